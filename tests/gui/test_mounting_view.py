"""The drawing of a mounting: the DUT stands as it would on the platform where that stands now."""

import time
from dataclasses import replace
from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF
from PySide6.QtGui import QFontMetricsF

from labcal.bench.coils.state import LabState, PlatformReading, unread
from labcal.bench.mounting import attitude
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.theming.theme import LIGHT
from labcal.gui.widgets import mounting_view
from labcal.gui.widgets.mounting_view import Mounting
from labcal.gui.widgets.placed_names import Tip, near, placed
from labcal.record.stream import Prompt

UP = {"body_from_cage": np.eye(3).tolist(), "axis_cage": [0.0, 0.0, 1.0]}


@pytest.mark.parametrize(
    ("platform", "along_x", "words"),
    [
        (PlatformReading(90.0, False, 1.0), (0.0, 1.0, 0.0), "platform at 90°"),
        (PlatformReading(-30.0, False, 1.0), (np.sqrt(0.75), -0.5, 0.0), "platform at −30°"),
        (PlatformReading(fault="silent"), (1.0, 0.0, 0.0), "drawn for platform angle 0°; where it stands is not known"),
        (None, (1.0, 0.0, 0.0), "drawn for platform angle 0°; where it stands is not known"),
    ],
)
def test_the_dut_is_drawn_on_the_platform_as_it_stands(still, platform, along_x, words):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "mounting-stands", "Still?", ("yes", "no"), True, UP),))
    drawing = still.page("Run").live.prompt.drawing
    if platform is not None and platform.read_s is not None:
        platform = replace(platform, read_s=time.monotonic())
    still.app_state.bench_worker.states.emit(LabState(unread(), platform=platform))
    assert np.allclose(drawing.body()[0], along_x)
    assert np.allclose(drawing.body()[2], (0.0, 0.0, 1.0))
    assert drawing.platform_words() == words
    assert drawing.toolTip() == words


def test_where_it_stands_is_as_old_as_its_reading_says_beside_it(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.items.emit((Prompt(1.0, "mount-x", "Mount.", ("done",), True, UP),))
    before = PlatformReading(137.0, False, time.monotonic() - 40)
    still.app_state.bench_worker.states.emit(LabState(unread(), platform=before))
    card = still.page("Run").live.prompt
    assert card.drawing.platform_words() == "platform at 137°, 40 s ago"
    assert "platform stands at 137°, read 40 s ago" in card.stands.text()


SIZES = ((128, 200), (300, 300), (260, 500), (620, 420))


def mounted(qtbot, size, up):
    """The drawing of a mounting with this body axis up, of this size, drawn."""
    drawing = Mounting(LIGHT)
    qtbot.addWidget(drawing)
    drawing.resize(*size)
    bench = SimpleNamespace(config=SimpleNamespace(platform=SimpleNamespace(axis_cage=(0.0, 0.0, 1.0))))
    drawing.show_drawing({"body_from_cage": attitude(bench, up).tolist(), "axis_cage": [0.0, 0.0, 1.0]})
    drawing.show_platform(0.0)
    drawing.grab()
    return drawing


@pytest.mark.parametrize("size", SIZES, ids=str)
@pytest.mark.parametrize("up", "xyz")
def test_names_of_axes_lie_over_no_other_name_and_within_the_drawing(qtbot, size, up):
    drawing = mounted(qtbot, size, up)
    assert len(drawing.names) == 5
    assert all(drawing.rect().toRectF().contains(place) for place in drawing.names.values())
    assert [pair for pair in combinations(drawing.names.values(), 2) if pair[0].intersects(pair[1])] == []


@pytest.mark.parametrize(("size", "small"), [((130, 340), True), ((900, 700), False)], ids=str)
@pytest.mark.parametrize("up", "xyz")
def test_names_are_written_small_where_large_ones_would_stand_at_another_arrow(qtbot, size, up, small):
    drawing = mounted(qtbot, size, up)
    usual = QFontMetricsF(drawing.font()).height()
    assert all((place.height() < usual) == small for place in drawing.names.values())


def test_a_name_nearer_to_another_tip_than_to_its_own_or_far_from_it_is_not_near():
    size = QSizeF(40.0, 12.0)
    tips = [Tip(QPointF(0.0, 0.0), 0.0, size), Tip(QPointF(100.0, 0.0), 0.0, size)]
    own = [QRectF(5.0, -6.0, 40.0, 12.0), QRectF(105.0, -6.0, 40.0, 12.0)]
    assert near(tips, own)
    assert not near(tips, own[::-1])
    assert not near(tips, [own[0], QRectF(105.0, 60.0, 40.0, 12.0)])


@pytest.mark.parametrize("size", [(244, 550), (404, 770), (620, 420)], ids=str)
@pytest.mark.parametrize("up", "xyz")
def test_names_of_axes_lie_on_no_line_of_the_drawing(qtbot, monkeypatch, size, up):
    drawn = []
    monkeypatch.setattr(
        mounting_view, "placed", lambda tips, lines, within: drawn.extend(lines) or placed(tips, lines, within)
    )
    drawing = mounted(qtbot, size, up)
    assert len(drawn) > 60  # the rim of the platform and the edges of the box are among them
    points = [line.pointAt(n / 20) for line in drawn for n in range(21)]
    assert {name for name, place in drawing.names.items() if any(map(place.contains, points))} == set()


def test_a_name_stands_on_no_line_where_it_can_be_helped():
    tip = Tip(QPointF(100, 100), 0.0, QSizeF(50, 16))
    beside = QLineF(105, 100, 160, 100)
    (place,) = placed([tip], [beside], QRectF(0, 0, 300, 300))
    assert not any(place.contains(beside.pointAt(n / 50)) for n in range(51))


def test_two_names_stand_apart_and_do_not_touch():
    tips = [Tip(QPointF(100, 100), 0.0, QSizeF(50, 16)), Tip(QPointF(100, 117), 0.0, QSizeF(50, 16))]
    first, second = placed(tips, [], QRectF(0, 0, 300, 300))
    assert not first.adjusted(-5, -5, 5, 5).intersects(second)
