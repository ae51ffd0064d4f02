"""Effects of other packages: whatever goes wrong in their formulas is said with their name, as a wrong input."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import wraps
from typing import TypeVar, get_args

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.protocol import Action, Array, Family
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import Kind, Shape
from labcal.model.effects.term import Kernel, Term
from labcal.model.records import Owner
from labcal.plugin_loading import blamed
from labcal.record import Run

Said = TypeVar("Said")


def guarded(family: Family, where: str) -> Family:
    """The same family; its candidates and columns are checked, and a fault names it and `where` it comes from."""
    named = f"the effect {family.id} of another package ({where})"
    shapes: object = family.shapes  # whatever its author has stated
    if not isinstance(shapes, tuple) or not all(isinstance(shape, Shape) for shape in shapes):
        raise InputError(f"{named} states in `shapes` something else than a Shape of each nonlinear parameter: (TAU,)")
    _check_words(family, named)
    kernel = _checked(family.kernel, named)
    return replace(
        family,
        kernel=kernel,
        candidates=_candidates(family, kernel, named),
        time_constants=_guarded(family.time_constants, named),
        reach_s=_guarded(family.reach_s, named),
        rig_form=_guarded(family.rig_form, named),
        bound_form=_guarded(family.bound_form, named),
        modes=family.modes and _guarded(family.modes, named),
        in_c=family.in_c and _guarded(family.in_c, named),
    )


def _candidates(family: Family, kernel: Kernel, named: str) -> Callable[[Run], Sequence[Term]]:
    kinds = {shape.name: shape.kind for shape in family.shapes}

    @wraps(family.candidates)
    def found(run: Run) -> Sequence[Term]:
        with blamed(named, f"on run {run.run_id}"):
            terms = list(family.candidates(run))
        for term in terms:
            _check_shapes(term, kinds, named)
        return [
            replace(term, kernel=kernel if term.kernel is family.kernel else _checked(term.kernel, named))
            for term in terms
        ]

    return found


def _check_words(family: Family, named: str) -> None:
    """Whether its owner and what it responds to are words that somebody asks for."""
    owners, actions = get_args(Owner), get_args(Action)
    if family.belongs_to not in owners:
        raise InputError(f"{named} belongs to {family.belongs_to!r}; expected one of {', '.join(owners)}")
    if unknown := sorted(set(family.responds) - set(actions)):
        raise InputError(f"{named} responds to {unknown[0]!r}; expected any of {', '.join(actions)}")


def _check_shapes(term: Term, kinds: Mapping[str, Kind], named: str) -> None:
    """Whether each nonlinear parameter of a term is stated by its family, and can be found as its kind says."""
    for shape in term.shape:
        if kinds.get(shape.name) is not shape.kind:
            raise InputError(f"{named} does not state its parameter {shape.name} and that one's kind in `shapes`")
        if shape.kind.found_by == "delay scan" and not (term.channels and shape.grid and len(term.parameters) == 3):
            raise InputError(f"{named}: {shape.name} has to delay a channel, with a grid and c_x, c_y, c_z alone")
        if shape.kind.found_by == "own secant" and len(term.parameters) != 1:
            raise InputError(f"{named}: {shape.name} has to belong to the one linear parameter of its term")


def _guarded(hook: Callable[[Term], Said], named: str) -> Callable[[Term], Said]:
    @wraps(hook)
    def asked(term: Term) -> Said:
        with blamed(named, f"in what it says of itself, {hook.__name__}"):
            return hook(term)

    return asked


def _checked(kernel: Kernel, named: str) -> Kernel:
    @wraps(kernel)
    def columns(term: Term, scene: Scene) -> Array:
        with blamed(named, "in its formula"):
            found = np.asarray(kernel(term, scene), dtype=float)
        wanted = (len(scene), 3, len(term.parameters))
        if found.shape != wanted:
            raise InputError(f"{named} gives columns of shape {found.shape}, not (rows, 3, parameters) = {wanted}")
        known = np.isfinite(scene.field_nT).all() and all(np.isfinite(scene.channels[c]).all() for c in term.channels)
        if known and not np.isfinite(found).all():
            raise InputError(f"{named} gives numbers that are not finite")
        return found

    return columns
