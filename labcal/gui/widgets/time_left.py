"""How far a run is: a bar, the step, the lab time that is left, and when a person is needed by the wall clock."""

from __future__ import annotations

from datetime import datetime

from PySide6.QtWidgets import QProgressBar, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.lab_now import LabNow, alarm_of
from labcal.gui.viewmodels.number_format import clock_time, format_duration, needed_title
from labcal.gui.viewmodels.pace import faster_than_life
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.widgets.roomy import Roomy

THOUSANDTHS = 1000
LONGEST_TIME, LONGEST_LEFT = "00:00", "00:00:00"
DAY_S = 86_400.0
UNBROKEN = "\N{NON-BREAKING HYPHEN}"  # the name of a step stays on one line


class TimeLeft(QWidget):
    """Shows `run`; nothing is promised while a person is asked, a step has failed, one is lost, or coils may be on."""

    def __init__(self, run: RunViewModel) -> None:
        super().__init__()
        self._run = run
        self._room: tuple[tuple[str, ...], bool] = ((), False)  # for which steps there is room
        self.progress = QProgressBar()
        self.progress.setRange(0, THOUSANDTHS)
        self.progress.setTextVisible(False)
        self.left, self.until = Roomy("caption", wrap=True), Roomy(wrap=True)
        self.until.setAccessibleName(self.tr("When it is done, and when you are needed"))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(GRID)
        for widget in (self.progress, self.left, self.until):
            column.addWidget(widget)

    def show_share(self) -> None:
        """The bar: what is over of the whole."""
        self.progress.setVisible(self._run.step is not None)
        self.progress.setValue(round(THOUSANDTHS * self._run.share()))

    def show_now(self, now: LabNow) -> None:
        """The bar, and the words, beside what is said of the lab."""
        self.show_share()
        self._give_room(alarmed=bool(alarm_of(now.coil_words)))
        self.until.setText(words := self._until(now))
        self.until.setVisible(bool(words))
        self.left.setText(self._left())

    def _give_room(self, *, alarmed: bool) -> None:
        """As long as a run goes on: what stands below moves with no word that comes or goes.

        Below a card that warns of coils, which needs the room, nothing is promised, and no room is kept for that.
        """
        run, keeps = self._run, self.until.sizePolicy()
        if keeps.retainSizeWhenHidden() is alarmed:
            keeps.setRetainSizeWhenHidden(not alarmed)
            self.until.setSizePolicy(keeps)
        wanted = (run.names if run.alive else (), faster_than_life(run.order, run.virtual_time))
        if wanted == self._room:
            return
        self._room = wanted
        tomorrow = clock_time(datetime.now(), DAY_S)  # a run that is done on another day says which
        done = self.tr("Done at about {0}").format(tomorrow)
        titles = {needed_title(name).replace("-", UNBROKEN) for name in wanted[0]}
        needed = (self.tr("You are needed at {0}: {1}").format(LONGEST_TIME, title) for title in titles)
        soon = (self.tr("You are needed within a minute: {0}").format(title) for title in titles)
        self.until.room_for(*sorted(f"{one}\n{done}" for one in (*needed, *soon)))
        self.left.room_for(*(self._at_step(len(wanted[0]), len(wanted[0]), LONGEST_LEFT) for _ in wanted[0][:1]))

    def _left(self) -> str:
        run, left_s = self._run, self._run.left_s()
        if run.state == "starting":
            return run.message
        if run.step is None:
            return ""
        if left_s is None:
            return ""  # it has ended: the verdict says how
        marks, total, left = [mark for _, mark in run.steps()], run.step.total, format_duration(left_s)
        at = min(marks.index("now") if "now" in marks else run.steps_done(), total - 1) + 1  # that which is marked
        return self._at_step(at, total, left)

    def _at_step(self, at: int, total: int, left: str) -> str:
        if not faster_than_life(self._run.order, self._run.virtual_time):
            return self.tr("step {0} of {1} · {2} left").format(at, total, left)
        return self.tr("step {0} of {1} · {2} of simulated time left").format(at, total, left)

    def _until(self, lab: LabNow) -> str:
        run, now = self._run, datetime.now()
        needed_for = run.step.needed_for if run.step else ""
        done_s, needed_s = run.promised_s("", run.left_s()), run.promised_s(needed_for, run.needed_s())
        if not done_s or run.time.failed or alarm_of(lab.coil_words) or lab.failed:
            return ""
        this_minute = clock_time(now, 0.0)
        done = self.tr("Done at about {0}").format(clock_time(now, done_s))
        done = "" if clock_time(now, done_s) == this_minute else done  # a time that is there is no forecast
        if not needed_s or run.step is None:
            return done
        at, what = clock_time(now, needed_s), needed_title(needed_for).replace("-", UNBROKEN)
        soon, later = self.tr("You are needed within a minute: {0}"), self.tr("You are needed at {0}: {1}")
        needed = soon.format(what) if at == this_minute else later.format(at, what)
        return "\n".join(filter(None, (needed, done)))
