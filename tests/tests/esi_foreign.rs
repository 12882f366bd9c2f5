//! ethercat-esi reads our ESI files. `cargo xtask test` asks the schemas and a Python judge.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "tests")]

use std::path::Path;

use drivewright_codegen::backend::esi::Esi;
use drivewright_codegen::backend::ethercat::{AssignedPdo, Device};
use drivewright_codegen::model::{Address, Direction, Model};
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, emit, load};
use drivewright_tests::cases::golden_cases;
use drivewright_tests::esi::with_active_pdos;
use ethercat_esi::{EtherCatInfo, Pdo};

/// Every EtherCAT drive of the golden cases, and the one whose manual was read.
fn drives() -> Vec<(String, Model)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e");
    let compiled = compile(load::folder(&folder).sources);
    let mut drives = vec![("sdv3-e".to_owned(), compiled.sound().cloned().expect("it is sound"))];
    drives.extend(golden_cases().iter().map(|case| (case.name.clone(), case.model())));
    drives.retain(|(_, model)| Device::of(model).is_some());
    assert!(drives.len() > 4, "only {} drives", drives.len());
    drives
}

/// The file of a drive.
fn xml(model: &Model) -> String {
    let (files, _) = emit(model, &[&Esi]);
    let (_, bytes) = files.iter().next().expect("a file");
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

fn read(xml: &str) -> Result<EtherCatInfo, String> {
    EtherCatInfo::from_xml_str(xml).map_err(|error| error.to_string())
}

#[test]
fn the_same_identity_and_slave_controller() {
    for (name, model) in drives() {
        let device = Device::of(&model).expect("it is on EtherCAT");
        let info = read(&with_active_pdos(&xml(&model))).unwrap_or_else(|e| panic!("{name}: {e}"));
        let found = &info.description.devices[0];
        let default = |sub| model.default_int(Address::new(0x1018, sub)).unwrap_or(0);
        let identity = [info.vendor.id, found.product_code, found.revision_no].map(i128::from);
        assert_eq!(identity, [1, 2, 3].map(default), "{name}");
        assert_eq!(info.vendor.name.as_deref(), Some(model.drive.vendor.as_str()), "{name}");
        assert_eq!(
            (found.name.as_str(), found.desc.as_str()),
            (model.drive.name.as_str(), device.product_type)
        );
        let managers: Vec<_> =
            found.sm.iter().map(|m| (m.enable, m.start_address, m.control_byte, m.default_size)).collect();
        let wanted: Vec<_> = device
            .managers
            .iter()
            .map(|m| (m.enable, m.start, m.control, Some(usize::from(m.size))))
            .collect();
        assert_eq!(managers, wanted, "{name}");
    }
}

#[test]
fn the_same_process_data() {
    for (name, model) in drives() {
        let device = Device::of(&model).expect("it is on EtherCAT");
        let info = read(&with_active_pdos(&xml(&model))).unwrap_or_else(|e| panic!("{name}: {e}"));
        let found = &info.description.devices[0];
        for (direction, pdos) in [(Direction::Rx, &found.rx_pdo), (Direction::Tx, &found.tx_pdo)] {
            let active: Vec<&AssignedPdo<'_>> =
                device.pdos.iter().filter(|p| p.assigned && p.pdo.direction == direction).collect();
            assert_eq!(pdos.len(), active.len(), "{name}");
            for (read, wanted) in pdos.iter().zip(active) {
                pdo(&model, read, wanted);
            }
        }
    }
}

fn pdo(model: &Model, read: &Pdo, wanted: &AssignedPdo<'_>) {
    assert_eq!((u16::from(read.idx), read.fixed), (wanted.pdo.index, wanted.fixed));
    let found: Vec<(u16, u8, usize)> = read
        .entries
        .iter()
        .map(|e| (u16::from(e.entry_idx.idx), u8::from(e.entry_idx.sub_idx), e.bit_len))
        .collect();
    let entries = wanted.pdo.entries.iter().map(|mapped| {
        let Address { index, sub } = model.entries[mapped.entry].address;
        (index, sub, usize::from(mapped.bits.value))
    });
    assert_eq!(found, entries.collect::<Vec<_>>());
}

/// Shapes of dictionaries that no EtherCAT drive shows here: every other golden case, made one.
#[test]
fn every_golden_case_is_read() {
    let row = "coe = [ { feature = \"sdo information\", supported = true, src = \"m1 L1\" } ]";
    for case in golden_cases() {
        let mut sources = case.sources.clone();
        if Device::of(&case.model()).is_none() {
            sources.push(Source { path: "coe.toml".into(), text: row.into() });
        }
        let compiled = compile(sources);
        let model = compiled.sound().unwrap_or_else(|| panic!("{}: {:#?}", case.name, compiled.diagnostics));
        let info = read(&with_active_pdos(&xml(model))).unwrap_or_else(|e| panic!("{}: {e}", case.name));
        assert_eq!(info.description.devices[0].name, model.drive.name, "{}", case.name);
    }
}

/// What the reader cannot take of a right file: if it can one day, nothing has to be cut for it.
#[test]
fn a_pdo_without_sync_manager_is_what_it_cannot_read() {
    let (_, model) = drives().remove(0);
    let error = read(&xml(&model)).expect_err("it demands `Sm` of each PDO");
    assert!(error.contains("missing field `Sm`"), "{error}");
}

/// The reader judges nothing if it takes these.
#[test]
fn broken_files_are_refused() {
    let (_, model) = drives().remove(0);
    let good = with_active_pdos(&xml(&model));
    read(&good).expect("it reads the whole one");
    let breaks = [
        ("<Id>#x000007E6</Id>", "<Id>SAVCH</Id>"),
        ("<Id>#x000007E6</Id>", ""),
        (" ProductCode=", " Product="),
        ("StartAddress=\"#x1000\"", "StartAddress=\"#x10000\""),
        ("</Device>", ""),
        ("<BitLen>16</BitLen>", ""),
        (" Fixed=\"0\"", " Fixed=\"no\""),
    ];
    for (from, to) in breaks {
        assert!(good.contains(from), "{from}");
        assert!(read(&good.replacen(from, to, 1)).is_err(), "{from} -> {to}");
    }
}
