"""`labcal run`: a procedure on the bench, with progress for people and for programs."""

from __future__ import annotations

import json
import shlex
import signal
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from enum import StrEnum
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

import typer

from labcal.cli import app
from labcal.cli.progress import Display, shown
from labcal.cli.screen import console, say
from labcal.errors import InputError
from labcal.record.endings import ended_words
from labcal.record.person import check_person

if TYPE_CHECKING:
    from labcal.bench.clock import Clock
    from labcal.runner import Control
    from labcal.session import Override


class ClockChoice(StrEnum):
    """True speed, or as fast as the computer goes (where all links are emulated)."""

    real = "real"
    virtual = "virtual"


class ProgressChoice(StrEnum):
    """How progress is shown on stderr."""

    bar = "bar"
    json = "json"
    none = "none"


OWN_BENCH = Path("bench.toml")


@app.command("run", rich_help_panel="Bench")
def run(
    procedure: str | None = typer.Argument(None, help="A procedure's name, or a file ./my_test.py; none: list them."),
    bench: Path | None = typer.Option(None, help="The bench file; else bench.toml in this folder."),
    dut: str | None = typer.Option(
        None, metavar="SERIAL", help="The DUT's serial number, instead of the bench file's."
    ),
    operator: str = typer.Option("", metavar="NAME", help="Who measures; it stands in the record."),
    settings: list[str] = typer.Option(
        [], "--set", metavar="KEY=VALUE", help="A parameter of the procedure; once for each."
    ),
    yes: bool = typer.Option(False, "--yes", help="Answer prompts; on a real bench only those that do nothing."),
    resume: str | None = typer.Option(None, metavar="RUN", help="Go on with a run that was stopped or broken off."),
    clock: ClockChoice | None = typer.Option(None, help="True speed, or virtual (the default where all is emulated)."),
    seed: int | None = typer.Option(None, min=0, help="Of the simulated lab: the same gives the same run."),
    override: str | None = typer.Option(
        None, metavar="NAME", help="Who lets it begin though the check standard is out of control; with --because."
    ),
    because: str = typer.Option("", metavar="TEXT", help="Why they do."),
    key: str | None = typer.Option(None, metavar="PRINCIPAL", help="The person whose key signs that."),
    progress: ProgressChoice = typer.Option(ProgressChoice.bar, help="How to show progress on stderr."),
) -> None:
    """Run a scripted procedure; prints the run id last."""
    from labcal import session
    from labcal.runner import Control

    control = Control()
    options: dict[str, Any] = {"clock": _clock(clock), "seed": seed, "control": control}
    with shown(progress.value) as display, _stop_on_interrupt(control, display):
        options |= {"answer": None if yes else display.ask, "on_item": display.on_item}
        if resume is not None:
            _nothing_else(settings, dut, operator)
            outcome = session.resume(resume, _bench(bench), procedure, **options)
        elif procedure is not None:
            given, lets = _pairs(settings), _override(override, because, key)
            if progress is not ProgressChoice.json:
                _say_shortfalls(procedure, given)
            outcome = session.run(procedure, _bench(bench), given, dut=dut, operator=operator, override=lets, **options)
        else:
            return _list()
    said = told_once(ended_words(outcome.ending), outcome.at_rest)
    if outcome.resumable:
        said = f"{said}; `{_goes_on(procedure, outcome.run_id, _bench(bench))}` goes on with it"
    as_json = progress is ProgressChoice.json
    say(json.dumps({"item": "end", "text": said}) if as_json else said, err=True)
    say(outcome.run_id)
    return outcome.raise_fault()


def _say_shortfalls(procedure: str, given: Mapping[str, str]) -> None:
    """What does not come of these settings, before anything is begun; what is wrong with them the run says."""
    from labcal.runner import find

    with suppress(InputError):
        for said in find(procedure).shortfalls(given):
            say(said, err=True)


def told_once(ending: str, lab: str) -> str:
    """How it ended, and of the lab what that does not say already, or what was read since."""
    from labcal.bench.coils.state import NOT_BY_REFERENCE, NOT_CONFIRMED

    if NOT_CONFIRMED in ending and NOT_CONFIRMED not in lab:
        return f"{ending}; since then: {lab}"
    before, by_reference, _ = ending.partition(NOT_BY_REFERENCE)
    if by_reference and NOT_BY_REFERENCE in lab:  # the newer of two looks, with what can be done
        return before + lab[lab.index(NOT_BY_REFERENCE) :]
    first, *rest = lab.split("; ", 1)
    return "; ".join([ending, *([] if first in ending else [first]), *rest])


def _list() -> None:
    """What there is to run, with the parameters of each."""
    from rich.table import Table

    from labcal.runner import catalogue

    table = Table("procedure", "does", "--set", box=None)
    found_ones, broken = catalogue()
    for name, found in found_ones.items():
        settings = "\n".join(f"{spec.name}: {spec.expected}" for spec in found.parameters)
        table.add_row(name, found.title, settings)
    console().print(table)
    for error in broken.values():
        say(f"labcal: {error}", err=True)


def _pairs(settings: Sequence[str]) -> dict[str, str]:
    pairs = [text.partition("=") for text in settings]
    for key, equals, _ in pairs:
        if not equals or not key:
            raise InputError(f"--set {key}: expected KEY=VALUE")
    keys = [key.strip() for key, _, _ in pairs]
    if twice := next((key for key in keys if keys.count(key) > 1), None):
        raise InputError(f"--set {twice} is there twice: which of them?")
    return {key.strip(): value for key, _, value in pairs}


def _nothing_else(settings: Sequence[str], dut: str | None, operator: str) -> None:
    given = {"--set": settings, "--dut": dut, "--operator": operator}
    if said := [name for name, value in given.items() if value]:
        raise InputError(f"--resume goes on with what the run was begun with: leave out {' and '.join(said)}")


def _override(who: str | None, because: str, key: str | None) -> Override | None:
    """What a person answers for; None where nobody does."""
    from labcal.cli.keys import own_passphrase
    from labcal.session import Override

    if who is None:
        if because or key:
            raise InputError("--because and --key belong to --override NAME")
        return None
    if not who.strip() or not because.strip():
        raise InputError("an override has a name and a reason: --override NAME --because TEXT")
    check_person(who)
    return Override(who, because, key, own_passphrase(key) if key else "")


def _bench(given: Path | None) -> Path:
    """The bench file that is named, else the one that lies in the current folder."""
    if given is None and not OWN_BENCH.is_file():
        raise InputError(f"which bench? no {OWN_BENCH} lies in this folder: say --bench FILE")
    return given or OWN_BENCH


def _goes_on(procedure: str | None, run_id: str, bench: Path) -> str:
    """The command that goes on with a run."""
    words = ["labcal", "run", *([procedure] if procedure else []), "--resume", run_id, "--bench", str(bench)]
    return shlex.join(words)


def _clock(choice: ClockChoice | None) -> Clock | None:
    from labcal.bench.clock import RealClock, VirtualClock

    if choice is None:
        return None
    return RealClock() if choice is ClockChoice.real else VirtualClock(datetime.now(UTC))


@contextmanager
def _stop_on_interrupt(control: Control, display: Display) -> Iterator[None]:
    """Ctrl-C stops the run in order, a second one aborts it; none breaks off the way to zero."""

    def interrupted(_: int, __: FrameType | None) -> None:
        (control.abort if control.stopping() else control.stop)()
        display.stopping()

    before = signal.signal(signal.SIGINT, interrupted)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
