"""What is plugged into this computer's USB, by the numbers of maker and model, which no device need be asked for."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

DEVICES = Path("/sys/bus/usb/devices")  # Linux'


@dataclass(frozen=True, slots=True)
class Plugged:
    """A device on USB: `port` is the serial port that it is, "" where it is none; `words` are its own, or ""."""

    vendor: int
    product: int
    words: str = ""
    port: str = ""


def serial_ports() -> list[Plugged]:
    """The serial ports that are devices on USB."""
    from serial.tools.list_ports import comports

    return [
        Plugged(one.vid, one.pid or 0, printable(one.product or ""), one.device)
        for one in comports()
        if one.vid is not None
    ]


def usb_devices() -> list[Plugged]:
    """All devices on USB, as Linux lists them; none elsewhere."""
    return [found for folder in sorted(DEVICES.glob("*")) if (found := _read(folder)) is not None]


def _read(folder: Path) -> Plugged | None:
    """One device; None where the folder is a part of one, or is being unplugged."""
    with suppress(OSError, ValueError):
        vendor, product = (int((folder / name).read_text(), 16) for name in ("idVendor", "idProduct"))
        words = folder / "product"
        return Plugged(vendor, product, printable(words.read_text()) if words.exists() else "")
    return None


def printable(words: str) -> str:
    """What a device says of itself, without what is not seen."""
    return "".join(letter for letter in words if letter.isprintable())[:80]
