"""`labcal bench off FILE`: to load the command line first would take longer than the way to zero.

What was read back is said here too, within a moment of its reading; what went wrong is for the command line to say.
"""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.bench.coils.at_zero import BY_WORD, SLOW_S
from labcal.bench.stage_off import StageStop
from labcal.files.home import SECRETS
from labcal.files.text_safety import in_utf8, one_line
from labcal.system.private_memory import kept_private

if TYPE_CHECKING:
    from labcal.bench.coils.at_zero import AtZero

DONE, INSTRUMENT_FAILED = 0, 3  # as the command line's
NO_ANSWER = "supplies of an earlier session do not answer"
GONE = "Switch them off by hand; where they are gone, say so in labcal's window after COILS OFF"
NAMED = "what was driven under this name or, where nothing was, what the file still says of its supplies"
_ended: dict[Path, list[AtZero] | Exception] = {}
_stage: dict[Path, StageStop] = {}


def is_off(words: Sequence[str]) -> bool:
    """Whether this is `bench off FILE` and nothing else: what has options is for the command line to read."""
    return len(words) == 3 and [*words[:2]] == ["bench", "off"] and not words[2].startswith("-")


def off(file: Path) -> int | None:
    """Bring the coils down and say how they ended; the exit code, None where the command line has more to say."""
    in_utf8()
    begin(file)
    ended = _ended[file]
    if isinstance(ended, Exception):
        return None
    try:
        return reported(file, ended)
    except Exception as error:  # nobody reads, or a fault of ours: as above
        _ended[file] = error
        return None


def begin(file: Path) -> None:
    """Bring the coils down; how that ended is kept for `coils_off`."""
    if any(name in os.environ for name in SECRETS):
        kept_private()
    try:
        _ended[file] = coils_off(file)
    except Exception as error:  # the command line says it, in its own words and with its own exit code
        _ended[file] = error


def coils_off(file: Path) -> list[AtZero]:
    """How each coil of `file` ended that was brought down from here; where that takes long it is said on stderr."""
    if (ended := _ended.pop(file, None)) is None:
        from labcal.bench.shutdown import coils_off  # not by way of the session, which loads for a second

        _stage[file] = StageStop(file, _said_where_slow)
        try:
            return coils_off(file, _stage[file].meanwhile, _stage[file].begin)
        finally:
            _stage[file].begin()  # whatever became of the coils
    if isinstance(ended, Exception):
        raise ended
    return ended


def reported(file: Path, ended: list[AtZero]) -> int:
    """Say on stdout how each coil ended, and what may be said of all; the exit code."""
    for end in ended:
        current = "unknown " if end.current_A is None else f"{end.current_A:+.4f} A  {BY_WORD}:"
        print(one_line(f"coil {end.axis}: {current} {end.words}{end.age_words}"), flush=True)
    from labcal.bench.coils.doubt import left_so  # when all that was read back is said
    from labcal.bench.shutdown import unread

    if why := unread(file):
        aloud(f"! {why}. Reported above is {NAMED}.")
    print(one_line(left_so(file, ended)), flush=True)
    if left := ", ".join(end.axis for end in ended if end.earlier_at and end.fault):
        aloud(f"! {NO_ANSWER}: {left}. {GONE}")
    if file in _stage and (platform := _stage.pop(file).ended()) is not None:
        why = f" ({platform.fault})" if platform.fault else ""
        aloud(platform.sentence(time.monotonic()) + why)
    return INSTRUMENT_FAILED if any(end.fault for end in ended) else DONE


@contextmanager
def _said_where_slow(words: str) -> Iterator[None]:
    """`words` on stderr after a while, unless all within is done by then."""
    later = threading.Timer(SLOW_S, aloud, (words,))
    later.daemon = True
    with suppress(RuntimeError):  # no memory for it
        later.start()
    try:
        yield
    finally:
        later.cancel()


def aloud(words: str) -> None:
    """One line on stderr, for whoever reads there."""
    with suppress(OSError, ValueError, AttributeError):  # nobody reads, or there is no stderr
        print(one_line(words), file=sys.stderr, flush=True)
