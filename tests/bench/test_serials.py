"""Serial numbers are those of the bench's pattern, wherever they come from."""

import re
from pathlib import Path

import pytest
from served_lab import example

from labcal import session
from labcal.bench.config import read_config
from labcal.bench.serials import USUAL, objection
from labcal.errors import InputError
from labcal.record.run_id import name_outside
from labcal.record.stream import Event, Prompt
from labcal.runner.prompts import first_choice, yes_to_all
from labcal.store import Store


@pytest.mark.parametrize("serial", ["EM-07", "7", "SN 0012 (B)", "Ärger_3.1", "MS-90:12#4+1", ""])
def test_usual_serials_are_taken(serial: str) -> None:
    assert objection(serial, USUAL) == ""


@pytest.mark.parametrize("serial", ["EM 07!?<b>", "<b>", "EM-07 ", " EM-07", "EM-07;", "-"])
def test_what_stands_on_no_label_is_refused(serial: str) -> None:
    assert "is no serial number: letters and digits" in objection(serial, USUAL)


@pytest.mark.parametrize("serial", ["EM 09/../x", "EM\\09", "..", "EM..09", "a\nb", "EM\u202e09", "EM-07\x00"])
def test_what_leads_elsewhere_in_a_file_s_name_is_refused_whatever_the_bench_takes(serial: str) -> None:
    for pattern in (USUAL, r"[\s\S]*"):
        assert "it becomes part of file names, which have no" in objection(serial, pattern)


def test_a_bench_whose_serials_have_a_slash_says_so_and_its_files_stay_in_their_folder() -> None:
    assert "where a / parts folders" in objection("S/N 0012", USUAL)
    assert objection("S/N 0012", "S/N [0-9]{4}") == ""
    assert name_outside("S/N 0012", "run-1_1") == "S-N-0012_run-1_1"


def test_a_run_takes_no_other_serial_than_those_of_the_bench_file(tmp_path: Path) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "EM-[0-9]{2}"\n'), encoding="utf-8")
    with pytest.raises(InputError, match=re.escape("'FM-1' is no serial number of this bench: they match EM-[0-9]{2}")):
        session.run("axes-check", path, dut="FM-1")
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "EM-["\n'), encoding="utf-8")
    with pytest.raises(InputError, match=r"dut.serial_pattern.* is no regular expression"):
        read_config(path)


def test_a_bench_file_cannot_hold_up_who_types_a_serial(tmp_path: Path) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(example().replace("[dut]\n", '[dut]\nserial_pattern = "(\\\\w+)+-"\n'), encoding="utf-8")
    with pytest.raises(InputError, match=r"dut.serial_pattern.* may take very long to match"):
        read_config(path)
    assert "a serial number of 101 characters: at most 100" in objection("a" * 101, USUAL)


SCANNED = "[dut]\nserial_at_mounting = true\n"
SHORT = {"axes": "x,y", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}


def run_scanning(bench: Path, said: list[str]) -> tuple[session.Outcome, list[Prompt]]:
    """A short preflight of EM-09, whose serial is answered by `said` one after the other; what was asked for it."""
    asked: list[Prompt] = []

    def answer(prompt: Prompt) -> str:
        if not prompt.key.startswith("serial-"):
            return first_choice(prompt)
        asked.append(prompt)
        return said.pop(0)

    return session.run("preflight", bench, SHORT, answer=answer, dut="EM-09", seed=3), asked


def test_the_serial_is_scanned_at_each_mounting_and_no_other_goes_on(tmp_path: Path) -> None:
    bench = tmp_path / "bench.toml"
    bench.write_text(example().replace("[dut]\n", SCANNED), encoding="utf-8")
    outcome, asked = run_scanning(bench, ["EM-09", "EM-10", "", "EM-09", "EM-09"])
    assert outcome.status == "finished"
    assert [prompt.key for prompt in asked] == ["serial-mount-x", *3 * ["serial-mount-y"], "serial-mount-x-again"]
    assert all(prompt.acts and prompt.choices == () for prompt in asked)
    assert asked[0].text == "Scan the serial of the DUT as it is mounted now: this run is of EM-09."
    assert asked[2].text == "EM-10: that is not the DUT of this run. Mount EM-09, then scan its serial again."
    assert asked[3].text.startswith("nothing: that is not the DUT")
    with Store.open() as store:
        told = [item for item in store.items(outcome.run_id, but="block") if isinstance(item, Event)]
    scanned = [one.text for one in told if str(one.data.get("key", "")).startswith("serial-")]
    assert scanned == ["EM-09", "EM-10", "", "EM-09", "EM-09"]


def test_nobody_but_a_person_says_which_serial_stands_there(tmp_path: Path) -> None:
    asked = Prompt(0.0, "serial-mount-x", "Scan it.", (), acts=True, drawing={"serial": "EM-09"})
    assert yes_to_all(simulated=True)(asked) == "EM-09"
    with pytest.raises(InputError, match="cannot answer for a person on a real bench"):
        yes_to_all(simulated=False)(asked)
