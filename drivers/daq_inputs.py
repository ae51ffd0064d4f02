"""An analogue three-axis fluxgate on three inputs of a LabJack U6 or an NI-DAQmx device, by their makers' modules."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from drivers.framing.analogue import Analogue, Fluxgate
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import decimal
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link, quoted
from labcal.errors import InstrumentError

KNOWN = ("LabJack", "National Instruments")
Input = Annotated[int, Field(ge=0, le=142)]  # of a U6 with its multiplexer


@dataclass(frozen=True)
class Settings(Analogue):
    """`inputs`: AIN or ai numbers. Differential: against the next one of a U6, the partner by its maker's rule of NI's.

    `range_V`: 10, 1, 0.1 or 0.01 of a U6; of NI's devices the least range of theirs that holds it.
    """

    inputs: tuple[Input, Input, Input] = (0, 1, 2)
    timeout_s: Annotated[float, Field(gt=0, le=60)] = 0.5


class DaqInputs(Fluxgate):
    """Volts become nT by the sensor's scale; `serial` is what bench.toml states of the sensor."""

    never = (rb"^(?!(who|ain \d+,\d+,\d+ (single|differential) [\d.]+ \d+)\n\Z)",)

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link = name, settings, link
        self.begin(clock)

    def identify(self) -> Identity:
        """Ask which box it is, and read its inputs once: they must be there, and have that range."""
        maker, model, serial, version = (*self._ask("who").split(","), "", "", "", "")[:4]
        if maker not in KNOWN:
            raise InstrumentError(f"{self.name}: {quoted(maker)} answered, no LabJack and no device of NI.",
                                  fault="another instrument")  # fmt: skip
        self.volts()
        return Identity(maker, model, f"{serial} {self.settings.serial}".strip(), version)

    def volts(self) -> list[float]:
        """One sample of the three inputs. Raises InstrumentError (refused) with what the box cannot do."""
        s = self.settings
        wiring = "differential" if s.differential else "single"
        reply = self._ask(f"ain {','.join(map(str, s.inputs))} {wiring} {s.range_V:g} {s.average}")
        if reply.startswith("?"):
            raise InstrumentError(f"{self.name}: it cannot: {reply[1:].strip()}.", fault="refused",
                                  remedy="Look at the settings of its inputs in bench.toml.")  # fmt: skip
        try:
            x, y, z = map(decimal, reply.split(","))
        except ValueError as error:
            raise InstrumentError(f"{self.name}: its inputs came as {quoted(reply)}.", fault="wrong reply") from error
        return [x, y, z]

    def _ask(self, line: str) -> str:
        self._link.flush()
        reply = self._link.ask(f"{line}\n".encode(), end=b"\n", timeout_s=self.settings.timeout_s)
        return reply.decode("utf-8", "replace").strip()
