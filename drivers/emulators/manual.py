"""A platform turned by hand has no wire: the bench's hands turn it, misreading its dial as the twin is told to."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from labcal.bench.links import Nobody


class ManualEmulator(Nobody):
    """Silence."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        pass
