//! Makes a drive keep its parameters: 1010h.
//!
//! A drive may keep targets with its parameters, and then moves at its next enable. So a drive that is enabled does not
//! store, and one whose targets would move it stores only after they were made harmless: targets of speed and torque 0, the
//! target position where the axis is.

use core::fmt;
use core::time::Duration;

use crate::address::Address;
use crate::cia402::{State, Statusword};
use crate::client::message::{displays, Explain};
use crate::client::object::{received, taken, AccessError, Action, Cause, Content};
use crate::model::DriveModel;
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::{micros, Instant};

/// `save`, as the drive wants it in 1010h.
const SAVE: [u8; 4] = *b"save";

/// How long to wait between two questions whether the drive has finished.
const PAUSE: Duration = Duration::from_millis(100);

const STATUSWORD: Address = Address::new(0x6041, 0);
const ACTUAL_POSITION: Address = Address::new(0x6064, 0);
const TARGET_POSITION: Address = Address::new(0x607A, 0);

/// The targets, each with what makes it harmless: the entry that holds the harmless value, or 0. Actual position first: it
/// is only read.
const TARGETS: [(Address, Option<Address>); 4] = [
    (TARGET_POSITION, Some(ACTUAL_POSITION)),
    (Address::new(0x60FF, 0), None),
    (Address::new(0x6071, 0), None),
    (Address::new(0x6042, 0), None),
];

/// Stores parameters.
#[derive(Clone, Copy, Debug)]
pub struct Store<'m> {
    model: &'m DriveModel<'m>,
    command: Address,
    neutralize: bool,
    polls: u64,
    phase: Phase,
    /// The harmless value of the target at hand.
    harmless: i128,
    /// Whether the command had an answer.
    confirmed: bool,
    bytes: [u8; 8],
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Phase {
    Begin,
    Statusword,
    /// Reads the entry with the harmless value of a target.
    Harmless(usize),
    /// Reads a target.
    Target(usize),
    /// Makes it harmless.
    Neutralize(usize),
    /// Reads it again.
    Again(usize),
    /// Reads whether the drive stores on command.
    Ability,
    Save,
    /// Waits, then asks whether it has finished.
    Pause,
    Poll,
}

/// It is stored.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Stored {
    /// Whether the drive confirmed the command. If not, it answered again within the time, but the command had no answer.
    pub confirmed: bool,
}

/// Why nothing was stored.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum StoreCause {
    /// The profile has no such entry of 1010h that can be written.
    NoStore,
    /// The drive says that it does not store on command.
    NotOnCommand {
        /// What 1010h holds.
        ability: u32,
    },
    /// The drive is enabled, or its statusword is that of no state.
    Enabled {
        /// The statusword.
        statusword: Statusword,
    },
    /// A target would move the drive at its next enable.
    Target {
        /// What it is.
        value: i64,
        /// What would be harmless.
        harmless: i64,
    },
    /// A transfer failed.
    Access(AccessError),
    /// The drive did not answer again in time: whether it stored is not known.
    TimedOut,
}

/// Nothing was stored, or it is not known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct StoreError {
    /// The entry that it is about.
    pub address: Address,
    /// Why.
    pub cause: StoreCause,
}

impl<'m> Store<'m> {
    /// Stores the group at this sub-index of 1010h: 1 for all parameters, 2 for those of communication, 3 for those of the
    /// application.
    ///
    /// # Errors
    /// [`StoreCause::NoStore`].
    pub fn new(model: &'m DriveModel<'m>, group: u8) -> Result<Self, StoreError> {
        let command = Address::new(0x1010, group);
        if group == 0 || !model.object(command).is_some_and(|object| object.access().writes()) {
            return Err(StoreError { address: command, cause: StoreCause::NoStore });
        }
        let phase = Phase::Begin;
        Ok(Self {
            model,
            command,
            neutralize: false,
            polls: 100,
            phase,
            harmless: 0,
            confirmed: false,
            bytes: [0; 8],
        })
    }

    /// Makes targets harmless before storing, instead of refusing: speed and torque 0, the position where the axis is.
    #[must_use]
    pub const fn neutralize(self) -> Self {
        Self { neutralize: true, ..self }
    }

    /// With the longest time that the drive may be busy; 10 s otherwise.
    #[must_use]
    pub const fn within(self, span: Duration) -> Self {
        let polls = match micros(span).checked_div(micros(PAUSE)) {
            Some(polls) => polls.saturating_add(1),
            None => 1,
        };
        Self { polls, ..self }
    }

