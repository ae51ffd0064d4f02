"""Other people's calibrations as drafts: A and b of MATLAB's `magcal`, A⁻¹ and b of Magneto, parameters of autopilots.

`magcal` corrects rows, C = (D − b) A, so K = Aᵀ and k = Aᵀ b; Magneto columns, h = A⁻¹ (m − b), so K = A⁻¹ and
k = A⁻¹ b. A `.mat` file holds `A`, `b` and, where it has them, `expmfs`, `unit`, `serial`, `model`; a text the same as
`name = numbers` or `name: numbers`, Magneto's own words included. Nothing of their uncertainty is known, and the draft
says so.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.flight.parameter_files import AUTOPILOTS, parameters
from labcal.errors import InputError
from labcal.files.plain_file import read_limited
from labcal.model import AffineMap, Calibration, Validity
from labcal.record import Dut
from labcal.record.physical import LARGEST_NUMBER
from labcal.version import __version__

Array = NDArray[np.float64]
KINDS = ("magcal", "magneto", *AUTOPILOTS)
LARGEST_BYTES = 2**20
UNITS_nT = {"nT": 1.0, "uT": 1e3, "µT": 1e3, "mG": 1e2, "G": 1e5, "gauss": 1e5, "T": 1e9}
EARTH_nT = (15e3, 80e3)  # a field strength that is stated without its unit is the Earth's in one of these
LABEL = re.compile(r"\s*([A-Za-z][^=:\n]*?)\s*[=:](.*)")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
WANTED = "expected A (3x3) and b (3), each after its name: `A = …`, `b = …`; and `unit = uT` where it is not clear"
AXES = "axes: the sensor's own; no body frame is known"
AS_STATED = "unit as the file states"
UNKNOWN = "nothing of its uncertainty is known: the file states a matrix and an offset alone, and no run is there"


def read_foreign(path: Path, kind: str) -> Calibration:
    """The draft that a file of `kind` states. Raises InputError saying what is missing in it."""
    content = read_limited(path, LARGEST_BYTES)
    try:
        if kind in AUTOPILOTS:
            return _draft(parameters(content, kind), kind, content)
        stated = _mat(path) if content.startswith(b"MATLAB") or path.suffix.lower() == ".mat" else _text(content)
        return _draft(stated, kind, content)
    except InputError as error:
        raise InputError(f"{error.what}", file=path) from None


def _draft(stated: Mapping[str, Any], kind: str, content: bytes) -> Calibration:
    matrix, offset = _numbers(stated, "A", 9).reshape(3, 3), _numbers(stated, "b", 3)
    field = float(_numbers(stated, "expmfs", 1)[0]) if "expmfs" in stated else None
    unit_nT, why = _unit(stated, field, kind)
    K = (matrix.T if kind == "magcal" else matrix) * unit_nT
    strength = 0.0 if field is None else abs(field) * unit_nT
    digest = sha256(content).hexdigest()
    dut = Dut(
        str(stated.get("serial") or "not stated"),
        str(stated.get("model") or ""),
        "nT" if unit_nT == 1 else "count",
        unit_nT,
    )
    known = (
        f"it was made at {strength:.6g} nT" if strength else "no field strength is stated, so no row is in its range"
    )
    return Calibration(
        run_id=f"imported-{digest[:12]}",
        simulated=False,
        dut=dut,
        affine=AffineMap(K, K @ offset),
        covariance=None,
        frame_known=False,
        validity=Validity((strength, strength)),
        span_s=(0.0, 0.0),
        run_sha256=digest,
        metrics={"before": {}, "after": {}},
        software=f"labcal {__version__}",
        not_covered=(
            UNKNOWN,
            f"taken from {kind}; {known}",
            why,
            AXES,
            *(f"not taken: {x}" for x in stated.get("left", ())),
        ),
        made_by={"command": "import", "method": kind, "channels": None, "empirical": False, "version": __version__},
    )


def _unit(stated: Mapping[str, Any], field: float | None, kind: str) -> tuple[float, str]:
    """What one unit of the corrected field is [nT], and why."""
    if "unit" in stated:
        name = str(stated["unit"]).strip()
        if name not in UNITS_nT:
            raise InputError(f"unit {name[:20]!r} is none of {', '.join(UNITS_nT)}")
        return UNITS_nT[name], f"unit of {kind}'s parameters: {name}" if kind in AUTOPILOTS else f"{AS_STATED}: {name}"
    if field is not None:
        fitting = [u for u in ("nT", "uT", "mG", "G") if EARTH_nT[0] <= abs(field) * UNITS_nT[u] <= EARTH_nT[1]]
        if fitting:
            return UNITS_nT[
                fitting[0]
            ], f"no unit is stated: {field:g} is the Earth's field in {fitting[0]}, so it is taken"
        raise InputError(f"states no unit, and a field of {field:g} is the Earth's in none; add `unit = uT`")
    assumed = "uT" if kind == "magcal" else "nT"
    return UNITS_nT[assumed], f"no unit is stated: {assumed} is taken"


def _numbers(stated: Mapping[str, Any], name: str, count: int) -> Array:
    if name not in stated:
        raise InputError(f"{name} is missing: {WANTED}")
    try:
        if np.iscomplexobj(stated[name]):
            raise ValueError
        found = np.asarray(stated[name], dtype=float).ravel()
    except (TypeError, ValueError):
        raise InputError(f"{name} is no numbers, or complex ones: {WANTED}") from None
    if len(found) != count or not np.isfinite(found).all():
        raise InputError(f"{name} has {len(found)} numbers, not {count} finite ones: {WANTED}")
    if np.abs(found).max() > LARGEST_NUMBER:
        raise InputError(f"{name} has a number beyond {LARGEST_NUMBER:g}")
    return found


def _mat(path: Path) -> dict[str, Any]:
    from scipy.io import loadmat

    try:
        found = loadmat(str(path), appendmat=False, simplify_cells=True, variable_names=["A", "b", "expmfs", *WORDS])
    except Exception as error:  # a broken file makes the reader stumble in many ways
        raise InputError("is no MATLAB file that can be read (version 7.3 is HDF5: save with -v7)") from error
    return {name: value for name, value in found.items() if not name.startswith("__")}


def _text(content: bytes) -> dict[str, Any]:
    try:
        lines = content.decode("utf-8-sig").splitlines()
    except UnicodeDecodeError:
        raise InputError(f"is neither text nor a MATLAB file: {WANTED}") from None
    stated, name = dict[str, Any](), ""
    for number, line in enumerate(lines, start=1):
        rest = line.partition("%")[0].partition("#")[0]
        if label := LABEL.match(rest):
            name, rest = _named(label[1]), label[2]
            if not name:
                raise InputError(f"line {number}: {label[1][:30]!r} is not known here: {WANTED}")
            if name in stated:
                raise InputError(f"line {number}: states {name} twice")
            stated[name] = rest.strip().strip("'\"; ") if name in WORDS else []
        if name and name not in WORDS:
            stated[name] += NUMBER.findall(rest)
        elif not name and rest.strip():
            raise InputError(f"line {number}: stands before any name: {WANTED}")
    return stated


WORDS = ("unit", "serial", "model")


def _named(label: str) -> str:
    """What a label says: Magneto's `Combined bias (b)` and `… soft iron (A^-1)` too; "" for what is not known."""
    plain = label.strip()
    if plain.lower() in WORDS:
        return plain.lower()
    if plain == "A" or re.search(r"\bA\s*(\^\s*\(?-1\)?|⁻¹|-1)|^(Ainv|inv\(A\))$", plain):
        return "A"
    if plain.lower() in ("b", "bias") or plain.endswith("(b)"):
        return "b"
    return "expmfs" if plain.lower() in ("expmfs", "hm", "field", "norm") else ""
