//! A configuration: what a user sets in one drive, and what a master writes for it, in order.
//!
//! [`read`] takes a text of the format that `rows/tables/configuration.rs` lists and checks it against the model of the
//! drive; every mistake is found in one run. [`crate::dcf`] prints the result.

mod axis;
pub mod code;
mod order;
mod pdo;
mod rules;
mod setting;

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Sink, code as profile_code};
use crate::model::{Address, Model};
use crate::raw::{self, RawTable};
use crate::rows::ConfigurationRows;
use crate::source::{FileId, Source, SourceMap};
use setting::Settings;

/// A configuration without mistakes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Configuration {
    /// Node-ID, 1 to 127.
    pub node_id: u8,
    /// Name of the node.
    pub name: Option<String>,
    /// Bit rate of the CAN bus, in kbit/s.
    pub bit_rate: Option<u16>,
    /// Number of the network.
    pub network: Option<u32>,
    /// Serial number of the one drive that it is for.
    pub serial: Option<u32>,
    /// What a master writes, in order.
    pub writes: Vec<Write>,
}

/// A value that a master writes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Write {
    /// The object.
    pub address: Address,
    /// The raw value, in the range of its type.
    pub value: i128,
    /// How many bytes it has over SDO.
    pub bytes: u8,
}

impl Configuration {
    /// What the written objects hold in the end.
    pub fn values(&self) -> BTreeMap<Address, i128> {
        self.writes.iter().map(|write| (write.address, write.value)).collect()
    }
}

/// Reads the configuration in `source` for the drive of `model`. The text is added to `sources`, those of the drive's
/// profile, so that findings can point to both. There is no configuration if one of them is an error.
pub fn read(
    source: Source,
    model: &Model,
    sources: &mut SourceMap,
) -> (Option<Configuration>, Vec<Diagnostic>) {
    let mut sink = Sink::default();
    let file = sources.add(source.path, source.text);
    let rows = decode(file, sources, &mut sink);
    let found = check(&rows, file, model, &mut sink);
    let sound = !sink.has_errors();
    (found.filter(|_| sound), sink.into_sorted(sources))
}

fn decode(file: FileId, sources: &SourceMap, sink: &mut Sink) -> ConfigurationRows {
    let mut rows = ConfigurationRows::default();
    for mut table in raw::toml::read(file, sources, sink) {
        tables_below(&mut table, sink);
        rows.add(table, sink);
    }
    rows
}

/// Takes out and reports tables below the header of another one: TOML reads them as its keys.
fn tables_below(table: &mut RawTable, sink: &mut Sink) {
    let is_table = |key: &str| ConfigurationRows::TABLES.iter().any(|t| t.name == key);
    for row in &mut table.rows {
        for field in row.fields.extract_if(.., |field| is_table(&field.key.value)) {
            let (key, header) = (&field.key.value, &table.name.value);
            let text = format!("`{key}` stands below `[{header}]`");
            sink.push(
                Diagnostic::new(code::TABLE_BELOW, field.key.span, text)
                    .why("in TOML all that follows a header belongs to it, up to the next one")
                    .help(format!("move `{key} = [...]` above `[{header}]`, or write rows as `[[{key}]]`")),
            );
        }
    }
}

fn check(rows: &ConfigurationRows, file: FileId, model: &Model, sink: &mut Sink) -> Option<Configuration> {
    let axis = axis::check(rows, file, model, sink)?;
    let mut settings = Settings::default();
    setting::add_values(&rows.values, model, &mut settings, sink);
    let pdos = pdo::check(rows, axis.node_id, model, sink);
    let writes = order::writes(model, &settings, &pdos);
    let configuration = Configuration { writes, ..axis };
    // What the mistakes before have left out would only be missed again.
    if !sink.has_errors() {
        rules::check(model, &configuration, &settings, &pdos, sink);
        pdo::overwritten(&settings, &pdos, sink);
        pdo::inactive(model, &configuration, &pdos, sink);
    }
    Some(configuration)
}
