"""How far off the map is if a rival did it: an effect of the rig stays in the lab, and the map beside it flies.

Where an effect of the rig and another one explain a run alike, each leaves another map, and nothing in the run says
which is right. Models that are as likely as each other count alike: the variance of an estimate is the mean of what it
is in each, and that between them (Hoeting, Madigan, Raftery and Volinsky, Bayesian model averaging, 1999, eq. 3), here
about the map that is shipped. Where one of the two is an effect of the device it flies with the map, and makes two maps
of it: where it acts, as after a step, and where it does not. The device may be met in either.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.beside_the_map import beside_the_map
from labcal.loop.candidates.library import Candidate
from labcal.loop.data.credible import of_the_rig
from labcal.loop.selection.equivalents import in_place_of
from labcal.loop.selection.joint_fit import JointFit, derivatives, joint_fit, sum_of_effects
from labcal.loop.selection.proof import Evidence
from labcal.uncertainty import Contribution

Array = NDArray[np.float64]
SENSOR = "sensor"


def beside_rivals(found: Evidence, shipped: JointFit, unsupported: Collection[int]) -> list[Contribution]:
    """Of each rival of a chosen effect, where one of the two is of the rig, over the parameters of the fit `shipped`.

    u is the rms of what it changes of the field [nT], over the root of how many models are as likely.
    """
    stays = [place for place in range(len(found.accepted)) if place not in unsupported]
    accepted, out = [found.accepted[place] for place in stays], list[Contribution]()
    for chosen, models in zip(accepted, (found.equivalents[place] for place in stays), strict=True):
        others = [one.scored.candidate for one in models[1:]]
        rivals = [one for one in others if chosen.belongs_to != SENSOR or one.belongs_to != SENSOR]
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
    between = _between(shipped, fitted)
    steps = [(source, step, np.inf, models * len(between)) for step in between]
    for one in beside_the_map(fitted, derivatives(fitted)[0]):
        steps.append((one.source, one.shift[: basis.shape[1]], one.dof, models))
    for name, step, dof, count in steps:
        shift = np.zeros(len(shipped.covariance))
        shift[: basis.shape[1]] = step / np.sqrt(count)
        u = _rms_nT(shipped, basis @ step) / np.sqrt(count)
        if u > 0:
            yield Contribution(name, "B", "discrete" if name == source else "normal", u, "nT", dof, shift)


def _between(shipped: JointFit, fitted: JointFit) -> list[Array]:
    """From the map that is shipped to the other (p,), with what the device's effects differ by; two where they do."""
    problem, used = shipped.problem, shipped.used
    basis, step = problem.parameterisation.basis, fitted.problem.theta - problem.theta
    apart = (_of_the_device(fitted) - _of_the_device(shipped))[used]
    changed_nT = _changed_nT(shipped, step) - apart
    acts = np.sum(apart**2, axis=1) > np.mean(np.sum(apart**2, axis=1))
    per_step = np.stack([_changed_nT(shipped, one) for one in basis.T], axis=2)
    each = (acts, ~acts) if acts.any() else (~acts,)
    fits = [np.linalg.lstsq(per_step[rows].reshape(-1, basis.shape[1]), changed_nT[rows].ravel())[0] for rows in each]
    return [np.asarray(fit) for fit in fits]


def _of_the_device(found: JointFit) -> Array:
    """The sum of its effects (n, 3) [nT]."""
    own = [place for place, term in enumerate(found.terms) if not of_the_rig(term)]
    terms, beta = [found.terms[place] for place in own], [found.beta[place] for place in own]
    return np.zeros((len(found.problem), 3)) + sum_of_effects(terms, beta, found.problem.scene)


def _changed_nT(shipped: JointFit, step: Array) -> Array:
    """What a step (12,) of the map's parameters changes of the field (n, 3) on the rows of the fit."""
    K, k = step[:9].reshape(3, 3), step[9:]
    return np.asarray(shipped.problem.observations.reading[shipped.used] @ K.T - k)


def _rms_nT(shipped: JointFit, step: Array) -> float:
    return float(np.sqrt(np.mean(np.sum(_changed_nT(shipped, step) ** 2, axis=1))))
