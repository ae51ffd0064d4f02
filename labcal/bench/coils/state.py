"""The state of the lab as one frozen value: coils, reference, guardian, instruments, each with the time it was read.

It is made in one place, `Bench.state`, and what is said of the coils is made here from it, and nowhere else. Times are
seconds of whatever clock the value was read on; `shifted` carries it to another.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from typing import Any, Literal

from labcal.bench.coils.at_zero import FRESH_S as FRESH_S
from labcal.bench.coils.zero import AtZero

MEAN_OF = 20  # readings of a reference are shown as one
AT_ZERO = "coils at zero"
BY_WORD = "zero by the supply's word only"
BY_SUPPLIES = "coils read back at zero by their supplies"  # the same, for who is to reach in
BY_BOTH = "coils at zero, by their supplies and by the field"  # AT_ZERO, likewise: what each proof is
NOT_CONFIRMED = "coils NOT confirmed at zero"
WAS_ZERO = "coils confirmed at zero"  # when it was read, and the reference agreed then
WAS_ZERO_BY_WORD = "coils read back at zero by the supply's word"
NOT_WATCHED = "; not watched since"
LOST_SINCE = ", silent since"  # of supplies: it goes with the zero however short that is put
NOT_BY_REFERENCE = "NOT at zero by the reference"
NOT_READ = "coils not read back in this session"
NOT_YET = "coils may be on: a run goes on, and nothing was read yet"
NOT_SINCE = "coils not read back since they were ordered off"
NOT_READ_ON = "of a simulated lab the reference is not read at rest"
NOT_ASKED = "no reference has confirmed it"
REFERENCE_SILENT = "the reference does not answer"
ON = "coils on"
MAY_TURN = "platform NOT confirmed at a standstill"
OPEN_THEM = "Open the outputs that can open, or switch the supplies off at their mains"
Verdict = Literal["agrees", "disagrees", "not known"]
Vector = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class CoilReading:
    """One axis as last read: None is not known. `zero`: below what counts as zero; `open`: its output was opened.

    `fault` is why it could not be read.
    """

    axis: str
    set_A: float | None = None
    current_A: float | None = None
    zero: bool = False
    open: bool | None = None
    read_s: float | None = None
    fault: str = ""


@dataclass(frozen=True, slots=True)
class Witness:
    """Whether the reference beside the DUT sees what the supplies say, last looked at `read_s`; `why` it is not known.

    `seen_nT` and `expected_nT` (3,) in C; their distance is judged against `limit_nT`. `advice`: at which supply a
    person can do something about it, and what.
    """

    verdict: Verdict = "not known"
    why: str = NOT_ASKED
    seen_nT: Vector | None = None
    expected_nT: Vector | None = None
    difference_nT: float = 0.0
    limit_nT: float = 0.0
    read_s: float | None = None
    advice: str = OPEN_THEM

    @property
    def words(self) -> str:
        """What was seen, what was expected, and how far they are apart."""
        if self.seen_nT is None or self.expected_nT is None:
            return self.why
        seen, expected = (" ".join(f"{v:.0f}" for v in vector) for vector in (self.seen_nT, self.expected_nT))
        apart = f"{self.difference_nT / 1000:.2f} µT apart, {self.limit_nT / 1000:.2f} µT allowed"
        return f"it sees {seen} nT, {expected} nT expected: {apart}"


@dataclass(frozen=True, slots=True)
class Heard:
    """When an instrument was last heard (None: not yet), and what is wrong with it now ("": nothing)."""

    name: str
    heard_s: float | None = None
    fault: str = ""


@dataclass(frozen=True, slots=True)
class FieldReading:
    """The field at the DUT in C: as it was asked for (None: it was not), and as the reference saw it last, `read_s`.

    `changing`: the coils are on their way, and what was seen is neither the field before nor the one to come.
    """

    set_nT: Vector | None = None
    seen_nT: Vector | None = None
    read_s: float | None = None
    changing: bool = False

    def seen(self, t_s: Any, field_nT: Any) -> FieldReading:
        """With the mean of the last of what the reference sent, (n, 3) at `t_s` (n,); none changes nothing."""
        if len(t_s) == 0:
            return self
        x, y, z = (sum(float(v) for v in column) / len(column) for column in zip(*field_nT[-MEAN_OF:], strict=True))
        return FieldReading(self.set_nT, (x, y, z), float(t_s[-1]))

    def since(self, t_s: float) -> FieldReading:
        """Without what was seen before `t_s`: on a ramp, of currents that flow no more."""
        return replace(self, seen_nT=None, read_s=None) if self.read_s is not None and self.read_s < t_s else self

    def asked(self, field_nT: Any, *, changing: bool = False) -> FieldReading:
        """With what was asked for (3,), or None."""
        if field_nT is None:
            return replace(self, set_nT=None, changing=changing)
        x, y, z = map(float, field_nT)
        return replace(self, set_nT=(x, y, z), changing=changing)


@dataclass(frozen=True, slots=True)
class PlatformReading:
    """The platform as it was read last: None is not known. `fault` is why it could not be read since."""

    angle_deg: float | None = None
    moving: bool | None = None
    read_s: float | None = None
    fault: str = ""

    def sentence(self, now_s: float) -> str:
        """What may be said of it at `now_s`."""
        if self.moving is None or self.angle_deg is None or self.read_s is None:
            return MAY_TURN
        age_s = now_s - self.read_s
        if self.moving:
            turns = f"platform turns, at {self.angle_deg:.0f}°"
            return turns if age_s <= FRESH_S else _turned(self.angle_deg, ago(age_s))
        if age_s > FRESH_S:
            return f"platform stands at {self.angle_deg:.0f}°, read {ago(age_s)}"
        return f"platform stands at {self.angle_deg:.0f}°"


def _turned(angle_deg: float, when: str) -> str:
    return f"platform NOT confirmed at a standstill: at {angle_deg:.0f}° it turned, {when}"


def ago(age_s: float) -> str:
    """In whole units that have passed: 12 s ago, 3 min ago, 2 h ago."""
    for words, unit_s in (("s ago", 1), ("min ago", 60)):
        if age_s < 120 * unit_s:
            return f"{age_s // unit_s:.0f} {words}"
    return f"{age_s // 3600:.0f} h ago"


@dataclass(frozen=True, slots=True)
class LabState:
    """`guardian`: whether it lives; None where a bench needs none. The record has the last two as samples, not here.

    `platform` is None where nobody has read one, or it has no motor.
    """

    coils: tuple[CoilReading, ...]
    reference: Witness = Witness()
    guardian: bool | None = None
    instruments: tuple[Heard, ...] = ()
    field: FieldReading = FieldReading()
    platform: PlatformReading | None = None

    def platform_sentence(self, now_s: float) -> str:
        """What may be said of the platform at `now_s`; "" where none with a motor was read."""
        return "" if self.platform is None else self.platform.sentence(now_s)

    def sentence(self, now_s: float, clock_s: float | None = None, *, lost: bool = False) -> str:
        """What may be said of the coils at `now_s`, and no more than was read back.

        `clock_s`: what the clock on the wall (POSIX seconds) shows then, where what is past is to be said by it.
        `lost`: a supply gives no answer any more; a zero is past then, however short ago it was read.
        """
        contradicted = f"{NOT_BY_REFERENCE}: {self.reference.words}. {self.reference.advice}"
        unread = [coil for coil in self.coils if coil.current_A is None]
        if self.reference.verdict == "disagrees":
            return f"{NOT_CONFIRMED}; {contradicted}" if unread else contradicted
        if unread:
            return NOT_CONFIRMED if any(coil.fault for coil in unread) else NOT_READ
        if not self.coils:
            return NOT_READ
        age_s = self.age_s(now_s)
        if flowing := [coil for coil in self.coils if not coil.zero]:
            said = ", ".join(f"{coil.axis} {coil.current_A:+.4f} A" for coil in flowing)
            return f"coils on: {said}" + ("" if age_s <= FRESH_S else f", read back {ago(age_s)}")
        if age_s > FRESH_S or lost:
            return self._was_zero(age_s, clock_s, LOST_SINCE if lost else NOT_WATCHED)
        return AT_ZERO if self._seconded(now_s) else f"{BY_WORD}: {self.why_alone(now_s)}"

    def at_zero(self, now_s: float) -> bool | None:
        """Whether every coil was read back below its zero just now: False where not, None where that is not known."""
        known = [coil for coil in self.coils if coil.current_A is not None]
        faulty = any(coil.fault for coil in self.coils if coil.current_A is None)
        if self.reference.verdict == "disagrees" or faulty or not all(coil.zero for coil in known):
            return False
        return True if len(known) == len(self.coils) and self.age_s(now_s) <= FRESH_S else None

    def age_s(self, now_s: float) -> float:
        """How long ago the coil was read that was read first."""
        return max((now_s - coil.read_s for coil in self.coils if coil.read_s is not None), default=float("inf"))

    def shifted(self, by_s: float) -> LabState:
        """The same on a clock that shows `by_s` more."""
        return replace(
            self,
            coils=tuple(replace(coil, read_s=_later(coil.read_s, by_s)) for coil in self.coils),
            reference=replace(self.reference, read_s=_later(self.reference.read_s, by_s)),
            instruments=tuple(replace(one, heard_s=_later(one.heard_s, by_s)) for one in self.instruments),
            field=replace(self.field, read_s=_later(self.field.read_s, by_s)),
            platform=self.platform and replace(self.platform, read_s=_later(self.platform.read_s, by_s)),
        )

    def with_ends(self, ended: Iterable[AtZero]) -> LabState:
        """With how a guardian says that coils ended, where nobody has read them since; on the monotonic clock."""
        newer = {end.axis: _coil(end) for end in ended}
        return replace(self, coils=tuple(_latest(coil, newer.get(coil.axis)) for coil in self.coils))

    def as_json(self, now_s: float) -> dict[str, Any]:
        """With ages in place of times: for the record, and for another process."""
        plain: dict[str, Any] = json.loads(json.dumps(asdict(self.shifted(-now_s))))  # lists, as whoever reads it has
        del plain["field"], plain["platform"]
        return plain

    def _was_zero(self, age_s: float, clock_s: float | None, since: str) -> str:
        """That they were at zero, by whose word, and when; nobody has looked since."""
        read_s = min(coil.read_s for coil in self.coils if coil.read_s is not None)
        seen_s = self.reference.read_s
        agreed = self.reference.verdict == "agrees" and seen_s is not None and abs(seen_s - read_s) <= FRESH_S
        when = ago(age_s)
        if clock_s is not None:
            when = f"at {datetime.fromtimestamp(clock_s - age_s):%H:%M:%S} ({when})"
        return f"{WAS_ZERO if agreed else WAS_ZERO_BY_WORD} {when}{since}"

    def _seconded(self, now_s: float) -> bool:
        seen_s = self.reference.read_s
        return self.reference.verdict == "agrees" and seen_s is not None and now_s - seen_s <= FRESH_S

    def why_alone(self, now_s: float) -> str:
        """Why a zero rests on the supplies' word alone."""
        if self.reference.verdict == "agrees" and self.reference.read_s is not None:
            return f"the reference agreed when it was last looked at, {ago(now_s - self.reference.read_s)}"
        age_s = 0.0 if self.reference.read_s is None else now_s - self.reference.read_s
        return self.reference.why + (f", {ago(age_s)}" if age_s >= 1 else "")


