//! Values as bytes: little-endian hexadecimal digits of the full width of the type.

use std::fmt::Write;

use super::loss::Loss;
use crate::model::{Entry, Fact, Type, Value};

/// What an ESI states of the value of an entry, beside its type.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub(super) struct Values {
    pub(super) text: Option<String>,
    pub(super) min: Option<String>,
    pub(super) max: Option<String>,
    pub(super) default: Option<String>,
    /// Code of ETG.1004.
    pub(super) unit: Option<u32>,
}

impl Values {
    pub(super) fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

/// The bytes of a value; `None` if it is none of the type.
pub(super) fn bytes(ty: Type, value: i128) -> Option<String> {
    match ty {
        Type::Bool => (0..=1).contains(&value).then(|| format!("{value:02X}")),
        Type::Int { bits, .. } => {
            let (least, most) = ty.range()?;
            let all = value.to_le_bytes();
            (least..=most).contains(&value).then(|| digits(all.get(..usize::from(bits / 8)).unwrap_or(&all)))
        }
        Type::Real { bits } => real(value, bits),
        _ => None,
    }
}

/// The bytes of a whole number as a real; `None` if the real is another number.
#[allow(clippy::cast_precision_loss, reason = "numbers of more bits than the mantissa has are left out")]
fn real(value: i128, bits: u8) -> Option<String> {
    let size = value.unsigned_abs();
    match bits {
        32 => (size <= 1 << 24).then(|| digits(&(value as f32).to_le_bytes())),
        _ => (size <= 1 << 53).then(|| digits(&(value as f64).to_le_bytes())),
    }
}

/// Hexadecimal digits of bytes.
pub(super) fn digits(bytes: &[u8]) -> String {
    let mut out = String::with_capacity(bytes.len() * 2);
    for byte in bytes {
        // Writing to a String cannot fail.
        let _ = write!(out, "{byte:02X}");
    }
    out
}

/// Limits and default of an entry; the unit is another matter.
pub(super) fn of(entry: &Entry, lose: &mut impl FnMut(Loss)) -> Values {
    let ty = entry.ty.value;
    let mut values = Values::default();
    match entry.default.as_ref().map(|d| &d.value) {
        None => {}
        Some(Value::Text(text)) if ty == Type::VisibleString => values.text = Some(text.clone()),
        Some(Value::Text(_)) => lose(Loss::OtherDefault),
        Some(Value::Int(n)) => {
            values.default = bytes(ty, *n);
            if values.default.is_none() {
                lose(if ty.bits().is_some() { Loss::DefaultOutsideType } else { Loss::OtherDefault });
            }
        }
    }
    let mut limit = |fact: Option<&Fact<i128>>| {
        let n = fact?.value;
        if ty.range().is_none() {
            lose(Loss::LimitOfOtherType);
            return None;
        }
        let found = bytes(ty, n);
        if found.is_none() {
            lose(Loss::LimitOutsideType);
        }
        found
    };
    values.min = limit(entry.min.as_ref());
    values.max = limit(entry.max.as_ref());
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_little_endian_and_of_full_width() {
        assert_eq!(bytes(Type::int(false, 32), 0x0002_0192).as_deref(), Some("92010200"));
        assert_eq!(bytes(Type::int(true, 24), -2).as_deref(), Some("FEFFFF"));
        assert_eq!(bytes(Type::int(true, 40), i128::from(i64::MAX)), None);
        assert_eq!(bytes(Type::int(false, 64), i128::from(u64::MAX)).as_deref(), Some("FFFFFFFFFFFFFFFF"));
        assert_eq!(bytes(Type::Bool, 1).as_deref(), Some("01"));
        assert_eq!(bytes(Type::Bool, 2), None);
        // IEEE 754: 1.0 is 3F800000h.
        assert_eq!(bytes(Type::Real { bits: 32 }, 1).as_deref(), Some("0000803F"));
        assert_eq!(bytes(Type::Real { bits: 32 }, (1 << 24) + 1), None);
        assert_eq!(bytes(Type::TimeOfDay, 1), None);
    }
}
