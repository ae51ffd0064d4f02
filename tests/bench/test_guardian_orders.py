"""What the guardian refuses: steps beyond the ramp, currents beyond the limit, ports that another process holds."""

from __future__ import annotations

import json
import os
import stat
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from labcal.bench.coils.zero import AtZero
from labcal.bench.config import read_config
from labcal.bench.guardian import duty, wire
from labcal.bench.guardian.coil_limits import CoilLimit
from labcal.bench.guardian.duty import DutyRecord
from labcal.bench.guardian.handover import patience
from labcal.bench.guardian.limits_together import TogetherLimit
from labcal.bench.guardian.logbook import note, written
from labcal.bench.links import ports
from labcal.errors import InstrumentError, LimitError
from labcal.files.home import home

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"


def test_a_current_beyond_the_limit_is_refused_with_both_numbers() -> None:
    with pytest.raises(LimitError, match=r"coil x: -2\.6 A.*2\.5 A"):
        CoilLimit("x", 2.5, 2.0).refuse(-2.6, 0.0)


def test_a_ramp_of_steps_passes_and_a_jump_does_not() -> None:
    limit = CoilLimit("x", 2.5, 2.0)
    for step in np.arange(1, 11):
        limit.refuse(0.2 * step, 0.1 * step)
        limit.was_set(0.2 * step, 0.1 * step)
    assert limit.ramp_down_s == pytest.approx(1.0)
    with pytest.raises(LimitError, match=r"step of 2 A .* 2 A/s"):
        limit.refuse(0.0, 100.0)


def test_steps_that_come_too_fast_are_refused() -> None:
    limit = CoilLimit("x", 2.5, 2.0)
    for step in (1, 2):
        limit.refuse(0.2 * step, 0.01 * step)
        limit.was_set(0.2 * step, 0.01 * step)
    with pytest.raises(LimitError):
        limit.refuse(0.6, 0.03)


AT_REST = {"x": 0.0, "y": 0.0, "z": 0.0}


def together(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limits: str = "") -> TogetherLimit:
    monkeypatch.setattr(ports, "runtime_folder", lambda: tmp_path)
    monkeypatch.setattr("labcal.bench.guardian.duty.runtime_folder", lambda: tmp_path)
    text = EXAMPLE.read_text(encoding="utf-8").replace("field_nT = 120000.0", f"field_nT = 120000.0\n{limits}")
    (tmp_path / "bench.toml").write_text(text, encoding="utf-8")
    return TogetherLimit(read_config(tmp_path / "bench.toml"), DutyRecord(["tcp://localhost:9"]))


def test_a_field_that_no_ambient_explains_is_refused_with_both_numbers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    limit = together(tmp_path, monkeypatch)
    limit.refuse({"x": 1.9, "y": 1.9, "z": 1.9})
    with pytest.raises(LimitError, match=r"field of 17\d{4} nT .* 100000 nT"):
        limit.refuse({"x": 2.0, "y": -2.0, "z": 2.0})
    with pytest.raises(LimitError):
        limit.refuse({"x": float("nan"), "y": 0.0, "z": 0.0})


def test_what_a_winding_has_borne_is_known_to_the_next_guardian(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stated = "rms_current_A = 1.0\nrms_window_s = 600"
    limit = together(tmp_path, monkeypatch, stated)
    assert limit.hot(AT_REST | {"y": 2.0}, 10.0) is None
    assert limit.hot(AT_REST | {"y": 2.0}, 100.0) is None
    hot = limit.hot(AT_REST | {"y": 2.0}, 200.0)
    assert hot is not None
    assert (hot.fault, "coil y" in hot.what) == ("limit reached", True)
    assert written(at_most_s=30)
    again = together(tmp_path, monkeypatch, stated)
    with pytest.raises(LimitError, match="coil y"):
        again.refuse(AT_REST | {"y": 1.01})
    again.refuse(AT_REST | {"x": 1.01})
    with monkeypatch.context() as later:  # a day, by the clock on the wall
        later.setattr(duty, "time", SimpleNamespace(time=lambda: time.time() + 86_400, monotonic=time.monotonic))
        with pytest.raises(LimitError, match="coil y"):
            together(tmp_path, monkeypatch, stated).refuse(AT_REST | {"y": 1.01})
        later.setattr(duty, "time", SimpleNamespace(time=lambda: time.time() + 86_400, monotonic=lambda: 0.0))
        together(tmp_path, monkeypatch, stated).refuse(AT_REST | {"y": 1.01})  # started anew meanwhile
    for spoilt in (
        "",
        "[]",
        '{"utc_s": "x", "mean_A2": [1,2,3]}',
        '{"utc_s": 0, "mean_A2": [1, NaN, -1]}',
        "\xff",
        "[" * 99_999,
    ):
        next(tmp_path.glob("duty-*.json")).write_text(spoilt)
        together(tmp_path, monkeypatch, stated).refuse(AT_REST | {"y": 1.01})


def test_a_log_that_cannot_be_written_delays_nobody(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "file"))
    (tmp_path / "file").write_text("not a folder")
    note("lost")
    assert written(at_most_s=30)
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path))
    note("kept")
    assert written(at_most_s=30)
    assert (home() / "guardian.log").read_text().endswith("kept\n")


@pytest.mark.parametrize("ramp_s", [0.0, 0.5, 1.0, 1.5])
def test_silence_and_ramp_together_leave_time_to_read_back(ramp_s: float) -> None:
    assert patience(ramp_s) > 0.25
    assert patience(ramp_s) + ramp_s < 1.85


@pytest.mark.skipif(sys.platform == "win32", reason="needs Unix sockets, which Windows' Python lacks")
def test_only_this_user_reaches_the_socket() -> None:
    listener, card = wire.listen()
    path = Path(card["address"])
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    wire.unlisten(listener, card)
    assert not path.exists()


def test_what_goes_over_the_socket_comes_back_the_same() -> None:
    end = AtZero("x", 0.1, False, LimitError("too much", fault="limit reached", remedy="less"), 1.0, 0.5, 2.0)
    back = wire.zero_of(json.loads(wire.packed(wire.zero_message(end))))
    assert (back.axis, back.current_A, back.opened, back.abrupt) == ("x", 0.1, False, True)
    assert (back.read_s, back.from_A, back.asked_s) == (1.0, 0.5, 2.0)
    assert isinstance(back.fault, LimitError)
    assert (back.fault.fault, str(back.fault)) == ("limit reached", "too much less")


def test_a_port_that_another_process_holds_is_refused_until_it_has_died(tmp_path: Path) -> None:
    url = f"serial://{tmp_path}/ttyUSB7?baud=9600"
    code = (
        "import sys; from labcal.bench.links import ports; assert ports.hold([sys.argv[1]]); "
        "ports.announce({'pid': 7}); print('held', flush=True); sys.stdin.read()"
    )
    with subprocess.Popen([sys.executable, "-c", code, url], stdin=-1, stdout=-1, text=True) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == "held\n"
        assert ports.holder(url.replace("9600", "115200")) == {"pid": 7}
        assert not ports.hold([url])
        # whoever holds it is named by the kernel, whatever is announced
        with pytest.raises(InstrumentError, match=rf"process {other.pid}\)"):
            ports.claim(url)
        os.kill(other.pid, 9)
    ports.claim(url)()
    assert ports.hold([url])
    ports.let_go()
