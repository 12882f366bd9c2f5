//! Numbers as an EDS states them: limits and defaults of integers, and `$NODEID` formulas.
//!
//! Values that are no whole number have no form here; the caller counts them as lost.

use crate::model::{Entry, Type, Value};

use super::loss::Loss;

/// A default.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Default {
    /// A whole number.
    Int(i128),
    /// The node-ID plus a number.
    NodeId(i128),
}

/// What the limits of an entry become.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(super) struct Range {
    pub(super) low: Option<i128>,
    pub(super) high: Option<i128>,
}

impl Range {
    fn holds(self, n: i128) -> bool {
        self.low.is_none_or(|low| low <= n) && self.high.is_none_or(|high| n <= high)
    }
}

/// The printed limits, as far as they are values of the type and leave room for one. Values that `allow` lists one by
/// one are no range and change nothing here.
pub(super) fn limits(entry: &Entry, lose: &mut impl FnMut(Loss)) -> Range {
    let stated = [&entry.min, &entry.max].map(|f| f.as_ref().map(|f| f.value));
    let Some((least, most)) = entry.ty.value.range() else {
        if stated != [None, None] {
            lose(Loss::LimitOfOtherType);
        }
        return Range::default();
    };
    let [low, high] = stated.map(|limit| limit.filter(|n| (least..=most).contains(n)));
    if [low, high] != stated {
        lose(Loss::LimitOutsideType);
    }
    if low.zip(high).is_some_and(|(low, high)| low > high) {
        lose(Loss::LimitsCrossed);
        return Range::default();
    }
    Range { low, high }
}

/// The default of `entry`, or `otherwise` where nobody states one.
pub(super) fn default(
    entry: &Entry,
    otherwise: Option<i128>,
    range: Range,
    lose: &mut impl FnMut(Loss),
) -> Option<Default> {
    let (least, most) = entry.ty.value.range().unwrap_or((0, -1));
    let number = match entry.default.as_ref().map(|f| &f.value) {
        None => otherwise?,
        Some(Value::Int(n)) if entry.ty.value.range().is_some() => *n,
        Some(Value::Text(_)) if entry.ty.value.is_integer() => {
            let formula = entry.default_beside_node_id();
            if formula.is_none() {
                lose(Loss::DefaultOutsideType);
            }
            return formula.map(Default::NodeId);
        }
        Some(_) => {
            lose(if is_text(entry.ty.value) { Loss::TextDefault } else { Loss::OtherDefault });
            return None;
        }
    };
    if !(least..=most).contains(&number) {
        lose(Loss::DefaultOutsideType);
        return None;
    }
    if !range.holds(number) {
        lose(Loss::DefaultOutsideLimits);
        return None;
    }
    Some(Default::Int(number))
}

fn is_text(ty: Type) -> bool {
    matches!(ty, Type::VisibleString | Type::OctetString | Type::UnicodeString | Type::Domain)
}

/// How a default is printed: signed numbers in decimal, since readers take two's complement for a large number.
pub(super) fn print(default: Default, hex: bool) -> String {
    match default {
        Default::Int(n) if hex && n >= 0 => format!("0x{n:X}"),
        Default::Int(n) => n.to_string(),
        Default::NodeId(0) => "$NODEID".to_owned(),
        Default::NodeId(n) => format!("$NODEID+0x{n:X}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn node_id_comes_first() {
        let printed = |text| Value::node_id_formula(text).map(|n| print(Default::NodeId(n), false));
        for text in ["$NODEID+0x200", "0x200+$NODEID", "$NodeId + 512"] {
            assert_eq!(printed(text).as_deref(), Some("$NODEID+0x200"), "{text}");
        }
        assert_eq!(printed("$NODEID").as_deref(), Some("$NODEID"));
        for bad in ["$NODEID+0x80+1", "$NODEID-1", "$NODEID+$NODEID", "$NODEID++1", "512", "$NODEID+x", ""] {
            assert_eq!(printed(bad), None, "{bad}");
        }
    }

    #[test]
    fn negative_numbers_are_decimal() {
        assert_eq!(print(Default::Int(-5), true), "-5");
        assert_eq!(print(Default::Int(10), true), "0xA");
        assert_eq!(print(Default::Int(10), false), "10");
    }
}
