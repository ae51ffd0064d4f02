"""The list of who is there: the instruments of the bench file, and the guardian below them. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.guardian import GUARDIAN
from labcal.gui.viewmodels.lab_now import Lights

GUARDED = ("coil-", "polarity", "interlock")  # roles
IN_RUN = QT_TRANSLATE_NOOP("Words", "only in a run")


def with_guardian(lights: Lights, facts: Bench | None) -> Lights:
    """Of a bench that a guardian belongs to it is listed in a run and at rest."""
    if facts is None or facts.virtual_time or any(name == GUARDIAN for name, *_ in lights):
        return lights
    lines = [one.link for one in facts.instruments.values() if one.role.startswith(GUARDED)]
    own = [link for link in lines if not link.startswith(("emulated://", "manual://"))]
    return (*lights, (GUARDIAN, "absent", translated(str(IN_RUN)))) if own else lights
