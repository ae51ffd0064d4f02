"""The bench of `sensor_laws.py`: legs of rotation and of swept coils, an oven, a late view of the field."""

import math
from types import SimpleNamespace

import numpy as np

FINE = 6  # steps of the world for one row
REST = 12.0  # s, at rest before and after a leg


def octave(rng, low, high):
    """A number whose logarithm is uniform."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def spin_matrix(axis, angle):
    """Active right-handed rotations (n, 3, 3) by Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.atleast_1d(angle)[:, None, None]
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)


def any_axis(rng):
    """A direction, none preferred."""
    z, phi = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return np.array([r * math.cos(phi), r * math.sin(phi), z])


def taking(a, b):
    """A rotation matrix that takes the unit vector a to b."""
    n = np.cross(a, b)
    s = np.linalg.norm(n)
    n = n / s if s > 1e-9 else np.cross(a, [0.3, 0.5, -0.81])
    return spin_matrix(n / np.linalg.norm(n), math.atan2(s, float(np.dot(a, b))))[0]


def spin_leg(rng, when, seconds, platform, axis, size, share):
    """Forth and back at two rates, over a share of one to two turns: field and angle as functions of time."""
    there = rng.uniform(0.35, 0.65) * seconds
    reach, rough = share * math.radians(rng.uniform(360, 720)) * rng.choice([-1, 1]), rng.uniform(0, 0.15)
    field, slope, mount = any_axis(rng) * size, rng.normal(0, 0.01, 3), taking(platform, axis)
    start = rng.uniform(0, 2 * math.pi)

    def angle(t):
        u = np.clip(t - when, 0, seconds)
        u = np.where(u < there, u / there, (seconds - u) / (seconds - there))
        return reach * (u * u * (3 - 2 * u) * (1 - rough) + rough * np.sin(math.pi * u / 2) ** 2)

    def world(t):
        cage = field + slope * (t - when)[:, None]
        return cage, np.einsum("nij,nj->ni", spin_matrix(axis, -angle(t) - start) @ mount, cage)

    segment = {"kind": "rotation", "axis_body": axis.tolist(), "axis_cage": platform.tolist()}
    return SimpleNamespace(world=world, angle=angle, segment=segment, axis=axis)


def sweep_leg(rng, when, seconds, size):
    """At rest, one coil direction swept up and down with an amplitude that grows or shrinks."""
    along, still = any_axis(rng) * size, any_axis(rng) * rng.uniform(0.05, 0.4) * size
    turns, change = rng.uniform(2, 5), rng.uniform(-0.6, 0.6)
    attitude = spin_matrix(any_axis(rng), rng.uniform(0, math.pi))[0]

    def world(t):
        u = np.clip((t - when) / seconds, 0, 1)
        wave = np.sin(2 * math.pi * turns * u) * (1 + change * (u - 0.5))
        cage = still + wave[:, None] * along
        return cage, cage @ attitude.T

    segment = {"kind": "static", "body_from_cage": np.round(attitude, 12).tolist()}
    return SimpleNamespace(world=world, angle=None, segment=segment, axis=None)


