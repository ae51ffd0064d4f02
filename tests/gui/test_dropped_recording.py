"""A file dropped on the window: a recording of others with its mapping, a run bundle, a calibration."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from labcal.errors import InputError
from labcal.files.toml_edit import edited
from labcal.gui.ipc.messages import ImportBundle, ImportRecording, ListRuns, LookAtRecording, VerifyFile
from labcal.gui.ipc.recording_commands import look, take
from labcal.gui.ipc.wire import Fault
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


def drop(window, *paths):
    """As the window system hands it over: to whatever is there, and up from it; says whether it was taken."""
    mime = QMimeData()
    mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    place = QPoint(window.width() // 2, window.height() // 2)
    actions, button, none = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(place, actions, mime, button, none)
    QApplication.sendEvent(window.windowHandle(), enter)
    if enter.isAccepted():
        QApplication.sendEvent(window.windowHandle(), QDropEvent(QPointF(place), actions, mime, button, none))
    return enter.isAccepted()


def typed(view, key, value):
    """A person's value in the line of the mapping that states `key`; then what is asked."""
    (row,) = (row for row in range(view.table.rowCount()) if view.table.text(row, 0) == key)
    view.table.item(row, 1).setText(value)
    view.show_changes.click()


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
    typed(view, "reading.axes", '["y", "x", "-z"]')
    assert not view.go.isEnabled()
    answer(worker, LookAtRecording, look)
    assert view.words.text().startswith("✓")
    (row,) = (row for row in range(view.table.rowCount()) if view.table.text(row, 0) == "reading.axes")
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


@pytest.mark.parametrize(
    ("rows", "key", "value", "said", "then"),
    [
        ([*range(50), 49, *range(50, ROWS)], "time.duplicates", '"drop"', 'duplicates = "drop" under [time]', "✓"),
        ([*range(50), 48, *range(50, ROWS)], "time.backward", '"drop"', 'backward = "drop" under [time]', "✓"),
        ([*range(100), *range(200, ROWS)], "run_id", '"bench-7"', "1 gap, the longest 10.1 s", "✓"),
    ],
)
def test_what_an_objection_asks_for_has_a_line_of_its_own(still, page, tmp_path, rows, key, value, said, then):
    worker, path = still.app_state.fit_worker, recording(tmp_path)
    head, *table = path.read_text().splitlines()
    path.write_text("\n".join([head, *(table[row] for row in rows)]))
    assert drop(still, path)
    answer(worker, LookAtRecording, look)
    assert said in page.recording.words.text()
    typed(page.recording, key, value)
    answer(worker, LookAtRecording, look)
    assert page.recording.words.text().startswith(then)


def test_two_clocks_are_named_and_brought_together(still, page, tmp_path):
    worker, path = still.app_state.fit_worker, recording(tmp_path)
    head, *table = path.read_text().splitlines()
    pairs = zip(table[:-30], table[30:], strict=True)
    late = [";".join([*one.split(";")[:4], *two.split(";")[4:]]) for one, two in pairs]
    path.write_text("\n".join([head, *late]))
    assert drop(still, path)
    answer(worker, LookAtRecording, look)
    assert "two clocks: the reference fits best with 3 s more in its clock_offset_s" in page.recording.words.text()
    typed(page.recording, "reference.clock_offset_s", "3.0")
    answer(worker, LookAtRecording, look)
    assert "two clocks" not in page.recording.words.text()


def test_a_reference_of_another_kind_is_given_what_it_needs(still, page, tmp_path):
    worker, view = still.app_state.fit_worker, page.recording
    assert drop(still, recording(tmp_path))
    answer(worker, LookAtRecording, look)
    for key in ("reference.columns", "reference.frame", "reference.unit"):
        (row,) = (row for row in range(view.table.rowCount()) if view.table.text(row, 0) == key)
        view.table.item(row, 1).setText("")
    typed(view, "reference.kind", '"site"')
    answer(worker, LookAtRecording, look)
    assert "a reference of kind 'site' needs value_nT" in view.words.text()
    typed(view, "reference.value_nT", "48000.0")
    answer(worker, LookAtRecording, look)
    assert view.words.text().startswith("✓")


def test_any_line_of_a_mapping_can_be_stated(still, page, tmp_path):
    worker, view = still.app_state.fit_worker, page.recording
    assert drop(still, recording(tmp_path))
    answer(worker, LookAtRecording, look)
    last = view.table.rowCount() - 1
    view.table.item(last, 1).setText('"EM-1"')
    assert not view.go.isEnabled(), "a value without its key is no mapping"
    view.show_changes.click()
    with pytest.raises(InputError, match='say which line of the mapping states "EM-1"'):
        look(None, worker.commands(LookAtRecording)[-1])
    worker.asked.pop().failed(Fault("input", "say which", ""))
    view.table.item(last, 0).setText("reference.serial")
    view.show_changes.click()
    answer(worker, LookAtRecording, look)
    shown = {view.table.text(row, 0): view.table.text(row, 1) for row in range(view.table.rowCount())}
    assert shown["reference.serial"] == '"EM-1"'
    assert view.words.text().startswith("✓")
    view.fault.show_fault(None)


def test_stamps_are_shown_with_as_many_digits_as_tell_them_apart_and_no_line_is_drawn_over_a_gap(tmp_path):
    path = recording(tmp_path)
    head, *table = path.read_text().splitlines()
    since_1970 = [";".join([f"{1.7e9 + 0.1 * row:.1f}", *one.split(";")[1:]]) for row, one in enumerate(table)]
    path.write_text("\n".join([head, *since_1970[:100], *since_1970[200:]]))
    found = look(None, LookAtRecording(str(path)))
    (stamps,) = (line.first for line in found.lines if line.keys == ("time", "column"))
    assert stamps == ("1700000000", "1700000000.1", "1700000000.2")
    assert np.flatnonzero(np.isnan(found.rows).all(axis=1)).tolist() == [100]
    assert found.rows[[99, 101], 0] == pytest.approx([9.9, 20.0])


def test_a_second_recording_of_the_same_name_says_what_to_state(still, page, tmp_path, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "home"))
    worker, path = still.app_state.fit_worker, recording(tmp_path)
    assert drop(still, path)
    answer(worker, LookAtRecording, look)
    page.recording.go.click()
    answer(worker, ImportRecording, take)
    recording(tmp_path, swapped=True)
    text = look(None, LookAtRecording(str(path))).text
    with pytest.raises(InputError, match=r"field test.csv: the store has another run called \S+: state another run_id"):
        take(None, ImportRecording(str(path), edited(text, ("accept",), '["axes"]')))


def test_several_files_at_once_are_refused_and_a_calibration_with_its_signature_is_one(still, page, tmp_path):
    assert drop(still, tmp_path / "a.csv", tmp_path / "b.csv")
    assert still.fault.isVisible()
    assert not still.app_state.fit_worker.asked
    still.fault.show_fault(None)
    assert drop(still, tmp_path / "cal.json.sshsig", tmp_path / "cal.json")
    assert [one.path for one in still.app_state.quick_worker.commands(VerifyFile)] == [str(tmp_path / "cal.json")]


def test_a_folder_that_is_a_bundle_is_imported(still, page, tmp_path):
    (tmp_path / "run.json").write_text("{}")
    assert drop(still, tmp_path)
    assert [one.path for one in still.app_state.quick_worker.commands(ImportBundle)] == [str(tmp_path)]


def test_the_table_comes_up_in_the_window_s_style(new_window, tmp_path):
    assert drop(new_window, recording(tmp_path))
    assert "QHeaderView" in new_window.page("History").recording.table.styleSheet()
