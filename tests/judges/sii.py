"""Reads an SII image by the tables of ETG.1000.6 and ETG.2010 and compares it with model.json, and with the ESI of the same
name where there is one. Usage: sii.py MODEL IMAGE

What is read here was written from the tables, and shares no code with the writer. Broken copies must be refused.
"""

import json
import struct
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

STRINGS, GENERAL, FMMU, SYNC_MANAGERS, TX_PDOS, RX_PDOS, CLOCK, END = 10, 30, 40, 41, 50, 51, 60, 0xFFFF
HEADER_BYTES = 128
USES = {1: "mailbox out", 2: "mailbox in", 3: "outputs", 4: "inputs"}
FMMU_USES = {1: "outputs", 2: "inputs", 3: "mailbox status"}
ESI_USES = {"MBoxOut": 1, "MBoxIn": 2, "Outputs": 3, "Inputs": 4}
ESI_FMMU_USES = {"Outputs": 1, "Inputs": 2, "MBoxState": 3}
PROTOCOLS = ["aoe", "eoe", "coe", "foe", "soe", "voe"]
# Codes of the data types of CiA 301 by the words of model.json.
TYPES = {"bool": 1, "i8": 2, "i16": 3, "i32": 4, "u8": 5, "u16": 6, "u32": 7, "f32": 8, "i24": 16, "f64": 17, "i40": 18,
         "i48": 19, "i56": 20, "i64": 21, "u24": 22, "u40": 24, "u48": 25, "u56": 26, "u64": 27}


class Malformed(Exception):
    """The bytes are no SII."""


def crc8(data):
    """CRC-8 by long division: x^8 + x^2 + x + 1, with all ones in front."""
    rest = 0xFF
    for byte in data:
        for bit in range(7, -1, -1):
            out = (rest >> 7) ^ ((byte >> bit) & 1)
            rest = ((rest << 1) & 0xFF) ^ (0x07 if out else 0)
    return rest


def categories(data):
    """Each category with its bytes; the end marker must be there and be the last word."""
    at, found = HEADER_BYTES, {}
    while True:
        if at + 2 > len(data):
            raise Malformed("no end marker")
        (kind,) = struct.unpack_from("<H", data, at)
        if kind == END:
            if at + 2 != len(data):
                raise Malformed(f"{len(data) - at - 2} bytes behind the end marker")
            return found
        if at + 4 > len(data):
            raise Malformed("a category without length")
        (words,) = struct.unpack_from("<H", data, at + 2)
        body = data[at + 4:at + 4 + 2 * words]
        if len(body) != 2 * words:
            raise Malformed(f"category {kind} ends behind the image")
        if kind in found:
            raise Malformed(f"category {kind} comes twice")
        found[kind] = body
        at += 4 + 2 * words


def strings(body):
    """The table of strings; number 0 is no string."""
    found, at = [None], 1
    for _ in range(body[0] if body else 0):
        if at >= len(body) or at + 1 + body[at] > len(body):
            raise Malformed("a string ends behind its category")
        text = body[at + 1:at + 1 + body[at]]
        if not text or any(not 0x20 <= byte < 0x7F for byte in text):
            raise Malformed(f"string {len(found)} is not printable ASCII: {text!r}")
        found.append(text.decode("ascii"))
        at += 1 + body[at]
    if len(body) - at > 1 or any(body[at:]):
        raise Malformed("something behind the strings")
    if len(set(found)) != len(found):
        raise Malformed("a string is there twice")
    return found


def records(body, size):
    """Records of one size that fill a category."""
    if len(body) % size:
        raise Malformed(f"{len(body)} bytes are no records of {size}")
    return [body[at:at + size] for at in range(0, len(body), size)]


def pdos(body):
    """PDOs with their entries."""
    found, rows = [], iter(records(body, 8))
    for row in rows:
        index, count, manager, sync, name, flags = struct.unpack("<HBBBBH", row)
        entries = []
        for _ in range(count):
            entry = next(rows, None)
            if entry is None:
                raise Malformed(f"PDO {index:04X}h ends behind its category")
            entries.append(dict(zip(("index", "sub", "name", "type", "bits", "flags"), struct.unpack("<HBBBBH", entry))))
        found.append({"index": index, "manager": manager, "sync": sync, "name": name, "flags": flags, "entries": entries})
    return found


