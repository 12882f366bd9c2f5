//! A drive as data: what is in its dictionary, its process data, its alarms and how it behaves.
//!
//! The tables are slices with a lifetime, so that a generated crate's statics and tables that a program builds at run
//! time from a profile are of one type. Rows are made by constructors that name what is always known; builder methods
//! add the rest, so that a new column does not break what was generated before.

mod alarm;
mod behaviour;
mod detection;
mod identity;
mod integrity;
mod object;
mod pdo;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::bit_field::BitFieldDesc;
use crate::homing::HomingDesc;
use crate::rule::{Occasion, RuleDesc};
use crate::wire_enum::EnumDesc;

pub use alarm::{alarms_by_code, AlarmDesc, AlarmText, Reset};
pub use behaviour::{
    AbortDesc, CommandDesc, Effect, EffectDesc, EmcyContent, EmcyDesc, ModeDesc, StateDesc, TerminalDesc,
    TerminalKind,
};
pub use detection::{EsmAfter, EsmState, Led, SyncMode};
pub use identity::Identity;
pub use integrity::ModelError;
#[doc(hidden)]
pub use object::NO_UNIT;
pub use object::{find_object, Allowed, DefaultValue, Meaning, ObjectDesc, TextDefault, UnitDesc};
pub use pdo::{PdoDesc, Remap};

/// A drive as data.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// static UNITS: [UnitDesc<'static>; 1] = [UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10)];
/// static OBJECTS: [ObjectDesc<'static>; 2] = [
///     ObjectDesc::new(Address::new(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, "Statusword"),
///     ObjectDesc::new(Address::new(0x6081, 0), DataType::UNSIGNED32, Access::Rw, Mapping::RxTx, "Profile velocity")
///         .range(0, 60_000)
///         .default_int(0)
///         .unit(0),
/// ];
/// static MODEL: DriveModel<'static> =
///     DriveModel::new(Identity::new("acme-x3", "Acme", "X3")).with_objects(&OBJECTS).with_units(&UNITS);
///
/// let object = MODEL.object(Address::new(0x6081, 0)).unwrap();
/// assert_eq!((object.name(), object.max()), ("Profile velocity", Some(60_000)));
/// assert_eq!(MODEL.unit_of(object).map(|u| u.text()), Some("0.1 rpm"));
/// assert!(MODEL.object(Address::new(0x6081, 1)).is_none());
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DriveModel<'m> {
    identity: Identity<'m>,
    objects: &'m [ObjectDesc<'m>],
    units: &'m [UnitDesc<'m>],
    allowed: &'m [Allowed<'m>],
    texts: &'m [TextDefault<'m>],
    enums: &'m [EnumDesc<'m>],
    bit_fields: &'m [BitFieldDesc<'m>],
    pdos: &'m [PdoDesc<'m>],
    alarms: &'m [AlarmDesc<'m>],
    homing_methods: &'m [HomingDesc<'m>],
    effects: &'m [EffectDesc],
    modes: &'m [ModeDesc<'m>],
    states: &'m [StateDesc<'m>],
    commands: &'m [CommandDesc<'m>],
    aborts: &'m [AbortDesc<'m>],
    emcy: &'m [EmcyDesc],
    terminals: &'m [TerminalDesc<'m>],
    rules: &'m [RuleDesc<'m>],
}

impl<'m> DriveModel<'m> {
    /// A drive with empty tables.
    pub const fn new(identity: Identity<'m>) -> Self {
        Self {
            identity,
            objects: &[],
            units: &[],
            allowed: &[],
            texts: &[],
            enums: &[],
            bit_fields: &[],
            pdos: &[],
            alarms: &[],
            homing_methods: &[],
            effects: &[],
            modes: &[],
            states: &[],
            commands: &[],
            aborts: &[],
            emcy: &[],
            terminals: &[],
            rules: &[],
        }
    }
}

