"""Where the trust list states roles people log in by name or badge; idle it is locked, and COILS OFF works."""

from types import SimpleNamespace

import pytest
from geometry import faults
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from labcal import session
from labcal.gui.ipc.answers import Person
from labcal.gui.ipc.file_commands import people
from labcal.gui.ipc.messages import ListPeople, RunProcedure, SwitchOff

ADA, BOB = Person("ada.smith", ("approve", "measure")), Person("bob.jones", ("release",))


@pytest.fixture
def locked(same_window):
    same_window.app_state.set_identity(operator="ada.smith")  # as remembered from yesterday
    same_window.app_state.login.take_people((ADA, BOB))
    assert same_window.lock_screen.isVisible()
    return same_window


def log_in(window, qtbot, name):
    window.lock_screen.entry.setText(name)
    qtbot.mouseClick(window.lock_screen.open, Qt.MouseButton.LeftButton)


def test_where_nobody_has_a_role_nobody_logs_in(same_window):
    same_window.app_state.login.take_people(())
    assert not same_window.lock_screen.isVisible()
    assert not same_window.lock_switch.isVisible()
    assert not same_window.top.operator.isReadOnly()
    same_window.app_state.login.lock()
    assert not same_window.app_state.login.locked
    assert same_window.app_state.objection() == ""


def test_a_name_opens_it_and_stands_at_the_top_where_nobody_types_another(locked, qtbot):
    log_in(locked, qtbot, "eve")
    assert "Nobody of the trust list has the name eve" in locked.lock_screen.words.text()
    assert not locked.stack.isVisible()
    log_in(locked, qtbot, " Ada.Smith ")
    assert (locked.stack.isVisible(), locked.lock_screen.isVisible()) == (True, False)
    assert (locked.top.operator.text(), locked.top.operator.isReadOnly()) == ("ada.smith", True)


def test_a_badge_opens_it_and_is_no_serial(locked):
    locked.scanner.scanned.emit("bob.jones")
    assert locked.app_state.login.who() == BOB
    assert locked.app_state.scan_vm.serial == ""
    assert "has not the role measure" in locked.app_state.objection()
    locked.app_state.resume("r1", "preflight", "EM-07")
    assert not locked.app_state.run.alive
    assert "has not the role measure" in locked.fault.text.text()
    locked.app_state.login.log_in("ada.smith")
    assert locked.app_state.objection() == ""


def test_locked_it_hears_no_key_but_f12_and_coils_off_is_clicked(locked, qtbot):
    page = locked.page_shown()
    for key in (Qt.Key.Key_1, Qt.Key.Key_7, Qt.Key.Key_N):
        qtbot.keyClick(locked, key, Qt.KeyboardModifier.ControlModifier)
    locked.app_state.path.changed.emit()  # what is next may be another thing meanwhile
    assert not locked.next.isEnabled()
    assert locked.page_shown() == page
    assert not locked.sidebar.isEnabled()
    worker = locked.app_state.off_worker
    qtbot.keyClick(locked.lock_screen.entry, Qt.Key.Key_F12)
    qtbot.mouseClick(locked.top.off, Qt.MouseButton.LeftButton)
    assert len(worker.commands(SwitchOff)) == 2


def test_idle_it_is_locked_but_never_in_a_run(locked, qtbot):
    login, run = locked.app_state.login, locked.app_state.run
    log_in(locked, qtbot, "ada.smith")
    assert login.idle.isActive()
    run.start(RunProcedure("preflight", "bench.toml"))
    login.idle.timeout.emit()
    assert not login.locked
    assert not locked.lock_switch.isEnabled()
    run.forget()
    run.changed.emit()
    login.idle.timeout.emit()
    QApplication.processEvents()
    assert (locked.lock_screen.isVisible(), locked.stack.isVisible()) == (True, False)


def test_a_click_starts_the_idle_time_anew(locked, qtbot):
    log_in(locked, qtbot, "ada.smith")
    locked.app_state.login.idle.stop()
    qtbot.mouseClick(locked.sidebar, Qt.MouseButton.LeftButton)
    assert locked.app_state.login.idle.isActive()


def test_the_button_locks_it(locked, qtbot):
    log_in(locked, qtbot, "ada.smith")
    qtbot.mouseClick(locked.lock_switch, Qt.MouseButton.LeftButton)
    assert locked.app_state.login.locked


def test_locked_nothing_is_cut_where_room_is_least(locked):
    locked.app_state.login.log_in("somebody.with.a.long.name@laboratory.example")
    locked.resize(1024, 700)
    for _ in range(6):
        QApplication.processEvents()
        locked.style_queue.finish()
    assert locked.lock_screen.words.isVisible()
    assert faults(locked) == []


def test_people_are_those_with_a_role_in_the_trust_list(tmp_path, monkeypatch):
    channel = SimpleNamespace(send=lambda event: None)
    for home, name in (("lab", "ada.smith"), ("bob", "bob.jones")):
        monkeypatch.setenv("LABCAL_HOME", str(tmp_path / home))
        session.new_key(name, "a long passphrase")
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "lab"))
    assert people(channel, ListPeople()) == ()
    session.trust_keys(tmp_path / "bob" / "keys" / "allowed_signers", ("release",))
    assert people(channel, ListPeople()) == (Person("bob.jones", ("release",)),)
