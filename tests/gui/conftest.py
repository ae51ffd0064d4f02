"""The window under test: its own home, its own settings, the simulated bench at once."""

import time
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from shutil import copytree
from types import SimpleNamespace

import pytest
from deaf_windows import deaf_window_at, settings_in, take_apart
from lab_states import runs_of
from PySide6.QtCore import QSettings, Qt

from labcal.gui.ipc.messages import CloseLoop
from labcal.gui.theming.font import interface_font
from labcal.gui.theming.theme import LIGHT
from labcal.gui.translations import sentences
from labcal.gui.viewmodels import app_state
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets import hold_button, next_button, prompt_card
from labcal.gui.widgets.fault_card import FaultCard
from labcal.testing.pages import DeafWorker

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
SHORT = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}
SCAN_WAIT_MS = 40
DEAD_MS = 1  # of a question; test_hold_button.py tests the second that it is
PATIENCE_MS = 180_000  # a condition that does not come true fails the test; a slow computer does not


@pytest.fixture(autouse=True)
def answered_soon(monkeypatch):
    """No second is waited for at each question, no key of the test before is down, and no bench file has a name."""
    monkeypatch.setattr(sentences.BenchFile, "name", sentences.BENCH_FILE)
    monkeypatch.setattr(prompt_card, "DEAD_MS", DEAD_MS)
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 0)  # a test reads no words
    hold_button.heard_ms.clear()


@pytest.fixture(scope="session", autouse=True)
def letters(qapp):
    """Those that labcal brings: what fits is the same on every computer."""
    qapp.setFont(interface_font(qapp.font()))


@pytest.fixture
def by_mouse(qtbot):
    """Answers by a button, as soon as it is alive: a click, or held where it wants that."""

    def answer(button):
        qtbot.waitUntil(button.isEnabled, timeout=PATIENCE_MS)
        if getattr(button, "held_by_mouse", False):
            button.held.setInterval(0)  # counted, not waited for
            answered = []
            button.clicked.connect(lambda: answered.append(button))
            qtbot.mousePress(button, Qt.MouseButton.LeftButton)
            qtbot.waitUntil(lambda: bool(answered), timeout=PATIENCE_MS)
        else:
            qtbot.mouseClick(button, Qt.MouseButton.LeftButton)

    return answer


@pytest.fixture
def windows():
    """The windows that a test opens by itself: taken apart after it."""
    opened = []
    yield opened
    for window in opened:
        take_apart(window)


@pytest.fixture
def patience():
    return PATIENCE_MS


@pytest.fixture
def deaf(qapp):
    return DeafWorker


@pytest.fixture(scope="session")
def deaf_window(tmp_path_factory, qapp):
    """One for all tests."""
    with deaf_window_at(tmp_path_factory.mktemp("home")) as window:
        yield window


@pytest.fixture
def still(deaf_window):
    """The window on a bench that is known, with nothing asked, said or begun."""
    return at_rest(deaf_window)


@pytest.fixture
def later(still, monkeypatch):
    """Lets so many seconds go by, for what grows old; by itself, however long the test takes, nothing does."""
    passed, began_s = [0.0], time.monotonic()
    clock = staticmethod(lambda: began_s + passed[0])
    monkeypatch.setattr(app_state, "time", type("Later", (), {"monotonic": clock}))

    def go(seconds):
        passed[0] += seconds
        still.app_state.grow_old()

    return go


@pytest.fixture
def fixed(still):
    """The same, whose ages are not looked at by themselves: what a test has shown stands, however long it takes."""
    still.app_state.age_timer.stop()
    yield still
    still.app_state.age_timer.start()


@pytest.fixture
def new_window(tmp_path, qapp):
    """The same for one test alone, where what other tests have shown before would count."""
    with deaf_window_at(tmp_path) as window:
        yield at_rest(window)


