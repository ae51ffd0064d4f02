"""How fast DUT and platform may turn by what is stated, before anything is opened."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.bench.clock import RealClock
from labcal.bench.loading import Loader
from labcal.errors import InputError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig


def fastest_stated(path: Path, config: BenchConfig) -> float | None:
    """The tighter limit of DUT and platform [deg/s]; None where neither states one."""
    stated = [config.dut.limits.rate_deg_per_s]
    loader = Loader(path, config, RealClock(), 0)
    for name in (name for name, one in config.instruments.items() if one.role == "platform"):
        with suppress(InputError):  # whoever opens the bench says what is wrong with it
            _, _, settings = loader.driver(name)
            stated.append(getattr(settings, "max_rate_deg_per_s", None))
    return min((one for one in stated if one is not None), default=None)