def from_json(said: Mapping[str, Any], now_s: float) -> LabState:
    """The value that `as_json` wrote, on a clock that shows `now_s`."""
    reference = dict(said["reference"])
    for field in ("seen_nT", "expected_nT"):
        reference[field] = None if reference[field] is None else tuple(reference[field])
    coils = tuple(CoilReading(**coil) for coil in said["coils"])
    instruments = tuple(Heard(**one) for one in said["instruments"])
    return LabState(coils, Witness(**reference), said["guardian"], instruments).shifted(now_s)


def unread(axes: str = "xyz") -> tuple[CoilReading, ...]:
    """Coils of which nothing is known."""
    return tuple(map(CoilReading, axes))


def of_ends(ended: Iterable[AtZero], doubt: str = "", advice: str = OPEN_THEM) -> LabState:
    """The coils as somebody brought them to zero who asked no reference; times are those of their ends.

    `doubt`: what a reference saw before that, where nobody has answered for it, and the `advice` that came with it.
    """
    witness = Witness("disagrees", doubt, advice=advice) if doubt else Witness(why=NOT_ASKED)
    return LabState(tuple(_coil(end) for end in ended), witness)


def _coil(end: AtZero) -> CoilReading:
    """One axis as it ended: what has a current was read back below its zero."""
    known, fault = end.current_A is not None, "" if end.fault is None else str(end.fault)
    return CoilReading(end.axis, 0.0 if known else None, end.current_A, known, end.opened, end.read_s, fault)


def _latest(known: CoilReading, other: CoilReading | None) -> CoilReading:
    if other is None or other.read_s is None:
        return other or known
    return known if known.read_s is not None and known.read_s > other.read_s else other


def _later(t_s: float | None, by_s: float) -> float | None:
    return None if t_s is None else t_s + by_s
