"""A watch: new runs of a folder or the archive are fitted, looped and drafted, a person notified. It never signs.

What was looked at stands in `watched.json` of the watch's own folder, written after each run: a watch that was killed
goes on where it was, and nobody is notified twice. A run that cannot be worked out is reported like any other.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from labcal import session
from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.outputs import claim
from labcal.session import archiving
from labcal.session.from_archive import run_from_archive
from labcal.years.notify import Way, notify

COMMAND, STATE, FORMAT = "watch", "watched.json", "labcal-watch/1"
SETTLED_S = 5.0  # a file that was written to since may not be whole yet
GOOD = ("clean", "explained")
Say = Callable[[str], None]
New = Iterator[tuple[str, str, Callable[[], Path]]]  # key, name and the way to the bundle


@dataclass(frozen=True, slots=True)
class WatchedRun:
    """What became of one run: `key` tells it from every other, `needs` says what needs a person's eyes."""

    key: str
    run: str
    serial: str = ""
    verdict: str = ""
    summary: str = ""
    needs: tuple[str, ...] = ()
    draft: str = ""
    report: str = ""
    told: bool = False

    def in_words(self) -> str:
        """A few lines for a mail."""
        said = [f"{self.run}{f' ({self.serial})' if self.serial else ''}: {self.verdict or 'not worked out'}"]
        said += [f"  needs eyes: {one}" for one in self.needs]
        said += [f"  {one}" for one in (self.summary, self.draft, self.report) if one]
        return "\n".join(said)


@dataclass(frozen=True, slots=True)
class Source:
    """What is watched: a folder of bundles, or an archive (`given` as `--archive` states it)."""

    folder: Path | None = None
    given: str | None = None
    settled_s: float = SETTLED_S

    def new(self, known: frozenset[str], out: Path) -> New:
        """Key, name and the way to the bundle of each run that is not known. Raises InputError where it is away."""
        return _of_archive(self.given, known, out) if self.folder is None else self._of_folder(self.folder, known, out)

    def _of_folder(self, folder: Path, known: frozenset[str], out: Path) -> New:
        if not folder.is_dir():
            raise InputError("is no folder", file=folder)
        places = [*(file.parent for file in folder.rglob("run.json")), *folder.rglob("*.zip")]
        for place in sorted(p for p in places if not p.resolve().is_relative_to(out.resolve())):
            changed = _changed(place)
            key = f"{place.resolve()} {changed}"
            if changed is not None and key not in known and time.time() - changed[0] >= self.settled_s:
                yield key, place.name, lambda place=place: place  # type: ignore[misc]


def require_folder(out: Path) -> None:
    """Make the watch's folder. Raises InputError where it is labcal's own, and OSError."""
    claim(COMMAND, out / STATE, force=True, with_folder=True)
    out.mkdir(parents=True, exist_ok=True)


def look(source: Source, out: Path, ways: Sequence[Way], say: Say = lambda one: None) -> list[WatchedRun]:
    """Look once: work out what is new, then notify of it and of what could not be sent before; returns what is new.

    Raises InputError where the source is away, `out` cannot be written, or telling failed; what was found is kept.
    """
    require_folder(out)
    kept = _read(out / STATE)
    found = []
    for key, name, bundle in source.new(frozenset(kept), out):
        try:
            place = bundle()
        except InputError as away:  # of an archive: it is asked again at the next look
            say(f"{name}: {away}")
            continue
        one = _worked_out(key, name, place, out)
        say(one.in_words())
        found.append(one)
        kept[key] = one
        _write(out / STATE, kept)
    untold = [one for one in kept.values() if not one.told]
    if untold:
        _tell(ways, untold)
        _write(out / STATE, kept | {one.key: replace(one, told=True) for one in untold})
    return found


