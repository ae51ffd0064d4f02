"""A procedure rehearsed on the simulated lab before anything real moves: what it will do, and for how long."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from labcal.bench.bench import Bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.cage import Cage
from labcal.bench.config import read_config
from labcal.bench.opening import open_bench
from labcal.bench.platform import BenchPlatform
from labcal.record.stream import Block, Event, Item, Prompt, SegmentOpened, Step
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
    person: dict[str, list[str]] = field(
        default_factory=dict
    )  # what a person is asked to do, and in which step each time
    _mounts: set[str] = field(default_factory=set, repr=False)  # of these what brings the DUT to the platform
    _step: str = field(default="", repr=False)
    _cage: Cage | None = field(default=None, repr=False)
    _platform: BenchPlatform | None = field(default=None, repr=False)
    _last: tuple[float, float] | None = field(default=None, repr=False)

    def watch(self, bench: Bench) -> None:
        """Its platform turns: how fast it may, by whose limit, how fast it is asked to; its cage makes the field."""
        platform, self._cage = bench.platform, bench.cage
        if isinstance(platform, BenchPlatform):
            whose = "DUT's limit in bench.toml" if platform.limited_by_dut else "platform's limit"
            self._platform, self.limit = platform, (platform.max_rate_deg_per_s, whose)

    def see(self, item: Item) -> None:
        """Take one item of the rehearsal into account."""
        if isinstance(item, Event) and item.kind == "set-point":
            self.field_nT = max(self.field_nT, self._field_of(item.data))
        elif isinstance(item, SegmentOpened):
            self.segments += 1
        elif isinstance(item, Prompt) and item.acts:
            self.person.setdefault(item.text, []).append(self._step)
            self._mounts |= {item.text} if "body_from_cage" in item.drawing else set()
        elif isinstance(item, Step):
            self._step = item.name
        elif isinstance(item, Block) and item.stream == "angle":
            for t, angle in zip(item.t_s.tolist(), item.values[:, 0].tolist(), strict=True):
                self._turned(t, angle)

    def _field_of(self, set_point: Mapping[str, Any]) -> float:
        """Its magnitude [nT], stated or by the currents."""
        if "field_nT" in set_point or self._cage is None:
            return float(np.linalg.norm(set_point.get("field_nT", 0.0)))
        made = self._cage.matrix_nT_per_A @ np.asarray(set_point["current_A"], dtype=float)
        return float(np.linalg.norm(made + self._cage.ambient_nT))

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
        asked = [f"– {text.replace(' -', ' −')}{self._how_often(text)}" for text in self.person]
        in_all = f"what a person is asked, {sum(map(len, self.person.values()))}× in all:"
        return [*said, *([in_all, *asked] if asked else [])]

    def _how_often(self, text: str) -> str:
        """Of what is asked more than once; of a mounting the steps as well, so that none is missed."""
        steps = self.person[text]
        where = f": {', '.join(steps)}" if text in self._mounts else ""
        return f" ({len(steps)}×{where})" if len(steps) > 1 else ""


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
            found.watch(lab)
            begun = clock.now()
            outcome = run_procedure(lab, procedure, given, store=store, answer=first_choice, on_item=found.see)
            found.seconds = clock.now() - begun
    if outcome.fault is not None:
        raise outcome.fault
    return found
