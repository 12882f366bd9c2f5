//! The resolved drive: plain data, typed ids, no text that is an identifier of some output language.
//!
//! Everything after [`crate::resolve`] sees only this. A `Model` that passed [`crate::check`] without errors can be
//! emitted by every backend.

mod behaviour;
mod ethercat;
mod expr;
mod fact;
mod homing;
mod id;
mod parts;
mod ty;
mod unit;
mod visit;
mod word;

pub use behaviour::{Abort, Command, Detection, EmcyPart, Entries, Example, Mode, Rule, State, Terminal};
pub use ethercat::{Coe, DcMode, EtherCat, Fmmu, StartUp, SyncManager};
pub use expr::{Expr, OPERATORS, Op, Term};
pub use fact::{Cite, Class, Fact, Origin, Place};
pub use homing::{Event, HomingCase, HomingMethod, Level, Moves, Pace, Step, When};
pub use id::{Address, Arena, BitsId, EntryId, EnumId, ErratumId, Id, ObjectId};
pub use parts::{
    Alarm, BitField, BitsDef, Drive, EnumDef, EnumValue, Erratum, Limits, Manual, Mapping, Value,
};
pub use ty::Type;
pub use unit::{CountsError, Quantity, Unit, UnitError};
pub use visit::RowOrigins;
pub use word::{
    Access, CoeFeature, DcSync, Direction, Edge, Effect, EmcyContent, EsmAfter, EsmState, FmmuUse,
    HomingSignal, HomingStart, HomingStatus, Led, MailboxProtocol, ObjectKind, Occasion, Reset,
    RevisionCheck, Side, Signal, Sure, SyncManagerUse, SyncMode, TerminalKind, Transition, Worded,
};

use crate::name::Name;
use crate::source::Sp;

/// A drive.
#[derive(Clone, PartialEq, Debug)]
pub struct Model {
    /// Who made it, what it is called, and the versions of what is generated.
    pub drive: Drive,
    /// The documents that facts cite.
    pub manuals: Vec<Manual>,
    /// One for each index of the dictionary, ascending.
    pub objects: Arena<ObjectId, Object>,
    /// One for each index and sub-index, ascending by address.
    pub entries: Arena<EntryId, Entry>,
    /// Value tables, by name.
    pub enums: Arena<EnumId, EnumDef>,
    /// Bit tables, by name.
    pub bits: Arena<BitsId, BitsDef>,
    /// Default process data, by index.
    pub pdos: Vec<Pdo>,
    /// Faults and warnings, by number and display.
    pub alarms: Vec<Alarm>,
    /// Homing methods, ascending.
    pub homing: Vec<HomingMethod>,
    /// Modes of operation, ascending.
    pub modes: Vec<Mode>,
    /// States of the CiA 402 state machine, in the order of the manual.
    pub states: Vec<State>,
    /// Commands of the CiA 402 state machine, in the order of the manual.
    pub commands: Vec<Command>,
    /// Abort codes of SDO transfers, ascending.
    pub aborts: Vec<Abort>,
    /// Terminals, in the order of the manual.
    pub terminals: Vec<Terminal>,
    /// The EtherCAT side as a whole.
    pub ethercat: EtherCat,
    /// SyncManagers, by number.
    pub sync_managers: Vec<SyncManager>,
    /// FMMUs, by number.
    pub fmmus: Vec<Fmmu>,
    /// What CoE can and cannot do, in the order of [`CoeFeature`].
    pub coe: Vec<Coe>,
    /// Ways to synchronize, the first by default.
    pub dc_modes: Vec<DcMode>,
    /// What a master must write at start-up, in order.
    pub startup: Vec<StartUp>,
    /// The emergency message, by byte.
    pub emcy: Vec<EmcyPart>,
    /// Rules between values, by id.
    pub rules: Vec<Rule>,
    /// Worked examples, by id and step.
    pub examples: Vec<Example>,
    /// Where the manual is wrong, in the order of the profile.
    pub errata: Arena<ErratumId, Erratum>,
}

