"""How sure the moment of a step is: every moment that explains the run as well is as likely.

No curvature tells it: a magnitude does not see a step at right angles to the field, and between two rows nothing does.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.changepoints import explained_from_each_row
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.nuisance import ols_with_nuisance
from labcal.model.effects import Term

Array = NDArray[np.float64]
UNIFORM = 12.0  # the square of an interval over the variance of what lies anywhere in it


def u_of_moment(
    here: LinearProblem, terms: Sequence[Term], beta: Sequence[Array], place: int, used: NDArray[np.bool_]
) -> float:
    """The standard uncertainty [s] of the moment of the term at `place`, by the likelihood of every other moment.

    Map, phases and the other effects are fitted anew at each, the moment lies anywhere between its two rows, and all
    are as likely before. About the solution `here`, effects subtracted, on the rows `used`.
    """
    chosen = terms[place]
    moment = chosen.found_by("changepoints")
    assert moment is not None
    t, E = here.scene.t_s[used], here.all_columns(chosen.stepped())[used]
    A = np.concatenate([here.T, *(here.all_columns(o) for i, o in enumerate(terms) if i != place)], axis=2)[used]
    y = (here.y + here.all_columns(chosen) @ beta[place])[used]
    left = y - A @ ols_with_nuisance(A, y, here.T.shape[2])
    drop = explained_from_each_row(E, A, left)[1:]
    gap, middle = np.diff(t), (t[1:] + t[:-1]) / 2
    off = middle - middle[min(max(int(np.searchsorted(t, moment.value)), 1), len(t) - 1) - 1]
    likely = gap * np.exp((drop - drop.max()) / (2 * max(float(np.mean(here.y[used] ** 2)), 1e-300)))
    return float(np.sqrt(np.sum(likely * (off**2 + gap**2 / UNIFORM)) / np.sum(likely)))
