"""Settings with which each procedure does all that it does, and is soon over."""

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
