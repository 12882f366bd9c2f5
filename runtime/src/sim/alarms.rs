//! Alarms that are active, what they show in the dictionary, and the emergency messages that they send.

use crate::model::{AlarmDesc, DriveModel, EmcyContent, Reset};

/// The most alarms that are active at once; more are not shown.
pub const MAX_ALARMS: usize = 10;

/// The most emergency messages that wait for the master. The oldest are kept, as a full mailbox keeps them.
pub const MAX_MESSAGES: usize = 16;

/// An emergency message, 8 bytes as on the wire.
pub type Emergency = [u8; 8];

/// An alarm that is active.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ActiveAlarm<'m> {
    /// Its row.
    pub alarm: &'m AlarmDesc<'m>,
    /// Whether its cause is still there.
    pub cause: bool,
}

impl ActiveAlarm<'_> {
    /// Whether a fault reset clears it now. Where the manual does not say how it is cleared, a fault reset does.
    pub const fn is_resettable(&self) -> bool {
        !self.cause && matches!(self.alarm.reset(), Reset::Resettable | Reset::NotStated)
    }
}

/// The drive has no such alarm.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct UnknownAlarm;

impl core::fmt::Display for UnknownAlarm {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("the model has no alarm with this display and number")
    }
}

impl core::error::Error for UnknownAlarm {}

/// A list with an end, in the order in which things came.
#[derive(Clone, Copy, Debug)]
struct Bounded<T, const N: usize> {
    items: [Option<T>; N],
    used: usize,
}

impl<T: Copy, const N: usize> Bounded<T, N> {
    const EMPTY: Self = Self { items: [None; N], used: 0 };

    /// Adds one; `false` if there is no room.
    fn push(&mut self, item: T) -> bool {
        let Some(place) = self.items.get_mut(self.used) else { return false };
        *place = Some(item);
        self.used = self.used.saturating_add(1);
        true
    }

    fn iter(&self) -> impl DoubleEndedIterator<Item = T> + '_ {
        self.items.iter().copied().flatten()
    }

    /// Keeps those that `keep` says; the others close up.
    fn retain(&mut self, keep: impl Fn(&T) -> bool) {
        let old = core::mem::replace(self, Self::EMPTY);
        for item in old.iter().filter(keep) {
            self.push(item);
        }
    }

    fn take_first(&mut self) -> Option<T> {
        let first = self.items.first().copied().flatten()?;
        self.items.rotate_left(1);
        self.items.iter_mut().rev().take(1).for_each(|last| *last = None);
        self.used = self.used.saturating_sub(1);
        Some(first)
    }
}

/// The alarms of a drive.
#[derive(Clone, Debug)]
pub(crate) struct Alarms<'m> {
    model: &'m DriveModel<'m>,
    active: Bounded<ActiveAlarm<'m>, MAX_ALARMS>,
    messages: Bounded<Emergency, MAX_MESSAGES>,
}

impl<'m> Alarms<'m> {
    pub(crate) const fn new(model: &'m DriveModel<'m>) -> Self {
        Self { model, active: Bounded::EMPTY, messages: Bounded::EMPTY }
    }

    /// Raises an alarm; one that is active already only gets its cause again. `sends`: a message goes out. Gives whether it
    /// is new.
    pub(crate) fn raise(&mut self, alarm: &'m AlarmDesc<'m>, cause: bool, sends: bool) -> bool {
        let same = |active: &&mut ActiveAlarm<'m>| active.alarm.is(alarm.display(), alarm.number());
        if let Some(active) = self.active.items.iter_mut().flatten().find(same) {
            active.cause |= cause;
            return false;
        }
        self.active.push(ActiveAlarm { alarm, cause });
        if sends {
            self.messages.push(message(self.model, alarm, self.register()));
        }
        true
    }

    /// The cause of an alarm is gone.
    pub(crate) fn end_cause(&mut self, alarm: &AlarmDesc<'_>) {
        let same = |active: &&mut ActiveAlarm<'m>| active.alarm.is(alarm.display(), alarm.number());
        if let Some(active) = self.active.items.iter_mut().flatten().find(same) {
            active.cause = false;
        }
    }

    /// What a fault reset does: what it may clear is cleared. When nothing is left, a message says so.
    pub(crate) fn reset(&mut self, sends: bool) {
        let were = self.is_active();
        self.active.retain(|active| !active.is_resettable());
        if were && !self.is_active() && sends {
            self.messages.push([0; 8]);
        }
    }

