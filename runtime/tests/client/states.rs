//! States: up, down, quick stop, fault reset.

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, Progress};

use crate::fake::{run, Fake};

#[test]
fn an_axis_is_enabled_and_disabled() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(State::SwitchOnDisabled));
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.transitions, [2, 3, 4]);
    axis.disable();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.transitions, [2, 3, 4, 5]);
}
