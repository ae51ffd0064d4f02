"""What is to be done about a bench of which something does not answer, or is not known to be at zero. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.links.heard_before import PLUG
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import in_words, of_this_bench
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.by_hand import by_hand_words
from labcal.gui.viewmodels.guardian import GUARDIAN, guardian_is
from labcal.gui.viewmodels.lab_now import alarm_of, shown_name

SEE_TO = QT_TRANSLATE_NOOP("Words", "{0}: see to plug, power and cable.")
AGAIN = QT_TRANSLATE_NOOP("Words", "Read all asks again.")
PLUGS = QT_TRANSLATE_NOOP(
    "Words", "they have answered at these links before: are their plugs in at both ends, and have they power?"
)
ALONE = QT_TRANSLATE_NOOP("Words", "The guardian is lost. COILS OFF (F12) works without it.")


def to_do(app_state: AppState) -> str:
    """In words: the coils first, then the guardian, then each instrument that is lost, with what is known to help."""
    now = app_state.lab.state.now
    guardian = shown_name(GUARDIAN)
    lost = [name for name in now.failed if name != guardian]
    known = {name: said for name in lost if (said := remedy_of(app_state, name))}
    unknown = ", ".join(name for name in lost if name not in known)
    words = [_of_each([name for name in known if known[name] == said], said) for said in dict.fromkeys(known.values())]
    words += [translated(str(SEE_TO)).format(unknown)] if unknown else []
    words += [translated(str(AGAIN))] if lost else []
    if guardian in now.failed:
        words = [translated(str(ALONE)), guardian_is(GUARDIAN), *words]
    if alarm := alarm_of(now.coil_words):
        off = app_state.by_hand()
        words = [f"{alarm}. {by_hand_words(off, pressed=bool(app_state.off.pressed))}." if off else f"{alarm}.", *words]
    return " ".join([*words, *filter(None, (now.in_common,))]) if words else ""


def _of_each(names: list[str], said: str) -> str:
    """The same question about several is asked once."""
    plural = len(names) > 1 and said == of_this_bench(in_words(PLUG))
    return with_head(", ".join(names), translated(str(PLUGS)) if plural else said)


def remedy_of(app_state: AppState, name: str) -> str:
    """What to do about an instrument, as whoever asked it says; "" where that is not known."""
    answered = app_state.answered.get(name)
    return "" if answered is None or answered.fault is None else of_this_bench(in_words(answered.fault.remedy))
