//! Executes commands on a virtual drive.

use std::time::Duration;

use drivewright_runtime::client::object::{Content, Shown};
use drivewright_runtime::mapping::Direction;
use drivewright_runtime::model::{AlarmDesc, DriveModel, EsmState, ObjectDesc};
use drivewright_runtime::sim::{UnknownAlarm, VirtualDrive};
use drivewright_runtime::transport::{Refusal, Transport};
use drivewright_runtime::{AbortCode, Address};

use super::script::{Bus, Command, Condition, Supply, help};
use super::{faults, state};
use crate::stage::{Watched, assumptions, image};
use crate::trace::{Kind, millis};

/// How long an SDO transfer may take.
const ANSWER_WITHIN: Duration = Duration::from_millis(500);

/// A virtual drive and its master.
pub(super) struct Session<'b, 'd, 'm, 's> {
    pub(super) bus: &'b mut Watched<'d, 'm, 's>,
    model: &'m DriveModel<'m>,
    cycle: Duration,
    /// What the master sends as process data, while it does.
    outputs: Option<Vec<(Address, i128)>>,
}

/// Why a command has not done what it should.
pub(super) enum Failed {
    /// The drive refuses it.
    Refused(String, Option<AbortCode>),
    /// It is not as expected, or cannot be.
    Not(String),
}

impl Failed {
    pub(super) fn text(&self) -> &str {
        match self {
            Self::Refused(text, _) | Self::Not(text) => text,
        }
    }
}

type Said = Result<String, Failed>;

impl<'b, 'd, 'm, 's> Session<'b, 'd, 'm, 's> {
    pub(super) fn new(bus: &'b mut Watched<'d, 'm, 's>, cycle: Duration) -> Self {
        let model = bus.drive().model();
        Self { bus, model, cycle, outputs: None }
    }

    /// Executes a command; gives what it has to say.
    pub(super) fn execute(&mut self, command: &Command) -> Said {
        match command {
            Command::Read(at) => self.read(*at).map(|(_, text)| text),
            Command::Write(at, value) => self.write(*at, *value),
            Command::Send(at, bytes) => self.send(*at, bytes),
            Command::Exchange(values) => self.exchange(values),
            Command::Expect(condition) => self.expect(condition),
            Command::Until(condition, within) => self.until(condition, *within),
            Command::Bus(wanted) => self.request(*wanted),
            Command::Refused(code, command) => self.refused(*code, command),
            Command::Raise(display, number) => self.with_alarm(display, *number, VirtualDrive::raise),
            Command::Hold(display, number) => self.with_alarm(display, *number, VirtualDrive::raise_for_good),
            Command::Clear(display, number) => self.with_alarm(display, *number, VirtualDrive::end_cause),
            Command::Fault(kind, number) => faults::disturb(self.bus, kind, *number).map_err(Failed::Not),
            Command::State => Ok(state::told(self.bus.drive())),
            Command::Assumptions => Ok(assumptions().trim_end().to_owned()),
            Command::Help => Ok(help().trim_end().to_owned()),
            quiet => {
                self.quietly(quiet);
                Ok(String::new())
            }
        }
    }

    /// Executes one of the commands that have nothing to say.
    fn quietly(&mut self, command: &Command) {
        match command {
            Command::ExchangeOff => self.outputs = None,
            Command::Run(span) => self.run(*span),
            Command::Power(supply, on) => self.power(*supply, *on),
            Command::Load(percent) => self.bus.drive().axis_mut().set_load(percent * 10),
            Command::Note(text) => {
                let now = self.bus.now();
                self.bus.recorder.trace.note(now, Kind::Note, text.clone());
            }
            _ => {}
        }
    }

    /// A cycle of process data, where they go on.
    fn tick(&mut self) {
        if let Some(outputs) = self.outputs.clone() {
            // What does not come in a cycle may come in the next; the drive itself notices what is missing.
            let _ = self.send_outputs(&outputs);
        }
    }

    fn run(&mut self, span: Duration) {
        let end = self.bus.now().after(span);
        while self.outputs.is_some() && self.bus.now() < end {
            self.tick();
        }
        self.bus.wait(end);
    }

