"""The joint fit of map, phases and all effects, by Gauss-Newton on the full residual."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.prior import as_data, precision
from labcal.loop.data.credible import follows_reference, left_by_the_best_map, min_new_share
from labcal.loop.data.linear_problem import LinearProblem, linearise
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.coloured import noise_spectrum, weighted_gram
from labcal.loop.noise.declared_directions import DeclaredDirections
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, ols_with_nuisance
from labcal.loop.selection.crossval import residual_lengths
from labcal.loop.selection.moment import u_of_moment
from labcal.loop.selection.settled import beside_settled, inverse_beside, settled_shape
from labcal.model import Parameter
from labcal.model.effects import Scene, Term, families

Array = NDArray[np.float64]
STEPS = 8
HALVINGS = 16  # of a step that does not lower the sum of squares
LEAST_FALL = 1e-9  # of the sum of squares: less is lost in rounding
ROUNDS = 30  # of fixed-point iteration: an effect of the field acts on the field that contains the effect
SETTLED_nT = 0.1  # change that ends it
SLOPE_STEP_nT = 5.0  # over which the slope of an effect in the field is taken
Point = tuple[LinearProblem, tuple[Term, ...], tuple[Array, ...]]


@dataclass(frozen=True, slots=True, eq=False)
class JointFit:
    """The joint solution."""

    problem: LinearProblem  # about the solution, effects subtracted
    terms: tuple[Term, ...]
    beta: tuple[Array, ...]  # of each term
    covariance: Array  # of the base's coordinates, phases, betas and searched parameters, coloured noise included
    used: NDArray[np.bool_]  # (n,) the rows of the fit

    @classmethod
    def at(cls, problem: LinearProblem, used: NDArray[np.bool_]) -> JointFit:
        """The base alone where `problem` is, however it was found."""
        return cls(problem, (), (), _covariance(problem, (), (), used), used)

    def effects(self, scene: Scene) -> Array | float:
        """Σ e (n, 3) [nT]."""
        return sum_of_effects(self.terms, self.beta, scene)

    def uncorrected(self) -> LinearProblem:
        """The problem about the same map and phases with the effects still in its residual.

        With vectors the base's columns do not contain them: readings with the effects, less a reference without, would
        let an effect of the rig imitate all of them.
        """
        p = self.problem
        if p.kind == "vector":
            return linearise(p.run, p.observations, p.noise, p.base, p.parameterisation, p.theta, p.phase)
        effects = self.effects(p.scene)
        here = linearise(p.run, p.observations, p.noise, p.base, p.parameterisation, p.theta, p.phase, effects)
        y = sum((here.all_columns(term) @ b for term, b in zip(self.terms, self.beta, strict=True)), here.y)
        return replace(here, y=np.asarray(y), residual_nT=here.residual_nT + effects)

    def parameters(self, covariance: Array | None = None) -> tuple[tuple[Parameter, ...], ...]:
        """The parameters of each effect with their standard uncertainties, by `covariance` or that of the noise.

        Without those that say how the run's segments began.
        """
        of = self.covariance if covariance is None else covariance
        u = np.sqrt(np.maximum(np.diag(of), 0.0))[self.problem.T.shape[2] :]
        linear = sum(len(b) for b in self.beta)
        by_slope, t_s = iter(u[linear:].tolist()), self.problem.scene.t_s
        out, at = [], 0
        for place, (term, beta) in enumerate(zip(self.terms, self.beta, strict=True)):
            found = [
                Parameter(name, float(value), float(spread), unit)
                for (name, unit), value, spread in zip(term.parameters, beta, u[at : at + len(beta)], strict=True)
            ][: term.lasting]
            at += len(beta)
            settled = settled_shape(term, beta, self.problem.scene)
            for s in term.shape:
                spread = s.u(t_s, next(by_slope)) if s.grid else 0.0
                if settled is not None and settled[0].name == s.name:
                    spread = settled[1]
                if s.kind.found_by == "changepoints":
                    spread = u_of_moment(self.problem, self.terms, self.beta, place, self.used)
                found.append(Parameter(s.name, s.value, spread, s.unit))
            out.append(tuple(found))
        return tuple(out)


def sum_of_effects(terms: Sequence[Term], beta: Sequence[Array], scene: Scene) -> Array | float:
    """The sum of the effects (n, 3) [nT]; 0.0 where there is none."""
    return sum((term.columns(scene) @ b for term, b in zip(terms, beta, strict=True)), 0.0)


def joint_fit(problem: LinearProblem, terms: Sequence[Term], rows: NDArray[np.bool_] | None = None) -> JointFit:
    """Fit all from the problem's own parameters, on `rows` where they are given."""
    used = np.ones(len(problem), dtype=bool) if rows is None else rows
    start = problem, tuple(terms), tuple(np.zeros(len(term.parameters)) for term in terms)
    found = _descended(start, used)
    if (settled := _settled(found, used)) is not found:
        found = _descended(settled, used)
    here, terms, beta = _summed_to_zero(*found, used)
    return JointFit(here, terms, beta, _covariance(here, terms, beta, used), used)


