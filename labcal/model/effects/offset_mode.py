"""Another offset in each power mode of the device."""

from __future__ import annotations

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.c_form import CForm, mode_enumerator
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run

ROWS = 10  # a mode with fewer rows is not a candidate


def kernel(term: Term, scene: Scene) -> Array:
    """E = c_m in mode m, against the mode that the offset k belongs to."""
    if scene.mode is None:
        raise InputError("the calibration needs the power mode of each row", column="mode")
    return np.concatenate([(scene.mode == name)[:, None, None] * np.eye(3) for name in own_modes(term)], axis=2)


def own_modes(term: Term) -> list[str]:
    """The modes that have an offset of their own."""
    return [name.removeprefix("c_x ") for name, _ in term.parameters if name.startswith("c_x ")]


def in_c(term: Term) -> CForm:
    """The same in C."""
    lines = [
        f"on_each_axis(e + {3 * k}, mode_is(now, {n}));" for k, n in enumerate(map(mode_enumerator, own_modes(term)))
    ]
    formula = "E = c [nT] in each mode but the one that k belongs to, for each axis of B"
    return CForm(formula, "\n".join(lines), helpers=("on_each_axis", "mode_is"))


def candidates(run: Run) -> list[Term]:
    """One form: every mode against the most frequent one."""
    names, counts = np.unique(run.mode, return_counts=True)
    base = names[np.argmax(counts)]
    others = [str(name) for name, count in zip(names, counts, strict=True) if name != base and count >= ROWS]
    parameters = tuple((f"{c} {mode}", unit) for mode in others for c, unit in per_axis("c", "nT"))
    return [Term(kernel, parameters)] if others else []


FAMILY = Family(
    "offset-mode",
    "sensor",
    kernel,
    candidates,
    phrase="the offset differs between power modes",
    experiment="hold the attitude and switch between the power modes",
    responds={"load": 1.0},
    modes=own_modes,
    in_c=in_c,
)
