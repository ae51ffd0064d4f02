"""`labcal bench`: identify every instrument, serve emulated ones, take the coils to zero."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import typer

from labcal.cli import DONE, INSTRUMENT_FAILED, NEGATIVE, app
from labcal.cli.keys import own_passphrase
from labcal.cli.results import FORCE
from labcal.cli.screen import console, say

bench = typer.Typer(
    help="Instruments: find, check, serve emulated ones, coils off; approve a cage.", no_args_is_help=True
)
app.add_typer(bench, name="bench", rich_help_panel="Bench")
FILE = typer.Argument(help="The bench file.", show_default=False)


@bench.command()
def check(
    file: Path = FILE,
    clear_as: str = typer.Option(
        "", metavar="NAME", help="Who answers for a zero that the reference did not see; measures again first."
    ),
) -> None:
    """Ask every instrument of FILE who it is, and each coil's supply what flows; measure a zero in doubt again."""
    from rich.table import Table
    from rich.text import Text

    from labcal.session import cage_remark, identify_instruments, look_again

    table = Table("instrument", "role", "link", "answers as")
    silent, answered = 0, identify_instruments(file)
    for one in answered:
        silent += one.fault is not None
        said = Text(f"✕ {one.fault}", "red") if one.fault else Text(f"✓ {one.identity}")
        table.add_row(one.name, one.role, one.link, said)
    console().print(table)
    for one in answered:
        if one.flows_A is not None:
            say(f"! {one.role}: {one.flows_A:+.3f} A, measured just now, and no guardian: `labcal bench off {file}`")
    looked = look_again(file, clear_as)
    if looked is not None:
        say(looked.words)
        for more in (looked.advice, looked.before and f"First seen {looked.before}"):
            if more:
                say(f"{more}.")
    elif clear_as:
        say("No zero of this bench is in doubt; there is nothing to clear.")
    if (remark := cage_remark(file)) is not None:
        say(f"! {remark}")
    raise typer.Exit(INSTRUMENT_FAILED if silent or (looked is not None and not looked.lifted) else DONE)


@bench.command()
def serve(
    file: Path = FILE,
    out: Path = typer.Option(..., "--out", metavar="SERVED.toml", help="The bench file with the served links."),
    force: bool = FORCE,
) -> None:
    """Serve FILE's emulated instruments on TCP ports and ptys until Ctrl-C."""
    from labcal.session import serve_bench

    serve_bench(file, out, lambda: say("ready"), force=force)


@bench.command()
def find(
    place: list[str] | None = typer.Argument(
        None, metavar="[PLACE]...", help="Links, devices, hosts; none: this computer's serial and USB devices."
    ),
    out: Path | None = typer.Option(
        None, "--out", metavar="BENCH.toml", help="A draft of a bench file, refused as it stands."
    ),
    force: bool = FORCE,
) -> None:
    """Ask who answers on which port, and set nothing; what a person must state stays open in the draft."""
    from labcal.session import find_instruments

    found = find_instruments(place or [], out, say, force=force)
    if not found:
        say("Nothing answered." if out is None else f"Nothing answered; {out} is not written.")
    raise typer.Exit(DONE if found else NEGATIVE)


@bench.command()
def off(file: Path = FILE) -> None:
    """All coils to zero, outputs open where the supply can open, with read-back."""
    from labcal.bench.early_off import coils_off, reported

    raise typer.Exit(reported(file, coils_off(file)))


@bench.command()
def cage(
    run: str = typer.Argument(..., metavar="RUN", help="A finished run of cage-calibration."),
    name: str = typer.Option(..., "--as", metavar="NAME", help="Who approves it; not the operator."),
    out: Path = typer.Option(
        ..., "--out", metavar="CAGE.json", help=r"The file for `\[cage] calibration` of bench.toml."
    ),
    force: bool = FORCE,
) -> None:
    """Approve the cage calibration of RUN, a draft until then; signed where the key of who approves it is at hand."""
    from labcal import session

    found, signature = session.approve_cage(
        run, name, out, own_passphrase, on_remark=partial(say, err=True), force=force
    )
    say(f"{out}: the cage as run {found.run_id} found it, approved by {found.approved_by}")
    say(f"{signature}: signed" if signature else f"NOT SIGNED: no key of {name} is at hand here.")
    say(f'Put calibration = "{out.name}" into [cage] of the bench file, in place of its matrix.')
