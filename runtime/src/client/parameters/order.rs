//! In which order a set is written.
//!
//! 1. Only what differs is written.
//! 2. With the whole set written, no rule may be broken that names an entry of the set; else nothing is written.
//! 3. Again and again the first entry is taken whose write breaks no rule that holds at that moment. Entries of the factor
//!    group come before limits, limits before the rest, within these the order of the caller.
//! 4. If no entry can be taken, there is no order, and nothing is written.
//!
//! For rules between two entries this finds an order wherever there is one: if both values of `a < b` change, one of the two
//! orders is always free, and which one does not depend on anything else. For rules over three and more entries there may
//! be an order that it does not find; it then says so instead of trying all of them.

use super::on_first_axis;
use crate::address::Address;
use crate::model::DriveModel;
use crate::rule::{Occasion, Op, RuleDesc, Term};

/// Memory for one entry of a set, or for one that its rules need. A caller gives an array of them:
/// `[Slot::EMPTY; 32]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Slot {
    pub(super) address: Address,
    /// What the device has; `None` where that is not known, or no number.
    pub(super) now: Option<i128>,
    /// What is wanted; `None` for text.
    pub(super) wanted: Option<i128>,
    pub(super) role: Role,
}

/// What a slot is for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    /// Only rules need it.
    Beside,
    /// It may have to be written.
    Open,
    /// The device has it already.
    Same,
    /// It is written in this turn, from 0.
    Turn(u16),
    /// It was written in this turn.
    Written(u16),
}

impl Slot {
    /// A slot that holds nothing.
    pub const EMPTY: Self = Self { address: Address::new(0, 0), now: None, wanted: None, role: Role::Beside };

    /// The value once all turns so far are taken.
    const fn planned(&self) -> Option<i128> {
        match self.role {
            Role::Turn(_) | Role::Written(_) | Role::Same => self.wanted,
            Role::Beside | Role::Open => self.now,
        }
    }
}

/// The rules that hold for a set: those that hold always, and those of the occasions that the caller names.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rules<'m, 'o> {
    pub(super) model: &'m DriveModel<'m>,
    pub(super) occasions: &'o [Occasion],
}

impl<'m> Rules<'m, '_> {
    /// Those that name this entry and that a program can check.
    pub(super) fn about(&self, address: Address) -> impl Iterator<Item = &'m RuleDesc<'m>> + '_ {
        let counts = |rule: &RuleDesc<'_>| rule.on().map_or(true, |on| self.occasions.contains(&on));
        let rules = self.model.rules().iter().filter(move |rule| counts(rule));
        rules.filter(move |rule| rule.require().is_some() && rule.names(address))
    }
}

/// A lower limit that is not above its upper one. Drives check that for themselves, whether the manual says it or not; so
/// an order is sought that obeys it, but a set need not.
static LIMITS: [RuleDesc<'static>; 2] = [pair(&POSITION_RANGE), pair(&SOFTWARE_LIMIT)];
static POSITION_RANGE: [Term; 3] = ascending(0x607B);
static SOFTWARE_LIMIT: [Term; 3] = ascending(0x607D);

const fn pair(require: &'static [Term]) -> RuleDesc<'static> {
    RuleDesc::new("", "").with_require(require)
}

const fn ascending(index: u16) -> [Term; 3] {
    [Term::Object(Address::new(index, 1)), Term::Object(Address::new(index, 2)), Term::Apply(Op::AtMost)]
}

fn value(slots: &[Slot], address: Address) -> Option<i128> {
    slots.iter().find(|slot| slot.address == address)?.planned()
}

/// The first rule that is broken with the whole set written, and the entry that it names.
pub(super) fn broken_in_the_end<'m>(
    rules: &Rules<'m, '_>,
    slots: &[Slot],
) -> Option<(Address, &'m RuleDesc<'m>)> {
    let end = |address| {
        let slot = slots.iter().find(|slot| slot.address == address)?;
        if slot.role == Role::Beside {
            slot.now
        } else {
            slot.wanted
        }
    };
    let of_set = slots.iter().filter(|slot| slot.role != Role::Beside);
    of_set
        .map(|slot| slot.address)
        .find_map(|address| rules.about(address).find(|rule| rule.broken(end)).map(|rule| (address, rule)))
}

/// Gives every open slot its turn, or names one that can have none and the rule that is in its way.
pub(super) fn give_turns<'m>(
    rules: &Rules<'m, '_>,
    slots: &mut [Slot],
) -> Result<(), (Address, Option<&'m RuleDesc<'m>>)> {
    for turn in 0..=u16::MAX {
        let Some(first) = slots.iter().find(|slot| slot.role == Role::Open).map(|slot| slot.address) else {
            break;
        };
        let Some(next) = next_free(rules, slots) else {
            return Err((first, in_the_way(rules, slots, first)));
        };
        if let Some(slot) = slots.get_mut(next) {
            slot.role = Role::Turn(turn);
        }
    }
    Ok(())
}

/// The open slot that is to be written next.
fn next_free(rules: &Rules<'_, '_>, slots: &[Slot]) -> Option<usize> {
    let open = || (0..slots.len()).zip(slots).filter(|(_, slot)| slot.role == Role::Open);
    let free = || open().filter(|(_, slot)| in_the_way(rules, slots, slot.address).is_none());
    let gentle = free().filter(|(_, slot)| !LIMITS.iter().any(|rule| breaks(rule, slots, slot.address)));
    let first = |slots: &mut dyn Iterator<Item = (usize, &Slot)>| {
        slots.min_by_key(|(place, slot)| (rank(slot.address), *place)).map(|(place, _)| place)
    };
    first(&mut gentle.into_iter()).or_else(|| first(&mut free()))
}

/// The rule that holds now and would not, if the wanted value of `address` were written next.
fn in_the_way<'m>(rules: &Rules<'m, '_>, slots: &[Slot], address: Address) -> Option<&'m RuleDesc<'m>> {
    rules.about(address).find(|rule| breaks(rule, slots, address))
}

fn breaks(rule: &RuleDesc<'_>, slots: &[Slot], address: Address) -> bool {
    let wanted = slots.iter().find(|slot| slot.address == address).and_then(|slot| slot.wanted);
    let after = |at| if at == address { wanted } else { value(slots, at) };
    rule.names(address) && !rule.broken(|at| value(slots, at)) && rule.broken(after)
}

/// Factor group, limits, the rest.
const fn rank(address: Address) -> u8 {
    match on_first_axis(address.index()) {
        0x608F..=0x6092 | 0x6096 | 0x6097 => 0,
        0x6072 | 0x6073 | 0x607B | 0x607D | 0x607F | 0x6080 | 0x60C5 | 0x60C6 | 0x60E0 | 0x60E1 => 1,
        _ => 2,
    }
}
