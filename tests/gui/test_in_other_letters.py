"""A desktop that names its letters keeps them: where they are wider or higher than ours nothing is cut either."""

from itertools import combinations
from pathlib import Path

import pytest
from matplotlib import get_data_path
from PySide6.QtCore import QRectF
from PySide6.QtGui import QFont, QFontDatabase, QFontInfo
from PySide6.QtWidgets import QApplication, QVBoxLayout
from test_nothing_is_cut import TURNED, begun, doubted, other_language, settle

from labcal.gui.theming.theme import LIGHT
from labcal.gui.widgets import camera_view
from labcal.gui.widgets.camera_view import CameraView
from labcal.gui.widgets.common import label
from labcal.gui.widgets.mounting_view import Mounting
from labcal.gui.widgets.rolled import Rolled
from labcal.gui.widgets.wanted_line import WantedLine

WIDE = "DejaVu Sans"  # a fifth wider than ours; Matplotlib brings it
__all__ = ["other_language"]


@pytest.fixture
def wider(qapp):
    before = qapp.font()
    letters = QFont(before)
    QFontDatabase.addApplicationFont(str(Path(get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"))
    letters.setFamily(WIDE)
    assert QFontInfo(letters).family() == WIDE
    qapp.setFont(letters)
    yield
    qapp.setFont(before)


@pytest.mark.parametrize("other_language", ["de"], indirect=True)
def test_what_is_said_of_hands_at_its_longest_has_all_its_lines_on_a_small_screen(
    wider, other_language, new_window, rest
):
    rest(new_window)
    doubted(new_window)
    for _ in range(2):
        new_window.resize(1024, 700)
        settle(new_window)
    side = new_window.side
    said = [one for one in (side.keep_off, side.hands, side.zero_words) if one.isVisible()]
    assert side.keep_off in said
    assert [one.text() for one in said if one.height() < one.heightForWidth(one.width())] == []
    assert side.coils.height() >= side.coils.minimumSizeHint().height()


def test_a_line_is_as_wide_as_what_it_says_is_wanted(qtbot):
    line = WantedLine("Why it may begin, in whole words", "")
    qtbot.addWidget(line)
    letters = line.font()
    letters.setStretch(200)
    line.setFont(letters)
    assert line.sizeHint().width() > line.fontMetrics().horizontalAdvance(line.placeholderText())


def test_where_there_is_no_camera_the_drawing_has_the_room_but_for_the_words(qtbot, still, monkeypatch):
    monkeypatch.setattr(camera_view, "opened", lambda source: (None, "camera"))
    card = still.page("Run").live.prompt
    card.camera.source = "nowhere"
    still.open_page(begun(still, TURNED))
    qtbot.waitUntil(lambda: "nowhere" in card.camera.words())
    card.camera.look()
    lines = card.camera.fontMetrics().boundingRect(card.camera.rect(), camera_view.CENTRED, card.camera.words())
    qtbot.waitUntil(lambda: card.camera.height() == lines.height())
    assert card.drawing.height() > card.camera.height()


def test_where_a_picture_may_still_come_it_has_its_place(qtbot):
    camera = CameraView()
    qtbot.addWidget(camera)
    camera.resize(200, 300)
    camera.look()
    assert camera.maximumHeight() > 300
    assert camera.minimumHeight() == camera_view.LEAST_PX


def test_the_gravest_words_are_in_sight_whole_at_every_width(qtbot):
    """Their lines were counted at a width that the margin beside the bar is part of."""
    words, layout = label("Hands may go in: coils at zero, each was read back. " * 7, wrap=True), QVBoxLayout()
    layout.addWidget(words)
    rolled = Rolled(layout, words)
    qtbot.addWidget(rolled)
    rolled.show()
    cut = []
    for width in range(220, 280):
        rolled.resize(width, 600)
        QApplication.processEvents()
        if rolled.minimumHeight() < words.heightForWidth(words.width()):
            cut.append(width)
    assert cut == []


@pytest.mark.parametrize("pt", [10.5, 14.7, 18.9])
def test_no_word_stands_in_the_drawing_and_no_name_on_another(qtbot, pt):
    drawing = Mounting(LIGHT)
    qtbot.addWidget(drawing)
    letters = drawing.font()
    letters.setPointSizeF(pt)
    drawing.setFont(letters)
    drawing.resize(224, 400)
    drawing.show_drawing({"body_from_cage": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]})
    drawing.grab()
    words = QRectF(0, drawing.words_top(), drawing.width(), drawing.height())
    assert not [name for name, place in drawing.names.items() if place.intersects(words)]
    assert not [pair for pair in combinations(drawing.names.values(), 2) if pair[0].intersects(pair[1])]
