"""An effect for a computer that flies: its formula in C99, row by row, which its author writes beside the kernel.

The body of a `CForm` is statements that set `e[parameter][axis]`, zero before, to what the kernel gives for the row.
It finds `now->t_s` (double), `now->segment`, `now->mode`, `now->field[3]` (a = K m − k [nT, B]), `now->along[3]` (the
same along the sensor's own axes), `now->input[…]` (double), `AXES[3][3]`, `shape[]` (double, the term's shape
parameters in their order) and `state`, its own. Every other number is a `labcal_real`, written `R(…)`.
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects.scene import Scene

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Input:
    """A number that is given with each reading. `values` gives it (n,) for the rows of a scene: for test vectors.

    One with a `channel` is that channel as it stands; the others are worked out by who calls.
    """

    name: str  # in C
    unit: str
    what: str  # one line, in ASCII
    values: Callable[[Scene], Array]
    channel: str | None = None
    where_it_begins: bool = False  # read in the first row of a state alone


@dataclass(frozen=True, slots=True)
class CForm:
    """One form of an effect in C: its formula for people, its statements, and what they need."""

    formula: str  # one line, in ASCII
    body: str
    inputs: tuple[Input, ...] = ()
    state: str = ""  # the members of its struct; empty for what remembers nothing
    helpers: tuple[str, ...] = ()  # names of functions in `labcal_calibration.c` that the body calls
    stamps: bool = False  # it says nothing but when: the field belongs to its one parameter before the reading


def identifier(name: str) -> str:
    """A word of C for a name: other signs are `_`, and a name that had such ends in a number of its own."""
    plain = re.sub(r"[^A-Za-z0-9_]", "_", name)
    return plain if plain == name else f"{plain}_{zlib.crc32(name.encode()) & 0xFFFF:04x}"


def real(value: float) -> str:
    """A number as C reads it, to the last bit."""
    return f"R({float(value)!r})" if np.isfinite(value) else "R(NAN)"


def mode_enumerator(mode: str) -> str:
    """The name of a power mode; "" is a row that states none."""
    return f"LABCAL_MODE_{identifier(mode)}" if mode else "LABCAL_NO_MODE"


def given(channel: str, unit: str) -> Input:
    """A channel as it was recorded."""
    return Input(identifier(channel), unit, f"channel {channel}", lambda scene: scene.channels[channel], channel)


def enumerator(one: Input) -> str:
    """The name of an input's place."""
    return f"LABCAL_IN_{one.name}"


def reads(one: Input) -> str:
    """The expression of an input's value, a double."""
    return f"now->input[{enumerator(one)}]"
