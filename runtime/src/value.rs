//! Physical values: exact fractions of a base unit.

use core::cmp::Ordering;
use core::fmt;
use core::marker::PhantomData;

use crate::quantity::{
    Acceleration, Angle, Current, CurrentRatio, Frequency, Length, Power, Quantity, Ratio, Temperature, Time,
    Torque, TorqueRatio, Velocity, Voltage,
};
use crate::ratio::{gcd, quotient};

/// A physical value, exact: a fraction of the base unit of `Q`, always reduced.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// let speed = Value::rpm(1_500);
/// let share = Value::per_mille_torque(-25);
/// assert_eq!(speed.to_string(), "1500 rpm");
/// assert_eq!(share.to_string(), "-0.025 rated torque");
/// assert_eq!((share.num(), share.den()), (-1, 40));
/// ```
pub struct Value<Q> {
    num: i64,
    den: u32,
    quantity: PhantomData<fn() -> Q>,
}

impl<Q> Value<Q> {
    /// Zero.
    pub const ZERO: Self = Self::whole(0);

    /// `num / den` of the base unit; `None` if `den` is 0.
    pub const fn new(num: i64, den: u32) -> Option<Self> {
        if den == 0 {
            return None;
        }
        Some(Self::reduced(num, den))
    }

    /// `num` of the base unit.
    pub const fn whole(num: i64) -> Self {
        Self { num, den: 1, quantity: PhantomData }
    }

    /// `num / den` where `den` is not 0.
    // What is cast has become smaller, or is a `u32` for a start.
    #[allow(clippy::cast_possible_wrap, clippy::cast_possible_truncation)]
    pub(crate) const fn reduced(num: i64, den: u32) -> Self {
        let common = gcd(num.unsigned_abs(), den as u64);
        let size = quotient(num.unsigned_abs(), common) as i64;
        // Only `i64::MIN` over an odd number stays 2^63: the cast has already made it negative.
        let num = if num < 0 { size.wrapping_neg() } else { size };
        Self { num, den: quotient(den as u64, common) as u32, quantity: PhantomData }
    }

    /// Above the line of the reduced fraction.
    pub const fn num(self) -> i64 {
        self.num
    }

    /// Below the line of the reduced fraction, never 0.
    pub const fn den(self) -> u32 {
        self.den
    }

    /// The value in base units as floating point, for display and plots: may be inexact.
    #[allow(clippy::cast_precision_loss)]
    pub fn to_f64(self) -> f64 {
        self.num as f64 / f64::from(self.den)
    }
}

