"""What goes between the window and its workers: one JSON object a line; items of the timeline in compact form.

The store, which knows the form, is imported with the first item: the window is up before it is needed.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.coils.state import NOT_BY_REFERENCE, NOT_CONFIRMED
from labcal.bench.named_links import named_links
from labcal.errors import (
    InputError,
    InstrumentError,
    LimitError,
    LimitNotMet,
    OutOfControl,
    Stopped,
    words_of_system,
)
from labcal.record.stream import Item
from labcal.runner.control import Later, Left

OWN_MISTAKE = "labcal itself made a mistake here; the details hold what it says of it."
BROKEN = ("crash", "ended", "off")  # kinds of fault after which nobody knows what the work left behind
IN_DOUBT = (NOT_BY_REFERENCE, NOT_CONFIRMED)  # so begins what is said of a zero that nobody may energise over
MENDED_FIRST = ("instrument", "record", "guardian", "zero")  # kinds over which a run is interrupted, not failed
NO_INSTRUMENT = {  # faults of the bench that are none of an instrument's, by their names
    "disk full": "record",
    "store slow": "record",
    "store locked": "record",
    "store gone": "record",
    "store failed": "record",
    "guardian lost": "guardian",
    "guardian failed": "guardian",
    "clock set back": "clock",
}


def item_to_json(item: Item) -> list[Any]:
    """An item as the store writes it, samples in base64; the raw frames stay behind."""
    from labcal.store.items import to_row

    row = to_row(item)
    return [row.kind, row.t_s, row.content, *(b64encode(part or b"").decode() for part in (row.stamps, row.samples))]


def item_from_json(said: list[Any]) -> Item:
    """The item that `item_to_json` wrote."""
    from labcal.store.items import ItemRow, from_row

    kind, t_s, content, stamps, samples = said
    return from_row(ItemRow(kind, t_s, content, b64decode(stamps), b64decode(samples)))


@dataclass(frozen=True, slots=True)
class Fault:
    """What went wrong, for a card.

    `kind` is input, standard (check standard out of control), instrument, record (which is not kept), guardian, clock,
    zero (in doubt: nothing is energised over it),
    coils (that may be on), platform (that may turn), limit, stopped, left (by whoever ran it), page, crash or ended
    (its process).
    """

    kind: str
    text: str
    remedy: str = ""
    details: str = ""
    mends: str = ""  # what only who mends labcal can do: behind the fold


def fault_of(error: BaseException, details: str = "") -> Fault:
    """The fault that an exception of labcal's (or any other) stands for."""
    if isinstance(error, InstrumentError):
        kind = "input" if isinstance(error, LimitError) else NO_INSTRUMENT.get(error.fault, "instrument")
        kind = "zero" if error.what.startswith(IN_DOUBT) else kind
        return Fault(kind, error.what, error.remedy, details, error.mends)
    if isinstance(error, OutOfControl):
        return Fault("standard", error.words, error.remedy, details or str(error))
    kinds: tuple[tuple[type[BaseException], str], ...] = (
        (InputError, "input"), (LimitNotMet, "limit"), (Later, "stopped"), (Left, "left"),
        (Stopped, "stopped"), (KeyboardInterrupt, "stopped"),
    )  # fmt: skip
    kind = next((name for types, name in kinds if isinstance(error, types)), "crash")
    if isinstance(error, InputError) and error.file is not None:  # its name; the whole path stands in the details
        return Fault(
            kind, str(error).replace(str(error.file), Path(str(error.file)).name, 1), "", details or str(error)
        )
    if isinstance(error, OSError) and error.errno is not None:  # the disk, or a file: nothing in labcal broke
        return Fault("input", words_of_system(error), "", details)
    if kind == "crash":  # what it says is for who mends labcal
        return Fault(kind, OWN_MISTAKE, "", details or f"{type(error).__name__}: {error}")
    return Fault(kind, str(error) or type(error).__name__, "", details)


def with_instrument_names(fault: Fault, links: Mapping[str, str]) -> Fault:
    """`fault` with the instrument's name before its link; `links` by name."""
    return replace(fault, text=named_links(fault.text, links))


def pack(values: ArrayLike) -> dict[str, Any]:
    """An array as JSON: its shape, and float64 in base64."""
    array = np.ascontiguousarray(values, dtype="<f8")
    return {"shape": list(array.shape), "f8": b64encode(array.tobytes()).decode()}


def unpack(said: Mapping[str, Any]) -> NDArray[np.float64]:
    """The array that `pack` wrote."""
    return np.frombuffer(b64decode(said["f8"]), dtype="<f8").reshape(said["shape"])
