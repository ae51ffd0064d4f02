"""What a run has sent to its window so far, for the next one: all but the samples whole, of those a thinned part."""

from __future__ import annotations

from labcal.bench.coils.state import LabState
from labcal.gui.ipc.messages import Done, Event, Failed, GoesOn, Recorded, StateRead
from labcal.record.stream import Block, Item, Prompt
from labcal.record.stream import Event as Told

ROWS = 60_000  # of samples; then every second block goes
AT_ONCE = 200  # items of one message


class PastMessages:
    """`keep` takes every message as it is said; `events` are those that bring a new window up to now."""

    def __init__(self, going: GoesOn) -> None:
        self._going = going
        self._items: list[Item] = []
        self._rows = 0
        self.state: LabState | None = None
        self._end: Done | Failed | None = None

    def keep(self, event: Event) -> None:
        """Remember what was said."""
        if isinstance(event, Recorded):
            for item in event.items:
                self._take(item)
        elif isinstance(event, StateRead):
            self.state = event.state
        elif isinstance(event, Done | Failed):
            self._end = event

    def events(self) -> list[Event]:
        """What the run is, how the lab is (coils first), what it recorded, and how it ended where it has."""
        parts = [tuple(self._items[n : n + AT_ONCE]) for n in range(0, len(self._items), AT_ONCE)]
        state = [] if self.state is None else [StateRead(self.state)]
        end = [] if self._end is None else [self._end]
        return [self._going, *state, *map(Recorded, parts), *end]

    def _take(self, item: Item) -> None:
        if isinstance(item, Told) and item.kind == "answer":  # who comes back is not asked again
            self._items = [one for one in self._items if not (isinstance(one, Prompt) and _key(item) == one.key)]
        self._items.append(item)
        if isinstance(item, Block):
            self._rows += len(item)
            if self._rows > ROWS:
                self._thin()

    def _thin(self) -> None:
        blocks = [one for one in self._items if isinstance(one, Block)]
        gone = {id(one) for one in blocks[::2]}
        self._items = [one for one in self._items if id(one) not in gone]
        self._rows = sum(len(one) for one in blocks[1::2])


def _key(answer: Told) -> object:
    return answer.data.get("key")
