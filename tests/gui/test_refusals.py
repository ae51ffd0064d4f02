"""A method that gives no calibration says why, in words beside the table, a reason once."""

from labcal.gui.ipc.answers import FitFigures, Fitted
from labcal.gui.pages.fit import refusals


def test_a_reason_is_given_once_with_the_methods_that_it_is_of():
    def said(ok, why=None):
        return Fitted(FitFigures(ok, why))

    fits = {
        "ml": said(True),
        "ekf": said(False, "diverged"),
        "ukf": said(False, "diverged"),
        "centered": said(False, "flat"),
    }
    assert refusals(fits) == ["✕ ekf, ukf: diverged", "✕ centered: flat"]
