//! CiA 402 as tables and pure functions: states, commands, transitions, option codes, modes, homing status.
//!
//! Both ends use them: the client decodes what a drive reports, the virtual drive does what it is told. Nothing here
//! keeps state, knows a clock or sends anything.

mod command;
mod homing;
mod mode;
mod option;
mod state;
mod transition;

pub use command::{Command, Controlword};
pub use homing::HomingState;
pub use mode::{Mode, ModeBits};
pub use option::{Reaction, StopOption};
pub use state::{State, Statusword};
pub use transition::{Cause, Options, Transition};
