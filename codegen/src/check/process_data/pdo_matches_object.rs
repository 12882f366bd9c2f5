//! E0606: a default PDO differs from its mapping object.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};

const CODE: Code = Code::error("E0606", "a default PDO differs from its mapping object");
const WHY: &str = "the manual states the default mapping twice, and a master reads the object";
const HELP: &str = "correct the table or the object. `60400010h` is object 6040h, sub-index 00h, 16 bits";

/// Compares the table `pdo` with the defaults of the mapping object: their number with sub-index 0, and each mapping word (index, sub-index, length) with sub-index 1 and on.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_matches_object.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for pdo in &model.pdos {
        let count = model.default_int(Address::new(pdo.index, 0));
        if let (Some(count), Some(last)) = (count, pdo.entries.last())
            && usize::try_from(count) != Ok(pdo.entries.len())
        {
            let text = format!(
                "`{}` is the last of {}, and {:04X}:00 counts {count}",
                super::mapped_row(pdo, last),
                pdo.entries.len(),
                pdo.index
            );
            sink.push(super::finding(CODE, last.origin.span, &super::mapped_row(pdo, last), text, WHY, HELP));
        }
    }
    for (pdo, mapped, entry) in super::mapped(model) {
        let word = mapping_word(entry.address, mapped.bits.value);
        let object = Address::new(pdo.index, mapped.position);
        if let Some(default) = model.default_int(object).filter(|d| *d != word) {
            let text = format!(
                "`{}` is {word:08X}h, and {object} defaults to {default:08X}h",
                super::mapped_row(pdo, mapped)
            );
            sink.push(super::finding(
                CODE,
                mapped.origin.span,
                &super::mapped_row(pdo, mapped),
                text,
                WHY,
                HELP,
            ));
        }
    }
}

fn mapping_word(entry: Address, bits: u8) -> i128 {
    i128::from(entry.index) << 16 | i128::from(entry.sub) << 8 | i128::from(bits)
}
