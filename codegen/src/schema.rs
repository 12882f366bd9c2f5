//! JSON schema of the profile format, generated from the row types.
