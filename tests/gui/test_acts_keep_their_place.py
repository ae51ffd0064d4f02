"""Stop and its neighbours lie where they lay, whatever they say; a click meant for what lay there does nothing."""

import pytest
from PySide6.QtCore import QPoint, Qt
from test_nothing_is_cut import other_language as other_language
from test_nothing_is_cut import settle

from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.widgets import next_button
from labcal.record.stream import Event, Step

TOLD = "The buttons of the run have just changed: nothing was done. Press again."
PAUSED, GOES_ON = Event(2.0, "pause", "paused, coils at zero", {}), Event(3.0, "pause", "goes on", {})


@pytest.fixture
def live(new_window):
    new_window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    new_window.app_state.bench_worker.items.emit((Step(0.0, 1, 2, "zero", 60.0, ("zero", "closing")),))
    new_window.open_page("Run")
    settle(new_window)
    return new_window.page("Run").live


def places(live):
    window = live.window()
    settle(window)
    return [(one.mapTo(window, QPoint()), one.size()) for one in (live.pause, live.stop)]


def tell(live, event):
    live._app_state.bench_worker.items.emit((event,))


@pytest.mark.parametrize("other_language", ["en", "de", "fr"], indirect=True)
def test_pause_and_stop_keep_their_places_from_pause_to_go_on_and_back(other_language, live):
    before = places(live)
    assert live.pause.height() == live.stop.height(), "one row"
    live.pause.click()
    assert places(live) == before
    words = {live.pause.text()}
    for event in (PAUSED, GOES_ON):
        tell(live, event)
        assert places(live) == before
        words.add(live.pause.text())
    assert len(words) == 3


def test_a_click_where_another_button_has_just_lain_does_nothing_and_says_so(live, qtbot, monkeypatch):
    stopped, app_state = [], live._app_state
    live.stop.clicked.connect(lambda: stopped.append("clicked"))
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    live.stop.move(live.stop.pos() - QPoint(live.pause.width(), 0))
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    assert (stopped, app_state.lab.state.message) == ([], TOLD)
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 0)
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    assert stopped == ["clicked"]


def test_go_on_takes_no_click_that_was_meant_for_pause(live, qtbot, monkeypatch):
    live.pause.click()
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    tell(live, PAUSED)
    qtbot.mouseClick(live.pause, Qt.MouseButton.LeftButton)
    assert live._run.state == "paused"
    assert len(live._app_state.bench_worker.said) == 1


def test_stop_is_taken_at_once_where_nothing_has_moved(live, qtbot, monkeypatch):
    """Another page was open before: that changes nothing of these buttons."""
    window = live.window()
    window.open_page("Start")
    settle(window)
    live.stop._changed_s = None
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    window.open_page("Run")
    settle(window)
    qtbot.mouseClick(live.stop, Qt.MouseButton.LeftButton)
    assert live._run.state == "stopping"