@pytest.fixture(scope="module")
def window_of_file(tmp_path_factory, qapp):
    with deaf_window_at(tmp_path_factory.mktemp("home")) as window:
        yield window


@pytest.fixture
def same_window(window_of_file):
    """One for all tests of a file, which bring it to sizes and pages of their own: each finds it at rest."""
    return at_rest(window_of_file)


@pytest.fixture
def rest():
    """What brings a window back to nothing asked, said or begun."""
    return at_rest


def at_rest(window):
    """Nothing asked, said or begun, on a known bench; forms, cards and the window's size as they were at first."""
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    from labcal.gui.ipc.bench_commands import read_bench
    from labcal.gui.ipc.messages import ListRuns, ReadBench

    app_state = window.app_state
    if not (give_up := window.page("Run").choose.give_up).isHidden():
        give_up.click()
    if QApplication.keyboardModifiers() != Qt.KeyboardModifier.NoModifier:  # of a last key: a row that is chosen by a
        QTest.keyRelease(window, Qt.Key.Key_Shift)  # call would be chosen as with that key held down
    window.scanner.flush()
    window.resize(window.size_at_first)  # in a smaller one the next test's words would have less room
    window.raise_()
    window.activateWindow()
    app_state.watch.stop()
    app_state.watch.timer.stop()  # a test calls it, and no clock does
    window.page("Start").refresh()
    app_state.quick_worker.answer(ListRuns, ())  # no run that broke off is kept from the test before
    workers = (app_state.quick_worker, app_state.bench_worker, app_state.fit_worker, app_state.off_worker)
    for worker in (*workers, app_state.second_fit_worker, app_state.watch_worker):
        worker.asked, worker.said, worker.killed = [], [], 0
    window.scanner.now = time.monotonic
    window.scanner.wait.setInterval(SCAN_WAIT_MS)
    app_state.off.force_timer.setInterval(3_600_000)  # a test calls it, and no clock does
    app_state.off.force_timer.stop()
    app_state.run.forget()
    app_state.scan_vm.put_away()
    app_state.forget()
    app_state.lab.update(message="", waiting="", unit="nT", asking=False)
    app_state.run.order = None
    app_state.study_vm.forget("")
    for done in ("handed_out", "closed_runs"):
        app_state.settings.remove(done)
    app_state.path.take_runs(())
    app_state.path.take_calibrations(())
    app_state.run.changed.emit()
    window.page("Run").live.put_away.emit()
    for card in (window.fault, window.page("Run").live.fault):
        card.show_fault(None)
    for page in ("Fit", "Loop"):
        if window.lazy_pages[page].ready:
            window.page(page).fold.setChecked(False)
    app_state.open_bench(str(BENCH))
    app_state.quick_worker.answer(ReadBench, read_bench(None, ReadBench(str(BENCH))))
    window.sidebar.setFocus()
    app_state.set_identity(dut="")  # what was looked at before is not come back to
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    choose = window.page("Run").choose
    choose.choose("preflight")
    choose.show_procedures(window.procedures)  # forms as they were
    window.show_state(app_state.lab.state)
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
        yield window
        take_apart(window)


@pytest.fixture
def window(qtbot, alive, monkeypatch):
    monkeypatch.setenv("LABCAL_HOME", alive.home)
    app_state = alive.app_state
    if app_state.run.alive:
        app_state.run.abort()
        qtbot.waitUntil(lambda: not app_state.run.alive, timeout=PATIENCE_MS)
    if app_state.bench != str(BENCH):
        app_state.open_bench(str(BENCH))
    qtbot.waitUntil(lambda: app_state.bench == str(BENCH) and bool(app_state.facts), timeout=PATIENCE_MS)
    qtbot.waitUntil(lambda: not app_state.off_worker.busy, timeout=PATIENCE_MS)
    app_state.set_identity(operator="J. Doe", dut="EM-07")
    return alive


