//! Writes a set.

use super::order::{broken_in_the_end, give_turns, Role, Rules, Slot};
use super::{is_command, is_mapping, SetCause, SetError, SetReport, Setting};
use crate::address::Address;
use crate::client::object::{is_free, received, taken, AccessError, Action, Cause, Content};
use crate::client::tally::count;
use crate::model::{DriveModel, Effect};
use crate::pdo::MapEntry;
use crate::procedure::{Answer, Ask, Procedure};
use crate::rule::Occasion;
use crate::time::Instant;

/// Writes what differs from a set, in an order that breaks no rule, and reads it back.
///
/// ```
/// use drivewright_runtime::client::parameters::{Apply, SetCause, Setting, Slot};
/// use drivewright_runtime::prelude::*;
///
/// let model = DriveModel::new(Identity::new("acme-x3", "Acme", "X3"));
/// let wanted = [Setting::number(Address::new(0x607A, 0), 0)];
/// let mut slots = [Slot::EMPTY; 8];
/// let error = Apply::new(&model, &wanted, &[], &mut slots).unwrap_err();
/// assert_eq!(error.cause, SetCause::Command);
/// ```
#[derive(Debug)]
pub struct Apply<'m, 'w, 's> {
    rules: Rules<'m, 'w>,
    wanted: &'w [Setting<'w>],
    slots: &'s mut [Slot],
    phase: Phase,
    bytes: [u8; 8],
}

/// What the next answer is about.
#[derive(Clone, Copy, Debug)]
enum Phase {
    /// Nothing was asked yet.
    Begin,
    /// What the device has, slot by slot.
    Reading(usize),
    /// The write of this turn.
    Writing(u16),
    /// What the device has after the write of this turn.
    Verifying(u16),
    /// Nothing more.
    Over,
}

/// How a set was written.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Applied {
    /// Entries that were written; those that can be read hold what was written.
    pub written: usize,
    /// Entries that had the wanted value.
    pub unchanged: usize,
    /// Written entries that take effect at the next standstill: [`Apply::effects`] names them.
    pub at_stop: usize,
    /// Written entries that take effect after the next power cycle: [`Apply::effects`] names them.
    pub power_cycle: usize,
}

