"""What a magnetometer promises: finite samples in order, with the bytes that they were read from."""

from __future__ import annotations

import numpy as np

from labcal.testing.drivers.rig import DriverCase
from labcal.testing.require import require

READS, EACH_S, FEWEST = 20, 0.37, 40


def it_gives_finite_ordered_samples_with_their_raw_bytes(case: DriverCase) -> None:
    """Twenty reads of 0.37 s of the running stream."""
    rig = case.rig()
    rig.driver.identify()
    rig.driver.start()
    blocks = [b for _ in range(READS) for b in rig.driver.read_until(rig.clock.now() + EACH_S)]
    rig.driver.stop()
    main = [b for b in blocks if b.stream in ("dut", "reference")]
    stamps = np.concatenate([b.t_s for b in main]) if main else np.array([])
    seen = f"{rig.name}.read_until gave {len(stamps)} samples in {READS * EACH_S:.1f} s"
    require(len(stamps) > FEWEST, f"{seen}: above {FEWEST}, in blocks of stream 'dut' or 'reference'.")
    require((np.diff(stamps) > 0).all(), f"{rig.name}: its samples' times do not increase.")
    require(all(np.isfinite(b.values).all() for b in main), f"{rig.name}: a sample is not finite; leave it out.")
    require(all(b.raw for b in main), f"{rig.name}: a block has no raw bytes; the record keeps what was received.")


def it_reads_its_own_frames_again_alike(case: DriverCase) -> None:
    """A driver that can parse the frames of a record again finds the samples that it gave, though blocks are joined."""
    rig = case.rig()
    if (parse_again := getattr(type(rig.driver), "parse_again", None)) is None:
        return
    rig.driver.identify()
    rig.driver.start()
    blocks = [b for _ in range(READS) for b in rig.driver.read_until(rig.clock.now() + EACH_S) if b.raw]
    rig.driver.stop()
    again = parse_again(rig.settings, b"".join(b.raw for b in blocks))
    same = np.array_equal(again, np.vstack([b.values for b in blocks]))
    require(same, f"{rig.name}.parse_again: the raw frames of its blocks, one after the other, give other samples.")


PROMISES = (it_gives_finite_ordered_samples_with_their_raw_bytes, it_reads_its_own_frames_again_alike)
