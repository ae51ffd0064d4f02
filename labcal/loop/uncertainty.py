"""The uncertainty of what the loop states: the noise that the residual shows, and all errors that the run declares."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR, observe
from labcal.fit.vector.system import evaluate
from labcal.loop.beside_the_map import beside_the_map
from labcal.loop.candidates.prior import precision
from labcal.loop.closures import after_effects
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.bounded import weighted_spectra
from labcal.loop.noise.coloured import grams_of_bands
from labcal.loop.noise.nuisance import RANK_TOLERANCE
from labcal.loop.selection.joint_fit import JointFit, derivatives
from labcal.model.affine import MAP_PARAMETERS
from labcal.record import Run
from labcal.uncertainty import Contribution, DeclaredError, FitNoise, Sources, declared_errors
from labcal.uncertainty.beside_declared import beside_declared, share

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class OfTheFile:
    """What makes uncertain what a calibration file ships, and the names of its parameters in their order."""

    sources: Sources  # over K row by row [nT per DUT unit], k [nT], then effects' parameters
    names: tuple[str, ...]

    @property
    def covariance(self) -> Array:
        """The joint covariance (p, p)."""
        C = self.sources.covariance
        return np.asarray((C + C.T) / 2)


def of_the_file(found: JointFit, uncertain: Sources, of_the_sensor: Sequence[bool]) -> OfTheFile:
    """Of the map and of the terms that are the sensor's; of a moment its own uncertainty, as it is no slope."""
    p = found.problem
    q, start, shape = p.parameterisation.basis.shape[1], p.T.shape[2], p.T.shape[2] + sum(map(len, found.beta))
    stated = found.parameters(uncertain.covariance)
    names, places, moments, number = list(MAP_PARAMETERS), list[int](), dict[int, float](), 0
    for term, parameters, sensor in zip(found.terms, stated, of_the_sensor, strict=True):
        u = {one.name: one.u for one in parameters}
        linear = [(name, start + i) for i, (name, _) in enumerate(term.parameters[: term.lasting])]
        searched = [(s.name, shape + i) for i, s in enumerate(s for s in term.shape if s.grid)]
        start, shape = start + len(term.parameters), shape + len(searched)
        if not sensor:
            continue
        for name, place in (*linear, *searched):
            if (moment := term.found_by("changepoints")) is not None and moment.name == name:
                moments[len(names)] = u[name]
            names.append(f"{number}:{name}")
            places.append(place)
        number += 1
    B = np.zeros((len(names), uncertain.noise.each.shape[1]))
    of_map = len(MAP_PARAMETERS)
    B[:of_map, :q] = p.parameterisation.basis * np.r_[np.full(3 * 3, 1 / p.observations.scale), np.ones(3)][:, None]
    B[np.arange(of_map, len(names)), places] = 1.0
    B[list(moments)] = 0.0
    noise = uncertain.noise.onto(B)
    noise.each[:, list(moments), list(moments)] = np.square(list(moments.values()))
    declared = tuple(replace(one, shift=B @ one.shift) for one in uncertain.declared)
    return OfTheFile(Sources(noise, declared, uncertain.beside_declared), tuple(names))


def uncertainty_of(found: JointFit) -> Sources:
    """What makes a joint fit uncertain: coloured noise, the shift of the same least squares by each declared error, and
    what the map may hold of the rig's effects.

    Of its parameters in their order: base's coordinates, phases, betas, searched parameters.
    """
    A, inverse = derivatives(found)
    of_the_fit = _of_the_fit(found, A, inverse)
    return replace(of_the_fit, declared=(*of_the_fit.declared, *beside_the_map(found, A)))


def _of_the_fit(found: JointFit, A: Array, inverse: Array) -> Sources:
    """Of noise and declared errors alone."""
    errors = declared_errors(after_effects(found))
    D = np.stack([np.zeros_like(A[:, :, 0]), *(_changed(found, error) for error in errors)], axis=2)[:, :, 1:]
    shifts = -inverse @ np.einsum("nqp,nqd->pd", A, D)
    contributions = [
        Contribution(error.source, "B", "normal", error.u, error.unit, np.inf, shift)
        for error, shift in zip(errors, shifts.T, strict=True)
    ]
    y = found.problem.y[found.used]
    part = share(y, beside_declared(y, _left_by(A, inverse, D)))
    return Sources(_of_noise(found, A, inverse, D), tuple(contributions), part)


def wald_p_values(found: JointFit) -> list[float]:
    """How often an effect that is not there would seem as large, of each term: all its parameters together (Wald)."""
    from scipy.special import chdtrc

    C, start, out = _of_the_fit(found, *derivatives(found)).covariance, found.problem.T.shape[2], list[float]()
    for term, beta in zip(found.terms, found.beta, strict=True):
        part = C[start : start + term.lasting, start : start + term.lasting]
        u = np.sqrt(np.maximum(np.diag(part), 1e-300))
        values, vectors = np.linalg.eigh(part / np.outer(u, u))
        known = values > RANK_TOLERANCE * values[-1]
        along = vectors[:, known].T @ (beta[: term.lasting] / u)
        out.append(float(chdtrc(max(known.sum(), 1), np.sum(along**2 / values[known]))))
        start += len(beta)
    return out


def _changed(found: JointFit, error: DeclaredError) -> Array:
    """What one standard deviation of an error changes of the whitened residual (n, q) on the rows of the fit."""
    p = found.problem
    effects, as_scalar = found.effects(p.scene), bool((p.observations.kind == SCALAR).all())

    def residual(run: Run) -> Array:
        return evaluate(observe(run, as_scalar=as_scalar), p.noise, p.theta, p.phase, effects).residual

    return np.asarray(np.einsum("nqj,nj->nq", p.whiten, error.moves(p.run, residual))[found.used])


def _of_noise(found: JointFit, A: Array, inverse: Array, D: Array) -> FitNoise:
    """A^+ S A^+ᵀ with each bounded spectrum S of the residual, and what priors leave open.

    What declared errors D left in the residual is no noise. Of A only what was fitted takes any: two columns may differ
    by the residual itself, as one of the readings and one of the prediction do.
    """
    transformed = cosine_transform(np.concatenate([A @ inverse, _shown(A, inverse, D)], axis=2))
    spectra = weighted_spectra(transformed, cosine_transform(found.problem.y[found.used]))
    grams = grams_of_bands(transformed[:, :, : len(inverse)], spectra.bands)
    before = inverse @ precision(found.terms, found.beta, found.problem.T.shape[2], len(inverse)) @ inverse
    return FitNoise.of(spectra.weight, np.tensordot(spectra.spectra, grams, axes=1) + before, spectra.dof)


def _shown(A: Array, inverse: Array, D: Array) -> Array:
    """The declared errors (n, q, d) that one standard deviation of them would show beside A in noise of variance one.

    Of another it is not known that it left anything: beside a scale of the reference there remains the scale times the
    residual itself, and as a column of free size that would take up all of the noise.
    """
    return np.asarray(D[:, :, np.sum(_left_by(A, inverse, D) ** 2, axis=(0, 1)) > 1.0])


def _left_by(A: Array, inverse: Array, D: Array) -> Array:
    """What one standard deviation of each declared error leaves in the residual (n, q, d), A fitted beside it."""
    return np.asarray(D - np.einsum("nqp,pd->nqd", A, inverse @ np.einsum("nqp,nqd->pd", A, D)))
