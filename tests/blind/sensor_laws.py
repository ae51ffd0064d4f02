"""Runs of a sensor that keeps a physicist's laws, not a textbook's: `sensor_laws.py OUT COUNT SEED [INDEX]`.

Jiles & Atherton (1986) and Preisach cores, two poles, tanh, a transverse field in the sensing film, a gain and a zero
bent in temperature, heating unlike cooling, power cycles, a clock that drifts, mains folded into the band. The reading
is in counts. Written from the contract alone; it shares nothing with labcal, nor with the other programs here.
"""

import csv
import json
import math
import pathlib
import sys

import numpy as np
from laws_bench import Bench, octave, stray

IDS = {
    "jiles-atherton": "hysteresis", "preisach": "hysteresis", "two-poles": "lag", "clock": "lag",
    "tanh": "nonlinearity", "gain-of-warmth": "gain-temperature", "zero-of-warmth": "offset-temperature",
    "heating-cooling": "offset-temperature", "gain-at-power-cycle": "gain-step", "zero-at-power-cycle": "offset-step",
    "mains": "periodic", "transverse": "cross-field", "rail": "saturation",
}  # fmt: skip
NO_ID = {"popcorn": [], "warm-square": ["gain-temperature"]}  # and what names its right channel
MORE = {"jiles-atherton": ["nonlinearity"], "preisach": ["nonlinearity"]}  # the loop's middle line is bent as well
LATE = ("two-poles", "clock")
STILL_C = 0.5  # a temperature that moves less drives nothing


def atherton(rng, fields):
    """Magnetisation of three cores, by Jiles & Atherton's equation; each field (n, 3) goes on where the last ended."""
    a, pin = octave(rng, 12e3, 50e3), octave(rng, 2e3, 15e3)
    alpha, bends = rng.uniform(0, 0.6) * 3 * a, rng.uniform(0.05, 0.6)
    M, last, out = np.zeros(3), np.zeros(3), []

    def langevin(x):
        small = np.abs(x) < 1e-3
        y = np.where(small, 1.0, x)
        return np.where(small, x / 3, 1 / np.tanh(y) - 1 / y)

    for path in fields:
        kept = np.empty_like(path)
        for i, H in enumerate(path):
            steps = max(1, int(np.max(np.abs(H - last)) / 1500))
            for _ in range(steps):
                dH = (H - last) / steps
                x = (H + alpha * M) / a
                lacking = langevin(x) - M
                opposed = np.maximum(pin - alpha * np.abs(lacking), 1e-6)  # none left: a jump, as steep as may be
                slope = np.where(lacking * dH > 0, np.abs(lacking) / opposed, 0.0)
                bent = 1 / (3 * a) / (1 + x * x / 5)
                M = M + ((1 - bends) * np.clip(slope, 0, 3 / a) + bends * bent) * dH
            last = H.copy()
            kept[i] = M
        out.append(kept)
    return out


def preisach(rng, fields):
    """The mean of relays whose thresholds are spread as in a real core: coercive fields log-normal, middles normal."""
    half = np.exp(rng.normal(math.log(octave(rng, 1500, 9000)), 0.6, 300))
    middle = rng.normal(0, octave(rng, 5e3, 25e3), 300)
    state, out = rng.choice([-1.0, 1.0], (3, 300)), []
    for path in fields:
        kept = np.empty_like(path)
        for i, H in enumerate(path):
            state = np.where(H[:, None] > middle + half, 1.0, np.where(H[:, None] < middle - half, -1.0, state))
            kept[i] = state.mean(axis=1)
        out.append(kept)
    return out


def core(bench, model):
    """What a core's memory adds, (n, 3), over all legs in their order."""
    paths = [leg.world(t)[1] @ bench.map.T for leg, t in zip(bench.legs, bench.fine(), strict=True)]
    states = model(bench.rng, paths)
    rows = [np.stack([np.interp(leg.t, t, s) for s in kept.T], axis=1)
            for leg, t, kept in zip(bench.legs, bench.fine(), states, strict=True)]  # fmt: skip
    return np.concatenate(rows) * bench.rng.uniform(0.4, 1.6, 3)


