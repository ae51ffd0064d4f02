"""What a link's URL must state, looked at before any port is opened."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from urllib.parse import parse_qsl, urlsplit

from labcal.bench.links.visa import canonical
from labcal.errors import InputError

SERIAL = ("serial", "modbus-rtu")
NETWORK = ("tcp", "udp", "telnet", "modbus-tcp")
PORTS = {"modbus-tcp": 502, "telnet": 23}  # where none is stated
OTHERS = ("usbtmc", "visa", "can", "daq", "ros", "file", "manual", "emulated")
NUMBERS = {"baud": 1, "bitrate": 1, "gap_ms": 0, "timeout_ms": 1}  # the least of each
CHOICES = {
    "bytesize": ("5", "6", "7", "8"), "parity": ("N", "E", "O", "M", "S"), "stopbits": ("1", "1.5", "2"),
    "rtscts": ("0", "1"), "xonxoff": ("0", "1"), "echo": ("0", "1"),
    "backend": ("py", "ivi"),
}  # fmt: skip
OPTIONS = (*NUMBERS, *CHOICES)
BY_URL = ("socket", "rfc2217", "loop", "hwgrep")  # pyserial's others write a file (spy) or load code (alt)
OVER_NETWORK = ("socket", "rfc2217")  # of these
THEIR_OPTIONS = ("logging", "ign_set_control", "poll_modem", "timeout")


def split(url: str) -> tuple[str, str, dict[str, str]]:
    """Scheme, address and our options of a URL; pyserial's own of a port that it opens by URL stay in its address.

    Raises InputError for a scheme, an option or a port that is none.
    """
    scheme, _, rest = url.partition("://")
    if scheme not in (*SERIAL, *NETWORK, *OTHERS):
        known = ", ".join(f"{s}://" for s in (*SERIAL, *NETWORK, *OTHERS))
        raise InputError(f"link {url!r}: {scheme}:// is none of {known}")
    address, _, query = rest.partition("?")
    pairs = parse_qsl(query, keep_blank_values=True)
    options = {key: value for key, value in pairs if key in OPTIONS}
    foreign = "&".join(f"{key}={value}" for key, value in pairs if key not in OPTIONS)
    _refuse_by_url(url, address, [key for key, _ in pairs if key not in OPTIONS])
    _refuse_values(url, options)
    if scheme in NETWORK:
        place(url, scheme, address)
    if scheme == "visa":
        canonical(address)
    return scheme, address + (f"?{foreign}" if foreign else ""), options


def is_connection(url: str) -> bool:
    """Whether somebody at the other end holds a TCP connection, which may be forgotten there and looks well here."""
    scheme, _, address = url.partition("://")
    return scheme in ("tcp", "telnet", "modbus-tcp") or address.partition("://")[0].lower() in OVER_NETWORK


def place(url: str, scheme: str, address: str) -> tuple[str, int]:
    """Host and port of a network address; "" where it names none. Raises InputError where the port is none."""
    try:
        stated = urlsplit(f"//{address}")
        port = stated.port or PORTS.get(scheme)
    except ValueError as error:
        raise InputError(f"link {url!r}: its port is no number from 1 to 65535") from error
    if port is None:
        raise InputError(f"link {url!r} states no port")
    return stated.hostname or "", port


def _refuse_by_url(url: str, address: str, foreign: Sequence[str]) -> None:
    """Of the ports that pyserial opens by URL only those that reach an instrument, and nothing else on the way."""
    by_url = "://" in address
    if by_url and (kind := address.partition("://")[0]).lower() not in BY_URL:
        known = ", ".join(f"{known}://" for known in BY_URL)
        raise InputError(f"link {url!r}: {kind}:// is none of {known}")
    for key in foreign:
        if not by_url or key not in THEIR_OPTIONS:
            raise InputError(f"link {url!r}: {key} is none of {', '.join(OPTIONS)}")


def _refuse_values(url: str, options: Mapping[str, str]) -> None:
    for key, value in options.items():
        if key in CHOICES and value not in CHOICES[key]:
            raise InputError(f"link {url!r}: {key}={value} is none of {', '.join(CHOICES[key])}")
        if key in NUMBERS and not (value.isascii() and value.isdigit() and int(value) >= NUMBERS[key]):
            what = {"baud": "baud rate", "bitrate": "bit rate"}.get(key) or "number of milliseconds"
            raise InputError(f"link {url!r}: {key}={value} is no {what}")
