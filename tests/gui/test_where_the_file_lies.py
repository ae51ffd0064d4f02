"""Once a calibration is signed, or handed out, its page says where the file is, and leads there."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QLineEdit
from test_certificate_steps import DRAFT, RELEASED, certificate_page, settle, told

from labcal.gui.ipc.messages import HandOut
from labcal.gui.widgets import open_externally
from labcal.gui.widgets.folder_dialog import FolderDialog


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


def test_what_was_handed_out_is_said_below_the_buttons_and_takes_no_room_before(page):
    told(page, RELEASED, "a.smith")
    paper = page.paper
    assert not paper.said.isVisible()
    high = paper.height()
    paper.said.setText("Written: here")
    settle()
    assert paper.said.isVisible()
    assert paper.height() > high
    assert paper.export.y() < paper.said.y()
    paper.said.setText("")
    settle()
    assert paper.height() == high


@pytest.mark.parametrize("there", [True, False])
def test_a_folder_that_is_there_is_taken_as_well_as_the_name_of_a_new_one(qtbot, page, tmp_path, there):
    """Its button was grey, without a word, for a folder that is there."""
    folder = tmp_path / "out"
    if there:
        folder.mkdir()
    asks = FolderDialog(page, "Where to", "Copy here", "EM-07")
    asks.open()
    typed = asks.findChild(QLineEdit, "fileNameEdit")
    typed.setText(str(folder))
    settle()
    button = asks.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
    assert button.isEnabled()
    button.click()
    assert asks.result() == 1
    assert asks.folder() == str(folder)