    fn read(&mut self, at: Address) -> Result<(Option<i128>, String), Failed> {
        self.tick();
        let mut buffer = [0; 256];
        let length = self.bus.upload(at, &mut buffer, ANSWER_WITHIN);
        let length = length.map_err(|why| self.refusal("read", at, why))?;
        let bytes = buffer.get(..length).unwrap_or(&[]);
        let Some(object) = self.model.object(at) else { return Ok((None, format!("{at} = {bytes:02X?}"))) };
        let content = Content::decode(object, bytes).map_err(|error| Failed::Not(error.to_string()))?;
        let shown = Shown::new(self.model, object, content);
        Ok((content.number(), format!("{at} {} = {shown}", object.name())))
    }

    fn write(&mut self, at: Address, value: i128) -> Said {
        let mut bytes = [0; 8];
        let length = match self.model.object(at).map(ObjectDesc::data_type) {
            Some(data_type) => data_type.encode_int(value, &mut bytes).map_err(|_| {
                let of = data_type.name().unwrap_or("its type");
                Failed::Not(format!("{value} is no value of {of}, the type of {at}; `send` sends any bytes"))
            })?,
            // The drive says what is wrong with it.
            None => 4,
        };
        self.send(at, bytes.get(..length).unwrap_or(&[]))
    }

    fn send(&mut self, at: Address, bytes: &[u8]) -> Said {
        self.tick();
        let written = self.bus.download(at, bytes, ANSWER_WITHIN);
        written.map(|()| String::new()).map_err(|why| self.refusal("write", at, why))
    }

    fn refusal(&self, what: &str, at: Address, why: Refusal<std::convert::Infallible>) -> Failed {
        let name = self.model.object(at).map(|object| format!(" {}", object.name())).unwrap_or_default();
        let head = format!("{what} of {at}{name}");
        match why {
            Refusal::Abort(code) => {
                let meant = self.model.abort(code).map(|row| format!("; the manual: {}", row.name()));
                let text = format!("{head}: the drive refuses: {code}{}", meant.unwrap_or_default());
                Failed::Refused(text, Some(code))
            }
            Refusal::NoAnswer => Failed::Refused(format!("{head}: no answer"), None),
            _ => Failed::Not(format!("{head}: the answer is longer than there is room for")),
        }
    }

    fn exchange(&mut self, values: &[(Address, i128)]) -> Said {
        let mapped = image::mapped(self.bus.drive(), Direction::Rx);
        if let Some((at, _)) =
            values.iter().find(|(at, _)| !mapped.iter().any(|entry| entry.address() == *at))
        {
            let have: Vec<String> = mapped.iter().map(|entry| entry.address().to_string()).collect();
            let have = have.join(", ");
            return Err(Failed::Not(format!(
                "{at} is not in the process data that the drive receives: {have}"
            )));
        }
        let mut outputs = self.outputs.take().unwrap_or_default();
        outputs.retain(|(at, _)| !values.iter().any(|(new, _)| new == at));
        outputs.extend(values);
        let inputs = self.send_outputs(&outputs);
        self.outputs = Some(outputs);
        // Who sets something wants to set it; who sets nothing wants to see.
        inputs.map(|shown| if values.is_empty() { shown } else { String::new() })
    }

    /// A cycle: what was never set is sent as the drive has it.
    fn send_outputs(&mut self, outputs: &[(Address, i128)]) -> Said {
        let drive = self.bus.drive();
        let mapped = image::mapped(drive, Direction::Rx);
        let frame = image::pack(&mapped, |at| {
            let set = outputs.iter().find(|(set, _)| *set == at).map(|(_, value)| *value);
            set.unwrap_or_else(|| drive.value(at).unwrap_or(0).into())
        });
        let mut inputs = [0; 512];
        match self.bus.exchange(&frame, &mut inputs) {
            Ok(length) => Ok(self.inputs(inputs.get(..length).unwrap_or(&[]))),
            Err(_) => Err(Failed::Not(
                "no process data came: they are exchanged after `bus safeop` and `bus op`".to_owned(),
            )),
        }
    }

    fn inputs(&mut self, frame: &[u8]) -> String {
        let mapped = image::mapped(self.bus.drive(), Direction::Tx);
        let signed = |at| self.model.object(at).is_some_and(|object| object.data_type().is_signed());
        let shown = image::unpack(&mapped, frame, signed).into_iter().filter_map(|(at, value)| {
            let object = self.model.object(at)?;
            Some(format!("{at} {} = {}", object.name(), Shown::number(self.model, object, value)))
        });
        shown.collect::<Vec<_>>().join("\n")
    }

