"""Numbered steps beside each other, each a card with its state, its fields, its rules and one button."""

from __future__ import annotations

import time
from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QPalette, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.signing import MARKS, SigningStep
from labcal.gui.widgets import next_button
from labcal.gui.widgets.common import Card, button, label, named, rename, set_primary, set_state
from labcal.gui.widgets.flow import Flow

LETTERS = 28  # a card is at least as wide: with less room they stand below each other


class StepCard(Card):
    """Fields, the button below them at one height in every card of a row, then words.

    Where cards stand below each other, or none of them is to be done, those that are not are folded to one line.
    """

    def __init__(self, title: str, rules: str = "") -> None:
        super().__init__(title)
        self._title, self._asked_s = title, 0.0
        self.mark, self.words, self.wrong = label("", "caption"), label("", wrap=True), label("", wrap=True)
        self.done, self.asked = label("", "caption", wrap=True), label("", wrap=True)
        self.rules = label(rules, "caption", wrap=True)
        self.holder = QWidget()
        self.fields = QVBoxLayout(self.holder)
        self.fields.setContentsMargins(0, 0, 0, 0)
        self.fields.setSpacing(GRID)
        self.fields.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.stacked = self.opened = self.now = False
        self.step, self.while_open = "", list[QLabel]()
        self.unfold = named(button(self.tr("Show"), self.tr("What is done in this step")), "small")
        self.unfold.clicked.connect(self._unfold)
        self.unfold.hide()
        self.heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.head.removeWidget(self.heading)
        self.top = Flow(self.heading, self.mark, self.unfold)
        self.head.addLayout(self.top, 1)
        self.unit.hide()
        self.body.addWidget(self.holder)
        for part in (self.wrong, self.asked, self.words, self.done, self.rules):
            self.body.addWidget(part)
        set_state(self.wrong, "bad")
        set_state(self.asked, "warning")
        self.wrong.hide()
        self.asked.hide()
        self.done.hide()
        self.rules.setVisible(bool(rules))
        self.body.addStretch()
        self.button = QPushButton()

    def put(self, fields: Sequence[QWidget], does: QPushButton) -> None:
        """The fields of this step, and the button that does it."""
        for field in fields:
            self.fields.addWidget(field)
        self.button = does
        self.body.insertWidget(self.body.indexOf(self.holder) + 1, does)

    def _unfold(self) -> None:
        self.opened = True
        self.fold()

    def stack(self, stacked: bool) -> None:
        """Whether it stands below another one, or is to be out of the way."""
        if stacked != self.stacked:
            self.stacked, self.opened = stacked, False
            self.fold()

    @property
    def folded(self) -> bool:
        """Whether its heading is all there is to see."""
        return self.stacked and not self.now and not self.opened

    def fold(self) -> None:
        """Show the whole card, or its heading alone."""
        self.unfold.setVisible(self.folded)
        self._head_in_short()
        self.holder.setVisible(not self.folded and self.fields.count() > 0)
        self.button.setVisible(not self.folded)  # asked each time: what is hidden may lay the row out anew meanwhile
        self.rules.setVisible(self.now and bool(self.rules.text()))
        self.words.setVisible(bool(self.words.text()) and not self._over)
        again = self.done.text() == self.words.text()
        self.done.setVisible(bool(self.done.text()) and not again and not self._over)
        for part in self.while_open:
            part.setVisible(bool(part.text()) and not self._over)
        self.setToolTip(self.words.text() if self._over else "")

    def name_it(self, title: str) -> None:
        """Another title."""
        self._title, self._asked_s = title, 0.0
        self._head_in_short()

    def _head_in_short(self) -> None:
        """Over and folded: its mark before its name, on one line however narrow the card is."""
        shape, _, state = MARKS.get(self.step, ("", "", ""))
        rename(self.heading, "" if self._over else "title")
        set_state(self.heading, state if self._over else "")
        self.heading.setText(f"{shape} {self._title}" if self._over else self._title)
        self.heading.setToolTip(self.mark.text() if self._over else "")
        self.mark.setVisible(not self._over)

    @property
    def _over(self) -> bool:
        """Folded, with nothing that is still to come of it: its mark says all."""
        return self.folded and self.step in ("done", "never")

    def show_step(self, step: SigningStep) -> None:
        """How it stands; what is to be done now has an edge in the accent, and the blue button."""
        shape, name, state = MARKS[step.mark]
        self.mark.setText(f"{shape} {translated(str(name))}")
        set_state(self.mark, state)
        self.words.setText(step.words)
        now, self.step = step.mark == "now", step.mark
        self.opened = self.opened and now is self.now
        self.now = now
        self.fold()
        self.edge, self.width_px = (QPalette.ColorRole.Highlight, 2) if now else (Card.edge, Card.width_px)
        set_primary(self.button, now)
        self.update()

    def say_done(self, words: str) -> None:
        """What was done in this step just now."""
        self.done.setText(words)
        self.fold()

    def ask(self, words: str) -> None:
        """What is to be known before its button is pressed once more."""
        self.asked.setText(words)
        self.asked.setVisible(bool(words))
        self._asked_s = time.monotonic()

    def asked_just_now(self) -> bool:
        """Whether a press was meant for what the button said before: the second one of a double click."""
        return not self.asked.isHidden() and time.monotonic() - self._asked_s < next_button.TOO_SOON_MS / 1000

    def say_wrong(self, words: str) -> None:
        """What is against that which is typed."""
        self.wrong.setText(f"✕ {words}" if words else "")
        self.wrong.setVisible(bool(words))


