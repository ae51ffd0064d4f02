"""Ten terms that the loop built of effects that no file describes, beside the truth that made them.

`python tools/empirical_pictures.py PICTURE.png [--seed S]`: a run and a fresh recording of each shape of
`tests/blind/empirical_term.py`, all with the same seed; fresh rows inside the term's domain are drawn.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from runpy import run_path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from labcal.fit import draft_calibration
from labcal.loop import close_loop

Array = NDArray[np.float64]
BLIND = Path(__file__).parents[1] / "tests" / "blind" / "empirical_term.py"
SEED = 2026
# What the truth is a function of, where that is one thing: of scaled channels, direction and rate.
DRIVEN_BY: dict[str, tuple[str, Callable[[Mapping[str, Array], Array, Array], Array]]] = {
    "saturating in temperature": ("temperature (scaled)", lambda c, u, w: c["temp"]),
    "resonant in a voltage": ("voltage (scaled)", lambda c, u, w: c["v_bus"]),
    "resonant in the rate": ("rate (deg/s)", lambda c, u, w: w),
    "cubic in a voltage": ("voltage (scaled)", lambda c, u, w: c["v_bus"]),
    "wavy in a pressure": ("pressure (scaled)", lambda c, u, w: c["p_tank"]),
    "a power of a channel": ("pressure (scaled)", lambda c, u, w: c["p_tank"]),
    "a lobe in the attitude": ("direction x", lambda c, u, w: u[:, 0]),
}


def drawn(panel: Any, blind: dict[str, Any], shape: str, seed: int) -> str:
    """One panel; what it shows in words."""
    scenes = [blind["lab"](np.random.default_rng([seed, i])) for i in (0, 1)]
    along = np.random.default_rng([seed, 2]).normal(size=3)
    along /= np.linalg.norm(along)
    effects = [blind["SHAPES"][shape](s[6], _direction(s[2]), s[2], s[5], _draw(seed, 4)) for s in scenes]
    size = _draw(seed, 3).uniform(3.0, 12.0) * blind["NOISE_nT"] / np.std(effects[0])
    truths = [size * one for one in effects]
    readings = [
        (scene[2] + truth[:, None] * along + blind["k"]) @ np.linalg.inv(blind["K"]).T
        for scene, truth in zip(scenes, truths, strict=True)
    ]
    run = blind["recorded"](scenes[0], readings[0] + _draw(seed, 5).normal(0, blind["NOISE_nT"], readings[0].shape))
    closed = close_loop(run, empirical=True)
    if not any(effect.basis is not None for effect in closed.accepted):
        panel.set_title(f"{shape}\nno term was built", fontsize=9)
        panel.set(xticks=(), yticks=())
        return f"{shape}: no term ({closed.verdict})"
    made = draft_calibration(run, closed.fit(), "0" * 64, metrics=closed.metrics())
    fresh = blind["recorded"](scenes[1], readings[1])
    assert made.covariance is not None
    of_map = replace(made, effects=(), covariance=made.covariance[:12, :12], covariance_of=made.covariance_of[:12])
    applied, bare = made.apply(fresh), of_map.apply(fresh)
    inside = np.array(["domain" not in flag for flag in applied.flags])
    truth, body = truths[1][inside], scenes[1][2][inside]
    found = ((bare.field_nT - applied.field_nT) @ along)[inside]
    found += _of_the_map(truth - found, body)
    name, x = "truth (nT)", truth
    if shape in DRIVEN_BY:
        name, driven = DRIVEN_BY[shape]
        x = driven(scenes[1][6], _direction(scenes[1][2]), scenes[1][5])[inside]
    order = np.argsort(x)
    panel.plot(x[order], truth[order], color="0.6", lw=3, label="truth")
    panel.plot(x, found, ".", ms=2.5, color="tab:blue", label="found")
    gone = 1 - np.sum((truth - found) ** 2) / np.sum((truth - _of_the_map(truth, body)) ** 2)
    inputs = ", ".join(i for e in closed.accepted if e.basis is not None for i in e.inputs)
    panel.set(xlabel=name)
    panel.set_title(f"{shape}\nin {inputs}: {100 * gone:.1f} % gone", fontsize=9)
    return f"{shape}: {closed.verdict}, in {inputs}, {100 * gone:.1f} % of the square gone, {inside.mean():.0%} inside"


def _draw(seed: int, part: int) -> np.random.Generator:
    return np.random.default_rng([seed, part])


def _direction(body: Array) -> Array:
    return np.asarray(body / np.linalg.norm(body, axis=1)[:, None])


def _of_the_map(values: Array, body: Array) -> Array:
    """The part of `values` (n,) that K and k carry: no term is to hold that."""
    columns = np.column_stack([np.ones(len(body)), body / 3e4])
    return np.asarray(columns @ np.linalg.lstsq(columns, values, rcond=None)[0])


def main() -> None:
    """Draw all shapes on one page."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("picture", type=Path)
    asked.add_argument("--seed", type=int, default=SEED)
    words, blind = asked.parse_args(), run_path(str(BLIND))
    figure = Figure(figsize=(15, 6.4), layout="constrained")
    panels = figure.subplots(2, 5).ravel()
    for panel, shape in zip(panels, blind["SHAPES"], strict=True):
        print(drawn(panel, blind, shape, words.seed), flush=True)
    for panel in panels[::5]:
        panel.set(ylabel="offset along its direction (nT)")
    panels[0].legend(loc="upper left")
    figure.savefig(words.picture, dpi=80)


if __name__ == "__main__":
    main()
