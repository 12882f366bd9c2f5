//! Rows of the dictionary.

use crate::access::Access;
use crate::address::Address;
use crate::data_type::DataType;
use crate::mapping::Mapping;
use crate::object::{NO_MAX, NO_MIN};
use crate::quantity::QuantityKind;

/// An entry of the dictionary. 40 bytes on a 32-bit processor.
///
/// Limits and default are raw numbers. Those of `UNSIGNED64` hold the bit pattern of the 64-bit number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ObjectDesc<'m> {
    min: i64,
    max: i64,
    default: i64,
    name: &'m str,
    // Address and meaning are stored in parts: as structs they would pad the row to 48 bytes.
    index: u16,
    meaning: u16,
    sub: u8,
    data_type: DataType,
    unit: u8,
    flags: u8,
}

#[cfg(target_pointer_width = "32")]
const _: () = assert!(size_of::<ObjectDesc<'static>>() == 40);

const ACCESS: u8 = 0b11;
const MAPPING_SHIFT: u8 = 2;
const MAPPING: u8 = 0b111;
const HAS_DEFAULT: u8 = 1 << 5;
const HAS_ENUM: u8 = 1 << 6;
const HAS_BITS: u8 = 1 << 7;
/// In the place of a unit, where none is stated.
pub const NO_UNIT: u8 = u8::MAX;

/// What the numbers of an entry mean, by number of the model's table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Meaning {
    /// A plain number, text or bytes.
    Plain,
    /// Named values: a table of [`DriveModel::enums`](super::DriveModel::enums).
    Enum(u16),
    /// Named bits: a table of [`DriveModel::bit_fields`](super::DriveModel::bit_fields).
    Bits(u16),
}

/// The value of an entry as the drive ships.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum DefaultValue<'m> {
    /// The manual does not say.
    NotStated,
    /// A raw number.
    Int(i128),
    /// A text.
    Text(&'m str),
}

impl<'m> ObjectDesc<'m> {
    /// An entry without limits, default, unit and meaning. `name` is what the manual calls it.
    pub const fn new(
        address: Address,
        data_type: DataType,
        access: Access,
        mapping: Mapping,
        name: &'m str,
    ) -> Self {
        let at = (address.index(), address.sub());
        Self::row(at, data_type, access, mapping, name, NO_UNIT, (NO_MIN, NO_MAX), None)
    }

    /// Everything that generated rows state: see [`row`](crate::row).
    #[allow(clippy::too_many_arguments)]
    pub(crate) const fn row(
        at: (u16, u8),
        data_type: DataType,
        access: Access,
        mapping: Mapping,
        name: &'m str,
        unit: u8,
        range: (i64, i64),
        default: Option<i64>,
    ) -> Self {
        let flags = access as u8 | (mapping as u8) << MAPPING_SHIFT;
        let (default, flags) = match default {
            Some(default) => (default, flags | HAS_DEFAULT),
            None => (0, flags),
        };
        let (index, sub) = at;
        Self { min: range.0, max: range.1, default, name, index, meaning: 0, sub, data_type, unit, flags }
    }

    /// With the lowest and highest raw value; `i64::MIN` and `i64::MAX` where none is stated.
    #[must_use]
    pub const fn range(mut self, min: i64, max: i64) -> Self {
        self.min = min;
        self.max = max;
        self
    }

    /// With the lowest raw value, where no highest is stated.
    #[must_use]
    pub const fn at_least(mut self, min: i64) -> Self {
        self.min = min;
        self
    }

    /// With the highest raw value, where no lowest is stated.
    #[must_use]
    pub const fn at_most(mut self, max: i64) -> Self {
        self.max = max;
        self
    }

    /// With the raw value as the drive ships.
    #[must_use]
    pub const fn default_int(mut self, default: i64) -> Self {
        self.default = default;
        self.flags |= HAS_DEFAULT;
        self
    }

    /// With a unit: a row of the model's table, 0 to 254. 255 means that none is stated.
    #[must_use]
    pub const fn unit(mut self, unit: u8) -> Self {
        self.unit = unit;
        self
    }

    /// With named values: a row of the model's table.
    #[must_use]
    pub const fn values(mut self, index: u16) -> Self {
        self.meaning = index;
        self.flags = (self.flags & !HAS_BITS) | HAS_ENUM;
        self
    }

    /// With named bits: a row of the model's table.
    #[must_use]
    pub const fn bits(mut self, index: u16) -> Self {
        self.meaning = index;
        self.flags = (self.flags & !HAS_ENUM) | HAS_BITS;
        self
    }

    /// Index and sub-index.
    pub const fn address(&self) -> Address {
        Address::new(self.index, self.sub)
    }

