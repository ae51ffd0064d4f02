"""What went wrong, in words for the person at the bench, with the details behind a fold."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QTimer, Signal
from PySide6.QtGui import QPalette, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QPlainTextEdit, QScrollArea

from labcal.bench.coils import state
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.punctuation import listed_apart, parted
from labcal.gui.translations.sentences import in_words, of_this_bench
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.by_hand import by_hand_words, not_read_words
from labcal.gui.viewmodels.failed_step import without_age
from labcal.gui.viewmodels.guardian import guardian_is
from labcal.gui.viewmodels.in_brief import in_brief
from labcal.gui.viewmodels.lab_now import mark_of, platform_mark, platform_said
from labcal.gui.viewmodels.raw_reply import plainly
from labcal.gui.widgets.common import Card, button, label, set_state
from labcal.gui.widgets.kept_lines import KeptLines
from labcal.gui.widgets.whole_card import WholeCard

TITLES = {
    "input": "✕ This cannot be done as asked",
    "standard": "✕ The check standard is out of control",
    "instrument": "✕ An instrument failed",
    "record": "✕ The record is not kept",
    "guardian": "✕ The guardian failed",
    "clock": "✕ The clock was set back",
    "zero": "✕ The zero of the coils is in doubt",
    "coils": "✕ HANDS OFF: the coils may be on",
    "platform": "✕ HANDS OFF: the platform may still turn",
    "limit": "✕ A limit is not met",
    "stopped": "■ Stopped",
    "left": "▲ Broken off",
    "page": "✕ This page cannot be shown",
    "crash": "✕ Something in labcal broke",
    "ended": "✕ The work broke off",
    "off": "■ Stopped by COILS OFF (F12)",
}
KEEP_OFF = ("coils", "platform")  # whose heading says that hands have to be off

HANDS_MS = 500  # between two looks whether they may go near


def without(hands: str, said: str) -> str:
    """What is said of `hands`, without the reasons that the card has `said` in larger letters with what to do."""
    answer, apart, why = hands.partition(": ")
    left = [reason for reason in parted(why) if not said or reason not in said]
    return f"{answer}{apart}{listed_apart(left)}" if left else answer


class FaultCard(WholeCard):
    """Words, state of the coils where that matters, what to do, details and "save a problem report".

    `hands`: whether they may go near an instrument that is lost, in words, and the state that goes with it.
    """

    report_requested = Signal(object)  # Fault
    zero_wanted = Signal()  # to be checked now
    closed = Signal()
    edge, width_px = QPalette.ColorRole.BrightText, 2

    def __init__(self, closable: bool = True, hands: Callable[[], tuple[str, str]] | None = None) -> None:
        super().__init__(" ")
        self._hands = hands
        self.unit.hide()  # there is none: it would be an empty line above the words
        self.hands = label("", "title", wrap=True)
        self.hands.setAccessibleName(self.tr("Whether hands may go in"))
        self.hands_timer = QTimer(self, interval=HANDS_MS)
        self.hands_timer.timeout.connect(self._say_hands_again)
        self.fault: Fault | None = None
        self._tells_coils = False
        self.gravest = label("", "large", wrap=True)  # in place of the heading: nothing on the card is larger
        set_state(self.gravest, "bad")
        self.by_hand = label("", "ask", wrap=True)
        set_state(self.by_hand, "bad")
        self.not_read = label("", "caption", wrap=True)
        self.text, self.coils, self.remedy = (label("", wrap=True) for _ in range(3))
        self.platform, self.turning = label("", wrap=True), label("", "title", wrap=True)
        self.meaning = label("", "caption", wrap=True)  # of a word that stands above, and in no manual of an instrument
        self.details = QPlainTextEdit()
        self.details.setReadOnly(True)
        self.details.hide()
        self.details.setMinimumHeight(160)
        self.fold = button(self.tr("Details"), self.tr("Show what labcal itself says about it"))
        self.fold.setCheckable(True)
        self.fold.toggled.connect(self.details.setVisible)
        self.save = save = button(
            self.tr("Save a problem report …"), self.tr("A .zip with the details, settings and versions, no keys")
        )
        save.clicked.connect(lambda: self.report_requested.emit(self.fault))
        self.check_zero = button(
            self.tr("Check the zero now"), self.tr("Coils to zero, then what the reference sees; nothing is energised")
        )
        self.check_zero.clicked.connect(self.zero_wanted)
        self.check_zero.hide()
        self._closable, self.close_card = closable, button(self.tr("Close"), self.tr("Put this card away"))
        if not closable:  # shown while it has no place yet, it would be a window of its own
            self.close_card.hide()
        self.close_card.clicked.connect(self._close)
        row = QHBoxLayout()
        for widget in (self.check_zero, self.fold, save):
            row.addWidget(widget)
        row.addStretch()
        row.addWidget(self.close_card)
        said = (self.text, self.coils, self.platform, self.remedy, self.meaning)
        for part in (self.gravest, self.by_hand, self.not_read, self.turning, self.hands, *said):
            self.body.addWidget(part)
        lines = self.gravest, self.by_hand, self.not_read, self.turning, self.hands, *said
        self._kept = KeptLines(*lines, apart_px=self.body.spacing())
        self.body.addWidget(self._kept)
        self.body.addLayout(row)
        self.body.addWidget(self.details)  # it opens downward: its button stays below the mouse
        self.hide()

    def show_fault(self, fault: Fault | None) -> None:
        """Show `fault`, or nothing."""
        if fault is self.fault:
            return None
        self.fault, self._tells_coils = fault, False
        self._kept.forget()
        self.say_hands()
        self.coils.hide()
        self.by_hand.hide()
        self.not_read.hide()
        self.platform.hide()
        self.turning.hide()
        self.text.show()
        if fault is None:
            return self.hide()
        self.heading.setText(translated(TITLES[fault.kind]))
        self.gravest.setText(self.heading.text())
        self.gravest.setVisible(fault.kind in KEEP_OFF)
        self.heading.setHidden(fault.kind in KEEP_OFF)
        stopped = fault.kind == "stopped"  # as it was asked for: nothing is wrong
        set_state(self.heading, "" if stopped else "bad")
        self.edge, self.width_px = (Card.edge, Card.width_px) if stopped else (FaultCard.edge, FaultCard.width_px)
        self.save.setVisible(not stopped)
        self.check_zero.setVisible(fault.kind == "zero")
        self.text.setText(in_words(without_age(fault.text)))
        self.remedy.setText(of_this_bench(in_words(fault.remedy)))
        self.remedy.setVisible(bool(fault.remedy))
        self.meaning.setText(guardian_is(fault.kind, fault.text, fault.remedy))
        self.meaning.setVisible(bool(self.meaning.text()))
        self.details.setPlainText(self._for_others(fault))
        self.fold.setVisible(bool(self.details.toPlainText()) and not stopped)
        self.fold.setChecked(False)
        self.details.hide()
        QTimer.singleShot(0, self, self._come_into_sight)
        return self.show()  # whole at once: what is folded widens no window

    def resizeEvent(self, event: QResizeEvent) -> None:
        """At another width they have other lines."""
        if event.size().width() != event.oldSize().width():
            self._kept.forget()
        super().resizeEvent(event)

    def _for_others(self, fault: Fault) -> str:
        """What is behind the fold: of what is no technician's business, whose it is."""
        theirs = bool(fault.mends) or "Traceback" in fault.details
        head = self.tr("For who mends labcal; a problem report holds it:") if theirs else ""
        raw = fault.text if plainly(fault.text) != fault.text and fault.text not in fault.details else ""
        return "\n\n".join(filter(None, (head, fault.mends, raw, fault.details)))

    def _come_into_sight(self) -> None:
        """On a page that is scrolled."""
        holder = self.parentWidget()
        while holder is not None and not isinstance(holder, QScrollArea):
            holder = holder.parentWidget()
        if holder is not None and self.isVisible():
            holder.ensureWidgetVisible(self)

    def say_not_read(self, supplies: Sequence[str]) -> None:
        """Whom nobody has asked yet."""
        self.not_read.setText(not_read_words(supplies))
        self.not_read.setVisible(bool(supplies) and not self.by_hand.isHidden())
        self._kept.fit()

    def say_coils(self, words: str, supplies: Sequence[str] = (), known: str = "", *, pressed: bool = False) -> None:
        """How the coils are left, below what happened; which `supplies` a person switches off goes before all else.

        The figures of it stand in the details then. `known`: what was read before that, and
        what to look at first where several are silent. `pressed`: COILS OFF was.
        """
        self._kept.keep()
        shape, mark = mark_of(state.AT_ZERO)  # of other words none: beside the platform that stands it is as green
        seen = in_words(words) == in_words(state.AT_ZERO)
        self.coils.setText(f"{shape} {in_words(words)}" if seen else in_words(words))
        set_state(self.coils, mark if seen else "")
        self._tells_coils = True
        self.by_hand.setVisible(bool(supplies))
        self.text.setVisible(not supplies)
        if supplies and self.fault is not None:
            self.by_hand.setText(by_hand_words(supplies, pressed=pressed))
            short = in_words(in_brief(words))
            self.coils.setText(f"{short}. {known}" if known else short)
            figures = in_words(words), in_words(self.fault.text)
            said = dict.fromkeys((*figures, self._for_others(self.fault)))
            if (details := "\n".join(filter(None, said))) != self.details.toPlainText():
                self.details.setPlainText(details)
            self.fold.show()
        self._say_coils_once()
        self._kept.fit()

    def say_gravest(self, known: str) -> None:
        """In the largest letters what is `known`, in place of what may be."""
        if self.fault is not None:
            self.gravest.setText(known or translated(TITLES[self.fault.kind]))
            self._kept.fit()

    def let_check_zero(self, may: bool) -> None:
        """Whether a zero is in doubt that can be measured again: every supply says that it is one."""
        self.check_zero.setVisible(may)

    def let_close(self, may: bool) -> None:
        """Whether a person may put it away: not while what it warns of is known to stand."""
        self.close_card.setVisible(self._closable and may)

    def say_hands(self) -> None:
        """Where an instrument is lost somebody goes to its plug: whether that may be done now."""
        lost = self._hands is not None and self.fault is not None and self.fault.kind == "instrument"
        if lost and self._hands is not None:
            words, mark = self._hands()
            self.hands.setText(without(words, "" if self.turning.isHidden() else self.turning.text()))
            set_state(self.hands, mark)
        self.hands.setVisible(lost)
        self._say_coils_once()
        self._kept.fit()
        self.hands_timer.start() if lost else self.hands_timer.stop()

    def _say_hands_again(self) -> None:
        self._kept.keep()
        self.say_hands()

    def _say_coils_once(self) -> None:
        """What is said beside "Hands may go in" is not said again below it."""
        again = not self.hands.isHidden() and self.coils.text().removeprefix("✓ ") in self.hands.text()
        self.coils.setVisible(self._tells_coils and not again)

    def say_platform(self, words: str, *, told: bool = False) -> None:
        """Whether it may turn still, in larger letters, or was seen to stand; nothing of one without a motor.

        `told`: by COILS OFF, just now, to stop.
        """
        shape, mark = platform_mark(words)
        keep_off = mark in ("warning", "bad")
        for place, shown in ((self.turning, keep_off), (self.platform, not keep_off)):
            place.setText(f"{shape} {platform_said(words, told=told)}")
            place.setVisible(bool(words) and shown)
            set_state(place, mark)
        self.say_hands()

    def _close(self) -> None:
        self.hide()
        self.closed.emit()
