"""What says by itself on the network who it is (mDNS, as LXI has it). Nothing is connected to."""

from __future__ import annotations

import socket
import threading
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from labcal.errors import InputError

SERVICES = {  # LXI Device Specification, on discovery by mDNS; the link of one at this address and port
    "_scpi-raw._tcp.local.": "tcp://{host}:{port}",
    "_hislip._tcp.local.": "visa://TCPIP0::{host}::hislip0::INSTR",
    "_vxi-11._tcp.local.": "visa://TCPIP0::{host}::inst0::INSTR",
    "_lxi._tcp.local.": "http://{host}:{port}",
}
FACTS = ("Manufacturer", "Model", "SerialNumber", "FirmwareVersion")
LISTEN_S = 3.0
MOST, LONGEST = 200, 120
HOW = "mdns:// needs zeroconf; install it: pip install 'labcal[network]'"


@dataclass(frozen=True, slots=True)
class Announced:
    """A service of an instrument: `said` as *IDN? has it, where it tells that, else the name of the service."""

    host: str
    link: str
    said: str


def announced(interface: str = "", seconds: float = LISTEN_S) -> list[Announced]:
    """What answers within this time, one an address: the first of SERVICES that it has.

    `interface`: the address of this computer to look from; "": all. Raises InputError without zeroconf, and for an
    address that is none of this computer.
    """
    try:
        zeroconf: Any = import_module("zeroconf")
    except ImportError as error:
        raise InputError(HOW) from error
    _see_that_it_is_ours(interface)
    try:
        network = zeroconf.Zeroconf(
            interfaces=[interface] if interface else zeroconf.InterfaceChoice.All, ip_version=zeroconf.IPVersion.V4Only
        )
    except (OSError, RuntimeError):  # a computer without a network
        return []
    try:
        listener = _Listener(network, seconds)
        browser = zeroconf.ServiceBrowser(network, list(SERVICES), listener)
        listener.whole.wait(seconds)
        browser.cancel()
        return listener.known()
    finally:
        network.close()


def _see_that_it_is_ours(interface: str) -> None:
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as here:
            here.bind((interface, 0))
    except (OSError, UnicodeError) as error:
        raise InputError(f"mdns://{interface}: state an IPv4 address of this computer, or none ({error})") from error


class _Listener:
    """Keeps the best service of each address."""

    def __init__(self, network: Any, seconds: float) -> None:
        self._network, self._wait_ms = network, round(1000 * seconds)
        self._found: dict[str, tuple[int, Announced]] = {}
        self._lock, self.whole = threading.Lock(), threading.Event()

    def known(self) -> list[Announced]:
        """In the order of their addresses."""
        with self._lock:
            return [one for _, (_, one) in sorted(self._found.items())]

    def add_service(self, zeroconf: Any, kind: str, name: str) -> None:
        """Ask for its address and facts."""
        info = zeroconf.get_service_info(kind, name, self._wait_ms)
        if info is None or not (hosts := info.parsed_addresses()):
            return
        rank = list(SERVICES).index(kind)
        one = Announced(hosts[0], SERVICES[kind].format(host=hosts[0], port=info.port), in_words(info, name))
        with self._lock:
            if len(self._found) < MOST and rank < self._found.get(hosts[0], (len(SERVICES), one))[0]:
                self._found[hosts[0]] = rank, one
            if len(self._found) >= MOST:
                self.whole.set()

    def update_service(self, zeroconf: Any, kind: str, name: str) -> None:
        """What it says anew is not needed."""

    def remove_service(self, zeroconf: Any, kind: str, name: str) -> None:
        """It was there."""


def in_words(info: Any, name: str) -> str:
    """What a service tells of its instrument, as *IDN? has it, or its own name; nothing in it that is not seen."""
    facts = {key.lower(): value or "" for key, value in info.decoded_properties.items()}
    values = [facts.get(key.lower(), "") for key in FACTS]
    words = ",".join(values) if values[1] else name.split("._")[0]
    return "".join(letter if letter.isprintable() else " " for letter in words[:LONGEST])
