"""Compares an ESI, as Python's own XML parser reads it, with model.json, and with rules of ETG.2000 that no schema sees.
Usage: esi_model.py MODEL_JSON ESI
"""

import json
import struct
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from fractions import Fraction
from pathlib import Path

import controls

# Words of model.json, names of ETG.1020 and bits.
TYPES = {
    "bool": ("BOOL", 1), "i8": ("SINT", 8), "i16": ("INT", 16), "i24": ("INT24", 24), "i32": ("DINT", 32),
    "i40": ("INT40", 40), "i48": ("INT48", 48), "i56": ("INT56", 56), "i64": ("LINT", 64), "u8": ("USINT", 8),
    "u16": ("UINT", 16), "u24": ("UINT24", 24), "u32": ("UDINT", 32), "u40": ("UINT40", 40), "u48": ("UINT48", 48),
    "u56": ("UINT56", 56), "u64": ("ULINT", 64), "f32": ("REAL", 32), "f64": ("LREAL", 64),
    "time": ("TIME_OF_DAY", 48), "time_difference": ("TIME_DIFFERENCE", 48),
}
# Beginnings of names of types without a fixed length.
LONG = {"string": "STRING(", "octets": "ARRAY [0..", "unicode": "ARRAY [0..", "domain": "DOMAIN"}
ACCESS = {"ro": "ro", "const": "ro", "rw": "rw", "wo": "wo"}
MAPPING = {None: "", "no": "", "rx": "R", "tx": "T", "rx tx": "RT"}
MANAGERS = {"mailbox out": "MBoxOut", "mailbox in": "MBoxIn", "outputs": "Outputs", "inputs": "Inputs"}
FMMUS = {"outputs": "Outputs", "inputs": "Inputs", "mailbox status": "MBoxState"}
FEATURES = {
    "sdo information": "SdoInfo", "pdo assignment": "PdoAssign", "pdo configuration": "PdoConfig",
    "pdo upload": "PdoUpload", "complete access": "CompleteAccess", "segmented sdo": "SegmentedSdo",
}
# Numerators and denominators of ETG.1004 that a drive needs: the quantity in words of model.json, and how many of its base
# units one is.
UNITS = {
    (0x00, 0x00): ("ratio", 1), (0x01, 0x00): ("length", 1), (0x03, 0x00): ("time", 1), (0x47, 0x00): ("time", 60),
    (0x48, 0x00): ("time", 3600), (0x04, 0x00): ("current", 1), (0x20, 0x00): ("frequency", 1), (0x24, 0x00): ("power", 1),
    (0x26, 0x00): ("voltage", 1), (0x28, 0x00): ("resistance", 1), (0x2C, 0x00): ("inductance", 1),
    (0x2D, 0x00): ("temperature", 1), (0x41, 0x00): ("angle", Fraction(1, 360)), (0xB4, 0x00): ("angle", 1),
    (0xB4, 0x47): ("velocity", 1), (0xB4, 0x03): ("velocity", 60), (0xB5, 0x00): ("counts", 1), (0x56, 0x00): ("torque", 1),
}
POWERS = {Fraction(10) ** power for power in range(-18, 19)}
# From here on a file names its units itself.
OWN_UNITS = 0xF0

