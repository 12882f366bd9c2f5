//! The smaller tables of a drive.

use std::fmt;

use super::{Address, Cite, Detection, Direction, Fact, Reset, Sure};
use crate::name::Name;

/// Who made the drive, and the versions of what is generated.
#[derive(Clone, PartialEq, Debug)]
pub struct Drive {
    /// Short id, `sdv3-e`: lower case, digits and `-`.
    pub id: String,
    /// Folder and crate name, `savch-sdv3-e`.
    pub package: String,
    /// Maker.
    pub vendor: String,
    /// Product name.
    pub name: String,
    /// Version of the generated crate.
    pub crate_version: String,
    /// `FileVersion` of the EDS.
    pub eds_version: u8,
    /// `FileRevision` of the EDS.
    pub eds_revision: u8,
    /// Date of the profile's last change, `2026-11-24`. A row of the profile, never the clock.
    pub date: String,
    /// Bases, in order.
    pub bases: Vec<String>,
    /// What a PDO may hold.
    pub limits: Limits,
    /// A remark for the reader.
    pub note: Option<String>,
}

/// What a PDO may hold, where the manual says so.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Limits {
    /// Most entries of one PDO.
    pub pdo_entries: Option<Fact<u8>>,
    /// Most bytes of one PDO.
    pub pdo_bytes: Option<Fact<u16>>,
    /// Most PDOs of one direction that can be active together.
    pub pdos_per_direction: Option<Fact<u8>>,
}

/// A document that facts cite. The document itself is not part of the project.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Manual {
    /// Id in citations.
    pub id: String,
    /// Title as printed.
    pub title: String,
    /// Version as printed.
    pub version: String,
    /// Date as printed.
    pub date: Option<String>,
    /// SHA-256 of the text extract, in hexadecimal.
    pub sha256: String,
    /// Lines of the text extract.
    pub lines: u32,
}

/// Which PDOs may carry an entry.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Mapping {
    /// Process data that the drive receives.
    pub rx: bool,
    /// Process data that the drive sends.
    pub tx: bool,
}

impl Mapping {
    /// Every mapping, in the order of the documentation.
    pub const ALL: [Self; 4] = [
        Self { rx: false, tx: false },
        Self { rx: true, tx: false },
        Self { rx: false, tx: true },
        Self { rx: true, tx: true },
    ];

    /// The word of profiles: `no`, `rx`, `tx` or `rx tx`.
    pub fn word(self) -> &'static str {
        match (self.rx, self.tx) {
            (false, false) => "no",
            (true, false) => "rx",
            (false, true) => "tx",
            (true, true) => "rx tx",
        }
    }

    /// Whether a PDO of this direction may carry it.
    pub fn has(self, direction: Direction) -> bool {
        if direction == Direction::Rx { self.rx } else { self.tx }
    }

    /// Whether any PDO may carry it.
    pub fn any(self) -> bool {
        self.rx || self.tx
    }
}

/// A value that a profile can state.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Value {
    /// A whole number; a boolean is 0 or 1.
    Int(i128),
    /// Text.
    Text(String),
}

impl Value {
    /// The number that the text `$NODEID+number` or `number+$NODEID` adds to the node-ID.
    pub fn node_id_formula(text: &str) -> Option<i128> {
        let parts: Vec<&str> = text.split('+').map(str::trim).collect();
        let is_node_id = |part: &&str| part.eq_ignore_ascii_case("$NODEID");
        match parts.as_slice() {
            [id] if is_node_id(id) => Some(0),
            [id, n] | [n, id] if is_node_id(id) && !is_node_id(n) => whole(n),
            _ => None,
        }
    }
}

fn whole(text: &str) -> Option<i128> {
    let (digits, radix) = text.strip_prefix("0x").map_or((text, 10), |hex| (hex, 16));
    u64::from_str_radix(digits, radix).ok().filter(|_| !digits.starts_with('+')).map(i128::from)
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Int(n) => write!(f, "{n}"),
            Self::Text(t) => write!(f, "{t:?}"),
        }
    }
}

/// A table of named values.
#[derive(Clone, PartialEq, Debug)]
pub struct EnumDef {
    /// Its name.
    pub name: Name,
    /// Values, ascending.
    pub values: Vec<EnumValue>,
}

/// A named value.
#[derive(Clone, PartialEq, Debug)]
pub struct EnumValue {
    /// The value.
    pub value: i128,
    /// Its name in code; unique by words in the table. The origin is that of the printed one.
    pub name: Fact<Name>,
    /// Its name as printed.
    pub printed: String,
    /// What it does, in our words.
    pub text: Option<String>,
}

