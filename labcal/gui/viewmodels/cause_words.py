"""A cause in plain words, its id beside it. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.study import cause_name

PLAIN = {  # of the DUT itself, which the technician looks for; {0}: its channels
    "offset-current": QT_TRANSLATE_NOOP("Words", "offset that follows the current {0}"),
    "offset-current-squared": QT_TRANSLATE_NOOP("Words", "offset that follows the square of the current {0}"),
    "offset-temperature": QT_TRANSLATE_NOOP("Words", "offset that follows the temperature {0}"),
    "offset-channel": QT_TRANSLATE_NOOP("Words", "offset that follows the channel {0}"),
    "offset-mode": QT_TRANSLATE_NOOP("Words", "offset of the power mode {0}"),
    "gain-temperature": QT_TRANSLATE_NOOP("Words", "gain that follows the temperature {0}"),
    "gain-channel": QT_TRANSLATE_NOOP("Words", "gain that follows the channel {0}"),
    "offset-drift": QT_TRANSLATE_NOOP("Words", "offset that drifts with time"),
    "offset-step": QT_TRANSLATE_NOOP("Words", "offset that steps at one moment"),
    "gain-step": QT_TRANSLATE_NOOP("Words", "gain that steps at one moment"),
    "hysteresis": QT_TRANSLATE_NOOP("Words", "magnetisation that remembers earlier fields"),
}


def in_plain_words(effect: str, channels: tuple[str, ...]) -> str:
    """What it does, then its name: "offset that follows the current i_eps: offset-current (i_eps)"."""
    name = cause_name(effect, channels)
    plain = str(PLAIN.get(effect, ""))
    if not plain or ("{0}" in plain) != bool(channels):
        return name
    return f"{translated(plain).format(', '.join(channels))} – {name}"
