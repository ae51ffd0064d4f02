"""Turning the DUT in a steady field: how fast it may, and how a turn is recorded and looked at."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from labcal.bench.axis_up import WrongAxis, refuse_another_axis, refuse_another_axis_early
from labcal.bench.bench import Bench
from labcal.bench.coverage import SECTOR_DEG, gaps, in_words, missing_sectors, unseen
from labcal.bench.steps import Blocks, Work, measured, record, recorded, turn, turn_by_hand
from labcal.bench.turn_diagnostics import look_at_turn
from labcal.errors import InputError, InstrumentError
from labcal.record.run import Segment
from labcal.record.vector import Vector

MOST_NOISE = 1.5  # times what the bench file states
TRIES_BY_HAND = 3


@dataclass(frozen=True, slots=True)
class Rotation:
    """One turn to `to_deg` [deg] at `rate_deg_per_s`; stepped where `step_deg` is not 0, resting `dwell_s` at each."""

    name: str
    axis_body: Vector
    mode: str
    rate_deg_per_s: float
    to_deg: float = 360.0
    mounting: str | None = None
    step_deg: float = 0.0
    dwell_s: float = 2.0
    u_axis_body_deg: float | None = None
    u_time_s: float | None = None
    note: str = field(default="")

    def seconds(self, angle_deg: float = 360.0) -> float:
        """Lab time of a turn by `angle_deg`."""
        rests = abs(angle_deg) / self.step_deg * self.dwell_s if self.step_deg else 0.0
        return abs(angle_deg) / self.rate_deg_per_s + rests

    def segment(self, bench: Bench) -> Segment:
        """The segment of the record. A scalar reference knows no axis in the cage."""
        platform, vector = bench.config.platform, bench.reference_kind == "vector"
        return Segment(
            self.name,
            "rotation",
            mode=self.mode,
            note=self.note,
            axis_body=self.axis_body,
            axis_cage=platform.axis_cage if vector else None,
            mounting=self.mounting,
            angle_noise_deg=platform.angle_noise_deg or (bench.by_hand.u_reading_deg if bench.by_hand else None),
            u_axis_body_deg=self.u_axis_body_deg,
            u_axis_cage_deg=platform.u_axis_cage_deg,
            u_time_s=self.u_time_s,
        )


def fastest_rate(bench: Bench, magnitude_nT: float, inclination_deg: float, u_time_s: float, timing_nT: float) -> float:
    """The fastest allowed rate [deg/s]: the timing error |b_perp| ω u_t stays below `timing_nT`.

    Never beyond the platform's, or the DUT's own limit.
    """
    across_nT = abs(magnitude_nT) * np.sin(np.radians(inclination_deg))
    return min(float(np.degrees(timing_nT / (across_nT * u_time_s))), _fastest(bench))


def refuse_too_fast(bench: Bench, rate_deg_per_s: float) -> None:
    """Raise InputError for a rate beyond the platform's or the DUT's limit, before anybody mounts anything."""
    if rate_deg_per_s > (fastest := _fastest(bench)):
        raise InputError(f"{rate_deg_per_s:g} deg/s is too fast: DUT and platform allow {fastest:g} deg/s")


def _fastest(bench: Bench) -> float:
    return min(bench.config.dut.limits.rate_deg_per_s or np.inf, bench.platform.max_rate_deg_per_s)


def rotate_once(bench: Bench, rotation: Rotation) -> Work[Blocks]:
    """Record one turn as a segment, with its coverage, noise and sense; sectors missing by hand are asked for.

    Raises WrongAxis where another body axis is up than it says.
    """
    how = _by_motor if bench.platform.motorised else _by_hand
    blocks = yield from recorded(bench, rotation.segment(bench), how(bench, rotation))
    refuse_another_axis(bench, rotation.name, rotation.axis_body, blocks)
    missing, seen = missing_sectors(blocks), look_at_turn(bench, rotation.axis_body, blocks)
    if found := gaps(blocks):
        yield unseen(bench, rotation.name, found)
    yield from measured(bench, f"{rotation.name}: missing sectors", len(missing), 0.0, "", limit=0.0)
    stated = bench.config.dut.noise_nT
    limit = None if stated is None else MOST_NOISE * stated
    yield from measured(bench, f"{rotation.name}: noise", seen.noise_nT, seen.u_noise_nT, "nT", limit)
    if seen.wrong_signs is not None:
        yield from measured(bench, f"{rotation.name}: wrong signs", seen.wrong_signs, 0.0, "", limit=0.0)
    return blocks


def _by_motor(bench: Bench, rotation: Rotation) -> Work[Blocks]:
    """A turn about another axis is stopped as soon as that is plain."""
    kept: Blocks = []

    def look(blocks: Blocks) -> None:
        refuse_another_axis_early(bench, rotation.name, rotation.axis_body, [*kept, *blocks])

    ends = [rotation.to_deg]
    if rotation.step_deg:
        ends = stops(bench.platform.angle_deg(), rotation.to_deg, rotation.step_deg)
    try:
        for angle in ends:
            kept += yield from turn(bench, angle, rotation.rate_deg_per_s, look)
            kept += yield from record(bench, rotation.dwell_s if rotation.step_deg else 0.0)
    except WrongAxis:
        bench.stop_platform()
        raise
    return kept


def stops(from_deg: float, to_deg: float, step_deg: float) -> list[float]:
    """The angles at which a stepped turn rests, the last one `to_deg`."""
    count = max(1, round(abs(to_deg - from_deg) / step_deg))
    return [from_deg + (to_deg - from_deg) * n / count for n in range(1, count + 1)]


def _by_hand(bench: Bench, rotation: Rotation) -> Work[Blocks]:
    """Ask for each angle in turn: a dial has no motor, but a person who reads it."""
    kept: Blocks = []
    begun, step = bench.platform.angle_deg(), rotation.step_deg or SECTOR_DEG
    half = np.copysign(step / 2, rotation.to_deg - begun)  # the middle of a sector, not its edge
    wanted = [round(angle - half, 1) for angle in stops(begun, rotation.to_deg, step)]
    for _ in range(TRIES_BY_HAND):
        for angle in wanted:
            yield from turn_by_hand(bench, angle)
            kept += yield from record(bench, rotation.dwell_s)
            refuse_another_axis_early(bench, rotation.name, rotation.axis_body, kept)
        wanted = [float(a) + SECTOR_DEG / 2 for a in missing_sectors(kept)]
        if not wanted:
            return kept
    raise InstrumentError(
        f"{rotation.name}: still not seen: {in_words(gaps(kept))}.",
        fault="coverage",
        remedy="Check that the dial's reading is entered after each turn.",
    )
