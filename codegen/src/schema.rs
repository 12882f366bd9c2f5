//! JSON schemas of profile and configuration files, for completion and hints in editors, made from the same list of tables that decodes them.
//!
//! Draft 7, and only its plain parts: that is what TOML language servers understand.

pub mod xsd;

use serde_json::{Map, Value, json};

use crate::limits;
use crate::rows::{ConfigurationRows, FieldInfo, Kind, Rows, TableInfo};

/// The schema of a profile file as JSON text, ending with a line feed.
pub fn profile_schema() -> String {
    let about = "A file of a drive profile: tables of rows, one row a fact. A key that is left out means that the manual does not say.";
    schema("drivewright profile, format 1", about, Rows::TABLES)
}

/// The schema of a configuration file, the same way.
pub fn configuration_schema() -> String {
    let about = "A configuration of one drive: what a master writes to it. What is left out stays as it is.";
    schema("drivewright configuration, format 1", about, ConfigurationRows::TABLES)
}

fn schema(title: &str, about: &str, tables: &[TableInfo]) -> String {
    let tables: Map<String, Value> = tables.iter().map(|t| (t.name.to_owned(), table(t))).collect();
    let schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": title,
        "description": about,
        "type": "object",
        "additionalProperties": false,
        "properties": tables,
    });
    format!("{schema:#}\n")
}

/// Tables that are one row.
const SINGLE: [&str; 2] = ["drive", "axis"];

/// A table is a list of rows, or one row.
fn table(table: &TableInfo) -> Value {
    let mut row = row(table);
    if SINGLE.contains(&table.name) {
        row["description"] = json!(table.doc.trim());
        return row;
    }
    json!({ "description": table.doc.trim(), "type": "array", "maxItems": limits::ROWS, "items": row })
}

fn row(table: &TableInfo) -> Value {
    let properties: Map<String, Value> = table.fields.iter().map(|f| (f.key.to_owned(), field(f))).collect();
    let required: Vec<&str> = table.fields.iter().filter(|f| f.required).map(|f| f.key).collect();
    json!({ "type": "object", "additionalProperties": false, "properties": properties, "required": required })
}

fn field(field: &FieldInfo) -> Value {
    let mut value = kind(&field.kind);
    value["description"] = json!(field.doc.trim());
    value
}

fn kind(of: &Kind) -> Value {
    match of {
        Kind::Text(None) => json!({ "type": "string", "minLength": 1, "maxLength": limits::TEXT_BYTES }),
        Kind::Text(Some(pattern)) => json!({ "type": "string", "pattern": pattern }),
        Kind::Words(words) => json!({ "type": "string", "enum": words() }),
        Kind::Int(low, high) => {
            json!({ "type": "integer", "minimum": number(*low), "maximum": number(*high) })
        }
        Kind::Bool => json!({ "type": "boolean" }),
        Kind::Scalar => json!({ "type": ["integer", "string", "boolean", "array"] }),
        Kind::List(item) => json!({ "type": "array", "maxItems": limits::LIST_VALUES, "items": kind(item) }),
    }
}

/// A bound as JSON holds it; every kind's bounds lie between those of i64 and u64.
fn number(n: i128) -> Value {
    i64::try_from(n).map_or_else(|_| u64::try_from(n).map_or(Value::Null, Value::from), Value::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_and_key_has_a_description() {
        let schemas = [(profile_schema(), Rows::TABLES), (configuration_schema(), ConfigurationRows::TABLES)];
        for (schema, table) in schemas.iter().flat_map(|(text, tables)| tables.iter().map(move |t| (text, t)))
        {
            let schema: Value = serde_json::from_str(schema).unwrap();
            let shape = &schema["properties"][table.name];
            assert!(shape["description"].as_str().is_some_and(|d| !d.is_empty()), "{}", table.name);
            let row = if SINGLE.contains(&table.name) { shape } else { &shape["items"] };
            for field in table.fields {
                let described = row["properties"][field.key]["description"].as_str();
                assert!(described.is_some_and(|d| !d.is_empty()), "{}.{}", table.name, field.key);
            }
        }
    }
}
