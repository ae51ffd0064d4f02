"""Everything at once: map, phases and all effects, by Gauss-Newton on the full residual."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import Problem, linearise
from labcal.loop.noise.bands import transformed
from labcal.loop.noise.coloured import spectrum_of, weighted_gram
from labcal.loop.noise.nuisance import SEEN, _inverse, minimise
from labcal.model import Parameter
from labcal.model.effects import Form, Scene, families
from labcal.model.effects.protocol import Shape

Array = NDArray[np.float64]
STEPS = 8
HALVINGS = 6
ROUNDS = 30  # of an effect of the field, which acts on what it adds to the field itself
SAME_nT = 0.1
NEAR_nT = 5.0  # over which the slope of an effect in the field is taken
Point = tuple[Problem, tuple[Form, ...], tuple[Array, ...]]


@dataclass(frozen=True, slots=True, eq=False)
class Refit:
    """The joint solution."""

    problem: Problem  # about the solution, effects subtracted
    forms: tuple[Form, ...]
    beta: tuple[Array, ...]  # of each form
    covariance: (
        Array  # of the base's coordinates, the phases, the betas and the searched shapes, correlated noise included
    )

    def effects(self, scene: Scene) -> Array | float:
        """Σ e (n, 3) [nT]."""
        return total(self.forms, self.beta, scene)

    def uncorrected(self) -> Problem:
        """The problem about the same map and phases with the effects still in its residual.

        Where vectors show them the base's columns stay clear of them: readings that hold the effects, less a reference
        that does not, would give an effect of the rig all their shapes.
        """
        p = self.problem
        if p.kind == "vector":
            return linearise(p.run, p.seen, p.noise, p.base, p.allowed, p.theta, p.phase)
        effects = self.effects(p.scene)
        here = linearise(p.run, p.seen, p.noise, p.base, p.allowed, p.theta, p.phase, effects)
        y = sum((here.columns(form) @ b for form, b in zip(self.forms, self.beta, strict=True)), here.y)
        return replace(here, y=np.asarray(y), residual_nT=here.residual_nT + effects)

    def parameters(self) -> tuple[tuple[Parameter, ...], ...]:
        """The parameters of each effect with their standard uncertainties."""
        u = np.sqrt(np.maximum(np.diag(self.covariance), 0.0))[self.problem.T.shape[2] :]
        linear = sum(len(b) for b in self.beta)
        shapes = iter(u[linear:].tolist())
        out, at = [], 0
        for form, beta in zip(self.forms, self.beta, strict=True):
            found = [
                Parameter(name, float(value), float(spread), unit)
                for (name, unit), value, spread in zip(form.parameters, beta, u[at : at + len(beta)], strict=True)
            ]
            at += len(beta)
            found += [
                Parameter(s.name, s.value, self._uncertain(s, shapes) if s.grid else 0.0, s.unit) for s in form.shape
            ]
            out.append(tuple(found))
        return tuple(out)

    def _uncertain(self, shape: Shape, by_slope: Iterator[float]) -> float:
        """The standard uncertainty of a searched shape: a step may lie anywhere between two rows (uniform)."""
        u, t = next(by_slope), self.problem.scene.t_s
        if shape.name != "t_step_s":
            return u
        after = min(max(int(np.searchsorted(t, shape.value)), 1), len(t) - 1)
        return float((t[after] - t[after - 1]) / np.sqrt(12))


def total(forms: Sequence[Form], beta: Sequence[Array], scene: Scene) -> Array | float:
    """The sum of the effects (n, 3) [nT]; 0.0 where there is none."""
    return sum((form.columns(scene) @ b for form, b in zip(forms, beta, strict=True)), 0.0)


def refit(problem: Problem, forms: Sequence[Form], rows: NDArray[np.bool_] | None = None) -> Refit:
    """Fit all from the problem's own parameters, on `rows` where they are given."""
    used = np.ones(len(problem), dtype=bool) if rows is None else rows
    here, forms = problem, tuple(forms)
    beta = tuple(np.zeros(len(form.parameters)) for form in forms)
    for _ in range(STEPS):
        A = np.concatenate([here.T, *(-here.columns(form) for form in forms)], axis=2)[used]
        step = -minimise(A, here.y[used], here.T.shape[2], _seen(here, forms, beta, used))
        there = _downhill(here, forms, beta, step, used)
        if there is None:
            break
        here, forms, beta = there
        if _negligible(A, step):
            break
    return Refit(here, forms, beta, _covariance(here, forms, beta, used))


def _downhill(
    here: Problem, forms: tuple[Form, ...], beta: tuple[Array, ...], step: Array, used: NDArray[np.bool_]
) -> Point | None:
    """The point a step on, or a part of it that does not raise the sum of squares; None where none does."""
    limit = float(np.sum(here.y[used] ** 2)) * (1 + 1e-9)
    for _ in range(HALVINGS):
        bare, moved = _moved(here, forms, beta, step)
        settled = tuple(_settled(form, b) for form, b in zip(forms, moved, strict=True))
        there = _about(bare, settled, moved)
        if float(np.sum(there.y[used] ** 2)) <= limit:
            return there, settled, moved
        step = step / 2
    return None


