"""The line at the bottom says nothing that is past: who was said not to answer, and does again, is said to."""

from __future__ import annotations

import re
from datetime import datetime

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from labcal.bench.coils.at_zero import ORDERED
from labcal.gui.translations.punctuation import listed_apart
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.back_again import BackAgain
from labcal.gui.viewmodels.failed_step import SHOWN
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import LabNow, platform_said
from labcal.gui.viewmodels.lost_since import LostSince
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.watched import as_watched

EVERYBODY = (
    ("BenchPage", "All {0} instruments answered"),
    ("LabWatch", "{0} of {1} instruments were read"),
)
NUMBERS = {r"\{0\}": r"(\d+)", r"\{1\}": r"\1"}
AGAIN = QT_TRANSLATE_NOOP("Words", "{0}: answers again, no answer from {1} to {2}")


def _all(form: tuple[str, str]) -> re.Pattern[str]:
    """What says of everybody that they answer, in the window's language."""
    said = re.escape(QCoreApplication.translate(*form))
    return re.compile(re.sub(r"\\\{\d\\\}", lambda found: NUMBERS[found[0]], said))


def _how_it_is(now: LabNow) -> str:
    """Coils and platform, in words that grow no age while they are read on."""
    seen = as_watched(now)
    return listed_apart([*filter(None, (in_words(seen.coil_words), platform_said(seen.platform_words)))])


class SaidNoMore:
    """Looks at the lab each time that it is known anew."""

    def __init__(self, lab: LabViewModel, run: RunViewModel) -> None:
        self._lab, self._run = lab, run
        self.back = BackAgain(lab, run)  # in the lists, where the next word does not replace it
        self._lost, self._times = set[str](), LostSince()
        self._since = dict[str, str]()
        self._out_then = self._state_then = ""  # of the line: who was out, and how coils and platform were
        self._was_out = dict[str, str]()  # by who was lost and is back: when it was last, in words

    def look(self, warned: str = "") -> None:
        """`warned`: what was said of coils that were not confirmed, and are; they are said to be as they are now.

        Where the line names one that was lost and is not any more, it says that.
        """
        self.back.look()
        message, now = self._lab.state.message, self._lab.state.now
        back, self._lost = sorted(self._lost - set(now.failed)), set(now.failed)
        self._was_out |= {one: self._out(one) for one in back}
        self._since = self._times.since(now)
        zero = now.coils_at_zero and any(said in message for said in (ORDERED, in_words(ORDERED)))
        named = [one for one in back if one in message]
        if now.failed and any(_all(form).fullmatch(message) for form in EVERYBODY):
            self._say(translated(str(SHOWN)).format(", ".join(now.failed)))
        elif zero or (warned and message == warned):
            self._out_then = "; ".join(s for n, s in self._was_out.items() if n in message and n not in now.failed)
            self._state_then = _how_it_is(now)
            self._say("; ".join(filter(None, (self._out_then, self._state_then))))
        elif self._state_then and message.endswith(self._state_then) and _how_it_is(now) != self._state_then:
            self._state_then, said_at = "", self._lab.state.said_at  # what happened stays, how it was then is past
            self._say(self._out_then)
            self._lab.update(said_at=said_at if self._out_then else "")
        elif named:
            self._say("; ".join(self._was_out[one] for one in named))

    def _out(self, name: str) -> str:
        """That it answers again, and from when to when it did not."""
        return translated(str(AGAIN)).format(name, self._since.get(name, ""), f"{datetime.now():%H:%M:%S}")

    def _say(self, words: str) -> None:
        if self._run.alive:
            self._run.message = words  # else it says the old words again with its next item
        self._lab.update(message=words)
