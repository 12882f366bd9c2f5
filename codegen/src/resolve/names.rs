//! Names are unique by words in their scope: a clash asks for `rename`, because a suffix would move when rows are added.

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Sink, code};
use crate::model::Model;
use crate::name::{Case, Name};
use crate::rows::value::Printed;
use crate::source::{Sp, Span};

/// The name that code uses: the printed one, or `rename`.
pub(super) fn used(printed: &Sp<Printed>, rename: Option<&Sp<Name>>, sink: &mut Sink) -> Sp<Name> {
    if let Some(rename) = rename {
        return rename.clone();
    }
    let Printed(name) = &printed.value;
    if name.words().is_empty() {
        sink.push(
            Diagnostic::new(code::NAME_EMPTY, printed.span, format!("`{name}` has no ASCII letter or digit"))
                .why("names of generated code are made of them")
                .help("keep the name as printed and add `rename = \"...\"` with an English one"),
        );
    }
    Sp::new(name.clone(), printed.span)
}

/// Reports every clash in every scope.
pub(super) fn check_unique(model: &Model, sink: &mut Sink) {
    let handles = model.entries.iter().map(|(_, e)| (&e.handle, e.name.span()));
    scope("objects", handles, Case::Snake, sink);
    let enums = model.enums.iter().filter_map(|(_, e)| e.values.first().map(|v| (&e.name, v.name.span())));
    let bits = model.bits.iter().filter_map(|(_, b)| b.fields.first().map(|f| (&b.name, f.name.span())));
    scope("value and bit tables", enums.chain(bits), Case::Pascal, sink);
    for (_, table) in model.enums.iter() {
        scope(
            &format!("values of `{}`", table.name),
            table.values.iter().map(|v| (&v.name.value, v.name.span())),
            Case::Snake,
            sink,
        );
    }
    for (_, table) in model.bits.iter() {
        let names: Vec<(Name, Span)> =
            table.fields.iter().map(|f| (f.scoped_name(), f.name.span())).collect();
        scope(
            &format!("bits of `{}`", table.name),
            names.iter().map(|(name, span)| (name, *span)),
            Case::Snake,
            sink,
        );
    }
    scope("alarms", model.alarms.iter().map(|a| (&a.name.value, a.name.span())), Case::Snake, sink);
}

/// Two names clash when they look the same in the case in which code writes them.
fn scope<'a>(what: &str, names: impl Iterator<Item = (&'a Name, Span)>, case: Case, sink: &mut Sink) {
    let mut seen: BTreeMap<String, (&Name, Span)> = BTreeMap::new();
    // A name without words is reported as such.
    for (name, span) in names.filter(|(name, _)| !name.words().is_empty()) {
        let key = name.to_identifier(case);
        let Some((first, at)) = seen.get(&key) else {
            seen.insert(key, (name, span));
            continue;
        };
        sink.push(
            Diagnostic::new(code::NAME_CLASH, span, format!("`{name}` and `{first}` are one name among {what}"))
                .label(format!("`{key}` again"))
                .related(*at, "first here")
                .why("a number behind one of them would change its meaning when a row is added, and break users in silence")
                .help("give one of the rows `rename = \"...\"`"),
        );
    }
}
