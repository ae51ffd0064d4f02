"""Runs of a magnetometer among a spacecraft's housekeeping: `spacecraft.py OUT COUNT SEED [INDEX]`.

Panels each with its own vector, torque rods, a thermostat's heater, a battery, a wheel; telemetry that is slow, late
and in steps; channels that add up to others, and decoys; turned in a cage, or tumbling as in orbit beside a reference
of the body's own frame or of magnitude alone. Written from the contract alone; it shares nothing with labcal, nor with
the other programs of this folder.
"""

import json
import sys
from pathlib import Path

import numpy as np
import spacecraft_flight as flight
from spacecraft_flight import Board, lagged, loguniform, pulses

ID = {
    "panels": "offset-current", "rods": "offset-current", "heater": "offset-current", "valve-squared":
    "offset-current-squared", "warm-zero": "offset-temperature", "warm-gain": "gain-temperature",
    "battery": "offset-channel", "power-mode": "offset-mode", "wheel": "periodic", "hall": "reference-temperature",
    "bursts": "outliers",
}  # fmt: skip
STRANGE = {"wheel-ramp": [], "chemistry": ["offset-current", "offset-temperature"]}  # and what would be no wrong name
NEEDS_CAGE = {"hall"}


def spread(rng, board, names):
    """Currents times a vector each (n, 3), and the same one by one."""
    columns = [np.outer(board.at_rows(name), rng.normal(size=3) * loguniform(rng, 0.4, 2)) for name in names]
    return sum(columns), columns


def effect_of(board, kind, body, mode):
    """An effect in the field of the body (n, 3) of some size, and the shapes that a fit which knew would use."""
    rng, c = board.rng, board.rng.normal(size=3)
    if kind in ("panels", "rods", "heater"):
        names = {"panels": board.panels, "rods": board.rods, "heater": ["i_heater"]}[kind]
        return spread(rng, board, names)
    if kind == "valve-squared":
        one = np.outer(board.at_rows("i_valve") ** 2, c)
    elif kind in ("warm-zero", "warm-gain"):
        within = (
            lagged(board.true["t_sensor"], loguniform(rng, 5, 200)) if rng.random() < 0.6 else board.true["t_sensor"]
        )
        one = np.outer(np.interp(board.t, board.clock, within) - within.mean(), c)
        one = one * body / 40e3 if kind == "warm-gain" else one
    elif kind == "battery":
        one = np.outer(board.at_rows("v_bus") - 8.0, c)
    elif kind == "power-mode":
        one = np.outer(mode == "eclipse", c)
    elif kind == "wheel":
        f = loguniform(rng, 0.02, 0.45 / np.median(np.diff(board.t)))
        one = c * np.sin(2 * np.pi * f * board.t[:, None] + rng.uniform(0, 6.28, 3))
    elif kind == "wheel-ramp":
        f0, f1 = rng.uniform(0.02, 0.1), rng.uniform(0.15, 0.5)
        u = board.t / board.t[-1]
        one = c * np.sin(2 * np.pi * board.t * (f0 + 0.5 * (f1 - f0) * u) + rng.uniform(0, 6.28, 1))[:, None]
    else:  # chemistry
        warm = board.at_rows("t_sensor")
        one = np.outer(board.at_rows("i_load") * (warm - warm.mean()), c)
    return one, [one]


def directions(legs, how):
    """What the comparison sees of a row: the body's three axes, or the field's own direction alone (n, k, 3)."""
    body = np.concatenate([leg.body for leg in legs])
    if how == "scalar":
        return (body / np.linalg.norm(body, axis=1, keepdims=True))[:, None, :]
    return np.broadcast_to(np.eye(3), (len(body), 3, 3))


def outstanding(legs, how, effect):
    """Rms of one seen component in the run that no map, offset and phase takes of an effect (n, 3) in the body."""
    fresh, leg_of = rows_of(legs)
    body, seen = np.concatenate([leg.body for leg in legs]) / 1e4, directions(legs, how)
    maps = np.einsum("nki,nj->nkij", seen, body).reshape(*seen.shape[:2], 9)
    parts = [maps, seen]
    for k, leg in enumerate(legs):
        if leg.axis is not None and not leg.fresh:
            parts.append((np.cross(leg.axis, body) * (leg_of == k)[:, None])[:, :, None])
    A = np.concatenate(parts, axis=2)[~fresh].reshape(-1, sum(p.shape[2] for p in parts))
    y = np.einsum("nki,ni->nk", seen, effect)[~fresh].ravel()
    return float(np.sqrt(np.mean((y - A @ np.linalg.lstsq(A, y, rcond=1e-9)[0]) ** 2)))


def rows_of(legs):
    """Which rows (n,) are fresh, and the stretch of each."""
    lengths = [len(leg.t) for leg in legs]
    return np.repeat([leg.fresh for leg in legs], lengths), np.repeat(np.arange(len(legs)), lengths)


