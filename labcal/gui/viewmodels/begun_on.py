"""On which bench a run was begun that broke off, beside the bench that is open now. No widgets."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.links.quoting import abridged
from labcal.gui.ipc.answers import Bench, InstrumentAnswer, RunLine
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.record.bench_kind import REAL, SERVED, SIMULATED, kind_of

BEGUN = QT_TRANSLATE_NOOP("Words", "Begun on the bench {0}.")
OTHER = QT_TRANSLATE_NOOP(
    "Words", "▲ Begun on the bench {0}; {1} is open. Open {0} first: with other instruments it does not go on."
)
WHICH = {
    SIMULATED: QT_TRANSLATE_NOOP("Words", "{0} (simulated)"),
    SERVED: QT_TRANSLATE_NOOP("Words", "{0} (served)"),
    REAL: QT_TRANSLATE_NOOP("Words", "{0} (not simulated)"),
}


def begun_on(one: RunLine) -> str:
    """In words; "" where the record does not name it."""
    return translated(str(BEGUN)).format(one.bench) if one.bench else ""


def another_bench(one: RunLine, facts: Bench | None, answered: Mapping[str, InstrumentAnswer]) -> str:
    """That another one is open than `one` was begun on, in words; "" where it is the same as far as anybody knows.

    Where an instrument has said by now that it is another, that is the reason: the run would refuse it by the same.
    """
    if facts is None or not one.bench:
        return ""
    for name, then in one.instruments:
        said = answered.get(name)
        if said is not None and said.fault is None and said.identity not in ("", abridged(then)):
            why = f"{name} was {abridged(then)} when run {one.run_id} began, now it is {said.identity}"
            return with_head(f"▲ {begun_on(one).removesuffix('.')}", in_words(why))
    now = kind_of(simulated=facts.virtual_time, served=facts.simulated)
    known = now if one.simulated == facts.simulated else SIMULATED if one.simulated else REAL
    then = one.bench_kind or known  # of a record that does not tell it
    if one.bench == facts.name and then == now:
        return ""
    names = one.bench, facts.name
    if one.bench == facts.name:  # a simulated lab is called as the real one, and as what it is served as
        names = translated(str(WHICH[then])).format(one.bench), translated(str(WHICH[now])).format(facts.name)
    return translated(str(OTHER)).format(*names)
