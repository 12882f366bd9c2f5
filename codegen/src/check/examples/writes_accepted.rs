//! E1302: an example writes what the drive would refuse.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Entry, Example, Model};
use crate::source::Span;

const CODE: Code = Code::error("E1302", "an example writes what the drive would refuse");
const WHY: &str =
    "the manual shows the example because it works: the example or the row of the object is read wrongly";
const HELP: &str = "compare the example with the dictionary; if the manual prints both so, add an erratum for the one that is wrong";

/// Compares each write of an example with access, type, range and allowed values of the entries.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("writes_accepted.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for example in &model.examples {
        let refused = written(model, example).find_map(|entry| Some((entry, refusal(entry, example)?)));
        let (Some(write), Some((entry, (fact, why)))) = (&example.write, refused) else { continue };
        let text = format!("`example {}` writes to {}, {why}", example.label(), entry.address);
        sink.push(
            super::finding(CODE, write.span(), &format!("example {}", example.label()), text, WHY, HELP)
                .related(fact, "the object"),
        );
    }
}

/// The entries that an example writes.
fn written<'m>(model: &'m Model, example: &Example) -> impl Iterator<Item = &'m Entry> {
    let ranges = example.write.iter().filter(|write| !super::settled(write)).map(|write| write.value);
    let addresses: Vec<Address> = ranges
        .flat_map(|range| (range.first.sub..=range.last).map(move |sub| Address::new(range.first.index, sub)))
        .collect();
    addresses.into_iter().filter_map(|address| Some(model.entry(address)?.1))
}

/// The fact of an entry that refuses the write, and why.
fn refusal(entry: &Entry, example: &Example) -> Option<(Span, String)> {
    let values = [&example.value, &example.min, &example.max];
    let values = values.into_iter().flatten().filter(|v| !super::settled(v));
    read_only(entry).or_else(|| values.into_iter().find_map(|value| refused(entry, value.value)))
}

/// The access of an entry, if it refuses every write.
pub(in crate::check) fn read_only(entry: &Entry) -> Option<(Span, String)> {
    let access = entry.access.value;
    (!access.writes() && !super::settled(&entry.access))
        .then(|| (entry.access.span(), format!("whose access is {}", access.word())))
}

/// The fact of an entry that refuses a value, and why.
pub(in crate::check) fn refused(entry: &Entry, value: i128) -> Option<(Span, String)> {
    if super::fits(entry.ty.value, value) == Some(false) {
        return Some((entry.ty.span(), format!("whose type {} has no {value}", entry.ty.value)));
    }
    let min = super::unsettled(entry.min.as_ref()).filter(|min| value < min.value);
    let max = super::unsettled(entry.max.as_ref()).filter(|max| value > max.value);
    if let Some(limit) = min.or(max) {
        return Some((limit.span(), format!("whose limit {} excludes {value}", limit.value)));
    }
    let allow = super::unsettled(entry.allow.as_ref()).filter(|allow| !allow.value.contains(&value))?;
    Some((allow.span(), format!("which does not allow {value}")))
}
