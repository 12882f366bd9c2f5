//! One identity in every generated file: 1018h of the model, of the EDS, of the ESI, and what their heads and the SII say.
//!
//! The files are those of `generated/`, read without drivewright.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "tests")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use drivewright_tests::cases::folders;
use drivewright_tests::esi::with_active_pdos;
use ethercat_esi::EtherCatInfo;

/// Vendor, product, revision.
type Identity = [u64; 3];

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Every folder of `generated/`.
fn packages() -> Vec<PathBuf> {
    let found = folders(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated"));
    assert!(!found.is_empty(), "nothing is generated");
    found
}

/// The only file in a folder of a package, if there is one.
fn only(package: &Path, folder: &str) -> Option<String> {
    let folder = package.join(folder);
    let files = if folder.is_dir() { drivewright_tests::cases::entries(&folder) } else { Vec::new() };
    assert!(files.len() <= 1, "{}: several files", folder.display());
    files.first().map(|file| read(file))
}

fn number(text: &str) -> u64 {
    let text = text.trim();
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("#x"));
    match digits {
        Some(hex) => u64::from_str_radix(hex, 16).expect("a number"),
        None => text.parse().expect("a number"),
    }
}

fn of_model(text: &str) -> Identity {
    let model: serde_json::Value = serde_json::from_str(text).expect("JSON");
    ["vendor_id", "product_code", "revision"].map(|key| model["identity"][key].as_u64().expect("a number"))
}

/// The keys of the sections of an INI file.
fn sections(text: &str) -> BTreeMap<&str, BTreeMap<&str, &str>> {
    let mut found: BTreeMap<&str, BTreeMap<&str, &str>> = BTreeMap::new();
    let mut section = "";
    for line in text.lines() {
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            section = name;
        } else if let Some((key, value)) = line.split_once('=') {
            found.entry(section).or_default().insert(key, value);
        }
    }
    found
}

/// The head of an EDS, and its object 1018h.
fn of_eds(text: &str) -> [Identity; 2] {
    let found = sections(text);
    let key = |section: &str, key: &str| number(found[section][key]);
    [
        ["VendorNumber", "ProductNumber", "RevisionNumber"].map(|name| key("DeviceInfo", name)),
        ["1018sub1", "1018sub2", "1018sub3"].map(|name| key(name, "DefaultValue")),
    ]
}

/// The head of an ESI as ethercat-esi reads it, and the bytes of its object 1018h.
fn of_esi(text: &str) -> [Identity; 2] {
    let info = EtherCatInfo::from_xml_str(&with_active_pdos(text)).expect("an ESI");
    let device = &info.description.devices[0];
    let (_, object) = text.split_once("<Index>#x1018</Index>").expect("1018h");
    let (object, _) = object.split_once("</Object>").expect("its end");
    let defaults: Vec<u64> = object
        .split("<DefaultData>")
        .skip(1)
        .map(|rest| little_endian(rest.split('<').next().unwrap_or_default()))
        .collect();
    // Sub-index 0 says how many there are.
    let own = [defaults[1], defaults[2], defaults[3]];
    [[info.vendor.id, device.product_code, device.revision_no].map(u64::from), own]
}

/// Words 8 to 15 of an SII: vendor, product, revision, serial number.
fn of_sii(image: &[u8]) -> [u64; 4] {
    [16, 20, 24, 28].map(|at| {
        let bytes = image.get(at..at + 4).expect("four bytes of the image");
        u64::from(u32::from_le_bytes(bytes.try_into().expect("four")))
    })
}

/// The image of a package, if there is one.
fn image(package: &Path) -> Option<Vec<u8>> {
    let folder = package.join("sii");
    let files = if folder.is_dir() { drivewright_tests::cases::entries(&folder) } else { Vec::new() };
    let mut images = files.iter().filter(|file| file.extension().is_some_and(|e| e == "bin"));
    let found = images.next().map(|file| std::fs::read(file).expect("an image"));
    assert!(images.next().is_none(), "{}: several images", folder.display());
    found
}

fn little_endian(digits: &str) -> u64 {
    let byte = |at: usize| u64::from_str_radix(&digits[at..at + 2], 16).expect("a byte");
    (0..digits.len()).step_by(2).rev().fold(0, |sum, at| sum << 8 | byte(at))
}

