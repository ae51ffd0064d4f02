"""F1's sheet in every size of the window and of its letters: no wider and no higher than the window, no word cut."""

import pytest
from geometry import faults
from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QApplication, QLabel
from test_nothing_is_cut import LARGE, SIZES, settle
from test_sixth_walk import asked

from labcal.gui.translations import translate
from labcal.gui.widgets.key_sheet import KeySheet


@pytest.fixture(params=[pytest.param("en", marks=pytest.mark.slow), "de"])  # German words are longer
def window(request, qapp, same_window):
    translate.install_translator(qapp, QLocale(request.param))
    yield same_window
    translate.install_translator(qapp, QLocale("en"))


@pytest.mark.parametrize("words", [*SIZES, *LARGE])
def test_the_sheet_of_keys_is_within_the_window(window, words):
    size, wall = (SIZES | LARGE)[words]
    if window.wall != wall:
        window.toggle_wall()
    window.resize(*size)
    settle(window)
    window.show_keys()
    settle(window)
    (sheet,) = window.findChildren(KeySheet)
    assert sheet.width() <= size[0]
    assert sheet.height() <= size[1]
    assert not list(faults(sheet))
    inside = sheet.area.widget()
    assert inside.width() <= sheet.area.viewport().width()
    last = inside.layout().itemAt(0).geometry().bottom()
    sheet.area.verticalScrollBar().setValue(sheet.area.verticalScrollBar().maximum())
    assert last - sheet.area.verticalScrollBar().value() <= sheet.area.viewport().height()
    sheet.close()
    QApplication.processEvents()


def test_the_sheet_has_its_title_grows_with_the_letters_and_answers_no_question_that_it_covers(new_window, qtbot):
    card = asked(new_window)
    qtbot.waitUntil(lambda: card.choices["yes"].isEnabled())
    new_window.resize(1920, 1080)
    new_window.show_keys()
    settle(new_window)
    (sheet,) = new_window.findChildren(KeySheet)
    title = sheet.findChild(QLabel, "large")
    assert title.text() == "Keys"
    before = title.height()
    new_window.toggle_wall()
    settle(new_window)
    assert title.height() > before
    qtbot.keyPress(new_window, Qt.Key.Key_F8)
    assert not card.choices["yes"].held.isActive()
    qtbot.keyRelease(new_window, Qt.Key.Key_F8)
    sheet.close()
    new_window.toggle_wall()
