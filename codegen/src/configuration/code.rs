//! The codes of findings about a configuration.

use crate::diag::Code;

macro_rules! codes {
    ($($name:ident $kind:ident $id:literal $title:literal;)*) => {
        $(
            #[doc = concat!($id, ": ", $title, ".")]
            pub const $name: Code = Code::$kind($id, $title);
        )*
        /// Every code of a configuration, ascending.
        pub const ALL: &[Code] = &[$($name),*];
    };
}

codes! {
    ONE_AXIS error "E2001" "a configuration has one axis";
    OTHER_DRIVE error "E2002" "a configuration is of another drive";
    NODE_ID error "E2003" "a node-ID is not 1 to 127";
    BIT_RATE error "E2004" "a bit rate is none of a CANopen bus";
    NODE_NAME error "E2005" "a node name is no line of ASCII";
    NO_OBJECT error "E2006" "a drive has no such object";
    READ_ONLY error "E2007" "an object cannot be written";
    NOT_TAKEN error "E2008" "an object does not take a value";
    NO_SETTING error "E2009" "an object is no setting";
    NO_COUNT error "E2010" "a quantity is not a whole number of counts";
    NO_PDO error "E2011" "a drive has no such PDO";
    MAPPING_FIXED error "E2012" "the mapping of a PDO is fixed";
    NOT_MAPPABLE error "E2013" "a PDO cannot carry an object";
    TOO_MANY_MAPPED error "E2014" "a PDO has more entries than the drive can map";
    PDO_TOO_LONG error "E2015" "a PDO has more bytes than it can carry";
    COB_ID error "E2016" "a CAN identifier cannot be used for a PDO";
    RULE_BROKEN error "E2017" "a configuration breaks a rule of the manual";
    OVERWRITTEN warning "W2018" "a PDO overwrites a value";
    TABLE_BELOW error "E2019" "a table stands below the header of another one";
    NOT_ACTIVE warning "W2020" "a PDO is mapped and not active";
}
