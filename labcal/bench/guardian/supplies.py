"""Which supply each coil hangs on, as two bench files that name it can agree: a guardian says it in its card."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from labcal.bench.links.ports import port_of
from labcal.bench.loading import WHICH

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig
    from labcal.bench.essentials import Essentials


def supplies_of(config: BenchConfig | Essentials) -> dict[str, str]:
    """By axis: its port, and what tells it from others there. Emulated ones live in one process and are left out."""
    return {
        entry.role[-1]: json.dumps([port_of(entry.link), {key: entry.settings.get(key) for key in WHICH}], default=str)
        for entry in config.instruments.values()
        if entry.role.startswith("coil-") and not entry.link.startswith("emulated://")
    }
