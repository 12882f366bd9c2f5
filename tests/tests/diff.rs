//! What must hold of differences between any two models.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use drivewright_codegen::diff::{
    Change, Listing, Report, What, compare, json::json, markdown::markdown, text::text,
};
use drivewright_codegen::model::Model;
use drivewright_codegen::{backend, compile, load};
use drivewright_tests::cases::golden_cases;
use drivewright_tests::drives;
use drivewright_tests::random::Random;
use serde_json::Value;

fn listing(model: &Model) -> Listing {
    Listing::of(model).expect("rows")
}

fn real() -> Vec<Model> {
    drives::all().iter().map(|folder| compile(load::folder(folder).sources).model.expect("a model")).collect()
}

fn all() -> Vec<Model> {
    golden_cases().iter().map(drivewright_tests::cases::Case::model).chain(real()).collect()
}

#[test]
fn a_model_does_not_differ_from_itself() {
    for model in all() {
        let one = listing(&model);
        let file = Listing::parse(&backend::json::value(&model).to_string()).expect("its own file");
        assert_eq!(compare(&one, &file).changes, [], "{}", model.drive.id);
        assert!(one.rows.len() > 1 || model.objects.is_empty(), "{}", model.drive.id);
    }
}

/// A change without its effect: row, field, and the values in order.
fn seen(change: &Change, mirrored: bool) -> String {
    match &change.what {
        What::Added(row) => format!("{} {:?}", if mirrored { "-" } else { "+" }, row.facts),
        What::Removed(row) => format!("{} {:?}", if mirrored { "+" } else { "-" }, row.facts),
        What::Changed(field, old, new) if mirrored => format!("~ {} {field} {new:?} {old:?}", change.key),
        What::Changed(field, old, new) => format!("~ {} {field} {old:?} {new:?}", change.key),
    }
}

#[test]
fn the_way_back_is_the_mirror() {
    let models = all();
    for pair in models.windows(2) {
        let (a, b) = (listing(&pair[0]), listing(&pair[1]));
        let there: BTreeSet<String> = compare(&a, &b).changes.iter().map(|c| seen(c, false)).collect();
        let back: BTreeSet<String> = compare(&b, &a).changes.iter().map(|c| seen(c, true)).collect();
        assert_eq!(there, back, "{} and {}", pair[0].drive.id, pair[1].drive.id);
    }
}

/// Keys of `model.json` that follow from others, so that a model in which they alone differ cannot be.
const DERIVED: &[(&str, &[&str])] = &[
    ("", &["format", "about", "identity"]),
    ("objects", &["index", "sub", "width"]),
    ("pdos", &["index", "sub", "bit"]),
    ("alarms", &["display"]),
    ("aborts", &["code"]),
];

/// Every value of the document, as a JSON pointer.
fn leaves(value: &Value, at: &str, out: &mut Vec<String>) {
    let table = at.split('/').nth(1).unwrap_or_default();
    let derived = |key: &str| DERIVED.iter().any(|(of, keys)| *of == table && keys.contains(&key));
    // The length of a PDO follows from its entries; the index of an object is in the addresses of its entries.
    let total = |key: &str| {
        at.matches('/').count() == 2 && [("pdos", "bits"), ("objects", "at")].contains(&(table, key))
    };
    match value {
        Value::Object(fields) => {
            let own = fields.iter().filter(|(key, _)| !derived(key) && !total(key));
            own.for_each(|(key, value)| {
                leaves(value, &format!("{at}/{}", key.replace('~', "~0").replace('/', "~1")), out);
            });
        }
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(n, item)| leaves(item, &format!("{at}/{n}"), out));
        }
        _ => out.push(at.to_owned()),
    }
}

fn other(value: &Value) -> Value {
    match value {
        Value::Number(n) => (n.as_i64().unwrap_or_default() ^ 1).into(),
        Value::Bool(yes) => (!yes).into(),
        Value::String(text) => format!("{text}~").into(),
        _ => "other".into(),
    }
}

