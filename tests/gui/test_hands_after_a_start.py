"""Closing and starting the window while hands have to be off: nobody goes without a word, nobody begins without one."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel
from test_hands_in_the_cage import lab

from labcal.gui.ipc.bench_commands import read_bench
from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.ipc.messages import ReadBench, SwitchOff


@pytest.fixture
def opened(new_window):
    """A window in which a bench on lines of its own has just been opened."""
    app_state = new_window.app_state
    bench = app_state.bench
    app_state.forget()
    app_state.open_bench(bench)
    facts = replace(read_bench(None, ReadBench(bench)), virtual_time=False, simulated=False)
    app_state.quick_worker.answer(ReadBench, facts)
    return new_window


@pytest.fixture
def silent(opened):
    """Coil z carried 1.1 A, and its supply does not answer any more."""
    opened.app_state.take_lab(lab((0.0, 0.0, 1.1)))
    opened.app_state.take_lab(lab((0.0, 0.0, None)))
    return opened


def words(dialog):
    return "\n".join(one.text() for one in dialog.findChildren(QLabel) if one.isVisible())


@pytest.mark.parametrize("guarded", [True, False])
def test_closing_with_a_coil_on_says_which_and_stays(qtbot, silent, monkeypatch, guarded):
    monkeypatch.setattr("labcal.bench.guardian.client.is_guarded", lambda bench: guarded)
    silent.close()
    dialog = silent.leaving.still_on
    assert (silent.isVisible(), dialog.isVisible(), dialog.stay.isDefault()) == (True, True, True)
    said = words(dialog)
    for part in (
        "HANDS OFF: the coils may be on",
        "z: +1.100 A when last read",
        "COILS OFF (F12), then switch off by hand: supply_z",
    ):
        assert part in said
    assert ("the guardian keeps trying" in said, "No guardian" in said) == (guarded, not guarded)
    qtbot.keyClick(dialog, Qt.Key.Key_Return)
    assert (silent.isVisible(), dialog.isVisible()) == (True, False)


def test_the_question_goes_once_the_coils_are_at_zero(silent):
    silent.close()
    silent.app_state.take_lab(lab())
    assert (silent.isVisible(), silent.leaving.still_on.isVisible()) == (True, False)


def test_who_closes_all_the_same_says_off_first(qtbot, silent):
    silent.close()
    qtbot.mouseClick(silent.leaving.still_on.go, Qt.MouseButton.LeftButton)
    assert not silent.isVisible()
    assert silent.app_state.off_worker.commands(SwitchOff)


def test_what_is_asked_is_whole_whatever_is_said_later(qtbot, silent):
    silent.close()
    dialog = silent.leaving.still_on
    dialog.coils.setText("z: it is silent, and what it carries is not known. " * 12)
    qtbot.waitUntil(lambda: dialog.coils.height() >= dialog.coils.heightForWidth(dialog.coils.width()))
    assert dialog.rect().contains(dialog.go.geometry())


def test_with_the_coils_at_zero_nothing_is_asked(opened):
    opened.app_state.take_lab(lab())
    opened.close()
    assert (opened.isVisible(), opened.leaving.still_on) == (False, None)


def test_a_bench_that_is_open_and_unread_keeps_hands_out_on_every_page(opened):
    for page in opened.lazy_pages:
        opened.open_page(page)
        for place in (opened.side.keep_off, opened.top.keep_off):
            assert (place.isVisible(), place.text()) == (True, "▲ Hands off")
    assert opened.side.zero_words.text() == "● coils not read back in this session"


def test_a_simulated_lab_is_not_read_and_alarms_nobody(still):
    assert still.app_state.watch_worker.commands(ReadLab) == []
    assert still.side.keep_off.property("state") == "off"
