//! The drive as a CMSIS-SVD: each entry a register of its width with one field, named values as enumerated values.

use std::fmt::Write;

use crate::synthetic::{Drive, Entry, Table};

/// The SVD of `drive`.
pub fn write(drive: &Drive) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<device schemaVersion=\"1.3\">\n<name>S1</name><version>1.0</version><description>S1</description>\n<addressUnitBits>8</addressUnitBits><width>32</width><size>32</size><access>read-write</access><resetValue>0</resetValue><resetMask>0xFFFFFFFF</resetMask>\n<peripherals><peripheral><name>OD</name><description>Object dictionary</description><baseAddress>0x40000000</baseAddress><registers>\n",
    );
    let mut place = 0;
    for object in &drive.objects {
        for entry in &object.entries {
            register(&mut text, object.index, place, entry, &drive.tables);
            place += 4;
        }
    }
    text + "</registers></peripheral></peripherals></device>\n"
}

fn register(text: &mut String, index: u16, place: u32, entry: &Entry, tables: &[Table]) {
    let (sub, bits) = (entry.sub, entry.ty.bits);
    let access = if entry.writable { "read-write" } else { "read-only" };
    let words = entry.text.as_deref().unwrap_or(&entry.name);
    let _ = write!(
        text,
        "<register><name>R{index:04X}_{sub:02X}</name><description>{words}</description><addressOffset>0x{place:X}</addressOffset><size>{bits}</size><access>{access}</access><fields><field><name>VALUE</name><description>{}</description><bitOffset>0</bitOffset><bitWidth>{bits}</bitWidth>",
        entry.name
    );
    if let Some(table) = entry.table.and_then(|n| tables.get(n)) {
        text.push_str("<enumeratedValues>");
        for (value, label) in table.labels.iter().enumerate() {
            let name = label.replace(' ', "_");
            let _ = write!(
                text,
                "<enumeratedValue><name>{name}</name><description>{label}</description><value>{value}</value></enumeratedValue>"
            );
        }
        text.push_str("</enumeratedValues>");
    }
    text.push_str("</field></fields></register>\n");
}
