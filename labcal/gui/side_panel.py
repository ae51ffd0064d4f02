"""At the right of every page: whether hands may go in, then the coils, the field, the platform and who answers."""

from __future__ import annotations

from math import hypot

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QVBoxLayout, QWidget

from labcal.bench.coils.state import ON
from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.guardian import GUARDIAN, guardian_is
from labcal.gui.viewmodels.hands_now import MAY, read_words
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.lab_now import (
    LIGHT_SHAPES,
    PLACES,
    LabNow,
    age_words,
    field_age,
    mark_of,
    platform_drawn,
    shown_name,
)
from labcal.gui.viewmodels.number_format import format_field, format_number
from labcal.gui.viewmodels.watched import as_watched
from labcal.gui.widgets.by_itself import ShownPart, cannot_be_shown
from labcal.gui.widgets.common import (
    ReadoutGrid,
    Surface,
    WholeWords,
    button,
    label,
    named,
    plain,
    set_state,
    tabular_font,
)
from labcal.gui.widgets.few_lines import MOST_LINES, lines, said_shorter
from labcal.gui.widgets.flow import Flow
from labcal.gui.widgets.mark_column import MarkLabel
from labcal.gui.widgets.rolled_column import RolledColumn

UNITS = ("nT", "µT", "mG")
MARGIN = 2 * GRID  # at both sides; at the right the bar of what rolls stands in it
SET, MEASURED, U, AXES = 0, 1, 2, 3  # rows of the field


