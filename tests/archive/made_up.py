"""Years of several labs, row by row into the catalogue: nobody waits for five thousand preflights."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import cached_property
from hashlib import sha256

import numpy as np
from postgres import Server

FIGURES = tuple(f"{figure} {axis}" for figure in ("offset", "scale", "angle") for axis in "xyz")
MODELS, REFERENCES, U_NT = 5, 20, 3.0
BEGIN = datetime(2016, 1, 1, tzinfo=UTC)
SAMPLES = 20_000  # of a run


@dataclass(frozen=True)
class Years:
    """`sensors` of five models, each calibrated `runs` times; every seventh drifts a little more each year."""

    sensors: int
    runs: int

    @cached_property
    def offsets(self) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
        """Each figure of each calibration (sensors, runs, 9): most stay, some jump by ten times u."""
        draw = np.random.default_rng(5)
        jumps = 10 * U_NT * (draw.random((self.sensors, self.runs, len(FIGURES))) < 0.02)
        return np.cumsum(jumps, axis=1) + draw.normal(0, U_NT / 4, jumps.shape)

    def began(self, sensor: int, run: int) -> datetime:
        return BEGIN + timedelta(days=365 * run, minutes=sensor)

    def reference(self, sensor: int, run: int) -> str:
        return f"R{(3 * sensor + run) % REFERENCES}"

    def drift(self, sensor: int, run: int) -> float:
        """In nT/s; 0 is none."""
        return 1e-3 * run if sensor % 7 == 0 else 0.0

    def all(self) -> Iterable[tuple[int, int]]:
        return ((sensor, run) for sensor in range(self.sensors) for run in range(self.runs))

    def touched(self, reference: str, since: datetime) -> set[str]:
        """Runs with this reference since then."""
        return {name(*one) for one in self.all() if self.reference(*one) == reference and self.began(*one) >= since}

    def changed(self) -> set[str]:
        """Runs of which a figure is further from the year before than 2 √2 u."""
        moved = np.abs(np.diff(self.offsets, axis=1)).max(axis=2) > 2 * np.hypot(U_NT, U_NT)
        return {name(int(sensor), int(run) + 1) for sensor, run in np.argwhere(moved)}

    def drifting(self, model: int, above: float) -> set[str]:
        return {name(s, r) for s, r in self.all() if s % MODELS == model and self.drift(s, r) > above}


def name(sensor: int, run: int) -> str:
    return f"run-{sensor}-{run}"


def fill(server: Server, database: str, years: Years) -> None:
    """Write all of it."""
    runs, made, effects, parameters, instruments = ([] for _ in range(5))
    for s, r in years.all():
        site, digest = ("aalto", "glasgow")[s % 2], sha256(name(s, r).encode()).hexdigest()
        of_run, dut, model = f"{digest[:-4]}0000", f"S{s:04}", f"M{s % MODELS}"
        sensor = (True, dut, model, "nT", "ada")
        began, reference = years.began(s, r), years.reference(s, r)
        runs.append(
            (site, of_run, name(s, r), began, "finished", *sensor, "preflight", "vector", reference, SAMPLES, "-", 1)
        )
        made.append((site, digest, of_run, name(s, r), *sensor, b"{}"))
        instruments += [
            (site, of_run, 0, "reference", "", "", reference, ""),
            (site, digest, 0, "reference", "", "", reference, ""),
        ]
        instruments += [
            (site, of_run, n, f"coil {axis}", "Aim-TTi", "PL155", f"C{s % 3}{axis}", "")
            for n, axis in enumerate("xyz", 1)
        ]
        rows = [("map", f"K_{n}", 1.0, 1e-5, "nT/nT") for n in range(9)] + [
            ("map", f"k_{a}", 100.0, U_NT, "nT") for a in "xyz"
        ]
        rows += [("figure", f, float(v), U_NT, "nT") for f, v in zip(FIGURES, years.offsets[s, r], strict=True)]
        if drift := years.drift(s, r):
            effects.append((site, digest, 0, "offset-drift", "sensor", "", False))
            rows += [
                ("offset-drift", f"c1_{a}", sign * drift, 1e-5, "nT/s")
                for a, sign in zip("xyz", (0.1, -1, 0.5), strict=True)
            ]
        parameters += [(site, digest, n, *row) for n, row in enumerate(rows)]
    columns = "site sha256 run_id started_utc status simulated dut_serial dut_model dut_unit operator procedure "
    columns += "reference_kind reference_serial n_samples bundle_sha256 bundle_bytes"
    copy(server, database, "run", columns, runs)
    copy(
        server,
        database,
        "calibration",
        "site sha256 run_sha256 run_id simulated dut_serial dut_model dut_unit operator content",
        made,
    )
    copy(server, database, "effect", "site calibration number effect belongs_to channels provisional", effects)
    copy(server, database, "parameter", "site calibration number of name value u unit", parameters)
    copy(server, database, "instrument", "site of number name manufacturer model serial firmware", instruments)


def copy(server: Server, database: str, table: str, columns: str, rows: Sequence[tuple[object, ...]]) -> None:
    names = ", ".join(f'"{column}"' for column in columns.split())
    with server.connect(database) as connection, connection.cursor() as cursor:
        with cursor.copy(f"COPY labcal.{table} ({names}) FROM STDIN") as into:
            for row in rows:
                into.write_row(row)
        cursor.execute(f"ANALYZE labcal.{table}")