    /// What the manual calls it.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The type on the wire.
    pub const fn data_type(&self) -> DataType {
        self.data_type
    }

    /// SDO access.
    pub const fn access(&self) -> Access {
        match self.flags & ACCESS {
            0 => Access::Ro,
            1 => Access::Rw,
            2 => Access::Wo,
            _ => Access::Const,
        }
    }

    /// Which process data may carry it.
    pub const fn mapping(&self) -> Mapping {
        match self.flags >> MAPPING_SHIFT & MAPPING {
            1 => Mapping::Unmapped,
            2 => Mapping::Rx,
            3 => Mapping::Tx,
            4 => Mapping::RxTx,
            _ => Mapping::NotStated,
        }
    }

    /// Lowest raw value; `None` where none is stated.
    pub const fn min(&self) -> Option<i128> {
        if self.min == NO_MIN {
            None
        } else {
            Some(self.widen(self.min))
        }
    }

    /// Highest raw value; `None` where none is stated.
    pub const fn max(&self) -> Option<i128> {
        if self.max == NO_MAX {
            None
        } else {
            Some(self.widen(self.max))
        }
    }

    /// Whether `raw` is within the stated limits and within the type.
    pub fn accepts(&self, raw: i128) -> bool {
        let fits = self.data_type.range().map_or(true, |(min, max)| min <= raw && raw <= max);
        fits && self.min().map_or(true, |min| min <= raw) && self.max().map_or(true, |max| raw <= max)
    }

    /// What the numbers mean.
    pub const fn meaning(&self) -> Meaning {
        if self.flags & HAS_ENUM != 0 {
            Meaning::Enum(self.meaning)
        } else if self.flags & HAS_BITS != 0 {
            Meaning::Bits(self.meaning)
        } else {
            Meaning::Plain
        }
    }

    /// The raw number as the drive ships; `None` where none is stated or where it is a text: see
    /// [`DriveModel::default_of`](super::DriveModel::default_of).
    pub const fn default_value(&self) -> Option<i128> {
        if self.flags & HAS_DEFAULT == 0 {
            None
        } else {
            Some(self.widen(self.default))
        }
    }

    /// The row of the model's table of units; `None` where no unit is stated.
    pub const fn unit_index(&self) -> Option<usize> {
        if self.unit == NO_UNIT {
            None
        } else {
            Some(self.unit as usize)
        }
    }

    /// A stored number as the type sees it.
    #[allow(clippy::cast_sign_loss)]
    const fn widen(&self, stored: i64) -> i128 {
        if self.data_type.0 == DataType::UNSIGNED64.0 {
            stored as u64 as i128
        } else {
            stored as i128
        }
    }
}

/// The entry at `address` in a table that ascends by address.
pub fn find_object<'t, 'm>(objects: &'t [ObjectDesc<'m>], address: Address) -> Option<&'t ObjectDesc<'m>> {
    let at = objects.binary_search_by_key(&address, ObjectDesc::address).ok()?;
    objects.get(at)
}

/// A unit: what one count is worth.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct UnitDesc<'m> {
    text: &'m str,
    quantity: QuantityKind,
    num: u32,
    den: u32,
}

impl<'m> UnitDesc<'m> {
    /// One count is `num / den` of the base unit of `quantity`; `text` is how a profile writes it: `0.1 rpm`.
    pub const fn new(text: &'m str, quantity: QuantityKind, num: u32, den: u32) -> Self {
        Self { text, quantity, num, den }
    }

    /// As a profile writes it.
    pub const fn text(&self) -> &'m str {
        self.text
    }

    /// What is measured.
    pub const fn quantity(&self) -> QuantityKind {
        self.quantity
    }

    /// What one count is worth, in base units: numerator and denominator.
    pub const fn factor(&self) -> (u32, u32) {
        (self.num, self.den)
    }
}

/// The only values that an entry takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Allowed<'m> {
    address: Address,
    values: &'m [i64],
}

impl<'m> Allowed<'m> {
    /// The entry at `address` takes these raw values only.
    pub const fn new(address: Address, values: &'m [i64]) -> Self {
        Self { address, values }
    }

    /// The entry.
    pub const fn address(&self) -> Address {
        self.address
    }

    /// The raw values.
    pub const fn values(&self) -> &'m [i64] {
        self.values
    }
}

/// The text that an entry holds as the drive ships.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TextDefault<'m> {
    address: Address,
    text: &'m str,
}

impl<'m> TextDefault<'m> {
    /// The entry at `address` holds this text.
    pub const fn new(address: Address, text: &'m str) -> Self {
        Self { address, text }
    }

    /// The entry.
    pub const fn address(&self) -> Address {
        self.address
    }

    /// The text.
    pub const fn text(&self) -> &'m str {
        self.text
    }
}