def unlike_ways(bench):
    """Temperature with its own backlash: the zero of heating is not the zero of cooling."""
    half, y, out = bench.rng.uniform(0.1, 0.35) * np.ptp(bench.T), bench.T[0], np.empty_like(bench.T)
    for i, T in enumerate(bench.T):
        y = min(max(y, T - half), T + half)
        out[i] = y
    return out - 20 + bench.rng.uniform(0, 0.5) * (bench.T - out)


def law(bench, kind):
    """An effect (n, 3) in the reading, nT, of some size."""
    rng, h, T = bench.rng, bench.body @ bench.map.T / 50e3, bench.T - 20
    c, cycled = rng.normal(size=3), int(rng.integers(3, len(bench.legs) - 3))
    after = bench.t > bench.legs[cycled].t[0]
    if kind in ("jiles-atherton", "preisach"):
        return core(bench, atherton if kind == "jiles-atherton" else preisach)
    if kind == "tanh":
        knee = octave(rng, 0.8, 4)
        return (knee * np.tanh(h / knee) - h) * rng.uniform(0.3, 1.5, 3)
    if kind == "gain-of-warmth":
        return h * c * (T + rng.normal(0, 0.03) * T**2)[:, None]
    if kind == "zero-of-warmth":
        return c * (T + octave(rng, 0.003, 0.05) * rng.choice([-1, 1]) * T**2)[:, None]
    if kind == "heating-cooling":
        return c * unlike_ways(bench)[:, None]
    if "power-cycle" in kind:
        bench.of_unknown_side = cycled if bench.legs[cycled].fresh else cycled - 1  # between two legs of the run
    if kind == "gain-at-power-cycle":
        return h * (c if rng.random() < 0.5 else np.ones(3)) * after[:, None]
    if kind == "zero-at-power-cycle":
        return c * after[:, None]
    if kind == "mains":
        line = rng.choice([50.0, 60.0]) * (1 + rng.normal(0, 2e-4))
        return c * np.sin(2 * math.pi * line * bench.t[:, None] + rng.uniform(0, 6, 3))
    if kind == "transverse":
        stiff = rng.uniform(3, 12)
        return -h * np.roll(h, int(rng.integers(1, 3)), axis=1) / stiff * rng.uniform(0.4, 1.6, 3)
    if kind == "popcorn":
        return c * (np.searchsorted(np.cumsum(rng.exponential(octave(rng, 8, 80), 9000)), bench.t) % 2)[:, None]
    return c * (T * np.sum(h * h, axis=1))[:, None]  # warm-square


def delay(bench, kind, wanted):
    """Poles or clock that leave `wanted` nT: the size is drawn to in steps."""
    rng, scale = bench.rng, 0.1
    ratio, ppm = rng.uniform(0.1, 1), octave(rng, 50, 2000) * 1e-6 * rng.choice([-1, 1])
    sign, share = rng.choice([-1, 1]), rng.uniform(0.2, 1)

    def of(s):
        if kind == "two-poles":
            return (s, ratio * s), 0.0, 0.0
        return (), sign * share * s, ppm * min(s, 1.0)

    for _ in range(8):
        scale = min(scale * wanted / bench.left((bench.seen(of(scale)) - bench.body) @ bench.map.T), 2.5)
    return of(scale)


def knowing_error(bench, seen, reading, shapes, usable):
    """Rms length on fresh rows of a least-squares fit that is given the true shapes."""
    X = np.column_stack([seen, np.ones(len(seen)), *shapes])
    run, new = ~bench.fresh & usable, bench.fresh & usable
    scale = np.linalg.norm(X[run], axis=0) + 1e-12
    fit = np.linalg.pinv(X[run] / scale, rcond=1e-9) @ reading[run] / scale[:, None]
    back = (reading[new] - X[new, 3:] @ fit[3:]) @ np.linalg.inv(fit[:3])
    return float(np.sqrt(np.mean(np.sum((back - seen[new]) ** 2, axis=1))))


