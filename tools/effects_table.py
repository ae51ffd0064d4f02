"""The table of labcal's own effects in docs/closed-loop.md, from their files: `effects_table.py [FILE]`."""

from __future__ import annotations

import sys
from pathlib import Path

from labcal.model.effects import families

BEGIN, END = "<!-- effects: tools/effects_table.py -->\n", "<!-- end of effects -->\n"


def table() -> str:
    """One row an effect, in Markdown: its id, whose it is, how its file begins, what would show it."""
    lines = ["| effect | of | what happens | what would show it |", "|---|---|---|---|"]
    for family in families():
        module = sys.modules[family.kernel.__module__]
        if module.__name__.startswith("labcal."):
            said = " ".join((module.__doc__ or "").split("\n\n")[0].split())
            lines.append(f"| `{family.id}` | {family.belongs_to} | {said} | {family.experiment} |")
    return "\n".join(lines) + "\n"


def with_table(text: str) -> str:
    """The page with the table of today between its two marks."""
    before, rest = text.split(BEGIN)
    return f"{before}{BEGIN}\n{table()}\n{END}{rest.split(END)[1]}"


if __name__ == "__main__":
    page = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1] / "docs" / "closed-loop.md")
    page.write_text(with_table(page.read_text(encoding="utf-8")), encoding="utf-8")
