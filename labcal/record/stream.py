"""What happens during a run, in one timeline: samples, segments, steps, measurements, prompts and events.

A procedure yields these; the runner writes them to the store. Times are seconds of the bench's clock.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.record.run import Segment

Array = NDArray[np.float64]
Stream = Literal["dut", "reference", "angle", "channel"]
CLOSURE = "closure"  # the kind of an event whose `u_offset_nT` is what the zero may have moved, between two standstills


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """Samples of one stream at their own stamps: `values` (n, k) in the order of `columns`.

    Streams and columns: "dut" dut_x dut_y dut_z [DUT unit]; "reference" ref_x ref_y ref_z [nT, C] or ref_f [nT];
    "angle" angle_deg; "channel" any housekeeping names. `raw` holds the frames as they came over the wire.
    """

    stream: Stream
    source: str  # the instrument's name in bench.toml
    columns: tuple[str, ...]
    t_s: Array  # (n,)
    values: Array  # (n, k)
    raw: bytes = b""

    def __len__(self) -> int:
        return len(self.t_s)


@dataclass(frozen=True, slots=True)
class SegmentOpened:
    """From here on, samples belong to `segment`."""

    t_s: float
    segment: Segment


@dataclass(frozen=True, slots=True)
class SegmentClosed:
    """The open segment ends here; samples between segments are kept and belong to none."""

    t_s: float


@dataclass(frozen=True, slots=True)
class ModeChanged:
    """The DUT's power mode from here on."""

    t_s: float
    mode: str


@dataclass(frozen=True, slots=True)
class Step:
    """Step `number` of `total` begins; `left_s` is the lab time expected until the procedure's end.

    The first step states the names of all, in order; `step_s` is the lab time of this one alone. `needed_s` is the lab
    time until `needed_for`, the next step that begins with a question to a person; None where none is to come.
    `whole_s` is the lab time of all steps, what an interruption has kept of them included.
    """

    t_s: float
    number: int
    total: int
    name: str
    left_s: float
    names: tuple[str, ...] = ()
    step_s: float | None = None
    needed_s: float | None = None
    needed_for: str = ""
    whole_s: float | None = None


@dataclass(frozen=True, slots=True)
class Measurement:
    """A value with standard uncertainty against limits; the verdict uses U = 2 u (k = 2)."""

    t_s: float
    name: str
    value: float
    u: float
    unit: str
    limit: float | None = None  # on |value|

    @property
    def verdict(self) -> Literal["PASS", "MARGINAL", "FAIL", "CANNOT DECIDE", ""]:
        """PASS where |value| + U is within the limit, FAIL where |value| − U is beyond, MARGINAL between.

        CANNOT DECIDE where U exceeds half the limit and the value is not beyond it all the same, or where either is no
        number; empty where there is no limit.
        """
        if self.limit is None:
            return ""
        size, U = abs(self.value), 2 * self.u
        if size - U > self.limit:
            return "FAIL"
        if not (self.limit / 2 >= U and isfinite(size)):
            return "CANNOT DECIDE"
        return "PASS" if size + U <= self.limit else "MARGINAL"


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened: a set-point, a read-back, an answer, a fault."""

    t_s: float
    kind: str  # "set-point", "read-back", "answer", "fault", "note", "zero" …
    text: str
    data: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Prompt:
    """A question to the person; the procedure's `yield` returns the answer, one of `choices`.

    `acts` says that "yes" mounts, energises, moves or switches a load: only a person may say it on a real bench.
    """

    t_s: float
    key: str  # "mount-x", "ready" … stable, for scripts
    text: str
    choices: tuple[str, ...] = ("done",)
    acts: bool = False
    drawing: Mapping[str, Any] = field(default_factory=dict)  # which body axis is up, which way it turns


NOT_USED = (
    "not-used"  # an Event of this kind: the segments so far that its data name are kept, and no run is made of them
)
OTHER_SERIAL = "other-serial"  # an Event of this kind: an instrument names another serial than is stated
COVERAGE = "coverage"  # an Event of this kind: a turn has not seen a stretch of the circle that matters
BY, PROCEDURE = "by", "procedure"  # in the data of a note: that no person wrote it
MEANWHILE = "meanwhile"  # an Event of this kind: what moved while an instrument was silent
RESUMED = "resumed"  # an Event of this kind: an interrupted run is gone on with
SLOW_DISK = "slow-disk"  # an Event of this kind is told and not kept: rows wait in memory for a busy disk
NOT_KEPT = "not-kept"  # an Event of this kind: the store does not take what is recorded, or not yet
FAULT = "fault"  # an Event of this kind: an instrument failed, in a step or so that the run ended
REMARK = "remark"  # an Event of this kind: what whoever uses the run has to hear of its bench

Item = Block | SegmentOpened | SegmentClosed | ModeChanged | Step | Measurement | Event | Prompt
