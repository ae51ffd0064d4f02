"""`labcal close-loop`: find what is left of a run, trace it to a cause, prove it."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.conformity import show_conformity
from labcal.cli.progress import shown, step_line
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import console, say_lines
from labcal.cli.signing import SUPERSEDES, UNTIL
from labcal.errors import InputError
from labcal.files.outputs import claim
from labcal.files.toml_file import named_files

if TYPE_CHECKING:
    from labcal.loop import ClosedLoop
    from labcal.runner.rehearsal import Rehearsal


@app.command("close-loop", rich_help_panel="Calibration")
def close_loop(
    run: str = typer.Argument(..., help="A run id of the local store, or the path of a bundle."),
    json_file: str | None = JSON,
    report: Path | None = typer.Option(None, metavar="FILE.html", help="Write the report for people (.html or .pdf)."),
    out: Path | None = typer.Option(None, metavar="CAL.json", help="Write the calibration with the effects found."),
    until: str | None = UNTIL,
    supersedes: Path | None = SUPERSEDES,
    measure: bool = typer.Option(
        False,
        "--measure",
        help="While causes are open, measure on --bench what distinguishes them.",
    ),
    bench: Path | None = typer.Option(None, help="The bench to measure on."),
    empirical: bool = typer.Option(
        False, "--empirical", help="Ship a term without a name where no known effect carries what is left."
    ),
    yes: bool = typer.Option(False, "--yes", help="Agree to the plans; on a real bench prompts still need a person."),
    seed: int | None = typer.Option(None, min=0, help="Of the simulated lab; else that of the run."),
    force: bool = FORCE,
) -> int:
    """Trace what the model leaves to its cause, and add that. Exit code 0: clean or explained; 1: any other verdict."""
    from labcal import session
    from labcal.certificate import stated_by_people

    stated = stated_by_people(until, supersedes)
    read = [*session.paths(run), *(named_files(bench) if bench else ()), *([supersedes] if supersedes else [])]
    claim("close-loop", out, report, json_path(json_file), inputs=read, force=force)  # before the work, not after it
    if measure:
        if bench is None:
            raise InputError("--measure needs a bench: say --bench FILE")
        if until or supersedes:
            raise InputError("--until and --supersedes are for `labcal approve`, not for --measure")
        closed = _measuring(run, bench, out, report, seed, sure=yes, force=force)
    else:
        closed = session.close_loop(run, out, step_line, report=report, empirical=empirical, stated=stated, force=force)
    if json_file is not None:
        write_json(closed.to_json(), json_file, "close-loop", inputs=read, force=force)
    if json_file != "-":
        _show(closed)
    return DONE if closed.done else NEGATIVE


def _measuring(
    run: str, bench: Path, out: Path | None, report: Path | None, seed: int | None, *, sure: bool, force: bool
) -> ClosedLoop:
    """Plans and progress go to stderr, for stdout belongs to the result."""
    from labcal.session.measuring import Talk, close_by_measuring

    def consent(plan: Rehearsal) -> bool:
        with display.aside():
            say_lines(["The plan:", *(f"  {line}" for line in plan.lines())], err=True)
            if sure or (plan.simulated and not sys.stdin.isatty()):
                return True
            if not sys.stdin.isatty():
                raise InputError("nobody is there to agree to the plan: at a terminal, or with --yes")
            return typer.confirm("Measure this now?", err=True)

    def progress(step: str) -> None:
        with display.aside():
            step_line(step)

    with shown("bar") as display:
        answer = display.ask if sys.stdin.isatty() and not sure else None
        talk = Talk(consent, answer, display.on_item, progress)
        return close_by_measuring(run, bench, talk, out=out, report=report, seed=seed, force=force)


def _show(closed: ClosedLoop) -> None:
    from rich.table import Table

    screen = console()
    screen.print(f"{closed.verdict}: {closed.summary}", highlight=False)
    table = Table("", "in sample nT", "held out nT", box=None)
    for when, errors in (("before", closed.before), ("after", closed.after)):
        table.add_row(when, f"{errors.train_rms_nT:.1f}", f"{errors.holdout_rms_nT:.1f}")
    table.add_row("noise alone", "", f"{closed.noise_floor_nT:.1f}")
    screen.print(table)
    if closed.accepted:
        effects = Table("Cause", "Channel", "Parameter", "Value", "u", "Unit", box=None)
        for effect in closed.accepted:
            name = effect.effect + (" (provisional)" if effect.provisional else "")
            if effect.basis is not None:
                of = f"{len(effect.parameters)} coefficients over {' and '.join(effect.inputs)}"
                effects.add_row(name, ", ".join(effect.channels), of, "", "", "nT")
                continue
            for number, p in enumerate(effect.parameters):
                first = (name, ", ".join(effect.channels)) if number == 0 else ("", "")
                effects.add_row(*first, p.name, f"{p.value:.4g}", f"{p.u:.2g}", p.unit)
        screen.print(effects)
    for effect in closed.proposed:
        text = f"{effect.holdout_rms_before_nT:.1f} to {effect.holdout_rms_after_nT:.1f} nT held out"
        of = " and ".join(effect.inputs)
        screen.print(f"Proposed, not shipped: a term without a name, a function of {of} ({text}). {effect.why}")
        screen.print("--empirical ships it; it holds only where this run has been.", highlight=False)
    if closed.conformity is not None:
        show_conformity(closed.conformity)
    for remark in closed.remarks:
        if remark not in closed.summary:
            screen.print(remark, highlight=False)
    for done in closed.rounds:
        screen.print(f"Measured: {done.procedure} (run {done.run_id}), then {done.verdict}.", highlight=False)
    if closed.next_experiment is not None:
        screen.print(f"Next: {closed.next_experiment.do} ({closed.next_experiment.why}).", highlight=False)
