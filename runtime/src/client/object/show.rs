//! A value as a person reads it: named, in its unit, raw in brackets.

use core::fmt;

use super::Content;
use crate::bit_field::BitDesc;
use crate::client::message::{list, Clean};
use crate::data_type::DataType;
use crate::model::{DefaultValue, DriveModel, ObjectDesc};
use crate::ratio::Factor;
use crate::value::write_fraction;
use crate::wire::Wire;

/// What an entry holds, as a person reads it.
///
/// ```
/// use drivewright_runtime::client::object::{Content, Shown};
/// use drivewright_runtime::prelude::*;
///
/// static UNITS: [UnitDesc<'static>; 1] = [UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10)];
/// static OBJECTS: [ObjectDesc<'static>; 1] =
///     [ObjectDesc::new(Address::new(0x6081, 0), DataType::UNSIGNED32, Access::Rw, Mapping::RxTx, "Profile velocity").unit(0)];
/// static MODEL: DriveModel<'static> =
///     DriveModel::new(Identity::new("acme-x3", "Acme", "X3")).with_objects(&OBJECTS).with_units(&UNITS);
///
/// assert_eq!(Shown::new(&MODEL, &OBJECTS[0], Content::Int(30_005)).to_string(), "3000.5 rpm [30005]");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Shown<'s, 'm> {
    model: &'s DriveModel<'m>,
    object: &'s ObjectDesc<'m>,
    content: Option<Content<'s>>,
}

impl<'s, 'm> Shown<'s, 'm> {
    /// The content of an entry of the model.
    pub const fn new(model: &'s DriveModel<'m>, object: &'s ObjectDesc<'m>, content: Content<'s>) -> Self {
        Self { model, object, content: Some(content) }
    }

    /// A raw number of an entry of the model.
    pub const fn number(model: &'s DriveModel<'m>, object: &'s ObjectDesc<'m>, number: i128) -> Self {
        Self { model, object, content: Some(Content::Int(number)) }
    }

    /// The value of an entry as the drive ships.
    pub fn default(model: &'s DriveModel<'m>, object: &'s ObjectDesc<'m>) -> Self {
        let content = match model.default_of(object) {
            DefaultValue::NotStated => None,
            DefaultValue::Int(value) => Some(Content::Int(value)),
            DefaultValue::Text(text) => Some(Content::Bytes(text.as_bytes())),
        };
        Self { model, object, content }
    }

    fn int(&self, f: &mut fmt::Formatter<'_>, value: i128) -> fmt::Result {
        if let Some(table) = self.model.enum_of(self.object) {
            return match table.name_of(value) {
                Some(name) => write!(f, "{} [{value}]", Clean(name.as_bytes())),
                None => write!(f, "{value}, which has no name"),
            };
        }
        if let (Some(table), Ok(word)) = (self.model.bits_of(self.object), u64::try_from(value)) {
            let digits = u8::try_from(self.object.data_type().bytes().saturating_mul(2)).unwrap_or(0);
            return write!(f, "{}", Bits { rows: table.bits(), word, digits });
        }
        self.measured(f, value)
    }

    fn measured(&self, f: &mut fmt::Formatter<'_>, value: i128) -> fmt::Result {
        let Some(unit) = self.model.unit_of(self.object) else { return write!(f, "{value}") };
        let (num, den) = unit.factor();
        let physical = Factor::new(num.into(), den.into()).and_then(|factor| factor.value_of(value).ok());
        let Some((above, below)) = physical else {
            return write!(f, "{value} x {}", Clean(unit.text().as_bytes()));
        };
        write_fraction(f, above, below)?;
        match unit.quantity().symbol() {
            "" => {}
            symbol => write!(f, " {symbol}")?,
        }
        if num == den {
            Ok(())
        } else {
            write!(f, " [{value}]")
        }
    }
}

impl fmt::Display for Shown<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.content {
            None => f.write_str("not stated"),
            Some(Content::Int(value)) => self.int(f, value),
            Some(Content::Bytes(bytes)) => show_bytes(f, self.object.data_type(), bytes),
        }
    }
}

fn show_bytes(f: &mut fmt::Formatter<'_>, data_type: DataType, bytes: &[u8]) -> fmt::Result {
    match data_type {
        DataType::VISIBLE_STRING => return write!(f, "\"{}\"", Clean(bytes)),
        DataType::REAL32 => {
            if let Ok(value) = f32::decode(bytes) {
                return show_real(f, value.into());
            }
        }
        DataType::REAL64 => {
            if let Ok(value) = f64::decode(bytes) {
                return show_real(f, value);
            }
        }
        _ => {}
    }
    f.write_str("[")?;
    list(f, " ", bytes.iter().map(Hex))?;
    f.write_str("]")
}

/// Floating point, to a millionth. The formatting of the core library takes kilobytes and can panic as far as a linker knows.
#[allow(clippy::cast_possible_truncation)] // A cast stops at the limits of its type.
fn show_real(f: &mut fmt::Formatter<'_>, value: f64) -> fmt::Result {
    const MILLION: u32 = 1_000_000;
    let scaled = value * f64::from(MILLION);
    match scaled as i64 {
        i64::MIN | i64::MAX => write!(f, "[{:016X}h]", value.to_bits()),
        0 if value != 0.0 => write!(f, "[{:016X}h]", value.to_bits()),
        millionths => write_fraction(f, millionths, MILLION),
    }
}

/// A byte as two hexadecimal digits.
struct Hex<'b>(&'b u8);

impl fmt::Display for Hex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:02X}", self.0)
    }
}

/// The names of the bits of a word that are set, and the word. Bits whose meaning depends on a mode are left out: the mode
/// is not known here.
pub(crate) struct Bits<'s, 'm> {
    /// The names.
    pub(crate) rows: &'s [BitDesc<'m>],
    /// The word.
    pub(crate) word: u64,
    /// Hexadecimal digits of the word.
    pub(crate) digits: u8,
}

impl fmt::Display for Bits<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rows, word, digits } = *self;
        let digits = usize::from(digits);
        let mut gap = "";
        for row in rows.iter().filter(|row| row.mode().is_none() && row.of(word) != 0) {
            write!(f, "{gap}{}", Clean(row.name().as_bytes()))?;
            gap = ", ";
            if row.width() > 1 {
                write!(f, " {}", row.of(word))?;
            }
        }
        write!(f, "{}[{word:0digits$X}h]", if gap.is_empty() { "" } else { " " })
    }
}
