"""A report page as content: what it says, in the order it says it. `html` and `pdf` give it a shape."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

Tone = Literal["good", "warning", "bad", "plain"]


@dataclass(frozen=True, slots=True)
class Mark:
    """A word that must not be overlooked: VALID, PROVISIONAL, NOT SIGNED."""

    word: str
    tone: Tone


@dataclass(frozen=True, slots=True)
class Headline:
    """Two numbers large, and what they are: before → after."""

    before: str
    after: str
    unit: str
    caption: str


@dataclass(frozen=True, slots=True)
class LargeNumber:
    """One number large, and what it is."""

    value: str
    unit: str
    caption: str


@dataclass(frozen=True, slots=True)
class Front:
    """What makes a page a certificate: number as printed, what stands at the foot of every sheet and across it.

    `images` and `code` (a QR code of what is signed) are data: addresses; `attached` are the files that its PDF holds,
    by name: bytes and what they are.
    """

    number: str
    foot: str
    stamp: str
    images: tuple[str, ...] = ()
    code: str = ""
    attached: tuple[tuple[str, bytes, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Facts:
    """Names and values, two columns."""

    rows: tuple[tuple[str, str], ...]
    kind: Literal["facts"] = "facts"


@dataclass(frozen=True, slots=True)
class Table:
    """Rows under a header; `numeric` columns stand flush right."""

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    numeric: frozenset[int] = frozenset()
    caption: str = ""
    kind: Literal["table"] = "table"


@dataclass(frozen=True, slots=True)
class Prose:
    """Sentences; several are a list."""

    sentences: tuple[str, ...]
    kind: Literal["prose"] = "prose"


@dataclass(frozen=True, slots=True, eq=False)
class Plot:
    """A figure: `draw` puts its axes on the figure it is handed, `height_in` inches high at the page's width."""

    draw: Callable[[FigureBase], None]
    height_in: float
    caption: str
    kind: Literal["plot"] = "plot"


Block = Facts | Table | Prose | Plot


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """A heading and what stands below it."""

    heading: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Page:
    """One report."""

    kind: str
    title: str
    subtitle: str
    simulated: bool
    facts: Facts
    sections: tuple[Section, ...]
    marks: tuple[Mark, ...] = ()
    summary: str = ""
    headline: Headline | LargeNumber | None = None
    footer: str = ""
    front: Front | None = None


def section(heading: str, blocks: Sequence[Block | None]) -> Section | None:
    """A section of the blocks that are there; None where none is."""
    there = tuple(block for block in blocks if block is not None)
    return Section(heading, there) if there else None


def sections(*given: Section | None) -> tuple[Section, ...]:
    """The sections that are there."""
    return tuple(s for s in given if s is not None)
