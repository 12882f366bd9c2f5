//! The committed schemas are those that the code gives, and describe every key.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::backend::json::model_schema;
use drivewright_codegen::schema::{configuration_schema, profile_schema, xsd::profile_xsd};
use serde_json::Value;

#[test]
fn schemas_are_fresh() {
    assert!(model_schema() == include_str!("../schema/model.schema.json"), "run `cargo xtask regen`");
    let configuration = include_str!("../schema/configuration.schema.json");
    assert!(configuration_schema() == configuration, "run `cargo xtask regen`");
    assert!(profile_xsd() == include_str!("../schema/profile.xsd"), "run `cargo xtask regen`");
    assert!(profile_schema() == include_str!("../schema/profile.schema.json"), "run `cargo xtask regen`");
}

/// Objects of the schema without `additionalProperties: false`, keys without a description, references to nothing.
fn gaps(schema: &Value, at: &str, root: &Value, out: &mut Vec<String>) {
    if let Some(target) = schema["$ref"].as_str() {
        let name = target.strip_prefix("#/definitions/").unwrap_or("");
        if root["definitions"].get(name).is_none() {
            out.push(format!("{at}: {target} leads nowhere"));
        }
    }
    if schema["type"] == "object" && schema["additionalProperties"] != false {
        out.push(format!("{at}: takes any key"));
    }
    for (key, property) in schema["properties"].as_object().into_iter().flatten() {
        let described = property["description"].as_str().is_some_and(|d| !d.is_empty());
        if !described && key != "value" && property["$ref"].is_null() {
            out.push(format!("{at}.{key}: no description"));
        }
        gaps(property, &format!("{at}.{key}"), root, out);
    }
    for part in ["items", "allOf"] {
        match &schema[part] {
            Value::Array(list) => list.iter().for_each(|s| gaps(s, at, root, out)),
            one if one.is_object() => gaps(one, at, root, out),
            _ => {}
        }
    }
}

fn all_gaps(schema: &Value) -> Vec<String> {
    let mut out = Vec::new();
    gaps(schema, "", schema, &mut out);
    for (name, definition) in schema["definitions"].as_object().expect("definitions") {
        gaps(definition, name, schema, &mut out);
    }
    out
}

#[test]
fn the_schema_of_the_model_is_closed_and_described() {
    let schema: Value = serde_json::from_str(&model_schema()).expect("JSON");
    assert_eq!(all_gaps(&schema), Vec::<String>::new());
}

#[test]
fn a_gap_would_be_seen() {
    let mut schema: Value = serde_json::from_str(&model_schema()).expect("JSON");
    schema["definitions"]["Entry"]["properties"]["min"]["description"] = "".into();
    schema["definitions"]["Unit"]["additionalProperties"] = true.into();
    schema["definitions"].as_object_mut().expect("definitions").remove("Alarm");
    assert_eq!(all_gaps(&schema).len(), 3, "{:#?}", all_gaps(&schema));
}
