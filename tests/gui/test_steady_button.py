"""A click is not lost because a card above the button came or went while the mouse was down."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from labcal.gui.widgets.common import button


@pytest.mark.parametrize(
    ("page_moves", "mouse_moves", "taken"), [(80, 0, True), (0, 0, True), (80, 60, False), (0, 60, False)]
)
def test_what_counts_is_where_it_was_pressed(qtbot, page_moves, mouse_moves, taken):
    page = QWidget()
    qtbot.addWidget(page)
    page.resize(300, 300)
    made, clicks = button("Simulated lab", ""), []
    made.setParent(page)
    made.clicked.connect(lambda: clicks.append(1))
    made.setGeometry(20, 20, 120, 30)
    page.show()
    at = QPoint(60, 15)
    on_screen = made.mapToGlobal(at)
    QTest.mousePress(made, Qt.MouseButton.LeftButton, pos=at)
    made.move(20, 20 + page_moves)
    let_go = made.mapFromGlobal(on_screen + QPoint(3 * mouse_moves, 0))
    QTest.mouseRelease(made, Qt.MouseButton.LeftButton, pos=let_go)
    assert bool(clicks) is taken
