//! Texts that would close a string, a comment, a section or a tag, in every place where a profile has a text: each is
//! refused with a stable code, or stands in every output and does nothing there.

use std::cell::Cell;

use drivewright_codegen::emit::FileSet;
use drivewright_codegen::source::Source;
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::TestRunner;

use super::judge::{Shapes, harm, hides, shapes};
use super::order::quoted;
use super::{Outcome, cases, run, source};

/// A profile with a place for a text wherever it has one: `<place>`.
const PROFILE: &str = r#"
manuals = [ { id = "m1", title = <title>, version = <version>, date = <printed>, sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 99 } ]
objects = [
  { at = "2000:00", name = <name>, type = "u32", access = "rw", unit = "0.1 rpm", min = 0, max = 9, bits = <table of bits>, text = <text>, note = <note>, inferred = [<rule>], src = "1 L1" },
  { at = "2001:00", name = "First", rename = <rename>, type = "u16", access = "rw", pdo = "rx", values = <table>, assumed = [<reason>], src = "1 L2" },
  { at = "2002:00", name = "Label", type = "string", access = "ro", default = <default>, src = <section> },
  { at = "2003", name = <object>, src = "1 L3" },
  { at = "2003:00", name = "Count", type = "u8", access = "ro", default = 1, src = "1 L3" },
  { at = "2003:01", name = <member>, type = "u8", access = "ro", src = "1 L3" },
]
enums = [ { name = <table>, value = 0, label = <label>, text = <meaning>, src = "L4" }, { name = <table>, value = 1, label = "on", src = "L4" } ]
bits = [ { name = <table of bits>, bit = 0, label = <bit>, text = <effect>, src = "L5" }, { name = <table of bits>, bit = 1, label = "on", src = "L5" } ]
alarms = [ { display = <display>, number = 1, code = 1, name = <alarm>, causes = [<cause>], remedies = [<remedy>], src = "L6" } ]
pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "2001:00", bits = 16, src = "L7" } ]
ethercat = [ { type = <type>, group = <group>, src = "L8" } ]
dc_modes = [ { number = 1, name = <mode>, sync = "sync0", text = <follows>, src = "L9" } ]
startup = [ { number = 1, transition = "PS", write = "2000:00", value = 1, text = <reason to write>, src = "L9" } ]
errata = [ { id = <erratum>, at = "2000:00", field = "max", was = 9, seen = "1 L2", set = 8, why = <why>, sure = "high" } ]
[drive]
format = 1
id = "x1"
vendor = <vendor>
vendor_id = "acme"
name = <product>
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
note = <remark>
"#;

/// Places whose text programs must read back as it was written, from JSON and from Rust.
const KEPT: &[&str] = &[
    "name", "member", "default", "label", "bit", "display", "alarm", "cause", "remedy", "vendor", "product",
    "table",
];

/// Codes that may refuse a text: what it holds, how long it is, what is left of it as a name, a citation or a manual.
const REFUSALS: &[&str] = &["E0006", "E0106", "E0108", "E0111", "E0304", "E0305", "E0309"];

/// Codes that follow where the row of a table or manual was refused.
const FOLLOWING: &[&str] = &["E0306", "E0307", "E0902"];

/// Places whose text becomes a name in Rust.
const NAMES: &[&str] =
    &["name", "member", "rename", "object", "table", "table of bits", "label", "bit", "alarm"];

/// Parts of hostile texts.
const PARTS: &[&str] = &[
    "\"",
    "'",
    "\\",
    "\\\"",
    "[6040]",
    "[",
    "]",
    "](",
    "!",
    "(",
    ")",
    "{",
    "}",
    "}}",
    "{{",
    "{%",
    "{#",
    "#}",
    "${}",
    "$NODEID",
    "*/",
    "/*",
    "//",
    "///",
    "<script>",
    "</b>",
    "<!--",
    "-->",
    "&lt;",
    "&",
    "`",
    "```",
    "~~~",
    "#",
    "##",
    "|",
    "%s",
    "=",
    ";",
    ":",
    ": ",
    ",",
    "http://x.y",
    "www.x.y",
    "_",
    "*",
    "-",
    "+ ",
    "1. ",
    "::",
    "$",
    "@",
    " ",
    "  ",
    "     ",
    "\u{A0}",
    "self",
    "gen",
    "r#type",
    "b'x'",
    "DRIVE",
    "Name",
    "value",
    "0",
    "1",
    "N1",
    "x",
    "Z",
    "伺服",
    "é",
    "𝕏",
    "\u{301}",
];

/// Parts that nobody sees.
const HIDDEN: &[&str] = &[
    "\n",
    "\r\n",
    "\n[6040]",
    "\t",
    "\0",
    "\u{1B}[2J",
    "\u{7F}",
    "\u{85}",
    "\u{200B}",
    "\u{200D}",
    "\u{202E}",
    "\u{2066}",
    "\u{2028}",
    "\u{2029}",
    "\u{FEFF}",
    "\u{61C}",
    "\u{AD}",
    "\u{206F}",
    "\u{FFF9}",
    "\u{E0041}",
];

