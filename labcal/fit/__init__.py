"""Estimators, one file each: pure functions, `Run` in, `Fit` out."""

from labcal.fit.result import Fit

__all__ = ["Fit"]
