//! W0506: the device type does not say that the device is a drive, or which kind.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};

const CODE: Code =
    Code::warning("W0506", "the device type does not say that the device is a drive, or which kind");
const WHY: &str = "masters choose their driver by 1000h: 402 in the low half, the kind of drive above it";
const HELP: &str = "compare the default with the manual: 00020192h is a servo drive; if it prints another one, add an erratum";

/// The number of the device profile CiA 402.
const DRIVES: i128 = 402;

/// Compares the default of 1000h with CiA 402, in drives that name the base `cia402`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("device_type_whole.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let Some((_, entry)) = model.entry(Address::new(0x1000, 0)) else { return };
    let settled = entry.default.as_ref().is_some_and(super::settled);
    let Some(default) = entry.default_int().filter(|_| super::based_on(model, "cia402") && !settled) else {
        return;
    };
    let (profile, kind) = (default.value & 0xFFFF, default.value >> 16);
    if profile != DRIVES || kind == 0 {
        let text = format!("`{}` defaults to {:08X}h", entry.address, default.value);
        sink.push(super::finding(CODE, default.span, &entry.address, text, WHY, HELP));
    }
}