/// The places of [`PROFILE`], each once.
fn places() -> Vec<&'static str> {
    let mut places: Vec<&str> =
        PROFILE.split('<').skip(1).filter_map(|rest| Some(rest.split_once('>')?.0)).collect();
    places.sort_unstable();
    places.dedup();
    places
}

/// [`PROFILE`] with `text` at `place` and a calm text at each other one.
fn profile(place: &str, text: &str) -> Vec<Source> {
    let filled = places().into_iter().fold(PROFILE.to_owned(), |profile, each| {
        let text = if each == place { text.to_owned() } else { format!("Calm {each}") };
        let text = match each {
            "rule" => format!("type: {text}"),
            "reason" => format!("access: {text}"),
            "section" => format!("{} L1", text.replace("Calm section", "calm")),
            _ => text,
        };
        profile.replace(&format!("<{each}>"), &quoted(&text))
    });
    vec![source("x1.toml", filled)]
}

/// The profile without any hostile text.
pub(crate) fn calm() -> Vec<Source> {
    profile("", "")
}

/// Codes of the errors of `result`, without those that follow from another.
fn refused(result: &Outcome) -> Vec<&str> {
    let codes: Vec<&str> = result.findings.iter().filter(|f| f.starts_with('E')).map(|f| &f[..5]).collect();
    let first: Vec<&str> = codes.iter().copied().filter(|c| !FOLLOWING.contains(c)).collect();
    if first.is_empty() { codes } else { first }
}

/// Whether `text` at `place` is accepted; fails where it does harm, or is refused for no known reason.
fn accepted(place: &str, text: &str, calm: &Shapes) -> Result<bool, TestCaseError> {
    let result = run(profile(place, text));
    let shown = result.findings.join("\n");
    prop_assert!(!shown.contains(|c| c != '\n' && hides(c)), "a message holds what it warns of: {:?}", shown);
    if result.files.is_empty() {
        let codes = refused(&result);
        prop_assert!(codes.iter().all(|c| REFUSALS.contains(c)) && !codes.is_empty(), "{}", shown);
        return Ok(false);
    }
    let kept = KEPT.contains(&place).then_some(text);
    match harm(&result.files, calm, kept) {
        Some(found) => Err(TestCaseError::fail(format!("{place} = {text:?}\n{found}"))),
        None => Ok(true),
    }
}

#[test]
fn the_calm_profile_has_every_place() {
    let result = run(calm());
    assert_eq!(refused(&result), Vec::<&str>::new(), "{:#?}", result.findings);
    assert_eq!(harm(&result.files, &shapes(&result.files), Some("Calm name")), None);
    assert!(places().len() >= 25 && KEPT.iter().all(|kept| places().contains(kept)));
}

#[test]
fn texts_made_by_chance() {
    let calm = shapes(&run(calm()).files);
    let (tried, passed) = (Cell::new(0_u32), Cell::new(0_u32));
    let part = prop_oneof![60 => select(PARTS), 1 => select(HIDDEN)];
    let texts = (select(places()), vec(part, 1..10).prop_map(|parts| parts.concat()));
    let checked = TestRunner::new(cases(400)).run(&texts, |(place, text)| {
        tried.set(tried.get() + 1);
        passed.set(passed.get() + u32::from(accepted(place, &text, &calm)?));
        Ok(())
    });
    if let Err(error) = checked {
        panic!("{error}");
    }
    assert!(passed.get() > tried.get() / 3, "{} of {} were accepted", passed.get(), tried.get());
}

#[test]
fn hidden_characters_are_refused_everywhere() {
    for place in places() {
        for part in HIDDEN {
            let result = run(profile(place, &format!("a{part}b")));
            let codes = refused(&result);
            assert!(!codes.is_empty() && codes.iter().all(|c| *c == "E0006"), "{place} {part:?}: {codes:?}");
        }
    }
}

#[test]
fn what_is_refused_and_what_is_not() {
    let long = |n: usize| "x".repeat(n);
    let texts = [
        ("name", "\n[6040]".to_owned(), Some("E0006")),
        ("name", "伺服".to_owned(), Some("E0304")),
        ("name", "\"\\*/".to_owned(), Some("E0304")),
        ("name", long(201), Some("E0108")),
        ("name", "first".to_owned(), None),
        ("rename", "Calm-Name".to_owned(), Some("E0305")),
        ("name", "   ".to_owned(), Some("E0106")),
        ("text", long(4097), Some("E0108")),
        ("section", "m2".to_owned(), Some("E0309")),
        ("section", "a b c".to_owned(), Some("E0111")),
        ("name", long(200), None),
        ("name", format!("a{}", "#".repeat(199)), None),
        ("text", long(4096), None),
        ("vendor", "\"]})*/ <script>".to_owned(), None),
        ("title", "[x](http://y) www.y.z #}".to_owned(), None),
        ("text", "    let x = 1;".to_owned(), None),
        ("why", "${} {{ name }} {% raw %}".to_owned(), None),
    ];
    let calm = shapes(&run(calm()).files);
    for (place, text, wanted) in texts {
        match accepted(place, &text, &calm) {
            Ok(true) => assert_eq!(wanted, None, "{place} {text:?}"),
            Ok(false) => assert_eq!(refused(&run(profile(place, &text))), [wanted.expect("accepted")]),
            Err(error) => panic!("{error}"),
        }
    }
}

