"""What counts as finished when a run broke off, once or twice."""

from __future__ import annotations

from labcal.record.stream import RESUMED, Event, Item, Measurement, Step
from labcal.runner.run import resume_state


def steps(*names: str) -> list[Item]:
    return [Step(float(n), n + 1, 9, name, 0.0) for n, name in enumerate(names)]


def test_the_last_step_before_an_interruption_is_not_finished() -> None:
    assert resume_state(steps("zero", "axes-check", "x")).done == {"zero", "axes-check"}


def test_nor_is_it_after_a_second_interruption_that_came_before_it_was_repeated() -> None:
    again = Event(10.0, RESUMED, "")
    twice = [*steps("zero", "x", "y"), again, *steps("zero", "axes-check")]
    assert resume_state(twice).done == {"zero", "x"}
    thrice = [*twice, again, *steps("zero", "axes-check", "y", "closing")]
    assert resume_state(thrice).done == {"zero", "x", "axes-check", "y"}


def test_the_first_value_of_a_measurement_counts() -> None:
    values: list[Item] = [Measurement(t, "zero: ref_x", t, 0.0, "nT") for t in (1.0, 2.0)]
    assert resume_state(values).measured == {"zero: ref_x": 1.0}
