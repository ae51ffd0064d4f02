"""The list of runs says of one that was interrupted on which bench it was begun, and who answered there."""

import pytest

from labcal.record import Dut, Reference, RunHeader
from labcal.store import Store, list_runs

SUPPLY = {"name": "supply_x", "manufacturer": "TTi", "model": "PL303", "serial": "0042", "firmware": ""}


def recorded(ended: str, bench: str) -> None:
    dut = Dut("EM-07", "fluxgate", "nT", 1.0, None)
    header = RunHeader(
        "r1", "2026-01-05T07:00:00Z", False, "J. Doe", dut, Reference("none"), bench=bench, instruments=(SUPPLY,)
    )
    with Store.open() as store:
        store.begin(header).finish(ended)


def test_an_interrupted_run_names_its_bench_and_its_instruments() -> None:
    recorded("interrupted", 'name = "cage of hall 2"\n[cage]\n')
    [one] = list_runs()
    assert (one.status, one.bench) == ("interrupted", "cage of hall 2")
    assert one.instruments == (("supply_x", "TTi PL303 0042"),)


@pytest.mark.parametrize(("ended", "bench"), [("finished", 'name = "a cage"'), ("interrupted", "no = bench = file")])
def test_nothing_is_read_of_what_has_ended_or_cannot_be_read(ended: str, bench: str) -> None:
    recorded(ended, bench)
    [one] = list_runs()
    assert (one.status, one.bench, one.instruments) == (ended, "", ())
