//! Applies errata: each must match exactly one row and the value that is printed there.

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Sink, code};
use crate::raw::RawValue;
use crate::rows::address::At;
use crate::rows::tables::{AlarmRow, ErratumRow};
use crate::rows::{Fix, Row, Rows, Visit, VisitMut, suggest};
use crate::source::Sp;

/// Applies every erratum of `rows` to the row that it names.
pub(super) fn apply(rows: &mut Rows, sink: &mut Sink) {
    let errata = std::mem::take(&mut rows.errata);
    for pair in errata.windows(2).filter(|p| p[0].id == p[1].id) {
        super::duplicate(&pair[1], &pair[0], sink);
    }
    let found = vec![0; errata.len()];
    let mut fixing = Fixing { errata: &errata, targets: targets(&errata), found, sink };
    rows.visit_mut(&mut fixing);
    let found = fixing.found;
    let mut keys = Keys::default();
    rows.visit(&mut keys);
    let known: Vec<&str> = keys.0.iter().map(String::as_str).collect();
    for (erratum, found) in errata.iter().zip(found).filter(|(_, found)| *found != 1) {
        if !rows.left_out.contains(&normal(&erratum.at.value.0)) {
            target(erratum, found, &known, sink);
        }
    }
    rows.errata = errata;
}

/// Errata by the key of the row that they name.
fn targets(errata: &[ErratumRow]) -> BTreeMap<String, Vec<usize>> {
    let mut targets: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (place, erratum) in errata.iter().enumerate() {
        targets.entry(normal(&erratum.at.value.0)).or_default().push(place);
    }
    targets
}

/// An address as rows name themselves, whatever its case; an alarm with the number behind its display as [`numbered`]
/// writes it.
fn normal(at: &str) -> String {
    if let Some(at) = At::parse(at) {
        return at.to_string();
    }
    let alarm = || {
        let (display, number) = at.strip_prefix("alarm ")?.rsplit_once(' ')?;
        let number = u16::from_str_radix(number.strip_prefix("0x")?, 16).ok()?;
        Some(format!("alarm {display} 0x{number:02X}"))
    };
    alarm().unwrap_or_else(|| at.to_owned())
}

/// The name of an alarm with its number: manuals print one display for several alarms.
fn numbered<R: Row>(row: &R) -> Option<String> {
    let number = row.meta().raw.get("number").filter(|_| R::TABLE.name == AlarmRow::TABLE.name)?;
    let RawValue::Int(number) = &number.value else { return None };
    Some(format!("{} 0x{number:02X}", row.key()))
}

/// Names of rows, for suggestions.
#[derive(Default)]
struct Keys(Vec<String>);

impl Visit<'_> for Keys {
    fn table<R: Row>(&mut self, rows: &[R]) {
        self.0.extend(rows.iter().take(200).map(Row::key));
    }
}

fn target(erratum: &ErratumRow, found: usize, known: &[&str], sink: &mut Sink) {
    let at = &erratum.at.value.0;
    let finding = |message, why, help| {
        Diagnostic::new(code::ERRATUM_TARGET, erratum.at.span, message).why(why).help(help)
    };
    sink.report(code::ERRATUM_TARGET, || {
        if found == 0 {
            let why = "a correction that matches nothing has been overtaken, or never worked";
            return finding(format!("no row `{at}`"), why, suggest(at, known));
        }
        let help = if at.starts_with("alarm ") {
            format!("name the number as well, as in `{at} 0x25`")
        } else {
            "make the rows differ, or remove the erratum".to_owned()
        };
        finding(format!("{found} rows are `{at}`"), "a correction must say which row it corrects", help)
    });
}

struct Fixing<'a> {
    errata: &'a [ErratumRow],
    targets: BTreeMap<String, Vec<usize>>,
    /// How many rows each erratum names.
    found: Vec<usize>,
    sink: &'a mut Sink,
}

/// One erratum, and its place among all.
struct Fixer<'a> {
    erratum: &'a ErratumRow,
    place: usize,
    errata: &'a [ErratumRow],
}

impl VisitMut for Fixing<'_> {
    /// Applies the errata that name rows of a table.
    fn table<R: Row>(&mut self, rows: &mut [R]) {
        for row in rows {
            let exact = numbered(row).and_then(|key| self.targets.get(&key));
            let places: Vec<usize> =
                self.targets.get(&row.key()).into_iter().chain(exact).flatten().copied().collect();
            for place in places {
                self.found[place] += 1;
                if self.found[place] == 1 {
                    Fixer { erratum: &self.errata[place], place, errata: self.errata }.row(row, self.sink);
                }
            }
        }
    }
}

