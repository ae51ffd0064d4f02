"""The shortest preflight that has every kind of step."""

SHORT = {
    "axes": "z",
    "modes": "nominal",
    "magnitudes_nT": "20000",
    "reverse": "no",
    "rate_deg_per_s": "20",
    "zero_s": "2",
    "dwell_s": "1",
}
