//! What an EDS cannot hold: one warning for each kind, and the same sentence for the comments of the file.

use crate::backend::losses::losses;
use crate::diag::Code;

/// An EDS cannot state a value.
pub const VALUE: Code = Code::warning("W1001", "an EDS cannot state a value");
/// Limits contradict each other or the default.
pub const LIMITS: Code = Code::warning("W1002", "limits contradict each other or the default");
/// An EDS has no place for an object.
pub const PLACE: Code = Code::warning("W1003", "an EDS has no place for an object");
/// An object lacks what CiA 306 demands.
pub const SHAPE: Code = Code::warning("W1004", "an object lacks what CiA 306 demands");
/// A text is not written as printed.
pub const TEXT: Code = Code::warning("W1005", "a text is not written as printed");

losses! {
    "EDS"
    TextDefault VALUE
        "the default is text and is left out"
        "readers disagree on whether text stands in quotes"
        "nothing; model.json and the generated crate carry it";
    OtherDefault VALUE
        "the default has no form that every reader takes and is left out"
        "CiA 306 does not say how reals and times are written, and readers disagree"
        "nothing; model.json and the generated crate carry it";
    DefaultOutsideType VALUE
        "the default is no value of the type and is left out"
        "readers cut it to another number, or refuse the file"
        "correct `type` or `default`, or add an erratum";
    LimitOutsideType VALUE
        "a limit is no value of the type and is left out"
        "readers cut it to another number, or refuse the file"
        "correct `type`, `min` or `max`, or add an erratum";
    LimitOfOtherType VALUE
        "limits of a type that is no integer are left out"
        "CiA 306 has limits for integers only"
        "nothing; model.json and the generated crate carry them";
    MappedDomain VALUE
        "a DOMAIN is not marked as mappable"
        "a PDO carries values of fixed length, and CiA 306 has no such key for a DOMAIN"
        "correct `type` or `pdo`";
    DefaultOutsideLimits LIMITS
        "the default is outside the limits and is left out"
        "readers refuse a file whose default breaks its own limits"
        "correct `default`, `min` or `max`, or add an erratum";
    LimitsCrossed LIMITS
        "the lowest value is above the highest, and both limits are left out"
        "no value could be written"
        "correct `min` or `max`, or add an erratum";
    IndexOfDataTypes PLACE
        "the object is left out"
        "indexes below 1000h are data types, which none of the three object lists may hold"
        "correct `at`";
    SubIndexFf PLACE
        "the entry is left out"
        "CiA 306 lists sub-indexes 00h to FEh; FFh describes the object itself"
        "correct `at`";
    NoSubIndex0 SHAPE
        "the object has no sub-index 0, and some readers refuse that"
        "an array or record says at sub-index 0 how many entries it has"
        "add sub-index 0 if the drive has it";
    VarWithSubIndexes SHAPE
        "the object is a variable with other sub-indexes than 0, and is written as a record"
        "an EDS lists sub-indexes of arrays and records only"
        "correct `kind`";
    MandatoryMissing SHAPE
        "a mandatory object is missing, and some readers refuse that"
        "CiA 306 demands 1000h, 1001h and 1018h"
        "add it if the drive has it";
    NameChanged TEXT
        "a name is not written as printed"
        "an EDS holds one line of at most 241 characters of ASCII, in which some signs have a meaning of their own"
        "nothing, or a shorter `name`; model.json and the generated crate carry it";
    DriveTextChanged TEXT
        "the name of the maker or of the product is not written as printed"
        "an EDS holds one line of at most 240 characters of ASCII"
        "nothing, or a shorter `vendor` or `name`";
}
