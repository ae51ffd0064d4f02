"""The simulated lab as a whole. Whoever stands at a wire asks it what is there at which time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotation, rotation_vector, unit
from labcal.twin.ambient import ambient
from labcal.twin.coils import AXES, Coil, square_coils
from labcal.twin.config import SensorTruth, TwinTruth
from labcal.twin.effects import DATA, REFERENCE, RIG, SENSOR, switched_on
from labcal.twin.housekeeping import Housekeeping
from labcal.twin.moment import Moment
from labcal.twin.pick import pick_effect
from labcal.twin.platform import Turntable
from labcal.twin.sensor import Sensor, response
from labcal.twin.step_functions import Steps

Array = NDArray[np.float64]


def open_twin(table: Mapping[str, Any], seed: int) -> Lab:
    """The lab that the table [twin] describes. Raises ValueError (pydantic's, with the path) for a wrong key."""
    return Lab(TwinTruth.model_validate(table), seed)


class Lab:
    """Coils, place, platform, reference and DUT. All times are the bench's clock; sensors are read in time order."""

    def __init__(self, truth: TwinTruth, seed: int) -> None:
        lots = [np.random.default_rng([seed, k]) for k in range(8)]
        wanted = {**truth.effects, **(pick_effect(seed) if truth.surprise else {})}
        coils = truth.coils
        tilt = np.array(coils.tilt_deg)
        self.coil_field = square_coils(coils.side_m, coils.turns, tilt, imbalance=coils.imbalance, exact=coils.exact)
        self._opposed = [Steps(False) for _ in AXES]  # one half of the pair reversed
        self.coils = {axis: Coil(coils.resistance_ohm, coils.tau_s, coils.residual_A) for axis in AXES}
        self.ambient = ambient(
            lots[0], np.array(truth.ambient.earth_nT), truth.ambient.drift_nT, truth.ambient.mains_nT
        )
        self.platform = Turntable(truth.platform.accel_deg_per_s2)
        self.housekeeping = Housekeeping(lots[1], truth.housekeeping.loads_A, period_s=truth.housekeeping.period_s)
        self.mode = Steps("nominal")
        self._truth, self._rng_reference, self._rng_dut, self._rng_hands = truth, lots[2], lots[3], lots[4]
        self._sensor_effects = switched_on(SENSOR, wanted, lots[5])
        self._rig_effects = switched_on(RIG, wanted, lots[6])
        self._reference_effects = switched_on(REFERENCE, wanted, lots[6])
        self._faults = switched_on(DATA, wanted, lots[7])
        self._reference, self._dut = _sensor(truth.reference), _sensor(truth.dut)
        self._reference_place, self._reference_turned = np.array(truth.reference_place_m), np.eye(3)
        tilt = sum((np.array(f.tilt_cage_deg) for f in self._faults), np.zeros(3))
        self._axis = rotation_vector(np.radians(tilt)) @ unit(truth.platform.axis_cage)
        self._across = np.cross(self._axis, [0.36, 0.48, 0.8])
        self._mounted: Steps[Array] = Steps(np.eye(3))
        self._there = Steps(True)

    # what hands do

    def mount(self, t_s: float, body_from_cage: Sequence[Sequence[float]]) -> None:
        """Mount the DUT with this attitude (3, 3) at platform angle zero, as well as hands can."""
        tilt = sum((np.array(f.tilt_body_deg) for f in self._faults), np.zeros(3))
        tilt = tilt + self._truth.mounting_error_deg * self._rng_hands.normal(size=3)
        self._mounted.set(t_s, rotation_vector(np.radians(tilt)) @ np.asarray(body_from_cage, dtype=float))
        self._there.set(t_s, True)

    def take_away(self, t_s: float) -> None:
        """Take the DUT off the platform, so far that the reference sees nothing of it; `mount` brings it back."""
        self._there.set(t_s, False)

    def switch_mode(self, t_s: float, mode: str) -> None:
        """Switch the DUT's power mode."""
        self.mode.set(t_s, mode)

    def turn_dial(self, t_s: float, angle_deg: float) -> None:
        """Turn a platform without a motor, as well as its dial is read."""
        if width := self._truth.platform.misreading_deg:
            angle_deg += float(self._rng_hands.uniform(-width, width))
        self.platform.place(t_s, angle_deg)

    def switch_load(self, t_s: float, load: str, on: bool) -> None:
        """Switch a load of the spacecraft: the channel "i_<load>"."""
        self.housekeeping.force(t_s, load if load.startswith("i_") else f"i_{load}", on)

    def move_reference(self, place_m: Sequence[float]) -> None:
        """Put the reference there, from the DUT's place in C, as well as hands can."""
        missed = self._truth.placing_error_m * self._rng_hands.normal(size=3) if self._truth.placing_error_m else 0.0
        self._reference_place = np.asarray(place_m, dtype=float) + missed

    def turn_reference(self, sensor_from_home: Sequence[Sequence[float]]) -> None:
        """Turn the reference (3, 3) from how it stands at home."""
        self._reference_turned = np.asarray(sensor_from_home, dtype=float)

    def reverse_half(self, t_s: float, axis: str, reversed_: bool) -> None:
        """Swap the leads of the half towards + of this coil's pair, or put them back."""
        self._opposed[AXES.index(axis)].set(t_s, reversed_)

    # what there is

    def moment(self, t_s: Array, channels: Mapping[str, Array] | None = None) -> Moment:
        """The lab at the times `t_s` (n,); `channels` where the housekeeping of these times is known already."""
        currents = self._currents(t_s)
        angle = self.platform.at(t_s)
        attitude = self._attitude(t_s, angle)
        mode = np.asarray(self.mode.values, dtype=np.str_)[self.mode.index(t_s)]
        field = self.ambient.slow(t_s) + self._of_coils(t_s, currents, np.array(self._truth.dut_place_m))
        channels = channels or self.housekeeping.true(t_s)
        there = np.asarray(self._there.values)[self._there.index(t_s)]
        return Moment(t_s, angle, field, attitude, currents, self.platform.busy(t_s), channels, mode, there)

    def reference_nT(self, t_s: Array) -> Array:
        """Readings (n, 3) of the reference in its own unit."""
        sensor, currents = self._reference, self._currents(t_s)
        field = self.ambient.slow(t_s) + self._of_coils(t_s, currents, self._reference_place)
        field = field + self.ambient.mains(t_s, sensor.bandwidth_hz)
        for effect in self._reference_effects:
            field = field + effect(self.moment(t_s), self._reference_place)
        return sensor.read(field @ self._reference_turned.T, self._rng_reference)

    @property
    def reference_nT_per_unit(self) -> float:
        """What one of the reference's own units is."""
        return self._truth.reference.nT_per_unit

    def dut_reading(self, t_s: Array) -> tuple[Array, dict[str, Array]]:
        """Readings (n, 3) of the DUT in its own unit, and the housekeeping (n,) that it sends with them."""
        true, late_s = self.housekeeping.true(t_s), sum(f.late_s for f in self._faults)
        sent = self.housekeeping.with_noise(true)
        moment = self.moment(t_s - late_s) if late_s else self.moment(t_s, true)
        field = moment.field_cage + self.ambient.mains(moment.t_s, self._dut.bandwidth_hz)
        for rig in self._rig_effects:
            field = field + rig(moment)
        seen = moment.into_body(field)
        for effect in self._sensor_effects:
            seen = seen + effect(moment, seen)
        reading = self._dut.read(seen, self._rng_dut)
        return self._corrupt(reading), sent

    def _of_coils(self, t_s: Array, currents_A: Array, place_m: Array) -> Array:
        """What the coils make (n, 3) [nT, C] at `place_m` (3,), each pair with both halves alike or opposed."""
        field = self.coil_field.at(currents_A, place_m)
        opposed = np.column_stack([np.asarray(steps.values)[steps.index(t_s)] for steps in self._opposed])
        if opposed.any():
            wires = self.coil_field.wires
            change = wires.at(tuple(place_m), True) - wires.at(tuple(place_m), False)
            field = field + (currents_A * opposed) @ change.T
        return np.asarray(field)

    def _currents(self, t_s: Array) -> Array:
        return np.column_stack([self.coils[axis].at(t_s) for axis in AXES])

    def _corrupt(self, reading: Array) -> Array:
        nominal, step = self._dut.nT_per_unit, self._dut.step_units
        for fault in self._faults:
            reading = fault.corrupt(np.clip(reading * nominal, -fault.range_nT, fault.range_nT)) / nominal
        return np.asarray(np.round(reading / step) * step)

    def _attitude(self, t_s: Array, angle_deg: Array) -> Array:
        """Body from cage (n, 3, 3): the mounting at angle zero, the platform's turn, its wobble once a turn."""
        turned = rotation(self._axis, -np.radians(angle_deg))
        wobble = np.radians(self._truth.platform.wobble_deg) * np.sin(np.radians(angle_deg))
        mounted = np.asarray(self._mounted.values)[self._mounted.index(t_s)]
        return np.asarray(mounted @ rotation(unit(self._across), wobble) @ turned)


def _sensor(truth: SensorTruth) -> Sensor:
    matrix = response(*(np.array(v) for v in (truth.scale, truth.nonorthogonality_deg, truth.misalignment_deg)))
    return Sensor(
        matrix,
        np.array(truth.bias_nT),
        truth.noise_nT,
        truth.nT_per_unit,
        truth.step_units,
        truth.range_nT,
        truth.bandwidth_hz,
    )
