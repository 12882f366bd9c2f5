"""Lets jsonschema judge profiles and model.json by their schemas. Usage: schemas.py ROOT"""

import copy
import json
import sys
from pathlib import Path

import jsonschema

try:
    import tomllib
except ImportError:  # before Python 3.11
    import tomli as tomllib

# Broken copies of a whole profile: what is changed, and how.
OF_PROFILES = [
    ("key that is missing", lambda p: p["objects"][0].pop("at")),
    ("key that nobody knows", lambda p: p["objects"][0].update(nmae="x")),
    ("word", lambda p: p["objects"][0].update(access="rx")),
    ("type", lambda p: p["objects"][0].update(type="u17")),
    ("address", lambda p: p["objects"][0].update(at="0x6040")),
    ("number", lambda p: p["pdo"][0].update(map=65536)),
    ("kind of value", lambda p: p["objects"][0].update(name=5)),
    ("table", lambda p: p.update(objcets=[])),
    ("text for true or false", lambda p: p["errata"][0].update(unset="true")),
    ("number for true or false", lambda p: p["errata"][0].update(unset=1)),
    ("word of a homing row", lambda p: p["homing"][0].update(status="missing")),
    ("word in a list", lambda p: p["homing"][0].update(mask=["index"])),
    ("mode below what a byte holds", lambda p: p["modes"][0].update(mode=-129)),
    ("address in a list", lambda p: p["modes"][0].update(objects=["6040"])),
    ("mask of a state", lambda p: p["states"][0].update(mask=65536)),
    ("edge of a command", lambda p: p["commands"][0].update(edge="rising")),
    ("code of an abort", lambda p: p["aborts"][0].update(code=-1)),
    ("word of a terminal", lambda p: p["io"][0].update(kind="in")),
    ("word of a SyncManager", lambda p: p["sync_managers"][0].update(use="mailbox")),
    ("length of a SyncManager", lambda p: p["sync_managers"][0].update(size=65536)),
    ("ports", lambda p: p["ethercat"][0].update(physics="X")),
    ("protocol of the mailbox", lambda p: p["ethercat"][0].update(mailbox=["can"])),
    ("word of CoE", lambda p: p["coe"][0].update(feature="sdo")),
    ("word of a DC mode", lambda p: p["dc_modes"][0].update(sync="sync2")),
    ("number of an FMMU", lambda p: p["fmmus"][0].pop("number")),
    ("word of the emergency message", lambda p: p["emcy"][0].update(holds="code")),
    ("occasion of a rule", lambda p: p["rules"][0].update(on="always")),
    ("range of an example", lambda p: p["examples"][0].update(write="1A00:1..2")),
    ("effect of a parameter", lambda p: p["objects"][0].update(effect="now")),
    ("state in which an alarm is found", lambda p: p["alarms"][0].update(esm=["Boot"])),
]


def first_fact(node):
    """The first value that has a class: the shape of every fact."""
    if isinstance(node, dict):
        if "class" in node:
            return node
        node = list(node.values())
    if isinstance(node, list):
        return next(filter(None, map(first_fact, node)), None)
    return None


def first_case(model):
    """The first case of the first homing method that has one."""
    return next(case for method in model["homing"] for case in method["cases"])


OF_MODELS = [
    ("format", lambda m: m.update(format="1")),
    ("table that is missing", lambda m: m.pop("objects")),
    ("table that nobody knows", lambda m: m.update(objcets=[])),
    ("class of a fact", lambda m: first_fact(m).update({"class": "guessed"})),
    ("word of a homing method", lambda m: m["homing"][0]["status"].update(value="missing")),
    ("moves that are missing", lambda m: first_case(m).pop("moves")),
    ("mask of a state", lambda m: m["states"][0]["mask"].update(value=65536)),
    ("word of CoE", lambda m: m["coe"][0].update(feature="sdo")),
    ("side that is missing", lambda m: m.pop("ethercat")),
    ("word of a terminal", lambda m: m["terminals"][0]["kind"].update(value="in")),
    ("dropped value", lambda m: m["errata"][0].update(unset="true")),
]


def findings(schema, value):
    """What is wrong with a value, with the place."""
    validator = jsonschema.Draft7Validator(schema)
    return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in validator.iter_errors(value)]


def judge(name, schema, value, changes):
    """Whether the value fits, and no broken copy of it does."""
    found = findings(schema, value)
    for finding in found:
        print(f"{name}: {finding}")
    missed = []
    for kind, change in changes:
        broken = copy.deepcopy(value)
        change(broken)
        if not findings(schema, broken):
            missed.append(kind)
            print(f"{name}: a copy with another {kind} is accepted")
    print(f"{name}: {len(found)} findings; broken copies refused: {', '.join(k for k, _ in changes if k not in missed)}")
    return not found and not missed


def main(root):
    schemas = {}
    for kind in ("profile", "model"):
        schemas[kind] = json.loads(Path(root, f"codegen/schema/{kind}.schema.json").read_text("utf-8"))
        jsonschema.Draft7Validator.check_schema(schemas[kind])
    good = []
    for drive in sorted(Path(root, "profiles").glob("*/*/drive.toml")):
        tables = {}
        for file in sorted(drive.parent.glob("*.toml")):
            tables.update(tomllib.loads(file.read_text("utf-8")))
        good.append(judge(drive.parent.name, schemas["profile"], tables, OF_PROFILES))
    for model in sorted(Path(root, "generated").glob("*/model.json")):
        good.append(judge(f"{model.parent.name}/model.json", schemas["model"], json.loads(model.read_text("utf-8")), OF_MODELS))
    for model in sorted(Path(root, "tests/golden").glob("*/out/model.snap.json")):
        good.append(judge(model.parent.parent.name, schemas["model"], json.loads(model.read_text("utf-8")), []))
    return 0 if good and all(good) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