def watch(
    source: Source,
    out: Path,
    ways: Sequence[Way],
    every_s: float,
    say: Say,
    wait: Callable[[float], object] = time.sleep,
) -> None:
    """Look again and again until somebody stops it; what is away is reported once, and looked for again."""
    said = ""
    while True:
        try:
            look(source, out, ways, say)
            said = ""
        except (InputError, OSError) as fault:
            if str(fault) != said:
                say(str(fault))
            said = str(fault)
        wait(every_s)


def _worked_out(key: str, name: str, place: Path, out: Path) -> WatchedRun:
    """One run fitted, looped and drafted; whatever is wrong with it is what it needs eyes for."""
    try:
        run = session.load_run(place)
        stem = f"{session.run_bundle(place).sha256[:12]}"
        draft, report = out / f"{stem}.json", out / f"{stem}.html"
        closed = session.close_loop(place, draft, report=report)  # one that a person has changed since stays
    except Exception as fault:  # a watch outlives every run
        kind = "" if isinstance(fault, InputError) else f"{type(fault).__name__}: "
        return WatchedRun(key, name, needs=(f"{kind}{fault}",))
    needs = [] if closed.verdict in GOOD else [f"the verdict is {closed.verdict}"]
    if closed.next_experiment is not None and closed.verdict not in GOOD:
        needs.append(f"next: {closed.next_experiment.do}")
    lines = closed.conformity.lines if closed.conformity is not None else ()
    needs += [f"{line.quantity}: {line.result}" for line in lines if line.result not in ("pass", "conditional-pass")]
    files = str(draft), str(report)
    return WatchedRun(key, run.run_id, run.dut.serial, closed.verdict, closed.summary, tuple(needs), *files)


def _tell(ways: Sequence[Way], found: Sequence[WatchedRun]) -> None:
    eyes = [one for one in found if one.needs]
    subject = f"labcal: {len(found)} new runs, {len(eyes)} need eyes" if len(found) > 1 else _subject(found[0])
    order = [*eyes, *(one for one in found if not one.needs)]
    drafts = "Drafts only: nothing is signed until a person approves and signs it."
    text = "\n\n".join([*(one.in_words() for one in order), drafts]) + "\n"
    notify(ways, subject, text, {"format": FORMAT, "runs": [document(one) for one in order]})


def _subject(one: WatchedRun) -> str:
    return f"labcal: {one.run} {'needs eyes' if one.needs else f'is {one.verdict}'}"


def document(one: WatchedRun) -> dict[str, Any]:
    """As JSON has it."""
    return {name: value for name, value in asdict(one).items() if name not in ("key", "told")}


def _of_archive(given: str | None, known: frozenset[str], out: Path) -> New:
    rows = {row["sha256"]: row for row in archiving.archived_runs(given)}  # two sites may have the same run
    for row in rows.values():
        if row["sha256"] not in known:
            yield row["sha256"], row["run_id"], partial(run_from_archive, given, row, out / "bundles")


def _changed(place: Path) -> tuple[float, int] | None:
    """When a bundle was last written to and how large it is; None where it is gone again."""
    try:
        files = [place] if place.is_file() else [one for one in place.iterdir() if one.is_file()]
        stats = [one.stat() for one in files]
        return max(one.st_mtime for one in stats), sum(one.st_size for one in stats)
    except (OSError, ValueError):
        return None


def _read(path: Path) -> dict[str, WatchedRun]:
    """What was looked at so far. Raises InputError where the file is none of a watch's."""
    if not path.exists():
        return {}
    try:
        stated = json.loads(path.read_bytes())
        if stated["format"] != FORMAT:
            raise ValueError
        found = [WatchedRun(**{**one, "needs": tuple(one["needs"])}) for one in stated["runs"]]
    except (ValueError, KeyError, TypeError, RecursionError):
        raise InputError("is not what a watch keeps: name another folder", file=path) from None
    return {one.key: one for one in found}


def _write(path: Path, kept: dict[str, WatchedRun]) -> None:
    state = {"format": FORMAT, "runs": [asdict(one) for one in kept.values()]}
    write_text(path, json.dumps(state, indent=1, ensure_ascii=False) + "\n")
