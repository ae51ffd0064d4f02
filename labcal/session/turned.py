"""Where the field was in the DUT's axes in the turns that a run has recorded, for whoever goes on with it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.record.stream import NOT_USED, Block, Event, SegmentClosed, SegmentOpened
from labcal.record.turned import TurnBefore
from labcal.store import Store

MOST = 400  # readings of a segment


def turned(run_id: str) -> tuple[TurnBefore, ...]:
    """Of a run in the local store, as it was recorded last; nothing of what is not used, or was broken off."""
    found, going, rows = dict[str, NDArray[np.float64]](), "", list[NDArray[np.float64]]()
    with Store.open() as store:
        nominal = store.header(run_id).dut.nominal_nT_per_unit
        for item in store.items(run_id, raw=False):
            if isinstance(item, SegmentOpened):
                going, rows = item.segment.id, []
            elif isinstance(item, Block) and item.stream == "dut" and going:
                rows.append(item.values)
            elif isinstance(item, SegmentClosed) and rows:
                found[going], going = nominal * np.concatenate(rows), ""
            elif isinstance(item, Event) and item.kind == NOT_USED:
                found = {name: field for name, field in found.items() if name not in item.data["segments"]}
    return tuple(TurnBefore(name, field[:: -(-len(field) // MOST)]) for name, field in found.items())
