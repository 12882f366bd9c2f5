//! What numbers an entry takes, as a sentence of documentation and as literals of code.

use super::number::{grouped, hex};
use crate::backend::prose::{allow, always, capital, default, digits, named, range};
use crate::emit::escape::rust_doc;
use crate::model::{Entry, Model};

/// `In 0.1 rpm; 0 to 60000 (0 to 6000 rpm); default 500 (50 rpm).`
pub(super) fn sentence(entry: &Entry, model: &Model) -> Option<String> {
    let unit = entry.unit.as_ref().map(|u| format!("In {}", rust_doc(&u.value.text)));
    let names = entry.values.as_ref().map(|v| &model.enums[v.value]);
    let parts = if let Some(n) = always(entry) {
        [unit, Some(format!("always {}", named(entry, n, names, rust_doc))), None, None]
    } else {
        // Where a list has the names, the default need not say them again.
        let unlisted = names.filter(|_| entry.allow.is_none());
        let default = default(entry, unlisted, rust_doc).map(|d| format!("default {d}"));
        [unit, range(entry, rust_doc), allow(entry, names, rust_doc), default]
    };
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let text = capital(&parts.join("; "));
    (!text.is_empty()).then(|| format!("{text}."))
}

/// A literal.
pub(super) fn literal(entry: &Entry, n: i128) -> String {
    match digits(entry) {
        Some(digits) if n > 9 => hex(n, digits),
        _ => grouped(n),
    }
}
