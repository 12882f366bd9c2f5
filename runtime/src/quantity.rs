//! What is measured: a marker type of a handle, and a value of a table. Each has one base unit.

use core::fmt;

use crate::mapping::sealed::Sealed;

/// A quantity, as a marker type.
pub trait Quantity: Sealed + Copy + PartialEq + fmt::Debug + 'static {
    /// The marker as a value.
    const KIND: QuantityKind;
}

/// A quantity whose unit does not depend on settings of the drive.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no fixed unit: one count depends on gear objects of the drive, or the manual states no unit",
    label = "only raw counts can be used here without a `Scale`",
    note = "for a user unit read the gear objects, build a `Scale`, and call `raw_with` or `value_with`; otherwise work in raw counts"
)]
pub trait FixedUnit: Quantity {}

/// A user unit that a [`Scale`](crate::Scale) can express in the base unit of `P`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be expressed as `{P}`",
    label = "a `Scale` joins a user unit with the quantity that it moves",
    note = "user positions are angles or lengths, user velocities are velocities, user accelerations are accelerations"
)]
pub trait UserUnit<P: FixedUnit>: Quantity {}

macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident = $words:literal, $symbol:literal $(, $fixed:ident)?;)*) => {
        /// A quantity, as a value.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        #[repr(u8)]
        pub enum QuantityKind {
            $($(#[$doc])* $name,)*
        }

        impl QuantityKind {
            /// Every quantity, in the order of declaration.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// The name in words, in lower case.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $words,)*
                }
            }

            /// The symbol of the base unit; empty for a number without one.
            pub const fn symbol(self) -> &'static str {
                match self {
                    $(Self::$name => $symbol,)*
                }
            }
        }

        $(
            $(#[$doc])*
            #[derive(Clone, Copy, PartialEq, Eq, Debug)]
            pub enum $name {}
            impl Sealed for $name {}
            impl Quantity for $name {
                const KIND: QuantityKind = QuantityKind::$name;
            }
            $(impl $fixed for $name {})?
        )*
    };
}

quantities! {
    /// A number without a unit, or one whose unit the manual does not state.
    Raw = "raw", "";
    /// Position in user units, which depend on gear objects.
    UserPosition = "user position", "user units";
    /// Velocity in user units, which depend on gear objects.
    UserVelocity = "user velocity", "user units/s";
    /// Acceleration in user units, which depend on gear objects.
    UserAcceleration = "user acceleration", "user units/s²";
    /// Encoder counts.
    Counts = "counts", "counts", FixedUnit;
    /// Angle; base unit: revolution.
    Angle = "angle", "rev", FixedUnit;
    /// Speed of rotation; base unit: revolution per minute.
    Velocity = "velocity", "rpm", FixedUnit;
    /// Acceleration; base unit: revolution per minute, per second.
    Acceleration = "acceleration", "rpm/s", FixedUnit;
    /// Time that a ramp takes for a change of 1,000 rpm; base unit: second.
    RampTime = "ramp time", "s/1000 rpm", FixedUnit;
    /// Time; base unit: second.
    Time = "time", "s", FixedUnit;
    /// Torque as a share of rated torque; 1 is rated torque.
    TorqueRatio = "torque ratio", "rated torque", FixedUnit;
    /// Torque; base unit: newton metre.
    Torque = "torque", "N m", FixedUnit;
    /// Current as a share of rated current; 1 is rated current.
    CurrentRatio = "current ratio", "rated current", FixedUnit;
    /// Current; base unit: ampere.
    Current = "current", "A", FixedUnit;
    /// Voltage; base unit: volt.
    Voltage = "voltage", "V", FixedUnit;
    /// Power; base unit: watt.
    Power = "power", "W", FixedUnit;
    /// Energy; base unit: joule.
    Energy = "energy", "J", FixedUnit;
    /// Temperature; base unit: degree Celsius.
    Temperature = "temperature", "°C", FixedUnit;
    /// Frequency; base unit: hertz.
    Frequency = "frequency", "Hz", FixedUnit;
    /// A share of something else; 1 is all of it.
    Ratio = "ratio", "", FixedUnit;
    /// Resistance; base unit: ohm.
    Resistance = "resistance", "ohm", FixedUnit;
    /// Inductance; base unit: henry.
    Inductance = "inductance", "H", FixedUnit;
    /// Moment of inertia; base unit: kilogram square metre.
    Inertia = "inertia", "kg m²", FixedUnit;
    /// Length; base unit: metre.
    Length = "length", "m", FixedUnit;
}

impl UserUnit<Angle> for UserPosition {}
impl UserUnit<Length> for UserPosition {}
impl UserUnit<Counts> for UserPosition {}
impl UserUnit<Velocity> for UserVelocity {}
impl UserUnit<Acceleration> for UserAcceleration {}
