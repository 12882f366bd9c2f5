//! Which alarm of a drive stands for what happens to it.

use crate::model::{AlarmDesc, DriveModel};

use super::words::holds;

/// Something that a drive reports as an alarm, if it has one for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Incident {
    /// The position is too far from where it should be.
    FollowingError,
    /// Too much torque for too long.
    Overload,
    /// The motor is faster than it may be.
    Overspeed,
    /// The main supply is missing while the drive is switched on.
    Undervoltage,
    /// No process data came in time.
    Watchdog,
    /// Homing takes too long.
    HomingTime,
    /// The mode of operation does not allow what is asked for.
    Mode,
    /// A command that the drive does not execute, such as a target too far away.
    Command,
    /// The EtherCAT state is changed while the drive is enabled.
    BusState,
}

/// Codes of 603Fh and a word of the name, which tells alarms of one code apart. The first row that an alarm has, counts.
/// Codes are of CiA 402 and, from 8100h on, also of makers.
const CODES: &[(Incident, u16, &str)] = &[
    (Incident::FollowingError, 0x8611, ""),
    (Incident::FollowingError, 0x8500, "following"),
    (Incident::Overload, 0x2350, ""),
    (Incident::Overload, 0x3230, "load"),
    (Incident::Overload, 0x2310, "load"),
    (Incident::Overload, 0x8311, ""),
    (Incident::Overspeed, 0x8400, "over speed"),
    (Incident::Overspeed, 0x8400, "overspeed"),
    (Incident::Overspeed, 0x7310, ""),
    (Incident::Undervoltage, 0x3220, ""),
    (Incident::Undervoltage, 0x3120, "main"),
    (Incident::Undervoltage, 0x3130, ""),
    (Incident::Watchdog, 0x8100, "watchdog"),
    (Incident::Watchdog, 0x8250, ""),
    (Incident::Watchdog, 0x7500, ""),
    (Incident::HomingTime, 0x8400, "homing"),
    (Incident::HomingTime, 0x8612, "homing"),
    (Incident::Mode, 0x8800, "mode"),
    (Incident::Command, 0x8802, "action"),
    (Incident::BusState, 0x8801, "esm"),
];

/// The alarm for an incident; `None` where the drive has none, and only bits tell.
pub(crate) fn alarm<'m>(model: &DriveModel<'m>, incident: Incident) -> Option<&'m AlarmDesc<'m>> {
    let rows = CODES.iter().filter(|(of, ..)| *of == incident);
    rows.flat_map(|(_, code, word)| model.alarms_by_code(*code).filter(|alarm| holds(alarm.name(), word)))
        .next()
}

#[cfg(test)]
mod tests {
    use super::super::samples::MODEL;
    use super::*;

    #[test]
    fn alarms_are_found_by_code_and_word() {
        let number = |incident| alarm(&MODEL, incident).map(AlarmDesc::number);
        assert_eq!(number(Incident::FollowingError), Some(0x25));
        assert_eq!(number(Incident::Watchdog), Some(0x33));
        assert_eq!(number(Incident::Overspeed), None);
    }
}
