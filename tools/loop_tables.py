"""The tables of docs/closed-loop.md that labcal's own files state, judgements and effects: `loop_tables.py [FILE]`."""

from __future__ import annotations

import sys
from pathlib import Path

from labcal.loop.policy import judgements
from labcal.model.effects import families


def judgements_table() -> str:
    """One row a judgement of `labcal.loop.policy`, in Markdown."""
    lines = ["| judgement | value | decides | source |", "|---|---|---|---|"]
    for name, stated in judgements().items():
        value = f"{stated.value:.3g} {stated.unit}".strip()
        lines.append(f"| `{name}` | {value} | {stated.decides} | {stated.source}: {stated.why} |")
    return "\n".join(lines) + "\n"


def effects_table() -> str:
    """One row an effect of labcal's own, in Markdown: its id, whose it is, how its file begins, what would show it."""
    lines = ["| effect | of | what happens | what would show it |", "|---|---|---|---|"]
    for family in families():
        module = sys.modules[family.kernel.__module__]
        if module.__name__.startswith("labcal."):
            said = " ".join((module.__doc__ or "").split("\n\n")[0].split())
            lines.append(f"| `{family.id}` | {family.belongs_to} | {said} | {family.experiment} |")
    return "\n".join(lines) + "\n"


TABLES = {"judgements": judgements_table, "effects": effects_table}


def with_tables(text: str) -> str:
    """The page with today's tables, each between its two marks."""
    for name, table in TABLES.items():
        begin, end = f"<!-- {name}: tools/loop_tables.py -->\n", f"<!-- end of {name} -->\n"
        before, rest = text.split(begin)
        text = f"{before}{begin}\n{table()}\n{end}{rest.split(end)[1]}"
    return text


if __name__ == "__main__":
    page = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1] / "docs" / "closed-loop.md")
    page.write_text(with_tables(page.read_text(encoding="utf-8")), encoding="utf-8")
