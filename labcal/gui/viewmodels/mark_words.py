"""What the mark before the name of a page means, and why it is as it is now. No widgets."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.guardian import GUARDIAN
from labcal.gui.viewmodels.lab_now import WATCHED_S, LabNow

ANY = {
    "done": QT_TRANSLATE_NOOP("Words", "✓ done for this DUT"),
    "now": QT_TRANSLATE_NOOP("Words", "● it goes on now"),
    "doubt": QT_TRANSLATE_NOOP("Words", "▲ done, and something of it is open: the page says what"),
    "broken": QT_TRANSLATE_NOOP("Words", "✕ it failed: the page says why"),
    "open": QT_TRANSLATE_NOOP("Words", "○ still to be done for this DUT"),
}
BENCH = {
    "done": QT_TRANSLATE_NOOP("Words", "✓ every instrument answered within the last {0} s"),
    "now": QT_TRANSLATE_NOOP(
        "Words", "● no answer within the last {0} s, for nobody asked: {1}. By themselves they are asked now and then."
    ),
    "broken": QT_TRANSLATE_NOOP("Words", "✕ no answer: {1}"),
    "open": QT_TRANSLATE_NOOP("Words", "○ no instrument answered within the last {0} s; Read all asks them"),
}
RUN = {
    "done": QT_TRANSLATE_NOOP("Words", "✓ a run that this DUT can be calibrated by is finished"),
    "doubt": QT_TRANSLATE_NOOP("Words", "▲ the last run that was to calibrate this DUT did not come to its end"),
    "open": QT_TRANSLATE_NOOP(
        "Words", "○ no run yet that this DUT can be calibrated by: a preflight is one, a turn about one axis is none"
    ),
}
OWN = {"Bench": BENCH, "Run": RUN}


def just_read(now: LabNow) -> dict[str, bool]:
    """By instrument: whether it has answered just now, by the age that lets hands in."""
    ages = dict(now.heard_old_s)  # of contacts, which nobody asks, that of the coils
    return {
        name: light == "ok" or (light == "old" and (ages.get(name, now.coil_old_s) or 0) <= WATCHED_S)
        for name, light, _ in now.lights
        if name != GUARDIAN
    }


def mark_words(marks: Mapping[str, str], now: LabNow) -> dict[str, str]:
    """By page, a sentence on its mark."""
    failed = [name for name, light, _ in now.lights if light == "fault"]
    silent = failed or [name for name, read in just_read(now).items() if not read]
    return {
        page: translated(str(OWN.get(page, {}).get(mark) or ANY[mark])).format(WATCHED_S, ", ".join(silent))
        for page, mark in marks.items()
    }
