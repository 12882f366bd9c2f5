//! Whether a hostile text did more in an output than stand there: each file must have the shape that the same profile
//! with a calm text gives it.

use std::collections::{BTreeMap, BTreeSet};

use drivewright_codegen::diag::Sink;
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::raw;
use drivewright_codegen::source::SourceMap;
use proc_macro2::{TokenStream, TokenTree};
use serde_json::Value;

use super::reader;

/// The shape of each file, by path; the reason where one has none.
pub(crate) type Shapes = BTreeMap<String, Result<String, String>>;

/// What a text did that it must not. `kept` is a text that programs must read back unchanged.
pub(crate) fn harm(files: &FileSet, calm: &Shapes, kept: Option<&str>) -> Option<String> {
    let found = shapes(files);
    if !found.keys().eq(calm.keys()) {
        return Some(format!("files: {:?}", found.keys()));
    }
    let other = found.iter().find(|(path, shape)| shape.is_err() || calm.get(*path) != Some(shape));
    let judged = other.map(|(path, shape)| {
        format!(
            "{path}: {shape:#?}\nnot {:#?}\n{}",
            calm[path],
            String::from_utf8_lossy(files.get(path).unwrap_or_default())
        )
    });
    judged.or_else(|| kept.and_then(|text| lost(files, text)))
}