    pub(crate) const fn is_active(&self) -> bool {
        self.active.used > 0
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = ActiveAlarm<'m>> + '_ {
        self.active.iter()
    }

    /// The code of the alarm that came last; 0 without any.
    pub(crate) fn code(&self) -> u16 {
        self.active.iter().next_back().map_or(0, |active| active.alarm.code())
    }

    /// The error register, 1001h: a bit for each class of the codes, and bit 0 for any.
    pub(crate) fn register(&self) -> u8 {
        self.active.iter().fold(0, |register, active| register | class(active.alarm.code()))
    }

    /// The oldest message.
    pub(crate) fn message(&mut self) -> Option<Emergency> {
        self.messages.take_first()
    }
}

/// The bits of the error register for a code, by its class in CiA 301; bit 0 always.
const fn class(code: u16) -> u8 {
    let bit = match code >> 8 {
        0x20..=0x2F => 1 << 1,
        0x30..=0x3F => 1 << 2,
        0x40..=0x4F => 1 << 3,
        0x81..=0x82 => 1 << 4,
        0x83..=0x8F => 1 << 5,
        0xFF => 1 << 7,
        _ => 0,
    };
    bit | 1
}

/// The message of an alarm: as the manual lays it out, or as CiA 301 does with nothing in the maker's five bytes.
fn message(model: &DriveModel<'_>, alarm: &AlarmDesc<'_>, register: u8) -> Emergency {
    let mut bytes = [0; 8];
    let mut put = |byte: u8, length: u8, value: u16| {
        let room = bytes.iter_mut().skip(usize::from(byte)).take(usize::from(length));
        room.zip(value.to_le_bytes()).for_each(|(to, from)| *to = from);
    };
    if model.emcy().is_empty() {
        put(0, 2, alarm.code());
        put(2, 1, u16::from(register));
    }
    for part in model.emcy() {
        let value = match part.holds() {
            EmcyContent::ErrorCode => alarm.code(),
            EmcyContent::ErrorRegister => u16::from(register),
            EmcyContent::ErrorNumber => alarm.number(),
            EmcyContent::AuxiliaryCode => alarm.aux().unwrap_or(0),
            EmcyContent::Reserved => 0,
        };
        put(part.byte(), part.bytes(), value);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::super::samples::MODEL;
    use super::*;

    fn alarm(display: &str, number: u16) -> &'static AlarmDesc<'static> {
        MODEL.alarm(display, number).unwrap()
    }

    #[test]
    fn the_register_has_a_bit_for_each_class() {
        for (code, register) in [
            (0x2310, 0b0000_0011),
            (0x3220, 0b0000_0101),
            (0x4210, 0b0000_1001),
            (0x8130, 0b0001_0001),
            (0x8611, 0b0010_0001),
            (0xFF00, 0b1000_0001),
            (0x7305, 1),
            (0x1000, 1),
        ] {
            assert_eq!(class(code), register, "{code:04X}");
        }
    }

    #[test]
    fn a_reset_clears_what_it_may() {
        let mut alarms = Alarms::new(&MODEL);
        alarms.raise(alarm("OF", 0x25), true, true);
        alarms.raise(alarm("ET", 0x06), false, true);
        alarms.raise(alarm("OF", 0x25), false, true);
        assert_eq!((alarms.iter().count(), alarms.code(), alarms.register()), (2, 0x7305, 0x21));
        alarms.reset(true);
        assert_eq!(alarms.iter().count(), 2, "one has its cause, the other cannot be reset");
        alarms.end_cause(alarm("OF", 0x25));
        alarms.reset(true);
        assert_eq!(alarms.iter().count(), 1);
        assert_eq!(alarms.message(), Some([0x11, 0x86, 0x21, 0, 0, 0, 0, 0]));
        assert_eq!(alarms.message(), Some([0x05, 0x73, 0x21, 0, 0, 0, 0, 0]));
        assert_eq!(alarms.message(), None, "one is left, so nobody says that none is");
    }

    #[test]
    fn what_is_full_keeps_the_oldest() {
        let mut list = Bounded::<u8, 2>::EMPTY;
        assert_eq!((list.push(1), list.push(2), list.push(3)), (true, true, false));
        assert_eq!((list.take_first(), list.take_first(), list.take_first()), (Some(1), Some(2), None));
        assert!(list.push(4));
        assert_eq!(list.take_first(), Some(4));
    }
}
