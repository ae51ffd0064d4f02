"""Who is named on a certificate: fields below their heading without an empty line, Keep in line with them."""

import pytest
from PySide6.QtCore import QPoint
from test_path import calibration

from labcal.gui.ipc.customer_messages import Named
from labcal.gui.ipc.messages import ListCalibrations, ListKeys, WhoIsNamed


@pytest.fixture
def names(new_window, qtbot):
    new_window.open_page("Certificate")
    page, worker = new_window.page("Certificate"), new_window.app_state.quick_worker
    worker.answer(ListCalibrations, (calibration(signed=False),))
    worker.answer(ListKeys, ("jdoe@lab",))
    worker.answer(WhoIsNamed, Named("", ""))
    qtbot.wait(50)
    return page.names


def middle(card, part):
    return part.mapTo(card, QPoint(0, 0)).y() + part.height() / 2


def test_nothing_empty_stands_above_the_fields(names):
    assert names.laboratory[0].isVisible()
    assert names.stated.text() == ""
    assert not names.stated.isVisible()


def test_the_button_is_in_the_middle_of_what_it_keeps(names):
    rows = middle(names, names.laboratory[0]), middle(names, names.customer[0])
    assert abs(middle(names, names.keep) - sum(rows) / 2) <= 1