@contextmanager
def window_at(home):
    """A window on the lab whose home is `home`."""
    from labcal.gui.window import Window

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        window = Window(AppState(QSettings(str(home / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
        window.show()
        window.app_state.open_bench(str(BENCH))
        window.app_state.set_identity(dut="EM-07", operator="J. Doe")
        window.home = str(home)
        try:
            yield window
        finally:
            take_apart(window)


@pytest.fixture
def window_on():
    """Opens a window on the lab of a home."""
    return window_at


@pytest.fixture(scope="session")
def recorded(tmp_path_factory):
    """The home of a lab whose store has one short preflight. Nobody writes to it: windows have copies."""
    from labcal import session
    from labcal.bench.clock import VirtualClock

    home = tmp_path_factory.mktemp("recorded") / "home"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
        session.run("preflight", BENCH, SHORT | {"zero_s": "3"}, dut="EM-07", operator="J. Doe", clock=clock, seed=3)
    return home


@pytest.fixture(scope="session")
def drafted(tmp_path_factory, recorded):
    """The same with the draft and the verdict of its loop."""
    from labcal import session
    from labcal.gui.ipc.study_commands import loop

    home = copytree(recorded, tmp_path_factory.mktemp("drafted") / "home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        loop(SimpleNamespace(send=lambda event: None), CloseLoop(session.runs()[0].run_id))
    return home


@pytest.fixture(scope="module")
def undrafted_lab(tmp_path_factory, recorded):
    with window_at(copytree(recorded, tmp_path_factory.mktemp("lab") / "home")) as window:
        yield window


@pytest.fixture(scope="module")
def signed_lab(tmp_path_factory, drafted):
    """Its calibration is approved by a.smith and signed by jdoe@lab."""
    from labcal import session

    home = copytree(drafted, tmp_path_factory.mktemp("signed") / "home")
    (draft,) = (home / "calibrations").glob("*.json")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        session.new_key("jdoe@lab", "a long passphrase")
        session.new_key("a.smith", "a long passphrase")
        session.approve(draft, "a.smith")
        session.sign(draft, "jdoe@lab", "a long passphrase")
    with window_at(home) as window:
        yield window


def at_home(window, monkeypatch):
    """The window as each test finds it: in its own home, no card open."""
    monkeypatch.setenv("LABCAL_HOME", window.home)
    for card in window.findChildren(FaultCard):
        card.show_fault(None)
    window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    return window


@pytest.fixture
def lab(undrafted_lab, monkeypatch):
    """A lab with one recorded run; tests look at it, fit and trace it, and leave the store as it is."""
    return at_home(undrafted_lab, monkeypatch)


@pytest.fixture
def signed(qtbot, signed_lab, monkeypatch):
    """A lab whose one calibration is signed, on the Certificate page."""
    at_home(signed_lab, monkeypatch)
    signed_lab.open_page("Certificate")
    qtbot.waitUntil(lambda: signed_lab.page("Certificate").chosen() is not None, timeout=PATIENCE_MS)
    return signed_lab


@pytest.fixture
def own_lab(tmp_path, drafted, monkeypatch):
    """A lab with a draft, for one test alone: it may write whatever it likes."""
    with window_at(copytree(drafted, tmp_path / "home")) as window:
        yield at_home(window, monkeypatch)


@pytest.fixture
def fitted(qtbot, lab):
    """The run is open on the Fit page, and fitted."""
    study, (run,) = lab.app_state.study_vm, runs_of(qtbot, lab)
    lab.app_state.open_study(run)
    study.fit("ml")
    qtbot.waitUntil(lambda: "ml" in study.fits and not study.busy, timeout=PATIENCE_MS)
    return lab


@pytest.fixture
def traced(qtbot, fitted):
    """And its residual is traced."""
    study = fitted.app_state.study_vm
    if study.loop is None:
        study.close_loop()
    qtbot.waitUntil(lambda: study.loop is not None, timeout=PATIENCE_MS)
    fitted.open_page("Loop")
    return fitted
