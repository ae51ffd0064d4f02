"""`labcal charts`, `rr`, `intervals` and `intercompare`: what a lab asks over the years."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console, say, say_lines
from labcal.errors import InputError
from labcal.files.outputs import claim

if TYPE_CHECKING:
    from labcal.bench.check_standard import CheckStandardConfig
    from labcal.certificate.report import Page
    from labcal.certificate.report.page import Table
    from labcal.years.history import Calibrated

TOO_MUCH = 30.0  # percent of the total variation, beyond which a gage is not fit (AIAG)
PANEL = "Years"
FORMS = (".html", ".pdf", ".png")
OUT = typer.Option(None, "--out", metavar="FILE", help="A page, .html or .pdf; its figures alone as .png.")
ARCHIVE = typer.Option(None, "--archive", metavar="URL", help="Ask the archive, not this lab's folder.")


@app.command(rich_help_panel=PANEL)
def charts(
    serial: str | None = typer.Argument(None, metavar="[SERIAL]", help="A DUT that is measured again and again."),
    bench: Path | None = typer.Option(None, help=r"The bench file whose \[check_standard] is meant; its settings too."),
    repeats: int = typer.Option(1, min=1, max=50, help="Runs that are one point; a bench file states its own."),
    baseline: int = typer.Option(20, min=8, max=1000, help="Points that the limits are made of."),
    archive: str | None = typer.Option(
        None,
        metavar="URL",
        help="Runs of the archive, of all benches, not of the store: postgresql://USER@HOST/DATABASE.",
    ),
    json: str | None = JSON,
    out: Path | None = OUT,
    force: bool = FORCE,
) -> int:
    """Show the control charts of a check standard. Exit code 1: it is out of control at its last point.

    Means and standard deviations, or single values and moving ranges (ISO 7870-2), with the Western Electric rules.
    """
    read = [bench] if bench is not None else []
    _claim("charts", json, out, read, force=force)
    from labcal.session.check_standard import charts as charts_of
    from labcal.session.check_standard import charts_of_bench
    from labcal.years.documents import charts_document
    from labcal.years.pages import charts_page

    if bench is not None and archive is not None:
        raise InputError("the archive does not know which bench a run was recorded on: say a SERIAL with --archive")
    if bench is not None and serial is None:
        found = charts_of_bench(bench)
    elif serial is not None and bench is None:
        found = charts_of(_stated(serial, repeats, baseline), archive=archive)
    else:
        raise InputError("say a SERIAL, or --bench FILE whose check standard is meant")
    if not found.points:
        place = "store" if archive is None else "archive"
        raise InputError(f"the {place} has no finished run of {found.serial} by {found.stated.procedure}")
    _give("charts", charts_document(found), charts_page(found), json, out, read, force=force)
    return NEGATIVE if found.out else DONE


@app.command(rich_help_panel=PANEL)
def rr(
    runs: list[str] | None = typer.Argument(None, metavar="[RUN]...", help="Runs of the store, or bundles."),
    table: Path | None = typer.Option(
        None, metavar="FILE.csv", help="Values instead: columns dut, operator, mounting, value."
    ),
    quantity: str | None = typer.Option(None, help="The figure of the runs (offset x), or what the table has."),
    tolerance: float | None = typer.Option(None, metavar="WIDTH", help="Width of the tolerance, in the figure's unit."),
    json: str | None = JSON,
    out: Path | None = OUT,
    force: bool = FORCE,
) -> int:
    """Gage R&R by a crossed ANOVA: DUT, operator, mounting. Exit code 1: more than 30 % of all variation is the gage's.

    Factors of one level are left out. Intervals are 95 %.
    """
    from labcal import session

    read = [*([table] if table else []), *(path for run in runs or () for path in session.paths(run))]
    _claim("rr", json, out, read, force=force)
    if bool(runs) == (table is not None):
        raise InputError("say the runs of the study, or --table FILE.csv")
    if tolerance is not None and not 0 < tolerance < float("inf"):
        raise InputError(f"--tolerance is a width larger than zero, not {tolerance:g}")
    from labcal.years.documents import study_document
    from labcal.years.pages import study_page
    from labcal.years.study_of_gage import rows_of_runs, rows_of_table, studied

    named = quantity or ("value" if table else "offset x")
    rows, unit, simulated = (rows_of_table(table), "", False) if table else rows_of_runs(runs or [], named, _working)
    if not rows:
        raise InputError("has no rows", file=table)
    study = studied(rows, named, unit, tolerance, simulated=simulated)
    _give("rr", study_document(study), study_page(study), json, out, read, force=force)
    return NEGATIVE if study.found.percent_rr > TOO_MUCH else DONE


@app.command(rich_help_panel=PANEL)
def intervals(
    serial: str = typer.Argument(..., metavar="SERIAL", help="The sensor."),
    calibrations: list[Path] | None = typer.Argument(
        None, metavar="[CAL]...", help="Its calibrations, files or folders; none: those of this lab's folder."
    ),
    permitted: list[str] = typer.Option(
        [], metavar="'FIGURE=CHANGE UNIT'", help="What may change until the next calibration: 'offset=20 nT'."
    ),
    every: float | None = typer.Option(
        None, min=1, max=36_525, metavar="DAYS", help="The interval that holds now; else that between the last two."
    ),
    archive: str | None = ARCHIVE,
    json: str | None = JSON,
    out: Path | None = OUT,
    force: bool = FORCE,
) -> int:
    """Show how each figure drifts and when to calibrate again (ILAC-G24). Exit code 1: one moved more than permitted.

    Four methods side by side: staircase, control chart, in-use time, drift with its interval.
    """
    read = list(calibrations or ())
    _claim("intervals", json, out, [path for path in read if path.is_file()], force=force)
    from labcal.years.documents import trend_document
    from labcal.years.history import of_one_sensor
    from labcal.years.pages import trend_page
    from labcal.years.trend import as_permitted, trends

    limits = as_permitted(permitted)
    mine = of_one_sensor(_history(read, archive, serial), serial)
    found = trends(mine, limits, every)
    page = trend_page(serial, found, [one.utc for one in mine], mine[0].simulated)
    _give("intervals", trend_document(serial, found), page, json, out, read, force=force)
    moved = [t for t in found if (limit := limits.get(t.quantity) or limits.get(t.quantity.split()[0])) is not None
             and abs(t.values[-1] - t.values[-2]) > limit[0]]  # fmt: skip
    return NEGATIVE if moved else DONE


@app.command(rich_help_panel=PANEL)
def intercompare(
    results: list[str] = typer.Argument(
        ...,
        metavar="BENCH=CAL...",
        help="A travelling standard's calibration by each bench; a bench may have several.",
    ),
    pilot: str | None = typer.Option(
        None,
        metavar="BENCH",
        help="The reference is this bench's; three of its calibrations show the standard's drift.",
    ),
    json: str | None = JSON,
    out: Path | None = OUT,
    force: bool = FORCE,
) -> int:
    """Compare benches by a travelling standard: E_n of each figure. Exit code 1: one is beyond ±1."""
    named = [_bench_and_file(one) for one in results]
    files = [path for _, path in named]
    _claim("intercompare", json, out, files, force=force)
    from labcal.years.comparison_page import comparison_page
    from labcal.years.documents import comparison_document
    from labcal.years.history import from_files
    from labcal.years.trend import compared

    each = [from_files([path])[0] for path in files]
    if len({one.simulated for one in each}) > 1:
        raise InputError("simulated and real calibrations say nothing of each other")
    found = compared([bench for bench, _ in named], each, pilot)
    page = comparison_page(each[0].serial, found, each[0].simulated)
    _give("intercompare", comparison_document(each[0].serial, found), page, json, out, files, force=force)
    beyond = any(abs(d.e_n) > 1 for _, one in found.values() for d in one.degrees if d.e_n is not None)
    return NEGATIVE if beyond else DONE


@app.command(rich_help_panel=PANEL)
def fleet(
    calibrations: list[Path] | None = typer.Argument(
        None, metavar="[CAL]...", help="Files or folders; none: this lab's folder."
    ),
    archive: str | None = ARCHIVE,
    model: str | None = typer.Option(None, help="Of this model alone."),
    batch: str | None = typer.Option(
        None, metavar="REGEX", help="Its group is the batch, in a serial; else all but its last number."
    ),
    json: str | None = JSON,
    out: Path | None = OUT,
    force: bool = FORCE,
) -> int:
    """Report on many sensors by model and batch: effects, who stands out, how figures are spread; the worst first.

    Batches are estimated together, by partial pooling.
    """
    read = list(calibrations or ())
    _claim("fleet", json, out, [path for path in read if path.is_file()], force=force)
    from labcal.years.fleet import USUAL_BATCH, fleet_of
    from labcal.years.fleet_page import fleet_document, fleet_page

    history = [one for one in _history(read, archive, undated=True) if model in (None, one.model)]
    found = fleet_of(history, batch if batch is not None else USUAL_BATCH)
    _give("fleet", fleet_document(found), fleet_page(found), json, out, read, force=force)
    return DONE


def _stated(serial: str, repeats: int, baseline: int) -> CheckStandardConfig:
    from labcal.bench.check_standard import CheckStandardConfig

    if not serial.strip():
        raise InputError("the serial is empty")
    return CheckStandardConfig(serial=serial, repeats=repeats, baseline=baseline)


def _history(
    read: Sequence[Path], archive: str | None, serial: str | None = None, *, undated: bool = False
) -> list[Calibrated]:
    from labcal.years.history import from_archive, from_files, of_this_lab

    if archive is not None:
        if read:
            raise InputError("say files, or --archive")
        return from_archive(archive, serial=serial)
    return from_files(read, _remark, undated=undated) if read else of_this_lab(_remark, undated=undated)


def _bench_and_file(text: str) -> tuple[str, Path]:
    bench, equals, file = text.partition("=")
    if not (equals and bench.strip() and file):
        raise InputError(f"expected BENCH=CAL, as aalto=cal.json, found {text!r}")
    return bench.strip(), Path(file)


def _claim(command: str, json: str | None, out: Path | None, read: Sequence[Path], *, force: bool) -> None:
    """Before the work: may these files be written, and is the page of a form that there is."""
    if out is not None and out.suffix.lower() not in FORMS:
        raise InputError(f"a page ends in {', '.join(FORMS)}", file=out)
    claim(command, *(path for path in (json_path(json), out) if path), inputs=read, force=force)


def _give(
    command: str, document: Any, page: Page, json: str | None, out: Path | None, read: Sequence[Path], *, force: bool
) -> None:
    """The JSON, the page, and on the terminal what it says, unless the JSON goes there."""
    from labcal.years.pages import write_page

    if json is not None:
        write_json(document, json, command, inputs=read, force=force)
    if out is not None:
        [output] = claim(command, out, inputs=read, force=force)
        with output.writing():
            write_page(page, out)
    if json != "-":
        show_page(page)


def show_page(page: Page) -> None:
    """Its sentence, its tables and its prose; figures are left out."""
    from labcal.certificate.report.page import Prose, Table

    say(page.title + (" (simulated)" if page.simulated else ""))
    for block in (block for part in page.sections for block in part.blocks):
        if isinstance(block, Table):
            _show_table(block)
        elif isinstance(block, Prose):
            say_lines(block.sentences)
    say(page.summary)


def _show_table(shown: Table) -> None:
    from rich.table import Table as Terminal

    table = Terminal(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    for i, head in enumerate(shown.header):
        table.add_column(head, justify="right" if i in shown.numeric else "left")
    for row in shown.rows:
        table.add_row(*row)
    console().print(table)
    if shown.caption:
        console().print(shown.caption, style="dim", highlight=False)


def _working(run: str) -> None:
    say(f"working out {run}", err=True)


def _remark(sentence: str) -> None:
    say(sentence, err=True)
