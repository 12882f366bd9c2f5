//! Names of the bits of the statusword, as they are in the mode that the drive is in.

use drivewright_runtime::cia402::{Mode, Statusword};

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

/// What a bit of [`PLAIN`] is called in a mode.
pub(super) fn name(bit: u16, plain: &'static str, mode: Mode) -> &'static str {
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

/// The bits that came and went, each by its name in the mode in which it was set: `+target reached, -remote`. Nothing
/// where the state alone changed.
pub(super) fn changed(before: (Statusword, Mode), now: (Statusword, Mode)) -> String {
    let differing = PLAIN.iter().filter(|(bit, _)| (before.0.0 ^ now.0.0) & bit != 0);
    let signed = differing.map(|(bit, plain)| {
        let (sign, mode) = if now.0.0 & bit == 0 { ('-', before.1) } else { ('+', now.1) };
        format!("{sign}{}", name(*bit, plain, mode))
    });
    signed.collect::<Vec<_>>().join(", ")
}