class StepRow(QWidget):
    """Cards in a row where there is room for all of them, else below each other."""

    def __init__(self) -> None:
        super().__init__()
        self._cards: tuple[StepCard, ...] = ()
        self._at_rest = False
        self._box = QBoxLayout(QBoxLayout.Direction.TopToBottom, self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(2 * GRID)

    def hold(self, cards: Sequence[StepCard]) -> None:
        """The cards, in order."""
        self._cards = tuple(cards)
        for card in cards:
            self._box.addWidget(card, 1)
        self._turn()

    def minimumSizeHint(self) -> QSize:
        """As narrow as the widest card: it need not be a row."""
        return QSize(max(one.minimumSizeHint().width() for one in self._cards), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width."""
        super().resizeEvent(event)
        self._turn()

    def event(self, event: QEvent) -> bool:
        """Letters of another size."""
        if event.type() == QEvent.Type.LayoutRequest:
            self._turn()
        return super().event(event)

    def rest(self, at_rest: bool) -> None:
        """Where nothing is to be done in any of them they are folded, in a row too."""
        if at_rest != self._at_rest:
            self._at_rest = at_rest
            self._turn()

    def _turn(self) -> None:
        if not self._cards:
            return
        needed = len(self._cards) * LETTERS * self._cards[0].words.fontMetrics().averageCharWidth()
        row = self.width() >= needed
        shown = [card for card in self._cards if row and not card.folded]
        lower = self._lower(shown)
        own = [card.fields.sizeHint().height() - card.fields.contentsMargins().top() for card in shown]
        for card in self._cards:
            card.stack(not row or self._at_rest)
            above = lower.get(card, 0)
            card.fields.setContentsMargins(0, above, 0, 0)
            if card.holder.minimumHeight() != (high := max(own, default=0) + above):
                card.holder.setMinimumHeight(high)
        way = QBoxLayout.Direction.LeftToRight if row else QBoxLayout.Direction.TopToBottom
        if way != self._box.direction():
            self._box.setDirection(way)
            self.updateGeometry()

    def _lower(self, shown: Sequence[StepCard]) -> dict[StepCard, int]:
        """By how much the fields of each begin lower, where another heading has its mark below it [px]."""
        width = (self.width() - (len(self._cards) - 1) * self._box.spacing()) // len(self._cards) - 4 * GRID
        tops = {card: card.top.heightForWidth(width) for card in shown}
        return {card: max(tops.values()) - top for card, top in tops.items()}