def read(data):
    """Everything that an image says."""
    if len(data) < HEADER_BYTES:
        raise Malformed("shorter than its header")
    if len(data) % 2:
        raise Malformed("not whole words")
    words = struct.unpack_from("<64H", data)
    if words[7] != crc8(data[:14]):
        raise Malformed(f"checksum {words[7]:04X}h, words 0 to 6 have {crc8(data[:14]):02X}h")
    found = categories(data)
    for kind in (STRINGS, GENERAL):
        if kind not in found:
            raise Malformed(f"no category {kind}")
    if len(found[GENERAL]) != 32:
        raise Malformed("the general category has 32 bytes")
    general = struct.unpack_from("<12BHBxH", found[GENERAL])
    managers = [dict(zip(("start", "size", "control", "status", "active", "use"), struct.unpack("<HHBBBB", row)))
                for row in records(found.get(SYNC_MANAGERS, b""), 8)]
    modes = [dict(zip(("cycle0", "shift0", "shift1", "factor1", "activate", "factor0", "name", "text"),
                      struct.unpack("<IiihHhBB", row[:20]))) for row in records(found.get(CLOCK, b""), 24)]
    return {
        "config": data[:14], "identity": list(struct.unpack_from("<4I", data, 16)), "bootstrap": data[40:48],
        "mailbox": list(words[24:28]), "protocols": words[28], "bytes": (words[62] + 1) * 128, "version": words[63],
        "strings": strings(found[STRINGS]),
        "general": dict(zip(("group", "image", "order", "name", "_", "coe", "foe", "eoe", "soe", "axes", "class", "flags",
                             "current", "group2", "ports"), general)),
        "fmmus": [code for code in found.get(FMMU, b"") if code != 0xFF],
        "managers": managers, "rx": pdos(found.get(RX_PDOS, b"")), "tx": pdos(found.get(TX_PDOS, b"")), "modes": modes,
        "reserved": any(data[32:40]) or any(data[58:124]),
    }


def within(image):
    """What does not hold in the image itself."""
    found = []
    numbers = [(f"general, {key}", image["general"][key]) for key in ("group", "image", "order", "name", "group2")]
    for pdo in image["rx"] + image["tx"]:
        numbers += [("PDO", pdo["name"])] + [("entry", entry["name"]) for entry in pdo["entries"]]
        for entry in pdo["entries"]:
            if entry["index"] and not (entry["type"] and entry["bits"]):
                found.append(f"entry {entry['index']:04X}h of PDO {pdo['index']:04X}h has no type or no length")
        if pdo["manager"] != 0xFF and pdo["manager"] >= len(image["managers"]):
            found.append(f"PDO {pdo['index']:04X}h names a SyncManager that is not there")
    numbers += [("mode", mode[key]) for mode in image["modes"] for key in ("name", "text")]
    found += [f"{what}: there is no string {number}" for what, number in numbers if number >= len(image["strings"])]
    for number, manager in enumerate(image["managers"]):
        if manager["use"] not in USES:
            found.append(f"SyncManager {number} has no use")
        if manager["active"] and not manager["size"]:
            found.append(f"SyncManager {number} is active without length")
    # Receive and send mailbox are those of the SyncManagers.
    both = [[m["start"], m["size"]] for use in (1, 2) for m in image["managers"] if m["use"] == use]
    if image["protocols"] and (sum(both, []) != image["mailbox"] or not all(image["mailbox"])):
        found.append(f"mailbox {image['mailbox']}, SyncManagers {both}")
    # The active PDOs of a direction fill its SyncManager.
    for use, key in ((3, "rx"), (4, "tx")):
        for number, manager in enumerate(image["managers"]):
            active = [pdo for pdo in image[key] if pdo["manager"] == number]
            if manager["use"] != use and active:
                found.append(f"PDO {active[0]['index']:04X}h is on SyncManager {number}, which is {USES[manager['use']]}")
    if image["reserved"] or image["version"] != 1:
        found.append("reserved words are not 0, or the version is not 1")
    return found


def value(known):
    """What a fact of model.json says."""
    return known["value"] if isinstance(known, dict) else known


