"""Whose run it was, and how it ended, in one line: in the language that the window speaks now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from labcal.bench.named_links import named_links
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.record.endings import BY_OFF, ended_words

if TYPE_CHECKING:
    from labcal.gui.viewmodels.run import RunViewModel


def last_words(run: RunViewModel) -> str:
    """Of a run that has ended."""
    said = in_words(ended_words(named_links(run.ending or run.status, run.links)))
    said = translated(BY_OFF) if run.by_off and run.status != "finished" else said
    name = " · ".join(filter(None, (run.order.dut, run.began, run.order.procedure))) if run.order else ""
    return f"{name}: {said}" if name else said
