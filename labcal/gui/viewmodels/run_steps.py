"""The steps of a run and how far each is: done, going on, to come, left out or broken off."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Literal

from labcal.record.stream import Step

Mark = Literal["done", "now", "next", "skipped", "broken"]


def marks_of(
    names: Sequence[str],
    at: int,
    here: Mark,
    measured: Collection[str],
    skipped: Collection[str],
    *,
    broken_off: bool = False,
) -> list[Mark]:
    """A mark for each of the steps `names`, of which number `at` is reached and stands as `here` says.

    `measured`: names of what was measured. A step that comes later and is kept from before an interruption is done.
    `broken_off`: it may be gone on with; where no turn is done that uses nothing, and no step is done.
    """
    out = left_out(names[:at], measured, skipped)
    before: list[Mark] = ["skipped" if name in out else "done" for name in names[:at]]
    later: list[Mark] = ["done" if _is_kept(name, names, measured) else "next" for name in names[at + 1 :]]
    marks = [*before, *([here] if at < len(names) else []), *later]
    if broken_off and uses_none(zip(names, marks, strict=True)):
        return ["next" if mark == "done" else mark for mark in marks]
    return marks


def uses_none(steps: Iterable[tuple[str, Mark]]) -> bool:
    """Whether one that is gone on with uses nothing of before: it was to turn, and no turn was finished."""
    turns = [mark for name, mark in steps if name_a_turn((name,))]
    return bool(turns) and "done" not in turns


def name_a_turn(steps: Sequence[str]) -> bool:
    """Whether one of them is a turn about a body axis: x+20uT-nominal."""
    return any(step[:1] in ("x", "y", "z") and step[1:2] in ("+", "-") for step in steps)


def in_turn(segment: str | None, step: Step | None) -> bool:
    """Whether one is being recorded, or its step has begun: on the way to its field nothing of it is seen yet."""
    return segment is not None or (step is not None and name_a_turn((step.name,)))


def may_pause(state: str, step: Step | None, *, pausing: bool) -> bool:
    """Whether it may be asked to, or to go on after it: where the next step begins it pauses, and the last has none."""
    last = step is not None and step.number == step.total
    return state == "paused" or (state in ("running", "asking") and not pausing and not last)


def axis_of(name: str) -> str:
    """The body axis that a step or segment is about: x of x+20uT-nominal, mount-x and closure-x; "" of others."""
    axis = name.removeprefix("mount-").removeprefix("closure-")
    return axis[:1] if axis in ("x", "y", "z") or name_a_turn((axis,)) else ""


def kind_of(name: str) -> str:
    """What a step has in common with others of a run: a turn, a mounting, a closure; else it is one of its own."""
    return "turn" if name_a_turn((name,)) else name.partition("-")[0] if axis_of(name) else name


def to_come(names: Sequence[str], step: Step | None, until: str) -> Sequence[str]:
    """The step that goes on and those after it, to the end or `until` another one."""
    if step is None or step.name not in names:
        return ()
    rest = names[names.index(step.name) :]
    return rest[: rest.index(until)] if until in rest else rest


def axes_of(names: Iterable[str]) -> list[str]:
    """The body axes that steps or segments are about; all where none says so."""
    about = set(map(axis_of, names))
    return [axis for axis in "xyz" if axis in about] or list("xyz")


def left_out(names: Sequence[str], measured: Collection[str], skipped: Collection[str]) -> list[str]:
    """Which of the steps `names`, that are past, were skipped, or broken off and not repeated, in their order."""
    return [name for name in names if name in skipped or _is_missing(name, measured)]


def _is_missing(step: str, measured: Collection[str]) -> bool:
    """A closure that was broken off: what it is of is mounted no more."""
    return step.startswith("closure-") and step.replace("-", " ", 1) not in measured


def _is_kept(step: str, names: Sequence[str], measured: Collection[str]) -> bool:
    """Turns are not repeated, nor what mounts and closes an axis with its turns, unless that closure is made up."""
    kind, _, axis = step.partition("-")
    if axis and kind == "closure":
        return not _is_missing(step, measured)
    if axis and kind == "mount":
        turns = [name for name in names if name.startswith((f"{axis}+", f"{axis}-"))]
        to_close = f"closure-{axis}" in names and _is_missing(f"closure-{axis}", measured)
        made_up = to_close and any(name.startswith(f"{step}: ") for name in measured)  # with what it began with
        return not made_up and bool(turns) and all(_is_kept(name, names, measured) for name in turns)
    return any(name.startswith(f"{step}:") for name in measured)
