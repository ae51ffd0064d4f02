"""German and French beside English: whole, with the same blanks to be filled, and switched while the window is open."""

import re
import subprocess
import time
from pathlib import Path
from xml.etree import ElementTree

import PySide6
import pytest
from PySide6.QtCore import QEvent, QLocale, Qt
from PySide6.QtWidgets import QApplication, QInputDialog, QLabel, QPushButton
from shiboken6 import delete, isValid

from labcal.gui import reopened
from labcal.gui.ipc.answers import Ended, RunLine
from labcal.gui.ipc.messages import (
    LastCageCheck,
    LastClosingCheck,
    ListCalibrations,
    ListKeys,
    ListMethods,
    ListProcedures,
    ListRuns,
    RunProcedure,
)
from labcal.gui.ipc.wire import Fault
from labcal.gui.pages import lazy_page
from labcal.gui.reopened import Shown
from labcal.gui.theming.theme import STATES
from labcal.gui.translations import translate
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.widgets.sounds import Sounds
from labcal.gui.window import Window

LRELEASE = next(Path(PySide6.__file__).parent.glob("lrelease*"), None)
SHIPPED = sorted(translate.FOLDER.glob("labcal_*.ts"))
FILLED_IN = re.compile(r"\{[^}]*\}|\bF\d+\b|<[^>]*>")  # by the window; keys; markup


def messages(path):
    contexts = ElementTree.parse(path).getroot().iter("context")
    return {
        (c.findtext("name"), m.findtext("source")): m.find("translation") for c in contexts for m in c.iter("message")
    }


@pytest.fixture
def restored(qapp):
    yield
    translate.install_translator(qapp, QLocale("en"))


def test_german_and_french_are_shipped():
    assert [path.stem for path in SHIPPED] == ["labcal_de", "labcal_fr"]
    assert translate.languages() == {"en": "English", "de": "Deutsch", "fr": "Français"}


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_a_language_says_everything_that_the_window_says(path):
    known, said = messages(translate.FOLDER / "labcal.ts"), messages(path)
    assert said.keys() == known.keys(), "tools/translations.sh brings it up to date"
    assert {source for source, one in said.items() if not (one.text or "").strip() or one.get("type")} == set()


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_what_is_filled_in_stands_in_every_language(path):
    for (_, source), one in messages(path).items():
        assert sorted(FILLED_IN.findall(one.text)) == sorted(FILLED_IN.findall(source))


def test_every_verdict_has_its_word_on_lights_tables_and_cards():
    known = messages(translate.FOLDER / "labcal.ts")
    assert {verdict for verdict in STATES if verdict.isupper()} <= {
        source for context, source in known if context == "Words"
    }


@pytest.mark.skipif(LRELEASE is None, reason="this PySide6 comes without lrelease, which makes the .qm file")
@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_the_file_that_qt_reads_is_made_of_the_one_that_people_write(path, tmp_path):
    made = tmp_path / "made.qm"
    subprocess.run([LRELEASE, path, "-qm", made], check=True, capture_output=True)
    assert made.read_bytes() == path.with_suffix(".qm").read_bytes(), "tools/translations.sh"


def test_a_click_makes_the_window_anew_in_the_next_language(qapp, qtbot, new_window, restored, windows):
    shown = Shown(new_window)
    new_window.app_state.set_identity(dut="EM-07")
    new_window.open_page("Bench")
    assert new_window.language_switch.text() == "Deutsch"
    new_window.app_state.lab.update(message="Scanned EM-07: it is the DUT at the top.")
    new_window.language_switch.click()
    window = shown.window
    windows.append(window)
    assert window is not new_window
    assert (window.page_shown(), window.top.dut.text()) == ("Bench", "EM-07")
    assert "Prüfling" in {one.text() for one in window.top.findChildren(QLabel)}
    assert "SPULEN AUS" in window.top.off.text()
    assert window.language_switch.text() == "Français"
    assert (window.focusWidget(), window.message.text()) == (window.language_switch, "")
    assert format_number(1234.5).endswith("234,5")
    assert window.app_state.settings.value("language") == "de"
    with qtbot.waitSignal(window.coils_off):
        window.top.off.click()


def test_a_second_click_while_the_window_stood_still_changes_nothing(qapp, new_window, restored, monkeypatch, windows):
    monkeypatch.setattr(reopened, "TOO_SOON_S", 3600.0)
    shown = Shown(new_window)
    shown._since_s = -3600.0 + time.monotonic() - 1
    cursors = []
    monkeypatch.setattr(Window, "prebuild", lambda window: None)
    monkeypatch.setattr(
        reopened, "Window", lambda state: cursors.append(qapp.overrideCursor().shape()) or Window(state)
    )
    new_window.language_switch.click()
    window = shown.window
    windows.append(window)
    assert cursors == [Qt.CursorShape.WaitCursor]
    assert (new_window.language_switch.isEnabled(), qapp.overrideCursor()) == (False, None)
    window.language_switch.click()
    assert (shown.window, window.language_switch.text()) == (window, "Français")


