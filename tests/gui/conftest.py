"""The window under test: its own home, its own settings, the simulated bench at once."""

import time
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.app_state import AppState
from labcal.testing.pages import DeafWorker

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
KEPT = []  # windows that were closed: plots that the collector takes apart in its own order bring Qt down
SCAN_WAIT_MS = 40
PATIENCE_MS = 180_000  # a condition that does not come true fails the test; a slow computer does not


@pytest.fixture(scope="session")
def kept_windows():
    return KEPT


@pytest.fixture
def patience():
    return PATIENCE_MS


@pytest.fixture
def deaf(qapp):
    return DeafWorker


def settings_in(folder):
    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    settings.setValue("seed", 3)
    return settings


@pytest.fixture(scope="session")
def deaf_window(tmp_path_factory, qapp):
    """A window whose workers are all deaf: no process is started. One for all tests."""
    from labcal.gui.ipc.bench_commands import procedures
    from labcal.gui.viewmodels import app_state
    from labcal.gui.window import Window

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(app_state, "Client", DeafWorker)
        window = Window(AppState(settings_in(tmp_path_factory.mktemp("home"))), LIGHT)
    KEPT.append(window)
    window.show()
    window.open_page("Run")
    window.page("Run")
    window.app_state.quick_worker.answer("procedures", procedures(None))
    yield window
    window.close()


@pytest.fixture
def still(deaf_window):
    """The window on a bench that is known, with nothing asked, said or begun."""
    from labcal.gui.ipc.bench_commands import bench_facts

    window, app_state = deaf_window, deaf_window.app_state
    window.raise_()
    window.activateWindow()
    for worker in (app_state.quick_worker, app_state.bench_worker, app_state.fit_worker, app_state.off_worker):
        worker.asked, worker.said, worker.killed = [], [], 0
    scanner = window.scanner
    scanner._now, scanner._kept = time.monotonic, []
    scanner._wait.setInterval(SCAN_WAIT_MS)
    app_state._force_timer.setInterval(3_600_000)  # a test calls it, and no clock does
    app_state._force_timer.stop()
    app_state.run._forget()
    app_state.known = app_state._taken = None
    app_state.lab.update(coils_at_zero=None)
    app_state.run.order = None
    app_state.study_vm._forget("")
    app_state.run.changed.emit()
    window.page("Run").live.put_away.emit()
    for card in (window.fault, window.page("Run").live.fault):
        card.show_fault(None)
    app_state.open_bench(str(BENCH))
    app_state.quick_worker.answer("bench", bench_facts(None, str(BENCH)))
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    window.open_page("Run")
    return window


@pytest.fixture(scope="module")
def alive(tmp_path_factory, qapp):
    """One window with real workers for all tests of a file; each finds it without a run."""
    from labcal.gui.window import Window

    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        window = Window(AppState(settings_in(home)), LIGHT)
        window.home = str(home)
        window.show()
        window.app_state.open_bench(str(BENCH))
        KEPT.append(window)
        yield window
        window.close()


@pytest.fixture
def window(qtbot, alive, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", alive.home)
    app_state = alive.app_state
    if app_state.run.alive:
        app_state.run.abort()
        qtbot.waitUntil(lambda: not app_state.run.alive, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: bool(app_state.facts) and not app_state.off_worker.busy, timeout=PATIENCE_MS)
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    return alive