def put_down(folder, bench, counts, channels, meta):
    """Bundle, fresh rows and their truth."""
    rng = np.random.default_rng([17, len(bench.t)])
    reference = bench.cage + rng.normal(0, 4.0, bench.cage.shape)
    (folder / "bundle").mkdir(parents=True, exist_ok=True)
    for path, fresh in ((folder / "bundle" / "samples.csv", False), (folder / "fresh.csv", True)):
        with path.open("w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(["t_s", "segment", "angle_deg", "dut_x", "dut_y", "dut_z",
                          *([] if fresh else ["ref_x", "ref_y", "ref_z"]), *channels])  # fmt: skip
            for i in np.flatnonzero(bench.fresh == fresh):
                leg = bench.legs[bench.leg_of[i]]
                angle = ["" if leg.angle is None else f"{math.degrees(leg.angle(bench.t[i])) + leg.zero:.2f}"]
                ref = [] if fresh else [f"{v:.1f}" for v in reference[i]]
                values = [f"{v[0][i]:.4g}" for v in channels.values()]
                out.writerow([f"{bench.t[i]:.5f}", leg.name, *angle, *(int(c) for c in counts[i]), *ref, *values])
    (folder / "bundle" / "run.json").write_text(json.dumps(meta))


def stray_channels(bench, count):
    """Channels of nobody's (n,), with unit and quantity."""
    sorts = [("supply_V", "V", "voltage"), ("humidity", "%", "humidity"), ("board_C", "degC", "temperature"),
             ("draw_A", "A", "current"), ("vacuum_hPa", "hPa", "pressure")]  # fmt: skip
    out = {}
    for k in bench.rng.permutation(len(sorts))[:count]:
        name, unit, quantity = sorts[k]
        out[name] = (np.interp(bench.t, bench.grid, 5 + stray(bench.rng, bench.grid)), unit, quantity)
    return out


def stated(bench, name, lsb, noise, channels):
    """The bundle's run.json."""
    segments = [{"id": leg.name, "mode": "nominal", "note": "", **leg.segment} for leg in bench.legs if not leg.fresh]
    return {
        "format": "labcal-run/1", "run_id": name, "started_utc": "2026-06-11T06:00:00Z", "simulated": True,
        "operator": "", "segments": segments, "reference": {"kind": "vector", "serial": "F3", "noise_nT": 4.0},
        "dut": {"serial": "L1", "model": "film", "unit": "count", "nominal_nT_per_unit": lsb, "noise_nT": noise},
        "channels": {c: {"unit": v[1], "quantity": v[2]} for c, v in channels.items()},
    }  # fmt: skip


def usable_rows(bench, reading, top):
    """Rows (n,) that can be corrected at all: off the rail, no ends of late legs, no leg beside a power cycle."""
    usable = np.all(np.abs(reading) < top, axis=1) & (bench.leg_of != bench.of_unknown_side)
    if bench.late is not None:
        poles, offset, drift = bench.late
        reach = 3 * sum(poles) + abs(offset) + abs(drift) * bench.end
        ends = np.array([[leg.t[0], leg.t[-1]] for leg in bench.legs])[bench.leg_of]
        usable &= (bench.t > ends[:, 0] + reach) & (bench.t < ends[:, 1] - reach)
    return usable


