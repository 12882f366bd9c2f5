//! Units without floating point: a quantity and the exact value of one count.

use std::fmt;

use crate::limits;

/// Defines the quantities with their names.
macro_rules! quantities {
    ($( $(#[doc = $doc:literal])+ $variant:ident = $name:literal, )+) => {
        /// What is measured. The base unit of each is the one that [`Quantity::base`] names.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Quantity {
            $( $(#[doc = $doc])+ $variant, )+
        }

        impl Quantity {
            /// Every quantity.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Name of the marker type in the runtime, in words.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }
        }

        impl From<Quantity> for drivewright_runtime::quantity::QuantityKind {
            fn from(quantity: Quantity) -> Self {
                match quantity {
                    $(Quantity::$variant => Self::$variant,)+
                }
            }
        }
    };
}

quantities! {
    /// Position in user units, which depend on the gear objects of the drive.
    UserPosition = "user position",
    /// Velocity in user units.
    UserVelocity = "user velocity",
    /// Acceleration in user units.
    UserAcceleration = "user acceleration",
    /// Encoder counts.
    Counts = "counts",
    /// Angle in revolutions.
    Angle = "angle",
    /// Speed of rotation in r/min.
    Velocity = "velocity",
    /// Acceleration in r/min per second.
    Acceleration = "acceleration",
    /// Time in seconds.
    Time = "time",
    /// Torque as a share of rated torque.
    TorqueRatio = "torque ratio",
    /// Torque in N m.
    Torque = "torque",
    /// Current as a share of rated current.
    CurrentRatio = "current ratio",
    /// Current in A.
    Current = "current",
    /// Voltage in V.
    Voltage = "voltage",
    /// Power in W.
    Power = "power",
    /// Temperature in °C.
    Temperature = "temperature",
    /// Frequency in Hz.
    Frequency = "frequency",
    /// A share of something else.
    Ratio = "ratio",
    /// Resistance in ohm.
    Resistance = "resistance",
    /// Inductance in H.
    Inductance = "inductance",
    /// Inertia in kg m².
    Inertia = "inertia",
    /// Length in m.
    Length = "length",
}

/// Symbol in a profile, quantity, and how many base units one of it is.
const SYMBOLS: &[(&str, Quantity, u32, u32)] = &[
    ("user position", Quantity::UserPosition, 1, 1),
    ("user velocity", Quantity::UserVelocity, 1, 1),
    ("user acceleration", Quantity::UserAcceleration, 1, 1),
    ("count", Quantity::Counts, 1, 1),
    ("rev", Quantity::Angle, 1, 1),
    ("deg", Quantity::Angle, 1, 360),
    ("rpm", Quantity::Velocity, 1, 1),
    ("rev/s", Quantity::Velocity, 60, 1),
    ("rpm/s", Quantity::Acceleration, 1, 1),
    ("rpm/ms", Quantity::Acceleration, 1_000, 1),
    ("h", Quantity::Time, 3_600, 1),
    ("min", Quantity::Time, 60, 1),
    ("s", Quantity::Time, 1, 1),
    ("ms", Quantity::Time, 1, 1_000),
    ("us", Quantity::Time, 1, 1_000_000),
    ("ns", Quantity::Time, 1, 1_000_000_000),
    ("rated torque", Quantity::TorqueRatio, 1, 1),
    ("% rated torque", Quantity::TorqueRatio, 1, 100),
    ("N m", Quantity::Torque, 1, 1),
    ("rated current", Quantity::CurrentRatio, 1, 1),
    ("% rated current", Quantity::CurrentRatio, 1, 100),
    ("A", Quantity::Current, 1, 1),
    ("mA", Quantity::Current, 1, 1_000),
    ("V", Quantity::Voltage, 1, 1),
    ("mV", Quantity::Voltage, 1, 1_000),
    ("W", Quantity::Power, 1, 1),
    ("degC", Quantity::Temperature, 1, 1),
    ("Hz", Quantity::Frequency, 1, 1),
    ("kHz", Quantity::Frequency, 1_000, 1),
    ("%", Quantity::Ratio, 1, 100),
    ("ohm", Quantity::Resistance, 1, 1),
    ("mH", Quantity::Inductance, 1, 1_000),
    ("H", Quantity::Inductance, 1, 1),
    ("kg m2", Quantity::Inertia, 1, 1),
    ("kg cm2", Quantity::Inertia, 1, 10_000),
    ("mm", Quantity::Length, 1, 1_000),
    ("m", Quantity::Length, 1, 1),
];

/// What a symbol measures, and how many base units one of it is.
fn of_symbol(text: &str) -> Option<(Quantity, u32, u32)> {
    // The length first: comparing texts is a call of its own where nobody optimized.
    let found = SYMBOLS.iter().find(|(symbol, ..)| symbol.len() == text.len() && *symbol == text);
    found.map(|(_, quantity, num, den)| (*quantity, *num, *den))
}

impl Quantity {
    /// Whether a value of one quantity can be one of the other: the same, or the user's unit of it.
    pub fn can_be(self, other: Self) -> bool {
        self == other || self.of_user() == Some(other) || other.of_user() == Some(self)
    }

    /// The quantity in user units that a drive can express in this one.
    fn of_user(self) -> Option<Self> {
        match self {
            Self::Counts | Self::Angle | Self::Length => Some(Self::UserPosition),
            Self::Velocity => Some(Self::UserVelocity),
            Self::Acceleration => Some(Self::UserAcceleration),
            _ => None,
        }
    }

    /// Symbol of its base unit; `1` for a bare share.
    pub fn base(self) -> &'static str {
        let base = SYMBOLS.iter().find(|(_, quantity, num, den)| *quantity == self && *num == *den);
        base.map_or("1", |b| b.0)
    }
}

/// The unit of one count: `num / den` base units of `quantity`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Unit {
    /// As the profile writes it: `0.1 rpm`.
    pub text: String,
    /// What is measured.
    pub quantity: Quantity,
    /// Numerator, never 0.
    pub num: u32,
    /// Denominator, never 0.
    pub den: u32,
}

/// Why a text is not a unit.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum UnitError {
    /// The factor is not a positive decimal, fraction or whole number in bounds.
    Factor(String),
    /// No such symbol; with those that exist.
    Symbol(String),
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Factor(text) => write!(
                f,
                "`{text}` is no factor: write a number above 0 such as `10`, `0.1` or `1/360`, both parts at most {}",
                limits::FACTOR
            ),
            Self::Symbol(text) => write!(f, "`{text}` is no unit symbol that drivewright knows"),
        }
    }
}

