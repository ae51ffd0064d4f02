"""What each effect says of itself in plain words, as `Family.phrase` has it."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

PHRASES = (
    QT_TRANSLATE_NOOP("Data", "the rotation axis is not where it was declared"),
    QT_TRANSLATE_NOOP("Data", "something at the cage or the table adds a field"),
    QT_TRANSLATE_NOOP("Data", "the reading along one axis changes with the field across it"),
    QT_TRANSLATE_NOOP("Data", "the reference sees the DUT's own magnetism"),
    QT_TRANSLATE_NOOP("Data", "the offset follows what was recorded, for no known cause"),
    QT_TRANSLATE_NOOP("Data", "the platform reads its angle wrong"),
    QT_TRANSLATE_NOOP("Data", "the DUT is off the cage's centre"),
    QT_TRANSLATE_NOOP("Data", "the gain changes with a recorded channel"),
    QT_TRANSLATE_NOOP("Data", "the gain jumps at one moment"),
    QT_TRANSLATE_NOOP("Data", "the gain changes with temperature"),
    QT_TRANSLATE_NOOP("Data", "magnetic parts remember earlier fields"),
    QT_TRANSLATE_NOOP("Data", "the readings come later than the field"),
    QT_TRANSLATE_NOOP("Data", "the reading is not proportional to the field"),
    QT_TRANSLATE_NOOP("Data", "the offset changes with a recorded channel"),
    QT_TRANSLATE_NOOP("Data", "the offset changes with a current"),
    QT_TRANSLATE_NOOP("Data", "the offset changes with the square of a current"),
    QT_TRANSLATE_NOOP("Data", "the offset drifts with time"),
    QT_TRANSLATE_NOOP("Data", "the offset differs between power modes"),
    QT_TRANSLATE_NOOP("Data", "the offset jumps at one moment"),
    QT_TRANSLATE_NOOP("Data", "the offset changes with temperature"),
    QT_TRANSLATE_NOOP("Data", "a periodic disturbance lies on the readings"),
    QT_TRANSLATE_NOOP("Data", "the reference drifts with time"),
    QT_TRANSLATE_NOOP("Data", "the reference changes with temperature"),
    QT_TRANSLATE_NOOP("Data", "single readings lie far off"),
    QT_TRANSLATE_NOOP("Data", "readings are at the end of their range"),
)
