"""The residual about the fitted base model, as one whitened linear problem.

Near the base fit, with r = a − Σ e − p and W'W the inverse noise covariance, W r = y + T δ − X β: T are the directions
that the base can still move in (map and phases), X the columns of effects. Everything else in this room is about y, T
and X, each (n, q, …): n rows in time, q = 3 numbers a row for vectors, 2 with an axis, 1 for a magnitude.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import AXIS, VECTOR, Observations
from labcal.fit.vector.solve import Parameterisation
from labcal.fit.vector.system import Noise, evaluate, map_of
from labcal.geometry import rotation, shortest_rotation
from labcal.loop.data.credible import credible, follows_reference, left_by_the_best_map, min_new_share
from labcal.loop.data.declared_moves import moves, residual_of
from labcal.loop.data.outliers import hampel_outliers
from labcal.loop.noise.declared_directions import principal
from labcal.loop.noise.nuisance import beside, orthonormal
from labcal.model import AffineMap
from labcal.model.effects import Scene, Term
from labcal.model.effects.scene import Rig
from labcal.model.gaps import bridged
from labcal.record import Run
from labcal.record.observation import stands_turned

Array = NDArray[np.float64]
Base = Literal["affine", "gain-offset", "offset"]


@dataclass(frozen=True, slots=True, eq=False)
class Bins:
    """Consecutive rows taken together."""

    start: NDArray[np.intp]  # (bins,) the first row of each
    count: NDArray[np.intp]  # (bins,) rows in each

    def averaged(self, values: Array) -> Array:
        """Mean (bins, ...) of values (N, ...), times the root of the number of rows: white noise keeps its variance."""
        size = np.sqrt(self.count).reshape(-1, *[1] * (values.ndim - 1))
        return np.asarray(np.add.reduceat(values, self.start, axis=0) / size)

    def any(self, rows: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """The bins (bins,) that hold any of these rows (N,)."""
        return np.asarray(np.logical_or.reduceat(rows, self.start))

    def spread(self, values: NDArray[Any]) -> NDArray[Any]:
        """The value (N,) of each row's bin."""
        return np.repeat(values, self.count)


