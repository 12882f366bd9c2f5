//! Homing, section 4.4: methods 1, 3, 17 and 35 home where they must, and each error is one.

use drivewright_runtime::AbortCode;
use drivewright_runtime::sim::plant::{PlantConfig, Switches};
use drivewright_runtime::sim::{Config, HomeOffset};

use crate::{GEAR, REVOLUTION, Rig};

/// Set up for a method, not started.
fn rig(method: i64, start: i64) -> Rig {
    let mut rig = Rig::with(Config::default(), PlantConfig { start, ..PlantConfig::default() });
    rig.write(0x6098, 0, method).unwrap();
    rig.write(0x6099, 1, 12_000).unwrap();
    rig.write(0x6099, 2, 600).unwrap();
    rig.write(0x607C, 0, 0).unwrap();
    rig.enable(6);
    assert_eq!(rig.status() & 0x3400, 0x0400, "not started");
    rig
}

/// Homes with a method from a place; gives the count at which home is.
fn home(method: i64, start: i64) -> i64 {
    let mut rig = rig(method, start);
    let status = rig.word(0x1F);
    if method != 35 {
        assert_eq!(status & 0x3400, 0, "in progress");
    }
    rig.until(0x3400, 0x1400);
    assert_eq!(rig.read(0x603F, 0), 0);
    let here = rig.drive.axis().position();
    assert!((rig.read(0x6064, 0) * GEAR - (here - rig.drive.origin())).abs() <= GEAR);
    rig.drive.origin()
}

/// The first index pulse at a place or above it.
fn index_above(place: i64) -> i64 {
    let index = Switches::default().index.unwrap();
    place + (index - place).rem_euclid(REVOLUTION)
}

#[test]
fn method_1_finds_the_index_above_the_negative_limit() {
    let edge = Switches::default().negative_limit.unwrap();
    for start in [0, 5 * REVOLUTION, edge - 1_000] {
        assert_eq!(home(1, start), index_above(edge), "from {start}");
    }
}

#[test]
fn method_3_finds_the_index_below_the_home_switch() {
    let edge = Switches::default().home[0].from;
    for start in [0, edge + 1_000] {
        assert_eq!(home(3, start), index_above(edge) - REVOLUTION, "from {start}");
    }
}

#[test]
fn method_17_finds_the_edge_of_the_negative_limit() {
    let edge = Switches::default().negative_limit.unwrap();
    for start in [0, edge - 1_000] {
        assert_eq!(home(17, start), edge, "from {start}");
    }
}

#[test]
fn method_35_takes_the_place_where_it_stands() {
    assert_eq!(home(35, 12_345), 12_345);
}

#[test]
fn the_offset_is_where_zero_is() {
    for (home_offset, position) in
        [(HomeOffset::ZeroIsHomePlusOffset, -1_000), (HomeOffset::HomeIsOffset, 1_000)]
    {
        let mut config = Config::default();
        config.home_offset = home_offset;
        let mut rig = Rig::with(config, PlantConfig::default());
        rig.write(0x6098, 0, 35).unwrap();
        rig.enable(6);
        rig.word(0x1F);
        rig.until(0x3400, 0x1400);
        assert_eq!(rig.read(0x6064, 0), position, "607Ch is 1000 as the drive ships");
    }
}

#[test]
fn errors_of_the_table_are_homing_errors() {
    let mut none = rig(0, 0);
    assert_eq!(none.word(0x1F) & 0x3400, 0x2400, "no method");
    for method in [15, 33] {
        let mut reserved = rig(method, 0);
        assert_eq!(reserved.word(0x1F) & 0x3400, 0x2400, "method {method} is reserved");
    }
    let mut off = rig(35, 0);
    off.word(0x06);
    assert_eq!(off.word(0x16) & 0x3400, 0x2400, "the servo is not enabled");
    let mut turns = Rig::enabled(3);
    turns.write(0x60FF, 0, 10_000).unwrap();
    turns.write(0x6098, 0, 35).unwrap();
    turns.until(0x0C00, 0x0400);
    turns.write(0x6060, 0, 6).unwrap();
    turns.run(1);
    assert_eq!(turns.word(0x1F) & 0x3000, 0x2000, "the axis moves");
}

#[test]
fn a_run_ends_with_bit_4() {
    let mut rig = rig(1, 0);
    rig.word(0x1F);
    rig.run(100);
    rig.word(0x0F);
    rig.until(0x3400, 0x0400);
    assert!(rig.drive.axis().position() > Switches::default().negative_limit.unwrap());
}

#[test]
fn while_homing_runs_method_and_mode_stay() {
    let mut rig = rig(1, 0);
    rig.word(0x1F);
    assert_eq!(rig.write(0x6098, 0, 2), Err(AbortCode::GENERAL), "note 3");
    rig.write(0x6060, 0, 1).unwrap();
    rig.run(1);
    assert_eq!(rig.read(0x6061, 0), 6, "homing runs in this cycle");
    rig.run(3);
    assert_eq!((rig.read(0x603F, 0), rig.read(0x6061, 0)), (0x8800, 1), "oPE ends it; then the mode is free");
}

#[test]
fn homing_that_takes_too_long_is_an_alarm() {
    let switches = Switches { negative_limit: None, ..Switches::default() };
    let axis = PlantConfig { switches, ..PlantConfig::default() };
    let mut rig = Rig::with(Config::default(), axis);
    rig.write(0x6098, 0, 17).unwrap();
    rig.write(0x6099, 1, 1).unwrap();
    rig.enable(6);
    rig.word(0x1F);
    rig.run(61_000);
    assert_eq!(rig.read(0x603F, 0), 0x8400, "oGE");
}
