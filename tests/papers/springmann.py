"""Tables 1 and 2 of Springmann & Cutler 2011 on simulated data like RAX's: magnitudes, four panel currents, beacons.

One orbit at 1 Hz (650 km, 72°, 2010-12-01), tumbling; each panel's current follows the sun on it and is nought in
eclipse; the power system draws a pulse of two seconds every 20 s. The sensors are those of the paper's calibration 3;
the currents' coefficients, which it does not print, are scaled so that calibration 1 leaves about what it prints.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass
from datetime import datetime

import numpy as np
from numpy.typing import NDArray
from orbit import EARTH_KM, circular, field

from labcal.fit.scalar import foster_elkaim, telemetry
from labcal.fit.scalar.scalar_run import Scalars
from labcal.fit.scalar.telemetry import TelemetryEstimate
from labcal.geometry import rotation

Array = NDArray[np.float64]
PANELS, EPS = ("i_plus_x", "i_minus_x", "i_plus_y", "i_minus_y"), "i_eps"
NAMES = ("a", "b", "c", "x0, µT", "y0, µT", "z0, µT", "ρ, °", "φ, °", "λ, °")
ALTITUDE_KM = 650.0


@dataclass(frozen=True, slots=True)
class Sensor:
    """A magnetometer of the paper: its table, its printed calibration 3, noise [nT], coefficients [nT/A], rms [nT]."""

    name: str
    table: int
    printed: tuple[float, ...]  # as NAMES
    noise_nT: float
    panel_nT_per_A: float
    eps_nT_per_A: float
    printed_rms_nT: tuple[float, float, float]


SENSORS = (
    Sensor("PNI", 1, (0.890, 0.910, 1.130, -0.687, 9.909, -7.701, -1.039, -3.974, 5.019), 166.0, 4400.0, 140.0,
           (903, 176, 174)),
    Sensor("IMU", 2, (0.886, 0.903, 1.052, -15.106, -3.527, 15.933, -0.312, -1.975, -1.779), 209.0, 10080.0, 1140.0,
           (2017, 290, 225)),
)  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Flight:
    """Readings (n, 3) and magnitudes (n,) [nT], currents (n, 5) [A] in the order of PANELS then EPS, true s (5, 3)."""

    reading: Array
    magnitude: Array
    current: Array
    s: Array


def sensor_matrix(sensor: Sensor) -> tuple[Array, Array]:
    """T (3, 3) of (5) to (7) and the offsets (3,) [nT]."""
    a, b, c, x0, y0, z0, *angles = sensor.printed
    rho, phi, lam = np.radians(angles)
    along_z = [np.sin(lam), np.sin(phi) * np.cos(lam), np.cos(phi) * np.cos(lam)]
    T = np.array([[a, 0, 0], [b * np.sin(rho), b * np.cos(rho), 0], c * np.array(along_z)])
    return T, 1e3 * np.array([x0, y0, z0])


def fly(sensor: Sensor, seed: int) -> Flight:
    """Simulate an orbit by (12) to (14)."""
    random = np.random.default_rng([seed, sensor.table])
    t = np.arange(5850.0)
    place = {"altitude_km": ALTITUDE_KM, "inclination_deg": 72, "node_deg": 40, "latitude_deg": 0}
    position, _ = circular(t, **place)
    attitude = rotation([0, 0, 1], 2 * np.pi * t / 400) @ rotation([1, 0, 0], 2 * np.pi * t / 1130 + 0.4)
    B = np.einsum("nij,nj->ni", attitude, field(t, position, ALTITUDE_KM, datetime(2010, 12, 1)))
    current = np.column_stack([panels(attitude, position), beacons(t, random)])
    T, offset = sensor_matrix(sensor)
    size = np.repeat([sensor.panel_nT_per_A, sensor.eps_nT_per_A], [4, 1])
    direction = np.random.default_rng(sensor.table).standard_normal((5, 3))
    s = size[:, None] * direction / np.linalg.norm(direction, axis=1, keepdims=True)
    noise = sensor.noise_nT * random.standard_normal(B.shape)
    return Flight(B @ T.T + offset + current @ s + noise, np.linalg.norm(B, axis=1), current, s)


def panels(attitude: Array, position: Array) -> Array:
    """Currents (n, 4) [A] of the panels on the faces +x, −x, +y, −y: 0.5 A in full sun."""
    sun = np.array([1.0, 0.2, -0.1]) / np.linalg.norm([1.0, 0.2, -0.1])
    along = position @ sun
    edge = -np.sqrt(1 - (EARTH_KM / (EARTH_KM + ALTITUDE_KM)) ** 2)
    lit = (along > edge)[:, None]
    in_body = attitude @ sun
    return 0.5 * lit * np.maximum(0, np.column_stack([in_body[:, 0], -in_body[:, 0], in_body[:, 1], -in_body[:, 1]]))


def beacons(t: Array, random: np.random.Generator) -> Array:
    """Current (n,) [A] drawn from the power system: a slow part and a pulse of two seconds every 20 s."""
    return 0.3 + 0.02 * random.standard_normal(len(t)) + 1.0 * (t % 20 < 2)


def calibrate(flight: Flight, noise_nT: float, columns: int) -> tuple[TelemetryEstimate, float]:
    """Calibration 1, 2 or 3 of the paper: with the first `columns` currents; and its rms [nT], section 4.1."""
    current = flight.current[:, :columns]
    seen = Scalars(flight.reading, flight.magnitude, noise_nT**2 * np.eye(3))
    _, found = telemetry.settle_currents(seen, current)
    K = np.eye(3) + found.affine.D
    B = flight.reading @ K - found.affine.bias - current @ found.e
    return found, float(np.sqrt(np.mean((np.linalg.norm(B, axis=1) - flight.magnitude) ** 2)))


def in_paper_units(axes: foster_elkaim.SensorAxes) -> Array:
    """The nine numbers (9,) in the order and units of NAMES."""
    return np.array(astuple(axes)) * np.repeat([1.0, 1e-3, 180 / np.pi], 3)


def section(seeds: int = 20) -> str:
    """The section of docs/papers.md."""
    parts = [part(sensor, seeds) for sensor in SENSORS]
    return "\n".join([HEAD.format(last=seeds - 1), *parts])


def part(sensor: Sensor, seeds: int) -> str:
    """One of the two tables: parameters of seed 0, rms, and how far the estimates are off over the seeds."""
    flight = fly(sensor, 0)
    calibrations = [calibrate(flight, sensor.noise_nT, columns) for columns in (0, 4, 5)]
    values = [in_paper_units(foster_elkaim.parameters(found.affine)) for found, _ in calibrations]
    u = in_paper_units(foster_elkaim.parameter_uncertainty(calibrations[2][0].affine))
    rows = [
        f"| {name} | {truth:g} | {one:.3f} | {two:.3f} | {three:.4f} ± {spread:.4f} |"
        for name, truth, one, two, three, spread in zip(NAMES, sensor.printed, *values, u, strict=True)
    ]
    measured = " | ".join(f"**{rms:.0f}**" for _, rms in calibrations)
    printed = " | ".join(f"{rms}" for rms in sensor.printed_rms_nT)
    off = np.sqrt(np.mean([normalised(sensor, seed) ** 2 for seed in range(seeds)]))
    return TABLE.format(
        sensor=sensor,
        rows="\n".join(rows),
        measured=measured,
        printed=printed,
        off=np.sqrt(np.mean(off**2)),
        seeds=seeds,
    )


def normalised(sensor: Sensor, seed: int) -> Array:
    """Error over standard uncertainty of calibration 3's nine parameters (9,)."""
    found, _ = calibrate(fly(sensor, seed), sensor.noise_nT, 5)
    error = in_paper_units(foster_elkaim.parameters(found.affine)) - np.array(sensor.printed)
    return error / in_paper_units(foster_elkaim.parameter_uncertainty(found.affine))


HEAD = """## Springmann & Cutler 2011, Tables 1 and 2

Simulated data like RAX's (one orbit at 650 km and 72°, 1 Hz, tumbling): the sensors are the paper's calibration 3, the
coefficients of the currents are ours, scaled so that calibration 1 leaves about what the paper prints. Calibration 1
knows no current, 2 the four panels', 3 the power system's as well. Seeds 0 to {last}.
"""

TABLE = """### Table {sensor.table}: {sensor.name}

| parameter | truth (printed, calibration 3) | calibration 1 | calibration 2 | calibration 3 |
|---|---|---|---|---|
{rows}
| rms of the magnitude, nT, measured | | {measured} |
| rms of the magnitude, nT, printed | | {printed} |

Calibration 3 over {seeds} seeds: error over standard uncertainty {off:.2f} rms (1 is expected).
"""
