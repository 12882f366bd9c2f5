//! Prints a lowered drive. Section and key names are literals and numbers; every value goes through [`Ini::key`].

use std::fmt::Display;

use super::Commissioning;
use super::assumed::granularity;
use super::lower::{Keys, List, Section, Sheet, drive_text};
use super::value::{self, Default};
use crate::emit::escape;
use crate::model::{Address, Model, ObjectKind, Type};

/// Lines that end with CR/LF. No value can end its line, so none can open a section.
#[derive(Default)]
struct Ini(String);

impl Ini {
    fn section(&mut self, name: &str) {
        let gap = if self.0.is_empty() { "" } else { "\r\n" };
        self.0.extend([gap, "[", name, "]\r\n"]);
    }

    fn key(&mut self, key: impl Display, value: impl Display) {
        self.0.extend([&key.to_string(), "=", &escape::ini(&value.to_string()), "\r\n"]);
    }

    fn keys(&mut self, keys: &[&str], value: u8) {
        for key in keys {
            self.key(key, value);
        }
    }
}

/// The text of the file; with a commissioning that of a device configuration file.
pub(super) fn sheet(
    model: &Model,
    sheet: &Sheet,
    comments: &[String],
    commissioning: Option<&Commissioning<'_>>,
) -> String {
    let mut ini = Ini::default();
    file_info(model, commissioning, &mut ini);
    device_info(model, sheet, &mut ini);
    if let Some(commissioning) = commissioning {
        device_commissioning(commissioning, &mut ini);
    }
    ini.section("DummyUsage");
    for dummy in 1..=7 {
        ini.key(format_args!("Dummy{dummy:04}"), 0);
    }
    ini.section("Comments");
    ini.key("Lines", comments.len());
    for (n, line) in (1..).zip(comments) {
        ini.key(format_args!("Line{n}"), line);
    }
    for list in List::ALL {
        let members: Vec<&Section> = sheet.objects.iter().filter(|o| List::of(o.index) == list).collect();
        ini.section(list.section());
        ini.key("SupportedObjects", members.len());
        for (n, object) in (1..).zip(&members) {
            ini.key(format_args!("{n}"), format_args!("0x{:04X}", object.index));
        }
        for object in members {
            section(object, commissioning, &mut ini);
        }
    }
    ini.0
}

fn file_info(model: &Model, commissioning: Option<&Commissioning<'_>>, ini: &mut Ini) {
    let drive = &model.drive;
    let about = format!("Generated from the manual of {} {}, not by its maker", drive.vendor, drive.name);
    ini.section("FileInfo");
    let sheet = format!("{}.eds", drive.package);
    ini.key("FileName", commissioning.map_or(sheet.as_str(), |c| c.file));
    ini.key("FileVersion", drive.eds_version);
    ini.key("FileRevision", drive.eds_revision);
    ini.key("EDSVersion", "4.0");
    ini.key("Description", drive_text(&about));
    for (time, date, by) in [
        ("CreationTime", "CreationDate", "CreatedBy"),
        ("ModificationTime", "ModificationDate", "ModifiedBy"),
    ] {
        ini.key(time, "12:00AM");
        ini.key(date, american(&drive.date));
        ini.key(by, "drivewright");
    }
    if commissioning.is_some() {
        ini.key("LastEDS", sheet);
    }
}

/// `2026-11-24` as `11-24-2026`.
fn american(date: &str) -> String {
    match date.split('-').collect::<Vec<_>>().as_slice() {
        [year, month, day] => format!("{month}-{day}-{year}"),
        _ => date.to_owned(),
    }
}

