//! What the list of tables in [`super::tables`] turns into: row structs, their decoders, and the struct of all tables.

use std::collections::BTreeSet;

use super::Row;
use super::decode::TableInfo;
use super::kind::suggest;
use crate::diag::{Diagnostic, Sink, code};
use crate::raw::{RawRow, RawValue};
use crate::source::Sp;

macro_rules! field_type {
    (required $ty:ty) => { Sp<$ty> };
    (optional $ty:ty) => { Option<Sp<$ty>> };
}

macro_rules! finish {
    (required $field:ident) => {
        $field?
    };
    (optional $field:ident) => {
        $field
    };
}

/// The field, if it is a citation.
macro_rules! cite {
    (required $this:ident.$field:ident) => {
        FromRaw::cite(&$this.$field)
    };
    (optional $this:ident.$field:ident) => {
        $this.$field.as_ref().and_then(FromRaw::cite)
    };
}

macro_rules! is_required {
    (required) => {
        true
    };
    (optional) => {
        false
    };
}

/// Defines the row structs and their decoders.
macro_rules! rows {
    ($(
        $(#[doc = $doc:literal])+
        $row:ident in $table:ident, key |$this:ident| $row_key:block {
            $( $(#[doc = $field_doc:literal])+ $field:ident $key:literal: $need:ident $ty:ty, )+
        }
    )+) => {
        $(
            $(#[doc = $doc])+
            #[derive(Clone, Debug)]
            pub struct $row {
                $( $(#[doc = $field_doc])+ pub $field: $crate::rows::define::field_type!($need $ty), )+
                /// The row as read, and what errata did to it.
                pub meta: Meta,
            }

            impl Row for $row {
                const TABLE: TableInfo = TableInfo {
                    name: stringify!($table),
                    doc: concat!($($doc),+),
                    fields: &[$( FieldInfo {
                        key: $key,
                        doc: concat!($($field_doc),+),
                        required: $crate::rows::define::is_required!($need),
                        kind: <$ty as FromRaw>::KIND,
                    } ),+],
                };

                fn decode(raw: RawRow, sink: &mut Sink) -> Option<Self> {
                    let mut decoder = Decoder::new(&raw, Self::TABLE, sink);
                    $( let $field = decoder.$need::<$ty>($key); )+
                    if !decoder.finish() {
                        return None;
                    }
                    Some(Self { $( $field: $crate::rows::define::finish!($need $field), )+ meta: Meta { raw, fixes: BTreeMap::new() } })
                }

                fn key(&self) -> String {
                    let $this = self;
                    $row_key
                }

                fn cites(&self) -> Vec<&Sp<Cite>> {
                    let mut cites = Vec::new();
                    $( cites.extend($crate::rows::define::cite!($need self.$field)); )+
                    cites
                }

                fn meta(&self) -> &Meta {
                    &self.meta
                }

                fn meta_mut(&mut self) -> &mut Meta {
                    &mut self.meta
                }
            }
        )+
    };
}

/// Defines a struct of tables.
macro_rules! tables {
    ($(#[doc = $doc:literal])+ $rows:ident { $( $table:ident: $row:ident, )+ }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Default, Debug)]
        pub struct $rows {
            $( #[doc = concat!("The rows of `", stringify!($table), "`.")] pub $table: Vec<$row>, )+
            /// Keys of rows that were left out because something in them is wrong; what refers to them is not reported again.
            pub left_out: BTreeSet<String>,
        }

        impl $rows {
            /// Every table of the format.
            pub const TABLES: &'static [TableInfo] = &[$(<$row as Row>::TABLE),+];

            /// Decodes `table` and adds its rows.
            pub fn add(&mut self, table: RawTable, sink: &mut Sink) {
                match table.name.value.as_str() {
                    $( stringify!($table) => $crate::rows::define::decode_rows(table.rows, &mut self.$table, &mut self.left_out, sink), )+
                    _ => $crate::rows::define::unknown_table(&table.name, Self::TABLES, sink),
                }
            }

            /// Shows every table to `visitor`.
            pub fn visit<'a>(&'a self, visitor: &mut impl Visit<'a>) {
                $( visitor.table(&self.$table); )+
            }

            /// Hands every table to `visitor`.
            pub fn visit_mut(&mut self, visitor: &mut impl VisitMut) {
                $( visitor.table(&mut self.$table); )+
            }
        }
    };
}

pub(super) use {cite, field_type, finish, is_required, rows, tables};

/// Looks at the rows of every table.
pub trait Visit<'a> {
    /// One table.
    fn table<R: Row>(&mut self, rows: &'a [R]);
}

/// Changes the rows of every table.
pub trait VisitMut {
    /// One table.
    fn table<R: Row>(&mut self, rows: &mut [R]);
}

/// Decodes the rows of a table; those that are wrong are reported and left out.
pub(super) fn decode_rows<R: Row>(
    rows: Vec<RawRow>,
    out: &mut Vec<R>,
    left_out: &mut BTreeSet<String>,
    sink: &mut Sink,
) {
    out.reserve(rows.len());
    for raw in rows {
        let at = raw.get("at").map(|at| at.value.clone());
        match (R::decode(raw, sink), at) {
            (Some(row), _) => out.push(row),
            (None, Some(RawValue::Text(at))) => drop(left_out.insert(at.to_ascii_uppercase())),
            (None, _) => {}
        }
    }
}

/// Reports a table that the format does not have.
pub(super) fn unknown_table(name: &Sp<String>, tables: &[TableInfo], sink: &mut Sink) {
    let known: Vec<&str> = tables.iter().map(|t| t.name).collect();
    sink.push(
        Diagnostic::new(code::UNKNOWN_TABLE, name.span, format!("there is no table `{}`", name.value))
            .why("rows of a table that is not known would be lost")
            .help(suggest(&name.value, &known)),
    );
}
