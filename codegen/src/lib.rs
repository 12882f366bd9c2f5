//! Compiles servo-drive profiles.
//!
//! `load → parse → merge → resolve → check → emit → sink`, one way: see `ARCHITECTURE.md`.

pub mod backend;
pub mod check;
pub mod diag;
pub mod emit;
pub mod facts;
pub mod limits;
pub mod load;
pub mod merge;
pub mod model;
pub mod name;
pub mod raw;
pub mod resolve;
pub mod rows;
pub mod schema;
pub mod sink;
pub mod source;
