"""Supplies that an earlier session on this bench file drove at other links, and left without bringing them to zero.

COILS OFF asks for them each time, until they were read back at zero or a person says that they are gone.
"""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import Any

from labcal.bench.guardian.wire import is_of
from labcal.bench.links import ports


def forget(bench: Path, gone: Collection[str]) -> None:
    """Have nobody ask again for what was driven for `bench` at the ports `gone`; what it names at others stays."""
    ports.amend_left_behind(lambda card: _without(card, gone) if is_of(bench, card) else card)


def _without(card: dict[str, Any], gone: Collection[str]) -> dict[str, Any]:
    """The card of a dead guardian without the supplies at these ports; {} where no supply is left."""
    driven = dict(card[ports.DRIVEN])
    left = {
        name: said
        for name, said in driven["instruments"].items()
        if not said["role"].startswith("coil-") or ports.port_of(said["link"]) not in gone
    }
    if not any(said["role"].startswith("coil-") for said in left.values()):
        return {}
    return card | {ports.DRIVEN: driven | {"instruments": left}}
