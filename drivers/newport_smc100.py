"""Newport SMC100CC/PP and CONEX-CC with a rotary stage, ASCII (57600 8N1 XON/XOFF; CONEX: USB 921600)."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.newport import NewportAxis
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.arrival import refuse_fast_homing
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Count, NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

NOT_REFERENCED = range(0x0A, 0x12)
HOMING, MOVING = (0x1E, 0x1F), (0x28,)
READY = range(0x32, 0x36)
DISABLED = range(0x3C, 0x3F)
NO_ERROR = "@"
# what may be asked again, and what its reply is
POLLED = {"TS": "[0-9A-F]{6}", "TP": r"[-+]?(?:\d+\.?\d*|\.\d+)(?:E[-+]?\d+)?"}
ERRORS = {
    "A": "unknown message", "B": "wrong address", "C": "parameter out of range", "D": "not allowed",
    "E": "it homes already", "G": "beyond its range", "H": "it is not referenced", "I": "it is being configured",
    "J": "it is disabled", "K": "not while it is ready", "L": "it homes", "M": "it moves", "N": "beyond a soft limit",
    "S": "time-out", "U": "memory fault", "V": "execution fault", "W": "wrong type", "X": "wrong type",
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class Settings:
    """`tolerance_deg`: how far from its target a finished move may end.

    `tries`: how often its state or position is asked for where the reply comes garbled, as it does now and then.
    """

    address: Annotated[int, Field(ge=1, le=31)] = 1
    tolerance_deg: Positive = 0.02
    max_rate_deg_per_s: Positive = 20.0
    gap_s: NotNegative = 0.06
    timeout_s: Positive = 0.5
    tries: Count = 10


class Smc100Stage:
    """Absolute moves only. Ready is not arrived: state, error bits and position are looked at after every move."""

    roles = ("platform",)
    never = (  # relative moves, configuration (flash), resets, other addresses, jogging
        rb"\d(PR|PW|RS|SA|SE|ZX|JM|DV|FD|FE|KD|KI|KP|KV|OH|OT|QI|SC|SR|SL|SU|AC|BA|BH|HT|ID|JR|OL)[^?]",
    )
    motorised = True

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self.max_rate_deg_per_s = settings.max_rate_deg_per_s
        self._axis, self._free_s = NewportAxis(name, self._command, self._ask, settings.tolerance_deg), 0.0

    def identify(self) -> Identity:
        """Ask for the controller's version and its stage. Raises InstrumentError for another controller."""
        version, stage = self._ask("VE"), self._ask("ID?")
        if not re.search("SMC|CONEX", version, re.IGNORECASE):
            raise InstrumentError(
                f"{self.name}: {quoted(version)} answered, not an SMC100.", fault="another instrument"
            )
        return Identity("Newport", stage, f"address {self.settings.address}", version)

    def home(self, limit_deg_per_s: float = math.inf) -> None:
        """Search the reference where it is not known, as after every power-up. Raises LimitError where that is fast."""
        if self._state() in NOT_REFERENCED:
            if limit_deg_per_s < math.inf:  # its speed stands in flash: asked for, never written
                refuse_fast_homing(self.name, self._axis.number("OH?"), limit_deg_per_s)
            self._axis.target_deg = 0.0
            self._command("OR")

    def move_to(self, angle_deg: float, rate_deg_per_s: float) -> None:
        """Begin an absolute move in the stage's own sense; sent once, never repeated."""
        self._axis.move_to(angle_deg, rate_deg_per_s)

    def moving(self) -> bool:
        """Whether it moves. Raises InstrumentError where it has stopped elsewhere than it should have."""
        state = self._state()
        if state in (*HOMING, *MOVING):
            return True
        if state not in READY:
            raise InstrumentError(
                f"{self.name}: it is {self._words(state)} (state {state:02X}).",
                fault="stage fault",
                remedy="Look at the stage, home it and try again.",
            )
        self._axis.refuse_elsewhere()
        return False

    def angle_deg(self) -> float:
        """The position [deg] in the stage's own sense."""
        return self._axis.angle_deg()

    def state(self) -> tuple[float, bool]:
        """Position [deg] and whether it moves; first the motion, so that a position said to be final is."""
        moving = self._status()[1] in (*HOMING, *MOVING)
        return self.angle_deg(), moving

    def make_safe(self) -> None:
        """Stop; allowed in every state."""
        self._axis.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _state(self) -> int:
        errors, state = self._status()
        if errors:
            raise InstrumentError(f"{self.name}: its positioner reports error {errors:04X}.", fault="stage fault")
        return state

    def _status(self) -> tuple[int, int]:
        reply = self._ask("TS")
        return int(reply[:4], 16), int(reply[4:], 16)

    def _words(self, state: int) -> str:
        return "not referenced" if state in NOT_REFERENCED else "disabled" if state in DISABLED else "not ready"

    def _command(self, words: str) -> None:
        self._send(words)
        code = self._ask("TE")
        if code != NO_ERROR:
            raise InstrumentError(f"{self.name}: {words} failed: {ERRORS.get(code, code)}.", fault="refused")

    def _ask(self, words: str) -> str:
        """The reply without its prefix."""
        form = re.compile(rf"{self.settings.address}{words.removesuffix('?')} *({POLLED.get(words, '.*')}) *", re.ASCII)
        for _ in range(self.settings.tries if words in POLLED else 1):
            self._send(words)
            came = self._link.ask(b"", end=b"\r\n", timeout_s=self.settings.timeout_s).strip(b" \r\n")
            reply = came.decode("ascii", "replace")
            if found := form.fullmatch(reply):
                return found[1].strip(" ")
        raise self._axis.wrong(words, reply)

    def _send(self, words: str) -> None:
        self._clock.wait_until(self._free_s)
        self._link.flush()
        self._link.send(f"{self.settings.address}{words}\r\n".encode())
        self._free_s = self._clock.now() + self.settings.gap_s
