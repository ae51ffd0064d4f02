"""Whom a run waited for in vain, and who answers again: what it was ended by is no longer to be mended then."""

from __future__ import annotations

from collections.abc import Iterable

from labcal.bench.guardian.wire import TRIED_AGAIN
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.lab_now import Lights


class AnswersAgain:
    """Looks at the lights from when a fault is shown: one that was red since, and is not any more, was heard."""

    def __init__(self) -> None:
        self._fault: Fault | None = None
        self._was_red = False

    def named(self, fault: Fault | None, instruments: Iterable[str], lights: Lights) -> list[str]:
        """Whom `fault` blames, of these `instruments`, once all of them answer again; nobody before."""
        if fault is not self._fault:
            self._fault, self._was_red = fault, False
        if fault is None or fault.kind != "instrument":
            return []
        blamed = [name for name in instruments if name in fault.text]
        now = {name: light for name, light, _ in lights if name in blamed}
        self._was_red |= "fault" in now.values()
        tried = TRIED_AGAIN in fault.remedy and set(now.values()) == {"ok"}  # the guardian found it, before or since
        heard = bool(now) and len(now) == len(blamed) and set(now.values()) <= {"ok", "old"}
        return blamed if heard and (self._was_red or tried) else []
