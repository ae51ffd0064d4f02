"""Drafts, signatures and what is done with them, and the store: through the real workers, on copies of one lab."""

import json
import zipfile
from pathlib import Path

import pytest
from lab_states import runs_of
from PySide6.QtCore import QMimeData, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QInputDialog, QLineEdit, QPushButton

from labcal.gui.widgets.calibration_views import BUDGET

LONG_MS = 180_000


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


@pytest.mark.slow
def test_a_wrong_serial_is_corrected_until_signing_and_the_draft_follows(qtbot, own_lab):
    (run,), page = runs_of(qtbot, own_lab), own_lab.page("History")
    (path,) = (Path(own_lab.home) / "calibrations").glob("*.json")
    for serial in ("EM-08", "EM-07"):
        correct_by_hand(qtbot, page, run, serial)
        qtbot.waitUntil(lambda s=serial: page.table.text(0, 1) == s, timeout=LONG_MS)
        assert json.loads(path.read_text())["dut"]["serial"] == serial


def test_a_draft_is_approved_signed_and_verified_by_two(qtbot, own_lab):
    own_lab.open_page("Certificate")
    page = own_lab.page("Certificate")
    qtbot.waitUntil(lambda: page.list.count() == 1, timeout=LONG_MS)
    page.views.tabs.setCurrentIndex(BUDGET)
    shown = {page.table.text(n, 0).partition(": ")[0]: n for n in range(page.table.rowCount())}
    assert page.table.text(shown["off 90° x–y"], 0).endswith("%")  # what makes most of its U
    assert "noise of the run, through the fit" in page.table.item(shown["off 90° x–y"], 0).toolTip()
    steps = page.steps
    steps.approver.setCurrentText("A. Smith")  # no key can bear that: it would wait for its signature for ever
    assert (steps.approve.isEnabled(), steps.approval.wrong.isVisible()) == (False, True)
    steps.approver.setCurrentText("b.jones")
    qtbot.mouseClick(steps.approve, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "b.jones is nobody of the trust list" in steps.approval.wrong.text(), timeout=LONG_MS)
    assert steps.approver.currentText() == "b.jones"
    steps.key_name.setText("a.smith")
    for entry, words in ((steps.new_words, "a long passphrase"), (steps.again, "a long passphrasf")):
        entry.setText(words)
    assert (steps.new_key.isEnabled(), steps.key.wrong.text()) == (False, "✕ The two passphrases differ.")
    steps.again.setText("a long passphrase")
    qtbot.mouseClick(steps.new_key, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "a.smith has a key now." in page.steps.key.done.text(), timeout=LONG_MS)
    steps.approver.setCurrentText("a.smith")
    steps.stated.until.setText("31.13.2099")
    assert ("is no day" in steps.approval.wrong.text(), steps.approve.isEnabled()) == (True, False)
    steps.stated.until.setText("31.12.2099")
    qtbot.mouseClick(steps.approve, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "a.smith" in page.standing.text(), timeout=LONG_MS)
    assert not page.fault.isVisible()
    assert not steps.stated.until.isVisible()  # what the approver has seen stays
    assert json.loads(Path(page.chosen().path).read_text())["validity"]["until"] == "2099-12-31"
    qtbot.waitUntil(lambda: steps.signer.currentText() == "a.smith", timeout=LONG_MS)  # who has to sign
    steps.passphrase.setText("a long passphrase")
    qtbot.mouseClick(steps.sign, Qt.MouseButton.LeftButton)
    assert steps.signature.asked.text() == (
        "The certificate names no laboratory and no customer. Sign it all the same?"
    )
    assert steps.passphrase.text()  # it is pressed once more, or somebody is named first
    for field, words in zip(page.names.customer, ("Holm AS", "Oslo", "n"), strict=True):
        field.setText(words)
    assert not page.names.keep.isEnabled()
    page.names.customer[2].setText("no")
    qtbot.mouseClick(page.names.keep, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.names.lacks() == "The certificate names no laboratory.", timeout=LONG_MS)
    assert (page.names.customer[0].isVisible(), page.names.laboratory[0].isVisible()) == (False, True)
    assert not steps.signature.asked.isVisible()
    for field, words in zip(page.names.laboratory, ("A lab", "Bern", "CH"), strict=True):
        field.setText(words)
    qtbot.mouseClick(page.names.keep, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not page.names.lacks(), timeout=LONG_MS)
    assert page.names.stated.text() == "Laboratory: A lab, Bern (CH)   Customer: Holm AS, Oslo (NO)"
    qtbot.mouseClick(steps.sign, Qt.MouseButton.LeftButton)
    assert steps.passphrase.text() == ""
    qtbot.waitUntil(lambda: "VALID: signed by a.smith" in page.standing.text(), timeout=LONG_MS)
    assert page.chosen().standing.status == "released"
    assert not steps.approve.isEnabled()
    page.verify(page.chosen().path)
    qtbot.waitUntil(lambda: page.drop.name.text().startswith("✓"), timeout=LONG_MS)