@dataclass(frozen=True, eq=False)
class LinearProblem:
    """A run's residual about one set of parameters, ready for linear algebra."""

    run: Run  # the usable rows only
    observations: Observations
    noise: Noise
    base: Base
    parameterisation: Parameterisation
    theta: Array  # (12,) scaled map
    phase: Array  # (groups,) rad
    scene: Scene
    whiten: Array  # (n, q, 3) W: y = W r
    residual_nT: Array  # (n, 3) r, effects subtracted
    y: Array  # (n, q)
    T: Array  # (n, q, t) of the base's coordinates, then of the phases
    phase_groups: NDArray[np.intp]  # phase groups that have rows, in the order of T's last columns
    bins: Bins | None = None  # where the rows of scene, whiten, y and T are bins of
    whole: LinearProblem | None = None  # this one's rows

    def __len__(self) -> int:
        return len(self.y)

    @property
    def kind(self) -> Literal["vector", "scalar"]:
        """`vector` where every row used offers a vector."""
        return "vector" if bool((self.observations.kind == VECTOR).all()) else "scalar"

    @property
    def affine(self) -> AffineMap:
        """The map in nT per DUT unit."""
        K, k = map_of(self.theta, self.observations.scale)
        return AffineMap(K, k)

    @cached_property
    def declared(self) -> Array:
        """What errors leave that the run declares (n, q, r), whitened: one standard deviation of r independent ones.

        Beside the base, and of those directions alone that show beside the noise.
        """
        if self.bins is not None and self.whole is not None:
            return self.bins.averaged(self.whole.declared)
        _, changes = moves(self.run, residual_of(self.observations, self.noise, self.theta, self.phase))
        return principal(beside(self.base_directions, self.whiten @ changes))

    def columns(self, candidate: Term) -> Array:
        """An effect's whitened columns (n, q, p), of the rig's in directions that are credible."""
        made, share = self.all_columns(candidate), self.credible_share(candidate)
        return made if share is None else credible(made, self.base_directions, share)

    @cached_property
    def base_directions(self) -> Array:
        """Orthonormal columns (n, q, b) that span T."""
        return orthonormal(self.T)

    def credible_share(self, candidate: Term) -> float | None:
        """The share of a direction's square that has to be new to the base; None where all directions count."""
        if self.scene.rig is None or not follows_reference(candidate):
            return None
        whole = self.whole or self
        return min_new_share(whole.steady_residual_nT, whole.scene.field_nT)

    @cached_property
    def steady_residual_nT(self) -> Array:
        """What the best map leaves (n, 3), zero in rows far from their neighbours: which are wild is not known yet."""
        steady = ~hampel_outliers(self.y, self.scene.segment)[:, None]
        return left_by_the_best_map(self.T * steady[:, :, None], self.whiten, self.residual_nT * steady)

    def all_columns(self, candidate: Term) -> Array:
        """An effect's whitened columns (n, q, p) in every direction."""
        return self.whitened(candidate.columns((self.whole or self).scene))

    def whitened(self, columns: Array) -> Array:
        """Columns (N, 3, p) on every row as y is: whitened, and taken together as the rows of bins are (n, q, p)."""
        if self.bins is None or self.whole is None:
            return np.asarray(self.whiten @ columns)
        flat = self._whitened_means @ columns.reshape(-1, columns.shape[2])
        return np.asarray(flat.reshape(*self.y.shape, -1))

    @cached_property
    def _whitened_means(self) -> Any:
        """The sparse matrix (n q, 3 N) that whitens every row and averages those of each bin."""
        from scipy.sparse import coo_array

        assert self.bins is not None
        assert self.whole is not None
        bin_of = self.bins.spread(np.arange(len(self)))
        W = self.whole.whiten / np.sqrt(self.bins.count)[bin_of][:, None, None]
        row, j, of_axis = np.nonzero(W)
        at = bin_of[row] * W.shape[1] + j, row * W.shape[2] + of_axis
        return coo_array((W[row, j, of_axis], at), shape=(self.y.size, W.shape[2] * len(W))).tocsr()

    def length_nT(self, residual_nT: Array) -> Array:
        """What the reported rms is over (n,): the residual vector's length, or the magnitude residual."""
        if self.kind == "vector":
            return np.asarray(np.linalg.norm(residual_nT, axis=1))
        b = self.scene.field_nT
        return np.asarray(np.abs(np.sum(residual_nT * b, axis=1)) / np.maximum(np.linalg.norm(b, axis=1), 1e-9))


def linearise(
    run: Run,
    seen: Observations,
    noise: Noise,
    base: Base,
    parameterisation: Parameterisation,
    theta: Array,
    phase: Array,
    effects_nT: Array | float = 0.0,
    slope: Array | None = None,
) -> LinearProblem:
    """The problem about `theta`, `phase` and the effects' sum e (n, 3).

    `slope` ∂e/∂a (n, 3, 3) is needed where e depends on the field: its curves act on a at the estimated true readings,
    where the map's columns are taken too. What a vector says of them does not hang on whether the device's noise is
    declared; beside a magnitude or an axis nobody knows them then, and the readings stand as they are in both.
    """
    at = evaluate(seen, noise, theta, phase, effects_nT)
    whiten = _whitener(seen, at.information, at.field)
    known = bool(run.dut.noise_nT) or bool((seen.kind == VECTOR).all())
    columns = at.columns if known else np.column_stack([seen.reading, -np.ones(len(seen))])
    T = _tangent(whiten if slope is None else whiten - whiten @ slope, columns, parameterisation)
    groups = np.flatnonzero([bool((seen.group == g).any()) for g in range(len(phase))])
    if len(groups):
        turn = np.einsum("nqj,nj->nq", whiten, at.tangent)[:, :, None]
        T = np.concatenate([T, turn * (seen.group[:, None] == groups)[:, None, :]], axis=2)
    y = np.einsum("nqj,nj->nq", whiten, at.residual)
    scene = scene_of(run, seen, theta, phase, at.field + effects_nT, at.prediction)
    if known:
        gains, zero = theta[: 3 * 3].reshape(3, 3), theta[3 * 3 :]
        scene = replace(scene, denoised_field_nT=columns[:, :3] @ gains.T + columns[:, 3:] * zero)
    return LinearProblem(
        run, seen, noise, base, parameterisation, theta, phase, scene, whiten, at.residual, y, T, groups
    )


