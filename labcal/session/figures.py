"""The figures of a run's sensor (offsets, scales, angles between axes), worked out once and kept by what it holds."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from hashlib import sha256
from math import isfinite
from pathlib import Path

from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.fit import draft_calibration, fit
from labcal.model import Calibration
from labcal.session.sources import Source, is_path, run_bundle
from labcal.session.working_out import this_labcal
from labcal.store import Store
from labcal.uncertainty.conformity.change import SHOWN
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

FOLDER = "figures"
METHOD = "ml"


@dataclass(frozen=True, slots=True)
class SensorFigure:
    """A figure of a sensor with its standard uncertainty, None where not known; offsets in nT, scales in ppm."""

    quantity: str
    value: float
    u: float | None
    unit: str


def figures_of_run(run: Source) -> Mapping[str, SensorFigure]:
    """The figures that the maximum-likelihood fit gives, by name. Raises InputError where the run gives none."""
    kept = place_of(run)
    if (found := _kept(kept)) is not None:
        return found
    bundle = run_bundle(run)
    measured = bundle.run()
    found = figures_of_calibration(draft_calibration(measured, fit(measured, METHOD, holdout=False), bundle.sha256))
    own_folder(kept.parent)
    write_bytes(kept, json.dumps([asdict(one) for one in found.values()]).encode(), FILE)
    return found


def figures_of_calibration(calibration: Calibration) -> Mapping[str, SensorFigure]:
    """Those that stand in its map, by name."""
    found = {}
    for one in figures_of_the_map(calibration):
        factor, unit = SHOWN[one.figure]
        u = one.u / factor if isfinite(one.u) else None
        found[one.quantity] = SensorFigure(one.quantity, one.value / factor, u, unit)
    return found


def place_of(run: Source) -> Path:
    """Where they are kept, by what the run holds and the labcal that worked them out."""
    key = sha256(f"{_content_of(run)} {METHOD} {this_labcal()}".encode()).hexdigest()
    return home() / FOLDER / f"{key}.json"


def _content_of(run: Source) -> str:
    """What tells a run from every other: the head of its chain in the store, else the SHA-256 of its bundle."""
    if isinstance(run, str) and not is_path(run):
        with Store.open() as store:
            if (head := store.head_of(run)) is not None:
                return head
    return run_bundle(run).sha256


def _kept(place: Path) -> Mapping[str, SensorFigure] | None:
    try:
        return {one["quantity"]: SensorFigure(**one) for one in json.loads(place.read_bytes())}
    except (OSError, ValueError, TypeError, KeyError):
        return None
