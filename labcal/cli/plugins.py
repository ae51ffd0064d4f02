"""`labcal plugins`: what other packages bring."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.screen import say
from labcal.errors import InputError

if TYPE_CHECKING:
    from labcal.plugin_loading import Part

NONE = (
    "no other package brings a driver, emulator, procedure, effect, estimator or page; examples/plugin shows one of "
    "each, CONTRIBUTING.md how they are written"
)


@app.command(rich_help_panel="Extensions")
def plugins() -> int:
    """List what other packages bring and whether it loads. Exit code 1: something does not."""
    from labcal import plugin_loading

    found = plugin_loading.parts()
    faults = [part.fault for part in found if part.fault is not None] or _faults_of_effects(found)
    for part in found:
        say("  ".join((f"{part.kind:<9}", f"{part.name:<20}", f"{part.package:<20}", part.value)))
    for fault in faults:
        say(fault, err=True)
    if not found:
        say(NONE)
    return NEGATIVE if faults else DONE


def _faults_of_effects(found: Sequence[Part]) -> list[str]:
    """Why effects that load cannot be used: each would keep `close-loop` from beginning."""
    from labcal.model.effects import families

    try:
        _ = families() if any(part.kind == "effect" for part in found) else ()
    except InputError as error:
        return [str(error)]
    return []