#[test]
fn words_of_rust() {
    let calm = shapes(&run(calm()).files);
    let words = "self Self super crate gen async await type match dyn union macro_rules static r#try true str u8 Some \
                 None Option DESC new MODEL Object Raw Rw Rx core std";
    for (word, place) in words.split(' ').flat_map(|word| NAMES.iter().map(move |place| (word, place))) {
        let passed = accepted(place, word, &calm).unwrap_or_else(|error| panic!("{error}"));
        assert!(passed, "{place} = {word}");
    }
}

/// Ids choose paths and crate names.
#[test]
fn no_id_leads_anywhere() {
    let ids = ["../x1", "/etc", "c:x", "X1", "x_1", "x1\0", "x 1", "x1/..", ".", "", "é", "nul\n", "-x"];
    for (key, id) in ["id = \"x1\"", "vendor_id = \"acme\""].iter().flat_map(|k| ids.map(|id| (k, id))) {
        let name = key.split_once(' ').expect("a key").0;
        let mut sources = calm();
        sources[0].text = sources[0].text.replace(&format!("\n{key}"), &format!("\n{name} = {}", quoted(id)));
        let result = run(sources);
        let codes = refused(&result);
        assert!(
            ["E0006", "E0106", "E0117"].iter().any(|code| codes == [*code]),
            "{name} {id:?}: {:#?}",
            result.findings
        );
    }
}

/// A text that reached an output without being escaped is seen in each of them.
#[test]
fn unescaped_texts_are_seen() {
    let calm = run(calm()).files;
    let wanted = shapes(&calm);
    let injections = [
        ("src/od.rs", "Calm name", "x\npub const X: u8 = 0;\n"),
        ("src/od.rs", "Calm name", "[x]"),
        ("src/od.rs", " Calm text", "      let x = 1;"),
        ("src/table.rs", "Calm name", "\", \""),
        ("src/enums.rs", "Calm label", "<b>"),
        ("eds/acme-x1.eds", "Calm name", "x\r\n[6040]"),
        ("eds/acme-x1.eds", "Calm name", "x;y"),
        ("esi/acme-x1.xml", "Calm name", "<x/>"),
        ("esi/acme-x1.xml", "Calm name", "x & y"),
        ("esi/acme-x1.xml", "Calm name", "\u{202E}"),
        ("esi/acme-x1.xml", "Calm title", "-- x"),
        ("map.txt", "Calm name", "x\ny"),
        ("map.txt", "Calm name", "\u{202E}"),
        ("model.json", "Calm name", "\", \"x\": \""),
        ("model.json", "Calm name", "other"),
        ("README.md", "Calm title", "<script>"),
        ("README.md", "Calm title", "https://x.y"),
        ("README.md", "Calm title", "x\n\n# y"),
        ("Cargo.toml", "Calm vendor", "\"\nbuild = \"x.rs"),
    ];
    for (path, from, to) in injections {
        let text = std::str::from_utf8(calm.get(path).expect("the file")).expect("UTF-8");
        assert!(text.contains(from), "{path} does not say {from}");
        let broken = with(&calm, path, text.replace(from, to));
        assert!(harm(&broken, &wanted, Some("Calm name")).is_some(), "{path}: {to}");
    }
}

/// The files, with another text at `path`.
fn with(files: &FileSet, path: &str, text: String) -> FileSet {
    let mut changed = FileSet::default();
    changed.add(path, text).expect("a path");
    for (at, bytes) in files.iter().filter(|(at, _)| at.as_str() != path) {
        changed.add(at.as_str(), bytes).expect("a path of its own");
    }
    changed
}

/// Two objects, each by its name and its name in code.
fn two(first: [&str; 2], second: [&str; 2]) -> Outcome {
    let row = |(index, [name, rename]): (u16, [&str; 2])| {
        let names = format!("name = {}, rename = {}", quoted(name), quoted(rename));
        format!(r#"{{ at = "{index:04X}:00", {names}, type = "u8", access = "rw", src = "1 L1" }},"#)
    };
    let rows = [(0x2000, first), (0x2001, second)].map(row).concat();
    run(vec![source("x1.toml", format!("objects = [\n{rows}\n]\n{}", super::DRIVE))])
}

/// Names that differ in a profile and not in an output.
#[test]
fn names_that_become_alike() {
    let in_rust = two(["1 gain", "1 gain"], ["n1 gain", "n1 gain"]);
    assert_eq!(refused(&in_rust), ["E0305"], "both are N1_GAIN");
    let in_eds = two(["参数 a", "first"], ["伺服 a", "second"]).files;
    let text = std::str::from_utf8(in_eds.get("eds/acme-x1.eds").expect("an EDS")).expect("ASCII");
    let names: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("ParameterName=")).collect();
    assert_eq!(names, ["?? a 2000h", "?? a 2001h"]);
}