    fn has(&self, address: Address) -> bool {
        self.model
            .object(address)
            .is_some_and(|object| object.access().reads() && object.data_type().is_integer())
    }

    /// From target `place` on, the first that the drive has.
    fn target(&self, place: usize) -> Phase {
        let mut targets = (0..TARGETS.len()).zip(&TARGETS).filter(|(at, _)| *at >= place);
        match targets.find(|(_, (target, _))| self.has(*target)) {
            Some((place, (_, Some(source)))) if self.has(*source) => Phase::Harmless(place),
            Some((place, _)) => Phase::Target(place),
            None => Phase::Ability,
        }
    }

    fn number(&self, address: Address, answer: Answer<'_>) -> Result<i128, StoreError> {
        let lost = AccessError { address, action: Action::Read, cause: Cause::NotInProfile };
        let content =
            self.model.object(address).ok_or(lost).and_then(|object| {
                received(address, answer).and_then(|bytes| Content::decode(object, bytes))
            });
        let number = content.map_err(|error| StoreError { address, cause: StoreCause::Access(error) })?;
        Ok(number.number().unwrap_or(0))
    }

    /// Takes an answer; gives what comes next.
    fn take(&mut self, answer: Answer<'_>) -> Result<Phase, StoreError> {
        Ok(match self.phase {
            Phase::Begin if self.has(STATUSWORD) => Phase::Statusword,
            Phase::Begin => self.target(0),
            Phase::Statusword => {
                disabled(self.number(STATUSWORD, answer)?)?;
                self.target(0)
            }
            Phase::Harmless(place) => {
                self.harmless = self.number(source(place), answer)?;
                Phase::Target(place)
            }
            Phase::Target(place) => self.take_target(place, answer, self.neutralize)?,
            Phase::Neutralize(place) => {
                let written = taken(target(place), Some(self.harmless), answer);
                written.map_err(|error| failed(StoreCause::Access(error), target(place)))?;
                Phase::Again(place)
            }
            Phase::Again(place) => self.take_target(place, answer, false)?,
            Phase::Ability => {
                self.able(self.number(self.command, answer)?)?;
                Phase::Save
            }
            Phase::Save => self.take_save(answer)?,
            Phase::Pause => Phase::Poll,
            Phase::Poll => self.again()?,
        })
    }

    /// A target that is harmless is passed; one that is not is made so, or ends it.
    fn take_target(
        &mut self,
        place: usize,
        answer: Answer<'_>,
        neutralize: bool,
    ) -> Result<Phase, StoreError> {
        let value = self.number(target(place), answer)?;
        let harmless = core::mem::replace(&mut self.harmless, 0);
        if value == harmless {
            return Ok(self.target(place.saturating_add(1)));
        }
        if neutralize {
            self.harmless = harmless;
            return Ok(Phase::Neutralize(place));
        }
        let near = |n: i128| i64::try_from(n).unwrap_or(i64::MAX);
        Err(failed(StoreCause::Target { value: near(value), harmless: near(harmless) }, target(place)))
    }

    /// That the drive stores on command: bit 0 of what 1010h holds.
    fn able(&self, ability: i128) -> Result<(), StoreError> {
        if ability & 1 != 0 {
            return Ok(());
        }
        let ability = u32::try_from(ability).unwrap_or(0);
        Err(failed(StoreCause::NotOnCommand { ability }, self.command))
    }

    /// A drive that is busy writing may not answer the command.
    fn take_save(&mut self, answer: Answer<'_>) -> Result<Phase, StoreError> {
        match taken(self.command, None, answer) {
            Ok(()) => {
                self.confirmed = true;
                Ok(Phase::Poll)
            }
            Err(AccessError { cause: Cause::NoAnswer, .. }) => self.again(),
            Err(error) => Err(failed(StoreCause::Access(error), self.command)),
        }
    }

    fn again(&mut self) -> Result<Phase, StoreError> {
        self.polls = self.polls.saturating_sub(1);
        if self.polls == 0 {
            return Err(failed(StoreCause::TimedOut, self.command));
        }
        Ok(Phase::Pause)
    }