/// Every identity of a package, by the place that says it.
fn identities(package: &Path) -> Vec<(&'static str, Identity)> {
    let mut found = vec![("model.json", of_model(&read(&package.join("model.json"))))];
    if let Some(eds) = only(package, "eds") {
        let [head, own] = of_eds(&eds);
        found.extend([("head of the EDS", head), ("1018h of the EDS", own)]);
    }
    if let Some(esi) = only(package, "esi") {
        let [head, own] = of_esi(&esi);
        found.extend([("head of the ESI", head), ("1018h of the ESI", own)]);
    }
    if let Some(image) = image(package) {
        let [vendor, product, revision, _] = of_sii(&image);
        found.push(("SII", [vendor, product, revision]));
    }
    found
}

#[test]
fn one_identity_in_every_file() {
    for package in packages() {
        let found = identities(&package);
        assert!(found.len() >= 3, "{}: too few files", package.display());
        for (place, identity) in &found {
            assert_eq!(identity, &found[0].1, "{}: {place}", package.display());
        }
    }
}

/// Only the objects and the SII have a serial number; a drive without the object has 0 there.
#[test]
fn one_serial_number() {
    for package in packages() {
        let Some(image) = image(&package) else { continue };
        let eds = only(&package, "eds").expect("an EDS");
        let own = sections(&eds).get("1018sub4").and_then(|keys| keys.get("DefaultValue").copied());
        let own = own.filter(|text| !text.is_empty()).map_or(0, number);
        assert_eq!(of_sii(&image)[3], own, "{}", package.display());
    }
}

/// A reading that is the same for every file says nothing.
#[test]
fn another_identity_is_seen() {
    let package = &packages()[0];
    let [eds, esi] = ["eds", "esi"].map(|folder| only(package, folder).expect("a file"));
    let [vendor, product, revision] = of_model(&read(&package.join("model.json")));
    let right = [[vendor, product, revision]; 2];
    assert_eq!((of_eds(&eds), of_esi(&esi)), (right, right));
    let changed = |text: &str, from: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(
            from,
            &format!("{}{}", &from[..from.len() - 1], if from.ends_with('1') { '2' } else { '1' }),
            1,
        )
    };
    for key in ["VendorNumber=", "ProductNumber=", "RevisionNumber="] {
        let line = eds.lines().find(|line| line.starts_with(key)).expect("the key");
        assert_ne!(of_eds(&changed(&eds, line)), right, "{key}");
    }
    for (start, digits) in [("<Id>#x", 8), ("ProductCode=\"#x", 8), ("RevisionNo=\"#x", 8)] {
        let at = esi.find(start).expect("the number") + start.len();
        assert_ne!(of_esi(&changed(&esi, &esi[..at + digits])), right, "{start}");
    }
}

#[test]
fn another_identity_of_objects_and_of_the_image_is_seen() {
    let package = &packages()[0];
    let eds = only(package, "eds").expect("a file");
    let right = of_eds(&eds);
    for sub in ["1018sub1", "1018sub2", "1018sub3"] {
        let at = eds.find(&format!("[{sub}]")).expect("the section");
        let value = at + eds[at..].find("DefaultValue=").expect("the default");
        let end = value + eds[value..].find('\r').expect("the end of the line");
        let digit = if eds[..end].ends_with('1') { "2" } else { "1" };
        assert_ne!(of_eds(&format!("{}{digit}{}", &eds[..end - 1], &eds[end..])), right, "{sub}");
    }
    let model = read(&package.join("model.json"));
    for number in of_model(&model) {
        let from = format!(": {number}");
        let identity = model.find("\"identity\"").expect("the identity");
        let at = identity + model[identity..].find(&from).expect("the number") + from.len();
        let digit = if from.ends_with('1') { "2" } else { "1" };
        assert_ne!(of_model(&format!("{}{digit}{}", &model[..at - 1], &model[at..])), of_model(&model));
    }
    let image = image(package).expect("an image");
    for at in 16..32 {
        let mut changed = image.clone();
        changed[at] ^= 1;
        assert_ne!(of_sii(&changed), of_sii(&image), "byte {at}");
    }
}
