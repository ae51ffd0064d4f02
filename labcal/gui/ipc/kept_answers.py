"""What was worked out of a run for the window, kept in labcal's folder: a window started again shows it at once.

Only what this very labcal, with the packages beside it, has made of as many rows is shown again: another may come to
other figures. Where the folder takes nothing, or what lies there cannot be read, it is to be worked out anew.
"""

from __future__ import annotations

import json
import shutil
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.home import home, own_folder
from labcal.gui.ipc.answers import Fitted, Loop
from labcal.gui.ipc.codec import decode, encode
from labcal.record import Run
from labcal.record.run_id import as_file_name

FOLDER, MOST_RUNS = "shown", 100
LOOP, FIT = "loop", "fit-"
Answer = TypeVar("Answer", Fitted, Loop)


def keep_loop(run: Run, answer: Loop) -> None:
    """Keep what the loop found in `run`."""
    _keep(run, LOOP, answer)


def keep_fit(run: Run, method: str, answer: Fitted) -> None:
    """Keep what a method made of `run`."""
    _keep(run, f"{FIT}{as_file_name(method)}", answer)


def kept_loop(run: Run) -> Loop | None:
    """What the loop found in `run`; None where that is not kept."""
    return _kept(run, _folder(run) / f"{LOOP}.json", Loop)


def kept_fits(run: Run, methods: tuple[str, ...]) -> dict[str, Fitted]:
    """What each of `methods` made of `run`, as far as it is kept, in the order in which it was worked out."""
    places = {method: _folder(run) / f"{FIT}{as_file_name(method)}.json" for method in methods}
    there = {method: place for method, place in places.items() if place.is_file()}
    found = {one: _kept(run, there[one], Fitted) for one in sorted(there, key=lambda one: there[one].stat().st_mtime)}
    return {method: answer for method, answer in found.items() if answer is not None}


def _folder(run: Run) -> Path:
    return home() / FOLDER / as_file_name(run.run_id)


def _keep(run: Run, name: str, answer: Fitted | Loop) -> None:
    with suppress(OSError, InputError):
        own_folder(own_folder(own_folder(home()) / FOLDER) / _folder(run).name)
        stated = {"made_by": _maker(), "rows": len(run), "answer": encode(answer)}
        write_text(_folder(run) / f"{name}.json", json.dumps(stated))
        _forget_oldest()


def _forget_oldest() -> None:
    """Of more runs than `MOST_RUNS` those that were worked out longest ago: they are to be worked out anew."""
    folders = sorted((home() / FOLDER).iterdir(), key=lambda one: one.stat().st_mtime)
    for folder in folders[:-MOST_RUNS]:
        shutil.rmtree(folder, ignore_errors=True)


def _kept(run: Run, place: Path, kind: type[Answer]) -> Answer | None:
    try:
        stated = json.loads(place.read_text(encoding="utf-8"))
        if (stated["made_by"], stated["rows"]) != (_maker(), len(run)):
            return None
        found: Answer = decode(kind, stated["answer"], place.name)
    except (OSError, ValueError, KeyError, TypeError, InputError):
        return None
    return found


def _maker() -> str:
    from labcal.session.working_out import this_labcal

    return this_labcal()
