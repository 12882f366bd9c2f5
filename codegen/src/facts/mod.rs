//! The list of facts of a model: what `map.txt` prints and what the audit counts.
//!
//! Each value that the model holds is one line. Lines come table by table, in each by key (numbers as numbers), and in
//! each row by a fixed order of fields. Nothing here escapes or aligns: that is the work of who prints a line.

mod behaviour;
mod dictionary;
mod ethercat;

use std::borrow::Cow;

use crate::model::{Cite, Class, Fact, Model, Origin, Worded};
use crate::name::Name;

/// A table of the model.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Table {
    /// The drive.
    Drive,
    /// Documents.
    Manuals,
    /// Objects and their entries.
    Objects,
    /// Named values.
    Enums,
    /// Named bits.
    Bits,
    /// Faults and warnings.
    Alarms,
    /// Default process data.
    Pdos,
    /// Homing methods and their cases.
    Homing,
    /// Modes of operation.
    Modes,
    /// States of the CiA 402 state machine.
    States,
    /// Its commands.
    Commands,
    /// Abort codes of SDO transfers.
    Aborts,
    /// Terminals.
    Terminals,
    /// The EtherCAT side: SyncManagers, FMMUs, CoE, synchronization, start-up.
    EtherCat,
    /// The emergency message.
    Emcy,
    /// Rules between values.
    Rules,
    /// Worked examples.
    Examples,
    /// Where the manual is wrong.
    Errata,
}

/// One value of the model.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FactLine<'m> {
    /// Table of the row.
    pub table: Table,
    /// The row: `object 607D:01`, `enum mode of operation 1`, `alarm OF 0x25`. With `field` it is unique.
    pub key: String,
    /// Which value of the row: `min`, `cause 2`.
    pub field: Cow<'static, str>,
    /// The value as a profile writes it; raw text, not escaped.
    pub value: String,
    /// How it is known; `None` for what is no fact of a manual but the profile's own: ids, versions, wording, judgement.
    pub class: Option<&'m Class>,
    /// Where a manual says it.
    pub cite: Option<&'m Cite>,
    /// Id of the erratum that set it or that explains it.
    pub erratum: Option<&'m str>,
}

/// How many lines there are of each class.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct Totals {
    /// A manual says it.
    pub stated: usize,
    /// It follows by a rule.
    pub inferred: usize,
    /// A base says it.
    pub standard: usize,
    /// A format demands it and nobody says it.
    pub assumed: usize,
    /// The profile's own.
    pub own: usize,
}

impl Totals {
    /// Counts `lines`.
    pub fn of(lines: &[FactLine<'_>]) -> Self {
        let mut totals = Self::default();
        for line in lines {
            *totals.place(line.class) += 1;
        }
        totals
    }

    fn place(&mut self, class: Option<&Class>) -> &mut usize {
        match class {
            Some(Class::Stated) => &mut self.stated,
            Some(Class::Inferred(_)) => &mut self.inferred,
            Some(Class::Standard(_)) => &mut self.standard,
            Some(Class::Assumed(_)) => &mut self.assumed,
            None => &mut self.own,
        }
    }

    /// All but the profile's own.
    pub fn facts(&self) -> usize {
        self.stated + self.inferred + self.standard + self.assumed
    }
}

/// Every fact of `model`.
pub fn facts(model: &Model) -> Vec<FactLine<'_>> {
    let mut lines = Lines { model, table: Table::Drive, key: String::new(), out: Vec::new() };
    dictionary::drive(&model.drive, &mut lines);
    model.manuals.iter().for_each(|m| dictionary::manual(m, &mut lines));
    model.objects.as_slice().iter().for_each(|o| dictionary::object(o, &mut lines));
    by_name(model.enums.as_slice(), |e| &e.name).for_each(|e| dictionary::enumeration(e, &mut lines));
    by_name(model.bits.as_slice(), |b| &b.name).for_each(|b| dictionary::bits(b, &mut lines));
    model.alarms.iter().for_each(|a| dictionary::alarm(a, &mut lines));
    model.pdos.iter().for_each(|p| dictionary::pdo(p, &mut lines));
    model.homing.iter().for_each(|m| behaviour::homing(m, &mut lines));
    model.modes.iter().for_each(|m| behaviour::mode(m, &mut lines));
    model.states.iter().for_each(|s| behaviour::state(s, &mut lines));
    model.commands.iter().for_each(|c| behaviour::command(c, &mut lines));
    model.aborts.iter().for_each(|a| behaviour::abort(a, &mut lines));
    model.terminals.iter().for_each(|t| behaviour::terminal(t, &mut lines));
    ethercat::ethercat(&model.ethercat, &mut lines);
    model.sync_managers.iter().for_each(|s| ethercat::sync_manager(s, &mut lines));
    model.fmmus.iter().for_each(|f| ethercat::fmmu(f, &mut lines));
    model.coe.iter().for_each(|c| ethercat::coe(c, &mut lines));
    model.dc_modes.iter().for_each(|d| ethercat::dc_mode(d, &mut lines));
    model.startup.iter().for_each(|s| ethercat::startup(s, &mut lines));
    model.emcy.iter().for_each(|e| behaviour::emcy(e, &mut lines));
    model.rules.iter().for_each(|r| behaviour::rule(r, &mut lines));
    model.examples.iter().for_each(|e| behaviour::example(e, &mut lines));
    model.errata.as_slice().iter().for_each(|e| behaviour::erratum(e, &mut lines));
    lines.out
}

