"""One verdict on one run: what is open in it stands on Start and on Certificate as on the Run page."""

import pytest
from test_path import calibration

from labcal.gui.ipc.messages import ListCalibrations, ListKeys
from labcal.gui.ipc.record_messages import TellRecord
from labcal.record.stream import BY, PROCEDURE, Event, Measurement, Step
from labcal.record.told import Told
from labcal.session.checks import not_measured, open_checks, open_words, results, worst
from labcal.session.told import notes_of

CLOSED = Measurement(1.0, "closure y", 426.6, 3.5, "nT", 500.0)
OPEN = Measurement(2.0, "closure, DUT less reference, coils off", 116.0, 157.5, "nT", 500.0)
FIELD = Measurement(3.0, "x+20uT-nominal: field", 20_000.0, 5.0, "nT")  # without a limit
ITEMS = [Step(0.0, 1, 1, "closure-y", 0.0, ("closure-y", "closure-z")), CLOSED, OPEN, FIELD]


def test_the_worst_result_of_a_run_is_that_of_its_verdict_and_not_the_largest_closure():
    assert worst(results(ITEMS)) is OPEN
    assert worst(results([CLOSED, FIELD])) is CLOSED
    assert open_checks(results(ITEMS)) == (OPEN,)
    assert not_measured(ITEMS, results(ITEMS)) == ("closure z",)
    vector = [*ITEMS, Measurement(1.0, "zero: ref_x", 20.0, 1.0, "nT"), Measurement(2.0, "delay z", 0.1, 0.1, "s", 0.5)]
    assert not_measured(vector, results(vector)) == ("closure z", "delay y")


def test_what_was_measured_again_counts_as_it_was_measured_last():
    again = Measurement(9.0, OPEN.name, 10.0, 2.0, "nT", 500.0)
    assert open_checks(results([*ITEMS, again])) == ()


def test_a_certificate_names_what_is_open_in_the_run():
    first, second = open_words((OPEN,), ("closure z",))
    assert first.startswith("Open in the run itself, CANNOT DECIDE: closure, DUT less reference, coils off +116 ±")
    assert first.endswith("limit 500.")
    assert second == "Not measured in the run: closure z."


def test_what_the_procedure_noted_is_no_note_of_a_person():
    own, old = Event(1.0, "note", "lift moved"), Event(2.0, "note", "offsets so far: x")
    marked = Event(3.0, "note", "too few directions", {BY: PROCEDURE})
    assert notes_of([own, old, marked]) == (("lift moved",), (old.text, marked.text))


@pytest.mark.parametrize("signed", [False, True])
def test_the_open_check_stands_above_the_approval(new_window, signed):
    new_window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    new_window.open_page("Certificate")
    page, worker = new_window.page("Certificate"), new_window.app_state.quick_worker
    worker.answer(ListCalibrations, (calibration(signed=signed),))
    worker.answer(ListKeys, ())
    assert not page.open.isVisible()
    worker.answer(TellRecord, Told(open=(OPEN,), not_measured=("closure z",)))
    assert page.open.isVisible()
    assert "CANNOT DECIDE: closure, DUT less reference, coils off +116 ± 315 nT (500)" in page.open.text()
    assert "closure z not measured" in page.open.text()
    assert page.open.y() < page.steps.mapTo(page, page.steps.rect().topLeft()).y()