CHANGES = [
    ("vendor", r"(<Vendor.*>\n *<Id>#x\w*)\w<", r"\g<1>F<"),
    ("product", r'(ProductCode="#x\w*)\w"', r'\g<1>F"'),
    ("revision", r'(RevisionNo="#x\w*)\w"', r'\g<1>F"'),
    ("group", r"<GroupType>", r"<GroupType>Other "),
    ("width of a type", r"(<Name>UDINT</Name>\n *<BitSize>)32", r"\g<1>16"),
    ("type", r"(<Object>\n(?: *<.*\n){2} *<Type>)UINT<", r"\g<1>INT<"),
    ("size of an object", r"(<Object>\n(?: *<.*\n){3} *<BitSize>)32", r"\g<1>16"),
    ("access", r"(<SubIdx>1</SubIdx>\n(?: *<.*\n){5} *<Access>r)w", r"\g<1>o"),
    ("offset", r"<BitOffs>16<", "<BitOffs>8<"),
    ("sub-index", r"<SubIdx>1</SubIdx>", "<SubIdx>250</SubIdx>"),
    ("lower limit", r"<MinData>.", "<MinData>9"),
    ("upper limit", r"<MaxData>.", "<MaxData>9"),
    ("default", r"(<DefaultData>)\w(\w+)<", r"\g<1>7\g<2><"),
    ("width of a default", r"(<DefaultData>\w+)\w\w<", r"\g<1><"),
    ("name of an entry", r"(<Info>\n *<SubItem>\n *<Name>\w)", r"\g<1>_"),
    ("mapping", r" *<PdoMapping>R.*</PdoMapping>\n", ""),
    ("named value", r"<Enum>-?\d+</Enum>\n *</EnumInfo>", "<Enum>99</Enum></EnumInfo>"),
    ("length of an entry", r"<BitLen>16<", "<BitLen>8<"),
    ("type of an entry", r"<DataType>UINT<", "<DataType>INT<"),
    ("exclusion", r" *<Exclude>.*\n", ""),
    ("fixed", r'Fixed="0"', 'Fixed="1"'),
    ("active PDO", r'(<RxPdo Fixed="0") Sm="2"', r"\g<1>"),
    ("length of a SyncManager", r'DefaultSize="13"', 'DefaultSize="14"'),
    ("memory of a SyncManager", r'StartAddress="#x1080"', 'StartAddress="#x1040"'),
    ("direction of a SyncManager", r'ControlByte="#x26"', 'ControlByte="#x22"'),
    ("FMMU", r"<Fmmu>Inputs<", "<Fmmu>Outputs<"),
    ("feature of CoE", r'PdoAssign="1"', 'PdoAssign="0"'),
    ("number of a message", r"<TextId>#x0001<", "<TextId>#x0002<"),
    ("cause", r"(<Cause LcId=\"1033\">)\w", r"\g<1>_"),
    ("class of a message", r"<DiagReset>1<", "<DiagReset>2<"),
    ("mode", r"(<OpMode>\n *<Name>)\w", r"\g<1>_"),
    ("words of the SII", r"<ConfigData>..", "<ConfigData>"),
    ("whose file it is", r"(<Comment>.*is )not (the maker(?:'|&apos;)s file)", r"\g<1>\g<2>"),
    ("power of ten of a unit", r"<Unit>#xFF", "<Unit>#xFE"),
    ("numerator of a unit", r"(<Unit>#x..)B4", r"\g<1>B5"),
    ("denominator of a unit", r"(<Unit>#x..B4)47", r"\g<1>03"),
    ("unit that is missing", r" *<Unit>.*</Unit>\n", ""),
    ("name of a unit", r"(<UnitType>\n.*\n *<Name>)\w", r"\g<1>_"),
]


def value(row, key):
    """The value of a fact of model.json; None where nobody states it."""
    fact = row.get(key)
    return None if fact is None else fact["value"]


def number(text):
    """A HexDecValue."""
    return None if text is None else int(text[2:], 16) if text.startswith("#x") else int(text)


