"""What an effect remembers, as the kinds of its parameters tell; an effect that remembers otherwise says so itself."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.shape import DELAY, SECANT, TIME_CONSTANT
from labcal.model.effects.term import Term

LEAD = 1 / 8  # of a thermometer's time constant: the window either way that its slope is taken over


def time_constants(term: Term) -> list[float]:
    """Of each response to a channel [s]."""
    return [shape.value for shape in term.shape if shape.kind is TIME_CONSTANT and term.channels]


def reach_s(term: Term) -> float | None:
    """How far [s] from a row, either way, the rows lie that it looks at; None where it looks at its own row alone.

    What follows as a state reaches nowhere: 0.
    """
    near = [abs(shape.value) for shape in term.shape if shape.kind in (DELAY, SECANT)]
    following = [max(-tau_s, 0.0) * LEAD for tau_s in time_constants(term) if tau_s]
    return max([*near, *following], default=None)


def secant_s(term: Term, t_s: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far ahead [s] of each row at t_s (n,) its secant looks."""
    return np.full(len(t_s), next((shape.value for shape in term.shape if shape.kind is SECANT), 0.0))


def nowhere(term: Term) -> float | None:
    """Of an effect that is a state: it remembers, and looks at no other row."""
    return 0.0
