//! Joins rows with their bases and applies errata.
