"""What is heard across the room: somebody is needed (two rising tones), or it is done (three falling ones).

Tones where Qt's multimedia is installed and the computer has a sound device; else the system's own beep, once and
three times. The switch in the sidebar turns both off.
"""

from __future__ import annotations

import math
import struct
import wave
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from PySide6.QtCore import QObject, QSettings, QTimer, QUrl
from PySide6.QtWidgets import QApplication

Sound = Literal["needed", "done"]
TONES_HZ: dict[Sound, tuple[float, ...]] = {"needed": (660.0, 880.0), "done": (784.0, 659.0, 523.0)}
BEEPS: dict[Sound, int] = {"needed": 1, "done": 3}
TONE_S, FADE_S, RATE_HZ = 0.22, 0.02, 22_050
ROWS = int(TONE_S * RATE_HZ)  # of one tone
BETWEEN_BEEPS_MS = 350


def is_on(settings: QSettings) -> bool:
    """Whether the window makes any sound."""
    return str(settings.value("sound", "yes")) == "yes"


def switch(settings: QSettings) -> None:
    """Off where it is on, and on where it is off; kept for the next day."""
    settings.setValue("sound", "no" if is_on(settings) else "yes")


class Sounds(QObject):
    """Plays one or the other, unless they are switched off."""

    def __init__(self, parent: QObject, settings: QSettings) -> None:
        super().__init__(parent)
        self._settings = settings
        self._folder: TemporaryDirectory[str] | None = None
        self.effects: dict[Sound, Any] | None = None

    def play(self, sound: Sound) -> None:
        """Play it, and wait for nothing."""
        if not is_on(self._settings):
            return
        if self.effects is None:
            self.effects = self._made()
        if sound in self.effects:
            self.effects[sound].play()
            return
        QApplication.beep()
        for n in range(1, BEEPS[sound]):
            QTimer.singleShot(n * BETWEEN_BEEPS_MS, self, QApplication.beep)

    def _made(self) -> dict[Sound, Any]:
        """The tones, where this computer can play them."""
        try:
            multimedia = import_module("PySide6.QtMultimedia")
            if not multimedia.QMediaDevices.audioOutputs():
                return {}
        except (ImportError, AttributeError):
            return {}
        self._folder = TemporaryDirectory(prefix="labcal-sounds-", ignore_cleanup_errors=True)
        return {sound: self._effect(multimedia, sound) for sound in TONES_HZ}

    def _effect(self, multimedia: Any, sound: Sound) -> Any:
        assert self._folder is not None
        file = Path(self._folder.name) / f"{sound}.wav"
        write_tones(file, TONES_HZ[sound])
        effect = multimedia.QSoundEffect(self)
        effect.setSource(QUrl.fromLocalFile(str(file)))
        return effect


def write_tones(file: Path, tones_Hz: tuple[float, ...]) -> None:
    """Write sine tones one after the other as a .wav of one channel, each faded in and out."""
    samples = [round(12_000 * _sine(f, k)) for f in tones_Hz for k in range(ROWS)]
    with wave.open(str(file), "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(RATE_HZ)
        out.writeframes(struct.pack(f"<{len(samples)}h", *samples))


def _sine(tone_Hz: float, row: int) -> float:
    """Between -1 and 1, softer at either end."""
    fade = min(1.0, row / RATE_HZ / FADE_S, (ROWS - row) / RATE_HZ / FADE_S)
    return fade * math.sin(math.tau * tone_Hz * row / RATE_HZ)
