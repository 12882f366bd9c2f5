//! Every alarm: the call under way fails with its code, the fault is explained, and it is reset if it can be.

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::{AxisErrorKind, SetPoint};
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::model::Reset;
use savch_sdv3_e::MODEL;
use savch_sdv3_e::alarms::ALARM_TEXTS;

use crate::{LONG, TURN, cycles, drive, kind};

#[test]
fn every_alarm_ends_what_is_under_way() {
    for alarm in MODEL.alarms() {
        let mut drive = drive();
        let what = alarm.display();
        drive.enable(Mode::PROFILE_POSITION).unwrap();
        drive.client_mut().axis_mut().move_to(SetPoint::to(TURN), LONG);
        cycles(&mut drive, 20);
        drive.bus().drive().raise(alarm.display(), alarm.number()).unwrap();
        let ended = (0..10).find_map(|_| drive.cycle().err());
        assert!(ended.is_some(), "{what} is seen within ten cycles");
        let code = Some(alarm.code());
        // The code is not mapped: it comes by SDO in the cycle in which the fault is seen.
        let Some(DriveError::Client(ClientError::Axis(error))) = ended else { panic!("{ended:?}") };
        assert_eq!(error.kind, AxisErrorKind::Faulted { code }, "{what}");
        assert_eq!(kind(drive.enable(Mode::PROFILE_POSITION)), AxisErrorKind::Faulted { code }, "{what}");
        let fault = drive.fault(&ALARM_TEXTS).unwrap().unwrap();
        assert!(fault.alarms().any(|of_code| of_code == alarm), "{what}");
        assert!(fault.to_string().contains(&format!("{:04X}h", alarm.code())), "{fault}");
    }
}

#[test]
fn every_alarm_is_reset_if_it_can_be() {
    for alarm in MODEL.alarms() {
        let mut drive = drive();
        let (what, code) = (alarm.display(), alarm.code());
        drive.bus().drive().raise(alarm.display(), alarm.number()).unwrap();
        cycles(&mut drive, 10);
        let result = drive.reset_fault();
        let shared = MODEL.alarms_by_code(code).any(|other| other.reset() == Reset::Resettable);
        match (alarm.reset() == Reset::Resettable, shared) {
            (true, _) => {
                result.unwrap_or_else(|error| panic!("{what}: {error}"));
                assert_eq!(drive.bus().drive().state(), State::SwitchOnDisabled, "{what}");
            }
            // One with the same code can be: it is tried, and verified.
            (false, true) => {
                assert_eq!(kind(result), AxisErrorKind::StillFaulted { code: Some(code) }, "{what}");
            }
            (false, false) => {
                assert_eq!(result, Err(DriveError::Client(ClientError::NotResettable { code })), "{what}");
            }
        }
        drive.quick_stop().unwrap();
        drive.disable().unwrap();
    }
}

#[test]
fn a_cause_that_stays_is_told() {
    let mut drive = drive();
    drive.bus().drive().raise_for_good("OF", 0x25).unwrap();
    cycles(&mut drive, 10);
    let kind = kind(drive.reset_fault());
    assert_eq!(kind, AxisErrorKind::StillFaulted { code: Some(0x8611) });
    drive.bus().drive().end_cause("OF", 0x25).unwrap();
    drive.reset_fault().unwrap();
    drive.enable(Mode::PROFILE_VELOCITY).unwrap();
}
