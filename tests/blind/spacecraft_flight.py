"""Where the spacecraft of `spacecraft.py` turns, and what its housekeeping truly does."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import interp1d
from scipy.signal import lfilter
from scipy.spatial.transform import Rotation, Slerp

CLOCK = 0.2  # s, the step of everything on board


def loguniform(rng, a, b):
    """Between a and b, uniform in the logarithm."""
    return float(np.exp(rng.uniform(*np.log([a, b]))))


@dataclass(frozen=True)
class Stretch:
    """One stretch of time: rows at `t`, the field in the cage's or the orbit's frame, and the body's attitude."""

    name: str
    t: np.ndarray
    outside: np.ndarray  # (n, 3) nT
    into_body: Rotation  # n of them
    mode: str
    fresh: bool
    axis: np.ndarray | None = None  # of the body, where it is turned about one
    angle_deg: np.ndarray | None = None

    @property
    def body(self):
        """The field in the body (n, 3)."""
        return self.into_body.apply(self.outside)


def tumbling(rng, t):
    """Attitudes of a free body: Euler's equations, with inertias and rates drawn."""
    inertia = rng.uniform(0.5, 1.5, 3)
    spin = rng.normal(size=3)
    spin *= np.radians(loguniform(rng, 1.0, 6.0)) / np.linalg.norm(spin)

    def euler(_, y):
        q, w = y[:4], y[4:]
        quarter = 0.5 * np.array([q[3] * w[0] + q[1] * w[2] - q[2] * w[1], q[3] * w[1] + q[2] * w[0] - q[0] * w[2],
                                  q[3] * w[2] + q[0] * w[1] - q[1] * w[0], -q[:3] @ w])  # fmt: skip
        return np.concatenate([quarter, -np.cross(w, inertia * w) / inertia])

    start = np.concatenate([Rotation.random(random_state=rng).as_quat(), spin])
    coarse = np.arange(0, t[-1] - t[0] + 2, 1.0)
    y = solve_ivp(euler, (0, coarse[-1]), start, t_eval=coarse, rtol=1e-7, atol=1e-9).y
    return Slerp(coarse, Rotation.from_quat(y[:4].T))(t - t[0]).inv()


def orbit_field(rng, t):
    """A dipole field as a satellite meets it (n, 3): the argument of latitude runs on, the size changes."""
    u = 2 * np.pi * t / rng.uniform(1500, 5600) + rng.uniform(0, 6.28)
    tilt = rng.uniform(0.3, 1.6)
    radial = np.stack([np.cos(u), np.sin(u) * np.cos(tilt), np.sin(u) * np.sin(tilt)], axis=1)
    return rng.uniform(22e3, 30e3) * (3 * radial * radial[:, 2:] - [0, 0, 1.0])


def in_cage(rng, name, t, axis, mode, fresh):
    """A turn about one axis in a field that is held, the rate never the same."""
    wave = 1 + rng.uniform(0, 0.6) * np.sin(np.linspace(0, rng.uniform(3, 15), len(t)) + rng.uniform(0, 6))
    angle = np.cumsum(wave) / np.sum(wave) * np.radians(rng.uniform(380, 800)) * rng.choice([-1, 1])
    mount = Rotation.align_vectors([axis], [[0, 0, 1.0]])[0]
    turned = Rotation.from_rotvec(np.outer(-angle - rng.uniform(0, 6.28), axis)) * mount
    field = rng.normal(size=3) * [1, 1, 0.8]
    field *= loguniform(rng, 18e3, 52e3) / np.linalg.norm(field)
    outside = field + np.outer(t - t[0], rng.normal(0, 0.02, 3))
    return Stretch(name, t, outside, turned, mode, fresh, axis, np.degrees(angle) % 360)


