//! Hostile and oversized profiles: each is refused with its own code, and in a moment, its findings printed included.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test measures that it does not hang")]

use std::fmt::Write;
use std::time::{Duration, Instant};

use drivewright_codegen::diag::{github, json, render};
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, limits};

const DRIVE: &str = include_str!("fixtures/drive.toml");

/// Not how fast it is, only that it ends: a profile at its limits takes seconds without optimization, and
/// work that grows with the square of its size takes many minutes. What lies between is left to slow and busy machines.
const PATIENCE: Duration = Duration::from_secs(60);

/// The codes that `tables` gives, each once, in order.
fn codes(tables: &str) -> Vec<&'static str> {
    let (codes, sound) = run(&[tables]);
    assert!(!sound, "a hostile profile compiled");
    codes
}

/// The codes that files give, the last of which holds the drive as well, and whether they compile.
fn run(files: &[&str]) -> (Vec<&'static str>, bool) {
    let start = Instant::now();
    let mut sources = Vec::new();
    for (number, text) in files.iter().enumerate() {
        let drive = if number + 1 == files.len() { DRIVE } else { "" };
        let text = format!("{text}\n{drive}");
        assert!(text.len() <= limits::FILE_BYTES, "the loader would refuse {} bytes", text.len());
        sources.push(Source { path: format!("{number}.toml"), text });
    }
    let compiled = compile(sources);
    let found = &compiled.diagnostics;
    let text = render::text(found, &compiled.sources, render::Style::default());
    let programs =
        [json::lines(found, &compiled.sources), github::commands(found, &compiled.sources, "profiles/x1")];
    assert!(programs.iter().all(|p| p.lines().count() == found.len()) && text.len() >= found.len());
    let mut codes: Vec<&str> = found.iter().map(|d| d.code.id()).collect();
    assert!(codes.len() <= limits::FINDINGS + 1);
    codes.sort_unstable();
    codes.dedup();
    assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
    (codes, compiled.sound().is_some())
}

fn object(rest: &str) -> String {
    format!(
        r#"objects = [ {{ at = "2000:00", name = "Speed", type = "u16", access = "rw", src = "1 L1"{rest} }} ]"#
    )
}

