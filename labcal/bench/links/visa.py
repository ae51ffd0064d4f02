"""visa:// an instrument that VISA reaches: GPIB, USBTMC, VXI-11, HiSLIP; through pyvisa, with pyvisa-py."""

from __future__ import annotations

import errno
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from typing import Any

from labcal.bench.links.messages import TIMEOUT_S, Replies
from labcal.errors import InputError

OPEN_S, STATUS_S = 5.0, 0.1
KINDS = ("GPIB", "TCPIP", "USB", "VXI")
HOW = "visa:// needs pyvisa; install it: pip install 'labcal[visa]' (GPIB and USBTMC: docs/bench.md)"
LOST = (errno.ENXIO, errno.ECONNRESET, errno.EPIPE, errno.ENOTCONN, errno.EBADF)
GONE = ("VI_ERROR_CONN_LOST", "VI_ERROR_RSRC_NFOUND", "VI_ERROR_INV_OBJECT", "VI_ERROR_NLISTENERS")


def canonical(address: str) -> str:
    """The resource's name with what may be left out: its board, 0, and its class, INSTR. What names the instrument
    stays as it is spelt, for it may know its own name in these letters alone.

    Raises InputError for what is none, and for a serial line or a raw socket, which have links of their own: pyvisa-py
    waits for ever for a socket whose other end has hung up.
    """
    kind, *parts = address.split("::")
    found = re.fullmatch(r"([A-Z]+)(\d*)", kind.upper())
    if found and found[1] == "ASRL":
        raise InputError(f"link 'visa://{address}': a serial line is serial://… (docs/bench.md)")
    if not found or found[1] not in KINDS or not parts or not all(parts):
        known = ", ".join(f"{one}…::…" for one in KINDS)
        raise InputError(f"link 'visa://{address}': is no VISA resource such as {known}")
    if parts[-1].upper() == "SOCKET":
        raise InputError(f"link 'visa://{address}': a raw socket is tcp://HOST:PORT (docs/bench.md)")
    named = parts[:-1] if parts[-1].upper() == "INSTR" else parts
    return "::".join([f"{found[1]}{found[2] or 0}", *named, "INSTR"])


def resources(backend: str = "py") -> list[str]:
    """Links of all that VISA sees: GPIB, USB, and what answers its call on the network; none where it cannot look.

    Raises InputError without pyvisa.
    """
    try:
        manager = import_module("pyvisa").ResourceManager(f"@{backend}")
    except (ImportError, OSError, ValueError) as error:
        raise InputError(HOW) from error
    with warnings.catch_warnings(), suppress(Exception):  # each backend fails in its own way where it lacks something
        warnings.simplefilter("ignore")
        return [f"visa://{name}" for name in manager.list_resources("?*") if _is_ours(name)]
    return []


def _is_ours(name: str) -> bool:
    """Whether it is an instrument, and neither a serial line nor a raw socket."""
    with suppress(InputError):
        return bool(canonical(name)) and name.upper().endswith("::INSTR")
    return False


class VisaPort:
    """Messages, not bytes: one write is one message, and a reply is read only after a message that asks for it."""

    byte_s = 0.0

    def __init__(self, address: str, options: dict[str, str]) -> None:
        resource, self._replies = canonical(address), Replies(self)
        try:
            self._visa: Any = import_module("pyvisa")
            manager = self._visa.ResourceManager(f"@{options.get('backend', 'py')}")
        except (ImportError, OSError, ValueError) as error:
            raise InputError(f"link 'visa://{address}': {HOW}") from error
        self._port = self._opened(manager, resource)
        self._port.timeout = 1000 * TIMEOUT_S

    def read(self) -> bytes:
        """The reply that was asked for, once it is there. Raises OSError when the instrument is gone."""
        return self._replies.look()

    def write(self, data: bytes) -> None:
        """One message, which asks for a reply where it has a question mark."""
        with self._errors():
            self._port.write_raw(data)
        self._replies.written(data)

    def status_byte(self) -> int | None:
        """By serial poll, or as the bus does it; None where it cannot, and where the instrument does not answer."""
        self._port.timeout = 1000 * STATUS_S
        try:
            with self._errors():
                return int(self._port.read_stb())
        except OSError as error:
            if error.errno in LOST:
                raise
            return None
        finally:
            self._port.timeout = 1000 * TIMEOUT_S

    def read_message(self) -> bytes:
        """One reply; b"" where none came in time."""
        with self._errors(), suppress(TimeoutError):
            return self._read_raw()
        return b""

    def drop_reply(self) -> None:
        """A device clear, where the backend has one."""
        with suppress(OSError), self._errors():
            self._port.clear()

    def there(self) -> bool:
        """It is, unless an error says otherwise."""
        return True

    def close(self) -> None:
        """Let go."""
        with suppress(OSError), self._errors():
            self._port.close()

    def _read_raw(self) -> bytes:
        try:
            return bytes(self._port.read_raw())
        except self._visa.errors.VisaIOError as error:
            if error.abbreviation == "VI_ERROR_TMO":
                raise TimeoutError from error
            raise

    @contextmanager
    def _errors(self) -> Iterator[None]:
        """What goes wrong on the bus, as OSError: pyvisa-py raises what it happens upon where a connection is gone."""
        try:
            yield
        except OSError:
            raise
        except self._visa.errors.VisaIOError as error:
            raise _as_os_error(error) from error
        except Exception as error:
            lacks = isinstance(error, NotImplementedError | AttributeError)  # how backends say that they lack it
            raise OSError(errno.EIO if lacks else errno.ECONNRESET, f"{type(error).__name__}: {error}") from error

    def _opened(self, manager: Any, resource: str) -> Any:
        try:
            return manager.open_resource(resource, open_timeout=round(1000 * OPEN_S))
        except self._visa.errors.VisaIOError as error:
            raise _as_os_error(error) from error
        except OSError:
            raise
        except Exception as error:  # a backend that lacks what this kind needs says so in many ways
            raise InputError(f"link 'visa://{resource}': {error}") from error


def _as_os_error(error: Any) -> OSError:
    number = errno.ENXIO if error.abbreviation in GONE else errno.EIO
    return OSError(number, f"{error.abbreviation}: {error.description}")
