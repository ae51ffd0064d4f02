"""Long work shows a bar and can be stopped; a fit says in words whether it is good."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from PySide6.QtCore import Qt
from test_calibration_views import LINES
from test_choose import told_by_the_loop
from test_path import RUN

from labcal.gui.ipc.answers import FitFigures, Fitted
from labcal.gui.ipc.messages import CloseLoop, FitRun, Rehearse
from labcal.gui.ipc.wire import Fault
from labcal.gui.next_step import begins_at
from labcal.gui.viewmodels.fit_words import said_of

K = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def fitted(left_nT, stated_nT):
    """A method takes its own noise from what is left over: that says nothing of how good it is."""
    said = FitFigures(True, None, K, (0.0, 0.0, 0.0), holdout_rms_scalar_nT=left_nT)
    return Fitted(said, left_nT, stated_nT=stated_nT)


@pytest.fixture
def studied(still):
    """A run under study, with nothing asked."""
    study = still.app_state.study_vm
    study.forget("r1")
    study.changed.emit()
    yield study
    study.forget("")
    study.changed.emit()


@pytest.mark.parametrize(("name", "begin"), [("Fit", "fit"), ("Loop", "close_loop")])
def test_what_is_computed_shows_a_bar_until_it_is_stopped(still, studied, qtbot, name, begin):
    still.open_page(name)
    page = still.page(name)
    assert not page.work.isVisible()
    getattr(studied, begin)(*(["ml"] if begin == "fit" else []))
    assert page.work.isVisible()
    assert page.work.maximum() == 0  # it moves: nothing is known of how far it is
    still.app_state.fit_worker.progress.emit("scoring every effect")
    assert page.work.maximum() == (100 if begin == "close_loop" else 0)  # filled by stages
    qtbot.mouseClick(page.cancel, Qt.MouseButton.LeftButton)
    assert still.app_state.fit_worker.killed == 1
    assert not page.work.isVisible()


def test_a_rehearsal_shows_a_bar_and_is_given_up_by_a_click(still, qtbot):
    still.open_page("Run")
    choose, worker = still.page("Run").choose, still.app_state.bench_worker
    qtbot.mouseClick(choose.show_plan, Qt.MouseButton.LeftButton)
    assert choose.work.isVisible()
    assert not choose.start.isEnabled()
    qtbot.mouseClick(choose.give_up, Qt.MouseButton.LeftButton)
    assert worker.killed == 1
    for one in [one for one in worker.asked if isinstance(one.command, Rehearse)]:
        one.failed(Fault("ended", "The work was ended by this window."))
    assert choose.plan.text() == "given up"
    assert not choose.work.isVisible()
    assert not choose.give_up.isVisible()
    assert choose.start.isEnabled()
    assert choose.show_plan.isVisible()


@pytest.mark.parametrize(
    ("left_nT", "lines", "words", "state"),
    [
        (10.0, LINES[:1], "✓ In specification.", "good"),
        (10.0, LINES[:2], "▲ In specification, conditionally: scale y +0.490 ± 0.020 % (± 0.5)", "warning"),
        (
            10.0,
            LINES,
            "✕ Not in specification: scale y +0.490 ± 0.020 % (± 0.5); noise +20.30 ± 0.50 nT (± 20) (+ 1)",
            "bad",
        ),
        (20.0, LINES[:1], "✓ In specification.", "warning"),
    ],
)
def test_a_fit_says_whether_its_map_is_in_specification(left_nT, lines, words, state):
    said, colour = said_of("ml", replace(fitted(left_nT, 10.0), specification=lines))
    assert (said.splitlines()[1], colour) == (words, state)


@pytest.mark.parametrize(
    ("left_nT", "stated_nT", "words", "state"),
    [
        (
            11.0,
            10.0,
            "ml: ✓ The calibration is good in size: 11.0 nT rms of |b| are left over, no more than its noise, "
            "10.0 nT rms. The loop judges the direction.",
            "good",
        ),
        (
            11.6,
            10.0,
            "ml: ▲ The map alone is not enough: 11.6 nT rms of |b| are left over, its noise is 10.0 nT rms. "
            "Trace the residual.",
            "warning",
        ),
        (11.0, None, "ml: 11.0 nT rms of |b| are left over; no noise is stated to compare it with.", ""),
        (None, 10.0, "", ""),
    ],
)
def test_a_fit_says_whether_it_is_good(still, studied, left_nT, stated_nT, words, state):
    words = words and f"{words} No specification is stated."
    assert said_of("ml", fitted(left_nT, stated_nT)) == (words, state)
    still.open_page("Fit")
    page = still.page("Fit")
    studied.fit("ml")
    still.app_state.fit_worker.answer(FitRun, fitted(left_nT, stated_nT))
    page.idle_queue.finish()
    assert (page.verdict.text(), page.verdict.property("state") or "") == (words, state)
    assert page.verdict.isVisible() == bool(words)


@pytest.mark.parametrize(
    ("verdict", "next_words", "button"),
    [
        ("", "Trace the residual.", "Trace the residual"),
        ("explained", "The residual was traced: ✓ EXPLAINED. The loop's draft holds its cause.", "See what was found"),
        ("ambiguous", "The residual was traced: ? AMBIGUOUS. The Loop page says what was found.", "See what was found"),
    ],
)
def test_what_was_traced_is_not_to_be_traced_again(still, studied, verdict, next_words, button):
    still.app_state.path.take_runs((replace(RUN, run_id=studied.run, verdict=verdict),))
    still.open_page("Fit")
    page, worker = still.page("Fit"), still.app_state.fit_worker
    studied.fit("ml")
    worker.answer(FitRun, fitted(20.0, 10.0))
    page.idle_queue.finish()
    assert page.verdict.text().startswith("ml: ▲ The map alone is not enough:")
    assert next_words in page.verdict.text()
    assert page.verdict.text().count("Trace") == (0 if verdict else 1)
    assert (page.trace.text(), page.trace.objectName()) == (button, "" if verdict else "primary")
    page.trace.click()
    assert still.page_shown() == "Loop"
    assert bool(worker.commands(CloseLoop)) == (not verdict)


def test_what_was_traced_in_this_session_is_known_before_the_store_has_it(still, studied):
    still.app_state.path.take_runs((replace(RUN, run_id=studied.run),))
    still.open_page("Fit")
    page, worker = still.page("Fit"), still.app_state.fit_worker
    studied.fit("ml")
    worker.answer(FitRun, fitted(20.0, 10.0))
    studied.close_loop()
    worker.answer(CloseLoop, told_by_the_loop(None))
    assert still.page("Loop").close_loop.text() == "Work it out again"  # its verdict is in sight
    page.idle_queue.finish()
    assert page.trace.text() == "See what was found"
    assert "The residual was traced: ? AMBIGUOUS." in page.verdict.text()


@pytest.mark.parametrize("left_nT", [11.0, None])
def test_a_map_that_the_run_leaves_open_is_not_good_however_little_is_left_over(left_nT):
    why = "the run determines 11 of 12 parameters, not K_xy: add a rotation about another body axis"
    said, state = said_of("ml", replace(fitted(left_nT, 10.0), left_open=why))
    assert said.startswith(f"ml: ▲ This run does not determine the whole map, however little is left over: {why}.")
    assert "good in size" not in said
    assert state == "warning"


def test_what_a_run_states_of_its_noise_comes_with_its_fit():
    from labcal.gui.ipc.study_commands import stated_noise

    def run(dut, reference):
        return SimpleNamespace(dut=SimpleNamespace(noise_nT=dut), reference=SimpleNamespace(noise_nT=reference))

    assert stated_noise(run(15.0, 8.0)) == pytest.approx(17.0)
    assert (stated_noise(run(None, 8.0)), stated_noise(run(15.0, None))) == (None, None)


def test_a_plan_that_cannot_be_is_not_begun_until_its_reason_is_away(still):
    still.open_page("Run")
    choose, worker = still.page("Run").choose, still.app_state.bench_worker
    choose.choose("preflight")
    choose.rehearse()
    (asked,) = (one for one in worker.asked if isinstance(one.command, Rehearse))
    asked.failed(Fault("input", "coil x: 3 A is beyond its limit of 2 A"))
    assert choose.plan.text().startswith("✕ coil x")
    assert not choose.start.isEnabled()
    assert choose.objection.text() == "It cannot be begun as it is set: the plan says why."
    assert still.app_state.path.next().words == "Correct the plan"
    choose.form.set_text("magnitudes_nT", "20000")
    assert choose.start.isEnabled()
    choose.form.set_text("magnitudes_nT", "")
    choose.choose("preflight")


def test_a_fit_that_comes_to_nothing_says_what_it_means_and_leads_on(still, studied):
    still.open_page("Fit")
    page, worker, study = still.page("Fit"), still.app_state.fit_worker, studied
    study.methods = ("ml", "ekf")
    no = Fitted(FitFigures(False, "the likelihood has no clear summit"))
    study.fit("ml")
    worker.answer(FitRun, no)
    page.idle_queue.finish()
    card = page.no_fit
    assert card.isVisible()
    assert card.heading.text() == "✕ No calibration from this run by ml"
    assert card.why.text() == "Why: the likelihood has no clear summit."
    assert [one.text() for one in begins_at(still.lazy_pages["Fit"])] == ["The other methods"]
    card.others.click()
    worker.answer(FitRun, no)
    page.idle_queue.finish()
    assert card.heading.text() == "✕ No calibration from this run"
    assert not card.others.isVisible()
    assert "measure again" in card.next.text()
    card.again.click()
    assert still.page_shown() == "Run"


@pytest.mark.parametrize(
    ("tried", "words"), [(("ml",), "Try the other methods"), (("ml", "ekf"), "Measure EM-07 again")]
)
def test_next_does_not_fit_again_what_came_to_nothing(still, studied, tried, words):
    still.app_state.path.take_runs((RUN,))
    studied.forget(RUN.run_id)
    studied.methods = ("ml", "ekf")
    studied.fits = {name: Fitted(FitFigures(False, "flat")) for name in tried}
    studied.changed.emit()
    assert still.app_state.path.marks()["Fit"] == "broken"
    assert still.app_state.path.next().words == words


def test_a_method_without_a_result_stands_folded_beside_the_verdict_of_another(still, studied):
    still.open_page("Fit")
    page = still.page("Fit")
    studied.fits = {"ml": fitted(10.0, 10.0), "ekf": Fitted(FitFigures(False, "the filter has diverged"))}
    studied.changed.emit()
    page.idle_queue.finish()
    assert page.verdict.property("state") == "good"
    assert page.aside.text() == "Without a result: ekf. What is said above is of ml, and does not rest on them."
    assert not page.why.isVisible()
    page.fold.click()
    assert page.why.text() == "✕ ekf: the filter has diverged"
    assert page.why.isVisible()
    page.fold.click()
