"""Makers' and models' numbers on USB, for what does not answer: which driver it most likely needs."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.bench.find.questions import Found
from labcal.bench.links.plugged import Plugged

ANY = -1


@dataclass(frozen=True, slots=True)
class KnownUsb:
    """What has these numbers; `link` where it is no serial port."""

    what: str
    driver: str = ""
    kind: str = ""
    link: str = ""


KNOWN = {
    (0x0403, 0xFAF0): KnownUsb("a Thorlabs APT controller", "thorlabs-apt", "platform"),
    (0x0416, 0x5011): KnownUsb("a Korad's port (or a printer's)", "korad-ka3005p", "coil"),
    (0x103E, ANY): KnownUsb("an Aim-TTi", "tti-pl", "coil"),
    (0x1A72, ANY): KnownUsb("a controller of Physik Instrumente", "pi-gcs2", "platform"),
    (0x1BFA, 0x0498): KnownUsb("a Metrolab THM1176", "metrolab", "reference"),
    (0x1CBE, 0x0007): KnownUsb("a Standa 8SMC", "standa-8smc5", "platform"),
    (0x232E, ANY): KnownUsb("a supply of EA (PS 2000 B: odd parity)", "ea-ps2000b", "coil"),
    (0x2939, ANY): KnownUsb("a Zaber", "zaber", "platform"),
    (0x2A3C, ANY): KnownUsb("a module of Trinamic", "trinamic-tmcl", "platform"),
    (0x0CD5, 0x0006): KnownUsb("a LabJack U6", "daq-inputs", "reference", "daq://u6"),
    (0x0CD5, 0x0007): KnownUsb(
        "a LabJack T7, read over its network port", "labjack-t7", "reference", "modbus-tcp://HOST:502"
    ),
    (0x3923, ANY): KnownUsb("a device of National Instruments", "daq-inputs", "reference", "daq://ni/Dev1"),
    (0x2341, ANY): KnownUsb("an Arduino", "microcontroller", "coil"),
    (0x2E8A, ANY): KnownUsb("a Raspberry Pi Pico", "microcontroller", "coil"),
    (0x0403, ANY): KnownUsb("an FTDI adapter"),
    (0x067B, ANY): KnownUsb("a Prolific adapter"),
    (0x10C4, 0xEA60): KnownUsb("a CP210x adapter"),
    (0x1A86, ANY): KnownUsb("a CH340 adapter"),
}


def known(device: Plugged) -> KnownUsb | None:
    """What has its numbers, the model's before the maker's."""
    return KNOWN.get((device.vendor, device.product)) or KNOWN.get((device.vendor, ANY))


def silent(link: str, device: Plugged) -> Found:
    """A port on USB behind which nobody answers."""
    one = known(device) or KnownUsb("a device that is not known")
    return Found(link, f"{_numbers(device)}: {one.what}; nobody answered", one.driver, one.kind)


def no_port(device: Plugged) -> Found | None:
    """A device on USB that is no port, if one of an instrument's; it is asked nothing."""
    if (one := known(device)) is None or not one.link:
        return None
    return Found(one.link, f"{_numbers(device)}: {one.what}; not asked", one.driver, one.kind)


def _numbers(device: Plugged) -> str:
    words = f" {device.words}" if device.words else ""
    return f"USB {device.vendor:04x}:{device.product:04x}{words}"
