//! A fault as a person reads it: which alarm, its causes, what to do, and how it is reset.
//!
//! Makers share error codes between alarms. The emergency message tells them apart where it carries the maker's number or
//! auxiliary code; otherwise every alarm with the code is named.

use core::fmt;

use crate::address::Address;
use crate::cia402::{Mode, State, Statusword};
use crate::client::decode::ErrorRegister;
use crate::client::message::{displays, list, Clean, Explain, Lines, Severity};
use crate::client::object::{received, AccessError, Action, Cause};
use crate::client::tally::count;
use crate::model::{AlarmDesc, AlarmText, DriveModel, EmcyContent, Reset};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::Fixed;

/// An emergency message.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Emergency(pub [u8; 8]);

impl Emergency {
    /// What the message holds of this kind; `None` where the profile does not say that it does. Error code and register are
    /// where CiA 301 has them, unless the profile says otherwise.
    pub fn part(self, model: &DriveModel<'_>, content: EmcyContent) -> Option<u16> {
        let row = model.emcy().iter().find(|row| row.holds() == content);
        let (byte, bytes) = match (row, content) {
            (Some(row), _) => (row.byte(), row.bytes()),
            (None, EmcyContent::ErrorCode) => (0, 2),
            (None, EmcyContent::ErrorRegister) => (2, 1),
            (None, _) => return None,
        };
        let from = usize::from(byte);
        let part = self.0.get(from..from.saturating_add(bytes.into()))?;
        match *part {
            [low] => Some(low.into()),
            [low, high] => Some(u16::from_le_bytes([low, high])),
            _ => None,
        }
    }
}

/// What is known about a fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Evidence {
    /// The statusword, 6041h.
    pub statusword: Option<Statusword>,
    /// The error code, 603Fh. It may be that of an earlier fault.
    pub code: Option<u16>,
    /// The error register, 1001h.
    pub register: Option<ErrorRegister>,
    /// The mode that is in effect, 6061h.
    pub mode: Option<Mode>,
    /// The last emergency message, which a transport may have received.
    pub emergency: Option<Emergency>,
}

const ENTRIES: [Address; 4] =
    [Address::new(0x6041, 0), Address::new(0x603F, 0), Address::new(0x1001, 0), Address::new(0x6061, 0)];

/// Reads what a drive says about its fault, as far as the profile has the entries.
#[derive(Clone, Copy, Debug)]
pub struct ReadFault<'m> {
    model: &'m DriveModel<'m>,
    place: usize,
    asked: Option<Address>,
    evidence: Evidence,
    error: Option<AccessError>,
}

impl<'m> ReadFault<'m> {
    /// The read from the drive of `model`.
    pub fn new(model: &'m DriveModel<'m>) -> Self {
        Self { model, place: 0, asked: None, evidence: Evidence::default(), error: None }
    }

    /// With an emergency message that was received.
    #[must_use]
    pub const fn with_emergency(mut self, emergency: Emergency) -> Self {
        self.evidence.emergency = Some(emergency);
        self
    }

    fn take(&mut self, address: Address, answer: Answer<'_>) -> Result<(), AccessError> {
        let evidence = &mut self.evidence;
        match address.index() {
            0x6041 => evidence.statusword = Some(Statusword(number(address, answer)?)),
            0x603F => evidence.code = Some(number(address, answer)?),
            0x1001 => evidence.register = Some(ErrorRegister(number(address, answer)?)),
            _ => evidence.mode = Some(Mode(number(address, answer)?)),
        }
        Ok(())
    }

    fn over(&self) -> Result<Evidence, AccessError> {
        let Evidence { statusword, code, register, .. } = self.evidence;
        let nothing = statusword.is_none() && code.is_none() && register.is_none();
        match self.error {
            Some(error) if nothing => Err(error),
            _ => Ok(self.evidence),
        }
    }
}

fn number<T: Fixed>(address: Address, answer: Answer<'_>) -> Result<T, AccessError> {
    let wire = |error| AccessError { address, action: Action::Read, cause: Cause::Wire(error) };
    received(address, answer).and_then(|bytes| T::decode(bytes).map_err(wire))
}

impl Procedure for ReadFault<'_> {
    /// [`Err`] where nothing at all could be read.
    type Output = Result<Evidence, AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let Some(address) = self.asked.take() {
            if let Err(error) = self.take(address, answer) {
                self.error = Some(error);
            }
        }
        while let Some(address) = ENTRIES.get(self.place) {
            self.place = self.place.saturating_add(1);
            if self.model.object(*address).is_some_and(|object| object.access().reads()) {
                self.asked = Some(*address);
                return Ask::Upload(*address);
            }
        }
        Ask::Done(self.over())
    }
}

