"""The frame around every page: top bar with Coils off, sidebar, field and instruments at the right, one line below."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import (
    QApplication,
    QButtonGroup,
    QDialog,
    QFileDialog,
    QGridLayout,
    QHBoxLayout,
    QLineEdit,
    QMainWindow,
    QMenu,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from labcal.gui.side_panel import SidePanel
from labcal.gui.theming.theme import GRID
from labcal.gui.top_bar import TopBar
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab import LabState, LabViewModel
from labcal.gui.viewmodels.number_format import short_number, turns_written
from labcal.gui.viewmodels.path import SHAPES
from labcal.gui.viewmodels.said_for_now import SaidForNow
from labcal.gui.widgets.by_itself import ByItself, ShownPart
from labcal.gui.widgets.common import Surface, label, named, plain, set_state
from labcal.gui.widgets.dialog_place import place_below_and_left
from labcal.gui.widgets.file_columns import show_names_whole
from labcal.gui.widgets.hold_button import HOLD_MS, KEYS
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.key_sheet import KeySheet, described, shortcuts
from labcal.gui.widgets.mark_column import MarkedButton
from labcal.gui.widgets.next_button import NextButton
from labcal.gui.widgets.plot_letters import scale_plots
from labcal.gui.widgets.two_lines import TwoLines

NARROW_PX = 1200  # a window that is less wide has a narrow sidebar and side panel
NUMBERED = 9  # pages have a key of their own
OF_MESSAGE, OF_WHAT_HAPPENS = 3, 2  # shares of the line below, while something happens; else the message has it
OFF_KEY = Qt.Key.Key_F12
OF_ITS_OWN = QDialog, QMenu  # windows beside this one


def put_off_into(dialog: QDialog, coils_off: Callable[[], object]) -> None:
    """A button of its own for Coils off in whatever dialog comes up: the window's cannot be clicked meanwhile."""
    layout = dialog.layout()
    if layout is None or dialog.findChild(QPushButton, "off") is not None:
        return
    for field in dialog.findChildren(QLineEdit) if isinstance(dialog, QFileDialog) else ():
        field.setCompleter(None)  # type: ignore[arg-type]  # its list takes the first click beside it, also on Coils off
    off = named(QPushButton(translated("COILS OFF   F12")), "off")
    off.setAutoDefault(False)
    off.clicked.connect(coils_off)
    if isinstance(layout, QGridLayout):
        layout.addWidget(off, layout.rowCount(), 0, 1, -1)
    else:
        layout.addWidget(off)
    off.show()


