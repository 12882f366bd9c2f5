//! How a drive behaves, as far as tables say it: modes, states, commands, abort codes, emergency message, terminals, and
//! when written values take effect.

use crate::abort::AbortCode;
use crate::address::Address;

crate::word::words! {
    /// When a written value takes effect.
    Effect {
        /// At once.
        AtOnce = "at once",
        /// At the next standstill.
        AtStop = "at stop",
        /// After the next power cycle.
        PowerCycle = "power cycle",
    }

    /// What a terminal is.
    TerminalKind {
        /// A digital input.
        Input = "input",
        /// A digital output.
        Output = "output",
        /// A common line of inputs or outputs.
        Common = "common",
        /// A supply or its ground.
        Supply = "supply",
        /// A port of the bus.
        Port = "port",
    }

    /// What bytes of an emergency message hold.
    EmcyContent {
        /// The error code, as 603Fh has it.
        ErrorCode = "error code",
        /// The error register, 1001h.
        ErrorRegister = "error register",
        /// The maker's number of the alarm.
        ErrorNumber = "error number",
        /// The maker's auxiliary code.
        AuxiliaryCode = "auxiliary code",
        /// Nothing.
        Reserved = "reserved",
    }
}

/// When a written value of an entry takes effect.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EffectDesc {
    address: Address,
    effect: Effect,
}

impl EffectDesc {
    /// A value written to `address` takes effect then.
    pub const fn new(address: Address, effect: Effect) -> Self {
        Self { address, effect }
    }

    /// The entry.
    pub const fn address(&self) -> Address {
        self.address
    }

    /// When.
    pub const fn effect(&self) -> Effect {
        self.effect
    }
}

/// A mode of operation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ModeDesc<'m> {
    number: i8,
    name: &'m str,
    objects: &'m [Address],
}

impl<'m> ModeDesc<'m> {
    /// A mode: the value of 6060h, and its name as the manual prints it.
    pub const fn new(number: i8, name: &'m str) -> Self {
        Self { number, name, objects: &[] }
    }

    /// With the entries that its section of the manual lists.
    #[must_use]
    pub const fn with_objects(mut self, objects: &'m [Address]) -> Self {
        self.objects = objects;
        self
    }

    /// The value of 6060h.
    pub const fn number(&self) -> i8 {
        self.number
    }

    /// Its name as the manual prints it.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// Entries that its section of the manual lists, in that order; empty where it lists none.
    pub const fn objects(&self) -> &'m [Address] {
        self.objects
    }
}

/// A state of the CiA 402 state machine, as the statusword shows it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StateDesc<'m> {
    name: &'m str,
    mask: u16,
    value: u16,
}

impl<'m> StateDesc<'m> {
    /// A state: its name, the bits of the statusword that tell, and their value.
    pub const fn new(name: &'m str, mask: u16, value: u16) -> Self {
        Self { name, mask, value }
    }

    /// Its name as the manual prints it.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The bits of the statusword that tell.
    pub const fn mask(&self) -> u16 {
        self.mask
    }

    /// Their value.
    pub const fn value(&self) -> u16 {
        self.value
    }

    /// Whether this statusword shows it.
    pub const fn matches(&self, statusword: u16) -> bool {
        statusword & self.mask == self.value
    }
}

/// A command of the CiA 402 state machine, as the controlword gives it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CommandDesc<'m> {
    name: &'m str,
    mask: u16,
    value: u16,
    edge: bool,
    transitions: &'m [u8],
}

impl<'m> CommandDesc<'m> {
    /// A command: its name, the bits of the controlword that tell, and their value.
    pub const fn new(name: &'m str, mask: u16, value: u16) -> Self {
        Self { name, mask, value, edge: false, transitions: &[] }
    }

    /// Given by a rising edge of its bits.
    #[must_use]
    pub const fn on_edge(mut self) -> Self {
        self.edge = true;
        self
    }

    /// With the transitions that it triggers.
    #[must_use]
    pub const fn with_transitions(mut self, transitions: &'m [u8]) -> Self {
        self.transitions = transitions;
        self
    }

    /// Its name as the manual prints it.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The bits of the controlword that tell.
    pub const fn mask(&self) -> u16 {
        self.mask
    }

    /// Their value.
    pub const fn value(&self) -> u16 {
        self.value
    }

    /// Whether a rising edge of its bits gives it, instead of their level.
    pub const fn edge(&self) -> bool {
        self.edge
    }

    /// The transitions that it triggers, by number; empty where the manual does not say.
    pub const fn transitions(&self) -> &'m [u8] {
        self.transitions
    }

    /// Whether the bits of this controlword are its bits. Whether they rose is another question: see
    /// [`edge`](Self::edge).
    pub const fn matches(&self, controlword: u16) -> bool {
        controlword & self.mask == self.value
    }
}

/// An abort code that a drive answers SDO transfers with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AbortDesc<'m> {
    code: AbortCode,
    name: &'m str,
}

impl<'m> AbortDesc<'m> {
    /// A code, and what it means for this drive.
    pub const fn new(code: AbortCode, name: &'m str) -> Self {
        Self { code, name }
    }

    /// The code.
    pub const fn code(&self) -> AbortCode {
        self.code
    }

    /// What it means for this drive.
    pub const fn name(&self) -> &'m str {
        self.name
    }
}

/// Bytes of the emergency message.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EmcyDesc {
    byte: u8,
    bytes: u8,
    holds: EmcyContent,
}

impl EmcyDesc {
    /// `bytes` bytes from byte `byte` on, which counts from 0, and what they hold.
    pub const fn new(byte: u8, bytes: u8, holds: EmcyContent) -> Self {
        Self { byte, bytes, holds }
    }

    /// The first byte, from 0.
    pub const fn byte(&self) -> u8 {
        self.byte
    }

    /// How many bytes.
    pub const fn bytes(&self) -> u8 {
        self.bytes
    }

    /// What they hold.
    pub const fn holds(&self) -> EmcyContent {
        self.holds
    }
}

/// A terminal of a drive.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TerminalDesc<'m> {
    name: &'m str,
    kind: TerminalKind,
    object: Option<Address>,
    bit: Option<u8>,
    function: Option<Address>,
}

impl<'m> TerminalDesc<'m> {
    /// A terminal: its name as the manual prints it, and what it is.
    pub const fn new(name: &'m str, kind: TerminalKind) -> Self {
        Self { name, kind, object: None, bit: None, function: None }
    }

    /// With the entry in which its state is read.
    #[must_use]
    pub const fn with_object(mut self, object: Address) -> Self {
        self.object = Some(object);
        self
    }

    /// With the bit of that entry.
    #[must_use]
    pub const fn with_bit(mut self, bit: u8) -> Self {
        self.bit = Some(bit);
        self
    }

    /// With the entry that gives it its function.
    #[must_use]
    pub const fn with_function(mut self, function: Address) -> Self {
        self.function = Some(function);
        self
    }

    /// Its name as the manual prints it.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// What it is.
    pub const fn kind(&self) -> TerminalKind {
        self.kind
    }

    /// The entry in which its state is read; `None` where none is stated.
    pub const fn object(&self) -> Option<Address> {
        self.object
    }

    /// The bit of that entry; `None` where none is stated.
    pub const fn bit(&self) -> Option<u8> {
        self.bit
    }

    /// The entry that gives it its function; `None` where none is stated.
    pub const fn function(&self) -> Option<Address> {
        self.function
    }
}
