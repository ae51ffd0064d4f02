from threading import Thread
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QEvent, QObject, QSettings, Qt
from PySide6.QtWidgets import QLineEdit, QWidget

from labcal.gui.frame import Frame
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import LabNow


@pytest.fixture
def lab():
    return LabViewModel()


@pytest.fixture
def frame(qtbot, lab):
    window = Frame(lab, {"Start": QLineEdit(), "Bench": QWidget(), "Run": QWidget()})
    qtbot.addWidget(window)
    window.show()
    return window


def test_f12_takes_the_coils_to_zero_even_while_a_field_has_the_focus(qtbot, frame):
    entry = frame.stack.currentWidget()
    entry.setFocus()
    with qtbot.waitSignal(frame.coils_off, timeout=1000):
        qtbot.keyClick(entry, Qt.Key.Key_F12)
    assert entry.text() == ""


def test_the_button_takes_the_coils_to_zero(qtbot, frame):
    with qtbot.waitSignal(frame.coils_off, timeout=1000):
        qtbot.mouseClick(frame.top.off, Qt.MouseButton.LeftButton)


def test_closing_the_window_takes_the_coils_to_zero(qtbot, frame):
    with qtbot.waitSignal(frame.coils_off, timeout=1000):
        frame.close()


def test_simulated_is_shown_where_it_is_and_only_there(lab, frame):
    lab.update(simulated=True)
    assert frame.top.simulated.isVisible()
    lab.update(simulated=False)
    assert not frame.top.simulated.isVisible()


def test_the_unit_button_changes_what_is_shown_and_nothing_else(qtbot, lab, frame):
    lab.update(now=LabNow(field_measured_nT=(0.0, 0.0, -19998.7)))
    assert "\u221219\u202f998.7" in texts(frame.side)
    qtbot.mouseClick(frame.side.unit, Qt.MouseButton.LeftButton)
    assert "\u221219.9987" in texts(frame.side)
    assert lab.state.now.field_measured_nT == (0.0, 0.0, -19998.7)


def test_what_is_not_known_is_shown_as_such(frame):
    assert "–" in texts(frame.side)
    assert "energised" not in " ".join(texts(frame.side))


def test_control_and_a_number_open_a_page(qtbot, frame):
    qtbot.waitExposed(frame)
    qtbot.keyClick(frame, Qt.Key.Key_2, Qt.KeyboardModifier.ControlModifier)
    assert frame.stack.currentIndex() == 1


def texts(widget):
    from PySide6.QtWidgets import QLabel

    return [child.text() for child in widget.findChildren(QLabel)]


def test_the_window_comes_back_where_it_stood_with_what_was_chosen(qtbot, tmp_path, deaf, windows, monkeypatch):
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels import app_state
    from labcal.gui.window import Window

    monkeypatch.setattr(app_state, "Client", lambda parent: deaf())
    stood = []
    for _ in range(2):
        settings = QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)
        window = Window(app_state.AppState(settings), LIGHT)
        windows.append(window)
        window.show()
        stood.append((window.isMaximized(), window.wall, window.top.operator.text()))
        window.showMaximized()
        window.app_state.set_identity(operator="J. Doe")
        if not window.wall:
            window.toggle_wall()
        window.close()
        settings.sync()
    assert stood == [(False, False, ""), (True, True, "J. Doe")]


class Shown(QObject):
    """Keeps whatever was shown as a window."""

    def __init__(self):
        super().__init__()
        self.seen = []

    def eventFilter(self, watched, event):
        if event.type() == QEvent.Type.Show and isinstance(watched, QWidget) and watched.isWindow():
            self.seen.append(watched)
        return False


def test_pages_that_are_built_ahead_come_up_in_no_window_of_their_own(tmp_path, deaf, windows, monkeypatch, qapp):
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels import app_state
    from labcal.gui.window import Window

    monkeypatch.setattr(app_state, "Client", lambda parent: deaf())
    watching = Shown()
    qapp.installEventFilter(watching)
    window = Window(app_state.AppState(QSettings(str(tmp_path / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
    windows.append(window)
    for page in window.lazy_pages.values():
        page.built()
    qapp.removeEventFilter(watching)
    assert watching.seen == []
    window.close()


def test_pages_out_of_sight_are_not_built_while_a_run_goes_on(still, monkeypatch):
    built = []
    there = SimpleNamespace(ready=True)
    missing = SimpleNamespace(ready=False, isVisible=lambda: False, page=object(), build=lambda: built.append("Fit"))
    read = Thread(target=built.clear)
    read.start()
    read.join()
    monkeypatch.setattr(still, "lazy_pages", {"Start": there, "Fit": missing})
    monkeypatch.setattr(still, "imports", read)
    for state, expected in (("running", []), ("idle", ["Fit"])):
        monkeypatch.setattr(still.app_state.run, "state", state)
        still.prebuild()
        still.prebuild_timer.stop()
        assert built == expected
