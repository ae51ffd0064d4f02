"""Listening to the DUT and the reference: what they sent, whether they still send, and what of it is beyond a limit."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.bench.clock import Clock
from labcal.bench.coils.cage import Cage
from labcal.bench.coils.cage_file import Place
from labcal.bench.coils.state import FieldReading
from labcal.bench.config import BenchConfig
from labcal.bench.driver_kit.roles import DutStream, Magnetometer
from labcal.bench.guardian.handover import patience
from labcal.bench.links.urls import is_connection
from labcal.bench.streams.reconnect import Reconnecting
from labcal.bench.streams.reference import blind, into_cage
from labcal.bench.streams.samples import merged
from labcal.bench.streams.watch import NOTICED_S, FieldLimit, StreamWatch, TemperatureLimit
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

LISTEN_S = 0.2  # at the latest the streams are listened to again; where time is simulated only those that are asked
PATIENCE = 0.9  # of the time after which a sensor is called silent: a lost line is called by its own name


class Listening:
    """Both sensors, read in one go. `reconnect` opens the lost line of one by its name; `carry` is the bench's.

    While one is `waited_for`, nothing is missed.
    """

    def __init__(
        self,
        config: BenchConfig,
        clock: Clock,
        cage: Cage,
        dut: DutStream,
        reference: Magnetometer,
        reconnect: Callable[[str], object],
        carry: Place | None,
        waited_for: Callable[[], bool],
    ) -> None:
        self.on = False
        self.field = FieldReading()
        self._config, self._clock, self._cage, self._carry = config, clock, cage, carry
        self._dut, self._reference, self._waited_for = dut, reference, waited_for
        self._streams = [
            Reconnecting(
                dut,
                partial(reconnect, dut.name),
                PATIENCE * config.dut.silent_s,
                self._dut_missed_s,
                waited_for=waited_for,
            ),
            Reconnecting(
                reference,
                partial(reconnect, reference.name),
                PATIENCE * config.reference.silent_s,
                lambda: PATIENCE * self._reference_missed_s(),
                tried=not is_connection(config.instruments[reference.name].link),
                waited_for=waited_for,
            ),
        ]
        self._arrived: list[Block] = []
        self._watches: list[StreamWatch] = []
        self._limits: list[TemperatureLimit] = []
        self._field_limit = self._limit_of_the_field_seen()
        self._listened_s = 0.0

    def start(self) -> None:
        """Begin both streams."""
        self._reference.start()
        self._dut.start()
        self._listened_s = now = self._clock.now()
        self._watches = [
            StreamWatch(stream.name, stated.silent_s, stated.stuck_s, now, stream.period_s)
            for stream, stated in ((self._streams[0], self._config.dut), (self._streams[1], self._config.reference))
        ]
        self._limits = self._temperature_limits(now)
        self.on = self._cage.check.streaming = True

    def stop(self) -> None:
        """End both streams; a failure of one does not skip the other."""
        self.on = self._cage.check.streaming = False
        with ExitStack() as steps:
            steps.callback(self._reference.stop)
            steps.callback(self._dut.stop)

    def due_s(self) -> float:
        """When to listen next; what is asked, or is lost, says when."""
        soon_s = math.inf if math.isinf(self._clock.listen_s) else self._listened_s + LISTEN_S
        return min(soon_s, *(stream.due_s() for stream in self._streams if not self._left_alone(stream)))

    def listen(self) -> None:
        """Take in what has come. What one stream or one watch finds wrong is raised when all have been looked at."""
        self._listened_s = now = self._clock.now()
        faults = list[InstrumentError]()
        dut, reference = (self._read(stream, now, faults) for stream in self._streams)
        readings = dut, [self._into_cage(block) for block in reference]
        self._arrived += [*readings[0], *readings[1]]
        self._cage.check.unheard(self._streams[1].wrong)
        for block in readings[1]:
            if block.values.shape[1] == 3:
                self._cage.check.see(block.t_s, block.values)
                still = block.t_s >= self._cage.settled_s
                self.field = self.field.seen(block.t_s[still], block.values[still])
        left_s = self._dut_missed_s(), self._reference_missed_s()
        for stream, watch, blocks, left in zip(self._streams, self._watches, readings, left_s, strict=True):
            try:
                may_s = math.inf if stream.wrong else left
                watch.see(blocks, now, stream.wrong, may_s, spoilt=stream.spoilt, waited_for=self._waited_for())
            except InstrumentError as fault:
                faults.append(fault)
        if faults:
            raise faults[0]
        for limit in self._limits:
            limit.see(readings[0], now, self._waited_for())
        if self._field_limit is not None and self._cage.on:
            self._field_limit.see(readings[1], float(np.linalg.norm(self._cage.ambient_nT)))
        self._cage.refuse_what_is_not_seen()

    def take(self) -> list[Block]:
        """What has arrived since this was asked last, merged."""
        arrived, self._arrived = self._arrived, []
        return merged(arrived)

    def reference_since(self, t_s: float) -> NDArray[np.float64]:
        """Readings (n, 3) [nT, C] of the reference from `t_s` on that nobody has taken yet."""
        arrived = (b for b in self._arrived if b.stream == "reference")
        return np.vstack([np.empty((0, 3)), *(b.values[b.t_s >= t_s] for b in arrived)])

    def events(self) -> list[Event]:
        """What the streams lost since this was asked last: gaps, wrong checksums, broken frames."""
        return [event for stream in self._streams for event in stream.events()]

    def news(self) -> list[Event]:
        """What has fallen silent, or was lost, or is back, since this was asked last."""
        news = [event for stream in self._streams for event in stream.news()]
        return news + [event for watch in self._watches for event in watch.news()]

    def last_s(self) -> dict[str, float | None]:
        """The stamp of each sensor's last sample, by its name; None before there was one."""
        return {watch.name: watch.last_s for watch in self._watches}

    def wrong(self, name: str) -> list[str]:
        """What is wrong with the sensor `name`, its line first; "" where nothing is, or another is meant."""
        lines = [stream.wrong for stream in self._streams if stream.name == name]
        return [*lines, *(watch.wrong(name) for watch in self._watches)]

    def _left_alone(self, stream: Reconnecting) -> bool:
        """Whether it fails and would be waited for: not while the coils come down."""
        return bool(stream.wrong) and self._cage.to_zero_since_s is not None and math.isfinite(stream.due_s())

    def _read(self, stream: Reconnecting, now: float, faults: list[InstrumentError]) -> list[Block]:
        if self._left_alone(stream):
            return []
        try:
            return stream.read_until(now)
        except InstrumentError as fault:
            faults.append(fault)
            return []

    def _dut_missed_s(self) -> float:
        """How long the DUT may be missed: with coils on until it is called silent, as hands go to its plug."""
        return NOTICED_S if self._cage.on else math.inf

    def _reference_missed_s(self) -> float:
        """How long the reference may be missed: with coils on, what two seconds leave after the ramp to zero."""
        on = self._cage.on and not blind(self._config.reference)
        return patience(self._cage.way_down_s) if on else math.inf

    def _temperature_limits(self, now_s: float) -> list[TemperatureLimit]:
        """Of the DUT and of the windings, as far as they are stated."""
        dut, winding = self._config.dut.limits.temperature_C, self._config.cage.limits.temperature_C
        stated = (
            ("dut", dut, "Let the DUT come back into its range."),
            (
                "coil",
                None if winding is None else (-math.inf, winding),
                "Let the windings cool, then use less current.",
            ),
        )
        return [
            TemperatureLimit(allowed, temperatures_of(self._dut, role), remedy, now_s)
            for role, allowed, remedy in stated
            if allowed is not None
        ]

    def _limit_of_the_field_seen(self) -> FieldLimit | None:
        if self._config.reference.place in ("remote", "computed"):
            return None
        stated = (self._config.dut.limits.field_nT, self._config.cage.limits.field_nT)
        return FieldLimit(min(limit for limit in stated if limit is not None))

    def _into_cage(self, block: Block) -> Block:
        """The reference's reading, zero taken off, from its own axes into C; a remote one's carried to the DUT's place.

        Carried with the currents as read last until its stamp, for it may come after they have changed; during a ramp,
        of at most one and a half seconds, those from before it.
        """
        if block.values.shape[1] != 3:
            return block
        field = into_cage(block.values, self._config.reference)
        if self._carry is not None:
            field = field + self._carry.at(self._cage.flown.at(block.t_s))
        return replace(block, values=field)


def temperatures_of(dut: DutStream, role: str) -> tuple[str, ...]:
    """The temperature channels that belong to `role`."""
    return tuple(c.name for c in dut.channels if c.quantity == "temperature" and c.role == role)