/// What is found when one value of a document is another.
fn mutated(document: &Value, pointer: &str, one: &Listing) -> Option<Report> {
    let mut changed = document.clone();
    let place = changed.pointer_mut(pointer).expect("a leaf");
    *place = other(place);
    // Two rows of one name, or a value that the format cannot have, are refused: that is noticed, too.
    Listing::parse(&changed.to_string()).ok().map(|two| compare(one, &two))
}

#[test]
fn every_single_change_is_reported_and_every_field_has_a_rule() {
    let (mut made, mut refused, mut rules) = (0, 0, BTreeSet::new());
    for model in all() {
        let (document, one) = (backend::json::value(&model), listing(&model));
        let mut places = Vec::new();
        leaves(&document, "", &mut places);
        let mut random = Random::new(2026);
        for _ in 0..40.min(places.len()) {
            let pointer = &places[random.below(places.len())];
            made += 1;
            let Some(report) = mutated(&document, pointer, &one) else {
                refused += 1;
                continue;
            };
            assert!(!report.changes.is_empty(), "{}: {pointer} is not seen", model.drive.id);
            let unruled = report.changes.iter().find(|c| c.rule == "no_rule");
            assert_eq!(unruled, None, "{}: {pointer}", model.drive.id);
            rules.extend(report.changes.iter().map(|c| c.rule));
            for shown in [
                text(&report, drivewright_codegen::diag::render::Style::default()),
                json(std::slice::from_ref(&report)),
            ] {
                assert!(shown.contains(report.changes[0].rule) || report.changes[0].is_source(), "{shown}");
            }
        }
    }
    println!("{made} changes, {refused} refused, {} rules", rules.len());
    assert!(made > 1000 && refused * 10 < made && rules.len() > 15, "{made} {refused} {rules:?}");
}

/// A drive with all its rows against none, ten times: what a comment takes is never exceeded, and what is left out is said.
#[test]
fn a_comment_is_never_too_long() {
    let model = real().remove(0);
    let report = compare(&Listing::default(), &listing(&model));
    for (count, most) in [(1, 65_000), (10, 65_000), (1, 3_000), (30, 5_000)] {
        let page = markdown(&vec![report.clone(); count], "ask for all", most);
        assert!(page.len() <= most, "{count} of {most}: {}", page.len());
        assert!(page.contains("ask for all"), "{count} of {most}: {page}");
        assert_eq!(page.matches("<details>").count(), page.matches("</details>").count());
    }
    let small = markdown(&[report], "ask for all", usize::MAX);
    assert!(
        !small.contains("ask for all") && small.len() > 65_000,
        "the test needs a report that is too long"
    );
}

/// Names of a profile are text in every output.
#[test]
fn hostile_names_stay_text() {
    let hostile = "a|b\n</details><script>`x` @all \u{202E}";
    let row = |name: &str| {
        let text = format!(
            "objects = [ {{ at = \"2000:00\", name = \"Speed\", type = \"u16\", access = \"rw\", text = {name:?}, src = \"1 L2\" }} ]\n{}",
            include_str!("../../codegen/tests/fixtures/drive.toml")
        );
        compile(vec![drivewright_codegen::source::Source { path: "drive.toml".into(), text }])
            .model
            .expect("a model")
    };
    let mut other = listing(&row("calm"));
    let one = other.clone();
    for row in &mut other.rows {
        for (_, said) in row.facts.iter_mut().filter(|(field, _)| field == "text") {
            (said.value, said.text) = (hostile.into(), hostile.to_owned());
        }
    }
    let report = compare(&one, &other);
    assert_eq!(report.changes.len(), 1);
    let page = markdown(std::slice::from_ref(&report), "", 65_000);
    assert!(
        !page.contains("<script>") && !page.contains("</details>") && !page.contains('\u{202E}'),
        "{page}"
    );
    let table = page.lines().find(|l| l.starts_with("| object")).expect("a row");
    assert_eq!(table.replace("\\|", "").matches('|').count(), 6, "{table}");
    let plain = text(&report, drivewright_codegen::diag::render::Style { colour: true });
    assert!(!plain.contains('\u{202E}') && plain.lines().count() < 12, "{plain}");
}
