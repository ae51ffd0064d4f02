"""Offsets that follow a channel: at once, behind it by one time constant, or as a sum of several responses."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from labcal.model.effects.protocol import Array, Form, Kernel, Scene, Shape
from labcal.model.effects.regressors import low_passed, middle, on_each_axis, per_axis
from labcal.record.run import Channel


def prompt(channel: Channel, kernel: Kernel) -> Form:
    """C in nT of B for each unit of the channel."""
    return Form(kernel, per_axis("c", f"nT/{channel.unit}"), (channel.name,), {channel.name: middle(channel)})


def late(channel: Channel, kernel: Kernel, tau: Shape) -> Form:
    """The same through a first-order response of time constant `tau`."""
    form = prompt(channel, kernel)
    return Form(kernel, form.parameters, form.channels, form.reference_value, (tau,))


def several(channel: Channel, kernel: Kernel, taus_s: Sequence[int]) -> Form:
    """A sum of responses, each with its own c: `c12s_x` belongs to 12 s, `c0s_x` to none."""
    form = prompt(channel, kernel)
    parameters = tuple(p for tau in taus_s for p in per_axis(f"c{tau}s", f"nT/{channel.unit}"))
    return Form(kernel, parameters, form.channels, form.reference_value)


def responding(form: Form, scene: Scene) -> Array:
    """The columns (n, 3, p) of all three."""
    drive = form.drive(scene)
    if form.shape:
        return on_each_axis(low_passed(scene.t_s, scene.segment, drive, form.at("tau_s")))
    taus = _taus(form)
    return np.concatenate([on_each_axis(low_passed(scene.t_s, scene.segment, drive, tau)) for tau in taus], axis=2)


def behind(form: Form) -> bool:
    """Whether the form looks at earlier rows."""
    return any(s.name == "tau_s" for s in form.shape) or any(tau > 0 for tau in _taus(form))


def _taus(form: Form) -> list[float]:
    """Of each group of three parameters: 12 for `c12s_x`, 0 for `c_x`."""
    found = [re.match(r"c(\d+)s_", name) for name, _ in form.parameters[::3]]
    return [float(match[1]) if match else 0.0 for match in found]
