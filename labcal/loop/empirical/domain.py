"""Where a run has seen what a smooth function depends on, and a function that is used there alone."""

from __future__ import annotations

from dataclasses import replace

from labcal.loop.empirical.splines import table
from labcal.model.effects import Scene, Term
from labcal.model.effects.inputs import outside, values
from labcal.model.effects.protocol import Array
from labcal.model.smooth import Domain, convex_hull


def domain_of(scene: Scene, term: Term) -> Domain:
    """The ends of one input, the joint hull of two."""
    x = values(term.inputs, scene)
    if x.shape[1] == 1:
        return Domain(term.inputs, ((float(x.min()),), (float(x.max()),)))
    return Domain(term.inputs, table(convex_hull(x)))


def used_inside(term: Term, domain: Domain) -> Term:
    """The same form, nought outside a domain: as `apply` leaves it out."""
    whole = term.kernel

    def kernel(form: Term, scene: Scene) -> Array:
        columns = whole(form, scene)
        columns[outside((domain,), scene)] = 0.0
        return columns

    return replace(term, kernel=kernel)
