//! Which values make an axis move, stop or refuse to: they come first in every report.

/// Groups of objects of CiA 402, by the index of the first axis.
const OBJECTS: &[(&str, &[(u16, u16)])] = &[
    ("option code", &[(0x6007, 0x6007), (0x605A, 0x605E), (0x60F2, 0x60F2)]),
    ("controlword", &[(0x6040, 0x6040)]),
    ("mode", &[(0x6060, 0x6061), (0x6502, 0x6502)]),
    ("following error", &[(0x6065, 0x6066)]),
    ("target", &[(0x6071, 0x6071), (0x607A, 0x607A), (0x60B0, 0x60B2), (0x60C1, 0x60C1), (0x60FF, 0x60FF)]),
    (
        "limit",
        &[
            (0x6072, 0x6073),
            (0x607B, 0x607B),
            (0x607D, 0x607D),
            (0x607F, 0x6080),
            (0x60C5, 0x60C6),
            (0x60E0, 0x60E1),
        ],
    ),
    ("polarity", &[(0x607E, 0x607E)]),
    ("gear", &[(0x608F, 0x6097), (0x60E6, 0x60ED)]),
    ("homing", &[(0x607C, 0x607C), (0x6098, 0x609A), (0x60E3, 0x60E3)]),
    ("profile", &[(0x6081, 0x6088), (0x60A3, 0x60A4), (0x60C0, 0x60C0), (0x60C2, 0x60C4)]),
    ("output", &[(0x60FE, 0x60FE)]),
];

/// What the object is for an axis. Each further axis of a drive repeats the objects of the first 800h higher.
pub(super) fn object(index: u16) -> Option<&'static str> {
    let first = match index {
        0x6000..=0x9FFF => 0x6000 + (index - 0x6000) % 0x800,
        _ => return None,
    };
    let holds = |ranges: &[(u16, u16)]| ranges.iter().any(|(low, high)| (*low..=*high).contains(&first));
    OBJECTS.iter().find(|(_, ranges)| holds(ranges)).map(|(group, _)| *group)
}

/// What every row of a table is for an axis.
pub(super) fn table(key: &str) -> Option<&'static str> {
    match key {
        "homing" => Some("homing"),
        "modes" => Some("mode"),
        "states" | "commands" => Some("state machine"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_of_every_axis() {
        assert_eq!(object(0x605A), Some("option code"));
        assert_eq!(object(0x685A), Some("option code"), "second axis");
        assert_eq!(object(0x6083), Some("profile"));
        assert_eq!(object(0x6041), None);
        assert_eq!(object(0x1018), None);
        assert_eq!(object(0xA05A), None);
    }
}
