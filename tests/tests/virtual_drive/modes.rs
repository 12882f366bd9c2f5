//! Each mode moves the axis, sections 4.2, 4.3 and 4.5 to 4.8.

use crate::{REVOLUTION, Rig, TURN};

#[test]
fn profile_position_goes_where_it_is_told() {
    let mut rig = Rig::enabled(1);
    rig.write(0x6081, 0, 6_000).unwrap();
    rig.write(0x607A, 0, 5 * TURN).unwrap();
    // Bit 6: the target is absolute, section 4.2.
    assert_eq!(rig.word(0x5F), 0x1237, "taken, and on its way");
    assert_eq!(rig.word(0x4F), 0x0237, "bit 12 follows bit 4");
    let time = rig.until(0x0400, 0x0400);
    assert_eq!(rig.settled(), 5 * TURN);
    // 600 rpm are 10 revolutions a second: 0.5 s, and half of two ramps of 30 ms each.
    assert!((500..650).contains(&time), "{time} ms");
    assert_eq!(rig.read(0x6063, 0), 5 * REVOLUTION);
}

#[test]
fn profile_position_is_relative_without_bit_6_and_queues_one() {
    let mut rig = Rig::enabled(1);
    rig.write(0x6081, 0, 6_000).unwrap();
    rig.write(0x607A, 0, TURN).unwrap();
    for word in [0x1F, 0x0F, 0x1F] {
        rig.word(word);
    }
    assert_eq!(rig.word(0x0F) & 0x1000, 0x1000, "one is approached, one waits: there is no room");
    rig.until(0x1400, 0x0400);
    assert_eq!(rig.settled(), 2 * TURN);
    rig.word(0x3F);
    rig.run(20);
    rig.word(0x0F);
    rig.write(0x607A, 0, -TURN).unwrap();
    rig.word(0x3F);
    rig.word(0x0F);
    rig.until(0x0400, 0x0400);
    assert_eq!(rig.settled(), 2 * TURN, "bit 5: three turns, minus one, at once");
}

#[test]
fn halt_stops_and_goes_on() {
    let mut rig = Rig::enabled(1);
    rig.write(0x6081, 0, 6_000).unwrap();
    rig.write(0x607A, 0, 5 * TURN).unwrap();
    rig.word(0x5F);
    rig.run(100);
    rig.word(0x14F);
    rig.until(0x0400, 0x0400);
    let place = rig.read(0x6064, 0);
    assert!((TURN / 2..2 * TURN).contains(&place), "{place}");
    rig.word(0x4F);
    rig.until(0x0400, 0x0400);
    assert_eq!(rig.settled(), 5 * TURN);
}

#[test]
fn a_software_limit_holds_the_target() {
    let mut rig = Rig::enabled(1);
    rig.write(0x607D, 2, 2 * TURN).unwrap();
    rig.write(0x6081, 0, 6_000).unwrap();
    rig.write(0x607A, 0, 5 * TURN).unwrap();
    rig.word(0x5F);
    rig.word(0x4F);
    assert_eq!(rig.status() & 0x0800, 0x0800, "limiter activation");
    rig.until(0x0400, 0x0400);
    assert_eq!(rig.settled(), 2 * TURN);
}

#[test]
fn profile_velocity_keeps_its_speed() {
    let mut rig = Rig::enabled(3);
    assert_eq!(rig.status(), 0x0E37, "arrived at 0, and bit 11 is speed zero in this mode");
    rig.write(0x60FF, 0, -10_000).unwrap();
    rig.run(1);
    assert_eq!(rig.status() & 0x0400, 0);
    let time = rig.until(0x0C00, 0x0400);
    assert!((40..70).contains(&time), "2,000 rpm in 100 ms, so 1,000 rpm in 50 ms: {time} ms");
    rig.run(50);
    let speed = rig.read(0x606C, 0);
    assert!((-10_050..-9_950).contains(&speed), "{speed}");
    assert_eq!(rig.read(0x606B, 0), -10_000);
    rig.write(0x60FF, 0, 60_000).unwrap();
    rig.run(300);
    assert_eq!(rig.read(0x606B, 0), 30_000, "607Fh and 6080h");
}

#[test]
fn profile_torque_and_cyclic_torque_accelerate() {
    for (mode, status) in [(4, 0x0237), (10, 0x1237)] {
        let mut rig = Rig::enabled(mode);
        assert_eq!(rig.status(), status, "mode {mode}");
        rig.write(0x6071, 0, 100).unwrap();
        rig.run(100);
        assert_eq!((rig.read(0x6074, 0), rig.read(0x6077, 0)), (100, 100));
        assert!(rig.read(0x606C, 0) > 100, "mode {mode}");
    }
}

#[test]
fn cyclic_position_follows_every_target() {
    let mut rig = Rig::enabled(8);
    assert_eq!(rig.status(), 0x1637, "it follows, and is there");
    for step in 1..=500 {
        rig.write(0x607A, 0, step * 20).unwrap();
        rig.run(1);
    }
    assert_eq!(rig.read(0x6062, 0), 10_000);
    assert_eq!(rig.status() & 0x3000, 0x1000);
    rig.until(0x0400, 0x0400);
    assert!((rig.read(0x6064, 0) - 10_000).abs() <= 100, "the window of 6067h");
}

#[test]
fn cyclic_velocity_follows_at_once() {
    let mut rig = Rig::enabled(9);
    rig.write(0x60FF, 0, 3_000).unwrap();
    rig.until(0x1C00, 0x1400);
    assert!((2_400..3_600).contains(&rig.read(0x606C, 0)));
}

#[test]
fn a_mode_that_the_drive_does_not_have_is_not_taken() {
    let mut rig = Rig::new();
    assert!(rig.write(0x6060, 0, 7).is_err());
    rig.write(0x6060, 0, 6).unwrap();
    rig.run(1);
    assert_eq!(rig.read(0x6061, 0), 6);
}

#[test]
fn the_touch_probe_takes_the_place_of_an_index_pulse() {
    let mut rig = Rig::enabled(3);
    // Probe 1 on, at the index pulse, once, at the rising edge: 4.9.1.
    rig.write(0x60B8, 0, 0x15).unwrap();
    rig.write(0x60FF, 0, 600).unwrap();
    rig.run(1);
    assert_eq!(rig.read(0x60B9, 0), 0x41, "on, by the index pulse");
    rig.run(3_000);
    assert_eq!(rig.read(0x60B9, 0), 0xC3, "latched, and toggled once");
    let index = drivewright_runtime::sim::plant::Switches::default().index.unwrap();
    assert_eq!(rig.read(0x60BA, 0), index / crate::GEAR, "the first pulse");
    rig.write(0x60B8, 0, 0).unwrap();
    rig.run(1);
    assert_eq!(rig.read(0x60B9, 0), 0);
}

#[test]
fn the_touch_probe_takes_the_place_of_both_edges_of_its_input() {
    let mut rig = Rig::enabled(3);
    rig.write(0x3002, 3, 41).unwrap();
    rig.write(0x60B8, 0, 0x3300).unwrap();
    rig.write(0x60FF, 0, 600).unwrap();
    rig.run(500);
    rig.drive.set_probe(1, true);
    rig.run(1);
    let place = rig.read(0x6064, 0);
    assert_eq!((rig.read(0x60BC, 0), rig.read(0x60B9, 0)), (place, 0x8300));
    rig.run(100);
    rig.drive.set_probe(1, false);
    rig.run(1);
    assert_eq!((rig.read(0x60BD, 0), rig.read(0x60B9, 0)), (rig.read(0x6064, 0), 0x0700));
}
