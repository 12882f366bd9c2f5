//! Words 0 to 63: what the slave controller is configured with, identity, mailbox, size.

use super::Parts;
use super::image::{Image, Said};
use super::loss::Loss;
use crate::model::{MailboxProtocol, SyncManagerUse};

/// The size is counted in units of 1024 bits.
const KIBIT: u32 = 128;

pub(super) fn write<'m>(parts: &mut Parts<'m>) -> Image<'m> {
    let mut image = Image::new(&parts.device.assumed);
    config(parts, &mut image);
    let names = ["Vendor id", "Product code", "Revision", "Serial number"];
    for (name, value) in names.into_iter().zip(parts.device.identity) {
        image.long(Said::Unless(name), name, value);
    }
    image.reserved(8);
    bootstrap(parts, &mut image);
    mailbox(parts, &mut image);
    image.reserved(66);
    image.word(Said::Unless("Bytes of the EEPROM"), "Size in KiBit, less 1", size(parts));
    image.word(Said::Format, "Version of the layout", 1);
    image
}

fn config(parts: &Parts<'_>, image: &mut Image<'_>) {
    const NAMES: [&str; 7] = [
        "PDI control and ESC configuration",
        "PDI configuration",
        "Length of the SYNC impulse",
        "Extended PDI configuration",
        "Station alias",
        "Configuration, word 5",
        "Configuration, word 6",
    ];
    for (name, value) in NAMES.into_iter().zip(parts.device.config) {
        image.word(Said::Unless("SII words 0 to 6"), name, value);
    }
    let bytes = image.bytes();
    image.word(Said::Format, "Checksum of words 0 to 6", u16::from(checksum(&bytes)));
}

/// CRC-8 with the polynomial 07h, started with all ones.
pub(super) fn checksum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0xFF, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc, _| if crc & 0x80 == 0 { crc << 1 } else { (crc << 1) ^ 0x07 })
    })
}

fn bootstrap(parts: &Parts<'_>, image: &mut Image<'_>) {
    const NAMES: [&str; 4] =
        ["receive mailbox, start", "receive mailbox, length", "send mailbox, start", "send mailbox, length"];
    for (name, value) in NAMES.into_iter().zip(parts.device.bootstrap) {
        image.word(Said::Unless("Mailbox of Bootstrap"), &format!("Bootstrap, {name}"), value);
    }
}

fn mailbox(parts: &mut Parts<'_>, image: &mut Image<'_>) {
    let uses = [(SyncManagerUse::MailboxOut, "Receive mailbox"), (SyncManagerUse::MailboxIn, "Send mailbox")];
    let mut managers = 0;
    for (carries, name) in uses {
        let Some(manager) = parts.device.manager(carries) else {
            image.word(Said::Format, &format!("{name}, start"), 0);
            image.word(Said::Format, &format!("{name}, length"), 0);
            continue;
        };
        managers += 1;
        let key = |what| format!("SyncManager {}, {what}", manager.number);
        image.word(Said::Unless(&key("start")), &format!("{name}, start"), manager.start);
        image.word(Said::Unless(&key("length")), &format!("{name}, length"), manager.size);
    }
    let stated = parts.device.mailbox.iter().fold(0, |bits, protocol| bits | bit(*protocol));
    if stated != 0 && managers < uses.len() {
        parts.losses.add_of_drive(Loss::MailboxWithoutManagers);
    }
    image.word(
        Said::Unless("Mailbox"),
        "Protocols of the mailbox",
        if managers < uses.len() { 0 } else { stated },
    );
}

fn bit(protocol: MailboxProtocol) -> u16 {
    match protocol {
        MailboxProtocol::Aoe => 0x01,
        MailboxProtocol::Eoe => 0x02,
        MailboxProtocol::Coe => 0x04,
        MailboxProtocol::Foe => 0x08,
        MailboxProtocol::Soe => 0x10,
        MailboxProtocol::Voe => 0x20,
    }
}

fn size(parts: &mut Parts<'_>) -> u16 {
    let bytes = parts.device.eeprom_bytes;
    let word = (bytes / KIBIT).checked_sub(1).and_then(|size| u16::try_from(size).ok());
    if word.is_none() || !bytes.is_multiple_of(KIBIT) {
        parts.losses.add_of_drive(Loss::Size);
    }
    word.unwrap_or(if bytes < KIBIT { 0 } else { u16::MAX })
}
