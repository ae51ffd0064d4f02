"""Fit, loop, certificate, history, bench and start on a run that was made once, through the real workers."""

import json
import zipfile
from pathlib import Path

import numpy as np
import pytest
from lab_states import runs_of
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QFileDialog, QPushButton

from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.study import cause_name

LONG_MS = 180_000


def test_the_start_page_says_what_holds(qtbot, lab):
    lab.open_page("Start")
    page = lab.page("Start")
    qtbot.waitUntil(lambda: "PASS" in page.facts["closing"][0].text(), timeout=LONG_MS)
    assert "closure" in page.facts["closing"][1].text()
    assert "1 in the store" in page.counted.text()
    assert page.interrupted.isHidden()
    qtbot.waitUntil(page.morning.isEnabled, timeout=LONG_MS)


def test_morning_check_opens_its_form(qtbot, lab):
    qtbot.mouseClick(lab.page("Start").morning, Qt.MouseButton.LeftButton)
    choose = lab.page("Run").choose
    qtbot.waitUntil(lambda: choose.form is not None, timeout=LONG_MS)
    assert choose.list.currentItem().text() == "axes-check"


def test_every_instrument_answers_on_the_bench_page(qtbot, lab):
    lab.open_page("Bench")
    page = lab.page("Bench")
    qtbot.waitUntil(page.check.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.check, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.table.text(0, 5) == "✓ answers", timeout=LONG_MS)
    assert [page.table.text(row, 5) for row in range(7)] == ["✓ answers"] * 7
    assert "THURLBY" in page.table.text(0, 3).upper()
    assert all(light == "ok" for _, light, _ in lab.app_state.lab.state.now.lights)