impl std::error::Error for UnitError {}

/// Why a text is no number of counts.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum CountsError {
    /// It does not begin with a decimal number and a blank.
    Number,
    /// No such symbol.
    Symbol(String),
    /// It measures something else.
    Quantity(Quantity),
    /// It lies between this number of counts and the next one.
    Between(i128),
}

impl fmt::Display for CountsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number => f.write_str("no decimal number and a unit, such as `150.0 rpm`"),
            Self::Symbol(text) => write!(f, "of the unit `{text}`, which drivewright does not know"),
            Self::Quantity(quantity) => write!(f, "of the quantity {}", quantity.name()),
            Self::Between(counts) => write!(f, "between {counts} and {} counts", counts + 1),
        }
    }
}

impl std::error::Error for CountsError {}

impl Unit {
    /// How many counts of this unit a quantity such as `-150.0 rpm` is, if that is a whole number.
    pub fn counts(&self, text: &str) -> Result<i128, CountsError> {
        let (number, symbol) = text.split_once(' ').ok_or(CountsError::Number)?;
        let (num, den) = parse_decimal(number).ok_or(CountsError::Number)?;
        let (quantity, n, d) = of_symbol(symbol).ok_or_else(|| CountsError::Symbol(symbol.to_owned()))?;
        if quantity != self.quantity {
            return Err(CountsError::Quantity(quantity));
        }
        // No product overflows: a decimal has at most 18 digits, a factor at most 9 before and behind the stroke.
        let above = num * i128::from(n) * i128::from(self.den);
        let below = den * i128::from(d) * i128::from(self.num);
        if above % below == 0 {
            Ok(above / below)
        } else {
            Err(CountsError::Between(above.div_euclid(below)))
        }
    }

    /// Reads `[factor] symbol`.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        let (factor, symbol) = match text.split_once(' ') {
            Some((first, rest))
                if first.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.') =>
            {
                (first, rest)
            }
            _ => ("1", text),
        };
        let (num, den) = parse_factor(factor).ok_or_else(|| UnitError::Factor(factor.to_owned()))?;
        let symbol = symbol.trim();
        let (quantity, n, d) = of_symbol(symbol).ok_or_else(|| UnitError::Symbol(symbol.to_owned()))?;
        let (num, den) = reduce(num * u64::from(n), den * u64::from(d));
        let bounded = |n: u64| u32::try_from(n).ok().filter(|n| *n <= limits::FACTOR);
        match (bounded(num), bounded(den)) {
            (Some(num), Some(den)) => Ok(Self { text: text.to_owned(), quantity, num, den }),
            _ => Err(UnitError::Factor(factor.to_owned())),
        }
    }

    /// Every symbol, for messages and the schema.
    pub fn symbols() -> impl Iterator<Item = &'static str> {
        SYMBOLS.iter().map(|s| s.0)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

