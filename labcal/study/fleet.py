"""A fleet of calibrations worked out again from their runs, and how far each would move, in units of its own U."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from labcal import loop, session
from labcal.certificate import looks_like_calibration
from labcal.errors import InputError
from labcal.files.home import home
from labcal.fit import draft_calibration
from labcal.fit.registry import methods
from labcal.loop.refit import refit
from labcal.model import Calibration, EffectRecord
from labcal.model.effects import find
from labcal.session.from_archive import calibrations_from_archive, runs_from_archive
from labcal.session.signing import CALIBRATIONS
from labcal.session.working_out import made_by, this_labcal, version, way_of, work_out
from labcal.store import Bundle, load_bundle
from labcal.study.job import Cell, Job, Row
from labcal.study.specification import FleetStudy
from labcal.uncertainty.conformity.change import SHOWN
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

COVERAGE = 2.0
FETCHED = "archive"  # in the folder of results


def fetched(study: FleetStudy, file: Path, folder: Path) -> FleetStudy:
    """The same study of what the archive holds, brought to `folder`. Raises InputError where that cannot be."""
    if study.runs or study.calibrations:
        raise InputError("archive: runs and calibrations come from there; leave out their folders", file=file)
    runs_from_archive(study.archive, folder / "runs")
    calibrations_from_archive(study.archive, folder / "calibrations")
    return study.model_copy(update={"runs": folder / "runs", "calibrations": folder / "calibrations"})


def fleet_jobs(study: FleetStudy) -> tuple[list[Job], list[str]]:
    """A job for each calibration whose run is at hand, by file name; remarks on those whose run is not."""
    _check_way(study)
    folder = study.calibrations or study.runs or home() / CALIBRATIONS
    files = list(_calibrations(folder))
    if not files:
        raise InputError("holds no calibration file", file=folder)
    there = _bundles(study.runs) if study.runs else {}
    jobs, without = [], []
    for file, stated in files:
        place = there.get(stated.run_sha256) if study.runs else _in_the_store(stated)
        if place is None:
            without.append(file.name)
        else:
            jobs.append(_job(study, file, folder, stated, place))
    if not jobs:
        where = study.runs or "this lab's store"
        raise InputError(f"none of its {len(files)} calibrations has its run in {where}", file=folder)
    return jobs, [f"{len(without)} calibrations whose run is not at hand: {', '.join(without)}"] if without else []


def _check_way(study: FleetStudy) -> None:
    if study.by not in ("as-made", "close-loop", *methods()):
        raise InputError(f"by: {study.by!r} is none of as-made, close-loop, {', '.join(methods())}")
    if study.effect is not None and find(study.effect.id) is None:
        raise InputError(f"effect: no installed package describes the effect {study.effect.id!r}")


def _job(study: FleetStudy, file: Path, folder: Path, stated: Calibration, place: str) -> Job:
    effect = None if study.effect is None else {"id": study.effect.id, "channels": list(study.effect.channels)}
    settings = {
        "calibration_sha256": _sha256(file), "run_sha256": stated.run_sha256, "by": study.by,
        "effect": effect, "version": this_labcal(),
    }  # fmt: skip
    labels: dict[str, Cell] = {
        "calibration": file.relative_to(folder).as_posix(), "serial": stated.dut.serial, "run": stated.run_id
    }  # fmt: skip
    return Job("fleet", settings, labels, {"calibration": str(file.resolve()), "run": place})


def _sha256(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def _calibrations(folder: Path) -> Iterator[tuple[Path, Calibration]]:
    """Every calibration below `folder`, by name; what is another JSON file is passed over."""
    if not folder.is_dir():
        raise InputError("is no folder", file=folder)
    for file in sorted(folder.rglob("*.json")):
        if file.name == "run.json" or not looks_like_calibration(file):
            continue
        try:
            yield file, session.load_calibration(file)
        except InputError as error:
            if b'"labcal-calibration/' in file.read_bytes():
                raise error from None


def _bundles(folder: Path) -> dict[str, str]:
    """Where the bundles below `folder` lie, by their SHA-256."""
    if not folder.is_dir():
        raise InputError("is no folder", file=folder)
    places = [*(file.parent for file in folder.rglob("run.json")), *folder.rglob("*.zip")]
    return {load_bundle(place).sha256: str(place.resolve()) for place in sorted(places)}


def _in_the_store(stated: Calibration) -> str | None:
    try:
        return stated.run_id if session.run_bundle(stated.run_id).sha256 == stated.run_sha256 else None
    except InputError:
        return None


def worked_out_again(settings: Mapping[str, Any], places: Mapping[str, str]) -> Row:
    """One calibration as it stands beside what this version makes of its run."""
    file = Path(places["calibration"])
    stated, bundle = session.load_calibration(file), session.run_bundle(places["run"])
    if bundle.sha256 != settings["run_sha256"] or _sha256(file) != settings["calibration_sha256"]:
        raise InputError("changed, or its run did, since the study began", file=file)
    made = _made(stated, bundle, settings)
    return {"why_not": "", "effects": _effects(made), "effects_before": _effects(stated), **_moved(stated, made)}


def _made(stated: Calibration, bundle: Bundle, settings: Mapping[str, Any]) -> Calibration:
    if (effect := settings["effect"]) is not None:
        return _with_effect(stated, bundle, effect["id"], tuple(effect["channels"]))
    if settings["by"] == "as-made":
        return work_out(bundle, {**way_of(stated), "version": version()}, lambda step: None)
    looped = settings["by"] == "close-loop"
    how = made_by("close-loop", "ml") if looped else made_by("fit", settings["by"])
    return work_out(bundle, how, lambda step: None)


def _with_effect(stated: Calibration, bundle: Bundle, effect: str, channels: tuple[str, ...]) -> Calibration:
    """The map with the effects that are stated and this one, unless it is among them."""
    run = bundle.run()
    had = [e for e in (*stated.effects, *stated.findings) if e.belongs_to != "data"]
    more = [] if any((e.effect, e.channels) == (effect, channels) for e in had) else [_record(run, effect, channels)]
    found = refit(run, [*had, *more])
    return draft_calibration(run, replace(found, method="fleet"), bundle.sha256)


def _record(run: Any, effect: str, channels: tuple[str, ...]) -> EffectRecord:
    return loop.one_cause(run, effect, channels).record


def _effects(calibration: Calibration) -> str:
    found = (*calibration.effects, *calibration.findings)
    return "; ".join(" ".join((e.effect, *e.channels)) for e in found if e.belongs_to != "data")


def _moved(old: Calibration, new: Calibration) -> Row:
    """Each figure's change in its unit and in U (k = 2) of the calibration that stands; the worst of them by name."""
    row, in_U = Row(), dict[str, float]()
    for a, b in zip(figures_of_the_map(old), figures_of_the_map(new), strict=True):
        factor, unit = SHOWN[a.figure]
        row[f"{a.quantity} change ({unit})"] = (b.value - a.value) / factor
        U = COVERAGE * a.u
        row[f"{a.quantity} change (U)"] = (b.value - a.value) / U if U > 0 else None
        if U > 0:
            in_U[a.quantity] = (b.value - a.value) / U
    worst = max(in_U, key=lambda name: abs(in_U[name])) if in_U else None
    return {"worst": worst, "worst_change_U": in_U[worst] if worst else None, **row}
