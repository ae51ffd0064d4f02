"""Who works here, where the lab's trust list says who may do what: by name or badge, and locked when nobody is there.

It says who is meant in the record, and proves nothing: that is what keys and passphrases are for.
"""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from labcal.gui.ipc.answers import Person
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.run import RunViewModel

IDLE_MIN = 10
MEASURE = "measure"


class LoginViewModel(QObject):
    """`people` with a role; none where nobody's is stated, and then there is no login. Never locked in a run."""

    changed = Signal()

    def __init__(self, lab: LabViewModel, run: RunViewModel) -> None:
        super().__init__()
        self._lab, self._run = lab, run
        self.people: tuple[Person, ...] = ()
        self.locked, self.refused = False, ""
        self.idle = QTimer(self, interval=IDLE_MIN * 60_000, singleShot=True)
        self.idle.timeout.connect(self._nobody_here)
        run.ended.connect(lambda *_: self.touched())

    @property
    def wanted(self) -> bool:
        """Whether people log in here."""
        return bool(self.people)

    def take_people(self, people: tuple[Person, ...]) -> None:
        """Who has a role in the trust list; whoever was here yesterday says again who works here."""
        self.people = people
        self.locked = self.wanted and not self._run.alive
        self.touched()
        self.changed.emit()

    def who(self) -> Person | None:
        """Who is logged in."""
        name = self._lab.state.operator
        return next((one for one in self.people if one.name == name), None) if not self.locked else None

    def log_in(self, name: str) -> None:
        """Take the person of this name, as typed or as their badge says; nobody else."""
        found = next((one for one in self.people if one.name.casefold() == name.strip().casefold()), None)
        self.refused = "" if found else self.tr("Nobody of the trust list has the name {0}.").format(name.strip())
        if found is not None:
            self.locked = False
            self._lab.update(operator=found.name, operator_objection="")
            self.touched()
        self.changed.emit()

    def lock(self) -> None:
        """Until somebody logs in; not in a run, whose questions somebody answers."""
        if self.wanted and not self._run.alive and not self.locked:
            self.locked, self.refused = True, ""
            self.changed.emit()

    def touched(self) -> None:
        """Somebody is here."""
        if self.wanted:
            self.idle.start()

    def objection(self) -> str:
        """Why whoever is logged in may not measure; "" where they may, or nobody logs in here."""
        who = self.who()
        if not self.wanted or (who is not None and MEASURE in who.roles):
            return ""
        if who is None:
            return self.tr("Log in first.")
        return self.tr("{0} has not the role measure in the trust list.").format(who.name)

    def _nobody_here(self) -> None:
        if self._run.alive:
            return self.idle.start()
        return self.lock()
