//! What follows the 64 words: strings, general, FMMUs, SyncManagers, PDOs, distributed clock.

use super::image::{Image, Said};
use super::loss::Loss;
use super::{Parts, Strings};
use crate::backend::ethercat::{AssignedPdo, Manager, OpMode, Sync};
use crate::model::{Address, CoeFeature, Direction, FmmuUse, MailboxProtocol, PdoEntry, SyncManagerUse};

/// Addresses of a slave controller have 16 bits.
const MEMORY_END: u32 = 0x1_0000;
/// Bytes of a category, whose length is a number of words in 16 bits.
const CATEGORY_BYTES: usize = 2 * u16::MAX as usize;
/// The number of a SyncManager where there is none, and the use of an FMMU that is not there.
const NONE: u8 = 0xFF;

/// Every category but that of the strings, whose numbers the others need.
pub(super) fn write<'m>(parts: &mut Parts<'m>) -> Image<'m> {
    let mut image = general(parts);
    image.append(fmmus(parts));
    image.append(sync_managers(parts));
    image.append(pdos(parts, Direction::Tx).category(50, "TxPDOs", 0));
    image.append(pdos(parts, Direction::Rx).category(51, "RxPDOs", 0));
    image.append(distributed_clock(parts));
    for startup in &parts.model.startup {
        parts.losses.add(Loss::StartUp, startup.write.value, startup.write.span());
    }
    image
}

pub(super) fn strings<'m>(parts: &Parts<'m>) -> Image<'m> {
    let mut image = Image::new(&parts.device.assumed);
    let count = parts.strings.count();
    if count > 0 {
        image.byte(Said::Format, format!("Strings: {count}"), count);
    }
    for (number, text) in (1..).zip(parts.strings.iter()) {
        let number: u8 = number;
        let length = u8::try_from(text.len()).unwrap_or(u8::MAX);
        image.byte(Said::Format, format!("String {number}, length"), length);
        image.put(Said::Below, format!("String {number}: {text}"), text.as_bytes());
    }
    image.category(10, "strings", 0)
}

/// The number of a text of the drive as a whole.
fn number(text: &str, parts: &mut Parts<'_>) -> u8 {
    let (number, loss) = parts.strings.number(text);
    if let Some(loss) = loss {
        parts.losses.add_of_drive(loss);
    }
    number
}

/// `Name: string 3`, with the text.
fn named(what: &str, number: u8, strings: &Strings) -> String {
    match strings.get(number) {
        Some(text) => format!("{what}: string {number}, {text}"),
        None => format!("{what}: no string"),
    }
}

fn general<'m>(parts: &mut Parts<'m>) -> Image<'m> {
    let device = parts.device;
    let mut image = Image::new(&device.assumed);
    let group = number(device.group, parts);
    let order = number(device.product_type, parts);
    let name = number(&parts.model.drive.name, parts);
    let has = |protocol| device.mailbox.contains(&protocol);
    image.byte(Said::Unless("Group"), named("Group", group, &parts.strings), group);
    image.byte(Said::Format, "Image: no string", 0);
    image.byte(Said::Unless("Type"), named("Type", order, &parts.strings), order);
    image.byte(Said::Profile, named("Name", name, &parts.strings), name);
    image.reserved(1);
    coe(parts, &mut image);
    for (name, protocol) in [("FoE", MailboxProtocol::Foe), ("EoE", MailboxProtocol::Eoe)] {
        image.byte(Said::Unless("Mailbox"), format!("{name}: {}", has(protocol)), u8::from(has(protocol)));
    }
    image.reserved(3);
    image.byte(Said::Format, "Flags: none", 0);
    image.word(Said::Format, "Current taken from the E-bus in mA", 0);
    image.byte(Said::Unless("Group"), named("Group once more", group, &parts.strings), group);
    image.reserved(1);
    let wiring = ports(parts);
    image.word(Said::Unless("Ports"), "Ports, four bits each: 1 MII, 3 E-bus, 4 fast hot connect", wiring);
    image.reserved(14);
    image.category(30, "general", 0)
}

fn coe(parts: &Parts<'_>, image: &mut Image<'_>) {
    const BITS: [(CoeFeature, u8); 5] = [
        (CoeFeature::SdoInformation, 0x02),
        (CoeFeature::PdoAssignment, 0x04),
        (CoeFeature::PdoConfiguration, 0x08),
        (CoeFeature::PdoUpload, 0x10),
        (CoeFeature::CompleteAccess, 0x20),
    ];
    let mut words = Vec::new();
    let mut bits = 0;
    if parts.device.mailbox.contains(&MailboxProtocol::Coe) {
        words.push("SDO");
        let can = BITS.iter().filter(|(feature, _)| parts.device.can(*feature));
        bits = can.fold(0x01, |bits, (feature, bit)| {
            words.push(feature.word());
            bits | bit
        });
    }
    let assumed = BITS.iter().map(|(feature, _)| format!("CoE, {}", feature.word()));
    let key = assumed.into_iter().find(|key| parts.device.assumed.holds(key));
    let said = key.as_deref().unwrap_or("Mailbox");
    let what = if words.is_empty() { "none".to_owned() } else { words.join(", ") };
    image.byte(Said::Unless(said), format!("CoE: {what}"), bits);
}

