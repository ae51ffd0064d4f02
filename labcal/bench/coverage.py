"""Which stretches of the circle a turn has not seen, and how long one has to be to matter.

A constant field is seen in a turn as harmonics of the platform's angle: the map makes the first, products of two
components the second, a cubic the third, and more is not looked for in a turn. Without a stretch of γ the combination
of these seven (a mean, three cosines, three sines) that suffers most has 1/√λ times its standard uncertainty, with
λ ≥ 1 − 7 γ/360°: what the stretch would have told is at most its trace. A third more comes of 22.5°; of 60° more
than twice as much. Attitudes 15° apart lose nothing, and one of them may be half a step off.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import Blocks
from labcal.bench.streams.samples import samples
from labcal.errors import InstrumentError
from labcal.record.stream import COVERAGE, Block, Event

HARMONICS = 3
MOST_GROWTH = 4 / 3  # of a standard uncertainty
MOST_GAP_DEG = 360.0 / (2 * HARMONICS + 1) * (1.0 - MOST_GROWTH**-2)  # 22.5
SECTOR_DEG = 15.0
PAUSES = 5.0  # of a platform that is read: a sample of the DUT further than these from any angle has none

Gap = tuple[float, float]


def gaps(blocks: Sequence[Block]) -> list[Gap]:
    """Stretches (from, to) [deg] of the circle, longer than `MOST_GAP_DEG`, without an attitude at which the DUT sent.

    The last may end beyond 360. Where no block is of the DUT, every angle counts.
    """
    seen = np.unique(np.mod(_attitudes(blocks), 360.0))
    if not len(seen):
        return [(0.0, 360.0)]
    after = np.append(seen[1:], seen[0] + 360.0)
    return [(float(a), float(b)) for a, b in zip(seen, after, strict=True) if b - a > MOST_GAP_DEG]


def missing_sectors(blocks: Sequence[Block], sector_deg: float = SECTOR_DEG) -> list[int]:
    """The starting angles [deg] of the sectors of the circle whose middle lies in one of the `gaps`."""
    open_yet = gaps(blocks)
    starts = [int(n * sector_deg) for n in range(round(360 / sector_deg))]
    return [at for at in starts if any(_lies_in(at + sector_deg / 2, gap) for gap in open_yet)]


def in_words(found: Sequence[Gap]) -> str:
    """From where to where: 30°–58°, 350°–15°."""
    return ", ".join(f"{a:.0f}°–{b % 360:.0f}°" for a, b in found)


def unseen(bench: Bench, segment: str, found: Sequence[Gap]) -> Event:
    """For the record, and for whoever decides whether the turn is repeated while the DUT still stands there."""
    data = {"segment": segment, "gaps_deg": [list(gap) for gap in found]}
    return Event(bench.clock.now(), COVERAGE, f"{segment}: not seen: {in_words(found)}", data)


def refuse_unseen(bench: Bench, blocks: Blocks) -> None:
    """Raise InstrumentError where the platform passed a stretch that matters while the DUT sent nothing."""
    passed = missing_sectors([block for block in blocks if block.stream == "angle"])
    if set(missing_sectors(blocks)) - set(passed):
        raise InstrumentError(
            f"{bench.dut.name}: it sent nothing at {in_words(gaps(blocks))} of this turn.",
            fault="coverage",
            remedy="See that it sends, then try again.",
        )


def _lies_in(angle: float, gap: Gap) -> bool:
    return gap[0] < angle < gap[1] or gap[0] < angle + 360.0 < gap[1]


def _attitudes(blocks: Sequence[Block]) -> NDArray[np.float64]:
    """Where the platform was [deg] each time that the DUT sent; no angle is made up where none was read near by."""
    angle = samples(blocks, "angle", "angle_deg")
    turned = np.unwrap(angle.values[:, 0], period=360.0)
    dut = [block.t_s for block in blocks if block.stream == "dut"]
    if not dut:
        return turned
    sent = np.unique(np.concatenate(dut))
    return np.interp(sent, angle.t_s, turned)[_near(sent, angle.t_s)]


def _near(sent: NDArray[np.float64], read: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which stamps of `sent` have one of `read` near by, by its usual pauses."""
    if len(read) < 2:
        return np.ones(len(sent), dtype=bool)
    after = np.clip(np.searchsorted(read, sent), 1, len(read) - 1)
    nearest = np.minimum(np.abs(sent - read[after - 1]), np.abs(read[after] - sent))
    return np.asarray(nearest <= PAUSES * np.median(np.diff(read)))
