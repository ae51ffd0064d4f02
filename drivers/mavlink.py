"""A DUT on board of a vehicle that speaks MAVLink (PX4, ArduPilot): its magnetometer, and its telemetry as channels."""

from __future__ import annotations

from collections.abc import Callable

from drivers.framing import mavlink
from drivers.framing.columns import QUANTITIES
from drivers.framing.listener import ParsedListener
from drivers.framing.mavlink_stream import Parser, Settings
from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import ChannelSpec, Identity
from labcal.bench.links import Link
from labcal.record.stream import Event

HEARTBEAT_S, ANSWERS_S = 3.0, 2.0
GROUND = 255  # the system id that ground stations have


class Mavlink(ParsedListener):
    """Frames with a wrong checksum give no value. It asks for parameters by name, and tells the vehicle nothing else.

    What the vehicle's own calibration holds is an event of the record: its readings may have that applied already.
    """

    roles = ("dut",)
    parser, before = Parser, b""
    never = (rb"^(?!\xfe\x14.{3}\x14.{22}$)",)  # but one PARAM_REQUEST_READ (20) in MAVLink 1

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.channels = tuple(map(_channel, settings.channels))
        self._dialect = mavlink.dialect()
        self._on_board: dict[str, float] | None = None
        self._reported = True
        super().__init__(name, link, clock, settings, Identity("", "", settings.serial))

    def identify(self) -> Identity:
        """Wait for a reading and a heartbeat, then read the calibration on board. Raises InstrumentError (silent)."""
        super().identify()
        parser = Parser(self.name, self.settings, Mishaps(self.name))
        self._listen(parser, HEARTBEAT_S, lambda: parser.vehicle.autopilot >= 0)
        self._on_board = self._asked(parser)
        vehicle = parser.vehicle
        model = f"{self.settings.message} of system {vehicle.system}"
        return Identity(vehicle.maker, model, self.settings.serial)

    def start(self) -> None:
        """Begin: what arrived before is dropped."""
        super().start()
        self._reported = False

    def events(self) -> list[Event]:
        """What was lost or no good since this was asked last; first of all, the calibration on board."""
        return [*self._calibration(), *super().events()]

    def _calibration(self) -> list[Event]:
        if self._reported or self._on_board is None:
            return []
        self._reported = True
        said = ", ".join(f"{name} {value:g}" for name, value in self._on_board.items())
        text = f"{self.name}: its own calibration, which its readings may have applied: {said or 'not stated'}"
        return [Event(self._clock.now(), "on-board-calibration", text, dict(self._on_board))]

    def _asked(self, parser: Parser) -> dict[str, float]:
        """The parameters that answer; one that does not is asked for twice."""
        wanted = mavlink.calibration_names(parser.vehicle, self.settings.sensor)
        for _ in range(2):
            for name in (name for name in wanted if name not in parser.parameters):
                self._link.send(self._request(parser.vehicle.system, name))
            self._listen(parser, ANSWERS_S, lambda: parser.parameters.keys() >= set(wanted))
        return {name: parser.parameters[name] for name in wanted if name in parser.parameters}

    def _request(self, system: int, name: str) -> bytes:
        sender = self._dialect.MAVLink(None, GROUND, 0)
        request = sender.param_request_read_encode(system, self.settings.component_id, name.encode(), -1)
        return bytes(request.pack(sender, force_mavlink1=True))

    def _listen(self, parser: Parser, seconds: float, enough: Callable[[], bool]) -> None:
        deadline = self._clock.now() + seconds
        while self._clock.now() < deadline and not enough():
            parser.feed(self._link.receive(self._clock.now() + 0.05))


def _channel(name: str) -> ChannelSpec:
    quantity, unit = mavlink.UNITS.get(name.split("_")[0]) or QUANTITIES[name.split("_")[0]]
    return ChannelSpec(name, unit, quantity)
