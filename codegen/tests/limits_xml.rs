//! Hostile and oversized profiles in XML: each is refused with its own code, and in a moment, its findings printed included.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test measures that it does not hang")]

use std::fmt::Write;
use std::time::{Duration, Instant};

use drivewright_codegen::diag::render;
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, limits};

const DRIVE: &str = include_str!("fixtures/drive.toml");

/// As for profiles in TOML: not how fast it is, only that it ends.
const PATIENCE: Duration = Duration::from_secs(60);

/// The codes that a file of XML gives beside the drive, and whether they compile.
fn xml(text: &str) -> (Vec<&'static str>, bool) {
    let start = Instant::now();
    assert!(text.len() <= limits::FILE_BYTES, "the loader would refuse {} bytes", text.len());
    let file = |path: &str, text: &str| Source { path: path.into(), text: text.into() };
    let compiled = compile(vec![file("drive.toml", DRIVE), file("a.xml", text)]);
    let shown = render::text(&compiled.diagnostics, &compiled.sources, render::Style::default());
    assert!(shown.len() >= compiled.diagnostics.len());
    let mut codes: Vec<&str> = compiled.diagnostics.iter().map(|d| d.code.id()).collect();
    assert!(codes.len() <= limits::FINDINGS + 1);
    codes.sort_unstable();
    codes.dedup();
    assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
    (codes, compiled.sound().is_some())
}

fn xml_table(name: &str, rows: &str) -> String {
    format!("<profile><{name}>{rows}</{name}></profile>")
}

