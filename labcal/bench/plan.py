"""What a procedure will do, step by step, with lab times; and what an interruption has kept of it."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.bench.bench import Bench
from labcal.record.stream import Step


@dataclass(frozen=True, slots=True)
class Plan:
    """What a procedure will do: names and lab time of its steps, so that each can say what is left.

    `asks`: the steps that begin with a question to a person, so that each can say when the next one comes.
    `kept_s`: the lab time of what an interruption has kept, which counts as done.
    """

    steps: tuple[tuple[str, float], ...]  # name, s
    asks: frozenset[str] = frozenset()
    kept_s: float = 0.0

    def begin(self, bench: Bench, name: str) -> Step:
        """The item that opens the step `name`."""
        names = tuple(n for n, _ in self.steps)
        number = names.index(name)
        left = sum(seconds for _, seconds in self.steps[number:])
        first = names if number == 0 else ()
        asking = next((n for n in range(number + 1, len(names)) if names[n] in self.asks), None)
        until = None if asking is None else sum(seconds for _, seconds in self.steps[number:asking])
        needed = "" if asking is None else names[asking]
        took, whole = self.steps[number][1], self.kept_s + sum(seconds for _, seconds in self.steps)
        return Step(bench.clock.now(), number + 1, len(self.steps), name, left, first, took, until, needed, whole)


@dataclass(frozen=True, slots=True)
class Resume:
    """What an interrupted run had finished, given to a procedure that declares the keyword `resume`.

    `done`: names of finished steps. `measured`: the first value of each measurement by name. `times`: how often it was
    gone on with, this time included.
    """

    done: frozenset[str]
    measured: dict[str, float]
    times: int = 1
