"""`bench find`: who answers on the lines of a served bench, and a draft that is refused until limits are stated."""

from __future__ import annotations

import socket
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from importlib.metadata import entry_points
from pathlib import Path
from typing import get_type_hints

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.config import read_config
from labcal.bench.find import Found, draft, find, places
from labcal.bench.find import questions as looking
from labcal.bench.loading import recogniser
from labcal.bench.serve import outlet_of, serve
from labcal.cli import execute
from labcal.errors import InputError
from labcal.twin import open_twin

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
PATIENCE_S = 60.0
LATE = ("gsm", "iaga-2002", "twinleaf")  # known after all questions: by what it sends, and by the last of them
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
def found(links: dict[str, str], request: pytest.FixtureRequest) -> Iterator[dict[str, Future[Found]]]:
    """Who answers on each line that is asked for. All at once: most of it is waiting for an answer at a wrong rate."""
    names = {item.callspec.params.get("name") for item in request.session.items if hasattr(item, "callspec")}
    with ThreadPoolExecutor(len(links)) as at_once:
        yield {name: at_once.submit(found_at, link) for name, link in links.items() if name in names}


@pytest.mark.parametrize(
    ("name", "driver", "settings"),
    [
        ("supply_x", "tti-pl", ""),
        ("supply_y", "scpi-table", 'model = "siglent-spd3303x"'),
        pytest.param("supply_z", "microcontroller", "", marks=pytest.mark.slow),
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


@contextmanager
def on_a_line(name: str, role: str) -> Iterator[str]:
    """An emulator on a pty, as `bench serve` puts it there."""
    driver, emulator = (
        next(iter(entry_points(group=f"labcal.{kind}", name=name))).load() for kind in ("drivers", "emulators")
    )
    settings = get_type_hints(driver.__init__)["settings"]()
    end = emulator(open_twin({}, 1), {role: {}}, settings)
    outlet, over, clock = outlet_of(end, modbus=False), threading.Event(), RealClock()

    def pump() -> None:
        while not over.is_set():
            if data := outlet.read():
                end.take(clock.now(), data)
            for _, piece in end.emit(clock.now()):
                outlet.write(piece)
            over.wait(0.001)

    (thread := threading.Thread(target=pump, daemon=True)).start()
    yield outlet.url
    over.set()
    thread.join()
    outlet.close()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
@pytest.mark.parametrize(
    ("name", "role", "said"),
    [
        ("genesys", "coil-x", "LAMBDA,GEN40-38"),
        ("pos-1", "reference", "POS-1 Overhauser magnetometer N 117"),
        ("gsm", "reference", "sends by itself"),
        pytest.param("iaga-2002", "reference", "sends by itself", marks=pytest.mark.slow),
        ("i2c-board", "dut", "sends by itself"),
        ("thorlabs-apt", "platform", "K10CR1"),
        ("trinamic-tmcl", "platform", "module"),
        ("standa-8smc5", "platform", "errc"),
        pytest.param("twinleaf", "reference", "Twinleaf VMR", marks=pytest.mark.slow),
    ],
)
def test_what_speaks_otherwise_is_known_too(name: str, role: str, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    with on_a_line(name, role) as link:
        monkeypatch.setattr(looking, "BAUDS", (int(link.rpartition("=")[2]),))  # the others are silence
        if name not in LATE:  # others are asked nothing that they do not know, which takes its time
            monkeypatch.setattr(looking, "PROBES", tuple(one for one in looking.PROBES if one.driver in ("", name)))
            monkeypatch.setattr(looking, "RTU", ())
        one = found_at(link)
    assert (one.driver, one.said[: len(said)]) == (name, said)
    assert one.settings == ('chip = "rm3100"' if name == "i2c-board" else "")


def test_the_draft_is_refused_until_limits_are_stated(tmp_path: Path) -> None:
    found = [Found("tcp://10.0.0.5:9221", "THURLBY THANDAR, PL303-P, 1, 1", "tti-pl", "coil"),
             Found("serial:///dev/ttyUSB0?baud=9600", 'ACME "X", 1')]  # fmt: skip
    found.append(Found("modbus-rtu:///dev/ttyUSB1?baud=9600", "a board", "waveshare-relay", "polarity or interlock"))
    assert "# settings = { x = , y = , z =  }" in draft(found)
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


@pytest.mark.parametrize(
    ("place", "why"),
    [
        ("/dev/nothing-here", "No such file"),
        ("/dev/null", "does not open"),
        ("tcp://127.0.0.1:1", "Connection refused"),
        ("tcp://", "states no port"),
        ("tcp://127.0.0.1:99999", "no number from 1 to 65535"),
        ("http://127.0.0.1:80", "is none of serial://"),
        ("visa://x", "is no VISA resource"),
        ("127.0.0.1", "nobody answers at its usual ports (5025,"),
    ],
)
def test_why_nothing_is_found_at_a_place_that_was_stated_is_said(
    place: str, why: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert execute(["bench", "find", place]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert why in said
    assert said.endswith("Nothing answered.")


def test_a_line_that_opens_and_is_silent_is_said_to_be_so(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as nobody:
        assert execute(["bench", "find", f"tcp://127.0.0.1:{nobody.getsockname()[1]}"]) == 1
    assert "it can be opened, and nobody answers" in " ".join(capsys.readouterr().out.split())


def test_where_nothing_is_found_no_draft_is_written_over_another(
    links: dict[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "bench.toml"
    assert execute(["bench", "find", links["supply_x"], "--out", str(out)]) == 0
    before = out.read_text()
    assert "tti-pl" in before
    assert execute(["bench", "find", "tcp://127.0.0.1:1", "--out", str(out)]) == 1
    assert "is not written" in " ".join(capsys.readouterr().out.split())
    assert out.read_text() == before
