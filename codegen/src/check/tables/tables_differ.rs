//! W0801: two value tables are the same.

use std::collections::BTreeMap;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{EnumDef, Model};

const CODE: Code = Code::warning("W0801", "two value tables are the same");
const WHY: &str = "each table becomes a type";
const HELP: &str = "keep one table and name it in both rows";

/// Compares the value tables of the drive with each other.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("tables_differ.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let mut seen: BTreeMap<Vec<(i128, &[String])>, &EnumDef> = BTreeMap::new();
    for (_, table) in model.enums.iter() {
        let content = table.values.iter().map(|v| (v.value, v.name.value.words())).collect();
        let (Some(first), Some(value)) = (seen.insert(content, table), table.values.first()) else {
            continue;
        };
        let text =
            format!("`enum {}={}` and its table say the same as `{}`", table.name, value.value, first.name);
        sink.push(super::finding(
            CODE,
            value.name.span(),
            &format!("enum {}={}", table.name, value.value),
            text,
            WHY,
            HELP,
        ));
    }
}
