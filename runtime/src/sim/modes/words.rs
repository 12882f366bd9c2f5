//! Where a drive's bits differ from CiA 402, as its own tables name them.

use crate::bit_field::BitDesc;
use crate::cia402::{Mode, ModeBits, Statusword};

use super::super::memory::{Memory, Slot};
use super::super::slots::Slots;

/// Modes that the virtual drive has.
const MODES: [Mode; 7] = [
    Mode::PROFILE_POSITION,
    Mode::PROFILE_VELOCITY,
    Mode::PROFILE_TORQUE,
    Mode::HOMING,
    Mode::CYCLIC_POSITION,
    Mode::CYCLIC_VELOCITY,
    Mode::CYCLIC_TORQUE,
];

/// Bits of the statusword that belong to the mode.
const OF_MODE: u16 =
    Statusword::TARGET_REACHED | Statusword::INTERNAL_LIMIT | Statusword::MODE_12 | Statusword::MODE_13;

/// What the bits of a mode mean.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words {
    /// Controlword bit 6 in profile position: set, the target is absolute.
    pub(super) set_is_absolute: bool,
    /// The bit of each mode that says that the axis stands; 0 where there is none.
    stands: [u16; MODES.len()],
    /// The bits that the drive shows in each mode.
    shown: [u16; MODES.len()],
}

fn place(mode: Mode) -> Option<usize> {
    MODES.iter().position(|own| *own == mode)
}

/// Whether the virtual drive has the mode.
pub(super) fn is_known(mode: Mode) -> bool {
    mode == Mode::NONE || place(mode).is_some()
}

impl Words {
    pub(super) fn of(memory: &Memory<'_, '_>, slots: &Slots) -> Self {
        let absolute = |bit: &BitDesc<'_>| {
            bit.bit() == 6 && bit.mode() == Some(Mode::PROFILE_POSITION.0) && starts(bit.name(), "abs")
        };
        let set_is_absolute = table(memory, slots.controlword).iter().any(absolute);
        let status = table(memory, slots.statusword);
        let (mut stands, mut shown) = ([0; MODES.len()], [OF_MODE; MODES.len()]);
        for ((mode, stands), shown) in MODES.iter().zip(&mut stands).zip(&mut shown) {
            *stands = standing(status, *mode);
            if status.iter().any(|bit| bit.mode().is_some()) {
                *shown = listed(status, *mode);
            }
        }
        Self { set_is_absolute, stands, shown }
    }

    /// The bit that says that the axis stands; 0 where there is none.
    pub(super) fn stands(&self, mode: Mode) -> u16 {
        place(mode).and_then(|at| self.stands.get(at).copied()).unwrap_or(0)
    }

    /// The bits that the drive shows.
    pub(super) fn shown(&self, mode: Mode) -> u16 {
        place(mode).and_then(|at| self.shown.get(at).copied()).unwrap_or(0)
    }
}

fn table<'m>(memory: &Memory<'m, '_>, slot: Slot) -> &'m [BitDesc<'m>] {
    let object = memory.object(slot);
    object.and_then(|object| memory.model().bits_of(object)).map_or(&[], |table| table.bits())
}

/// The bit with a name of standing still: bit 12 in profile velocity where the table has none.
fn standing(status: &[BitDesc<'_>], mode: Mode) -> u16 {
    let named = |bit: &&BitDesc<'_>| {
        let name = bit.name();
        bit.mode() == Some(mode.0)
            && (starts(name, "speed zero") || starts(name, "zero speed") || starts(name, "speed is 0"))
    };
    let own = status.iter().find(named).map(mask);
    let standard = if mode == Mode::PROFILE_VELOCITY { ModeBits::SPEED_IS_ZERO } else { 0 };
    own.unwrap_or(standard)
}

/// The bits that the table lists for the mode, or for every one.
fn listed(status: &[BitDesc<'_>], mode: Mode) -> u16 {
    let own = status.iter().filter(|bit| bit.mode().map_or(true, |own| own == mode.0));
    own.map(mask).fold(0, |set, bit| set | bit) & OF_MODE
}

fn mask(bit: &BitDesc<'_>) -> u16 {
    1_u16.checked_shl(u32::from(bit.bit())).unwrap_or(0)
}

fn starts(name: &str, with: &str) -> bool {
    name.as_bytes().get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with.as_bytes()))
}
