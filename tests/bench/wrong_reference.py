"""A lab whose reference, at the DUT's place, errs by draws of what bench.toml declares of it."""

import numpy as np

U_SCALE_PPM, U_ZERO_nT, U_ALIGN_deg = 50.0, 3.0, 0.02
DECLARED = ("u_offset_nT = 3.0", f"u_offset_nT = 3.0\nu_align_deg = {U_ALIGN_deg}")


def drawn(seed: int) -> tuple[float, np.ndarray, np.ndarray]:
    """Its scale, zero (3,) [nT] and turn (3,) [deg]."""
    rng = np.random.default_rng([seed, 77])
    return 1 + 1e-6 * U_SCALE_PPM * rng.normal(), U_ZERO_nT * rng.normal(size=3), U_ALIGN_deg * rng.normal(size=3)


def wrong_reference(seed: int) -> str:
    """The table [twin] of that lab."""
    scale, zero, turn = drawn(seed)
    stated = f"scale = {[scale] * 3}, bias_nT = {zero.tolist()}, misalignment_deg = {turn.tolist()}"
    return f"reference_place_m = [0.0, 0.0, 0.0]\nreference = {{ {stated}, noise_nT = 2.5, nT_per_unit = 6.6666667 }}"
