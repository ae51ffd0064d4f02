"""Is a calibration in specification: by its own file, by limits chosen afterwards, or before it is written."""

from __future__ import annotations

from pathlib import Path

from labcal import session
from labcal.bench.specification import read_specification
from labcal.certificate.predecessor import changed_from
from labcal.errors import InputError
from labcal.fit import Fit, draft_calibration
from labcal.model import Calibration
from labcal.record import Run
from labcal.uncertainty.conformity import LEFT_OPEN, Assessment, Changes, assess, stated_lines


def fit_conformity(run: Run, found: Fit) -> Assessment | None:
    """The calibration that `found` makes of `run` beside its specification; None without one, or without a map."""
    if run.specification is None or not found.ok:
        return None
    return assess(draft_calibration(run, found, ""), run.specification, run)


def conformity(calibration: Path, specification: Path | None = None, run: session.Source | None = None) -> Assessment:
    """The lines of the specification that a calibration was measured under, or those of another, chosen afterwards.

    The other's noise, linearity and residual need the calibration's run, from the store or as named.
    """
    found = session.load_calibration(calibration)
    if specification is None:
        return _stated(found, calibration)
    asked = read_specification(specification, found.dut.model)
    return assess(found, asked, session.run_of(found) if run is None else _same_run(found, run))


def compare(calibration: Path, before: Path) -> Changes:
    """What changed from the calibration in `before` to a later one of the same DUT. Raises InputError for another."""
    return changed_from(session.load_calibration(calibration), before)


def _stated(found: Calibration, file: Path) -> Assessment:
    left_open = tuple(said for said in found.not_covered if said.startswith(LEFT_OPEN))
    if not found.specification and not left_open:
        raise InputError("was measured under no specification: name one with --specification FILE", file=file)
    return Assessment(stated_lines(found), left_open, found.k_means())


def _same_run(found: Calibration, run: session.Source) -> Run:
    bundle = session.run_bundle(run)
    if bundle.sha256 != found.run_sha256:
        raise InputError(f"run {found.run_id} as this calibration was made of it is another than {run}")
    return bundle.run()