def session(rng, slow):
    """Legs of the run and fresh ones between, with rows at one rate."""
    period, size = octave(rng, 0.25, 1.5), rng.uniform(30e3, 55e3)
    platform = any_axis(rng)
    rows = int(rng.integers(60, 150)) * (2 if slow and period < 0.6 else 1)
    kinds = ["spin"] * int(rng.integers(5, 8)) + ["sweep"] * int(rng.integers(0, 3) if not slow else 0)
    legs, now = [], 0.0
    for k, kind in enumerate(rng.permutation(kinds)):
        axis = np.eye(3)[k % 3] if rng.random() < 0.7 else any_axis(rng)
        for fresh, count in ((False, rows), (True, rows // 2)):
            now += REST + rng.uniform(5, 60)
            seconds = (count - 1) * period
            if kind == "spin" or fresh:
                about, strong = (any_axis(rng) if fresh else axis), rng.uniform(0.4, 0.9 if fresh else 1.0) * size
                leg = spin_leg(rng, now, seconds, platform, about, strong, 0.5 if fresh else 1.0)  # at the same rates
            else:
                leg = sweep_leg(rng, now, seconds, size * 1.05)
            leg.t, leg.fresh, leg.name = now + period * np.arange(count), fresh, f"{kind}{k}{'f' * fresh}"
            leg.zero = rng.uniform(0, 360)
            legs.append(leg)
            now += seconds
    return legs[:-1], period, now


def oven(rng, end):
    """Temperatures over time: heated and let cool, more than once; the body follows the heater late."""
    grid = np.arange(-REST, end + 2 * REST, 0.5)
    tau, heat = octave(rng, 60, 900), rng.uniform(6, 25)
    edges = np.cumsum(rng.exponential(octave(rng, 120, 500), 400))
    wanted = heat * (np.searchsorted(edges, grid) % 2)
    warm, out = 0.0, np.empty_like(grid)
    for i, w in enumerate(wanted):
        warm += (w - warm) * 0.5 / tau
        out[i] = warm
    return grid, 20 + out + rng.normal(0, 4)


def stray(rng, grid):
    """A slow quantity of nobody's, sum of a walk and a wave."""
    walk = np.cumsum(rng.normal(size=len(grid)))
    wave = np.sin(2 * math.pi * grid / octave(rng, 40, 900) + rng.uniform(0, 6))
    return (walk - walk.mean()) / (walk.std() + 1e-9) + rng.uniform(0, 1.5) * wave


class Bench:
    """The session's legs as rows, and what the laws ask for."""

    def __init__(self, rng, slow):
        self.rng = rng
        self.legs, self.period, self.end = session(rng, slow)
        self.grid, self.warmth = oven(rng, self.end)
        self.t = np.concatenate([leg.t for leg in self.legs])
        self.leg_of = np.repeat(np.arange(len(self.legs)), [len(leg.t) for leg in self.legs])
        self.fresh = np.array([leg.fresh for leg in self.legs])[self.leg_of]
        self.cage, self.body = (np.concatenate(v) for v in zip(*(leg.world(leg.t) for leg in self.legs), strict=True))
        self.T = np.interp(self.t, self.grid, self.warmth)
        self.map = np.eye(3) + rng.normal(0, 0.04, (3, 3))
        self.zero = rng.normal(0, 4000, 3)
        self.late = None  # (delay poles s, clock offset s, clock drift)
        self.of_unknown_side = -1  # the fresh leg of which the run cannot tell whether a power cycle was before it

    def fine(self):
        """Times of each leg in the world's own steps, from rest to rest."""
        step = self.period / FINE
        return [np.arange(leg.t[0] - REST, leg.t[-1] + REST, step) for leg in self.legs]

    def seen(self, late):
        """The field (n, 3) in the reading of each row: through two poles, at the clock's wrong time."""
        if late is None:
            return self.body
        poles, offset, drift = late
        out = []
        for leg, t in zip(self.legs, self.fine(), strict=True):
            field = leg.world(t)[1]
            for tau in poles:
                field = one_pole(field, t[1] - t[0], tau)
            at = leg.t - offset - drift * leg.t
            out.append(np.stack([np.interp(at, t, f) for f in field.T], axis=1))
        return np.concatenate(out)

    def left(self, effect):
        """Rms of one component, nT, that map, zero and starting angles leave of an effect (n, 3) in the run."""
        use = ~self.fresh
        b, e = self.body[use], np.linalg.solve(self.map, effect[use].T).T
        n = len(b)
        blocks = np.zeros((n, 3, 12 + len(self.legs)))
        for row in range(3):
            blocks[:, row, 3 * row : 3 * row + 3] = b
            blocks[:, row, 9 + row] = 1e4
        for k, leg in enumerate(self.legs):
            if leg.axis is not None:
                blocks[:, :, 12 + k] = np.cross(leg.axis, b) * (self.leg_of[use] == k)[:, None]
        A = blocks.reshape(3 * n, -1)
        A = A[:, np.any(A != 0, axis=0)]
        u = np.linalg.svd(A / np.linalg.norm(A, axis=0), full_matrices=False)[0]
        return float(np.std(e.ravel() - u @ (u.T @ e.ravel())))


def one_pole(field, step, tau):
    """A first-order low pass (n, 3), starting at rest; exact for what is straight between its steps."""
    keep, out, y = math.exp(-step / tau), np.empty_like(field), field[0]
    ahead = 1 - (1 - keep) * tau / step
    for i, rise in enumerate(np.diff(field, axis=0, prepend=field[:1])):
        y = keep * y + (1 - keep) * (field[i] - rise) + ahead * rise
        out[i] = y
    return out
