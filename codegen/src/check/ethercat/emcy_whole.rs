//! E1501: the parts of the emergency message do not make its eight bytes.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E1501", "the parts of the emergency message do not make its eight bytes");
const WHY: &str = "every part behind the difference would be read from the wrong byte";
const HELP: &str = "count the bytes of the table again; a part that holds nothing is `reserved`";

/// Bytes of an emergency message.
const BYTES: u16 = 8;

/// Adds up the parts of the emergency message: bytes 0 to 7, each once.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("emcy_whole.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let mut next = 0;
    for part in &model.emcy {
        let byte = u16::from(part.byte);
        if byte != next {
            let text = format!("`emcy {byte}` starts where byte {next} is expected");
            sink.push(super::finding(CODE, part.holds.span(), &format!("emcy {byte}"), text, WHY, HELP));
        }
        next = byte + u16::from(part.bytes.value);
    }
    let Some(last) = model.emcy.last().filter(|_| next != BYTES) else { return };
    let text = format!("`emcy {}` is the last part and ends before byte {next}, not {BYTES}", last.byte);
    sink.push(super::finding(CODE, last.bytes.span(), &format!("emcy {}", last.byte), text, WHY, HELP));
}
