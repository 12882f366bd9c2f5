//! A fault as the drive reports it, with what the model knows about its code.

use core::fmt;

use crate::cia402::Statusword;
use crate::client::message::{displays, Clean, Explain, Lines, Severity};
use crate::model::{AlarmDesc, AlarmText, DriveModel, Reset};

/// A fault: the error code, and the alarms that report it. Several may share a code.
#[derive(Clone, Copy, Debug)]
pub struct Fault<'m> {
    model: &'m DriveModel<'m>,
    texts: &'m [AlarmText<'m>],
    code: u16,
    statusword: Statusword,
}

impl<'m> Fault<'m> {
    /// What these values report; `None` if they report no fault.
    pub fn of(model: &'m DriveModel<'m>, code: u16, statusword: Statusword) -> Option<Self> {
        let faulted = statusword.state().is_some_and(|state| state.is_fault());
        (faulted || code != 0).then_some(Self { model, texts: &[], code, statusword })
    }

    /// With the texts of the alarms: causes and remedies. They are a table of their own, so that a program without them does
    /// not carry them.
    #[must_use]
    pub const fn with_texts(self, texts: &'m [AlarmText<'m>]) -> Self {
        Self { texts, ..self }
    }

    /// 603Fh.
    pub const fn code(&self) -> u16 {
        self.code
    }

    /// 6041h.
    pub const fn statusword(&self) -> Statusword {
        self.statusword
    }

    /// The alarms with this code, in the order of the model.
    pub fn alarms(&self) -> impl Iterator<Item = &'m AlarmDesc<'m>> {
        self.model.alarms_by_code(self.code)
    }

    /// The text of an alarm; `None` where there is none, or none was given.
    pub fn text(&self, alarm: &AlarmDesc<'m>) -> Option<&'m AlarmText<'m>> {
        AlarmText::find(self.texts, alarm)
    }

    fn list(&self, f: &mut fmt::Formatter<'_>, part: fn(&AlarmText<'m>) -> &'m [&'m str]) -> fmt::Result {
        let texts = self.alarms().filter_map(|alarm| self.text(alarm));
        for (number, line) in (1_u8..).zip(texts.flat_map(|text| part(text).iter())) {
            write!(f, "{}{number} {}", if number == 1 { "" } else { "\n" }, Clean(line.as_bytes()))?;
        }
        Ok(())
    }
}

/// What to say of the ways in which alarms are cleared.
const fn cleared(reset: Reset) -> &'static str {
    match reset {
        Reset::Resettable => "a fault reset clears it, once the cause is gone",
        Reset::NotResettable => "a fault reset does not clear it",
        Reset::PowerCycle => "switch the control supply off and on",
        Reset::NotStated => "the manual does not say how it is cleared",
    }
}

impl Explain for Fault<'_> {
    fn severity(&self) -> Severity {
        Severity::Fault
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}h", self.code)
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut alarms = self.alarms();
        match alarms.next() {
            None => f.write_str("a fault whose code the profile does not know")?,
            Some(first) => {
                write!(f, "{} \"{}\"", Clean(first.display().as_bytes()), Clean(first.name().as_bytes()))?
            }
        }
        for alarm in alarms {
            write!(f, ", or {} \"{}\"", Clean(alarm.display().as_bytes()), Clean(alarm.name().as_bytes()))?;
        }
        write!(f, " [603F {:04X}h, statusword {:04X}h]", self.code, self.statusword.0)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        lines.line("state", self.statusword)?;
        lines.line("causes", Listed(self, AlarmText::causes))?;
        self.alarms().try_for_each(|alarm| {
            lines.line(
                "reset",
                format_args!("{}: {}", Clean(alarm.display().as_bytes()), cleared(alarm.reset())),
            )
        })
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.list(f, AlarmText::remedies)
    }
}

/// A list of the texts, as something to display.
struct Listed<'f, 'm>(&'f Fault<'m>, fn(&AlarmText<'m>) -> &'m [&'m str]);

impl fmt::Display for Listed<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.list(f, self.1)
    }
}

displays! {
    ['m] Fault<'m>;
}