/// An index of the dictionary.
#[derive(Clone, PartialEq, Debug)]
pub struct Object {
    /// The index.
    pub index: u16,
    /// What it is called.
    pub name: Fact<Name>,
    /// Variable, array or record.
    pub kind: Fact<ObjectKind>,
    /// Its entries, ascending by sub-index; never empty.
    pub entries: Vec<EntryId>,
    /// What it is for as a whole, in our words.
    pub text: Option<String>,
    /// A remark for the reader on the object as a whole.
    pub note: Option<String>,
    /// Why the object as a whole may differ from the standard one.
    pub deviation: Option<String>,
    /// Where the manual prints a row for the object as a whole again.
    pub also: Option<Cite>,
}

/// An index and sub-index of the dictionary.
#[derive(Clone, PartialEq, Debug)]
pub struct Entry {
    /// Index and sub-index.
    pub address: Address,
    /// The index it belongs to.
    pub object: ObjectId,
    /// The printed name.
    pub name: Fact<String>,
    /// The name that generated code uses; unique by words among all entries.
    pub handle: Name,
    /// Type on the wire.
    pub ty: Fact<Type>,
    /// Who may do what over SDO.
    pub access: Fact<Access>,
    /// Which PDO direction may carry it; `None` where nobody says.
    pub mapping: Option<Fact<Mapping>>,
    /// Unit and factor of one count.
    pub unit: Option<Fact<Unit>>,
    /// Lowest raw value.
    pub min: Option<Fact<i128>>,
    /// Highest raw value.
    pub max: Option<Fact<i128>>,
    /// The only raw values allowed, where the manual lists them.
    pub allow: Option<Fact<Vec<i128>>>,
    /// Value after the first power-on or after restoring factory settings.
    pub default: Option<Fact<Value>>,
    /// Meaning of its values.
    pub values: Option<Fact<EnumId>>,
    /// Meaning of its bits.
    pub bits: Option<Fact<BitsId>>,
    /// What it is for, in our words.
    pub text: Option<String>,
    /// A remark for the reader.
    pub note: Option<String>,
    /// Why it may differ from the standard object of the same index.
    pub deviation: Option<String>,
    /// Number of the parameter on the panel and in the drive's manual.
    pub parameter: Option<Fact<String>>,
    /// When a written value takes effect.
    pub effect: Option<Fact<Effect>>,
    /// Where the manual prints a row for it again.
    pub also: Option<Cite>,
}

impl Entry {
    /// The facts that forbid a raw value: who states each, and why it forbids. An entry whose values are no whole
    /// numbers forbids none.
    pub fn refusals(&self, value: i128) -> impl Iterator<Item = (&Origin, String)> {
        let outside = |(low, high): (i128, i128)| !(low..=high).contains(&value);
        let ty = self.ty.value.range().is_some_and(outside);
        let ty = ty.then(|| (&self.ty.origin, format!("whose type {} has no {value}", self.ty.value)));
        let min = self.min.as_ref().filter(|min| value < min.value);
        let max = self.max.as_ref().filter(|max| value > max.value);
        let limit = move |limit: &Fact<i128>| format!("whose limit {} excludes {value}", limit.value);
        let limits = min.into_iter().chain(max).map(move |fact| (&fact.origin, limit(fact)));
        let allow = self.allow.as_ref().filter(|allow| !allow.value.contains(&value));
        let allow = allow.map(|allow| (&allow.origin, format!("which does not allow {value}")));
        ty.into_iter().chain(limits).chain(allow)
    }

    /// The default, where it is a number.
    pub fn default_int(&self) -> Option<Sp<i128>> {
        let default = self.default.as_ref()?;
        match default.value {
            Value::Int(n) => Some(Sp::new(n, default.span())),
            Value::Text(_) => None,
        }
    }

