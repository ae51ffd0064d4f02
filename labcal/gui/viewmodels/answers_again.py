"""Whom a run waited for in vain, and who answers again: what it was ended by is no longer to be mended then."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.guardian.wire import TRIED_AGAIN
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, Lights
from labcal.gui.viewmodels.run import RunViewModel

AGAIN = QT_TRANSLATE_NOOP("Words", "{0}: answers again")
LIFTED = QT_TRANSLATE_NOOP("Words", "✓ The zero was checked: supplies and reference agree. A run may begin again.")


class AnswersAgain:
    """Looks at the lights from when a fault is shown: one that was red since, and is not any more, was heard."""

    def __init__(self) -> None:
        self._fault: Fault | None = None
        self._was_red = self._was_lifted = False

    def words(self, run: RunViewModel, facts: Bench | None, now: LabNow) -> str:
        """What a run was ended by, once that is mended: who answers again, or that its zero was seen; else ""."""
        fault = run.fault
        named = self.named(fault, () if facts is None else facts.instruments, now.lights)
        if run.state != "ended":
            return ""
        self._was_lifted |= fault is not None and fault.kind == "zero" and now.reference_agreed
        if self._was_lifted:
            return translated(str(LIFTED))
        return translated(str(AGAIN)).format(", ".join(named)) if named else ""

    def named(self, fault: Fault | None, instruments: Iterable[str], lights: Lights) -> list[str]:
        """Whom `fault` blames, of these `instruments`, once all of them answer again; nobody before."""
        if fault is not self._fault:
            self._fault, self._was_red, self._was_lifted = fault, False, False
        if fault is None or fault.kind != "instrument":
            return []
        blamed = [name for name in instruments if name in fault.text]
        now = {name: light for name, light, _ in lights if name in blamed}
        self._was_red |= "fault" in now.values()
        tried = TRIED_AGAIN in fault.remedy and set(now.values()) == {"ok"}  # the guardian found it, before or since
        heard = bool(now) and len(now) == len(blamed) and set(now.values()) <= {"ok", "old"}
        return blamed if heard and (self._was_red or tried) else []
