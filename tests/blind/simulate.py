"""Runs with an undeclared effect, by a simulator that shares nothing with labcal: `simulate.py OUT COUNT SEED`.

Each run gets a folder: `bundle/` as the contract has it, `fresh.csv` and `truth_fresh.csv` (another recording of the
same device), and under OUT/truth a file that the analysis never sees. Plain numpy, in the device's own reading:
reading = S b + offset + effect + noise.
"""

from __future__ import annotations

import csv
import json
import sys
from pathlib import Path

import numpy as np
from at_work import rig_effect, sensor_effect
from lab import add_channels, record, shift

SENSOR = (
    "offset-current", "offset-current-squared", "offset-temperature", "offset-channel", "gain-temperature",
    "offset-drift", "offset-step", "offset-mode", "nonlinearity", "cross-field", "hysteresis", "lag", "periodic",
)  # fmt: skip
RIG = ("axis-tilt", "field-gradient", "cage-field", "reference-drift", "dut-dipole-at-reference")
DATA = ("saturation", "outliers")
STRANGE = ("random-walk", "telegraph", "bursts", "rate-squared")
PAIRS = (
    ("offset-current", "offset-temperature"), ("lag", "offset-current"), ("nonlinearity", "offset-temperature"),
    ("axis-tilt", "offset-current"), ("hysteresis", "gain-temperature"), ("offset-mode", "cross-field"),
)  # fmt: skip
STRENGTHS = (0.5, 2.0, 10.0)  # the classes of the score; what else a run draws, it draws continuously


def left_by_base(scene, effect, S):
    """Rms length of what K, k and the phases cannot absorb of an effect (n, 3) in the reading."""
    inverse = np.linalg.inv(S)
    e = effect @ inverse.T
    n = len(e)
    A = [np.kron(scene.body, np.eye(3)), np.kron(np.ones((n, 1)), np.eye(3))]
    for k, p in enumerate(scene.parts):
        if p.kind == "rotation":
            A.append((np.cross(p.axis, scene.body) * (scene.segment == k)[:, None]).reshape(-1, 1))
    A = np.concatenate(A, axis=1)
    A = A / np.linalg.norm(A, axis=0)
    y = e.reshape(-1)
    left = y - A @ np.linalg.lstsq(A, y, rcond=1e-8)[0]
    return float(np.sqrt(np.sum(left**2) / n))


def make_run(seed, kinds, strength, as_scalar):
    """One run: scenes, readings, truth."""
    rng = np.random.default_rng(seed)
    scalar = as_scalar or (not set(kinds) & {*RIG, "lag", "reference-drift", "saturation"} and rng.random() < 0.12)
    no_angle = not scalar and not set(kinds) & {*RIG, "lag", "reference-drift"} and rng.random() < 0.05
    modes = ["nominal", "full-power"] if "offset-mode" in kinds or rng.random() < 0.3 else ["nominal"]
    run, fresh, end = record(
        rng,
        statics=rng.random() < 0.5 and not scalar and "lag" not in kinds,
        long="lag" in kinds or rng.random() < 0.2,
        modes=modes,
    )
    wanted = {"offset-current": ["load"], "offset-current-squared": ["levels"], "offset-temperature": ["temperature"],
              "gain-temperature": ["temperature"], "offset-channel": ["voltage"]}  # fmt: skip
    names = add_channels(rng, run, fresh, end, [w for k in kinds for w in wanted.get(k, [])])
    S = np.eye(3) + rng.normal(0, 0.05, (3, 3))
    offset = rng.normal(0, 3500, 3)
    noise = round(float(rng.uniform(20.0, 50.0)), 2)
    near = rng.normal(size=3)
    near *= 0.25 / np.linalg.norm(near)
    floor = noise * np.sqrt(np.sum(np.linalg.inv(S) ** 2))
    zero = [np.zeros_like(run.cage), np.zeros_like(fresh.cage)]
    state = {"run": run, "fresh": fresh, "S": S, "noise": noise, "lag": 0.0, "reference": zero}
    readings = [np.zeros_like(s.body) for s in (run, fresh)]
    sizes = []
    for kind in kinds:
        if kind in DATA:
            continue
        if kind == "lag":
            pilot = shift(run, 0.5) @ S.T - run.body @ S.T
            state["lag"] = min(0.5 * strength * floor / left_by_base(run, pilot, S), 4.0) * rng.choice([-1, 1])
            continue
        if kind == "reference-drift":
            d = rng.normal(size=3)
            here, there = ((s.t / end)[:, None] * d for s in (run, fresh))
            unit = left_by_base(run, np.einsum("nij,nj->ni", run.to_body, here) @ S.T, S)
            state["reference"] = [slope * strength * floor / unit for slope in (here, there)]
            continue
        if kind in RIG:
            effect = rig_effect(kind, rng, end, near)
            here = [effect(s) @ S.T for s in (run, fresh)]
        else:
            effect = sensor_effect(kind, rng, names, S, end)
            here = [effect(s) for s in (run, fresh)]
        unit = left_by_base(run, here[0], S)
        size = strength * floor / max(unit, 1e-12)
        sizes.append(size)
        # what the rig does is there in the run; the fresh recording is scored against the field at the device
        for out, add, fresh_one in zip(readings, here, (False, True), strict=True):
            if not (fresh_one and kind in RIG):
                out += size * add
    out = []
    for scene, effect, ref in zip((run, fresh), readings, state["reference"], strict=True):
        seen = shift(scene, -state["lag"]) if state["lag"] else scene.body
        clean = seen @ S.T + offset + rng.normal(0, noise, scene.body.shape)
        out.append((clean + effect, scene.cage + ref + rng.normal(0, 3.5, scene.cage.shape), clean))
    return rng, state, names, out, scalar, no_angle, near, offset


