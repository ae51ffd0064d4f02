"""Who is there, of all instruments: those of the guardian's lines are asked over a connection each, and at once too."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack

from labcal.bench.clock import Clock
from labcal.bench.config import BenchConfig
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.guardian.client import Connection, ask_once, found
from labcal.bench.guardian.proxies import GuardedInstrument
from labcal.bench.identification import HOLDS_S, Identifies, identified, lines_apart
from labcal.errors import InstrumentError


class AskedSupply:
    """An instrument of the guardian's, asked who it is beside the session's own orders, which wait for one another.

    One that said so on its way to zero a moment ago is not asked again.
    """

    def __init__(self, name: str, connection: Connection) -> None:
        self.name, self._connection = name, connection

    def identify(self) -> Identity:
        """Who answers. Raises InstrumentError as the guardian says, and (guardian lost) where it is gone."""
        try:
            return Identity(**ask_once(self._connection, "identify", name=self.name, within_s=HOLDS_S))
        except OSError as error:
            raise InstrumentError(
                f"{self.name}: the guardian is gone ({error}); how the coils are is not known.",
                fault="guardian lost",
                remedy="Say `labcal bench off`, then try again.",
            ) from error


def all_identified(instruments: Mapping[str, Identifies], config: BenchConfig, clock: Clock) -> dict[str, Identity]:
    """Each one's identity by name. Raises the InstrumentError of the first, in their order, that is silent or another.

    What shares a line is asked one after another; a guardian that is met by no second connection, in turn.
    """
    there, apart = dict[str, Identifies](instruments), lines_apart(config)
    with ExitStack() as afterwards:
        for name, one in instruments.items():
            link = config.instruments[name].link
            if isinstance(one, GuardedInstrument) and (connection := _another(link)) is not None:
                afterwards.callback(connection.close)
                there[name], apart[name] = AskedSupply(name, connection), link
        return identified(there, apart, clock)


def _another(link: str) -> Connection | None:
    """One more connection to the guardian of this port; None where there is none, or no handle for it."""
    try:
        return found([link])
    except OSError:
        return None
