"""Runs of a cage of finite coils, with iron and magnets about it (magpylib): `magnets.py OUT COUNT SEED [INDEX]`.

Written from the contract alone; it shares nothing with labcal, nor with the other programs of this folder. Lengths in
m, fields in nT. Each run leaves `bundle/`, `fresh.csv`, `truth_fresh.csv`, and OUT/truth/NAME.json.
"""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, field
from pathlib import Path

import magpylib as magpy
import numpy as np
from scipy.spatial.transform import Rotation

SINGLE = ("panels", "off-centre", "iron-beside", "iron-on-table", "motor", "tilt", "moment")
UNNAMED = ("lift", "hinge")
ID_OF = {
    "panels": "offset-current", "off-centre": "field-gradient", "iron-beside": "cage-field",
    "iron-on-table": "cage-field", "motor": "cage-field", "tilt": "axis-tilt", "moment": "dut-dipole-at-reference",
}  # fmt: skip
NEAR_ENOUGH = {"hinge": ["offset-channel"]}  # a straight line in the true channel is no wrong name

SQUARE = np.array([[1, 1, 0], [-1, 1, 0], [-1, -1, 0], [1, -1, 0], [1, 1, 0]])


@dataclass
class Lab:
    """One afternoon: rows (n,) of all segments in time, those of the run and the fresh ones between them."""

    rng: np.random.Generator
    coils: list
    t: np.ndarray
    segment: np.ndarray
    angle: np.ndarray  # rad, true
    moving: np.ndarray  # the motor is on
    amperes: np.ndarray  # (n, 3)
    ambient: np.ndarray  # (n, 3) in the cage
    body_from_table: np.ndarray  # (segments, 3, 3)
    fresh: np.ndarray  # (segments,)
    phase_known: bool
    channels: dict = field(default_factory=dict)  # name -> (values, unit, quantity, role)
    decoys: list = field(default_factory=list)

    def coil_field(self, places):
        """The coils' field (n, 3) at places (n, 3) in the cage, one for each row."""
        return sum(1e9 * magpy.getB(pair, places) * self.amperes[:, [k]] for k, pair in enumerate(self.coils))

    def to_body(self, spindle=None):
        """Rotations (n, 3, 3) from the cage into the body; `spindle` (3,) is where the table's axis truly points."""
        upright = np.eye(3) if spindle is None else Rotation.align_vectors([[0, 0, 1.0]], [spindle])[0].as_matrix()
        turned = Rotation.from_rotvec(np.outer(-self.angle, [0, 0, 1.0])).as_matrix()
        return self.body_from_table[self.segment] @ turned @ upright


def log_between(rng, low, high):
    """Every octave as likely as any other."""
    return float(low * (high / low) ** rng.random())


def direction(rng):
    """A unit vector (3,)."""
    return (v := rng.normal(size=3)) / np.linalg.norm(v)


def coil_pair(rng, axis, round_ones):
    """Two coils for one ampere: nearly Helmholtz's spacing, nearly alike, nearly along `axis`."""
    side, turns = rng.uniform(1.1, 2.4), rng.integers(20, 60)
    spacing = side * (0.5 if round_ones else 0.5445) * (1 + rng.normal(0, 0.01))
    pair = magpy.Collection()
    for sign in (-1, 1):
        size = side * (1 + rng.normal(0, 0.003))
        round_one = magpy.current.Circle(diameter=size, current=turns)
        coil = round_one if round_ones else magpy.current.Polyline(vertices=SQUARE * size / 2, current=turns)
        coil.position = (*rng.normal(0, 0.004, 2), sign * spacing / 2)
        pair.add(coil)
    aligned = Rotation.align_vectors([np.eye(3)[axis]], [[0, 0, 1.0]])[0]
    return pair.rotate(Rotation.from_rotvec(rng.normal(0, 0.01, 3)) * aligned, anchor=0)


