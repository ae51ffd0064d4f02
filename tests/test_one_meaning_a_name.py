"""One meaning a name: a public class has the name of another only where it is listed here, with the reason."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[1]
ROOMS = ("labcal", "drivers", "procedures", "tools", "benchmarks")
EACH_DRIVERS_OWN = {"Settings", "Parser", "Conversation", "Channel", "Output", "Refused"}  # only within drivers
TWICE = {
    "the same thing in another file format": "ChannelPart DutPart ReferencePart SegmentPart",
    "what the window is sent of it, or shows of it": (
        "Bench Cage Doubt Identified Instrument LabState Loci Reference Signature Trend"
    ),
    "another thing in the window, whose messages and translations hold the name": (
        "Caller Change Channel Event Fitted Page Place Standing"
    ),
    "the emulators' view of the other side": "Lab Replies",
    "a word that means the same in two fields": "Connection Table",
}
THRICE = {"Table"}  # of a report, of the window, and of the supplies' commands or a stream's columns


@cache
def public_classes() -> Mapping[str, list[str]]:
    """The rooms of each public class by its name, but for what every driver has."""
    found: dict[str, list[str]] = defaultdict(list)
    for room in ROOMS:
        for path in sorted((ROOT / room).rglob("*.py")):
            for name in names_of(path.read_text(encoding="utf-8")):
                if room != "drivers" or name not in EACH_DRIVERS_OWN:
                    found[name].append(str(path.relative_to(ROOT)))
    return found


def names_of(source: str) -> Iterable[str]:
    return [n.name for n in ast.parse(source).body if isinstance(n, ast.ClassDef) and not n.name.startswith("_")]


def test_a_class_has_the_name_of_another_only_where_that_is_listed() -> None:
    found = {name: places for name, places in public_classes().items() if len(places) > 1}
    listed = {name for names in TWICE.values() for name in names.split()}
    assert {name: places for name, places in found.items() if name not in listed} == {}, "rename one of them"
    assert listed - found.keys() == set(), "listed, and there no more"
    assert {name: places for name, places in found.items() if len(places) > 2 and name not in THRICE} == {}, "rename"


def test_only_public_classes_of_a_module_count() -> None:
    assert list(names_of("class A:\n    class B: ...\nclass _C: ...\nD = 1\n")) == ["A"]
    assert len(public_classes()) > 500