/// The shape of each file.
pub(crate) fn shapes(files: &FileSet) -> Shapes {
    files.iter().map(|(path, bytes)| (path.to_string(), shape(path.as_str(), bytes))).collect()
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

fn shape(path: &str, bytes: &[u8]) -> Result<String, String> {
    if path.rsplit_once('.').is_some_and(|(_, extension)| extension == "bin") {
        return categories(bytes);
    }
    let text = text(bytes);
    match path.rsplit_once('.').map(|(_, extension)| extension) {
        Some("rs") => Ok(format!("{:?} {:?}", rust(text)?, docs(text))),
        Some("eds") => sheet(text),
        Some("xml") => elements(text),
        Some("txt") if path.starts_with("sii/") => listing(text),
        Some("txt") => Ok(format!("{:?}", lines(text)?)),
        Some("json") => json(text).map(|value| kinds(&value)),
        Some("md") => Ok(format!("{:?} {:?}", lines(text)?, markup(text))),
        Some("toml") => Ok(format!("{:?} {:?}", lines(text)?, keys(text)?)),
        _ => Err("a format that nobody judges".into()),
    }
}

/// The kinds of the categories of an SII, which end with the image.
fn categories(image: &[u8]) -> Result<String, String> {
    let word = |at: usize| {
        let bytes = image.get(at..at + 2).ok_or("the image ends in a category")?;
        Ok::<_, String>(u16::from_le_bytes([bytes[0], bytes[1]]))
    };
    let (mut at, mut kinds) = (128, Vec::new());
    while word(at)? != 0xFFFF {
        kinds.push(word(at)?);
        at += 4 + 2 * usize::from(word(at + 2)?);
    }
    if at + 2 == image.len() { Ok(format!("{kinds:?}")) } else { Err("bytes behind the end".into()) }
}

/// A listing has comments, and then a line for each field; how many there are depends on which texts are the same.
fn listing(text: &str) -> Result<String, String> {
    lines(text)?;
    let (head, fields) = text.split_once("\n\n").ok_or("no field")?;
    let hex = |line: &str| line.get(..4).is_some_and(|at| at.bytes().all(|b| b.is_ascii_hexdigit()));
    let wrong = head.lines().find(|l| !l.starts_with('#')).or(fields.lines().find(|l| !hex(l)));
    wrong.map_or_else(|| Ok("comments, fields".into()), |line| Err(format!("a line of its own: {line:?}")))
}

/// The elements of a document with their attributes, in order. No text of it hides anything.
fn elements(text: &str) -> Result<String, String> {
    let document = roxmltree::Document::parse(text).map_err(|e| e.to_string())?;
    let mut out = String::new();
    for node in document.descendants() {
        let texts = node.text().into_iter().chain(node.attributes().map(|a| a.value()));
        if let Some(hidden) = texts.into_iter().find(|t| t.contains(|c| hides(c) && c != '\n')) {
            return Err(format!("hidden: {hidden:?}"));
        }
        if node.is_element() {
            let attributes: Vec<String> = node.attributes().map(|a| format!(" {}", a.name())).collect();
            let depth = node.ancestors().count();
            out.push_str(&" ".repeat(depth));
            out.push_str(node.tag_name().name());
            out.push_str(&attributes.join(","));
            out.push('\n');
        }
    }
    Ok(out)
}

/// How many lines there are. None of them holds a sign that would hide or reorder it.
fn lines(text: &str) -> Result<usize, String> {
    let hidden = text.lines().find(|line| line.contains(hides));
    hidden.map_or_else(|| Ok(text.lines().count()), |line| Err(format!("hidden: {line:?}")))
}

/// Controls and marks of direction, written here once more.
pub(crate) fn hides(c: char) -> bool {
    c.is_control()
        || "\u{61C}\u{200E}\u{200F}\u{2028}\u{2029}".contains(c)
        || ('\u{202A}'..='\u{202E}').contains(&c)
        || ('\u{2066}'..='\u{2069}').contains(&c)
}

/// The tokens of a module with their kind alone, and how many handles it has; each name is there once. Commas are left
/// out: a formatter that breaks a long line adds one.
fn rust(text: &str) -> Result<(String, usize), String> {
    let file = syn::parse_file(text).map_err(|e| e.to_string())?;
    let constants: Vec<String> = file.items.iter().filter_map(constant).collect();
    if constants.iter().collect::<BTreeSet<_>>().len() != constants.len() {
        return Err(format!("a name is there twice: {constants:?}"));
    }
    let mut kinds = String::new();
    walk(text.parse().map_err(|e| format!("{e:?}"))?, &mut |token| kinds.extend(kind(token)));
    Ok((kinds, constants.len()))
}

fn constant(item: &syn::Item) -> Option<String> {
    match item {
        syn::Item::Const(constant) => Some(constant.ident.to_string()),
        _ => None,
    }
}

fn kind(token: &TokenTree) -> Option<char> {
    match token {
        TokenTree::Group(_) => Some('('),
        TokenTree::Ident(_) => Some('i'),
        TokenTree::Literal(_) => Some('l'),
        TokenTree::Punct(sign) => Some(sign.as_char()).filter(|c| *c != ','),
    }
}

fn walk(tokens: TokenStream, see: &mut impl FnMut(&TokenTree)) {
    for token in tokens {
        see(&token);
        if let TokenTree::Group(group) = token {
            walk(group.stream(), see);
        }
    }
}

/// The markup of each line of documentation.
fn docs(text: &str) -> Vec<Vec<String>> {
    let line = |line: &str| {
        line.trim_start().strip_prefix("//").and_then(|l| l.strip_prefix(['/', '!'])).map(markup)
    };
    text.lines().filter_map(line).collect()
}

/// What Markdown, and what stands on its shoulders, would not take for plain text.
fn markup(text: &str) -> Vec<String> {
    const SIGNS: &str = "`*_[]|#~$<>";
    let mut found = Vec::new();
    let mut rest = text;
    // One blank follows the sign of a comment; four make a block of code, which rustdoc compiles.
    found.extend(text.lines().filter(|l| l.starts_with("     ") || l.starts_with("-  ")).map(str::to_owned));
    while let Some(c) = rest.chars().next() {
        let entity = ["&lt;", "&gt;", "&amp;"].into_iter().find(|e| rest.starts_with(e));
        let link = ["://", "www."].into_iter().find(|l| rest.starts_with(l));
        if c == '&' && entity.is_none() || SIGNS.contains(c) || link.is_some() {
            found.push(link.map_or_else(|| c.to_string(), str::to_owned));
        }
        let escaped =
            rest[c.len_utf8()..].chars().next().filter(|next| c == '\\' && next.is_ascii_punctuation());
        rest = &rest[c.len_utf8() + escaped.map_or(0, char::len_utf8)..];
    }
    found
}

/// The sections with their keys, and each object without names. Comments may be longer.
fn sheet(text: &str) -> Result<String, String> {
    let sections = reader::read(text.as_bytes())?;
    let mut objects = reader::dictionary(&sections)?;
    for object in objects.values_mut() {
        object.0.clear();
        object.2.values_mut().for_each(|entry| entry.name.clear());
    }
    let keys = |(name, keys): (&String, &reader::Keys)| {
        let known: Vec<&str> = keys.keys().map(String::as_str).filter(|_| name != "Comments").collect();
        format!("[{name}] {}", known.join(" "))
    };
    let keys: Vec<String> = sections.iter().map(keys).collect();
    Ok(format!("{keys:?} {objects:?}"))
}

fn json(text: &str) -> Result<Value, String> {
    serde_json::from_str(text).map_err(|e| e.to_string())
}

/// Keys and kinds of a JSON value.
fn kinds(value: &Value) -> String {
    match value {
        Value::Object(map) => map.iter().flat_map(|(key, value)| [key.clone(), kinds(value)]).collect(),
        Value::Array(list) => format!("[{}]", list.iter().map(kinds).collect::<String>()),
        Value::String(_) => "s".into(),
        Value::Number(_) => "n".into(),
        other => other.to_string(),
    }
}

/// The tables of a manifest with their keys.
fn keys(text: &str) -> Result<Vec<String>, String> {
    let (mut map, mut sink) = (SourceMap::default(), Sink::default());
    let file = map.add("Cargo.toml", text);
    let tables = raw::toml::read(file, &map, &mut sink);
    if sink.has_errors() {
        return Err(format!("{:?}", sink.as_slice()));
    }
    let rows = tables.iter().flat_map(|t| t.rows.iter().map(move |r| (t, r)));
    Ok(rows
        .flat_map(|(t, r)| r.fields.iter().map(move |f| format!("{}.{}", t.name.value, f.key.value)))
        .collect())
}

/// Whether programs that read the crate or the JSON cannot find `wanted` as it was written.
fn lost(files: &FileSet, wanted: &str) -> Option<String> {
    let (mut in_json, mut in_rust) = (false, false);
    for (path, bytes) in files.iter() {
        if path.as_str() == "model.json" {
            strings(&json(text(bytes)).expect("judged before"), &mut |s| in_json |= s == wanted);
        } else if path.as_str().starts_with("src/") {
            let tokens = text(bytes).parse().expect("judged before");
            walk(tokens, &mut |token| in_rust |= literal(token).is_some_and(|l| l == wanted));
        }
    }
    let missing = [("model.json", in_json), ("the crate", in_rust)].into_iter().find(|(_, found)| !found);
    missing.map(|(place, _)| format!("{place} does not say {wanted:?}"))
}

/// The text of a string literal.
fn literal(token: &TokenTree) -> Option<String> {
    let TokenTree::Literal(literal) = token else { return None };
    syn::parse_str::<syn::LitStr>(&literal.to_string()).ok().map(|l| l.value())
}

fn strings(value: &Value, see: &mut impl FnMut(&str)) {
    match value {
        Value::String(text) => see(text),
        Value::Array(list) => list.iter().for_each(|v| strings(v, see)),
        Value::Object(map) => map.values().for_each(|v| strings(v, see)),
        _ => {}
    }
}
