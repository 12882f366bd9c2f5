//! How the drive behaves, besides its dictionary: modes, states, rules and terminals.

use std::collections::BTreeSet;
use std::fmt;

use drivewright_runtime::rule;

use super::{Address, EmcyContent, EsmAfter, EsmState, Expr, Fact, Led, Occasion, SyncMode, TerminalKind};
use crate::name::Name;

/// How an alarm shows on EtherCAT, where the manual says so.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Detection {
    /// States of the EtherCAT state machine in which it is detected.
    pub esm: Option<Fact<Vec<EsmState>>>,
    /// State of the EtherCAT state machine after it.
    pub esm_after: Option<Fact<EsmAfter>>,
    /// Synchronization in which it is detected.
    pub sync: Option<Fact<SyncMode>>,
    /// AL status code that it sets.
    pub al_status: Option<Fact<u16>>,
    /// What the error indicator shows.
    pub led: Option<Fact<Led>>,
}

/// A mode of operation.
#[derive(Clone, PartialEq, Debug)]
pub struct Mode {
    /// The value of 6060h.
    pub number: i8,
    /// Its name as printed.
    pub name: Fact<Name>,
    /// Objects that its section lists, in the order printed.
    pub objects: Option<Fact<Vec<Address>>>,
    /// What it does.
    pub text: Option<String>,
}

/// A state of the CiA 402 state machine.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    /// Its name.
    pub name: Fact<Name>,
    /// The bits of the statusword that tell.
    pub mask: Fact<u16>,
    /// Their value.
    pub value: Fact<u16>,
}

/// A command of the CiA 402 state machine.
#[derive(Clone, PartialEq, Debug)]
pub struct Command {
    /// Its name.
    pub name: Fact<Name>,
    /// The bits of the controlword that tell.
    pub mask: Fact<u16>,
    /// Their value.
    pub value: Fact<u16>,
    /// Whether a rising edge of these bits is the command.
    pub edge: Option<Fact<bool>>,
    /// Transitions that it triggers.
    pub transitions: Option<Fact<Vec<u8>>>,
}

/// An abort code that the drive answers SDO transfers with.
#[derive(Clone, PartialEq, Debug)]
pub struct Abort {
    /// The code.
    pub code: Fact<u32>,
    /// What it means, in our words.
    pub name: Fact<String>,
}

/// A terminal of the drive.
#[derive(Clone, PartialEq, Debug)]
pub struct Terminal {
    /// Its name as printed.
    pub name: String,
    /// What it is.
    pub kind: Fact<TerminalKind>,
    /// Number of the pin.
    pub pin: Option<Fact<u8>>,
    /// Object in which its state is read.
    pub object: Option<Fact<Address>>,
    /// Bit of that object.
    pub bit: Option<Fact<u8>>,
    /// Parameter that gives it its function.
    pub parameter: Option<Fact<String>>,
    /// What it is for.
    pub text: Option<String>,
    /// A remark for the reader.
    pub note: Option<String>,
}

/// Bytes of the emergency message.
#[derive(Clone, PartialEq, Debug)]
pub struct EmcyPart {
    /// The first byte, from 0.
    pub byte: u8,
    /// How many bytes.
    pub bytes: Fact<u8>,
    /// What they hold.
    pub holds: Fact<EmcyContent>,
    /// What to know about them.
    pub text: Option<String>,
}

/// A rule between values.
#[derive(Clone, PartialEq, Debug)]
pub struct Rule {
    /// Id, unique in the profile.
    pub id: String,
    /// The rule in our words.
    pub text: Fact<String>,
    /// What must hold.
    pub require: Option<Fact<Expr>>,
    /// Under which condition.
    pub when: Option<Fact<Expr>>,
    /// On which occasion; `None`: always.
    pub on: Option<Fact<Occasion>>,
}

impl Rule {
    /// The objects that it names.
    pub fn objects(&self) -> BTreeSet<Address> {
        self.require.iter().chain(&self.when).flat_map(|expr| expr.value.objects()).collect()
    }

    /// Whether it holds for these values and is not obeyed; never where one that decides this is unknown.
    pub fn broken(&self, value: impl Fn(Address) -> Option<i128>) -> bool {
        let [when, require] = [&self.when, &self.require].map(|part| Some(part.as_ref()?.value.evaluated()));
        rule::broken(when, require, |at| value(at.into()))
    }
}

/// Entries of one index, first to last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Entries {
    /// The first.
    pub first: Address,
    /// The sub-index of the last.
    pub last: u8,
}

impl fmt::Display for Entries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.first.fmt(f)?;
        if self.last == self.first.sub { Ok(()) } else { write!(f, "..{:02X}", self.last) }
    }
}

/// A step of a worked example.
#[derive(Clone, PartialEq, Debug)]
pub struct Example {
    /// Id of the example.
    pub id: String,
    /// Number of the step, where it has several.
    pub step: Option<u8>,
    /// The entries that are written.
    pub write: Option<Fact<Entries>>,
    /// The object that a mapping word names, or where a parameter is.
    pub entry: Option<Fact<Address>>,
    /// Length in bits in a mapping word.
    pub bits: Option<Fact<u8>>,
    /// Parameter whose place is shown.
    pub parameter: Option<Fact<String>>,
    /// The value that is written, or the mapping word.
    pub value: Option<Fact<i128>>,
    /// Lowest value of those that may be written.
    pub min: Option<Fact<i128>>,
    /// Highest value of those that may be written.
    pub max: Option<Fact<i128>>,
    /// What it shows.
    pub text: Option<String>,
}

impl Example {
    /// How messages and citations name it: `X2.4`.
    pub fn label(&self) -> String {
        self.step.map_or_else(|| self.id.clone(), |step| format!("{}.{step}", self.id))
    }
}
