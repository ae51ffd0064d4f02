"""AlphaLab MR3 / VGM / VM three-axis milligauss meters on their USB serial line (115200 baud), polled."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from drivers.framing import alphalab
from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.polling import Polled, Polls
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError
from labcal.record.stream import Block

PROPERTIES, SETTINGS, READ, NEXT, END_OF_ALL = 0x01, 0x02, 0x03, 0x08, 0xFF
MORE, LAST, NEXT_S = 0x08, 0x07, 0.05  # it needs that long between two chunks
CHUNK = 64  # letters; one of its own has twenty
NT_PER_MG, NT_PER_G = 100.0, 1e5


@dataclass(frozen=True, slots=True)
class Settings:
    """`rate` in readings per second. `relative`: what a setting's name has in it where it zeroes the reading.

    `nT_per_unit`: of what it sends; 0: what its lists say, or its model (a VGM sends gauss, the others milligauss).
    `magnitude_mG` is how far the sent magnitude may be from that of x, y, z, beside `magnitude_part` of it.
    """

    rate: float = 8.0
    nT_per_unit: NotNegative = 0.0
    full_scale_mG: float = 1999.9
    magnitude_mG: float = 1.0
    magnitude_part: float = 0.01
    relative: str = "REL|ZERO|TARE|NULL|OFFSET"
    off: tuple[str, ...] = ("0", "OFF", "NO", "FALSE", "0.0", "")
    timeout_s: Positive = 0.5

    def __post_init__(self) -> None:
        if not 0 < self.rate <= 10:
            raise ValueError("rate must be above 0 and at most 10 readings a second")


class AlphaLab(Polled):
    """Refuses a meter that shows differences; a reading is good only if its magnitude fits its axes."""

    roles = ("reference",)
    never = (rb"\A[^\x01\x02\x03\x08\xff]",)  # it alters settings, deletes files, resets time: only these are sent

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._polls, self._mishaps = Polls(clock, settings.rate), Mishaps(name)
        self._nT = settings.nT_per_unit or NT_PER_MG

    def identify(self) -> Identity:
        """Read its properties and settings. Raises InstrumentError (wrong mode) where it is zeroed or relative."""
        self._send(END_OF_ALL)
        self._clock.wait_until(self._clock.now() + 0.1)
        self._link.flush()
        about = self._pairs(PROPERTIES)
        words = [v for k, v in about.items() if re.search("MODEL|NAME|TYPE", k)] or ["milligauss meter"]
        serial = [v for k, v in about.items() if re.search("SER|S/N|SN", k)]
        version = [v for k, v in about.items() if re.search("VER|FW|FIRM", k)]
        stated, of_model = self.settings.nT_per_unit, NT_PER_G if words[0].upper().startswith("VGM") else NT_PER_MG
        self._nT = alphalab.unit_nT(self.name, about, stated) or stated or of_model
        self._look_at_settings()
        return Identity("AlphaLab", words[0], "".join(serial[:1]), "".join(version[:1]))

    def start(self) -> None:
        """Look at its settings again, then begin to ask."""
        self._link.flush()
        self._look_at_settings()
        self._polls.start()

    def read_until(self, t_s: float) -> list[Block]:
        """Readings asked for up to `t_s` [nT, its own axes]."""
        good = [(stamp, *taken) for stamp in self._polls.due(t_s) if (taken := self._reading(stamp)) is not None]
        if not good:
            return []
        stamps, values = np.array([g[0] for g in good]), np.array([g[1] for g in good])
        columns, raw = ("ref_x", "ref_y", "ref_z"), b"".join(g[2] for g in good)
        return [Block("reference", self.name, columns, stamps, values * self._nT, raw)]

    def _send(self, code: int) -> None:
        self._link.send(bytes([code, 0, 0, 0, 0, 0]))

    def _reading(self, stamp: float) -> tuple[list[float], bytes] | None:
        """x, y, z as sent, and the frame; None, noted, where it is no good."""
        self._link.flush()  # a block that came twice would answer for ever one question late
        frame = self._link.ask(bytes([READ, 0, 0, 0, 0, 0]), end=alphalab.LENGTH, timeout_s=self.settings.timeout_s)
        mG = NT_PER_MG / self._nT  # in what it sends
        xyz = alphalab.axes(frame, self.settings.magnitude_mG * mG, self.settings.magnitude_part)
        if xyz is None:
            self._mishaps.note("bad frame", stamp)
            self._clock.wait_until(self._clock.now() + 0.05)
            self._link.flush()  # a slip must not shift the next frame
            return None
        if max(map(abs, xyz)) >= self.settings.full_scale_mG * mG:
            raise overloaded(self.name)
        return xyz, frame

    def _pairs(self, code: int) -> dict[str, str]:
        """A reply of `key=value:` in chunks, each ended by 08, the last by 07."""
        self._send(code)
        text = b""
        for _ in range(100):
            chunk = self._chunk()
            text += chunk[:-1]
            if chunk[-1] == LAST:
                pairs = (pair.partition("=") for pair in text.decode("ascii", "replace").split(":") if "=" in pair)
                found = {key.strip(" \0").upper(): value.strip(" \0") for key, _, value in pairs}
                if not found:
                    raise self._another(text)
                return found
            self._clock.wait_until(self._clock.now() + NEXT_S)
            self._send(NEXT)
        raise InstrumentError(f"{self.name}: its list of settings has no end.", fault="wrong reply")

    def _chunk(self) -> bytes:
        chunk = b""
        while not chunk or chunk[-1] not in (MORE, LAST):
            chunk += self._link.ask(b"", end=1, timeout_s=self.settings.timeout_s)
            if len(chunk) > CHUNK or chunk[-1] >= 0x80:
                raise self._another(chunk)
        return chunk

    def _another(self, said: bytes) -> InstrumentError:
        self._link.flush()
        return InstrumentError(f"{self.name}: {quoted(said)} came, no list of an AlphaLab.", fault="another instrument")

    def _look_at_settings(self) -> None:
        settings = self._pairs(SETTINGS)
        self._nT = alphalab.unit_nT(self.name, settings, self.settings.nT_per_unit) or self._nT
        for key, value in settings.items():
            if re.search(self.settings.relative, key) and value.upper() not in self.settings.off:
                raise InstrumentError(
                    f"{self.name}: its setting {key} is {value}: it shows differences, not the field.",
                    fault="wrong mode",
                    remedy="Switch relative and zero off on the meter.",
                )