    /// What the default adds to the node-ID, where it is such a formula and gives every node a value of the type.
    pub fn default_beside_node_id(&self) -> Option<i128> {
        let Value::Text(text) = &self.default.as_ref()?.value else { return None };
        let (least, most) = self.ty.value.range().filter(|_| self.ty.value.is_integer())?;
        Value::node_id_formula(text).filter(|n| least <= *n && *n + 127 <= most)
    }
}

/// A process data object with its default mapping.
#[derive(Clone, PartialEq, Debug)]
pub struct Pdo {
    /// Index of the mapping object, `1600h` or `1A00h` for the first ones.
    pub index: u16,
    /// Direction.
    pub direction: Direction,
    /// Who says the direction.
    pub origin: Origin,
    /// What it carries, in order.
    pub entries: Vec<PdoEntry>,
}

impl Pdo {
    /// The direction of the PDO whose mapping object has this index.
    pub fn direction_of(index: u16) -> Option<Direction> {
        match index {
            0x1600..=0x17FF => Some(Direction::Rx),
            0x1A00..=0x1BFF => Some(Direction::Tx),
            _ => None,
        }
    }

    /// Length of the default mapping in bits.
    pub fn bits(&self) -> u32 {
        self.entries.iter().map(|e| u32::from(e.bits.value)).sum()
    }
}

/// A mapped entry.
#[derive(Clone, PartialEq, Debug)]
pub struct PdoEntry {
    /// Place in the mapping, from 1.
    pub position: u8,
    /// The mapped entry.
    pub entry: EntryId,
    /// Who says that it stands here.
    pub origin: Origin,
    /// Its length as the mapping states it.
    pub bits: Fact<u8>,
}

impl Model {
    /// Whether the drive is on a CAN bus: it has nothing of EtherCAT.
    pub fn on_can(&self) -> bool {
        self.drive.bases.iter().all(|base| base != "coe")
            && [0x1C12, 0x1C13].iter().all(|index| self.object(*index).is_none())
    }

    /// The entry at `address`.
    pub fn entry(&self, address: Address) -> Option<(EntryId, &Entry)> {
        let at = self.entries.as_slice().binary_search_by_key(&address, |e| e.address).ok()?;
        let id = EntryId::at(at);
        Some((id, &self.entries[id]))
    }

    /// The homing method `number` with its program: for one that is the same as another, that one's.
    pub fn homing_program(&self, number: i8) -> Option<&HomingMethod> {
        let find = |number| self.homing.iter().find(|m| m.number == number);
        let method = find(number)?;
        method.same.as_ref().map_or(Some(method), |same| find(same.value))
    }

    /// The distinct units of entries, in the order of the entries.
    pub fn units(&self) -> Vec<&Unit> {
        let mut units: Vec<&Unit> = Vec::new();
        for unit in self.entries.as_slice().iter().filter_map(|entry| entry.unit.as_ref()) {
            if !units.contains(&&unit.value) {
                units.push(&unit.value);
            }
        }
        units
    }

    /// The entry that gives a terminal its function: the one with the number of its parameter.
    pub fn function_of(&self, terminal: &Terminal) -> Option<Address> {
        let parameter = &terminal.parameter.as_ref()?.value;
        let is_it = |entry: &&Entry| entry.parameter.as_ref().is_some_and(|p| p.value == *parameter);
        self.entries.as_slice().iter().find(is_it).map(|entry| entry.address)
    }

    /// The object at `index`.
    pub fn object(&self, index: u16) -> Option<&Object> {
        let at = self.objects.as_slice().binary_search_by_key(&index, |o| o.index).ok()?;
        Some(&self.objects[ObjectId::at(at)])
    }

    /// Vendor, product, revision and serial number as the identity object states them: the one source of the drive's identity.
    pub fn identity(&self) -> [Option<u32>; 4] {
        [1, 2, 3, 4].map(|sub| u32::try_from(self.default_int(Address::new(0x1018, sub))?).ok())
    }

    /// The integer default of the entry at `address`, where one is known.
    pub fn default_int(&self, address: Address) -> Option<i128> {
        self.entry(address)?.1.default_int().map(|d| d.value)
    }
}
