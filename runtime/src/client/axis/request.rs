//! Goals as data: for procedures, for searches over all that can happen, for programs that keep a list.

use core::time::Duration;

use super::{Axis, SetPoint};
use crate::cia402::{Mode, State};

/// A goal of an axis: each is the method of its name.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum Request {
    /// [`Axis::enable`].
    Enable(Mode),
    /// [`Axis::enable_with_target`].
    EnableWithTarget(i32),
    /// [`Axis::reach`].
    Reach(State),
    /// [`Axis::disable`].
    Disable,
    /// [`Axis::shutdown`].
    Shutdown,
    /// [`Axis::quick_stop`].
    QuickStop,
    /// [`Axis::resume`].
    Resume,
    /// [`Axis::reset_fault`].
    ResetFault,
    /// [`Axis::select_mode`].
    SelectMode(Mode),
    /// [`Axis::move_to`].
    MoveTo(SetPoint, Duration),
    /// [`Axis::velocity`].
    Velocity(i32, Duration),
    /// [`Axis::torque`].
    Torque(i16, Duration),
    /// [`Axis::home`].
    Home(Duration),
}

impl Axis {
    /// Starts a goal.
    pub fn start(&mut self, request: Request) {
        match request {
            Request::Enable(mode) => self.enable(mode),
            Request::EnableWithTarget(position) => self.enable_with_target(position),
            Request::Reach(state) => self.reach(state),
            Request::Disable => self.disable(),
            Request::Shutdown => self.shutdown(),
            Request::QuickStop => self.quick_stop(),
            Request::Resume => self.resume(),
            Request::ResetFault => self.reset_fault(),
            Request::SelectMode(mode) => self.select_mode(mode),
            Request::MoveTo(set_point, within) => self.move_to(set_point, within),
            Request::Velocity(velocity, within) => self.velocity(velocity, within),
            Request::Torque(torque, within) => self.torque(torque, within),
            Request::Home(within) => self.home(within),
        }
    }
}
