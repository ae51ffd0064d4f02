"""What counts as finished when a run broke off, once or twice."""

from __future__ import annotations

from labcal.bench.steps import Resume
from labcal.record.stream import NOT_USED, RESUMED, Event, Item, Measurement, Step
from labcal.runner.resume_state import resume_state


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


def test_what_its_procedure_began_anew_counts_as_it_was_at_last() -> None:
    wrong, right = (Measurement(t, "zero: ref_x", t, 0.0, "nT") for t in (1.0, 2.0))
    opening = [*steps("zero"), wrong, *steps("axes-check", "zero")]
    assert resume_state(opening) == Resume(frozenset(), {})
    assert resume_state([*opening, right, *steps("axes-check", "x")]).done == {"zero", "axes-check"}
    assert resume_state([*opening, right]).measured == {"zero: ref_x": 2.0}


def test_begun_anew_after_an_interruption_it_changes_nothing_that_was_finished_before() -> None:
    first, wrong = (Measurement(t, "zero: ref_x", t, 0.0, "nT") for t in (1.0, 2.0))
    run = [*steps("zero"), first, *steps("axes-check", "x", "y"), Event(10.0, RESUMED, "")]
    again = [*run, *steps("zero"), wrong, *steps("axes-check", "zero")]
    assert resume_state(again) == Resume(frozenset({"zero", "axes-check", "x"}), {"zero: ref_x": 1.0}, times=2)


def test_an_opening_that_led_to_no_turn_is_forgotten_with_its_values() -> None:
    wrong, right = (Measurement(t, "zero: ref_x", t, 0.0, "nT") for t in (1.0, 2.0))
    run = [*steps("zero"), wrong, *steps("axes-check"), Event(10.0, RESUMED, "")]
    assert resume_state([*run, *steps("zero"), right, *steps("axes-check", "x")]).measured == {"zero: ref_x": 2.0}


def test_the_closure_of_turns_that_were_begun_anew_is_to_be_measured_again() -> None:
    closed = [*steps("zero", "x", "closure-x"), Measurement(5.0, "closure x", 3.0, 1.0, "nT", 500.0)]
    assert resume_state([*closed, *steps("mount-y")]).measured == {"closure x": 3.0}
    assert resume_state([*closed, *steps("mount-y", "x")]).measured == {}


def test_what_was_marked_as_not_used_is_not_finished() -> None:
    refused = Event(10.0, NOT_USED, "", {"segments": ["x", "-x"]})
    turned = [*steps("zero", "x", "-x", "closure-x", "mount-y"), refused]
    assert resume_state(turned).done == {"zero", "closure-x"}
    assert resume_state([*turned, *steps("x")]).done == {"zero"}
    assert resume_state([*turned, *steps("x", "-x", "y")]).done == {"zero", "x", "-x"}
