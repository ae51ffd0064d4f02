"""The doubt about a zero, measured again: every coil to zero, outputs open, then what the reference sees now."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import cast

import numpy as np

from labcal.bench.clock import Clock, RealClock
from labcal.bench.coils.agreement import LIMIT_NT
from labcal.bench.coils.at_zero import of_this_bench
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.coils.state import NOT_BY_REFERENCE, Vector
from labcal.bench.coils.zero import AtZero
from labcal.bench.config import BenchConfig, read_config
from labcal.bench.driver_kit.roles import Magnetometer
from labcal.bench.loading import Loader
from labcal.bench.shutdown import coils_off
from labcal.bench.streams.reference import into_cage
from labcal.bench.streams.samples import samples
from labcal.errors import InstrumentError

LISTEN_S = 3.0


@dataclass(frozen=True, slots=True)
class Looked:
    """What was measured, in words, and whether the coils may be energised again; `ended`: each coil as read back."""

    words: str
    lifted: bool
    ended: tuple[AtZero, ...] = ()


def look_again(path: Path, clear_as: str = "", clock: Clock | None = None) -> Looked | None:
    """Measure again where the bench `path` is in doubt, and lift that where reference and supplies agree; else None.

    Where they do not, `clear_as` names the person who answers for it: that is kept for the next run's record.
    """
    config = read_config(path)
    latch = StoredDoubt(config.guarded_links)
    if (doubt := latch.doubt) is None:
        return None
    ended = of_this_bench(coils_off(path))
    supplies = "; ".join(f"coil {end.axis} {end.words}" for end in ended)
    seen, said = _reference(path, config, clock or RealClock())
    utc = f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC"
    reading = f"{utc}: {said}, {_expected(doubt)}; {supplies}"
    agree = _agree(ended, seen, doubt)
    if agree or clear_as.strip():
        by = "supplies and reference agree again" if agree else f"{clear_as.strip()} answers for it"
        latch.lift(f"{by}, {reading}")
        return Looked(f"{by}: the coils may be energised again. {reading}", True, tuple(ended))
    return Looked(f"{NOT_BY_REFERENCE}, {reading}. {doubt.advice}, then look again.", False, tuple(ended))


def _agree(ended: list[AtZero], seen_nT: Vector | None, doubt: Doubt) -> bool:
    if seen_nT is None or doubt.ambient_nT is None or any(end.fault is not None for end in ended):
        return False
    return float(np.linalg.norm(np.subtract(seen_nT, doubt.ambient_nT))) <= LIMIT_NT


def _expected(doubt: Doubt) -> str:
    return "the ambient field is not known" if doubt.ambient_nT is None else f"{_words(doubt.ambient_nT)} expected"


def _words(field_nT: Vector) -> str:
    return " ".join(f"{v:.0f}" for v in field_nT) + " nT"


def _reference(path: Path, config: BenchConfig, clock: Clock) -> tuple[Vector | None, str]:
    """What the reference sees now (3,) [nT, C], and that in words; None where it does not answer."""
    name = next(name for name, one in config.instruments.items() if one.role == "reference")
    loader = Loader(path, config, clock, 0)
    with ExitStack() as afterwards:
        afterwards.callback(loader.close)
        try:
            sensor = cast(Magnetometer, loader.instrument(name))
            sensor.identify()
            sensor.start()
            afterwards.callback(sensor.stop)
            blocks = sensor.read_until(clock.now() + LISTEN_S)
            x, y, z = np.median(into_cage(samples(blocks, "reference").values, config.reference), axis=0).tolist()
        except InstrumentError as fault:
            return None, f"the reference tells nothing ({fault.what})"
    return (x, y, z), f"the reference sees {_words((x, y, z))}"
