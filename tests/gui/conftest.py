"""The window under test: its own home, its own settings, the simulated bench at once."""

import time
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, QSettings, Signal

from labcal.gui.desk import Desk
from labcal.gui.theme import LIGHT

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
KEPT = []  # windows that were closed: plots that the collector takes apart in its own order bring Qt down
SCAN_WAIT_MS = 40
PATIENCE_MS = 180_000  # a condition that does not come true fails the test; a slow computer does not


class Deaf(QObject):
    """A worker that answers only when it is told to."""

    items = Signal(list)
    states = Signal(dict)
    progress = Signal(str)

    def __init__(self):
        super().__init__()
        self.asked, self.said, self.killed, self.busy, self.pid = [], [], 0, False, 0

    def ask(self, do, then, failed, **what):
        self.asked.append((do, then, failed, what))

    def say(self, do, **what):
        self.said.append((do, what))

    def kill(self):
        self.killed += 1

    def hang_up(self, wait_ms=0):
        pass

    def answer(self, do, result):
        """Answer every request for `do` that waits."""
        mine = [one for one in self.asked if one[0] == do]
        self.asked = [one for one in self.asked if one[0] != do]
        for _, then, _, _ in mine:
            then(result)


@pytest.fixture(scope="session")
def kept_windows():
    return KEPT


@pytest.fixture
def patience():
    return PATIENCE_MS


@pytest.fixture
def deaf(qapp):
    return Deaf


def settings_in(folder):
    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    settings.setValue("pace", "at once")
    settings.setValue("seed", 3)
    return settings


@pytest.fixture(scope="session")
def deaf_window(tmp_path_factory, qapp):
    """A window whose workers are all deaf: no process is started. One for all tests."""
    from labcal.gui import desk as rooms
    from labcal.gui.bench_verbs import procedures
    from labcal.gui.window import Window

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(rooms, "Client", lambda parent: Deaf())
        window = Window(Desk(settings_in(tmp_path_factory.mktemp("home"))), LIGHT)
    KEPT.append(window)
    window.show()
    window.open_page("Run")
    window.page("Run")
    window.desk.clerk.answer("procedures", procedures(None))
    yield window
    window.close()


@pytest.fixture
def still(deaf_window):
    """The window on a bench that is known, with nothing asked, said or begun."""
    from labcal.gui.bench_verbs import bench_facts

    window, desk = deaf_window, deaf_window.desk
    window.raise_()
    window.activateWindow()
    for worker in (desk.clerk, desk.bench_worker, desk.study, desk.switch):
        worker.asked, worker.said, worker.killed = [], [], 0
    scanner = window.scanner
    scanner._now, scanner._kept = time.monotonic, []
    scanner._wait.setInterval(SCAN_WAIT_MS)
    desk._force.setInterval(3_600_000)  # a test calls it, and no clock does
    desk._force.stop()
    desk.run._forget()
    desk.known = desk._taken = None
    desk.lab.update(coils_at_zero=None)
    desk.run.order = None
    desk.study_vm._forget("")
    desk.run.changed.emit()
    window.page("Run").live.put_away.emit()
    for card in (window.fault, window.page("Run").live.fault):
        card.show_fault(None)
    desk.open_bench(str(BENCH))
    desk.clerk.answer("bench", bench_facts(None, str(BENCH)))
    desk.who(operator="J. Doe", dut="EM-07")
    window.open_page("Run")
    return window


@pytest.fixture(scope="module")
def alive(tmp_path_factory, qapp):
    """One window with real workers for all tests of a file; each finds it without a run."""
    from labcal.gui.window import Window

    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        window = Window(Desk(settings_in(home)), LIGHT)
        window.home = str(home)
        window.show()
        window.desk.open_bench(str(BENCH))
        KEPT.append(window)
        yield window
        window.close()


@pytest.fixture
def window(qtbot, alive, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", alive.home)
    desk = alive.desk
    if desk.run.alive:
        desk.run.abort()
        qtbot.waitUntil(lambda: not desk.run.alive, timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: bool(desk.facts) and not desk.switch.busy, timeout=PATIENCE_MS)
    desk.who(operator="J. Doe", dut="EM-07")
    return alive
