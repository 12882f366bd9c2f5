"""Lets python-canopen judge the EDS of every golden case, dcfchk those with a device type, and the readers of an SII every
image. Usage: golden.py ROOT

Their broken copies are tried on the files of real drives: here a great many shapes of dictionaries are read.
"""

import json
import sys
import tempfile
import xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import eds_canopen
import eds_dcfchk
import sii
import sii_ebpfcat


def findings(case):
    """What the judges have against the EDS of a case, which is copied to a file of its own name."""
    model = json.loads((case / "out/model.snap.json").read_text(encoding="utf-8"))
    found = []
    for snapshot in sorted((case / "out").glob("eds-*.snap.eds")):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / snapshot.name.removeprefix("eds-").replace(".snap", "")
            file.write_bytes(snapshot.read_bytes())
            found += [f"{case.name}: canopen: {text}" for text in eds_canopen.judge(model, file)]
            # dcfchk ends with a stack trace unless there is 1000h, which most of the small cases leave out.
            if any(entry["index"] == 0x1000 for entry in model["objects"]):
                found += [f"{case.name}: dcfchk: {text}" for text in eds_dcfchk.judge(file)]
    return found


def image_findings(case):
    """What the readers of an SII have against the image of a case; `None` where there is no image."""
    image = next(iter((case / "out").glob("sii-*.snap.bin")), None)
    if image is None:
        return None
    model = json.loads((case / "out/model.snap.json").read_text(encoding="utf-8"))
    esi = next(iter((case / "out").glob("esi-*.snap.xml")), None)
    data = image.read_bytes()
    found = sii.judge(data, model, ET.fromstring(esi.read_bytes()) if esi else None)
    found += sii_ebpfcat.judge(data) if sii_ebpfcat.Terminal and not found else []
    return [f"{case.name}: SII: {text}" for text in found]


def main(root):
    """Judges every case; says what was found."""
    cases = sorted(path for path in (Path(root) / "tests/golden").iterdir() if (path / "out").is_dir())
    if len(cases) < 40:
        print(f"only {len(cases)} golden cases found")
        return 1
    with ThreadPoolExecutor() as pool:
        found = [text for texts in pool.map(findings, cases) for text in texts]
    images = [texts for texts in map(image_findings, cases) if texts is not None]
    found += [text for texts in images for text in texts]
    for text in found:
        print(text)
    print(f"{len(cases)} golden cases, {len(images)} with an SII: {len(found)} findings")
    return 1 if found or not images else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
