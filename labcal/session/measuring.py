"""The loop closes on the instruments: rehearse what is proposed, ask once, measure, add the new run, decide again."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

from labcal import session
from labcal.bench.clock import Clock, VirtualClock
from labcal.bench.config import read_config
from labcal.errors import InputError, LimitError
from labcal.loop import ClosedLoop, Round
from labcal.record import Run
from labcal.record.join import GAP_S, joined
from labcal.record.stream import Item
from labcal.runner import Answer, find, procedures
from labcal.runner.rehearsal import Rehearsal, rehearsed
from labcal.store import write_bundle

ROUNDS = 3
ALWAYS_TELLS = "repeat"  # what is proposed where nothing better records anything
Consent = Callable[[Rehearsal], bool]


@dataclass(frozen=True, slots=True)
class Talk:
    """How the rounds speak with people: may this plan run, who answers prompts, who hears items and progress."""

    consent: Consent
    answer: Answer | None = None
    on_item: Callable[[Item], None] = lambda item: None
    progress: Callable[[str], None] = lambda text: None


def close_by_measuring(
    run: str,
    bench: Path,
    talk: Talk,
    *,
    out: Path | None = None,
    report: Path | None = None,
    seed: int | None = None,
    force: bool = False,
) -> ClosedLoop:
    """Close the loop on `run`; while it is open, measure what is proposed on `bench`, three rounds at most.

    Each new run is kept in the store, and so is the run of all rows together, which the result is about. `seed` is
    the simulated lab's. Raises InputError where the bench holds another DUT, and what an instrument or limit raises.
    """
    _refuse_another_dut(run, bench)
    closed = session.close_loop(run, out, talk.progress, report=report, force=force)
    rounds: list[Round] = []
    while not closed.done and len(rounds) < ROUNDS:
        plan, settings = _plan(closed, bench, {r.procedure for r in rounds}, seed)
        if plan is None or not talk.consent(plan):
            break
        run, new = _measured(plan, settings, run, bench, talk, seed)
        closed = session.close_loop(run, out, talk.progress, report=report, force=force)
        rounds.append(Round(plan.procedure, new, closed.verdict))
    return replace(closed, rounds=tuple(rounds))


def _refuse_another_dut(run: str, bench: Path) -> None:
    held, wanted = read_config(bench).dut.serial, session.load_run(run).dut.serial
    if held != wanted:
        raise InputError(f"the bench holds {held}, the run is of {wanted}: nothing was moved", file=bench)


def _plan(
    closed: ClosedLoop, bench: Path, done: set[str], seed: int | None
) -> tuple[Rehearsal | None, Mapping[str, str]]:
    """The first experiment proposed, not done yet, that this bench can do and that records rows for the loop.

    With the settings of its procedure. One whose settings this bench refuses, as beyond a limit, is passed over.
    """
    for name, settings in proposed_procedures(closed):
        if name in procedures() and name not in done:
            with suppress(*((InputError, LimitError) if settings else ())):
                plan = rehearsed(bench, find(name), settings, seed)
                if plan.segments:
                    return plan, settings
    return None, {}


def proposed_procedures(closed: ClosedLoop) -> Iterator[tuple[str, Mapping[str, str]]]:
    """What the loop would measure next, best first, then the procedure that always tells; each once, with settings."""
    if (proposed := closed.next_experiment) is None:
        return
    each_once: dict[str, Mapping[str, str]] = {}
    ranked = ((one.procedure, one.settings) for one in proposed.ranking)
    for name, settings in ((proposed.procedure, proposed.settings), *ranked):
        if name:
            each_once.setdefault(name, settings)
    each_once.setdefault(ALWAYS_TELLS, {})
    yield from each_once.items()


def _measured(
    plan: Rehearsal, settings: Mapping[str, str], run: str, bench: Path, talk: Talk, seed: int | None
) -> tuple[str, str]:
    """The id of the run of all rows so far and the new ones, and that of the new run."""
    clock: Clock | None = None
    if plan.simulated:
        start, now_s = goes_on(run)
        clock = VirtualClock(start)
        clock.wait_until(now_s)
    outcome = session.run(
        plan.procedure, bench, settings, answer=talk.answer, clock=clock, seed=seed, on_item=talk.on_item
    )
    if outcome.fault is not None:
        raise outcome.fault
    return together(run, outcome.run_id), outcome.run_id


def together(run: str, new: str) -> str:
    """Keep the run of all rows of `run` and then of `new` in the store; returns its id.

    Raises InputError where `new` is of another DUT or reference.
    """
    first, second = session.load_run(run), session.load_run(new)
    try:
        both = joined([first, second], f"{first.run_id}+{second.run_id}")
    except ValueError as error:
        raise InputError(str(error)) from None
    with tempfile.TemporaryDirectory() as folder:
        write_bundle(both, Path(folder) / "both")
        return session.import_bundle(Path(folder) / "both")


def goes_on(run: str) -> tuple[datetime, float]:
    """When `run` began, and how many seconds later simulated time goes on: a minute after the run's end.

    What a simulated DUT does by the time, it goes on doing.
    """
    measured = session.load_run(run)
    lasted_s = float(np.ptp(measured.t_s)) if len(measured) else 0.0
    return _start(measured), lasted_s + GAP_S


def _start(run: Run) -> datetime:
    try:
        start = datetime.fromisoformat(run.started_utc)
    except ValueError:
        return datetime.now(UTC)
    return start if start.tzinfo else start.replace(tzinfo=UTC)
