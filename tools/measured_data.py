"""Before and after on measured data, over four draws of 20-s blocks.

`python tools/measured_data.py FOLDER [PICTURE.png]` prints a line a draw, and draws the residual before and after;
`--first 4 --draws 12` takes twelve others. Causes are chosen again within every fold of every draw, among all of them.
"""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

import numpy as np

from labcal import session
from labcal.loop.close import candidates_of, prepare
from labcal.loop.selection.crossval import block_folds, cross_validate
from labcal.loop.selection.proof import Evidence, against_own_base, nested_selection, select_and_prove

BLOCK_S = 20.0


def main(folder: str, picture: Path | None, seeds: range) -> None:
    """The draws, their mean, and the picture."""
    run = session.load_run(folder)
    problem, level, _ = prepare(run)
    found = select_and_prove(candidates_of(run, problem), level)
    print("accepted:", ", ".join(c.family.id for c in found.accepted) or "nothing")
    draws = []
    for seed in seeds:
        draws.append(_drawn(found, seed))
        print("draw {}: {:.1f} to {:.1f} nT held out".format(seed, *draws[-1]), flush=True)
    print("mean: {:.1f} to {:.1f} nT held out".format(*np.mean(draws, axis=0)))
    if picture is not None:
        _draw(folder, picture)


def _drawn(found: Evidence, seed: int) -> tuple[float, float]:
    pool = found.pool.restricted_to(found.pool.candidates)
    blocks = block_folds(pool.problem, found.blocks.guard_s, BLOCK_S, seed)
    errors = cross_validate(pool, blocks, nested_selection(found.level, blocks))
    own_base = against_own_base(found.base_set, pool, blocks, errors)
    return own_base.before, own_base.after


def _draw(folder: str, picture: Path) -> None:
    from matplotlib.figure import Figure

    from labcal.certificate.report.closed_loop import draw_over_time

    figure = Figure(figsize=(8, 4.2), layout="constrained")
    draw_over_time(figure, session.close_loop(folder))
    figure.savefig(picture, dpi=90)


if __name__ == "__main__":
    asked = ArgumentParser(description=__doc__)
    asked.add_argument("folder")
    asked.add_argument("picture", type=Path, nargs="?")
    asked.add_argument("--first", type=int, default=0)
    asked.add_argument("--draws", type=int, default=4)
    given = asked.parse_args()
    main(given.folder, given.picture, range(given.first, given.first + given.draws))