def _seen(here: Problem, forms: Sequence[Form], beta: Sequence[Array], used: NDArray[np.bool_]) -> float:
    """The part of a column's square that has to be new to the base.

    The map is driven by readings, the rig's effects by the reference: a turn common to all mountings, which no run
    shows, seems to differ from a turn of the map by twice the angle between the two (two standard deviations).
    """
    if not any(family.kernel is form.kernel for family in families() if family.belongs_to == "rig" for form in forms):
        return SEEN
    apart = here.residual_nT + total(forms, beta, here.scene)
    return max(SEEN, float(4 * np.sum(apart[used] ** 2) / np.sum(here.scene.field_nT[used] ** 2)))


def _negligible(A: Array, step: Array) -> bool:
    return bool(np.sqrt(np.mean((A @ step) ** 2)) < 1e-4)


def _moved(
    here: Problem, forms: tuple[Form, ...], beta: tuple[Array, ...], step: Array
) -> tuple[Problem, tuple[Array, ...]]:
    q = here.allowed.basis.shape[1]
    theta = here.theta + here.allowed.basis @ step[:q]
    phase = here.phase.copy()
    phase[here.turning] += step[q : q + len(here.turning)]
    ends = np.cumsum([q + len(here.turning), *(len(b) for b in beta)])
    moved = tuple(b + step[start : start + len(b)] for b, start in zip(beta, ends, strict=False))
    bare = linearise(here.run, here.seen, here.noise, here.base, here.allowed, theta, phase)
    return bare, moved


def _about(bare: Problem, forms: tuple[Form, ...], beta: tuple[Array, ...]) -> Problem:
    if not forms:
        return bare
    effects = _acting(forms, beta, bare.scene)
    slope = _slope(forms, beta, _holding(effects, bare.scene))
    return linearise(bare.run, bare.seen, bare.noise, bare.base, bare.allowed, bare.theta, bare.phase, effects, slope)


def _acting(forms: Sequence[Form], beta: Sequence[Array], scene: Scene) -> Array | float:
    """Σ e (n, 3) [nT] on the field a that holds these effects themselves, for a scene whose quiet field lacks them.

    Parameters so large that no field holds its own effect are as far off as their first round says.
    """
    effects, change = total(forms, beta, scene), np.inf
    for _ in range(ROUNDS):
        held = total(forms, beta, _holding(effects, scene))
        last, change = change, float(np.max(np.abs(held - effects)))
        if not change < last:
            break
        effects = held
        if change < SAME_nT:
            break
    return effects


def _holding(effects: Array | float, scene: Scene) -> Scene:
    return replace(scene, quiet_nT=scene.smooth_nT + effects)


def _slope(forms: Sequence[Form], beta: Sequence[Array], scene: Scene) -> Array:
    """∂e/∂a (n, 3, 3), by small changes of the field along each axis: what the map adds to a moves e as well."""
    here = total(forms, beta, scene)
    moved = (total(forms, beta, scene.moved(step)) for step in NEAR_nT * np.eye(3))
    return np.stack([(there - here) / NEAR_nT for there in moved], axis=2)


def _settled(form: Form, beta: Array) -> Form:
    """A lag's secant is taken over the lag itself."""
    if any(s.name == "secant_s" for s in form.shape) and abs(float(beta[0])) > 1e-6:
        return form.reshaped(secant_s=float(beta[0]))
    return form


def _covariance(here: Problem, forms: tuple[Form, ...], beta: tuple[Array, ...], used: NDArray[np.bool_]) -> Array:
    """A⁻¹ (Σ S_k G_k) A⁻¹ for plain least squares under the noise spectrum S that the residual shows."""
    shapes = [_by_shape(form, b, here) for form, b in zip(forms, beta, strict=True)]
    columns = [here.columns(form) for form in forms]
    parts = np.concatenate([here.T, *columns, *(s for s in shapes if s.shape[2])], axis=2)[used]
    moved = transformed(parts)
    bands, spectrum = spectrum_of(moved, here.y[used])
    A = weighted_gram(moved, bands, np.ones_like(spectrum))
    inverse = _inverse(A, here.T.shape[2], _seen(here, forms, beta, used))
    return np.asarray(inverse @ weighted_gram(moved, bands, spectrum) @ inverse)


def _by_shape(form: Form, beta: Array, here: Problem) -> Array:
    """Derivatives by the searched shapes, whitened (n, q, shapes)."""
    out = [np.zeros((len(here), here.y.shape[1], 0))]
    for shape in form.shape:
        if shape.grid:
            step = _small(shape, here.scene.t_s)
            up, down = (form.reshaped(**{shape.name: shape.value + s}) for s in (step, -step))
            slope = (up.columns(here.scene) - down.columns(here.scene)) @ beta / (2 * step)
            out.append(here.whiten @ slope[:, :, None])
    return np.concatenate(out, axis=2)


def _small(shape: Shape, t_s: Array) -> float:
    """A step of the shape over which the effect is straight."""
    if shape.name == "f_Hz":
        return 1e-3 / float(np.ptp(t_s))
    return 0.05 * float(np.median(np.diff(t_s))) if shape.name == "delay_s" else 1e-3 * abs(shape.value)
