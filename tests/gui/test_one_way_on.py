"""One thing at a time: Next presses the button for it, one button is blue, one figure is the error before."""

import re
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QFileDialog, QLabel, QMenu, QPushButton
from test_choose import looked_at, told_by_the_loop
from test_path import DONE, RUN, calibration

from labcal.gui.ipc.answers import Checked, Ended, FitFigures, Fitted
from labcal.gui.ipc.messages import CloseLoop, Identify, LastCageCheck, ListRuns, LookAt, ResumeRun
from labcal.gui.reopened import Shown
from labcal.gui.translations import translate
from labcal.gui.viewmodels.loop_causes import candidates
from labcal.gui.viewmodels.loop_words import as_a_drop


def test_next_on_the_bench_page_opens_a_bench_and_says_so(new_window, qtbot, monkeypatch):
    asked = []
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *said: asked.append(said) or ("", ""))
    new_window.page("Bench")
    new_window.app_state.lab.update(bench="")
    new_window.app_state.facts = None
    new_window.app_state.bench_changed.emit()
    new_window.open_page("Start")
    assert new_window.next.text() == "Next: Open a bench"
    qtbot.mouseClick(new_window.next, Qt.MouseButton.LeftButton)
    assert (new_window.page_shown(), asked) == ("Bench", [])
    assert new_window.next.text() == "Next: Open a bench file …"
    qtbot.mouseClick(new_window.next, Qt.MouseButton.LeftButton)
    assert len(asked) == 1


def test_next_on_the_bench_page_asks_the_instruments_where_one_has_failed(still, qtbot):
    lab = still.app_state.lab
    lab.update(now=replace(lab.state.now, lights=(("supply_z", "fault", "failed"),)))
    still.open_page("Bench")
    still.page("Bench").show_readings()
    lab.changed.emit(lab.state)
    assert still.next.text() == "Next: Check all"
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert len(still.app_state.off_worker.commands(Identify)) == 1


def test_next_on_the_start_page_goes_on_with_the_run(still, qtbot, patience):
    still.open_page("Start")
    broken = replace(RUN, status="interrupted")
    still.page("Start").refresh()
    still.app_state.quick_worker.answer(ListRuns, (broken,))
    assert still.next.text() == "Next: Go on with EM-07"
    goes_on = still.page("Start").go_on_buttons[0]
    qtbot.waitUntil(goes_on.isVisible, timeout=patience)
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert [one.run for one in still.app_state.bench_worker.commands(ResumeRun)] == ["r1"]
    still.app_state.path.take_runs(())


def test_the_run_page_offers_to_go_on_and_next_begins_it_from_any_page(still, qtbot):
    """After a restart the Run page showed a blue Begin alone; Next led to Start and put the focus there."""
    still.app_state.set_identity(dut="EM-07", operator="J. Doe")
    choose = still.page("Run").choose
    for page in ("History", "Run"):
        still.open_page(page)
    still.app_state.quick_worker.answer(
        ListRuns, (replace(RUN, status="interrupted"), replace(RUN, dut_serial="EM-08"))
    )
    assert choose.unfinished.isVisible()
    assert blue(still) == [choose.go_on.text()] == ["Go on with EM-07"]
    qtbot.mouseClick(choose.go_on, Qt.MouseButton.LeftButton)
    asked = still.app_state.bench_worker
    assert [one.run for one in asked.commands(ResumeRun)] == ["r1"]
    asked.answer(ResumeRun, Ended("r1", "interrupted"))
    still.open_page("History")
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert ([one.run for one in asked.commands(ResumeRun)], still.page_shown()) == (["r1"], "Run")
    asked.answer(ResumeRun, Ended("r1", "finished"))
    still.app_state.path.take_runs(())
    assert choose.unfinished.isHidden()


def blue(window):
    seen = window.findChildren(QPushButton, "primary")
    return [one.text() for one in seen if one.isVisible() and one.isEnabled()]


