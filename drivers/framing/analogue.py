"""An analogue three-axis fluxgate: volts on three inputs become nT by the sensor's scale, polled."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.polling import Polled, Polls
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.record.stream import Block, Event

NONE_V = -9999.0  # what an input of a T7 reads that does not exist
Input = Annotated[int, Field(ge=0, le=255)]


@dataclass(frozen=True)  # without slots, so that a box's own settings can stand beside it
class Analogue:
    """`uT_per_V`, `zero_V`: by the sensor's certificate, an axis each; 10 where 100 µT are 10 V. `inputs`: by number.

    `differential`: each input against its partner. `range_V`: of the converter. The sensor is overloaded at
    `full_scale_V`. `filter_Hz`: corner of the first-order filter before the input, whose delay is taken off the
    stamps; 0: there is none. `average`: readings to one sample.
    """

    uT_per_V: tuple[float, float, float]
    zero_V: tuple[float, float, float] = (0.0, 0.0, 0.0)
    inputs: tuple[Input, Input, Input] = (0, 1, 2)
    differential: bool = False
    range_V: Positive = 10.0
    full_scale_V: Positive = 9.9
    filter_Hz: NotNegative = 0.0
    rate: Annotated[float, Field(gt=0, le=100)] = 10.0
    average: Annotated[int, Field(ge=1, le=100)] = 1
    serial: str = ""

    def __post_init__(self) -> None:
        if len(set(self.inputs)) != 3:
            raise ValueError("inputs must be three")
        if not all(map(math.isfinite, (*self.uT_per_V, *self.zero_V))) or not all(self.uT_per_V):
            raise ValueError("uT_per_V and zero_V must be finite numbers, and uT_per_V other than zero")


class Fluxgate(Polled):
    """The methods of a reference on `volts`, one sample of the three inputs. The sensor says nothing of itself."""

    roles = ("reference",)
    name: str
    settings: Any

    def begin(self, clock: Clock) -> None:
        """What it needs beside name and settings."""
        s = self.settings
        self._polls, self._mishaps = Polls(clock, s.rate), Mishaps(self.name)
        self._delay_s = 1 / (2 * math.pi * s.filter_Hz) if s.filter_Hz else 0.0

    def volts(self) -> list[float]:
        """One sample of the three inputs."""
        raise NotImplementedError

    def start(self) -> None:
        """Begin to ask."""
        self._polls.start()

    def read_until(self, t_s: float) -> list[Block]:
        """Samples taken up to `t_s` [nT, the sensor's own axes]."""
        taken = [(stamp, row) for stamp in self._polls.due(t_s) if (row := self._numbers(stamp)) is not None]
        if not taken:
            return []
        volts = np.array([three for _, three in taken])
        if np.abs(volts).max() >= self.settings.full_scale_V:
            raise overloaded(self.name)
        values = 1000.0 * (volts - self.settings.zero_V) * np.array(self.settings.uT_per_V)
        stamps, raw = np.array([stamp for stamp, _ in taken]) - self._delay_s, volts.astype(">f4").tobytes()
        return [Block("reference", self.name, ("ref_x", "ref_y", "ref_z"), stamps, values, raw)]

    def events(self) -> list[Event]:
        """Readings that were no numbers."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Ask no more."""
        self._polls.stop()

    def make_safe(self) -> None:
        """Ask no more."""
        self.stop()

    def _numbers(self, stamp: float) -> list[float] | None:
        """One sample; None, noted, where one is no number, or no input."""
        volts = self.volts()
        if np.isfinite(volts).all() and min(volts) > NONE_V:
            return volts
        self._mishaps.note("bad frame", stamp)
        return None
