"""Which kind of bench a run was begun on: real, simulated, or a simulated one served on lines of this computer."""

from __future__ import annotations

import tomllib

SIMULATED, SERVED, REAL = "simulated", "served", "real"


def bench_kind(text: str) -> str:
    """Of the whole text of a bench file; "" where it does not say it."""
    try:
        stated = tomllib.loads(text)
        links = [str(one["link"]) for one in stated["instruments"].values()]
    except (tomllib.TOMLDecodeError, AttributeError, KeyError, TypeError):
        return ""
    emulated = all(link.startswith("emulated://") for link in links)
    return kind_of(simulated=emulated, served=stated.get("served") is True)


def kind_of(*, simulated: bool, served: bool) -> str:
    """`simulated`: every link is emulated; `served`: emulated instruments stand on real lines."""
    return SIMULATED if simulated else SERVED if served else REAL
