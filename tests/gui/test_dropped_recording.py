"""A file dropped on the window: a recording of others with its mapping, a run bundle, a calibration."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.messages import ImportBundle, ImportRecording, ListRuns, LookAtRecording, VerifyFile
from labcal.gui.ipc.recording_commands import look, take
from labcal.store import Store

ROWS = 400


def recording(folder, *, swapped=False):
    """A table with its reference, in another order of axes where it is `swapped`."""
    t = 0.1 * np.arange(ROWS)
    a, b = 2 * np.pi * t / 20, 2 * np.pi * t / 33
    field = 48_000 * np.column_stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])
    read = field[:, [1, 0, 2]] * [1, 1, -1] if swapped else field
    lines = ["t_s;dut_x_nT;dut_y_nT;dut_z_nT;ref_x_nT;ref_y_nT;ref_z_nT"]
    lines += [";".join(f"{v:.3f}" for v in row) for row in np.column_stack([t, read + 150.0, field])]
    (path := folder / "field test.csv").write_text("\n".join(lines))
    return path


def drop(window, path, at=None):
    """As the window system hands it over: to whatever is there, and up from it; says whether it was taken."""
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path))])
    place = at or QPoint(window.width() // 2, window.height() // 2)
    actions, button, none = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(place, actions, mime, button, none)
    QApplication.sendEvent(window.windowHandle(), enter)
    if enter.isAccepted():
        QApplication.sendEvent(window.windowHandle(), QDropEvent(QPointF(place), actions, mime, button, none))
    return enter.isAccepted()


def answer(worker, kind, do):
    """By the worker's own function."""
    (command,) = worker.commands(kind)
    worker.answer(kind, do(SimpleNamespace(), command))


@pytest.fixture
def page(still):
    page = still.page("History")
    yield page
    page.faces.setCurrentIndex(0)


def test_a_recording_dropped_anywhere_is_shown_by_its_guessed_mapping_and_imported(still, page, tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "home"))
    worker = still.app_state.fit_worker
    still.open_page("Run")
    assert drop(still, recording(tmp_path))
    view = page.recording
    assert view.isVisible()
    assert not view.go.isEnabled()
    answer(worker, LookAtRecording, look)
    shown = {view.table.text(row, 0): row for row in range(view.table.rowCount())}
    assert view.table.text(shown["reading.columns"], 1) == '["dut_x_nT", "dut_y_nT", "dut_z_nT"]'
    assert view.table.text(shown["reading.columns"], 2) == "48150 / 150 / 150"
    assert view.table.text(shown["time.column"], 4) == "0.2"
    assert "does not say when it began" in view.table.text(shown["started_utc"], 2)
    (x, y) = view.traces._curves[0].getOriginalDataset()
    assert (len(x), y[0]) == (ROWS, pytest.approx(48.15))
    view.go.click()
    answer(worker, ImportRecording, take)
    assert page.faces.currentIndex() == 0
    assert still.app_state.quick_worker.commands(ListRuns)
    with Store.open() as store:
        (run,) = store.runs()
    assert run.status == "imported"


def test_swapped_axes_are_named_corrected_in_the_table_and_checked_before_it_is_imported(still, page, tmp_path):
    worker = still.app_state.fit_worker
    assert drop(still, recording(tmp_path, swapped=True))
    answer(worker, LookAtRecording, look)
    view = page.recording
    assert 'axes ["y", "x", "-z"]' in view.words.text()
    assert view.traces._curves[0].getOriginalDataset()[0][-1] == pytest.approx(0.1 * (ROWS - 1))
    assert not view.go.isEnabled()
    (row,) = (row for row in range(view.table.rowCount()) if view.table.text(row, 0) == "reading.axes")
    view.table.item(row, 1).setText('["y", "x", "-z"]')
    assert not view.go.isEnabled()
    view.show_changes.click()
    answer(worker, LookAtRecording, look)
    assert view.words.text().startswith("✓")
    assert view.table.text(row, 1) == '["y", "x", "-z"]'
    assert view.go.isEnabled()
    view.table.item(row, 1).setText('["x", "y", "z"]')
    assert not view.go.isEnabled(), "what is imported is what was checked"
    view.back.click()
    assert page.faces.currentIndex() == 0
    assert not worker.commands(ImportRecording)


def test_what_was_dropped_before_is_not_shown_in_place_of_what_was_dropped_last(still, page, tmp_path):
    worker = still.app_state.fit_worker
    first = recording(tmp_path)
    (folder := tmp_path / "other").mkdir()
    drop(still, first)
    drop(still, recording(folder, swapped=True))
    early, late = worker.commands(LookAtRecording)
    one, other = worker.asked
    other.then(look(None, late))
    one.then(look(None, early))
    assert "axes" in page.recording.words.text()


def test_a_file_that_is_no_recording_says_so_and_nothing_is_shown(still, page, tmp_path):
    from labcal.errors import InputError
    from labcal.gui.ipc.wire import fault_of

    (path := tmp_path / "notes.txt").write_text("dear diary\nit rained\n")
    assert drop(still, path)
    (asked,) = still.app_state.fit_worker.asked
    with pytest.raises(InputError) as caught:
        look(None, asked.command)
    asked.failed(fault_of(caught.value))
    assert page.recording.fault.isVisible()
    assert page.recording.table.rowCount() == 0
    assert not page.recording.go.isEnabled()
    page.recording.fault.show_fault(None)


def test_a_bundle_is_imported_and_a_calibration_verified(still, page, tmp_path):
    assert drop(still, tmp_path / "run.zip")
    assert [one.path for one in still.app_state.quick_worker.commands(ImportBundle)] == [str(tmp_path / "run.zip")]
    assert drop(still, tmp_path / "cal.json.sshsig")
    assert [one.path for one in still.app_state.quick_worker.commands(VerifyFile)] == [str(tmp_path / "cal.json")]


def test_nothing_is_taken_while_a_run_goes_on(still, page, tmp_path, monkeypatch):
    monkeypatch.setattr(type(still.app_state.run), "alive", property(lambda self: True))
    assert not drop(still, recording(tmp_path))
    assert not still.app_state.fit_worker.asked