/// A fault, with what the profile knows about it.
///
/// ```
/// use drivewright_runtime::cia402::Statusword;
/// use drivewright_runtime::client::fault::{Evidence, Fault};
/// use drivewright_runtime::prelude::*;
///
/// static ALARMS: [AlarmDesc<'static>; 1] =
///     [AlarmDesc::new("OF", 0x25, 0x8611, "following error exceeded").with_reset(Reset::Resettable)];
/// static TEXTS: [AlarmText<'static>; 1] =
///     [AlarmText::new("OF", 0x25, &["The axis is jammed", "The gain is too low"], &["Free the axis"])];
/// let model = DriveModel::new(Identity::new("acme-x3", "Acme", "X3")).with_alarms(&ALARMS);
///
/// let evidence = Evidence { statusword: Some(Statusword(0x0238)), code: Some(0x8611), ..Evidence::default() };
/// assert_eq!(Fault::new(&model, &TEXTS, evidence).to_string(), "\
/// FAULT[OF]: following error exceeded [603Fh 8611h, alarm 25h, 6041h 0238h]
///   causes : 1 The axis is jammed
///            2 The gain is too low
///   reset  : by a fault reset, once the cause is gone
///   do     : Free the axis");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Fault<'m> {
    model: &'m DriveModel<'m>,
    texts: &'m [AlarmText<'m>],
    evidence: Evidence,
}

impl<'m> Fault<'m> {
    /// The fault that the evidence shows. `texts` are causes and remedies; empty where they are not at hand.
    pub const fn new(model: &'m DriveModel<'m>, texts: &'m [AlarmText<'m>], evidence: Evidence) -> Self {
        Self { model, texts, evidence }
    }

    /// With the texts of the alarms: causes and remedies. They are a table of their own, so that a program without them does
    /// not carry them.
    #[must_use]
    pub const fn with_texts(self, texts: &'m [AlarmText<'m>]) -> Self {
        Self { texts, ..self }
    }

    /// What is known about it.
    pub const fn evidence(&self) -> Evidence {
        self.evidence
    }

    /// Whether the drive is in fault now; `None` where the statusword is not known.
    pub fn is_active(&self) -> Option<bool> {
        let state = self.evidence.statusword?.state();
        Some(matches!(state, Some(State::Fault | State::FaultReactionActive)))
    }

    /// The error code: of 603Fh, otherwise of the emergency message; `None` for none and for 0.
    pub fn code(&self) -> Option<u16> {
        let message = self.message(EmcyContent::ErrorCode);
        self.evidence.code.filter(|code| *code != 0).or(message).filter(|code| *code != 0)
    }

    fn message(&self, content: EmcyContent) -> Option<u16> {
        self.evidence.emergency?.part(self.model, content)
    }

    /// What tells an alarm from others with its code. A message about another code says nothing about this one.
    fn same(&self, alarm: &AlarmDesc<'_>) -> bool {
        let told = self.message(EmcyContent::ErrorCode) == self.code();
        let number = self.message(EmcyContent::ErrorNumber).filter(|_| told);
        let aux = self.message(EmcyContent::AuxiliaryCode).filter(|_| told);
        number.map_or(true, |number| number == alarm.number())
            && aux.map_or(true, |aux| alarm.aux().map_or(true, |stated| stated == aux))
    }

    /// The alarms that it may be: those with the code, and with what the emergency message tells of them. If that fits none,
    /// all with the code.
    pub fn alarms(&self) -> impl Iterator<Item = &'m AlarmDesc<'m>> + '_ {
        let code = self.code();
        let with_code = move || self.model.alarms().iter().filter(move |alarm| Some(alarm.code()) == code);
        let any = with_code().any(|alarm| self.same(alarm));
        with_code().filter(move |alarm| !any || self.same(alarm))
    }

    /// The alarm; `None` where it is not known, or may be one of several.
    pub fn alarm(&self) -> Option<&'m AlarmDesc<'m>> {
        let mut alarms = self.alarms();
        let first = alarms.next()?;
        alarms.next().is_none().then_some(first)
    }

    fn text(&self) -> Option<&'m AlarmText<'m>> {
        AlarmText::find(self.texts, self.alarm()?)
    }

    fn raw(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Evidence { statusword, code, register, .. } = self.evidence;
        let mut gap = " [";
        let mut put = |label: &str, value: Option<u16>, digits: usize| match value {
            None => Ok(()),
            Some(value) => {
                let result = write!(f, "{gap}{label} {value:0digits$X}h");
                gap = ", ";
                result
            }
        };
        put("603Fh", code, 4)?;
        put("alarm", self.alarm().map(AlarmDesc::number), 2)?;
        put("EMCY", self.message(EmcyContent::ErrorCode), 4)?;
        put("aux", self.message(EmcyContent::AuxiliaryCode), 4)?;
        put("1001h", register.map(|register| register.0.into()), 2)?;
        put("6041h", statusword.map(|word| word.0), 4)?;
        f.write_str(if gap == ", " { "]" } else { "" })
    }
}

