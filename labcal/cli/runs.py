"""`labcal runs`, `show`, `import` and `export`: the store."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from labcal.cli import app
from labcal.cli.results import FORCE, JSON, write_json
from labcal.cli.screen import aligned, console, say, say_lines
from labcal.errors import InputError
from labcal.record.endings import ended_words

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from labcal.store import RunSummary

MOST_SHOWN = 500  # lines of one table: a recording may have 45 000 segments, which no person reads
HEADS = ("run", "started", "status", "DUT", "procedure", "operator")
RUN = typer.Argument(..., metavar="RUN", help="A run id of the store, or the path of a bundle.")


class ExportFormat(StrEnum):
    """What a run, or a calibration, can be exported as."""

    bundle = "bundle"
    csv = "csv"
    hdf5 = "hdf5"
    mat = "mat"
    c = "c"
    json = "json"
    px4 = "px4"
    ardupilot = "ardupilot"


OF_A_RUN = (ExportFormat.bundle, ExportFormat.csv, ExportFormat.hdf5, ExportFormat.mat)
OF_A_CALIBRATION = (ExportFormat.c, ExportFormat.json, ExportFormat.mat, ExportFormat.px4, ExportFormat.ardupilot)


@app.command(rich_help_panel="Runs")
def runs(
    archive: str | None = typer.Option(
        None, metavar="URL", help="Of the archive, not of the store: postgresql://USER@HOST/DATABASE."
    ),
    json: str | None = JSON,
    force: bool = FORCE,
) -> None:
    """List the runs of the store, the oldest first, with how each ended; those of the archive with --archive."""
    from dataclasses import asdict

    from labcal.store import list_runs  # and no more: the list is there at once

    if archive is not None:
        return list_archived(archive, json, force=force)
    found = list_runs()
    if json is not None:
        return write_json([asdict(run) for run in found], json, "runs", force=force)
    if not found:
        return say("no runs yet: `labcal demo` makes one, `labcal import` takes one in")
    return say_lines(aligned([HEADS, *map(_listed, found)]))


def list_archived(url: str | None, json: str | None, *, force: bool) -> None:
    """Print the runs of the archive, or write them as JSON."""
    from dataclasses import fields

    from labcal.session import archiving
    from labcal.store import RunSummary

    found = archiving.archived_runs(url)
    if json is not None:
        return write_json(found, json, "runs", force=force)
    if not found:
        return say("no runs yet: `labcal push` copies finished ones here")
    names = [field.name for field in fields(RunSummary)]
    rows = ((one["site"], *_listed(RunSummary(**{n: one[n] for n in names if n in one}))) for one in found)
    return say_lines(aligned([("site", *HEADS), *rows]))


@app.command(rich_help_panel="Runs")
def show(run: str = RUN, json: str | None = JSON, force: bool = FORCE) -> None:
    """Show what a run is: DUT, reference, segments and what each offers, channels, measurements."""
    from labcal import session

    described = session.describe_run(run)
    if json is not None:
        return write_json(described, json, "show", inputs=session.paths(run), force=force)
    screen = _console()
    screen.print(_head(described))
    for name, table_of in (("segments", _segments), ("channels", _channels), ("measurements", _measurements)):
        rows = described.get(name, ())
        if rows:
            screen.print(table_of(rows[:MOST_SHOWN]))
        if len(rows) > MOST_SHOWN:
            say(f"… and {len(rows) - MOST_SHOWN} more {name}: --json has all {len(rows)}")
    return None


@app.command("check-store", rich_help_panel="Runs")
def check_store(
    run: str | None = typer.Argument(None, metavar="RUN", help="A run id of the store; none: all of them."),
) -> int:
    """Look through every page, row and hash chain: exit 0 where all fits, else 1 and the first thing that does not."""
    from labcal import session
    from labcal.cli import DONE, NEGATIVE

    found = session.check_store(run)
    if found.fault:
        say(f"NOT SOUND: {found.fault}")
        return NEGATIVE
    again = f", the raw frames of {found.parsed} parsed again" if found.parsed else ""
    say(f"sound: {found.runs} run{'s' * (found.runs != 1)}, {found.items} rows{again}")
    return DONE


@app.command("import", rich_help_panel="Runs")
def import_(
    path: Path = typer.Argument(..., metavar="PATH", help="A bundle (a folder, or a zip of it), or what --from says."),
    kind: str | None = typer.Option(
        None,
        "--from",
        metavar="FORMAT",
        help="A recording of others: csv, ulog, dataflash, rosbag, mat, iaga or imagcdf; a calibration: magcal, "
        "magneto, px4 or ardupilot.",
    ),
    map_: Path | None = typer.Option(
        None, "--map", metavar="MAP.toml", help="What its columns are: units, axes, clocks (docs/import.md)."
    ),
    guess: bool = typer.Option(
        False, "--guess", help="Write a first mapping to --map, or to standard output, for a person to check."
    ),
    out: Path | None = typer.Option(
        None, "--out", metavar="BUNDLE", help="Write a bundle instead of taking the run into the store."
    ),
    force: bool = FORCE,
) -> None:
    """Take a bundle into the store, byte for byte, or a recording of others by its mapping; prints its run id.

    A calibration that another program made becomes a draft.
    """
    from labcal import session

    if kind is None:
        if map_ is not None or guess or out is not None:
            raise typer.BadParameter("--map, --guess and --out go with --from: a bundle is taken in as it is")
        return say(session.import_bundle(path))
    if kind in session.FOREIGN_CALIBRATIONS:
        if map_ is not None or guess:
            raise typer.BadParameter("--map and --guess are for recordings, not for a calibration")
        return say(session.import_calibration(path, kind, out, force=force))
    taken = session.import_foreign(session.ImportRequest(path, kind, map_, guess, out, force))
    say_lines(taken.remarks, err=True)
    return say_lines(taken.result.splitlines())


@app.command(rich_help_panel="Runs")
def export(
    source: str = typer.Argument(..., metavar="RUN|CAL", help="A run id, a bundle's path, or a calibration file."),
    format_: ExportFormat = typer.Option(
        ...,
        "--format",
        help="Of a run: bundle, csv (its samples), hdf5, mat. Of a calibration: c, json, mat, px4, ardupilot.",
    ),
    out: Path = typer.Option(
        ...,
        "--out",
        metavar="PATH",
        help="Where to: a file, a folder for a calibration; a bundle is a zip where it ends in .zip.",
    ),
    require_signature: bool = typer.Option(False, help="Refuse a calibration that nobody validly signed."),
    force: bool = FORCE,
) -> None:
    """Write a run for other programs, or a calibration for those who fly it; the same gives the same bytes."""
    from labcal import session
    from labcal.certificate import looks_like_calibration

    if looks_like_calibration(Path(source)):
        _check_format(format_, OF_A_CALIBRATION, f"{source} is a calibration")
        signed = session.export_calibration(
            Path(source), format_.value, out, require_signature=require_signature, force=force
        )
        say(signed, err=True)
    else:
        _check_format(format_, OF_A_RUN, f"{source} is a run")
        session.export_run(source, format_.value, out, force=force)
    say(out)


def _check_format(format_: ExportFormat, there: tuple[ExportFormat, ...], what: str) -> None:
    if format_ not in there:
        raise InputError(f"{what}, and {format_} is no format of one; there are {', '.join(there)}")


def _listed(run: RunSummary) -> tuple[str, ...]:
    procedure = f"{run.procedure} (simulated)" if run.simulated else run.procedure
    return (
        run.run_id,
        run.started_utc,
        ended_words(run.status, stopped=run.stopped),
        run.dut_serial,
        procedure,
        run.operator,
    )


def _table(*heads: str, **options: Any) -> Table:
    from rich.table import Table

    return Table(*heads, **options)


def _head(described: Mapping[str, Any]) -> Table:
    table = _table(show_header=False, box=None)
    dut, reference = described["dut"], described["reference"]
    noise = "not stated" if dut["noise_nT"] is None else f"{dut['noise_nT']:g} nT"
    lines = {
        "run": f"{described['run_id']}{' (SIMULATED)' if described['simulated'] else ''}",
        "status": ended_words(described["status"], stopped=described.get("stopped", False)),
        "started": described["started_utc"],
        "operator": described["operator"],
        "DUT": f"{dut['serial']} {dut['model']}, {dut['nominal_nT_per_unit']:g} nT per {dut['unit']}, noise {noise}",
        "reference": ", ".join(f"{key} {value}" for key, value in reference.items() if value != ""),
        "origin": _origin(described["chain"]),
        "samples": f"{described['n_samples']}, {_between(described['span_s'], 'g')} s",
    }
    if "procedure" in described:
        procedure = described["procedure"]
        chosen = ", ".join(f"{key}={value}" for key, value in procedure["parameters"].items())
        lines["procedure"] = f"{procedure['name']} {chosen}".strip()
        lines["software"] = procedure["software"]
        lines["instruments"] = "\n".join(" ".join(map(str, one.values())) for one in described["instruments"])
    if "specification" in described:
        lines["specification"] = _asked(described["specification"])
    for name, text in lines.items():
        if text:
            table.add_row(name, text)
    return table


def _asked(specification: Mapping[str, Any]) -> str:
    """What the DUT was to keep, and the rule that decides."""
    limits = [f"{name} {v['limit']:g} {v['unit']}" for name, v in specification.items() if isinstance(v, dict)]
    return f"{', '.join(limits)}; {specification['rule']}, r = {specification['r']:g}".replace("_", "-")


def _origin(chain: Mapping[str, Any] | None) -> str:
    return f"chain of {chain['rows']} rows, head {chain['head']}" if chain else "not shown: there is no hash chain"


def _segments(rows: Sequence[Mapping[str, Any]]) -> Table:
    table = _table("segment", "kind", "offers", "modes", "samples", "missing", "s", "Hz", "|reference| nT", "note")
    for one in rows:
        rate = "" if one["rate_Hz"] is None else f"{one['rate_Hz']:.3g}"
        counts = (str(one["n_samples"]), str(one["missing"] or ""), f"{one['duration_s']:.1f}", rate)
        names = (one["id"], one["kind"], one["offers"], " ".join(one["modes"]))
        table.add_row(*names, *counts, _between(one["magnitude_nT"], ".0f"), one["note"])
    return table


def _channels(rows: Sequence[Mapping[str, Any]]) -> Table:
    table = _table("channel", "unit", "quantity", "role", "range")
    for one in rows:
        table.add_row(one["name"], one["unit"], one["quantity"], one["role"], _between(one["range"], ".5g"))
    return table


def _measurements(rows: Sequence[Mapping[str, Any]]) -> Table:
    table = _table("measurement", "value", "U (k = 2)", "unit", "limit", "verdict")
    for one in rows:
        numbers = ("" if x is None else f"{x:.4g}" for x in (one["value"], one["u"] and 2 * one["u"]))
        limit = "" if one["limit"] is None else f"{one['limit']:g}"
        table.add_row(one["name"], *numbers, one["unit"], limit, one["verdict"])
    return table


def _between(ends: tuple[float, float] | None, format_: str) -> str:
    return "" if ends is None else f"{ends[0]:{format_}} … {ends[1]:{format_}}"


def _console() -> Console:
    screen = console()
    return screen if screen.is_terminal else console(width=160)