class PanelGroup(QWidget):
    """A title with what holds for all its rows at the right: how old they are."""

    def __init__(self, title: str, *beside: QWidget) -> None:
        super().__init__()
        self.age, self.body = label("", "caption", wrap=True), QVBoxLayout(self)
        self.age.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.age.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.body.setContentsMargins(0, 0, 0, 0)
        self.body.setSpacing(GRID // 2)
        self.body.addLayout(Flow(label(title, "caption"), *beside, self.age))  # below, where there is no room beside

    def add(self, *rows: QWidget) -> PanelGroup:
        """Below what is there."""
        for row in rows:
            self.body.addWidget(row)
        return self


class InstrumentRow(QWidget):
    """Who, with its mark before it; how old that is at the right, and what is wrong in whole words behind the name."""

    def __init__(self) -> None:
        super().__init__()
        self.mark, self.name = MarkLabel(shape for shape, *_ in LIGHT_SHAPES.values()), WholeWords()
        self.age, self.back = label("", "caption", wrap=True), label("", "caption", wrap=True)
        row, said = QHBoxLayout(self), QVBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GRID // 2)
        row.addWidget(self.mark, 0, Qt.AlignmentFlag.AlignTop)
        self.name.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.name.setAlignment(Qt.AlignmentFlag.AlignTop)
        said.addLayout(Flow(self.name, self.age))  # the age below, where there is no room for it
        said.addWidget(self.back)  # never beside: it would be wider than the column
        said.setSpacing(0)
        row.addLayout(said, 1)

    def show_light(self, shape: str, colour: str, name: str, words: str, *, aged: bool, alone: bool, back: str) -> None:
        """`aged`: its `words` are its age, said here where it stands `alone` with that; `back`: it was out meanwhile.

        Who answers has its mark alone: what is wrong, or not of now, stands out.
        """
        self.mark.setText(shape)
        for place, what in ((self.age, words if aged and alone else ""), (self.back, back)):
            place.setText(what)
            place.setVisible(bool(what))
        self.back.setToolTip(back)
        self.name.say(f"{shape} {name}  {words}".strip(), name if aged else f"{name}  {words}".strip())
        set_state(self.mark, colour)
        set_state(self.name, "" if colour == "good" else colour)


class SidePanel(Surface):
    """Hands, coils, field, platform, instruments: a group each, on one grid."""

    unit_asked = Signal(str)

    def __init__(self) -> None:
        super().__init__(Qt.Edge.LeftEdge)
        self._why, self._coils_again = "", True  # what of the hands is shown, and whether that speaks of the coils
        self._may = False  # whether it is a yes
        column = QVBoxLayout(self)
        column.setContentsMargins(MARGIN, 3 * GRID // 2, 0, GRID)
        column.setSpacing(3 * GRID // 2)
        self.unit = named(QPushButton("nT"), "small")
        self.unit.setToolTip(self.tr("Change the unit of what is shown: nT, µT, mG. Entry fields keep theirs."))
        self.unit.clicked.connect(self._next_unit)
        self.read_all = button(
            self.tr("Read all"),
            self.tr("Read every instrument now: currents, field, angle, who answers. Nothing is set or moved."),
        )
        self.read_all.setObjectName("small")
        self.coils_on, self.angle = label("", "caption"), label()
        self.angle.setFont(tabular_font())
        self.coils, self.field = (
            ReadoutGrid(("x", "y", "z")),
            ReadoutGrid(("set", "measured", "U (k=2)", "x", "y", "z")),
        )
        coils = PanelGroup(self.tr("COILS   A"), self.coils_on).add(self.coils)
        field = PanelGroup(self.tr("FIELD"), self.unit).add(self.field)
        self.platform = WholeWords()
        self.platform_group, stands = PanelGroup(self.tr("PLATFORM")), QHBoxLayout()
        stands.addWidget(self.platform, 1)
        stands.addWidget(self.angle)
        self.platform_group.body.addLayout(stands)
        self.coils_age, self.field_age = coils.age, field.age
        coils.body.setContentsMargins(0, 0, MARGIN, 0)
        column.addWidget(self._hands())
        column.addWidget(coils)
        self._rolled, self._lost = self._rolling(field, self.platform_group), frozenset[str]()
        column.addWidget(self._rolled, 1)
        self.rows: list[InstrumentRow] = []

    @property
    def instrument_rows(self) -> list[QLabel]:
        """What is said of each instrument; those not in sight are of a bench before."""
        return [row.name for row in self.rows if not row.isHidden()]

    def _hands(self) -> QWidget:
        """The largest words of this panel, and below them why."""
        self.keep_off = label("", "ask", wrap=True)
        self.keep_off.setAccessibleName(self.tr("Whether hands have to be off"))
        self.may_go_in, self.hands, self.zero_words = label("", "title", wrap=True), WholeWords(), WholeWords()
        self.hands_age = label("", "caption")  # a line of its own: another age moves nothing
        self.hands_age.setFont(tabular_font())
        set_state(self.hands_age, "old")
        self.hands_group = QWidget()
        column = QVBoxLayout(self.hands_group)
        column.setContentsMargins(0, 0, MARGIN, 0)
        column.setSpacing(GRID // 2)
        for said in (self.keep_off, self.may_go_in, self.hands_age, self.hands, self.zero_words):
            column.addWidget(said)
        return self.hands_group

    def _rolling(self, *groups: QWidget) -> RolledColumn:
        """These and who answers. In a low window they roll, so that what is said of hands and coils is always whole."""
        self.legend = label("", "caption", wrap=True)
        title = label(self.tr("INSTRUMENTS"), "caption")
        title.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._lights = QVBoxLayout()
        self._lights.setSpacing(GRID // 2)
        column = QVBoxLayout()
        column.setSpacing(GRID // 2)
        for group in groups:
            column.addWidget(group)
            column.addSpacing(GRID)
        column.addLayout(Flow(title, self.read_all))  # above what may be longer than the room
        column.addWidget(self.legend)
        column.addLayout(self._lights)
        column.addStretch()
        return RolledColumn(column, MARGIN)

    def _next_unit(self) -> None:
        self.unit_asked.emit(UNITS[(UNITS.index(self.unit.text()) + 1) % len(UNITS)])

    def parts(self) -> tuple[ShownPart, ...]:
        """Hands, coils, field, platform and lights, each to be shown by itself."""
        return (
            ShownPart(lambda state: self._show_coils(state.now), self._blank_coils),
            ShownPart(self._show_hands, self._blank_hands),
            ShownPart(self._show_field, self._blank_field),
            ShownPart(self._show_platform, self._blank_platform),
            ShownPart(self._show_lights, self._blank_lights),
        )

    def _show_coils(self, now: LabNow) -> None:
        old = "" if now.coil_old_s is None else "old"
        self.coils_age.setText(age_words(now.coil_old_s))
        for row, current in enumerate(now.coil_A):  # x, y, z
            self.coils.show_row(row, "–" if current is None else format_number(current, PLACES), state=old)
        words = as_watched(now).coil_words  # what was read so short ago is watched: of how old it is the rows speak
        shape, mark = mark_of(words, at_rest=now.at_rest)
        on = self.tr("on")
        self.coils_on.setText(f"{shape} {on}" if words.startswith(ON) else "")
        set_state(self.coils_on, mark)
        whole = f"{shape} {in_words(words)}".strip()
        self.zero_words.say(whole, whole)
        set_state(self.zero_words, mark)

    def _show_hands(self, state: LabState) -> None:
        """Yes or no, and why, once: what the sentence on hands or the currents say of the coils is not said again."""
        off, off_mark = state.keep_off
        self.keep_off.setText(off)
        set_state(self.keep_off, off_mark)
        self.keep_off.setVisible(bool(off))
        coils = as_watched(state.now).coil_words
        said, mark = state.hands
        self._may = mark in MAY and not off
        answer, _, why = said.partition(":")
        self.may_go_in.setText(answer.strip() if why else said)
        self.may_go_in.setVisible(bool(said) and not off)
        age = read_words(state.now, mark) if self._may else ""
        self.hands_age.setText(age)
        self.hands_age.setVisible(bool(age))
        self._why = why.strip() if why else "" if not off else said
        self.hands.say(said, self._why)
        self.hands.setVisible(bool(said))
        for place in (self.may_go_in, self.hands):
            set_state(place, mark)
        again = mark in MAY or in_words(coils) in why or coils.startswith(ON)
        again = again or (off_mark == "bad" and mark_of(coils)[1] in ("", "good"))  # what calms stands below no alarm
        self._coils_again = again or not coils
        self.hands_group.setVisible(bool(off or said or (coils and not again)))
        self._in_few_lines()
        self._place_hands()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """In another width there is room for other words."""
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            QTimer.singleShot(0, self, self._in_few_lines)  # now it would hold a window large that is being made small

    def _in_few_lines(self) -> None:
        """The longest form for which there is room; the whole stands in the tip."""
        both = self.hands, self.zero_words
        width = self.width() - 2 * MARGIN
        largest = self.keep_off, self.may_go_in, self.hands_age
        above = sum(lines(one, one.text(), width) for one in largest if not one.isHidden())
        told = "" if self._coils_again else self.zero_words.text()
        for forms in said_shorter(self._why, told, may=self._may):  # the last one that comes has to do
            if above + sum(lines(one, form, width) for one, form in zip(both, forms, strict=True)) <= MOST_LINES:
                break
        for one, form, whole in zip(both, forms, (self._why, told), strict=True):
            one.say(one.text(), form)
            one.setToolTip("" if form == whole else plain(one.text()))
        self.zero_words.setVisible(bool(forms[1]))

    def _place_hands(self) -> None:
        """At once: in a frame before Qt lays it out, other words would be cut in the middle of a line."""
        for part in (self.hands_group, self):
            if (layout := part.layout()) is not None and self.isVisible():
                layout.activate()

    def _blank_coils(self) -> None:
        self.coils.blank()
        self.coils_age.setText(cannot_be_shown())
        self.coils_on.setText("")
        self.zero_words.say("", "")

    def _blank_hands(self) -> None:
        self.keep_off.setText(f"▲ {cannot_be_shown()}")
        set_state(self.keep_off, "bad")
        self._why, self._coils_again = "", True
        self.keep_off.show()
        self.hands_group.show()
        for said in (self.may_go_in, self.hands_age, self.hands, self.zero_words):
            said.hide()

    def _blank_field(self) -> None:
        self.field.blank()
        self.field_age.setText(cannot_be_shown())

    def _blank_platform(self) -> None:
        self.platform.say(cannot_be_shown(), cannot_be_shown())
        set_state(self.platform, "bad")
        self.platform_group.age.setText("")
        self.angle.setText("")

    def _blank_lights(self) -> None:
        self.legend.setText(cannot_be_shown())
        set_state(self.legend, "bad")
        self.legend.show()
        for row in self.rows:
            row.hide()

    def _show_field(self, state: LabState) -> None:
        def size(vector: tuple[float, float, float] | None) -> str:
            return "–" if vector is None else format_field(hypot(*vector), state.unit, signed=False)

        now = state.now
        self.unit.setText(state.unit)
        set_old, old = ("old" if one else "" for one in (age_words(now.coil_old_s), field_age(now)))
        self.field_age.setText(field_age(now))
        self.field.show_row(SET, size(now.field_set_nT), state=set_old)
        self.field.keep_row(SET, shown=now.driven or now.field_set_nT is not None)  # in a run nothing moves up and down
        self.field.show_row(MEASURED, size(now.field_measured_nT), state=old)
        u = "–" if state.field_U_nT is None else "±" + format_field(state.field_U_nT, state.unit, signed=False)
        self.field.show_row(U, u, state=old)
        for row, axis in enumerate(now.field_measured_nT or (None,) * 3):
            self.field.show_row(AXES + row, "–" if axis is None else format_field(axis, state.unit), state=old)

    def _show_platform(self, state: LabState) -> None:
        """That it stands or turns in two words, with its angle; what is not so plain in the whole sentence."""
        now = state.now
        anew = self.tr("simulated: began anew at its zero") if state.simulated and state.platform_anew else ""
        shape, mark = platform_drawn(now.platform_words, now.coil_words)
        whole = f"{shape} {in_words(now.platform_words)}".strip()
        plainly = {"platform stands": self.tr("stands"), "platform turns": self.tr("turns")}
        short = (
            plainly.get(" ".join(now.platform_words.partition(",")[0].split()[:2]))
            if now.platform_deg is not None
            else None
        )
        self.platform.say(whole, f"{shape} {short}" if short else whole)
        set_state(self.platform, mark)
        self.platform_group.setVisible(bool(whole))
        age = age_words(now.platform_old_s) if short else ""
        self.platform_group.age.setText(", ".join(filter(None, (age, "" if now.driven else anew))))
        self.angle.setText(f"{now.platform_deg:.0f}°" if short else "")
        set_state(self.angle, "old" if mark == "old" else "")

    def _show_lights(self, state: LabState) -> None:
        while len(self.rows) < len(state.now.lights):
            self.rows.append(InstrumentRow())
            self._lights.addWidget(self.rows[-1])
        self.read_all.setEnabled(bool(state.bench) and not state.reading)  # in a run it says why it does not
        others, back = dict(state.other_serials), dict(state.back)
        of_all = self._of_all(state)
        none_open = self.tr("The bench is being opened …") if state.opening else self.tr("No bench is open.")
        self.legend.setText(state.now.in_common or of_all if state.bench else none_open)
        self.legend.setVisible(bool(self.legend.text()))
        set_state(self.legend, "bad" if state.now.in_common else "")
        for row, (name, light, words) in zip(self.rows, state.now.lights, strict=False):
            shape, colour, plain = LIGHT_SHAPES[light]
            aged = light != "fault"
            words = words or (translated(plain) if aged else "")
            if light != "fault" and name in others:
                shape, colour, words, aged = "▲", "warning", others[name], False
            alone = (not of_all or name == GUARDIAN) and light != "ok"
            row.show_light(shape, colour, shown_name(name), words, aged=aged, alone=alone, back=back.get(name, ""))
            row.name.setToolTip(guardian_is(name))
            row.show()
        for row in self.rows[len(state.now.lights) :]:
            row.hide()
        self._bring_lost(state.now)

    def _bring_lost(self, now: LabNow) -> None:
        """Who begins not to answer comes into sight in a low window; with the last of them it is as it was."""
        lost = frozenset(name for name, light, _ in now.lights if light == "fault")
        if lost != self._lost:
            begins, self._lost = lost - self._lost, lost
            rows = [row for row, (name, *_) in zip(self.rows, now.lights, strict=False) if name in begins]
            if rows or not lost:
                QTimer.singleShot(0, self, lambda: self._roll_to(rows))  # once it has its lines

    def _roll_to(self, rows: list[InstrumentRow]) -> None:
        if not rows:
            return self._rolled.verticalScrollBar().setValue(0)
        for row in reversed(rows):  # the first of them is seen in any case
            self._rolled.ensureWidgetVisible(row, 0, GRID)
        return None

    def _of_all(self, state: LabState) -> str:
        """What holds for every instrument is said once, above them."""
        lights = {(light, words) for name, light, words in state.now.lights if name != GUARDIAN}
        if len(lights) != 1 or state.other_serials:
            return ""
        ((light, words),) = lights
        if light == "fault":
            return ""
        return self.tr("all answer") if light == "ok" else words or translated(LIGHT_SHAPES[light][2])