    fn ask(&mut self, now: Instant) -> Ask<'_, Result<Stored, StoreError>> {
        match self.phase {
            // Never asked for: what comes after it is.
            Phase::Begin => Ask::Wait(now),
            Phase::Statusword => Ask::Upload(STATUSWORD),
            Phase::Harmless(place) => Ask::Upload(source(place)),
            Phase::Target(place) | Phase::Again(place) => Ask::Upload(target(place)),
            Phase::Neutralize(place) => self.ask_neutral(target(place)),
            Phase::Ability | Phase::Poll => Ask::Upload(self.command),
            Phase::Save => Ask::Download(self.command, &SAVE),
            Phase::Pause => Ask::Wait(now.after(PAUSE)),
        }
    }

    fn ask_neutral(&mut self, address: Address) -> Ask<'_, Result<Stored, StoreError>> {
        let action = Action::write(Some(self.harmless));
        let lost = AccessError { address, action, cause: Cause::NotInProfile };
        let content = Content::Int(self.harmless);
        let used = self.model.object(address).ok_or(lost).and_then(|object| {
            content.check(self.model, object)?;
            let wire = |error| AccessError { address, action, cause: Cause::Wire(error) };
            content.encode(object.data_type(), &mut self.bytes).map_err(wire)
        });
        match used {
            Ok(used) => Ask::Download(address, self.bytes.get(..used).unwrap_or(&[])),
            Err(error) => Ask::Done(Err(failed(StoreCause::Access(error), address))),
        }
    }
}

const fn failed(cause: StoreCause, address: Address) -> StoreError {
    StoreError { address, cause }
}

fn target(place: usize) -> Address {
    TARGETS.get(place).map_or(TARGET_POSITION, |(target, _)| *target)
}

fn source(place: usize) -> Address {
    TARGETS.get(place).and_then(|(_, source)| *source).unwrap_or(ACTUAL_POSITION)
}

/// That nothing moves while targets are looked at. A word that is that of no state is no proof of that.
fn disabled(word: i128) -> Result<(), StoreError> {
    let statusword = Statusword(u16::try_from(word).unwrap_or(0));
    match statusword.state() {
        Some(State::OperationEnabled | State::QuickStopActive | State::FaultReactionActive) | None => {
            Err(failed(StoreCause::Enabled { statusword }, STATUSWORD))
        }
        Some(_) => Ok(()),
    }
}

impl Procedure for Store<'_> {
    type Output = Result<Stored, StoreError>;

    fn next(&mut self, now: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        // The drive answers again: it has finished.
        if let (Phase::Poll, Answer::Data(_)) = (self.phase, answer) {
            return Ask::Done(Ok(Stored { confirmed: self.confirmed }));
        }
        match self.take(answer) {
            Ok(phase) => {
                self.phase = phase;
                self.ask(now)
            }
            Err(error) => Ask::Done(Err(error)),
        }
    }
}

impl Explain for StoreError {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            StoreCause::Access(error) => error.code(f),
            _ => f.write_str("STORE"),
        }
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let address = self.address;
        match &self.cause {
            StoreCause::NoStore => write!(f, "the profile has no {address} that can be written"),
            StoreCause::NotOnCommand { ability } => {
                write!(f, "the drive does not store on command [{address} = {ability:08X}h]")
            }
            StoreCause::Enabled { statusword } => {
                let state = statusword.state().map_or("no state of CiA 402", State::word);
                write!(
                    f,
                    "refusing 1010h: the drive is not disabled, but in {state} [6041h {:04X}h]",
                    statusword.0
                )
            }
            StoreCause::Target { value, harmless } => {
                write!(f, "refusing 1010h: target {address} is {value}, not {harmless}")
            }
            StoreCause::Access(error) => error.what(f),
            StoreCause::TimedOut => f.write_str("the drive did not answer again after the command to store"),
        }
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            StoreCause::Target { .. } => {
                f.write_str("if the drive keeps it, the first enable after power-up would move")
            }
            StoreCause::Access(error) => error.why(f),
            StoreCause::TimedOut => f.write_str("whether it stored is not known"),
            _ => Ok(()),
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match &self.cause {
            StoreCause::NoStore | StoreCause::NotOnCommand { .. } => {
                "see the manual for how this drive keeps parameters"
            }
            StoreCause::Enabled { .. } => "disable the drive, then store",
            StoreCause::Target { .. } => "store with `neutralize`, which makes the targets harmless first",
            StoreCause::Access(error) => return error.remedy(f),
            StoreCause::TimedOut => "switch the control supply off and on, and compare the parameters",
        })
    }
}

displays! {
    [] StoreError;
}