fn parse_factor(text: &str) -> Option<(u64, u64)> {
    let whole = |t: &str| -> Option<u64> {
        let digits = !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
        t.parse::<u64>().ok().filter(|n| digits && *n <= u64::from(limits::FACTOR))
    };
    let (num, den) = if let Some((n, d)) = text.split_once('/') {
        (whole(n)?, whole(d)?)
    } else if let Some((int, frac)) = text.split_once('.') {
        let den = 10u64.checked_pow(u32::try_from(frac.len()).ok()?)?;
        let num = whole(int)?.checked_mul(den)?.checked_add(whole(frac)?)?;
        (num, den)
    } else {
        (whole(text)?, 1)
    };
    let (num, den) = (num != 0 && den != 0).then(|| reduce(num, den))?;
    (num <= limits::FACTOR.into() && den <= limits::FACTOR.into()).then_some((num, den))
}

/// A decimal number with its sign as a fraction.
fn parse_decimal(text: &str) -> Option<(i128, i128)> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let all = format!("{whole}{fraction}");
    let sound = !whole.is_empty() && !digits.ends_with('.') && all.len() <= 18;
    let number: i128 = all.parse().ok().filter(|_| sound && all.bytes().all(|b| b.is_ascii_digit()))?;
    let den = 10i128.pow(u32::try_from(fraction.len()).ok()?);
    Some((if digits.len() < text.len() { -number } else { number }, den))
}

fn reduce(num: u64, den: u64) -> (u64, u64) {
    let (mut a, mut b) = (num, den);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    (num / a.max(1), den / a.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_exact() {
        let unit = Unit::parse("0.1 rpm").unwrap();
        assert_eq!((unit.quantity, unit.num, unit.den), (Quantity::Velocity, 1, 10));
        let unit = Unit::parse("0.1 % rated torque").unwrap();
        assert_eq!((unit.quantity, unit.num, unit.den), (Quantity::TorqueRatio, 1, 1_000));
        let unit = Unit::parse("1/65536 rev").unwrap();
        assert_eq!((unit.num, unit.den), (1, 65_536));
        assert_eq!(Unit::parse("user position").unwrap().quantity, Quantity::UserPosition);
    }

    #[test]
    fn quantities_are_whole_counts_or_refused() {
        let counts = |unit, text| Unit::parse(unit).unwrap().counts(text);
        assert_eq!(counts("0.1 rpm", "150.0 rpm"), Ok(1_500));
        assert_eq!(counts("0.1 rpm", "-2.5 rev/s"), Ok(-1_500));
        assert_eq!(counts("0.1 % rated torque", "100 % rated torque"), Ok(1_000));
        assert_eq!(counts("62500 ns", "0.25 ms"), Ok(4));
        assert_eq!(counts("1/65536 rev", "0 deg"), Ok(0));
        assert_eq!(counts("0.1 rpm", "150.05 rpm"), Err(CountsError::Between(1_500)));
        assert_eq!(counts("0.1 rpm", "-0.01 rpm"), Err(CountsError::Between(-1)));
        assert_eq!(counts("0.1 rpm", "1 ms"), Err(CountsError::Quantity(Quantity::Time)));
        assert_eq!(counts("0.1 rpm", "1 furlong"), Err(CountsError::Symbol("furlong".into())));
        for bad in
            ["rpm", "1rpm", "1. rpm", ".5 rpm", "+1 rpm", "1e3 rpm", "-- rpm", "1234567890123456789 rpm", ""]
        {
            assert_eq!(counts("0.1 rpm", bad), Err(CountsError::Number), "{bad}");
        }
        // The widest of everything.
        assert!(counts("1/1000000000 rev", "999999999999999999 deg").is_ok());
        assert!(counts("277777 h", "0.00000000000000001 ns").is_err());
    }

    #[test]
    fn base_units() {
        assert_eq!(Unit::parse("60 deg").unwrap().quantity.base(), "rev");
        assert_eq!(Unit::parse("rev/s").unwrap().quantity.base(), "rpm");
        assert_eq!(Unit::parse("mH").unwrap().quantity.base(), "H");
        assert_eq!(Unit::parse("%").unwrap().quantity.base(), "1");
    }

    #[test]
    fn nothing_divides_by_zero() {
        for bad in [
            "0 rpm",
            "1/0 rpm",
            "0.0 rpm",
            "-1 rpm",
            "1e9 rpm",
            "99999999999999999999 rpm",
            ". rpm",
            "furlong",
        ] {
            assert!(Unit::parse(bad).is_err(), "{bad}");
        }
    }
}
