"""How far off the map is if a rival did it: an effect of the rig stays in the lab, and the map beside it flies.

Where two effects of the rig explain a run alike, each leaves another map, and nothing in the run says which is right.
Models that are as likely as each other count alike: the variance of an estimate is the mean of what it is in each, and
that between them (Hoeting, Madigan, Raftery and Volinsky, Bayesian model averaging, 1999, eq. 3), here about the map
that is shipped.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.beside_the_map import beside_the_map
from labcal.loop.candidates.library import Candidate
from labcal.loop.selection.equivalents import in_place_of
from labcal.loop.selection.joint_fit import JointFit, derivatives, joint_fit
from labcal.loop.selection.proof import Evidence
from labcal.uncertainty import Contribution

Array = NDArray[np.float64]
SENSOR = "sensor"


def beside_rivals(found: Evidence, shipped: JointFit, unsupported: Collection[int]) -> list[Contribution]:
    """Of each rival of an effect of the rig, itself of the rig, over the parameters of the fit that is `shipped`.

    u is the rms of what it changes of the field [nT], over the root of how many models are as likely.
    """
    stays = [place for place in range(len(found.accepted)) if place not in unsupported]
    accepted, out = [found.accepted[place] for place in stays], list[Contribution]()
    for chosen, models in zip(accepted, (found.equivalents[place] for place in stays), strict=True):
        others = [one.scored.candidate for one in models[1:]] if chosen.belongs_to != SENSOR else []
        rivals = [rival for rival in others if rival.belongs_to != SENSOR]
        for rival in rivals:
            fitted = _with(found, shipped, in_place_of(accepted, chosen, rival))
            source = f"{rival.label} in place of {chosen.label}: another map"
            out += _of_one(shipped, fitted, source, 1 + len(rivals))
    return out


def _with(found: Evidence, shipped: JointFit, accepted: Sequence[Candidate]) -> JointFit:
    return joint_fit(found.pool.whole, [part.term for one in accepted for part in one.parts], shipped.used)


def _of_one(shipped: JointFit, fitted: JointFit, source: str, models: int) -> Iterator[Contribution]:
    """How far its map is from the one that is shipped, and what of its own effects that may hold."""
    basis = shipped.problem.parameterisation.basis
    steps = [(source, np.linalg.lstsq(basis, fitted.problem.theta - shipped.problem.theta, rcond=None)[0], np.inf)]
    for one in beside_the_map(fitted, derivatives(fitted)[0]):
        steps.append((one.source, one.shift[: basis.shape[1]], one.dof))
    for name, step, dof in steps:
        shift = np.zeros(len(shipped.covariance))
        shift[: basis.shape[1]] = step / np.sqrt(models)
        u = _rms_nT(shipped, basis @ step) / np.sqrt(models)
        if u > 0:
            yield Contribution(name, "B", "discrete" if name == source else "normal", u, "nT", dof, shift)


def _rms_nT(shipped: JointFit, step: Array) -> float:
    """The rms of what a step (12,) of the map's parameters changes of the field on the rows of the fit."""
    K, k = step[:9].reshape(3, 3), step[9:]
    changed = shipped.problem.observations.reading[shipped.used] @ K.T - k
    return float(np.sqrt(np.mean(np.sum(changed**2, axis=1))))
