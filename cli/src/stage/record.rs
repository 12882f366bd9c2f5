//! Looks at a virtual drive after each step and writes a trace of it.

use std::thread;
use std::time::{Duration, Instant};

use drivewright_runtime::Address;
use drivewright_runtime::cia402::{HomingState, Mode, State};
use drivewright_runtime::model::{AlarmDesc, DriveModel};
use drivewright_runtime::sim::VirtualDrive;

use crate::trace::{BitNames, Kind, Sample, Trace, Unit, Units};

const CONTROLWORD: Address = Address::new(0x6040, 0);
pub(crate) const POSITION: Address = Address::new(0x6064, 0);
pub(crate) const SPEED: Address = Address::new(0x606C, 0);
pub(crate) const TORQUE: Address = Address::new(0x6077, 0);
const CURRENT: Address = Address::new(0x6078, 0);

/// What is looked at for the force of the motor, and what it is called: torque, or current where there is no torque.
pub(crate) fn force(model: &DriveModel<'_>) -> (Address, &'static str) {
    let current = model.object(TORQUE).is_none() && model.object(CURRENT).is_some();
    if current { (CURRENT, "current") } else { (TORQUE, "torque") }
}

/// The trace of a drive that is being looked at.
pub(crate) struct Recorder {
    pub(crate) trace: Trace,
    pace: Pace,
    /// Display and number of each alarm that was active.
    alarms: Vec<(String, u16)>,
    /// The farthest position, and how many counts of the axis that was.
    farthest: (i64, i64),
    revolution: i64,
}

impl Recorder {
    pub(crate) fn new(model: &DriveModel<'_>, title: String, pace: Pace) -> Self {
        let unit = |at| Unit::of(model, at);
        let (force, force_name) = force(model);
        let units = Units { position: unit(POSITION), speed: unit(SPEED), force: unit(force), force_name };
        Self {
            trace: Trace::new(title, units, BitNames::of(model)),
            pace,
            alarms: Vec::new(),
            farthest: (0, 0),
            revolution: 0,
        }
    }

    /// Takes a sample, and events that it shows. In the pace that is asked for, this waits.
    pub(crate) fn look(&mut self, drive: &VirtualDrive<'_, '_>) {
        let sample = sample(drive);
        let before = self.trace.samples.last().copied();
        self.trace.push(sample);
        if let Some(before) = before {
            self.compare(&before, &sample);
        }
        self.alarms(drive, &sample);
        self.measure(drive, sample.position);
        self.pace.keep(sample.at);
    }

    /// Far from 0 the unit of positions shows best.
    fn measure(&mut self, drive: &VirtualDrive<'_, '_>, position: i64) {
        let axis = drive.axis();
        self.revolution = axis.config().switches.revolution;
        if position.abs() > self.farthest.0.abs() {
            self.farthest = (position, axis.position() - drive.origin());
        }
    }

    /// Units of position in a revolution, to the nearest; `None` before the axis has moved.
    pub(crate) fn per_revolution(&self) -> Option<i64> {
        let (position, counts) = self.farthest;
        let doubled = (i128::from(position) * i128::from(self.revolution) * 2).checked_div(counts.into())?;
        i64::try_from((doubled.abs() + 1) / 2).ok()
    }

    fn compare(&mut self, before: &Sample, now: &Sample) {
        let fault = |sample: &Sample| sample.state() == Some(State::Fault);
        if fault(before) && now.state() == Some(State::SwitchOnDisabled) {
            self.trace.note(now.at, Kind::Reset, "fault reset");
        }
        let home = |sample: &Sample| {
            sample.mode == Mode::HOMING && HomingState::of(sample.status) == HomingState::Completed
        };
        if home(now) && !home(before) {
            let place = self.trace.units.position.told(now.position);
            self.trace.note(now.at, Kind::Homed, format!("home found; the axis stands at {place}"));
        }
    }

    fn alarms(&mut self, drive: &VirtualDrive<'_, '_>, now: &Sample) {
        let active: Vec<&AlarmDesc<'_>> = drive.alarms().map(|active| active.alarm).collect();
        self.alarms.retain(|(display, number)| active.iter().any(|alarm| alarm.is(display, *number)));
        for alarm in active {
            let known = self.alarms.iter().any(|(display, number)| alarm.is(display, *number));
            if !known {
                self.alarms.push((alarm.display().to_owned(), alarm.number()));
                self.trace.note(now.at, Kind::Fault, named(alarm));
            }
        }
    }
}

/// `OF (8611h): Deviation exceeded`
pub(crate) fn named(alarm: &AlarmDesc<'_>) -> String {
    format!("{} ({:04X}h): {}", alarm.display(), alarm.code(), alarm.name())
}

fn sample(drive: &VirtualDrive<'_, '_>) -> Sample {
    let value = |at| drive.value(at).unwrap_or(0);
    Sample {
        at: drive.now(),
        position: value(POSITION),
        speed: value(SPEED),
        force: value(force(drive.model()).0),
        mode: drive.mode(),
        status: drive.statusword(),
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a word of 16 bits")]
        control: value(CONTROLWORD) as u16,
    }
}

/// How fast virtual time goes.
#[derive(Clone, Copy)]
pub(crate) struct Pace {
    /// Virtual seconds a second; `None` for as fast as it can be computed.
    speed: Option<f64>,
    start: Instant,
}

impl Pace {
    /// `max`, `real`, or how many times as fast as a clock.
    pub(crate) fn read(word: &str) -> Result<Self, String> {
        let speed = match word {
            "max" => None,
            "real" => Some(1.0),
            word => match word.parse::<f64>() {
                Ok(speed) if (0.001..=1e6).contains(&speed) => Some(speed),
                _ => return Err("real, max, or a number from 0.001 to 1000000".to_owned()),
            },
        };
        Ok(Self { speed, start: Instant::now() })
    }

    /// Waits until it is `at`. Time that people think before they ask for the next thing does not count.
    fn keep(&mut self, at: drivewright_runtime::time::Instant) {
        let Some(speed) = self.speed else { return };
        let due = Duration::from_micros(at.micros()).div_f64(speed);
        match due.checked_sub(self.start.elapsed()) {
            Some(early) if early < LONGEST_NAP => thread::sleep(early),
            // Later than asked for by more than anybody can see: the clock of the drive was stopped.
            Some(_) => {}
            None => self.start += self.start.elapsed().saturating_sub(due),
        }
    }
}

/// Longer than any step of a drive, at any speed.
const LONGEST_NAP: Duration = Duration::from_secs(20);