def _descended(start: Point, used: NDArray[np.bool_]) -> Point:
    """Where the steps of Gauss and Newton lead to."""
    here, terms, beta = start
    for _ in range(STEPS):
        A = np.concatenate([here.T, *(-here.all_columns(term) for term in terms)], axis=2)[used]
        step, loops = _step(here, terms, beta, used, A, beta), beta
        if any(term.of_beginnings and not own.any() for term, own in zip(terms, beta, strict=True)):
            loops = _added(here, beta, step)  # how large a loop is, is known from here on, and with it how it may begin
            step = _step(here, terms, beta, used, A, loops)
        there = _line_search(here, terms, beta, step, used, loops, A @ step)
        if there is None:
            break
        here, terms, beta = there
    return here, terms, beta


def _step(
    here: LinearProblem,
    terms: tuple[Term, ...],
    beta: tuple[Array, ...],
    used: NDArray[np.bool_],
    A: Array,
    loops: tuple[Array, ...],
) -> Array:
    """The step (p,) of Gauss and Newton, what is known of the parameters included, where the `loops` are so large."""
    known, off = as_data(terms, beta, here.T.shape[2], A.shape[1], loops)
    X, y, M = np.concatenate([A, known]), np.concatenate([here.y[used], off]), beside_settled(here, terms, beta, used)
    step = -ols_with_nuisance(X if M is None else X @ M, y, here.T.shape[2], new_share_needed(here, terms, beta, used))
    return np.asarray(step if M is None else M @ step)


def _summed_to_zero(
    here: LinearProblem, terms: tuple[Term, ...], beta: tuple[Array, ...], used: NDArray[np.bool_]
) -> Point:
    """The same residual with sums at zero that are so by what the effect is, where the map takes what they are not."""
    base, start, step = here.T.shape[2], here.T.shape[2], np.zeros(here.T.shape[2] + sum(map(len, beta)))
    least = new_share_needed(here, terms, beta, used)
    for term, own in zip(terms, beta, strict=True):
        names = [name for name, _ in term.parameters]
        summed = next((f.sums_to_zero(term) for f in families() if f.kernel is term.kernel), ())
        places = [names.index(name) for name in summed]
        if places:
            column = -here.all_columns(term)[used][:, :, places].sum(axis=2).ravel()
            T = here.T[used].reshape(-1, base)
            carried = np.linalg.lstsq(T, column, rcond=None)[0]
            mean = float(np.mean(own[places]))
            if np.sum((column - T @ carried) ** 2) <= least * np.sum(column**2):
                step[:base] += carried * mean
                step[[start + place for place in places]] -= mean
        start += len(own)
    if not step.any():
        return here, terms, beta
    bare, stepped = _stepped(here, terms, beta, step)
    return _relinearised(bare, terms, stepped), terms, stepped


def _settled(found: Point, used: NDArray[np.bool_]) -> Point:
    """Nearly the same residual with what no run tells where the other parameters say; the map takes what that changes.

    The same point where there is no such parameter.
    """
    here, terms, beta = found
    base, step, out = here.T.shape[2], np.zeros(here.T.shape[2] + sum(map(len, beta))), list[Term]()
    T, least = here.T[used].reshape(-1, base), new_share_needed(here, terms, beta, used)
    for term, own in zip(terms, beta, strict=True):
        settled = settled_shape(term, own, here.scene)
        there = term if settled is None else term.with_shape(settled[0])
        if there is not term:
            column = ((here.all_columns(there) - here.all_columns(term)) @ own)[used].ravel()
            carried = np.linalg.lstsq(T, column, rcond=None)[0]
            taken = np.sum((column - T @ carried) ** 2) <= least * np.sum(column**2)
            step[:base] += carried if taken else 0.0
            there = there if taken else term
        out.append(there)
    if not step.any():
        return found
    bare, stepped = _stepped(here, terms, beta, step)
    return _relinearised(bare, tuple(out), stepped), tuple(out), stepped


