//! Codes of units after ETG.1004, which are those of CiA 303-2: a power of ten, a numerator, a denominator.
//!
//! Numerators from F0h are this file's own: user units and shares of rated values have no code, and an ESI may name units
//! that it adds. A factor that is no power of ten has no code.

use crate::model::{Quantity, Unit};

/// A unit that the file itself names.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Own {
    pub(super) notation: u8,
    pub(super) name: &'static str,
    pub(super) symbol: &'static str,
}

/// Quantity, numerator, denominator, and how many of the quantity's base units it is.
const CODES: &[(Quantity, u8, u8, u64, u64)] = &[
    (Quantity::Counts, 0xB5, 0, 1, 1),
    (Quantity::Angle, 0xB4, 0, 1, 1),
    (Quantity::Angle, 0x41, 0, 1, 360),
    (Quantity::Velocity, 0xB4, 0x47, 1, 1),
    (Quantity::Velocity, 0xB4, 0x03, 60, 1),
    (Quantity::Time, 0x03, 0, 1, 1),
    (Quantity::Time, 0x47, 0, 60, 1),
    (Quantity::Time, 0x48, 0, 3_600, 1),
    (Quantity::Current, 0x04, 0, 1, 1),
    (Quantity::Voltage, 0x26, 0, 1, 1),
    (Quantity::Power, 0x24, 0, 1, 1),
    (Quantity::Temperature, 0x2D, 0, 1, 1),
    (Quantity::Frequency, 0x20, 0, 1, 1),
    (Quantity::Ratio, 0x00, 0, 1, 1),
    (Quantity::Resistance, 0x28, 0, 1, 1),
    (Quantity::Inductance, 0x2C, 0, 1, 1),
    (Quantity::Length, 0x01, 0, 1, 1),
    (Quantity::UserPosition, 0xF0, 0, 1, 1),
    (Quantity::UserVelocity, 0xF1, 0, 1, 1),
    (Quantity::UserAcceleration, 0xF2, 0, 1, 1),
    (Quantity::TorqueRatio, 0xF3, 0, 1, 1),
    (Quantity::CurrentRatio, 0xF4, 0, 1, 1),
    (Quantity::Acceleration, 0xF5, 0, 1, 1),
    (Quantity::Torque, 0x56, 0, 1, 1),
    (Quantity::Inertia, 0xF7, 0, 1, 1),
];

const OWN: &[Own] = &[
    Own { notation: 0xF0, name: "user position", symbol: "pos" },
    Own { notation: 0xF1, name: "user velocity", symbol: "vel" },
    Own { notation: 0xF2, name: "user acceleration", symbol: "acc" },
    Own { notation: 0xF3, name: "rated torque", symbol: "rated torque" },
    Own { notation: 0xF4, name: "rated current", symbol: "rated current" },
    Own { notation: 0xF5, name: "revolutions per minute and second", symbol: "rpm/s" },
    Own { notation: 0xF7, name: "kilogram square metre", symbol: "kg m2" },
];

/// The code of a unit, and the unit that the file must name for it.
pub(super) fn code(unit: &Unit) -> Option<(u32, Option<Own>)> {
    let codes = CODES.iter().filter(|(quantity, ..)| *quantity == unit.quantity);
    let found = codes.filter_map(|(_, numerator, denominator, num, den)| {
        let power = power_of_ten(u64::from(unit.num) * den, u64::from(unit.den) * num)?;
        let code = u32::from_be_bytes([power.to_le_bytes()[0], *numerator, *denominator, 0]);
        Some((code, OWN.iter().find(|own| own.notation == *numerator).copied()))
    });
    // Of two codes that fit, the one without a factor says it plainer.
    found.min_by_key(|(code, _)| code.to_be_bytes()[0])
}

/// The power of ten that `num / den` is.
fn power_of_ten(num: u64, den: u64) -> Option<i8> {
    let (larger, smaller, sign) = if num >= den { (num, den, 1) } else { (den, num, -1) };
    let quotient = larger.checked_div(smaller).filter(|q| q * smaller == larger)?;
    let power = quotient.checked_ilog10().filter(|power| 10_u64.pow(*power) == quotient)?;
    i8::try_from(power).ok().map(|power| sign * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Option<u32> {
        code(&Unit::parse(text).unwrap()).map(|(code, _)| code)
    }

    #[test]
    fn codes_of_cia_303() {
        assert_eq!(of("rpm"), Some(0x00B4_4700));
        assert_eq!(of("0.1 rpm"), Some(0xFFB4_4700));
        assert_eq!(of("mV"), Some(0xFD26_0000));
        assert_eq!(of("ns"), Some(0xF703_0000));
        assert_eq!(of("min"), Some(0x0047_0000));
        assert_eq!(of("0.1 kHz"), Some(0x0220_0000));
        assert_eq!(of("deg"), Some(0x0041_0000));
        assert_eq!(of("%"), Some(0xFE00_0000));
        assert_eq!(of("N m"), Some(0x0056_0000));
        assert_eq!(of("0.1 A"), Some(0xFF04_0000));
    }

    #[test]
    fn own_units_are_named_and_odd_factors_have_no_code() {
        let (code, own) = code(&Unit::parse("0.1 % rated torque").unwrap()).unwrap();
        assert_eq!((code, own.map(|o| o.name)), (0xFDF3_0000, Some("rated torque")));
        assert_eq!(of("1/65536 rev"), None);
        assert_eq!(of("60 deg"), None);
        for own in OWN {
            assert!(CODES.iter().any(|(_, numerator, ..)| *numerator == own.notation));
        }
        for quantity in Quantity::ALL {
            assert!(CODES.iter().any(|(of, ..)| of == quantity), "{quantity:?}");
        }
    }
}
