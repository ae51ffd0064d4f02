"""Settings with which each procedure does all that it does, and is soon over."""

import pytest

from labcal.runner import procedures

ALWAYS = ("degauss", "field-hold", "flip", "preflight", "rotate-axis")  # one of each kind
EACH = [name if name in ALWAYS else pytest.param(name, marks=pytest.mark.slow) for name in sorted(procedures())]

SHORT = {
    "preflight": {"axes": "x,z", "magnitudes_nT": "20000", "reverse": "no", "zero_s": "2", "dwell_s": "1"},
    "ambient": {"duration_s": "20"},
    "configuration": {"photographs": "no"},
    "temperature-drift": {"rounds": "2"},
    "field-sphere": {"n_directions": "12"},
    "cage-map": {"probes": "1"},
    "play-field": {"duration_s": "60"},
    "dut-moment": {"rest_s": "2"},
    "current-coupling": {"repeats": "2"},
    "repeat": {"times": "2"},
    "verify": {"positions": "5"},
    "rotate-axis": {"turns": "2"},
    "scalar-cage": {"n_directions": "24"},
}
