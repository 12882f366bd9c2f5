//! Values that a profile writes as one of some words.

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

    /// When a written parameter takes effect.
    Effect {
        /// At once.
        AtOnce = "at once",
        /// At the next standstill.
        AtStop = "at stop",
        /// After the next power cycle.
        PowerCycle = "power cycle",
    }

    /// A state of the EtherCAT state machine.
    EsmState {
        /// Init.
        Init = "Init",
        /// Pre-Operational.
        PreOp = "PreOP",
        /// Safe-Operational.
        SafeOp = "SafeOP",
        /// Operational.
        Op = "OP",
    }

    /// The state of the EtherCAT state machine after an alarm.
    EsmAfter {
        /// Init.
        Init = "Init",
        /// Pre-Operational.
        PreOp = "PreOP",
        /// Safe-Operational.
        SafeOp = "SafeOP",
        /// Operational.
        Op = "OP",
        /// The one before.
        Kept = "kept",
        /// The one that the master asks for.
        Requested = "requested",
    }

    /// The synchronization in which an alarm is detected.
    SyncMode {
        /// Every one.
        All = "all",
        /// Distributed clocks.
        Dc = "dc",
        /// Free run.
        FreeRun = "free run",
    }

    /// What the error indicator shows.
    Led {
        /// Off.
        Off = "off",
        /// On.
        On = "on",
        /// Blinking.
        Blinking = "blinking",
        /// One flash, then a pause.
        SingleFlash = "single flash",
        /// Two flashes, then a pause.
        DoubleFlash = "double flash",
    }

    /// What a terminal is.
    TerminalKind {
        /// A digital input.
        Input = "input",
        /// A digital output.
        Output = "output",
        /// A common line of inputs or outputs.
        Common = "common",
        /// A supply or its ground.
        Supply = "supply",
        /// A port of the bus.
        Port = "port",
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

    /// Whether a drive has a homing method.
    HomingStatus {
        /// It has it.
        Supported = "supported",
        /// The number is kept for later.
        Reserved = "reserved",
        /// The manual names it and says that the drive does not have it.
        NotAvailable = "not available",
    }

    /// Direction of the first move of a homing method.
    HomingStart {
        /// Towards lower positions.
        Negative = "negative",
        /// Towards higher positions.
        Positive = "positive",
        /// It depends on the switch at the start.
        BySwitch = "by switch",
    }

    /// What a homing method looks for.
    HomingSignal {
        /// The negative limit switch.
        NegativeLimit = "negative_limit",
        /// The positive limit switch.
        PositiveLimit = "positive_limit",
        /// The home switch.
        Home = "home",
        /// The index pulse of the encoder.
        Index = "index",
        /// A hard stop.
        Stall = "stall",
        /// The place where the axis stands.
        Here = "here",
    }

    /// A side, seen from a signal.
    Side {
        /// Lower positions.
        Negative = "negative",
        /// Higher positions.
        Positive = "positive",
    }

    /// A change of a signal, as time goes on.
    Edge {
        /// It becomes active.
        Rising = "rising",
        /// It becomes inactive.
        Falling = "falling",
    }

    /// A switch that homing looks at.
    Signal {
        /// The negative limit switch.
        NegativeLimit = "negative_limit",
        /// The positive limit switch.
        PositiveLimit = "positive_limit",
        /// The home switch.
        Home = "home",
    }

    /// When a rule must hold.
    Occasion {
        /// With distributed clocks.
        Dc = "dc",
        /// In free run.
        FreeRun = "free run",
        /// When homing is started.
        StartHoming = "start homing",
        /// While homing runs.
        WhileHoming = "while homing",
        /// When the drive is enabled.
        Enable = "enable",
        /// When a state of the EtherCAT state machine is asked for.
        EsmChange = "esm change",
        /// When process data are mapped or assigned.
        Remap = "remap",
    }

    /// What bytes of an emergency message hold.
    EmcyContent {
        /// The error code, as 603Fh has it.
        ErrorCode = "error code",
        /// The error register, 1001h.
        ErrorRegister = "error register",
        /// The maker's number of the alarm.
        ErrorNumber = "error number",
        /// The maker's auxiliary code.
        AuxiliaryCode = "auxiliary code",
        /// Nothing.
        Reserved = "reserved",
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