    /// Whether it is so, and what is.
    fn holds(&mut self, condition: &Condition) -> Result<(bool, String), Failed> {
        match condition {
            Condition::Entry { at, mask, is, value } => {
                let (number, text) = self.read(*at)?;
                let number = number.ok_or_else(|| Failed::Not(format!("{text}, which is no number")))?;
                let masked = mask.map_or(number, |mask| number & mask);
                let with = mask.map(|mask| format!("; & {mask:#X} is {masked:#X}")).unwrap_or_default();
                Ok((is.holds(masked, *value), format!("{text}{with}")))
            }
            Condition::State(wanted) => {
                self.tick();
                let state = self.bus.drive().state().word();
                Ok((state == wanted, format!("the state is {state}")))
            }
        }
    }

    fn expect(&mut self, condition: &Condition) -> Said {
        let (holds, text) = self.holds(condition)?;
        if holds { Ok(String::new()) } else { Err(Failed::Not(format!("it is not so: {text}"))) }
    }

    fn until(&mut self, condition: &Condition, within: Duration) -> Said {
        let start = self.bus.now();
        let end = start.after(within);
        loop {
            let (holds, text) = self.holds(condition)?;
            let now = self.bus.now();
            if holds {
                let took = now.since(start).as_millis();
                return Ok(format!("after {took} ms"));
            }
            if now >= end {
                return Err(Failed::Not(format!("it is not so after {} ms: {text}", within.as_millis())));
            }
            self.bus.wait(now.after(self.cycle));
        }
    }

    fn request(&mut self, wanted: Bus) -> Said {
        let wanted = match wanted {
            Bus::Init => EsmState::Init,
            Bus::PreOp => EsmState::PreOp,
            Bus::SafeOp => EsmState::SafeOp,
            Bus::Op => EsmState::Op,
        };
        let asked = self.bus.drive().request(wanted);
        asked.map(|()| String::new()).map_err(|why| Failed::Refused(why.to_string(), None))
    }

    fn refused(&mut self, code: Option<u32>, command: &Command) -> Said {
        match self.execute(command) {
            Err(Failed::Refused(text, seen)) if code.is_none() || seen.map(|seen| seen.0) == code => Ok(text),
            Err(Failed::Refused(text, _)) => {
                Err(Failed::Not(format!("it is refused, but otherwise: {text}")))
            }
            Err(not) => Err(not),
            Ok(_) => Err(Failed::Not("the drive does not refuse it".to_owned())),
        }
    }

    /// Does something with an alarm.
    fn with_alarm(
        &mut self,
        display: &str,
        number: Option<u16>,
        act: impl FnOnce(&mut VirtualDrive<'m, 's>, &str, u16) -> Result<(), UnknownAlarm>,
    ) -> Said {
        let alarm = self.alarm(display, number)?;
        let done = act(self.bus.drive(), alarm.display(), alarm.number());
        done.map(|()| String::new()).map_err(|error| Failed::Not(error.to_string()))
    }

    /// The alarm that is meant. One display may stand for several.
    fn alarm(&self, display: &str, number: Option<u16>) -> Result<&'m AlarmDesc<'m>, Failed> {
        let alarms = self.model.alarms().iter();
        let meant: Vec<_> = alarms
            .filter(|alarm| alarm.display() == display && number.is_none_or(|n| n == alarm.number()))
            .collect();
        match meant.as_slice() {
            [one] => Ok(one),
            [] => {
                let known: Vec<&str> = self.model.alarms().iter().map(AlarmDesc::display).collect();
                Err(Failed::Not(format!(
                    "there is no alarm `{}`; known: {}",
                    display.escape_debug(),
                    known.join(", ")
                )))
            }
            several => {
                let numbers: Vec<String> =
                    several.iter().map(|alarm| format!("{:#04X}", alarm.number())).collect();
                Err(Failed::Not(format!(
                    "several alarms show {display}: say {display} and {}",
                    numbers.join(" or ")
                )))
            }
        }
    }

    fn power(&mut self, supply: Supply, on: bool) {
        match supply {
            Supply::Control => self.bus.drive().set_supply(on),
            Supply::Main => self.bus.drive().set_mains(on),
            Supply::Torque => self.bus.drive().allow_torque(on),
        }
    }

    /// The time on the clock of the drive, in words.
    pub(super) fn clock(&mut self) -> String {
        millis(self.bus.now())
    }
}
