//! How the audit reads the tables of a manual, and what it cannot prove.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::Cite;
use crate::raw::RawRow;
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Ident, Sha256, Text};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// How a column of a printed table is read: the audit compares facts with the cells below its heading.
    ColumnRow in columns, key |row| { format!("column {}", row.header.value.0) } {
        /// The heading as printed, or the word in front of a cell.
        header "header": required Text,
        /// What its cells hold: `index`, `sub`, `name`, `unit`, `type`, `access`, `pdo`, `range`, `default`, or a key of a row.
        field "field": required Text,
        /// Whether the word stands in front of its cell and not above.
        beside "beside": optional bool,
    }

    /// What a printed word means in a column: the audit compares facts with the meaning.
    PrintedRow in printed, key |row| { format!("printed {}", row.word.value.0) } {
        /// The key that it is a value of.
        field "field": required Text,
        /// The word as printed.
        word "word": required Text,
        /// The word of profiles.
        means "means": required Text,
    }

    /// Lines of a printed table whose cells are out of place.
    ShiftedRow in shifted, key |row| { format!("shifted {}", row.lines.value.first().copied().unwrap_or(0)) } {
        /// The lines.
        lines "lines": required Vec<u32>,
        /// What their cells hold, in order; `-` for nothing.
        fields "fields": required Vec<Text>,
        /// What is out of place.
        why "why": required Text,
    }

    /// A fact that the audit cannot prove, or a difference between two places that is none, with the reason.
    UnprovedRow in unproved, key |row| { format!("unproved {}", row.at.value.0) } {
        /// The row, as `map.txt` names it; a `*` at the end stands for any rest.
        at "at": required Text,
        /// The key; all of the row when left out.
        field "field": optional Text,
        /// Why it is right all the same.
        why "why": required Text,
    }

    /// Lines of printed tables that no fact cites, with the reason.
    UncitedRow in uncited, key |row| { format!("uncited {}", row.lines.value.first().copied().unwrap_or(0)) } {
        /// The lines.
        lines "lines": required Vec<u32>,
        /// Why they hold no fact.
        why "why": required Text,
    }

    /// The last audit: written by `drivewright audit --record`.
    AuditedRow in audited, key |row| { format!("audited {}", row.manual.value.0) } {
        /// Id of the manual.
        manual "manual": required Ident,
        /// SHA-256 of the text extract that was read.
        extract "extract": required Sha256,
        /// SHA-256 of the list of facts.
        facts "facts": required Sha256,
        /// Facts that the cited lines hold.
        proved "proved": required u32,
        /// Facts that they do not, accepted with a reason.
        accepted "accepted": required u32,
        /// Lines of printed tables that facts cite.
        cited_lines "cited_lines": required u32,
        /// Lines of printed tables that none cites, accepted with a reason.
        uncited_lines "uncited_lines": required u32,
    }
}
