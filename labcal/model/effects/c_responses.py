"""What follows a channel, in C: at once, behind it, late, or ahead of a slow thermometer (`following`, `regressors`).

What looks ahead cannot be done in flight, so who calls brings it: how fast the channel moves where a response begins,
the slope that undoes a slow thermometer, and a channel whose clock is behind.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from labcal.model.effects import memory
from labcal.model.effects.c_form import CForm, Input, given, identifier, reads
from labcal.model.effects.regressors import delayed, low_passed
from labcal.model.effects.scene import Array, Scene
from labcal.model.effects.shape import DELAY
from labcal.model.effects.term import Term

STEP_S = 1e-6  # over which the slope of a channel is taken
Drive = Callable[[Scene], Array]


@dataclass(frozen=True, slots=True)
class Driven:
    """The drive of a term in C, the double `q`: its channel from the reference value, or the square of that."""

    term: Term
    squared: bool = False

    @property
    def channel(self) -> str:
        """What drives it."""
        return self.term.channels[0]

    @property
    def unit(self) -> str:
        """Of the drive."""
        return f"{self.channel_unit}^2" if self.squared and self.channel_unit else self.channel_unit

    @property
    def channel_unit(self) -> str:
        """Of its channel, as the parameters' own unit tells; empty where that is open."""
        first = self.term.parameters[0][1]
        return first.partition("/")[2].removesuffix("^2") if first.startswith(("nT/", "1/")) else ""

    @property
    def name(self) -> str:
        """For inputs and comments."""
        return f"{identifier(self.channel)}_squared" if self.squared else identifier(self.channel)

    def of(self, scene: Scene) -> Array:
        """The same for rows of a scene (n,)."""
        drive = self.term.drive(scene)
        return drive**2 if self.squared else drive

    def written(self, value: str) -> str:
        """The expression for a value of the channel."""
        from_reference = f"({value} - {self.term.reference_value[self.channel]!r})"
        return f"{from_reference} * {from_reference}" if self.squared else from_reference


def at_once(driven: Driven) -> tuple[str, tuple[Input, ...]]:
    """The statement that declares the drive q, and what it needs."""
    channel = given(driven.channel, driven.channel_unit)
    return f"const double q = {driven.written(reads(channel))};", (channel,)


def behind(driven: Driven, tau_s: float, tau: str, place: int) -> tuple[str, str, tuple[Input, ...]]:
    """The expression of the drive through a response of `tau_s`, written `tau`, the helper it calls, and its inputs.

    `place` is its place among the effect's states.
    """
    if tau_s == 0:
        return "(labcal_real)q", "", ()
    slope = _slope(driven, tau_s)
    if tau_s < 0:
        return f"(labcal_real)(q - {tau} * {reads(slope)})", "", (slope,)
    return (
        f"low_passed(&state->behind[{place}], now, q, {reads(slope)}, {tau})",
        "low_passed",
        (slope,),
    )


def _slope(driven: Driven, tau_s: float) -> Input:
    """How fast the drive moves [unit/s]: in each row where a slow thermometer is undone, else where a state begins."""
    stated = f"{abs(tau_s):g}".replace(".", "p").replace("-", "m").replace("+", "")
    if tau_s < 0:
        name = f"{driven.name}_slope_{stated}s"
        window = abs(tau_s) * memory.LEAD
        what = f"slope of a line through {driven.name} within {window:.3g} s either way of t_s, each row"

        def slope(scene: Scene) -> Array:
            drive = driven.of(scene)
            return np.asarray((low_passed(scene.t_s, scene.segment, drive, tau_s) - drive) / -tau_s)
    else:
        name = f"{driven.name}_start_{stated}s"
        what = f"how fast {driven.name} moves where its state begins, by a line over {tau_s:.3g} s; 0 where not known"

        def slope(scene: Scene) -> Array:
            drive = driven.of(scene)
            return np.asarray((drive - low_passed(scene.t_s, scene.segment, drive, tau_s)) / tau_s)

    return Input(name, f"{driven.unit}/s", what, slope, where_it_begins=tau_s > 0)


def late(driven: Driven, delay_s: float) -> tuple[str, tuple[Input, ...], str, tuple[str, ...]]:
    """Statements that set the drive `late`, a delay earlier or (negative) later; inputs, state members, helpers."""
    if delay_s >= 0:
        declared, inputs = at_once(driven)
        line = "const labcal_real late = (labcal_real)earlier(&state->past, now, q, shape[0]);"
        return f"{declared}\n{line}", inputs, "labcal_history past;", ("earlier",)
    stated = f"{-delay_s:g}".replace(".", "p").replace("-", "m")
    name, ahead = f"{identifier(driven.channel)}_in_{stated}s", -delay_s

    def later(scene: Scene, by_s: float = ahead) -> Array:
        return delayed(scene.t_s, scene.segment, scene.channels[driven.channel], -by_s)

    def slope(scene: Scene) -> Array:
        return np.asarray((later(scene) - later(scene, ahead - STEP_S)) / STEP_S)

    value = Input(name, driven.unit, f"channel {driven.channel} {ahead:g} s after t_s: its clock is behind", later)
    rate = Input(f"{name}_slope", f"{driven.unit}/s", "how fast it moves then; only for u", slope)
    moved = f"(shape[0] - {delay_s!r}) * {reads(rate)}"
    return f"const labcal_real late = (labcal_real)({driven.written(reads(value))} - {moved});", (value, rate), "", ()


def responses_in_c(term: Term, formula: str, taus_s: Sequence[float]) -> CForm:
    """C for an offset that follows a channel as `labcal.model.effects.following.responses` does."""
    driven, delay = Driven(term), term.of(DELAY)
    if delay is not None:
        body, inputs, state, helpers = late(driven, delay.value)
        return CForm(formula, f"{body}\non_each_axis(e, late);", inputs, state, (*helpers, "on_each_axis"))
    declared, inputs = at_once(driven)
    lines, helpers_of, slow = [declared], ["on_each_axis"], 0
    for number, tau_s in enumerate(taus_s):
        tau = "shape[0]" if term.shape else repr(tau_s)
        value, helper, more = behind(driven, tau_s, tau, slow)
        lines.append(f"on_each_axis(e + {3 * number}, {value});")
        inputs += more
        slow += bool(helper)
        helpers_of += [helper] if helper else []
    state = f"labcal_behind behind[{slow}];" if slow else ""
    return CForm(formula, "\n".join(lines), inputs, state, tuple(helpers_of))


def filtered(driven: Driven) -> tuple[str, tuple[Input, ...], str, tuple[str, ...]]:
    """Statements that set the drive `followed`, through the term's own time constant where it has one."""
    declared, inputs = at_once(driven)
    tau_s = driven.term.shape[0].value if driven.term.shape else 0.0
    value, helper, more = behind(driven, tau_s, "shape[0]", 0)
    lines = f"{declared}\nconst labcal_real followed = {value};"
    return lines, inputs + more, "labcal_behind behind[1];" if helper else "", (helper,) if helper else ()
