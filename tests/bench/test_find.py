"""`bench find`: who answers on the lines of a served bench, and a draft that is refused until limits are stated."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.config import read_config
from labcal.bench.find import Found, draft, find, places
from labcal.bench.loading import recogniser
from labcal.bench.serve import serve
from labcal.cli import execute
from labcal.errors import InputError

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
PATIENCE_S = 60.0
MORE = {  # what stands in place of the example's own
    'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-y"': 'driver = "scpi-table"\nlink = "emulated://"\n'
    'role = "coil-y"\nsettings = { model = "siglent-spd3303x" }',
    'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-z"': 'driver = "microcontroller"\nlink = "emulated://"\n'
    'role = "coil-z"',
}


@pytest.fixture(scope="module")
def links(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The lines of a served lab, by instrument: at the head of each what a person would know, and no more."""
    if sys.platform == "win32":
        pytest.skip("Windows has no ptys")
    folder, ready, text = tmp_path_factory.mktemp("lab"), threading.Event(), EXAMPLE.read_text()
    for old, new in MORE.items():
        assert old in text
        text = text.replace(old, new)
    (folder / "bench.toml").write_text(text)
    words = (folder / "bench.toml", folder / "served.toml", ready.set)
    threading.Thread(target=serve, args=words, daemon=True).start()
    assert ready.wait(PATIENCE_S)
    served = read_config(folder / "served.toml")
    return {name: entry.link for name, entry in served.instruments.items()}


def found_at(link: str) -> Found:
    scheme, _, rest = link.partition("://")
    place = link if scheme == "tcp" else f"serial://{rest.partition('?')[0]}"
    (one,) = find([place], RealClock(), recogniser("scpi-table"))
    return one


@pytest.fixture(scope="module")
def found(links: dict[str, str]) -> Iterator[dict[str, Future[Found]]]:
    """Who answers on each line. All at once: most of it is waiting for an answer at a wrong rate."""
    with ThreadPoolExecutor(len(links)) as at_once:
        yield {name: at_once.submit(found_at, link) for name, link in links.items()}


@pytest.mark.parametrize(
    ("name", "driver", "settings"),
    [
        ("supply_x", "tti-pl", ""),
        ("supply_y", "scpi-table", 'model = "siglent-spd3303x"'),
        ("supply_z", "microcontroller", ""),
        ("stage", "zaber", ""),
        ("reference", "hmr2300", ""),
        ("reversers", "waveshare-relay", ""),
        ("dut", "csv-line", ""),
    ],
)
def test_each_is_known_by_its_answer_at_its_own_baud_rate(
    links: dict[str, str], found: dict[str, Future[Found]], name: str, driver: str, settings: str
) -> None:
    one = found[name].result(PATIENCE_S)
    assert (one.driver, one.settings) == (driver, settings)
    assert one.link.rpartition("://")[2] == links[name].rpartition("://")[2]


def test_the_draft_is_refused_until_limits_are_stated(tmp_path: Path) -> None:
    found = [Found("tcp://10.0.0.5:9221", "THURLBY THANDAR, PL303-P, 1, 1", "tti-pl", "coil"),
             Found("serial:///dev/ttyUSB0?baud=9600", 'ACME "X", 1')]  # fmt: skip
    (path := tmp_path / "bench.toml").write_text(draft(found))
    with pytest.raises(InputError, match="is missing"):
        read_config(path)
    stated = (
        draft(found).replace("# current_A =  ", "current_A = 2.0 #").replace("# ramp_A_per_s =", "ramp_A_per_s = 2.0 #")
    )
    stated = stated.replace("# field_nT =", "field_nT = 1e5 #").replace("# serial = ", "serial = 'A' # ")
    path.write_text(stated.replace("# constants_nT_per_A = [ , , ]", "constants_nT_per_A = 5e4 #"))
    with pytest.raises(InputError, match=r"tti_pl_1\.role is missing"):
        read_config(path)


def test_places_are_links_devices_and_hosts() -> None:
    assert places(["/dev/ttyUSB7", "tcp://h:1", "/dev/usbtmc1"]) == [
        "serial:///dev/ttyUSB7",
        "tcp://h:1",
        "usbtmc:///dev/usbtmc1",
    ]
    assert {"tcp://10.0.0.5:5025", "modbus-tcp://10.0.0.5:502"} <= set(places(["10.0.0.5"]))


def test_where_nobody_answers_it_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert execute(["bench", "find", "emulated://"]) == 1
    assert "Nothing answered" in capsys.readouterr().out