def spoil(rng, kinds, readings, noise, strength):
    """Outliers and a rail, in place."""
    valid = np.ones(len(readings), dtype=bool)
    if "outliers" in kinds:
        rows = rng.choice(len(readings), int(len(readings) * rng.uniform(0.005, 0.03)), replace=False)
        readings[rows] += rng.normal(0, 60 * noise, (len(rows), 3)) + 30 * noise * rng.choice([-1, 1], (len(rows), 3))
        valid[rows] = False
    if "saturation" in kinds:
        rail = np.quantile(np.abs(readings), 1 - {0.5: 0.01, 2.0: 0.03, 10.0: 0.08}[strength])
        valid &= ~(np.abs(readings) > rail).any(axis=1)
        np.clip(readings, -rail, rail, out=readings)
    return valid


def write(folder, scene, reading, reference, channels, scalar, no_angle, with_reference, rng):
    """samples.csv with what belongs in it."""
    head = ["t_s", "segment", "dut_x", "dut_y", "dut_z"] + (["ref_f"] if scalar else ["ref_x", "ref_y", "ref_z"])
    head += [] if scalar or no_angle else ["angle_deg"]
    head += [*channels, "mode"]
    gaps = {name: rng.random(len(scene.t)) < (0.02 if rng.random() < 0.25 else 0) for name in channels}
    folder.parent.mkdir(parents=True, exist_ok=True)
    with folder.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(head)
        for i in range(len(scene.t)):
            row = [
                f"{scene.t[i]:.4f}",
                scene.parts[scene.segment[i]].id,
                *(f"{np.round(v * 2) / 2:.1f}" for v in reading[i]),
            ]
            ref = [np.linalg.norm(reference[i])] if scalar else reference[i]
            row += [f"{v:.2f}" if with_reference else "" for v in ref]
            if not (scalar or no_angle):
                a = np.degrees(scene.angle[i])
                row.append("" if np.isnan(a) else f"{np.round(a / 0.02) * 0.02 % 360:.2f}")
            row += ["" if gaps[c][i] else f"{scene.channels[c][0][i]:.4f}" for c in channels]
            row.append(scene.mode[i])
            out.writerow(row)


def segment_json(part, scalar, no_angle):
    """What run.json says of a segment."""
    out = {"id": part.id, "kind": "free" if scalar else part.kind, "mode": part.mode, "note": ""}
    if not scalar and part.kind == "rotation":
        out |= {"axis_body": [float(v) for v in part.axis], "axis_cage": [0.0, 0.0, 1.0]}
    if not scalar and part.kind == "static":
        out["body_from_cage"] = np.round(part.at_zero, 9).tolist()
    return out


