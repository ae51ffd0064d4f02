"""A procedure run on the simulated bench and left by every way out: each leaves the coils at zero by its own undo."""

from __future__ import annotations

import inspect
import tempfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from labcal.bench import Bench, open_bench
from labcal.bench.clock import VirtualClock
from labcal.bench.parameters import parameters_of, settings
from labcal.bench.steps import Procedure
from labcal.demo import simulated_bench
from labcal.record.stream import Block, Event, Item, Prompt, SegmentOpened, Step
from labcal.runner import Control, find, run_procedure
from labcal.runner.catalogue import FoundProcedure
from labcal.runner.drive import Drive, Ending
from labcal.runner.prompts import Answer, first_choice
from labcal.store import Store
from labcal.testing.require import answered, require

UNDO = "with ExitStack() as afterwards: afterwards.callback(bench.cage.zero), before anything is energised"
ZERO_A = 0.002
BEGINS = datetime(2026, 1, 1, tzinfo=UTC)


class PutIn(Exception):
    """The fault that is put in here."""


@dataclass
class ProcedureTrial:
    """One run of a procedure on a bench of its own, to which `happens` is done when item `at` has been kept."""

    found: FoundProcedure
    given: Mapping[str, str]
    bench_file: Path
    answer: Answer
    at: int = -1
    happens: Callable[[ProcedureTrial], None] = lambda trial: None
    control: Control = field(default_factory=Control)
    items: list[Item] = field(default_factory=list)
    left_A: float = 0.0  # the largest true current as the procedure itself was over, before the runner zeroes anything
    raised: bool = False
    energised: bool = False  # as the last item was kept
    hands_near: list[tuple[str, Item]] = field(default_factory=list)  # what began before anybody said "hands off"

    def run(self) -> Ending:
        """Drive it to its end."""
        with closing(open_bench(self.bench_file, clock=VirtualClock(BEGINS), seed=2)) as self.bench:
            drive = Drive(self.bench, lambda item: None, self.answer, self.control, self._notice)
            return drive.run(self._witnessed(self.found.function(self.bench, **self.values())))

    def values(self) -> dict[str, Any]:
        """Its settings as the runner would hand them in."""
        return settings(self.found.parameters, self.given)

    def _notice(self, item: Item) -> None:
        self.items.append(item)
        self._watch_hands(item)
        if len(self.items) - 1 == self.at:
            self.happens(self)

    def _watch_hands(self, item: Item) -> None:
        before, self.energised = self.energised, largest_A(self.bench) > ZERO_A
        if self.bench.hands_near and self.energised and not before:
            self.hands_near.append(("energises", item))
        if self.bench.hands_near and turns(self.bench):
            self.hands_near.append(("turns the platform", item))

    def _witnessed(self, procedure: Procedure) -> Procedure:
        try:
            yield from procedure
        finally:
            self.left_A = largest_A(self.bench)


def largest_A(bench: Bench) -> float:
    """The largest current that truly flows in a coil, asked of the physics and not of any instrument."""
    lab: Any = bench.simulated_operator
    now = [bench.clock.now()]
    return max(abs(float(coil.at(now)[0])) for coil in lab._lab.coils.values())


def turns(bench: Bench) -> bool:
    """Whether the platform truly turns."""
    lab: Any = bench.simulated_operator
    return bool(lab._lab.platform.moving(bench.clock.now()))


def stop(trial: ProcedureTrial) -> None:
    """The operator stops."""
    trial.control.stop()


def abort(trial: ProcedureTrial) -> None:
    """The operator aborts: the runner zeroes the coils first."""
    trial.control.abort()


def ctrl_c(trial: ProcedureTrial) -> None:
    """In a script, where nobody turns it into a stop."""
    raise KeyboardInterrupt


def exception(trial: ProcedureTrial) -> None:
    """A fault where the procedure next listens or sets a current."""

    def faulty(*_: Any, **__: Any) -> Any:
        trial.raised = True
        raise PutIn("put in by labcal.testing")

    trial.bench.stream_until = faulty  # type: ignore[method-assign]
    trial.bench.cage.set_currents = faulty  # type: ignore[method-assign]


WAYS_OUT: dict[Callable[[ProcedureTrial], None], tuple[str, str]] = {
    stop: ("a stop", "stopped"),
    abort: ("an abort", "failed: aborted by the operator"),
    ctrl_c: ("Ctrl-C", "stopped"),
    exception: ("an exception", "failed: put in by labcal.testing"),
}


