//! Reads a profile's folder into texts.