fn xml_object(rest: &str) -> String {
    let row = format!(r#"<row at="2000:00" name="Speed" type="u16" access="rw" src="1 L1"{rest}"#);
    xml_table("objects", &row)
}

#[test]
fn an_xml_file_is_sound_with_a_mark_and_without() {
    for text in [xml_object("/>"), format!("\u{FEFF}{}", xml_object("/>")), "<profile/>".to_owned()] {
        assert_eq!(xml(&text), (vec![], true), "{text}");
    }
    let declared = |rest: &str| xml(&format!("<?xml version=\"1.0\"{rest}?>{}", xml_object("/>")));
    for fine in ["", " encoding='utf-8'", " encoding=\"UTF-8\" standalone=\"no\""] {
        assert_eq!(declared(fine), (vec![], true), "{fine}");
    }
    assert_eq!(declared(" encoding=\"UTF-16\"").0, ["E0127"]);
    assert_eq!(xml(&format!("\u{FEFF}\u{FEFF}{}", xml_object("/>"))).0, ["E0121"]);
    for version in [
        "<?xml version=\"1.1\"?>",
        "<?xml?>",
        " <?xml version=\"1.0\"?>",
        "<?xml version=\"1.0\"?><?xml version=\"1.0\"?>",
    ] {
        assert_eq!(xml(&format!("{version}{}", xml_object("/>"))).0, ["E0121"], "{version}");
    }
}

#[test]
fn what_is_no_xml_is_refused() {
    for text in [
        "",
        "{}",
        "objects = []",
        "<",
        "<profile",
        "<profile>",
        "</profile>",
        "<profile></profil>",
        "<profile/><profile/>",
        "<profile><!-- a",
        "<profile><![CDATA[",
        "<profile><?a",
        "<profile a=\"",
        "<profile></profile",
        "<!",
        "<!DOCTYPE",
        "<!-->",
        "<profile><!-- -- --></profile>",
        "<profile><!-- ---></profile>",
        "<profile>\u{0}</profile>",
        "<profile>\u{FFFE}</profile>",
        "<profile>&amp;</profile>",
        "text<profile/>",
        "<profile/>text",
        "<profile a='1'/>",
        "<profile><1/></profile>",
    ] {
        let (codes, sound) = xml(text);
        assert!(!sound && !codes.is_empty(), "{text}: {codes:?}");
    }
    for rest in [
        " name=\"Torque\"/>",
        " a/>",
        " a=/>",
        " a=1/>",
        " min=\"1\"max=\"2\"/>",
        " note=\"a<b\"/>",
        " note=\"&\"/>",
        "/",
        "><row>",
        "></rwo>",
        "><note>]]></note></row>",
        "><src>1 L2</src></row>",
        "><note/><note/></row>",
    ] {
        let (codes, sound) = xml(&xml_object(rest));
        assert!(!sound && codes.contains(&"E0121"), "{rest}: {codes:?}");
    }
}

#[test]
fn a_broken_row_of_xml_does_not_hide_the_next() {
    let rows =
        "<row a=1/><row at=\"2000:00\" nmae=\"x\"/><row b></row><x/>text<row><at>1</row><row at=\"&x;\"/>";
    assert_eq!(xml(&xml_table("objects", rows)).0, ["E0103", "E0121", "E0123", "E0125"]);
}

#[test]
fn values_of_xml_are_what_their_keys_take() {
    let value = |rest: &str| xml(&xml_object(&format!(" {rest}/>"))).0;
    assert_eq!(value("max=\"0x10\" min=\"1_0\" default=\"0b1100\""), Vec::<&str>::new());
    for (rest, code) in [
        ("max=\"18446744073709551616\"", "E0107"),
        ("max=\"0xFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF\"", "E0107"),
        ("max=\"1.5\"", "E0114"),
        ("default=\"1e3\"", "E0114"),
        ("max=\"ten\"", "E0105"),
        ("max=\"\"", "E0105"),
        ("max=\" 1\"", "E0105"),
        ("max=\"007\"", "E0105"),
        ("allow=\"1\"", "E0125"),
        ("note=\"a&#10;b\"", "E0006"),
        ("note=\"a&#x202E;b\"", "E0006"),
        ("xml:lang=\"en\"", "E0124"),
    ] {
        assert_eq!(value(rest), [code], "{rest}");
    }
    let text = |kind: &str| xml(&xml_object(&format!("><max{kind}>100</max></row>"))).0;
    assert_eq!(text(""), Vec::<&str>::new());
    assert_eq!(text(" kind=\"number\""), Vec::<&str>::new());
    assert_eq!(text(" kind=\"text\""), ["E0105"]);
    assert_eq!(text(" kind=\"bool\""), ["E0106"]);
    assert_eq!(text(" kind=\"int\""), ["E0125"]);
    assert_eq!(text(" type=\"int\""), ["E0125"]);
}

#[test]
fn entities_are_not_expanded() {
    let mut text = String::from("<!DOCTYPE profile [<!ENTITY a0 \"aaaaaaaaaa\">");
    for n in 1..100 {
        let _ = write!(text, "<!ENTITY a{n} \"{}\">", format!("&a{};", n - 1).repeat(10));
    }
    text.push_str("<!ENTITY file SYSTEM \"file:///etc/passwd\">]>");
    text.push_str(&xml_object(" note=\"&a99;\" text=\"&file;\"/>"));
    assert_eq!(xml(&text).0, ["E0122", "E0123"]);
    let many = format!("<note>{}</note></row>", "&amp;".repeat(limits::FILE_BYTES / 5 - 50));
    assert_eq!(xml(&xml_object(&format!(">{many}"))).0, ["E0108"]);
}

#[test]
fn nesting_of_xml_does_not_overflow_the_stack() {
    let deep = limits::FILE_BYTES / 8;
    assert_eq!(
        xml(&format!("<profile>{}{}</profile>", "<a>".repeat(deep), "</a>".repeat(deep))).0,
        ["E0102", "E0125"]
    );
    assert!(xml(&format!("<profile>{}", "<a>".repeat(deep))).0.contains(&"E0121"));
    let items = format!("><allow>{}{}</allow></row>", "<item>".repeat(deep / 2), "</item>".repeat(deep / 2));
    assert_eq!(xml(&xml_object(&items)).0, ["E0118"]);
}

#[test]
fn rows_keys_and_tables_of_xml_are_bounded() {
    assert_eq!(xml(&xml_table("objects", &"<row/>".repeat(limits::ROWS + 1))).0, ["E0109"]);
    assert_eq!(xml(&xml_table("objects", &"<row/>".repeat(limits::ROWS))).0, ["E0007", "E0104"]);
    let keys = |n: usize| (0..n).map(|n| format!(" k{n}=\"1\"")).collect::<Vec<_>>().concat();
    assert_eq!(xml(&xml_object(&format!("{}/>", keys(20_000)))).0, ["E0120"]);
    assert_eq!(xml(&xml_object(&format!("{}/>", keys(limits::KEYS - 6)))).0, ["E0103"]);
    let elements = (0..20_000).map(|n| format!("<k{n}/>")).collect::<Vec<_>>().concat();
    assert_eq!(xml(&xml_object(&format!(">{elements}</row>"))).0, ["E0120"]);
    let tables = |n: usize| {
        format!("<profile>{}</profile>", (0..n).map(|n| format!("<a{n}/>")).collect::<Vec<_>>().concat())
    };
    assert_eq!(xml(&tables(600_000)).0, ["E0119"]);
    assert_eq!(xml(&tables(limits::TABLES)).0, ["E0102"]);
    let items = format!("><allow>{}</allow></row>", "<item>1</item>".repeat(limits::LIST_VALUES + 1));
    assert_eq!(xml(&xml_object(&items)).0, ["E0108"]);
}

#[test]
fn many_faults_of_xml_take_linear_time() {
    let rows = |row: &str| xml(&xml_table("objects", &row.repeat(limits::FILE_BYTES / 16 / row.len()))).0;
    for (row, code) in [
        ("<row a=1/>", "E0121"),
        ("<row a a a a a a a a/>", "E0121"),
        ("</x>", "E0121"),
        ("<x>", "E0125"),
        ("&", "E0125"),
        ("&x;", "E0125"),
        ("<?a?>", "E0126"),
        ("<!-- -- -->", "E0121"),
        ("<![CDATA[]]>", "E0125"),
        ("<a:b/>", "E0124"),
        ("\u{0}", "E0121"),
    ] {
        let found = rows(row);
        assert!(found.contains(&code), "{row}: {found:?}");
    }
    let tag = format!("{}/>", " a".repeat(limits::FILE_BYTES / 8));
    assert_eq!(xml(&xml_object(&tag)).0, ["E0007", "E0121"]);
    assert_eq!(
        xml(&xml_object(&format!(" note=\"{}\"/>", "&".repeat(limits::FILE_BYTES - 200)))).0,
        ["E0121"]
    );
}
