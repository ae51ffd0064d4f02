"""The coverage campaign: `cover.py RUNS` prints how often 95 % intervals hold the truth; exit 1 where they do not.

Half of the runs are the twin's, half another simulator's; vectors, axes and magnitudes; with and without an effect.
"""

from __future__ import annotations

import itertools
import sys

import numpy as np
from trials import KINDS, Trial, trial

LABS = {"twin": True, "independent": False}
POOLED, OF_A_CLASS, LEAST = (0.93, 0.97), (0.90, 0.99), 200  # a class of fewer runs is not judged


def main(runs: int) -> int:
    """All classes in turn, each run with draws of its own."""
    classes = list(itertools.product(LABS, KINDS, (False, True)))
    found: dict[tuple[str, str, bool], list[Trial]] = {one: [] for one in classes}
    for seed in range(runs):
        lab, kind, coupled = one = classes[seed % len(classes)]
        found[one].append(trial(10_000 + seed, kind, coupled=coupled, twin=LABS[lab]))
    print("| lab | reference | effect at work | runs | in 95 % | rms error / u |\n|---|---|---|---|---|---|")
    for (lab, kind, coupled), of in found.items():
        print(_row(of, lab, kind, "offset-current" if coupled else "none"))
    everything = [one for of in found.values() for one in of]
    print(_row(everything, "all", "all", "both"))
    groups = [[t for one, of in found.items() if kind in one for t in of] for kind in (*KINDS, True, False)]
    wrong = [g for g in groups if len(g) >= LEAST and not OF_A_CLASS[0] <= _covered(g) <= OF_A_CLASS[1]]
    return int(bool(wrong) or not POOLED[0] <= _covered(everything) <= POOLED[1])


def _covered(of: list[Trial]) -> float:
    return float(np.mean([one.covered for one in of]))


def _row(of: list[Trial], *names: str) -> str:
    z = np.sqrt(np.mean([one.square for one in of]))
    return f"| {' | '.join(names)} | {len(of)} | {100 * _covered(of):.1f} % | {z:.2f} |"


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 1000))
