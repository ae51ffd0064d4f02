"""An interference of one frequency, as the sampling shows it: on the readings, or a field that is fixed to the cage."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.regressors import AXES, on_each_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import FREQUENCY, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers, period_s

LINE = Shape("f_Hz", 0.0, "Hz", kind=FREQUENCY)
CAGE = "cage_"  # begins the names of parameters along the axes of C


def kernel(term: Term, scene: Scene) -> Array:
    """E = c cos(2π f t) + s sin(2π f t), each per axis of the body, or of the cage: R (c cos + s sin)."""
    phase = 2 * np.pi * term.at(LINE.name) * scene.t_s
    waves = np.concatenate([on_each_axis(np.cos(phase)), on_each_axis(np.sin(phase))], axis=2)
    if not in_the_cage(term):
        return waves
    assert scene.rig is not None
    return np.asarray(scene.rig.to_body @ waves)


def in_the_cage(term: Term) -> bool:
    """Whether the line is a field of the room that the reference does not see: it turns in the body."""
    return any(name.startswith(CAGE) for name, _ in term.parameters)


def candidates(run: Run) -> list[Term]:
    """One frequency between a few cycles a segment and the Nyquist frequency; the loop finds where to look."""
    if len(run) < 20 or not np.isfinite(nyquist := 0.5 / period_s(run.t_s)):
        return []
    seen = any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments)
    shape = (replace(LINE, value=nyquist / 2),)
    return [Term(kernel, _along(frame), shape=shape) for frame in (("", CAGE) if seen else ("",))]


def _along(frame: str) -> tuple[tuple[str, str], ...]:
    return tuple((f"{frame}{wave}_{a}", "nT") for wave in ("cos", "sin") for a in AXES)


FAMILY = Family(
    "periodic",
    "sensor",
    kernel,
    candidates,
    phrase="a periodic disturbance lies on the readings",
    shapes=(LINE,),
    repeats=True,
    harmonics=True,
    rig_form=in_the_cage,
    experiment="record at rest, and again at another sampling rate: an alias moves",
    bound_to_run=True,
)
