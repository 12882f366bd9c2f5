"""Lets dcfchk, python-canopen and dcfgen judge the configurations of tests/configurations. Usage: configurations.py ROOT

dcfchk must be content with each DCF. python-canopen must read from it the values of the concise DCF. dcfgen must take
each DCF as that of a slave, and, given the EDS of the drive and what the TOML file says, must come to the same writes.
Every one of them is then shown broken copies.
"""

import json
import re
import struct
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

import canopen
import yaml

import controls
import eds_dcfchk

try:
    import tomllib
except ImportError:  # before Python 3.11
    import tomli as tomllib

DCFGEN = [sys.executable, "-m", "dcfgen.cli"]
OFF, NO_RTR = 1 << 31, 1 << 30
# dcfgen 2.4.2 writes four bytes for the three of these and says three, which nobody can read.
UNWRITTEN = {0x10, 0x16}

CHECKED = [
    ("value", r"^(ParameterValue=0x\w*)\w$", r"\g<1>x"),
    ("value of a signed type", r"^(ParameterValue=-?\d*)\d$", r"\g<1>x"),
    ("key of a value", r"^ParameterValue=", "ParameterValux="),
    ("key of the node", r"^NodeID=", "NodeIx="),
    ("key of the last EDS", r"^LastEDS=", "LastEDx="),
    ("count of sub-indexes", r"^(SubNumber=\d*)(\d)$", controls.other_digit),
]
READ = [
    ("value", r"^(ParameterValue=0x\w*)(\d)$", controls.other_digit),
    ("key of a value", r"^ParameterValue=", "ParameterValux="),
    ("node", r"^(NodeID=\d*)(\d)$", controls.other_digit),
    ("sub-index", r"^(\[\w{4}sub)1(?=\][^\[]*^ParameterValue)", r"\g<1>9"),
    ("index", r"^(\[\w{3})\w(?=(sub\w+)?\][^\[]*^ParameterValue)", r"\g<1>F"),
    ("type", r"^(DataType=0x000)\d(?=[^\[]*^ParameterValue)", r"\g<1>9"),
]


def writes(data):
    """The writes of a concise DCF: [(index, sub, bytes, value)]."""
    (count,), place, found = struct.unpack_from("<L", data), 4, []
    for _ in range(count):
        index, sub, size = struct.unpack_from("<HBL", data, place)
        value = data[place + 7 : place + 7 + size]
        if len(value) != size:
            raise ValueError("it ends within a write")
        found.append((index, sub, size, int.from_bytes(value, "little")))
        place += 7 + size
    if place != len(data):
        raise ValueError(f"{len(data) - place} bytes follow the last write")
    return found


def final(found):
    """What the written objects hold in the end."""
    return {(index, sub): (size, value) for index, sub, size, value in found}


def member(dictionary, index, sub):
    """The variable of a dictionary at an address."""
    found = dictionary[index]
    return found if isinstance(found, canopen.objectdictionary.ODVariable) else found[sub]


def read_findings(configuration, wanted, path):
    """What python-canopen reads from a DCF otherwise than the concise DCF and the configuration say."""
    try:
        dictionary = canopen.import_od(str(path))
    except Exception as error:  # Whatever stops the reader is a finding.
        return [f"python-canopen cannot read it: {error!r}"]
    findings = []
    if dictionary.node_id != configuration["node_id"]:
        findings.append(f"node {dictionary.node_id}, not {configuration['node_id']}")
    rate = configuration.get("baudrate")
    if (dictionary.bitrate or None) != (rate and rate * 1000):
        findings.append(f"bit rate {dictionary.bitrate}, not {rate} kbit/s")
    for (index, sub), (size, value) in wanted.items():
        try:
            variable = member(dictionary, index, sub)
            there = variable.value
            raw = there if isinstance(there, int) else None
        except (KeyError, AttributeError):
            raw = None
        if raw is None or raw % (1 << 8 * size) != value or variable.data_type not in range(1, 0x1C):
            findings.append(f"{index:04X}:{sub:02X} is {raw}, not {value}")
    return findings


