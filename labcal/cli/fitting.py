"""`labcal fit` and `labcal apply`: a calibration from a run, and readings through a calibration."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.conformity import show_conformity
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console, say
from labcal.cli.signing import SUPERSEDES, UNTIL
from labcal.files.outputs import claim

if TYPE_CHECKING:
    from labcal.certificate import AppliedFile
    from labcal.fit import Fit

FIT_WORDS = (
    "Residual: rms of |b| less the reference's magnitude; held out: the same on stretches of time that the fit did not "
    "see. u(k): standard uncertainties of the offsets x, y, z. Frame: free where magnitudes leave the rotation open."
)


@app.command("fit", rich_help_panel="Calibration")
def fit(
    run: str = typer.Argument(..., help="A run id of the local store, or the path of a bundle."),
    method: str = typer.Option("ml", help="A method, or all side by side; a name that is none lists them."),
    channels: str | None = typer.Option(
        None, help="With --method telemetry: channels that may act, with commas between."
    ),
    json_file: str | None = JSON,
    out: Path | None = typer.Option(None, metavar="CAL.json", help="Write a draft calibration (with all: of ml)."),
    until: str | None = UNTIL,
    supersedes: Path | None = SUPERSEDES,
    force: bool = FORCE,
) -> int:
    """Estimate a calibration from a run. Exit code 1: the run does not determine one."""
    from labcal import session
    from labcal.certificate import stated_by_people
    from labcal.fit.document import document
    from labcal.fit.wild import wild_rows
    from labcal.session.conformity import fit_conformity

    stated = stated_by_people(until, supersedes)
    read = [*session.paths(run), *([supersedes] if supersedes else [])]
    claim("fit", out, json_path(json_file), inputs=read, force=force)  # before the work, not after it
    names = tuple(name.strip() for name in channels.split(",") if name.strip()) if channels is not None else None
    measured, fits = session.fit_run(run, method, names)
    if json_file is not None:
        write_json(document(measured, fits), json_file, "fit", inputs=session.paths(run), force=force)
    if json_file != "-":
        _show_fits(fits)
        for found in fits:
            if found.ok and (open_yet := session.left_open(measured, found)):
                say(f"{found.method}: not the whole map: {open_yet}", err=True)
    if (wild := int(wild_rows(measured).sum())) > 0:
        say(f"left out: {wild} of {len(measured)} readings, which no field made (twenty times the others)", err=True)
    chosen = next((f for f in fits if f.method == "ml"), fits[0])
    if json_file != "-" and (judged := fit_conformity(measured, chosen)) is not None:
        show_conformity(judged)
    if out is not None and chosen.ok:
        session.draft(run, chosen, out, names, stated=stated, force=force)
        say(f"draft calibration: {out}", err=True)
    return DONE if chosen.ok else NEGATIVE


@app.command("apply", rich_help_panel="Calibration")
def apply(
    calibration: Path = typer.Argument(..., metavar="CAL", help="A calibration file."),
    source: Path = typer.Argument(..., metavar="IN.csv", help="Readings: dut_x, dut_y, dut_z and what CAL needs."),
    out: Path = typer.Option(..., metavar="OUT.csv", help="Every column of IN.csv and b_x, b_y, b_z, u_nT, flag."),
    dut: str | None = typer.Option(None, metavar="SERIAL", help="The DUT's serial, refused where CAL is another's."),
    require_signature: bool = typer.Option(
        False, "--require-signature", help="Refuse a calibration that is not validly signed (exit code 2)."
    ),
    force: bool = FORCE,
) -> None:
    """Calibrate readings; says on stderr where the calibration is unsigned, provisional, expired or superseded."""
    from labcal import session

    remarks: list[str] = []  # said once it is done: a refusal is one sentence
    applied = session.apply_calibration(
        calibration, source, out, dut, require_signature=require_signature, on_remark=remarks.append, force=force
    )
    for remark in remarks:
        say(remark, err=True)
    _show_applied(applied, out)


def _show_fits(fits: list[Fit]) -> None:
    from rich.table import Table

    table = Table(box=None)
    for name in ("Method", "Residual\nnT", "Held out\nnT", "u(k)\nnT", "Frame", "Time\nms"):
        table.add_column(name, no_wrap=True, justify="left" if name in ("Method", "Frame") else "right")
    for found in fits:
        table.add_row(found.method, *_cells(found)) if found.ok else table.add_row(found.method, "none", style="yellow")
    screen = console()
    screen.print(table)
    screen.print(FIT_WORDS, style="dim", highlight=False)
    why_not: dict[str, list[str]] = {}
    for found in fits:
        if not found.ok:
            why_not.setdefault(str(found.why_not), []).append(found.method)
    for reason, methods in why_not.items():
        screen.print(f"{', '.join(methods)}: {reason}", style="yellow", highlight=False)


def _cells(found: Fit) -> tuple[str, ...]:
    u = "none" if found.covariance is None else " ".join(f"{found.covariance[i, i] ** 0.5:.1f}" for i in (9, 10, 11))
    residuals = ("" if v is None else f"{v:.1f}" for v in (found.rms_scalar_nT, found.holdout_rms_scalar_nT))
    return (*residuals, u, "known" if found.frame_known else "free", f"{found.seconds * 1000:.0f}")


def _show_applied(applied: AppliedFile, out: Path) -> None:
    from collections import Counter

    counts = Counter[str]()
    for flag, rows in applied.flags.items():
        counts.update(dict.fromkeys(flag.split(), rows))
    flagged = ", ".join(f"{word} {n}" for word, n in counts.most_common()) or "none"
    say(f"{applied.rows} rows corrected into {out}; flagged: {flagged}")
