//! What a client keeps of a drive between calls, and the machine that runs goals over a bus.

mod cycle;
mod facts;
mod operation;
mod plan;
mod steps;

use core::time::Duration;

use crate::address::Address;
use crate::cia402::Mode;
use crate::client::axis::{Axis, AxisPolicy, Modes};
use crate::client::error::ClientError;
use crate::client::image::{Image, Input, Output, FRAME_BYTES};
use crate::client::units::{Amount, Scales};
use crate::model::DriveModel;
use crate::quantity::{FixedUnit, UserUnit};
use crate::scale::Scale;

pub use operation::Operation;
pub use plan::{Plan, Step};

/// A drive as its client knows it: model, process image, axis.
///
/// Its procedures exchange process data as long as they run. Between them nothing is sent by it: a drive with a watchdog
/// wants [`Plan::cycle`] in every cycle, or a transport that goes on by itself.
#[derive(Clone, Debug)]
pub struct Client<'m> {
    model: &'m DriveModel<'m>,
    image: Image<'m>,
    axis: Axis,
    frame: [u8; FRAME_BYTES],
    /// Outputs that went by SDO.
    written: [Option<[u8; 4]>; Output::ALL.len()],
    primed: bool,
    cycle: Duration,
    scales: Scales,
}

impl<'m> Client<'m> {
    /// The client of a drive of this model, over these process data. What the policy leaves open is as the
    /// model says: the modes, and the meaning of bit 6.
    pub fn new(model: &'m DriveModel<'m>, image: Image<'m>, mut policy: AxisPolicy) -> Self {
        if policy.modes == Modes::ANY {
            policy.modes = modes_of(model);
        }
        let inverted = policy.relative_bit_is_inverted.or_else(|| bit_6_is_absolute(model));
        policy.relative_bit_is_inverted = inverted;
        Self {
            model,
            image,
            axis: Axis::new(policy),
            frame: [0; FRAME_BYTES],
            written: [None; Output::ALL.len()],
            primed: false,
            cycle: Duration::from_millis(10),
            scales: Scales::default(),
        }
    }

    /// With another pause between cycles where there are no process data. 10 ms if nothing is said.
    #[must_use]
    pub fn with_cycle(mut self, cycle: Duration) -> Self {
        self.cycle = cycle;
        self
    }

    /// With what a user unit of the drive is worth, so that positions can be given as angles and so on. It is made from
    /// what was read from the gear objects of the drive at hand.
    #[must_use]
    pub fn with_scale<Q: UserUnit<P>, P: FixedUnit>(mut self, scale: Scale<Q, P>) -> Self {
        self.scales.set(scale);
        self
    }

    /// The raw count of an amount for an entry, which is given for the first axis of a drive.
    ///
    /// # Errors
    /// [`ClientError::Unit`], [`ClientError::NoScale`], [`ClientError::Range`], and [`ClientError::Access`] for an entry
    /// that the profile does not have.
    pub fn count(&self, address: Address, amount: Amount) -> Result<i64, ClientError> {
        amount.count(self.model, self.image.at(address), &self.scales)
    }

    /// The axis.
    pub const fn axis(&self) -> &Axis {
        &self.axis
    }

    /// The axis, to set targets and bits. Goals are run by an [`Operation`].
    pub fn axis_mut(&mut self) -> &mut Axis {
        &mut self.axis
    }

    /// The model.
    pub const fn model(&self) -> &'m DriveModel<'m> {
        self.model
    }

    /// The process image.
    pub const fn image(&self) -> &Image<'m> {
        &self.image
    }

    /// Forgets what was written and seen, as after a power cycle of the drive: the next procedure reads it again.
    pub fn forget(&mut self) {
        self.axis = Axis::new(*self.axis.policy());
        self.written = [None; Output::ALL.len()];
        self.primed = false;
    }

    /// Whether bit 10 of the statusword, target reached, says anything in a mode. Where the model does not tell modes apart
    /// it is as in the standard.
    pub(super) fn shows_target_reached(&self, mode: Mode) -> bool {
        let object = self.model.object(Input::Statusword.address());
        let bits = object.and_then(|object| self.model.bits_of(object)).map_or(&[][..], |table| table.bits());
        let by_mode = bits.iter().any(|bit| bit.mode().is_some());
        !by_mode || bits.iter().any(|bit| bit.bit() == 10 && bit.mode().map_or(true, |of| of == mode.0))
    }

    /// Whether an input is worth a read by SDO.
    fn has(&self, input: Input) -> bool {
        input == Input::Statusword || self.model.object(self.image.at(input.address())).is_some()
    }

    /// The mode that goes out is the one that the drive has.
    fn mode_is_written(&mut self) {
        let value = Output::Mode.bytes(&self.axis.outputs());
        if let Some(place) = self.written.get_mut(Output::Mode as usize) {
            *place = Some(value);
        }
    }

    /// Whether an output matters now. Those that do not are not written by SDO.
    fn matters(&self, output: Output) -> bool {
        let mode = self.axis.outputs().mode;
        match output {
            Output::Controlword | Output::Mode => true,
            Output::Position => {
                mode == Mode::CYCLIC_POSITION || mode == Mode::PROFILE_POSITION && self.axis.has_set_point()
            }
            Output::Velocity => matches!(mode, Mode::PROFILE_VELOCITY | Mode::CYCLIC_VELOCITY),
            Output::Torque => {
                matches!(mode, Mode::PROFILE_TORQUE | Mode::CYCLIC_TORQUE | Mode::CYCLIC_TORQUE_ANGLE)
            }
        }
    }
}

/// The modes that a model lists; any where it lists none.
fn modes_of(model: &DriveModel<'_>) -> Modes {
    if model.modes().is_empty() {
        return Modes::ANY;
    }
    model.modes().iter().fold(Modes::NONE, |modes, mode| modes.with(Mode(mode.number())))
}

/// Whether bit 6 of the controlword means absolute in profile position mode, against the standard; `None` where the model
/// does not describe it.
fn bit_6_is_absolute(model: &DriveModel<'_>) -> Option<bool> {
    let bits = model.bits_of(model.object(Output::Controlword.address())?)?.bits();
    let bit = bits.iter().find(|bit| bit.bit() == 6 && bit.mode() == Some(Mode::PROFILE_POSITION.0))?;
    Some(bit.name().get(..3).is_some_and(|start| start.eq_ignore_ascii_case("abs")))
}
