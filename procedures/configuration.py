"""The checklist before anything else: what must lie where, said and photographed."""

from __future__ import annotations

from typing import Annotated

from labcal.bench.bench import Bench
from labcal.bench.steps import Procedure, coils_off
from labcal.errors import LimitNotMet
from labcal.record.stream import Event, Prompt

ITEMS = (
    ("covers", "Are all covers of the DUT as they will fly, and the others off?"),
    ("batteries", "Are the batteries those that will fly, and connected?"),
    ("tools", "Are all tools out of the cage?"),
    ("phones", "Are phones, keys and watches out of the room?"),
    ("chairs", "Do chairs and trolleys stand at their marks?"),
)


def configuration(
    bench: Bench,
    *,
    photographs: Annotated[bool, "ask for a photograph of each"] = True,
) -> Procedure:
    """Go through the checklist; every "no" is named at the end."""
    yield from coils_off(bench)
    missing: list[str] = []
    for key, question in ITEMS:
        answer = yield Prompt(bench.clock.now(), key, question, ("yes", "no"))
        missing += [key] if answer == "no" else []
        if photographs:
            picture = yield Prompt(bench.clock.now(), f"photo-{key}", f"File of the photograph ({key}), or empty:", ())
            yield Event(bench.clock.now(), "photograph", picture or "none", {"item": key})
    if missing:
        raise LimitNotMet(f"configuration: {', '.join(missing)} not as stated")
