//! A driver of the SAVCH SDV3-E. No index, width, bit or byte offset is typed here: all of them come from the profile.
//!
//! The same drive is here twice, to show both ways: as the generated crate, which [`Driver`] uses, and compiled by
//! `build.rs` into [`compiled`]. A real driver takes one of them.

#![no_std]

use core::fmt;

use drivewright_runtime::prelude::*;
use savch_sdv3_e::bits::Controlword;
use savch_sdv3_e::{od, pdo};

/// The drive as `build.rs` compiled it.
#[rustfmt::skip]
pub mod compiled {
    include!(concat!(env!("OUT_DIR"), "/savch_sdv3_e.rs"));
}

/// How objects are reached outside of the cycle: what a user writes for a master, in a few lines.
pub trait Sdo {
    /// Why a transfer failed.
    type Error;

    /// Reads an object into `buffer`; returns how many bytes.
    ///
    /// # Errors
    /// Whatever stopped the transfer.
    fn upload(&mut self, at: Address, buffer: &mut [u8]) -> Result<usize, Self::Error>;

    /// Writes an object.
    ///
    /// # Errors
    /// Whatever stopped the transfer.
    fn download(&mut self, at: Address, bytes: &[u8]) -> Result<(), Self::Error>;
}

/// Why a call failed.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error<E> {
    /// The transfer failed.
    Transfer(E),
    /// The value is outside of what the drive accepts; nothing was sent.
    Refused(EncodeError),
    /// The value has no exact number of counts, or too many.
    Unit(ConvertError),
    /// The drive answered with another length than the type has.
    Answer(WireError),
    /// Another device answers.
    Identity {
        /// What the profile says.
        expected: u32,
        /// What the device says.
        found: u32,
    },
}

impl<E: fmt::Display> fmt::Display for Error<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Transfer(error) => error.fmt(f),
            Self::Refused(error) => error.fmt(f),
            Self::Unit(error) => error.fmt(f),
            Self::Answer(error) => error.fmt(f),
            Self::Identity { expected, found } => {
                write!(f, "product code is {found:08X}h, and this driver is for {expected:08X}h")
            }
        }
    }
}

/// One drive behind a master.
pub struct Driver<S> {
    sdo: S,
}

impl<S: Sdo> Driver<S> {
    /// Takes a drive over after asking for its product code.
    ///
    /// # Errors
    /// [`Error::Identity`] if another device answers; errors of the transfer.
    pub fn new(mut sdo: S) -> Result<Self, Error<S::Error>> {
        let mut buffer = [0; 4];
        let length = sdo.upload(od::PRODUCT_CODE.address(), &mut buffer).map_err(Error::Transfer)?;
        let found = od::PRODUCT_CODE.decode(&buffer[..length.min(4)]).map_err(Error::Answer)?;
        match savch_sdv3_e::MODEL.identity().product_code() {
            Some(expected) if expected != found => Err(Error::Identity { expected, found }),
            _ => Ok(Self { sdo }),
        }
    }

    /// Sets the velocity of positioning moves (6081h).
    ///
    /// # Errors
    /// [`Error::Unit`] unless it is a whole number of 0.1 r/min in the range of the drive; errors of the transfer.
    pub fn set_profile_velocity(&mut self, velocity: Value<Velocity>) -> Result<(), Error<S::Error>> {
        let raw = od::PROFILE_VELOCITY.raw_from(velocity).map_err(Error::Unit)?;
        let mut buffer = [0; 4];
        let length = od::PROFILE_VELOCITY.encode(raw, &mut buffer).map_err(Error::Refused)?;
        self.sdo.download(od::PROFILE_VELOCITY.address(), &buffer[..length]).map_err(Error::Transfer)
    }
}

/// The bytes of one cycle: velocity `velocity`, everything else zero, all four bits of the state machine set.
///
/// # Errors
/// [`ConvertError`] unless `velocity` is a whole number of 0.1 r/min in the range of the drive.
pub fn run_at(velocity: Value<Velocity>) -> Result<[u8; pdo::Rx1::BYTES], ConvertError> {
    let image = pdo::Rx1 {
        control_word: Controlword(0)
            .with(Controlword::SWITCH_ON, true)
            .with(Controlword::ENABLE_VOLTAGE, true)
            .with(Controlword::QUICK_STOP, true)
            .with(Controlword::ENABLE_OPERATION, true),
        target_velocity: od::TARGET_VELOCITY.raw_from(velocity)?,
        target_position: 0,
        target_torque: 0,
        modes_of_operation: savch_sdv3_e::enums::ModeOfOperation::CYCLE_SYNCHRONIZED_VELOCITY_MODE,
    };
    Ok(image.pack())
}
