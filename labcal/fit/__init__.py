"""Estimators, one file each: pure functions, `Run` in, `Fit` out."""

from labcal.fit.draft import draft_calibration
from labcal.fit.registry import METHODS, fit, fit_all, methods
from labcal.fit.result import Fit

__all__ = ["METHODS", "Fit", "draft_calibration", "fit", "fit_all", "methods"]
