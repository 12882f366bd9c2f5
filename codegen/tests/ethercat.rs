//! What ESI and SII share: values of the profile where it has them, and assumed ones by their rules where it has none.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::backend::ethercat::{Device, Manager};
use drivewright_codegen::compile;
use drivewright_codegen::model::{CoeFeature, FmmuUse, MailboxProtocol, Model, SyncManagerUse};
use drivewright_codegen::source::Source;

const DRIVE: &str = include_str!("fixtures/drive.toml");

fn model(tables: &str) -> Model {
    let text = format!("{tables}\n{DRIVE}");
    let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
    assert!(compiled.sound().is_some(), "{:#?}", compiled.diagnostics);
    compiled.model.unwrap()
}

fn assumed(device: &Device<'_>) -> Vec<String> {
    device.assumed.iter().map(|a| format!("{} = {}", a.what, a.value)).collect()
}

const OBJECTS: &str = r#"
objects = [
  { at = "1000:00", name = "Type", type = "u32", access = "ro", default = 0, src = "1 L1" },
  { at = "1001:00", name = "Error", type = "u8", access = "ro", src = "1 L1" },
  { at = "1018:00", name = "Count", type = "u8", access = "ro", default = 1, rename = "Identity count", src = "1 L1" },
  { at = "1018:01", name = "Vendor", type = "u32", access = "ro", default = 0x7E6, src = "1 L1" },
  { at = "1600:00", name = "Count", type = "u8", access = "rw", default = 1, src = "1 L1" },
  { at = "1600:01", name = "Entry", type = "u32", access = "rw", default = 0x20000010, src = "1 L1" },
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "rx tx", src = "1 L1" },
  { at = "2001:00", name = "Place", type = "u32", access = "ro", pdo = "tx", src = "1 L1" },
]
pdo = [
  { map = 0x1600, dir = "rx", pos = 1, entry = "2000:00", bits = 16, src = "1 L1" },
  { map = 0x1A00, dir = "tx", pos = 1, entry = "2000:00", bits = 16, src = "1 L1" },
  { map = 0x1A00, dir = "tx", pos = 2, entry = "2001:00", bits = 32, src = "1 L1" },
  { map = 0x1A01, dir = "tx", pos = 1, entry = "2001:00", bits = 32, src = "1 L1" },
]
"#;

#[test]
fn a_drive_without_a_word_of_ethercat_has_none() {
    assert_eq!(Device::of(&model(OBJECTS)), None);
}

#[test]
fn what_nobody_states_follows_rules_and_is_listed() {
    let model = model(&format!("{OBJECTS}\nfmmus = [ {{ number = 0, use = \"inputs\", src = \"1 L1\" }} ]"));
    let device = Device::of(&model).unwrap();
    // 1000h + 80h + 80h; then three buffers of 2 bytes, rounded up to the next 80h.
    let starts: Vec<u16> = device.managers.iter().map(|m| m.start).collect();
    assert_eq!(starts, [0x1000, 0x1080, 0x1100, 0x1180]);
    let sizes: Vec<u16> = device.managers.iter().map(|m| m.size).collect();
    assert_eq!(sizes, [128, 128, 2, 6]);
    let controls: Vec<u8> = device.managers.iter().map(|m| m.control).collect();
    assert_eq!(controls, [0x26, 0x22, 0x64, 0x20]);
    assert_eq!(device.fmmus, [FmmuUse::Inputs]);
    assert_eq!(device.mailbox, [MailboxProtocol::Coe]);
    assert_eq!(device.identity, [0x7E6, 0, 0, 0]);
    // The mapping object can be written, the assignment has none.
    assert_eq!(device.coe, [CoeFeature::PdoConfiguration]);
    let fixed: Vec<bool> = device.pdos.iter().map(|p| p.fixed).collect();
    assert_eq!(fixed, [false, true, true]);
    let active: Vec<bool> = device.pdos.iter().map(|p| p.assigned).collect();
    assert_eq!(active, [true, true, false]);
    let assumed = assumed(&device);
    for line in [
        "Product code = 0",
        "Active TxPDO = 1A00h",
        "SyncManager 3, start = 1180h",
        "CoE, complete access = no",
    ] {
        assert!(assumed.iter().any(|a| a == line), "{line}: {assumed:#?}");
    }
    assert!(!assumed.iter().any(|a| a.starts_with("Vendor id") || a.starts_with("FMMU")), "{assumed:#?}");
}

#[test]
fn stated_values_are_taken_and_not_listed() {
    let tables = r#"
ethercat = [ { type = "X1-E", group = "Servos", physics = "YY", mailbox = ["coe", "foe"], config = [0xC08, 0x6608, 0x1F4, 0, 0, 0, 0], bootstrap = [0x1000, 0x80, 0x1400, 0x80], eeprom_bytes = 4096, src = "1 L1" } ]
sync_managers = [
  { number = 0, use = "mailbox out", start = 0x1000, size = 128, control = 0x26, enable = true, src = "1 L1" },
  { number = 1, use = "mailbox in", start = 0x1400, size = 128, control = 0x22, enable = true, src = "1 L1" },
  { number = 2, use = "outputs", src = "1 L1" },
]
"#;
    let model = model(tables);
    let device = Device::of(&model).unwrap();
    assert_eq!((device.product_type, device.group, device.eeprom_bytes), ("X1-E", "Servos", 4096));
    assert_eq!(device.config[..3], [0x0C08, 0x6608, 0x01F4]);
    assert_eq!(device.bootstrap, [0x1000, 0x80, 0x1400, 0x80]);
    // Behind the highest stated mailbox, and not active, since nothing is mapped.
    let outputs: &Manager = device.manager(SyncManagerUse::Outputs).unwrap();
    assert_eq!((outputs.start, outputs.size, outputs.enable), (0x1480, 0, false));
    let of_mailbox = |a: &String| a.contains("SyncManager 0") || a.contains("SyncManager 1");
    assert!(!assumed(&device).iter().any(of_mailbox));
}

#[test]
fn one_pdo_at_a_time_excludes_the_others() {
    let limits = "pdos_per_direction = 1\npdo_bytes = 32\npdo_src = \"1 L1\"\ndate";
    let coe = "coe = [ { feature = \"pdo upload\", supported = true, src = \"1 L1\" } ]";
    let text = format!("{coe}\n{OBJECTS}\n{}", DRIVE.replacen("date", limits, 1));
    let compiled = compile(vec![Source { path: "drive.toml".into(), text }]);
    let mut limited = compiled.sound().cloned().unwrap();
    let device = Device::of(&limited).unwrap();
    let excludes: Vec<&[u16]> = device.pdos.iter().map(|p| p.excludes.as_slice()).collect();
    assert_eq!(excludes, [&[][..], &[0x1A01], &[0x1A00]]);
    // 1100h and three buffers of 32 bytes.
    assert_eq!(device.managers[3].start, 0x1180);
    assert_eq!(device.managers[2].max_size, Some(32));
    assert!(device.can(CoeFeature::PdoUpload));
    limited.drive.limits.pdos_per_direction = None;
    let device = Device::of(&limited).unwrap();
    assert!(device.pdos.iter().all(|p| p.excludes.is_empty()));
}