def wild(rng, reading, noise, fresh):
    """Bursts of 3 to 10 wild rows, 1 to 2 % of the run's in all; where they are."""
    rows, hit = np.flatnonzero(~fresh), np.zeros(len(fresh), dtype=bool)
    while hit.sum() < rng.uniform(0.01, 0.02) * len(rows):
        start = int(rng.integers(len(rows) - 10))
        hit[rows[start : start + int(rng.integers(3, 11))]] = True
    reading[hit] += noise * np.exp(rng.uniform(2.5, 6, (hit.sum(), 3))) * rng.choice([-1, 1], (hit.sum(), 3))
    return hit


def board_with_all(rng, legs, kinds):
    """A board on which what is needed is there, and some more that drives nothing."""
    board = Board(rng, legs)
    board.panels, board.rods = [], []
    if "panels" in kinds or rng.random() < 0.3:
        board.panels = flight.panel_currents(board, int(rng.integers(3, 7)))
    if "rods" in kinds or rng.random() < 0.2:
        board.rods = flight.torquers(board)
    if {"heater", "warm-zero", "warm-gain", "chemistry"} & set(kinds) or rng.random() < 0.4:
        flight.thermostat(board)
    if "battery" in kinds or rng.random() < 0.5:
        flight.battery(board)
    for name, kind in (("i_valve", "valve-squared"), ("i_load", "chemistry")):
        if kind in kinds:
            level = pulses(rng, board.clock, loguniform(rng, 8, 50), [0.1, 0.5, 0.9, 1.6])
            board.telemetry(name, level, "A", "current", 0.005)
    if "hall" in kinds or rng.random() < 0.2:
        walk = np.cumsum(rng.normal(size=len(board.clock)))
        trend = rng.uniform(2, 8) * np.sin(board.clock / loguniform(rng, 100, 600) + rng.uniform(0, 6))
        board.telemetry("t_hall", 21 + trend + 0.01 * walk, "degC", "temperature", 0.05, role="room")
    flight.decoys(board, int(rng.integers(0, 4)))
    return board


def hall(board, legs, how, wanted):
    """What the reference reads too much (n, 3): its scale and zero follow the hall; and how much that leaves."""
    rng, outside = board.rng, np.concatenate([leg.outside for leg in legs])
    warm = board.at_rows("t_hall")[:, None] - 21
    extra = warm * (rng.normal() * outside / 40e3 + rng.normal(size=3) * rng.uniform(0, 1))
    ends = np.cumsum([0, *(len(leg.t) for leg in legs)])

    def in_body(v):
        return np.concatenate([leg.into_body.apply(v[a:b]) for leg, a, b in zip(legs, ends, ends[1:], strict=False)])

    size = wanted / outstanding(legs, how, in_body(extra))
    return size * extra, outstanding(legs, how, size * in_body(extra))


def fit_that_knew(body, reading, shapes, use, new):
    """Rms length and rms of the magnitude on fresh rows of a fit by least squares with the true shapes."""
    X = np.column_stack([body / 1e4, np.ones(len(body)), *shapes])
    size = np.abs(X[use]).max(axis=0)
    size[size == 0] = 1.0
    theta = np.linalg.lstsq(X[use] / size, reading[use], rcond=1e-10)[0] / size[:, None]
    back = 1e4 * np.linalg.solve(theta[:3].T, (reading[new] - X[new, 3:] @ theta[3:]).T).T
    vector = np.sum((back - body[new]) ** 2, axis=1)
    magnitude = (np.linalg.norm(back, axis=1) - np.linalg.norm(body[new], axis=1)) ** 2
    return float(np.sqrt(vector.mean())), float(np.sqrt(magnitude.mean()))


