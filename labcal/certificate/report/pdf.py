"""A page as PDF on A4 sheets, set with matplotlib: the same content as the HTML, no browser needed."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import IO, TYPE_CHECKING, cast

from labcal.certificate.report.page import Block, Facts, Headline, Page, Plot, Prose, Table
from labcal.certificate.report.style import BAD, GOOD, LINE, MUTED, TEXT, WARNING, WIDTH_IN, plot_style

if TYPE_CHECKING:
    from matplotlib.backends.backend_pdf import PdfPages
    from matplotlib.figure import Figure

WIDE, HIGH = 8.27, 11.69  # A4 [in]
LEFT, TOP, BOTTOM = (WIDE - WIDTH_IN) / 2, 0.75, 0.75  # margins [in]
POINT = 1 / 72  # [in]
TONES = {"good": GOOD, "warning": WARNING, "bad": BAD, "plain": MUTED}
TIGHTER = (1.0, 0.95, 0.9, 0.85, 0.8)  # figures and gaps of their own height, or lower where that saves a sheet
LETTER = 0.52  # mean width of a letter, of its height; where lines are broken


def write_pdf(page: Page, path: Path) -> None:
    """Write `page` to `path`; the bytes depend on the content alone."""
    from matplotlib.backends.backend_pdf import PdfPages

    metadata = {
        "Title": f"{page.title} · {page.kind}",
        "Creator": "labcal",
        "Producer": "matplotlib",
        "CreationDate": None,
    }
    with plot_style(), PdfPages(path, metadata=metadata) as out:
        _set(_Sheets(out, page, _tightness(page)), page)


def _tightness(page: Page) -> float:
    """The loosest of `TIGHTER` that needs no more sheets than the tightest: no group stands alone that would fit."""
    counts = {each: _set(_Sheets(None, page, each), page) for each in TIGHTER}
    return next(each for each in TIGHTER if counts[each] == min(counts.values()))


def _set(sheets: _Sheets, page: Page) -> int:
    """Everything in its order; how many sheets it took."""
    _header(sheets, page)
    for section in page.sections:
        sheets.need(_together(section.blocks, sheets.tight) + 0.5)
        sheets.space(0.2)
        sheets.text(section.heading, 11, weight="bold")
        sheets.rule()
        for block in section.blocks:
            _block(sheets, block)
    sheets.space(0.15)
    sheets.text(page.footer, 7.5, MUTED)
    sheets.close()
    return sheets.count


class _Sheets:
    """Sheets filled from the top; `y` is how far down [in] the next line goes. Without `out` they are only counted.

    `tight`: of their own height figures and gaps have so much.
    """

    def __init__(self, out: PdfPages | None, page: Page, tight: float) -> None:
        self.out, self.page, self.tight, self.count = out, page, tight, 0
        self.open()

    def open(self) -> None:
        from matplotlib.figure import Figure

        self.sheet: Figure = Figure(figsize=(WIDE, HIGH), layout="constrained")
        self.y = TOP
        self.count += 1
        if self.page.simulated:
            self.put(WIDE / 2, 0.45, "S I M U L A T E D", 9, WARNING, weight="bold", align="center")
        self.put(LEFT, HIGH - 0.45, f"labcal · {self.page.kind} · {self.page.title}", 7, MUTED)
        self.put(WIDE - LEFT, HIGH - 0.45, str(self.count), 7, MUTED, align="right")

    def close(self) -> None:
        if self.out is not None:
            self.sheet.savefig(cast("IO[bytes]", self.out), format="pdf")  # matplotlib appends a sheet to its PdfPages

    def need(self, height: float) -> None:
        """Go to a new sheet unless `height` inches are left on this one."""
        if self.y + min(height, HIGH - TOP - BOTTOM) > HIGH - BOTTOM:
            self.close()
            self.open()

    def space(self, height: float) -> None:
        self.y += height * self.tight

    def line(self, height: float) -> None:
        """Past what stands in a line: letters are as high as they are."""
        self.y += height

    def put(
        self,
        x: float,
        y: float,
        text: str,
        size: float,
        colour: str = TEXT,
        *,
        weight: str = "normal",
        align: str = "left",
    ) -> None:
        """One line with its top at (`x`, `y`) [in from the upper left]; dollars and the like mean themselves."""
        if self.out is None:
            return
        self.sheet.text(
            x / WIDE, 1 - y / HIGH, text, size=size, color=colour, weight=weight, ha=align, va="top", parse_math=False
        )

    def text(
        self, text: str, size: float = 8.5, colour: str = TEXT, *, weight: str = "normal", indent: float = 0
    ) -> None:
        """A paragraph, broken into lines of the sheet's width."""
        for line in _lines(text, WIDTH_IN - indent, size):
            self.need(size * 1.4 * POINT)
            self.put(LEFT + indent, self.y, line, size, colour, weight=weight)
            self.y += size * 1.4 * POINT

    def rule(self) -> None:
        from matplotlib.lines import Line2D

        self.y += 0.03
        x, y = [LEFT / WIDE, 1 - LEFT / WIDE], [1 - self.y / HIGH] * 2
        self.sheet.add_artist(Line2D(x, y, color=LINE, lw=0.7))
        self.y += 0.06

    def plot(self, plot: Plot) -> None:
        """The figure, over the sheet's width."""
        high = plot.height_in * self.tight
        self.need(high + 0.3)
        if self.out is not None:
            heights = (self.y, high, HIGH - self.y - high)
            grid = self.sheet.add_gridspec(3, 3, height_ratios=heights, width_ratios=(LEFT, WIDTH_IN, LEFT))
            plot.draw(self.sheet.add_subfigure(grid[1, 1]))
        self.y += high


