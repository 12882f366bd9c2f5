//! What the virtual drive assumes where manuals are silent.

/// Something that a virtual drive does and no manual says.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Assumption {
    /// What it is about.
    pub about: &'static str,
    /// What is assumed.
    pub is: &'static str,
    /// Why.
    pub because: &'static str,
}

/// A table, one assumption a row.
macro_rules! assumptions {
    ($($about:literal, $is:literal, $because:literal;)*) => {
        /// Everything that a virtual drive assumes, of any drive. Where a drive has the object or the table that says
        /// otherwise, that holds.
        pub const ASSUMPTIONS: &[Assumption] =
            &[$(Assumption { about: $about, is: $is, because: $because },)*];
    };
}

assumptions! {
    "default that is not stated", "0, or the value of the range nearest to 0",
        "a cell holds a number; one in the range surprises least";
    "number of entries of a PDO, default not stated", "as many as the table of process data lists",
        "entries that are not counted would not be exchanged";
    "what survives without 1010h", "what is written to 2000h to 5FFFh; of others what takes effect after a power cycle",
        "parameters that a panel shows are usually kept at once; Config::keeps";
    "start-up", "0.1 s, without an answer to SDO", "long enough to be noticed; Config::start_up";
    "statusword bit 5", "0 in switch on disabled and in faults", "the standard leaves it open there";
    "statusword bit 4", "main supply on and torque allowed", "its name in the standard";
    "statusword bit 9", "1 unless the drive is operated at its panel", "its name in the standard";
    "controlword 0Fh in ready to switch on", "no transition", "the table of commands has enable operation for 4 and 16 only";
    "ramp of transitions 5 and 8", "the state is left at standstill", "the drive function ends with the ramp";
    "option codes without an object", "605Ah 2, 605Bh 0, 605Ch 1, 605Dh 1, 605Eh 2", "the usual defaults; Config";
    "option codes that the standard does not know", "as 0", "off is the safest reading";
    "stop that does not come to standstill", "after 5 s the power stage goes off",
        "the state machine must not hang on a load that pulls; Config::stop_time";
    "option 0", "the axis coasts and the state is left at once", "the power stage is off";
    "options 3 and 4", "with the highest torque that the limits allow", "the model of the motor has no voltage";
    "quick-stop ramp without 6085h", "60,000 rpm/s", "steep, and within the torque of a usual servo; Config";
    "counts of the encoder", "131,072 a revolution", "1,966,080 in 6065h is 15 times 131,072; Config, unless 608Fh says it";
    "unit of 6065h without one", "counts of the encoder", "the numbers look like it";
    "6083h and 6084h in a unit of time", "the time for 2,000 rpm", "the only drive with it says so; Config::ramp_speed";
    "6066h, 6068h, 606Eh and 6070h that are missing", "0: at once", "nothing to wait for";
    "process data outside the range of an entry", "taken over; what acts on them cuts them to its limits",
        "process data have no abort";
    "unsupported mode in process data", "6061h stays", "process data have no abort";
    "abort code that the drive does not list", "the nearest that it lists", "a drive answers with what its manual prints";
    "order of checks of a download", "object, sub-index, access, local control, length, process data, range, list, rules",
        "one order is needed; several mistakes at once are rare";
    "download without data", "0607 0010", "neither too long nor too short";
    "remapping outside PreOP", "refused, device state", "the mapping is read in the change to SafeOP";
    "entries while sub-index 0 or the assignment is not 0", "0601 0003 or the nearest listed", "ETG.1000";
    "mapped length", "checked in the change to SafeOP", "the manual of the SDV3-E says so";
    "rules", "a rule that says refused refuses the write; one that names an alarm raises it", "they have no column for it";
    "SDO write to what the RxPDO carries", "refused where the drive lists 0601 0006, otherwise overwritten", "ETG.1000";
    "603Fh", "the code of the alarm that came last", "the standard says last error";
    "1001h", "a bit for the class of each code", "CiA 301";
    "emergency message when the last alarm is cleared", "eight bytes 0", "CiA 301";
    "alarm that a drive has for a physical event", "by code and words of its name", "tables have no column for it";
    "alarm that stands and how it is reset is not stated", "a fault reset clears it", "most are";
    "watchdog", "100 ms", "the default of the EtherCAT slave controller; Config::watchdog";
    "overload", "the square of the torque above rated torque, 10 s at twice the rated torque", "a usual motor; Config";
    "home offset", "zero is home plus offset", "the words of CiA 402; Config::home_offset";
    "limits while homing", "software limits do not hold", "positions mean nothing before home is known";
    "time-out of homing", "60 s", "longer than any way of the virtual axis; Config::homing_time";
    "jump of a target in cyclic synchronous position", "4 times the way at the highest speed in a cycle", "Config::target_jump";
    "parameters of the maker", "no effect but by rules: they change neither units nor what inputs do",
        "manuals of the bus name them and do not describe them";
    "halt", "brakes in every mode while bit 8 is set", "the standard; some manuals call the bit reserved";
    "limit switches", "stop what moves on towards them, in every mode but homing", "what they are for";
    "mode bits of the statusword", "those that the drive's own table lists, where it lists any", "the others are reserved";
    "data that do not come in cyclic synchronous position", "the axis stays at the last target", "the simplest";
    "encoder", "incremental: the position is 0 at power-on and home is unknown", "the simplest";
}
