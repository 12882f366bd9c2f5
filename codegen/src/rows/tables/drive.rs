//! The drive, its documents, and what is wrong or accepted in them.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::{Cite, Sure};
use crate::raw::{RawRow, RawValue};
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Date, Ident, Sha256, Text, Version};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// The drive: one row.
    DriveRow in drive, key |_row| { "drive".to_owned() } {
        /// Version of the profile format: 1.
        format "format": required u32,
        /// Short id of the drive.
        id "id": required Ident,
        /// The maker's name.
        vendor "vendor": required Text,
        /// Short id of the maker; the generated package is `<vendor_id>-<id>`.
        vendor_id "vendor_id": required Ident,
        /// Product name.
        name "name": required Text,
        /// Bases whose objects the drive implements, in order.
        bases "bases": optional Vec<Ident>,
        /// Version of the generated crate.
        crate_version "crate_version": required Version,
        /// `FileVersion` of the EDS.
        eds_version "eds_version": required u8,
        /// `FileRevision` of the EDS.
        eds_revision "eds_revision": required u8,
        /// Date of the profile's last change.
        date "date": required Date,
        /// Most entries of one PDO.
        pdo_entries "pdo_entries": optional u8,
        /// Most bytes of one PDO.
        pdo_bytes "pdo_bytes": optional u16,
        /// Most PDOs of one direction that can be active together.
        pdos_per_direction "pdos_per_direction": optional u8,
        /// Where the limits of PDOs are printed.
        pdo_src "pdo_src": optional Cite,
        /// A remark for the reader.
        note "note": optional Text,
    }

    /// A document that facts cite. It is named, never contained.
    ManualRow in manuals, key |row| { format!("manual {}", row.id.value.0) } {
        /// Id in citations: `m1`.
        id "id": required Ident,
        /// Title as printed.
        title "title": required Text,
        /// Version as printed.
        version "version": required Text,
        /// Date as printed.
        date "date": optional Text,
        /// SHA-256 of the text extract whose lines are cited.
        sha256 "sha256": required Sha256,
        /// Lines of the text extract.
        lines "lines": required u32,
    }

    /// A place where the manual is wrong or contradicts itself.
    ErratumRow in errata, key |row| { format!("erratum {}", row.id.value.0) } {
        /// Id, unique in the profile.
        id "id": required Text,
        /// The row: `607D:01`, `alarm OF` or `alarm OF 0x25`, `pdo 1600:1`, `enum NAME=1`, `bits NAME.4`, `drive`.
        at "at": required Text,
        /// The key of that row.
        field "field": required Text,
        /// What is printed; the row must hold this.
        was "was": required RawValue,
        /// Where it is printed.
        seen "seen": required Cite,
        /// The value to use instead; left out, the printed one is kept.
        set "set": optional RawValue,
        /// `true`: the printed value is dropped and nothing takes its place, since no reading of it can be trusted.
        unset "unset": optional bool,
        /// Where the other reading is printed.
        by "by": optional Cite,
        /// Why.
        why "why": required Text,
        /// How sure.
        sure "sure": required Sure,
    }

    /// A finding of a lint that is accepted, with the reason.
    AllowRow in allow, key |row| { format!("allow {} {}", row.lint.value.0, row.at.value.0) } {
        /// The lint's code.
        lint "lint": required Text,
        /// The row that it concerns, as messages name it.
        at "at": required Text,
        /// Why it is accepted.
        why "why": required Text,
    }
}

impl ErratumRow {
    /// Whether the printed value is dropped.
    pub fn drops(&self) -> bool {
        self.unset.is_some_and(|unset| unset.value)
    }
}