def data(word, n):
    """The bytes of a number of a type, as hexadecimal digits; None if it has none."""
    if word in ("f32", "f64"):
        return struct.pack("<f" if word == "f32" else "<d", n).hex().upper()
    if word not in TYPES or word.startswith("time"):
        return None
    bits = TYPES[word][1]
    return (n % (1 << bits)).to_bytes((bits + 7) // 8, "little").hex().upper()


class Judge:
    """Collects what is wrong with one file."""

    def __init__(self, model, file):
        self.model, self.found = model, []
        self.root = ElementTree.parse(file).getroot()
        self.device = self.root.find("Descriptions/Devices/Device")
        dictionary = self.device.find("Profile/Dictionary")
        self.types = {t.findtext("Name"): t for t in dictionary.iterfind("DataTypes/DataType")}
        self.type_names = Counter(t.findtext("Name") for t in dictionary.iterfind("DataTypes/DataType"))
        self.objects = dictionary.findall("Objects/Object")
        named = dictionary.iterfind("UnitTypes/UnitType")
        self.units = {number(u.findtext("NotationIndex")): (u.findtext("Name"), u.findtext("Symbol")) for u in named}
        self.entries = {(o["index"], e["sub"]): e for o in model["objects"] for e in o["entries"]}

    def same(self, what, found, wanted):
        """Notes a difference."""
        if found != wanted:
            self.found.append(f"{what}: {found!r}, model.json has {wanted!r}")

    def holds(self, rule, truth):
        """Notes a broken rule."""
        if not truth:
            self.found.append(rule)

    def default(self, index, sub):
        """The default of an entry as a number; None where nobody states one."""
        found = value(self.entries.get((index, sub), {}), "default")
        return None if found is None else int(found)

    def head(self):
        """Identity, group, and whose file it is."""
        vendor, kind, model = self.root.find("Vendor"), self.device.find("Type"), self.model
        self.same("vendor", number(vendor.findtext("Id")), int(model["identity"].get("vendor_id", 0)))
        self.same("vendor's name", vendor.findtext("Name"), model["drive"]["vendor"])
        self.same("product", number(kind.get("ProductCode")), int(model["identity"].get("product_code", 0)))
        self.same("revision", number(kind.get("RevisionNo")), int(model["identity"].get("revision", 0)))
        self.same("type", kind.text, value(model["ethercat"], "type") or model["drive"]["name"])
        self.holds("the vendor's comment does not say whose file it is", "not the maker's" in vendor.findtext("Comment"))
        groups = [g.findtext("Type") for g in self.root.iterfind("Descriptions/Groups/Group")]
        self.holds("GroupType is no group", self.device.findtext("GroupType") in groups)
        device_type = model["identity"].get("device_type")
        if device_type is not None:
            found = [number(self.device.findtext(f"Profile/{key}")) for key in ("ProfileNo", "AddInfo")]
            self.same("profile", found, [int(device_type) & 0xFFFF, int(device_type) >> 16])

    def data_types(self):
        """What a schema cannot see of types: sizes, offsets, and that enumerations are those of the model."""
        for name, times in self.type_names.items():
            self.holds(f"type {name} is declared {times} times", times == 1)
        for name, kind in self.types.items():
            bits, end, items = int(kind.findtext("BitSize")), 0, kind.findall("SubItem")
            base = kind.findtext("BaseType")
            elements = int(kind.findtext("ArrayInfo/Elements", "1"))
            if base:
                self.holds(f"type {name}: base", base in self.types)
                self.same(f"type {name}: size", bits, int(self.types[base].findtext("BitSize")) * elements)
            for item in items:
                at, size = int(item.findtext("BitOffs")), int(item.findtext("BitSize"))
                inner = self.types.get(item.findtext("Type"))
                self.holds(f"type {name}: an item overlaps", at >= end and (at == 0 or at >= 16))
                self.holds(f"type {name}: no such type", inner is not None)
                self.same(f"type {name}: size of an item", size, inner is not None and int(inner.findtext("BitSize")))
                self.holds(f"type {name}: an item without access", item.findtext("Flags/Access") is not None)
                end = at + size
            self.holds(f"type {name}: items end behind it", end <= bits)

    def dictionary(self):
        """Every object and entry, in both directions."""
        wanted = [o for o in self.model["objects"] if o["index"] >= 0x1000 and any(e["sub"] < 255 for e in o["entries"])]
        self.same("objects", [number(o.findtext("Index")) for o in self.objects], [o["index"] for o in wanted])
        for found, object_ in zip(self.objects, wanted):
            self.object(found, object_)

    def object(self, found, object_):
        """An object: its type, and each entry as the type and the information of the object state it."""
        at, kind = object_["at"], self.types.get(found.findtext("Type"))
        if kind is None:
            self.found.append(f"{at}: no such type")
            return
        self.same(f"{at}: size", found.findtext("BitSize"), kind.findtext("BitSize"))
        entries = [e for e in object_["entries"] if e["sub"] < 255]
        items = kind.findall("SubItem")
        if not items:
            self.same(f"{at}: entries", [0], [e["sub"] for e in entries])
            self.entry(entries[0], kind, found.find("Flags"), found.find("Info"))
            self.same(f"{at}: name", found.findtext("Name"), value(entries[0], "name"))
            return
        self.same(f"{at}: name", found.findtext("Name"), value(object_, "name"))
        infos = found.findall("Info/SubItem")
        array = self.types.get(items[-1].findtext("Type")) if items[-1].find("SubIdx") is None else None
        if array is not None:
            size = int(array.findtext("ArrayInfo/Elements"))
            rows = [(0, items[0])] + [(sub, items[1]) for sub in range(1, size + 1)]
            names = [f"SubIndex {sub:03}" for sub, _ in rows]
        else:
            rows = [(int(item.findtext("SubIdx")), item) for item in items]
            names = [item.findtext("Name") for item in items]
        self.same(f"{at}: entries", [sub for sub, _ in rows], [e["sub"] for e in entries])
        if infos:
            self.same(f"{at}: names of entries", [info.findtext("Name") for info in infos], names)
        for (sub, item), name, entry, info in zip(rows, names, entries, infos or [None] * len(rows)):
            inner = self.types.get(item.findtext("Type"))
            if array is not None and sub:
                inner = self.types.get(array.findtext("BaseType"))
            elif array is None:
                # Of several entries with one name each has its number behind it.
                printed = " ".join(value(entry, "name").split())
                self.holds(f"{entry['at']}: name {name!r}", " ".join(name.split()).startswith(printed))
            if inner is not None:
                self.entry(entry, inner, item.find("Flags"), info if info is None else info.find("Info"))

    def entry(self, entry, kind, flags, info):
        """Type, access, mapping, limits, default and named values of an entry."""
        at, word = entry["at"], value(entry, "type")
        names = kind.findall("EnumInfo")
        base = self.types.get(kind.findtext("BaseType")) if names else kind
        if word in TYPES:
            self.same(f"{at}: type", (base.findtext("Name"), int(kind.findtext("BitSize"))), TYPES[word])
        else:
            self.holds(f"{at}: type {base.findtext('Name')}", base.findtext("Name").startswith(LONG[word]))
        self.same(f"{at}: access", flags.findtext("Access"), ACCESS[value(entry, "access")])
        self.same(f"{at}: mapping", flags.findtext("PdoMapping", ""), MAPPING[value(entry, "pdo")])
        text = (lambda key: None) if info is None else info.findtext
        for key, element in (("min", "MinData"), ("max", "MaxData"), ("default", "DefaultData")):
            stated = value(entry, key)
            integer = word in TYPES and not word.startswith(("time", "f")) or key == "default"
            wanted = data(word, int(stated)) if stated is not None and integer else None
            self.same(f"{at}: {key}", text(element), wanted)
        if word == "string":
            self.same(f"{at}: default", text("DefaultString"), value(entry, "default_text"))
        self.unit(at, text("Unit"), value(entry, "unit"))
        table = value(entry, "values")
        rows = [v for e in self.model["enums"] if e["name"] == table for v in e["values"]]
        if table is not None:
            wanted = [(int(v["value"]), value(v, "name")) for v in rows if -(2**31) <= int(v["value"]) < 2**32]
            self.same(f"{at}: named values", [(int(n.findtext("Enum")), n.findtext("Text")) for n in names], wanted)

    def unit(self, at, found, wanted):
        """The code of a unit: sign and power of ten, numerator, denominator, and a byte that is 0."""
        if wanted is None or found is None:
            # A factor that is no power of ten has no code.
            factor = None if wanted is None else Fraction(int(wanted["num"]), int(wanted["den"]))
            sizes = [Fraction(size) for quantity, size in UNITS.values() if wanted and quantity == wanted["quantity"]]
            coded = factor is not None and any(factor / size in POWERS for size in sizes or [1])
            self.holds(f"{at}: unit {found}", found is None and not coded)
            return
        power, numerator, denominator, rest = number(found).to_bytes(4, "big")
        self.same(f"{at}: last byte of the unit", rest, 0)
        factor = Fraction(10) ** (power - 256 if power > 127 else power)
        if numerator >= OWN_UNITS:
            self.holds(f"{at}: name of the unit", wanted["base_unit"] in self.units.get(numerator, ()))
        else:
            quantity, size = UNITS.get((numerator, denominator), (None, 0))
            self.same(f"{at}: quantity of the unit", quantity, wanted["quantity"])
            factor *= size
        self.same(f"{at}: size of the unit", factor, Fraction(int(wanted["num"]), int(wanted["den"])))

    def assigned(self, pdos, assignment):
        """Indexes of the PDOs of a direction that are active by default."""
        count = self.default(assignment, 0)
        if count is None:
            return pdos[:1]
        return [index for index in (self.default(assignment, sub) for sub in range(1, count + 1)) if index in pdos]

    def process_data(self):
        """PDOs with their entries, assignment, exclusions; the lengths of SyncManagers."""
        seen = Counter(number(p.findtext("Index")) for p in self.device if p.tag in ("RxPdo", "TxPdo"))
        self.holds("a PDO is listed twice", max(seen.values(), default=1) == 1)
        managers = {m.text: (str(n), m) for n, m in enumerate(self.device.iterfind("Sm"))}
        for element, direction, assignment, manager in (
            ("RxPdo", "rx", 0x1C12, "Outputs"), ("TxPdo", "tx", 0x1C13, "Inputs"),
        ):
            wanted = [p for p in self.model["pdos"] if value(p, "direction") == direction]
            found = self.device.findall(element)
            indexes = [p["index"] for p in wanted]
            self.same(element, [number(p.findtext("Index")) for p in found], indexes)
            active, bits = self.assigned(indexes, assignment), 0
            for pdo, row in zip(found, wanted):
                self.pdo(pdo, row, [i for i in indexes if i != row["index"]])
                self.holds(f"{row['at']}: Sm", (pdo.get("Sm") is not None) == (row["index"] in active))
                if pdo.get("Sm") is not None:
                    self.same(f"{row['at']}: Sm", pdo.get("Sm"), managers[manager][0])
                    bits += row["bits"]
            stated = [m for m in self.model["sync_managers"] if MANAGERS[value(m, "use")] == manager and "size" in m]
            if manager in managers and not stated:
                self.same(f"length of {manager}", number(managers[manager][1].get("DefaultSize")), (bits + 7) // 8)

    def pdo(self, pdo, row, others):
        """A PDO."""
        at = row["at"]
        limit = value(self.model["drive"], "pdos_per_direction")
        excludes = [number(e.text) for e in pdo.iterfind("Exclude")]
        self.same(f"{at}: excludes", excludes, others if limit == 1 else [])
        access = [value(e, "access") for (index, _), e in self.entries.items() if index == row["index"]]
        fixed = not any(word in ("rw", "wo") for word in access)
        self.same(f"{at}: fixed", pdo.get("Fixed"), "1" if fixed else "0")
        entries = pdo.findall("Entry")
        self.holds(f"{at}: no entries", entries)
        found = [(number(e.findtext("Index")), number(e.findtext("SubIndex")), int(e.findtext("BitLen"))) for e in entries]
        self.same(f"{at}: entries", found, [(e["index"], e["sub"], value(e, "bits")) for e in row["entries"]])
        for mapped, (index, sub, _) in zip(entries, found):
            entry = self.entries.get((index, sub))
            if entry is None:
                continue
            word = value(entry, "type")
            self.same(f"{at}: name", mapped.findtext("Name"), value(entry, "name"))
            if word in TYPES:
                self.same(f"{at}: type of an entry", mapped.findtext("DataType"), TYPES[word][0])

    def hardware(self):
        """SyncManagers and FMMUs: as stated where they are, and such as a slave controller takes them."""
        found, stated = self.device.findall("Sm"), self.model["sync_managers"]
        used = []
        if stated:
            self.same("SyncManagers", [m.text for m in found], [MANAGERS[value(m, "use")] for m in stated])
        for manager, row in zip(found, stated or [{}] * len(found)):
            name, size = manager.text, number(manager.get("DefaultSize"))
            start, control = number(manager.get("StartAddress")), number(manager.get("ControlByte"))
            for key, attribute in (
                ("start", "StartAddress"), ("size", "DefaultSize"), ("min_size", "MinSize"), ("max_size", "MaxSize"),
                ("control", "ControlByte"), ("enable", "Enable"),
            ):
                if key in row:
                    self.same(f"{name}: {key}", number(manager.get(attribute)), int(value(row, key)))
            mode = {"MBoxOut": 0b0110, "MBoxIn": 0b0010, "Outputs": 0b0100, "Inputs": 0b0000}[name]
            self.holds(f"{name}: mode and direction", control & 0b1111 == mode)
            self.holds(f"{name}: active without a length", size or manager.get("Enable") == "0")
            end = start + max(size, number(manager.get("MaxSize")) or 0) * (1 if name.startswith("MBox") else 3)
            self.holds(f"{name}: memory", start >= 0x1000 and all(start >= e or end <= s for s, e in used))
            used.append((start, end))
        if self.model["fmmus"]:
            wanted = [FMMUS[value(f, "use")] for f in self.model["fmmus"]]
            self.same("FMMUs", [f.text for f in self.device.iterfind("Fmmu")], wanted)

    def mailbox(self):
        """CoE, start-up, synchronization, EEPROM."""
        coe = self.device.find("Mailbox/CoE")
        for row in self.model["coe"]:
            self.same(row["feature"], coe.get(FEATURES[row["feature"]]), "1" if value(row, "supported") else "0")
        commands = [] if coe is None else coe.findall("InitCmd")
        found = [(c.findtext("Transition"), number(c.findtext("Index")), number(c.findtext("SubIndex")), c.findtext("Data")) for c in commands]
        wanted = []
        for row in self.model["startup"]:
            index, sub = (int(part, 16) for part in value(row, "write").split(":"))
            word = value(self.entries[(index, sub)], "type")
            wanted.append((value(row, "transition"), index, sub, data(word, int(value(row, "value")))))
        self.same("start-up", found, wanted)
        modes = self.device.findall("Dc/OpMode")
        self.same("modes of DC", [m.findtext("Name") for m in modes], [value(m, "name") for m in self.model["dc_modes"]])
        for mode, row in zip(modes, self.model["dc_modes"]):
            activate = {"free run": 0, "sync0": 0x300, "sync0 sync1": 0x700}[value(row, "sync")]
            if "assign_activate" in row:
                activate = value(row, "assign_activate")
            self.same("AssignActivate", number(mode.findtext("AssignActivate")), activate)
        words = {key: bytes.fromhex(self.device.findtext(f"Eeprom/{key}")) for key in ("ConfigData", "BootStrap")}
        self.same("words of the SII", [len(w) for w in words.values()], [14, 8])
        for key, element in (("config", "ConfigData"), ("bootstrap", "BootStrap")):
            stated = value(self.model["ethercat"], key)
            if stated is not None:
                self.same(key, words[element], struct.pack(f"<{len(stated)}H", *stated))

    def messages(self):
        """Alarms: a number for each, texts, causes and remedies."""
        found, alarms = self.device.findall("Profile/DiagMessages/DiagMessage"), self.model["alarms"]
        self.same("messages", [m.findtext("MessageText") for m in found], [value(a, "name") for a in alarms])
        ids = [number(m.findtext("TextId")) for m in found]
        self.holds("a message has the number of another one, or none", len(set(ids)) == len(ids) and 0 not in ids)
        resets = {r.findtext("Enum"): r.findtext("Text") for r in self.device.iterfind("Profile/DiagMessages/DiagReset")}
        words = {"by a fault reset": "resettable", "not by a fault reset": "not resettable"}
        numbers = Counter(value(a, "number") for a in alarms)
        for message, alarm, text_id in zip(found, alarms, ids):
            own = value(alarm, "number")
            self.holds(f"{alarm['key']}: number", text_id == own or numbers[own] > 1 or own == 0)
            for element, key in (("Cause", "causes"), ("Remedy", "remedies")):
                texts = [t.text for t in message.iterfind(f"CauseRemedy/{element}")]
                self.same(f"{alarm['key']}: {key}", texts, [t["value"] for t in alarm[key]])
            reset = words.get(resets.get(message.findtext("Flags/DiagReset")))
            self.same(f"{alarm['key']}: reset", reset, value(alarm, "reset"))


def judge(model, file):
    """What is wrong with the file."""
    try:
        found = Judge(model, file)
    except ElementTree.ParseError as error:
        return [str(error)]
    parts = [found.head, found.data_types, found.dictionary, found.process_data, found.hardware, found.mailbox, found.messages]
    for part in parts:
        part()
    return found.found


def goldens(root):
    """Judges the ESI of every golden case that has one."""
    found, cases = [], sorted((root / "tests/golden").glob("*/out/esi-*.snap.xml"))
    for file in cases:
        model = json.loads((file.parent / "model.snap.json").read_text(encoding="utf-8"))
        found += [f"{file.parents[1].name}: {text}" for text in judge(model, file)]
    print(*found, f"{len(cases)} golden cases: {len(found)} findings", sep="\n")
    return 1 if found or len(cases) < 3 else 0


def main(path, file=None):
    """Judges one file and broken copies of it, or all golden cases below a folder."""
    if file is None:
        return goldens(Path(path))
    model = json.loads(Path(path).read_text(encoding="utf-8"))
    good = controls.run(Path(file), CHANGES, lambda copy: judge(model, copy), encoding="utf-8", newline="\n")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