def _tangent(whiten: Array, columns: Array, parameterisation: Parameterisation) -> Array:
    """The whitened residual's derivatives (n, q, coordinates) by the map: K row by row goes with `columns`, then k."""
    of_gains = whiten[:, :, :, None] * columns[:, None, None, :3]
    whole = np.concatenate([of_gains.reshape(*whiten.shape[:2], 3 * 3), whiten * columns[:, None, 3:]], axis=2)
    return whole if parameterisation.name == "affine" else whole @ parameterisation.basis


def _whitener(seen: Observations, information: Array, field: Array) -> Array:
    """W (n, q, 3) with W'W = G; axes of W move no faster than the field."""
    if bool((seen.kind == VECTOR).all()):
        if bool((information == information[0]).all()):
            return np.broadcast_to(np.linalg.cholesky(information[0]).T, information.shape)
        return np.asarray(np.swapaxes(np.linalg.cholesky(information), 1, 2))
    u = field / np.maximum(np.linalg.norm(field, axis=1), 1e-9)[:, None]
    first = np.einsum("nab,nb->na", information, u)
    size = np.sqrt(np.maximum(np.einsum("na,na->n", first, u), 1e-300))
    along = first / size[:, None]
    if not bool((seen.kind == AXIS).any()):
        return np.asarray(along[:, None, :])
    rest = information - along[:, :, None] * along[:, None, :]
    values, vectors = np.linalg.eigh(rest)
    second = np.sqrt(np.maximum(values[:, 2], 0.0))[:, None] * vectors[:, :, 2]
    second *= np.where(np.sum(second * seen.axis, axis=1) < 0, -1.0, 1.0)[:, None]
    return np.stack([along, second], axis=1)


def scene_of(run: Run, seen: Observations, theta: Array, phase: Array, field: Array, prediction: Array) -> Scene:
    """What effects may depend on; rows and prediction as in the fit, gaps of channels bridged by what they are."""
    K, _ = map_of(theta, seen.scale)
    channels = {c.name: bridged(run.t_s, c.values)[0] for c in run.channels if np.isfinite(c.values).any()}
    rig = None
    vector = bool((seen.kind == VECTOR).all()) and run.reference_vector is not None
    if vector:
        rig = _rig(run, seen, phase, prediction)
    axes = K / run.dut.nominal_nT_per_unit
    return Scene(run.t_s, run.segment_index, field, channels, run.mode, axes, rig, of_the_fit=True)


def _rig(run: Run, seen: Observations, phase: Array, prediction: Array) -> Rig:
    n = len(run)
    to_body = np.full((n, 3, 3), np.nan)
    axis_body, axis_cage, angle = np.full((n, 3), np.nan), np.full((n, 3), np.nan), np.full(n, np.nan)
    mounting, names = np.zeros(n, dtype=np.intp), list[Any]()
    for index, segment in enumerate(run.segments):
        rows = run.rows(index)
        name = segment.mounting or (index,)
        if name not in names:
            names.append(name)
        mounting[rows] = names.index(name)
        if segment.reference_frame == "body" or not len(rows):
            to_body[rows] = 0.0
            continue
        cage, body = np.asarray(segment.axis_cage), np.asarray(segment.axis_body)
        stated = segment.body_from_cage
        at_zero = np.asarray(stated) if stated is not None else shortest_rotation(cage, body)
        if run.angle_deg is None or not stands_turned(run, segment):
            to_body[rows] = at_zero
            continue
        if segment.kind != "rotation":  # at rest, where no effect of the turning platform looks for it
            to_body[rows] = rotation(body, -np.radians(run.angle_deg[rows])) @ at_zero
            continue
        start = np.where(seen.group[rows] >= 0, phase[np.maximum(seen.group[rows], 0)], 0.0) if len(phase) else 0.0
        angle[rows] = np.unwrap(np.radians(run.angle_deg[rows]))
        axis_body[rows], axis_cage[rows] = body, cage
        to_body[rows] = rotation(body, -(angle[rows] + start)) @ at_zero
    assert run.reference_vector is not None
    return Rig(prediction, run.reference_vector, to_body, axis_body, axis_cage, angle, mounting)
