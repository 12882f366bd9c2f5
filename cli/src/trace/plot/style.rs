//! Colours and fonts: a row a class, with what it is on light and on dark. Paper is light.

use std::fmt::Write;

use drivewright_runtime::cia402::State;

const FONTS: &str = "\
text { font: 12px system-ui, 'Segoe UI', Helvetica, Arial, sans-serif; }
.title { font-size: 16px; font-weight: 600; }
.label { font-weight: 600; }
.small { font-size: 10px; }
.number { font-size: 11px; font-weight: 600; }
.end { text-anchor: end; }
.mid { text-anchor: middle; }
path { fill: none; stroke-linejoin: round; }
.position, .speed, .force { stroke-width: 1.6; }
.bit { stroke-width: 1.2; }
.line { stroke-width: 1; stroke-dasharray: 3 3; opacity: 0.75; }
circle { stroke: none; }
";

/// Class, property, colour on light, colour on dark. Text on a coloured band has its contrast in both.
const COLOURS: &[(&str, &str, &str, &str)] = &[
    (".page", "fill", "#ffffff", "#0d1117"),
    ("text", "fill", "#1f2328", "#e6edf3"),
    (".tick", "fill", "#4b535c", "#b1bac4"),
    (".number", "fill", "#ffffff", "#0d1117"),
    (".grid", "stroke", "#e2e6ea", "#262c34"),
    (".zero", "stroke", "#a8b1ba", "#586069"),
    (".position", "stroke", "#0757b8", "#58a6ff"),
    (".speed", "stroke", "#176f2c", "#4cc35f"),
    (".force", "stroke", "#a33c00", "#f0883e"),
    (".bit", "stroke", "#57606a", "#9aa4af"),
    (".set", "fill", "#cfd7df", "#39424d"),
    (".mode", "fill", "#dde7f5", "#22344d"),
    (".band, .small", "fill", "#10151a", "#f0f6fc"),
    (".mark-step", "fill", "#57606a", "#9aa4af"),
    (".mark-fault", "fill", "#c01c28", "#ff7b72"),
    (".mark-reset", "fill", "#0757b8", "#58a6ff"),
    (".mark-homed", "fill", "#176f2c", "#4cc35f"),
    (".mark-note", "fill", "#8250df", "#bc8cff"),
    (".line.mark-step", "stroke", "#57606a", "#9aa4af"),
    (".line.mark-fault", "stroke", "#c01c28", "#ff7b72"),
    (".line.mark-reset", "stroke", "#0757b8", "#58a6ff"),
    (".line.mark-homed", "stroke", "#176f2c", "#4cc35f"),
    (".line.mark-note", "stroke", "#8250df", "#bc8cff"),
    (".not-ready", "fill", "#eaeef2", "#21262d"),
    (".disabled", "fill", "#d3d9df", "#30363d"),
    (".ready", "fill", "#bfdcf7", "#163a5f"),
    (".on", "fill", "#8fc3f2", "#1f548a"),
    (".enabled", "fill", "#94dfa5", "#1c5c2e"),
    (".quick", "fill", "#ffd970", "#6b5200"),
    (".reaction", "fill", "#ffb77c", "#7a3d06"),
    (".fault", "fill", "#ff9d99", "#8b1f22"),
    (".unknown", "fill", "#e0c3f5", "#4d2a6b"),
];

/// The class of a state.
pub(super) fn state_class(state: Option<State>) -> &'static str {
    match state {
        Some(State::NotReadyToSwitchOn) => "not-ready",
        Some(State::SwitchOnDisabled) => "disabled",
        Some(State::ReadyToSwitchOn) => "ready",
        Some(State::SwitchedOn) => "on",
        Some(State::OperationEnabled) => "enabled",
        Some(State::QuickStopActive) => "quick",
        Some(State::FaultReactionActive) => "reaction",
        Some(State::Fault) => "fault",
        _ => "unknown",
    }
}

/// The style sheet. Dark is asked for by a screen only: a printer gets what is on light.
pub(super) fn sheet() -> String {
    let mut out = FONTS.to_owned();
    let rule = |out: &mut String, row: &(&str, &str, &str, &str), colour: &str| {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "{} {{ {}: {colour}; }}", row.0, row.1);
    };
    for row in COLOURS {
        rule(&mut out, row, row.2);
    }
    out.push_str("@media screen and (prefers-color-scheme: dark) {\n");
    for row in COLOURS {
        rule(&mut out, row, row.3);
    }
    out.push_str("}\n");
    out
}
