"""Metrolab THM1176 (Hall) and TFM1186 (fluxgate) three-axis magnetometers, SCPI (USB 488.2 in the lab), polled."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.polling import Polled, Polls
from drivers.framing.scpi import Scpi
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Count, Positive
from labcal.bench.links import Link
from labcal.record.stream import Block

VALUE = re.compile(r" *([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?) *([A-Za-zµ]+) *")
NT = {"T": 1e9, "mT": 1e6, "MT": 1e6, "uT": 1e3, "UT": 1e3, "µT": 1e3, "nT": 1.0, "NT": 1.0, "G": 1e5, "mG": 100.0,
      "kG": 1e8}  # fmt: skip
OVERFLOW = 9.9e37
SAMPLE_S = 122e-6  # the fastest that it triggers itself, by its manual: each of those that it averages


@dataclass(frozen=True, slots=True)
class Settings:
    """`range_T`: "" leaves the range of the instrument, "AUTO" lets it choose. `average`: readings to one value.

    `timeout_s`: of replies to settings; a reading is missed after twice its time at `rate`, 0.5 s at least.
    `full_scale_nT` is what counts as overloaded.
    """

    rate: float = 10.0
    average: Count = 100
    range_T: str = ""
    digits: int = 9
    full_scale_nT: float = 100_000.0
    models: str = "THM|TFM"
    timeout_s: Positive = 2.0

    def __post_init__(self) -> None:
        if not 0 < self.rate <= 50 or not 1 <= self.average <= 10_000 or not 1 <= self.digits <= 12:
            raise ValueError("rate is up to 50 a second, average 1 to 10000, digits 1 to 12")
        if self.range_T and not re.fullmatch(r"AUTO|\d+(\.\d+)?", self.range_T):
            raise ValueError('range_T is "", "AUTO" or a number of tesla such as "0.1"')


class Metrolab(Polled):
    """Each reading is triggered, so that none comes twice; its unit is read from the reply, never assumed."""

    roles = ("reference",)
    never = (rb"\*RST", rb"\*SAV", rb"\*RCL", rb":CAL", rb":MEM", rb":FLAS", rb":SYST:(?!ERR)")

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._polls, self._mishaps = Polls(clock, settings.rate), Mishaps(name)
        self._scpi = Scpi(name, link, clock, settings.timeout_s, errors=":SYST:ERR?;*STB?")
        self._reply_s = self._polls.reply_s + 2 * SAMPLE_S * settings.average

    @staticmethod
    def parse_again(settings: Settings, raw: bytes) -> NDArray[np.float64]:
        """The samples (n, 3) of replies as a record keeps them."""
        rows = [[nanotesla(part) for part in reply.split(";")] for reply in raw.decode().splitlines()]
        return np.array(rows, dtype=float).reshape(-1, 3)

    def identify(self) -> Identity:
        """Ask who it is. Raises InstrumentError where it is no magnetometer of this family."""
        models = self.settings.models
        who = self._scpi.identify(
            lambda maker, model: "METROLAB" in maker and re.search(models, model) is not None,
            "a Metrolab magnetometer",
        )
        self._scpi.empty_errors()
        return who

    def start(self) -> None:
        """Stop what it does, set format, averaging and range, and see that it took them."""
        s = self.settings
        range_words = (f":SENS:FLUX:RANG {s.range_T}{'' if s.range_T == 'AUTO' else 'T'}",) if s.range_T else ()
        for words in (":ABOR", ":INIT:CONT OFF", ":FORM:DATA ASCII", f":AVER:COUN {s.average}", ":TRIG:SOUR IMM",
                      ":TRIG:COUN 1", *range_words):  # fmt: skip
            self._scpi.command(words)
        self._polls.start()

    def read_until(self, t_s: float) -> list[Block]:
        """Readings triggered up to `t_s` [nT, its own axes]."""
        good = [(stamp, *taken) for stamp in self._polls.due(t_s) if (taken := self.reading(stamp)) is not None]
        if not good:
            return []
        stamps, values, raw = np.array([g[0] for g in good]), np.array([g[1] for g in good]), [g[2] for g in good]
        if np.abs(values).max() >= self.settings.full_scale_nT:
            raise overloaded(self.name)
        lines = "".join(f"{reply}\n" for reply in raw).encode()
        return [Block("reference", self.name, ("ref_x", "ref_y", "ref_z"), stamps, values, lines)]

    def stop(self) -> None:
        """Trigger no more."""
        self._polls.stop()
        self._scpi.send(":ABOR")

    def reading(self, stamp: float) -> tuple[list[float], str] | None:
        """x, y, z [nT] and the reply; None, noted, where it is no good."""
        fetch = ";".join(f":FETC:ARR:{axis}? 1,{self.settings.digits}" for axis in "XYZ")
        reply = self._scpi.query(f":INIT;{fetch}", self._reply_s)
        values = [nanotesla(part) for part in reply.split(";")]
        good = [v for v in values if v is not None]
        if len(values) != 3 or len(good) != 3:
            self._mishaps.note("bad frame", stamp)
            return None
        return good, reply


def nanotesla(text: str) -> float | None:
    """A number with its unit [nT], inf where it is out of range; None where either is not there or not known."""
    found = VALUE.fullmatch(text)
    if found is None or found[2] not in NT:
        return None
    return float(found[1]) * NT[found[2]] if abs(float(found[1])) < OVERFLOW else float("inf")
