"""Installation qualification: does what is installed here do what it should? Every check is said, and kept as a page.

`installed` looks at versions and files, `line` drives the simulated lab from preflight to signature, `surroundings` at
this computer: its folder, its ports, its screen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from labcal.self_test.installed import check_files, check_versions
from labcal.self_test.page import place_for, qualification_page, write_page
from labcal.self_test.result import Check, Qualification, guarded
from labcal.self_test.simulated_line import check_line
from labcal.self_test.surroundings import check_folder, check_ports, check_window, computer

__all__ = ["Check", "Qualification", "place_for", "qualification_page", "qualify", "write_page"]

Begin = Callable[[str], None]


def qualify(begin: Begin = lambda name: None, on_check: Callable[[Check], None] = lambda check: None) -> Qualification:
    """Make every check, in a folder of its own; `begin` gets what is looked at, `on_check` each check."""
    made = []
    with TemporaryDirectory(prefix="labcal-self-test-") as place:
        for check in _checks(Path(place), begin):
            on_check(check)
            made.append(check)
    return Qualification(computer(), tuple(made))


def _checks(place: Path, begin: Begin) -> Iterator[Check]:
    begin("looking at what is installed")
    yield guarded("versions", check_versions)
    begin("hashing every installed file")
    yield guarded("files", check_files)
    yield guarded("labcal's folder", check_folder)
    yield guarded("serial ports", check_ports)
    yield from check_line(place / "demo", begin)
    begin("opening the window")
    yield guarded("window", lambda: check_window(place / "window"))
