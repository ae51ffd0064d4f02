"""A pause takes the coils to zero: gone on with, a procedure measures in the field that it would have had without."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scalar_lab import SCALAR, sensor
from short_settings import EACH, SHORT

from labcal.demo import simulated_bench
from labcal.record.stream import Event, Item, Prompt, SegmentOpened, Step
from labcal.runner import find
from labcal.runner.prompts import first_choice
from labcal.testing.procedures import ProcedureTrial


@dataclass
class Paused(ProcedureTrial):
    """A trial that pauses at each step where it is asked to, and keeps the true currents [A] as segments begin."""

    at_each_step: bool = False
    flows: dict[str, list[float]] = field(default_factory=dict)
    promised_nT: float = 0.0  # the largest field that the last "Hands off?" names
    stand_back: bool = False  # whoever said "hands off", and was asked for nothing since
    asked_twice: list[str] = field(default_factory=list)
    unsaid: list[tuple[float, str]] = field(default_factory=list)  # what was stronger [nT], and at which set-point

    def _notice(self, item: Item) -> None:
        super()._notice(item)
        if isinstance(item, Prompt):
            self.asked_twice += [item.text] if item.key == "ready" and self.stand_back else []
            self.stand_back = item.key == "ready"
            named = re.findall(r"([0-9.]+) µT", item.text) if item.key == "ready" else []
            self.promised_nT = 1000 * max(map(float, named), default=0.0)
        elif isinstance(item, Event) and item.kind == "set-point":
            currents = np.asarray(item.data.get("current_A", (0.0, 0.0, 0.0)))
            made = item.data.get("field_nT") or self.bench.cage.matrix_nT_per_A @ currents
            if (most_nT := float(np.linalg.norm(made))) > 1.01 * self.promised_nT:
                self.unsaid.append((most_nT, item.text))
        if isinstance(item, Step) and self.at_each_step:
            self.control.pause()
        elif isinstance(item, Event) and item.kind == "pause":
            self.control.resume()
            self.stand_back = False
        elif isinstance(item, SegmentOpened):
            self.flows[item.segment.id] = self._currents_A()

    def of_each_segment(self) -> dict[str, list[float]]:
        """Of a run to its end."""
        assert self.run().status == "finished"
        return self.flows

    def _currents_A(self) -> list[float]:
        lab: Any = self.bench.simulated_operator
        return [float(coil.at([self.bench.clock.now()])[0]) for coil in lab._lab.coils.values()]


@pytest.mark.parametrize("name", EACH)
def test_what_is_measured_after_a_pause_is_measured_in_the_same_field(
    name: str, bench_file: Callable[..., Path]
) -> None:
    bench = bench_file(sensor(1), *SCALAR) if name == "scalar-cage" else simulated_bench()
    trials = [Paused(find(name), SHORT.get(name, {}), bench, first_choice) for _ in range(2)]
    trials[1].at_each_step = True
    without, paused = (trial.of_each_segment() for trial in trials)
    steps = sum(isinstance(item, Step) for item in trials[1].items)
    assert sum(isinstance(item, Event) and item.kind == "pause" for item in trials[1].items) == 2 * steps
    assert paused.keys() == without.keys()
    for segment, amperes in without.items():
        assert paused[segment] == pytest.approx(amperes, rel=0.02, abs=0.02), segment
    assert trials[1].hands_near == []
    for trial in trials:  # whoever said "hands off" was told of the strongest field until the next question
        assert (trial.unsaid, trial.asked_twice) == ([], [])


GRANTED = '''
"""One field for all of its steps."""
from contextlib import ExitStack
from labcal.bench.steps import Plan, coils_off, energise, ready, rest


def granted(bench):
    """Two steps in one field."""
    plan = Plan((("field", 5.0), ("rest", 3.0)))
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        yield plan.begin(bench, "field")
        yield from ready(bench, "Hands off?")
        yield from energise(bench, (0.0, 0.0, 30_000.0))
        yield plan.begin(bench, "rest")
        yield from rest(bench, "rest", 3.0)
        yield from coils_off(bench)
'''


def test_a_procedure_that_takes_its_field_for_granted_is_refused_before_it_measures(tmp_path: Path) -> None:
    source = tmp_path / "granted.py"
    source.write_text(GRANTED, encoding="utf-8")
    trial = Paused(find(str(source)), {}, simulated_bench(), first_choice, at_each_step=True)
    ending = trial.run()
    assert ending.status.startswith("failed: the pause took the field to zero, and the procedure did not bring it back")
    assert trial.flows == {}
    assert trial.left_A < 0.002
