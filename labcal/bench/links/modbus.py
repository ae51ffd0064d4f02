"""Modbus: pymodbus' client and frames over one of our byte lines, so that a late reply can never answer the next."""

from __future__ import annotations

import logging
import struct
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from pymodbus.client.base import ModbusBaseSyncClient
from pymodbus.exceptions import ModbusException
from pymodbus.framer import FramerType
from pymodbus.pdu.bit_message import WriteSingleCoilRequest
from pymodbus.transport import CommParams, CommType

from labcal.bench.clock import Clock
from labcal.bench.links.heard_before import MODBUS, heard, remedy
from labcal.bench.links.line import LONGEST, Link, babbles, wait_for_quiet
from labcal.bench.links.urls import split
from labcal.errors import WHAT_TO_DO, InstrumentError

logging.getLogger("pymodbus.logging").setLevel(logging.CRITICAL)  # all that it would say on stderr is raised as well
T = TypeVar("T")
REPLY_S, FRAME_GAP_S = 0.1, 0.005  # by then a healthy device has answered; and its frame has ended
NUMBERED_QUIET_S = 0.05
UNANSWERED = {"no_response_expected": True}
EXCEPTIONS = {
    1: ": it does not know the function",
    2: ": it does not know the address",
    3: ": it does not take the value",
    4: ": it could not do it",
    6: ": it is busy",
    7: ": no access",
    0x17: ": it is in LOCAL mode, free it on its panel",  # Elektro-Automatik's own
}


class ModbusLink:
    """One Modbus master on one line; several devices on it share this object.

    After any timeout the line is read until it has been quiet for `quiet_s` (longer than the slowest reply), so that
    a late reply is dropped and not taken for the answer to the next request; RTU frames carry no transaction id.
    Nothing is ever sent twice by this class.
    """

    def __init__(
        self, line: Link, clock: Clock, *, framer: str = "rtu", timeout_s: float = 0.6, quiet_s: float = 0.5
    ) -> None:
        self.url, self.emulated, self._line, self._clock, self._quiet_s = line.url, line.emulated, line, clock, quiet_s
        self._client = _LineClient(line, clock, FramerType(framer), timeout_s)
        self._owed_s = list[
            float
        ]()  # when each was sent whose reply may still come, where it was given up or not waited for

    def read_coils(self, device: int, address: int, count: int) -> list[bool]:
        """FC 01. Raises InstrumentError: silent, or refused by the device."""
        reply = self._ask(device, 1, lambda: self._client.read_coils(address, count=count, device_id=device))
        return list(reply.bits[:count])

    def read_holding(self, device: int, address: int, count: int) -> list[int]:
        """FC 03: `count` 16-bit registers from the zero-based `address`."""
        ask = self._client.read_holding_registers
        return self._words(device, self._ask(device, 3, lambda: ask(address, count=count, device_id=device)), count)

    def read_input(self, device: int, address: int, count: int) -> list[int]:
        """FC 04."""
        ask = self._client.read_input_registers
        return self._words(device, self._ask(device, 4, lambda: ask(address, count=count, device_id=device)), count)

    def write_coil(self, device: int, address: int, on: bool) -> None:
        """FC 05: on or off, never a toggle."""
        self._ask(device, 5, lambda: self._client.write_coil(address, on, device_id=device), address)

    def pulse(self, device: int, address: int, value: int) -> None:
        """FC 05 with a number where on or off stands: some boards take a time so."""
        request = _Pulse(address=address, bits=[True], dev_id=device)
        request.value = value
        self._ask(device, 5, lambda: self._client.execute(False, request), address)

    def write_register(self, device: int, address: int, value: int) -> None:
        """FC 06."""
        self._ask(device, 6, lambda: self._client.write_register(address, value, device_id=device), address)

    def write_registers(self, device: int, address: int, values: Sequence[int]) -> None:
        """FC 16."""
        self._ask(device, 16, lambda: self._client.write_registers(address, list(values), device_id=device), address)

    def write_register_unacknowledged(self, device: int, address: int, value: int) -> None:
        """FC 06; what comes back within the time of a healthy reply is dropped, and nothing coming is no fault."""
        self._unanswered(lambda: self._client.write_register(address, value, device_id=device, **UNANSWERED))

    def write_coil_unacknowledged(self, device: int, address: int, on: bool) -> None:
        """FC 05, likewise."""
        self._unanswered(lambda: self._client.write_coil(address, on, device_id=device, **UNANSWERED))

    def close(self) -> None:
        """Let go of the line."""
        self._line.close()

    def _unanswered(self, request: Callable[[], Any]) -> None:
        """On a pair of wires the next request must not collide with the reply to this one."""
        self._drop_owed(REPLY_S)
        self._owed_s.append(self._clock.now())
        request()
        self._drop_owed(REPLY_S)

    def _drop_owed(self, wait_s: float) -> None:
        """Drop the replies to what was sent before, each as far as it comes within `wait_s` of the last of these."""
        came = False
        while self._owed_s and (left_s := self._owed_s[-1] + wait_s - self._clock.now()) > 0:
            pieces = self._line.receive(self._clock.now() + min(left_s, FRAME_GAP_S))
            if came and not pieces:
                del self._owed_s[0]
            came = bool(pieces)

    def _ask(self, device: int, function: int, request: Callable[[], Any], written: int | None = None) -> Any:
        """The reply, if it is one to this function and, of a write, to this address."""
        self._drop_owed(self._quiet_s)
        self._owed_s = [self._clock.now()]
        try:
            reply = request()
        except ModbusException as error:
            self._owed_s.clear()
            self._wait_for_quiet()
            raise InstrumentError(
                f"{self._called(device)}: no valid Modbus reply.",
                fault="silent",
                remedy=remedy(MODBUS, self.url, device),
            ) from error
        self._owed_s.clear()
        heard(self.url, device)
        if reply.isError():
            raise InstrumentError(
                f"{self._called(device)}: the device refused with Modbus exception {reply.exception_code}"
                f"{EXCEPTIONS.get(reply.exception_code, '')}.",
                fault="refused",
            )
        if reply.function_code != function or (written is not None and reply.address != written):
            self._wait_for_quiet()
            what = f"{self._called(device)}: the reply belongs to another request."
            raise InstrumentError(what, fault="wrong reply", remedy=WHAT_TO_DO["out of step"])
        return reply

    def _words(self, device: int, reply: Any, count: int) -> list[int]:
        if len(reply.registers) != count:
            self._wait_for_quiet()
            raise InstrumentError(
                f"{self._called(device)}: {len(reply.registers)} registers came where {count} were asked for.",
                fault="wrong reply",
            )
        return list(reply.registers)

    def _called(self, device: int) -> str:
        """One of the devices on this line, whose URL may be that of another's name."""
        return f"address {device} on {self.url}"

    def _wait_for_quiet(self) -> None:
        wait_for_quiet(self._line, self._clock, self._quiet_s)


