"""The independent lab's recordings as runs of labcal."""

from __future__ import annotations

from collections.abc import Callable

import lab
import numpy as np
import pytest

from labcal.record import Channel, Dut, Reference, Run, Segment


def as_run(found: lab.Recorded) -> Run:
    """What labcal is told of a recording."""
    d = found.declared
    vector = d.kind == "vector"
    stated = {"u_scale_ppm": d.scale_ppm, "u_offset_nT": d.zero_nT, "u_align_deg": d.align_deg if vector else None}
    segments = tuple(Segment(**{**s, "u_axis_body_deg": d.body_deg}) for s in found.segments)
    return Run(
        run_id="made",
        started_utc="2026-05-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("P1", noise_nT=found.noise_nT),
        reference=Reference(d.kind, "R", noise_nT=lab.REFERENCE_NOISE_nT, place="dut", **stated),
        segments=segments,
        t_s=found.t_s,
        segment_index=found.segment.astype(np.intp),
        reading=found.reading,
        reference_vector=found.reference if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(found.reference, axis=1),
        angle_deg=found.angle_deg if vector else None,
        channels=(Channel("i_eps", "A", "current", found.current_A),),
    )


@pytest.fixture
def recorded() -> Callable[..., tuple[Run, lab.Recorded]]:
    """A run of the independent lab, and its truth."""

    def make(seed: int, declared: lab.Declared, **more: object) -> tuple[Run, lab.Recorded]:
        found = lab.record(seed, declared, **more)
        return as_run(found), found

    return make
