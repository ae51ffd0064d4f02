"""The line on the simulated lab, from preflight to signature: what it must find is known."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from pathlib import Path

from labcal import session
from labcal.demo import Demo, demo
from labcal.demo.folder import CALIBRATION, TRUST, make_room
from labcal.self_test.result import Check, guarded

SEED = 0
CAUSE = ("offset-current", "i_eps")  # what the simulated DUT of this seed suffers
NEAR_NOISE = 1.15  # held-out error over that of noise alone, as in the loop's own verdict
Begin = Callable[[str], None]


def check_line(folder: Path, begin: Begin = lambda name: None) -> Iterator[Check]:
    """Preflight, loop and signature on the simulated lab, which leaves its files in `folder`."""
    begun, done = time.monotonic(), list[Demo]()

    def preflight() -> Check:
        make_room(folder)
        done.append(demo(folder, SEED, stage=lambda name: begin(f"simulated {name}"), on_item=lambda item: None))
        return check_preflight(done[0], time.monotonic() - begun)

    yield guarded("simulated preflight", preflight)
    if done:
        yield guarded("closed loop", lambda: check_loop(done[0]))
        yield guarded("signature", lambda: check_signature(done[0]))


def check_preflight(done: Demo, took_s: float) -> Check:
    """It met every limit."""
    missed = ", ".join(measured.name for measured in done.limits_missed)
    if missed:
        return Check("", "FAIL", f"limits were not met that this simulated lab meets: {missed}")
    return Check("", "pass", f"{done.rows} samples, all limits met; preflight, loop and signature took {took_s:.0f} s")


def check_loop(done: Demo) -> Check:
    """It found the effect that is there, and no other, and came down to the noise."""
    closed = done.closed
    named = [(one.effect, *one.channels) for one in closed.accepted]
    before, after, floor = closed.before.holdout_rms_nT, closed.after.holdout_rms_nT, closed.noise_floor_nT
    said = f"{closed.verdict}: {', '.join(map(' '.join, named)) or 'no effect'}; held out {before:.1f} → {after:.1f} nT"
    sound = closed.verdict == "explained" and named == [CAUSE] and after < NEAR_NOISE * floor
    return Check("", "pass" if sound else "FAIL", f"{said}, noise alone {floor:.1f} nT")


def check_signature(done: Demo) -> Check:
    """It holds, and of a file in which one digit was changed it does not."""
    path = done.folder / CALIBRATION
    if not done.verification.valid:
        return Check("", "FAIL", "the signature that was just made does not hold")
    content = path.read_bytes()
    path.write_bytes(content.replace(b'"run_sha256":"', b'"run_sha256":"0', 1))
    try:
        forged = session.verify(path, done.folder / TRUST).valid
    finally:
        path.write_bytes(content)
    if forged:
        return Check("", "FAIL", "the signature holds of a file that was changed after it")
    return Check("", "pass", "made, it holds; of the same file with one digit more it does not")