#[test]
fn texts_and_lists_are_bounded() {
    assert_eq!(codes(&object(&format!(r#", text = "{}""#, "x".repeat(limits::TEXT_BYTES + 1)))), ["E0108"]);
    let name = object("").replace("Speed", &"x".repeat(limits::NAME_BYTES + 1));
    assert_eq!(codes(&name), ["E0108"]);
    assert_eq!(codes(&object(&format!(", allow = [{}]", "1,".repeat(limits::LIST_VALUES + 1)))), ["E0108"]);
}

#[test]
#[rustfmt::skip]
fn hidden_characters_are_refused() {
    for hidden in [
        "\\u0000", "\\n", "\\r", "\\t", "\\u007F", "\\u00AD", "\\u034F", "\\u061C", "\\u115F", "\\u1160", "\\u180E", "\\u200B",
        "\\u200F", "\\u2028", "\\u202E", "\\u2066", "\\u206F", "\\u3164", "\\uFE00", "\\uFE0F", "\\uFEFF", "\\uFFA0", "\\uFFF9",
        "\\U000E0001", "\\U000E0041", "\\U000E0100",
    ] {
        assert_eq!(codes(&object("").replace("Speed", &format!("Sp{hidden}eed"))), ["E0006"], "{hidden}");
    }
    for seen in ["µ", "°", "速度", "\\u00AE", "\\u2027", "\\u202F", "\\uFFFD", "\\U0001F600"] {
        let found = run(&[&object("").replace("Speed", &format!("Sp{seen}eed"))]);
        assert!(found.1, "{seen}: {found:?}");
    }
}

#[test]
fn numbers_do_not_wrap() {
    for number in [
        "0xFFFFFFFFFFFFFFFFFF",
        "-0x1",
        "99999999999999999999999999999999999999999999",
        "18446744073709551616",
    ] {
        let found = codes(&object(&format!(", default = {number}")));
        assert!(found == ["E0107"] || found == ["E0101"], "{number}: {found:?}");
    }
    for number in ["0.0", "1e3", "nan", "inf"] {
        assert_eq!(codes(&object(&format!(", default = {number}"))), ["E0114"], "{number}");
    }
}

#[test]
fn units_cannot_divide_by_zero() {
    for unit in [
        "0 rpm",
        "1/0 rpm",
        "0/1 rpm",
        "0.0 rpm",
        "-1 rpm",
        "1e3 rpm",
        "1//2 rpm",
        "9999999999 rpm",
        "rpm rpm",
    ] {
        assert_eq!(codes(&object(&format!(r#", unit = "{unit}""#))), ["E0112"], "{unit}");
    }
}

#[test]
fn ids_cannot_leave_the_folder() {
    for id in ["../x", "/etc", "a/b", "a\\\\b", "C:x", "..", "x.toml", "x y", "X1", "1x", "con\\u0000"] {
        let text = DRIVE.replace("\"x1\"", &format!("\"{id}\""));
        let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
        let codes: Vec<&str> = compiled.diagnostics.iter().map(|d| d.code.id()).collect();
        assert_eq!(codes, [if id.contains("u0000") { "E0006" } else { "E0117" }], "{id}");
        assert!(compiled.sound().is_none());
    }
}

#[test]
fn nesting_does_not_overflow_the_stack() {
    for (open, close) in [("[", "]"), ("{a=", "}")] {
        let deep = format!("objects = {}1{}", open.repeat(200_000), close.repeat(200_000));
        assert!(codes(&deep).contains(&"E0118"));
    }
    assert_eq!(codes(&format!("[{}]\nx = 1", "a.".repeat(200_000) + "a")), ["E0118"]);
}

#[test]
fn too_many_rows_are_refused_at_once() {
    assert_eq!(codes(&format!("objects = [{}]", "{},".repeat(limits::ROWS + 1))), ["E0109"]);
}

#[test]
fn many_bad_rows_are_counted_not_kept() {
    let found = codes(&format!("objects = [{}]", "{},".repeat(limits::ROWS)));
    assert_eq!(found, ["E0007", "E0104"]);
}

#[test]
fn many_syntax_errors_take_linear_time() {
    let found = codes(&format!("objects = [\n{}]", "{ at = = 1 },\n".repeat(100_000)));
    assert!(found.contains(&"E0101"), "{found:?}");
}

/// Errata of one row, each `rest`.
fn errata(count: usize, rest: &str) -> String {
    let row = |n| {
        format!(
            "{{ id = \"E{n}\", at = \"2000:00\", {rest}, seen = \"1 L1\", why = \"w\", sure = \"low\" }},\n"
        )
    };
    format!("errata = [\n{}]", (0..count).map(row).collect::<String>())
}

#[test]
fn many_errata_of_one_row_take_linear_time() {
    let row = object(", min = 1");
    let kept = errata(80_000, "field = \"min\", was = 1");
    assert_eq!(run(&[&kept, &row]), (vec![], true));
}

/// Each erratum that does not hold prints the value that it found; a long one must not be printed as a whole.
#[test]
fn errata_of_a_huge_value_take_linear_time() {
    let texts = format!("\"{}\", ", "x".repeat(1_000)).repeat(limits::LIST_VALUES);
    let row = format!(
        "alarms = [ {{ display = \"A\", number = 1, code = 1, name = \"A\", causes = [ {texts} ], src = \"1 L1\" }} ]"
    );
    let of_alarm = |rest: &str| errata(5_000, rest).replace("2000:00", "alarm A");
    assert_eq!(run(&[&of_alarm("field = \"causes\", was = 1"), &row]), (vec!["E0204"], false));
    let wrong = of_alarm("field = \"code\", was = 1, set = -1");
    assert_eq!(run(&[&wrong, &row]), (vec!["E0107", "E0205"], false));
}

#[test]
fn many_errata_that_match_nothing_take_linear_time() {
    let mut tables = object("");
    tables.push_str("\nerrata = [\n");
    for n in 0..50_000 {
        let _ = writeln!(
            tables,
            r#"{{ id = "E{n}", at = "3{:03X}:{:02X}", field = "min", was = 1, seen = "1 L1", why = "w", sure = "low" }},"#,
            n / 256,
            n % 256
        );
    }
    tables.push(']');
    assert_eq!(codes(&tables), ["E0007", "E0203"]);
}

#[test]
fn many_rows_of_one_homing_method_take_linear_time() {
    let rows = |row: &str| codes(&format!("homing = [\n{}]", format!("{{ {row} }},\n").repeat(limits::ROWS)));
    assert_eq!(rows("method = 1"), ["E0007", "E0202", "E0312"]);
    let program = r#"method = 1, when = "any", moves = "+ slow until home on; latch""#;
    assert_eq!(rows(program), ["E0007", "E0202"]);
}

#[test]
fn what_would_be_read_as_something_else_is_refused() {
    let homing = r#"homing = [{ method = 1, when = "any", moves = "+ slow until home on; latch", abort = "any", src = "1 L1" }]"#;
    assert_eq!(codes(homing), ["E0312"]);
    let example = r#"examples = [{ id = "a", write = "2000", value = 1, src = "1 L1" }]"#;
    assert_eq!(codes(&format!("{}\n{example}", object(""))), ["E0110"]);
}

#[test]
fn ranges_do_not_multiply_without_bound() {
    let mut tables = String::from("objects = [\n");
    for index in 0..4_000 {
        let _ = writeln!(
            tables,
            r#"{{ at = "{:04X}:00..FF", name = "N{index}", type = "u8", access = "rw", src = "1 L1" }},"#,
            0x2000 + index
        );
    }
    tables.push(']');
    assert!(codes(&tables).contains(&"E0310"));
}

#[test]
fn long_unknown_keys_cost_nothing() {
    let row = format!("{{ {} = 1 }},\n", "k".repeat(60));
    let found = codes(&format!("objects = [\n{}]", row.repeat(80_000)));
    assert_eq!(found, ["E0007", "E0103", "E0104"]);
}

#[test]
fn keys_of_a_row_and_tables_of_a_file_are_bounded() {
    let keys = |n: usize| (0..n).map(|n| format!(", k{n} = 1")).collect::<Vec<_>>().concat();
    assert_eq!(codes(&object(&keys(20_000))), ["E0120"]);
    assert_eq!(codes(&object(&keys(limits::KEYS - 6))), ["E0103"]);
    let tables = |n: usize| (0..n).map(|n| format!("[a{n}]\n")).collect::<Vec<_>>().concat();
    assert_eq!(codes(&tables(600_000)), ["E0119"]);
    // The drive and its manuals are two more.
    assert_eq!(codes(&tables(limits::TABLES - 2)), ["E0102"]);
}

#[test]
fn many_findings_in_one_line_take_linear_time() {
    let long = "x".repeat(limits::FILE_BYTES / 2);
    let found = codes(&format!(
        "objects = [{}{{y=\"{long}\"}}]",
        "{µ=1},".replace('µ', "\"µ\"").repeat(limits::ROWS - 1)
    ));
    assert_eq!(found, ["E0007", "E0103", "E0104"]);
}

#[test]
fn bases_and_process_data_are_bounded() {
    let many: Vec<String> = (0..=limits::BASES).map(|n| format!("\"b{n}\"")).collect();
    let text = DRIVE.replace("eds_version", &format!("bases = [{}]\neds_version", many.join(", ")));
    let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
    assert_eq!(compiled.diagnostics.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0211"]);
    let mut tables = object(r#", pdo = "rx""#);
    tables.push_str("\npdo = [\n");
    for n in 0..=limits::PDOS {
        let _ = writeln!(
            tables,
            r#"{{ map = {n}, dir = "rx", pos = 1, entry = "2000:00", bits = 16, src = "1 L1" }},"#
        );
    }
    tables.push(']');
    assert_eq!(codes(&tables), ["E0315"]);
}

/// A profile with one PDO of `count` entries of `bits` bits.
fn pdo(count: u32, bits: u32) -> String {
    let mut tables = object("").replace("u16", &format!("u{bits}")).replace("src", "pdo = \"rx\", src");
    tables.push_str("\npdo = [\n");
    for pos in 0..count {
        let _ = writeln!(
            tables,
            r#"{{ map = 0x1600, dir = "rx", pos = {}, entry = "2000:00", bits = {bits}, src = "1 L1" }},"#,
            // Beyond the last position there is only position 0.
            (pos + 1) % 256
        );
    }
    tables.push(']');
    tables
}

#[test]
fn a_pdo_has_no_more_entries_than_a_mapping_counts() {
    let most = limits::PDO_ENTRIES;
    assert!(codes(&pdo(most + 1, 8)).contains(&"E0313"));
    assert_eq!(run(&[&pdo(most, 8)]), (vec![], true));
}

#[test]
fn a_pdo_has_no_more_bytes_than_a_frame_carries() {
    let most = limits::PDO_BYTES / 8;
    assert_eq!(codes(&pdo(most + 1, 64)), ["E0314"]);
    assert_eq!(run(&[&pdo(most, 64)]), (vec![], true));
}

#[test]
fn a_profile_without_a_drive_or_with_two_is_refused() {
    let none = compile(vec![Source { path: "objects.toml".into(), text: object("") }]);
    assert_eq!(none.diagnostics.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0209"]);
    let two = compile(vec![
        Source { path: "a.toml".into(), text: DRIVE.into() },
        Source { path: "b.toml".into(), text: DRIVE.split("[[manuals]]").next().unwrap_or_default().into() },
    ]);
    assert_eq!(two.diagnostics.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0209"]);
    assert_eq!(compile(Vec::new()).diagnostics.len(), 1);
}