impl Explain for Fault<'_> {
    fn severity(&self) -> Severity {
        match self.is_active() {
            Some(false) if self.evidence.statusword.is_some_and(Statusword::has_warning) => Severity::Warning,
            Some(false) => Severity::Note,
            _ => Severity::Fault,
        }
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.alarm(), Fault::code(self)) {
            (Some(alarm), _) => write!(f, "{}", Clean(alarm.display().as_bytes())),
            (None, Some(code)) => write!(f, "{code:04X}h"),
            (None, None) => f.write_str("ALARM"),
        }
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_active() == Some(false) {
            f.write_str("not in fault now; the last one: ")?;
        }
        match (self.alarm(), Fault::code(self), count(self.alarms())) {
            (Some(alarm), ..) => write!(f, "{}", Clean(alarm.name().as_bytes()))?,
            (None, None, _) => f.write_str("the drive reports no error code")?,
            (None, Some(code), 0) => write!(f, "{}, a code that the profile does not list", class(code))?,
            (None, Some(_), many) => write!(f, "one of {many} alarms that share this code")?,
        }
        self.raw(f)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        if self.alarm().is_none() {
            lines.line("maybe", Maybe(self))?;
        }
        if let Some(register) = self.evidence.register.filter(|register| register.0 != 0) {
            lines.line("kind", register)?;
        }
        if let Some(name) = self.evidence.mode.and_then(Mode::name) {
            lines.line("mode", name)?;
        }
        lines.line("causes", Numbered(self.text().map_or(&[], |text| text.causes())))?;
        lines.line("reset", self.alarm().map_or("", |alarm| how(alarm.reset())))
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", Numbered(self.text().map_or(&[], |text| text.remedies())))
    }
}

const fn how(reset: Reset) -> &'static str {
    match reset {
        Reset::NotStated => "the manual does not say",
        Reset::Resettable => "by a fault reset, once the cause is gone",
        Reset::NotResettable => "not by a fault reset",
        Reset::PowerCycle => "by switching the control supply off and on; do not repeat fault resets",
    }
}

/// Texts below one another, with numbers if there are several.
struct Numbered<'t>(&'t [&'t str]);

impl fmt::Display for Numbered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [only] = self.0 {
            return write!(f, "{}", Clean(only.as_bytes()));
        }
        for (number, text) in (1..=usize::MAX).zip(self.0) {
            write!(f, "{}{number} {}", if number == 1 { "" } else { "\n" }, Clean(text.as_bytes()))?;
        }
        Ok(())
    }
}

/// The alarms that share a code, below one another.
struct Maybe<'f, 'm>(&'f Fault<'m>);

impl fmt::Display for Maybe<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        list(f, "\n", self.0.alarms().map(Named))
    }
}

/// An alarm by display, number and name.
struct Named<'m>(&'m AlarmDesc<'m>);

impl fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (display, name) = (Clean(self.0.display().as_bytes()), Clean(self.0.name().as_bytes()));
        write!(f, "{display} {:02X}h {name}", self.0.number())
    }
}

/// The class of an error code, CiA 301 and IEC 61800-7-201.
const fn class(code: u16) -> &'static str {
    match code >> 8 {
        0x00 => "no error",
        0x10..=0x1F => "generic error",
        0x20 => "current",
        0x21 => "current at the input",
        0x22 => "current inside the device",
        0x23 => "current at the output",
        0x30 => "voltage",
        0x31 => "mains voltage",
        0x32 => "voltage inside the device",
        0x33 => "voltage at the output",
        0x40 => "temperature",
        0x41 => "ambient temperature",
        0x42..=0x43 => "temperature of the device",
        0x50..=0x5F => "device hardware",
        0x60..=0x62 => "device software",
        0x63 => "parameters",
        0x70..=0x7F => "additional modules",
        0x80 | 0x89..=0x8F => "monitoring",
        0x81 => "communication",
        0x82 => "protocol",
        0x83 => "torque control",
        0x84 => "speed control",
        0x85..=0x86 => "position control",
        0x87..=0x88 => "synchronization",
        0x90..=0x9F => "external error",
        0xF0..=0xFE => "additional functions",
        0xFF => "of the maker",
        _ => "error",
    }
}

displays! {
    ['m] Fault<'m>;
}

#[cfg(test)]
mod tests;
