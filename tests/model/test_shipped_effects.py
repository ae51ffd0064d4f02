"""Effects of a calibration file that came from anywhere: whole ones load, all others are a sentence."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.model import EffectRecord, Parameter
from labcal.model.effects import Term, families, load_shipped
from labcal.record import Channel, Dut, Reference, Run, Segment


def measured() -> Run:
    """A run that offers something to every effect of the sensor."""
    n, t = 400, np.arange(400.0)
    kinds = (("temperature", "degC"), ("current", "A"), ("voltage", "V"))
    channels = tuple(Channel(kind, unit, kind, np.sin(t / (9 + i))) for i, (kind, unit) in enumerate(kinds))
    return Run(
        run_id="r",
        started_utc="2026-11-21T08:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("S"),
        reference=Reference("scalar"),
        segments=(Segment("s", "free"),),
        t_s=t,
        segment_index=np.zeros(n, dtype=np.intp),
        reading=3e4 * np.column_stack([np.cos(t / 20), np.sin(t / 20), np.cos(t / 7)]),
        reference_magnitude=np.full(n, 4e4),
        row_mode=np.where(t < 200, "nominal", "full power"),
        channels=channels,
    )


def shipped(effect: str, term: Term) -> EffectRecord:
    """What a calibration file says of `form`."""
    stated = [Parameter(s.name, s.grid[0] if s.grid else s.value, 0.0, s.unit) for s in term.shape]
    stated += [Parameter(name, 1.0, 0.1, unit) for name, unit in term.parameters]
    return EffectRecord(effect, term.channels, term.reference_value, "sensor", tuple(stated))


OURS = [f for f in families() if f.kernel.__module__.startswith("labcal.")]
BUILT = ("empirical",)  # by the loop from what its search leaves: tests/loop/test_empirical.py


@pytest.mark.parametrize("effect", [f.id for f in OURS if f.belongs_to == "sensor" and f.id not in BUILT])
def test_every_form_that_a_fit_may_find_loads_from_its_file(effect: str) -> None:
    run = measured()
    (family,) = (f for f in families() if f.id == effect)
    terms = family.candidates(run)
    assert terms
    for term in terms:
        assert load_shipped(shipped(effect, term)).term.parameters == term.parameters


def record(effect: str, names: str, channels: str = "", reference: dict[str, float] | None = None, value: float = 1.0):
    parameters = tuple(Parameter(name, value, 0.1, "") for name in names.split(","))
    there = tuple(channels.split(",")) if channels else ()
    return EffectRecord(
        effect, there, dict.fromkeys(there, 0.0) if reference is None else reference, "sensor", parameters
    )


@pytest.mark.parametrize(
    ("stated", "says"),
    [
        (record("warp", "c_x,c_y,c_z"), "no installed package"),
        (record("axis-tilt", "cage_x"), "is the rig's"),
        (record("offset-current", "c_x,c_y", "i"), "not those of its formula"),
        (record("offset-current", "c_x,c_y,c_z,c_w", "i"), "not those of its formula"),
        (record("offset-current", "c_x,c_x,c_x", "i"), "twice"),
        (record("offset-current", "c_z,c_y,c_x", "i"), "order x, y, z"),
        (record("offset-current", "c_x,c_y,c_z"), "not those of its formula"),
        (record("offset-current", "c_x,c_y,c_z", "i", {}), "reference value"),
        (record("offset-current", "c_x,c_y,c_z", "segment"), "a name of its own"),
        (record("lag", "lag_s"), "lacks its parameter secant_s"),
        (record("lag", "secant_s,lag_s", value=0.0), "give no numbers"),
        (record("hysteresis", "q_x,q_y,q_z"), "not those of its formula"),
        (record("nonlinearity", "a,b,c"), "not those of its formula"),
        (record("cross-field", "q_w:ab"), "not those of its formula"),
        (record("gain-temperature", "g1,g2,g3,g4,g5", "t"), "not those of its formula"),
        (record("offset-drift", "t_ref_s"), "not those of its formula"),
        (record("offset-mode", "x,y,z"), "not those of its formula"),
        (record("offset-step", "c_x,c_y,c_z"), "lacks its parameter t_step_s"),
    ],
)
def test_an_effect_that_is_not_whole_is_refused_in_words(stated: EffectRecord, says: str) -> None:
    with pytest.raises(InputError, match=says):
        load_shipped(stated)
