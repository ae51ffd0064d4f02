"""A bench that is served, its simulated twin and a real one differ, whatever they are called."""

import pytest

from labcal.record.bench_kind import REAL, SERVED, SIMULATED, bench_kind

SUPPLY, STAGE = (f'[instruments.{name}]\nlink = "{{}}"\n' for name in ("supply_x", "stage"))


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        (SUPPLY.format("emulated://") + STAGE.format("emulated://"), SIMULATED),
        ("served = true\n" + SUPPLY.format("tcp://127.0.0.1:4001") + STAGE.format("emulated://"), SERVED),
        (SUPPLY.format("tcp://10.0.0.4:4001") + STAGE.format("emulated://"), REAL),
        ("", ""),
        ("name = ", ""),
        ("instruments = 3", ""),
        ("[instruments.stage]\nrole = 2", ""),
    ],
)
def test_the_file_tells(text, kind):
    assert bench_kind(text) == kind
