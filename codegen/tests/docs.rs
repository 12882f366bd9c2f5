//! What the reference pages and `explain` say of one small drive, word by word where a reader depends on it.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::fmt::Write;

use drivewright_codegen::backend::docs::{Docs, explain};
use drivewright_codegen::model::Model;
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, emit};

const PROFILE: &str = r#"
manuals = [ { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 99 } ]
objects = [
  { at = "1600:00", name = "Mapped", type = "u8", access = "rw", default = 1, src = "1 L1" },
  { at = "1600:01", name = "Mapped object", type = "u32", access = "rw", default = 0x60810020, src = "1 L2" },
  { at = "3000", name = "Group", text = "All of it.", note = "In two tables.", also = "4 L9", src = "1 L3" },
  { at = "3000:00", name = "Highest", type = "u8", access = "ro", default = 9, src = "1 L3" },
  { at = "3000:01..09", name = "Parameter", type = "i16", access = "rw", inferred = ["type: width of the range"], src = "1 L4" },
  { at = "3000:04", name = "Delay", parameter = "P1.04", effect = "power cycle", unit = "0.1 ms", min = 0, max = 50, default = 15, src = "2 L5" },
  { at = "6060:00", name = "Mode", type = "i8", access = "rw", values = "mode", default = 8, src = "1 L6" },
  { at = "6061:00", name = "Mode display", type = "i8", access = "ro", values = "mode", text = "See 6060h, E7 and P1.04.", src = "1 L7" },
  { at = "6081:00", name = "Speed", type = "u32", access = "rw", pdo = "rx", unit = "0.1 rpm", min = 0, max = 60000, src = "1 L8" },
]
enums = [ { name = "mode", value = 8, label = "CSP", src = "L9" } ]
alarms = [
  { display = "EC", number = 0x13, code = 0x7305, name = "Encoder", reset = "not resettable", causes = ["Cable."], remedies = ["Mend it."], src = "L10" },
  { display = "Ec", number = 0x14, code = 0x7305, name = "Other encoder", src = "L11" },
]
homing = [ { method = 1, when = "negative_limit off", moves = "- fast until negative_limit on; stop; latch", src = "L12" } ]
modes = [ { mode = 8, name = "Cyclic position", objects = ["6081:00"], src = "L13" } ]
aborts = [ { code = 0x06020000, name = "No such object", src = "L14" } ]
rules = [ { id = "R1", text = "Not 0.", require = "6081:00 > 0", src = "L15" } ]
pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "6081:00", bits = 32, src = "L16" } ]
errata = [ { id = "E007", at = "6081:00", field = "max", was = 60000, seen = "1 L8", set = 30000, by = "2 L3", why = "As 2 says.", sure = "medium" } ]
[drive]
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
note = "With the brake option."
"#;

fn model(text: String) -> Model {
    let compiled = compile(vec![Source { path: "a.toml".into(), text }]);
    compiled.sound().cloned().unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics))
}

