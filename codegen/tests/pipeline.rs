//! The pipeline from texts to a model: what each stage promises.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::model::{Address, Class, Value};
use drivewright_codegen::source::Source;
use drivewright_codegen::{backend, compile, emit};

const DRIVE: &str = include_str!("fixtures/drive.toml");

fn sources(objects: &str, more: &[(&str, &str)]) -> Vec<Source> {
    let mut out = vec![
        Source { path: "drive.toml".into(), text: DRIVE.into() },
        Source { path: "objects.toml".into(), text: format!("objects = [\n{objects}\n]\n") },
    ];
    out.extend(more.iter().map(|(path, text)| Source { path: (*path).into(), text: (*text).into() }));
    out
}

fn codes(objects: &str, more: &[(&str, &str)]) -> Vec<String> {
    let compiled = compile(sources(objects, more));
    compiled
        .diagnostics
        .iter()
        .map(|d| format!("{} {}", d.code.id(), compiled.sources.place(d.span)))
        .collect()
}

const GOOD: &str = r#"{ at = "2000:00", name = "Speed", type = "u16", access = "rw", unit = "0.1 rpm", min = 0, max = 30000, default = 5, src = "1 L2" },"#;

#[test]
fn a_small_profile_compiles() {
    let compiled = compile(sources(GOOD, &[]));
    assert_eq!(compiled.diagnostics, []);
    let model = compiled.sound().expect("a model");
    let (_, entry) = model.entry(Address::new(0x2000, 0)).expect("the entry");
    assert_eq!(entry.handle.words().join(" "), "speed");
    assert_eq!(entry.default.as_ref().map(|d| &d.value), Some(&Value::Int(5)));
    assert_eq!(entry.ty.origin.class, Class::Stated);
    assert_eq!(entry.ty.origin.cite.as_ref().map(ToString::to_string).as_deref(), Some("1 L2"));
}

#[test]
fn every_bad_row_of_every_file_is_reported_in_one_run() {
    let objects = r#"
{ at = "2000:00", nmae = "A", type = "u16", access = "rw", src = "1 L2" },
{ at = "2001:00", name = "B", type = "u17", access = "rx", src = "1 L2" },
{ at = "2002:00", name = "C", type = "u16", access = "rw", src = "1 L2" },
{ at = "2003", name = 5 },"#;
    let found = codes(objects, &[("alarms.toml", "alarms = [ { display = \"A\" } ]\n")]);
    let starts: Vec<&str> = found.iter().map(|c| &c[..5]).collect();
    assert_eq!(starts, ["E0104", "E0104", "E0104", "E0103", "E0106", "E0106", "E0105"], "{found:#?}");
}

/// What the standard leaves to the drive, or what a manual says more loosely, is no contradiction.
#[test]
fn a_row_may_say_less_than_the_standard_or_leave_its_units_to_the_user() {
    let drive = DRIVE.replace("eds_version", "bases = [\"cia402\"]\neds_version");
    let found = |row: &str| -> Vec<&'static str> {
        let objects = format!("objects = [ {{ {row}, src = \"1 L2\" }} ]");
        let text = format!("{objects}\n{drive}");
        let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
        compiled.diagnostics.iter().filter(|d| d.code.id() == "E0207").map(|d| d.code.id()).collect()
    };
    for fine in ["pdo = \"rx tx\"", "pdo = \"tx\"", "pdo = \"no\"", "unit = \"count\"", "unit = \"deg\""] {
        assert_eq!(found(&format!("at = \"6064:00\", {fine}")), Vec::<&str>::new(), "{fine}");
    }
    for wrong in ["pdo = \"rx\"", "unit = \"ms\"", "unit = \"rpm\""] {
        assert_eq!(found(&format!("at = \"6064:00\", {wrong}")), ["E0207"], "{wrong}");
    }
}

#[test]
fn an_erratum_sets_the_value_and_says_so() {
    let errata = r#"errata = [ { id = "E1", at = "2000:00", field = "max", was = 30000, seen = "1 L2", set = 3000, by = "2 L5", why = "a zero too many", sure = "high" } ]"#;
    let compiled = compile(sources(GOOD, &[("errata.toml", errata)]));
    assert_eq!(compiled.diagnostics, []);
    let model = compiled.sound().expect("a model");
    let max = model.entry(Address::new(0x2000, 0)).and_then(|(_, e)| e.max.clone()).expect("a maximum");
    assert_eq!(max.value, 3000);
    assert_eq!(max.origin.cite.map(|c| c.to_string()).as_deref(), Some("2 L5"));
    assert!(max.origin.erratum.is_some());
}

#[test]
fn an_erratum_that_expects_another_value_is_an_error() {
    let errata = |row: &str| format!("errata = [ {row} ]");
    let of = |row: &str| codes(GOOD, &[("errata.toml", &errata(row))])[0][..5].to_owned();
    let row = |at: &str, field: &str, rest: &str| {
        format!(
            r#"{{ id = "E1", at = "{at}", field = "{field}", {rest}, seen = "1 L2", why = "w", sure = "low" }}"#
        )
    };
    assert_eq!(of(&row("2000:00", "max", "was = 3000, set = 5")), "E0204");
    assert_eq!(of(&row("2001:00", "max", "was = 30000, set = 5")), "E0203");
    assert_eq!(of(&row("2000:00", "mx", "was = 30000, set = 5")), "E0311");
    assert_eq!(of(&row("2000:00", "max", "was = 30000, set = 30000")), "E0206");
    let twice = format!(
        "{}, {}",
        row("2000:00", "max", "was = 30000, set = 5"),
        row("2000:00", "max", "was = 30000, set = 6")
    );
    assert!(codes(GOOD, &[("errata.toml", &errata(&twice))]).iter().any(|c| c.starts_with("E0205")));
}

