//! E1503: the control byte of a sync manager contradicts its use.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, SyncManagerUse};

const CODE: Code = Code::error("E1503", "the control byte of a sync manager contradicts its use");
const WHY: &str = "a master writes the byte into the slave controller, which would then refuse the transfers";
const HELP: &str = "bits 0 and 1: 10b for a mailbox, 00b for process data; bits 2 and 3: 01b if the master writes, 00b if it reads";

/// Looks at mode and direction in the control byte of each sync manager.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("control_fits_use.md"), run };

/// Mode in bits 0 and 1, direction in bits 2 and 3.
const MASK: u8 = 0b1111;

fn expected(carries: SyncManagerUse) -> u8 {
    match carries {
        SyncManagerUse::MailboxOut => 0b0110,
        SyncManagerUse::MailboxIn => 0b0010,
        SyncManagerUse::Outputs => 0b0100,
        SyncManagerUse::Inputs => 0b0000,
    }
}

fn run(model: &Model, sink: &mut Sink) {
    for manager in &model.sync_managers {
        let wanted = expected(manager.carries.value);
        let Some(control) = manager.control.as_ref().filter(|c| c.value & MASK != wanted) else { continue };
        let row = format!("sync manager {}", manager.number);
        let word = manager.carries.value.word();
        let text = format!(
            "`{row}` carries {word}, and bits 0 to 3 of {:02X}h are {:04b}b, not {wanted:04b}b",
            control.value,
            control.value & MASK
        );
        sink.push(super::finding(CODE, control.span(), &row, text, WHY, HELP));
    }
}