impl Fixer<'_> {
    fn row<R: Row>(&self, row: &mut R, sink: &mut Sink) {
        if !self.field_exists(R::TABLE.fields.iter().map(|f| f.key), R::TABLE.name, sink)
            || !self.expectation_holds(row, sink)
            || !self.is_first(row, sink)
        {
            return;
        }
        let field = self.erratum.field.value.0.clone();
        // Kept before the new value is looked at: a wrong one is reported once, however many errata set it.
        row.meta_mut().add_fix(field.clone(), Fix { erratum: self.place, set: self.changes() });
        if self.changes() {
            let mut raw = row.meta().raw.clone();
            match &self.erratum.set {
                Some(set) => raw.set(&field, Sp::new(set.value.clone(), set.span)),
                None => raw.unset(&field),
            }
            // What is wrong with the new value is reported at the erratum, where it stands.
            let Some(mut corrected) = R::decode(raw, sink) else { return };
            corrected.meta_mut().fixes = std::mem::take(&mut row.meta_mut().fixes);
            *row = corrected;
        }
    }

    fn field_exists(&self, fields: impl Iterator<Item = &'static str>, table: &str, sink: &mut Sink) -> bool {
        let known: Vec<&str> = fields.collect();
        let field = &self.erratum.field;
        if known.contains(&field.value.0.as_str()) {
            return true;
        }
        sink.push(
            Diagnostic::new(
                code::NAMED_FIELD,
                field.span,
                format!("`{table}` has no key `{}`", field.value.0),
            )
            .why("an erratum corrects one key of one row")
            .help(suggest(&field.value.0, &known)),
        );
        false
    }

    fn expectation_holds<R: Row>(&self, row: &R, sink: &mut Sink) -> bool {
        let (field, was) = (&self.erratum.field.value.0, &self.erratum.was);
        // The value before an earlier erratum changed it is what is printed; `is_first` reports that case.
        if row.meta().fix(field).is_some_and(|f| f.set) {
            return true;
        }
        let found = row.meta().raw.get(field);
        if found.is_some_and(|f| f.value == was.value) {
            return true;
        }
        sink.report(code::ERRATUM_WAS, || {
            let shown = found.map_or_else(|| "not stated".to_owned(), |f| f.value.brief());
            let wanted = was.value.brief();
            let text = format!("`{field}` of `{}` is {shown}, and the erratum expects {wanted}", row.key());
            Diagnostic::new(code::ERRATUM_WAS, was.span, text)
                .related(found.map_or(row.meta().span(), |f| f.span), "the row says this")
                .why("an erratum holds for the printed value that it was written against, and for no other")
                .help("look at the manual again: correct `was`, or remove the erratum")
        });
        false
    }

    fn is_first<R: Row>(&self, row: &R, sink: &mut Sink) -> bool {
        let field = &self.erratum.field.value.0;
        let earlier = row.meta().fix(field).filter(|f| f.set && self.changes());
        if let Some(earlier) = earlier {
            sink.push(
                Diagnostic::new(
                    code::ERRATUM_TWICE,
                    self.erratum.id.span,
                    format!("`{field}` of `{}` is changed a second time", row.key()),
                )
                .related(self.errata[earlier.erratum].id.span, "changed here first")
                .why("of two corrections of one value at most one can be right")
                .help("keep one of them"),
            );
            return false;
        }
        self.changes_something(sink)
    }

    /// Whether another value, or none, takes the place of the printed one.
    fn changes(&self) -> bool {
        self.erratum.set.is_some() || self.erratum.drops()
    }

    fn changes_something(&self, sink: &mut Sink) -> bool {
        if let (Some(set), true) = (&self.erratum.set, self.erratum.drops()) {
            sink.push(
                Diagnostic::new(
                    code::ERRATUM_NO_CHANGE,
                    set.span,
                    "the erratum both sets and drops the value",
                )
                .why("only one of the two can be meant")
                .help("remove `set` or `unset`"),
            );
            return false;
        }
        let same = self.erratum.set.as_ref().filter(|set| set.value == self.erratum.was.value);
        if let Some(set) = same {
            sink.push(
                Diagnostic::new(code::ERRATUM_NO_CHANGE, set.span, "`set` is the value that is printed")
                    .why("a correction that changes nothing hides what it is for")
                    .help("leave `set` out to keep the printed value and record the contradiction"),
            );
        }
        same.is_none()
    }
}