@pytest.mark.parametrize("page", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
@pytest.mark.parametrize("runs", [(), (RUN,), (DONE,)], ids=["nothing", "measured", "traced"])
def test_one_button_at_most_is_blue(still, qtbot, page, runs):
    still.app_state.path.take_runs(runs)
    still.app_state.path.take_calibrations((calibration(signed=False),) if runs == (DONE,) else ())
    still.open_page(page)
    still.page(page)
    qtbot.wait(20)
    assert len(blue(still)) <= 1
    still.app_state.path.take_runs(())
    still.app_state.path.take_calibrations(())


def test_next_is_blue_until_the_page_has_a_blue_button_of_its_own(new_window, qtbot, patience):
    new_window.open_page("History")
    page = new_window.page("History")
    new_window.app_state.quick_worker.answer(ListRuns, (RUN,))
    qtbot.waitUntil(lambda: blue(new_window) == [new_window.next.text()], timeout=patience)
    page.table.selectRow(0)
    qtbot.waitUntil(lambda: blue(new_window) == [page.open.text()], timeout=patience)


def test_a_cage_that_was_not_checked_has_a_button_that_leads_to_its_check(new_window, qtbot):
    app_state, page = new_window.app_state, new_window.page("Start")
    new_window.open_page("Start")
    app_state.facts = replace(app_state.facts, cage=replace(app_state.facts.cage, stated=True))
    app_state.bench_changed.emit()
    assert page.facts["cage"][0].text() == "? not checked"
    qtbot.mouseClick(page.check_cage, Qt.MouseButton.LeftButton)
    assert new_window.page_shown() == "Run"
    assert new_window.page("Run").choose.list.currentItem().text() == "cage-calibration"
    page.refresh()
    today = replace(RUN, started_utc=f"{datetime.now(UTC):%Y-%m-%dT%H:%M:%SZ}")
    app_state.quick_worker.answer(LastCageCheck, Checked(today, None, "PASS"))
    assert page.check_cage.isHidden()


def test_the_loop_page_names_one_figure_for_the_error_before(still, qtbot, patience):
    study, worker, page = still.app_state.study_vm, still.app_state.fit_worker, still.page("Loop")
    still.open_page("Loop")
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    why = "the held-out rms falls from 48.8 to 29.9 nT; evidence over a slow wander without a name: 40 nats, 6 needed"
    loop = told_by_the_loop("reverse")
    worker.answer(CloseLoop, replace(loop, accepted=(replace(loop.accepted[0], why=why),)))

    def causes():
        return [page.others.text(row, column) for row in range(page.others.rowCount()) for column in range(5)]

    alone = "it alone takes 18.9 nT off the held-out rms beside declared errors"
    qtbot.waitUntil(lambda: any(alone in one for one in causes()), timeout=patience)
    assert "50.0 → 50.0 nT" in page.before_after.text()
    assert page.noise.text().startswith("rms of the vector, with declared errors; noise alone ")
    whole = "before → after: held-out rms of the vector, with the errors in it that the run declares"
    assert page.noise.toolTip().startswith(whole)
    assert whole in page.summary.text()
    shown = [one.text() for one in page.findChildren(QLabel) if one.isVisible()]
    shown += causes()
    assert [text for text in shown if "48.8" in text] == []
    page.others.selectRow(0)
    assert all("48.8" not in why for *_, why in candidates(study.loop))


def test_what_a_cause_takes_off_is_the_difference_of_its_two_figures():
    assert as_a_drop("the held-out rms falls from 164.0 to 26.8 nT") == (
        "it alone takes 137.2 nT off the held-out rms beside declared errors"
    )


@pytest.fixture
def english_again(qapp):
    yield
    translate.install_translator(qapp, QLocale("en"))


@pytest.mark.slow
def test_another_language_on_the_fit_page_leaves_one_choice_its_legend_and_the_line_of_the_run(
    new_window, english_again, patience, windows
):
    app_state = new_window.app_state
    new_window.open_page("Fit")
    new_window.page("Fit")
    app_state.study_vm.open("r1")
    app_state.fit_worker.answer(LookAt, looked_at("r1"))
    app_state.study_vm.fits["ml"] = Fitted(FitFigures(True, holdout_rms_scalar_nT=11.0))
    app_state.run.message = "Run r1: finished"
    app_state.lab.update(message="Run r1: finished")
    shown = Shown(new_window)
    shown.speak("de")
    windows.append(shown.window)
    lazy_page = shown.window.lazy_pages["Fit"]
    lazy_page.build()  # in pieces, and between them what waits is drawn
    lazy_page.page.idle_queue.finish()
    page = shown.window.page("Fit")
    assert page.views.against.isHidden()
    assert page.views.words.text().startswith("grau: wie gelesen")
    assert page.verdict.text().startswith("ml: ")
    assert app_state.lab.state.message == "Run r1: finished"


def test_dialogs_and_menus_wear_the_style_of_the_window(still, qtbot):
    dialog, menu = QFileDialog(still), QMenu(still)
    menu.addAction("one")
    for one in (dialog, menu):
        one.show()
        assert one.styleSheet() == still.sheet()
        one.close()
    assert re.search(r"QMenu::item:selected \{ background: #\w+", still.sheet())


def test_what_is_wider_than_its_place_goes_on_in_a_second_row(still, qtbot):
    page = still.page("Fit")
    still.open_page("Fit")
    page.resize(500, 900)
    page.layout().activate()
    buttons = [one for one in (page.fit, page.all, page.draft, page.trace) if one.isVisible()]
    assert all(one.geometry().right() < 500 for one in buttons)
    assert len({one.y() for one in buttons}) > 1