def turning(rng, t, stepped):
    """Angle (n,) and whether the motor is on, from rest to rest: in stops, or at one rate with a rest between."""
    span, total = t[-1] - t[0], np.radians(rng.uniform(370, 760)) * rng.choice([-1, 1])
    stops = int(rng.integers(9, 17)) if stepped else 2
    share = rng.uniform(0.4, 0.7) if stepped else rng.uniform(0.75, 0.9)
    u = (t - t[0]) / span * stops
    within = np.clip((u - np.floor(u) - (1 - share) / 2) / share, 0, 1)
    angle = (np.floor(u) + within * within * (3 - 2 * within)) / stops * total
    return angle, (within > 0) & (within < 1)


def set_points(rng, t, reach, held):
    """Fields (n, 3) that the cage is asked for: some set points, each held."""
    edges = np.sort(rng.uniform(t[0], t[-1], held - 1))
    wanted = np.array([direction(rng) * rng.uniform(0.35, 1.0) * reach for _ in range(held)])
    wanted[:, 2] *= 0.8
    return wanted[np.searchsorted(edges, t)]


def afternoon(rng):
    """A cage, six to nine segments about different axes of the body, and fresh ones between."""
    round_ones, stepped = rng.random() < 0.5, rng.random() < 0.4
    coils = [coil_pair(rng, axis, round_ones) for axis in range(3)]
    central = 1e9 * np.stack([pair.getB((0, 0, 0)) for pair in coils], axis=1)
    earth, drift = rng.normal(0, 22000, 3), rng.normal(0, 0.02, 3)
    count, rows, step = int(rng.integers(6, 10)), int(rng.integers(50, 150)), log_between(rng, 0.3, 1.6)
    axes = [np.eye(3)[k % 3] for k in range(count)]
    axes = [axes[k] if rng.random() < 0.85 else direction(rng) for k in rng.permutation(count)]
    pieces, mounts, fresh, now = [], [], [], 0.0
    reach = rng.uniform(32000, 56000)
    for k in range(2 * count - 1):
        is_fresh = k % 2 == 1
        axis = direction(rng) if is_fresh else axes[k // 2]
        t = now + step * np.arange(rows // 3 if is_fresh else rows)
        angle, moving = turning(rng, t, stepped)
        wanted = set_points(rng, t, reach, 1 if not stepped and rng.random() < 0.6 else int(rng.integers(2, 5)))
        ambient = earth + np.outer(t, drift)
        amperes = np.linalg.solve(central, (wanted - earth).T).T
        pieces.append((t, np.full(len(t), k), angle, moving, amperes, ambient))
        spin = Rotation.from_rotvec(axis * rng.uniform(0, 2 * np.pi))
        mounts.append((spin * Rotation.align_vectors([axis], [[0, 0, 1.0]])[0]).as_matrix())
        fresh.append(is_fresh)
        now = t[-1] + rng.uniform(10, 40)
    joined = [np.concatenate(column) for column in zip(*pieces, strict=True)]
    return Lab(rng, coils, *joined, np.array(mounts), np.array(fresh), bool(rng.random() < 0.5))


def switched(rng, t):
    """A load's current (n,), A: two levels and a little ripple, dwell times drawn."""
    edges = np.cumsum(rng.exponential(log_between(rng, 6, 50), 4000))
    low, high = rng.uniform(0, 0.3), rng.uniform(0.5, 1.8)
    return np.where(np.searchsorted(edges, t - t[0]) % 2, high, low) + rng.normal(0, 0.01, len(t))


def wandering(rng, t, scale):
    """An Ornstein-Uhlenbeck walk (n,), its time constant drawn."""
    tau, out = log_between(rng, 4, 300), np.empty(len(t))
    out[0] = rng.normal()
    for i in range(1, len(t)):
        keep = np.exp(-(t[i] - t[i - 1]) / tau)
        out[i] = keep * out[i - 1] + np.sqrt(1 - keep**2) * rng.normal()
    return scale * out


def panels(lab):
    """Current loops of one to three panels beside the device: their field in the body is the sensor's to correct."""
    rng, out, count = lab.rng, 0.0, int(lab.rng.integers(1, 4))
    for k in range(count):
        corners = SQUARE * [*rng.uniform(0.03, 0.12, 2), 0]
        loop = magpy.current.Polyline(vertices=corners, current=1.0).rotate(Rotation.random(random_state=rng))
        there = direction(rng) * rng.uniform(0.12, 0.35)
        amperes = switched(rng, lab.t)
        lab.channels[f"panel_{k + 1}_A"] = (np.round(amperes, 3), "A", "current", "dut")
        out = out + amperes[:, None] * 1e9 * magpy.getB(loop, -there)
    return lambda size: ("sensor", size * out)


def off_centre(lab):
    """The device beside the spindle and above the centre: what the finite coils give there."""
    lever, above, upright = direction(lab.rng), lab.rng.normal(0, 0.4), lab.to_body()
    at_centre = lab.coil_field(np.zeros((len(lab.t), 3)))

    def there(size):
        places = min(0.01 * size, 0.15) * (np.einsum("nji,j->ni", upright, lever) + [0, 0, above])
        return "rig", np.einsum("nij,nj->ni", upright, lab.coil_field(places) - at_centre)

    return there


def lump(rng):
    """A cuboid of iron: its field for each component of its polarisation at a place; and how it answers a field."""
    answer = np.diag(rng.uniform(0.5, 1.5, 3))
    turned = Rotation.random(random_state=rng).as_matrix()
    answer, sides = turned @ answer @ turned.T, rng.uniform(0.02, 0.06, 3)
    blocks = [magpy.magnet.Cuboid(polarization=p, dimension=sides) for p in np.eye(3)]
    return answer, lambda places: np.stack([magpy.getB(block, places) for block in blocks], axis=-1)


def iron_beside(lab):
    """Iron that stands beside the cage's centre: magnetised by coils and earth, with some remanence of its own."""
    rng, (answer, unit) = lab.rng, lump(lab.rng)
    place = direction(rng) * rng.uniform(0.25, 0.6)
    remanent = rng.normal(0, rng.uniform(0, 60000), 3)
    magnetised = (lab.coil_field(np.tile(place, (len(lab.t), 1))) + lab.ambient) @ answer.T + remanent
    seen = magnetised @ unit(-place).T
    return lambda size: ("rig", size * np.einsum("nij,nj->ni", lab.to_body(), seen))


def iron_on_table(lab):
    """Iron that turns with the table; each mounting puts the device otherwise, the iron stays in the table's frame."""
    rng, (answer, unit) = lab.rng, lump(lab.rng)
    place = direction(rng) * rng.uniform(0.12, 0.3)
    table = Rotation.from_rotvec(np.outer(lab.angle, [0, 0, 1.0]))
    around = lab.coil_field(table.apply(place)) + lab.ambient
    magnetised = table.inv().apply(around) @ answer.T + rng.normal(0, rng.uniform(10000, 60000), 3)
    in_table = magnetised @ unit(-place).T
    seen = np.einsum("nij,nj->ni", lab.body_from_table[lab.segment], in_table)
    return lambda size: ("rig", size * seen)


def motor(lab):
    """A motor under the table: its magnets stand, its rotor's turn with the table, its windings only while it runs."""
    rng = lab.rng
    below = np.array([*rng.normal(0, 0.05, 2), -rng.uniform(0.25, 0.5)])
    poles = int(rng.integers(1, 4))
    standing, turning_, winding = rng.normal(size=3), rng.normal(size=3) * rng.uniform(0, 1), rng.normal(size=3)
    turned = Rotation.from_rotvec(np.outer(poles * lab.angle, [0, 0, 1.0])).apply(turning_)
    on = lab.moving[:, None] * rng.uniform(0.2, 1.5)
    unit = np.stack([magpy.getB(magpy.misc.Dipole(moment=m), -below) for m in np.eye(3)], axis=1)
    seen = 1e9 * (standing * rng.integers(0, 2) + turned + on * (winding + turned)) @ unit.T
    return lambda size: ("rig", size * np.einsum("nij,nj->ni", lab.to_body(), seen))


def tilt(lab):
    """The spindle is not upright in the cage."""
    lean = direction(lab.rng) * [1, 1, 0]
    field_ = lab.coil_field(np.zeros((len(lab.t), 3))) + lab.ambient

    def leaning(size):
        spindle = np.array([0, 0, 1.0]) + 0.001 * size * lean
        turned = lab.to_body(spindle / np.linalg.norm(spindle)) - lab.to_body()
        return "rig", np.einsum("nij,nj->ni", turned, field_)

    return leaning


def moment(lab):
    """The device's own moment, seen by a reference that stands near it."""
    lab.near = direction(lab.rng) * lab.rng.uniform(0.2, 0.6)
    own = lab.rng.normal(size=3)
    in_cage = np.einsum("nji,j->ni", lab.to_body(), own)
    unit = np.stack([magpy.getB(magpy.misc.Dipole(moment=m), lab.near) for m in np.eye(3)], axis=1)
    return lambda size: ("reference", size * 1e9 * in_cage @ unit.T)


def lift(lab):
    """Nobody's name: a lift or a lorry goes by, at times that nothing recorded."""
    rng, seen = lab.rng, 0.0
    for start in rng.uniform(lab.t[0], lab.t[-1], int(rng.integers(3, 8))):
        along, away = direction(rng), direction(rng) * rng.uniform(3, 6)
        places = away + np.outer((lab.t - start) * log_between(rng, 0.1, 1.0), along)
        seen = seen + 1e9 * magpy.getB(magpy.misc.Dipole(moment=rng.normal(size=3) * 100), -places)
    return lambda size: ("rig", size * np.einsum("nij,nj->ni", lab.to_body(), seen))


def hinge(lab):
    """Nobody's name: a magnet on a hinged panel; the panel's angle is recorded, the field is bent in it."""
    rng = lab.rng
    opened = 60 + wandering(rng, lab.t, 35)
    lab.channels["hinge_deg"] = (np.round(opened, 1), "deg", "other", "dut")
    foot, arm, magnet = direction(rng) * 0.15, rng.uniform(0.08, 0.12), rng.normal(size=3)
    folded = Rotation.from_rotvec(np.outer(np.radians(opened), direction(rng)))
    places = foot + folded.apply([arm, 0, 0])
    out = 1e9 * magpy.getB(magpy.misc.Dipole(moment=magnet), -places)
    return lambda size: ("sensor", size * out)


MAKERS = {
    "panels": panels, "off-centre": off_centre, "iron-beside": iron_beside, "iron-on-table": iron_on_table,
    "motor": motor, "tilt": tilt, "moment": moment, "lift": lift, "hinge": hinge,
}  # fmt: skip


def add_decoys(lab, count):
    """Channels that drive nothing."""
    rng = lab.rng
    sorts = [("bus_V", "V", "voltage", 0.2), ("tank_hPa", "hPa", "pressure", 4.0), ("spare_A", "A", "current", 0.3),
             ("box_C", "degC", "temperature", 3.0)]  # fmt: skip
    for k in rng.permutation(len(sorts))[:count]:
        name, unit, quantity, scale = sorts[k]
        values = switched(rng, lab.t) if quantity == "current" else 10 + wandering(rng, lab.t, scale)
        lab.channels[name] = (np.round(values, 3), unit, quantity, "dut")
        lab.decoys.append(name)


def beyond_base(lab, body, effect):
    """Rms of one component of an effect (n, 3) in the run that no map, offset or starting angle takes."""
    b, e, where = (v[~lab.fresh[lab.segment]] for v in (body, effect, lab.segment))
    X = np.hstack([np.kron(b, np.eye(3)), np.kron(np.ones((len(b), 1)), np.eye(3))])
    if not lab.phase_known:
        turned = np.cross(lab.body_from_table[where][:, :, 2], b)
        X = np.hstack([X, *[(turned * (where == k)[:, None]).reshape(-1, 1) for k in np.unique(where)]])
    basis = np.linalg.qr(X / np.linalg.norm(X, axis=0))[0]
    return float(np.sqrt(np.mean((e.ravel() - basis @ (basis.T @ e.ravel())) ** 2)))


def sticks_out(lab, body, where, effect):
    """Rms, nT, of what an effect (n, 3) leaves in the comparison of device and reference."""
    seen = effect if where != "reference" else -np.einsum("nij,nj->ni", lab.to_body(), effect)
    return beyond_base(lab, body, seen)


def size_for(lab, body, at, wanted):
    """The size at which an effect sticks out by `wanted`, nT, or nearly: some are bent in their size."""
    size = wanted / sticks_out(lab, body, *at(1.0))
    for _ in range(14):
        short = wanted / sticks_out(lab, body, *at(size))
        if abs(short - 1) < 0.02:
            break
        size *= short**0.25
    return size


def write_rows(path, lab, rows, reading, reference, written):
    """A CSV of some rows; the reference stays away where it is None."""
    head = ["t_s", "segment", "dut_x", "dut_y", "dut_z", *([] if reference is None else ["ref_x", "ref_y", "ref_z"])]
    lines = [",".join([*head, "angle_deg", *lab.channels])]
    for i in np.flatnonzero(rows):
        cells = [f"{lab.t[i]:.4f}", f"s{lab.segment[i]:02d}", *(f"{v:.1f}" for v in reading[i])]
        cells += [] if reference is None else [f"{v:.2f}" for v in reference[i]]
        lines.append(",".join([*cells, f"{written[i]:.3f}", *(f"{c[0][i]:.4f}" for c in lab.channels.values())]))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def run_json(lab, name, noise):
    """What the bundle says of itself."""
    segments = []
    for k in np.flatnonzero(~lab.fresh):
        mount = lab.body_from_table[k]
        one = {"id": f"s{k:02d}", "kind": "rotation", "axis_body": np.round(mount[:, 2], 12).tolist(),
               "axis_cage": [0.0, 0.0, 1.0], "mode": "nominal", "note": "", "mounting": f"m{k}"}  # fmt: skip
        segments.append(one | ({"body_from_cage": np.round(mount, 12).tolist()} if lab.phase_known else {}))
    place = {"place": "remote", "position_m": lab.near.tolist()} if hasattr(lab, "near") else {}
    reference = {"kind": "vector", "serial": "R7", "noise_nT": 3.0} | place
    return {
        "format": "labcal-run/1", "run_id": name, "started_utc": "2026-03-03T13:00:00Z", "simulated": True,
        "operator": "", "reference": reference, "segments": segments,
        "dut": {"serial": f"M{lab.rng.integers(1000)}", "model": "fluxgate", "unit": "nT", "nominal_nT_per_unit": 1.0,
                "noise_nT": noise},
        "channels": {c: {"unit": u, "quantity": q, "role": r} for c, (_, u, q, r) in lab.channels.items()},
    }  # fmt: skip


def make(out, index, seed, kinds, strengths, decoys):
    """One run with its truth."""
    rng = np.random.default_rng([seed, index, 71])
    lab = afternoon(rng)
    for k, axis in enumerate("xyz"):
        lab.channels[f"coil_{axis}_A"] = (np.round(lab.amperes[:, k], 4), "A", "current", "coil")
    lab.channels["motor_on"] = (lab.moving * 1.0, "1", "other", "platform")
    cage = lab.coil_field(np.zeros((len(lab.t), 3))) + lab.ambient
    body, reference = np.einsum("nij,nj->ni", lab.to_body(), cage), cage.copy()
    noise = round(log_between(rng, 6, 45), 2)
    S, offset = np.eye(3) + rng.normal(0, 0.03, (3, 3)), rng.normal(0, 2500, 3)
    true, sensor, rms, shapes = body.copy(), np.zeros_like(body), {}, []
    for kind, strength in zip(kinds, strengths, strict=True):
        at = MAKERS[kind](lab)
        where, effect = at(size_for(lab, body, at, strength * noise))
        rms[ID_OF.get(kind, kind)] = round(sticks_out(lab, body, where, effect) / noise, 3)
        true += effect if where == "rig" else 0
        sensor += effect if where == "sensor" else 0
        reference += effect if where == "reference" else 0
        shapes += [effect @ S.T] if where == "sensor" else []
    add_decoys(lab, decoys)
    reading = (true + sensor) @ S.T + offset + rng.normal(0, noise, body.shape)
    reference = reference + rng.normal(0, 3.0, body.shape)
    zero = 0 if lab.phase_known else rng.uniform(0, 360, len(lab.fresh))[lab.segment]
    written, fresh = np.degrees(lab.angle) + zero, lab.fresh[lab.segment]
    name = f"b{index:04d}"
    write_rows(out / name / "bundle" / "samples.csv", lab, ~fresh, reading, reference, written)
    write_rows(out / name / "fresh.csv", lab, fresh, reading, None, written)
    (out / name / "bundle" / "run.json").write_text(json.dumps(run_json(lab, name, noise), indent=1))
    np.savetxt(out / name / "truth_fresh.csv", true[fresh], delimiter=",", fmt="%.3f")
    X = np.hstack([true, np.ones((len(true), 1)), *[s.sum(axis=1, keepdims=True) for s in shapes], *shapes])
    knew, *_ = np.linalg.lstsq(X[~fresh], reading[~fresh], rcond=1e-10)
    error = np.linalg.solve(knew[:3].T, (reading - X[:, 3:] @ knew[3:])[fresh].T).T - true[fresh]
    told = {"simulator": "magnets", "seed": seed, "index": index, "kinds": kinds,
            "cause": sorted({ID_OF[k] for k in kinds if k in ID_OF}), "unnamed": [k for k in kinds if k in UNNAMED],
            "not_wrong": [i for k in kinds for i in NEAR_ENOUGH.get(k, [])], "rms_over_noise": rms, "noise_nT": noise,
            "decoys": lab.decoys, "knowing_rms_nT": float(np.sqrt(np.mean(np.sum(error**2, axis=1))))}  # fmt: skip
    (out / "truth").mkdir(exist_ok=True)
    (out / "truth" / f"{name}.json").write_text(json.dumps(told))


def menu(count, seed):
    """What is at work in each run: of 24, six nulls, ten single causes, six pairs, two that no id names."""
    rng, out = np.random.default_rng([seed, 72]), []
    while len(out) < count:
        turn = [((), ())] * 6
        turn += [((k,), (log_between(rng, 2, 30),)) for k in SINGLE]
        turn += [((SINGLE[rng.integers(7)],), (log_between(rng, 0.5, 2),)) for _ in range(3)]
        for _ in range(6):
            pair = []
            while len({ID_OF[k] for k in pair}) < 2:
                pair = [SINGLE[k] for k in rng.permutation(7)[:2]]
            turn.append((pair, (log_between(rng, 10, 25), log_between(rng, 2, 4))))
        turn += [((k,), (log_between(rng, 3, 20),)) for k in UNNAMED]
        out += [(*turn[k], int(rng.integers(0, 4))) for k in rng.permutation(len(turn))]
    return out[:count]


if __name__ == "__main__":
    count_, seed_, *only = map(int, sys.argv[2:])
    for index_, run in enumerate(menu(count_, seed_)):
        if only in ([], [index_]):
            make(Path(sys.argv[1]), index_, seed_, *run)