/// A builder method and a getter for every table.
macro_rules! tables {
    ($($(#[$doc:meta])* $name:ident, $with:ident: $row:ident $(<$life:lifetime>)?;)*) => {
        impl<'m> DriveModel<'m> {
            $(
                #[doc = concat!("With this table of `", stringify!($row), "`.")]
                #[must_use]
                pub const fn $with(self, $name: &'m [$row $(<$life>)?]) -> Self {
                    Self { $name, ..self }
                }
            )*
        }

        /// The tables of a drive.
        impl<'m> DriveModel<'m> {
            $(
                $(#[$doc])*
                pub const fn $name(&self) -> &'m [$row $(<$life>)?] {
                    self.$name
                }
            )*
        }
    };
}

tables! {
    /// Entries of the dictionary, ascending by address.
    objects, with_objects: ObjectDesc<'m>;
    /// Units that entries refer to by number.
    units, with_units: UnitDesc<'m>;
    /// Entries that take listed values only, ascending by address.
    allowed, with_allowed: Allowed<'m>;
    /// Entries whose default is a text, ascending by address.
    texts, with_texts: TextDefault<'m>;
    /// Value tables that entries refer to by number.
    enums, with_enums: EnumDesc<'m>;
    /// Bit tables that entries refer to by number.
    bit_fields, with_bit_fields: BitFieldDesc<'m>;
    /// Process data as the drive ships.
    pdos, with_pdos: PdoDesc<'m>;
    /// Faults and warnings.
    alarms, with_alarms: AlarmDesc<'m>;
    /// Homing methods, ascending by number; empty where the manual describes none.
    homing_methods, with_homing: HomingDesc<'m>;
    /// Entries of which the manual says when a written value takes effect, ascending by address.
    effects, with_effects: EffectDesc;
    /// Modes of operation, ascending by number; empty where the manual lists none.
    modes, with_modes: ModeDesc<'m>;
    /// States as the statusword shows them; empty where the manual prints none, and CiA 402 holds.
    states, with_states: StateDesc<'m>;
    /// Commands as the controlword gives them; empty where the manual prints none, and CiA 402 holds.
    commands, with_commands: CommandDesc<'m>;
    /// Abort codes of SDO transfers, ascending; empty where the manual prints none, and CiA 301 holds.
    aborts, with_aborts: AbortDesc<'m>;
    /// The emergency message, by byte; empty where the manual does not describe it.
    emcy, with_emcy: EmcyDesc;
    /// Terminals, in the order of the manual.
    terminals, with_terminals: TerminalDesc<'m>;
    /// Rules between values, by id.
    rules, with_rules: RuleDesc<'m>;
}

impl<'m> DriveModel<'m> {
    /// Who made the drive, and what it is called.
    pub const fn identity(&self) -> Identity<'m> {
        self.identity
    }

    /// The entry at `address`; `None` if the dictionary has none there.
    pub fn object(&self, address: Address) -> Option<&'m ObjectDesc<'m>> {
        find_object(self.objects, address)
    }

    /// The entries of one index, ascending by sub-index; empty if the dictionary has none.
    pub fn entries_of(&self, address: Address) -> &'m [ObjectDesc<'m>] {
        let from = self.objects.partition_point(|o| o.address().index() < address.index());
        let to = self.objects.partition_point(|o| o.address().index() <= address.index());
        self.objects.get(from..to).unwrap_or(&[])
    }

    /// The unit of an entry; `None` where none is stated.
    pub fn unit_of(&self, object: &ObjectDesc<'m>) -> Option<&'m UnitDesc<'m>> {
        self.units.get(object.unit_index()?)
    }

    /// The named values of an entry; `None` where there are none.
    pub fn enum_of(&self, object: &ObjectDesc<'m>) -> Option<&'m EnumDesc<'m>> {
        match object.meaning() {
            Meaning::Enum(index) => self.enums.get(usize::from(index)),
            _ => None,
        }
    }

    /// The named bits of an entry; `None` where there are none.
    pub fn bits_of(&self, object: &ObjectDesc<'m>) -> Option<&'m BitFieldDesc<'m>> {
        match object.meaning() {
            Meaning::Bits(index) => self.bit_fields.get(usize::from(index)),
            _ => None,
        }
    }

    /// The only values that an entry takes; `None` where the manual lists none.
    pub fn allowed_of(&self, object: &ObjectDesc<'m>) -> Option<&'m [i64]> {
        let at = self.allowed.binary_search_by_key(&object.address(), Allowed::address).ok()?;
        self.allowed.get(at).map(Allowed::values)
    }

    /// The value of an entry as the drive ships.
    pub fn default_of(&self, object: &ObjectDesc<'m>) -> DefaultValue<'m> {
        if let Some(value) = object.default_value() {
            return DefaultValue::Int(value);
        }
        match self.texts.binary_search_by_key(&object.address(), TextDefault::address) {
            Ok(at) => self.texts.get(at).map_or(DefaultValue::NotStated, |t| DefaultValue::Text(t.text())),
            Err(_) => DefaultValue::NotStated,
        }
    }

    /// The process data whose mapping is at this index.
    pub fn pdo(&self, address: Address) -> Option<&'m PdoDesc<'m>> {
        self.pdos.iter().find(|p| p.address().index() == address.index())
    }

    /// The homing method `number` with its program: for one that is the same as another, that one.
    pub fn homing(&self, number: i8) -> Option<&'m HomingDesc<'m>> {
        let find = |number| self.homing_methods.iter().find(|method| method.number() == number);
        let method = find(number)?;
        method.same().map_or(Some(method), find)
    }

    /// When a value written to `address` takes effect; `None` where the manual does not say.
    pub fn effect_of(&self, address: Address) -> Option<Effect> {
        let at = self.effects.binary_search_by_key(&address, EffectDesc::address).ok()?;
        self.effects.get(at).map(EffectDesc::effect)
    }

    /// The mode of operation that 6060h calls `number`; `None` where the manual does not list it.
    pub fn mode(&self, number: i8) -> Option<&'m ModeDesc<'m>> {
        self.modes.iter().find(|mode| mode.number() == number)
    }

    /// What an abort code means for this drive; `None` where its manual does not list it.
    pub fn abort(&self, code: AbortCode) -> Option<&'m AbortDesc<'m>> {
        self.aborts.iter().find(|abort| abort.code() == code)
    }

    /// The rules that must hold on this occasion; with `None` those that must hold always, which are not among those of
    /// an occasion.
    pub fn rules_on(&self, occasion: Option<Occasion>) -> impl Iterator<Item = &'m RuleDesc<'m>> {
        self.rules.iter().filter(move |rule| rule.on() == occasion)
    }

    /// The alarm that the panel shows as `display` and the maker numbers `number`.
    pub fn alarm(&self, display: &str, number: u16) -> Option<&'m AlarmDesc<'m>> {
        self.alarms.iter().find(|a| a.is(display, number))
    }

    /// The alarms that report `code` in 603Fh. Several may: makers share codes between alarms.
    pub fn alarms_by_code(&self, code: u16) -> impl Iterator<Item = &'m AlarmDesc<'m>> {
        alarms_by_code(self.alarms, code)
    }
}

#[cfg(test)]
mod tests;
