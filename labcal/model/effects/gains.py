"""Scale factors that follow a channel: at once or behind it, straight or curved, of each axis or the whole matrix."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import Driven, filtered
from labcal.model.effects.following import BEHIND, beginnings, carried_off
from labcal.model.effects.protocol import Array
from labcal.model.effects.regressors import AXES, low_passed, middle, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import Shape
from labcal.model.effects.term import Kernel, Term
from labcal.record.run import Channel


def followed_by_gains(term: Term, scene: Scene) -> Array:
    """The columns (n, 3, p) of all forms: q s_i along sensor axis i, with nine parameters along every axis j.

    q is the drive, behind by `tau_s` if at all. A curved form has q² s_i beside it; one that may begin anywhere in each
    segment what is left of that.
    """
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    drive, ends = term.drive(scene), term.ends_of_drive(scene)
    followed = low_passed(scene.t_s, scene.segment, drive, tau_s, scene.past, ends, carried_off=carried_off(term))
    s, q = scene.along_axes_nT, followed[:, None]
    if not _is_whole(term):
        powers = (q, q**2) if _is_curved(term) else (q,)
        each = (*powers, *(left[:, None] for left in beginnings(term, scene)))
        return np.concatenate([(one * s)[:, None, :] * scene.axes for one in each], axis=2)
    return np.asarray(np.einsum("ji,nk->njik", scene.axes, q * s).reshape(len(scene), 3, 9))


def _is_curved(term: Term) -> bool:
    return any(name.startswith("h_") for name, _ in term.parameters)


def _is_whole(term: Term) -> bool:
    return term.lasting == 9


def gains_in_c(term: Term) -> CForm:
    """The same in C."""
    driven = Driven(term)
    lines, inputs, state, helpers = filtered(driven)
    if not _is_whole(term):
        powers = ("followed", "followed * followed") if _is_curved(term) else ("followed",)
        body = "\n".join(
            f"along_axis(e[{3 * k + i}], {i}, {power} * now->along[{i}]);"
            for k, power in enumerate(powers)
            for i in range(3)
        )
    else:
        body = "\n".join(
            f"along_axis(e[{3 * i + k}], {i}, followed * now->along[{k}]);" for i in range(3) for k in range(3)
        )
    of = driven.channel_unit or "1"
    formula = (
        f"E = sum of g s (q - q_ref) along the sensor's axes, g [1/{of}], s [nT] the field along them, q as inputs say"
    )
    if _is_curved(term):
        formula += f"; and h s (q - q_ref)^2, h [1/{of}^2]"
    return CForm(formula, f"{lines}\n{body}", inputs, state, (*helpers, "along_axis"))


def gains(channel: Channel, kernel: Kernel, tau: Shape | None = None, *, curved: bool = False) -> Term:
    """One gain an axis, straight or curved, at once or behind by `tau`."""
    unit = f"1/{channel.unit}"
    parameters = per_axis("g", unit) + (per_axis("h", f"{unit}^2") if curved else ())
    return Term(kernel, parameters, (channel.name,), {channel.name: middle(channel)}, (tau,) if tau else ())


def whole_matrix(channel: Channel, kernel: Kernel) -> Term:
    """Each gain and each cross term, straight and at once."""
    nine = tuple((f"g_{i}{j}", f"1/{channel.unit}") for i in AXES for j in AXES)
    return Term(kernel, nine, (channel.name,), {channel.name: middle(channel)})