macro_rules! units {
    ($($quantity:ident { $($(#[$doc:meta])* $name:ident: $mul:literal / $den:literal;)* })*) => {$(
        impl Value<$quantity> {
            $(
                $(#[$doc])*
                ///
                /// Up to 32 bits, so that the result is exact.
                pub const fn $name(n: i32) -> Self {
                    Self::reduced(n as i64 * $mul, $den)
                }
            )*
        }
    )*};
}

units! {
    Angle {
        /// Revolutions.
        revolutions: 1 / 1;
        /// Degrees: 1/360 of a revolution.
        degrees: 1 / 360;
    }
    Velocity {
        /// Revolutions per minute.
        rpm: 1 / 1;
        /// Revolutions per second.
        revolutions_per_second: 60 / 1;
    }
    Acceleration {
        /// Revolutions per minute, per second.
        rpm_per_second: 1 / 1;
        /// Revolutions per minute, per millisecond.
        rpm_per_millisecond: 1_000 / 1;
    }
    Time {
        /// Seconds.
        seconds: 1 / 1;
        /// Milliseconds.
        milliseconds: 1 / 1_000;
        /// Microseconds.
        microseconds: 1 / 1_000_000;
    }
    TorqueRatio {
        /// Percent of rated torque.
        percent_torque: 1 / 100;
        /// Thousandths of rated torque.
        per_mille_torque: 1 / 1_000;
    }
    Torque {
        /// Newton metres.
        newton_metres: 1 / 1;
        /// Thousandths of a newton metre.
        newton_millimetres: 1 / 1_000;
    }
    CurrentRatio {
        /// Percent of rated current.
        percent_current: 1 / 100;
        /// Thousandths of rated current.
        per_mille_current: 1 / 1_000;
    }
    Current {
        /// Amperes.
        amperes: 1 / 1;
        /// Milliamperes.
        milliamperes: 1 / 1_000;
    }
    Voltage {
        /// Volts.
        volts: 1 / 1;
        /// Millivolts.
        millivolts: 1 / 1_000;
    }
    Power {
        /// Watts.
        watts: 1 / 1;
    }
    Temperature {
        /// Degrees Celsius.
        celsius: 1 / 1;
    }
    Frequency {
        /// Hertz.
        hertz: 1 / 1;
    }
    Ratio {
        /// Percent.
        percent: 1 / 100;
    }
    Length {
        /// Metres.
        metres: 1 / 1;
        /// Millimetres.
        millimetres: 1 / 1_000;
        /// Micrometres.
        micrometres: 1 / 1_000_000;
    }
}

// Derives would ask the same of the marker type.
impl<Q> Clone for Value<Q> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Q> Copy for Value<Q> {}

impl<Q> PartialEq for Value<Q> {
    fn eq(&self, other: &Self) -> bool {
        (self.num, self.den) == (other.num, other.den)
    }
}

impl<Q> Eq for Value<Q> {}

impl<Q> PartialOrd for Value<Q> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<Q> Ord for Value<Q> {
    fn cmp(&self, other: &Self) -> Ordering {
        let left = i128::from(self.num) * i128::from(other.den);
        left.cmp(&(i128::from(other.num) * i128::from(self.den)))
    }
}

impl<Q: Quantity> fmt::Display for Value<Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_fraction(f, self.num, self.den)?;
        match Q::KIND.symbol() {
            "" => Ok(()),
            symbol => write!(f, " {symbol}"),
        }
    }
}

impl<Q: Quantity> fmt::Debug for Value<Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

const POWERS_OF_TEN: [u32; 10] =
    [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000, 1_000_000_000];

/// As a decimal where that is exact within nine places, otherwise as a fraction.
pub(crate) fn write_fraction(f: &mut fmt::Formatter<'_>, num: i64, den: u32) -> fmt::Result {
    let places = (0..=9_u8).zip(POWERS_OF_TEN).find(|(_, ten)| ten.checked_rem(den) == Some(0));
    let sign = if num < 0 { "-" } else { "" };
    let (num, den) = (num.unsigned_abs(), u64::from(den));
    match places {
        Some((0, _)) => write!(f, "{sign}{num}"),
        Some((places, ten)) => {
            let whole = quotient(num, den);
            let rest = num.saturating_sub(whole.saturating_mul(den));
            let part = rest.saturating_mul(quotient(ten.into(), den));
            write!(f, "{sign}{whole}.{part:0width$}", width = usize::from(places))
        }
        None => write!(f, "{sign}{num}/{den}"),
    }
}

#[cfg(feature = "serde")]
impl<Q: Quantity> serde::Serialize for Value<Q> {
    /// As the fraction: a pair of numerator and denominator.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.num, self.den).serialize(serializer)
    }
}

#[cfg(feature = "defmt")]
impl<Q: Quantity> defmt::Format for Value<Q> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=i64}/{=u32} {=str}", self.num, self.den, Q::KIND.symbol());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn values_are_reduced() {
        let half = Value::<Ratio>::percent(50);
        assert_eq!((half.num(), half.den()), (1, 2));
        assert_eq!(Some(half), Value::new(2, 4));
        assert_eq!(Value::<Ratio>::new(0, 7), Some(Value::ZERO));
        assert_eq!(Value::<Ratio>::new(1, 0), None);
        let least = Value::<Ratio>::new(i64::MIN, u32::MAX).unwrap();
        assert_eq!((least.num(), least.den()), (i64::MIN, u32::MAX));
    }

    #[test]
    fn text_is_exact() {
        let text = |num, den| Value::<Velocity>::new(num, den).unwrap().to_string();
        assert_eq!(text(30_000, 10), "3000 rpm");
        assert_eq!(text(-1, 10), "-0.1 rpm");
        assert_eq!(text(1, 1_000_000_000), "0.000000001 rpm");
        assert_eq!(text(-1, 3), "-1/3 rpm");
        assert_eq!(text(i64::MIN, 1), "-9223372036854775808 rpm");
        assert_eq!(Value::<Ratio>::percent(5).to_string(), "0.05");
        assert_eq!(Value::<Angle>::degrees(-90).to_string(), "-0.25 rev");
    }

    #[test]
    fn order_is_by_size() {
        let v = |num, den| Value::<Time>::new(num, den).unwrap();
        assert!(v(1, 3) < v(1, 2));
        assert!(v(-1, 3) > v(-1, 2));
        assert!(v(i64::MAX, u32::MAX) < v(i64::MAX, u32::MAX - 1));
    }
}