#[test]
fn names_that_are_the_same_words_ask_for_a_rename() {
    let objects = format!("{GOOD}\n{}", GOOD.replace("2000", "2001").replace("Speed", "SPEED"));
    assert!(codes(&objects, &[])[0].starts_with("E0305"));
    let renamed =
        format!("{GOOD}\n{}", GOOD.replace("2000", "2001").replace("access", "rename = \"Speed 2\", access"));
    assert_eq!(codes(&renamed, &[]), Vec::<String>::new());
}

/// Manuals print one display for several alarms; an erratum names the one that it means by its number as well.
#[test]
fn alarms_of_one_display_are_told_by_their_numbers() {
    let alarms = r#"alarms = [
        { display = "OF", number = 0x25, code = 0x8611, name = "Following", src = "1 L1" },
        { display = "OF", number = 0x2A, code = 0x8612, name = "Overflow", src = "1 L1" },
    ]"#;
    let compiled = |at: &str| {
        let errata = format!(
            r#"errata = [ {{ id = "E1", at = "{at}", field = "code", was = 0x8612, seen = "1 L1", set = 0x8613, why = "w", sure = "low" }} ]"#
        );
        compile(sources(GOOD, &[("alarms.toml", alarms), ("errata.toml", &errata)]))
    };
    for at in ["alarm OF 0x2A", "alarm OF 0x2a"] {
        let compiled = compiled(at);
        let model = compiled.sound().unwrap_or_else(|| panic!("{at}: {:#?}", compiled.diagnostics));
        assert_eq!(model.alarms.iter().map(|a| a.code.value).collect::<Vec<_>>(), [0x8611, 0x8613], "{at}");
    }
    let found = compiled("alarm OF").diagnostics;
    assert_eq!(found[0].code.id(), "E0203");
    assert!(found[0].help.contains("alarm OF 0x"), "{found:#?}");
    assert_eq!(compiled("alarm OF 0x2B").diagnostics[0].code.id(), "E0203");
}

/// What a manual prints in another script stays as printed; code calls it by its `rename`.
#[test]
fn a_printed_name_may_be_of_any_script_where_it_is_renamed() {
    let tables = r#"
objects = [ { at = "2000:00", name = "速度", type = "u16", access = "rw", values = "M", src = "1 L1", rename = "Speed" },
  { at = "2001:00", name = "状态", type = "u16", access = "ro", bits = "S", src = "1 L1", rename = "State" },
  { at = "2002:00", name = "Gains", type = "u8", access = "ro", default = 2, src = "1 L1" },
  { at = "2002:01..02", name = "增益", type = "u16", access = "rw", src = "1 L1", rename = "Gain" } ]
enums = [ { name = "M", value = 0, label = "关", src = "1 L1", rename = "Off" } ]
bits = [ { name = "S", bit = 0, label = "就绪", src = "1 L1", rename = "Ready" } ]
alarms = [ { display = "A", number = 1, code = 1, name = "过流", src = "1 L1", rename = "Over current" } ]
"#;
    let run = |text: &str| compile(vec![Source { path: "x.toml".into(), text: format!("{text}\n{DRIVE}") }]);
    let compiled = run(tables);
    assert_eq!(compiled.diagnostics, []);
    let (files, losses) = emit(compiled.sound().expect("a model"), backend::ALL);
    let lost: Vec<&str> = losses.iter().map(|d| d.code.id()).collect();
    assert_eq!(lost, ["W1004", "W1005"], "what an EDS cannot say, and no more: {losses:#?}");
    let file = |path| String::from_utf8_lossy(files.get(path).expect("a file")).into_owned();
    assert!(file("src/od.rs").contains("GAIN_2") && file("src/enums.rs").contains("关"));
    let names = ["Speed", "State", "Gain", "Off", "Ready", "Over current"];
    let plain = names
        .iter()
        .fold(tables.to_owned(), |text, name| text.replace(&format!(", rename = \"{name}\""), ""));
    let found = run(&plain).diagnostics;
    assert_eq!(found.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0304"; 6], "{found:#?}");
}

#[test]
fn the_order_of_files_and_rows_does_not_matter() {
    let second = GOOD.replace("2000", "2001").replace("Speed", "Torque");
    let forward = compile(sources(&format!("{GOOD}\n{second}"), &[]));
    let mut backward = sources(&format!("{second}\n{GOOD}"), &[]);
    backward.reverse();
    assert_eq!(forward.model, compile(backward).model);
}

/// Cases without numbers are told apart by their start; those of one start may have another case between them.
#[test]
fn cases_of_one_start_are_one_case() {
    let row = |when: &str, line: u8| {
        format!(
            r#"{{ method = 1, when = "{when}", moves = "- slow until home on; latch", src = "1 L{line}" }},"#
        )
    };
    let of = |rows: &[String]| {
        let homing = format!("homing = [\n{}\n]\n", rows.join("\n"));
        let found = codes("", &[("homing.toml", &homing)]);
        found.into_iter().filter(|c| c.starts_with("E0202")).collect::<Vec<_>>()
    };
    assert_eq!(of(&[row("home off", 1), row("home on", 2)]), [""; 0]);
    let again = of(&[row("home off", 1), row("home on", 2), row("home off", 3)]);
    assert_eq!(again, ["E0202 homing.toml:4:1"]);
}
