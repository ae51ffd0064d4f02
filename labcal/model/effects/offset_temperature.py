"""Sensor offset that follows temperature, straight or curved: at once, behind it by thermal time constants, or ahead.

It is ahead (a negative time constant) where the thermometer is the slower of the two. Where heating is unlike cooling,
as with magnets and glued parts, it has two branches: it passes from one to the other while the temperature turns back.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.c_form import CForm
from labcal.model.effects.c_responses import Driven, at_once, filtered, responses_in_c
from labcal.model.effects.following import (
    BEHIND,
    LATE,
    OFF,
    WITHIN,
    begun_anew,
    begun_elsewhere,
    delayed_terms,
    first_order,
    instantaneous,
    multi_tau,
    reach_s,
    responses,
    time_constants,
)
from labcal.model.effects.past import ANYWHERE, Past
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.recursion import clipped_recursion
from labcal.model.effects.regressors import low_passed, moving, on_each_axis, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import THRESHOLD, Shape
from labcal.model.effects.term import Term
from labcal.record import Run
from labcal.record.run import Channel

LEADS_S = (-100.0, -30.0, -10.0, -3.0)  # of a thermometer that is slower than the sensor
TAU_S = (10.0, 30.0, 100.0, 300.0)
SEVERAL_S = (0, 60, 300)  # a housing and what is inside it
TURNS = Shape("r_C", 1.0, "degC", kind=THRESHOLD)
OF_THE_RANGE = (0.005, 0.02, 0.1, 0.3)  # of the run's temperatures: half-widths of a turning back
OWN_NOISE = 4.0  # standard deviations of a thermometer: a narrower turning would follow its noise
BRANCH_IN_C = """\
double branch = state->begun ? state->branch + (q - state->last) : 0.0;
branch = branch > shape[0] ? shape[0] : branch < -shape[0] ? -shape[0] : branch;
state->branch = branch;
state->last = q;
state->begun = 1;
on_each_axis(e, (labcal_real)q);
on_each_axis(e + 3, (labcal_real)(branch / shape[0]));"""
SLOPE_IN_C = """
on_each_axis(e + 6, (labcal_real)(branch / shape[0] * q));"""
RISES = Confounded("a temperature that only rises", "a drift", "warm the device and let it cool again")


def kernel(term: Term, scene: Scene) -> Array:
    """E = c (T − T_ref) + d (T − T_ref)², T through a first-order response of time constant tau_s, or of several.

    With two branches E = c (T − T_ref) + b w + f w (T − T_ref), w = 1 where it has been heating by 2 r_C, −1 where it
    has been cooling.
    """
    if term.of(THRESHOLD) is not None:
        T, w = term.drive(scene), _branch(term, scene)
        return np.concatenate([on_each_axis(one) for one in (T, w, w * T)][: len(term.parameters) // 3], axis=2)
    if not any(name.startswith("d_") for name, _ in term.parameters):
        return responses(term, scene)
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    T = low_passed(scene.t_s, scene.segment, term.drive(scene), tau_s, scene.past, term.ends_of_drive(scene))
    return np.concatenate([on_each_axis(T), on_each_axis(T**2)], axis=2)


def _branch(term: Term, scene: Scene) -> Array:
    """The stop of T of half-width r_C, over r_C (n,): it starts between the branches, and goes on from the past.

    Where nothing went before it may be on either. So it may after a gap in which T has moved: by as much, for it may
    have turned back unseen.
    """
    T, past, half = term.drive(scene), scene.past or Past(len(scene)), term.at(TURNS.name)
    if not len(T):
        return T
    name = f"branch of {half}"
    within, before, stood = past.before.get(name, (scene.segment[0], T[0], past.astray * half * ANYWHERE))
    steps = np.diff(T, prepend=before)
    after_a_gap = np.flatnonzero(np.diff(scene.segment, prepend=within))
    unseen = past.astray * np.minimum(np.abs(steps[after_a_gap]), half)
    steps[0] += stood
    with_gaps = np.insert(steps, after_a_gap + 1, unseen)
    stop = clipped_recursion(with_gaps[:, None], half, np.zeros(1, dtype=np.intp))[:, 0]
    stop = np.delete(stop, after_a_gap + np.arange(len(after_a_gap)))
    last = past.own - 1
    past.after[name] = scene.segment[last], T[last], stop[last]
    return stop / half


def _reach_s(term: Term) -> float | None:
    """As what follows a channel; branches are a state."""
    return 0.0 if term.of(THRESHOLD) is not None else reach_s(term)


def in_c(term: Term) -> CForm:
    """The same in C."""
    if term.of(THRESHOLD) is not None:
        declared, channel = at_once(Driven(term))
        law = "E = (c + f w) (T - T_ref) + b w, c, f [nT/degC], b [nT]; w from 1, heating, to -1 within 2 r_C [degC]"
        state, sloped = "double last; double branch; int begun;", len(term.parameters) > 6
        body = f"{declared}\n{BRANCH_IN_C}{SLOPE_IN_C if sloped else ''}"
        return CForm(law, body, channel, state, ("on_each_axis",))
    formula = "E = c (T - T_ref) + d (T - T_ref)^2, c [nT/degC], d [nT/degC^2] for each axis of B; T as its inputs say"
    if not any(name.startswith("d_") for name, _ in term.parameters):
        return responses_in_c(term, formula, time_constants(term))
    lines, inputs, state, helpers = filtered(Driven(term))
    body = f"{lines}\non_each_axis(e, followed);\non_each_axis(e + 3, followed * followed);"
    return CForm(formula, body, inputs, state, (*helpers, "on_each_axis"))


def candidates(run: Run) -> list[Term]:
    """Each temperature that moves: prompt, behind, with several time constants, curved, branched, delayed.

    What is behind may have begun anywhere in each segment.
    """
    tau, either = replace(BEHIND, grid=TAU_S), replace(BEHIND, grid=(*LEADS_S, *TAU_S))
    found = []
    for c in moving(run, ("temperature",)):
        straight = (instantaneous(c, kernel), first_order(c, kernel, tau))
        found += [straight[0], first_order(c, kernel, either), *multi_tau(c, kernel, run, SEVERAL_S)]
        found += map(_curved, straight)
        found += [begun_elsewhere(straight[1], c), *begun_anew(straight[1], c, run)]
        found += [*_of_two_branches(c, straight[0]), *delayed_terms(c, kernel, run)]
    return found


def _of_two_branches(channel: Channel, straight: Term) -> list[Term]:
    """Turning back within parts of the range of T, none so narrow that the thermometer's noise would do."""
    T = channel.values[np.isfinite(channel.values)]
    noise = 1.4826 * float(np.median(np.abs(np.diff(T, 2)))) / np.sqrt(6) if len(T) > 2 else np.inf
    least = OWN_NOISE * max(noise, _step(T) / np.sqrt(12))
    grid = tuple(r for share in OF_THE_RANGE if (r := share * float(np.ptp(T))) >= least)
    apart = (*straight.parameters, *per_axis("b", "nT"))
    sloped = (*apart, *per_axis("f", straight.parameters[0][1]))
    return [replace(straight, parameters=p, shape=(replace(TURNS, grid=grid),)) for p in (apart, sloped) if grid]


def _step(T: Array) -> float:
    """The least change of a thermometer (n,)."""
    return float(np.min(np.diff(np.unique(T)), initial=np.ptp(T)))


def _curved(term: Term) -> Term:
    unit = term.parameters[0][1].removeprefix("nT/")
    return replace(term, parameters=(*term.parameters, *per_axis("d", f"nT/{unit}^2")))


FAMILY = Family(
    "offset-temperature",
    "sensor",
    kernel,
    candidates,
    phrase="the offset changes with temperature",
    shapes=(BEHIND, LATE, TURNS, OFF, WITHIN),
    adds_up=True,
    time_constants=time_constants,
    experiment="hold the attitude and warm the sensor, then let it cool",
    responds={"heat": 1.0},
    confounded=(RISES,),
    of_temperature=True,
    reach_s=_reach_s,
    in_pieces=True,
    in_c=in_c,
)
