//! Option codes: every number of each object.

use drivewright_runtime::cia402::{Reaction, StopOption};

use super::table::rows;

/// Object, code, how the axis stops, whether the state stays. Standard; what has no row is the maker's or reserved.
const OPTIONS: &str = "
    605A | 0 | Coast         | no
    605A | 1 | SlowDownRamp  | no
    605A | 2 | QuickStopRamp | no
    605A | 3 | CurrentLimit  | no
    605A | 4 | VoltageLimit  | no
    605A | 5 | SlowDownRamp  | yes
    605A | 6 | QuickStopRamp | yes
    605A | 7 | CurrentLimit  | yes
    605A | 8 | VoltageLimit  | yes
    605B | 0 | Coast         | no
    605B | 1 | SlowDownRamp  | no
    605C | 0 | Coast         | no
    605C | 1 | SlowDownRamp  | no
    605D | 1 | SlowDownRamp  | yes
    605D | 2 | QuickStopRamp | yes
    605D | 3 | CurrentLimit  | yes
    605D | 4 | VoltageLimit  | yes
    605E | 0 | Coast         | no
    605E | 1 | SlowDownRamp  | no
    605E | 2 | QuickStopRamp | no
    605E | 3 | CurrentLimit  | no
    605E | 4 | VoltageLimit  | no
";

type Read = fn(i16) -> Option<StopOption>;

const OBJECTS: [(&str, Read); 5] = [
    ("605A", StopOption::quick_stop),
    ("605B", StopOption::disable),
    ("605C", StopOption::disable),
    ("605D", StopOption::halt),
    ("605E", StopOption::fault),
];

fn reaction(name: &str) -> Reaction {
    match name {
        "Coast" => Reaction::Coast,
        "SlowDownRamp" => Reaction::SlowDownRamp,
        "QuickStopRamp" => Reaction::QuickStopRamp,
        "CurrentLimit" => Reaction::CurrentLimit,
        "VoltageLimit" => Reaction::VoltageLimit,
        other => panic!("{other} is no reaction"),
    }
}

#[test]
fn every_code_of_every_object_is_that_of_its_row() {
    let table = rows::<4>(OPTIONS);
    for (object, read) in OBJECTS {
        for code in i16::MIN..=i16::MAX {
            let row = table.iter().find(|row| row[0] == object && row[1].parse() == Ok(code));
            let wanted = row.map(|row| StopOption { reaction: reaction(row[2]), stays: row[3] == "yes" });
            assert_eq!(read(code), wanted, "{object}h = {code}");
        }
    }
}
