"""Colours, sizes and the style sheet: neutral greys, one accent, three states, one colour for each axis.

A colour has one meaning. States are green, amber and red, apart for all eyes, what may be clicked or goes on is blue;
x, y and z are magenta, cyan and violet, which eyes that see fewer colours tell from these and from each other
(tests/gui/test_theme.py works out what they see). What is drawn of a run is grey before and ink after. Every state
has a shape and a word as well. Spacing stands on an 8-pixel grid.
"""

from __future__ import annotations

from dataclasses import dataclass
from string import Template

GRID = 8
ITEM_PX = 6  # of an item of a list, between its edge and its words
TEXT, SMALL, LARGE = 10.5, 9.0, 22.0  # points: body, captions, what is read from across the room
WALL_SCALE = 1.8
WHOLE_PX = (1024, 600)  # a window of this size has room for its texts in their size


def text_scale(width: int, height: int, *, wall: bool) -> float:
    """How large texts are; those read from two metres (`wall`) in tenths: in a window so large none is cut."""
    if not wall:
        return 1.0
    room = min(width / WHOLE_PX[0], height / WHOLE_PX[1])
    return min(WALL_SCALE, max(1.0, int(10 * room) / 10))


@dataclass(frozen=True, slots=True)
class Theme:
    """One set of colours, as #rrggbb."""

    name: str
    page: str  # behind everything
    surface: str  # cards, panels
    sunken: str  # entry fields
    line: str
    text: str
    muted: str
    accent: str
    on_accent: str
    good: str
    warning: str
    bad: str
    axis_x: str
    axis_y: str
    axis_z: str

    @property
    def axes(self) -> tuple[str, str, str]:
        """The colours of x, y and z, the same in every plot and table."""
        return self.axis_x, self.axis_y, self.axis_z

    @property
    def before(self) -> str:
        """What is drawn as read, as calibrated without a cause, or of the earlier of two runs."""
        return self.muted

    @property
    def after(self) -> str:
        """What is drawn as calibrated, with a cause, or of the later of two runs."""
        return self.text


LIGHT = Theme(
    name="light",
    page="#f3f4f5",
    surface="#ffffff",
    sunken="#f7f8f9",
    line="#d5d9dd",
    text="#1c2126",
    muted="#57606a",
    accent="#0b5cad",
    on_accent="#ffffff",
    good="#00694b",
    warning="#966000",
    bad="#ae0c1a",
    axis_x="#a8106e",
    axis_y="#00778f",
    axis_z="#6f3ad6",
)
DARK = Theme(
    name="dark",
    page="#16191c",
    surface="#1f2327",
    sunken="#181b1e",
    line="#363c42",
    text="#e8eaed",
    muted="#a2abb4",
    accent="#6cb4f0",
    on_accent="#0d1a26",
    good="#37c89b",
    warning="#f0c128",
    bad="#ff6848",
    axis_x="#ff4db8",
    axis_y="#a6f0ff",
    axis_z="#b070ff",
)

HANDS = {"good": "good", "alone": "warning", "off": "bad", "bad": "bad"}  # may go in by two witnesses, by one, may not
STATES = {"PASS": ("✓", "good"), "MARGINAL": ("▲", "warning"), "FAIL": ("✕", "bad"), "CANNOT DECIDE": ("?", "warning")}

