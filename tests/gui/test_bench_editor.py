"""A bench file edited in the window: limits first, what would change is seen before it is saved, comments stay."""

from pathlib import Path
from shutil import copy

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog

from labcal.bench.config import read_config
from labcal.bench.find import Found, draft
from labcal.gui.ipc.bench_file_commands import edit
from labcal.gui.ipc.messages import EditBench, FindOnLines, ReadBench
from labcal.gui.ipc.wire import fault_of
from labcal.gui.translations.sentences import form_of
from labcal.session.bench_settings import settings

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
CURRENT, RAMP = "cage.limits.current_A", "cage.limits.ramp_A_per_s"


@pytest.fixture
def file(tmp_path):
    return copy(BENCH, tmp_path / "bench.toml")


@pytest.fixture
def page(still):
    still.open_page("Bench")
    page = still.page("Bench")
    yield page
    page.faces.setCurrentIndex(0)


def answer(page):
    """As the worker would."""
    worker = page.window().app_state.quick_worker
    asked = next(one for one in worker.asked if isinstance(one.command, EditBench))
    worker.asked.remove(asked)
    try:
        said = edit(None, asked.command)
    except Exception as error:
        asked.failed(fault_of(error))
    else:
        asked.then(said)


def opened(page, qtbot, file):
    page.window().app_state.bench = str(file)
    qtbot.mouseClick(page.edit, Qt.MouseButton.LeftButton)
    answer(page)
    return page.editor


def write(editor, name, text):
    names = [editor.table.text(row, 0) for row in range(editor.table.rowCount())]
    editor.table.item(names.index(name), 1).setText(text)


def test_limits_come_first_and_one_line_is_changed_after_it_was_seen(still, page, qtbot, file):
    before = file.read_text()
    editor = opened(page, qtbot, file)
    assert [editor.table.text(0, column) for column in range(3)] == [CURRENT, "2.5", "A"]
    write(editor, CURRENT, "2.25")
    assert not editor.save.isEnabled()
    qtbot.mouseClick(editor.show_difference, Qt.MouseButton.LeftButton)
    answer(page)
    assert "-current_A = 2.5\n+current_A = 2.25" in editor.difference.toPlainText()
    assert editor.words.text() == "✓ A bench file"
    assert file.read_text() == before
    qtbot.mouseClick(editor.save, Qt.MouseButton.LeftButton)
    answer(page)
    assert file.read_text() == before.replace("current_A = 2.5\n", "current_A = 2.25\n")
    assert editor.changes() == ()
    assert still.app_state.quick_worker.commands(ReadBench) == [ReadBench(str(file))]  # the open bench is read again


def test_what_was_seen_is_no_longer_saved_once_something_else_is_typed(page, qtbot, file):
    editor = opened(page, qtbot, file)
    write(editor, CURRENT, "2.25")
    editor.show_difference.click()
    answer(page)
    write(editor, RAMP, "1.0")
    assert not editor.save.isEnabled()
    assert editor.difference.toPlainText() == ""


@pytest.mark.parametrize(
    ("text", "words"),
    [
        pytest.param("2,5", "is no value of TOML", marks=pytest.mark.slow),
        ("-1.0", "must be greater than 0"),
        pytest.param("", "is missing", marks=pytest.mark.slow),
    ],
)
def test_a_bench_file_stays_one(page, qtbot, file, text, words):
    before = file.read_text()
    editor = opened(page, qtbot, file)
    write(editor, CURRENT, text)
    editor.show_difference.click()
    answer(page)
    if editor.save.isEnabled():
        assert words in editor.words.text()
        editor.save.click()
        answer(page)
    assert words in editor.fault.text.text()
    assert file.read_text() == before


def test_what_another_has_changed_meanwhile_is_not_overwritten(page, qtbot, file):
    editor = opened(page, qtbot, file)
    write(editor, CURRENT, "2.25")
    editor.show_difference.click()
    answer(page)
    other = file.read_text().replace("field_nT = 120000.0", "field_nT = 90000.0")
    file.write_text(other)
    editor.save.click()
    answer(page)
    assert "changed by somebody else" in editor.fault.text.text()
    assert file.read_text() == other


def test_nothing_is_saved_while_a_run_goes_on(still, page, qtbot, file, monkeypatch):
    editor = opened(page, qtbot, file)
    write(editor, CURRENT, "2.25")
    editor.show_difference.click()
    answer(page)
    monkeypatch.setattr(type(still.app_state.run), "alive", property(lambda _: True))
    still.app_state.run.changed.emit()
    assert not editor.save.isEnabled()


def test_a_draft_of_what_answers_is_edited_and_kept_before_it_is_whole(still, page, qtbot, tmp_path, monkeypatch):
    out = tmp_path / "new.toml"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (str(out), "*.toml"))
    qtbot.mouseClick(page.make, Qt.MouseButton.LeftButton)
    assert still.app_state.off_worker.commands(FindOnLines) == [FindOnLines(str(out))]
    out.write_text(draft([Found("serial:///dev/ttyUSB0", "TTI PL303", "tti-pl", "coil")]))
    still.app_state.off_worker.answer(FindOnLines, ("serial:///dev/ttyUSB0: TTI PL303: tti-pl",))
    answer(page)
    editor = page.editor
    write(editor, CURRENT, "2.0")
    write(editor, "instruments.tti_pl_1.role", '"coil-x"')
    editor.show_difference.click()
    answer(page)
    assert "▲ Not a bench file then: line" in editor.words.text()
    editor.save.click()
    answer(page)
    assert "current_A = 2.0  # what the thinnest wire of a coil bears for ever" in out.read_text()


def test_every_setting_of_the_example_is_told_with_what_holds_where_nothing_is_stated():
    _, found = settings(BENCH)
    by_name = {".".join(one.keys): one for one in found}
    assert by_name["platform.wrap_deg"].usual == "400.0"
    assert by_name["cage.limits.temperature_C"].meaning == "of the windings, where a channel tells it"
    assert {one.meaning for one in found if one.meaning and form_of(one.meaning) is None} == set()
    assert [one.keys for one in found if not one.here] == [("cage", "matrix_nT_per_A")]
    assert read_config(BENCH).cage.limits.current_A[0] == float(by_name[CURRENT].value)
