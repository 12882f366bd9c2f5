//! Entries that the drive uses every cycle, looked up once.

use crate::address::Address;

use super::memory::{Memory, Slot};

/// One line an entry: name, index, sub-index.
macro_rules! slots {
    ($($name:ident = $index:literal, $sub:literal;)*) => {
        /// Where the entries are that the drive uses; [`Slot::NONE`] for those that the model does not have.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Slots {
            $(pub(crate) $name: Slot,)*
        }

        impl Slots {
            pub(crate) fn of(memory: &Memory<'_, '_>) -> Self {
                Self { $($name: memory.slot(Address::new($index, $sub)),)* }
            }
        }
    };
}

slots! {
    error_register = 0x1001, 0;
    error_code = 0x603F, 0;
    controlword = 0x6040, 0;
    statusword = 0x6041, 0;
    quick_stop_option = 0x605A, 0;
    shutdown_option = 0x605B, 0;
    disable_option = 0x605C, 0;
    halt_option = 0x605D, 0;
    fault_option = 0x605E, 0;
    mode = 0x6060, 0;
    mode_display = 0x6061, 0;
    position_demand = 0x6062, 0;
    position_counts = 0x6063, 0;
    position = 0x6064, 0;
    following_window = 0x6065, 0;
    following_time = 0x6066, 0;
    position_window = 0x6067, 0;
    velocity_demand = 0x606B, 0;
    velocity = 0x606C, 0;
    velocity_window = 0x606D, 0;
    velocity_threshold = 0x606F, 0;
    target_torque = 0x6071, 0;
    max_torque = 0x6072, 0;
    torque_demand = 0x6074, 0;
    torque = 0x6077, 0;
    current = 0x6078, 0;
    target_position = 0x607A, 0;
    home_offset = 0x607C, 0;
    min_position = 0x607D, 1;
    max_position = 0x607D, 2;
    max_profile_velocity = 0x607F, 0;
    max_motor_speed = 0x6080, 0;
    profile_velocity = 0x6081, 0;
    acceleration = 0x6083, 0;
    deceleration = 0x6084, 0;
    quick_stop_deceleration = 0x6085, 0;
    torque_slope = 0x6087, 0;
    encoder_increments = 0x608F, 1;
    encoder_revolutions = 0x608F, 2;
    gear_motor = 0x6091, 1;
    gear_shaft = 0x6091, 2;
    feed = 0x6092, 1;
    feed_revolutions = 0x6092, 2;
    factor_numerator = 0x6093, 1;
    factor_divisor = 0x6093, 2;
    homing_method = 0x6098, 0;
    homing_fast = 0x6099, 1;
    homing_slow = 0x6099, 2;
    homing_acceleration = 0x609A, 0;
    position_offset = 0x60B0, 0;
    velocity_offset = 0x60B1, 0;
    torque_offset = 0x60B2, 0;
    probe_function = 0x60B8, 0;
    probe_status = 0x60B9, 0;
    probe_1_rising = 0x60BA, 0;
    probe_1_falling = 0x60BB, 0;
    probe_2_rising = 0x60BC, 0;
    probe_2_falling = 0x60BD, 0;
    max_torque_positive = 0x60E0, 0;
    max_torque_negative = 0x60E1, 0;
    following_error = 0x60F4, 0;
    position_demand_counts = 0x60FC, 0;
    digital_inputs = 0x60FD, 0;
    target_velocity = 0x60FF, 0;
}

impl Slots {
    /// Words and targets: what a master sends every cycle and no unit depends on.
    pub(crate) const fn set_points(&self) -> [Slot; 8] {
        [
            self.controlword,
            self.mode,
            self.target_position,
            self.target_velocity,
            self.target_torque,
            self.velocity_offset,
            self.torque_offset,
            self.probe_function,
        ]
    }
}
