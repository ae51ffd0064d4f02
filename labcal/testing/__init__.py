"""What others hold their own parts to: a driver with its emulator, a procedure, an effect, an estimator.

Each `check_…` is a plain function that raises AssertionError with a sentence that says what to do.
"""

from labcal.testing.drivers import check_driver
from labcal.testing.effects import check_effect
from labcal.testing.estimators import check_estimator
from labcal.testing.procedures import check_procedure

__all__ = ["check_driver", "check_effect", "check_estimator", "check_procedure"]
