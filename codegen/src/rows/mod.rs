//! The rows of each table, decoded from the raw tree.
//!
//! [`tables`] lists every table once: the row structs, their decoder, the documentation of each key and the JSON schema
//! all come from that list. A row with a bad value is reported and left out; the other rows go on.

pub mod address;
pub mod cite;
mod decode;
mod define;
mod expr;
mod homing;
mod kind;
pub mod tables;
pub mod value;
mod words;

pub use decode::{Decoder, FieldInfo, TableInfo};
pub use define::{Visit, VisitMut};
pub(crate) use kind::suggest;
pub use kind::{Expected, FromRaw, Kind};
pub use tables::{ConfigurationRows, Rows};

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::Cite;
use crate::raw::RawRow;
use crate::raw::literal::{Shape, Takes};
use crate::source::{Sp, Span};

/// What a key of a table takes, for readers of formats without types of their own.
pub fn shape(table: &str, key: &str) -> Shape {
    let field = Rows::TABLES.iter().filter(|t| t.name == table).flat_map(|t| t.fields).find(|f| f.key == key);
    field.map_or(Shape { takes: Takes::Any, list: false }, |field| field.kind.shape())
}

/// A change that an erratum made to a row, or a value that it explains.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fix {
    /// Place of the erratum in the profile's list.
    pub erratum: usize,
    /// Whether the value was changed.
    pub set: bool,
}

/// What every row has besides its fields.
#[derive(Clone, Debug)]
pub struct Meta {
    /// The row as read, so that errata can compare and replace values.
    pub raw: RawRow,
    /// What errata did, by key.
    pub fixes: BTreeMap<String, Fix>,
}

impl Meta {
    /// The whole row.
    pub fn span(&self) -> Span {
        self.raw.span
    }

    /// What an erratum did to `key`.
    pub fn fix(&self, key: &str) -> Option<&Fix> {
        self.fixes.get(key)
    }

    /// Keeps what an erratum did to `key`. Of several that explain its value the first is kept, and of all the one that
    /// changes it.
    pub fn add_fix(&mut self, key: String, fix: Fix) {
        let kept = self.fixes.entry(key).or_insert_with(|| fix.clone());
        if fix.set && !kept.set {
            *kept = fix;
        }
    }
}

/// A row type.
pub trait Row: Sized {
    /// Its table.
    const TABLE: TableInfo;
    /// Decodes a row; `None` when something in it is wrong, which is then in `sink`.
    fn decode(raw: RawRow, sink: &mut Sink) -> Option<Self>;
    /// How errata, allowances and messages name the row.
    fn key(&self) -> String;
    /// Its citations, in the order of its fields.
    fn cites(&self) -> Vec<&Sp<Cite>>;
    /// What it has besides its fields.
    fn meta(&self) -> &Meta;
    /// The same, to change it.
    fn meta_mut(&mut self) -> &mut Meta;
}
