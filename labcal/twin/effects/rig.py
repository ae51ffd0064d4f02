"""Effects of the rig: what is at the DUT and not at the reference, and what ails the reference."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.twin.moment import Moment

Array = NDArray[np.float64]
Rng = np.random.Generator
RigEffect = Callable[[Moment], Array]  # field at the DUT beside the coils' and the place's (n, 3) [nT, C]
ReferenceEffect = Callable[[Moment, Array], Array]  # (moment, reference place (3,)) -> too much (n, 3) [nT, C]
Three = Sequence[float]


def field_gradient(
    _: Rng, nT_per_m: Sequence[Three] | None = None, place_body_m: Three = (0.08, 0.05, 0.0)
) -> RigEffect:
    """The DUT is off the centre by `place_body_m`, carried round by the platform, in a gradient of the building.

    `nT_per_m` (3, 3) is symmetric and without trace, as a field without sources is.
    """
    gradient = np.array(nT_per_m or [[3000.0, 1200.0, -800.0], [1200.0, -1800.0, 900.0], [-800.0, 900.0, -1200.0]])
    return lambda moment: moment.into_cage(np.asarray(place_body_m)) @ gradient.T


def cage_field(_: Rng, nT: Three = (250.0, -180.0, 120.0)) -> RigEffect:
    """Motor and carriage magnetise the DUT's place, fixed in C."""
    return lambda moment: np.tile(np.asarray(nT, dtype=float), (len(moment.t_s), 1))


def motor_field(_: Rng, nT: Three = (150.0, 90.0, -60.0)) -> RigEffect:
    """The motor's field while it runs, fixed in C."""
    return lambda moment: np.outer(moment.motor_on, nT)


def reference_drift(_: Rng, nT_per_h: Three = (400.0, -250.0, 300.0)) -> ReferenceEffect:
    """The reference's own offset creeps."""
    return lambda moment, place: np.outer(moment.t_s / 3600, nT_per_h)


def dut_dipole_at_reference(
    _: Rng, moment_Am2: Three = (0.02, -0.01, 0.03), induced_Am2_per_T: Sequence[Three] | None = None
) -> ReferenceEffect:
    """The DUT's own magnetic moment p + X b at the reference's place: p fixed in B, X (3, 3) times the field at it.

    B = µ0 / 4π · (3 (m·r̂) r̂ − m) / r³ (Jackson, Classical Electrodynamics, 3rd ed., eq. 5.56).
    """
    permanent, susceptibility = np.asarray(moment_Am2, dtype=float), np.asarray(induced_Am2_per_T or np.zeros((3, 3)))

    def effect(moment: Moment, place: Array) -> Array:
        r = float(np.linalg.norm(place))
        along = place / r
        body = permanent + 1e-9 * moment.into_body(moment.field_cage) @ susceptibility.T
        m = np.einsum("nji,nj->ni", moment.body_from_cage, body) * moment.dut_there[:, None]
        return np.asarray(1e9 * 1e-7 * (3 * np.outer(m @ along, along) - m) / r**3)

    return effect


RIG: dict[str, Callable[..., RigEffect]] = {
    "field-gradient": field_gradient,
    "cage-field": cage_field,
    "motor-field": motor_field,
}
REFERENCE: dict[str, Callable[..., ReferenceEffect]] = {
    "reference-drift": reference_drift,
    "dut-dipole-at-reference": dut_dipole_at_reference,
}
