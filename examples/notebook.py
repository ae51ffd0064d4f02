"""A calibration from a notebook: every cell uses the public face of labcal (docs/api.md) and nothing else.

The cells (`# %%`) run one by one in VS Code, Spyder or, with Jupytext, Jupyter; `python examples/notebook.py` runs them
all. Everything is simulated: the lab, and an effect in the sensor that its seed picks and nobody is told.
"""

# %% Measure: a short preflight on the simulated lab
import tempfile
from pathlib import Path

import numpy as np

import labcal

outcome = labcal.run(
    "preflight",
    settings={"magnitudes_nT": (20_000, 50_000), "modes": "nominal", "reverse": "no", "timing_nT": 1_000, "zero_s": 2},
    seed=5,
)
print(outcome.run_id, outcome.status, outcome.at_rest)

# %% Look: arrays, in the units of their names
run = labcal.load_run(outcome.run_id, channels=["temp_dut", "i_radio"])
print(len(run), "readings of", run.dut.serial, "about", ", ".join(segment.id for segment in run.segments))
print(f"reference {run.magnitude_nT.min():.0f} to {run.magnitude_nT.max():.0f} nT")

# %% Fit: scale, non-orthogonality, misalignment and bias
found = labcal.fit(run)
u = np.sqrt(np.diag(found.covariance))
print("K =", np.array2string(found.affine.K, precision=5), sep="\n")
for axis, k, u_k in zip("xyz", found.affine.k_nT, u[9:], strict=True):
    print(f"k_{axis} = {k:.1f} nT, u = {u_k:.1f} nT")
print(f"left over: {found.rms_scalar_nT:.1f} nT, and the noise is {run.dut.noise_nT} nT an axis")

# %% Close the loop: what is left over, and why
folder = Path(tempfile.mkdtemp(prefix="labcal-"))
closed = labcal.close_loop(run, out=folder / "cal.json")
print(closed.summary)
print(f"held out: {closed.before.holdout_rms_nT:.1f} nT before, {closed.after.holdout_rms_nT:.1f} nT after")
for cause in closed.accepted:
    for p in cause.parameters:
        print(f"{' '.join((cause.effect, *cause.channels))}: {p.name} = {p.value:.4g} ± {p.u:.2g} {p.unit}")

# %% Apply: readings in, field out
calibration = labcal.load_calibration(folder / "cal.json")
applied = calibration.apply(run)
error_nT = np.linalg.norm(applied.field_nT, axis=1) - run.magnitude_nT
print(f"|b| less the reference: {np.sqrt(np.nanmean(error_nT**2)):.1f} nT rms; u = {np.median(applied.u_nT):.1f} nT")

# %% Verify: nobody has signed this draft yet (`labcal approve`, `labcal sign`)
result = labcal.verify(folder / "cal.json")
print(*result.sentences())