def check_procedure(
    procedure: str | Callable[..., Procedure],
    given: Mapping[str, str] | None = None,
    *,
    bench: Path | None = None,
    moments: int = 8,
    answer: Answer = first_choice,
) -> None:
    """Run a procedure (its name, file or function) with the settings `given`, then leave it at `moments` of its items.

    It must finish, keep a record that can be read, hear "hands off" before it energises or turns anything, and have
    the coils at zero when it is over, by its own undo: at its end and after a stop, an abort, Ctrl-C and an exception
    at each moment. `bench` is a bench file with emulated links, the simulated bench where it is not stated.
    Raises AssertionError.
    """
    trial = ProcedureTrial(_found(procedure), given or {}, bench or simulated_bench(), answer)
    check_words(trial.found)
    check_record(trial)
    items = check_normal_end(trial)
    for at in chosen(items, moments):
        for way in WAYS_OUT:
            check_way_out(trial, way, at, items[at])


def _found(procedure: str | Callable[..., Procedure]) -> FoundProcedure:
    if isinstance(procedure, str):
        with answered("Register it in labcal.procedures, or name its file."):
            return find(procedure)
    name = getattr(procedure, "__name__", "?")
    text = f"{name} is no generator function: it yields what it measures, and is given the bench."
    require(inspect.isgeneratorfunction(procedure), text)
    source = Path(inspect.getsourcefile(procedure) or "")
    return FoundProcedure(name.replace("_", "-"), procedure, parameters_of(procedure), source)


def check_words(found: FoundProcedure) -> None:
    """It says what it does, and each setting its meaning."""
    require(inspect.getdoc(found.function), f"{found.name} has no docstring: its first line is its title.")
    for spec in found.parameters:
        text = f"setting {spec.name} of {found.name} has no words: Annotated[…, Limits(…), 'what it is']"
        require(spec.help, text)


def check_record(trial: ProcedureTrial) -> None:
    """It finishes through the runner, and its record can be read back."""
    with (
        tempfile.TemporaryDirectory() as folder,
        closing(open_bench(trial.bench_file, clock=VirtualClock(BEGINS), seed=2)) as bench,
        Store.open(Path(folder) / "store.sqlite") as store,
    ):
        outcome = run_procedure(bench, trial.found, trial.given, store=store, answer=trial.answer, dut_serial="T-1")
        text = f"{trial.found.name} ends as {outcome.status!r} on the simulated bench, not as 'finished'."
        require(outcome.status == "finished", text)
        require(list(store.items(outcome.run_id)), f"{trial.found.name} records nothing: yield what is measured.")


def check_normal_end(trial: ProcedureTrial) -> list[Item]:
    """It leaves zero at its end, and nothing began under somebody's hands; what it yielded."""
    ending = trial.run()
    require(ending.status == "finished", f"{trial.found.name} ends as {ending.status!r} when it is run a second time.")
    _at_zero(trial, "at its end")
    for does, item in trial.hands_near[:1]:
        asks = "hands off: yield from ready(bench, 'The coils go on. Hands off?') after the last question before that."
        require(False, f"{trial.found.name} {does} at {_named(item)} where nobody has said {asks}")
    return trial.items


def check_way_out(trial: ProcedureTrial, way: Callable[[ProcedureTrial], None], at: int, item: Item) -> None:
    """It is at zero after this way out at item number `at`, and the status says how it ended."""
    again = ProcedureTrial(trial.found, trial.given, trial.bench_file, trial.answer, at, way)
    ending, (words, status) = again.run(), WAYS_OUT[way]
    when = f"after {words} at {_named(item)}"
    _at_zero(again, when)
    if way is exception and not again.raised:
        return  # it neither listened nor set a current any more
    text = f"{again.found.name} ends as {ending.status!r} {when}, not as {status!r}: let what it does not know pass."
    require(ending.status.startswith(status), text)


def _at_zero(trial: ProcedureTrial, when: str) -> None:
    text = f"{trial.found.name} leaves {trial.left_A:.3g} A in a coil {when}: {UNDO}."
    require(trial.left_A <= ZERO_A, text)


def chosen(items: Sequence[Item], most: int) -> list[int]:
    """Numbers of at most `most` items, evenly among those where something begins and those just after."""
    begins = [n for n, item in enumerate(items) if isinstance(item, Step | SegmentOpened | Prompt) or _energises(item)]
    places = sorted({n for b in begins for n in (b, b + 1) if n < len(items)} or {0})
    if len(places) <= most:
        return places
    return sorted({places[round(k * (len(places) - 1) / max(most - 1, 1))] for k in range(most)})


def _energises(item: Item) -> bool:
    return isinstance(item, Event) and item.kind == "set-point"


def _named(item: Item) -> str:
    word = getattr(item, "name", getattr(item, "kind", getattr(item, "key", "")))
    return f"{type(item).__name__} {word!r}, t = {_time(item):.1f} s" if word else type(item).__name__


def _time(item: Item) -> float:
    return float(item.t_s[-1]) if isinstance(item, Block) else float(item.t_s)
