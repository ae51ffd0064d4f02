"""Scale factors, and with them the cross terms, that follow temperature: at once or behind it, straight or curved."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import Driven, filtered
from labcal.model.effects.following import BEHIND
from labcal.model.effects.offset_temperature import RISES
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES, low_passed, middle, moving, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

TAU_S = (10.0, 30.0, 100.0, 300.0)


def kernel(term: Term, scene: Scene) -> Array:
    """E = Σ g_i s_i (T − T_ref) along sensor axis i; with nine parameters along every axis j; T behind by tau_s.

    A curved one has Σ h_i s_i (T − T_ref)² beside it.
    """
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    followed = low_passed(scene.t_s, scene.segment, term.drive(scene), tau_s, scene.past, term.ends_of_drive(scene))
    s, warm = scene.along_axes_nT, followed[:, None]
    if not _is_whole(term):
        powers = (warm, warm**2) if _is_curved(term) else (warm,)
        return np.concatenate([(power * s)[:, None, :] * scene.axes for power in powers], axis=2)
    return np.asarray(np.einsum("ji,nk->njik", scene.axes, warm * s).reshape(len(scene), 3, 9))


def _is_curved(term: Term) -> bool:
    return any(name.startswith("h_") for name, _ in term.parameters)


def _is_whole(term: Term) -> bool:
    return len(term.parameters) == 9


def in_c(term: Term) -> CForm:
    """The same in C."""
    lines, inputs, state, helpers = filtered(Driven(term))
    if not _is_whole(term):
        powers = ("warm", "warm * warm") if _is_curved(term) else ("warm",)
        body = "\n".join(
            f"along_axis(e[{3 * k + i}], {i}, {power} * now->along[{i}]);"
            for k, power in enumerate(powers)
            for i in range(3)
        )
    else:
        body = "\n".join(
            f"along_axis(e[{3 * i + k}], {i}, warm * now->along[{k}]);" for i in range(3) for k in range(3)
        )
    formula = (
        "E = sum of g s (T - T_ref) along the sensor's axes, g [1/degC], s [nT] the field along them, T as inputs say"
    )
    if _is_curved(term):
        formula += "; and h s (T - T_ref)^2, h [1/degC^2]"
    return CForm(formula, f"{lines}\n{body}", inputs, state, (*helpers, "along_axis"))


def candidates(run: Run) -> list[Term]:
    """Each temperature that moves: gains alone, at once and behind, straight and curved, and the whole matrix."""
    found = []
    for c in moving(run, ("temperature",)):
        unit = f"1/{c.unit}"
        whole = tuple((f"g_{i}{j}", unit) for i in AXES for j in AXES)
        gains, tau = per_axis("g", unit), (replace(BEHIND, grid=TAU_S),)
        curved = (*gains, *per_axis("h", f"{unit}^2"))
        variants = ((gains, ()), (gains, tau), (whole, ()), (curved, ()), (curved, tau))
        found += [Term(kernel, p, (c.name,), {c.name: middle(c)}, shape) for p, shape in variants]
    return found


FAMILY = Family(
    "gain-temperature",
    "sensor",
    kernel,
    candidates,
    shapes=(BEHIND,),
    of_field=True,
    experiment="warm the sensor in a large field and again in a small one",
    responds={"heat": 1.0},
    confounded=(RISES,),
    of_temperature=True,
    in_pieces=True,
    in_c=in_c,
)
