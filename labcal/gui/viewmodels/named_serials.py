"""Instruments that name another serial than is stated: pointed out wherever one of the two is read."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Qt

from labcal.bench.serials import is_another
from labcal.gui.ipc.answers import Bench, InstrumentAnswer
from labcal.gui.translations.punctuation import listed_apart
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.run import RunViewModel
from labcal.record.stream import OTHER_SERIAL, Event


class NamedSerials(QObject):
    """Keeps `other_serials` of the lab's state: by instrument, in words."""

    def __init__(self, lab: LabViewModel, run: RunViewModel, facts: Callable[[], Bench | None]) -> None:
        super().__init__()
        self._lab, self._facts, self._named = lab, facts, dict[str, str]()
        lab.changed.connect(self._say, Qt.ConnectionType.QueuedConnection)  # others hear first what has changed
        run.item.connect(self._heard)

    def take(self, answered: Mapping[str, InstrumentAnswer]) -> None:
        """Who they say they are."""
        self._named |= {name: one.serial for name, one in answered.items()}
        self._say()

    def forget(self) -> None:
        """Another bench."""
        self._named.clear()
        self._say()

    def asked(self) -> str:
        """What whoever begins a run is asked, where the DUT names another serial than stands at the top; else ""."""
        facts = self._facts()
        duts = [] if facts is None else [name for name, one in facts.instruments.items() if one.role == "dut"]
        said = [f"{name} {words}" for name, words in self._lab.state.other_serials if name in duts]
        return self.tr("{0}: is this the right sensor?").format(listed_apart(said)) if said else ""

    def _heard(self, item: object) -> None:
        """A run asks as well, and tells of those that name another."""
        if isinstance(item, Event) and item.kind == OTHER_SERIAL:
            self._named[str(item.data["instrument"])] = str(item.data["named"])
            self._say()

    def _say(self, _state: object = None) -> None:
        facts = self._facts()
        if facts is None:
            return self._lab.update(other_serials=())
        said = self.tr("names itself {0}, not {1}")
        found = []
        for name, one in facts.instruments.items():
            wanted = one.serial
            if one.role == "dut":  # a simulated one is whichever is asked for
                wanted = "" if facts.simulated else self._lab.state.dut_serial
            if is_another(named := self._named.get(name, ""), wanted):
                found.append((name, said.format(named, wanted)))
        return self._lab.update(other_serials=tuple(found))
