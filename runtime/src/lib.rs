#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
// What `wire_enum!` expands to, here in its own crate; each attribute in it would cost every enum of every drive.
#![allow(clippy::cast_lossless, clippy::expl_impl_clone_on_copy)]

#[cfg(test)]
extern crate std;

pub mod abort;
pub mod access;
pub mod address;
pub mod bit_field;
pub mod cia402;
pub mod client;
pub mod constant;
pub mod data_type;
pub mod homing;
pub mod mapping;
pub mod model;
pub mod object;
#[doc(hidden)]
pub mod optional;
pub mod pdo;
pub mod procedure;
pub mod quantity;
#[doc(hidden)]
pub mod row;
pub mod rule;
pub mod scale;
pub mod sim;
pub mod time;
pub mod transport;
pub mod value;
pub mod wire;
pub mod wire_enum;

mod ratio;
mod word;

pub use abort::AbortCode;
pub use address::Address;
pub use data_type::DataType;
pub use model::DriveModel;
pub use object::{ConvertError, EncodeError, Object, RangeError};
pub use scale::Scale;
pub use value::Value;
pub use wire::{Count, Fixed, Wire, WireError};

/// Everything that generated code and most programs name.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// pub const PROFILE_VELOCITY: Object<u32, Rw, RxTx, Velocity> =
///     Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
/// ```
pub mod prelude {
    pub use crate::abort::AbortCode;
    pub use crate::access::{Access, Const, Readable, Ro, Rw, Wo, Writable};
    pub use crate::address::Address;
    pub use crate::bit_field::{BitDesc, BitFieldDesc, Bits};
    pub use crate::data_type::DataType;
    pub use crate::homing::{HomingCase, HomingDesc};
    pub use crate::mapping::{Direction, MapNotStated, Mapping, MapsRx, MapsTx, Rx, RxTx, Tx, Unmapped};
    pub use crate::model::{
        AbortDesc, AlarmDesc, AlarmText, Allowed, CommandDesc, DefaultValue, DriveModel, Effect, EffectDesc,
        EmcyContent, EmcyDesc, EsmAfter, EsmState, Identity, Led, Meaning, ModeDesc, ModelError, ObjectDesc,
        PdoDesc, Remap, Reset, StateDesc, SyncMode, TerminalDesc, TerminalKind, TextDefault, UnitDesc,
    };
    pub use crate::object::{ConvertError, EncodeError, Object, RangeError};
    pub use crate::pdo::{LayoutMismatch, MapEntry, ProcessData};
    pub use crate::quantity::{
        Acceleration, Angle, Counts, Current, CurrentRatio, Energy, FixedUnit, Frequency, Inductance,
        Inertia, Length, Power, Quantity, QuantityKind, RampTime, Ratio, Raw, Resistance, Temperature, Time,
        Torque, TorqueRatio, UserAcceleration, UserPosition, UserVelocity, Velocity, Voltage,
    };
    pub use crate::scale::Scale;
    pub use crate::value::Value;
    pub use crate::wire::{
        Count, Domain, Fixed, OctetString, Text, TimeDifference, TimeOfDay, UnicodeString, VisibleString,
        Wire, WireError, I24, I40, I48, I56, U24, U40, U48, U56,
    };
    pub use crate::wire_enum::{EnumDesc, EnumValue};
    pub use crate::{bit_field, constant, pdo_layout, wire_enum};
}