fn device_info(model: &Model, sheet: &Sheet, ini: &mut Ini) {
    let [vendor, product, revision, _] = model.identity();
    let pdos =
        |first: u16| sheet.objects.iter().filter(|o| (first..first + 0x200).contains(&o.index)).count();
    ini.section("DeviceInfo");
    ini.key("VendorName", drive_text(&model.drive.vendor));
    ini.key("VendorNumber", format_args!("0x{:X}", vendor.unwrap_or(0)));
    ini.key("ProductName", drive_text(&model.drive.name));
    ini.key("ProductNumber", format_args!("0x{:X}", product.unwrap_or(0)));
    ini.key("RevisionNumber", format_args!("0x{:X}", revision.unwrap_or(0)));
    ini.key("OrderCode", "");
    for rate in [10, 20, 50, 125, 250, 500, 800, 1000] {
        ini.key(format_args!("BaudRate_{rate}"), 0);
    }
    ini.keys(&["SimpleBootUpMaster", "SimpleBootUpSlave"], 0);
    ini.key("Granularity", granularity(model));
    ini.keys(&["DynamicChannelsSupported", "GroupMessaging"], 0);
    ini.key("NrOfRXPDO", pdos(0x1600));
    ini.key("NrOfTXPDO", pdos(0x1A00));
    ini.keys(&["LSS_Supported"], 0);
}

/// The section has one `m` in CiA 306.
fn device_commissioning(commissioning: &Commissioning<'_>, ini: &mut Ini) {
    ini.section("DeviceComissioning");
    ini.key("NodeID", commissioning.node_id);
    ini.key("NodeName", commissioning.name);
    if let Some(rate) = commissioning.bit_rate {
        ini.key("Baudrate", rate);
    }
    ini.key("NetNumber", commissioning.network.unwrap_or(0));
    ini.key("NetworkName", "");
    ini.key("CANopenManager", 0);
    if let Some(serial) = commissioning.serial {
        ini.key("LSS_SerialNumber", format_args!("0x{serial:X}"));
    }
}

fn section(object: &Section, commissioning: Option<&Commissioning<'_>>, ini: &mut Ini) {
    let name = format!("{:04X}", object.index);
    let code = match object.kind {
        ObjectKind::Var => {
            for entry in &object.entries {
                ini.section(&name);
                keys(object, entry, commissioning, ini);
            }
            return;
        }
        ObjectKind::Array => "0x8",
        ObjectKind::Record => "0x9",
    };
    ini.section(&name);
    ini.key("ParameterName", &object.name);
    ini.key("ObjectType", code);
    ini.key("SubNumber", object.entries.len());
    for entry in &object.entries {
        ini.section(&format!("{name}sub{:X}", entry.sub));
        keys(object, entry, commissioning, ini);
    }
}

fn keys(object: &Section, entry: &Keys, commissioning: Option<&Commissioning<'_>>, ini: &mut Ini) {
    let member = object.kind != ObjectKind::Var;
    ini.key("ParameterName", if member { &entry.name } else { &object.name });
    ini.key("ObjectType", if entry.ty == Type::Domain { "0x2" } else { "0x7" });
    ini.key("DataType", format_args!("0x{:04X}", entry.ty.cia301_code()));
    ini.key("AccessType", entry.access.word());
    for (key, limit) in [("LowLimit", entry.range.low), ("HighLimit", entry.range.high)] {
        if let Some(limit) = limit {
            ini.key(key, limit);
        }
    }
    // zencan-eds takes the count of a record for hexadecimal, so it must look like that.
    let hex = (member && entry.sub == 0) || is_code(object.index, entry.ty);
    ini.key("DefaultValue", entry.default.map_or_else(String::new, |d| value::print(d, hex)));
    let chosen = commissioning.and_then(|c| c.values.get(&Address::new(object.index, entry.sub)));
    if let Some(value) = chosen {
        ini.key("ParameterValue", value::print(Default::Int(*value), hex));
    }
    if let Some(mapped) = entry.mapped {
        ini.key("PDOMapping", u8::from(mapped));
    }
}

/// Unsigned values of the communication area are identities, COB-IDs and mappings, which people read in hexadecimal.
fn is_code(index: u16, ty: Type) -> bool {
    (0x1000..0x2000).contains(&index) && matches!(ty, Type::Int { signed: false, .. })
}
