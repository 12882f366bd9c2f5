//! Rows that refine a range, and values that errata drop.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::compile;
use drivewright_codegen::model::{Address, Class, Entry, Model, Value};
use drivewright_codegen::source::Source;

const DRIVE: &str = include_str!("fixtures/drive.toml");

const GAINS: &str = r#"
{ at = "3000", name = "Gains", src = "1 L1" },
{ at = "3000:00", name = "Highest sub-index", type = "u8", access = "ro", default = 4, src = "1 L2" },
{ at = "3000:01..04", name = "Gain", type = "u16", access = "rw", min = 1, max = 100, default = 10, src = "1 L3" },"#;

/// A profile of [`GAINS`], more rows of `objects`, and rows of `errata`.
fn sources(objects: &str, errata: &str) -> Vec<Source> {
    let rows = format!("objects = [{GAINS}\n{objects}\n]\nerrata = [\n{errata}\n]\n");
    vec![
        Source { path: "drive.toml".into(), text: DRIVE.into() },
        Source { path: "rows.toml".into(), text: rows },
    ]
}

fn codes(objects: &str, errata: &str) -> Vec<&'static str> {
    compile(sources(objects, errata)).diagnostics.iter().map(|d| d.code.id()).collect()
}

fn sound(sources: Vec<Source>) -> Model {
    let compiled = compile(sources);
    assert_eq!(compiled.diagnostics, []);
    compiled.sound().cloned().expect("a model")
}

fn gain(model: &Model, sub: u8) -> &Entry {
    model.entry(Address::new(0x3000, sub)).expect("the entry").1
}

/// The raw default, the highest value and who corrected it.
fn numbers(model: &Model, sub: u8) -> (Option<i128>, Option<i128>, Option<&str>) {
    let entry = gain(model, sub);
    let max = entry.max.as_ref();
    let erratum = max.and_then(|m| m.origin.erratum).map(|id| model.errata[id].id.as_str());
    (entry.default_int().map(|d| d.value), max.map(|m| m.value), erratum)
}

/// An erratum, with what is said of its value in `rest`.
fn erratum(id: &str, at: &str, field: &str, rest: &str) -> String {
    format!(
        r#"{{ id = "{id}", at = "{at}", field = "{field}", {rest}, seen = "1 L3", why = "w", sure = "low" }},"#
    )
}

const SINGLE: &str = r#"{ at = "3000:02", default = 20, max = 50, src = "1 L4" },"#;

#[test]
fn a_row_of_one_address_takes_from_its_range_what_it_does_not_state() {
    let model = sound(sources(SINGLE, ""));
    assert_eq!(numbers(&model, 1), (Some(10), Some(100), None));
    assert_eq!(numbers(&model, 2), (Some(20), Some(50), None));
    let refined = gain(&model, 2);
    let cite = |line: &str| Some(line.to_owned());
    assert_eq!(
        refined.default.as_ref().and_then(|d| d.origin.cite.as_ref()).map(ToString::to_string),
        cite("1 L4")
    );
    assert_eq!(refined.ty.origin.cite.as_ref().map(ToString::to_string), cite("1 L3"));
    assert_eq!(refined.min.as_ref().map(|m| m.value), Some(1));
    let handles: Vec<String> = (1..=4).map(|sub| gain(&model, sub).handle.to_string()).collect();
    assert_eq!(handles, ["Gain 1", "Gain 2", "Gain 3", "Gain 4"]);
}

/// The more exact row holds, wherever it stands.
#[test]
fn the_order_of_range_and_row_does_not_matter() {
    let before = sources(SINGLE, "");
    let mut after = before.clone();
    after[1].text = format!("objects = [\n{SINGLE}{GAINS}\n]\n");
    assert_eq!(sound(before), sound(after));
}

#[test]
fn a_name_of_its_own_has_no_number() {
    let refining = r#"{ at = "3000:02", name = "Filter", src = "1 L4" },
{ at = "3000:03", rename = "Loop gain", src = "1 L5" },"#;
    let model = sound(sources(refining, ""));
    let names: Vec<(&str, String)> = (2..=4)
        .map(|sub| (gain(&model, sub).name.value.as_str(), gain(&model, sub).handle.to_string()))
        .collect();
    let expected = [("Filter", "Filter"), ("Gain", "Loop gain"), ("Gain", "Gain 4")];
    assert_eq!(names, expected.map(|(printed, handle)| (printed, handle.to_owned())));
}

#[test]
fn of_two_rows_as_exact_neither_refines_the_other() {
    assert_eq!(codes(SINGLE, ""), [""; 0]);
    assert_eq!(codes(&format!("{SINGLE}\n{SINGLE}"), ""), ["E0202"]);
    let overlap = r#"{ at = "3000:04..05", name = "Other", type = "u16", access = "rw", src = "1 L4" },"#;
    assert!(codes(overlap, "").contains(&"E0202"));
    let inside = r#"{ at = "3000:02..03", default = 20, src = "1 L4" },"#;
    assert_eq!(codes(inside, ""), ["E0202"]);
    assert_eq!(
        codes(&format!("{inside}\n{SINGLE}"), ""),
        ["E0202"],
        "the row of one address is no third one"
    );
}

