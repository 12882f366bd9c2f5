//! Turns merged rows into a model.
