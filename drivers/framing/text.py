"""Lines of text with a number for each column, and nothing else that could be taken for one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from drivers.framing.columns import ColumnMap, numbers
from drivers.framing.mishaps import Mishaps
from drivers.framing.sent_lines import Rows, SentLines


@dataclass(frozen=True)  # without slots, so that a column map can stand beside it
class Text:
    """`decimal` point or comma; lines that begin with `comment` are skipped, longer ones than `longest` are noise."""

    delimiter: str = ","
    decimal: Literal[".", ","] = "."
    comment: str = "#"
    longest: int = 1000

    def __post_init__(self) -> None:
        if not self.delimiter or self.delimiter == self.decimal:
            raise ValueError("delimiter must be there, and another sign than the decimal point or comma")


class TextRows:
    """The first line after the start may be cut and is dropped; what is no good is noted."""

    def __init__(self, text: Text, columns: ColumnMap, mishaps: Mishaps) -> None:
        self._text, self._columns, self._mishaps = text, columns, mishaps
        self._lines = SentLines(mishaps, text.longest)

    def feed(self, pieces: Sequence[tuple[float, bytes]]) -> Rows:
        """Stamps, rows and raw lines that these pieces complete."""
        return self._lines.rows(pieces, self._row)

    def _row(self, stamp: float, line: bytes) -> list[float] | None:
        words = line.strip(b"\r \0").decode("latin-1")
        if self._text.comment and words.startswith(self._text.comment):
            return None
        if (row := numbers(words.split(self._text.delimiter), self._columns, self._text.decimal)) is None:
            self._mishaps.note("bad frame", stamp)
        return row