/// Tables in the order of their names: those of bases come into the model in the order of use.
pub(crate) fn by_name<T>(tables: &[T], name: impl Fn(&T) -> &Name) -> impl Iterator<Item = &T> {
    let mut sorted: Vec<&T> = tables.iter().collect();
    sorted.sort_by(|a, b| name(a).words().cmp(name(b).words()));
    sorted.into_iter()
}

struct Lines<'m> {
    model: &'m Model,
    table: Table,
    key: String,
    out: Vec<FactLine<'m>>,
}

impl<'m> Lines<'m> {
    /// Starts a row.
    fn row(&mut self, table: Table, key: String) {
        (self.table, self.key) = (table, key);
    }

    /// A value of the row, and who says it.
    fn said(
        &mut self,
        field: impl Into<Cow<'static, str>>,
        value: &(impl ToString + ?Sized),
        origin: &'m Origin,
    ) {
        let erratum = origin.erratum.map(|id| self.model.errata[id].id.as_str());
        self.line(field.into(), value.to_string(), (Some(&origin.class), origin.cite.as_ref(), erratum));
    }

    fn fact<T>(&mut self, field: &'static str, fact: Option<&'m Fact<T>>, value: impl Fn(&T) -> String) {
        if let Some(fact) = fact {
            self.said(field, &value(&fact.value), &fact.origin);
        }
    }

    /// A value of the row that is the profile's own.
    fn own(&mut self, field: &'static str, value: &(impl ToString + ?Sized)) {
        self.line(field.into(), value.to_string(), (None, None, None));
    }

    fn own_text(&mut self, field: &'static str, text: Option<&String>) {
        if let Some(text) = text {
            self.own(field, text);
        }
    }

    /// The name of code, where it is not the printed one.
    fn rename(&mut self, printed: &str, name: &Name) {
        let same = || Name::new(printed).is_some_and(|p| p.words() == name.words());
        // A name that nobody chose is the printed text: that saves splitting it again.
        if name.original() != printed && !same() {
            self.own("rename", name);
        }
    }

