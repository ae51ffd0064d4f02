"""The geomagnetic field along a circular orbit, for the simulations of two papers."""

from __future__ import annotations

from datetime import datetime

import numpy as np
import ppigrf
from numpy.typing import NDArray

Array = NDArray[np.float64]
EARTH_KM, MU, EARTH_RATE = 6371.2, 398_600.4418, 7.292_115_9e-5


def circular(
    t_s: Array, *, altitude_km: float, inclination_deg: float, node_deg: float, latitude_deg: float
) -> tuple[Array, Array]:
    """Unit position and unit velocity (n, 3), inertial; `latitude_deg` is the argument of latitude at the start.

    The inertial x axis is Greenwich's at t = 0, so that `node_deg` is the node's longitude then.
    """
    rate = np.sqrt(MU / (EARTH_KM + altitude_km) ** 3)
    u, node, i = np.radians(latitude_deg) + rate * t_s, np.radians(node_deg), np.radians(inclination_deg)
    along = np.array([np.cos(node), np.sin(node), 0.0])
    across = np.array([-np.sin(node) * np.cos(i), np.cos(node) * np.cos(i), np.sin(i)])
    c, s = np.cos(u)[:, None], np.sin(u)[:, None]
    return c * along + s * across, c * across - s * along


def field(t_s: Array, position: Array, altitude_km: float, date: datetime) -> Array:
    """IGRF (n, 3) [nT], inertial, at unit positions (n, 3)."""
    longitude = np.arctan2(position[:, 1], position[:, 0])
    latitude = np.arcsin(position[:, 2])
    at = (90 - np.degrees(latitude), np.degrees(longitude - EARTH_RATE * t_s))
    radial, south, east = (np.ravel(b) for b in ppigrf.igrf_gc(EARTH_KM + altitude_km, *at, date))
    sin, cos = np.sin(latitude), np.cos(latitude)
    to_south = np.stack([sin * np.cos(longitude), sin * np.sin(longitude), -cos], axis=1)
    to_east = np.stack([-np.sin(longitude), np.cos(longitude), np.zeros_like(longitude)], axis=1)
    return radial[:, None] * position + south[:, None] * to_south + east[:, None] * to_east
