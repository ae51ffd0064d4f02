"""Once a calibration is signed, or handed out, its page says where the file is, and leads there."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from test_certificate_steps import DRAFT, RELEASED, certificate_page, settle, told

from labcal.gui.ipc.messages import HandOut
from labcal.gui.widgets import open_externally


@pytest.fixture
def page(new_window):
    return certificate_page(new_window)


@pytest.fixture
def opened(monkeypatch):
    """Whatever the computer is told to show."""
    shown = []
    monkeypatch.setattr(open_externally, "open_externally", shown.append)
    return shown


def test_a_signed_file_says_its_name_and_folder_and_leads_there(page, opened):
    told(page, RELEASED, "a.smith")
    path, said = Path(RELEASED.path), page.lies.words.text().replace(open_externally.MAY_BREAK, "")
    assert said == f"The signed file is {path.name}, in the folder {path.parent}"
    assert page.lies.isVisible()
    page.lies.folder.click()
    assert opened == [str(path.parent)]
    page.lies.copy.click()
    assert QApplication.clipboard().text() == RELEASED.path
    assert page.lies.copy.text() == "✓ Path copied"
    told(page, DRAFT, "a.smith")
    assert not page.lies.isVisible()


def test_what_was_handed_out_lies_in_its_folder_and_that_can_be_copied(page, tmp_path, opened):
    told(page, RELEASED, "a.smith")
    assert not page.paper.copy.isVisible()
    page.paper.hand_out(str(tmp_path))
    page._app_state.quick_worker.answer(HandOut, str(tmp_path))
    settle()
    assert str(tmp_path) in page.said.text()
    page.paper.copy.click()
    assert QApplication.clipboard().text() == str(tmp_path)
    page.paper.folder.click()
    assert opened == [str(tmp_path)]
