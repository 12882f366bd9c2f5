//! How much of each thing a profile may hold. One place, so that the documentation and every check agree.

/// Bytes of one profile file (8 MiB).
pub const FILE_BYTES: usize = 8 << 20;
/// Files of one profile.
pub const FILES: usize = 64;
/// Bytes of an output path.
pub const PATH_BYTES: usize = 200;
/// Tables of one file, known or not.
pub const TABLES: usize = 256;
/// Keys of one row, known or not.
pub const KEYS: usize = 64;
/// Rows of one table in one file.
pub const ROWS: usize = 100_000;
/// Object entries of a drive after ranges are expanded.
pub const ENTRIES: usize = 100_000;
/// Findings that a run keeps; further ones are counted.
pub const FINDINGS: usize = 10_000;
/// Names that a message lists where none is near the one written.
pub const SUGGESTIONS: usize = 24;
/// Bytes of a value in a message.
pub const BRIEF_BYTES: usize = 200;
/// Bits of the widest object.
pub const OBJECT_BITS: u8 = 64;
/// Values of a list in one row.
pub const LIST_VALUES: usize = 4_096;
/// Bytes of a name.
pub const NAME_BYTES: usize = 200;
/// Bytes of any other text.
pub const TEXT_BYTES: usize = 4_096;
/// PDOs of a drive.
pub const PDOS: usize = 512;
/// Entries of one PDO: what a mapping record can count.
pub const PDO_ENTRIES: u32 = 254;
/// Bytes of one `SyncManager`'s process data.
pub const PDO_BYTES: u32 = 1_486;
/// Bases of one profile.
pub const BASES: usize = 8;
/// Numerator or denominator of a unit's factor.
pub const FACTOR: u32 = 1_000_000_000;
