//! What a virtual drive shows, in words.

use drivewright_runtime::sim::VirtualDrive;

use crate::stage::{POSITION, SPEED, force, named};
use crate::trace::{Unit, millis, mode_name};

/// State, mode, place, alarms.
pub(super) fn told(drive: &VirtualDrive<'_, '_>) -> String {
    let model = drive.model();
    let value = |at| Unit::of(model, at).told(drive.value(at).unwrap_or(0));
    let (force, force_name) = force(model);
    let mut lines = vec![
        format!("time      {} ms", millis(drive.now())),
        format!("state     {}", drive.statusword()),
        format!("mode      {}", mode_name(drive.mode())),
        format!("network   {}", drive.bus_state()),
        format!("position  {}", value(POSITION)),
        format!("speed     {}", value(SPEED)),
        format!("{force_name:<8}  {}", value(force)),
    ];
    for active in drive.alarms() {
        let cause = if active.cause { "; its cause is still there" } else { "" };
        lines.push(format!("alarm     {}{cause}", named(active.alarm)));
    }
    lines.join("\n")
}
