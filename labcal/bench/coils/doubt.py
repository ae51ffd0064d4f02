"""That the reference saw a field where the supplies said zero: kept on disk, so that no later session forgets it.

It is lifted where both agree again, or by a person who measured again with the outputs open; the next run's record
says by whom, and what was measured.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from labcal.bench.coils.at_zero import of_this_bench
from labcal.bench.coils.state import NOT_BY_REFERENCE, OPEN_THEM, Vector, of_ends
from labcal.bench.coils.zero import AtZero
from labcal.bench.essentials import essentials
from labcal.bench.links.ports import as_spelt, port_of
from labcal.errors import InputError, InstrumentError
from labcal.files.atomic import write_text
from labcal.files.home import home


@dataclass(frozen=True, slots=True)
class Doubt:
    """What was seen, what the ambient field was (3,) [nT, C], and when; `lifted`: by whom or what, with which reading.

    `advice`: at which supply a person can do something about it, and what.
    `ambient_nT` is None where the file that kept it can no longer be read.
    """

    utc: str
    words: str
    seen_nT: Vector | None = None
    ambient_nT: Vector | None = None
    lifted: str = ""
    advice: str = OPEN_THEM

    def error(self) -> InstrumentError:
        """The refusal to energise anything."""
        return InstrumentError(
            f"{NOT_BY_REFERENCE}, at {self.utc}: {self.words}. Nothing was set.",
            fault="not zero",
            remedy=f"{self.advice}, then measure again: `labcal bench check FILE` lifts this where reference and "
            "supplies agree, with --clear-as NAME where a person answers for it.",
        )


def doubt_of(path: Path) -> str:
    """The doubt about the coils of the bench file `path`, in words; "" where there is none, or the file is spoilt."""
    doubt = _of(path)
    return "" if doubt is None else f"{doubt.utc}, {doubt.words}"


def advice_of(path: Path) -> str:
    """At which supply a person can do something about that doubt, and what; "" where there is none."""
    return "" if (doubt := _of(path)) is None else doubt.advice


def _of(path: Path) -> Doubt | None:
    try:
        if (stated := essentials(path)) is not None:
            return StoredDoubt(stated.guarded_links).doubt
        from labcal.bench.config import read_config  # all of it, which takes longest to load

        return StoredDoubt(read_config(path).guarded_links).doubt
    except (InputError, OSError):
        return None


def left_so(path: Path, ended: Iterable[AtZero]) -> str:
    """What may be said now of coils that ended so; no reference was asked, but a doubt that stands is stated."""
    advice = OPEN_THEM if (doubt := _of(path)) is None else doubt.advice
    return of_ends(of_this_bench(ended), doubt_of(path), advice).sentence(time.monotonic())


class StoredDoubt:
    """The doubt about the coils on these ports; of a simulated bench (no ports) it ends with the session."""

    def __init__(self, urls: Iterable[str]) -> None:
        links = list(urls)
        keys = dict.fromkeys((_key(map(port_of, links)), _key(map(as_spelt, links)))) if links else {}
        self._paths = [home() / f"not-at-zero-{key}.json" for key in keys]  # a name may come by another address
        self._kept = self._read()

    @property
    def doubt(self) -> Doubt | None:
        """What nothing may be energised over; None where all is well."""
        return self._kept if self._kept is not None and not self._kept.lifted else None

    def set(self, doubt: Doubt) -> None:
        """From here on nothing is energised."""
        self._keep(doubt)

    def lift(self, by: str) -> None:
        """Both agree again, or a person answers for it: `by` says who, and what was measured."""
        if self._kept is not None:
            self._keep(replace(self._kept, lifted=by))

    def take_lifted(self) -> Doubt | None:
        """The doubt that was lifted and stands in no record yet; it is forgotten by this."""
        kept = self._kept
        if kept is None or not kept.lifted:
            return None
        self._kept = None
        for path in self._paths:
            path.unlink(missing_ok=True)
        return kept

    def _keep(self, doubt: Doubt) -> None:
        self._kept = doubt
        for path in self._paths:
            with suppress(OSError):  # a disk that is full keeps no coil on: the session itself remembers
                path.parent.mkdir(parents=True, exist_ok=True)
                write_text(path, json.dumps(asdict(doubt)))

    def _read(self) -> Doubt | None:
        path = next((path for path in self._paths if path.exists()), None)
        if path is None:
            return None
        try:
            said = json.loads(path.read_text(encoding="utf-8"))
            seen, ambient = (said[key] and _vector(said[key]) for key in ("seen_nT", "ambient_nT"))
            advice = str(said.get("advice", OPEN_THEM))  # none is there in a file of labcal 1
            return Doubt(str(said["utc"]), str(said["words"]), seen, ambient, str(said["lifted"]), advice)
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return Doubt("a time unknown", f"{path} can no longer be read")


def _key(ports: Iterable[str]) -> str:
    return hashlib.sha256("\n".join(sorted(ports)).encode()).hexdigest()[:16]


def _vector(values: Iterable[float]) -> Vector:
    x, y, z = (float(v) for v in values)
    return x, y, z
