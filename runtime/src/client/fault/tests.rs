//! Faults of a drive that is a map of entries.

use super::*;
use crate::client::testing::{at, Dictionary, Nonsense};
use crate::prelude::*;
use crate::transport::Refusal;
use std::string::ToString;

static ALARMS: [AlarmDesc<'static>; 3] = [
    AlarmDesc::new("OF", 0x25, 0x8611, "Following error").with_aux(0x8005).with_reset(Reset::Resettable),
    AlarmDesc::new("oSt", 0x26, 0x8611, "Jammed").with_aux(0x0005).with_reset(Reset::PowerCycle),
    AlarmDesc::new("EC", 0x10, 0x7305, "Encoder"),
];
static TEXTS: [AlarmText<'static>; 1] = [AlarmText::new("oSt", 0x26, &["A"], &["B", "C\x1B"])];
static EMCY: [EmcyDesc; 2] =
    [EmcyDesc::new(3, 1, EmcyContent::ErrorNumber), EmcyDesc::new(4, 2, EmcyContent::AuxiliaryCode)];
static OBJECTS: [ObjectDesc<'static>; 4] = [
    ObjectDesc::new(at(0x1001, 0), DataType::UNSIGNED8, Access::Ro, Mapping::Tx, ""),
    ObjectDesc::new(at(0x603F, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, ""),
    ObjectDesc::new(at(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, ""),
    ObjectDesc::new(at(0x6061, 0), DataType::INTEGER8, Access::Ro, Mapping::Tx, ""),
];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("x3", "Acme", "X3"))
    .with_objects(&OBJECTS)
    .with_alarms(&ALARMS)
    .with_emcy(&EMCY);

fn drive() -> Dictionary {
    Dictionary::default()
        .with(at(0x1001, 0), &[0x21])
        .with(at(0x603F, 0), &[0x11, 0x86])
        .with(at(0x6041, 0), &[0x38, 0x02])
        .with(at(0x6061, 0), &[8])
}

fn fault(drive: &mut Dictionary, message: Option<[u8; 8]>) -> Fault<'static> {
    let read = ReadFault::new(&MODEL);
    let read = message.map_or(read, |message| read.with_emergency(Emergency(message)));
    Fault::new(&MODEL, &TEXTS, drive.run(read).unwrap())
}

#[test]
fn the_emergency_message_tells_alarms_with_one_code_apart() {
    let fault = fault(&mut drive(), Some([0x11, 0x86, 0x21, 0x26, 0x05, 0x00, 0, 0]));
    assert_eq!(
        fault.to_string(),
        "\
FAULT[oSt]: Jammed [603Fh 8611h, alarm 26h, EMCY 8611h, aux 0005h, 1001h 21h, 6041h 0238h]
  kind   : generic, device profile [21h]
  mode   : cyclic synchronous position
  causes : A
  reset  : by switching the control supply off and on; do not repeat fault resets
  do     : 1 B
           2 C\\x1b"
    );
}

#[test]
fn without_it_all_alarms_with_the_code_are_named() {
    let fault = fault(&mut drive(), None);
    assert_eq!((fault.alarm(), fault.alarms().count()), (None, 2));
    let text = fault.to_string();
    assert!(
        text.starts_with(
            "FAULT[8611h]: one of 2 alarms that share this code [603Fh 8611h, 1001h 21h, 6041h 0238h]
  maybe  : OF 25h Following error
           oSt 26h Jammed\n"
        ),
        "{text}"
    );
}

#[test]
fn a_message_about_something_else_is_no_evidence() {
    let reset = fault(&mut drive(), Some([0; 8]));
    assert_eq!((reset.is_active(), reset.alarms().count()), (Some(true), 2));
    let other = fault(&mut drive(), Some([0x05, 0x73, 0x21, 0x26, 0x05, 0x00, 0, 0]));
    assert_eq!(other.alarms().count(), 2, "the number belongs to the code of the message");
    let contradicting = fault(&mut drive(), Some([0x11, 0x86, 0, 0x77, 0, 0, 0, 0]));
    assert_eq!(contradicting.alarms().count(), 2, "a number that no alarm has");
}

#[test]
fn codes_that_the_profile_lacks_have_a_class() {
    let text = fault(&mut drive().with(at(0x603F, 0), &[0x10, 0x43]), None).to_string();
    assert!(
        text.starts_with("FAULT[4310h]: temperature of the device, a code that the profile does not list ["),
        "{text}"
    );
    let text = fault(&mut drive().with(at(0x603F, 0), &[0, 0]), None).to_string();
    assert!(text.starts_with("FAULT[ALARM]: the drive reports no error code [603Fh 0000h, "), "{text}");
}

#[test]
fn a_fault_that_is_over_is_none() {
    let over = fault(&mut drive().with(at(0x6041, 0), &[0x50, 0x02]), None);
    assert_eq!((over.is_active(), over.severity()), (Some(false), Severity::Note));
    assert!(over.to_string().starts_with("note[8611h]: not in fault now; the last one: one of 2"));
    let warning = fault(&mut drive().with(at(0x6041, 0), &[0xB7, 0x02]), None);
    assert_eq!(warning.severity(), Severity::Warning);
}

#[test]
fn a_drive_that_says_nothing_is_an_error() {
    let mut drive = drive();
    for object in &OBJECTS {
        drive.reads.insert(object.address(), Refusal::NoAnswer);
    }
    assert_eq!(drive.run(ReadFault::new(&MODEL)).unwrap_err().cause, Cause::NoAnswer);
}

#[test]
fn nonsense_is_a_report_or_an_error() {
    for seed in 0..2_000_u32 {
        let mut drive = Nonsense::new(seed.into());
        let message = u64::from(seed).wrapping_mul(0x9E37_79B9_7F4A_7C15).to_le_bytes();
        let mut read = ReadFault::new(&MODEL).with_emergency(Emergency(message));
        if let Ok(evidence) = drive.run(&mut read) {
            let text = Fault::new(&MODEL, &TEXTS, evidence).to_string();
            assert!(!text.contains('\u{1B}'));
        }
    }
}