#[test]
fn errata_name_the_range_or_the_row_inside() {
    let range = erratum("E1", "3000:01..04", "max", "was = 100, set = 200");
    let single = erratum("E2", "3000:02", "max", "was = 50, set = 60");
    let model = sound(sources(SINGLE, &range));
    assert_eq!(numbers(&model, 1), (Some(10), Some(200), Some("E1")));
    assert_eq!(numbers(&model, 2), (Some(20), Some(50), None), "the row states its own");
    let model = sound(sources(SINGLE, &format!("{range}\n{single}")));
    assert_eq!(numbers(&model, 2), (Some(20), Some(60), Some("E2")));
    assert_eq!(numbers(&model, 3), (Some(10), Some(200), Some("E1")));
    // What the row leaves to the range is corrected there.
    let other = erratum("E3", "3000:02", "min", "was = 1, set = 0");
    assert_eq!(codes(SINGLE, &other), ["E0204"]);
    assert_eq!(codes("", &single), ["E0203"], "there is no row for 3000:02 alone");
}

#[test]
fn a_value_that_the_row_drops_does_not_come_from_the_range() {
    let model = sound(sources(SINGLE, &erratum("E1", "3000:02", "max", "was = 50, unset = true")));
    assert_eq!(numbers(&model, 2), (Some(20), None, None));
    assert_eq!(numbers(&model, 1), (Some(10), Some(100), None));
    let model = sound(sources(SINGLE, &erratum("E1", "3000:01..04", "max", "was = 100, unset = true")));
    assert_eq!(numbers(&model, 1), (Some(10), None, None));
    assert_eq!(numbers(&model, 2), (Some(20), Some(50), None));
}

/// A drive with the objects of a base: 6065:00 has `pdo = "rx"` there.
fn on_a_base(errata: &str) -> Vec<Source> {
    let object = r#"objects = [ { at = "6065:00", type = "u32", pdo = "tx", unit = "rev", default = 5, src = "1 L3" } ]"#;
    let drive = DRIVE.replace("id = \"x1\"", "id = \"x1\"\nbases = [\"cia402\"]");
    vec![
        Source { path: "drive.toml".into(), text: drive },
        Source { path: "rows.toml".into(), text: format!("{object}\nerrata = [\n{errata}\n]\n") },
    ]
}

#[test]
fn a_dropped_value_does_not_come_back_from_the_base() {
    let window = |errata: &str| {
        let model = sound(on_a_base(errata));
        model.entry(Address::new(0x6065, 0)).expect("the entry").1.clone()
    };
    assert_eq!(window("").mapping.map(|m| m.value.word()), Some("tx"));
    let kept = window(&erratum("E1", "6065:00", "pdo", "was = \"tx\", unset = false"));
    assert_eq!(kept.mapping.map(|m| m.value.word()), Some("tx"));
    let dropped = window(&erratum("E1", "6065:00", "pdo", "was = \"tx\", unset = true"));
    assert_eq!(dropped.mapping, None);
    assert_eq!(dropped.default.map(|d| d.value), Some(Value::Int(5)), "another key stays");
    assert_eq!(dropped.access.origin.class, Class::Standard("cia402".to_owned()));
}

/// What every entry needs cannot be dropped: the base does not fill in.
#[test]
fn a_type_that_is_dropped_is_stated_by_nobody() {
    let dropped = erratum("E1", "6065:00", "type", "was = \"u32\", unset = true");
    let compiled = compile(on_a_base(&dropped));
    assert_eq!(compiled.diagnostics.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0301"]);
}

#[test]
fn what_is_not_printed_or_set_as_well_cannot_be_dropped() {
    let max = |rest: &str| codes("", &erratum("E1", "3000:01..04", "max", rest));
    assert_eq!(max("was = 99, unset = true"), ["E0204"]);
    assert_eq!(max("was = 100, set = 200, unset = true"), ["E0206"]);
    let twice = [("E1", "was = 100, unset = true"), ("E2", "was = 100, set = 200")];
    let both: String = twice.map(|(id, rest)| erratum(id, "3000:01..04", "max", rest)).join("\n");
    assert_eq!(codes("", &both), ["E0205"]);
}

/// A row that refines a range is compared with the base by what both state.
#[test]
fn a_range_that_contradicts_the_base_does_so_where_it_is_refined() {
    let sources = |deviation: &str| {
        let objects = format!(
            r#"objects = [
{{ at = "1018:00", default = 1, src = "1 L1" }},
{{ at = "1018:01..02", name = "Id", type = "u16", access = "ro"{deviation}, src = "1 L2" }},
{{ at = "1018:01", default = 5, src = "1 L3" }},
]"#
        );
        let drive = DRIVE.replace("id = \"x1\"", "id = \"x1\"\nbases = [\"cia301\"]");
        vec![
            Source { path: "drive.toml".into(), text: drive },
            Source { path: "rows.toml".into(), text: objects },
        ]
    };
    let of = |deviation: &str| {
        let found = compile(sources(deviation)).diagnostics;
        found.iter().filter(|d| d.code.id() == "E0207").count()
    };
    assert_eq!(of(""), 2);
    assert_eq!(of(", deviation = \"16 bits are printed\""), 0);
}
