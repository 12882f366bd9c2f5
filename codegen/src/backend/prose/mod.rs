//! What numbers an entry takes, in the words of a person: words in hexadecimal, measured values with their unit. Backends
//! that write for readers share it; each gives the escaping function of its language for texts of the profile.

mod number;

use number::scaled;

use crate::model::{Effect, Entry, EnumDef, Erratum, ErratumId, Fact, Mapping, Model, Type, Unit, Value};

/// Makes text of a profile harmless in an output.
pub(super) type Escape = fn(&str) -> String;

/// The only value that an entry can have.
pub(super) fn always(entry: &Entry) -> Option<i128> {
    let (min, max) = (entry.min.as_ref()?.value, entry.max.as_ref()?.value);
    let same = entry.default.as_ref().is_none_or(|d| d.value == Value::Int(min));
    (min == max && same && entry.allow.is_none()).then_some(min)
}

/// `only 0 (off), 1 (on)`
pub(super) fn allow(entry: &Entry, names: Option<&EnumDef>, escape: Escape) -> Option<String> {
    let list: Vec<String> =
        entry.allow.as_ref()?.value.iter().map(|n| named(entry, *n, names, escape)).collect();
    Some(format!("only {}", list.join(", ")))
}

/// `0 to 60000 (0 to 6000 rpm)`
pub(super) fn range(entry: &Entry, escape: Escape) -> Option<String> {
    let of = |f: &Fact<i128>| f.value;
    let (min, max) = (entry.min.as_ref().map(of), entry.max.as_ref().map(of));
    let span = |number: &dyn Fn(i128) -> String| match (min, max) {
        (Some(min), Some(max)) => Some(format!("{} to {}", number(min), number(max))),
        (Some(min), None) => Some(format!("at least {}", number(min))),
        (None, Some(max)) => Some(format!("at most {}", number(max))),
        (None, None) => None,
    };
    let counts = span(&|n| shown(entry, n))?;
    let measured =
        scale(entry, escape).and_then(|s| Some(format!(" ({} {})", span(&|n| s.of(n))?, s.symbol)));
    Some(counts + &measured.unwrap_or_default())
}

/// `500 (50 rpm)`
pub(super) fn default(entry: &Entry, names: Option<&EnumDef>, escape: Escape) -> Option<String> {
    Some(match &entry.default.as_ref()?.value {
        Value::Int(n) => named(entry, *n, names, escape),
        Value::Text(text) => format!("\"{}\"", escape(text)),
    })
}

/// A number with what it stands for behind it.
pub(super) fn named(entry: &Entry, n: i128, names: Option<&EnumDef>, escape: Escape) -> String {
    let name = names.and_then(|table| table.values.iter().find(|v| v.value == n));
    let name = name.map(|v| escape(&v.printed));
    let measured = || scale(entry, escape).filter(|_| n != 0).map(|s| format!("{} {}", s.of(n), s.symbol));
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
fn scale(entry: &Entry, escape: Escape) -> Option<Scale> {
    let unit = &entry.unit.as_ref()?.value;
    let (_, symbol) = unit.text.split_once(' ')?;
    let one = Unit::parse(symbol.trim()).ok()?;
    let num = u64::from(unit.num) * u64::from(one.den);
    let den = u64::from(unit.den) * u64::from(one.num);
    (num != den).then(|| Scale { num, den, symbol: escape(symbol.trim()) })
}

/// Whether the numbers of an entry are words, which people read in hexadecimal, and how many digits they have: bits, and
/// what the communication area holds, such as mappings, indexes and identities.
pub(super) fn digits(entry: &Entry) -> Option<usize> {
    let Type::Int { signed: false, bits } = entry.ty.value else { return None };
    let communication = (0x1000..0x2000).contains(&entry.address.index) && matches!(bits, 16 | 32);
    let plain = entry.unit.is_none() && entry.values.is_none();
    let word = entry.bits.is_some() || plain && (communication || entry.address.index == 0x6502);
    word.then(|| usize::from(bits).div_ceil(4))
}

/// A number. One below ten is what it is.
pub(super) fn shown(entry: &Entry, n: i128) -> String {
    match digits(entry) {
        Some(digits) if n > 9 => format!("{n:0digits$X}h"),
        _ => n.to_string(),
    }
}

/// With the first letter as a capital one.
pub(super) fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |c| c.to_uppercase().to_string() + chars.as_str())
}

/// `type, access and mapping`.
pub(super) fn listed(words: &[&str]) -> String {
    match words {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [some @ .., last] => format!("{} and {last}", some.join(", ")),
    }
}

/// Which process data may carry an entry; `None` where nobody says.
pub(super) fn mapping(mapping: Option<Mapping>) -> &'static str {
    match mapping.map(Mapping::word) {
        None => "mapping not stated",
        Some("no") => "not mapped",
        Some("rx") => "RxPDO",
        Some("tx") => "TxPDO",
        Some(_) => "RxPDO and TxPDO",
    }
}

/// When a new value is used: it takes effect...
pub(super) fn effect(effect: Effect) -> &'static str {
    match effect {
        Effect::AtOnce => "at once",
        Effect::AtStop => "at the next standstill",
        Effect::PowerCycle => "**only after a power cycle**",
    }
}

/// Errata of an entry's row, and those of other rows, such as one of a range, that its values come from.
pub(super) fn errata_of<'m>(entry: &Entry, model: &'m Model) -> impl Iterator<Item = &'m Erratum> {
    let origins = entry.origins();
    let ids: Vec<ErratumId> = origins.iter().filter_map(|o| o.erratum).collect();
    let address = entry.address;
    let concerns = move |(id, e): &(ErratumId, &Erratum)| e.address == Some(address) || ids.contains(id);
    model.errata.iter().filter(concerns).map(|(_, e)| e)
}

/// What becomes of a printed value. That it is kept or dropped is not said twice.
pub(super) fn outcome(erratum: &Erratum, escape: Escape) -> String {
    let outcome = erratum.outcome(escape);
    let said =
        matches!(outcome.as_str(), "kept" | "dropped") && erratum.why.to_lowercase().contains(&outcome);
    if said { String::new() } else { format!(", {outcome}") }
}
