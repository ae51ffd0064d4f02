"""A procedure rehearsed on the simulated lab before anything real moves: what it will do, and for how long."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from labcal.bench.clock import VirtualClock
from labcal.bench.config import read_config
from labcal.bench.driver_kit.roles import RotationPlatform
from labcal.bench.opening import open_bench
from labcal.bench.platform import BenchPlatform
from labcal.record.stream import Block, Event, Item, Prompt, SegmentOpened
from labcal.runner.catalogue import FoundProcedure
from labcal.runner.prompts import first_choice
from labcal.runner.run import run_procedure
from labcal.store import Store

LINK = re.compile(r"""(^\s*|[{,]\s*)(?:link|"link"|'link')\s*=\s*(?:"[^"]*"|'[^']*')""", re.MULTILINE)  # served: quoted
TURNING_DEG = 1.0  # between the platform's readings: less is rest


@dataclass
class Rehearsal:
    """What a procedure does, as rehearsed with its settings."""

    procedure: str
    title: str
    simulated: bool = False  # the bench itself: all its links are emulated
    segments: int = 0  # recorded for a calibration
    seconds: float = 0.0  # of lab time, a person's steps not counted
    field_nT: float = 0.0  # the largest at the DUT
    rate_deg_per_s: float = 0.0  # of the fastest turn
    limit: tuple[float, str] | None = None  # [deg/s] that no turn goes beyond, and whose that is
    angles_deg: tuple[float, float] | None = None
    temperature_C: tuple[float, float] | None = None  # that the DUT's limits allow
    shortfalls: list[str] = field(default_factory=list)  # what does not come of it with these settings
    person: list[str] = field(default_factory=list)  # what a person is asked to do, mounting and switching included
    _platform: BenchPlatform | None = field(default=None, repr=False)
    _last: tuple[float, float] | None = field(default=None, repr=False)

    def watch(self, platform: RotationPlatform) -> None:
        """This one turns: how fast it may, by whose limit, and how fast it is asked to."""
        if isinstance(platform, BenchPlatform):
            whose = "DUT's limit in bench.toml" if platform.limited_by_dut else "platform's limit"
            self._platform, self.limit = platform, (platform.max_rate_deg_per_s, whose)

    def see(self, item: Item) -> None:
        """Take one item of the rehearsal into account."""
        if isinstance(item, Event) and "field_nT" in item.data and item.kind == "set-point":
            self.field_nT = max(self.field_nT, float(np.linalg.norm(item.data["field_nT"])))
        elif isinstance(item, SegmentOpened):
            self.segments += 1
        elif isinstance(item, Prompt) and item.acts:
            self.person.append(item.text)
        elif isinstance(item, Block) and item.stream == "angle":
            for t, angle in zip(item.t_s.tolist(), item.values[:, 0].tolist(), strict=True):
                self._turned(t, angle)

    def _turned(self, t_s: float, angle_deg: float) -> None:
        """Angles are read with some noise: no turn is called faster than it was asked to be."""
        low, high = self.angles_deg or (angle_deg, angle_deg)
        self.angles_deg = min(low, angle_deg), max(high, angle_deg)
        if self._last is not None and t_s > self._last[0]:
            rate = abs(angle_deg - self._last[1]) / (t_s - self._last[0])
            asked = rate if self._platform is None else self._platform.asked_deg_per_s
            self.rate_deg_per_s = max(self.rate_deg_per_s, min(rate, asked))
        self._last = t_s, angle_deg

    def _rates(self) -> str:
        """The rate to two figures, never rounded beyond its limit, and whose limit that is."""
        rate = float(f"{self.rate_deg_per_s:.2g}")
        if self.limit is None:
            return f"{rate:g} °/s"
        most, whose = self.limit
        return f"{min(rate, most):g} °/s; the {whose} is {most:g} °/s"

    def lines(self) -> list[str]:
        """The plan in words, one line each."""
        low, high = self.angles_deg or (0.0, 0.0)
        turns = f"turns between {low:.0f} and {high:.0f}°, the fastest at {self._rates()}"
        kept = " to ".join(f"{limit:g}" for limit in self.temperature_C or ()).replace("-", "−")
        said = [
            f"{self.procedure}: {self.title}",
            *self.shortfalls,
            f"largest field at the DUT {self.field_nT / 1000:.1f} µT",
            turns if high - low > TURNING_DEG else "the platform rests",
            f"DUT kept within {kept} °C" if kept else "no temperature limits are stated",
            f"about {self.seconds / 60:.0f} min, without a person's steps",
        ]
        asked = [f"– {text.replace(' -', ' −')}" for text in dict.fromkeys(self.person)]
        return [*said, *(["what a person is asked:", *asked] if asked else [])]


def rehearsed(bench: Path, procedure: FoundProcedure, given: Mapping[str, str], seed: int | None = None) -> Rehearsal:
    """Run `procedure` on the simulated twin of `bench`, whatever its links are, and return what it did.

    Raises what the procedure raises: a plan beyond a limit fails here, before anything real is touched.
    """
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "bench.toml"
        copy.write_text(LINK.sub(r'\1link = "emulated://"', bench.read_text(encoding="utf-8")), encoding="utf-8")
        clock = VirtualClock(datetime.now(UTC))
        with closing(open_bench(copy, clock=clock, seed=seed)) as lab, Store.open(Path(folder) / "r.sqlite") as store:
            limits = lab.config.dut.limits.temperature_C
            found = Rehearsal(procedure.name, procedure.title, read_config(bench).simulated, temperature_C=limits)
            found.shortfalls = procedure.shortfalls(given)
            found.watch(lab.platform)
            begun = clock.now()
            outcome = run_procedure(lab, procedure, given, store=store, answer=first_choice, on_item=found.see)
            found.seconds = clock.now() - begun
    if outcome.fault is not None:
        raise outcome.fault
    return found
