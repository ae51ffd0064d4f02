"""What the catalogue says of a run and of a calibration: rows, a dict for each, without their site."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict
from datetime import UTC, datetime
from math import isfinite
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.model import Calibration, EffectRecord
from labcal.model.affine import MAP_PARAMETERS
from labcal.record import Dut, Run
from labcal.uncertainty.conformity.change import SHOWN
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

Row = dict[str, Any]
INSTRUMENT = ("name", "manufacturer", "model", "serial", "firmware")


def run_row(run: Run, status: str, procedure: str) -> Row:
    """A run, without what its bundle says."""
    return {
        "run_id": run.run_id,
        "started_utc": utc(run.started_utc),
        "status": status,
        **_sensor(run.dut, run.simulated),
        "operator": run.operator,
        "procedure": procedure,
        "reference_kind": run.reference.kind,
        "reference_serial": run.reference.serial,
        "n_samples": len(run),
    }


def instruments_of_run(run: Run, recorded: Iterable[Mapping[str, str]]) -> list[Row]:
    """The reference as number 0, then what the record of the run names."""
    reference = {"name": "reference", **asdict(run.reference)}
    return _instruments([*([] if run.reference.kind == "none" else [reference]), *recorded])


def instruments_of_calibration(calibration: Calibration) -> list[Row]:
    """The instruments that it names."""
    return _instruments([{"name": one.get("role", "instrument"), **one} for one in calibration.instruments])


def calibration_row(calibration: Calibration) -> Row:
    """A calibration, without its bytes."""
    issued = calibration.issued_utc
    return {
        "run_sha256": calibration.run_sha256,
        "run_id": calibration.run_id,
        **_sensor(calibration.dut, calibration.simulated),
        "operator": calibration.operator,
        "issued_utc": utc(issued) if issued else None,
        "number": calibration.number,
        "supersedes": calibration.supersedes,
    }


def effect_rows(calibration: Calibration) -> list[Row]:
    """Every effect that was found, the sensor's first, then those of the rig and the data."""
    return [
        {
            "number": number,
            "effect": one.effect,
            "belongs_to": one.belongs_to,
            "channels": " ".join(one.channels),
            "provisional": one.provisional,
            "p_value": one.p_value,
        }
        for number, one in enumerate(_found(calibration))
    ]


def parameter_rows(calibration: Calibration) -> list[Row]:
    """K and k, the figures that `labcal compare` shows, and every effect's parameters, with their standard u."""
    rows = [*_of_the_map(calibration), *_figures(calibration)]
    rows += [_parameter(e.effect, p.name, p.value, p.u, p.unit) for e in _found(calibration) for p in e.parameters]
    return [{"number": number, **row} for number, row in enumerate(rows)]


def utc(stated: str) -> datetime:
    """The moment that an ISO 8601 text states; without a zone it is UTC. Raises InputError."""
    try:
        moment = datetime.fromisoformat(stated)
    except ValueError:
        raise InputError(f"{stated!r} is no date such as 2026-11-23") from None
    return moment if moment.tzinfo else moment.replace(tzinfo=UTC)


def _sensor(dut: Dut, simulated: bool) -> Row:
    unit = dut.unit if dut.unit == "nT" else f"count of {dut.nominal_nT_per_unit:g} nT"
    return {"simulated": simulated, "dut_serial": dut.serial, "dut_model": dut.model, "dut_unit": unit}


def _instruments(stated: Sequence[Mapping[str, Any]]) -> list[Row]:
    return [{"number": n} | {key: str(one.get(key) or "") for key in INSTRUMENT} for n, one in enumerate(stated)]


def _found(calibration: Calibration) -> tuple[EffectRecord, ...]:
    return (*calibration.effects, *calibration.findings)


def _of_the_map(calibration: Calibration) -> Iterator[Row]:
    joint = calibration.covariance
    u = [None] * len(MAP_PARAMETERS) if joint is None else np.sqrt(np.maximum(np.diag(joint)[:12], 0.0)).tolist()
    units = (*[f"nT/{calibration.dut.unit}"] * 9, *["nT"] * 3)
    for name, value, u_one, unit in zip(MAP_PARAMETERS, calibration.affine.parameters, u, units, strict=True):
        yield _parameter("map", name, value, u_one, unit)


def _figures(calibration: Calibration) -> Iterator[Row]:
    for one in figures_of_the_map(calibration):
        factor, unit = SHOWN[one.figure]
        yield _parameter("figure", one.quantity, one.value / factor, one.u / factor, unit)


def _parameter(of: str, name: str, value: float, u: float | None, unit: str) -> Row:
    known = u is not None and isfinite(u)
    return {
        "of": of,
        "name": name,
        "value": float(value),
        "u": float(u) if known and u is not None else None,
        "unit": unit,
    }
