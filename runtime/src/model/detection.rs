//! How an alarm shows on EtherCAT.

crate::word::words! {
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
}
