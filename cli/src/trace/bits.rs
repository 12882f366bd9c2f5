//! Names of the bits of the statusword, as they are in the mode that the drive is in.

use drivewright_codegen::emit::escape::one_line;
use drivewright_runtime::Address;
use drivewright_runtime::cia402::{Mode, Statusword};
use drivewright_runtime::model::DriveModel;

/// Bits that are no part of the state, with their names in no particular mode.
pub(super) const PLAIN: &[(u16, &str)] = &[
    (Statusword::VOLTAGE_ENABLED, "voltage enabled"),
    (Statusword::WARNING, "warning"),
    (Statusword::MANUFACTURER_8, "bit 8"),
    (Statusword::REMOTE, "remote"),
    (Statusword::TARGET_REACHED, "target reached"),
    (Statusword::INTERNAL_LIMIT, "internal limit active"),
    (Statusword::MODE_12, "bit 12"),
    (Statusword::MODE_13, "bit 13"),
    (Statusword::MANUFACTURER_14, "bit 14"),
    (Statusword::MANUFACTURER_15, "bit 15"),
];

/// What a drive calls its bits.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct BitNames(Vec<(u16, Option<i8>, String)>);

impl BitNames {
    /// The names of the bits of the statusword in a profile, in lower case.
    pub(crate) fn of(model: &DriveModel<'_>) -> Self {
        let table = model.object(Address::new(0x6041, 0)).and_then(|object| model.bits_of(object));
        let rows = table.map_or(&[][..], |table| table.bits()).iter().filter(|row| row.width() == 1);
        let named = rows.filter_map(|row| {
            Some((1_u16.checked_shl(row.bit().into())?, row.mode(), one_line(row.name()).to_lowercase()))
        });
        Self(named.collect())
    }

    /// What a bit is called in a mode: by the profile, or by the standard.
    pub(super) fn name(&self, bit: u16, plain: &'static str, mode: Mode) -> &str {
        let of = |wanted: Option<i8>| {
            let row = self.0.iter().find(|(named, mode, _)| *named == bit && *mode == wanted);
            row.map(|(.., name)| name.as_str())
        };
        of(Some(mode.0)).or_else(|| of(None)).unwrap_or_else(|| standard(bit, plain, mode))
    }

    /// The bits that came and went, each by its name in the mode in which it was set: `+target reached, -remote`. Nothing
    /// where the state alone changed.
    pub(super) fn changed(&self, before: (Statusword, Mode), now: (Statusword, Mode)) -> String {
        let differing = PLAIN.iter().filter(|(bit, _)| (before.0.0 ^ now.0.0) & bit != 0);
        let signed = differing.map(|(bit, plain)| {
            let (sign, mode) = if now.0.0 & bit == 0 { ('-', before.1) } else { ('+', now.1) };
            format!("{sign}{}", self.name(*bit, plain, mode))
        });
        signed.collect::<Vec<_>>().join(", ")
    }
}

/// What CiA 402 calls a bit of [`PLAIN`] in a mode.
fn standard(bit: u16, plain: &'static str, mode: Mode) -> &'static str {
    let cyclic = mode.is_cyclic();
    match (bit, mode) {
        (Statusword::MODE_12, Mode::PROFILE_POSITION) => "set-point acknowledge",
        (Statusword::MODE_12, Mode::PROFILE_VELOCITY) => "speed is zero",
        (Statusword::MODE_12, Mode::HOMING) => "homing attained",
        (Statusword::MODE_12, _) if cyclic => "follows the target",
        (Statusword::MODE_13, Mode::PROFILE_POSITION | Mode::CYCLIC_POSITION) => "following error",
        (Statusword::MODE_13, Mode::HOMING) => "homing error",
        _ => plain,
    }
}
