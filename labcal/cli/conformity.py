"""`labcal conformity` and `labcal compare`: is it in specification, and what changed since the calibration before."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console
from labcal.files.outputs import claim

if TYPE_CHECKING:
    from labcal.uncertainty.conformity import Assessment, Changes

ACCEPTED = ("pass", "conditional-pass")
AFTERWARDS = "This specification was not chosen before the measurement: no certificate states these lines."
RISK_WORDS = (
    "Risk: how probably the true value is beyond its limit (false acceptance; specific risk, JCGM 106:2012). "
    "TUR: limit / U."
)
E_N_WORDS = "E_n = (as left - as found) / U of the difference (95 %): beyond ±1 the sensor has changed."


@app.command("conformity", rich_help_panel="Certificate")
def conformity(
    calibration: Path = typer.Argument(..., metavar="CAL", help="A calibration file."),
    specification: Path | None = typer.Option(
        None, metavar="FILE.toml", help="Judge by this specification, not by the one that the run was recorded under."
    ),
    run: str | None = typer.Option(None, help="CAL's run, for noise, linearity and residual: that of the store."),
    json_file: str | None = JSON,
    force: bool = FORCE,
) -> int:
    """Show whether a calibration is in specification. Exit code 1: a line is not, or nothing determined it."""
    from labcal import session
    from labcal.session.conformity import conformity as judged

    read = [calibration, *([specification] if specification else []), *(session.paths(run) if run else [])]
    claim("conformity", json_path(json_file), inputs=read, force=force)  # before the work, not after it
    found = judged(calibration, specification, run)
    if json_file is not None:
        content = {"specification": [asdict(line) for line in found.lines], "left_open": list(found.left_open)}
        content |= {"offsets": found.k_means} if found.k_means else {}
        write_json(content, json_file, "conformity", inputs=read, force=force)
    if json_file != "-":
        show_conformity(found)
        if specification is not None:
            console().print(AFTERWARDS, highlight=False)
    accepted = all(line.result in ACCEPTED for line in found.lines) and not found.left_open
    return DONE if accepted else NEGATIVE


@app.command("compare", rich_help_panel="Certificate")
def compare(
    calibration: Path = typer.Argument(..., metavar="CAL", help="A calibration file: as left."),
    before: Path = typer.Argument(..., metavar="OLDCAL", help="An earlier one of the same DUT: as found."),
    json_file: str | None = JSON,
    force: bool = FORCE,
) -> int:
    """Show what changed between two calibrations of one DUT. Exit code 1: more than the uncertainty explains."""
    from labcal.session.conformity import compare as compared

    claim("compare", json_path(json_file), inputs=[calibration, before], force=force)
    found = compared(calibration, before)
    if json_file is not None:
        write_json(asdict(found), json_file, "compare", inputs=[calibration, before], force=force)
    if json_file != "-":
        _show_changes(found)
    return NEGATIVE if any(row.changed for row in found.rows) else DONE


def show_conformity(found: Assessment) -> None:
    """The lines as a table, the rule, and what is left open."""
    from rich.table import Table

    from labcal.certificate.report.style import with_uncertainty
    from labcal.uncertainty.conformity import WORDS, ratio_in_words, risk_in_words

    screen = console()
    if found.lines:
        table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
        table.add_column("Specification")  # words are wrapped where the screen is narrow; a number is never cut
        for name in ("Value", "U", "Limit", "Unit", "Result", "Risk", "TUR"):
            table.add_column(name, no_wrap=name != "Result", justify="left" if name in ("Unit", "Result") else "right")
        for line in found.lines:
            numbers = *map(_plain, with_uncertainty(line.value, line.U)), f"{line.limit:g}"
            ratios = risk_in_words(line.risk), ratio_in_words(line.tur)
            table.add_row(line.quantity, *numbers, line.unit, WORDS[line.result], *ratios)
        screen.print(table)
        if found.k_means and any(line.quantity.startswith("offset") for line in found.lines):
            screen.print(f"Offsets are those {found.k_means}.", highlight=False)
        for rule in dict.fromkeys(line.rule for line in found.lines):
            screen.print(f"Decision rule: {rule}.", style="dim", highlight=False)
        screen.print(RISK_WORDS, style="dim", highlight=False)
    for said in found.left_open:
        screen.print(said, style="yellow", highlight=False)


def _plain(number: str) -> str:
    """A number of a printed page as programs read it: no thin spaces, an ASCII minus."""
    return number.replace("\u202f", "").replace("\u2212", "-")


def _show_changes(found: Changes) -> None:
    from rich.table import Table

    from labcal.certificate.report.style import decimals_for

    screen = console()
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0))
    table.add_column("Figure", no_wrap=True)
    for name in ("As found", "As left", "Change", "U", "Unit", "E_n", ""):
        table.add_column(name, no_wrap=True, justify="left" if name in ("Unit", "") else "right")
    for row in found.rows:
        decimals = decimals_for([row.U or 0.0])
        numbers = (f"{value:.{decimals}f}" for value in (row.found, row.left, row.left - row.found))
        U, e_n = ("–", "–") if row.e_n is None else (f"{row.U:.{decimals}f}", f"{row.e_n:+.2f}")
        table.add_row(row.quantity, *numbers, U, row.unit, e_n, "changed" if row.changed else "")
    screen.print(table)
    screen.print(f"As found: run {found.found}; as left: run {found.left}. {found.in_words()}", highlight=False)
    for said in found.remarks:
        screen.print(said, style="yellow", highlight=False)
    screen.print(E_N_WORDS, style="dim", highlight=False)
