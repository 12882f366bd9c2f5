//! What numbers an entry takes, as a sentence and as literals: words in hexadecimal, measured values with their unit.

use super::number::{grouped, hex, scaled};
use crate::emit::escape::rust_doc;
use crate::model::{Entry, EnumDef, Fact, Model, Type, Unit, Value};

/// `In 0.1 rpm; 0 to 60000 (0 to 6000 rpm); default 500 (50 rpm).`
pub(super) fn sentence(entry: &Entry, model: &Model) -> Option<String> {
    let unit = entry.unit.as_ref().map(|u| format!("In {}", rust_doc(&u.value.text)));
    let names = entry.values.as_ref().map(|v| &model.enums[v.value]);
    let parts = if let Some(n) = always(entry) {
        [unit, Some(format!("always {}", named(entry, n, names))), None, None]
    } else {
        // Where a list has the names, the default need not say them again.
        let unlisted = names.filter(|_| entry.allow.is_none());
        [unit, range(entry), allow(entry, names), default(entry, unlisted)]
    };
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let text = capital(&parts.join("; "));
    (!text.is_empty()).then(|| format!("{text}."))
}

/// The only value that an entry can have.
fn always(entry: &Entry) -> Option<i128> {
    let (min, max) = (entry.min.as_ref()?.value, entry.max.as_ref()?.value);
    let same = entry.default.as_ref().is_none_or(|d| d.value == Value::Int(min));
    (min == max && same && entry.allow.is_none()).then_some(min)
}

fn allow(entry: &Entry, names: Option<&EnumDef>) -> Option<String> {
    let list: Vec<String> = entry.allow.as_ref()?.value.iter().map(|n| named(entry, *n, names)).collect();
    Some(format!("only {}", list.join(", ")))
}

fn range(entry: &Entry) -> Option<String> {
    let of = |f: &Fact<i128>| f.value;
    let (min, max) = (entry.min.as_ref().map(of), entry.max.as_ref().map(of));
    let span = |number: &dyn Fn(i128) -> String| match (min, max) {
        (Some(min), Some(max)) => Some(format!("{} to {}", number(min), number(max))),
        (Some(min), None) => Some(format!("at least {}", number(min))),
        (None, Some(max)) => Some(format!("at most {}", number(max))),
        (None, None) => None,
    };
    let counts = span(&|n| shown(entry, n))?;
    let measured = scale(entry).and_then(|s| Some(format!(" ({} {})", span(&|n| s.of(n))?, s.symbol)));
    Some(counts + &measured.unwrap_or_default())
}

fn default(entry: &Entry, names: Option<&EnumDef>) -> Option<String> {
    Some(match &entry.default.as_ref()?.value {
        Value::Int(n) => format!("default {}", named(entry, *n, names)),
        Value::Text(text) => format!("default \"{}\"", rust_doc(text)),
    })
}

/// A number with what it stands for behind it.
fn named(entry: &Entry, n: i128, names: Option<&EnumDef>) -> String {
    let name = names.and_then(|table| table.values.iter().find(|v| v.value == n));
    let name = name.map(|v| rust_doc(&v.printed));
    let measured = || scale(entry).filter(|_| n != 0).map(|s| format!("{} {}", s.of(n), s.symbol));
    name.or_else(measured).map_or_else(|| shown(entry, n), |means| format!("{} ({means})", shown(entry, n)))
}

/// One count in a unit that people use.
struct Scale {
    num: u64,
    den: u64,
    symbol: String,
}

impl Scale {
    fn of(&self, n: i128) -> String {
        scaled(n, self.num, self.den)
    }
}

/// The unit without its factor; `None` where one count is one of it.
fn scale(entry: &Entry) -> Option<Scale> {
    let unit = &entry.unit.as_ref()?.value;
    let (_, symbol) = unit.text.split_once(' ')?;
    let one = Unit::parse(symbol.trim()).ok()?;
    let num = u64::from(unit.num) * u64::from(one.den);
    let den = u64::from(unit.den) * u64::from(one.num);
    (num != den).then(|| Scale { num, den, symbol: rust_doc(symbol.trim()) })
}

/// Whether the numbers of an entry are words, which people read in hexadecimal, and how many digits they have: bits, and
/// what the communication area holds, such as mappings, indexes and identities.
fn digits(entry: &Entry) -> Option<usize> {
    let Type::Int { signed: false, bits } = entry.ty.value else { return None };
    let communication = (0x1000..0x2000).contains(&entry.address.index) && matches!(bits, 16 | 32);
    let plain = entry.unit.is_none() && entry.values.is_none();
    let word = entry.bits.is_some() || plain && (communication || entry.address.index == 0x6502);
    word.then(|| usize::from(bits).div_ceil(4))
}

/// A number of documentation. One below ten is what it is.
fn shown(entry: &Entry, n: i128) -> String {
    match digits(entry) {
        Some(digits) if n > 9 => format!("{n:0digits$X}h"),
        _ => n.to_string(),
    }
}

/// A literal.
pub(super) fn literal(entry: &Entry, n: i128) -> String {
    match digits(entry) {
        Some(digits) if n > 9 => hex(n, digits),
        _ => grouped(n),
    }
}

/// With the first letter as a capital one.
pub(super) fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |c| c.to_uppercase().to_string() + chars.as_str())
}
