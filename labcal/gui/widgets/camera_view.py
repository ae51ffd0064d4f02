"""What a camera at the cage sees, beside the drawing of a mounting: the DUT as it stands, kept with the answer.

`camera` of bench.toml says which one; the extra `camera` (OpenCV) reads it. A camera that is missing keeps nobody from
measuring: the place of the picture says what is wrong.
"""

from __future__ import annotations

import time
from importlib import import_module
from pathlib import Path
from threading import Event, Thread
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QRect, Qt, QTemporaryDir, QTimer
from PySide6.QtGui import QImage, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

from labcal.gui.widgets.roomy import NO_END_PX

LOOK_MS = 80
OLD_S = 2.0  # a picture that is older is no picture of now
LEAST_PX = 120  # of a picture's height
CENTRED = int(Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap)
Missing = Literal["", "extra", "camera", "pictures"]  # what there is none of
Frame = NDArray[np.uint8]  # (rows, columns, 3), blue first


def opened(source: str) -> tuple[Any, Missing]:
    """The camera of this number, or at this address, as OpenCV has it; or what is missing."""
    try:
        cv2 = import_module("cv2")
    except ImportError:
        return None, "extra"
    camera = cv2.VideoCapture(int(source) if source.isdigit() else source)
    return camera, "" if camera.isOpened() else "camera"


class Watching:
    """Reads one camera in a thread of its own, which waits for it, until `stop`: the window never does."""

    def __init__(self, source: str) -> None:
        self.latest: tuple[float, Frame] | None = None  # and when it came, by the computer's monotonic clock
        self.missing: Missing = ""
        self._over = Event()
        Thread(target=self._watch, args=(source,), daemon=True, name="camera").start()

    def stop(self) -> None:
        """Let go of the camera as soon as it gives its next picture."""
        self._over.set()

    def _watch(self, source: str) -> None:
        camera, self.missing = opened(source)
        if self.missing:
            return
        try:
            while not self._over.is_set():
                good, frame = camera.read()
                if not good:
                    self.missing = "pictures"
                    return
                self.latest = time.monotonic(), frame
        finally:
            camera.release()


class CameraView(QWidget):
    """The newest picture of the camera while it is watched; nothing at all where the bench has none."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumSize(128, LEAST_PX)
        self.source = ""
        self._watching: Watching | None = None
        self._folder = QTemporaryDir()
        self._timer = QTimer(self, interval=LOOK_MS)
        self._timer.timeout.connect(self.look)
        self.hide()

    def watch(self, wanted: bool) -> None:
        """Begin where a camera is stated, or end."""
        self.setVisible(wanted and bool(self.source))
        if self._watching is not None:
            self._watching.stop()
        self._watching = Watching(self.source) if wanted and self.source else None
        self._timer.start() if self._watching is not None else self._timer.stop()
        self.look()

    def picture(self) -> QImage | None:
        """What is seen now; None where that is nothing, or old."""
        latest = None if self._watching is None else self._watching.latest
        if latest is None or time.monotonic() - latest[0] > OLD_S:
            return None
        rows, columns, _ = latest[1].shape
        return QImage(latest[1].tobytes(), columns, rows, 3 * columns, QImage.Format.Format_BGR888).copy()

    def save(self) -> str:
        """The path of a file that holds what is seen now, gone with the window; "" where that is nothing."""
        if (picture := self.picture()) is None:
            return ""
        file = Path(self._folder.path()) / f"{time.time_ns()}.png"
        return str(file) if picture.save(str(file)) else ""

    def words(self) -> str:
        """What stands in the place of the picture where there is none."""
        if self._watching is None or self.picture() is not None:
            return ""
        if self._watching.missing:
            return {
                "extra": self.tr("No camera: OpenCV is not installed (pip install 'labcal[camera]')."),
                "camera": self.tr("No camera answers at {0}.").format(self.source),
                "pictures": self.tr("The camera {0} gives no picture any more.").format(self.source),
            }[self._watching.missing]
        if (latest := self._watching.latest) is None:
            return self.tr("The camera has given no picture yet …")
        return self.tr("The camera has given no picture for {0:.0f} s.").format(time.monotonic() - latest[0])

    def look(self) -> None:
        """Show what has come."""
        said = self.words()
        self.setAccessibleName(said or self.tr("Picture of the camera: the DUT as it stands now"))
        self._take_place()
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width the words have other lines."""
        super().resizeEvent(event)
        self._take_place()

    def _take_place(self) -> None:
        """Where no picture can come no more height than its words need: the drawing above has the rest."""
        none = self._watching is not None and self._watching.missing in ("extra", "camera")
        words = self.fontMetrics().boundingRect(QRect(0, 0, self.width(), NO_END_PX), CENTRED, self.words())
        self.setMinimumHeight(words.height() if none else LEAST_PX)
        self.setMaximumHeight(words.height() if none else NO_END_PX)

    def paintEvent(self, event: QPaintEvent) -> None:
        """The picture as large as its place, or why there is none."""
        with QPainter(self) as painter:
            if (picture := self.picture()) is None:
                painter.drawText(self.rect(), CENTRED, self.words())
                return
            place = QRect(QPoint(), picture.size().scaled(self.size(), Qt.AspectRatioMode.KeepAspectRatio))
            place.moveCenter(self.rect().center())
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(place, picture)
