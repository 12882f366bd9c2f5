//! The row `axis`: which drive, which node.

use super::{Configuration, code, profile_code};
use crate::diag::{Diagnostic, Sink};
use crate::emit::escape;
use crate::model::Model;
use crate::rows::ConfigurationRows;
use crate::rows::tables::AxisRow;
use crate::source::{FileId, Sp, Span};

/// Bit rates of CiA 301, in kbit/s.
const BIT_RATES: [u16; 8] = [10, 20, 50, 125, 250, 500, 800, 1000];
/// Longest node name: behind `NodeName=`, a line has the 255 characters that CiA 306 allows.
const LONGEST: usize = 246;

/// The configuration of the one axis, without what is written.
pub(super) fn check(
    rows: &ConfigurationRows,
    file: FileId,
    model: &Model,
    sink: &mut Sink,
) -> Option<Configuration> {
    let axis = one(rows, file, sink)?;
    if axis.format.value != 1 {
        let text = format!("the configuration has format {}", axis.format.value);
        sink.push(
            Diagnostic::new(profile_code::FORMAT_VERSION, axis.format.span, text)
                .why("this version knows format 1 and would misread another")
                .help("use the drivewright version that the configuration was written for"),
        );
        return None;
    }
    drive(axis, model, sink);
    node_id(axis.node_id, sink);
    axis.baudrate.iter().for_each(|rate| bit_rate(*rate, model, sink));
    axis.name.iter().for_each(|name| node_name(name.as_ref().map(|name| name.0.as_str()), sink));
    Some(Configuration {
        node_id: axis.node_id.value,
        name: axis.name.as_ref().map(|name| name.value.0.clone()),
        bit_rate: axis.baudrate.map(|rate| rate.value),
        network: axis.network.map(|network| network.value),
        serial: axis.serial.map(|serial| serial.value),
        writes: Vec::new(),
    })
}

fn one<'r>(rows: &'r ConfigurationRows, file: FileId, sink: &mut Sink) -> Option<&'r AxisRow> {
    const WHY: &str = "a configuration is what one drive is set to";
    let (span, text, help) = match rows.axis.as_slice() {
        [axis] => return Some(axis),
        [_, second, ..] => (second.meta.span(), "a second `axis`", "keep one, or write a file for each"),
        // One with an error in it is reported as such.
        [] if sink.has_errors() => return None,
        [] => (
            Span::whole(file),
            "the configuration has no `axis`",
            "add `axis = { format = 1, drive = \"...\", node_id = 1 }`",
        ),
    };
    sink.push(Diagnostic::new(code::ONE_AXIS, span, text).why(WHY).help(help));
    None
}

fn drive(axis: &AxisRow, model: &Model, sink: &mut Sink) {
    let (named, drive) = (&axis.drive.value.0, &model.drive);
    if *named != drive.id && *named != drive.package {
        let text = format!("the configuration is of `{named}`, and the drive is `{}`", drive.id);
        sink.push(
            Diagnostic::new(code::OTHER_DRIVE, axis.drive.span, text)
                .why("the same object means something else in another drive")
                .help("name the drive that it was written for, or correct `drive`"),
        );
    }
}

fn node_id(id: Sp<u8>, sink: &mut Sink) {
    if !(1..=127).contains(&id.value) {
        sink.push(
            Diagnostic::new(code::NODE_ID, id.span, format!("{} is no node-ID", id.value))
                .why("CANopen has the nodes 1 to 127; 0 is all of them")
                .help("write a number from 1 to 127 that no other node of the bus has"),
        );
    }
}

fn bit_rate(rate: Sp<u16>, model: &Model, sink: &mut Sink) {
    let (why, help) = if !model.on_can() {
        ("the drive is on EtherCAT, which has one bit rate", "remove `baudrate`".to_owned())
    } else if BIT_RATES.contains(&rate.value) {
        return;
    } else {
        ("CiA 301 knows others only, and a DCF has no key for it", format!("write one of {BIT_RATES:?}"))
    };
    let text = format!("a bit rate of {} kbit/s", rate.value);
    sink.push(Diagnostic::new(code::BIT_RATE, rate.span, text).why(why).help(help));
}

fn node_name(name: Sp<&str>, sink: &mut Sink) {
    if escape::ini(name.value) != name.value || name.value.len() > LONGEST {
        sink.push(
            Diagnostic::new(code::NODE_NAME, name.span, format!("`{}` is no node name", name.value))
                .why(format!(
                    "a DCF holds one line of at most {LONGEST} characters of ASCII, in which some signs have a meaning of their own"
                ))
                .help("use letters, digits, `-`, `_` and blanks"),
        );
    }
}
