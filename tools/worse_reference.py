"""What a certificate says of one run as its reference is declared, and a hundred times worse.

`python tools/worse_reference.py RUN [PICTURE.png]` prints the certificate's own rows as Markdown, and draws the budget
of the run as it is declared. Each column is a whole `labcal close-loop`.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from labcal import loop, session
from labcal.certificate.report.budget import budget_blocks, draw_shares
from labcal.certificate.report.page import Table
from labcal.fit import draft_calibration
from labcal.model import Calibration
from labcal.record import Run

WORSE = 100.0
ROWS = ("reference scale", "reference zero x")


def main(source: str, picture: Path | None) -> None:
    """Three certificates side by side."""
    run = session.load_run(source)
    reference = run.reference
    if reference.u_scale_ppm is None or reference.u_offset_nT is None:
        sys.exit(f"{source}: its reference states no u_scale_ppm or no u_offset_nT")
    ppm, closure = reference.u_scale_ppm, max((closed.u_offset_nT for closed in run.closures), default=0.0)
    zero = float(np.sqrt(max(reference.u_offset_nT**2 - closure**2, 0.0)))  # as bench.toml has it
    stated = {
        "as declared": reference,
        f"u_scale_ppm {ppm:.3g} → {WORSE * ppm:.3g}": replace(reference, u_scale_ppm=WORSE * ppm),
        f"u_offset_nT {zero:.3g} → {WORSE * zero:.3g}": replace(
            reference, u_offset_nT=float(np.hypot(WORSE * zero, closure))
        ),
    }
    made = {name: certified(replace(run, reference=of)) for name, of in stated.items()}
    print(f"| | {' | '.join(made)} |\n|{'---|' * (len(made) + 1)}")
    for words, cells in lines(list(made.values())):
        print(f"| {words} | {' | '.join(cells)} |")
    if picture is not None:
        draw(made["as declared"], picture)


def certified(run: Run) -> Calibration:
    """As `labcal close-loop --out` writes it."""
    closed = loop.close_loop(run)
    return draft_calibration(run, closed.fit(), "0" * 64, metrics=closed.metrics())


def lines(made: list[Calibration]) -> list[tuple[str, list[str]]]:
    """What stands on paper: U of each quantity with what makes most of it, then the rows of the reference."""
    at = made[0].budget[0]["at"]
    wanted = [("b x", at), ("scale x", ""), ("zero reading x", "")]
    found = [(f"U({q}){f' at {a}' if a else ''}", [whole(one(c, q, a)) for c in made]) for q, a in wanted]
    for source in ROWS:
        found.append((f"row “{source}” of b x", [row(one(c, "b x", at), source) for c in made]))
    first = [next(block for block in budget_blocks(c) if isinstance(block, Table)).rows[0] for c in made]
    return [*found, ("largest contributions to U(scale x), as printed", [str(cells[-1]) for cells in first])]


def one(c: Calibration, quantity: str, at: str) -> Mapping[str, Any]:
    """The budget of a quantity at a point, or of a figure wherever it is."""
    return next(b for b in c.budget if b["quantity"] == quantity and (not at or b["at"] == at))


def whole(budget: Mapping[str, Any]) -> str:
    """Its U, as on paper."""
    return f"{budget['U']:.3g} {budget['unit']}"


def row(budget: Mapping[str, Any], source: str) -> str:
    """One source of it: its own u, what that does, its share."""
    for found in budget["rows"]:
        if found["source"] == source:
            effect = abs(found["u"] * found["sensitivity"])
            return f"u {found['u']:.3g} {found['unit']}, {effect:.3g} {budget['unit']}, {100 * found['share']:.1f} %"
    return "below 10⁻⁵"


def draw(c: Calibration, picture: Path) -> None:
    """The budget as the report draws it."""
    from matplotlib.figure import Figure

    field = [b for b in c.budget if b["quantity"].startswith("b ")][:9]
    drawn = [*field, *(b for b in c.budget if not b["quantity"].startswith("b "))]
    figure = Figure(figsize=(8, 0.9 + 0.22 * len(drawn)), layout="constrained")
    draw_shares(figure, drawn)
    figure.savefig(picture, dpi=90)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]) if len(sys.argv) > 2 else None)
