"""The table of the loop's judgements in docs/closed-loop.md, from `labcal.loop.policy`: `policy_table.py [FILE]`."""

from __future__ import annotations

import sys
from pathlib import Path

from labcal.loop.policy import judgements

BEGIN, END = "<!-- judgements: tools/policy_table.py -->\n", "<!-- end of judgements -->\n"


def table() -> str:
    """One row a judgement, in Markdown."""
    lines = ["| judgement | value | decides | source |", "|---|---|---|---|"]
    for name, stated in judgements().items():
        value = f"{stated.value:.3g} {stated.unit}".strip()
        lines.append(f"| `{name}` | {value} | {stated.decides} | {stated.source}: {stated.why} |")
    return "\n".join(lines) + "\n"


def with_table(text: str) -> str:
    """The page with the table of today between its two marks."""
    before, rest = text.split(BEGIN)
    return f"{before}{BEGIN}\n{table()}\n{END}{rest.split(END)[1]}"


if __name__ == "__main__":
    page = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[1] / "docs" / "closed-loop.md")
    page.write_text(with_table(page.read_text(encoding="utf-8")), encoding="utf-8")
