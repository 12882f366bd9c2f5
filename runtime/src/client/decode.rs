//! Words that CiA 301 and CiA 402 define, as names: supported modes, error register, digital inputs.

use core::fmt;

use crate::address::Address;
use crate::bit_field::BitDesc;
use crate::cia402::Mode;
use crate::client::message::Clean;
use crate::client::object::Bits;
use crate::model::{DriveModel, TerminalKind};

/// Supported drive modes, 6502h.
///
/// ```
/// use drivewright_runtime::cia402::Mode;
/// use drivewright_runtime::client::decode::SupportedModes;
///
/// let modes = SupportedModes(0x0000_0225);
/// assert!(modes.has(Mode::HOMING) && !modes.has(Mode::CYCLIC_POSITION));
/// assert_eq!(
///     modes.to_string(),
///     "profile position, profile velocity, homing, cyclic synchronous torque [00000225h]"
/// );
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SupportedModes(pub u32);

impl SupportedModes {
    /// Whether the drive has this mode. No standard says which bit stands for one of the maker's or for no mode: never.
    pub fn has(self, mode: Mode) -> bool {
        mode.supported_bit().is_some_and(|bit| self.0 & bit != 0)
    }

    /// The modes, by number. Bit 4 and bits above 10 name none.
    pub fn modes(self) -> impl Iterator<Item = Mode> {
        (1..=11).map(Mode).filter(move |mode| self.has(*mode) && mode.name().is_some())
    }

    /// The bits that are set and stand for no mode of the standard.
    fn others(self) -> impl Iterator<Item = u32> {
        let known = self.modes().filter_map(Mode::supported_bit).fold(0, |known, bit| known | bit);
        (0..u32::BITS).filter(move |bit| (self.0 & !known) & 1_u32.wrapping_shl(*bit) != 0)
    }
}

impl fmt::Display for SupportedModes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut gap = "";
        for mode in self.modes() {
            write!(f, "{gap}{}", mode.name().unwrap_or_default())?;
            gap = ", ";
        }
        for bit in self.others() {
            write!(f, "{gap}{} bit {bit}", if bit < 16 { "reserved" } else { "maker's" })?;
            gap = ", ";
        }
        write!(f, "{} [{:08X}h]", if gap.is_empty() { "none" } else { "" }, self.0)
    }
}

static REGISTER: [BitDesc<'static>; 8] = [
    BitDesc::new(0, 1, "generic"),
    BitDesc::new(1, 1, "current"),
    BitDesc::new(2, 1, "voltage"),
    BitDesc::new(3, 1, "temperature"),
    BitDesc::new(4, 1, "communication"),
    BitDesc::new(5, 1, "device profile"),
    BitDesc::new(6, 1, "reserved"),
    BitDesc::new(7, 1, "manufacturer"),
];

/// Error register, 1001h.
///
/// ```
/// use drivewright_runtime::client::decode::ErrorRegister;
///
/// assert_eq!(ErrorRegister(0x21).to_string(), "generic, device profile [21h]");
/// assert_eq!(ErrorRegister(0).to_string(), "[00h]");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ErrorRegister(pub u8);

impl fmt::Display for ErrorRegister {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Bits { rows: &REGISTER, word: self.0.into(), digits: 2 }.fmt(f)
    }
}

/// Digital inputs, 60FDh.
const DIGITAL_INPUTS: Address = Address::new(0x60FD, 0);

static INPUTS: [BitDesc<'static>; 4] = [
    BitDesc::new(0, 1, "negative limit switch"),
    BitDesc::new(1, 1, "positive limit switch"),
    BitDesc::new(2, 1, "home switch"),
    BitDesc::new(3, 1, "interlock"),
];

/// Digital inputs, 60FDh, by the names of the drive's manual where it gives them, otherwise of CiA 402. Whether a bit shows
/// the level of the terminal or what its function makes of it differs from drive to drive.
///
/// ```
/// use drivewright_runtime::client::decode::DigitalInputs;
/// use drivewright_runtime::prelude::*;
///
/// let model = DriveModel::new(Identity::new("acme-x3", "Acme", "X3"));
/// let inputs = DigitalInputs::new(&model, 0x0001_0005);
/// assert_eq!(inputs.to_string(), "negative limit switch, home switch [00010005h]");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DigitalInputs<'m> {
    model: &'m DriveModel<'m>,
    word: u32,
}