def against_model(image, model):
    """Where the image and model.json differ. Only what the model says is compared: the rest is assumed."""
    found = []

    def same(what, says, wanted):
        if says != wanted:
            found.append(f"{what}: image {says!r}, model {wanted!r}")

    entries = {(e["index"], e["sub"]): e for o in model["objects"] for e in o["entries"]}
    for sub, number in enumerate(image["identity"], 1):
        same(f"1018:{sub:02X}", number, value(entries.get((0x1018, sub), {}).get("default", 0)))
    for row in model.get("sync_managers", []):
        if row["number"] >= len(image["managers"]):
            found.append(f"SyncManager {row['number']} is missing")
            continue
        manager = image["managers"][row["number"]]
        same(f"SyncManager {row['number']}, use", USES.get(manager["use"]), value(row["use"]))
        for key in ("start", "size", "control"):
            if key in row:
                same(f"SyncManager {row['number']}, {key}", manager[key], value(row[key]))
    for row, code in zip(model.get("fmmus", []), image["fmmus"] + [None] * 99):
        same(f"FMMU {row['number']}", FMMU_USES.get(code), value(row["use"]))
    whole = model.get("ethercat", {})
    if "mailbox" in whole and all(image["mailbox"]):
        same("mailbox", [p for n, p in enumerate(PROTOCOLS) if image["protocols"] >> n & 1], sorted(value(whole["mailbox"])))
    if "config" in whole:
        same("words 0 to 6", list(struct.unpack("<7H", image["config"])), value(whole["config"]))
    same("modes", len(image["modes"]), len(model.get("dc_modes", [])))
    for key in ("rx", "tx"):
        wanted = [(p["index"], [(value(m["entry"]), value(m["bits"])) for m in p["entries"]])
                  for p in model.get("pdos", []) if value(p["direction"]) == key and p["entries"]]
        says = [(p["index"], [(f"{e['index']:04X}:{e['sub']:02X}", e["bits"]) for e in p["entries"]]) for p in image[key]]
        same(f"{key} PDOs", says, wanted)
        for entry in (entry for pdo in image[key] for entry in pdo["entries"]):
            word = value(entries[entry["index"], entry["sub"]]["type"])
            if word in TYPES:
                same(f"type of {entry['index']:04X}:{entry['sub']:02X}", entry["type"], TYPES[word])
    return found


def number_of(text):
    """A HexDecValue of ETG.2000."""
    return int(text[2:], 16) if text.startswith("#x") else int(text)


def esi_pdos(device, name):
    """The PDOs of an ESI as the image has them."""
    def entry(e):
        return number_of(e.findtext("Index")), number_of(e.findtext("SubIndex", "0")), int(e.findtext("BitLen"))
    return [(number_of(p.findtext("Index")), number_of(p.get("Sm", "255")), p.get("Fixed") in ("1", "true"),
             [entry(e) for e in p.findall("Entry")]) for p in device.findall(name)]


def against_esi(image, root):
    """Where the image and the ESI of the same drive differ."""
    found = []

    def same(what, says, wanted):
        if says != wanted:
            found.append(f"{what}: image {says!r}, ESI {wanted!r}")

    device = root.find("Descriptions/Devices/Device")
    kind = device.find("Type")
    same("identity", image["identity"][:3],
         [number_of(t) for t in (root.findtext("Vendor/Id"), kind.get("ProductCode"), kind.get("RevisionNo"))])
    same("words 0 to 6", image["config"].hex(), device.findtext("Eeprom/ConfigData", "").lower())
    same("Bootstrap", image["bootstrap"].hex(), device.findtext("Eeprom/BootStrap", "").lower())
    size = int(device.findtext("Eeprom/ByteSize"))
    if size % 128 == 0 and 128 <= size <= 65536 * 128:
        same("bytes of the EEPROM", image["bytes"], size)
    managers = [tuple(number_of(sm.get(key, "0")) for key in ("StartAddress", "DefaultSize", "ControlByte")) +
                (int(bool(number_of(sm.get("Enable")) and number_of(sm.get("DefaultSize", "0")))), ESI_USES[sm.text])
                for sm in device.findall("Sm")]
    same("SyncManagers", [tuple(m[k] for k in ("start", "size", "control", "active", "use")) for m in image["managers"]],
         managers)
    same("FMMUs", image["fmmus"], [ESI_FMMU_USES[f.text] for f in device.findall("Fmmu")])
    for key, name in (("rx", "RxPdo"), ("tx", "TxPdo")):
        says = [(p["index"], p["manager"], bool(p["flags"] & 0x10),
                 [(e["index"], e["sub"], e["bits"]) for e in p["entries"]]) for p in image[key]]
        same(name, says, [pdo for pdo in esi_pdos(device, name) if pdo[3]])
    mailbox = device.find("Mailbox")
    names = [] if mailbox is None or not all(image["mailbox"]) else [child.tag.lower() for child in mailbox]
    same("protocols", [p for n, p in enumerate(PROTOCOLS) if image["protocols"] >> n & 1], sorted(names))
    coe = None if mailbox is None else mailbox.find("CoE")
    if coe is not None:
        bits = ["SdoInfo", "PdoAssign", "PdoConfig", "PdoUpload", "CompleteAccess"]
        wanted = 1 + sum(2 << n for n, bit in enumerate(bits) if coe.get(bit) in ("1", "true"))
        same("CoE", image["general"]["coe"], wanted)
    letters = {" ": 0, "Y": 1, "K": 3, "H": 4}
    wanted = sum(letters.get(c, 0) << (4 * n) for n, c in enumerate(device.get("Physics", "")[:4]))
    same("ports", image["general"]["ports"], wanted)
    modes = [number_of(mode.findtext("AssignActivate", "0")) for mode in device.findall("Dc/OpMode")]
    same("AssignActivate", [mode["activate"] for mode in image["modes"]], modes)
    return found


