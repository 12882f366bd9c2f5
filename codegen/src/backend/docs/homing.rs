//! Homing methods: the table, and each method's cases in words and as the program that the virtual drive runs.

use serde::Serialize;

use super::book::{Book, mark};
use super::table::Table;
use crate::backend::prose::{capital, listed};
use crate::model::{
    Class, Erratum, Event, HomingCase, HomingMethod, HomingStatus, Level, Origin, Pace, Side, Signal, Step,
    When,
};

/// The page.
#[derive(Serialize)]
pub(super) struct Homing {
    overview: String,
    methods: Vec<MethodView>,
}

/// A method for a reader.
#[derive(Serialize)]
pub(super) struct MethodView {
    anchor: String,
    number: i8,
    status: String,
    texts: Vec<String>,
    facts: String,
    cases: Vec<CaseView>,
    items: Vec<String>,
    errata: Vec<String>,
}

#[derive(Serialize)]
struct CaseView {
    start: String,
    steps: Vec<String>,
    program: String,
    rest: String,
}

/// The anchor of a method.
pub(super) fn anchor(number: i8) -> String {
    let sign = if number < 0 { "n" } else { "" };
    format!("method-{sign}{}", number.unsigned_abs())
}

pub(super) fn page(book: &Book<'_>) -> Option<Homing> {
    let methods = &book.model.homing;
    let rows = methods.iter().map(|m| {
        let number = book.link(&m.number.to_string(), &format!("#{}", anchor(m.number)));
        let same = book.fact(m.same.as_ref(), i8::to_string);
        let status = book.marked(m.status.value.word(), &[&m.status.origin]);
        let [start, approach, reference, side, edge] = columns(book, m);
        [number, status, same, start, approach, reference, side, edge, book.source(&m.status.origin)]
    });
    let head = ["6098h", "Status", "Same as", "First move", "Looks for", "Home is", "Side", "Edge", "Manual"];
    (!methods.is_empty()).then(|| Homing {
        overview: Table::of(&head, rows).text(book.plain),
        methods: methods.iter().map(|m| view(book, m)).collect(),
    })
}

/// The columns of the manual's table.
fn columns(book: &Book<'_>, m: &HomingMethod) -> [String; 5] {
    let signal = |word: &str| word.replace('_', " ");
    [
        book.fact(m.start.as_ref(), |w| w.word().to_owned()),
        book.fact(m.approach.as_ref(), |w| signal(w.word())),
        book.fact(m.reference.as_ref(), |w| signal(w.word())),
        book.fact(m.side.as_ref(), |w| w.word().to_owned()),
        book.fact(m.edge.as_ref(), |w| w.word().to_owned()),
    ]
}

/// What to tell of a method.
pub(super) fn view(book: &Book<'_>, method: &HomingMethod) -> MethodView {
    let status = match (method.status.value, &method.same) {
        (HomingStatus::Reserved, _) => "Reserved for later.".to_owned(),
        (HomingStatus::NotAvailable, _) => "The drive does not have it.".to_owned(),
        (HomingStatus::Supported, Some(same)) => {
            format!(
                "The same as {}.",
                book.link(&format!("method {}", same.value), &format!("#{}", anchor(same.value)))
            )
        }
        (HomingStatus::Supported, None) => String::new(),
    };
    let names = ["first move", "looks for", "home is", "on its side", "edge"];
    let row = names.into_iter().zip(columns(book, method)).filter(|(_, value)| !value.is_empty());
    MethodView {
        anchor: book.anchored(&anchor(method.number)),
        number: method.number,
        status,
        texts: method.text.iter().map(|t| book.prose(t)).collect(),
        facts: capital(&row.map(|(name, value)| format!("{name}: {value}")).collect::<Vec<_>>().join("; ")),
        cases: method.cases.iter().map(|c| case(book, method, c)).collect(),
        items: items(book, method),
        errata: errata(book, method),
    }
}

fn case(book: &Book<'_>, method: &HomingMethod, case: &HomingCase) -> CaseView {
    let abort = case.abort.as_ref().map(|a| format!("It ends with an error when {}.", start(&a.value)));
    let mask = case.mask.as_ref().map(|m| {
        let signals: Vec<&str> = m.value.iter().map(|s| switch(*s)).collect();
        format!("Without effect meanwhile: {}.", listed(&signals))
    });
    let rest: Vec<String> = abort.into_iter().chain(mask).collect();
    CaseView {
        start: book.marked(&told_apart(method, case), &[&case.when.origin]),
        steps: case.moves.value.0.iter().map(|s| step(*s)).collect(),
        program: case.moves.value.to_string(),
        rest: rest.join(" "),
    }
}

