//! The client with its drive, and the scenes that were played.

use std::convert::Infallible;
use std::time::Duration;

use drivewright_runtime::Address;
use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::axis::AxisPolicy;
use drivewright_runtime::client::drive::Drive;
use drivewright_runtime::client::error::DriveError;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::client::units::Amount;
use drivewright_runtime::model::{DriveModel, EsmState};
use drivewright_runtime::pdo::MapEntry;
use drivewright_runtime::sim::VirtualDrive;
use drivewright_runtime::transport::Transport;
use drivewright_runtime::value::Value;

use crate::stage::{POSITION, SPEED, Watched};
use crate::trace::{Kind, Trace, Unit, mode_name};

/// Between parts, so that they can be told apart in a picture.
pub(super) const PAUSE: Duration = Duration::from_millis(200);

/// A part of the play that is over.
pub(super) struct Scene {
    pub(super) title: String,
    /// What came of it.
    pub(super) told: String,
    /// When it began and ended, in microseconds.
    pub(super) span: (u64, u64),
    /// The same as numbers, for programs: raw counts.
    pub(super) numbers: Vec<(&'static str, i64)>,
}

/// A client with its drive.
pub(super) struct Actor<'c, 'd, 'm, 's> {
    pub(super) drive: Drive<'c, Watched<'d, 'm, 's>>,
    /// Whether there are process data; else all goes by SDO.
    pub(super) cyclic: bool,
    pub(super) scenes: Vec<Scene>,
    pub(super) fault: String,
    numbers: Vec<(&'static str, i64)>,
}

impl<'c, 'd, 'm: 'c, 's> Actor<'c, 'd, 'm, 's> {
    /// Over these process data, or SDO alone where the client cannot use them.
    pub(super) fn new(
        model: &'m DriveModel<'m>,
        bus: Watched<'d, 'm, 's>,
        (rx, tx): (&'c [MapEntry], &'c [MapEntry]),
    ) -> Result<Self, String> {
        let image =
            Image::new(rx, tx).or_else(|_| Image::new(&[], &[])).map_err(|error| error.to_string())?;
        let cyclic = !image.is_empty();
        let client = Client::new(model, image, AxisPolicy::default()).with_cycle(Duration::from_millis(2));
        let drive = Drive::new(client, bus);
        Ok(Self { drive, cyclic, scenes: Vec::new(), fault: String::new(), numbers: Vec::new() })
    }
}

impl<'m, 's> Actor<'_, '_, 'm, 's> {
    pub(super) fn model(&mut self) -> &'m DriveModel<'m> {
        self.machine().model()
    }

    /// The virtual drive itself, for what a client cannot know.
    pub(super) fn machine(&mut self) -> &mut VirtualDrive<'m, 's> {
        self.drive.bus().drive()
    }

    pub(super) fn into_trace(self) -> Trace {
        let (_, bus) = self.drive.into_parts();
        bus.recorder.trace
    }

    /// Plays a part; what it gives is told.
    pub(super) fn scene(
        &mut self,
        title: &str,
        play: impl FnOnce(&mut Self) -> Result<String, String>,
    ) -> Result<(), String> {
        let from = self.drive.bus().now();
        self.drive.bus().recorder.trace.note(from, Kind::Step, title);
        let told = play(self).map_err(|why| format!("{title}: {why}"))?;
        let to = self.drive.bus().now();
        let numbers = std::mem::take(&mut self.numbers);
        self.scenes.push(Scene {
            title: title.to_owned(),
            told,
            span: (from.micros(), to.micros()),
            numbers,
        });
        Ok(())
    }

    /// A part that is not played.
    pub(super) fn skip(&mut self, title: &str, why: &str) {
        let now = self.drive.bus().now().micros();
        let told = format!("left out: {why}");
        self.scenes.push(Scene { title: title.to_owned(), told, span: (now, now), numbers: Vec::new() });
    }

    /// A number for programs, of the part that is being played.
    pub(super) fn number(&mut self, name: &'static str, number: i64) {
        self.numbers.push((name, number));
    }

