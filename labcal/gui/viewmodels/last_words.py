"""Whose run it was, and how it ended, in one line: in the language that the window speaks now."""

from __future__ import annotations

from collections.abc import Mapping

from labcal.bench.named_links import named_links
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.failed_step import without_age
from labcal.record.endings import BY_OFF, ended_words


def last_words(order: RunProcedure | None, began: str, ending: str, links: Mapping[str, str], *, by_off: bool) -> str:
    """Of a run that has ended as `ending` says, or `by_off`: by COILS OFF."""
    said = translated(BY_OFF) if by_off else in_words(ended_words(without_age(named_links(ending, links))))
    name = " · ".join(filter(None, (order.dut, began, order.procedure))) if order else ""
    return with_head(name, said) if name else said
