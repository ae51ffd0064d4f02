"""One port by any of its names: what locks and comparisons know it by, and how long an unknown name is waited for."""

from __future__ import annotations

import os
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import closing

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.coils.doubt import Doubt, StoredDoubt
from labcal.bench.links import hosts, open_link
from labcal.bench.links.ports import port_of
from labcal.errors import InstrumentError

LONG_S = 30.0
NAMES = {"supply-x.lab": ["fe80::7", "192.0.2.7"], "here.lab": ["127.0.0.1"]}


@pytest.fixture(autouse=True)
def names(monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """A name service that knows `NAMES`; for all others it is down: nothing comes back before the event is set."""
    back = threading.Event()

    def resolve(name: str) -> list[str]:
        if name not in NAMES:
            back.wait(LONG_S)
            raise socket.gaierror
        return NAMES[name]

    monkeypatch.setattr(hosts, "resolve", resolve)
    monkeypatch.setattr(hosts, "known_names", hosts.KnownNames())
    yield back
    back.set()


@pytest.mark.parametrize(
    "spelt",
    [
        "tcp://127.0.0.1:9221", "tcp://localhost:9221", "tcp://LOCALHOST.:9221", "tcp://127.1:9221",
        "tcp://0x7f000001:9221", "tcp://[::1]:9221", "tcp://[0:0::1]:9221", "tcp://[::ffff:127.0.0.1]:09221",
        "tcp://here.lab:9221?gap_ms=5", "tcp://HERE.lab.:9221", "modbus-rtu://socket://localhost:9221?baud=9600",
        "modbus-rtu://rfc2217://127.0.0.1:9221", "modbus-tcp://127.0.0.1:9221",
    ],
)  # fmt: skip
def test_a_port_is_one_by_any_of_its_names(spelt: str) -> None:
    assert port_of(spelt) == "127.0.0.1:9221"


def test_other_ports_are_others() -> None:
    assert port_of("modbus-tcp://supply-x.lab") == port_of("tcp://192.0.2.7:502") == "192.0.2.7:502"
    urls = ["tcp://127.0.0.1:1", "tcp://127.0.0.1:2", "tcp://127.0.0.2:1", "tcp://[fe80::7]:1", "tcp://192.0.2.7:1",
            "serial:///dev/null", "emulated://127.0.0.1:1x"]  # fmt: skip
    assert len(set(map(port_of, urls))) == len(urls)


def test_a_port_that_one_link_has_is_no_others_by_another_name() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
        with closing(open_link(f"tcp://localhost:{port}", RealClock())):
            for other in ("127.0.0.1", "127.1", "here.lab"):
                with pytest.raises(InstrumentError) as caught:
                    open_link(f"tcp://{other}:{port}", RealClock())
                assert caught.value.fault == "in use"
                assert f"(process {os.getpid()}) holds this port" in str(caught.value)


def test_names_that_nobody_answers_for_cost_a_second_all_together(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hosts, "known_names", names := hosts.KnownNames())
    names._left_s = 0.2
    begun = time.monotonic()
    for _ in range(20):
        assert [port_of(f"tcp://Gone-{axis}.lab.:9221") for axis in "xyz"] == [f"gone-{a}.lab:9221" for a in "xyz"]
    assert names._left_s == 0.0
    assert time.monotonic() - begun < LONG_S / 2  # and not as long as sixty answers take
    with pytest.raises(InstrumentError, match=r"gone-x\.lab has no address that is known") as caught:
        open_link("tcp://gone-x.lab:9221", RealClock())
    assert caught.value.fault == "link lost"


def test_a_name_that_has_an_address_later_is_found(monkeypatch: pytest.MonkeyPatch, names: threading.Event) -> None:
    monkeypatch.setattr(hosts, "AGAIN_S", 0.0)
    monkeypatch.setattr(hosts, "PATIENCE_S", 0.05)
    hosts.known_names._left_s = 0.05
    assert hosts.one_of("late.lab") == "late.lab"
    names.set()
    monkeypatch.setitem(NAMES, "late.lab", ["192.0.2.9"])
    begun = time.monotonic()
    while hosts.one_of("late.lab") != "192.0.2.9":
        assert time.monotonic() - begun < LONG_S
        time.sleep(0.01)


def test_a_doubt_stays_where_a_supply_gets_another_address(monkeypatch: pytest.MonkeyPatch) -> None:
    links = ["tcp://supply-x.lab:9221", "tcp://192.0.2.8:9221"]
    StoredDoubt(links).set(Doubt("2026-01-01 00:00 UTC", "12 nT too much"))
    assert StoredDoubt(["tcp://192.0.2.7:9221", links[1]]).doubt is not None
    monkeypatch.setitem(NAMES, "supply-x.lab", ["192.0.2.99"])
    monkeypatch.setattr(hosts, "known_names", hosts.KnownNames())
    again = StoredDoubt(links)
    assert again.doubt is not None
    again.lift("both agree")
    assert again.take_lifted() is not None
    assert StoredDoubt(links).doubt is None
