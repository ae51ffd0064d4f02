"""The calibration as JSON and as a MATLAB file, for ground software: what `c` has, in numbers."""

from __future__ import annotations

import json
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from labcal.certificate.flight.content import Content, Flown, stamps
from labcal.model import EffectRecord

MAT_TITLE = b"MATLAB 5.0 MAT-file, a labcal calibration".ljust(116)  # scipy writes the date there
FORMAT = "labcal-export/1"
CONVENTION = (
    "b = K m - k - sum of effects [nT, body axes]; m the reading; every effect takes a = K m - k and channels counted "
    "from reference_value; a reading stamped t is of the field at t - stamped_earlier_s; constant_u_nT: noise, misfit "
    "and what is left out"
)


def as_json(content: Content) -> bytes:
    """`labcal_calibration.json`."""
    return json.dumps(document(content), indent=1, allow_nan=False).encode() + b"\n"


def as_mat(content: Content) -> bytes:
    """`labcal_calibration.mat`, MATLAB 5: a struct `calibration` of the same; `covariance` is a matrix."""
    from scipy.io import savemat

    with TemporaryDirectory() as folder:
        path = Path(folder) / "calibration.mat"
        savemat(str(path), {"calibration": _for_matlab(document(content))}, long_field_names=True)
        return MAT_TITLE + path.read_bytes()[len(MAT_TITLE) :]


def document(content: Content) -> dict[str, Any]:
    """What both hold."""
    calibration, dut = content.calibration, content.calibration.dut
    validity, u = calibration.validity, np.sqrt(np.mean(content.constant_nT2))
    return {
        "format": FORMAT,
        "calibration_sha256": content.sha256,
        "status": content.status,
        "run_id": calibration.run_id,
        "simulated": calibration.simulated,
        "dut": {
            "serial": dut.serial,
            "model": dut.model,
            "unit": dut.unit,
            "nominal_nT_per_unit": dut.nominal_nT_per_unit,
        },
        "convention": CONVENTION,
        "K": calibration.affine.K.tolist(),
        "k_nT": calibration.affine.k_nT.tolist(),
        "stamped_earlier_s": float(content.lag_s),
        "effects": [_effect(one) for one in content.effects],
        "left_out": [
            {"effect": record.effect, "why": "bound to the run's own time", "u_nT": rms.tolist()}
            for record, rms in zip(content.left_out, content.left_out_nT, strict=True)
        ],
        "covariance": content.covariance.tolist(),
        "covariance_of": _names(content),
        "constant_u_nT": float(u) if np.isfinite(u) else None,
        "validity": {
            "field_nT": list(validity.field_nT),
            "temperature_C": None if validity.temperature_C is None else list(validity.temperature_C),
            "modes": list(validity.modes),
            "until": validity.until,
        },
        "not_covered": list(calibration.not_covered),
    }


def _effect(one: Flown) -> dict[str, Any]:
    form = one.effect.family.in_c
    return {
        "effect": one.record.effect,
        "formula": "" if form is None else form(one.effect.term).formula,
        "only_stamps": stamps(one.effect),
        "channels": list(one.record.channels),
        "reference_value": dict(one.record.reference_value),
        "parameters": [{"name": p.name, "value": p.value, "u": p.u, "unit": p.unit} for p in one.record.parameters],
        **_smooth(one.record),
    }


def _smooth(record: EffectRecord) -> dict[str, Any]:
    """Of a smooth function: what it depends on, its basis, where it was seen, outside of which it is left out."""
    if record.basis is None:
        return {}
    basis = record.basis
    return {
        "inputs": list(record.inputs),
        "basis": {
            "kind": basis.kind,
            "degree": basis.degree,
            "knots": [list(row) for row in basis.knots],
            "functions": [list(row) for row in basis.functions],
            "projection": [list(row) for row in basis.projection],
        },
        "domain": [{"inputs": list(d.inputs), "hull": [list(row) for row in d.hull]} for d in record.domain],
    }


def _names(content: Content) -> list[str]:
    of_the_map = [*(f"K_{a}{b}" for a in "xyz" for b in "xyz"), "k_x", "k_y", "k_z"]
    return of_the_map + [f"{i}:{p.name}" for i, one in enumerate(content.effects) for p in one.record.parameters]


def _for_matlab(value: Any) -> Any:
    """Lists of numbers as arrays, other lists as cells, None as an empty array; names that MATLAB has."""
    if isinstance(value, dict):
        return {
            "".join(c if c.isalnum() and c.isascii() else "_" for c in k)[:63]: _for_matlab(v) for k, v in value.items()
        }
    if isinstance(value, list):
        if value and all(isinstance(v, list | int | float) for v in value):
            return np.array(value, dtype=float)
        cells = np.empty((len(value), 1), dtype=object)
        cells[:, 0] = [_for_matlab(v) for v in value]
        return cells
    return np.zeros((0, 0)) if value is None else value