def dcfgen(folder, slave):
    """Runs dcfgen on a bus with one slave: what it says, its writes, and the mapping of the master."""
    bus = {"master": {"node_id": 126}, "drive": slave}
    (folder / "bus.yml").write_text(yaml.safe_dump(bus), encoding="ascii")
    command = [*DCFGEN, "-r", "-d", str(folder), str(folder / "bus.yml")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    says = [line for line in done.stderr.splitlines() if line.strip() and "pkg_resources" not in line]
    if done.returncode:
        return says[-1:] or [f"dcfgen ends with {done.returncode}"], [], {}
    master, list_ = folder / "master.dcf", folder / "drive.bin"
    found = writes(list_.read_bytes()) if list_.exists() else []
    return says, found, mapped(master.read_text(encoding="ascii"))


def mapped(text):
    """The process data of a master: the values below 1400h to 1BFFh, by section."""
    sections = re.findall(r"^\[(1[4-9A-B][0-9A-F]{2}\w*)\]\n(.*?)(?=^\[|\Z)", text, re.MULTILINE | re.DOTALL)
    return {name: re.findall(r"^(?:Parameter|Default)Value=(.*)$", body, re.MULTILINE) for name, body in sections}


def taken_findings(path):
    """What dcfgen has against a DCF as that of a slave."""
    with tempfile.TemporaryDirectory() as folder:
        return dcfgen(Path(folder), {"dcf": str(path)})[0]


def count(value, unit):
    """The raw count of a value of the TOML file; a quantity has the symbol of the unit."""
    if not isinstance(value, str):
        return int(value)
    number, symbol = value.split(" ", 1)
    factor, _, own = unit.rpartition(" ")
    if own != symbol:
        raise ValueError(f"{value} in counts of {unit}")
    return int(Fraction(number) / Fraction(factor or "1"))


def slave_of(configuration, eds, model):
    """The same configuration in dcfgen's words."""
    node = configuration["axis"]["node_id"]
    dictionary = canopen.import_od(str(eds), node_id=node)
    units = {
        (entry["index"], entry["sub"]): (entry.get("unit") or {}).get("value", {}).get("text")
        for obj in model["objects"]
        for entry in obj["entries"]
    }
    pdos = {}
    for row in configuration.get("communication", []):
        pdo = pdos.setdefault(row["map"], {})
        for ours, theirs in [("transmission", "transmission"), ("inhibit", "inhibit_time"), ("event", "event_timer")]:
            if ours in row:
                pdo[theirs] = row[ours]
        default = dictionary[row["map"] - 0x200][1].default or 0
        if row.get("off"):
            # Without the bit, dcfgen would not switch it on and yet map it in the master.
            pdo["cob_id"] = default | OFF
        elif "cob_id" in row:
            # What a user does not set stays: for a TxPDO bit 30.
            pdo["cob_id"] = row["cob_id"] | (default & NO_RTR if row["map"] >= 0x1A00 else 0)
    for row in configuration.get("pdo", []):
        index, sub = (int(part, 16) for part in row["entry"].split(":"))
        pdo = pdos.setdefault(row["map"], {})
        pdo.setdefault("mapping", []).append({"index": index, "sub_index": sub})
    sdo = []
    for row in configuration.get("values", []):
        index, sub = (int(part, 16) for part in row["at"].split(":"))
        if member(dictionary, index, sub).data_type not in UNWRITTEN:
            sdo.append({"index": index, "sub_index": sub, "value": count(row["value"], units[index, sub])})
    part = lambda first: {index - first + 1: pdo for index, pdo in pdos.items() if first <= index < first + 0x200}
    slave = {"dcf": str(eds), "node_id": node, "rpdo": part(0x1600), "tpdo": part(0x1A00), "sdo": sdo}
    return {key: value for key, value in slave.items() if value}, dictionary


def compare(ours, theirs, dictionary):
    """In what two lists of writes differ.

    Ours may hold more where dcfgen leaves out what the drive holds by default. Single values may stand in another order:
    dcfgen knows no rules between them. Those of process data may not.
    """
    of_pdos = lambda found: [write for write in found if 0x1400 <= write[0] < 0x1C00]
    single = lambda found: {write for write in found if not 0x1400 <= write[0] < 0x1C00}
    same = lambda index, sub: member(dictionary, index, sub).data_type not in UNWRITTEN
    here, there = single(ours), single(theirs)
    findings = [f"dcfgen does not write {write}" for write in sorted(here - there) if same(*write[:2])]
    findings += [f"only dcfgen writes {write}" for write in sorted(there - here)]
    rest = of_pdos(theirs)
    for write in of_pdos(ours):
        index, sub, _, value = write
        if rest and rest[0] == write:
            rest.pop(0)
        elif member(dictionary, index, sub).default != value:
            findings.append(f"dcfgen does not write {write} there, but {rest[:1]}")
    return findings + [f"only dcfgen writes {write}" for write in rest]


def same_as_dcfgen(name, configuration, data, dcf, eds, model):
    """Compares our writes with those of dcfgen, and then changed copies of ours."""
    slave, dictionary = slave_of(configuration, eds, model)
    with tempfile.TemporaryDirectory() as folder:
        says, theirs, master = dcfgen(Path(folder), slave)
    with tempfile.TemporaryDirectory() as folder:
        _, _, from_dcf = dcfgen(Path(folder), {"dcf": str(dcf)})
    findings = says + compare(writes(data), theirs, dictionary)
    if master != from_dcf:
        findings.append(f"the master of our DCF maps {from_dcf}, that of our EDS {master}")
    seen, missed = [], []
    for kind, changed in changed_lists(writes(data)):
        (seen if compare(changed, theirs, dictionary) else missed).append(kind)
    findings += [f"a list with {kind} is accepted" for kind in missed]
    for finding in findings:
        print(f"{name}: dcfgen: {finding}")
    print(f"{name}: {len(theirs)} writes of dcfgen, {len(writes(data))} of ours; changed lists refused: {', '.join(seen)}")
    return not findings


def changed_lists(found):
    """Copies of a list of writes, each with one thing changed."""
    index, sub, size, value = found[0]
    yield "another value", [(index, sub, size, value ^ 1), *found[1:]]
    yield "another sub-index", [(index, sub + 1, size, value), *found[1:]]
    yield "another width", [(index, sub, size + 1, value), *found[1:]]
    yield "its first write left out", found[1:]
    yield "a write more", [*found, (0x6083, 0, 4, 7)]
    if len(found) > 8:
        yield "a mapping after its count", [*found[:3], found[6], *found[4:6], found[3], *found[7:]]


def judge(root, source, folder):
    """Everything about one configuration; whether all of it is right."""
    name = source.stem
    configuration = tomllib.loads(source.read_text(encoding="utf-8"))
    out = root / "tests/configurations/out"
    data = (out / f"{name}-concise.snap.bin").read_bytes()
    dcf = folder / f"{name}.dcf"
    dcf.write_bytes((out / f"{name}.snap.dcf").read_bytes())
    wanted = final(writes(data))
    axis = configuration["axis"]
    print(f"{name}: dcfchk")
    right = controls.run(dcf, CHECKED, eds_dcfchk.judge)
    print(f"{name}: python-canopen")
    right &= controls.run(dcf, READ, lambda path: read_findings(axis, wanted, path))
    print(f"{name}: dcfgen")
    right &= controls.run(dcf, CHECKED, taken_findings)
    if axis["drive"] == "sdv3-e":
        print(f"{name}: writes not compared: dcfgen maps PDOs of CANopen only, and the drive is on EtherCAT")
        return right
    case = root / "tests/golden/canopen/out"
    eds = folder / "acme-x1.eds"
    eds.write_bytes((case / "eds-acme-x1.snap.eds").read_bytes())
    model = json.loads((case / "model.snap.json").read_text(encoding="utf-8"))
    return right & same_as_dcfgen(name, configuration, data, dcf, eds, model)


def main(root):
    """Judges every configuration that is right."""
    sources = sorted((root / "tests/configurations/good").glob("*.toml"))
    if len(sources) < 3:
        print(f"only {len(sources)} configurations found")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        right = [judge(root, source, Path(folder)) for source in sources]
    return 0 if all(right) else 1


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
