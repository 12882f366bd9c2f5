//! Joins a profile's rows with its bases and applies errata. What comes out is still rows, every value with its place.

mod errata;

use std::collections::BTreeMap;

use crate::diag::{Diagnostic, Sink, code};
use crate::limits;
use crate::model::Address;
use crate::raw;
use crate::rows::address::Sub;
use crate::rows::tables::ObjectRow;
use crate::rows::{Row, Rows, shape, suggest};
use crate::source::{FileId, Source, SourceMap, Span};

/// A base profile with its rows.
#[derive(Clone, Debug)]
pub struct Base {
    /// Its name.
    pub name: String,
    /// Its rows.
    pub rows: Rows,
}

/// A profile after merging.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The drive's own rows, errata applied.
    pub rows: Rows,
    /// The bases it names, in order.
    pub bases: Vec<Base>,
}

/// Parses `files` of one profile and merges them.
pub fn merge(files: &[FileId], sources: &mut SourceMap, sink: &mut Sink) -> Profile {
    let mut rows = parse(files, sources, sink);
    sort(&mut rows);
    one_drive(&rows, files, sink);
    let bases = bases(&rows, sources, sink);
    errata::apply(&mut rows, sink);
    Profile { rows, bases }
}

/// The order of files and rows means nothing; where order shows, it is that of keys.
fn sort(rows: &mut Rows) {
    rows.manuals.sort_by(|a, b| a.id.value.cmp(&b.id.value));
    rows.objects.sort_by_key(|r| (r.at.value.index, r.at.value.addresses().next(), r.at.value.sub));
    // A table is called what the row of its lowest value or bit calls it.
    rows.enums.sort_by_cached_key(|r| (r.value.value, r.name.value.clone()));
    rows.bits.sort_by_cached_key(|r| (r.mode.map(|m| m.value), r.bit.value, r.name.value.clone()));
    rows.alarms.sort_by_cached_key(|r| (r.number.value, r.display.value.clone()));
    rows.pdo.sort_by_key(|r| (r.map.value, r.pos.value));
    rows.errata.sort_by(|a, b| a.id.value.cmp(&b.id.value));
}

fn parse(files: &[FileId], sources: &SourceMap, sink: &mut Sink) -> Rows {
    let mut rows = Rows::default();
    for file in files {
        for table in raw::read(*file, sources, shape, sink) {
            rows.add(table, sink);
        }
    }
    rows
}

fn one_drive(rows: &Rows, files: &[FileId], sink: &mut Sink) {
    match rows.drive.as_slice() {
        [drive] if drive.format.value != 1 => sink.push(
            Diagnostic::new(
                code::FORMAT_VERSION,
                drive.format.span,
                format!("the profile has format {}", drive.format.value),
            )
            .why("this version knows format 1 and would misread another")
            .help(
                "use the drivewright version that the profile was written for, or convert it to `format = 1`",
            ),
        ),
        [_] => {}
        [first, second, ..] => sink.push(
            Diagnostic::new(code::DRIVE_ROWS, second.meta.span(), "a second `drive`")
                .related(first.meta.span(), "the first one")
                .why("a profile describes one drive")
                .help("keep one of the two"),
        ),
        // A drive row with an error in it is reported as such.
        [] if sink.has_errors() => {}
        [] => sink.push(
            Diagnostic::new(
                code::DRIVE_ROWS,
                files.first().map_or_else(Span::nowhere, |f| Span::whole(*f)),
                "the profile has no `drive`",
            )
            .why("the drive row names the maker, the product, and the versions of what is generated")
            .help("add a file `drive.toml` with a table `[drive]`"),
        ),
    }
}