impl<'m, 'w, 's> Apply<'m, 'w, 's> {
    /// The write of `wanted`. Rules of the drive that must hold always count, and those of the `occasions` given here.
    ///
    /// `slots` has one for each setting, and one for each further entry that the rules about them name.
    ///
    /// # Errors
    /// What can be told without the drive: commands, mapping, unknown entries, access, limits, lists, types, memory.
    pub fn new(
        model: &'m DriveModel<'m>,
        wanted: &'w [Setting<'w>],
        occasions: &'w [Occasion],
        slots: &'s mut [Slot],
    ) -> Result<Self, SetError<'m>> {
        for (place, setting) in (0..wanted.len()).zip(wanted) {
            let others = wanted.get(..place).unwrap_or(&[]);
            check(model, setting, others).map_err(|cause| SetError::before(setting.address, cause))?;
            if place >= usize::from(u16::MAX) {
                return Err(SetError::before(setting.address, SetCause::Room { needed: wanted.len() }));
            }
        }
        let mut apply =
            Self { rules: Rules { model, occasions }, wanted, slots, phase: Phase::Begin, bytes: [0; 8] };
        apply.fill()?;
        Ok(apply)
    }

    /// On a drive that receives this layout as process data now: an entry of it cannot be written.
    ///
    /// # Errors
    /// [`Cause::MappedInRxPdo`].
    pub fn beside(self, layout: &[MapEntry]) -> Result<Self, SetError<'m>> {
        for setting in self.wanted {
            let free = is_free(setting.address, layout).map_err(SetCause::Access);
            free.map_err(|cause| SetError::before(setting.address, cause))?;
        }
        Ok(self)
    }

    /// The entries that were written, in their order.
    pub fn written(&self) -> impl Iterator<Item = Address> + '_ {
        let turn = |turn| self.slots.iter().find(move |slot| slot.role == Role::Written(turn));
        (0..=u16::MAX).map_while(turn).map(|slot| slot.address)
    }

    /// The written entries that do not take effect at once, and when they do.
    pub fn effects(&self) -> impl Iterator<Item = (Address, Effect)> + '_ {
        let effect = |address| Some((address, self.rules.model.effect_of(address)?));
        self.written().filter_map(effect).filter(|(_, effect)| *effect != Effect::AtOnce)
    }

    /// The error with names, and with what was written before it.
    pub fn explain(&self, error: &SetError<'m>) -> SetReport<'_, 'm> {
        SetReport::new(*error, self.rules.model, self.slots)
    }

    /// Slots for the settings, in their order, then for the other entries of their rules.
    fn fill(&mut self) -> Result<(), SetError<'m>> {
        self.slots.fill(Slot::EMPTY);
        let mut used = 0;
        for setting in self.wanted {
            self.put(&mut used, setting.address, setting.value.number(), Role::Open)?;
        }
        for setting in self.wanted {
            let (rules, model) = (self.rules, self.rules.model);
            for rule in rules.about(setting.address) {
                let parts = [rule.when(), rule.require()];
                for address in parts.iter().flatten().flat_map(|expr| expr.objects()) {
                    let known = self.slots.iter().take(used).any(|slot| slot.address == address);
                    let reads = model.object(address).is_some_and(|object| object.access().reads());
                    if reads && !known {
                        self.put(&mut used, address, None, Role::Beside)?;
                    }
                }
            }
        }
        let slots = core::mem::take(&mut self.slots);
        self.slots = slots.get_mut(..used).unwrap_or_default();
        Ok(())
    }

    fn put(
        &mut self,
        used: &mut usize,
        address: Address,
        wanted: Option<i128>,
        role: Role,
    ) -> Result<(), SetError<'m>> {
        let needed = used.saturating_add(1);
        let full = SetError::before(address, SetCause::Room { needed });
        *self.slots.get_mut(*used).ok_or(full)? = Slot { address, now: None, wanted, role };
        *used = needed;
        Ok(())
    }

    fn failed(&self, address: Address, cause: SetCause<'m>) -> SetError<'m> {
        SetError { address, cause, written: count(self.written()) }
    }

    fn refused(&self, error: AccessError) -> SetError<'m> {
        self.failed(error.address, SetCause::Access(error))
    }

    /// The place of the slot of this turn.
    fn place(&self, turn: u16) -> Option<usize> {
        let mine = |slot: &Slot| slot.role == Role::Turn(turn) || slot.role == Role::Written(turn);
        self.slots.iter().position(mine)
    }

    /// Takes what the device has in slot `place`. What only rules need may stay unknown.
    fn take_reading(&mut self, place: usize, answer: Answer<'_>) -> Result<(), SetError<'m>> {
        let Some(slot) = self.slots.get(place).copied() else { return Ok(()) };
        let Some(object) = self.rules.model.object(slot.address) else { return Ok(()) };
        let read = received(slot.address, answer).and_then(|bytes| Content::decode(object, bytes));
        let content = match (read, slot.role) {
            (Err(_), Role::Beside) => return Ok(()),
            (read, _) => read.map_err(|error| self.refused(error))?,
        };
        let same = self.wanted.get(place).is_some_and(|setting| setting.value.same(content));
        if let Some(slot) = self.slots.get_mut(place) {
            slot.now = content.number();
            if same {
                slot.role = Role::Same;
            }
        }
        Ok(())
    }

    /// Orders the writes, once all is known.
    fn plan(&mut self) -> Result<(), SetError<'m>> {
        if let Some((address, rule)) = broken_in_the_end(&self.rules, self.slots) {
            return Err(SetError::before(address, SetCause::Rule { id: rule.id(), text: rule.text() }));
        }
        give_turns(&self.rules, self.slots).map_err(|(address, rule)| {
            SetError::before(address, SetCause::Order { id: rule.map_or("", |rule| rule.id()) })
        })
    }

    /// Takes the answer to the write of this turn.
    fn take_written(&mut self, turn: u16, answer: Answer<'_>) -> Result<(), SetError<'m>> {
        let Some(place) = self.place(turn) else { return Ok(()) };
        let Some(setting) = self.wanted.get(place) else { return Ok(()) };
        taken(setting.address, setting.value.number(), answer).map_err(|error| self.refused(error))?;
        if let Some(slot) = self.slots.get_mut(place) {
            slot.role = Role::Written(turn);
        }
        Ok(())
    }

    /// That the device holds what was written in this turn.
    fn take_verified(&mut self, turn: u16, answer: Answer<'_>) -> Result<(), SetError<'m>> {
        let Some(setting) = self.place(turn).and_then(|place| self.wanted.get(place)) else { return Ok(()) };
        let Some(object) = self.rules.model.object(setting.address) else { return Ok(()) };
        let read = received(setting.address, answer).and_then(|bytes| Content::decode(object, bytes));
        let found = read.map_err(|error| self.refused(error))?;
        if setting.value.same(found) {
            Ok(())
        } else {
            Err(self.failed(setting.address, SetCause::NotKept))
        }
    }

    /// Takes an answer.
    fn take(&mut self, answer: Answer<'_>) -> Result<(), SetError<'m>> {
        match self.phase {
            Phase::Begin | Phase::Over => Ok(()),
            Phase::Reading(place) => self.take_reading(place, answer),
            Phase::Writing(turn) => self.take_written(turn, answer),
            Phase::Verifying(turn) => self.take_verified(turn, answer),
        }
    }

    /// What comes next: reads, then writes, then reads of what was written.
    fn advance(&mut self) -> Result<(), SetError<'m>> {
        self.phase = match self.phase {
            Phase::Begin => self.reading(0)?,
            Phase::Reading(place) => self.reading(place.saturating_add(1))?,
            Phase::Writing(turn) => self.writing(turn.saturating_add(1)),
            Phase::Verifying(turn) => self.verifying(turn.saturating_add(1)),
            Phase::Over => Phase::Over,
        };
        Ok(())
    }

    /// The first slot from `from` on that can be read; once there is none, the first write.
    fn reading(&mut self, from: usize) -> Result<Phase, SetError<'m>> {
        let place = (from..self.slots.len()).find(|place| self.reads(*place));
        if let Some(place) = place {
            return Ok(Phase::Reading(place));
        }
        self.plan()?;
        Ok(self.writing(0))
    }

    fn writing(&self, turn: u16) -> Phase {
        if self.place(turn).is_some() {
            return Phase::Writing(turn);
        }
        self.verifying(0)
    }

    /// The next written entry from turn `from` on that can be read.
    fn verifying(&self, from: u16) -> Phase {
        let mut turns = (from..=u16::MAX).map_while(|turn| Some((turn, self.place(turn)?)));
        turns.find(|(_, place)| self.reads(*place)).map_or(Phase::Over, |(turn, _)| Phase::Verifying(turn))
    }

    fn reads(&self, place: usize) -> bool {
        let object = self.slots.get(place).and_then(|slot| self.rules.model.object(slot.address));
        object.is_some_and(|object| object.access().reads())
    }

    fn ask(&mut self) -> Ask<'_, <Self as Procedure>::Output> {
        let (place, write) = match self.phase {
            Phase::Reading(place) => (Some(place), false),
            Phase::Verifying(turn) => (self.place(turn), false),
            Phase::Writing(turn) => (self.place(turn), true),
            Phase::Begin | Phase::Over => (None, false),
        };
        let Some(slot) = place.and_then(|place| self.slots.get(place)) else {
            return Ask::Done(Ok(self.applied()));
        };
        match place.and_then(|place| self.wanted.get(place)) {
            Some(setting) if write => self.ask_write(*setting),
            _ => Ask::Upload(slot.address),
        }
    }

    fn ask_write(&mut self, setting: Setting<'w>) -> Ask<'_, <Self as Procedure>::Output> {
        let (address, action) = (setting.address, Action::write(setting.value.number()));
        if let Content::Bytes(bytes) = setting.value {
            return Ask::Download(address, bytes);
        }
        let lost = AccessError { address, action, cause: Cause::NotInProfile };
        let used = self.rules.model.object(address).ok_or(lost).and_then(|object| {
            let encoded = setting.value.encode(object.data_type(), &mut self.bytes);
            encoded.map_err(|error| AccessError { address, action, cause: Cause::Wire(error) })
        });
        match used {
            Ok(used) => Ask::Download(address, self.bytes.get(..used).unwrap_or(&[])),
            Err(error) => Ask::Done(Err(self.refused(error))),
        }
    }

    fn applied(&self) -> Applied {
        let of = |effect| count(self.effects().filter(|(_, e)| *e == effect));
        Applied {
            written: count(self.written()),
            unchanged: count(self.slots.iter().filter(|slot| slot.role == Role::Same)),
            at_stop: of(Effect::AtStop),
            power_cycle: of(Effect::PowerCycle),
        }
    }
}

/// What can be told of a setting without the drive.
fn check<'m>(
    model: &DriveModel<'m>,
    setting: &Setting<'_>,
    others: &[Setting<'_>],
) -> Result<(), SetCause<'m>> {
    let (address, action) = (setting.address, Action::write(setting.value.number()));
    if is_command(address) {
        return Err(SetCause::Command);
    }
    if is_mapping(address) {
        return Err(SetCause::Mapping);
    }
    if others.iter().any(|other| other.address == address) {
        return Err(SetCause::Twice);
    }
    let lost = AccessError { address, action, cause: Cause::NotInProfile };
    let object = model.object(address).ok_or(SetCause::Access(lost))?;
    setting.value.check(model, object).map_err(SetCause::Access)
}

impl<'m> Procedure for Apply<'m, '_, '_> {
    type Output = Result<Applied, SetError<'m>>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        match self.take(answer).and_then(|()| self.advance()) {
            Ok(()) => self.ask(),
            Err(error) => Ask::Done(Err(error)),
        }
    }
}
