"""At a question a supply that gives no answer is waited for once, and the others are read all the same."""

from types import SimpleNamespace
from typing import Any

import pytest

from labcal.bench.at_a_question import currents_or_away
from labcal.bench.coils.state import CoilReading
from labcal.bench.streams.watch import RestPoll
from labcal.errors import InstrumentError


class Coils:
    """Of a cage what is read here; `silent` axes give no answer."""

    def __init__(self, silent: str) -> None:
        self.silent, self.asked = silent, list[str]()
        self.supplies = {axis: SimpleNamespace(name=f"supply_{axis}") for axis in "xyz"}
        self._read = {axis: CoilReading(axis) for axis in "xyz"}

    def coils(self) -> tuple[CoilReading, ...]:
        return tuple(self._read.values())

    def read(self, axis: str) -> float:
        self.asked.append(axis)
        if axis in self.silent:
            self._read[axis] = CoilReading(axis, fault="no reply")
            raise InstrumentError(f"supply_{axis}: no reply.", fault="silent")
        self._read[axis] = CoilReading(axis, current_A=0.0, zero=True, read_s=0.0)
        return 0.0

    def currents_A(self) -> list[float]:
        return [self.read(axis) for axis in "xyz"]


@pytest.mark.parametrize("silent", ["x", "y", "z", "yz"])
def test_each_is_asked_once_and_who_answers_is_read(silent: str) -> None:
    cage: Any = Coils(silent)
    look = RestPoll([], lambda name: None)
    assert currents_or_away(cage, look, 1.0, waited_for=True) is None
    assert {axis: cage.asked.count(axis) for axis in silent} == dict.fromkeys(silent, 1)
    assert [coil.axis for coil in cage.coils() if coil.read_s is None] == list(silent)
    assert [look.wrong(f"supply_{axis}") for axis in silent] == ["silent"] * len(silent)
