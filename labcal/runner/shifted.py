"""An item of the bench's time, in that of its run."""

from __future__ import annotations

from dataclasses import replace

from labcal.record.stream import Block, Item


def shifted(item: Item, by_s: float) -> Item:
    """The same, so much later."""
    if isinstance(item, Block):
        return replace(item, t_s=item.t_s + by_s)
    return replace(item, t_s=item.t_s + by_s)
