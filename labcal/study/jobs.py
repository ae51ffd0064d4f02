"""The jobs of a study, in their order, each checked before the first begins."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from labcal.bench.config import BenchConfig, sentence
from labcal.bench.parameters import settings as checked_settings
from labcal.demo import simulated_bench
from labcal.errors import InputError
from labcal.files.toml_file import named_files, read_toml
from labcal.fit.registry import methods
from labcal.runner import find
from labcal.runner.catalogue import FoundProcedure
from labcal.session.working_out import this_labcal
from labcal.study.fleet import fleet_jobs
from labcal.study.grid import PROCEDURE, GridPoint, merged, points
from labcal.study.job import Cell, Job, canonical
from labcal.study.optimal import MOST
from labcal.study.specification import MOST_JOBS, Blind, Design, FleetStudy, MonteCarlo, Simulated, texts
from labcal.twin import open_twin

Table = Mapping[str, Any]


def jobs_of(study: Simulated | FleetStudy, file: Path) -> tuple[list[Job], list[str]]:
    """All jobs in the order of the table, and remarks on what makes none. Raises InputError naming `file`."""
    if isinstance(study, FleetStudy):
        return fleet_jobs(study)
    try:
        return list(_simulated(study, file)), []
    except ValidationError as error:  # a ValueError too
        fault = error.errors()[0]
        name, said = ".".join(("lab", *map(str, fault["loc"]))), sentence(fault)
        raise InputError(f"{name}{' ' if said.startswith(('is ', 'must ')) else ': '}{said}", file=file) from None
    except ValueError as error:
        raise (error if isinstance(error, InputError) and error.file else InputError(str(error), file=file)) from None


def _simulated(study: Simulated, file: Path) -> Iterator[Job]:
    bench, grid = _bench(study.bench), points(study.grid)
    asked = list(_asked(study))
    if (number := len(grid) * len(study.all_seeds) * len(asked)) > MOST_JOBS:
        raise InputError(f"is a study of {number} jobs; at most {MOST_JOBS} are meant", file=file)
    for point in grid:
        procedure = find(_procedure(study, str(point.changes.get(PROCEDURE, study.procedure)), file))
        common = {**_common(study, procedure, bench, point), "version": this_labcal()}
        for more in asked:
            for seed in study.all_seeds:
                labels: dict[str, Cell] = {**point.labels, **more, "seed": seed}
                yield Job(study.kind, {**common, **more, "seed": seed}, labels)


def _procedure(study: Simulated, named: str, file: Path) -> str:
    """Its name; a file of one's own counts from the study's folder."""
    if isinstance(study, Design) and named != "preflight":
        raise InputError("procedure: a design is chosen from the rotations of a preflight", file=file)
    return str((file.parent / named).resolve()) if named.endswith(".py") else named


def _asked(study: Simulated) -> list[dict[str, Cell]]:
    """What each seed at each point is asked: one accuracy after the other."""
    return [{"accuracy_deg": deg} for deg in study.accuracies_deg] if isinstance(study, Design) else [{}]


def _common(study: Simulated, procedure: FoundProcedure, bench: Table, point: GridPoint) -> dict[str, Any]:
    """What all seeds at one point share, checked."""
    stated = merged({"lab": study.lab, "settings": study.settings}, point.changes)
    table, given = merged(bench, stated["lab"]), texts(stated["settings"])
    _check_bench(table)
    values = checked_settings(procedure.parameters, given)
    out: dict[str, Any] = {
        "bench": table, "procedure": str(procedure.source) if procedure.own else procedure.name,
        "procedure_sha256": procedure.sha256, "given": given,
    }  # fmt: skip
    if isinstance(study, Blind):
        out["bench"] = merged(table, {"twin": {"surprise": True, "effects": {}}})
    if isinstance(study, MonteCarlo | Design):
        out["field_nT"] = study.field_nT
    if isinstance(study, MonteCarlo):
        if study.method not in methods():
            raise ValueError(f"method: there is no method {study.method!r}; the methods are {', '.join(methods())}")
        out["method"] = study.method
    if isinstance(study, Design):
        _refuse_too_many(values)
        out["mount_s"] = study.mount_s
    return out


def _refuse_too_many(values: Mapping[str, Any]) -> None:
    fields = len(values["magnitudes_nT"]) + bool(values["reverse"])
    if (number := len(values["axes"]) * fields * len(values["modes"])) > MOST:
        raise ValueError(f"settings: a preflight of {number} rotations; a design is chosen from at most {MOST}")


def _bench(path: Path | None) -> Table:
    """The bench file's table; that of the demo without the effect that it hides, which only a blind trial wants."""
    place = path or simulated_bench()
    if others := [str(file) for file in named_files(place)[1:]]:
        raise InputError(f"names another file ({others[0]}): a study's bench stands alone", file=place)
    table = read_toml(place)[1]
    return table if path else merged(table, {"twin": {"surprise": False}})


def _check_bench(table: Table) -> None:
    """Raise ValueError or InputError unless it is a bench whose links are all emulated, with a lab behind them."""
    try:
        canonical(table)  # no dates, no numbers that are none
    except (TypeError, ValueError) as error:
        raise ValueError(f"lab: {error}") from None
    config = BenchConfig.model_validate(table)
    if not config.simulated:
        raise InputError("a study runs on a simulated bench alone: every link must be emulated://")
    open_twin(table.get("twin", {}), 0)
