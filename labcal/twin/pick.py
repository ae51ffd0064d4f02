"""The seed picks what the DUT suffers. Nobody else knows."""

from __future__ import annotations

from typing import Any

import numpy as np

CHOICES: tuple[tuple[str, dict[str, Any]], ...] = (
    ("offset-current", {"channel": "i_eps"}),
    ("offset-current", {"channel": "i_payload"}),
    ("offset-current", {"channel": "i_radio"}),
    ("offset-temperature", {}),
    ("gain-temperature", {}),
    ("offset-drift", {}),
    ("offset-step", {}),
    ("nonlinearity", {}),
    ("cross-field", {}),
    ("lag", {}),
    ("axis-tilt", {}),
    ("cage-field", {}),
    ("periodic", {}),
)


def pick_effect(seed: int) -> dict[str, dict[str, Any]]:
    """One effect with its parameters, by `seed`."""
    rng = np.random.default_rng([seed, 0x5EED])
    name, parameters = CHOICES[int(rng.integers(len(CHOICES)))]
    return {name: parameters}