def stretches(rng, how, modes):
    """The run and, between its stretches, fresh ones: `how` is cage, tumble or scalar."""
    count = int(rng.integers(6, 9)) if how == "cage" else int(rng.integers(4, 6))
    rows = int(rng.integers(60, 150)) if how == "cage" else int(rng.integers(130, 260))
    step, out, now = loguniform(rng, 0.4, 2.0), [], 10.0
    for k in range(2 * count - 1):
        fresh = k % 2 == 1
        n = rows // 3 if fresh else rows
        t = now + step * np.arange(n) + np.sort(rng.uniform(0, 0.2 * step, n))
        mode = modes[int(rng.integers(len(modes)))]
        if how == "cage":
            axis = np.eye(3)[k // 2 % 3] if not fresh else (v := rng.normal(size=3)) / np.linalg.norm(v)
            out.append(in_cage(rng, f"c{k}", t, axis, mode, fresh))
        else:
            out.append(Stretch(f"o{k}", t, orbit_field(rng, t), tumbling(rng, t), mode, fresh))
        now = t[-1] + rng.uniform(8, 40)
    return out


def pulses(rng, clock, dwell, levels):
    """A signal (m,) that jumps between levels, each held for an exponential time."""
    edges = np.cumsum(rng.exponential(dwell, int(4 * clock[-1] / dwell) + 20))
    picks = rng.integers(0, len(levels), len(edges) + 1)
    return np.asarray(levels, dtype=float)[picks[np.searchsorted(edges, clock)]]


def lagged(clock_signal, tau):
    """A first-order response on board's clock, in its steady state at the start."""
    keep = np.exp(-CLOCK / tau)
    return lfilter([1 - keep], [1, -keep], clock_signal - clock_signal[0]) + clock_signal[0]


class Board:
    """Signals on the board's own clock, each with what telemetry makes of it."""

    def __init__(self, rng, legs):
        self.rng, self.legs = rng, legs
        self.clock = np.arange(-20.0, legs[-1].t[-1] + 20, CLOCK)
        self.t = np.concatenate([leg.t for leg in legs])
        self.true, self.told, self.decoys = {}, {}, []

    def sun(self):
        """The sun (m, 3) in the body on the board's clock; between stretches it is as the nearest row had it."""
        body = np.concatenate([leg.into_body.apply(self.lamp) for leg in self.legs])
        return interp1d(self.t, body, axis=0, kind="nearest", fill_value="extrapolate")(self.clock)

    @property
    def lamp(self):
        """Where the sun, or the lamp in the hall, stands."""
        return np.array([0.48, -0.6, 0.64])

    def at_rows(self, name):
        """A true signal at the rows (n,)."""
        return np.interp(self.t, self.clock, self.true[name])

    def telemetry(self, name, values, unit, quantity, quantum, role="dut", decoy=False, plain=False):
        """Keep a signal, and what the ground gets: slow, late, in steps, drawn straight between its samples."""
        rng = self.rng
        self.true[name] = values
        period, late = loguniform(rng, 0.5, 10.0), loguniform(rng, 0.03, 2.0)
        if plain:
            period, late = loguniform(rng, 0.3, 1.0), 0.0
        at = np.arange(self.clock[0] + 5, self.clock[-1], period)
        samples = np.round(np.interp(at - late, self.clock, values) / quantum) * quantum
        self.told[name] = (np.interp(self.t, at, samples), unit, quantity, role)
        self.decoys += [name] if decoy else []


def panel_currents(board, count):
    """Strings of cells on the faces, lit as the body turns and shunted by a regulator; and the bus that adds them."""
    rng, sun, total = board.rng, board.sun(), 0.0
    plain = rng.random() < 0.5
    faces = [s * np.eye(3)[k] for k in range(3) for s in (1, -1)]
    for k in range(count):
        lit = np.clip(sun @ faces[k], 0, None) if rng.random() < 0.6 else 0.7
        on = pulses(rng, board.clock, loguniform(rng, 6, 40), [0, 0.5, 1])
        amperes = rng.uniform(0.3, 0.9) * (0.1 + lit) * on + rng.normal(0, 0.003, len(board.clock))
        board.telemetry(f"i_panel{k + 1}", amperes, "A", "current", 0.004, plain=plain)
        total = total + amperes
    if rng.random() < 0.6:
        board.told["i_bus"] = (
            sum(v[0] for c, v in board.told.items() if c.startswith("i_panel")),
            "A",
            "current",
            "dut",
        )
    return [f"i_panel{k + 1}" for k in range(count)]


def torquers(board):
    """Rods that are pulsed one way and the other."""
    names = [f"i_rod_{axis}" for axis in "xyz"[: int(board.rng.integers(1, 4))]]
    for name in names:
        strong = loguniform(board.rng, 0.05, 0.4)
        amperes = pulses(board.rng, board.clock, loguniform(board.rng, 5, 30), [-strong, 0, 0, strong])
        board.telemetry(name, lagged(amperes, loguniform(board.rng, 0.05, 0.8)), "A", "current", 0.002)
    return names


def thermostat(board):
    """A heater that a thermostat switches: its current, and a temperature that follows it and the sun's slow change."""
    rng, clock = board.rng, board.clock
    tau, strong, band = loguniform(rng, 80, 900), rng.uniform(15, 40), rng.uniform(0.5, 4)
    outside = -5 + 12 * np.sin(2 * np.pi * clock / rng.uniform(700, 4000) + rng.uniform(0, 6))
    T, on, wanted = outside[0] + strong / 2, True, rng.uniform(5, 12)
    kept, heater = np.empty(len(clock)), np.empty(len(clock))
    for i, cold in enumerate(outside):
        on = (wanted + band if on else wanted - band) > T
        T += CLOCK / tau * (cold + strong * on - T)
        kept[i], heater[i] = T, on
    board.telemetry("i_heater", 0.6 * heater, "A", "current", 0.01)
    board.telemetry("t_sensor", kept, "degC", "temperature", loguniform(rng, 0.02, 0.4))


def battery(board):
    """A bus voltage that sags and is charged."""
    rng, clock = board.rng, board.clock
    sag = lagged(pulses(rng, clock, loguniform(rng, 30, 200), [0, 0.3, 0.5, 0.8]), loguniform(rng, 10, 90))
    board.telemetry("v_bus", 8.2 - sag, "V", "voltage", 0.01)


def decoys(board, count):
    """Channels of things that do nothing to the sensor and follow nothing that does."""
    rng, clock = board.rng, board.clock
    walk = np.cumsum(rng.normal(size=len(clock))) * np.sqrt(CLOCK)
    choices = [
        ("i_radio", pulses(rng, clock, loguniform(rng, 5, 60), [0.05, 0.05, 1.1]), "A", "current", 0.01),
        ("t_tracker", 12 + 0.4 * lagged(walk, 20.0), "degC", "temperature", 0.1),
        ("p_tank", 1800 + 5 * np.sin(clock / loguniform(rng, 20, 200)) + walk, "hPa", "pressure", 1.0),
        ("n_frames", np.round(40 + 10 * pulses(rng, clock, 9.0, [0, 1, 3])), "1", "count", 1.0),
        ("v_ref", 2.5 + 0.002 * rng.normal(size=len(clock)), "V", "voltage", 0.0005),
    ]
    for k in rng.permutation(len(choices))[:count]:
        board.telemetry(*choices[k], decoy=True)