    fn line(
        &mut self,
        field: Cow<'static, str>,
        value: String,
        (class, cite, erratum): (Option<&'m Class>, Option<&'m Cite>, Option<&'m str>),
    ) {
        self.out.push(FactLine {
            table: self.table,
            key: self.key.clone(),
            field,
            value,
            class,
            cite,
            erratum,
        });
    }
}

/// Words with blanks between.
fn words<T: Worded>(list: &[T]) -> String {
    list.iter().map(|item| item.word()).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    const PROFILE: &str = r#"
manuals = [ { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 99 } ]
objects = [
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "rx", min = 0, default = 5, parameter = "P1", effect = "at once", also = "2 L3", src = "1 L2" },
  { at = "2010", name = "Gains", text = "t", note = "n", also = "3 L4", src = "1 L3" },
  { at = "2010:00", name = "Count", type = "u8", access = "ro", default = 2, inferred = ["default: highest sub-index"], src = "1 L3" },
  { at = "2010:01..02", name = "Gain", type = "u8", access = "ro", assumed = ["access: never said"], src = "1 L3" },
]
enums = [ { name = "z", value = -1, label = "3 phase", rename = "Three phase", src = "L4" }, { name = "a", value = 10, label = "b", src = "L4" }, { name = "a", value = 9, label = "c", src = "L4" } ]
bits = [ { name = "ctl", bit = 1, width = 2, label = "run", src = "L4" } ]
alarms = [ { display = "OF", number = 0x25, code = 0x8611, name = "Following", causes = ["a", "b"], esm = ["SafeOP", "OP"], esm_after = "kept", sync = "dc", al_status = 0x1A, led = "on", src = "L8" } ]
pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "2000:00", bits = 16, src = "L10" } ]
homing = [
  { method = 1, case = 1, start = "negative", approach = "home", reference = "home", side = "negative", edge = "rising", when = "home off", moves = "- fast until home on; latch", abort = "positive_limit on", mask = ["negative_limit"], text = "t", src = "L12" },
  { method = 1, case = 2, when = "home on", moves = "done", src = "L13" },
  { method = 2, same = 1, src = "L14" },
]
modes = [ { mode = 1, name = "Position", objects = ["2000:00"], src = "L15" } ]
states = [ { name = "Fault", mask = 0x4F, value = 0x08, src = "L16" } ]
commands = [ { name = "Reset", mask = 0x80, value = 0x80, edge = true, transitions = [15], src = "L17" } ]
aborts = [ { code = 0x06020000, name = "No such object", src = "L18" } ]
io = [ { terminal = "DI1", kind = "input", pin = 1, object = "2000:00", bit = 2, parameter = "P1", src = "L19" } ]
ethercat = [ { type = "X1-E", group = "Drives", physics = "YY", revision_check = "equal", mailbox = ["coe"], config = [1, 2, 3, 4, 5, 6, 7], bootstrap = [1, 2, 3, 4], eeprom_bytes = 2048, src = "L20" } ]
sync_managers = [ { number = 0, use = "mailbox out", start = 0x1000, size = 128, min_size = 34, max_size = 128, control = 0x26, enable = true, src = "L20" } ]
fmmus = [ { number = 0, use = "outputs", src = "L21" } ]
coe = [ { feature = "pdo upload", supported = false, src = "L21" } ]
dc_modes = [ { number = 1, name = "DC", sync = "sync0", assign_activate = 0x300, cycle0 = 1, shift0 = -2, cycle1 = 3, shift1 = -4, text = "t", src = "L21" } ]
startup = [ { number = 1, transition = "PS", write = "2000:00", value = 1, text = "t", src = "L21" } ]
emcy = [ { byte = 0, bytes = 2, holds = "error code", src = "L22" }, { byte = 2, bytes = 6, holds = "reserved", src = "L22" } ]
rules = [ { id = "R1", text = "r", require = "2000:00 > 0", when = "2010:01 == 1", on = "dc", src = "L23" } ]
examples = [
  { id = "X1", entry = "2000:00", bits = 16, parameter = "P1", value = 0x20000010, src = "L24" },
  { id = "X2", step = 1, write = "2000:00", min = 1, max = 5, src = "L25" },
]
errata = [ { id = "E1", at = "2000:00", field = "min", was = 0, seen = "4.2 L42", set = 1, by = "6.2 L12", why = "w", sure = "high" } ]
[drive]
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
pdo_bytes = 8
pdo_src = "L11"
note = "d"
"#;

    fn model() -> Model {
        let compiled = crate::compile(vec![Source { path: "a.toml".into(), text: PROFILE.into() }]);
        assert!(compiled.sound().is_some(), "{:#?}", compiled.diagnostics);
        compiled.model.unwrap()
    }

    fn line<'m>(lines: &'m [FactLine<'m>], key: &str, field: &str) -> &'m FactLine<'m> {
        lines.iter().find(|l| l.key == key && l.field == field).unwrap_or_else(|| panic!("{key} {field}"))
    }

    #[test]
    fn lines_say_value_class_citation_and_erratum() {
        let model = model();
        let lines = facts(&model);
        let min = line(&lines, "object 2000:00", "min");
        assert_eq!((min.value.as_str(), min.erratum), ("1", Some("E1")));
        assert_eq!(min.cite.map(ToString::to_string).as_deref(), Some("6.2 L12"));
        let class = |key, field| line(&lines, key, field).class.map(ToString::to_string);
        assert_eq!(class("object 2010:00", "default").as_deref(), Some("inferred (highest sub-index)"));
        assert_eq!(class("object 2010:02", "access").as_deref(), Some("assumed (never said)"));
        assert_eq!(class("drive", "pdo_bytes").as_deref(), Some("stated"));
        assert_eq!(class("enum z -1", "rename"), None);
        assert_eq!(line(&lines, "enum z -1", "label").value, "3 phase");
        assert_eq!(line(&lines, "alarm OF 0x25", "cause 2").value, "b");
    }

    #[test]
    fn keys_stand_in_order_and_once() {
        let model = model();
        let lines = facts(&model);
        assert!(lines.is_sorted_by_key(|l| l.table));
        let enums: Vec<&str> = lines
            .iter()
            .filter(|l| l.table == Table::Enums && l.field == "label")
            .map(|l| l.key.as_str())
            .collect();
        assert_eq!(enums, ["enum a 9", "enum a 10", "enum z -1"]);
        let keys: std::collections::BTreeSet<_> = lines.iter().map(|l| (&l.key, &l.field)).collect();
        assert_eq!(keys.len(), lines.len());
    }

    /// The visitor of the lints walks the model by another way: what it does not visit is counted here by hand. Names of
    /// states and commands and codes of aborts are keys of rows, and neither has them as values.
    #[test]
    fn every_origin_of_the_model_is_a_line() {
        let model = model();
        let lines = facts(&model);
        let tables: std::collections::BTreeSet<Table> = lines.iter().map(|l| l.table).collect();
        assert_eq!(tables.len(), Table::Errata as usize + 1, "the profile has no row of some table");
        let visited: usize = model.row_origins().iter().map(|r| r.origins.len()).sum();
        let kinds_and_name = 2 + 1;
        let width_and_direction = 1 + 1;
        assert_eq!(Totals::of(&lines).facts(), visited + kinds_and_name + width_and_direction);
    }

    /// Values of the rows of behaviour, counted in the profile: each key but those of the row's name and the profile's own.
    #[test]
    fn every_key_of_behaviour_is_a_line() {
        let model = model();
        let lines = facts(&model);
        let of = |start: &str| lines.iter().filter(|l| l.key.starts_with(start) && l.class.is_some()).count();
        let columns = 5;
        assert_eq!((of("homing 1"), of("homing 2")), (1 + columns + 4 + 2, 1 + 1));
        assert_eq!((of("mode "), of("state "), of("command "), of("abort ")), (2, 2, 4, 1));
        assert_eq!((of("terminal "), of("sync manager "), of("fmmu "), of("emcy ")), (5, 7, 1, 2 * 2));
        assert_eq!((of("ethercat"), of("coe "), of("dc mode "), of("startup ")), (8, 1, 7, 3));
        assert_eq!(line(&lines, "ethercat", "bootstrap").value, "0x0001 0x0002 0x0003 0x0004");
        assert_eq!((of("rule "), of("example ")), (4, 7));
        let detection = 5;
        assert_eq!(of("alarm "), 3 + 2 + detection);
        assert_eq!(line(&lines, "object 2000:00", "also").value, "2 L3");
        let whole = ["text", "note", "also"].map(|field| line(&lines, "object 2010", field).value.as_str());
        assert_eq!(whole, ["t", "n", "3 L4"]);
        assert_eq!(line(&lines, "drive", "note").value, "d");
    }

    #[test]
    fn totals_by_class() {
        let model = model();
        let totals = Totals::of(&facts(&model));
        assert_eq!((totals.inferred, totals.standard, totals.assumed), (2 + 1, 0, 2));
    }
}
