"""`labcal push` and `labcal archive`: finished work of several labs in one PostgreSQL."""

from __future__ import annotations

import re
from contextlib import suppress
from enum import StrEnum
from math import isfinite
from pathlib import Path
from typing import Any

import typer

from labcal.cli import app
from labcal.cli.results import FORCE, JSON, write_json
from labcal.cli.runs import list_archived
from labcal.cli.screen import aligned, say, say_lines
from labcal.errors import InputError

ARCHIVE = typer.Option(
    None, "--archive", metavar="URL", help="postgresql://USER@HOST/DATABASE, without a password; else LABCAL_ARCHIVE."
)
HEADS = ("site", "run", "measured", "DUT", "model", "reference", "signed by", "")
BOUND = re.compile(r"\s*([0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([^\W\d]\S*)\s*")


class May(StrEnum):
    """What a role may do with a lab's rows."""

    read = "read"
    push = "push"
    nothing = "nothing"


archive = typer.Typer(help="The archive of several labs: make it, give rights, ask it.", no_args_is_help=True)
app.add_typer(archive, name="archive", rich_help_panel="Archive")


@app.command(rich_help_panel="Archive")
def push(
    runs: list[str] | None = typer.Argument(
        None, metavar="[RUN|CAL]...", help="Runs, bundles, signed calibrations; none: all that is not there yet."
    ),
    archive: str | None = ARCHIVE,
    bundles: str | None = typer.Option(
        None, metavar="PLACE", help="Where bundles go: a folder, or s3://… ; else as the URL or the archive says."
    ),
    every: float | None = typer.Option(
        None, metavar="SECONDS", min=1.0, help="Push again and again until Ctrl-C, whether the server is there or not."
    ),
) -> None:
    """Copy finished runs, signed calibrations and the audit log into the archive; what is there already stays."""
    from labcal.session import archiving

    if every is not None:
        archiving.push_every(every, archive, runs or (), bundles, say)
    found = archiving.push(archive, runs or (), bundles, say)
    say(found.in_words())
    if found.refused:
        say_lines(found.refused[:-1], err=True)
        raise InputError(f"{found.refused[-1]} ({len(found.refused)} not pushed; the others are there)")


@archive.command()
def init(
    archive: str | None = ARCHIVE,
    bundles: str | None = typer.Option(None, metavar="PLACE", help="Where all sites keep bundles: a folder, or s3://…"),
) -> None:
    """Make the catalogue in an empty database, or bring an older one up to date."""
    from labcal.session import archiving

    say(archiving.init_archive(archive, bundles))


@archive.command()
def grant(
    role: str = typer.Argument(..., metavar="ROLE", help="A role that the server has."),
    lab: str = typer.Option(..., help="The lab, as its rows name their site; * is all, to be read."),
    may: May = typer.Option(..., help="What it may do with that lab's rows; none of them is ever changed."),
    archive: str | None = ARCHIVE,
) -> None:
    """Let a PostgreSQL role see a lab's rows, or add to them; the server itself refuses everything else."""
    from labcal.session import archiving

    archiving.grant_in_archive(archive, role, lab, may.value)
    say(f"{role} may {may} {'of ' if may is May.nothing else ''}{lab}")


@archive.command()
def runs(archive: str | None = ARCHIVE, json: str | None = JSON, force: bool = FORCE) -> None:
    """List the runs of all sites, the oldest first, as far as this role may see them."""
    list_archived(archive, json, force=force)


@archive.command()
def calibrations(
    archive: str | None = ARCHIVE,
    model: str | None = typer.Option(None, help="Of this model of sensor."),
    dut: str | None = typer.Option(None, metavar="SERIAL", help="Of this sensor."),
    instrument: str | None = typer.Option(
        None, metavar="SERIAL", help="Made with this reference, or another instrument of the run."
    ),
    since: str | None = typer.Option(None, metavar="DATE", help="Measured on this day (UTC) or later."),
    until: str | None = typer.Option(None, metavar="DATE", help="Measured before this day (UTC)."),
    effect: str | None = typer.Option(None, metavar="EFFECT", help="In which this effect was found: offset-drift …"),
    above: str | None = typer.Option(
        None, metavar="VALUE", help="With a parameter of that effect larger than this, as in '0.01 nT/s'."
    ),
    changed: bool = typer.Option(
        False, "--changed", help="That differ from the one before of the same sensor by more than U (k = 2)."
    ),
    json: str | None = JSON,
    force: bool = FORCE,
) -> None:
    """List calibrations: those that a reference's fault touches, that changed, that suffer an effect."""
    from labcal.session import archiving

    bound = _bound(above)
    found = archiving.archived_calibrations(
        archive, model=model, dut=dut, instrument=instrument, since=archiving.as_moment(since),
        until=archiving.as_moment(until), effect=effect, above=bound, changed=changed,
    )  # fmt: skip
    if json is not None:
        return write_json(found, json, "archive calibrations", force=force)
    if not found:
        return say("none")
    return say_lines(aligned([HEADS, *map(_listed, found)]))


@archive.command()
def get(
    run: str = typer.Argument(..., metavar="RUN", help="A run id, or the beginning of a run's SHA-256."),
    out: Path = typer.Option(..., "--out", metavar="RUN.zip", help="The bundle, as it was pushed."),
    site: str | None = typer.Option(None, help="Of this site, where several have a run of that name."),
    archive: str | None = ARCHIVE,
    force: bool = FORCE,
) -> None:
    """Fetch a run's bundle from the archive."""
    from labcal.session import archiving

    archiving.fetch_from_archive(archive, run, site, out, force=force)
    say(out)


@archive.command()
def check(
    archive: str | None = ARCHIVE,
    bundles: str | None = typer.Option(None, metavar="PLACE", help="Where bundles are; else as the archive says."),
) -> None:
    """Read every bundle and file again: do they say what the catalogue says? Exit code 2: not all do."""
    from labcal.session import archiving

    looked = list[str]()
    found = archiving.check_archive(archive, bundles, looked.append)
    say(f"{len(looked)} runs and calibrations read, {len(found)} are not what the catalogue says")
    if found:
        say_lines(found[:-1], err=True)
        raise InputError(found[-1])


def _bound(text: str | None) -> tuple[float, str] | None:
    """The value and unit that `--above` states. Raises typer.BadParameter."""
    if text is None:
        return None
    found = BOUND.fullmatch(text)
    with suppress(ValueError):
        if found and isfinite(value := float(found[1])):
            return value, found[2]
    raise typer.BadParameter(f"--above is a value with its unit, as in '0.01 nT/s', found {text!r}")


def _listed(one: dict[str, Any]) -> tuple[str, ...]:
    run = f"{one['run_id']} (simulated)" if one["simulated"] else one["run_id"]
    measured, reference = one["measured_utc"] or "not known", one["reference_serial"] or ""
    signers = one["signers"] or "not confirmed"  # by the lab that pushed it
    return (one["site"], run, measured, one["dut_serial"], one["dut_model"], reference, signers, _why(one))


def _why(one: dict[str, Any]) -> str:
    """What fits, and what became of it."""
    said = []
    if "e_n" in one:
        said.append(f"{one['figure']} {one['found']:.5g} → {one['left']:.5g} {one['unit']}, E_n {one['e_n']:+.2f}")
    if "parameter" in one:
        u = "" if one["u"] is None else f" ± {one['u']:.2g}"
        said.append(f"{one['parameter']} {one['value']:.4g}{u} {one['parameter_unit']}")
    if one["superseded_by"]:
        said.append(f"superseded by {one['superseded_by']}")
    return "; ".join(said)
