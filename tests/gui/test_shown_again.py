"""What was worked out of a run is shown again by a window that is started again, tables and pictures, at once."""

import json
import os
from dataclasses import replace
from shutil import copytree

import numpy as np
import pytest
from test_choose import looked_at, told_by_the_loop
from test_path import RUN, calibration

from labcal import session
from labcal.gui.ipc import kept_answers
from labcal.gui.ipc.answers import FitFigures, Fitted
from labcal.gui.ipc.kept_answers import keep_fit, keep_loop, kept_fits, kept_loop
from labcal.gui.ipc.messages import CloseLoop, FitRun, ListCalibrations, ListRuns, LookAt
from labcal.gui.ipc.study_commands import fit, loaded_fit, look

K = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ML = Fitted(FitFigures(True, None, K, (120.0, -30.0, 5.0)), 20.0, np.zeros(50), np.ones((50, 3)))


@pytest.fixture
def run(drafted, tmp_path, monkeypatch):
    """A run whose residual was traced, in a home of its own."""
    monkeypatch.setenv("LABCAL_HOME", str(copytree(drafted, tmp_path / "home")))
    return session.load_run(session.runs()[0].run_id)


def test_a_run_that_is_looked_at_again_brings_its_loop_and_its_fits(run):
    loaded_fit.cache_clear()
    fitted = fit(None, FitRun(run.run_id, "centered"))
    seen = look(None, LookAt(run.run_id))
    assert seen.loop is not None
    (shown,), (drafted,) = seen.loop.accepted, session.load_calibration(seen.loop.draft).effects
    assert (shown.effect, shown.parameters, shown.why) == (drafted.effect, drafted.parameters, drafted.why)
    assert len(seen.loop.change.before) == len(seen.loop.change.against["time  s"])
    assert list(seen.fits) == ["centered"]
    assert seen.fits["centered"].fit == fitted.fit
    assert np.array_equal(seen.fits["centered"].residual, fitted.residual)


def test_of_another_labcal_nothing_is_shown_again(run, monkeypatch):
    assert kept_loop(run) is not None
    monkeypatch.setattr("labcal.session.working_out.sources", lambda: "of another day")
    assert kept_loop(run) is None


def test_of_a_run_that_has_gone_on_nothing_is_shown_again(run):
    """An interrupted run may have been fitted, and have more rows now."""
    assert kept_loop(run) is not None
    shorter = type("Shorter", (), {"run_id": run.run_id, "__len__": lambda self: len(run) - 1})()
    assert kept_loop(shorter) is None


@pytest.mark.parametrize("text", ["", "{", "[]", '{"made_by": 1}', "null"])
def test_what_cannot_be_read_is_to_be_worked_out_anew(run, text):
    keep_fit(run, "ml", ML)
    (place,) = (kept_answers.home() / kept_answers.FOLDER).glob("*/fit-ml.json")
    assert list(kept_fits(run, ("ml", "ekf"))) == ["ml"]
    stated = json.loads(place.read_text())
    place.write_text(text)
    assert kept_fits(run, ("ml",)) == {}
    place.write_text(json.dumps(stated | {"answer": {"fit": 3}}))
    assert kept_fits(run, ("ml",)) == {}


def test_of_more_runs_than_are_kept_the_one_worked_out_longest_ago_is_to_be_worked_out_anew(run, monkeypatch):
    monkeypatch.setattr(kept_answers, "MOST_RUNS", 2)
    others = [type("Other", (), {"run_id": name, "__len__": lambda self: 3})() for name in ("r-a", "r-b")]
    for other in others:
        keep_fit(other, "ml", ML)
    assert [list(kept_fits(one, ("ml",))) for one in others] == [["ml"], ["ml"]]
    assert kept_loop(run) is None


def test_methods_come_in_the_order_in_which_they_were_worked_out(run):
    for at, method in enumerate(("ml", "ekf", "centered")):
        keep_fit(run, method, ML)
        place = next((kept_answers.home() / kept_answers.FOLDER).glob(f"*/fit-{method}.json"))
        os.utime(place, (1e9 + at, 1e9 + at))
    assert list(kept_fits(run, ("centered", "ekf", "ml"))) == ["ml", "ekf", "centered"]


def test_a_folder_that_takes_nothing_costs_no_answer(run, monkeypatch, tmp_path):
    (tmp_path / "a-file").write_text("")
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "a-file"))
    keep_loop(run, told_by_the_loop("reverse"))
    assert kept_loop(run) is None


@pytest.fixture
def started_again(new_window):
    """A window that has just begun, on the DUT whose run was traced."""
    app_state = new_window.app_state
    app_state.set_identity(dut="EM-07")
    for page in ("Fit", "Loop"):
        new_window.page(page)
    new_window.open_page("Fit")
    app_state.quick_worker.answer(ListCalibrations, (calibration(),))
    app_state.quick_worker.answer(ListRuns, (RUN,))
    return new_window


def test_the_tables_are_there_at_once_and_nothing_is_asked_for(started_again, qtbot, patience):
    study, worker = started_again.app_state.study_vm, started_again.app_state.fit_worker
    worker.answer(LookAt, replace(looked_at("r1"), fits={"ml": ML}, loop=told_by_the_loop("reverse")))
    fit_page, loop_page = started_again.page("Fit"), started_again.page("Loop")
    qtbot.waitUntil(lambda: fit_page.table.columnCount() == 2, timeout=patience)
    assert fit_page.table.horizontalHeaderItem(1).text() == "ml"
    assert (fit_page.empty.isVisible(), fit_page.fit.isEnabled()) == (False, False)
    started_again.open_page("Loop")
    qtbot.waitUntil(lambda: loop_page.others.rowCount() == 2, timeout=patience)
    assert (loop_page.story.isVisible(), loop_page.empty.isVisible()) == (True, False)
    assert loop_page.verdict.text() == "? AMBIGUOUS"
    assert (worker.commands(FitRun), worker.commands(CloseLoop), study.shown.computes) == ([], [], False)


def test_what_is_being_worked_out_again_is_not_put_back(started_again):
    study, worker = started_again.app_state.study_vm, started_again.app_state.fit_worker
    study.close_loop()
    study.fits["ml"] = anew = replace(ML, noise_nT=7.0)
    worker.answer(LookAt, replace(looked_at("r1"), fits={"ml": ML}, loop=told_by_the_loop("reverse")))
    assert (study.loop, study.fits) == (None, {"ml": anew})