def samples(path, board, legs, how, reading, reference, fresh):
    """The rows of the run or the fresh ones, as CSV."""
    refs = [] if fresh else ["ref_f"] if how == "scalar" else ["ref_x", "ref_y", "ref_z"]
    turned = ["angle_deg"] if how == "cage" else []
    lines = [",".join(["t_s", "segment", "dut_x", "dut_y", "dut_z", *refs, *turned, "mode", *board.told])]
    row = 0
    for leg in legs:
        for i in range(len(leg.t)):
            if leg.fresh == fresh:
                ref = np.atleast_1d(np.linalg.norm(reference[row]) if how == "scalar" else reference[row])
                told = [f"{leg.t[i]:.3f}", leg.name, *(f"{v:.1f}" for v in reading[row])]
                told += [f"{v:.1f}" for v in ref[: len(refs)]]
                told += [f"{np.round(leg.angle_deg[i] / 0.01) * 0.01:.2f}"] if turned else []
                lines.append(",".join([*told, leg.mode, *(f"{v[0][row]:.5g}" for v in board.told.values())]))
            row += 1
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def bundle_head(name, board, legs, how, noise):
    """What run.json says."""
    segments = []
    for leg in legs:
        told = {"id": leg.name, "kind": "rotation" if how == "cage" else "free", "mode": leg.mode, "note": ""}
        if how == "cage":
            told |= {"axis_body": leg.axis.tolist(), "axis_cage": [0.0, 0.0, 1.0]}
        segments += [] if leg.fresh else [told | ({"reference_frame": "body"} if how == "tumble" else {})]
    return {
        "format": "labcal-run/1", "run_id": name, "started_utc": "2026-09-20T22:10:00Z", "simulated": True,
        "operator": "",
        "reference": {"kind": "scalar" if how == "scalar" else "vector", "serial": "G", "noise_nT": 3.0},
        "dut": {"serial": "FM2", "model": "amr", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": noise},
        "segments": segments,
        "channels": {c: {"unit": u, "quantity": q, "role": r} for c, (_, u, q, r) in board.told.items()},
    }  # fmt: skip


def make(out, index, seed, kinds, strengths):
    """One run and its truth."""
    rng = np.random.default_rng([index, seed, 9001])
    how = "cage" if NEEDS_CAGE & set(kinds) else str(rng.choice(["cage", "tumble", "scalar"], p=[0.5, 0.35, 0.15]))
    modes = ["nominal", "eclipse"] if "power-mode" in kinds or rng.random() < 0.25 else ["nominal"]
    legs = flight.stretches(rng, how, modes)
    board = board_with_all(rng, legs, kinds)
    (fresh, leg_of), body = rows_of(legs), np.concatenate([leg.body for leg in legs])
    mode = np.array([leg.mode for leg in legs])[leg_of]
    noise = round(loguniform(rng, 8, 70), 2)
    reference = body.copy() if how == "tumble" else np.concatenate([leg.outside for leg in legs])
    total, shapes, rms = np.zeros_like(body), [], {}
    for kind, strength in zip(kinds, strengths, strict=True):
        if kind == "hall":
            extra, left = hall(board, legs, how, strength * noise)
            reference, rms[ID[kind]] = reference + extra, left / noise
        elif kind != "bursts":
            effect, columns = effect_of(board, kind, body, mode)
            left = outstanding(legs, how, effect)
            size = strength * noise / left if left > 1e-6 * np.std(effect) else 0.0
            rms[ID.get(kind, kind)] = size * left / noise
            total, shapes = total + size * effect, [*shapes, *columns]
    S = np.eye(3) + rng.normal(0, 0.05, (3, 3))
    S = (S + S.T) / 2 if how == "scalar" else S
    reading = (body + total) @ S.T + rng.normal(0, 5000, 3) + rng.normal(0, noise, body.shape)
    hit = np.zeros(len(body), dtype=bool)
    if "bursts" in kinds:
        before = reading.copy()
        hit = wild(rng, reading, noise, fresh)
        rms["outliers"] = float(np.sqrt(np.mean((reading - before)[~fresh] ** 2))) / noise
    declared = None if rng.random() < (0.5 if "bursts" in kinds else 0.08) else noise
    reference = reference + rng.normal(0, 3.0, body.shape)
    name = f"b{index:04d}"
    samples(out / name / "bundle" / "samples.csv", board, legs, how, reading, reference, False)
    samples(out / name / "fresh.csv", board, legs, how, reading, reference, True)
    (out / name / "bundle" / "run.json").write_text(json.dumps(bundle_head(name, board, legs, how, declared)))
    np.savetxt(out / name / "truth_fresh.csv", body[fresh], delimiter=",", fmt="%.3f")
    knew, knew_magnitude = fit_that_knew(body, reading, shapes, ~fresh & ~hit, fresh)
    told = {
        "simulator": "spacecraft", "seed": seed, "index": index, "kinds": kinds, "how": how,
        "cause": sorted({ID[k] for k in kinds if k in ID}), "unnamed": [k for k in kinds if k in STRANGE],
        "not_wrong": [i for k in kinds for i in STRANGE.get(k, [])], "noise_nT": noise, "declared": declared,
        "rms_over_noise": {k: round(v, 3) for k, v in rms.items()}, "decoys": board.decoys,
        "knowing_rms_nT": knew, "knowing_magnitude_rms_nT": knew_magnitude,
    }  # fmt: skip
    (out / "truth").mkdir(exist_ok=True)
    (out / "truth" / f"{name}.json").write_text(json.dumps(told))


def cases(count, seed):
    """What is at work in each run: of 33, eight nulls, fourteen single causes, nine pairs, two that no id names."""
    rng, one, out = np.random.default_rng([seed, 9002]), list(ID), []
    while len(out) < count:
        deck = [((), ())] * 8
        deck += [((k,), (loguniform(rng, 2, 30),)) for k in one]
        deck += [((str(rng.choice(one)),), (loguniform(rng, 0.5, 2),)) for _ in range(3)]
        while len(deck) < 31:
            strong, weak = rng.choice(one, 2, replace=False).tolist()
            if ID[strong] != ID[weak]:
                deck.append(((strong, weak), (loguniform(rng, 10, 25), loguniform(rng, 2, 4))))
        deck += [((k,), (loguniform(rng, 3, 20),)) for k in STRANGE]
        out += [deck[k] for k in rng.permutation(len(deck))]
    return out[:count]


if __name__ == "__main__":
    folder, (count, seed, *only) = Path(sys.argv[1]), map(int, sys.argv[2:])
    for index, (kinds, strengths) in enumerate(cases(count, seed)):
        if index in (only or [index]):
            make(folder, index, seed, kinds, strengths)
