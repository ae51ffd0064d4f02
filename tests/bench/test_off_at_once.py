"""`labcal bench off` asks the supplies before it loads or checks anything that they do not need."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from served_lab import EXAMPLE, LABCAL, LONG_S, Served, at_zero, example, three_on_one_pair
from test_off import left_on

from labcal.bench.clock import RealClock
from labcal.bench.config import read_config
from labcal.bench.early_off import is_off
from labcal.bench.essentials import AXES, StatedInstrument, essentials
from labcal.bench.loading import Loader
from labcal.bench.shutdown import coils_off
from labcal.errors import InputError

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="needs ptys, which Windows lacks")
UNLOCKED = example().replace("interface_lock = true, ", "")
SLOW_TO_LOAD = {"numpy", "scipy", "pydantic", "typer", "rich", "annotated_types", "importlib.metadata"}
LOADED_AT_THE_FIRST_WORD = f"""
import os, sys
from labcal.bench.links import wired
from labcal.start import main
send = wired.WiredLink.send
def told(link, data):
    words = " ".join(["loaded:", *sorted({SLOW_TO_LOAD} & {{*sys.modules}})])
    os.write(2, words.encode() + b"\\n")
    send(link, data)
wired.WiredLink.send = told
main()
"""


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED, three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
def test_nothing_slow_is_loaded_before_the_supplies_are_asked(lab: Served) -> None:
    words = [sys.executable, "-c", LOADED_AT_THE_FIRST_WORD, "bench", "off", str(lab.file)]
    said = subprocess.run(words, capture_output=True, text=True, timeout=LONG_S)
    assert said.returncode == 0, said
    assert said.stdout.count("zero, open") == 3
    assert said.stderr.count("loaded:") > 3
    assert {line for line in said.stderr.splitlines() if line.startswith("loaded:")} == {"loaded:"}


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED], ids=["unlocked"])
def test_nothing_slow_is_loaded_before_its_last_word_so_that_what_was_read_is_not_old_by_then(lab: Served) -> None:
    words = [sys.executable, "-X", "importtime", *LABCAL[1:], "bench", "off", str(lab.file)]
    said = subprocess.run(words, capture_output=True, text=True, timeout=LONG_S)
    loaded = {line.rpartition("|")[2].strip() for line in said.stderr.splitlines()}
    assert "labcal.bench.coils.doubt" in loaded
    assert loaded & SLOW_TO_LOAD == set()
    assert said.stdout.splitlines()[-1] == "zero by the supply's word only: no reference has confirmed it"


def test_with_an_option_the_command_line_is_asked_what_was_meant() -> None:
    assert is_off(["bench", "off", "bench.toml"])
    others = (["bench", "off"], ["bench", "off", "--help"], ["bench", "off", "a", "b"], ["bench", "check", "a"])
    assert not any(map(is_off, others))


def without_the_dut(text: str) -> str:
    """As an editor leaves a file whose table was cut out."""
    before, _, after = text.partition('["dut"]')
    return before + after[after.index("\n[") + 1 :]


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED], ids=["unlocked"])
@pytest.mark.parametrize(
    "spoilt",
    [
        lambda text: text.replace('"role" = "dut"', '"role" = "dog"'),
        lambda text: text.replace('"serial" = ', '"serail" = '),
        lambda text: text.replace('["cage"."limits"]', '["cage"."limit"]'),
        without_the_dut,
    ],
    ids=["role", "misspelt", "no limits", "no dut"],
)
def test_what_is_wrong_elsewhere_in_the_file_keeps_no_coil_on(lab: Served, spoilt: Callable[[str], str]) -> None:
    left_on(lab)
    text = lab.file.read_text()
    assert spoilt(text) != text
    lab.file.write_text(spoilt(text))
    assert [(end.axis, end.words) for end in coils_off(lab.file)] == [(axis, "zero, open") for axis in "xyz"]
    assert at_zero(lab)


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED], ids=["unlocked"])
def test_of_a_file_that_was_cut_off_the_coils_that_it_names_come_to_zero(lab: Served) -> None:
    left_on(lab)
    text = lab.file.read_text()
    lab.file.write_text(text[: text.index('["instruments"."supply_z"]')])
    told = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
    said = dict(line.split(": ", 1) for line in told.stdout.splitlines() if line.startswith("coil "))
    assert at_zero(lab, "xy")
    assert not at_zero(lab, "z")
    assert told.returncode == 3
    assert said["coil z"].startswith(f"unknown  not reached: {lab.file} names no supply for coil z.")
    assert [said[f"coil {axis}"].endswith("zero, open") for axis in "xy"] == [True, True]
    assert told.stdout.splitlines()[-1].startswith("coils NOT confirmed at zero")


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED, three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
def test_the_essentials_of_a_file_are_what_stands_in_the_whole_of_it(lab: Served) -> None:
    some, whole = essentials(lab.file), read_config(lab.file)
    assert some is not None
    assert (some.guarded, some.guarded_links, some.axes) == (whole.guarded, whole.guarded_links, [*AXES])
    assert some.cage.limits.current_A == whole.cage.limits.current_A
    assert some.cage.limits.ramp_A_per_s == whole.cage.limits.ramp_A_per_s
    for name, entry in whole.instruments.items():
        assert some.instruments[name] == StatedInstrument(entry.driver, entry.link, entry.role, entry.settings)


def test_an_emulated_bench_has_no_essentials() -> None:
    assert essentials(EXAMPLE) is None


@pytest.mark.parametrize(
    "settings",
    [
        "timeout_s = 2, interface_lock = false, compliance_V = 12.5",
        "output = 2",
        "timeout_s = -1",
        "timeout_s = '1.5'",
        "timeout_s = nan",
        "output = true",
        "no_such = 1",
    ],
)
def test_settings_are_read_as_a_session_reads_them(tmp_path: Path, settings: str) -> None:
    file, (text, _, _) = tmp_path / "bench.toml", EXAMPLE.read_text().partition("\n[twin]")
    of_x = 'role = "coil-x"'
    file.write_text(
        text.replace("emulated://", "tcp://127.0.0.1:9").replace(of_x, f"{of_x}\nsettings = {{{settings}}}")
    )

    def read(config: Any) -> str:
        try:
            return repr(Loader(file, config, RealClock(), 0).driver("supply_x")[2])
        except InputError as error:
            return str(error)

    assert read(essentials(file)) == read(read_config(file))


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED], ids=["unlocked"])
def test_where_there_are_no_handles_that_is_said_and_nothing_of_a_guardian(lab: Served) -> None:
    few = "import resource, sys; resource.setrlimit(resource.RLIMIT_NOFILE, (8, 8)); "
    words = [sys.executable, "-c", f"{few}from labcal.start import main; main()", "bench", "off", str(lab.file)]
    said = subprocess.run(words, capture_output=True, text=True, timeout=LONG_S)
    assert said.returncode == 3, said
    assert "Too many open files" in said.stderr
    assert "how the coils are is not known" in said.stderr
    assert "guardian" not in said.stderr


@POSIX
@pytest.mark.parametrize("bench_text", [UNLOCKED], ids=["unlocked"])
def test_what_was_read_back_is_said_before_anything_more_is_loaded(lab: Served) -> None:
    ends = "import sys; sys.modules['labcal.bench.coils.doubt'] = None; "  # as where there is no memory for it
    words = [sys.executable, "-c", f"{ends}from labcal.start import main; main()", "bench", "off", str(lab.file)]
    said = subprocess.run(words, capture_output=True, text=True, timeout=LONG_S)
    assert said.stdout.count("zero, open") == 3, said
