//! The virtual drive: a physical axis and what moves it.

mod motion;
pub mod planner;
pub mod plant;
