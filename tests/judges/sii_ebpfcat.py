"""Lets the EtherCAT master ebpfcat read an SII image. Usage: sii_ebpfcat.py IMAGE

Its own code fetches the EEPROM word by word and parses it; only the wire is replaced. Compared is what it makes of it:
identity, the categories, the SyncManagers, the bits of the PDOs. Broken copies must read differently or not at all.
"""

import asyncio
import sys
from pathlib import Path

import sii

try:
    from ebpfcat.ethercat import Terminal
except ImportError as error:
    Terminal, why = None, error


def terminal(data):
    """A terminal of ebpfcat with this EEPROM."""
    class Virtual(Terminal):
        """Answers with the image, and with FFh behind it."""

        async def _eeprom_read_one(self, start):
            if start > 0x8000:
                raise EOFError("it reads on and on")
            return (data[2 * start:2 * start + 8] + b"\xff" * 8)[:8]

        def has_mailbox(self):
            # Without a mailbox, ebpfcat takes PDOs from the EEPROM.
            return False

    return Virtual(None)


def bits(image, key):
    """Bits of all PDOs of a direction."""
    return sum(entry["bits"] for pdo in image[key] for entry in pdo["entries"])


async def foreign(data):
    """What ebpfcat reads."""
    found = terminal(data)
    await found.read_eeprom()
    found.parse_sync_managers(found.eeprom.get(41, b""))
    try:
        pdos = await found.parse_pdos()
    except (RuntimeError, KeyError):
        # It takes whole bytes only.
        pdos = None
    return {
        "identity": [found.vendorId, found.productCode, found.revisionNo, found.serialNo],
        "categories": sorted(found.eeprom),
        "managers": [found.mbx_out_off, found.mbx_out_sz, found.mbx_in_off, found.mbx_in_sz,
                     found.pdo_out_off, found.pdo_out_sz, found.pdo_in_off, found.pdo_in_sz],
        "pdos": pdos,
    }


def ours(data):
    """The same from the tables."""
    image = sii.read(data)
    of_use = {m["use"]: m for m in image["managers"]}
    managers = [of_use[use][key] if use in of_use else None for use in (1, 2, 3, 4) for key in ("start", "size")]
    return {"identity": image["identity"], "categories": sorted(sii.categories(data)), "managers": managers,
            "pdos": (bits(image, "rx"), bits(image, "tx"))}


def judge(data, wanted=None):
    """Where ebpfcat and the tables differ."""
    try:
        found = asyncio.run(foreign(data))
    except Exception as error:  # Whatever ends it is a finding.
        return [f"ebpfcat ends with {error!r}"]
    wanted = wanted or ours(data)
    return [f"{key}: ebpfcat {found[key]!r}, tables {wanted[key]!r}" for key in wanted
            if found[key] != wanted[key] and not (key == "pdos" and found[key] is None)]


def controls(data):
    """Copies that ebpfcat must read differently. It checks no checksum and no length, so only what it uses is broken."""
    for what, at in (("vendor", 16), ("product", 20), ("revision", 24), ("serial number", 28), ("kind of category", 0x80),
                     ("end marker", len(data) - 2)):
        yield what, data[:at] + bytes([data[at] ^ 1]) + data[at + 1:]


def main(image):
    """Judges an image and its broken copies."""
    if Terminal is None:
        print(f"ebpfcat is not there ({why}): the image is not read by it")
        return 0
    data, name = Path(image).read_bytes(), Path(image).name
    findings, wanted = judge(data), ours(data)
    missed = [what for what, copy in controls(data) if not judge(copy, wanted)]
    for text in findings + [f"the judge accepts a copy with another {what}" for what in missed]:
        print(f"{name}: {text}")
    print(f"{name}: read by ebpfcat, {len(findings)} findings, {len(missed)} broken copies accepted")
    return 1 if findings or missed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
