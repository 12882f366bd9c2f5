//! What an SII cannot hold: one warning for each kind, and the same sentence in the listing.

use crate::backend::losses::losses;
use crate::diag::Code;

/// An SII cannot state a value.
pub const VALUE: Code = Code::warning("W2101", "an SII cannot state a value");
/// An SII has no place for it.
pub const PLACE: Code = Code::warning("W2102", "an SII has no place for something");
/// An SII is too long.
pub const SIZE: Code = Code::warning("W2103", "an SII does not fit the EEPROM");
/// A text is not written as printed.
pub const TEXT: Code = Code::warning("W2104", "a text of an SII is not written as printed");

losses! {
    "SII"
    MailboxWithoutManagers VALUE
        "the protocols of the mailbox are left out"
        "no SyncManager carries the mailbox in both directions, and masters take address and length from there"
        "add `sync_managers` for it, or correct `mailbox` of the row `ethercat`";
    ActiveWithoutLength VALUE
        "an active SyncManager without length is written as inactive"
        "slave controllers do not take a SyncManager that has no length"
        "correct `size` or `enable` of its row";
    Memory VALUE
        "a SyncManager lies beyond the addresses of the slave controller"
        "addresses have 16 bits"
        "state `start` and `size` in `sync_managers`, or correct the limits of PDOs in `drive`";
    CycleOfSync1 VALUE
        "the cycle of SYNC1 is left out"
        "an SII states it only as a factor of the cycle of SYNC0"
        "nothing; the ESI carries it";
    EmptyPdo PLACE
        "the PDO is not listed, since it carries nothing by default"
        "masters take a PDO without entries for a defect"
        "nothing; its mapping object is in the drive's dictionary";
    PdosTooLong PLACE
        "the PDO is not listed, since the ones before it fill the category"
        "the length of a category is 16 bits"
        "nothing; the ESI carries it";
    Ports PLACE
        "ports are left out"
        "an SII has four ports, of the kinds Y, K, H or none"
        "correct `physics` of the row `ethercat`";
    StartUp PLACE
        "values for the start-up are left out"
        "an SII has no place for them, so a master without the ESI must be told"
        "nothing; the ESI carries them";
    Size SIZE
        "the size of the EEPROM is not written as stated"
        "it is counted in units of 128 bytes, 65536 of them at most"
        "correct `eeprom_bytes` of the row `ethercat`";
    TooLong SIZE
        "the image is longer than the EEPROM"
        "a master that trusts the size reads a part of it"
        "state `eeprom_bytes` of the row `ethercat`";
    TextChanged TEXT
        "a text is not written as printed"
        "an SII holds texts of ASCII, at most 255 characters long"
        "nothing; model.json and the ESI carry it";
    TooManyTexts TEXT
        "a text is left out"
        "an SII holds 255 texts"
        "nothing; model.json and the ESI carry it";
}
