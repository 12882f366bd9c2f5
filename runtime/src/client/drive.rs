//! A drive on a bus, by calls: each is a plan that runs to its end.

use core::time::Duration;

use crate::address::Address;
use crate::cia402::{Mode, State, Statusword};
use crate::client::axis::{Request, Sample};
use crate::client::error::{ClientError, DriveError};
use crate::client::fault::{Fault, ReadFault};
use crate::client::home::Homing;
use crate::client::moves::{self, MoveTo};
use crate::client::object::ReadContent;
use crate::client::session::{Client, Operation, Plan, Step};
use crate::client::units::Amount;
use crate::model::AlarmText;
use crate::procedure::{run, run_async, Policy, Procedure};
use crate::transport::{AsyncTransport, Transport};

/// Both drives are one list of calls; they differ in whether they wait or are told to come again.
macro_rules! drive {
    ($(#[$doc:meta])* $name:ident, $transport:ident, $run:ident $(, $async:tt, $await:tt)?) => {
        $(#[$doc])*
        #[derive(Debug)]
        pub struct $name<'m, T> {
            client: Client<'m>,
            bus: T,
            policy: Policy,
        }

        impl<'m, T> $name<'m, T> {
            /// A drive on a bus. Nothing is sent yet.
            pub fn new(client: Client<'m>, bus: T) -> Self {
                Self { client, bus, policy: Policy::default() }
            }

            /// With other times and tries of SDO transfers.
            #[must_use]
            pub fn with_policy(self, policy: Policy) -> Self {
                Self { policy, ..self }
            }

            /// What the client knows of it.
            pub const fn client(&self) -> &Client<'m> {
                &self.client
            }

            /// The same, to set targets of cyclic modes, halt, and bits of the maker.
            pub fn client_mut(&mut self) -> &mut Client<'m> {
                &mut self.client
            }

            /// The bus.
            pub fn bus(&mut self) -> &mut T {
                &mut self.bus
            }

            /// The parts again.
            pub fn into_parts(self) -> (Client<'m>, T) {
                (self.client, self.bus)
            }
        }

        /// Calls. Each ends with a [`DriveError`] where the drive does not do what was asked, or the bus fails.
        impl<'m, T: $transport> $name<'m, T> {
            /// Runs a plan.
            pub $($async)? fn run(&mut self, plan: Plan) -> Result<(), DriveError<T::Error>> {
                let mut operation = Operation::new(&mut self.client, plan);
                let ended = $run(&mut operation, &mut self.bus, self.policy)$(.$await)?;
                Ok(ended.map_err(DriveError::Link)??)
            }

            $($async)? fn pursue(&mut self, request: Request) -> Result<(), DriveError<T::Error>> {
                self.run(Plan::goal(request))$(.$await)?
            }

            /// Enables it in a mode: see [`Axis::enable`](crate::client::axis::Axis::enable).
            pub $($async)? fn enable(&mut self, mode: Mode) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::Enable(mode))$(.$await)?
            }

            /// Takes the torque off the motor: see [`Axis::disable`](crate::client::axis::Axis::disable).
            pub $($async)? fn disable(&mut self) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::Disable)$(.$await)?
            }

            /// Goes to ready to switch on.
            pub $($async)? fn shutdown(&mut self) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::Shutdown)$(.$await)?
            }

            /// Goes to a state.
            pub $($async)? fn reach(&mut self, state: State) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::Reach(state))$(.$await)?
            }

            /// Stops it: see [`Axis::quick_stop`](crate::client::axis::Axis::quick_stop).
            pub $($async)? fn quick_stop(&mut self) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::QuickStop)$(.$await)?
            }

            /// Comes back from a quick stop that stays, after another look at 605Ah.
            pub $($async)? fn resume(&mut self) -> Result<(), DriveError<T::Error>> {
                let plan = Plan::EMPTY.then(Step::ReadQuickStop).then(Step::Goal(Request::Resume));
                self.run(plan)$(.$await)?
            }

            /// Resets a fault, if the model does not rule it out: see
            /// [`Axis::reset_fault`](crate::client::axis::Axis::reset_fault).
            pub $($async)? fn reset_fault(&mut self) -> Result<(), DriveError<T::Error>> {
                let plan = Plan::EMPTY.then(Step::Look).then(Step::NeedResettable).then(Step::Goal(Request::ResetFault));
                self.run(plan)$(.$await)?
            }

            /// Selects a mode of operation.
            pub $($async)? fn select_mode(&mut self, mode: Mode) -> Result<(), DriveError<T::Error>> {
                self.pursue(Request::SelectMode(mode))$(.$await)?
            }

            /// Sets or releases halt, with a cycle.
            pub $($async)? fn halt(&mut self, on: bool) -> Result<(), DriveError<T::Error>> {
                self.client.axis_mut().halt(on);
                self.run(Plan::cycle())$(.$await)?
            }

            /// Finds home.
            pub $($async)? fn home(&mut self, homing: Homing) -> Result<(), DriveError<T::Error>> {
                let plan = homing.plan(&self.client)?;
                self.run(plan)$(.$await)?
            }

            /// Moves to a position, and waits until it is reached.
            pub $($async)? fn move_to(&mut self, there: MoveTo) -> Result<(), DriveError<T::Error>> {
                let plan = there.plan(&self.client)?;
                self.run(plan)$(.$await)?
            }

            /// Goes to a velocity in profile velocity mode, and waits until it is reached.
            pub $($async)? fn velocity(
                &mut self,
                velocity: impl Into<Amount>,
                within: Duration,
            ) -> Result<(), DriveError<T::Error>> {
                let plan = moves::velocity(&self.client, velocity.into(), within)?;
                self.run(plan)$(.$await)?
            }

            /// Goes to a torque in profile torque mode, and waits until it is reached, where the drive shows that.
            pub $($async)? fn torque(
                &mut self,
                torque: impl Into<Amount>,
                within: Duration,
            ) -> Result<(), DriveError<T::Error>> {
                let plan = moves::torque(&self.client, torque.into(), None, within)?;
                self.run(plan)$(.$await)?
            }

            /// Turns at a velocity as long as `held` says so, and no longer than `within`; then comes to a stop. Given up
            /// on the way, it stops with the next cycle.
            pub $($async)? fn jog(
                &mut self,
                velocity: impl Into<Amount>,
                within: Duration,
                mut held: impl FnMut() -> bool,
            ) -> Result<(), DriveError<T::Error>> {
                let plan = moves::jog(&self.client, velocity.into(), within)?;
                let mut operation = Operation::new(&mut self.client, plan).while_held(&mut held);
                let ended = $run(&mut operation, &mut self.bus, self.policy)$(.$await)?;
                drop(operation);
                Ok(ended.map_err(DriveError::Link)??)
            }

            /// One cycle: for programs that give a target in every one, and for watchdogs. The last sample; `None` if none
            /// has come yet.
            pub $($async)? fn cycle(&mut self) -> Result<Option<Sample>, DriveError<T::Error>> {
                self.run(Plan::cycle())$(.$await)?.map(|()| self.client.axis().sample())
            }

            /// Writes a raw number, or a value in the unit of the entry. Refused where process data would overwrite it.
            pub $($async)? fn write(
                &mut self,
                address: Address,
                amount: impl Into<Amount>,
            ) -> Result<(), DriveError<T::Error>> {
                let count = self.client.count(address, amount.into())?;
                let step = Step::Write(self.client.image().at(address), count);
                self.run(Plan::EMPTY.then(step))$(.$await)?
            }

            /// Reads a raw number.
            pub $($async)? fn read(&mut self, address: Address) -> Result<i128, DriveError<T::Error>> {
                let address = self.client.image().at(address);
                let mut read = ReadContent::new(self.client.model(), address, &mut []).map_err(ClientError::Access)?;
                let content = self.call(&mut read)$(.$await)?.map_err(DriveError::Link)?.map_err(ClientError::Access)?;
                Ok(content.number().unwrap_or(0))
            }

            /// The fault that it reports, or the warning; `None` if it reports neither. `texts` are causes and remedies;
            /// empty where they are not at hand.
            pub $($async)? fn fault(
                &mut self,
                texts: &'m [AlarmText<'m>],
            ) -> Result<Option<Fault<'m>>, DriveError<T::Error>> {
                let mut read = ReadFault::new(self.client.model());
                let evidence = self.call(&mut read)$(.$await)?.map_err(DriveError::Link)?.map_err(ClientError::Access)?;
                let warns = evidence.statusword.is_some_and(Statusword::has_warning);
                let fault = Fault::new(self.client.model(), texts, evidence);
                Ok((warns || fault.is_active() != Some(false)).then_some(fault))
            }

            /// Runs any other procedure on this bus: identity, comparison, layouts, parameter sets. Process data do not
            /// go on by themselves meanwhile.
            ///
            /// # Errors
            /// That of the bus.
            pub $($async)? fn call<P: Procedure>(&mut self, procedure: &mut P) -> Result<P::Output, T::Error> {
                $run(procedure, &mut self.bus, self.policy)$(.$await)?
            }
        }
    };
}

drive! {
    /// A drive on a bus that blocks.
    Drive, Transport, run
}

drive! {
    /// A drive on a bus that does not block. No executor is needed in particular, and nothing need be `Send`.
    AsyncDrive, AsyncTransport, run_async, async, await
}