fn bases(rows: &Rows, sources: &mut SourceMap, sink: &mut Sink) -> Vec<Base> {
    let named = rows.drive.first().and_then(|d| d.bases.as_ref());
    let Some(named) = named else { return Vec::new() };
    if named.value.len() > limits::BASES {
        let text = format!("{} bases", named.value.len());
        sink.push(
            Diagnostic::new(code::TOO_MANY_BASES, named.span, text)
                .why(format!("a profile names at most {}", limits::BASES))
                .help("remove those whose objects the drive does not have"),
        );
        return Vec::new();
    }
    let known: Vec<&str> = drivewright_standard::bases().iter().map(|b| b.name).collect();
    let mut out: Vec<Base> = Vec::new();
    for name in &named.value {
        let Some(base) = drivewright_standard::bases().iter().find(|b| b.name == name.0) else {
            sink.push(
                Diagnostic::new(code::UNKNOWN_BASE, named.span, format!("there is no base `{}`", name.0))
                    .why("standard objects would lose their types")
                    .help(suggest(&name.0, &known)),
            );
            continue;
        };
        if out.iter().all(|b| b.name != name.0) {
            let files: Vec<FileId> = base.files.iter().map(|f| sources.add(f.0, f.1)).collect();
            out.push(Base { name: name.0.clone(), rows: parse(&files, sources, sink) });
        }
    }
    out
}

/// Rows of `objects` by what they state, with the place of each row in its list.
#[derive(Clone, Default, Debug)]
pub struct ObjectIndex {
    /// Rows by address; where a row of one address lies in the range of another row, the one that is more exact.
    pub entries: BTreeMap<Address, usize>,
    /// The row of a range that the row in `entries` refines.
    pub refined: BTreeMap<Address, usize>,
    /// Rows for an index as a whole.
    pub whole: BTreeMap<u16, usize>,
}

impl ObjectIndex {
    /// Indexes `rows`; an address that two rows state is reported and keeps the first. Stops once there are more
    /// entries than a drive may have, which resolving reports.
    pub fn new(rows: &[ObjectRow], sink: &mut Sink) -> Self {
        let mut index = Self::default();
        let is_range = |row: &ObjectRow| matches!(row.at.value.sub, Sub::Range(..));
        for (place, row) in rows.iter().enumerate().filter(|(_, row)| is_range(row)) {
            if index.entries.len() > limits::ENTRIES {
                return index;
            }
            let mut clash = None;
            for address in row.at.value.addresses() {
                let first = *index.entries.entry(address).or_insert(place);
                clash = clash.or((first != place).then_some(first));
            }
            if let Some(first) = clash {
                duplicate(row, &rows[first], sink);
            }
        }
        for (place, row) in rows.iter().enumerate().filter(|(_, row)| !is_range(row)) {
            match row.at.value.addresses().next() {
                None => index.whole(place, rows, sink),
                Some(address) => index.single(address, place, rows, sink),
            }
        }
        index
    }

    fn whole(&mut self, place: usize, rows: &[ObjectRow], sink: &mut Sink) {
        let first = *self.whole.entry(rows[place].at.value.index).or_insert(place);
        if first != place {
            duplicate(&rows[place], &rows[first], sink);
        }
    }

    fn single(&mut self, address: Address, place: usize, rows: &[ObjectRow], sink: &mut Sink) {
        match self.entries.insert(address, place) {
            None => {}
            Some(range) if matches!(rows[range].at.value.sub, Sub::Range(..)) => {
                self.refined.insert(address, range);
            }
            Some(first) => {
                self.entries.insert(address, first);
                duplicate(&rows[place], &rows[first], sink);
            }
        }
    }
}

/// Reports a row that states again what an earlier one states.
pub(crate) fn duplicate<R: Row>(row: &R, first: &R, sink: &mut Sink) {
    sink.push(
        Diagnostic::new(code::DUPLICATE_ROW, row.meta().span(), format!("`{}` is stated twice", row.key()))
            .label("again here")
            .related(first.meta().span(), "first here")
            .why("two rows for one thing may come to differ, and nobody could say which holds")
            .help("keep one; if the manual prints both and they differ, keep the one you trust and add an erratum"),
    );
}

/// Adds the texts of a profile to `sources`, in path order, so that the order of reading cannot matter.
pub fn add_sources(mut profile: Vec<Source>, sources: &mut SourceMap) -> Vec<FileId> {
    profile.sort_by(|a, b| a.path.cmp(&b.path));
    profile.into_iter().map(|s| sources.add(s.path, s.text)).collect()
}
