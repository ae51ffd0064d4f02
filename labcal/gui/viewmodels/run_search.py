"""Runs as a person looks for them: by words and by days, in local time; and in the order of a column."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import NamedTuple

from labcal.gui.ipc.answers import CalibrationFile, RunLine
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.record.endings import ended_word

HEADINGS = ("started", "DUT", "procedure", "operator", "result", "calibration", "run")
OF_ARCHIVE = tuple(heading if heading != "calibration" else "site" for heading in HEADINGS)
SHAPES = "✓▲✕■?○● "
NOT_WHOLE = ("running", "interrupted")
DAY = re.compile(r"(\d{1,2})[./](\d{1,2})\.?(?:[./]?(\d{4}))?")  # 22.11.2026, 22.11., 22/11/2026: the day first


class FoundRun(NamedTuple):
    """A run with its cells, and the colour of its result."""

    run: RunLine
    cells: tuple[str, ...]
    state: str


def local_time(utc: str) -> datetime:
    """An ISO 8601 time on the clock of this place; where it is none, the beginning of time."""
    try:
        return datetime.fromisoformat(utc.replace("Z", "+00:00")).astimezone()
    except ValueError:
        return datetime.fromtimestamp(0).astimezone()


def cells(one: RunLine, stands: str = "", result: str = "") -> tuple[str, ...]:
    """A run's row: when it began by the clock of this place, DUT, procedure, operator, result, calibration or site, id.

    `stands`: what became of its calibration. `result`: how it came out, as the card of its end says it.
    """
    simulated = translated("SIMULATED") if one.simulated else ""
    return (
        f"{local_time(one.started_utc):%Y-%m-%d %H:%M}",
        one.dut_serial,
        " · ".join(filter(None, (one.procedure or "bundle", simulated))),
        one.operator,
        result or translated(ended_word(one.status, stopped=one.stopped, by_off=one.by_off)),
        one.site or " · ".join(filter(None, (verdict_word(one.verdict), stands))),  # the archive knows no verdicts
        one.run_id,
    )


def matches(one: RunLine, words: str, now: datetime, row: Sequence[str] | None = None) -> bool:
    """Whether every word is a day on which the run began, or stands somewhere in its `row` (its `cells`)."""
    began, line = local_time(one.started_utc).date(), " ".join((*(row or cells(one)), one.status)).casefold()
    return all(word.casefold() in line or _is_day(word, began, now.date()) for word in words.split())


def rows_of(
    runs: Iterable[RunLine],
    words: str,
    now: datetime,
    stands: Callable[[str], str],
    told: Callable[[RunLine], tuple[str, str]],
    order: tuple[int, bool],
) -> list[FoundRun]:
    """The rows of those runs that `words` find, in their order: `stands` and `told` say what became of each."""
    rows = (FoundRun(one, cells(one, stands(one.run_id), word), state) for one in runs for word, state in [told(one)])
    return in_order((row for row in rows if matches(row.run, words, now, row.cells)), *order)


def in_order(rows: Iterable[FoundRun], column: int, falling: bool) -> list[FoundRun]:
    """`rows` by a column; what is alike stays as it was, times are those to the second, and shapes do not count."""

    def key(row: FoundRun) -> str:
        return row.run.started_utc if column == 0 else row.cells[column].lstrip(SHAPES)

    return sorted(rows, key=key, reverse=falling)


def _is_day(word: str, began: date, today: date) -> bool:
    named = {translated("today"): 0, translated("yesterday"): 1, "today": 0, "yesterday": 1}
    if (ago := named.get(word.casefold())) is not None:
        return began == today - timedelta(days=ago)
    found = DAY.fullmatch(word)
    if found is None:
        return False
    day, month, year = found.groups()
    return (began.day, began.month) == (int(day), int(month)) and year in (None, str(began.year))


def file_name(one: RunLine) -> str:
    """By site, serial and date, as it is found again in a folder. What others called it names no other folder."""
    began = f"{local_time(one.started_utc):%Y-%m-%d_%H%M%S}"
    parts = (one.site, one.dut_serial, began, one.procedure or "bundle")
    return "_".join(re.sub(r"[^\w.-]", "-", part) for part in parts if part)


def moment_s(utc: str) -> float:
    """An ISO 8601 time [s since 1970]."""
    return datetime.fromisoformat(utc.replace("Z", "+00:00")).timestamp()


def measured_s(one: CalibrationFile, runs: Iterable[RunLine]) -> float | None:
    """When what `one` was made of was measured [s since 1970]; of a run that is not here when its file was written.

    None where that file is gone by now.
    """
    started = next((run.started_utc for run in runs if run.run_id == one.run_id), None)
    if started is not None:
        return moment_s(started)
    try:
        return datetime.fromtimestamp(Path(one.path).stat().st_mtime, UTC).timestamp()
    except OSError:
        return None
