"""What people read on the terminal: nothing that a file, an instrument or a person put into it acts there."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from labcal.files.text_safety import one_line, replace_unseen

if TYPE_CHECKING:
    from rich.console import Console


def say(*texts: object, err: bool = False, end: str = "\n") -> None:
    """Print one line to stdout, or to stderr (`err`)."""
    print(*(one_line(str(text)) for text in texts), end=end, file=sys.stderr if err else sys.stdout, flush=True)


def say_lines(lines: Iterable[object], *, err: bool = False) -> None:
    """Print each on a line of its own."""
    if said := [one_line(str(line)) for line in lines]:
        print("\n".join(said), file=sys.stderr if err else sys.stdout, flush=True)


def aligned(rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """The rows as lines, each column as wide as its widest cell: ten thousand of them at once."""
    columns = [[*_of_one_width(column)] for column in zip(*rows, strict=True)]
    return ("  ".join(row).rstrip() for row in zip(*columns, strict=True))


def _of_one_width(cells: Sequence[str]) -> Iterator[str]:
    if _one_place_each("".join(cells)):
        width = max(map(len, cells))
        return (cell.ljust(width) for cell in cells)
    width = max(map(_width, cells))
    return (cell + " " * (width - _width(cell)) for cell in cells)


def _one_place_each(text: str) -> bool:
    """Whether each of its characters takes one place on a terminal."""
    return text.isascii() and text.isprintable()


def _width(cell: str) -> int:
    """How many places the cell takes on a terminal."""
    if _one_place_each(cell):
        return len(cell)
    from rich.cells import cell_len

    return cell_len(cell)


def console(**options: Any) -> Console:
    """A console whose tables and sentences carry nothing that acts: colours and the bar's movements are its own."""
    from rich.console import Console, ConsoleOptions, RenderableType
    from rich.segment import Segment

    class Seen(Console):
        def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Any:
            for part in super().render(renderable, options):
                yield part if part.control else Segment(replace_unseen(part.text), part.style)

    return Seen(markup=False, emoji=False, **options)
