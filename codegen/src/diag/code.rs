//! Every code that a stage before [`crate::check`] can report. Lints carry their own code and page.
//!
//! A code never changes its meaning and is never given to another finding.

use super::Severity;

/// A stable code.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Code {
    id: &'static str,
    severity: Severity,
    title: &'static str,
}

impl Code {
    /// A code that stops emission.
    pub const fn error(id: &'static str, title: &'static str) -> Self {
        Self { id, severity: Severity::Error, title }
    }

    /// A code that does not.
    pub const fn warning(id: &'static str, title: &'static str) -> Self {
        Self { id, severity: Severity::Warning, title }
    }

    /// `E0102`.
    pub const fn id(self) -> &'static str {
        self.id
    }

    /// How bad it is.
    pub const fn severity(self) -> Severity {
        self.severity
    }

    /// What it is about, in a few words.
    pub const fn title(self) -> &'static str {
        self.title
    }
}

macro_rules! codes {
    ($($name:ident $kind:ident $id:literal $title:literal;)*) => {
        $(
            #[doc = concat!($id, ": ", $title, ".")]
            pub const $name: Code = Code::$kind($id, $title);
        )*
        /// Every code of the stages before the lints, ascending.
        pub const ALL: &[Code] = &[$($name),*];
    };
}

codes! {
    FILE_MISSING error "E0001" "a file or folder cannot be read";
    FILE_TOO_LARGE error "E0002" "a file is larger than a profile may be";
    NOT_UTF8 error "E0003" "a file is not UTF-8";
    TOO_MANY_FILES error "E0004" "a profile has too many files";
    PATH_OUTSIDE error "E0005" "a path leads out of the profile's folder";
    HIDDEN_CHARACTER error "E0006" "a text holds a character that readers cannot see";

    MORE_ERRORS error "E0007" "there are more findings than a run keeps";
    MORE_WARNINGS warning "W0008" "there are more warnings than a run keeps";
    NOT_A_FILE error "E0009" "what is named like a file is none";
    WRITTEN_TWICE error "E0010" "drivewright writes two files to one place";

    SYNTAX error "E0101" "the text is not TOML";
    UNKNOWN_TABLE error "E0102" "no such table";
    UNKNOWN_KEY error "E0103" "no such key in this table";
    MISSING_KEY error "E0104" "a row lacks a key that it must have";
    WRONG_KIND error "E0105" "a value has the wrong kind";
    BAD_VALUE error "E0106" "a value is not one of those allowed";
    NUMBER_RANGE error "E0107" "a number does not fit";
    TOO_LONG error "E0108" "a text or list is too long";
    TOO_MANY_ROWS error "E0109" "a table has too many rows";
    BAD_ADDRESS error "E0110" "an address is not `index:sub`";
    BAD_CITATION error "E0111" "a citation cannot be read";
    BAD_UNIT error "E0112" "a unit cannot be read";
    FORMAT_VERSION error "E0113" "the profile is of a format that this version does not know";
    FLOAT error "E0114" "a number has a fraction";
    BAD_PROGRAM error "E0115" "a homing program cannot be read";
    BAD_EXPRESSION error "E0116" "an expression cannot be read";
    BAD_ID error "E0117" "an id is not of lower-case letters, digits and `-`";
    TOO_DEEP error "E0118" "values are nested too deep";
    TOO_MANY_TABLES error "E0119" "a file has too many tables";
    TOO_MANY_KEYS error "E0120" "a row has too many keys";
    NOT_XML error "E0121" "the text is not XML";
    DOCTYPE error "E0122" "a file declares a document type";
    ENTITY error "E0123" "a reference names no character";
    NAMESPACE error "E0124" "a name belongs to a namespace";
    MISPLACED error "E0125" "an element or text stands where none belongs";
    INSTRUCTION error "E0126" "a file holds a processing instruction";
    ENCODING error "E0127" "a file says that it is not UTF-8";
    INEXPRESSIBLE error "E0128" "another format cannot say this";

    UNKNOWN_BASE error "E0201" "no such base";
    DUPLICATE_ROW error "E0202" "two rows state the same thing";
    ERRATUM_TARGET error "E0203" "an erratum matches no row";
    ERRATUM_WAS error "E0204" "an erratum expects another value";
    ERRATUM_TWICE error "E0205" "two errata change one value";
    ERRATUM_NO_CHANGE error "E0206" "an erratum sets the value that is already there";
    CONTRADICTS_BASE error "E0207" "a row contradicts the standard object without a reason";
    DEVIATION_UNUSED error "E0208" "a deviation is declared where nothing deviates";
    DRIVE_ROWS error "E0209" "a profile has one drive";
    ALLOW_UNUSED error "E0210" "an allowance matches no finding";
    TOO_MANY_BASES error "E0211" "a profile names too many bases";

    TYPE_UNKNOWN error "E0301" "nobody states the type of an object";
    ACCESS_UNKNOWN error "E0302" "nobody states the access of an object";
    NAME_UNKNOWN error "E0303" "nobody states the name of an object";
    NAME_EMPTY error "E0304" "a name has no letter or digit";
    NAME_CLASH error "E0305" "two names are the same words";
    UNKNOWN_ENUM error "E0306" "no such value table";
    UNKNOWN_BITS error "E0307" "no such bit table";
    UNKNOWN_OBJECT error "E0308" "no such object";
    UNKNOWN_MANUAL error "E0309" "no such manual";
    TOO_MANY_ENTRIES error "E0310" "a drive has too many entries";
    NAMED_FIELD error "E0311" "a row names a field that it does not have";
    HOMING_ROWS error "E0312" "the rows of a homing method do not go together";
    TOO_MANY_MAPPED error "E0313" "a PDO has more entries than a mapping can count";
    PDO_TOO_LONG error "E0314" "a PDO has more bytes than a frame can carry";
    TOO_MANY_PDOS error "E0315" "a drive has too many PDOs";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_ascend_and_differ() {
        assert!(ALL.windows(2).all(|w| w[0].id()[1..] < w[1].id()[1..]));
    }
}
