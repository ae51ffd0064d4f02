"""Who is back after a silence, and from when to when it was out: that stays beside its name. No widgets."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import shown_name
from labcal.gui.viewmodels.lost_since import LostSince
from labcal.gui.viewmodels.run import RunViewModel

BACK = QT_TRANSLATE_NOOP("Words", "back {0}, out since {1}")


class BackAgain:
    """Looks at the lights each time that the lab is known anew; what it says stays until the next run begins.

    Who is not asked any more, or not yet, is not back.
    """

    def __init__(self, lab: LabViewModel, run: RunViewModel) -> None:
        self._lab, self._run, self._times = lab, run, LostSince()
        self._out = dict[str, str]()  # by who is out: since when
        run.changed.connect(self._begins)

    def look(self) -> None:
        """Who is out since when, and who is heard again."""
        now, back = self._lab.state.now, dict(self._lab.state.back)
        lights = {name: light for name, light, _ in now.lights}
        since = self._times.since(now)
        heard = [name for name in self._out if lights.get(name) == "ok"]
        back |= {
            name: translated(str(BACK)).format(f"{datetime.now():%H:%M:%S}", self._out.pop(name)) for name in heard
        }
        lost = [name for name, light in lights.items() if light == "fault"]
        self._out |= {name: self._out.get(name) or since[shown_name(name)] for name in lost}
        self._lab.update(back=tuple((name, words) for name, words in back.items() if name not in lost))

    def forget(self) -> None:
        """Another run begins, or another bench is open."""
        self._out.clear()
        self._lab.update(back=())

    def _begins(self) -> None:
        if self._run.state == "starting" and self._lab.state.back:
            self._lab.update(back=())
