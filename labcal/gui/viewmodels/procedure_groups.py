"""Procedures in the groups in which a technician looks for them."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated

GROUPS = {
    "Calibrate a DUT": ("preflight", "field-sphere", "configuration"),
    "Every morning": ("morning-check", "axes-check", "sync-check", "ambient"),
    "Test a DUT": (
        "verify",
        "rotate-axis",
        "linearity",
        "rate-sweep",
        "temperature-drift",
        "current-coupling",
        "dut-moment",
        "degauss",
        "flip",
        "repeat",
        "reverse",
    ),
    "The cage and its reference": (
        "cage-calibration",
        "cage-map",
        "scalar-cage",
        "locate",
        "reference-check",
        "platform-signature",
    ),
    "Fields": ("field-hold", "play-field"),
}
CALIBRATES = ("preflight", "field-sphere")  # a calibration may come of one run of them alone
OTHERS = "Others"
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "Calibrate a DUT"),
    QT_TRANSLATE_NOOP("Words", "Every morning"),
    QT_TRANSLATE_NOOP("Words", "Test a DUT"),
    QT_TRANSLATE_NOOP("Words", "The cage and its reference"),
    QT_TRANSLATE_NOOP("Words", "Fields"),
    QT_TRANSLATE_NOOP("Words", "Others"),
)


def calibrates(procedure: str) -> bool:
    """Whether a calibration may come of one run of it; of one of another package it may."""
    return procedure in CALIBRATES or not any(procedure in names for names in GROUPS.values())


def group_of(name: str) -> str:
    """The words of the group of the procedure `name`; those of another package are among the others."""
    return translated(next((group for group, names in GROUPS.items() if name in names), OTHERS))


def grouped(names: Iterable[str]) -> list[tuple[str, list[str]]]:
    """`names` by group, in the order of the groups and within each in theirs; no group without one."""
    there = set(names)
    groups = [(translated(group), [one for one in known if one in there]) for group, known in GROUPS.items()]
    others = sorted(there - {one for known in GROUPS.values() for one in known})
    return [(group, found) for group, found in [*groups, (translated(OTHERS), others)] if found]
