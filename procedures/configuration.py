"""The checklist before anything else: what must lie where, said and photographed."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Annotated

from labcal.bench.bench import Bench
from labcal.bench.steps import Plan, Procedure, Work, coils_off
from labcal.errors import LimitNotMet
from labcal.record.stream import Event, Prompt

NEEDS, LASTS_MIN = "the DUT as it will fly, and a camera", 1

FILE = {"file": "photograph"}
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
    plan = Plan(tuple((key, 0.0) for key, _ in ITEMS), frozenset(key for key, _ in ITEMS))  # a person's time alone
    missing: list[str] = []
    for key, question in ITEMS:
        yield plan.begin(bench, key)
        if key == ITEMS[0][0]:
            yield from coils_off(bench)
        answer = yield Prompt(bench.clock.now(), key, question, ("yes", "no"))
        missing += [key] if answer == "no" else []
        if photographs:
            yield from _photograph(bench, key)
    if missing:
        raise LimitNotMet(f"configuration: {', '.join(missing)} not as stated")


def _photograph(bench: Bench, key: str) -> Work[None]:
    """Ask for the file until there is one, or none is wanted; its name and SHA-256 go into the record."""
    text = f"File of the photograph ({key}), or empty:"
    picture = yield Prompt(bench.clock.now(), f"photo-{key}", text, (), drawing=FILE)
    while picture and not Path(picture).expanduser().is_file():
        picture = yield Prompt(
            bench.clock.now(), f"photo-{key}", f"There is no file {picture}. {text}", (), drawing=FILE
        )
    digest = {"sha256": hashlib.sha256(Path(picture).expanduser().read_bytes()).hexdigest()} if picture else {}
    yield Event(bench.clock.now(), "photograph", picture or "none", {"item": key} | digest)
