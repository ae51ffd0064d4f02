"""The drawing of a mounting: the DUT stands as it would on the platform where that stands now."""

import time

import numpy as np
import pytest

from labcal.bench.coils.state import LabState, PlatformReading, unread
from labcal.gui.ipc.messages import RunProcedure
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
    assert card.drawing.platform_words() == "platform at 137°"
    assert "platform stands at 137°, read 40 s ago" in card.stands.text()
