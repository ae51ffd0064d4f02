"""The card of a question: large words, a drawing of the mounting, and buttons that no scanner and no Enter presses."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QPaintEvent, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout

from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.failed_step import NO_ANSWER, WHAT, asked_text, below, headline
from labcal.gui.viewmodels.first_thing import first_thing
from labcal.gui.viewmodels.hands import READY, RETRY, STILL_LOST, coming, reached_into
from labcal.gui.viewmodels.hands_now import MAY, dated, hands_of
from labcal.gui.viewmodels.lab_now import OFF, LabNow, age_words, mark_of, platform_drawn
from labcal.gui.viewmodels.lost_since import to_be_seen_to
from labcal.gui.viewmodels.may_answer import acting, may_answer, moves_by_itself, wanted
from labcal.gui.viewmodels.run import SERIAL
from labcal.gui.viewmodels.watched import as_watched
from labcal.gui.viewmodels.what_happens import in_shape
from labcal.gui.widgets.answer_words import MOUNTING, WORDS, answer_label, unbroken
from labcal.gui.widgets.camera_view import CameraView
from labcal.gui.widgets.common import button, label, named, plain, set_state
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.hold_button import KEYS, HoldButton
from labcal.gui.widgets.mounting_view import Mounting
from labcal.gui.widgets.notes_room import NotesRoom
from labcal.gui.widgets.order_label import OrderLabel
from labcal.gui.widgets.rolled import Rolled
from labcal.gui.widgets.whole_card import UncutCard
from labcal.record.stream import Prompt

CALLS_EVERY_MS = 20_000  # while nobody answers
WORDED, PICTURED, CROWDED = 15, 13, 5  # of the width, for words and drawing; for this where words need room
DEAD_MS = 1000  # from when a question is seen until it may be answered: a second click was meant for the one before it
STANDS = "mounting-stands"  # the question whether the DUT stands as before an interruption
ANOTHER_DUT = "another-dut"  # the question whether a DUT that names another serial is measured all the same
FILE = "file"  # in a prompt's drawing: the words are the path of one


class PromptCard(UncutCard):
    """Shows one `Prompt`; `answered` carries the choice, or the text where there are no choices.

    `calls` when it comes up, and again and again until it is answered. Its buttons are dead (disabled) for the first
    second that it is seen, each time.
    """

    answered = Signal(str)
    calls = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Question to you"))
        self._prompt: Prompt | None = None
        self._keeps_a_turn, self._delays = False, ""  # of before an interruption
        self._reached_into = False  # what is asked brings hands to the lab
        self._lost = self._mended = False  # somebody, since it was asked; who was is heard again
        self._first = ""  # what comes before a plug
        self._usual = self._how = ""  # how it is answered, with what that means; by which key alone
        self._said_once = False  # how the coils are is said whole where hands are told that they may go in
        self._who, self._since, self._back = list[str](), list[str](), ""  # who is lost; who was, and answers again
        self._waits = False  # what sends hands to the lab: for the lab
        self.text, self.hint, self.drawing = OrderLabel(theme), label("", "caption", wrap=True), Mounting(theme)
        words = QVBoxLayout()
        words.setSpacing(2 * GRID)
        words.addWidget(label(self.tr("YOUR TURN"), "caption"))
        words.addWidget(self.text, 1)
        self.details = label("", "title", wrap=True)
        self.hands, self.lab, self.stands = label("", "title", wrap=True), label("", wrap=True), label("", wrap=True)
        self.hands.setAccessibleName(self.tr("Whether hands may go in"))
        self.lab.setAccessibleName(self.tr("How the coils are"))
        self.stands.setAccessibleName(self.tr("How the platform is"))
        self.moved, self.serials = label("", wrap=True), label("", wrap=True)
        self.moved.setAccessibleName(self.tr("What moved while an instrument was silent"))
        self.serials.setAccessibleName(self.tr("Who names another serial"))
        set_state(self.serials, "warning")
        self.anew = label(
            self.tr("The simulated bench began anew: its platform is at its zero, nothing has turned."), wrap=True
        )
        self._room = NotesRoom(self.details, self.moved, apart_px=words.spacing())
        told = self.text.below, self.details, self.moved, self.serials, self._room
        for said in (self.hands, self.lab, self.stands, self.anew, *told):
            words.addWidget(said)  # the gravest first: they roll where there is no room for all
        self.entry = QLineEdit()
        self.entry.returnPressed.connect(self._enter)
        self.choose = button(self.tr("Choose a file …"), self.tr("Write the path of a file into the answer"))
        self.choose.clicked.connect(self._choose)
        answer = QHBoxLayout()
        answer.addWidget(self.entry, 1)
        answer.addWidget(self.choose)
        self._buttons = Flow(left=True)
        row = QHBoxLayout()
        row.setSpacing(2 * GRID)
        self._rolled = Rolled(words, self.hands)
        row.addWidget(self._rolled, WORDED)
        self.camera = CameraView()
        pictures = QVBoxLayout()
        for widget in (self.drawing, self.camera):
            pictures.addWidget(widget, 1)
        row.addLayout(pictures)
        self._row = row
        self.body.addLayout(row, 1)
        self.body.addLayout(answer)
        self.body.addWidget(self.hint)
        self.body.addLayout(self._buttons)
        self.choices: dict[str, QPushButton] = {}
        self.send: QPushButton | None = None  # where the answer is in words
        self.call = QTimer(self, interval=CALLS_EVERY_MS)
        self.call.timeout.connect(self._call)
        self.dead = QTimer(self, singleShot=True)
        self.dead.timeout.connect(self._let_queued_events_pass)
        self.alive, self._unseen = False, True

    def show_prompt(self, prompt: Prompt | None) -> None:
        """Ask `prompt`; the same one again changes nothing."""
        if prompt is self._prompt:
            return
        self._prompt, self._lost, self._mended, self._back = prompt, False, False, ""
        self.camera.watch(prompt is not None and MOUNTING in prompt.drawing)
        if prompt is None:
            self.call.stop()
            return
        self._call()
        self.call.start()
        self._reached_into = prompt.acts and prompt.key != "ready"
        self._show_hands()
        self.text.order(unbroken(coming(prompt, headline(prompt))))
        self.text.setToolTip(plain(in_words(asked_text(prompt))))  # the whole, with what the system says
        self._say_what_to_do()
        self.drawing.show_drawing(prompt.drawing)
        self.serials.setVisible(bool(self.serials.text()) and self._is_of_mounting())
        self._share_width()
        self.hint.setMinimumHeight(0)
        self.entry.clear()
        self.entry.setVisible(not prompt.choices)
        self.choose.setVisible(FILE in prompt.drawing)
        self.entry.setPlaceholderText(
            self.tr("Scan it, or type it") if SERIAL in prompt.drawing else self.tr("Write it here")
        )
        self._make_buttons(prompt)
        self._die()

    def _share_width(self) -> None:
        """Between words and drawing; where that is hidden Qt would keep half of the card for it."""
        pictured = any(one.isVisibleTo(self) for one in (self.drawing, self.camera))
        usual = self._row.geometry().width() * WORDED // (WORDED + PICTURED)
        crowded = self._rolled.crowded(usual)
        self._row.setStretch(1, pictured * (CROWDED if crowded else PICTURED))  # what is said of hands comes first
        self._room.fit(roomy=not crowded)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width: other lines."""
        super().resizeEvent(event)
        self._share_width()

    def _die(self) -> None:
        """Take no answer before the question has been seen for a second."""
        self.dead.stop()
        self.alive, self._unseen = False, True
        for made in self._answers():
            made.setEnabled(False)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """From now on it is seen."""
        super().paintEvent(event)
        if self._unseen and self._prompt is not None:
            self._unseen = False
            self.dead.start(DEAD_MS)

    def showEvent(self, event: QShowEvent) -> None:
        """Seen anew: nobody knows what was clicked just before."""
        super().showEvent(event)
        self._die()

    def _let_queued_events_pass(self) -> None:
        """What was clicked while the window stood still is heard first, by dead buttons."""
        QTimer.singleShot(0, self._live)

    def _live(self) -> None:
        if not self._unseen and not self.dead.isActive():
            self.alive = True
            self._let_answer()

    def _let_answer(self) -> None:
        """Alive, once it was seen for long enough, and as far as that may be answered."""
        for choice, made in self.choices.items():
            made.setEnabled(self.alive and self._may(choice))
        if self.send is not None:
            self.send.setEnabled(self.alive and self._may(""))
        self._say_how()

    def _say_how(self) -> None:
        """How it is answered; of an answer that may not be given yet, that it waits."""
        waits = self._prompt is not None and bool(self._prompt.choices) and not self._may(wanted(self._prompt))
        later = self._usual.replace(self._how, self.tr("Not yet: what it waits for stands above."))
        if self._how and self.hint.text() == (self._usual if waits else later):
            self.hint.setText(later if waits else self._usual)

    def _may(self, choice: str) -> bool:
        return self._prompt is not None and may_answer(self._prompt, choice, lost=self._lost, waits=self._waits)

    def _answers(self) -> list[QPushButton]:
        return [made for made in (*self.choices.values(), self.send) if made is not None]

    def take_focus(self) -> None:
        """Where a serial is asked it is typed without a click; a field that is not in sight yet gets no focus."""
        if self._prompt is not None and SERIAL in self._prompt.drawing:
            self.entry.setFocus()

    def say_lab(self, now: LabNow, out: str = "", heading: str = "") -> None:
        """What coils and platform do while hands may be near, as the side panel says it; `out`: they go out now.

        `heading`: what stands over every page.
        """
        seen = as_watched(now)  # one word at one moment: what lets hands in is not "not watched" below it
        coil_words, platform_words = seen.coil_words, seen.platform_words
        self.drawing.show_platform(now.platform_deg, age_words(now.platform_old_s))
        for place, words, (shape, mark) in (
            (self.lab, coil_words, mark_of(coil_words)),
            (self.stands, platform_words, platform_drawn(platform_words, coil_words)),
        ):
            place.setText(f"{shape} {in_words(words)}".strip())
            place.setVisible(bool(words))
            set_state(place, mark)
        words, mark = dated(*hands_of(now), now)
        words, mark = (out, OFF) if out and mark in MAY else (words, mark)
        self.hands.setText(words if mark in MAY else in_shape(words, heading))
        set_state(self.hands, mark)
        self._first = first_thing(now)
        self._said_once = bool(coil_words) and (in_words(coil_words) in words or mark in MAY)  # they need not follow
        self._show_hands()

    def say_kept_out(self, words: str, mark: str, *, waits: bool) -> None:
        """That hands are kept out, in place of an order that sends them in ("": none); whether its answer `waits`."""
        self.text.keep_out(words, mark)
        self._waits = waits
        self._let_answer()

    def _show_hands(self) -> None:
        known = bool(self.lab.text())
        self._share_width()
        self.hands.setVisible(known and self._reached_into)
        self.lab.setVisible(known and not (self._reached_into and self._said_once))

    def say_anew(self, *, anew: bool) -> None:
        """That where the platform stood before an interruption is forgotten: beside the first question after it."""
        self.anew.setVisible(anew and bool(self.stands.text()))

    def say_moved(self, words: str) -> None:
        """What a silence has moved, once everybody answers again; "" where there was none."""
        self.moved.setText(words)
        self.moved.setVisible(bool(words) and not self._lost)
        self._share_width()

    def say_serials(self, others: Sequence[tuple[str, str]]) -> None:
        """Who names another serial than is stated, where something is mounted or a serial is asked for."""
        self.serials.setText("\n".join(f"▲ {name} {words}" for name, words in others))
        self.serials.setVisible(bool(others) and self._is_of_mounting())

    def _is_of_mounting(self) -> bool:
        return self._prompt is not None and (MOUNTING in self._prompt.drawing or SERIAL in self._prompt.drawing)

    def say_lost(self, lost: list[str], since: Sequence[str] = ()) -> None:
        """Who does not answer, and `since` when, below every question; what energises or turns is not answered then.

        A headline that says who is lost is true no longer than that.
        """
        if self._prompt is None:
            return
        anew = lost != self._who or bool(lost) is not self._lost
        if lost != self._who:
            back, self._who = [one for one in self._who if one not in lost], list(lost)
            self._back = self.tr("{0}: answers again").format(", ".join(back)) if back else ""
        says = NO_ANSWER in self._prompt.drawing or self._prompt.text.startswith(STILL_LOST)
        says = says and self._prompt.key != READY  # there the question stays: what will move is said in it
        if says and anew and (lost or self._lost):
            again = self.tr("Every instrument answers again.")
            self.text.order(unbroken(headline(self._prompt, lost)) if lost else again)
            self._mended = not lost
        self._lost = bool(lost)
        self._let_answer()
        self._reached_into = reached_into(self._prompt, lost=self._lost)
        self._show_hands()
        self._since = list(since or lost)
        self._say_what_to_do()

    def _say_what_to_do(self) -> None:
        """Below the question: one thing after the other."""
        if self._prompt is None:
            return
        failed = WHAT in self._prompt.drawing or self._prompt.text.startswith(STILL_LOST)
        if failed and self._prompt.key != READY:
            again = translated(WORDS[RETRY])
            words = below(self._prompt, again, lost=not self._mended, first=self._first)
        else:
            seen_to = to_be_seen_to(self._since, self._first, is_ready=self._prompt.key == READY)
            words = seen_to if self._lost else self._back
        self.details.setText(words)
        self.details.setVisible(bool(words))
        self._share_width()

    def _call(self) -> None:
        """A window that was closed over a question asks nobody."""
        if self.window().isVisible():
            self.calls.emit()

    def _make_buttons(self, prompt: Prompt) -> None:
        while (old := self._buttons.takeAt(0)) is not None:
            if (widget := old.widget()) is not None:
                widget.setParent(None)  # from now on it hears no key
                widget.deleteLater()
        self.choices, self.send = {}, None
        keys = iter(KEYS)
        for choice in prompt.choices:
            key = next(keys, KEYS[-1]) if acting(prompt, choice) else None
            made = self._button(answer_label(prompt, choice), key, held=moves_by_itself(prompt, choice))
            named(made, "primary" if choice == wanted(prompt) else "")
            made.clicked.connect(lambda _=False, c=choice: self.answered.emit(c))
            self.choices[choice] = made
            self._buttons.addWidget(made)
        if not prompt.choices:
            self._make_senders(prompt)
        held = [b for b in self._answers() if isinstance(b, HoldButton)]
        by_key = self.tr("Click, or hold the key for a moment. Enter does nothing here.") if held else ""
        if any(b.held_by_mouse for b in held):
            by_key = self.tr("Hold the button, or its key, until it is full. Enter does nothing here.")
        self._how = by_key
        if "skip" in prompt.choices:
            cost = self.tr(
                "Skipped, it is missing, and this run does not come back to it; only Redo axis, where that is offered "
                "at the next mounting, turns its axis again. The verdict says so, and a calibration may lack what it "
                "would tell."
            )
            by_key = f"{by_key} {cost}".strip()
        if prompt.key == ANOTHER_DUT:
            by_key = self.tr("No: nothing is measured, and the run ends. Yes: the record says that you answered so.")
        if prompt.key == STANDS:
            by_key = f"{self._what_no_means()} {by_key}".strip()
        by_scan = self.tr("A scan answers by itself; what is typed is sent by Enter.")
        self._usual = by_scan if SERIAL in prompt.drawing else by_key
        self.hint.setText(self._usual)

    def say_kept(self, *, turn: bool, delays: str) -> None:
        """Before a question is shown: whether a turn is kept of before an interruption, and what of the delays."""
        self._keeps_a_turn, self._delays = turn, delays

    def _what_no_means(self) -> str:
        either = self.tr("Yes: it goes on as it stands. No: mount it again first.")
        if not self._keeps_a_turn:
            anew = self.tr("No turn was finished: either way it begins with the first step again.")
            return f"{either} {anew}"
        kept = self.tr(
            "Either way turns that were finished stay as they are, with their ticks: each mounting has a phase of its "
            "own in the fit. First the zero, the axes and the timing are measured again, to see whether anything moved "
            "or drifted; then only what is missing."
        )
        return f"{either} {kept} {self._delays}".strip()

    def _make_senders(self, prompt: Prompt) -> None:
        """What sends the words; where they say that something was moved, by click or held key alone."""
        self.send = self._button(translated(WORDS["send"]), KEYS[0] if prompt.acts else None)
        named(self.send, "primary").clicked.connect(self._send_text)
        self._buttons.addWidget(self.send)
        if FILE in prompt.drawing:
            self.choices[""] = button(self.tr("None"), self.tr("Go on without a file; the record says so"))
            self.choices[""].clicked.connect(lambda: self.answered.emit(""))
            self._buttons.addWidget(self.choices[""])

    def _button(self, words: str, key: Qt.Key | None, *, held: bool = False) -> QPushButton:
        if key is None:
            return button(words, self.tr("Answer: {0}").format(words))
        made = HoldButton(f"{words}   {key.name.removeprefix('Key_')}", key, held_by_mouse=held)
        how = self.tr("Hold this button, or {0}, for 0.7 s") if held else self.tr("Click, or hold {0} for 0.7 s")
        words = how.format(key.name.removeprefix("Key_"))
        made.setToolTip(words)
        made.tapped.connect(self._say_tapped)
        made.freed.connect(lambda: self.hint.setText(self._usual))
        return made

    def _say_tapped(self, words: str) -> None:
        """In the room that the hint had: the question above does not move."""
        self.hint.setMinimumHeight(self.hint.height())
        self.hint.setText(words)

    def _enter(self) -> None:
        if self._prompt is not None and (SERIAL in self._prompt.drawing or (self.alive and not self._prompt.acts)):
            self._send_text()  # a scanner that is as slow as a person ends what it reads by Enter

    def _choose(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("A file for the record"))
        if path:
            self.entry.setText(path)

    def _send_text(self) -> None:
        if self._may("") and self._prompt is not None and not self._prompt.choices and self.entry.text().strip():
            self.answered.emit(self.entry.text().strip())
