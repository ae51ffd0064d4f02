"""Is it in specification, and what has changed: decision rules with their risk, and two calibrations of one DUT."""

from labcal.uncertainty.conformity.assessment import LEFT_OPEN, Assessment, assess, stated_lines, with_conformity
from labcal.uncertainty.conformity.change import Change, Changes, changes
from labcal.uncertainty.conformity.decision import (
    WORDS,
    Judged,
    judge,
    ratio_in_words,
    risk_in_words,
    risk_of_accepting,
)

__all__ = [
    "LEFT_OPEN",
    "WORDS",
    "Assessment",
    "Change",
    "Changes",
    "Judged",
    "assess",
    "changes",
    "judge",
    "ratio_in_words",
    "risk_in_words",
    "risk_of_accepting",
    "stated_lines",
    "with_conformity",
]
