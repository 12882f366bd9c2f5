//! Disturbances by name: what real wires and supplies do.

use drivewright_runtime::AbortCode;
use drivewright_runtime::sim::Disturbance;

use crate::stage::Watched;

/// A disturbance, and what its number means.
struct Kind {
    name: &'static str,
    does: &'static str,
    /// The disturbance, and how many times it happens.
    plan: fn(u32) -> (Disturbance, u32),
}

const fn kind(name: &'static str, does: &'static str, plan: fn(u32) -> (Disturbance, u32)) -> Kind {
    Kind { name, does, plan }
}

/// As long as the simulation runs.
const ALWAYS: u32 = u32::MAX;

const KINDS: &[Kind] = &[
    kind("lost-pdo", "so many cycles of process data do not arrive", |n| (Disturbance::LostCycle, n)),
    kind("frozen-pdo", "for so many cycles what the drive sends stays as it was", |n| {
        (Disturbance::FrozenInputs, n)
    }),
    kind("short-pdo", "for so many cycles what the drive sends has a byte less", |n| {
        (Disturbance::ShortInputs, n)
    }),
    kind("lost-request", "so many SDO requests do not arrive", |n| (Disturbance::LostRequest, n)),
    kind("lost-answer", "so many SDO answers do not arrive", |n| (Disturbance::LostAnswer, n)),
    kind("late-answer", "the next SDO answer comes so many milliseconds later", |n| {
        (Disturbance::LateAnswer(low(n)), 1)
    }),
    kind("short-answer", "so many SDO answers have a byte less", |n| (Disturbance::ShortAnswer, n)),
    kind("long-answer", "so many SDO answers have a byte more", |n| (Disturbance::LongAnswer, n)),
    kind("wrong-abort", "the next SDO transfer is refused with this abort code", |n| {
        (Disturbance::WrongAbort(AbortCode(n)), 1)
    }),
    kind("stuck-on", "these bits of the statusword are 1 for a master", |n| {
        (Disturbance::StuckStatus { mask: low(n), value: low(n) }, ALWAYS)
    }),
    kind("stuck-off", "these bits of the statusword are 0 for a master", |n| {
        (Disturbance::StuckStatus { mask: low(n), value: 0 }, ALWAYS)
    }),
    kind("no-torque", "the drive must not make torque for so many cycles of process data", |n| {
        (Disturbance::NoTorque, n)
    }),
    kind("mains-dip", "the main supply is off for so many cycles of process data", |n| {
        (Disturbance::MainsDip, n)
    }),
    kind("supply-dip", "the control supply is off for so many cycles of process data", |n| {
        (Disturbance::SupplyDip, n)
    }),
];

#[allow(clippy::cast_possible_truncation, reason = "what is above has no meaning there")]
const fn low(n: u32) -> u16 {
    n as u16
}

/// Plans a disturbance; without a kind, lists them. `calm` takes all of them back.
pub(super) fn disturb(
    bus: &mut Watched<'_, '_, '_>,
    kind: &str,
    number: Option<u64>,
) -> Result<String, String> {
    if kind.is_empty() {
        return Ok(list());
    }
    if kind == "calm" {
        bus.calm();
        return Ok(String::new());
    }
    let Some(found) = KINDS.iter().find(|known| known.name == kind) else {
        return Err(format!("there is no fault `{}`; `fault` lists them", kind.escape_debug()));
    };
    let number =
        u32::try_from(number.unwrap_or(1)).map_err(|_| "the number has more than 32 bits".to_owned())?;
    let (what, times) = (found.plan)(number);
    if times > 0 && !bus.disturb(what, times) {
        return Err("too many are planned; `fault calm` takes them back".to_owned());
    }
    Ok(String::new())
}

fn list() -> String {
    let width = KINDS.iter().map(|kind| kind.name.len() + 2).max().unwrap_or(0);
    let line = |kind: &Kind| format!("fault {:<width$}  {}", format!("{} N", kind.name), kind.does);
    let last = format!("fault {:<width$}  takes all of them back; supplies are on again", "calm");
    KINDS.iter().map(line).chain([last]).collect::<Vec<_>>().join("\n")
}
