//! What an ESI cannot hold: one warning for each kind, and the same sentence in the comment of the file.

use crate::backend::losses::losses;
use crate::diag::Code;

/// An ESI cannot state a value.
pub const VALUE: Code = Code::warning("W1901", "an ESI cannot state a value");
/// An ESI has no place for an object.
pub const PLACE: Code = Code::warning("W1902", "an ESI has no place for an object");
/// An ESI demands the length of a type that has none.
pub const LENGTH: Code = Code::warning("W1903", "an ESI demands the length of a type that has none");
/// A unit has no code.
pub const UNIT: Code = Code::warning("W1904", "a unit has no code");
/// Process data does not fit the slave controller.
pub const MEMORY: Code = Code::warning("W1905", "process data does not fit the slave controller");

losses! {
    "ESI"
    DefaultOutsideType VALUE
        "the default is no value of the type and is left out"
        "an ESI states values as the bytes of their type"
        "correct `type` or `default`, or add an erratum";
    LimitOutsideType VALUE
        "a limit is no value of the type and is left out"
        "an ESI states values as the bytes of their type"
        "correct `type`, `min` or `max`, or add an erratum";
    OtherDefault VALUE
        "the default has no form in bytes and is left out"
        "nobody states how the text of the default becomes bytes"
        "nothing; model.json and the generated crate carry it";
    LimitOfOtherType VALUE
        "limits of a type that is no integer are left out"
        "masters read limits of integers only"
        "nothing; model.json and the generated crate carry them";
    NamedValue VALUE
        "named values of more than 32 bits are left out"
        "older masters take the values of an enumeration for 32 bits"
        "nothing; model.json and the generated crate carry them";
    CycleTooLong VALUE
        "a cycle of 2.1 seconds or more is left out"
        "an ESI holds cycle times in ns in 31 bits"
        "correct `cycle0` or `cycle1`";
    StartUpValue VALUE
        "a start-up value that is no value of the entry's type is left out"
        "an ESI states values as the bytes of their type"
        "correct `value`";
    StartUpWithoutCoe PLACE
        "values for the start-up are left out"
        "an ESI holds them in the description of CoE, and the drive's mailbox has none"
        "correct `mailbox` of the row `ethercat`";
    IndexOfDataTypes PLACE
        "the object is left out"
        "indexes below 1000h are data types, which an ESI describes elsewhere"
        "correct `at`";
    SubIndexFf PLACE
        "the entry is left out"
        "sub-index FFh describes the object itself"
        "correct `at`";
    EmptyPdo PLACE
        "the PDO is not listed, since it carries nothing by default"
        "readers refuse a PDO without entries"
        "nothing; its mapping object is in the dictionary";
    LengthUnknown LENGTH
        "the length is that of the default, or 32 bytes"
        "an ESI states a length for every type, and nobody states that of a text or a domain"
        "nothing; a master reads the length that the drive sends";
    NoUnit UNIT
        "the unit is left out"
        "the codes of ETG.1004 have a factor of a power of ten"
        "nothing; model.json and the generated crate carry it";
    Memory MEMORY
        "a SyncManager lies beyond the addresses of the slave controller"
        "addresses have 16 bits"
        "state `start` and `size` in `sync_managers`, or correct the limits of PDOs in `drive`";
}
