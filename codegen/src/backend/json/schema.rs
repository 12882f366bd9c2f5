//! The JSON schema of `model.json`, made from the same structs that write it.
//!
//! Draft 7, and only its plain parts, so that every validator understands it.

use serde_json::{Map, Value, json};

use super::shape::Document;
use super::value::{Integer, Known, Word, Words};

/// A type that the schema can describe.
pub(super) trait Shape {
    /// Its schema; structs add themselves to `definitions` and give a reference.
    fn schema(definitions: &mut Map<String, Value>) -> Value;
}

/// A struct of [`super::shape`].
pub(super) trait Struct {
    /// Its name.
    const NAME: &'static str;
    /// What it is.
    const DOC: &'static str;
    /// Its keys.
    const FIELDS: &'static [Field];
}

/// A key of a struct.
pub(super) struct Field {
    /// The key.
    pub(super) key: &'static str,
    /// What it means.
    pub(super) doc: &'static str,
    /// Whether it is always there.
    pub(super) required: bool,
    /// The schema of its value.
    pub(super) schema: fn(&mut Map<String, Value>) -> Value,
}

/// The schema as JSON text, ending with a line feed.
pub fn model_schema() -> String {
    let mut definitions = Map::new();
    let root = object::<Document<'_>>(&mut definitions);
    let mut schema = json!({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "drivewright model.json, format 1",
    });
    schema["definitions"] = Value::Object(definitions);
    for key in ["description", "type", "properties", "required", "additionalProperties"] {
        schema[key] = root[key].clone();
    }
    schema["properties"]["format"]["const"] = json!(1);
    format!("{schema:#}\n")
}

fn object<T: Struct>(definitions: &mut Map<String, Value>) -> Value {
    let mut properties = Map::new();
    for field in T::FIELDS {
        let mut schema = (field.schema)(definitions);
        // Readers of draft 7 ignore what stands beside a reference.
        if schema.get("$ref").is_some() {
            schema = json!({ "allOf": [schema] });
        }
        schema["description"] = json!(field.doc.trim());
        properties.insert(field.key.to_owned(), schema);
    }
    let required: Vec<&str> = T::FIELDS.iter().filter(|f| f.required).map(|f| f.key).collect();
    json!({
        "description": T::DOC.trim(),
        "type": "object",
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}

impl<T: Struct> Shape for T {
    fn schema(definitions: &mut Map<String, Value>) -> Value {
        if !definitions.contains_key(T::NAME) {
            let schema = object::<T>(definitions);
            definitions.insert(T::NAME.to_owned(), schema);
        }
        json!({ "$ref": format!("#/definitions/{}", T::NAME) })
    }
}

macro_rules! plain {
    ($($ty:ty: $schema:expr;)+) => {$(
        impl Shape for $ty {
            fn schema(_: &mut Map<String, Value>) -> Value {
                $schema
            }
        }
    )+};
}

plain! {
    &str: json!({ "type": "string" });
    String: json!({ "type": "string" });
    bool: json!({ "type": "boolean" });
    i8: json!({ "type": "integer", "minimum": i8::MIN, "maximum": i8::MAX });
    u8: json!({ "type": "integer", "minimum": 0, "maximum": u8::MAX });
    u16: json!({ "type": "integer", "minimum": 0, "maximum": u16::MAX });
    u32: json!({ "type": "integer", "minimum": 0, "maximum": u32::MAX });
    Integer: json!({ "oneOf": [
        { "type": "integer", "minimum": -Integer::EXACT, "maximum": Integer::EXACT },
        { "type": "string", "pattern": "^-?[0-9]{16,20}$" },
    ] });
}

impl<T: Words> Shape for Word<T> {
    fn schema(_: &mut Map<String, Value>) -> Value {
        json!({ "type": "string", "enum": T::all() })
    }
}

impl<T: Shape> Shape for Vec<T> {
    fn schema(definitions: &mut Map<String, Value>) -> Value {
        json!({ "type": "array", "items": T::schema(definitions) })
    }
}

/// What a value can have beside it: key, and what it means.
const BESIDE: &[(&str, &str)] = &[
    ("class", "How the value is known."),
    ("cite", "Where the manual says it: manual, section, table (T) and lines (L) of the text extract."),
    ("rule", "The rule by which an inferred value follows from the manual."),
    ("base", "The base that says a standard value."),
    ("reason", "Why an assumed value is this one: no manual states it."),
    ("erratum", "Id of the erratum that set the value or that explains it."),
];

impl<T: Shape> Shape for Known<'_, T> {
    fn schema(definitions: &mut Map<String, Value>) -> Value {
        let mut properties = Map::new();
        properties.insert("value".to_owned(), T::schema(definitions));
        for (key, doc) in BESIDE {
            let mut schema = json!({ "type": "string", "description": doc });
            if *key == "class" {
                schema["enum"] = json!(["stated", "inferred", "standard", "assumed"]);
            }
            definitions.insert((*key).to_owned(), schema);
            properties.insert((*key).to_owned(), json!({ "$ref": format!("#/definitions/{key}") }));
        }
        json!({
            "type": "object",
            "properties": properties,
            "required": ["value", "class"],
            "additionalProperties": false,
        })
    }
}
