"""The example's bench with a scalar reference: what is replaced in its text, and the sensor's truth in the twin."""

import numpy as np

ROWS = ("[49942.0, -221.0, 169.0]", "[-301.0, 49951.0, 101.0]", "[-179.0, 151.0, 49944.0]")
NOMINAL = f"matrix_nT_per_A = [\n    {ROWS[0]},\n    {ROWS[1]},\n    {ROWS[2]},\n]"
SCALAR = [
    ('kind = "vector"\nnoise_nT = 3.2 # noise and the step of its converter', 'kind = "scalar"\nnoise_nT = 0.1'),
    ("u_scale_ppm = 50.0\nu_offset_nT = 3.0", "u_scale_ppm = 1.0"),
    ('driver = "hmr2300"', 'driver = "text-line"'),
    ("settings = { rate = 20 }", 'settings = { columns = ["f"] }'),
    (NOMINAL, "constants_nT_per_A = 50000.0"),
]


def sensor(seed: int) -> str:
    """The table [twin] with a scalar sensor whose scale errs by a draw of what is declared."""
    scale = 1 + 1e-6 * np.random.default_rng([seed, 5]).normal()
    return f"reference = {{ noise_nT = 0.1, nT_per_unit = 0.01, bandwidth_hz = 1.0, scale = {[scale] * 3} }}"