/// When a case holds. Cases with the same start are told apart by what happens first.
fn told_apart(method: &HomingMethod, case: &HomingCase) -> String {
    let at = if case.when.value.0.is_empty() {
        "From any start".to_owned()
    } else {
        format!("When {} at the start", start(&case.when.value))
    };
    let alike = method.cases.iter().filter(|c| c.when.value == case.when.value).count() > 1;
    match case.moves.value.moves().next() {
        Some((_, _, until)) if alike => format!("{at}, and the first event is: {}", event(until)),
        _ => at,
    }
}

/// `the home switch is off and the axis stands still`
fn start(when: &When) -> String {
    let levels: Vec<String> = when.0.iter().map(|l| level(*l)).collect();
    listed(&levels.iter().map(String::as_str).collect::<Vec<_>>())
}

fn level(level: Level) -> String {
    match level {
        Level::Switch(signal, on) => format!("{} is {}", switch(signal), if on { "on" } else { "off" }),
        Level::Standstill => "the axis stands still".to_owned(),
        Level::AtHome => "the axis stands at home".to_owned(),
    }
}

fn switch(signal: Signal) -> &'static str {
    match signal {
        Signal::NegativeLimit => "the negative limit switch",
        Signal::PositiveLimit => "the positive limit switch",
        Signal::Home => "the home switch",
    }
}

/// A step in words.
fn step(step: Step) -> String {
    match step {
        Step::Move { direction, pace, until } => {
            let to = if direction == Side::Negative { "negative" } else { "positive" };
            let pace = if pace == Pace::Fast { "fast (6099:01)" } else { "slowly (6099:02)" };
            format!("Move {pace} in the {to} direction until {}.", event(until))
        }
        Step::Stop => "Brake and wait for standstill.".to_owned(),
        Step::Latch => "Take that place as home.".to_owned(),
        Step::Return => "Go back to the place that was taken.".to_owned(),
        Step::Done => "Nothing moves: the axis is at home.".to_owned(),
        Step::NotStated => "What follows is not stated.".to_owned(),
    }
}

fn event(event: Event) -> String {
    match event {
        Event::Switch(signal, on) => format!("{} goes {}", switch(signal), if on { "on" } else { "off" }),
        Event::Index => "the index pulse".to_owned(),
        Event::Torque(true) => "the torque is at its limit".to_owned(),
        Event::Torque(false) => "the torque is below its limit".to_owned(),
        Event::Stall => "a hard stop".to_owned(),
    }
}

/// Notes, and what the manual does not say itself, each once.
fn items(book: &Book<'_>, method: &HomingMethod) -> Vec<String> {
    let mut items: Vec<String> = Vec::new();
    items.extend(method.note.iter().map(|n| format!("Note: {}", book.prose(n))));
    items.extend(method.deviation.iter().map(|d| format!("Deviates from the standard: {}", book.prose(d))));
    for (what, origin) in facts(method) {
        let (Class::Inferred(rule) | Class::Assumed(rule)) = &origin.class else { continue };
        let text = book.prose(rule.trim_end_matches('.'));
        let item = format!("{}, {}{}: {text}.", capital(what), origin.class.word(), mark(&origin.class));
        if !items.contains(&item) {
            items.push(item);
        }
    }
    let cites = facts(method).into_iter().map(|(_, o)| book.cite(o.cite.as_ref())).filter(|c| !c.is_empty());
    let mut printed: Vec<String> = cites.collect();
    printed.dedup();
    if !printed.is_empty() {
        items.push(format!("Manual: {}.", printed.join("; ")));
    }
    items
}

fn facts(method: &HomingMethod) -> Vec<(&'static str, &Origin)> {
    let columns = [
        ("status", Some(&method.status.origin)),
        ("same as", method.same.as_ref().map(|f| &f.origin)),
        ("first move", method.start.as_ref().map(|f| &f.origin)),
        ("looks for", method.approach.as_ref().map(|f| &f.origin)),
        ("home is", method.reference.as_ref().map(|f| &f.origin)),
        ("side", method.side.as_ref().map(|f| &f.origin)),
        ("edge", method.edge.as_ref().map(|f| &f.origin)),
    ];
    let cases = method.cases.iter().flat_map(|c| {
        [
            ("start", Some(&c.when.origin)),
            ("program", Some(&c.moves.origin)),
            ("end with an error", c.abort.as_ref().map(|f| &f.origin)),
            ("signals without effect", c.mask.as_ref().map(|f| &f.origin)),
        ]
    });
    columns.into_iter().chain(cases).filter_map(|(what, origin)| Some((what, origin?))).collect()
}

fn errata(book: &Book<'_>, method: &HomingMethod) -> Vec<String> {
    let used: Vec<_> = facts(method).iter().filter_map(|(_, o)| o.erratum).collect();
    let row = format!("homing {}", method.number);
    let case = format!("{row}.");
    let concerns = |(id, e): &(crate::model::ErratumId, &Erratum)| {
        used.contains(id) || e.at == row || e.at.starts_with(&case)
    };
    book.model.errata.iter().filter(concerns).map(|(_, e)| super::objects::erratum(book, e)).collect()
}
