"""What must not go unnoticed: a stream that falls silent or stuck, contacts that are gone, too much heat or field."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

Array = NDArray[np.float64]
STUCK_SAMPLES = 100
NOTICED_S, SILENCES, PAUSES = 2.0, 5.0, 2.0
LATE_S = 0.2  # later than its rate says, on its line and in this computer
KNOWN_PAUSES = 100  # looks, of which the longest pause counts: one long pause, as of a busy computer, is forgotten
LOOK_S = 1.0  # as the coils: what is heard so often is never shown as old
UNKNOWN_S = 60.0  # without a value so long, a temperature that has a limit is not known
SEEN = 1.05  # the reference stands beside the DUT, and set-points may go up to the limit itself


class StreamWatch:
    """Raises InstrumentError where nothing has come for `silent_s`, or the same values for `stuck_s`.

    With coils on, the sensor that watches them may be missed for less: `left_s` of `see`, but `PAUSES` times the
    longest of the last pauses between two looks that found something; where its maker states its `period_s`, `LATE_S`
    more than that or the longest of them.

    A silence is an event at once: as soon as it is `SILENCES` times the longest of its last pauses, and `NOTICED_S` at
    least; of a stream that has sent no two samples yet, after `silent_s`. While something else that was reported keeps
    the stream from sending, it is none; it counts from the end of that. While a person is asked, `waited_for` of `see`,
    nothing is raised, and patience begins anew with the answer.
    """

    def __init__(self, name: str, silent_s: float, stuck_s: float, now_s: float, period_s: float | None = None) -> None:
        self.name, self._silent_s, self._stuck_s = name, silent_s, stuck_s
        self._last_s = self._changed_s = self._waited_s = now_s
        self._excused_s = -math.inf
        self._period_s, self._spoilt = period_s, 0
        self._between_s = deque[float](maxlen=KNOWN_PAUSES)  # two samples, the longest of each look
        self._came_s: float | None = None  # when a look found samples last
        self._pauses_s = deque[float](maxlen=20)  # between two such looks
        self._quiet = False
        self._pending: list[Event] = []
        self._value: Array | None = None
        self._same = 0

    @property
    def last_s(self) -> float | None:
        """The stamp of its last sample; None before there was one."""
        return None if self._value is None else self._last_s

    def wrong(self, name: str) -> str:
        """What is wrong with `name` now; "" where nothing is, or another is meant."""
        return "silent" if name == self.name and self._quiet else ""

    def news(self) -> list[Event]:
        """Silences that began or ended since this was asked last."""
        pending, self._pending = self._pending, []
        return pending

    def see(
        self,
        blocks: list[Block],
        now_s: float,
        wrong: str = "",
        left_s: float = math.inf,
        *,
        spoilt: int = 0,
        waited_for: bool = False,
    ) -> None:
        """Look at what has come up to `now_s`; `wrong` is what is known to keep it from sending.

        `spoilt`: how many messages came so far that were no good: whoever sends them is not missed.
        """
        if spoilt > self._spoilt:
            self._spoilt = spoilt
            self._came(now_s)
        for block in blocks:
            if block.stream in ("dut", "reference") and len(block):
                self._note(block)
                self._came(now_s)
        self._excused_s = now_s if wrong else self._excused_s
        self._notice(now_s)
        self._waited_s = now_s if waited_for else self._waited_s
        if waited_for:
            return
        if now_s - max(self._last_s, self._waited_s) > self._silent_s or self._missed(now_s, left_s):
            raise InstrumentError(
                f"{self.name}: no sample for {now_s - self._last_s:.1f} s.",
                fault="silent",
                remedy="Is its plug in at both ends, and has it power? Nobody can tell from here which it is.",
            )
        if self._same > STUCK_SAMPLES and self._last_s - self._changed_s > self._stuck_s:
            raise InstrumentError(
                f"{self.name}: the same reading for {self._last_s - self._changed_s:.0f} s.",
                fault="stuck",
                remedy="Switch the sensor off and on, and look at its range.",
            )

    def _came(self, now_s: float) -> None:
        if self._came_s is not None and self._excused_s < self._came_s:
            self._pauses_s.append(now_s - self._came_s)
        self._came_s = now_s

    def _missed(self, now_s: float, left_s: float) -> bool:
        """Whether it is missed for too long; of a stream whose pauses are not known, `silent_s` alone tells."""
        longest_s = max(self._pauses_s, default=0.0)
        if self._came_s is None or not (longest_s or self._period_s):
            return False
        usual_s = PAUSES * longest_s if self._period_s is None else max(self._period_s, longest_s) + LATE_S
        return now_s - self._came_s > max(left_s, usual_s)

    def _notice(self, now_s: float) -> None:
        """Say so once where it has fallen silent; a stream of which no two samples are known is given its time."""
        pause_s = now_s - max(self._last_s, self._excused_s)
        usual_s = SILENCES * max(self._between_s) if self._between_s else self._silent_s
        if not self._quiet and pause_s > max(NOTICED_S, usual_s):
            self._quiet = True
            self._report(now_s, "silent", f"no sample for {pause_s:.1f} s")

    def _report(self, t_s: float, fault: str, text: str) -> None:
        self._pending.append(Event(t_s, "stream", f"{self.name}: {text}", {"fault": fault}))

    def _note(self, block: Block) -> None:
        if self._quiet:
            self._quiet = False
            self._report(
                float(block.t_s[0]), "heard again", f"it sends again, after {block.t_s[0] - self._last_s:.1f} s"
            )
        else:
            before = block.t_s[:0] if self._value is None else np.array([self._last_s])
            pauses = np.diff(np.concatenate([before, block.t_s])).tolist()
            self._between_s.extend([max(known)] if (known := pauses[self._excused_s >= self._last_s :]) else [])
        self._last_s = float(block.t_s[-1])
        before = block.values[:1] if self._value is None else self._value[None, :]
        moved = np.flatnonzero(np.any(np.diff(np.vstack([before, block.values]), axis=0) != 0, axis=1))
        self._value = block.values[-1]
        if len(moved):
            self._changed_s, self._same = float(block.t_s[moved[-1]]), len(block) - int(moved[-1])
        else:
            self._same += len(block)


class RestPoll:
    """Asks what is not heard otherwise, and what is `gone`, whether it answers; what has gone, or is back, is reported.

    `ask` raises InstrumentError where it does not answer. That takes long: of several that are gone one is asked at a
    look, so that those which answer are read between two of them.
    """

    def __init__(self, names: Sequence[str], ask: Callable[[str], None]) -> None:
        self._names, self._ask, self._next_s = tuple(names), ask, 0.0
        self._wrong: dict[str, str] = {}
        self._pending: list[Event] = []

    def at(self, now_s: float) -> None:
        """Look, where it is time. Raises InstrumentError where another instrument answers than before."""
        if now_s < self._next_s:
            return
        self._next_s = now_s + LOOK_S
        for name in (*(name for name in self._names if name not in self._wrong), *list(self._wrong)[:1]):
            self._look(name, now_s)

    def wrong(self, name: str) -> str:
        """What is wrong with it now; "" where nothing is."""
        return self._wrong.get(name, "")

    def news(self) -> list[Event]:
        """What has gone or come back since this was asked last."""
        pending, self._pending = self._pending, []
        return pending

    def gone(self, name: str, fault: InstrumentError, now_s: float) -> None:
        """It does not answer."""
        if name not in self._wrong:
            self._pending.append(Event(now_s, "stream", f"{name}: {fault.what}", {"fault": fault.fault}))
        self._wrong.pop(name, None)  # it is asked again after the others
        self._wrong[name] = fault.fault

    def heard(self, name: str, now_s: float) -> None:
        """It answers."""
        if self._wrong.pop(name, None) is not None:
            self._pending.append(Event(now_s, "stream", f"{name}: it answers again", {"fault": "heard again"}))

    def _look(self, name: str, now_s: float) -> None:
        try:
            self._ask(name)
        except InstrumentError as fault:
            if fault.fault == "another instrument":
                raise
            return self.gone(name, fault, now_s)
        return self.heard(name, now_s)


class TemperatureLimit:
    """Raises InstrumentError where one of these temperatures [degC] leaves its range, or none has come for long."""

    def __init__(self, allowed_C: tuple[float, float], channels: tuple[str, ...], remedy: str, now_s: float) -> None:
        self._allowed, self._channels, self._remedy = allowed_C, channels, remedy
        self._last_s = dict.fromkeys(channels, now_s)

    def see(self, blocks: list[Block], now_s: float, waited_for: bool = False) -> None:
        """Look at the housekeeping that has come up to `now_s`; while it is `waited_for` none need come."""
        self._last_s = dict.fromkeys(self._channels, now_s) if waited_for else self._last_s
        for block in blocks:
            for name in set(self._channels) & set(block.columns):
                values = block.values[:, block.columns.index(name)]
                if (known := np.isfinite(values)).any():
                    self._last_s[name] = float(block.t_s[known][-1])
                    self._judge(block.source, name, values[known])
        for name, last_s in self._last_s.items():
            if now_s - last_s > UNKNOWN_S:
                raise InstrumentError(
                    f"{name}: no temperature for {now_s - last_s:.0f} s, and it has a limit.",
                    fault="silent",
                    remedy=f"See why {name} is not reported.",
                )

    def _judge(self, source: str, name: str, values: Array) -> None:
        low, high = self._allowed
        for value, limit, beyond in (
            (values.min(), low, values.min() < low),
            (values.max(), high, values.max() > high),
        ):
            if beyond:
                raise InstrumentError(
                    f"{source}: {name} is {value:g} degC, its limit is {limit:g} degC.",
                    fault="limit reached",
                    remedy=self._remedy,
                )


class FieldLimit:
    """Raises InstrumentError where the reference, beside the DUT, sees more than `limit_nT` and `SEEN` allow.

    For while the coils are on: a field that is there without them is nobody's doing.
    """

    def __init__(self, limit_nT: float) -> None:
        self._limit_nT = limit_nT

    def see(self, blocks: list[Block], ambient_nT: float) -> None:
        """Look at the readings (n, 3) or (n, 1) [nT] of the reference that have come."""
        for block in blocks:
            if block.stream == "reference" and len(block):
                seen = float(np.linalg.norm(block.values, axis=1).max())
                if seen > SEEN * max(self._limit_nT, ambient_nT):
                    raise InstrumentError(
                        f"{block.source}: a field of {seen:.0f} nT is seen, the limit is {self._limit_nT:.0f} nT.",
                        fault="limit reached",
                        remedy="Is the ambient field what it was when it was measured last?",
                    )