impl<'m> DigitalInputs<'m> {
    /// What was read from 60FDh.
    pub const fn new(model: &'m DriveModel<'m>, word: u32) -> Self {
        Self { model, word }
    }

    /// The names of the bits.
    fn rows(&self) -> &'m [BitDesc<'m>] {
        let table = self.model.object(DIGITAL_INPUTS).and_then(|object| self.model.bits_of(object));
        table.map_or(&INPUTS, |table| table.bits())
    }

    /// Whether the bit with this name is set; `None` where no bit has the name.
    pub fn is_set(&self, name: &str) -> Option<bool> {
        let row = self.rows().iter().find(|row| row.name() == name)?;
        Some(row.of(self.word.into()) != 0)
    }

    /// The terminals whose bit in 60FDh the manual prints, and whether that bit is set.
    pub fn terminals(&self) -> impl Iterator<Item = (&'m str, bool)> + 'm {
        let word = self.word;
        let inputs = self.model.terminals().iter().filter(|t| t.kind() == TerminalKind::Input);
        inputs.filter(|t| t.object() == Some(DIGITAL_INPUTS)).filter_map(move |terminal| {
            let mask = 1_u32.checked_shl(terminal.bit()?.into())?;
            Some((terminal.name(), word & mask != 0))
        })
    }
}

impl fmt::Display for DigitalInputs<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Bits { rows: self.rows(), word: self.word.into(), digits: 8 }.fmt(f)?;
        for (name, set) in self.terminals() {
            write!(f, " {}={}", Clean(name.as_bytes()), u8::from(set))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::client::testing::at;
    use crate::prelude::*;
    use std::string::ToString;
    use std::vec::Vec;

    #[test]
    fn b26_supported_modes_are_names_from_bytes_in_wire_order() {
        const SUPPORTED: Object<u32, Ro, Unmapped, Raw> = Object::new(0x6502, 0);
        let modes = SupportedModes(SUPPORTED.decode(&[0x25, 0x02, 0, 0]).unwrap());
        let numbers: Vec<i8> = modes.modes().map(|mode| mode.0).collect();
        assert_eq!(numbers, [1, 3, 6, 10]);
        assert!(!modes.to_string().contains("252"));
    }

    #[test]
    fn bits_without_a_mode_show_as_bits() {
        assert_eq!(SupportedModes(0).to_string(), "none [00000000h]");
        assert_eq!(
            SupportedModes(1 << 4 | 1 << 11 | 1 << 16).to_string(),
            "reserved bit 4, reserved bit 11, maker's bit 16 [00010810h]"
        );
        assert!(!SupportedModes(u32::MAX).has(Mode::NONE) && !SupportedModes(u32::MAX).has(Mode(-1)));
        assert_eq!(SupportedModes(u32::MAX).modes().count(), 10, "mode 5 is reserved");
    }

    #[test]
    fn every_bit_of_the_error_register_has_a_name() {
        assert_eq!(ErrorRegister(0xFF).to_string(),
            "generic, current, voltage, temperature, communication, device profile, reserved, manufacturer [FFh]");
    }

    #[test]
    fn inputs_have_the_names_of_the_manual() {
        let rows = [BitDesc::new(0, 1, "POT"), BitDesc::new(16, 1, "EI1")];
        let bits = [BitFieldDesc::new("inputs", &rows)];
        let objects =
            [ObjectDesc::new(at(0x60FD, 0), DataType::UNSIGNED32, Access::Ro, Mapping::Tx, "Inputs").bits(0)];
        let terminals = [
            TerminalDesc::new("CN1-3", TerminalKind::Input).with_object(at(0x60FD, 0)).with_bit(0),
            TerminalDesc::new("CN1-4", TerminalKind::Input).with_object(at(0x60FD, 0)).with_bit(40),
            TerminalDesc::new("CN1-5", TerminalKind::Input).with_object(at(0x4000, 1)).with_bit(1),
        ];
        let model =
            DriveModel::new(Identity::new("a", "b", "c")).with_objects(&objects).with_bit_fields(&bits);
        let model = model.with_terminals(&terminals);
        let inputs = DigitalInputs::new(&model, 0x0001_0002);
        assert_eq!(inputs.to_string(), "EI1 [00010002h] CN1-3=0");
        assert_eq!(
            (inputs.is_set("EI1"), inputs.is_set("POT"), inputs.is_set("x")),
            (Some(true), Some(false), None)
        );
    }
}
