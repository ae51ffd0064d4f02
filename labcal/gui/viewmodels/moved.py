"""What moved while an instrument was silent, as the run says it: it stands until the next turn is recorded."""

from __future__ import annotations

from datetime import datetime

from labcal.gui.translations.sentences import in_words
from labcal.record.stream import MEANWHILE, Event, Item, SegmentOpened


class Moved:
    """`words` are those of the last silence, "" where none was since a turn was recorded."""

    def __init__(self) -> None:
        self._said: Event | None = None

    def see(self, item: Item) -> None:
        """Whatever the run says."""
        if isinstance(item, Event) and item.kind == MEANWHILE:
            self._said = item
        elif isinstance(item, SegmentOpened):
            self._said = None

    def words(self, *, by_the_wall: bool) -> str:
        """In the window's language; with the time that it was looked at, where the bench goes `by_the_wall`."""
        if self._said is None:
            return ""
        utc = self._said.data.get("utc") if by_the_wall else None
        at = f"{datetime.fromisoformat(str(utc)).astimezone():%H:%M:%S}: " if utc else ""
        return f"{at}{in_words(self._said.text)}"
