//! Reports as they print.

use super::*;
use std::format;
use std::string::ToString;

/// F1, with every part.
struct Layout;

impl Explain for Layout {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("LAYOUT")
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("TxPDO 1A00h is not the profile's layout")
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        lines.line("profile", "6077:00 16 bit")?;
        lines.line("device", format_args!("6077:00 {} bit", 32))?;
        lines.line("step", "")
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("first\n")?;
        f.write_str("second")
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("this, or\nthat")
    }

    fn source(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("profile acme-x3")
    }
}

/// Only what every message has.
struct Bare;

impl Explain for Bare {
    fn severity(&self) -> Severity {
        Severity::Fault
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("OF")
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("following error")
    }
}

#[test]
fn parts_stand_below_one_another_and_empty_ones_do_not_show() {
    let expected = "\
error[LAYOUT]: TxPDO 1A00h is not the profile's layout
  profile: 6077:00 16 bit
  device : 6077:00 32 bit
  why    : first
           second
  do     : this, or
           that
  source : profile acme-x3";
    assert_eq!(Report::new(&Layout).to_string(), expected);
    assert_eq!(Report::new(&Bare).to_string(), "FAULT[OF]: following error");
}

#[test]
fn one_line_has_no_line_break() {
    let line = format!("{:#}", Report::new(&Layout));
    assert_eq!(line, "error[LAYOUT]: TxPDO 1A00h is not the profile's layout; do: this, or that");
    assert_eq!(format!("{:#}", Report::new(&Bare)), "FAULT[OF]: following error");
}

#[test]
fn the_caller_may_know_the_source_better() {
    let text = Report::new(&Layout).from("manual p.188").to_string();
    assert!(text.ends_with("\n  source : manual p.188") && !text.contains("acme"), "{text}");
    let dynamic: &dyn Explain = &Bare;
    assert!(Report::new(dynamic).from("x").to_string().ends_with("following error\n  source : x"));
}

#[test]
fn text_of_a_drive_does_nothing_to_a_terminal() {
    for bytes in [&b"\x1B]0;x\x07"[..], b"\xC2\x9B31m", "\u{202E}txt".as_bytes(), b"a\nb\r"] {
        let shown = Clean(bytes).to_string();
        assert!(!shown.chars().any(|c| c.is_control() || c == '\u{202E}'), "{shown}");
    }
    assert_eq!(format!("{:?}", Clean(b"")), "\"\"");
}
