"""Certificates and labels on paper: by the computer's own printing; where it has none the file is opened."""

import sys
from types import SimpleNamespace

import pytest
from PySide6.QtGui import QDesktopServices

from labcal.gui.ipc.messages import WriteLabel, WriteReport
from labcal.gui.pages.certificate_paper import Paper


@pytest.fixture
def printing(still, tmp_path, monkeypatch):
    """The buttons for one calibration, who writes, and what was opened in place of paper."""
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    still.open_page("Certificate")
    chosen = SimpleNamespace(path=str(tmp_path / "EM-07.json"), dut=SimpleNamespace(serial="EM-07"))
    paper = Paper(still.app_state, lambda: chosen, still.page("Certificate").fault)
    return paper, still.app_state.quick_worker, opened


def program(folder, monkeypatch, words):
    """`lp` as a script of a few words, the only one on the path."""
    (folder / "bin").mkdir()
    (folder / "bin" / "lp").write_text(f"#!/bin/sh\n{words}\n", encoding="utf-8")
    (folder / "bin" / "lp").chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder / 'bin'}")


@pytest.mark.skipif(sys.platform == "win32", reason="lp is not how Windows prints")
@pytest.mark.parametrize(("what", "kind"), [("certificate", WriteReport), ("label", WriteLabel)])
def test_paper_comes_from_the_computers_own_printing(printing, qtbot, tmp_path, monkeypatch, what, kind):
    paper, worker, opened = printing
    program(tmp_path, monkeypatch, f'echo "$1" > {tmp_path}/printed')
    getattr(paper, f"print_{what}")()
    written = worker.commands(kind)[-1].out
    assert written.endswith(f"EM-07-{what}.pdf")
    worker.answer(kind, written)
    qtbot.waitUntil(lambda: paper.said.text() == f"Sent to the printer: EM-07-{what}.pdf", timeout=60_000)
    assert (tmp_path / "printed").read_text(encoding="utf-8").strip() == written
    assert opened == []


@pytest.mark.skipif(sys.platform == "win32", reason="lp is not how Windows prints")
@pytest.mark.parametrize(
    ("words", "why"),
    [
        ("echo lp: Error - no default destination available. >&2; exit 1", "no default destination available"),
        ("exit 3", "lp ended with 3"),
        ("", "this computer has no program lp"),
    ],
)
def test_where_nothing_prints_the_file_is_opened_and_that_is_said(printing, qtbot, tmp_path, monkeypatch, words, why):
    paper, worker, opened = printing
    program(tmp_path, monkeypatch, words)
    if not words:
        (tmp_path / "bin" / "lp").unlink()
    paper.print_label()
    written = worker.commands(WriteLabel)[-1].out
    worker.answer(WriteLabel, written)
    qtbot.waitUntil(lambda: why in paper.said.text(), timeout=60_000)
    assert paper.said.text().startswith("Not printed (")
    assert opened == [written]


def test_everything_that_prints_stands_in_one_menu(printing):
    paper, worker, _ = printing
    _, certificate, label, _ = paper.export.menu().actions()
    certificate.trigger()
    label.trigger()
    assert (len(worker.commands(WriteReport)), len(worker.commands(WriteLabel))) == (1, 1)
