"""Findings about the run: channels that are one signal or silent, undeclared axes, a noise other than declared."""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.data.checks import turned_axes
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.noise.differences import white_level
from labcal.loop.result import Finding
from labcal.model.gaps import is_known_enough
from labcal.record import Run
from labcal.record.run import Channel

Array = NDArray[np.float64]
ONE_SIGNAL = 0.99999  # correlation from which two channels are one signal
MIN_COMMON_ROWS = 0.5  # of the rows that both channels have to be known in


def findings(run: Run, problem: LinearProblem, level: NoiseFloor) -> tuple[Finding, ...]:
    """All of them for one run."""
    found = [turned_axes(problem), noise_disagreement(problem, level), coloured_noise(level)]
    return (*(f for f in found if f is not None), *silent_channels(run), *same_signals(run))


def silent_channels(run: Run) -> list[Finding]:
    """Channels that cannot show a cause: without a value, with one value alone, or with too few to be drawn between."""
    values = {c.name: c.values[np.isfinite(c.values)] for c in run.channels if c.role == "dut"}
    empty = [name for name, known in values.items() if not len(known)]
    constant = [name for name, known in values.items() if len(known) and np.ptp(known) == 0]
    moving = {c.name: c.values for c in run.channels if c.name in values and c.name not in (*empty, *constant)}
    sparse = [name for name, column in moving.items() if not is_known_enough(run.t_s, column)]
    kinds = (
        (empty, "no value in this run"),
        (constant, "one value all through this run"),
        (sparse, "no value, nor a sure one between two others, in most rows"),
    )
    return [
        Finding("silent-channel", "data", f"Channels with {what}: {', '.join(names)}. They can show no cause.")
        for names, what in kinds
        if names
    ]


def same_signals(run: Run) -> list[Finding]:
    """Pairs of channels that are one signal: no fit tells which of them is a cause."""
    moving = [c for c in run.channels if c.role == "dut" and np.nanstd(_known(c)) > 0]
    return [
        Finding(
            "same-signal", "data", f"Channels {a.name} and {b.name} are one signal: no fit tells which is the cause."
        )
        for a, b in itertools.combinations(moving, 2)
        if _one_signal(a, b)
    ]


def _known(channel: Channel) -> Array:
    return channel.values[np.isfinite(channel.values)] if np.isfinite(channel.values).any() else np.zeros(1)


def _one_signal(a: Channel, b: Channel) -> bool:
    both = np.isfinite(a.values) & np.isfinite(b.values)
    if both.sum() < MIN_COMMON_ROWS * len(both) or np.ptp(a.values[both]) == 0 or np.ptp(b.values[both]) == 0:
        return False
    return bool(abs(np.corrcoef(a.values[both], b.values[both])[0, 1]) > ONE_SIGNAL)


def coloured_noise(level: NoiseFloor) -> Finding | None:
    """Noise that is not stated and follows itself from row to row."""
    if level.memory_s is None:
        return None
    return Finding(
        "coloured-noise",
        "data",
        f"The noise, whose level is not stated, follows itself for about {level.memory_s:.2g} s and goes with nothing "
        f"that is recorded: {level.nT:.3g} nT. State the device's noise, measured at rest, to be sure.",
    )


def noise_disagreement(problem: LinearProblem, level: NoiseFloor) -> Finding | None:
    """The declared noise where it is not the one measured at rest, or else from row to row."""
    if level.source != "declared":
        return None
    still = level.measured_over_declared
    ratio = still or white_level(problem.y, problem.scene.segment)
    if 1 / policy.POLICY.max_noise_ratio <= ratio <= policy.POLICY.max_noise_ratio:
        return None
    where = "at rest" if still else "from row to row"
    doubt = f"the floor of {level.nT:.0f} nT that results are compared with may be wrong"
    return Finding("noise-floor", "data", f"The noise measured {where} is {ratio:.2f} times the declared one: {doubt}.")
