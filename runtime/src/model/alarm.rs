//! Faults and warnings.

use super::detection::{EsmAfter, EsmState, Led, SyncMode};

/// How an alarm is cleared.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Reset {
    /// The manual does not say.
    NotStated,
    /// By a fault reset, once the cause is gone.
    Resettable,
    /// Not by a fault reset; the manual does not say by what.
    NotResettable,
    /// By switching the control supply off and on.
    PowerCycle,
}

/// A fault or a warning.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AlarmDesc<'m> {
    display: &'m str,
    name: &'m str,
    number: u16,
    code: u16,
    aux: u16,
    has_aux: bool,
    reset: Reset,
}

impl<'m> AlarmDesc<'m> {
    /// An alarm: what the panel shows, the maker's number, the code in 603Fh and in the emergency message, and a name
    /// in words.
    pub const fn new(display: &'m str, number: u16, code: u16, name: &'m str) -> Self {
        Self { display, name, number, code, aux: 0, has_aux: false, reset: Reset::NotStated }
    }

    /// With the auxiliary code of the emergency message.
    #[must_use]
    pub const fn with_aux(mut self, aux: u16) -> Self {
        self.aux = aux;
        self.has_aux = true;
        self
    }

    /// With the way it is cleared.
    #[must_use]
    pub const fn with_reset(mut self, reset: Reset) -> Self {
        self.reset = reset;
        self
    }

    /// What the panel shows; one display may stand for several numbers.
    pub const fn display(&self) -> &'m str {
        self.display
    }

    /// The maker's number.
    pub const fn number(&self) -> u16 {
        self.number
    }

    /// The code in 603Fh and in the emergency message. Not a key: alarms share codes.
    pub const fn code(&self) -> u16 {
        self.code
    }

    /// The auxiliary code of the emergency message; `None` where none is stated.
    pub const fn aux(&self) -> Option<u16> {
        if self.has_aux {
            Some(self.aux)
        } else {
            None
        }
    }

    /// Its name, in words.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// How it is cleared.
    pub const fn reset(&self) -> Reset {
        self.reset
    }

    /// Whether this is its key.
    pub fn is(&self, display: &str, number: u16) -> bool {
        self.number == number && self.display == display
    }
}

/// The alarms of `table` that report `code` in 603Fh.
pub fn alarms_by_code<'t, 'm>(
    table: &'t [AlarmDesc<'m>],
    code: u16,
) -> impl Iterator<Item = &'t AlarmDesc<'m>> {
    table.iter().filter(move |a| a.code == code)
}

/// Causes and remedies of an alarm, and how it shows on EtherCAT. A table of its own, which no [`DriveModel`](super::DriveModel) refers to: a program
/// that does not name it does not carry it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AlarmText<'m> {
    display: &'m str,
    number: u16,
    causes: &'m [&'m str],
    remedies: &'m [&'m str],
    esm: &'m [EsmState],
    esm_after: Option<EsmAfter>,
    sync: Option<SyncMode>,
    al_status: Option<u16>,
    led: Option<Led>,
}

impl<'m> AlarmText<'m> {
    /// Causes and remedies of the alarm with this display and number.
    pub const fn new(display: &'m str, number: u16, causes: &'m [&'m str], remedies: &'m [&'m str]) -> Self {
        Self {
            display,
            number,
            causes,
            remedies,
            esm: &[],
            esm_after: None,
            sync: None,
            al_status: None,
            led: None,
        }
    }

    /// With the states of the EtherCAT state machine in which it is detected.
    #[must_use]
    pub const fn with_esm(mut self, esm: &'m [EsmState]) -> Self {
        self.esm = esm;
        self
    }

    /// With the state of the EtherCAT state machine after it.
    #[must_use]
    pub const fn with_esm_after(mut self, esm_after: EsmAfter) -> Self {
        self.esm_after = Some(esm_after);
        self
    }

    /// With the synchronization in which it is detected.
    #[must_use]
    pub const fn with_sync(mut self, sync: SyncMode) -> Self {
        self.sync = Some(sync);
        self
    }

    /// With the AL status code that it sets.
    #[must_use]
    pub const fn with_al_status(mut self, al_status: u16) -> Self {
        self.al_status = Some(al_status);
        self
    }

    /// With what the error indicator shows.
    #[must_use]
    pub const fn with_led(mut self, led: Led) -> Self {
        self.led = Some(led);
        self
    }

    /// What can have caused it.
    pub const fn causes(&self) -> &'m [&'m str] {
        self.causes
    }

    /// What to do about it.
    pub const fn remedies(&self) -> &'m [&'m str] {
        self.remedies
    }

    /// States of the EtherCAT state machine in which it is detected; none where the manual does not say.
    pub const fn esm(&self) -> &'m [EsmState] {
        self.esm
    }

    /// State of the EtherCAT state machine after it; `None` where the manual does not say.
    pub const fn esm_after(&self) -> Option<EsmAfter> {
        self.esm_after
    }

    /// Synchronization in which it is detected; `None` where the manual does not say.
    pub const fn sync(&self) -> Option<SyncMode> {
        self.sync
    }

    /// AL status code that it sets; `None` where the manual does not say.
    pub const fn al_status(&self) -> Option<u16> {
        self.al_status
    }

    /// What the error indicator shows; `None` where the manual does not say.
    pub const fn led(&self) -> Option<Led> {
        self.led
    }

    /// The row of `table` for `alarm`; `None` where the manual says nothing of all this.
    pub fn find<'t>(table: &'t [Self], alarm: &AlarmDesc<'_>) -> Option<&'t Self> {
        table.iter().find(|t| alarm.is(t.display, t.number))
    }
}
