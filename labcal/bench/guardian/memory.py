"""What the windings have borne outlives the guardian: the next one begins with them as warm as they are."""

from __future__ import annotations

import hashlib
import json
import math
import time
from collections.abc import Iterable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.bench.guardian.logbook import later
from labcal.bench.links.ports import port_of, runtime_folder
from labcal.files import write_text

Array = NDArray[np.float64]
EVERY_S = 1.0


class Memory:
    """The mean square currents (3,) [A²] of the coils on these ports, in this user's runtime folder, until a reboot."""

    def __init__(self, urls: Iterable[str]) -> None:
        ports = hashlib.sha256("\n".join(sorted(map(port_of, urls))).encode()).hexdigest()[:16]
        self._path, self._next_s = runtime_folder() / f"duty-{ports}.json", 0.0

    def keep(self, mean_A2: Array, now_s: float) -> None:
        """Write them down, once a second at most."""
        if now_s >= self._next_s:
            self._next_s = now_s + EVERY_S
            later(partial(write_text, self._path, json.dumps({"utc_s": time.time(), "mean_A2": mean_A2.tolist()})))

    def recall(self, window_s: float) -> Array:
        """What is left of them, faded since they were written; zero where nothing that can be read was."""
        try:
            kept = json.loads(self._path.read_text(encoding="utf-8"))
            mean, since_s = np.array(kept["mean_A2"], dtype=float), max(0.0, time.time() - float(kept["utc_s"]))
        except (OSError, ValueError, KeyError, TypeError):
            return np.zeros(3)
        known = mean.shape == (3,) and bool(np.isfinite(mean).all()) and bool((mean >= 0).all())
        return mean * math.exp(-since_s / window_s) if known else np.zeros(3)
