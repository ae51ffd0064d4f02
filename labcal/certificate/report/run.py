"""The report of a run: what was recorded, what it covers, and what a maximum-likelihood fit leaves."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.report.calibration import headline_of, name_of
from labcal.certificate.report.figures import (
    MOST_POINTS,
    NEAR_DEG,
    coverage,
    draw_by_segment,
    draw_magnitude,
    draw_residual,
    draw_sphere,
)
from labcal.certificate.report.harmonics import on_the_sphere
from labcal.certificate.report.page import Block, Facts, Headline, Page, Plot, Prose, Table, section, sections
from labcal.certificate.report.style import number
from labcal.fit import Fit
from labcal.fit.metrics import vector_residual
from labcal.record import Run, Segment, offers
from labcal.uncertainty.unstated import not_covered

Array = NDArray[np.float64]


def run_page(run: Run, run_sha256: str, fit: Fit, chain: Mapping[str, Any] | None = None) -> Page:
    """The page of `run`; `fit` is the maximum-likelihood fit (its `ok` may be False, and the page says why)."""
    field = fit.affine.apply(run.reading) if fit.affine else None
    residual, labels = _residual(run, fit, field)
    return Page(
        kind="Run",
        title=run.run_id,
        subtitle=name_of(run.dut),
        simulated=run.simulated,
        summary="" if fit.ok else f"No fit: {fit.why_not}.",
        headline=_headline(run, residual, labels),
        facts=_facts(run, run_sha256, chain),
        sections=sections(
            section("Coverage", _coverage(run, field)),
            section("Field magnitude", [Plot(lambda f: draw_magnitude(f, run, field), 2.3, _thin_note(run))]),
            section("What the fit leaves", _left(run, residual, labels)),
            section("Segments", [_segments(run)]),
            section("Housekeeping", [_channels(run)]),
            section("What is not covered", [Prose(not_covered(run))]),
        ),
        footer="Residual r = b − p: calibrated reading minus the reference carried into the sensor's axes.",
    )


def _residual(run: Run, fit: Fit, field: Array | None) -> tuple[Array | None, tuple[str, ...]]:
    """The residual vector (n, 3) where every row offers one, else that of the magnitude (n, 1)."""
    if field is None or run.reference.kind == "none":
        return None, ()
    if (left := vector_residual(run, fit)) is not None:
        return left, ("x", "y", "z")
    return (np.linalg.norm(field, axis=1) - run.magnitude_nT)[:, None], ("|b|",)


def _headline(run: Run, residual: Array | None, labels: tuple[str, ...]) -> Headline | None:
    if residual is None:
        return None
    raw = np.linalg.norm(run.reading_nT, axis=1) - run.magnitude_nT
    fitted = residual[:, 0]
    if len(labels) == 3:
        return None  # the raw vector has no common frame with the reference before the phases are known
    return headline_of(_rms(raw), _rms(fitted), "magnitude against the reference, rms: raw → after the fit")


def _coverage(run: Run, field: Array | None) -> list[Block]:
    shown = run.reading_nT if field is None else field
    share = coverage(shown)
    words = f"{share:.0%} of all directions lie within {NEAR_DEG:.0f}° of a measured one."
    caption = "Direction of the field in the sensor's axes, equal-area map centred on +x (−x at both ends)."
    return [Prose((words,)), Plot(lambda f: draw_sphere(f, run, shown), 2.9, caption)]


def _left(run: Run, residual: Array | None, labels: tuple[str, ...]) -> list[Block | None]:
    if residual is None:
        return [Prose(("There is no fit, so nothing is left to show.",))]
    rms = _rms(np.linalg.norm(residual, axis=1))
    what = "length of the residual vector" if len(labels) == 3 else "residual of the magnitude"
    noise = run.dut.noise_nT
    declared = f"; the sensor's declared noise alone gives {number(noise * np.sqrt(len(labels)))} nT" if noise else ""
    return [
        Prose((f"In sample, the {what} has an rms of {number(rms)} nT{declared}.",)),
        Plot(
            lambda f: draw_residual(f, run, residual, labels),
            2.5,
            "Residual over time, and its distribution. " + _thin_note(run),
        ),
        on_the_sphere(run, residual),
        Plot(lambda f: draw_by_segment(f, run, residual, noise), 1.9, "Rms of the residual in each segment."),
    ]


def _facts(run: Run, run_sha256: str, chain: Mapping[str, Any] | None) -> Facts:
    noise = "not stated" if run.dut.noise_nT is None else f"{run.dut.noise_nT:g} nT, one axis, one sample"
    return Facts(
        (
            ("Started (UTC)", run.started_utc),
            ("Operator", run.operator or "–"),
            ("Sensor", name_of(run.dut)),
            ("Reads in", run.dut.unit if run.dut.unit == "nT" else f"counts, {run.dut.nominal_nT_per_unit:g} nT each"),
            ("Noise", noise),
            ("Reference", f"{run.reference.kind} {run.reference.serial}".strip()),
            ("Samples", number(len(run), 0)),
            ("Lasted", f"{number(float(run.t_s[-1] - run.t_s[0]))} s" if len(run) else "–"),
            ("SHA-256", run_sha256),
            ("Head of its chain", f"{chain['head']}, {chain['rows']} rows" if chain else "origin not shown"),
        )
    )


def _segments(run: Run) -> Table:
    rows = [_segment_row(run, index, segment) for index, segment in enumerate(run.segments)]
    header: tuple[str, ...] = ("Segment", "Kind", "Offers", "Mode", "Axis in body", "Samples", "|ref| (µT)", "Note")
    if not any(segment.note for segment in run.segments):
        header, rows = header[:-1], [row[:-1] for row in rows]
    return Table(header, tuple(rows), frozenset({5, 6}))


def _segment_row(run: Run, index: int, segment: Segment) -> tuple[str, ...]:
    rows = run.rows(index)
    magnitude = "–"
    if run.reference.kind != "none" and np.isfinite(run.magnitude_nT[rows]).any():
        magnitude = number(float(np.nanmean(run.magnitude_nT[rows])) / 1000, 2)
    axis = "–" if segment.axis_body is None else " ".join(f"{v:g}" for v in np.round(segment.axis_body, 4))
    offered = offers(run, segment)
    return segment.id, segment.kind, offered, segment.mode or "–", axis, number(len(rows), 0), magnitude, segment.note


def _channels(run: Run) -> Table | None:
    rows = tuple(
        (c.name, c.quantity, c.role, number(_least(c.values), 3), number(_most(c.values), 3), c.unit)
        for c in run.channels
    )
    return Table(("Channel", "Quantity", "Of", "Least", "Most", "Unit"), rows, frozenset({3, 4})) if rows else None


def _thin_note(run: Run) -> str:
    every = -(-len(run) // MOST_POINTS)
    return f"Every {every}th sample is drawn." if every > 1 else "Faint lines part the segments."


def _least(values: Array) -> float | None:
    return float(np.nanmin(values)) if np.isfinite(values).any() else None


def _most(values: Array) -> float | None:
    return float(np.nanmax(values)) if np.isfinite(values).any() else None


def _rms(values: Array) -> float:
    seen = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(seen**2))) if len(seen) else float("nan")
