"""The coverage factor of a calibration's parameters, K, k and its effects', which have no budgets of their own."""

from __future__ import annotations

from labcal.model import Calibration
from labcal.uncertainty import Sources
from labcal.uncertainty.budget import coverage_factor
from labcal.uncertainty.of_calibration import FIGURES

COVERAGE = 2.0  # of about 95 % where degrees of freedom are many
MANY_K = 2.05  # of 51 degrees of freedom, where k = 2 holds 94.9 %


def k_of_parameters(c: Calibration) -> float:
    """The largest k of the sensor's figures, which are made of the same parameters; 2 where it is hardly larger."""
    largest = max([float(b["k"]) for b in c.budget if b["quantity"] in FIGURES], default=COVERAGE)
    return largest if largest >= MANY_K else COVERAGE


def k_of_sources(sources: Sources | None) -> float:
    """The same of what makes parameters uncertain: the k of the one with the fewest degrees of freedom."""
    k = COVERAGE if sources is None else coverage_factor(sources.fewest_dof())
    return k if k >= MANY_K else COVERAGE


def k_in_words(k: float) -> str:
    """As "2", or with two decimals."""
    return f"{k:.0f}" if k == COVERAGE else f"{k:.2f}"