fn page(model: &Model, name: &str) -> String {
    let (files, _) = emit(model, &[&Docs]);
    let bytes = files.get(&format!("docs/{name}")).unwrap_or_else(|| panic!("there is no {name}"));
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

fn says(text: &str, wanted: &[&str]) {
    for line in wanted {
        assert!(text.lines().any(|l| l == *line), "{line}\nis not in\n{text}");
    }
}

#[test]
fn entries_that_say_the_same_share_a_row() {
    let text = page(&model(PROFILE.into()), "manufacturer.md");
    says(
        &text,
        &[
            "All of it.",
            "- Note: In two tables.",
            "- Printed again: 4 L9.",
            "| <a id=\"3000-01\"></a>01 to 03 | Parameter | i16ⁱ | rw | | | | 1 L4 |",
            "| <a id=\"3000-04\"></a>04 | P1.04 Delay | i16ⁱ | rw | 0.1 ms | 0 to 50 (0 to 5 ms) | 15 (1.5 ms) | 2 L5 |",
            "| <a id=\"3000-05\"></a>05 to 09 | Parameter | i16ⁱ | rw | | | | 1 L4 |",
            "- Type of 01 to 09: inferredⁱ: width of the range.",
            "- 04: A new value takes effect **only after a power cycle**.",
        ],
    );
}

#[test]
fn words_that_name_things_are_links() {
    let model = model(PROFILE.into());
    let text = page(&model, "profile.md");
    says(
        &text,
        &[
            // E7 is no erratum of this drive.
            "See [6060h](profile.md#6060), E7 and [P1.04](manufacturer.md#3000-04).",
            "**Mode: values: see [6060:00](profile.md#6060-00)**",
            "| <a id=\"6081-00\"></a>00 | u32 | rw | rx | 0.1 rpm | 0 to 30000 (0 to 3000 rpm) [E007](errata.md#e007) | 1 L8 |",
        ],
    );
    let mapped = "60810020h ([6081:00](profile.md#6081-00), 32 bits)";
    assert!(page(&model, "communication.md").contains(mapped));
    assert!(page(&model, "README.md").contains("With the brake option."));
}

#[test]
fn an_area_with_many_entries_has_several_pages() {
    let mut rows = String::from("objects = [\n");
    for index in 0x2000..0x2000 + 1_200 {
        let row = r#"name = "Value", type = "u8", access = "ro", src = "1 L1""#;
        let _ = writeln!(rows, r#"  {{ at = "{index:04X}:00", {row}, rename = "Value {index}" }},"#);
    }
    let manuals = PROFILE.lines().nth(1).expect("the manuals");
    let drive = PROFILE.split("[drive]").nth(1).expect("the drive");
    let model = model(format!("{manuals}\n{rows}]\n[drive]{drive}"));
    let (files, _) = emit(&model, &[&Docs]);
    let names: Vec<&str> = files.iter().map(|(path, _)| path.as_str()).collect();
    let wanted = ["README", "known", "manufacturer-21f4", "manufacturer-23e8", "manufacturer"];
    assert_eq!(names, wanted.map(|n| format!("docs/{n}.md")));
    assert!(files.iter().all(|(_, bytes)| bytes.len() < 400_000));
    assert!(page(&model, "manufacturer-21f4.md").contains("[21F4h](manufacturer-21f4.md#21f4)"));
}

#[test]
fn explain_knows_what_the_drive_shows() {
    let model = model(PROFILE.into());
    let told = |what: &str| explain(&model, what).unwrap_or_else(|| panic!("nothing of {what}"));
    for what in ["7305h", "0x7305", "7305"] {
        assert!(told(what).contains("Alarm EC: Encoder") && told(what).contains("Alarm Ec: Other"), "{what}");
    }
    says(&told("EC"), &["Acme X1", "A fault reset does not clear it.", "  1. Cable.", "  1. Mend it."]);
    assert!(!told("EC").contains("Other") && told("Ec").contains("Other"), "displays differ in case");
    for what in ["3000:04", "P1.04", "p1.04"] {
        assert!(told(what).contains("P1.04 Delay") && !told(what).contains("01 to 03"), "{what}");
    }
    assert!(told("3000:02").contains("02   Parameter"));
    assert!(told("6061h").contains("8      CSP"), "a terminal has no other page");
    says(
        &told("homing 1"),
        &["  1. Move fast (6099:01) in the negative direction until the negative limit switch goes on."],
    );
    says(&told("e007"), &["Printed: 60000 (in 1 L8)", "Used: 30000", "How sure: medium"]);
    says(&told("R1"), &["Rule R1: Not 0.", "- Must hold: 6081:00 > 0"]);
    assert!(told("mode 8").contains("6081:00") && told("06020000h").contains("No such object"));
    assert!(told("3000:02").ends_with("ᵃ assumed.\n") && !told("R1").contains("assumed"), "marks are told");
    for what in ["", "zz", "FFFFh", "homing 9", "3000:0A", "::", "homing x", "99999999999999999999"] {
        assert_eq!(explain(&model, what), None, "{what}");
    }
}
