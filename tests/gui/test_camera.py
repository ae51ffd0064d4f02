"""A camera at the cage: its picture stands in the mounting's question, and goes into the record with the answer."""

import sys
import time
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtGui import QImage

from labcal.gui.ipc.messages import Answer, KeepPhoto, Note, RunProcedure
from labcal.gui.widgets import camera_view
from labcal.record.stream import Prompt

ATTITUDE = {"body_from_cage": np.eye(3).tolist(), "axis_cage": [0, 0, 1]}
MOUNT = Prompt(1.0, "mount-x", "Mount the DUT with body X up.", ("done",), True, ATTITUDE)
READY = Prompt(2.0, "ready", "The field goes to 20 µT. Hands off?", acts=True)
ORANGE = (0, 120, 240)  # blue first
WAIT_MS = 60_000


class StandIn:
    """A camera that sees one colour, until it is told to be gone."""

    made = ()

    def __init__(self, source):
        self.source, self.gives, self.released = source, True, False
        StandIn.made = (*StandIn.made, self)

    def isOpened(self):
        return self.source != "nowhere"

    def read(self):
        time.sleep(0.01)  # as a camera keeps its reader waiting
        return (True, np.full((30, 40, 3), ORANGE, np.uint8)) if self.gives else (False, None)

    def release(self):
        self.released = True


@pytest.fixture
def camera(still, monkeypatch):
    """The window on a bench that states a camera, in a run."""
    monkeypatch.setitem(sys.modules, "cv2", SimpleNamespace(VideoCapture=StandIn))
    StandIn.made = ()
    state(still, "0")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    yield still.page("Run").live.prompt.camera
    state(still, "")


def state(window, source):
    window.app_state.facts = replace(window.app_state.facts, camera=source)
    window.app_state.bench_changed.emit()


def ask(window, prompt):
    window.app_state.bench_worker.items.emit((prompt,))


def test_what_the_camera_sees_is_shown_while_the_dut_is_mounted_and_no_longer(still, camera, qtbot):
    ask(still, MOUNT)
    assert camera.isVisible()
    qtbot.waitUntil(lambda: camera.picture() is not None, timeout=WAIT_MS)
    assert camera.words() == ""
    seen = camera.grab().toImage().pixelColor(camera.rect().center())
    assert (seen.blue(), seen.green(), seen.red()) == ORANGE
    assert StandIn.made[0].source == 0
    ask(still, READY)
    assert not camera.isVisible()
    qtbot.waitUntil(lambda: StandIn.made[0].released, timeout=WAIT_MS)


def test_the_picture_of_that_moment_goes_into_the_record(still, camera, qtbot, by_mouse):
    ask(still, MOUNT)
    qtbot.waitUntil(lambda: camera.picture() is not None, timeout=WAIT_MS)
    by_mouse(still.page("Run").live.prompt.choices["done"])
    kept = still.app_state.quick_worker.commands(KeepPhoto)[-1]
    assert QImage(kept.path).pixelColor(20, 15).red() == ORANGE[2]
    still.app_state.quick_worker.answer(KeepPhoto, {"file": "p.png", "sha256": "ab"})
    said = still.app_state.bench_worker.said
    assert said == [Answer("mount-x", "done"), Note("as it was mounted", {"file": "p.png", "sha256": "ab"})]


@pytest.mark.parametrize("answer", ["stop", "redo x"])
def test_no_other_answer_keeps_a_picture(still, camera, qtbot, by_mouse, answer):
    ask(still, replace(MOUNT, choices=("done", answer)))
    qtbot.waitUntil(lambda: camera.picture() is not None, timeout=WAIT_MS)
    by_mouse(still.page("Run").live.prompt.choices[answer])
    assert still.app_state.quick_worker.commands(KeepPhoto) == []


@pytest.mark.parametrize(
    ("source", "module", "said"),
    [
        ("0", None, "No camera: OpenCV is not installed (pip install 'labcal[camera]')."),
        ("nowhere", SimpleNamespace(VideoCapture=StandIn), "No camera answers at nowhere."),
    ],
)
def test_a_camera_that_is_missing_says_so_and_keeps_nobody_from_answering(
    still, camera, qtbot, by_mouse, monkeypatch, source, module, said
):
    monkeypatch.setitem(sys.modules, "cv2", module)
    state(still, source)
    ask(still, MOUNT)
    qtbot.waitUntil(lambda: camera.words() == said, timeout=WAIT_MS)
    assert camera.picture() is None
    by_mouse(still.page("Run").live.prompt.choices["done"])
    assert still.app_state.bench_worker.said == [Answer("mount-x", "done")]


def test_a_picture_that_is_old_is_shown_as_none(still, camera, qtbot, monkeypatch):
    ask(still, MOUNT)
    qtbot.waitUntil(lambda: camera.picture() is not None, timeout=WAIT_MS)
    StandIn.made[0].gives = False
    qtbot.waitUntil(lambda: StandIn.made[0].released, timeout=WAIT_MS)
    monkeypatch.setattr(camera_view, "OLD_S", 0.0)
    assert camera.picture() is None
    assert camera.words() == "The camera 0 gives no picture any more."
    assert camera.save() == ""


def test_where_no_camera_is_stated_there_is_no_place_for_one(still, camera):
    state(still, "")
    ask(still, MOUNT)
    assert not camera.isVisible()
    assert StandIn.made == ()
