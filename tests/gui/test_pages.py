"""Fit, loop, certificate, history, bench and start on a run that was made once, through the real workers."""

import json
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPointF, QSettings, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QInputDialog, QLineEdit, QPushButton

from labcal.gui.ipc.wire import Fault, unpack

LONG_MS = 180_000
BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
SHORT = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}


@pytest.fixture(scope="module")
def lab(tmp_path_factory, qapp, kept_windows):
    """A window whose store has one short preflight; the tests below go on from one another's work."""
    from labcal import session
    from labcal.bench.clock import VirtualClock
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels.app_state import AppState
    from labcal.gui.window import Window

    home = tmp_path_factory.mktemp("home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(home))
        clock = VirtualClock(datetime(2026, 1, 5, tzinfo=UTC))
        session.run("preflight", BENCH, SHORT | {"zero_s": "3"}, dut="EM-07", operator="J. Doe", clock=clock, seed=3)
        window = Window(AppState(QSettings(str(home / "w.ini"), QSettings.Format.IniFormat)), LIGHT)
        window.show()
        window.app_state.open_bench(str(BENCH))
        window.app_state.set_identity(dut="EM-07", operator="J. Doe")
        window.home = str(home)
        kept_windows.append(window)
        yield window
        window.close()


@pytest.fixture(autouse=True)
def in_its_home(lab, monkeypatch):
    """Every test is in the lab's home, not in one of its own."""
    monkeypatch.setenv("LABCAL_HOME", lab.home)


def test_the_start_page_says_what_holds(qtbot, lab):
    lab.open_page("Start")
    page = lab.page("Start")
    qtbot.waitUntil(lambda: "PASS" in page.facts["closing"][0].text(), timeout=LONG_MS)
    assert "closure" in page.facts["closing"][1].text()
    assert "1 in the store" in page.facts["runs"][0].text()
    assert page.interrupted.isHidden()
    qtbot.waitUntil(page.morning.isEnabled, timeout=LONG_MS)


def test_morning_check_opens_its_form(qtbot, lab):
    qtbot.mouseClick(lab.page("Start").morning, Qt.MouseButton.LeftButton)
    choose = lab.page("Run").choose
    qtbot.waitUntil(lambda: choose.form is not None, timeout=LONG_MS)
    assert choose.list.currentItem().text() == "axes-check"


def test_every_instrument_answers_on_the_bench_page(qtbot, lab):
    lab.open_page("Bench")
    page = lab.page("Bench")
    qtbot.waitUntil(page.check.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.check, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.table.text(0, 5) == "✓ answers", timeout=LONG_MS)
    assert [page.table.text(row, 5) for row in range(7)] == ["✓ answers"] * 7
    assert "THURLBY" in page.table.text(0, 3).upper()
    assert all(light == "ok" for _, light, _ in lab.app_state.lab.state.lights)


def test_a_run_is_opened_from_the_history_and_fitted(qtbot, lab):
    lab.open_page("History")
    history = lab.page("History")
    qtbot.waitUntil(lambda: history.table.rowCount() == 1, timeout=LONG_MS)
    history.search.setText("another")
    assert history.table.rowCount() == 0
    history.search.setText("em-07 preflight")
    history.table.selectRow(0)
    qtbot.mouseClick(history.open, Qt.MouseButton.LeftButton)
    page = lab.page("Fit")
    qtbot.waitUntil(page.fit.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.fit, Qt.MouseButton.LeftButton)
    study = lab.app_state.study_vm
    qtbot.waitUntil(lambda: "ml" in study.fits or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    fit = lab.app_state.study_vm.fits["ml"]["fit"]
    assert fit["ok"]
    assert page.table.horizontalHeaderItem(1).text() == "ml"
    rows = {page.table.text(row, 0): page.table.text(row, 1) for row in range(page.table.rowCount())}
    assert rows["frame"] == "known"
    assert " ± " in rows["k x  nT"]
    assert " ± " in rows["K xy"]
    assert page.views.against.count() > 5


def test_every_view_of_a_fit_has_something_to_show(qtbot, lab):
    page, study = lab.page("Fit"), lab.app_state.study_vm
    views = page.views
    for n in range(views.view.count()):
        views.view.setCurrentIndex(n)
        views.view.activated.emit(n)
        assert views.faces.currentIndex() == n
    qtbot.waitUntil(lambda: "ekf" in study.growth or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    qtbot.waitUntil(lambda: len(views.growth.getPlotItem().listDataItems()) >= 3, timeout=LONG_MS)
    assert len(views.magnitude.getPlotItem().listDataItems()) == 3
    assert "rms" in views.histogram.getPlotItem().titleLabel.text
    assert len(views.residual._clouds) == 1


@pytest.mark.parametrize(("face", "columns"), [("residual", 2), ("histogram", 4), ("magnitude", 6)])
def test_a_picture_is_saved_and_its_numbers_are_copied(qtbot, lab, tmp_path, face, columns):
    from labcal.gui.widgets import plot_export
    from labcal.gui.widgets.fit_views import FACES

    views = lab.page("Fit").views
    views.view.setCurrentIndex(FACES.index(face))
    views.view.activated.emit(FACES.index(face))
    copier = next(b for b in views.findChildren(QPushButton) if b.text() == "Copy")
    qtbot.mouseClick(copier, Qt.MouseButton.LeftButton)
    rows = [row.split("\t") for row in QApplication.clipboard().text().splitlines()]
    assert {len(row) for row in rows} == {columns}
    if face == "residual":
        drawn = unpack(lab.app_state.study_vm.fits["ml"]["residual"])
        assert sorted(float(row[1]) for row in rows[1:]) == pytest.approx(sorted(drawn[np.isfinite(drawn)]))
    plot_export.save(getattr(views, face), str(tmp_path / "picture"))
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


def test_the_loop_tells_its_story_and_leaves_a_draft(qtbot, lab):
    qtbot.mouseClick(lab.page("Fit").trace, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: lab.app_state.study_vm.loop is not None, timeout=LONG_MS)
    page, loop = lab.page("Loop"), lab.app_state.study_vm.loop["loop"]
    assert page.story.isVisible()
    assert loop["verdict"].upper().replace("-", " ") in page.verdict.text().replace("-", " ")
    assert page.summary.text() == loop["summary"]
    assert "→" in page.before_after.text()
    assert Path(lab.app_state.study_vm.loop["draft"]).is_file()


def test_a_cause_that_was_not_named_is_picked_and_its_change_is_drawn(qtbot, lab):
    page, study = lab.page("Loop"), lab.app_state.study_vm
    qtbot.waitUntil(lambda: page.others.count() > 0, timeout=LONG_MS)
    rejected = next(n for n in range(page.others.count()) if ": not named" in page.others.item(n).text())
    name, why = page.others.item(rejected).text().removeprefix("– ").split(": not named\n")
    page.others.scrollToItem(page.others.item(rejected))
    place = page.others.visualItemRect(page.others.item(rejected)).center()
    qtbot.mouseClick(page.others.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.waitUntil(lambda: name in study.causes or study.fault is not None, timeout=LONG_MS)
    assert study.fault is None
    assert name in page.change_heading.text()
    assert "→" in page.change_words.text()
    assert page.change_why.text() == why
    page.others.clearSelection()
    assert page.change_heading.text() == "3  What it changes"


def correct_by_hand(qtbot, page, run, serial):
    """Click on the run, click on the button; `serial` is typed into the box that asks, and Enter."""
    qtbot.waitUntil(lambda: run in [page.table.text(n, 6) for n in range(page.table.rowCount())], timeout=LONG_MS)
    row = next(n for n in range(page.table.rowCount()) if page.table.text(n, 6) == run)
    place = page.table.visualItemRect(page.table.item(row, 0)).center()
    qtbot.mouseClick(page.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    asked = []

    def write():
        box = QApplication.activeModalWidget()
        if not isinstance(box, QInputDialog):
            return QTimer.singleShot(0, write)
        entry = box.findChild(QLineEdit)
        asked.append((box.labelText(), entry.text()))
        entry.selectAll()
        for letter in serial:  # a hand: the scanner lets go of each before the next comes
            qtbot.keyClick(entry, letter)
            page.window().scanner.flush()
        return qtbot.keyClick(entry, Qt.Key.Key_Return)

    QTimer.singleShot(0, write)
    qtbot.mouseClick(page.correct, Qt.MouseButton.LeftButton)
    assert [run in words for words, _ in asked] == [True]


def test_a_wrong_serial_is_corrected_until_signing_and_the_draft_follows(qtbot, lab):
    lab.open_page("History")
    page = lab.page("History")
    page.search.clear()
    qtbot.waitUntil(lambda: page.table.rowCount() == 1, timeout=LONG_MS)
    run = page.table.text(0, 6)
    for serial in ("EM-08", "EM-07"):
        correct_by_hand(qtbot, page, run, serial)
        qtbot.waitUntil(lambda s=serial: page.table.text(0, 1) == s, timeout=LONG_MS)
        draft = json.loads(Path(lab.app_state.study_vm.loop["draft"]).read_text())
        assert draft["dut"]["serial"] == serial


def test_a_draft_is_approved_signed_and_verified_by_two(qtbot, lab):
    lab.open_page("Certificate")
    page = lab.page("Certificate")
    qtbot.waitUntil(lambda: page.list.count() == 1, timeout=LONG_MS)
    page.approver.setCurrentText("A. Smith")  # no key can bear that: it would wait for its signature for ever
    qtbot.mouseClick(page.approve, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "No key can bear the name 'A. Smith'" in page.fault.text.text()
    assert page.approver.currentText() == "A. Smith"
    page.approver.setCurrentText("a.smith")
    qtbot.mouseClick(page.approve, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "a.smith" in page.standing.text(), timeout=LONG_MS)
    assert not page.fault.isVisible()
    page.signer.setCurrentText("jdoe@lab")
    page.passphrase.setText("a long passphrase")
    page.again.setText("a long passphrasf")
    assert (page.new_key.isEnabled(), page.next.text()) == (False, "The two passphrases differ.")
    page.again.setText("a long passphrase")
    qtbot.mouseClick(page.new_key, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.sign.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.sign, Qt.MouseButton.LeftButton)
    assert page.passphrase.text() == ""
    qtbot.waitUntil(lambda: "VALID: signed by jdoe@lab" in page.standing.text(), timeout=LONG_MS)
    assert "PROVISIONAL" in page.standing.text()
    assert not page.approve.isEnabled()
    page.verify(page.chosen()["path"])
    qtbot.waitUntil(lambda: page.drop.words.text().startswith("▲"), timeout=LONG_MS)


def test_after_signing_the_serial_stands(qtbot, lab):
    lab.open_page("History")
    page = lab.page("History")
    qtbot.waitUntil(lambda: page.table.rowCount() == 1, timeout=LONG_MS)
    correct_by_hand(qtbot, page, page.table.text(0, 6), "EM-09")
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "is signed" in page.fault.text.text()
    assert page.table.text(0, 1) == "EM-07"
    page.fault.show_fault(None)


def test_the_dcc_is_written_by_a_click_and_a_laboratory_that_is_not_stated_is_asked_for_in_words(
    qtbot, lab, tmp_path, monkeypatch
):
    etree = pytest.importorskip("lxml.etree", reason="the DCC is written by lxml, of the extra `dcc`")
    lab.open_page("Certificate")
    page, out = lab.page("Certificate"), tmp_path / "calibration.xml"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (str(out), "DCC (*.xml)"))
    qtbot.waitUntil(page.report.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.report, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "laboratory.toml" in page.fault.text.text()
    page.fault.show_fault(None)
    assert not page.said.text()
    place = 'name = "A"\ncity = "Bern"\ncountry = "CH"\n'
    (Path(lab.home) / "laboratory.toml").write_text(f"{place}[customer]\n{place}")
    qtbot.mouseClick(page.report, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.said.text() == f"Written: {out}" or page.fault.isVisible(), timeout=LONG_MS)
    assert not page.fault.isVisible(), page.fault.text.text()
    assert etree.QName(etree.parse(out).getroot()).localname == "digitalCalibrationCertificate"


def test_a_calibration_is_handed_out_and_applied(qtbot, lab, tmp_path):
    lab.open_page("Certificate")
    page = lab.page("Certificate")
    name = Path(page.chosen()["path"]).name
    page.hand_out(str(tmp_path))
    qtbot.waitUntil(lambda: (tmp_path / "allowed_signers").is_file(), timeout=LONG_MS)
    assert (tmp_path / name).is_file()
    assert (tmp_path / f"{name}.sshsig").is_file()
    effects = {c for effect in page.chosen()["effects"] for c in effect["channels"]}
    header = ["t_s", "segment", "mode", "dut_x", "dut_y", "dut_z", *sorted(effects)]
    row = ["0", "a", "nominal", "100", "200", "300", *["0"] * len(effects)]
    (tmp_path / "in.csv").write_text(",".join(header) + "\n" + ",".join(row) + "\n")
    page.apply_to(str(tmp_path / "in.csv"), str(tmp_path / "out.csv"))
    qtbot.waitUntil(lambda: page.said.text().startswith("1 rows"), timeout=LONG_MS)
    assert "b_x" in (tmp_path / "out.csv").read_text()


def test_a_changed_file_that_is_dropped_is_not_valid(qtbot, lab, tmp_path):
    page = lab.page("Certificate")
    path = Path(page.chosen()["path"])
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes().replace(b"J. Doe", b"J. Dot"))
    copy.with_name(copy.name + ".sshsig").write_bytes(path.with_name(path.name + ".sshsig").read_bytes())
    for name in (copy.name, f"{copy.name}.sshsig"):  # a signature stands for its calibration
        page.drop.words.clear()
        files = QMimeData()
        files.setUrls([QUrl.fromLocalFile(str(tmp_path / name))])
        where, button, key = QPointF(9, 9), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        for kind in (QDragEnterEvent, QDropEvent):
            event = kind(
                where.toPoint() if kind is QDragEnterEvent else where, Qt.DropAction.CopyAction, files, button, key
            )
            event.ignore()
            QApplication.sendEvent(page.drop, event)
        qtbot.waitUntil(lambda: page.drop.words.text().startswith(f"✕ {copy.name}: "), timeout=LONG_MS)


def test_a_wrong_passphrase_is_a_card_with_words(qtbot, lab):
    page = lab.page("Certificate")
    page.signer.setCurrentText("jdoe@lab")
    page.passphrase.setText("wrong")
    qtbot.mouseClick(page.sign, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "Traceback" not in page.fault.text.text()


def test_a_run_is_exported_and_imported_by_clicks(qtbot, lab, tmp_path, monkeypatch):
    lab.open_page("History")
    page, out = lab.page("History"), str(tmp_path / "run.zip")
    qtbot.waitUntil(lambda: page.table.rowCount() == 1, timeout=LONG_MS)
    page.table.selectRow(0)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (out, "Bundle (*.zip)"))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *said: (out, "*.zip"))
    qtbot.mouseClick(page.export, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: lab.app_state.lab.state.message == f"Exported: {out}", timeout=LONG_MS)
    with zipfile.ZipFile(out) as bundle:
        assert sorted(bundle.namelist()) == ["run.json", "samples.csv"]
        other = json.loads(bundle.read("run.json")) | {"run_id": "another"}
        samples = bundle.read("samples.csv")
    with zipfile.ZipFile(out, "w") as bundle:
        bundle.writestr("run.json", json.dumps(other))
        bundle.writestr("samples.csv", samples)
    take = next(one for one in page.findChildren(QPushButton) if one.text() == "Import …")
    qtbot.mouseClick(take, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.table.rowCount() == 2, timeout=LONG_MS)
    assert {page.table.text(row, 6) for row in range(2)} > {"another"}


def test_a_fault_unfolds_its_details_and_a_problem_report_holds_them_and_no_key(qtbot, lab, tmp_path, monkeypatch):
    out = tmp_path / "problem.zip"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (str(out), "*.zip"))
    lab.app_state.fault.emit(Fault("instrument", "The reference is silent.", "Check its plug.", "Traceback: …"))
    card = lab.fault
    assert not card.details.isVisible()
    qtbot.mouseClick(card.fold, Qt.MouseButton.LeftButton)
    assert card.details.isVisible()
    assert card.details.toPlainText() == "Traceback: …"
    save = next(one for one in card.findChildren(QPushButton) if one.text().startswith("Save a problem"))
    qtbot.mouseClick(save, Qt.MouseButton.LeftButton)
    with zipfile.ZipFile(out) as packed:
        assert packed.namelist() == ["problem.json", "bench.toml"]
        told = json.loads(packed.read("problem.json"))
    assert told["fault"]["text"] == "The reference is silent."
    assert told["packages"]["labcal"]
    card.show_fault(None)


def test_the_trend_of_a_dut_is_drawn(qtbot, lab):
    lab.open_page("History")
    history = lab.page("History")
    qtbot.waitUntil(history.plot.isVisible, timeout=LONG_MS)
    assert "EM-07" in history.trend_heading.text()
    assert any(one["verdict"] for one in history._runs)


def test_another_theme_and_the_wall_size_keep_what_is_known(qtbot, lab):
    from labcal.gui.theming.theme import DARK

    lab.open_page("Fit")
    pages = {name: lab.page(name) for name in lab.lazy_pages}
    lab.set_theme(DARK)
    views = lab.page("Fit").views
    qtbot.waitUntil(lambda: views.loci._plots[0].backgroundBrush().color().name() == DARK.surface, timeout=LONG_MS)
    qtbot.waitUntil(lambda: DARK.surface in lab.page("History").table.styleSheet(), timeout=LONG_MS)
    assert pages == {name: lab.page(name) for name in lab.lazy_pages}  # in place: what is chosen stays chosen
    assert lab.page("Fit").table.horizontalHeaderItem(1).text() == "ml"
    size = lab.size()
    lab.resize(2400, 1400)  # wide at either size of its words
    before, words = lab.sidebar.width(), lab.top.off.fontMetrics().height()
    lab.toggle_wall()
    assert lab.sidebar.width() > 1.5 * before
    qtbot.waitUntil(lambda: lab.top.off.fontMetrics().height() > 1.5 * words, timeout=LONG_MS)
    lab.resize(size)


@pytest.mark.parametrize("name", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_f12_is_heard_on_every_page(qtbot, lab, name):
    lab.open_page(name)
    with qtbot.waitSignal(lab.coils_off, timeout=2000):
        qtbot.keyClick(lab.lazy_pages[name], Qt.Key.Key_F12)