/// Four bits a port, port 0 in the lowest.
fn ports(parts: &mut Parts<'_>) -> u16 {
    let kinds: Vec<Option<u16>> = parts.device.physics.chars().map(port).collect();
    if kinds.len() > 4 || kinds.contains(&None) {
        parts.losses.add_of_drive(Loss::Ports);
    }
    let four = kinds.into_iter().take(4).zip(0u16..);
    four.fold(0, |ports, (kind, place)| ports | (kind.unwrap_or(0) << (4 * place)))
}

fn port(letter: char) -> Option<u16> {
    match letter {
        ' ' => Some(0),
        'Y' => Some(1),
        'K' => Some(3),
        'H' => Some(4),
        _ => None,
    }
}

fn fmmus<'m>(parts: &Parts<'m>) -> Image<'m> {
    let mut image = Image::new(&parts.device.assumed);
    for (number, maps) in parts.device.fmmus.iter().enumerate() {
        let code = match maps {
            FmmuUse::Outputs => 1,
            FmmuUse::Inputs => 2,
            FmmuUse::MailboxStatus => 3,
        };
        image.byte(Said::Unless("FMMUs"), format!("FMMU {number}: {}", maps.word()), code);
    }
    image.category(40, "FMMUs", NONE)
}

fn sync_managers<'m>(parts: &mut Parts<'m>) -> Image<'m> {
    let device = parts.device;
    let mut image = Image::new(&device.assumed);
    for manager in &device.managers {
        sync_manager(manager, parts, &mut image);
    }
    image.category(41, "SyncManagers", 0)
}

fn sync_manager(manager: &Manager, parts: &mut Parts<'_>, image: &mut Image<'_>) {
    let name = |what: &str| format!("SyncManager {}, {what}", manager.number);
    if manager.end() > MEMORY_END {
        parts.losses.add_of_drive(Loss::Memory);
    }
    if manager.enable && manager.size == 0 {
        parts.losses.add_of_drive(Loss::ActiveWithoutLength);
    }
    let active = manager.enable && manager.size > 0;
    let code = match manager.carries {
        SyncManagerUse::MailboxOut => 1,
        SyncManagerUse::MailboxIn => 2,
        SyncManagerUse::Outputs => 3,
        SyncManagerUse::Inputs => 4,
    };
    let (start, length) = (name("start"), name("length"));
    image.word(Said::Unless(&start), &start, manager.start);
    image.word(Said::Unless(&length), &length, manager.size);
    let control = name("control");
    image.byte(Said::Unless(&control), format!("{control}: 0x{:02X}", manager.control), manager.control);
    image.byte(Said::Format, name("status: 0"), 0);
    image.byte(Said::Unless(&name("active")), name(&format!("active: {active}")), u8::from(active));
    let key = "SyncManagers 0 to 3";
    image.byte(Said::Unless(key), name(&format!("carries: {}", manager.carries.word())), code);
}

fn pdos<'m>(parts: &mut Parts<'m>, direction: Direction) -> Image<'m> {
    let device = parts.device;
    let mut image = Image::new(&device.assumed);
    for pdo in device.pdos.iter().filter(|pdo| pdo.pdo.direction == direction) {
        let length = 8 * (1 + pdo.pdo.entries.len());
        let loss = if pdo.pdo.entries.is_empty() {
            Some(Loss::EmptyPdo)
        } else {
            (image.len() + length > CATEGORY_BYTES).then_some(Loss::PdosTooLong)
        };
        match loss {
            Some(loss) => parts.losses.add(loss, Address::new(pdo.pdo.index, 0), pdo.pdo.origin.span),
            None => self::pdo(pdo, parts, &mut image),
        }
    }
    image
}

