"""Parts of the window in another style sheet: at once what nobody may miss, the rest bit by bit."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

from PySide6.QtWidgets import QWidget

from labcal.gui.theming.stylesheet import apply_style, styled_widgets
from labcal.gui.widgets.idle_queue import IdleQueue


def style_at_once(sheet: str, *parts: QWidget) -> None:
    """They are painted with the next frame, in the new style."""
    for part in parts:
        for one in styled_widgets(part):
            apply_style(one, sheet)


def style_bit_by_bit(
    queue: IdleQueue,
    part: QWidget,
    wanted: Iterable[QWidget],
    sheet: str,
    theme_updates: Iterable[Callable[[], object]] = (),
    *,
    seen: bool = False,
) -> None:
    """Style what is `wanted` of a part, then do `theme_updates`; it is painted once, after all that, unless `seen`."""
    part.setUpdatesEnabled(seen)
    for one in wanted:
        queue.put(one, partial(apply_style, one, sheet))
    queue.add(*theme_updates)
    queue.put(part, partial(part.setUpdatesEnabled, True))