def judge(data, model, esi):
    """Everything that speaks against an image."""
    try:
        image = read(data)
    except (Malformed, struct.error) as error:
        return [str(error)]
    return within(image) + against_model(image, model) + (against_esi(image, esi) if esi is not None else [])


def broken(data):
    """Copies of an image with one thing broken: each must be refused."""
    for bit in range(14 * 8):
        yield f"bit {bit} of words 0 to 6", data[:bit // 8] + bytes([data[bit // 8] ^ 1 << bit % 8]) + data[bit // 8 + 1:]
    for at in range(16, 32):
        yield f"byte {at} of the identity", data[:at] + bytes([data[at] ^ 1]) + data[at + 1:]
    for at in (0x30, 0x32, 0x34, 0x36):
        yield f"byte {at} of the mailbox", data[:at] + bytes([data[at] ^ 1]) + data[at + 1:]
    for length in range(0, len(data), 7):
        yield f"only {length} bytes", data[:length]
    yield "no end marker", data[:-2]
    yield "another end marker", data[:-2] + b"\x01\x10"
    yield "a string too many", data[:0x84] + bytes([data[0x84] + 1]) + data[0x85:]
    at, kinds = HEADER_BYTES, {}
    while data[at:at + 2] != b"\xff\xff":
        kind, words = struct.unpack_from("<HH", data, at)
        kinds[kind] = at
        at += 4 + 2 * words
    yield "a length of the strings", data[:0x82] + bytes([data[0x82] ^ 1]) + data[0x83:]
    # Start of the first SyncManager, use of the first FMMU, index of the first PDO and of its first entry.
    for kind, offset, flip in ((SYNC_MANAGERS, 4, 1), (SYNC_MANAGERS, 11, 7), (FMMU, 4, 1), (RX_PDOS, 4, 1), (RX_PDOS, 12, 1),
                               (TX_PDOS, 4, 1), (TX_PDOS, 17, 1), (TX_PDOS, 15, 255)):
        if kind in kinds:
            at = kinds[kind] + offset
            yield f"byte {offset} of category {kind}", data[:at] + bytes([data[at] ^ flip]) + data[at + 1:]


def main(model, image):
    """Judges an image and its broken copies."""
    image = Path(image)
    model, data, name = json.loads(Path(model).read_text(encoding="utf-8")), image.read_bytes(), image.name
    esi = image.parent.parent / "esi" / f"{image.stem}.xml"
    root = ET.fromstring(esi.read_bytes()) if esi.exists() else None
    findings = judge(data, model, root)
    copies = list(broken(data)) if not findings else []
    missed = [what for what, copy in copies if not judge(copy, model, root)]
    for text in findings:
        print(f"{name}: {text}")
    for what in missed:
        print(f"{name}: the judge accepts a copy with {what}")
    print(f"{name}: {len(findings)} findings; {len(copies) - len(missed)} of {len(copies)} broken copies refused"
          + ("" if root is not None else "; there is no ESI to compare with"))
    return 1 if findings or missed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
