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

/// As long as the simulation runs.
const ALWAYS: u32 = u32::MAX;

const KINDS: &[Kind] = &[
    Kind {
        name: "lost-pdo",
        does: "so many cycles of process data do not arrive",
        plan: |n| (Disturbance::LostCycle, n),
    },
    Kind {
        name: "frozen-pdo",
        does: "for so many cycles what the drive sends stays as it was",
        plan: |n| (Disturbance::FrozenInputs, n),
    },
    Kind {
        name: "short-pdo",
        does: "for so many cycles what the drive sends has a byte less",
        plan: |n| (Disturbance::ShortInputs, n),
    },
    Kind {
        name: "lost-request",
        does: "so many SDO requests do not arrive",
        plan: |n| (Disturbance::LostRequest, n),
    },
    Kind {
        name: "lost-answer",
        does: "so many SDO answers do not arrive",
        plan: |n| (Disturbance::LostAnswer, n),
    },
    Kind {
        name: "late-answer",
        does: "the next SDO answer comes so many milliseconds later",
        plan: |n| (Disturbance::LateAnswer(low(n)), 1),
    },
    Kind {
        name: "short-answer",
        does: "so many SDO answers have a byte less",
        plan: |n| (Disturbance::ShortAnswer, n),
    },
    Kind {
        name: "long-answer",
        does: "so many SDO answers have a byte more",
        plan: |n| (Disturbance::LongAnswer, n),
    },
    Kind {
        name: "wrong-abort",
        does: "the next SDO transfer is refused with this abort code",
        plan: |n| (Disturbance::WrongAbort(AbortCode(n)), 1),
    },
    Kind {
        name: "stuck-on",
        does: "these bits of the statusword are 1 for a master",
        plan: |n| (Disturbance::StuckStatus { mask: low(n), value: low(n) }, ALWAYS),
    },
    Kind {
        name: "stuck-off",
        does: "these bits of the statusword are 0 for a master",
        plan: |n| (Disturbance::StuckStatus { mask: low(n), value: 0 }, ALWAYS),
    },
    Kind {
        name: "no-torque",
        does: "the drive must not make torque for so many cycles of process data",
        plan: |n| (Disturbance::NoTorque, n),
    },
    Kind {
        name: "mains-dip",
        does: "the main supply is off for so many cycles of process data",
        plan: |n| (Disturbance::MainsDip, n),
    },
    Kind {
        name: "supply-dip",
        does: "the control supply is off for so many cycles of process data",
        plan: |n| (Disturbance::SupplyDip, n),
    },
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
