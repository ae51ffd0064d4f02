"""The person at a simulated bench: what a prompt asks of the operator is done to the simulated lab."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from labcal.bench.clock import Clock
from labcal.record.stream import Prompt


class SimulatedLab(Protocol):
    """What an operator can do in a lab; times on the bench's clock."""

    def mount(self, t_s: float, body_from_cage: Sequence[Sequence[float]]) -> None:
        """Mount the DUT with this attitude (3, 3) at platform angle zero."""
        ...

    def take_away(self, t_s: float) -> None:
        """Take the DUT off the platform and far away; `mount` brings it back."""
        ...

    def switch_mode(self, t_s: float, mode: str) -> None:
        """Switch the DUT's power mode."""
        ...

    def turn_dial(self, t_s: float, angle_deg: float) -> None:
        """Turn a platform without a motor."""
        ...

    def switch_load(self, t_s: float, load: str, on: bool) -> None:
        """Switch a load of the spacecraft."""
        ...

    def move_reference(self, place_m: Sequence[float]) -> None:
        """Put the reference there, from the DUT's place in C."""
        ...

    def turn_reference(self, sensor_from_home: Sequence[Sequence[float]]) -> None:
        """Turn the reference (3, 3) from how it stands at home."""
        ...

    def reverse_half(self, t_s: float, axis: str, reversed_: bool) -> None:
        """Swap the leads of the half towards + of this coil's pair, or put them back."""
        ...


class SimulatedOperator:
    """Does what a prompt's `drawing` says: mount, take away, switch mode or load, turn the dial, move the reference.

    "body_from_cage" (3x3, at angle 0) mounts the DUT, "mode" switches its power mode, "angle_deg" turns a dial that has
    no motor, "load" and "on" switch a load, "half" and "reversed" swap the leads of half a coil pair.
    """

    def __init__(self, lab: SimulatedLab, clock: Clock) -> None:
        self._lab, self._clock = lab, clock

    def do(self, prompt: Prompt) -> None:
        """Do it now, before the answer is given."""
        t, asked = self._clock.now(), prompt.drawing
        if "body_from_cage" in asked:
            self._lab.mount(t, asked["body_from_cage"])
        if "dut_away" in asked:
            self._lab.take_away(t)
        if "mode" in asked:
            self._lab.switch_mode(t, asked["mode"])
        if "angle_deg" in asked:
            self._lab.turn_dial(t, asked["angle_deg"])
        if "load" in asked:
            self._lab.switch_load(t, asked["load"], bool(asked["on"]))
        if "reference_m" in asked:
            self._lab.move_reference(asked["reference_m"])
        if "reference_turned" in asked:
            self._lab.turn_reference(asked["reference_turned"])
        if "half" in asked:
            self._lab.reverse_half(t, asked["half"], bool(asked["reversed"]))