class Frame(QMainWindow):
    """The main window: pages by name in the sidebar's order; `coils_off`: its button, or F12 with any focus."""

    coils_off = Signal()

    def __init__(self, lab: LabViewModel, pages: dict[str, QWidget], said: SaidForNow | None = None) -> None:
        super().__init__()
        self.setWindowTitle("labcal")
        self.resize(1360, 860)
        self.top, self.side, self.stack = TopBar(), SidePanel(), QStackedWidget()
        self.said_at, self.message, self.waiting = label("", "caption"), TwoLines(), label()
        line = ShownPart(self._show_line, self._blank_line)
        self._parts = ByItself(ShownPart(self.top.show_state, self.top.blank), *self.side.parts(), line)
        self.next = NextButton(self.tr("What is next for this DUT, whichever page is open (Ctrl+N)"))
        changed = self.tr("Next has just changed, and did nothing. It is now: {0}. Press it again.")
        self._said_for_now = said or SaidForNow(lab)
        self.next.too_soon.connect(lambda: self._said_for_now.say(changed.format(self.next.following)))
        self.next.clicked.connect(self._said_for_now.put_away)
        keeps = self.next.sizePolicy()
        keeps.setRetainSizeWhenHidden(True)  # the line below keeps its height: nothing above it moves
        self.next.setSizePolicy(keeps)
        self.next.hide()
        self.key_handlers: list[Callable[[QWidget, QKeyEvent], bool]] = []
        self.sidebar_buttons, self._scale = QButtonGroup(self), 1.0
        self.rail: list[MarkedButton] = []  # the same, by page
        self.says_off = True  # when it closes; else its worker finds the line closed, and takes the coils to zero
        self._names = tuple(pages)
        middle = QHBoxLayout()
        middle.setSpacing(0)
        middle.addWidget(self._sidebar(pages))
        self.above = QVBoxLayout()  # what concerns every page: faults
        self.above.setContentsMargins(2 * GRID, 0, 2 * GRID, 0)
        self.pages_column = QVBoxLayout()
        self.pages_column.setSpacing(0)
        self.pages_column.addLayout(self.above)
        self.pages_column.addWidget(self.stack, 1)
        middle.addLayout(self.pages_column, 1)
        middle.addWidget(self.side)
        page = named(QWidget(), "page")
        column = QVBoxLayout(page)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.top)
        column.addLayout(middle, 1)
        column.addWidget(self._status_line())
        self.setCentralWidget(page)
        self.top.off.clicked.connect(self.coils_off)
        self.side.unit_asked.connect(lambda unit: lab.update(unit=unit))
        lab.changed.connect(self.show_state)
        self.show_state(lab.state)
        self.set_scale(1.0)
        self.open_page(self._names[0])
        QApplication.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)  # they would have no Coils off
        application = QApplication.instance()
        if application is not None:
            application.installEventFilter(self)

    def _sidebar(self, pages: dict[str, QWidget]) -> QWidget:
        self.sidebar = sidebar = Surface(Qt.Edge.RightEdge)
        column = QVBoxLayout(sidebar)
        column.setContentsMargins(0, 2 * GRID, 0, 2 * GRID)
        column.setSpacing(0)
        for index, (name, page) in enumerate(pages.items()):
            entry = named(MarkedButton(translated(name), SHAPES.values()), "rail")
            entry.setCheckable(True)
            self.rail.append(entry)
            if index < NUMBERED:
                entry.setToolTip(self.tr("{0} (Ctrl+{1})").format(translated(name), index + 1))
                words = self.tr("the page {0}").format(translated(name))
                described(QShortcut(QKeySequence(f"Ctrl+{index + 1}"), self, entry.click), words)
            self.sidebar_buttons.addButton(entry, index)
            entry.setAccessibleName(translated(name))
            column.addWidget(entry)
            self.stack.addWidget(page)
        column.addStretch()
        self.help = named(QPushButton(self.tr("Keys   F1")), "rail")
        self.help.setToolTip(self.tr("Which keys there are, and what each does"))
        self.help.clicked.connect(self.show_keys)
        described(QShortcut(QKeySequence("F1"), self, self.show_keys), self.tr("this sheet"))
        self.theme_switch, self.size_switch = named(QPushButton(), "rail"), named(QPushButton(), "rail")
        self.theme_switch.setToolTip(self.tr("Dark or light; until then as the system has it"))
        self.size_switch.setToolTip(self.tr("Letters to be read from two metres, and back (F11)"))
        self.lock_switch = named(QPushButton(self.tr("Lock")), "rail")
        self.lock_switch.setToolTip(self.tr("Until somebody logs in; COILS OFF works all the same"))
        self.lock_switch.hide()
        self.sound_switch = named(QPushButton(), "rail")
        self.sound_switch.setToolTip(self.tr("Two tones where you are needed, three where it is done; or neither"))
        self.language_switch = named(QPushButton(), "rail")
        self.language_switch.setToolTip(self.tr("The window in this language; not while a run goes on"))
        switches = (self.lock_switch, self.language_switch, self.theme_switch, self.size_switch, self.sound_switch)
        for widget in (*switches, self.help):
            column.addWidget(widget)
        self.sidebar_buttons.idClicked.connect(self._open_at)
        return sidebar

    def _status_line(self) -> QWidget:
        """What happens and what is next begin at one place, however long the words of either are."""
        self.bottom = line = Surface(Qt.Edge.TopEdge)
        row, ahead = QHBoxLayout(line), QHBoxLayout()
        row.setContentsMargins(2 * GRID, GRID // 2, 2 * GRID, GRID // 2)
        row.setSpacing(GRID)
        row.addWidget(self.said_at)
        row.addWidget(self.message, OF_MESSAGE)
        ahead.addWidget(self.waiting, 1)
        ahead.addWidget(self.next)
        row.addLayout(ahead)
        self._line = row, ahead
        return line

    def show_path(self, marks: Mapping[str, str], why: Mapping[str, str] | None = None) -> None:
        """A mark before the name of each page that is a step of the path; `why` it is that one, by page."""
        for index, name in enumerate(self._names):
            self.rail[index].set_mark(marks.get(name, ""))
            tip = self.tr("{0} (Ctrl+{1})").format(translated(name), index + 1)
            self.rail[index].setToolTip("\n".join(filter(None, (tip, (why or {}).get(name, "")))))

    def say_next(self, following: str, about: str = "") -> None:
        """What is next, in words, for the DUT that it is `about`; what was said of another is past."""
        if following != self.next.following:
            self._said_for_now.put_away()
        self.next.say(self.tr("Next: {0}").format(following), following, about)
        self.next.show()

    def open_page(self, name: str) -> None:
        """Show the page called `name`."""
        index = self._names.index(name)
        self.sidebar_buttons.button(index).setChecked(True)
        self._open_at(index)

    def _open_at(self, index: int) -> None:
        """Who worked on the page before has the focus on the name of this one."""
        of_this_page, here = self.sidebar_buttons.button(index), QApplication.focusWidget()
        if here in self.sidebar_buttons.buttons():
            of_this_page.setFocus(Qt.FocusReason.OtherFocusReason)
        with focus_kept_in(self.stack, of_this_page):
            self.stack.setCurrentIndex(index)

    def page_shown(self) -> str:
        """The name of the page that is in sight."""
        return self._names[self.stack.currentIndex()]

    def keys(self) -> list[tuple[str, str]]:
        """Every key with what it does: those that are heard before any other, then the shortcuts that there are."""
        held, held_s = ", ".join(key.name.removeprefix("Key_") for key in KEYS), short_number(HOLD_MS / 1000)
        first = {
            OFF_KEY.name.removeprefix("Key_"): self.tr("coils off, at any moment"),
            held: self.tr("held for {0} s: the answer on the button of this key").format(held_s),
            "Tab": self.tr(
                "to the next field or button; Shift and Tab goes back, Space presses a button or picks a row, "
                "but no answer that mounts, energises or moves: its own key is held"
            ),
        }
        return list((first | shortcuts(self)).items())

    def show_keys(self) -> None:
        """The sheet with all keys; nothing waits for it."""
        sheet = KeySheet(self, self.keys())
        sheet.setStyleSheet(self.sheet())
        put_off_into(sheet, self.coils_off.emit)  # before it is measured: else the rows are short of its room
        sheet.fit_into(self.size())
        sheet.show()

    def sheet(self) -> str:
        """The style sheet of every part."""
        return ""

    def set_scale(self, scale: float) -> None:
        """Room for texts `scale` times their size."""
        self._scale = scale
        scale_plots(self, scale)
        self._give_room()

    def hold_minimum(self, held: bool) -> None:
        """Whether it is no smaller than its texts need. While these are to shrink with it, it may be any size."""
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)  # what they needed before is past
        self.setMinimumSize(*((0, 0) if held else (1, 1)))  # (0, 0): what is in it says how small

    def _give_room(self) -> None:
        """Sidebar and side panel, narrow where the window is: the page between them has what is left."""
        narrow = self.width() < NARROW_PX * self._scale
        sidebar, side, entry = (15, 25, 15) if narrow else (17, 31, 18)
        for field in (self.top.dut, self.top.operator):
            field.setMaximumWidth(int(entry * GRID * self._scale))
        self.sidebar.setFixedWidth(int(sidebar * GRID * self._scale))
        self.side.setFixedWidth(int(side * GRID * self._scale))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Another width: what was said of it is past."""
        super().resizeEvent(event)
        self._said_for_now.put_away()
        self._give_room()

    def show_state(self, state: LabState) -> None:
        """Write the lab's state into every part of the frame."""
        self._parts.show(state)

    def _show_line(self, state: LabState) -> None:
        self.said_at.setText(state.said_at)
        self.message.setText(turns_written(in_words(state.message)))
        self.message.setToolTip(plain(self.message.text()))  # the whole, where there is no room for it
        self.waiting.setText(state.waiting)
        row, ahead = self._line
        row.setStretchFactor(ahead, OF_WHAT_HAPPENS if state.waiting else 0)
        set_state(self.waiting, state.waiting_state)

    def _blank_line(self) -> None:
        for part in (self.said_at, self.message, self.waiting):
            part.setText("")

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take F12 before anything else can, whatever has the focus and whatever card is open; then `key_handlers`."""
        if isinstance(watched, OF_ITS_OWN) and event.type() == QEvent.Type.Show:
            if not watched.styleSheet():
                watched.setStyleSheet(self.sheet())  # what is styled here does not reach it
            if isinstance(watched, QDialog):
                put_off_into(watched, self.coils_off.emit)
            if isinstance(watched, QFileDialog) and (above := watched.parentWidget()) and above.window() is self:
                show_names_whole(watched)
                place_below_and_left(watched, self.top, self.side)  # whether hands may go in stands in both
        if not isinstance(event, QKeyEvent):
            return False
        if event.type() == QEvent.Type.KeyPress and event.key() == OFF_KEY:
            if not event.isAutoRepeat():
                self.coils_off.emit()
            return True
        return isinstance(watched, QWidget) and any(handle_key(watched, event) for handle_key in self.key_handlers)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Coils off before the window goes, by a word or by hanging up; a window that is gone hears no keys."""
        if self.says_off:
            self.coils_off.emit()
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self)
        super().closeEvent(event)
