//! The drive as a zencan device config, which knows neither units nor limits nor named values.

use std::fmt::Write;

use crate::synthetic::{Drive, Entry, Object};

const HEAD: &str = "device_name = \"S1\"\n[identity]\nvendor_id = 1\nproduct_code = 1\nrevision_number = 1\n";

/// The device config of `drive`.
pub fn write(drive: &Drive) -> String {
    let mut text = String::from(HEAD);
    drive.objects.iter().for_each(|o| object(&mut text, o));
    text
}

fn object(text: &mut String, object: &Object) {
    let Object { index, name, entries } = object;
    let _ = write!(text, "[[objects]]\nindex = 0x{index:X}\nparameter_name = \"{name}\"\n");
    match entries.as_slice() {
        [only] => {
            text.push_str("object_type = \"var\"\n");
            keys(text, only);
        }
        [_, members @ ..] => {
            text.push_str("object_type = \"record\"\n");
            for member in members {
                let _ = write!(
                    text,
                    "[[objects.subs]]\nsub_index = {}\nparameter_name = \"{}\"\n",
                    member.sub, member.name
                );
                keys(text, member);
            }
        }
        [] => {}
    }
}

fn keys(text: &mut String, entry: &Entry) {
    let sign = if entry.ty.signed { "int" } else { "uint" };
    let (access, pdo) = if entry.writable { ("rw", "rpdo") } else { ("ro", "tpdo") };
    let pdo = if entry.mapped { pdo } else { "none" };
    let first = entry.range.map_or(0, |[_, _, first]| first);
    let _ = write!(
        text,
        "data_type = \"{sign}{}\"\naccess_type = \"{access}\"\npdo_mapping = \"{pdo}\"\ndefault_value = {first}\n",
        entry.ty.bits
    );
}