class _Pulse(WriteSingleCoilRequest):
    """A write of one coil with any value, which pymodbus itself turns into on or off."""

    value = 0

    def encode(self) -> bytes:
        return struct.pack(">HH", self.address, self.value)


class _LineClient(ModbusBaseSyncClient):
    """pymodbus' synchronous client on a Link."""

    def __init__(self, line: Link, clock: Clock, framer: FramerType, timeout_s: float) -> None:
        params = CommParams(comm_type=CommType.SERIAL, host=line.url, comm_name="labcal", timeout_connect=timeout_s)
        super().__init__(framer, 0, params, None, None, None)
        self._line, self._clock, self._timeout_s, self._deadline_s = line, clock, timeout_s, 0.0
        self._looked = False  # when the time was up
        self._came = 0  # bytes since the request

    def connect(self) -> bool:
        return True

    def is_socket_open(self) -> bool:
        return True

    def send(self, request: bytes, addr: tuple[Any, ...] | None = None) -> int:
        self._line.flush()
        self._line.send(request)
        self._deadline_s, self._looked, self._came = self._clock.now() + self._timeout_s, False, 0
        return len(request)

    def recv(self, size: int | None) -> bytes:
        """What comes next; nothing when the time is up. Raises InstrumentError (babbles) for more than a reply."""
        while not self._looked:
            self._looked = self._clock.now() >= self._deadline_s
            pieces = self._line.receive(min(self._deadline_s, self._clock.now() + 0.001))
            if data := b"".join(data for _, data in pieces):
                self._came += len(data)
                if self._came > LONGEST:
                    raise babbles(self._line.url, data)
                return data
        return b""


def modbus_link(line: Link, clock: Clock) -> ModbusLink:
    """The Modbus master on an open line: RTU frames, but for modbus-tcp://; `timeout_ms` in its URL, 600 if not."""
    scheme, _, options = split(line.url)
    timeout_s = int(options.get("timeout_ms", "600")) / 1000
    if scheme == "modbus-tcp":  # its replies are numbered: a late one is distinguished from the next
        return ModbusLink(line, clock, framer="socket", timeout_s=timeout_s, quiet_s=NUMBERED_QUIET_S)
    return ModbusLink(line, clock, timeout_s=timeout_s)