def test_a_run_is_opened_from_the_history_and_fitted(qtbot, lab):
    lab.app_state.study_vm.forget("")  # whatever was fitted before
    lab.app_state.study_vm.changed.emit()
    assert len(runs_of(qtbot, lab)) == 1
    history = lab.page("History")
    history.search.setText("another")
    assert history.table.rowCount() == 0
    history.search.setText("em-07 preflight")
    history.table.selectRow(0)
    qtbot.mouseClick(history.open, Qt.MouseButton.LeftButton)
    page, study = lab.page("Fit"), lab.app_state.study_vm
    qtbot.waitUntil(page.fit.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.fit, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "ml" in study.fits or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    assert study.fits["ml"].fit.ok
    assert page.table.horizontalHeaderItem(1).text() == "ml"
    rows = {page.table.text(row, 0): page.table.text(row, 1) for row in range(page.table.rowCount())}
    assert rows["frame"] == "known"
    assert " ± " in rows["offset k x  nT"]
    assert " ± " in rows["gain K x by y"]
    assert page.views.against.count() > 5


def test_every_view_of_a_fit_has_something_to_show(qtbot, fitted):
    from labcal.gui.widgets.fit_views import FACES

    page, study = fitted.page("Fit"), fitted.app_state.study_vm
    views = page.views
    for n in range(views.view.count()):
        views.view.setCurrentIndex(n)
        views.view.activated.emit(n)
        assert views.shown() == FACES[n]
        assert views.faces.currentWidget() is getattr(views, FACES[n])
    views.view.setCurrentIndex(FACES.index("growth"))
    qtbot.waitUntil(lambda: "ekf" in study.growth or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    qtbot.waitUntil(lambda: len(views.growth.getPlotItem().listDataItems()) >= 3, timeout=LONG_MS)
    assert len(views.magnitude.getPlotItem().listDataItems()) == 3
    assert "rms" in views.histogram.getPlotItem().titleLabel.text
    assert len(views.residual.clouds) == 1


@pytest.mark.parametrize(("face", "columns"), [("residual", 2), ("histogram", 4), ("magnitude", 6)])
def test_a_picture_is_saved_and_its_numbers_are_copied(qtbot, fitted, tmp_path, face, columns):
    from labcal.gui.widgets import plot_export
    from labcal.gui.widgets.fit_views import FACES

    views = fitted.page("Fit").views
    views.view.setCurrentIndex(FACES.index(face))
    views.view.activated.emit(FACES.index(face))
    copier = next(b for b in views.findChildren(QPushButton) if b.text() == "Copy")
    qtbot.mouseClick(copier, Qt.MouseButton.LeftButton)
    rows = [row.split("\t") for row in QApplication.clipboard().text().splitlines()]
    assert {len(row) for row in rows} == {columns}
    if face == "residual":
        drawn = fitted.app_state.study_vm.fits["ml"].residual
        assert sorted(float(row[1]) for row in rows[1:]) == pytest.approx(sorted(drawn[np.isfinite(drawn)]))
    plot_export.save(getattr(views, face), str(tmp_path / "picture"))
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


def test_the_loop_tells_its_story_and_leaves_a_draft(qtbot, fitted):
    study = fitted.app_state.study_vm
    study.loop = None
    study.changed.emit()
    fitted.open_page("Fit")
    qtbot.mouseClick(fitted.page("Fit").trace, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: study.loop is not None, timeout=LONG_MS)
    page, loop = fitted.page("Loop"), study.loop
    assert page.story.isVisible()
    assert loop.verdict.upper().replace("-", " ") in page.verdict.text().replace("-", " ")
    assert page.summary.text().startswith(loop.summary)
    assert "→" in page.before_after.text()
    assert Path(loop.draft).is_file()


def test_a_cause_that_was_not_named_is_picked_and_its_change_is_drawn(qtbot, traced):
    page, study = traced.page("Loop"), traced.app_state.study_vm
    qtbot.waitUntil(lambda: page.others.rowCount() > 0, timeout=LONG_MS)
    rejected = next(n for n in range(page.others.rowCount()) if page.others.text(n, 3) == "– not named")
    name, why = page.others.text(rejected, 0), page.others.text(rejected, 4)
    page.others.scrollToItem(page.others.item(rejected, 0))
    place = page.others.visualItemRect(page.others.item(rejected, 0)).center()
    qtbot.mouseClick(page.others.viewport(), Qt.MouseButton.LeftButton, pos=place)
    chosen = page.picked().cause
    of_study = cause_name(chosen.effect, chosen.channels)
    qtbot.waitUntil(lambda: of_study in study.causes or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    assert name in page.change_heading.text()
    assert page.change_words.text().startswith("it alone would leave ")
    whole = page.others.item(rejected, 4).toolTip().splitlines()[-1]  # below what is said of it in short
    assert page.change_why.text() == f"{name}: {whole}"
    assert why
    page.others.clearSelection()
    assert page.change_heading.text() == "2  What it changes"


def test_a_fault_unfolds_its_details_and_a_problem_report_holds_them_and_no_key(qtbot, lab, tmp_path, monkeypatch):
    out = tmp_path / "problem.zip"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (str(out), "*.zip"))
    lab.app_state.fault.emit(Fault("instrument", "The reference is silent.", "Check its plug.", "Traceback: …"))
    card = lab.fault
    assert not card.details.isVisible()
    qtbot.mouseClick(card.fold, Qt.MouseButton.LeftButton)
    assert card.details.isVisible()
    assert card.details.toPlainText().endswith("\n\nTraceback: …")  # what it is for stands before it
    save = next(one for one in card.findChildren(QPushButton) if one.text().startswith("Save a problem"))
    qtbot.mouseClick(save, Qt.MouseButton.LeftButton)
    with zipfile.ZipFile(out) as packed:
        assert packed.namelist() == ["problem.json", "bench.toml"]
        told = json.loads(packed.read("problem.json"))
    assert told["fault"]["text"] == "The reference is silent."
    assert told["packages"]["labcal"]


def test_another_theme_and_the_wall_size_keep_what_is_known(qtbot, fitted):
    from labcal.gui.theming.theme import DARK, LIGHT

    lab = fitted
    lab.open_page("Fit")
    pages = {name: lab.page(name) for name in lab.lazy_pages}
    lab.set_theme(DARK)
    views = lab.page("Fit").views
    qtbot.waitUntil(lambda: views.loci.plots[0].backgroundBrush().color().name() == DARK.surface, timeout=LONG_MS)
    qtbot.waitUntil(lambda: DARK.surface in lab.page("History").table.styleSheet(), timeout=LONG_MS)
    assert pages == {name: lab.page(name) for name in lab.lazy_pages}  # in place: what is chosen stays chosen
    assert lab.page("Fit").table.horizontalHeaderItem(1).text() == "ml"
    size = lab.size()
    lab.resize(2400, 1400)  # wide at either size of its words
    before, words = lab.sidebar.width(), lab.top.off.fontMetrics().height()
    lab.toggle_wall()
    assert lab.sidebar.width() > 1.5 * before
    qtbot.waitUntil(lambda: lab.top.off.fontMetrics().height() > 1.5 * words, timeout=LONG_MS)
    lab.toggle_wall()
    lab.set_theme(LIGHT)
    lab.style_queue.finish()
    lab.resize(size)


@pytest.mark.parametrize("name", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_f12_is_heard_on_every_page(qtbot, lab, name):
    lab.open_page(name)
    with qtbot.waitSignal(lab.coils_off, timeout=2000):
        qtbot.keyClick(lab.lazy_pages[name], Qt.Key.Key_F12)
