//! The steps of a plan, each of which begins with a request or with a cycle.

use super::facts::Fact;
use super::operation::{Operation, Stage, Want};
use super::Step;
use crate::address::Address;
use crate::client::axis::{Progress, Request};
use crate::client::error::ClientError;
use crate::client::image::Output;
use crate::client::object::{is_free, AccessError, Action, Cause, Content};
use crate::time::Instant;

impl Operation<'_, '_> {
    /// Begins the next step; `None`: look again.
    pub(super) fn begin_step(&mut self, now: Instant) -> Result<Option<Want>, ClientError> {
        let Some(step) = self.plan.step(self.at) else { return Ok(Some(Want::Done(Ok(())))) };
        self.at = self.at.saturating_add(1);
        match step {
            Step::Set(address, value) => return self.write(address, value, true),
            Step::Write(address, value) => return self.write(address, value, false),
            Step::NeedOperation => self.client.axis.need_operation()?,
            Step::ReadQuickStop => return Ok(self.begin_read(Fact::QuickStop)),
            Step::NeedResettable => return Ok(self.begin_read(Fact::Resettable)),
            Step::Goal(request) => self.begin_goal(request)?,
            Step::TargetVelocity(velocity) => self.client.axis.target_velocity(velocity)?,
            Step::TargetTorque(torque) => self.client.axis.target_torque(torque)?,
            Step::RestoreMode => {
                if let Some(mode) = self.mode {
                    self.begin_goal(Request::SelectMode(mode))?;
                }
            }
            Step::Look | Step::Cycle | Step::Hold(_) => {
                self.since = Some(now);
                self.stage = Stage::Send(0);
            }
        }
        Ok(None)
    }

    /// A goal that is refused has sent nothing. Others begin with a cycle: the last sample may be old.
    fn begin_goal(&mut self, request: Request) -> Result<(), ClientError> {
        self.client.axis.start(request);
        if let Progress::Failed(error) = self.client.axis.progress() {
            return Err(ClientError::Axis(error));
        }
        self.stage = Stage::Send(0);
        Ok(())
    }

    fn begin_read(&mut self, fact: Fact) -> Option<Want> {
        if !self.exists(fact) {
            return None;
        }
        self.stage = Stage::Read(fact);
        Some(Want::Upload(self.place_of(fact)))
    }

    /// Writes for a step. `place`: into the process data where it is mapped.
    fn write(&mut self, address: Address, value: i64, place: bool) -> Result<Option<Want>, ClientError> {
        let number = i128::from(value);
        let refused = |cause| AccessError { address, action: Action::Write(Some(value)), cause };
        let object = self.client.model.object(address).ok_or(refused(Cause::NotInProfile))?;
        Content::Int(number).check(self.client.model, object)?;
        let wire = |error| refused(Cause::Wire(error));
        let length = object.data_type().encode_int(number, &mut self.buffer).map_err(wire)?;
        let is_output = Output::ALL.iter().any(|output| self.client.image.at(output.address()) == address);
        if place && !is_output {
            let bytes = self.buffer.get(..length).unwrap_or(&[]);
            if self.client.image.place(address, bytes, &mut self.client.frame) {
                return Ok(None);
            }
        }
        is_free(address, self.client.image.rx())?;
        self.stage = Stage::Write(address, value);
        Ok(Some(Want::Download(address, length)))
    }
}
