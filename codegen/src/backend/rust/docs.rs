//! Doc comments: what a reader of the generated crate wants to know of an entry, with who says so.

use super::values;
use crate::backend::prose::{self, capital, errata_of, listed, outcome};
use crate::emit::escape::rust_doc;
use crate::model::{Cite, Class, Entry, Erratum, Model, Origin, Value};
use crate::name::Name;

/// Writes `text` as doc comment lines; an empty text is an empty line.
pub(super) fn comment(indent: &str, lines: &[String]) -> String {
    let line =
        |l: &String| if l.is_empty() { format!("{indent}///\n") } else { format!("{indent}/// {l}\n") };
    lines.iter().map(line).collect()
}

/// What to know of an entry.
pub(super) fn entry(entry: &Entry, model: &Model) -> Vec<String> {
    let mut lines = vec![headline(entry), String::new()];
    lines.extend(count(entry, model));
    lines.extend(parameter(entry));
    lines.extend(entry.text.as_ref().map(|t| rust_doc(t)));
    lines.extend(values::sentence(entry, model));
    lines.extend(entry.note.as_ref().map(|n| format!("Note: {}", rust_doc(n))));
    lines.extend(entry.deviation.as_ref().map(|d| format!("Deviates from the standard: {}", rust_doc(d))));
    lines.extend(said(entry));
    lines.extend(errata(entry, model));
    lines
}

fn headline(entry: &Entry) -> String {
    let mapping = prose::mapping(entry.mapping.as_ref().map(|m| m.value));
    let (name, ty, access) =
        (rust_doc(&entry.name.value), entry.ty.value.cia301_name(), entry.access.value.word());
    format!("{name}, `{}`: {ty}, {access}, {mapping}.", entry.address)
}

/// That a sub-index 0, which bears the name of its object, is a count.
fn count(entry: &Entry, model: &Model) -> Option<String> {
    let object = &model.objects[entry.object];
    let highest = object.entries.iter().map(|id| model.entries[*id].address.sub).max()?;
    let default = entry.default.as_ref().map(|d| &d.value);
    let counts = entry.address.sub == 0 && highest > 0 && default == Some(&Value::Int(highest.into()));
    counts.then(|| format!("The highest sub-index of {:04X}h.", object.index))
}

/// What the panel and the drive's manual call it, and when a new value is used.
fn parameter(entry: &Entry) -> Option<String> {
    let number = entry.parameter.as_ref().map(|p| format!("Parameter {}.", rust_doc(&p.value)));
    let effect =
        entry.effect.as_ref().map(|e| format!("A new value takes effect {}.", prose::effect(e.value)));
    let parts: Vec<String> = [number, effect].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join(" "))
}

/// Where the manual says it, and what it does not say itself.
fn said(entry: &Entry) -> Vec<String> {
    let facts: [(&'static str, Option<&Origin>); 9] = [
        ("name", Some(&entry.name.origin)),
        ("type", Some(&entry.ty.origin)),
        ("access", Some(&entry.access.origin)),
        ("mapping", entry.mapping.as_ref().map(|f| &f.origin)),
        ("unit", entry.unit.as_ref().map(|f| &f.origin)),
        ("minimum", entry.min.as_ref().map(|f| &f.origin)),
        ("maximum", entry.max.as_ref().map(|f| &f.origin)),
        ("allowed values", entry.allow.as_ref().map(|f| &f.origin)),
        ("default", entry.default.as_ref().map(|f| &f.origin)),
    ];
    let mut lines = cited(&facts);
    for (what, origin) in facts {
        let Some(origin) = origin.filter(|o| !matches!(o.class, Class::Stated)) else { continue };
        let (word, detail) = (origin.class.word(), origin.class.detail().unwrap_or_default());
        lines.push(format!("The {what} is {word}: {}.", rust_doc(detail.trim_end_matches('.'))));
    }
    lines
}

/// The place of the row, and that of each value that stands elsewhere.
fn cited<'o>(facts: &[(&'static str, Option<&'o Origin>)]) -> Vec<String> {
    let cite =
        |(what, origin): &(&'static str, Option<&'o Origin>)| Some((*what, origin.as_ref()?.cite.as_ref()?));
    let cites: Vec<(&str, &Cite)> = facts.iter().filter_map(cite).collect();
    let Some((_, row)) = cites.first() else { return Vec::new() };
    let mut lines = vec![format!("Manual: {}.", rust_doc(&row.to_string()))];
    let mut elsewhere: Vec<(&Cite, Vec<&str>)> = Vec::new();
    for (what, cite) in cites.iter().filter(|(_, cite)| cite != row) {
        match elsewhere.iter_mut().find(|(known, _)| known == cite) {
            Some((_, whats)) => whats.push(what),
            None => elsewhere.push((cite, vec![what])),
        }
    }
    lines.extend(
        elsewhere
            .iter()
            .map(|(cite, whats)| format!("Manual, the {}: {}.", listed(whats), rust_doc(&cite.to_string()))),
    );
    lines
}

/// Errata that concern it, each a paragraph.
fn errata(entry: &Entry, model: &Model) -> Vec<String> {
    let line = |e: &Erratum| {
        format!(
            "Erratum {}, {}: printed {}{}. {}",
            rust_doc(&e.id),
            rust_doc(&e.field),
            rust_doc(&e.was),
            outcome(e, rust_doc),
            rust_doc(&e.why)
        )
    };
    // Each stands on its own.
    errata_of(entry, model).flat_map(|e| [String::new(), line(e)]).collect()
}

/// What a table is, and where its values or bits are found: `Controlword: bits of 6040:00.`
pub(super) fn table(name: &Name, what: &str, used: &[&Entry]) -> String {
    let name = rust_doc(&capital(name.original()));
    let texts: Vec<String> = used.iter().map(|e| e.address.to_string()).collect();
    match texts.as_slice() {
        [] => format!("{name}: {what} that no object refers to."),
        few if few.len() < 7 => {
            format!("{name}: {what} of {}.", listed(&few.iter().map(String::as_str).collect::<Vec<_>>()))
        }
        some => format!("{name}: {what} of {} and {} more.", some[..4].join(", "), some.len() - 4),
    }
}
