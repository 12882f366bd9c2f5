//! Rules between values, and the worked examples of the manual.

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::model::{Example, Expr, Fact, Occasion, Rule};

/// The page.
#[derive(Serialize)]
pub(super) struct Rules {
    rules: Vec<RuleView>,
    examples: Vec<ExampleView>,
}

/// A rule for a reader.
#[derive(Serialize)]
pub(super) struct RuleView {
    anchor: String,
    id: String,
    text: String,
    items: Vec<String>,
}

/// A worked example for a reader.
#[derive(Serialize)]
pub(super) struct ExampleView {
    anchor: String,
    id: String,
    table: String,
}

pub(super) fn page(book: &Book<'_>) -> Option<Rules> {
    let model = book.model;
    (!model.rules.is_empty() || !model.examples.is_empty()).then(|| Rules {
        rules: model.rules.iter().map(|r| view(book, r)).collect(),
        examples: model.examples.chunk_by(|a, b| a.id == b.id).map(|steps| example(book, steps)).collect(),
    })
}

/// What to tell of a rule.
pub(super) fn view(book: &Book<'_>, rule: &Rule) -> RuleView {
    let expr = |what: &str, fact: &Fact<Expr>| format!("{what}: {}", expression(book, fact));
    let items = [
        rule.require.as_ref().map(|e| expr("Must hold", e)),
        rule.when.as_ref().map(|e| expr("If", e)),
        rule.on.as_ref().map(|o| book.marked(&format!("Holds {}", occasion(o.value)), &[&o.origin])),
        Some(format!("Manual: {}", book.source(&rule.text.origin)))
            .filter(|_| rule.text.origin.cite.is_some()),
    ];
    RuleView {
        anchor: book.anchored(&book.rule_anchor(rule)),
        id: book.text(&rule.id),
        text: book.marked(&book.prose(&rule.text.value), &[&rule.text.origin]),
        items: items.into_iter().flatten().collect(),
    }
}

/// An expression, with links to the objects that it names.
fn expression(book: &Book<'_>, fact: &Fact<Expr>) -> String {
    book.marked(&book.prose(&fact.value.text), &[&fact.origin])
}

fn occasion(occasion: Occasion) -> &'static str {
    match occasion {
        Occasion::Dc => "with distributed clocks",
        Occasion::FreeRun => "in free run",
        Occasion::StartHoming => "when homing is started",
        Occasion::WhileHoming => "while homing runs",
        Occasion::Enable => "when the drive is enabled",
        Occasion::EsmChange => "when a state of the EtherCAT state machine is asked for",
        Occasion::Remap => "when process data are mapped or assigned",
    }
}

fn example(book: &Book<'_>, steps: &[Example]) -> ExampleView {
    let id = steps.first().map_or("", |s| s.id.as_str());
    let rows = steps.iter().map(|s| {
        let number = s.step.map(|n| n.to_string()).unwrap_or_default();
        let write = s.write.as_ref().map(|w| {
            let rest = if w.value.last == w.value.first.sub {
                String::new()
            } else {
                format!(" to {:02X}", w.value.last)
            };
            book.marked(&(book.address(w.value.first) + &rest), &[&w.origin])
        });
        let entry = book.fact(s.entry.as_ref(), |at| book.address(*at));
        let parameter = book.fact(s.parameter.as_ref(), |p| book.prose(p));
        let bits = book.fact(s.bits.as_ref(), u8::to_string);
        let text = s.text.as_ref().map(|t| book.prose(t)).unwrap_or_default();
        [number, write.unwrap_or_default(), parameter, entry, bits, value(book, s), text, manual(book, s)]
    });
    let head = ["Step", "Write", "Parameter", "Entry", "Bits", "Value", "What it shows", "Manual"];
    ExampleView {
        anchor: book.anchored(&book.example_anchor(id)),
        id: book.text(id),
        table: Table::of(&head, rows).text(book.plain),
    }
}

fn value(book: &Book<'_>, example: &Example) -> String {
    let number = |n: &i128| if *n > 9 { format!("{n:X}h") } else { n.to_string() };
    let exact = book.fact(example.value.as_ref(), number);
    let (min, max) =
        (book.fact(example.min.as_ref(), i128::to_string), book.fact(example.max.as_ref(), i128::to_string));
    match (exact.is_empty(), min.is_empty(), max.is_empty()) {
        (false, ..) => exact,
        (_, false, false) => format!("{min} to {max}"),
        _ => min + &max,
    }
}

fn manual(book: &Book<'_>, example: &Example) -> String {
    let origins = [
        example.write.as_ref().map(|f| &f.origin),
        example.entry.as_ref().map(|f| &f.origin),
        example.value.as_ref().map(|f| &f.origin),
        example.parameter.as_ref().map(|f| &f.origin),
    ];
    origins.into_iter().flatten().find(|o| o.cite.is_some()).map(|o| book.source(o)).unwrap_or_default()
}