def publish(out, index, seed, kinds, strength, as_scalar=False):
    """Write one run and its truth."""
    rng, state, names, recordings, scalar, no_angle, near, offset = make_run(seed, kinds, strength, as_scalar)
    run, fresh, noise = state["run"], state["fresh"], state["noise"]
    (reading, reference, _), (fresh_reading, _, fresh_clean) = recordings
    spoil(rng, kinds, reading, noise, strength)
    name = f"b{index:04d}"
    channels = sorted(run.channels)
    write(out / name / "bundle" / "samples.csv", run, reading, reference, channels, scalar, no_angle, True, rng)
    write(
        out / name / "fresh.csv",
        fresh,
        fresh_reading,
        fresh.cage,
        channels,
        scalar,
        no_angle,
        False,
        np.random.default_rng(0),
    )
    meta = {
        "format": "labcal-run/1", "run_id": name, "started_utc": "2026-05-01T08:00:00Z", "simulated": True, "operator": "",
        "dut": {"serial": f"SN{seed % 1000}", "model": "M", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": noise},
        "reference": {"kind": "scalar" if scalar else "vector", "serial": "R"},
        "segments": [segment_json(p, scalar, no_angle) for p in run.parts],
        "channels": {c: {"unit": run.channels[c][1], "quantity": run.channels[c][2]} for c in channels},
    }  # fmt: skip
    if "dut-dipole-at-reference" in kinds:
        meta["reference"]["position_m"] = near.tolist()
    (out / name / "bundle" / "run.json").write_text(json.dumps(meta, indent=1))
    reached = within_reach(fresh, state["lag"])
    truth = np.where(reached[:, None], fresh.body, np.nan)
    np.savetxt(out / name / "truth_fresh.csv", truth, delimiter=",", fmt="%.3f")
    inverse = np.linalg.inv(state["S"])
    knowing = (fresh_clean - offset) @ inverse.T
    truth_body = shift(fresh, -state["lag"]) if state["lag"] else fresh.body
    knew = np.linalg.norm(knowing - truth_body, axis=1)
    knew_size = np.linalg.norm(knowing, axis=1) - np.linalg.norm(truth_body, axis=1)
    truth_json = {"seed": seed, "cause": list(kinds), "strength": strength, "scalar": scalar, "no_angle": no_angle,
             "channels": names, "knowing_rms_nT": float(np.sqrt(np.mean(knew**2))),
             "knowing_magnitude_rms_nT": float(np.sqrt(np.mean(knew_size**2))), "lag_s": state["lag"]}  # fmt: skip
    (out / "truth").mkdir(exist_ok=True)
    (out / "truth" / f"{name}.json").write_text(json.dumps(truth_json))


def within_reach(scene, lag):
    """Rows (n,) whose reading a lag later lies in the same segment: no others can be corrected."""
    ends = [np.concatenate([np.full(len(p.t), p.t[k]) for p in scene.parts]) for k in (0, -1)]
    return (scene.t + lag >= ends[0]) & (scene.t + lag <= ends[1])


def menu(count, seed):
    """Causes and strengths of `count` runs, in a mixed order."""
    rng = np.random.default_rng(seed)
    single = [(k,) for k in (*SENSOR, *RIG, *DATA)]
    out = []
    while len(out) < count:
        turn_ = [(kinds, strength) for kinds in single for strength in STRENGTHS]
        turn_ += [((k,), s) for k in STRANGE for s in (2.0, 10.0)]
        turn_ += [((), 0.0)] * 32
        turn_ += [(p, s) for p in PAIRS for s in (2.0, 10.0)]
        out += [turn_[i] for i in rng.permutation(len(turn_))]
    return out[:count]


SHORT = (
    ((), 0.0), (("axis-tilt",), 2.0), (("saturation",), 2.0), (("telegraph",), 10.0), (("lag", "offset-current"), 2.0),
    (("offset-temperature",), 10.0, True),
)  # fmt: skip


DELICATE = (
    *(((k,), 0.5) for k in ("offset-current", "offset-current-squared", "offset-temperature", "offset-channel",
                            "gain-temperature", "offset-drift", "hysteresis", "periodic", "axis-tilt", "cage-field")),
    (("lag",), 2.0), (("outliers",), 0.5), (("saturation",), 0.5), (("offset-temperature",), 2.0, True),
    *((pair, 2.0) for pair in PAIRS), *(((k,), 2.0) for k in STRANGE),
)  # fmt: skip


def main(out, count, seed):
    """Write `count` runs; one of each class where `count` is `short`, 24 that are hard to judge where `delicate`."""
    named = {"short": SHORT, "delicate": DELICATE}
    runs = named[count] if count in named else menu(int(count), seed)
    for index, run in enumerate(runs):
        publish(Path(out), index, seed * 100000 + index, *run)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
