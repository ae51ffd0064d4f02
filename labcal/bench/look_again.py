"""The doubt about a zero, measured again: every coil to zero, outputs open, then what the reference sees now."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import cast

import numpy as np

from labcal.bench.clock import Clock, RealClock
from labcal.bench.coils.advice import as_if, by_hand
from labcal.bench.coils.agreement import LIMIT_NT
from labcal.bench.coils.at_zero import of_this_bench
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.coils.state import NOT_BY_REFERENCE, NOT_CONFIRMED, Vector, Witness
from labcal.bench.coils.zero import AtZero
from labcal.bench.config import BenchConfig, read_config
from labcal.bench.driver_kit.roles import Magnetometer
from labcal.bench.loading import Loader
from labcal.bench.shutdown import coils_off
from labcal.bench.streams.reference import into_cage
from labcal.bench.streams.samples import samples
from labcal.errors import InstrumentError

LISTEN_S = 3.0
ANSWERED_FOR = "measures it too, with --clear-as NAME where a person answers for it."


@dataclass(frozen=True, slots=True)
class Looked:
    """What was measured now, in words, and whether the coils may be energised again; `ended`: each coil as read back.

    `before`: when the doubt arose, and what was seen then.
    """

    words: str
    lifted: bool
    ended: tuple[AtZero, ...] = ()
    before: str = ""
    advice: str = ""


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
    found = _witness(seen, said, doubt, config)
    agree = found.verdict == "agrees" and all(end.fault is None for end in ended)
    if agree or clear_as.strip():
        by = "supplies and reference agree again" if agree else f"{clear_as.strip()} answers for it"
        latch.lift(f"{by}, {reading}")
        return Looked(f"{by}: the coils may be energised again. {reading}", True, tuple(ended))
    before = f"{doubt.utc}, {doubt.words}"
    return Looked(_why_not(ended, found), False, tuple(ended), before, found.advice)


def refuse_doubt(path: Path) -> None:
    """Before hands work for a run that could set nothing: a zero in doubt is measured now, and lifted where it is one.

    Raises InstrumentError (not zero) where it is in doubt still.
    """
    looked = look_again(path)
    if looked is not None and not looked.lifted:
        remedy = f"{looked.advice}, then check the zero again." if looked.advice else "Then check the zero again."
        mends = f"First seen {looked.before}. `labcal bench check FILE` {ANSWERED_FOR}"
        raise InstrumentError(looked.words, fault="not zero", remedy=remedy, mends=mends)


def _why_not(ended: list[AtZero], found: Witness) -> str:
    """What keeps the coils from being energised, as it is now: the reference, or a supply that is not at zero."""
    if found.verdict == "disagrees":
        return f"{NOT_BY_REFERENCE}: {found.words}."
    if left := "; ".join(end.why_left for end in ended if end.fault is not None):
        return f"{NOT_CONFIRMED}: {left}"
    return f"{NOT_CONFIRMED}: {found.words}."


def _witness(seen_nT: Vector | None, said: str, doubt: Doubt, config: BenchConfig) -> Witness:
    """The reference now, with what a person can do where it sees no zero."""
    if seen_nT is None or doubt.ambient_nT is None:
        return Witness(why=said if seen_nT is None else f"{said}, {_expected(doubt)}", advice="")
    difference = np.subtract(seen_nT, doubt.ambient_nT)
    apart = float(np.linalg.norm(difference))
    if apart <= LIMIT_NT:
        return Witness("agrees", "", seen_nT, doubt.ambient_nT, apart, LIMIT_NT, advice="")
    names = {str(one.role)[-1]: (name, True) for name, one in config.instruments.items()}
    advice = by_hand(as_if(difference, config.cage.matrix, LIMIT_NT), names)
    return Witness("disagrees", "", seen_nT, doubt.ambient_nT, apart, LIMIT_NT, advice=advice)


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