def test_what_is_not_there_yet_in_the_other_language_is_said_to_be_coming(
    qapp, new_window, restored, monkeypatch, windows
):
    shown = Shown(new_window)
    monkeypatch.setattr(Window, "prebuild", lambda window: None)
    new_window.show()
    new_window.open_page("Bench")
    new_window.language_switch.click()
    windows.append(window := shown.window)
    assert new_window.language_switch.text() == "Deutsch …"
    place = window.lazy_pages["Bench"]
    assert (place.coming.isVisible(), place.coming.text()) == (True, "Diese Seite wird vorbereitet …")
    place.built()
    assert place.coming.isHidden()


@pytest.mark.parametrize("pieces", [1, 20])
def test_settings_that_come_while_their_page_is_built_have_their_style(
    qapp, new_window, restored, windows, monkeypatch, pieces
):
    monkeypatch.setattr(Window, "prebuild", lambda window: None)
    monkeypatch.setattr(lazy_page, "TIME_SLICE_S", 0.0)  # each widget is a piece
    shown = Shown(new_window)
    new_window.open_page("Run")
    new_window.language_switch.click()
    windows.append(window := shown.window)
    place = window.lazy_pages["Run"]
    for _ in range(pieces):
        place.build()
        QApplication.processEvents()
    window.app_state.quick_worker.answer(ListProcedures, new_window.procedures)
    while not place.ready:
        QApplication.processEvents()
        place.build()
    QApplication.processEvents()
    form = window.page("Run").choose.form
    assert form.isVisible()
    assert form.styleSheet() == new_window.page("Run").choose.form.styleSheet()


def test_how_a_run_ended_is_said_anew_in_the_other_language(qapp, new_window, restored, windows):
    shown, app_state = Shown(new_window), new_window.app_state
    run = app_state.run
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    run.abort()
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("stopped", "stopped")))
    assert app_state.lab.state.message.endswith("stopped by COILS OFF")
    app_state.lab.update(said_at="00:17:08")
    shown.speak("de")
    windows.append(shown.window)
    assert app_state.lab.state.message.endswith("durch SPULEN AUS gestoppt")
    assert app_state.lab.state.said_at == "00:17:08"  # when it ended, not when it was said anew
    assert shown.window.message.text().endswith("durch SPULEN AUS gestoppt")


@pytest.mark.parametrize(("code", "cancel"), [("de", "Abbrechen"), ("fr", "Annuler"), ("en", "Cancel")])
def test_what_qt_s_own_dialogs_say_is_in_the_language_too(qapp, qtbot, restored, code, cancel):
    translate.install_translator(qapp, QLocale(code))
    asks = QInputDialog()
    qtbot.addWidget(asks)
    asks.open()
    assert cancel in {button.text().replace("&", "") for button in asks.findChildren(QPushButton)}


def test_the_end_of_a_run_is_not_sounded_by_the_window_before(qapp, new_window, restored, monkeypatch, windows):
    played = []
    monkeypatch.setattr(Sounds, "play", lambda sounds, sound: played.append((isValid(sounds), sound)))
    shown, before = Shown(new_window), new_window.page("Run").live
    new_window.language_switch.click()
    windows.append(shown.window)
    assert shown.window.page("Run").live is not before
    delete(before)
    shown.window.app_state.run.ended.emit("r1", "finished")
    assert played == [(True, "done")]


ANSWERS = {
    ListRuns: (RunLine("r1", "2026-11-22T23:30:00Z", "finished", "EM-07", "J. Doe", "preflight", simulated=True),),
    ListCalibrations: (),
    ListKeys: ("jdoe",),
    LastClosingCheck: None,
    LastCageCheck: None,
    ListMethods: ("ml",),
}


OFTEN = "Run", "Certificate", "History"  # what most is asked from


@pytest.mark.parametrize(
    "name", [*OFTEN, *(pytest.param(name, marks=pytest.mark.slow) for name in ("Start", "Bench", "Fit", "Loop"))]
)
def test_what_a_page_asked_before_the_language_changed_twice_reaches_the_page_that_is_there(
    qapp, new_window, restored, name, monkeypatch, windows
):
    monkeypatch.setattr(reopened, "TOO_SOON_S", 0.0)
    shown, app_state = Shown(new_window), new_window.app_state
    app_state.study_vm.open("r1")
    new_window.open_page(name)
    new_window.page(name)
    for _ in range(2):
        before = shown.window
        before.language_switch.click()
        shown.window.page(name)
        QApplication.sendPostedEvents(before, QEvent.Type.DeferredDelete)
        assert not isValid(before)
    windows.append(shown.window)
    for worker in (app_state.quick_worker, app_state.fit_worker):
        for kind, answer in (ANSWERS | {ListProcedures: new_window.procedures}).items():
            worker.answer(kind, answer)
        for one in worker.asked:
            one.failed(Fault("input", "refused"))
    assert app_state.path.runs == (() if name in ("Bench", "Certificate") else ANSWERS[ListRuns])
    if name == "History":
        assert shown.window.page(name).table.rowCount() == 1


def test_no_other_language_while_a_run_goes_on(qapp, new_window, restored, monkeypatch):
    shown = Shown(new_window)
    monkeypatch.setattr(type(new_window.app_state.run), "alive", property(lambda _: True))
    new_window.app_state.run.changed.emit()
    assert not new_window.language_switch.isEnabled()
    shown.speak("de")
    assert shown.window is new_window
    assert QLocale().language() == QLocale.Language.English
