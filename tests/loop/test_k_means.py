"""What k belongs to is said wherever the loop speaks of its result."""

from __future__ import annotations

from labcal.model import EffectRecord, Parameter
from labcal.model.calibration import k_means

CURRENT = EffectRecord("offset-current", ("i_eps",), {"i_eps": 0.0532}, "sensor", (Parameter("c_x", 1.0, 0.1, "nT/A"),))


def test_k_belongs_to_the_reference_values_of_the_channels() -> None:
    assert k_means([CURRENT]) == "at i_eps = 0.0532 A"
    assert k_means([CURRENT], {"temp_dut": 21.0}) == "at i_eps = 0.0532 A, temp_dut = 21"
    assert k_means([]) == ""
