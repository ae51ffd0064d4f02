"""Before and after on measured data, over four draws of 20-s blocks.

`python tools/measured_data.py FOLDER [PICTURE.png]` prints a line a draw, and draws the residual before and after.
Causes are chosen again within every fold of every draw, among those that came out best on all rows.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from labcal import session
from labcal.loop.close import prepared, searched
from labcal.loop.decide import forward
from labcal.loop.evidence import Evidence, weighed
from labcal.loop.holdout import held_out, plan

DRAWS, BLOCK_S = 4, 20.0


def main(folder: str, picture: str | None = None) -> None:
    """The draws, their mean, and the picture."""
    run = session.load_run(folder)
    problem, level, _ = prepared(run)
    found = weighed(searched(run, problem), level)
    print("accepted:", ", ".join(c.family.id for c in found.accepted) or "nothing")
    draws = np.array([_drawn(found, seed) for seed in range(DRAWS)])
    for seed, (before, after) in enumerate(draws):
        print(f"draw {seed}: {before:.1f} to {after:.1f} nT held out")
    print("mean: {:.1f} to {:.1f} nT held out".format(*draws.mean(axis=0)))
    if picture is not None:
        _draw(folder, Path(picture))


def _drawn(found: Evidence, seed: int) -> tuple[float, float]:
    best = {w.candidate.cause for ranking in found.rankings for w in ranking[:8]}
    search = found.search.among([c for c in found.search.candidates if c.cause in best])
    blocks = plan(search.problem, found.blocks.guard_s, BLOCK_S, seed)
    honest = held_out(search, blocks, lambda part: forward(part, len(found.accepted))[0])
    return honest.before, honest.after


def _draw(folder: str, picture: Path) -> None:
    from matplotlib.figure import Figure

    from labcal.certificate.report.closed_loop import draw_over_time

    figure = Figure(figsize=(8, 4.2), layout="constrained")
    draw_over_time(figure, session.close_loop(folder))
    figure.savefig(picture, dpi=90)


if __name__ == "__main__":
    main(*sys.argv[1:3])
