//! Bytes and losses against printed images and the tables of ETG.2010.

use super::*;
use crate::source::Source;

/// What the drive of every test has.
const HEAD: &str = r#"
manuals = [ { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 9 } ]
drive = { format = 1, id = "x1", vendor = "Acme", vendor_id = "acme", name = "X1", crate_version = "0.1.0", eds_version = 1, eds_revision = 0, date = "2026-01-01" }
"#;

fn model(rows: &str) -> Model {
    let compiled = crate::compile(vec![Source { path: "a.toml".into(), text: format!("{HEAD}{rows}") }]);
    assert!(compiled.sound().is_some(), "{:#?}", compiled.diagnostics);
    compiled.sound().unwrap().clone()
}

fn bytes(rows: &str) -> Vec<u8> {
    let model = model(rows);
    let device = Device::of(&model).unwrap();
    image(&model, &device).0.bytes()
}

#[test]
fn the_checksum_is_that_of_printed_images() {
    // The manual of another drive prints words 0 to 6 and their checksum D2h.
    let words: [u16; 7] = [0x0C08, 0x6608, 0x01F4, 0, 0, 0, 0];
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    assert_eq!(header::checksum(&bytes), 0xD2);
    // CRC-8 of nothing is where it starts.
    assert_eq!(header::checksum(&[]), 0xFF);
}

#[test]
fn words_are_where_etg_2010_has_them() {
    let bytes = bytes(
        r#"ethercat = [ { config = [0x0C08, 0x6608, 0x01F4, 0, 0, 0, 0], eeprom_bytes = 4096, src = "1 L2" } ]"#,
    );
    assert_eq!(bytes[..16], [8, 0x0C, 8, 0x66, 0xF4, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0xD2, 0]);
    // 4096 bytes are 32 KiBit, and the size is one less.
    assert_eq!(bytes[0x7C..0x80], [31, 0, 1, 0]);
    // The first mailbox lies at 1000h and has 128 bytes, and CoE is bit 2.
    assert_eq!(bytes[0x30..0x34], [0, 0x10, 128, 0]);
    assert_eq!(bytes[0x38..0x3A], [4, 0]);
    assert_eq!(bytes[0x80..0x82], [10, 0]);
    assert_eq!(bytes[bytes.len() - 2..], [0xFF, 0xFF]);
    assert_eq!(bytes.len() % 2, 0);
}

#[test]
fn a_text_is_there_once_and_255_are_there() {
    let mut strings = Strings::default();
    assert_eq!(strings.number("a"), (1, None));
    assert_eq!(strings.number("b"), (2, None));
    assert_eq!(strings.number("a"), (1, None));
    assert_eq!(strings.number("\0"), (0, Some(Loss::TextChanged)));
    assert_eq!(strings.number("é"), (3, Some(Loss::TextChanged)));
    for n in 4..=255 {
        assert_eq!(strings.number(&format!("text {n}")), (n, None));
    }
    assert_eq!(strings.number("one more"), (0, Some(Loss::TooManyTexts)));
    assert_eq!(strings.number("b"), (2, None));
    assert_eq!(Strings::default().number(&"x".repeat(256)).1, Some(Loss::TextChanged));
}

#[test]
fn the_listing_says_who_says_it() {
    let model =
        model(r#"sync_managers = [ { number = 0, use = "mailbox out", start = 0x1800, src = "1 L2" } ]"#);
    let device = Device::of(&model).unwrap();
    let (image, losses) = image(&model, &device);
    let text = listing::text(&model, &device, &image, &losses);
    let line = |what: &str| text.lines().find(|line| line.contains(what)).unwrap();
    for (what, source) in [
        ("Vendor id: 0x", "assumed"),
        ("PDI configuration: 0x", "assumed"),
        ("Checksum", "format"),
        ("Receive mailbox, start", "profile"),
        ("Receive mailbox, length", "assumed"),
        ("SyncManager 0, start: 0x1800", "profile"),
        ("SyncManager 0, control: 0x26", "assumed"),
    ] {
        assert!(line(what).contains(source), "{}", line(what));
    }
    assert!(text.contains("must never be written"));
    assert!(text.contains("The protocols of the mailbox are left out."));
}

#[test]
fn what_cannot_be_held_is_a_warning() {
    let model = model(
        r#"ethercat = [ { eeprom_bytes = 100, src = "1 L2" } ]
sync_managers = [ { number = 2, use = "outputs", size = 0, enable = true, src = "1 L2" } ]"#,
    );
    let device = Device::of(&model).unwrap();
    let (image, losses) = image(&model, &device);
    let found: Vec<String> = losses.sentences().collect();
    for says in ["an active SyncManager", "the size of the EEPROM", "longer than the EEPROM"] {
        assert!(found.iter().any(|f| f.to_lowercase().contains(&says.to_lowercase())), "{says}: {found:#?}");
    }
    let bytes = image.bytes();
    assert_eq!(bytes[0x7C..0x7E], [0, 0]);
}
