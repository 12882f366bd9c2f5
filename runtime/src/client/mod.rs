//! The client of a drive: what a program does with one.
//!
//! Services over SDO are machines of [`procedure`](crate::procedure): a program runs them on its bus, or one request at a
//! time in a loop of its own. None allocates; what a service finds goes into memory that the caller gives, or to a
//! function of the caller. Errors say what happened, why, and what to do: [`message`].
//!
//! Motion has three floors. [`Axis`] is the cyclic machine of CiA 402, without any bus. An [`Operation`] runs goals of it
//! over a bus, with process data where an [`Image`] says that they are mapped. [`Drive`] and [`AsyncDrive`] are calls.
//!
//! [`Operation`]: session::Operation

pub mod axis;
pub mod compare;
pub mod decode;
pub mod drive;
pub mod error;
pub mod fault;
pub mod home;
pub mod identify;
pub mod image;
pub mod layout;
pub mod message;
pub mod moves;
pub mod object;
pub mod parameters;
pub mod session;
mod tally;
pub mod units;

pub use axis::{Axis, AxisPolicy};
pub use drive::{AsyncDrive, Drive};
pub use error::{ClientError, DriveError};
pub use home::Homing;
pub use image::Image;
pub use moves::MoveTo;
pub use session::Client;

#[cfg(test)]
mod testing;