    /// Waits for the drive, and brings the network to where process data are exchanged.
    pub(super) fn start(&mut self) -> Result<String, String> {
        let start_up = self.machine().config().start_up;
        self.drive.bus().look();
        self.rest(start_up);
        self.operate()?;
        self.hold(PAUSE)?;
        let network = self.machine().bus_state();
        Ok(format!("the drive has started up; network: {network}"))
    }

    /// To OP, as far as there are process data.
    pub(super) fn operate(&mut self) -> Result<(), String> {
        let cyclic = self.cyclic;
        let drive = self.machine();
        for state in [EsmState::PreOp, EsmState::SafeOp, EsmState::Op] {
            if drive.bus_state() != EsmState::Op && (cyclic || state == EsmState::PreOp) {
                drive.request(state).map_err(|why| why.to_string())?;
            }
        }
        Ok(())
    }

    pub(super) fn enable(&mut self, mode: Mode) -> Result<String, String> {
        self.drive.enable(mode).map_err(said)?;
        self.hold(PAUSE)?;
        Ok(format!("{} in {}", self.machine().state(), mode_name(mode)))
    }

    pub(super) fn disable(&mut self) -> Result<String, String> {
        self.drive.disable().map_err(said)?;
        Ok(self.machine().state().to_string())
    }

    /// Time goes by, without process data.
    pub(super) fn rest(&mut self, span: Duration) {
        let end = self.drive.bus().now().after(span);
        self.drive.bus().wait(end);
    }

    /// Cycles of process data for so long.
    pub(super) fn hold(&mut self, span: Duration) -> Result<(), String> {
        let end = self.drive.bus().now().after(span);
        while self.drive.bus().now() < end {
            self.cycle()?;
        }
        Ok(())
    }

    /// One cycle; the axis must still be in operation.
    pub(super) fn cycle(&mut self) -> Result<(), String> {
        self.drive.cycle().map_err(said)?;
        self.drive.client().axis().trip().map_or(Ok(()), |error| Err(error.to_string()))
    }

    /// The entry as the drive has it.
    pub(super) fn value(&mut self, at: Address) -> i64 {
        self.machine().value(at).unwrap_or(0)
    }

    pub(super) fn position(&mut self) -> i64 {
        self.value(POSITION)
    }

    /// A count of an entry with its unit.
    pub(super) fn told(&mut self, at: Address, raw: i64) -> String {
        Unit::of(self.model(), at).told(raw)
    }

    /// User units of a revolution. No object says it in a way that all drives share, so it is what the virtual axis has
    /// shown so far; a guess until it has turned.
    pub(super) fn per_revolution(&mut self) -> i64 {
        const GUESS: i64 = 10_000;
        self.drive.bus().recorder.per_revolution().unwrap_or(GUESS)
    }

    /// So many rpm in the counts of an entry.
    pub(super) fn speed(&mut self, at: Address, rpm: i32) -> i64 {
        let amount = Amount::from(Value::rpm(rpm));
        match self.drive.client().count(at, amount) {
            Ok(count) => count,
            // User units a second.
            Err(_) => self.per_revolution() * i64::from(rpm) / 60,
        }
    }

    /// So many percent of rated torque in the counts of an entry.
    pub(super) fn torque(&mut self, at: Address, percent: i64) -> i64 {
        use drivewright_runtime::quantity::QuantityKind;
        let amount = Amount::Physical { kind: QuantityKind::TorqueRatio, num: percent, den: 100 };
        // CiA 402 counts in thousandths of rated torque.
        self.drive.client().count(at, amount).unwrap_or(percent * 10)
    }

    /// The speed of the axis, with its unit.
    pub(super) fn speed_told(&mut self) -> String {
        let speed = self.value(SPEED);
        self.told(SPEED, speed)
    }
}

/// An error of the client, in words.
#[allow(clippy::needless_pass_by_value, reason = "for map_err")]
pub(super) fn said(error: DriveError<Infallible>) -> String {
    error.to_string()
}
