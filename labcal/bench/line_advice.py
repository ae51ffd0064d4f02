"""What a serial line should be set to, for where no answer comes, or bytes that make no sense."""

from __future__ import annotations

import re

from labcal.bench.config import InstrumentConfig
from labcal.bench.links.heard_before import PLUG
from labcal.bench.links.urls import SERIAL, split
from labcal.errors import InputError, InstrumentError

LOOKS_WRONG = ("silent", "wrong reply", "another instrument", "babbles")
USUAL = {  # as it leaves its maker, or as labs have it (docs/bench.md); where no baud rate stands, it is one of several
    "ea-ps2000b": "baud=115200&parity=O", "gsm": "baud=9600", "genesys": "baud=9600", "hmr2300": "baud=9600",
    "kepco-bop": "xonxoff=1", "korad-ka3005p": "baud=9600", "microcontroller": "baud=115200",
    "newport-esp301": "baud=19200&rtscts=1", "newport-smc100": "baud=57600&xonxoff=1", "oriental-az": "parity=E",
    "pi-gcs2": "baud=115200", "pos-1": "baud=9600", "riden-rd60xx": "baud=115200",
    "standa-8smc5": "baud=115200&stopbits=2", "thorlabs-apt": "baud=115200&rtscts=1", "trinamic-tmcl": "baud=9600",
    "twinleaf": "baud=115200", "velmex-vxm": "baud=9600", "waveshare-interlock": "baud=9600",
    "waveshare-relay": "baud=9600", "zaber": "baud=115200",
}  # fmt: skip
PLAIN = {"bytesize": "8", "parity": "N", "stopbits": "1", "rtscts": "0", "xonxoff": "0"}


def advised(fault: InstrumentError, entry: InstrumentConfig) -> InstrumentError:
    """The same fault, with how its line is set and how it should be where that may be what is wrong."""
    if fault.fault not in LOOKS_WRONG or fault.remedy == PLUG:
        return fault
    if not (words := advice(entry.driver, entry.link, fault.what)):
        return fault
    return InstrumentError(fault.what, fault=fault.fault, remedy=f"{fault.remedy} {words}".strip())


def advice(driver: str, link: str, came: str = "") -> str:
    """A sentence or two about a serial line; "" for any other link. `came`: the fault's words, with what came."""
    try:
        scheme, address, stated = split(link)
    except InputError:
        return ""
    if scheme not in SERIAL or "://" in address:
        return ""
    here = _settings(stated)
    usual = _settings({"baud": here["baud"]} | _options(USUAL.get(driver, "")))
    words = f"This line is set to {_said(here)}"
    if driver not in USUAL:
        words += ": the instrument must be too"
    elif here == usual:
        words += f", as {driver} has it as a rule; its panel may say otherwise"
    else:
        words += f"; {driver} has {_said(usual)} as a rule"
    return f"{words}.{_of_bytes(came)}"


def _of_bytes(came: str) -> str:
    if re.search(r"\\x[0-9a-f]{2}|[^\x00-\x7f…]", came):
        return " Bytes that are no text come of another baud rate or parity."
    return (
        " What came has no end: another line end (terminator), or a cable that loses bytes." if "only b" in came else ""
    )


def _options(query: str) -> dict[str, str]:
    return dict(pair.split("=") for pair in query.split("&") if pair)


def _settings(stated: dict[str, str]) -> dict[str, str]:
    return {key: stated.get(key, usual) for key, usual in ({"baud": "9600"} | PLAIN).items()}


def _said(line: dict[str, str]) -> str:
    handshake = [key for key in ("rtscts", "xonxoff") if line[key] == "1"]
    frame = f"{line['baud']} baud, {line['bytesize']}{line['parity']}{line['stopbits']}"
    return f"{frame} ({', '.join(f'{key}=1' for key in handshake)})" if handshake else frame
