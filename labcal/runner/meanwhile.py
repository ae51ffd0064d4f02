"""What moved while an instrument was silent: the platform's angle and the ambient field, before it and after."""

from __future__ import annotations

from contextlib import suppress

from labcal.bench.bench import Bench
from labcal.bench.coils.state import PlatformReading, Vector
from labcal.bench.streams.reconnect import AWAY
from labcal.errors import InstrumentError
from labcal.record.stream import FAULT, MEANWHILE, Block, Event, Item

BACK = ("heard again", "reconnected")
SETTLES_S = 3.0  # so long after the last one is back the reference has to look at the zero


class Meanwhile:
    """Sees all that is recorded. While anybody is silent what was known before is kept."""

    def __init__(self) -> None:
        self._angle_deg: float | None = None
        self._silent = False
        self._back_s: float | None = None

    def see(self, item: Item, bench: Bench) -> None:
        """The last angle before a silence, that one began, or that somebody is back."""
        if isinstance(item, Block):
            if item.stream == "angle" and len(item) and not self._silent:
                self._angle_deg = float(item.values[-1, 0])
        elif isinstance(item, Event) and item.kind in ("stream", FAULT):
            fault = item.data.get("fault")
            if fault in AWAY:
                self._begin(bench.state().platform)
            elif fault in BACK and self._silent:
                self._back_s = bench.clock.now()

    def _begin(self, stands: PlatformReading | None) -> None:
        """Of a platform that was never polled, as it was looked at last."""
        self._silent, self._back_s = True, None
        if self._angle_deg is None and stands is not None:
            self._angle_deg = stands.angle_deg

    def over(self, bench: Bench, *, answered: bool = False) -> Event | None:
        """Once everybody answers again and the coils are at zero: what was before, and what is now; told once.

        The reference is waited for, unless the question is `answered`.
        """
        now_s = bench.clock.now()
        if self._back_s is None or bench.cage.on or any(one.fault for one in bench.state().instruments):
            return None
        seen = bench.cage.witness
        looked = seen.read_s is not None and seen.read_s >= self._back_s
        if not looked and not answered and now_s < self._back_s + SETTLES_S:
            return None
        with suppress(InstrumentError):
            bench.look_at_platform()
        stands, before = bench.state().platform, self._angle_deg
        self._silent, self._back_s = False, None
        now = None if stands is None else stands.angle_deg
        fields = (seen.expected_nT, seen.seen_nT) if looked and bench.cage.check.zero_expected else (None, None)
        text = words(before, now, *fields)
        data = {
            "angle_deg": [before, now],
            "field_nT": [None if one is None else list(one) for one in fields],
            "utc": bench.clock.utc().isoformat(),
        }
        return Event(now_s, MEANWHILE, text, data) if text else None


def words(before_deg: float | None, now_deg: float | None, before_nT: Vector | None, now_nT: Vector | None) -> str:
    """Both of what is known of both; "" where nothing is."""
    said = []
    if before_deg is not None and now_deg is not None:
        said.append(f"platform {before_deg:.1f}° before, {now_deg:.1f}° now")
    if before_nT is not None and now_nT is not None:
        said.append(f"ambient field {_field(before_nT)} nT before, {_field(now_nT)} nT now")
    return f"after the silence: {'; '.join(said)}" if said else ""


def _field(nT: Vector) -> str:
    return " ".join(f"{value:.0f}" for value in nT)
