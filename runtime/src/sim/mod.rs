//! A drive without hardware: as strict as a real one, from the model of the drive.
//!
//! A [`VirtualDrive`] answers SDO, exchanges process data, runs the state machine of CiA 402 and moves a physical axis.
//! Its values lie in memory of the caller, its time is what it is told. What a manual does not say is a setting of
//! [`Config`], listed with its reason in [`ASSUMPTIONS`]: nothing here is said of the maker's drive.
//!
//! [`Link`] joins it with a client in one program; [`Disturbed`] lies between them and does what real wires do.

mod aborts;
mod alarms;
mod assumptions;
mod config;
mod cycle;
mod device;
mod drive;
mod events;
mod faults;
mod history;
#[cfg(test)]
mod lcg;
mod link;
mod memory;
mod modes;
mod motion;
mod network;
mod number;
pub mod planner;
pub mod plant;
mod process;
mod remap;
mod rules;
#[cfg(test)]
mod samples;
mod server;
mod slots;
mod store;
#[cfg(test)]
mod tests;
mod words;

pub use alarms::{ActiveAlarm, Emergency, UnknownAlarm, MAX_ALARMS, MAX_MESSAGES};
pub use assumptions::{Assumption, ASSUMPTIONS};
pub use config::{Config, HomeOffset, Keeps};
pub use drive::{NoAnswer, VirtualDrive};
pub use events::Incident;
pub use faults::{Disturbance, Disturbed, MAX_DISTURBANCES};
pub use link::Link;
pub use memory::{cells, SpaceError};
pub use network::BusRefusal;
pub use process::MAX_MAPPED;
