"""What a run that broke off had finished, read from its record."""

from __future__ import annotations

from collections.abc import Iterable

from labcal.bench.steps import Resume
from labcal.record.stream import NOT_USED, RESUMED, Event, Item, Measurement, Step


def resume_state(items: Iterable[Item]) -> Resume:
    """What an interrupted run had finished, and the first value of every measurement.

    A step is finished where another followed it before the run broke off, or broke off again. What was marked as not
    used is not. A step that its procedure began anew counts as it was at last, and what followed it before as little.
    """
    earlier, measured, stretch, times = set[str](), dict[str, float](), _Stretch(), 1
    for item in items:
        if isinstance(item, Event) and item.kind == RESUMED:
            earlier, measured = stretch.after(earlier, measured)
            stretch, times = _Stretch(), times + 1
        elif isinstance(item, Event) and item.kind == NOT_USED:
            earlier -= set(item.data["segments"])
            stretch.done -= set(item.data["segments"])
        else:
            stretch.take(item)
    done, measured = stretch.after(earlier, measured)
    return Resume(frozenset(done), measured, times)


class _Stretch:
    """From where a run began, or was gone on with, to where it broke off."""

    def __init__(self) -> None:
        self.begun, self.done, self.measured = list[str](), set[str](), dict[str, float]()

    def take(self, item: Item) -> None:
        if isinstance(item, Step):
            self.done |= set(self.begun[-1:])
            if item.name in self.begun:
                self._undo(self.begun.index(item.name))
            self.begun.append(item.name)
        elif isinstance(item, Measurement):
            self.measured.setdefault(item.name, item.value)

    def _undo(self, index: int) -> None:
        undone, self.begun = self.begun[index:], self.begun[:index]
        self.done -= set(undone)
        closures = [name.replace("-", " ", 1) for name in undone if name.startswith("closure-")]
        of_them = (*(f"{name}: " for name in undone), *closures)
        self.measured = {name: value for name, value in self.measured.items() if not name.startswith(of_them)}

    def after(self, done: set[str], measured: dict[str, float]) -> tuple[set[str], dict[str, float]]:
        """Both as they are once this stretch came after them.

        Where all that was finished was begun again, the run began anew, and these values are its first.
        """
        values = measured | self.measured if done <= set(self.begun) else self.measured | measured
        return done | self.done, values
