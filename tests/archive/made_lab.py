"""A lab's finished runs and signed calibrations: made directly, as a preflight and a person leave them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import audit, certificate
from labcal.certificate import sshsig
from labcal.files.home import home
from labcal.record import Dut, Reference, RunHeader, Segment
from labcal.record.stream import Block, SegmentClosed, SegmentOpened
from labcal.store import Store

GOLDEN = Path(__file__).parents[1] / "golden"
BLOCK = 1000  # rows
RECORDINGS = 50  # that differ: more would only take longer, for each run is compressed by itself


def stored_runs(numbers: Iterable[int], samples: int) -> None:
    """Runs called size-0, size-1 …, of five hundred sensors."""
    with Store.open() as store:
        for number in numbers:
            record(store, number, samples)


def signed_calibrations(number: int) -> None:
    """Each beside its signature, and that in the audit log."""
    key, folder = Ed25519PrivateKey.generate(), home() / "calibrations"
    folder.mkdir(parents=True, exist_ok=True)
    made = certificate.read_calibration(GOLDEN / "calibration-2.json")
    for one in range(number):
        content = certificate.calibration_bytes(replace(made, run_id=f"years-{one}"))
        signature = sshsig.sign(content, key).encode()
        path = folder / f"years-{one}.json"
        path.write_bytes(content)
        path.with_name(f"{path.name}.sshsig").write_bytes(signature)
        audit.append(home(), "sign", "ada", {"file": path.name, "signature": audit.link_of(signature)})


@cache
def recording(number: int, samples: int) -> dict[str, list[Block]]:
    """What DUT and reference sent, raw lines included."""
    draw, t_s = np.random.default_rng(number), np.arange(samples) / 40
    found = dict[str, list[Block]]()
    for role in ("dut", "reference"):
        columns = tuple(f"{role[:3]}_{axis}" for axis in "xyz")
        values = draw.normal(0, 3e4, (samples, 3)).round(1)
        lines = [f"{t:.3f},{x},{y},{z}\r\n".encode() for t, (x, y, z) in zip(t_s, values.tolist(), strict=True)]
        pieces = [slice(first, first + BLOCK) for first in range(0, samples, BLOCK)]
        found[role] = [Block(role, role, columns, t_s[r], values[r], b"".join(lines[r])) for r in pieces]
    return found


def record(store: Store, number: int, samples: int) -> None:
    """A run with a reference, as a preflight writes it."""
    dut = Dut(f"S{number % 500:04}", "M3")
    header = RunHeader(f"size-{number}", "2026-05-01T10:00:00Z", True, "ada", dut, Reference("vector", "R7"))
    with store.begin(header) as writer:
        writer.write(SegmentOpened(0.0, Segment("all", "free")))
        for blocks in zip(*recording(number % RECORDINGS, samples).values(), strict=True):
            for block in blocks:
                writer.write(block)
        writer.write(SegmentClosed((samples - 1) / 40))
        writer.finish("finished")
