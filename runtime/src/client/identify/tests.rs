//! Drives that are the one of a profile, and others.

use super::*;
use crate::client::message::Report;
use crate::client::testing::{at, Dictionary, Nonsense};
use crate::prelude::*;
use std::string::ToString;

const fn entry(index: u16, sub: u8, ty: DataType) -> ObjectDesc<'static> {
    ObjectDesc::new(at(index, sub), ty, Access::Ro, Mapping::Unmapped, "")
}

static OBJECTS: [ObjectDesc<'static>; 6] = [
    entry(0x1000, 0, DataType::UNSIGNED32).default_int(0x192),
    entry(0x1008, 0, DataType::VISIBLE_STRING),
    entry(0x1018, 1, DataType::UNSIGNED32),
    entry(0x1018, 2, DataType::UNSIGNED32),
    entry(0x1018, 3, DataType::UNSIGNED32),
    entry(0x1018, 4, DataType::UNSIGNED32),
];

fn model(revision: Option<u32>) -> DriveModel<'static> {
    let identity =
        Identity::new("acme-x3", "Acme", "X3").with_vendor_id(0x7E6).with_product_code(0x5344_5633);
    let identity = revision.map_or(identity, |revision| identity.with_revision(revision));
    DriveModel::new(identity).with_objects(&OBJECTS)
}

fn drive(vendor: u32, product: u32, revision: u32) -> Dictionary {
    Dictionary::default()
        .with(at(0x1000, 0), &0x0002_0192_u32.to_le_bytes())
        .with(at(0x1008, 0), b"ZeroErr Driver\0")
        .with(at(0x1018, 1), &vendor.to_le_bytes())
        .with(at(0x1018, 2), &product.to_le_bytes())
        .with(at(0x1018, 3), &revision.to_le_bytes())
        .with(at(0x1018, 4), &7_u32.to_le_bytes())
}

fn outcome(mut drive: Dictionary) -> ProfileMatch {
    let model = model(Some(0x0010_0010));
    drive.run(Identify::new(&model)).against(&model)
}

#[test]
fn b44_vendor_product_and_revision_tell_the_drive_not_its_name() {
    assert_eq!(outcome(drive(0x7E6, 0x5344_5633, 0x0010_0010)), ProfileMatch::Exact);
    assert!(matches!(outcome(drive(0x7E6, 0x5344_5633, 0x0010_0011)), ProfileMatch::Compatible(_)));
    for (vendor, product, revision) in
        [(1, 0x5344_5633, 0x0010_0010), (0x7E6, 1, 0x0010_0010), (0x7E6, 0x5344_5633, 0x0011_0010)]
    {
        assert!(matches!(outcome(drive(vendor, product, revision)), ProfileMatch::Mismatch(_)));
    }
}

#[test]
fn a_profile_that_does_not_state_the_revision_is_never_exact() {
    let model = model(None);
    let found = drive(0x7E6, 0x5344_5633, 1).run(Identify::new(&model));
    let ProfileMatch::Compatible(differences) = found.against(&model) else { panic!() };
    let texts: std::vec::Vec<_> = differences.iter().map(ToString::to_string).collect();
    assert_eq!(texts, ["device 00000001h, profile does not state it"]);
}

#[test]
fn another_drive_prints_both_sides() {
    let mut drive = drive(1, 0x5344_5633, 0x0010_0010).with(at(0x1018, 3), &[1]);
    drive.entries.remove(&at(0x1018, 2));
    let model = model(Some(0x0010_0010));
    let found = drive.run(Identify::new(&model));
    let verdict = Verdict::new(&model, &found);
    assert_eq!(
        Report::new(&verdict).to_string(),
        "\
error[IDENTITY]: the drive is not the one of profile acme-x3 (Acme X3)
  vendor : device 00000001h, profile 000007E6h
  product: device refuses [0609 0011: sub-index does not exist], profile 53445633h
  rev    : device gives 1 bytes where the type takes 4, profile 00100010h
  device : \"ZeroErr Driver\", hardware \"\", software \"\"
  serial : 00000007h
  do     : use the profile of this drive; if only the firmware differs, compare device and profile first"
    );
}

#[test]
fn a_device_of_another_device_profile_is_another_drive() {
    let drive = drive(0x7E6, 0x5344_5633, 0x0010_0010).with(at(0x1000, 0), &401_u32.to_le_bytes());
    let ProfileMatch::Mismatch(differences) = outcome(drive) else { panic!() };
    assert_eq!(differences.iter().map(|d| d.what).collect::<std::vec::Vec<_>>(), ["type"]);
}

#[test]
fn nonsense_is_never_exact_and_never_hangs() {
    let model = model(Some(0x0010_0010));
    for seed in 0..2_000 {
        let found = Nonsense::new(seed).run(&mut Identify::new(&model));
        let verdict = Verdict::new(&model, &found);
        assert_ne!(verdict.outcome(), ProfileMatch::Exact);
        assert!(!Report::new(&verdict).to_string().chars().any(|c| c.is_control() && c != '\n'));
    }
}
