//! E0601: a PDO carries an entry that cannot be mapped in its direction.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Mapping, Model};

const CODE: Code = Code::error("E0601", "a PDO carries an entry that cannot be mapped in its direction");
const WHY: &str =
    "the drive would refuse the mapping with abort 0604 0041, or the profile has the wrong column";
const HELP: &str = "correct `pdo` of the entry, or the mapping";

/// Compares the direction of a PDO with `pdo` of each entry that it carries.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_entry_mappable.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (pdo, mapped, entry) in super::mapped(model) {
        let allowed = entry.mapping.as_ref().map(|m| m.value);
        let ok = allowed.is_some_and(|m| m.has(pdo.direction));
        if !ok {
            let (address, word) = (entry.address, allowed.map_or("not stated", Mapping::word));
            let text =
                format!("`{}` carries {address}, whose mapping is {word}", super::mapped_row(pdo, mapped));
            sink.push(
                super::finding(CODE, mapped.origin.span, &super::mapped_row(pdo, mapped), text, WHY, HELP)
                    .related(entry.name.span(), "the entry"),
            );
        }
    }
}