def test_after_signing_the_serial_stands(qtbot, signed):
    (run,), page = runs_of(qtbot, signed), signed.page("History")
    correct_by_hand(qtbot, page, run, "EM-09")
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "is signed" in page.fault.text.text()
    assert page.table.text(0, 1) == "EM-07"


def test_the_dcc_is_written_by_a_click_and_a_laboratory_that_is_not_stated_is_asked_for_in_words(
    qtbot, signed, tmp_path, monkeypatch
):
    etree = pytest.importorskip("lxml.etree", reason="the DCC is written by lxml, of the extra `dcc`")
    page, out = signed.page("Certificate"), tmp_path / "calibration.xml"
    (Path(signed.home) / "laboratory.toml").unlink(missing_ok=True)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (str(out), "DCC (*.xml)"))
    qtbot.waitUntil(page.paper.report.isEnabled, timeout=LONG_MS)
    qtbot.mouseClick(page.paper.report, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(page.fault.isVisible, timeout=LONG_MS)
    assert "laboratory.toml" in page.fault.text.text()
    page.fault.show_fault(None)
    assert not page.said.text()
    place = 'name = "A"\ncity = "Bern"\ncountry = "CH"\n'
    (Path(signed.home) / "laboratory.toml").write_text(f"{place}[customer]\n{place}")
    qtbot.mouseClick(page.paper.report, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.said.text() == f"Written: {out}" or page.fault.isVisible(), timeout=LONG_MS)
    assert not page.fault.isVisible(), page.fault.text.text()
    assert etree.QName(etree.parse(out).getroot()).localname == "digitalCalibrationCertificate"


def test_a_calibration_is_handed_out_and_applied(qtbot, signed, tmp_path):
    page = signed.page("Certificate")
    page.paper.hand_out(str(tmp_path))
    qtbot.waitUntil(lambda: page.drop.words.isVisible(), timeout=LONG_MS)  # what has left is verified where it lies
    (handed,) = tmp_path.glob("*.json")
    said = page.said.text().splitlines()[1:]
    assert [line.partition(": ")[0] for line in said] == sorted(one.name for one in tmp_path.iterdir())
    assert handed.with_suffix(".pdf").read_bytes().startswith(b"%PDF")
    assert page.drop.name.text() == f"▲ {handed.name}"
    assert page.stage.text().endswith("✓ Hand out  →  ✓ Verify")
    assert handed.read_bytes() == Path(page.chosen().path).read_bytes()
    assert handed.with_name(f"{handed.name}.sshsig").is_file()
    effects = {c for effect in page.chosen().effects for c in effect.channels}
    header = ["t_s", "segment", "mode", "dut_x", "dut_y", "dut_z", *sorted(effects)]
    row = ["0", "a", "nominal", "100", "200", "300", *["0"] * len(effects)]
    (tmp_path / "in.csv").write_text(",".join(header) + "\n" + ",".join(row) + "\n")
    page.paper.apply_to(str(tmp_path / "in.csv"), str(tmp_path / "out.csv"))
    qtbot.waitUntil(lambda: page.said.text().startswith("1 rows"), timeout=LONG_MS)
    assert "b_x" in (tmp_path / "out.csv").read_text()


def test_a_changed_file_that_is_dropped_is_not_valid(qtbot, signed, tmp_path):
    page = signed.page("Certificate")
    path = Path(page.chosen().path)
    copy = tmp_path / path.name
    copy.write_bytes(path.read_bytes().replace(b"J. Doe", b"J. Dot"))
    copy.with_name(copy.name + ".sshsig").write_bytes(path.with_name(path.name + ".sshsig").read_bytes())
    for name in (copy.name, f"{copy.name}.sshsig"):  # a signature stands for its calibration
        page.drop.name.clear()
        files = QMimeData()
        files.setUrls([QUrl.fromLocalFile(str(tmp_path / name))])
        where, button, key = QPointF(9, 9), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        for kind in (QDragEnterEvent, QDropEvent):
            event = kind(
                where.toPoint() if kind is QDragEnterEvent else where, Qt.DropAction.CopyAction, files, button, key
            )
            event.ignore()
            QApplication.sendEvent(page.drop, event)
        qtbot.waitUntil(lambda: page.drop.name.text() == f"✕ {copy.name}", timeout=LONG_MS)


def test_a_wrong_passphrase_is_said_at_its_field(qtbot, signed):
    page = signed.page("Certificate")
    qtbot.waitUntil(lambda: page.steps.signer.findText("jdoe@lab") >= 0, timeout=LONG_MS)
    page.steps.signer.setCurrentText("jdoe@lab")
    page.steps.passphrase.setText("wrong")
    qtbot.mouseClick(page.steps.sign, Qt.MouseButton.LeftButton)
    wrong = page.steps.signature.wrong
    qtbot.waitUntil(wrong.isVisible, timeout=LONG_MS)
    assert not page.fault.isVisible()
    assert "Traceback" not in wrong.text()


def test_a_run_is_exported_and_imported_by_clicks(qtbot, own_lab, tmp_path, monkeypatch):
    assert len(runs_of(qtbot, own_lab)) == 1
    page, out = own_lab.page("History"), str(tmp_path / "run.zip")
    page.table.selectRow(0)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *said: (out, "Bundle (*.zip)"))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *said: (out, "*.zip"))
    qtbot.mouseClick(page.export, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: own_lab.app_state.lab.state.message == f"Exported: {out}", timeout=LONG_MS)
    with zipfile.ZipFile(out) as bundle:
        assert sorted(bundle.namelist()) == ["chain.jsonl", "run.json", "samples.csv"]
        other = json.loads(bundle.read("run.json")) | {"run_id": "another"}
        samples = bundle.read("samples.csv")
    with zipfile.ZipFile(out, "w") as bundle:
        bundle.writestr("run.json", json.dumps(other))
        bundle.writestr("samples.csv", samples)
    take = next(one for one in page.findChildren(QPushButton) if one.text() == "Import …")
    qtbot.mouseClick(take, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: page.table.rowCount() == 2, timeout=LONG_MS)
    assert {page.table.text(row, 6) for row in range(2)} > {"another"}


def test_the_trend_of_a_dut_is_drawn(qtbot, signed):
    signed.open_page("History")
    history = signed.page("History")
    qtbot.waitUntil(lambda: "EM-07" in history.trend.heading.text(), timeout=LONG_MS)
    qtbot.waitUntil(lambda: len(history.trend.plot.getPlotItem().listDataItems()) == 3, timeout=LONG_MS)
    assert history.trend.plot.isVisible()
    assert any(one.verdict for one in history.runs)
