"""An EA PS 2042-10 B: takes set-points under remote control alone, counts in shares of 42 V and 10 A."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from drivers.emulators.line import Lab, Replies
from drivers.framing import ea_telegram as ea

VOLTS, AMPS, WATTS, REPLY_S = 42.0, 10.0, 160.0, 0.005
TEXTS = {ea.TYPE: b"PS 2042-10B", ea.MAKER: b"EA-Elektro-Automatik"[:15], ea.VERSION: b"V3.04 09.06.11"}
SETS, MOST_TRIP = (ea.SET_VOLTAGE, ea.SET_CURRENT), round(1.1 * ea.FULL)
MOST = dict.fromkeys(SETS, ea.FULL) | {ea.OVP: MOST_TRIP, ea.OCP: MOST_TRIP}  # counts
NOMINAL = {ea.VOLTS: VOLTS, ea.AMPS: AMPS, ea.WATTS: WATTS}
BITS = {0x10: "remote", 0x01: "on"}


@dataclass
class Output:
    """One output and the coil behind it; `tripped`: bits 4 to 7 of its state."""

    coil: Any
    held: dict[int, int] = field(default_factory=lambda: MOST | dict.fromkeys(SETS, 0))
    state: dict[str, bool] = field(default_factory=lambda: {"remote": False, "on": False})
    tripped: int = 0

    def act(self, t_s: float) -> None:
        """Drive the coil, unless a set-point is above its protection, which ends the output."""
        for bit, number, most in ((0, ea.SET_VOLTAGE, ea.OVP), (1, ea.SET_CURRENT, ea.OCP)):
            if self.state["on"] and self.held[number] > self.held[most]:
                self.tripped, self.state["on"] = 1 << bit, False
        amps, volts = self.held[ea.SET_CURRENT] / ea.FULL * AMPS, self.held[ea.SET_VOLTAGE] / ea.FULL * VOLTS
        self.coil.drive(t_s, amps, volts, self.state["on"])


class EaPs2000BEmulator(Replies):
    """Takes a telegram whole or in parts; what begins none is passed over, a wrong sum is refused (3)."""

    baud, usb = 115200, True

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        alone = settings.channel if len(roles) == 1 else 1
        self.outputs = {int(s.get("channel", alone)) - 1: Output(lab.coils[role[-1]]) for role, s in roles.items()}
        self._came, first = b"", min(roles)
        self._texts = TEXTS | {ea.SERIAL: f"28{ord(first[-1])}30001".encode()}

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host."""
        self._came += data
        while self._came:
            start = self._came[0]
            length = ea.HEAD + ea.SUM + ((start & 0x0F) + 1 if start >= ea.SEND else 0)
            if start & 0xF0 not in (ea.SEND, ea.QUERY):
                self._came = self._came[1:]
                continue
            if len(self._came) < length:
                return
            whole, self._came = self._came[:length], self._came[length:]
            number, said = self._answer(t_s, whole)
            self.say(t_s + REPLY_S, ea.telegram(ea.ANSWER, whole[1], number, said))

    def _answer(self, t_s: float, whole: bytes) -> tuple[int, bytes]:
        """Object and data of the answer; an error number as object FFh."""
        if sum(whole[: -ea.SUM]).to_bytes(ea.SUM, "big") != whole[-ea.SUM :]:
            return ea.ERROR, b"\3"
        number, data = whole[2], whole[ea.HEAD : -ea.SUM]
        if (output := self.outputs.get(whole[1])) is None:
            return ea.ERROR, b"\5"
        if data:
            return ea.ERROR, bytes([_execute(output, t_s, number, data)])
        said = self._object(output, t_s, number)
        return (number, said) if said else (ea.ERROR, b"\7")

    def _object(self, output: Output, t_s: float, number: int) -> bytes:
        if number in self._texts:
            return self._texts[number] + b"\0"
        if number in NOMINAL:
            return struct.pack(">f", NOMINAL[number])
        if number in MOST:
            return output.held[number].to_bytes(2, "big")
        if number != ea.STATE:
            return b""
        current = output.coil.current.now(t_s)
        shares = current * output.coil.resistance_ohm / VOLTS, current / AMPS
        counts = [max(0, min(0xFFFF, round(share * ea.FULL))) for share in shares]
        state = output.state["on"] | 0b100 | output.tripped << 4
        return struct.pack(">BBHH", output.state["remote"], state, *counts)

    def trip(self, t_s: float, bit: int) -> None:
        """A protection ends its first output."""
        output = next(iter(self.outputs.values()))
        output.tripped, output.state["on"] = 1 << bit - 4, False
        output.act(t_s)


def _execute(output: Output, t_s: float, number: int, data: bytes) -> int:
    """0, or why it refuses."""
    if number not in (*MOST, ea.CONTROL):
        return 7
    if len(data) != 2:
        return 8
    taking_over = number == ea.CONTROL and data[0] == 0x10
    if not output.state["remote"] and not taking_over:
        return 9
    if number == ea.CONTROL:
        if data[0] not in BITS:
            return 7
        output.state[BITS[data[0]]] = bool(data[1]) and not (data[0] == 1 and output.tripped)
    elif (counts := int.from_bytes(data, "big")) > MOST[number]:
        return 0x30
    else:
        output.held[number] = counts
    output.act(t_s)
    return 0
