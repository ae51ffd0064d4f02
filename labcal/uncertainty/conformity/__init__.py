"""Is it in specification, and what has changed: decision rules with their risk, and two calibrations of one DUT."""

from labcal.uncertainty.conformity.assessment import Assessment, assess, stated_lines, with_conformity
from labcal.uncertainty.conformity.change import Change, Changes, changes
from labcal.uncertainty.conformity.decision import Judged, judge, risk_of_accepting

__all__ = [
    "Assessment",
    "Change",
    "Changes",
    "Judged",
    "assess",
    "changes",
    "judge",
    "risk_of_accepting",
    "stated_lines",
    "with_conformity",
]
