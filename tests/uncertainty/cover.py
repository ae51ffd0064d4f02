"""The coverage campaign: `cover.py RUNS FILE` prints how often 95 % intervals hold the truth; exit 1 where they do not.

Half of the runs are the twin's, half another simulator's; vectors, axes and magnitudes; without an effect and with one
of three at work. The loop is told nothing: it chooses, and whatever its verdict is counts. FILE keeps one line a run;
a campaign that was broken off goes on behind its last.
"""

from __future__ import annotations

import itertools
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from scipy.special import betaincinv
from trials import KINDS, trial_of_the_loop
from wrong_lab import EFFECTS

LABS = {"independent": False, "twin": True}
POOLED, OF_A_CLASS, LEAST = (0.93, 0.97), (0.90, 0.99), 200  # a class of fewer runs is not judged
TITLES = {"kind": "reference", "effect": "at work"}


def main(runs: int, file: Path) -> int:
    """All classes in turn, each run with draws of its own."""
    classes = list(itertools.product(LABS, KINDS, EFFECTS))
    found = [_Line(**json.loads(text)) for text in file.read_text().splitlines()] if file.exists() else []
    for number in range(len(found), runs):
        lab, kind, effect = classes[number % len(classes)]
        one = trial_of_the_loop(10_000 + number, kind, effect=effect, twin=LABS[lab])
        found.append(_Line(lab, kind, effect, one.verdict, one.named, one.covered, one.square))
        with file.open("a") as out:
            out.write(json.dumps(asdict(found[-1])) + "\n")
    return _told(found[:runs])


@dataclass(frozen=True)
class _Line:
    """What is kept of a run."""

    lab: str
    kind: str
    effect: str
    verdict: str
    named: bool
    covered: float
    square: float


def _told(found: Sequence[_Line]) -> int:
    """The table on stdout; 1 where all together, or a class of enough runs, are outside their limits."""
    print("| class | runs | in 95 % (interval) | rms error / u | effect named |\n|---|---|---|---|---|")
    wrong = []
    for place, names in (("lab", LABS), ("kind", KINDS), ("effect", EFFECTS)):
        for name in names:
            of = [one for one in found if getattr(one, place) == name]
            print(_row(of, f"{TITLES.get(place, place)}: {name}"))
            wrong += [name] * (len(of) >= LEAST and not OF_A_CLASS[0] <= _covered(of) <= OF_A_CLASS[1])
    for verdict in sorted({one.verdict for one in found}):
        print(_row([one for one in found if one.verdict == verdict], f"verdict: {verdict}"))
    print(_row(found, "all"))
    print(f"\n{_spread(found)}")
    return int(bool(wrong) or not POOLED[0] <= _covered(found) <= POOLED[1])


def _covered(of: Sequence[_Line]) -> float:
    return float(np.mean([one.covered for one in of]))


def _row(of: Sequence[_Line], name: str) -> str:
    z, named = np.sqrt(np.mean([one.square for one in of])), np.mean([one.named for one in of])
    low, high = binomial_interval(_covered(of), len(of))
    share = f"{100 * _covered(of):.1f} % ({100 * low:.1f} to {100 * high:.1f})"
    return f"| {name} | {len(of)} | {share} | {z:.2f} | {100 * named:.0f} % |"


def binomial_interval(share: float, runs: int) -> tuple[float, float]:
    """The 95 % interval of a share of so many runs (Clopper & Pearson 1934), each run one trial; never too narrow.

    A run's intervals hold or miss together at the most: what is in it of many readings counts for no more than one.
    """
    held = share * runs
    low = betaincinv(held, runs - held + 1, 0.025) if held > 0 else 0.0
    high = betaincinv(held + 1, runs - held, 0.975) if held < runs else 1.0
    return float(low), float(high)


def _spread(of: Sequence[_Line]) -> str:
    """Mean square of error over u with its 99.9 % interval over runs."""
    squares = np.array([one.square for one in of])
    half = 3.29 * squares.std(ddof=1) / np.sqrt(len(squares))
    return f"Mean square of error over u {squares.mean():.3f}, 99.9 % interval over runs ± {half:.3f}."


if __name__ == "__main__":
    RUNS, FILE = sys.argv[1:]
    sys.exit(main(int(RUNS), Path(FILE)))
