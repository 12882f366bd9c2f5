//! Values that a profile writes as one of some words.

pub use drivewright_runtime::homing::{Edge, HomingSignal, HomingStart, HomingStatus, Side, Signal};
pub use drivewright_runtime::model::{Effect, EmcyContent, EsmAfter, EsmState, Led, SyncMode, TerminalKind};
pub use drivewright_runtime::rule::Occasion;

/// A value that stands for one of a fixed list of words.
pub trait Worded: Copy + 'static {
    /// Every value, in the order of the documentation.
    const ALL: &'static [Self];

    /// The word of profiles and of every output.
    fn word(self) -> &'static str;

    /// The value that `word` stands for.
    fn from_word(word: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|value| value.word() == word)
    }
}

/// Defines enums with a word for each variant.
macro_rules! worded {
    ($(
        $(#[doc = $doc:literal])+
        $name:ident { $( $(#[doc = $variant_doc:literal])+ $variant:ident = $word:literal, )+ }
    )+) => {$(
        $(#[doc = $doc])+
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum $name {
            $( $(#[doc = $variant_doc])+ $variant, )+
        }

        impl $name {
            /// The word of profiles and of every output.
            pub fn word(self) -> &'static str {
                match self {
                    $(Self::$variant => $word,)+
                }
            }
        }

        impl Worded for $name {
            const ALL: &'static [Self] = &[$(Self::$variant),+];

            fn word(self) -> &'static str {
                self.word()
            }
        }
    )+};
}

/// Words that programs for a drive know, too: the runtime defines them.
macro_rules! worded_by_runtime {
    ($($name:ident)+) => {$(
        impl Worded for $name {
            const ALL: &'static [Self] = $name::ALL;

            fn word(self) -> &'static str {
                $name::word(self)
            }
        }
    )+};
}

worded_by_runtime! {
    Edge Effect EmcyContent EsmAfter EsmState HomingSignal HomingStart HomingStatus Led Occasion Side Signal SyncMode
    TerminalKind
}

worded! {
    /// SDO access.
    Access {
        /// Read only.
        Ro = "ro",
        /// Read and write.
        Rw = "rw",
        /// Write only.
        Wo = "wo",
        /// Read only, never changes.
        Const = "const",
    }

    /// Direction of process data, seen from the drive.
    Direction {
        /// Received by the drive.
        Rx = "rx",
        /// Sent by the drive.
        Tx = "tx",
    }

    /// What an index holds.
    ObjectKind {
        /// One value at sub-index 0.
        Var = "var",
        /// Values of one type at sub-indexes 1.., their count at 0.
        Array = "array",
        /// Values of several types, the highest sub-index at 0.
        Record = "record",
    }

    /// How an alarm is cleared.
    Reset {
        /// By a fault reset, once the cause is gone.
        Resettable = "resettable",
        /// Not by a fault reset.
        NotResettable = "not resettable",
    }

    /// How sure an erratum is.
    Sure {
        /// Nothing else fits.
        High = "high",
        /// The likelier reading.
        Medium = "medium",
        /// A choice that a device must confirm.
        Low = "low",
    }

    /// What a SyncManager carries.
    SyncManagerUse {
        /// Mailbox, master to drive.
        MailboxOut = "mailbox out",
        /// Mailbox, drive to master.
        MailboxIn = "mailbox in",
        /// Process data that the drive receives.
        Outputs = "outputs",
        /// Process data that the drive sends.
        Inputs = "inputs",
    }

    /// What an FMMU maps.
    FmmuUse {
        /// Process data that the drive receives.
        Outputs = "outputs",
        /// Process data that the drive sends.
        Inputs = "inputs",
        /// The status of the mailbox.
        MailboxStatus = "mailbox status",
    }

    /// A protocol of the EtherCAT mailbox.
    MailboxProtocol {
        /// ADS over EtherCAT.
        Aoe = "aoe",
        /// Ethernet over EtherCAT.
        Eoe = "eoe",
        /// CANopen over EtherCAT.
        Coe = "coe",
        /// File access over EtherCAT.
        Foe = "foe",
        /// SERCOS over EtherCAT.
        Soe = "soe",
        /// A protocol of the maker's over EtherCAT.
        Voe = "voe",
    }

    /// What CoE can do beyond reading and writing one entry.
    CoeFeature {
        /// The list of objects, their names, types and access can be read.
        SdoInformation = "sdo information",
        /// Which PDOs are active can be written: 1C12h, 1C13h.
        PdoAssignment = "pdo assignment",
        /// What a PDO carries can be written: 1600h, 1A00h.
        PdoConfiguration = "pdo configuration",
        /// The master can read assignment and mapping instead of knowing them.
        PdoUpload = "pdo upload",
        /// All entries of an object in one transfer.
        CompleteAccess = "complete access",
        /// Values that are longer than the mailbox, in segments.
        SegmentedSdo = "segmented sdo",
    }

    /// What the drive is synchronized by.
    DcSync {
        /// By nothing, or by the arrival of process data.
        FreeRun = "free run",
        /// By SYNC0 of the distributed clock.
        Sync0 = "sync0",
        /// By SYNC0 and SYNC1 of the distributed clock.
        Sync0And1 = "sync0 sync1",
    }

    /// A change between states of the EtherCAT state machine.
    Transition {
        /// Init to Pre-Operational.
        InitToPreOp = "IP",
        /// Pre-Operational to Safe-Operational.
        PreOpToSafeOp = "PS",
        /// Safe-Operational to Operational.
        SafeOpToOp = "SO",
        /// Safe-Operational to Pre-Operational.
        SafeOpToPreOp = "SP",
        /// Operational to Pre-Operational.
        OpToPreOp = "OP",
        /// Operational to Safe-Operational.
        OpToSafeOp = "OS",
    }

    /// Which revisions of a device a device file holds for. The low word counts what is compatible, the high word what is not.
    RevisionCheck {
        /// Every one.
        Any = "any",
        /// This one.
        Equal = "equal",
        /// This one and higher ones.
        EqualOrHigher = "equal or higher",
        /// Those with this low word.
        LowEqual = "low equal",
        /// Those with this low word and this or a higher high word.
        LowEqualHighOrHigher = "low equal, high equal or higher",
        /// Those with this high word.
        HighEqual = "high equal",
        /// Those with this high word and this or a higher low word.
        HighEqualLowOrHigher = "high equal, low equal or higher",
    }
}

impl Access {
    /// Whether an upload can succeed.
    pub fn reads(self) -> bool {
        self != Self::Wo
    }

    /// Whether a download can succeed.
    pub fn writes(self) -> bool {
        matches!(self, Self::Rw | Self::Wo)
    }

    /// Whether a PDO of this direction can carry the value: what a PDO brings is written, what it sends is read.
    pub fn carries(self, direction: Direction) -> bool {
        if direction == Direction::Rx { self.writes() } else { self.reads() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_back() {
        assert_eq!(Access::from_word("wo"), Some(Access::Wo));
        assert_eq!(EsmAfter::ALL.len(), 6);
        assert!(EsmState::ALL.iter().all(|s| EsmState::from_word(s.word()) == Some(*s)));
        assert_eq!(Led::from_word("Blinking"), None);
    }
}