def in_sample_rms(fitted: JointFit) -> float:
    """What a fit leaves on its own rows [nT], beside the likeliest errors of those that the run declares."""
    problem = fitted.problem
    lengths = problem.length_nT(problem.residual_nT)[fitted.used]
    if problem.declared.shape[2]:
        lengths = residual_lengths(problem, beside_declared(fitted).y[fitted.used], fitted.used)
    return float(np.sqrt(np.mean(lengths**2)))


def declared_beside(fitted: JointFit) -> Array:
    """What one standard deviation of each declared error leaves (n, q, r) beside a fit, of every row."""
    return beside_fit(fitted, fitted.problem.declared)


def beside_fit(fitted: JointFit, columns: Array) -> Array:
    """Columns (n, q, r) less what a fit of all parameters to them takes, on the rows of the fit."""
    A, inverse = derivatives(fitted)
    left = columns.copy()
    shared = inverse @ np.einsum("nqp,nqr->pr", A, columns[fitted.used])
    left[fitted.used] -= np.einsum("nqp,pr->nqr", A, shared)
    return left


def beside_declared(fitted: JointFit) -> LinearProblem:
    """The problem with what declared errors are likeliest to have left taken off the whitened residual of its rows."""
    problem, used = fitted.problem, fitted.used
    if not problem.declared.shape[2]:
        return problem
    left, y = declared_beside(fitted)[used], problem.y.copy()
    y[used] -= left @ DeclaredDirections.of(left).likeliest(y[used])
    return replace(problem, y=y)


def information(fitted: JointFit) -> float:
    """Schwarz' criterion of a joint fit whose noise level is open [nats]."""
    y = fitted.problem.y[fitted.used]
    return float(y.size * np.log(np.mean(y**2)) + sum(map(len, fitted.beta)) * np.log(y.size)) / 2


def _line_search(
    here: LinearProblem,
    terms: tuple[Term, ...],
    beta: tuple[Array, ...],
    step: Array,
    used: NDArray[np.bool_],
    loops: tuple[Array, ...],
    moved: Array,
) -> Point | None:
    """The point a step on, or a part of it that lowers the sum of squares; None where none does.

    The step takes off what it has `moved`: where that is lost in rounding, nothing falls.
    """
    now = _misfit(here, terms, beta, used, loops)
    for _ in range(HALVINGS):
        if not np.sum(moved**2) > LEAST_FALL * now:
            break
        bare, stepped = _stepped(here, terms, beta, step)
        on_secants = tuple(term.over_own_secants(b) for term, b in zip(terms, stepped, strict=True))
        there = _relinearised(bare, on_secants, stepped)
        if _misfit(there, on_secants, stepped, used, loops) < (1 - LEAST_FALL) * now:
            return there, on_secants, stepped
        step, moved = step / 2, moved / 2
    return None


def _misfit(
    here: LinearProblem,
    terms: Sequence[Term],
    beta: Sequence[Array],
    used: NDArray[np.bool_],
    loops: Sequence[Array],
) -> float:
    """The sum of squares on the rows used, and of what parameters are off the prior that goes with these `loops`."""
    _, off = as_data(terms, beta, 0, here.y.shape[1], loops)
    return float(np.sum(here.y[used] ** 2) + np.sum(off**2))


def new_share_needed(
    here: LinearProblem, terms: Sequence[Term], beta: Sequence[Array], used: NDArray[np.bool_]
) -> float:
    """The share of a column's square that has to be new to the base."""
    if not any(map(follows_reference, terms)):
        return MIN_NEW_SHARE
    apart = here.residual_nT + sum_of_effects(terms, beta, here.scene)
    left = left_by_the_best_map(here.T[used], here.whiten[used], apart[used])
    return min_new_share(left, here.scene.field_nT[used])


def _stepped(
    here: LinearProblem, terms: tuple[Term, ...], beta: tuple[Array, ...], step: Array
) -> tuple[LinearProblem, tuple[Array, ...]]:
    q = here.parameterisation.basis.shape[1]
    theta = here.theta + here.parameterisation.basis @ step[:q]
    phase = here.phase.copy()
    phase[here.phase_groups] += step[q : q + len(here.phase_groups)]
    stepped = _added(here, beta, step)
    bare = linearise(here.run, here.observations, here.noise, here.base, here.parameterisation, theta, phase)
    return bare, stepped


def _added(here: LinearProblem, beta: tuple[Array, ...], step: Array) -> tuple[Array, ...]:
    """The parameters of the effects a step on."""
    ends = np.cumsum([here.T.shape[2], *(len(b) for b in beta)])
    return tuple(b + step[start : start + len(b)] for b, start in zip(beta, ends, strict=False))


