"""`labcal plugins`: what other packages bring."""

from __future__ import annotations

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.screen import say

NONE = (
    "no other package brings a driver, emulator, procedure, effect, estimator or page; examples/plugin shows one of "
    "each, CONTRIBUTING.md how they are written"
)


@app.command(rich_help_panel="Extensions")
def plugins() -> int:
    """List what other packages bring and whether it loads. Exit code 1: something does not."""
    from labcal import plugin_loading

    found = plugin_loading.parts()
    for part in found:
        say("  ".join((f"{part.kind:<9}", f"{part.name:<20}", f"{part.package:<20}", part.value)))
    for part in found:
        if part.fault is not None:
            say(part.fault, err=True)
    if not found:
        say(NONE)
    return NEGATIVE if any(part.fault for part in found) else DONE