def make(out, index, seed, kinds, strengths, decoys):
    """One run and its truth."""
    rng = np.random.default_rng([seed, index, 3])
    needs_warmth = any("warm" in k or "heating" in k for k in kinds)
    bench = Bench(rng, bool(set(kinds) & set(LATE)))
    while needs_warmth and np.ptp(bench.T[~bench.fresh]) < STILL_C:  # no effect of a temperature would stick out
        bench = Bench(rng, bool(set(kinds) & set(LATE)))
    noise = round(octave(rng, 8, 60), 2)
    lsb = float(f"{noise * octave(rng, 0.05, 1.5):.3g}")
    total, shapes, rms, top = np.zeros_like(bench.body), [], {}, math.inf
    for kind, strength in zip(kinds, strengths, strict=True):
        if kind == "rail":
            continue
        if kind in LATE:
            bench.late = delay(bench, kind, strength * noise)
            rms["lag"] = bench.left((bench.seen(bench.late) - bench.body) @ bench.map.T) / noise
            continue
        effect = law(bench, kind)
        effect *= strength * noise / bench.left(effect)
        rms[IDS.get(kind, kind)] = bench.left(effect) / noise
        total, shapes = total + effect, [*shapes, effect]
    seen = bench.seen(bench.late)
    reading = seen @ bench.map.T + bench.zero + total
    if "rail" in kinds:
        top = float(np.quantile(np.abs(reading), rng.uniform(0.93, 0.99)))
        rms["saturation"] = float(np.std(reading - np.clip(reading, -top, top))) / noise
    usable = usable_rows(bench, reading, top)
    noisy = np.clip(reading + rng.normal(0, noise, reading.shape), -top, top)
    counts = np.round(noisy / lsb)
    warm = {"sensor_C": (np.round(bench.T / 0.05) * 0.05, "degC", "temperature")}
    channels = {**(warm if needs_warmth or rng.random() < 0.6 else {}), **stray_channels(bench, decoys)}
    name = f"b{index:04d}"
    put_down(out / name, bench, counts, channels, stated(bench, name, lsb, noise, channels))
    truth = np.where(usable[:, None], bench.body, np.nan)[bench.fresh]
    np.savetxt(out / name / "truth_fresh.csv", truth, delimiter=",", fmt="%.3f")
    told = {
        "simulator": "sensor_laws", "seed": seed, "index": index, "kinds": kinds,
        "cause": sorted({IDS[k] for k in kinds if k in IDS}), "unnamed": [k for k in kinds if k in NO_ID],
        "not_wrong": [i for k in kinds for i in {**NO_ID, **MORE}.get(k, [])], "noise_nT": noise, "lsb_nT": lsb,
        "rms_over_noise": {k: round(v, 3) for k, v in rms.items()}, "late": bench.late,
        "decoys": [c for c in channels if c != "sensor_C" or not needs_warmth],
        "knowing_rms_nT": knowing_error(bench, seen, counts * lsb, shapes, usable),
    }  # fmt: skip
    (out / "truth").mkdir(exist_ok=True)
    (out / "truth" / f"{name}.json").write_text(json.dumps(told))


def plan(count, seed):
    """What acts in each run: of 36, eight nulls, sixteen single causes, ten pairs, two that no id names."""
    rng, single, out = np.random.default_rng([seed, 4]), list(IDS), []
    while len(out) < count:
        some = [((), ()) for _ in range(8)]
        some += [((k,), (octave(rng, 2, 30),)) for k in single]
        some += [((single[int(rng.integers(len(single)))],), (octave(rng, 0.5, 2),)) for _ in range(3)]
        some += [(pair_of(rng, single), (octave(rng, 10, 25), octave(rng, 2, 4))) for _ in range(10)]
        some += [((k,), (octave(rng, 3, 20),)) for k in NO_ID]
        out += [(*some[k], int(rng.integers(0, 4))) for k in rng.permutation(len(some))]
    return out[:count]


def pair_of(rng, single):
    """Two laws with two ids."""
    while True:
        one, other = (single[k] for k in rng.permutation(len(single))[:2])
        if IDS[one] != IDS[other]:
            return one, other


if __name__ == "__main__":
    number, root_seed, *wanted = map(int, sys.argv[2:])
    for at, case in enumerate(plan(number, root_seed)):
        if wanted in ([], [at]):
            make(pathlib.Path(sys.argv[1]), at, root_seed, *case)
