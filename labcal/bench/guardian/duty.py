"""What the windings have borne outlives the guardian: the next one begins with them as warm as they are."""

from __future__ import annotations

import hashlib
import json
import math
import time
from collections.abc import Iterable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.bench.guardian.logbook import later
from labcal.bench.links.locks import text_of
from labcal.bench.links.places import OF_GROUP, OWN, group, runtime_folder, user
from labcal.bench.links.ports import port_of
from labcal.files.atomic import write_bytes

Array = NDArray[np.float64]
EVERY_S = 1.0


class DutyRecord:
    """The mean square currents (3,) [A²] of the coils on these ports, in the runtime folder, until a reboot.

    Each user writes a file of its own; the warmest counts.
    """

    def __init__(self, urls: Iterable[str]) -> None:
        ports = hashlib.sha256("\n".join(sorted(map(port_of, urls))).encode()).hexdigest()[:16]
        self._path, self._next_s = runtime_folder() / f"duty-{ports}-{user()}.json", 0.0
        self._all, self._mode = f"duty-{ports}-*.json", OWN if group() is None else OF_GROUP

    def keep(self, mean_A2: Array, now_s: float) -> None:
        """Write them down, once a second at most."""
        if now_s >= self._next_s:
            self._next_s = now_s + EVERY_S
            kept = json.dumps({"utc_s": time.time(), "monotonic_s": time.monotonic(), "mean_A2": mean_A2.tolist()})
            later(partial(write_bytes, self._path, kept.encode(), self._mode))

    def recall(self, window_s: float) -> Array:
        """What is left of them, faded since they were written; zero where nothing that can be read was."""
        kept = [_faded(path, window_s) for path in self._path.parent.glob(self._all)]
        return np.array(np.max([np.zeros(3), *kept], axis=0))


def _faded(path: Path, window_s: float) -> Array:
    try:
        kept = json.loads(text_of(path))
        mean, since_s = np.array(kept["mean_A2"], dtype=float), _since_s(kept)
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return np.zeros(3)
    known = mean.shape == (3,) and bool(np.isfinite(mean).all()) and bool((mean >= 0).all())
    return mean * math.exp(-since_s / window_s) if known else np.zeros(3)


def _since_s(kept: dict[str, Any]) -> float:
    """How long ago that was, at least: a wall clock that was set forward cools no winding.

    The monotonic clock begins anew with the computer; one that is behind was read before that, and tells nothing.
    """
    by_wall_s = time.time() - float(kept["utc_s"])
    went_s = time.monotonic() - float(kept.get("monotonic_s", math.inf))
    return max(0.0, min(by_wall_s, went_s) if went_s >= 0 else by_wall_s)
