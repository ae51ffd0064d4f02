"""What a run shows on stderr while it goes on: a bar for people, a line of JSON an item for programs, or nothing."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import asdict
from typing import TYPE_CHECKING, Protocol

from labcal.cli.screen import console, say
from labcal.errors import InputError, Stopped

if TYPE_CHECKING:
    from rich.progress import Progress

    from labcal.record.stream import Event, Item, Prompt


AT_ONCE = ("silent", "link lost", "heard again", "reconnected")  # of an instrument, while the run still goes on


class Display(Protocol):
    """Shows items as they come, and asks what has to be asked."""

    def on_item(self, item: Item) -> None:
        """Show one item."""
        ...

    def stopping(self) -> None:
        """Say that the end was heard: an instrument that does not answer may keep the last word for seconds."""
        ...

    def ask(self, prompt: Prompt) -> str:
        """Ask the person at the terminal."""
        ...

    def aside(self) -> AbstractContextManager[None]:
        """What is shown stands aside while something else is said or asked."""
        ...


@contextmanager
def shown(how: str) -> Iterator[Display]:
    """The display `how`: "bar", "json" or "none"."""
    if how != "bar":
        yield JsonLines() if how == "json" else Nothing()
        return
    from rich.progress import BarColumn, Progress, TextColumn

    columns = (TextColumn("{task.description:<28}", markup=False), BarColumn(), TextColumn("{task.fields[left]}"))
    with at_a_terminal(Progress(*columns, console=console(stderr=True), transient=True)) as progress:
        yield Bar(progress)


@contextmanager
def at_a_terminal(progress: Progress) -> Iterator[Progress]:
    """The bar at work; nothing of it, no empty line either, where it would go into a file or a pipe."""
    if not progress.console.is_terminal:
        yield progress
        return
    with progress:
        yield progress


def step_line(step: str) -> None:
    """One step of what takes long, for who sits at a terminal."""
    if sys.stderr.isatty():
        say(f"{step} …", err=True)


class Nothing:
    """Shows nothing; asks all the same."""

    def on_item(self, item: Item) -> None:
        """Show nothing."""

    def stopping(self) -> None:
        """Show nothing."""

    def ask(self, prompt: Prompt) -> str:
        """Ask on the terminal until one of the choices is said."""
        if not sys.stdin.isatty():
            raise InputError(f"nobody is there to answer: {prompt.text} (at a terminal, or with --yes on a simulation)")
        return _until_valid(prompt)

    @contextmanager
    def aside(self) -> Iterator[None]:
        """Nothing is in the way."""
        yield


class JsonLines(Nothing):
    """One JSON object a line for each step, measurement, prompt and event."""

    def on_item(self, item: Item) -> None:
        """Write it, unless it is samples."""
        from labcal.record.stream import Block, Measurement

        if isinstance(item, Block):
            return
        verdict = {"verdict": item.verdict} if isinstance(item, Measurement) else {}
        said = {"item": type(item).__name__.lower(), **asdict(item), **verdict}
        try:
            say(json.dumps(said, default=str), err=True)
        except BrokenPipeError:
            sys.stderr = open(os.devnull, "w")  # noqa: SIM115  what is said at the end finds nobody, and must not fail
            raise Stopped("nobody reads the progress any more") from None


class Bar(Nothing):
    """Step n of m with the lab time left; measurements with their verdict, and instruments lost, as they come."""

    def __init__(self, progress: Progress) -> None:
        self._progress = progress
        self._task = progress.add_task("starting", total=None, left="")

    def on_item(self, item: Item) -> None:
        """Move the bar at a step, print a measurement that has a limit."""
        from labcal.record.stream import NOT_KEPT, REMARK, Event, Measurement, Step

        if isinstance(item, Event) and (item.kind in (NOT_KEPT, REMARK) or _of_a_stream_at_once(item)):
            self._progress.console.print(f"! {item.text}", highlight=False, markup=False)
        if isinstance(item, Event) and item.kind == "slow-zero":
            self._progress.console.print(item.text, highlight=False, markup=False)
        if isinstance(item, Step):
            left = f"step {item.number} of {item.total} · {clock_face(item.left_s)} left"
            self._progress.update(
                self._task, description=item.name, total=item.total, completed=item.number - 1, left=left
            )
        if isinstance(item, Measurement) and item.limit is not None:
            value = f"{item.value:.4g} ± {2 * item.u:.2g} {item.unit} (limit {item.limit:g})"
            self._progress.console.print(f"{item.verdict:<13} {item.name}: {value}", highlight=False)

    def stopping(self) -> None:
        """Above the bar, at once."""
        self._progress.console.print("stopping; how the coils are is said once it was read back", highlight=False)

    def ask(self, prompt: Prompt) -> str:
        """Ask with the bar out of the way."""
        with self.aside():
            return super().ask(prompt)

    @contextmanager
    def aside(self) -> Iterator[None]:
        """Without the bar, which would write over what is asked."""
        if not self._progress.live.is_started:
            yield
            return
        self._progress.stop()
        try:
            yield
        finally:
            self._progress.start()


def _of_a_stream_at_once(event: Event) -> bool:
    return event.kind == "stream" and event.data.get("fault") in AT_ONCE


def clock_face(seconds: float) -> str:
    """Seconds as minutes and seconds: 6:40."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def _until_valid(prompt: Prompt) -> str:
    """An answer that counts, in either case of letters; Enter gives the only choice there is."""
    choices, only = "/".join(prompt.choices), len(prompt.choices) == 1
    shown = f" [{choices}{', or Enter' if only else ''}]" if choices else ""
    while True:
        say(f"{prompt.text}{shown} ", end="", err=True)
        given = sys.stdin.readline()
        if not given:
            raise InputError(f"nobody answered: {prompt.text}")
        said = given.strip()
        if not prompt.choices:
            return said
        if only and not said:
            return prompt.choices[0]
        if said.lower() in prompt.choices:
            return said.lower()
        say(f"{said!r} is no answer here: say {choices}.", err=True)
