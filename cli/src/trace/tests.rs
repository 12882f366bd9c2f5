//! A small trace in each of its forms. Expected values are read off the samples.

use drivewright_runtime::cia402::{Mode, Statusword};
use drivewright_runtime::time::Instant;

use super::{BitNames, Kind, Sample, Trace, Unit, Units, csv, json_lines, svg, text};

fn sample(ms: u64, status: u16, position: i64, speed: i64) -> Sample {
    Sample {
        at: Instant::from_micros(ms * 1000),
        position,
        speed,
        force: speed / 10,
        mode: if ms < 3 { Mode::NONE } else { Mode::PROFILE_POSITION },
        status: Statusword(status),
        control: if ms < 2 { 0x0000 } else { 0x000F },
    }
}

/// Half a second: enabled at 3 ms, target reached at 300 ms, a fault at 400 ms.
fn small() -> Trace {
    let units = Units {
        position: Unit::new("user units", 1, 1),
        speed: Unit::new("rpm", 1, 10),
        force: Unit::new("%", 1, 10),
        force_name: "torque",
    };
    let mut trace = Trace::new("Acme <X1> & more".to_owned(), units, BitNames::default());
    for ms in 0..500_u64 {
        let moving = (3..300).contains(&ms);
        let status = match ms {
            0..=2 => 0x0250,
            3..=299 => 0x0237,
            300..=399 => 0x0637,
            _ => 0x0218,
        };
        let position = i64::try_from(ms.clamp(3, 300) - 3).unwrap() * 25;
        trace.push(sample(ms, status, position, if moving { 15_005 } else { 0 }));
    }
    trace.note(Instant::from_micros(3_000), Kind::Step, "move to 7425");
    trace.note(Instant::from_micros(400_000), Kind::Fault, "OF, \"following\" error, <script>");
    trace
}

#[test]
fn a_count_is_shown_in_its_unit() {
    let tenth = Unit::new("rpm", 1, 10);
    assert_eq!(tenth.show(15_005), "1500.5");
    assert_eq!(tenth.show(-3), "-0.3");
    assert_eq!(Unit::new("x", 1, 3).show(2), "0.667");
    assert_eq!(Unit::new("x", 1, 3).show(-2), "-0.667");
    assert_eq!(Unit::new("x", 5, 1).told(i64::MIN), "-46116860184273879040 x");
    assert_eq!(Unit::new("x", 1, 0).show(4), "4", "no division by nothing");
}

#[test]
fn people_see_what_changed() {
    let shown = text(&small());
    let lines: Vec<&str> = shown.lines().collect();
    assert!(lines[0].starts_with(" time  state"), "{shown}");
    assert!(lines[1].contains("user units") && lines[1].contains("rpm") && lines[1].contains('%'));
    // First sample, controlword, enabled, its event, reached, fault, its event.
    assert_eq!(lines.len(), 2 + 7, "{shown}");
    assert!(lines[3].starts_with("  2.0  Switch on disabled") && lines[3].ends_with("6040h = 000Fh"));
    assert!(lines[4].contains("Operation enabled") && lines[4].contains("1500.5"), "{shown}");
    assert_eq!(lines[5], "  3.0  == move to 7425");
    assert!(lines[6].starts_with("300.0  Operation enabled") && lines[6].ends_with("0637h  +target reached"));
    assert!(lines[7].starts_with("400.0  Fault ") && lines[7].contains("-target reached"), "{shown}");
    assert_eq!(lines[8], "400.0  !! OF, \"following\" error, <script>");
    let starts: Vec<Option<usize>> =
        [lines[4], lines[6]].iter().map(|line| line.find("profile position")).collect();
    assert_eq!(starts[0], starts[1], "columns are aligned");
}

#[test]
fn programs_get_every_sample() {
    let shown = csv(&small());
    let lines: Vec<&str> = shown.lines().collect();
    assert_eq!(lines.len(), 1 + 500 + 2);
    assert_eq!(lines[0].split(',').count(), 10);
    assert_eq!(lines[1], "0.0,0,0.0,0.0,Switch on disabled,0,0250h,0000h,,");
    assert!(lines.contains(&"400.0,,,,,,,,fault,\"OF, \"\"following\"\" error, <script>\""), "{shown}");
    let mut formula = small();
    formula.note(Instant::from_micros(600_000), Kind::Note, "=1+1");
    assert!(csv(&formula).ends_with("600.0,,,,,,,,note,'=1+1\n"));
}

#[test]
fn json_lines_are_json() {
    let shown = json_lines(&small());
    let rows: Vec<serde_json::Value> =
        shown.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(rows.len(), 7);
    assert_eq!((&rows[2]["at_us"], &rows[2]["speed"]), (&3000.into(), &15_005.into()));
    assert_eq!((&rows[6]["event"], &rows[6]["at_us"]), (&"fault".into(), &400_000.into()));
}

#[test]
fn the_picture_holds_what_happened_and_no_markup_of_a_profile() {
    let shown = svg(&small());
    for part in ["Acme &lt;X1&gt; &amp; more", "Operation enabled", "profile position", "[rpm]", "time [ms]"]
    {
        assert!(shown.contains(part), "{part}");
    }
    assert!(shown.contains("400.0 ms  OF, &quot;following&quot; error, &lt;script&gt;"));
    assert!(!shown.contains("<script"));
    assert!(
        shown.contains("target reached") && !shown.contains("remote"),
        "only bits that change have a track"
    );
    assert!(shown.len() < 20_000, "{}", shown.len());
    assert!(!shown.contains("NaN") && !shown.contains("inf"));
}

/// A foreign reader: it finds the texts as they are, and refuses a picture with a tag left open.
#[test]
fn the_picture_is_xml() {
    let shown = svg(&small());
    let read = roxmltree::Document::parse(&shown).unwrap();
    let texts: Vec<&str> = read.descendants().filter_map(|node| node.text()).collect();
    assert!(texts.contains(&"Acme <X1> & more"), "{texts:?}");
    assert!(texts.contains(&"400.0 ms  OF, \"following\" error, <script>"), "{texts:?}");
    assert!(roxmltree::Document::parse(&shown.replace("</svg>", "")).is_err());
}

#[test]
fn an_empty_trace_is_no_trouble() {
    let nothing = Trace { samples: Vec::new(), events: Vec::new(), ..small() };
    assert_eq!(text(&nothing).lines().count(), 2);
    assert_eq!(csv(&nothing).lines().count(), 1);
    assert!(json_lines(&nothing).is_empty());
    assert!(svg(&nothing).contains("</svg>") && !svg(&nothing).contains("NaN"));
}

#[test]
fn samples_of_one_moment_are_one() {
    let mut trace = small();
    let last = *trace.samples.last().unwrap();
    trace.push(Sample { position: 1, ..last });
    assert_eq!(trace.samples.len(), 500);
    assert_eq!(trace.samples.last().unwrap().position, 1);
}
