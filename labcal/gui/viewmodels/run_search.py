"""Runs as a person looks for them: by words and by days, in local time; and in the order of a column."""

from __future__ import annotations

import re
from collections.abc import Iterable
from datetime import UTC, date, datetime, timedelta
from pathlib import Path

from labcal.gui.ipc.answers import CalibrationFile, RunLine
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.record.endings import ended_word

NOT_WHOLE = ("running", "interrupted")
DAY = re.compile(r"(\d{1,2})[./](\d{1,2})\.?(?:[./]?(\d{4}))?")  # 22.11.2026, 22.11., 22/11/2026: the day first


def local_time(utc: str) -> datetime:
    """An ISO 8601 time on the clock of this place; where it is none, the beginning of time."""
    try:
        return datetime.fromisoformat(utc.replace("Z", "+00:00")).astimezone()
    except ValueError:
        return datetime.fromtimestamp(0).astimezone()


def cells(one: RunLine, stands: str = "") -> tuple[str, ...]:
    """A run's row: when it began by the clock of this place, DUT, procedure, operator, status, verdict or site, id.

    `stands`: what became of its calibration.
    """
    simulated = translated("SIMULATED") if one.simulated else ""
    return (
        f"{local_time(one.started_utc):%Y-%m-%d %H:%M}",
        one.dut_serial,
        " · ".join(filter(None, (one.procedure or "bundle", simulated))),
        one.operator,
        translated(ended_word(one.status, stopped=one.stopped)),
        one.site or " · ".join(filter(None, (verdict_word(one.verdict), stands))),  # the archive knows no verdicts
        one.run_id,
    )


def matches(one: RunLine, words: str, now: datetime, stands: str = "") -> bool:
    """Whether every word is a day on which the run began, or stands somewhere in its row."""
    began, line = local_time(one.started_utc).date(), " ".join((*cells(one, stands), one.status)).casefold()
    return all(word.casefold() in line or _is_day(word, began, now.date()) for word in words.split())


def in_order(runs: Iterable[RunLine], column: int, falling: bool) -> list[RunLine]:
    """`runs` by a column of `cells`; what is alike stays as it was, and times are those to the second."""
    return sorted(runs, key=lambda one: one.started_utc if column == 0 else cells(one)[column], reverse=falling)


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


def measured_s(one: CalibrationFile, runs: Iterable[RunLine]) -> float:
    """When what `one` was made of was measured [s since 1970]; of a run that is not here when its file was written."""
    started = next((run.started_utc for run in runs if run.run_id == one.run_id), None)
    if started is None:
        return datetime.fromtimestamp(Path(one.path).stat().st_mtime, UTC).timestamp()
    return moment_s(started)