/// A table of named bits.
#[derive(Clone, PartialEq, Debug)]
pub struct BitsDef {
    /// Its name.
    pub name: Name,
    /// Fields, by mode, then ascending by bit.
    pub fields: Vec<BitField>,
}

/// One or more bits with a name.
#[derive(Clone, PartialEq, Debug)]
pub struct BitField {
    /// Lowest bit.
    pub bit: u8,
    /// How many bits.
    pub width: u8,
    /// Mode of operation (6060h) in which the bits have this meaning; `None`: in every mode.
    pub mode: Option<i8>,
    /// Its name in code; unique by words among the fields of its mode. The origin is that of the printed one.
    pub name: Fact<Name>,
    /// Its name as printed.
    pub printed: String,
    /// What it does, in our words.
    pub text: Option<String>,
    /// Why it may differ from the standard.
    pub deviation: Option<String>,
}

impl BitField {
    /// Its name with the short name of the mode in front, where it belongs to one: unique among all fields of its table.
    pub fn scoped_name(&self) -> Name {
        let Some(mode) = self.mode else { return self.name.value.clone() };
        let prefixed = format!("{} {}", mode_name(mode), self.name.value);
        Name::new(&prefixed).unwrap_or_else(|| self.name.value.clone())
    }

    /// One past the highest bit.
    pub fn end(&self) -> u16 {
        u16::from(self.bit) + u16::from(self.width)
    }
}

/// The short name of a mode of operation (6060h): `pp`, `csv`, or `mode n3` for the maker's own.
fn mode_name(mode: i8) -> String {
    const NAMES: [&str; 11] = ["no mode", "pp", "vl", "pv", "tq", "mode 5", "hm", "ip", "csp", "csv", "cst"];
    match usize::try_from(mode) {
        Ok(n) => NAMES.get(n).map_or_else(|| format!("mode {mode}"), |name| (*name).to_owned()),
        Err(_) => format!("mode n{}", mode.unsigned_abs()),
    }
}

/// A fault or warning. 603Fh is shared by several: the key is display and number.
#[derive(Clone, PartialEq, Debug)]
pub struct Alarm {
    /// What the panel shows.
    pub display: String,
    /// The maker's number.
    pub number: Fact<u16>,
    /// Error code, as 603Fh and the emergency message carry it.
    pub code: Fact<u16>,
    /// Auxiliary code of the emergency message.
    pub aux: Option<Fact<u16>>,
    /// Its name in code. The origin is that of the printed one.
    pub name: Fact<Name>,
    /// Its name as printed.
    pub printed: String,
    /// How it is cleared; `None` where the manual does not say.
    pub reset: Option<Fact<Reset>>,
    /// Causes, in our words.
    pub causes: Vec<Fact<String>>,
    /// Remedies, in our words.
    pub remedies: Vec<Fact<String>>,
    /// How it shows on EtherCAT.
    pub detection: Detection,
}

impl Alarm {
    /// Whether the manual says more of it than what it is called and how it is reset.
    pub fn is_explained(&self) -> bool {
        !self.causes.is_empty() || !self.remedies.is_empty() || self.detection != Detection::default()
    }
}

impl Erratum {
    /// What is used: `used 5`, `dropped` or `kept`; `value` says how the value is written.
    pub fn outcome(&self, value: impl Fn(&str) -> String) -> String {
        match &self.set {
            Some(set) => format!("used {}", value(set)),
            None if self.unset => "dropped".to_owned(),
            None => "kept".to_owned(),
        }
    }
}

/// Where the manual is wrong or contradicts itself.
#[derive(Clone, PartialEq, Debug)]
pub struct Erratum {
    /// Id, unique in the profile.
    pub id: String,
    /// Row that it concerns, as the profile writes it.
    pub at: String,
    /// The row's address, where it is an object.
    pub address: Option<Address>,
    /// Field of that row.
    pub field: String,
    /// What is printed.
    pub was: String,
    /// Where that is printed.
    pub seen: Cite,
    /// The value used instead; `None`: the printed value is kept or dropped.
    pub set: Option<String>,
    /// Whether the printed value is dropped, and nothing takes its place.
    pub unset: bool,
    /// Where the other reading is printed.
    pub by: Option<Cite>,
    /// Why.
    pub why: String,
    /// How sure.
    pub sure: Sure,
}