_SHEET = Template(
    """
* { font-size: ${text_pt}pt; color: $text; }
QLabel { background: transparent; }
QLabel#title { font-size: ${title_pt}pt; font-weight: 600; }
QLabel#caption { font-size: ${small_pt}pt; color: $muted; }
QLabel#large { font-size: ${large_pt}pt; font-weight: 600; }
QLabel#simulated { background: transparent; color: $warning; border: 2px solid $warning; font-weight: 700;
                   padding: 4px 6px; border-radius: 4px; letter-spacing: 1px; }
QLabel#keep_off { font-weight: 700; }
QLabel[state="good"] { color: $good; } QLabel[state="warning"] { color: $warning; } QLabel[state="bad"] { color: $bad; }
QLabel[state="alone"] { color: $alone; } QLabel[state="off"] { color: $off; }
QLabel[state="old"] { color: $muted; } QLabel#caption[state="bad"] { color: $bad; }
QLabel#caption[state="good"] { color: $good; } QLabel#caption[state="warning"] { color: $warning; }
QLabel#caption[state="off"] { color: $off; }
QLabel#caption[state="now"] { color: $accent; font-weight: 600; }
QPushButton { background: $surface; border: 1px solid $line; border-radius: 4px; padding: 7px 16px; }
QPushButton:hover { border-color: $accent; } QPushButton:focus { border: 2px solid $accent; padding: 6px 15px; }
QPushButton:disabled { color: $muted; background: $page; }
QPushButton#primary { background: $accent; color: $on_accent; border-color: $accent; font-weight: 600; }
QPushButton#primary:focus { border: 2px solid $text; }
QPushButton#primary:disabled { background: $line; color: $muted; border-color: $line; }
QPushButton#small { padding: 2px 8px; } QPushButton#small:focus { border: 2px solid $accent; padding: 1px 7px; }
QPushButton#off { background: $bad; color: $surface; border: 0; font-weight: 700; padding: 12px 14px; }
QPushButton#off:focus { border: 3px solid $text; padding: 9px 11px; }
QPushButton#rail { text-align: left; border: 0; border-radius: 0; padding: 10px 12px; }
QPushButton#rail:checked { background: $page; border-left: 4px solid $accent; padding-left: 8px; }
QPushButton#rail:disabled { background: $surface; }
QPushButton#rail:focus { border: 2px solid $accent; padding: 8px 10px; }
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QPlainTextEdit, QTextEdit { background: $sunken;
    border: 1px solid $line; border-radius: 4px; padding: 5px 8px;
    selection-background-color: $accent; selection-color: $on_accent; }
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border: 2px solid $accent; padding: 4px 7px; }
QLineEdit[state="bad"] { border: 2px solid $bad; padding: 4px 7px; }
QComboBox { combobox-popup: 0; } QComboBox QAbstractItemView::item { padding: 5px 8px; }
QDialog { background: $surface; border: 2px solid $muted; }
QToolButton { background: $surface; border: 1px solid $line; border-radius: 4px; padding: 4px; }
QToolButton:hover, QToolButton:focus { border-color: $accent; }
QMenu { background: $surface; border: 1px solid $line; padding: 4px; }
QMenu::item { padding: 6px 16px; border-radius: 4px; } QMenu::item:selected { background: $accent; color: $on_accent; }
QComboBox QAbstractItemView { background: $surface; border: 1px solid $line; selection-background-color: $accent;
    selection-color: $on_accent; }
QTableView, QListView, QTreeView { background: $surface; border: 1px solid $line; padding: 1px; gridline-color: $line;
    alternate-background-color: $sunken; selection-background-color: $accent; selection-color: $on_accent; }
QHeaderView::section { background: $page; color: $muted; border: 0; border-bottom: 1px solid $line; padding: 6px 11px; }
QProgressBar { background: $sunken; border: 1px solid $line; border-radius: 4px; height: 14px; text-align: center; }
QProgressBar::chunk { background: $accent; border-radius: 3px; }
QToolTip { background: $surface; color: $text; border: 1px solid $line; padding: 4px; }
QListWidget { outline: 0; } QListWidget::item { padding: 4px ${item_px}px; border-radius: 4px; }
QListWidget::item:selected { background: $accent; color: $on_accent; }
QTableView:focus, QListView:focus { border: 2px solid $accent; padding: 0; }
QTableView { outline: 0; } QTableView::item { padding: 0 8px; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: $line; border-radius: 5px; min-height: 24px; min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QComboBox::drop-down { border: 0; width: 24px; }
QComboBox::down-arrow { image: none; width: 0; height: 0;
    border-left: 5px solid $sunken; border-right: 5px solid $sunken; border-top: 6px solid $muted; }
QTabBar { background: transparent; }
QTabBar::tab { background: transparent; color: $muted; border: 0; border-bottom: 2px solid $line; padding: 6px 14px; }
QTabBar::tab:selected { color: $text; border-bottom-color: $accent; font-weight: 600; }
QTabBar::tab:hover { color: $text; } QTabBar:focus { border: 2px solid $accent; border-radius: 4px; }
QLabel#ask { font-size: ${ask_pt}pt; font-weight: 600; }
QLabel#huge { font-size: ${huge_pt}pt; font-weight: 600; }
QPlainTextEdit:focus { border: 2px solid $accent; padding: 4px 7px; }
QPlainTextEdit#story { background: transparent; border: 2px solid transparent; padding: 0; }
QPlainTextEdit#story:focus { border: 2px solid $accent; }
QCheckBox { border: 2px solid transparent; border-radius: 4px; padding: 2px; spacing: 0; }
QCheckBox::indicator { width: 0; height: 0; border: 0; }
QCheckBox:focus { border: 2px solid $accent; }
"""
)


def style_sheet(theme: Theme, scale: float = 1.0) -> str:
    """The application's style sheet for `theme`, with all texts `scale` times their size."""
    colours = {name: getattr(theme, name) for name in Theme.__dataclass_fields__}
    sizes = {
        "item_px": str(ITEM_PX),
        "text_pt": f"{TEXT * scale:.1f}",
        "small_pt": f"{SMALL * scale:.1f}",
        "title_pt": f"{TEXT * 1.35 * scale:.1f}",
        "ask_pt": f"{TEXT * 1.7 * scale:.1f}",
        "huge_pt": f"{LARGE * 1.6 * scale:.1f}",
        "large_pt": f"{LARGE * scale:.1f}",
    }
    return _SHEET.substitute(colours | {state: state_ink(theme, state) for state in HANDS} | sizes)


def state_ink(theme: Theme, state: str) -> str:
    """The colour of `theme` that goes with a state, of hands or any other; "" is ink."""
    return str(getattr(theme, HANDS.get(state, state) or "text"))


def contrast(a: str, b: str) -> float:
    """Contrast ratio of two colours by WCAG 2.1, from 1 to 21."""
    brighter, darker = sorted((_luminance(a), _luminance(b)), reverse=True)
    return (brighter + 0.05) / (darker + 0.05)


def _luminance(colour: str) -> float:
    channels = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    linear = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels)
    return sum(weight * c for weight, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))
