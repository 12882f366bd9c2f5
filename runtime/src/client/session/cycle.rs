//! A cycle: outputs that are not mapped, process data, inputs that are not mapped, the axis.

use super::operation::{received, written, wrong_length, Operation, Stage, Want};
use super::Step;
use crate::cia402::{State, Statusword};
use crate::client::axis::{AxisError, AxisErrorKind, Progress};
use crate::client::error::ClientError;
use crate::client::image::{Input, Output};
use crate::procedure::Answer;
use crate::time::Instant;

impl Operation<'_, '_> {
    pub(super) fn must_send(&self, output: Output) -> bool {
        let value = output.bytes(&self.client.axis.outputs());
        self.client.image.output(output).is_none()
            && self.client.matters(output)
            && self.client.written.get(output as usize).is_some_and(|written| *written != Some(value))
    }

    pub(super) fn send(&mut self, output: Output) -> Want {
        let value = output.bytes(&self.client.axis.outputs());
        let length = usize::from(output.bits() / 8);
        for (place, byte) in self.buffer.iter_mut().zip(value) {
            *place = byte;
        }
        Want::Download(self.client.image.at(output.address()), length)
    }

    pub(super) fn sent(&mut self, output: Output, answer: Answer<'_>) -> Result<(), ClientError> {
        let value = output.bytes(&self.client.axis.outputs());
        written(self.client.image.at(output.address()), i128::from(i32::from_le_bytes(value)), answer)?;
        if let Some(place) = self.client.written.get_mut(output as usize) {
            *place = Some(value);
        }
        Ok(())
    }

    pub(super) fn exchange(&mut self, now: Instant) -> Want {
        if self.client.image.is_empty() {
            return Want::Wait(now.after(self.client.cycle));
        }
        self.client.image.pack(&self.client.axis.outputs(), &mut self.client.frame);
        Want::Exchange
    }

    pub(super) fn must_receive(&self, input: Input) -> bool {
        if self.client.image.input(input).is_some() || !self.client.has(input) {
            return false;
        }
        match input {
            Input::Statusword | Input::Mode | Input::Position => true,
            Input::ErrorCode => {
                self.reading.statusword().and_then(Statusword::state).is_some_and(State::is_fault)
            }
            Input::Velocity | Input::Torque => false,
        }
    }

    pub(super) fn receive(&mut self, n: usize, answer: Answer<'_>) -> Result<(), ClientError> {
        let Some(input) = Input::ALL.get(n).copied() else { return Ok(()) };
        self.take_input(input, answer)
    }

    /// No answer is no sample: that is a matter of the age. A refusal and nonsense are errors.
    pub(super) fn take_input(&mut self, input: Input, answer: Answer<'_>) -> Result<(), ClientError> {
        let address = self.client.image.at(input.address());
        let bytes = match answer {
            Answer::Data(bytes) => bytes,
            Answer::NoAnswer => return Ok(()),
            other => received(address, other)?,
        };
        let length = usize::from(input.bits() / 8);
        let wrong = wrong_length(address, length, bytes.len());
        self.reading = self.reading.take(input, bytes).ok_or(wrong)?;
        Ok(())
    }

    /// The axis takes the sample; the result once the plan is at its end.
    pub(super) fn end_cycle(&mut self, now: Instant) -> Option<Result<(), ClientError>> {
        let sample = self.reading.sample();
        self.client.axis.cycle(now, sample);
        self.stage = Stage::Send(0);
        if let Some(ended) = self.ended.take() {
            self.stage = Stage::Step;
            return ended.err().map(Err);
        }
        if let Some(since) = self.since {
            match self.hold_ends(now, since) {
                None => return None,
                Some(Ok(())) => self.stage = Stage::Step,
                Some(Err(error)) => self.ended = Some(Err(error)),
            }
            self.since = None;
            return None;
        }
        // What the end of a goal puts out, the safe command above all, is sent before anything else happens.
        self.ended = match self.client.axis.progress() {
            Progress::Pending => None,
            Progress::Done => Some(Ok(())),
            Progress::Failed(error) => Some(Err(self.told(error))),
        };
        None
    }

    /// The error of the axis, or what is behind it.
    fn told(&self, error: AxisError) -> ClientError {
        let silent = matches!(error.kind, AxisErrorKind::Stale { .. } | AxisErrorKind::NoStatusword);
        match self.odd {
            Some(odd) if silent => ClientError::Image(odd),
            _ => ClientError::Axis(error),
        }
    }

    /// The end of a cycle or of a held step: the axis left operation, let go, or too long.
    fn hold_ends(&mut self, now: Instant, since: Instant) -> Option<Result<(), ClientError>> {
        let step = self.plan.step(self.at.saturating_sub(1));
        let trip = self.client.axis.trip().filter(|_| !self.tripped && step != Some(Step::Look));
        if let Some(error) = trip {
            return Some(Err(self.told(error)));
        }
        let Some(Step::Hold(within)) = step else { return Some(Ok(())) };
        let held = self.held.as_mut().is_some_and(|held| held());
        (!held || now.since(since) >= within).then_some(Ok(()))
    }
}
