"""Where to look."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path

PORTS = (5025, 5555, 9221, 2268, 50000, 502)  # of instruments that speak over TCP
DEVICES = ("/dev/serial/by-id/*", "/dev/ttyUSB*", "/dev/ttyACM*", "/dev/usbtmc*")
USB, VISA, MDNS = "usb://", "visa://", "mdns://"  # all that is there
NEEDS = {VISA: "pyvisa_py", MDNS: "zeroconf"}  # each looked at unasked where this is installed


def places(stated: Sequence[str]) -> list[str]:
    """Links to ask: those stated (a link, a device, a host with the usual ports), else all that this computer sees."""
    if stated:
        return [link for place in stated for link in _links(place)]
    devices = sorted({Path(name).resolve() for pattern in DEVICES for name in _glob(pattern)})
    here = [f"usbtmc://{path}" if path.name.startswith("usbtmc") else f"serial://{path}" for path in devices]
    return [*here, USB, *(place for place, module in NEEDS.items() if find_spec(module) is not None)]


def _glob(pattern: str) -> Iterator[Path]:
    return Path("/").glob(pattern.removeprefix("/"))


def _links(place: str) -> list[str]:
    if "://" in place:
        return [place]
    if place.startswith("/"):
        return [f"usbtmc://{place}" if "usbtmc" in place else f"serial://{place}"]
    return [f"{'modbus-tcp' if port == 502 else 'tcp'}://{place}:{port}" for port in PORTS]
