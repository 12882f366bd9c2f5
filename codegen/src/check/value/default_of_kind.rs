//! E0411: a default is text where the type is a number, or the other way round.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, Type, Value};

const CODE: Code =
    Code::error("E0411", "a default is text where the type is a number, or the other way round");
const WHY: &str = "it could not be encoded";
const HELP: &str =
    "write the raw number, or `$NODEID+0x200` where it depends on the node; keep text for strings";

/// Compares the kind of `default` with the kind of the type. A formula of the node-ID is a number.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("default_of_kind.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let Some(default) = &entry.default else { continue };
        let text_type = matches!(
            entry.ty.value,
            Type::VisibleString | Type::UnicodeString | Type::OctetString | Type::Domain
        );
        let formula = entry.default_beside_node_id().is_some();
        if !formula && text_type != matches!(default.value, Value::Text(_)) {
            let text = format!(
                "default {} of `{}` is no value of type {}",
                default.value, entry.address, entry.ty.value
            );
            sink.push(
                super::finding(CODE, default.span(), &entry.address, text, WHY, HELP)
                    .related(entry.ty.span(), "the type"),
            );
        }
    }
}
