"""The Certificate page is opened at its top: how the file stands comes before what is to be done with it."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from test_certificate_steps import DRAFT, settle, told
from test_path import RUN


@pytest.fixture
def window(new_window):
    new_window.resize(1280, 700)
    app_state = new_window.app_state
    app_state.set_identity(dut="EM-07", operator="J. Doe")
    app_state.path.take_runs((replace(RUN, verdict="explained"),))
    new_window.open_page("Certificate")
    told(new_window.page("Certificate"), DRAFT, "a.smith")
    return new_window


def rolled(window):
    settle()
    return window.lazy_pages["Certificate"].area.verticalScrollBar().value()


@pytest.mark.parametrize("by", ["its name", "Next"])
def test_the_certificate_page_is_opened_at_its_top(window, qtbot, by):
    bar = window.lazy_pages["Certificate"].area.verticalScrollBar()
    assert bar.maximum() > 0
    bar.setValue(bar.maximum())
    window.open_page("Start")
    settle()
    if by == "Next":
        qtbot.mouseClick(window.next, Qt.MouseButton.LeftButton)
    else:
        window.open_page("Certificate")
    assert (window.page_shown(), rolled(window)) == ("Certificate", 0)


def test_next_on_the_page_itself_shows_the_whole_card_of_what_is_to_be_done(window, qtbot):
    window.resize(1280, 480)
    assert rolled(window) == 0
    page, area = window.page("Certificate"), window.lazy_pages["Certificate"].area
    qtbot.mouseClick(window.next, Qt.MouseButton.LeftButton)
    assert rolled(window) > 0
    field = window.focusWidget()
    assert page.steps.isAncestorOf(field)
    top = field.mapTo(area.viewport(), QPoint()).y()
    assert top >= 0
    assert top + field.height() <= area.viewport().height()
