"""What was not confirmed when a window closed, or died: kept in a small file, until a window has read it at rest.

By bench file: the supplies that were not known to be at zero, the platform that was not seen to stand, and when.
"""

from __future__ import annotations

import json
import time
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.punctuation import listed_apart
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, mark_of, platform_mark

NAME = "unconfirmed.json"
ANEW_S = 30.0  # a window that is killed says no more: its last word is never older than that
COILS, PLATFORM = "coils", "platform"
WORDS = {
    COILS: QT_TRANSLATE_NOOP("Words", "{0}: not confirmed at zero when the window closed, {1}"),
    PLATFORM: QT_TRANSLATE_NOOP("Words", "{0}: not confirmed at a standstill when the window closed, {1}"),
}


class LeftUnconfirmed:
    """Of one bench file at a time. `left`: by kind, as a window before this one left it; nothing of it was read yet."""

    def __init__(self) -> None:
        self._bench, self._written, self._written_s = "", dict[str, list[str]](), 0.0
        self.left = dict[str, list[str]]()
        self._closed_s = 0.0

    def look(self, bench: str) -> None:
        """Into the file, for `bench`."""
        if bench == self._bench:
            return
        said = _kept().get(bench, {})
        self._bench, self._closed_s = bench, float(said.get("unix_s", 0.0))
        self.left = {kind: list(said[kind]) for kind in WORDS if said.get(kind)}
        self._written = dict(self.left)

    def seen_in(self, now: LabNow) -> LabNow:
        """The lab, with what is still to be read since; a run says itself how it is."""
        unread = {COILS: now.coil_words in ("", state.NOT_READ), PLATFORM: not now.platform_words}
        said = [_said(kind, names, self._closed_s) for kind, names in self.left.items() if unread[kind]]
        return replace(now, closed_with=listed_apart(said)) if said and not now.driven else now

    def keep(self, now: LabNow, by_hand: tuple[str, ...], facts: Bench | None, *, closing: bool = False) -> None:
        """Write down what is not confirmed `now`, and nothing any more of what is; of a lab that is there."""
        if not self._bench or facts is None or facts.virtual_time or now.driven_elsewhere:
            return
        if now.coils_at_zero:
            self.left.pop(COILS, None)
        if platform_mark(now.platform_words)[1] == "good":
            self.left.pop(PLATFORM, None)
        open_now = {**self.left, **_unconfirmed(now, by_hand, facts)}
        late = bool(open_now) and (closing or time.time() - self._written_s > ANEW_S)
        if open_now != self._written or (late and open_now != self.left):  # what a window before left has its time
            self._written, self._written_s = open_now, time.time()
            _write(self._bench, {**open_now, "unix_s": self._written_s} if open_now else None)


def _unconfirmed(now: LabNow, by_hand: tuple[str, ...], facts: Bench) -> dict[str, list[str]]:
    """By kind; what a run has on is its own."""
    coils = mark_of(now.coil_words)[1] == "bad" or now.coil_words == state.NOT_SINCE
    coils = coils or (now.coil_words.startswith(state.ON) and not now.driven)
    turns = platform_mark(now.platform_words)[1] in (("bad",) if now.driven else ("bad", "warning"))
    platform = [name for name, one in facts.instruments.items() if one.role == "platform"]
    said = {COILS: list(by_hand) if coils else [], PLATFORM: platform if turns else []}
    return {kind: names for kind, names in said.items() if names}


def _said(kind: str, names: list[str], closed_s: float) -> str:
    at = datetime.fromtimestamp(closed_s)
    when = f"{at:%H:%M}" if at.date() == datetime.now().date() else f"{at:%Y-%m-%d %H:%M}"
    return translated(str(WORDS[kind])).format(", ".join(names), when)


def _file() -> Path:
    return own_folder(home()) / NAME


def _kept() -> dict[str, Any]:
    """By bench file; nothing where the file is absent, cut or of somebody else."""
    with suppress(OSError, ValueError):
        said = json.loads(_file().read_text(encoding="utf-8"))
        if isinstance(said, dict):
            return {bench: one for bench, one in said.items() if isinstance(one, dict)}
    return {}


def _write(bench: str, said: dict[str, Any] | None) -> None:
    """A full disk is no fault of the window's."""
    with suppress(OSError):
        kept = {**_kept(), bench: said}
        left = {one: said for one, said in kept.items() if said}
        if left:
            write_bytes(_file(), json.dumps(left).encode(), FILE)
        else:
            _file().unlink(missing_ok=True)