def _relinearised(bare: LinearProblem, terms: tuple[Term, ...], beta: tuple[Array, ...]) -> LinearProblem:
    if not terms:
        return bare
    effects = _self_consistent(terms, beta, bare.scene)
    slope = _field_slope(terms, beta, _with_effects(effects, bare.scene))
    return linearise(
        bare.run,
        bare.observations,
        bare.noise,
        bare.base,
        bare.parameterisation,
        bare.theta,
        bare.phase,
        effects,
        slope,
    )


def _self_consistent(terms: Sequence[Term], beta: Sequence[Array], scene: Scene) -> Array | float:
    """Σ e (n, 3) [nT] on the field a that holds these effects themselves, for a scene whose denoised field lacks them.

    Parameters so large that no field holds its own effect are as far off as their first round says.
    """
    effects, change = sum_of_effects(terms, beta, scene), np.inf
    for _ in range(ROUNDS):
        held = sum_of_effects(terms, beta, _with_effects(effects, scene))
        last, change = change, float(np.max(np.abs(held - effects)))
        if not change < last:
            break
        effects = held
        if change < SETTLED_nT:
            break
    return effects


def _with_effects(effects: Array | float, scene: Scene) -> Scene:
    if scene.denoised_field_nT is None:  # readings as they are hold their effects
        return scene
    return replace(scene, denoised_field_nT=scene.denoised_field_nT + effects)


def _field_slope(terms: Sequence[Term], beta: Sequence[Array], scene: Scene) -> Array:
    """∂e/∂a (n, 3, 3), by small changes of the field along each axis: what the map adds to a moves e as well."""
    here = sum_of_effects(terms, beta, scene)
    moved = (sum_of_effects(terms, beta, scene.moved(step)) for step in SLOPE_STEP_nT * np.eye(3))
    return np.stack([(there - here) / SLOPE_STEP_nT for there in moved], axis=2)


def _covariance(
    here: LinearProblem, terms: tuple[Term, ...], beta: tuple[Array, ...], used: NDArray[np.bool_]
) -> Array:
    """A⁻¹ (Σ S_k G_k) A⁻¹ for plain least squares under the noise spectrum S that the residual shows."""
    transformed = cosine_transform(_derivatives(here, terms, beta, used))
    bands, spectrum = noise_spectrum(transformed, here.y[used])
    A = weighted_gram(transformed, bands, np.ones_like(spectrum))
    known = precision(terms, beta, here.T.shape[2], len(A))
    inverse = _inverse(here, terms, beta, used, A + known)
    return np.asarray(inverse @ (weighted_gram(transformed, bands, spectrum) + known) @ inverse)


def derivatives(found: JointFit) -> tuple[Array, Array]:
    """The whitened residual's derivatives (n, q, p) by all parameters, and the inverse (p, p) of their Gram matrix.

    With the precision that parameters with a prior have before the data.
    """
    here, terms, beta, used = found.problem, found.terms, found.beta, found.used
    A = _derivatives(here, terms, beta, used)
    flat = A.reshape(-1, A.shape[2])
    known = precision(terms, beta, here.T.shape[2], flat.shape[1])
    return A, _inverse(here, terms, beta, used, flat.T @ flat + known)


def _inverse(
    here: LinearProblem, terms: Sequence[Term], beta: Sequence[Array], used: NDArray[np.bool_], gram: Array
) -> Array:
    """The generalised inverse (p, p) of a Gram matrix of derivatives by all parameters."""
    M, least = beside_settled(here, terms, beta, used), new_share_needed(here, terms, beta, used)
    return inverse_beside(gram, M, here.T.shape[2], least)


def _derivatives(here: LinearProblem, terms: Sequence[Term], beta: Sequence[Array], used: NDArray[np.bool_]) -> Array:
    """The whitened residual's derivatives (n, q, p) on the rows used: base, phases, betas, searched parameters."""
    shapes = [_nonlinear_slopes(term, b, here) for term, b in zip(terms, beta, strict=True)]
    columns = [-here.all_columns(term) for term in terms]
    return np.concatenate([here.T, *columns, *(-s for s in shapes if s.shape[2])], axis=2)[used]


def _nonlinear_slopes(term: Term, beta: Array, here: LinearProblem) -> Array:
    """Derivatives by the searched shapes, whitened (n, q, shapes)."""
    out = [np.zeros((len(here), here.y.shape[1], 0))]
    for shape in term.shape:
        if shape.grid:
            step = shape.step(here.scene.t_s)
            up, down = (term.with_shape(replace(shape, value=shape.value + s)) for s in (step, -step))
            slope = (up.columns(here.scene) - down.columns(here.scene)) @ beta / (2 * step)
            out.append(here.whiten @ slope[:, :, None])
    return np.concatenate(out, axis=2)
