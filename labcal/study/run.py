"""A study from its file to its results: the jobs that the folder does not hold yet, then table, summary and report."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from labcal.certificate.report import write_report
from labcal.files.atomic import write_text
from labcal.files.outputs import Output, claim
from labcal.study import folder
from labcal.study.cluster import on_cluster
from labcal.study.engine import on_processes
from labcal.study.fleet import FETCHED, fetched
from labcal.study.job import Job, Row
from labcal.study.jobs import jobs_of
from labcal.study.page import study_page
from labcal.study.specification import FleetStudy, Simulated, read_study
from labcal.study.summary import Summary, summarise
from labcal.study.table import csv_text, has_parquet, write_parquet

TABLE, PARQUET, SUMMARY, REPORT = "table.csv", "table.parquet", "summary.json", "report.html"
Progress = Callable[[int, int], None]


@dataclass(frozen=True, slots=True)
class StudyResult:
    """What a study gave, and the files that it left."""

    summary: Summary
    jobs: int
    kept_before: int  # jobs that an earlier call had done
    without: int  # jobs that gave no result
    files: tuple[Path, ...]


def run_study(
    file: Path,
    out: Path,
    *,
    scheduler: str | None = None,
    processes: int | None = None,
    progress: Progress = lambda done, of: None,
    on_remark: Callable[[str], None] = lambda remark: None,
    force: bool = False,
) -> StudyResult:
    """Do every job of the study `file` that `out` does not hold yet, then write table, summary and report there.

    Raises InputError for a file that says nothing sensible, before the first job.
    """
    study = read_study(file)
    outputs = _claimed(out, file, force)
    if isinstance(study, FleetStudy) and study.archive is not None:
        study = fetched(study, file, out / FETCHED)
    jobs, remarks = jobs_of(study, file)
    for remark in remarks:
        on_remark(remark)
    folder.open_folder(out)
    rows = folder.done(out, jobs)
    before = len(rows)
    progress(before, len(jobs))
    left = [job for job in jobs if job.key not in rows]
    for number, (job, row) in enumerate(_engine(left, scheduler, processes, on_remark), before + 1):
        rows[job.key] = folder.keep(out, job, row)
        progress(number, len(jobs))
    table = [rows[job.key] for job in jobs]
    summary = summarise(study, jobs, table)
    _write(study, file, jobs, table, summary, remarks, outputs)
    without = sum(bool(row.get("why_not")) for row in table)
    return StudyResult(summary, len(jobs), before, without, tuple(o.path for o in outputs.values() if o.path.exists()))


def _claimed(out: Path, file: Path, force: bool) -> dict[str, Output]:
    names = (TABLE, SUMMARY, REPORT, *([PARQUET] if has_parquet() else []))
    found = claim("study", *(out / name for name in names), inputs=[file], force=force, with_folder=True)
    return dict(zip(names, found, strict=True))


def _engine(
    jobs: Sequence[Job], scheduler: str | None, processes: int | None, on_remark: Callable[[str], None]
) -> Iterator[tuple[Job, Row]]:
    if not jobs:
        return iter(())
    if scheduler is not None:
        return on_cluster(jobs, scheduler, on_remark)
    return on_processes(jobs, processes or os.cpu_count() or 1)


def _write(
    study: Simulated | FleetStudy,
    file: Path,
    jobs: Sequence[Job],
    rows: Sequence[Row],
    summary: Summary,
    remarks: list[str],
    outputs: dict[str, Output],
) -> None:
    """Table, summary and report, each whole or not at all."""
    table = [{**job.labels, **row} for job, row in zip(jobs, rows, strict=True)]
    said = {
        "format": "labcal-study-summary/1", "kind": study.kind, "jobs": len(jobs), "answer": summary.answer,
        "lines": summary.lines,
    }  # fmt: skip
    with outputs[TABLE].writing() as path:
        write_text(path, csv_text(table))
    if PARQUET in outputs:
        with outputs[PARQUET].writing() as path:
            write_parquet(table, path)
    with outputs[SUMMARY].writing() as path:
        write_text(path, json.dumps(said, indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    with outputs[REPORT].writing() as path:
        write_report(study_page(study, file.name, jobs, rows, summary, remarks), path)
