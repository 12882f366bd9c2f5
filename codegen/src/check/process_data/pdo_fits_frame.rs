//! E0608: a PDO of a CANopen drive is longer than a CAN frame.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0608", "a PDO of a CANopen drive is longer than a CAN frame");
const WHY: &str =
    "a CAN frame carries eight bytes, and the drive would refuse the mapping with abort 0604 0042";
const HELP: &str = "correct the mapping; add the base `coe` if the drive is on EtherCAT";

/// Bits of a CAN frame.
const FRAME: u32 = 64;

/// Adds up each default PDO of drives that name a base and not `coe`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_fits_frame.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let on_can = !model.drive.bases.is_empty() && !super::based_on(model, "coe");
    for pdo in model.pdos.iter().filter(|pdo| on_can && pdo.bits() > FRAME) {
        let Some(last) = pdo.entries.last() else { continue };
        let row = super::mapped_row(pdo, last);
        let text = format!("with `{row}` PDO {:04X} has {} bits, more than {FRAME}", pdo.index, pdo.bits());
        sink.push(super::finding(CODE, last.origin.span, &row, text, WHY, HELP));
    }
}
