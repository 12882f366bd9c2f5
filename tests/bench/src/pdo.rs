//! Process data of a generated layout beside the same bytes written by hand.

use std::hint::black_box;
use std::time::Instant;

use savch_sdv3_e::bits::{Controlword, Statusword};
use savch_sdv3_e::enums::ModeOfOperation;
use savch_sdv3_e::pdo::{Rx1, Tx1};

/// Frames of one round, and rounds: the fastest round counts, since nothing makes a round too fast.
const FRAMES: u32 = 2_000_000;
const ROUNDS: usize = 9;

/// Time of a cycle (pack a command, unpack an answer) by its layout, over that by hand.
pub fn ratio() -> f64 {
    let (mut layout, mut hand) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..ROUNDS {
        layout = layout.min(time(by_layout));
        hand = hand.min(time(by_hand));
    }
    layout / hand
}

fn time(cycle: impl Fn(i32, &[u8; 13]) -> ([u8; 13], i32)) -> f64 {
    let mut answer = [0; 13];
    let start = Instant::now();
    for n in 0..FRAMES as i32 {
        let (command, position) = cycle(black_box(n), black_box(&answer));
        answer = black_box(command);
        black_box(position);
    }
    start.elapsed().as_secs_f64()
}

fn by_layout(n: i32, answer: &[u8; 13]) -> ([u8; 13], i32) {
    let command = Rx1 {
        control_word: Controlword(0x000F),
        target_position: n,
        target_velocity: n + 1,
        target_torque: 7,
        modes_of_operation: ModeOfOperation(8),
    };
    let answer = Tx1::unpack(answer);
    let Statusword(status) = answer.status_word;
    let sum = i32::from(status)
        + i32::from(answer.current_actual_value)
        + i32::from(answer.modes_of_operation_display.0);
    (
        command.pack(),
        answer.position_actual_value.wrapping_add(answer.velocity_actual_value).wrapping_add(sum),
    )
}

fn by_hand(n: i32, answer: &[u8; 13]) -> ([u8; 13], i32) {
    let mut out = [0; 13];
    out[0..2].copy_from_slice(&0x000F_u16.to_le_bytes());
    out[2..6].copy_from_slice(&n.to_le_bytes());
    out[6..10].copy_from_slice(&(n + 1).to_le_bytes());
    out[10..12].copy_from_slice(&7_i16.to_le_bytes());
    out[12] = 8;
    let status = u16::from_le_bytes([answer[0], answer[1]]);
    let position = i32::from_le_bytes([answer[2], answer[3], answer[4], answer[5]]);
    let velocity = i32::from_le_bytes([answer[6], answer[7], answer[8], answer[9]]);
    let current = i16::from_le_bytes([answer[10], answer[11]]);
    let mode = answer[12] as i8;
    (
        out,
        position
            .wrapping_add(velocity)
            .wrapping_add(i32::from(status) + i32::from(current) + i32::from(mode)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two that do not do the same are not compared.
    #[test]
    fn both_give_the_same_bytes() {
        let answer = [0x37, 0x02, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 8];
        for n in [0, -1, 70_000] {
            assert_eq!(by_layout(n, &answer), by_hand(n, &answer));
        }
    }
}
