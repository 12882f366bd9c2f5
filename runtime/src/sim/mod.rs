//! The virtual drive: a physical axis and what moves it.

#[cfg(test)]
mod lcg;
mod motion;
pub mod planner;
pub mod plant;