def _header(sheets: _Sheets, page: Page) -> None:
    sheets.text(page.title, 20, weight="bold")
    sheets.space(0.04)
    sheets.text(page.subtitle, 9, MUTED)
    x = LEFT
    for mark in page.marks:
        sheets.put(x, sheets.y + 0.08, mark.word, 9, TONES[mark.tone], weight="bold")
        x += len(mark.word) * 9 * POINT * 0.72 + 0.25
    sheets.space(0.4 if page.marks else 0.12)
    if page.summary:
        sheets.text(page.summary, 10)
        sheets.space(0.1)
    if isinstance(page.headline, Headline):
        sheets.text(f"{page.headline.before} → {page.headline.after} {page.headline.unit}", 22)
        sheets.space(0.05)
        sheets.text(page.headline.caption, 8, MUTED)
        sheets.space(0.12)
    _facts(sheets, page.facts)


def _block(sheets: _Sheets, block: Block) -> None:
    match block:
        case Facts():
            _facts(sheets, block)
        case Table():
            _table(sheets, block)
        case Prose():
            for sentence in block.sentences:
                bullet = "•  " if len(block.sentences) > 1 else ""
                sheets.text(bullet + sentence)
        case Plot():
            sheets.plot(block)
            sheets.text(block.caption, 7.5, MUTED)
    sheets.space(0.08)


def _facts(sheets: _Sheets, facts: Facts) -> None:
    for name, value in facts.rows:
        lines = _lines(value, WIDTH_IN - 1.6, 8.5) or ["–"]
        sheets.need(len(lines) * 0.165)
        sheets.put(LEFT, sheets.y, name, 8.5, MUTED)
        for line in lines:
            sheets.put(LEFT + 1.6, sheets.y, line, 8.5)
            sheets.line(0.165)


def _table(sheets: _Sheets, table: Table) -> None:
    widths = _widths(table)
    sheets.need(0.55)
    _row(sheets, table, table.header, widths, MUTED)
    sheets.rule()
    for row in table.rows:
        if len(row) < len(table.header):  # the heading of those below it
            sheets.need(0.32)
            sheets.text(" ".join(row), 8, MUTED)
        else:
            _row(sheets, table, row, widths, MUTED if row[0] in ("", "U") else TEXT)
    if table.caption:
        sheets.space(0.03)
        sheets.text(table.caption, 7.5, MUTED)


def _row(sheets: _Sheets, table: Table, row: tuple[str, ...], widths: list[float], colour: str) -> None:
    cells = [_lines(cell, width - 0.1, 8) for cell, width in zip(row, widths, strict=True)]
    height = max(1, *map(len, cells)) * 0.16
    sheets.need(height)
    x = LEFT
    for column, (lines, width) in enumerate(zip(cells, widths, strict=True)):
        right = column in table.numeric
        for i, line in enumerate(lines):
            place = x + width - 0.15 if right else x
            sheets.put(place, sheets.y + i * 0.16, line, 8, colour, align="right" if right else "left")
        x += width
    sheets.line(height)


def _widths(table: Table) -> list[float]:
    """Column widths [in] that share the sheet by their longest cells; none is starved by a talkative one."""
    whole = [row for row in (table.header, *table.rows) if len(row) == len(table.header)]
    longest = [max(len(row[i]) for row in whole) for i in range(len(table.header))]
    wanted = [min(length, 46) + 2 for length in longest]
    return [WIDTH_IN * w / sum(wanted) for w in wanted]


def _lines(text: str, width: float, size: float) -> list[str]:
    letters = max(4, int(width / (size * POINT * LETTER)))
    return textwrap.wrap(text, letters)


def _together(blocks: tuple[Block, ...], tight: float) -> float:
    """Height [in] that a heading keeps with it: its first figure, or a few lines."""
    for before, block in enumerate(blocks):
        if isinstance(block, Plot):
            return 0.4 * before + block.height_in * tight
    return 0.5