fn pdo(pdo: &AssignedPdo<'_>, parts: &mut Parts<'_>, image: &mut Image<'_>) {
    let index = pdo.pdo.index;
    let (kind, carries) = match pdo.pdo.direction {
        Direction::Rx => ("RxPDO", SyncManagerUse::Outputs),
        Direction::Tx => ("TxPDO", SyncManagerUse::Inputs),
    };
    let name = |what: &str| format!("{kind} {index:04X}h, {what}");
    let object = parts.model.object(index);
    let text = object.map_or_else(|| format!("{kind} {index:04X}h"), |o| o.name.value.original().to_owned());
    let text = number(&text, parts);
    // A position is a byte, so no PDO has more entries.
    let count = u8::try_from(pdo.pdo.entries.len()).unwrap_or(u8::MAX);
    let manager = parts.device.manager(carries).filter(|_| pdo.assigned).map_or(NONE, |m| m.number);
    image.word(Said::Profile, &name("index"), index);
    image.byte(Said::Profile, name(&format!("entries: {count}")), count);
    let active = if manager == NONE { "none by default".to_owned() } else { manager.to_string() };
    image.byte(Said::Unless(&format!("Active {kind}")), name(&format!("SyncManager: {active}")), manager);
    image.byte(Said::Format, name("synchronization: none"), 0);
    image.byte(Said::Profile, named(&name("name"), text, &parts.strings), text);
    let fixed = if pdo.fixed { 0x0010 } else { 0 };
    image.word(
        Said::Unless(&format!("PDO {index:04X}h, fixed")),
        &name(if pdo.fixed { "flags, fixed content" } else { "flags, changeable content" }),
        fixed,
    );
    for mapped in &pdo.pdo.entries {
        entry(mapped, parts, image);
    }
}

fn entry(mapped: &PdoEntry, parts: &mut Parts<'_>, image: &mut Image<'_>) {
    let entry = &parts.model.entries[mapped.entry];
    let (text, loss) = parts.strings.number(&entry.name.value);
    if let Some(loss) = loss {
        parts.losses.add(loss, entry.address, entry.name.span());
    }
    let name = |what: &str| format!("  {}, {what}", entry.address);
    let ty = entry.ty.value;
    image.word(Said::Profile, &name("index"), entry.address.index);
    image.byte(Said::Profile, name(&format!("sub-index: {:02X}h", entry.address.sub)), entry.address.sub);
    image.byte(Said::Profile, named(&name("name"), text, &parts.strings), text);
    let code = u8::try_from(ty.cia301_code()).unwrap_or(0);
    image.byte(Said::Profile, name(&format!("type: {}", ty.cia301_name())), code);
    let bits = mapped.bits.value;
    image.byte(Said::Profile, name(&format!("bits: {bits}")), bits);
    image.word(Said::Format, &name("flags"), 0);
}

fn distributed_clock<'m>(parts: &mut Parts<'m>) -> Image<'m> {
    let device = parts.device;
    let mut image = Image::new(&device.assumed);
    for (number, mode) in (1..).zip(&device.dc_modes) {
        let number: u32 = number;
        op_mode(number, mode, parts, &mut image);
    }
    image.category(60, "distributed clock", 0)
}

fn op_mode(place: u32, mode: &OpMode<'_>, parts: &mut Parts<'_>, image: &mut Image<'_>) {
    let name = |what: &str| format!("DC mode {place}, {what}");
    let part = |sync: Option<Sync>| sync.map_or((0, 0), |sync| (sync.cycle, sync.shift));
    let ((cycle0, shift0), (cycle1, shift1)) = (part(mode.sync0), part(mode.sync1));
    if cycle1 != 0 {
        parts.losses.add_of_drive(Loss::CycleOfSync1);
    }
    let (title, text) = (number(mode.name, parts), mode.text.map_or(0, |text| number(text, parts)));
    let cycle = name("cycle of SYNC0");
    image.long(said(mode.sync0, &cycle), &name("cycle of SYNC0 in ns, 0 that of the master"), cycle0);
    let signals = [("SYNC0", mode.sync0, shift0), ("SYNC1", mode.sync1, shift1)];
    for (which, sync, shift) in signals {
        let key = name(&format!("shift of {which}"));
        image.long(said(sync, &key), &name(&format!("shift of {which} in ns")), shift.cast_unsigned());
    }
    let factors = [mode.sync0, mode.sync1].map(|sync| u16::from(sync.is_some_and(|sync| sync.cycle == 0)));
    image.word(Said::Format, &name("cycle of SYNC1 in cycles"), factors[1]);
    image.word(Said::Unless(&name("AssignActivate")), &name("AssignActivate"), mode.assign_activate);
    image.word(Said::Format, &name("cycle of SYNC0 in cycles of the master"), factors[0]);
    image.byte(Said::Profile, named(&name("name"), title, &parts.strings), title);
    image.byte(Said::Profile, named(&name("text"), text, &parts.strings), text);
    image.reserved(4);
}

/// A mode without the signal has zeros for it.
fn said(sync: Option<Sync>, key: &str) -> Said<'_> {
    sync.map_or(Said::Format, |_| Said::Unless(key))
}
