"""The specification in the record: written when the run begins, in its bundle ever after."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import session
from labcal.cli import execute
from labcal.errors import InputError
from labcal.record import Limit, Specification
from labcal.store import Store, bundle_of, read_bundle

EXAMPLE = (Path(__file__).resolve().parents[2] / "examples" / "simulated.toml").read_text(encoding="utf-8")
ASKED = {"offset": {"limit": 250.0, "unit": "nT"}, "rule": "guard-band", "r": 1.5}


def test_a_bundle_s_specification_is_read_and_written_the_same(bundle) -> None:
    run = read_bundle(bundle(lambda header: header.update(specification=ASKED)))
    assert run.specification == Specification(offset=Limit(250.0, "nT"), r=1.5)
    assert json.loads(bundle_of(run).run_json)["specification"] == ASKED
    assert b"specification" not in bundle_of(replace(run, specification=None)).run_json


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        ({"ofset": {"limit": 1, "unit": "nT"}}, "ofset"),
        ({"offset": {"limit": 1, "unit": "deg"}}, "no unit 'deg'"),
        ({"offset": {"limit": "1", "unit": "nT"}}, "limit"),
        ({"r": 1}, "limits nothing"),
        ({**ASKED, "title": "\u202e"}, "printable"),
    ],
)
def test_a_limit_that_cannot_be_judged_is_refused_with_its_line(bundle, asked: object, says: str) -> None:
    with pytest.raises(InputError, match=r"run.json, line \d+") as caught:
        read_bundle(bundle(lambda header: header.update(specification=asked)))
    assert says in str(caught.value)


def test_it_is_in_the_record_before_the_first_sample(
    tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "bench.toml"
    path.write_text(f'{EXAMPLE}\n[dut.specification]\noffset = {{ limit = 250.0, unit = "nT" }}\nr = 1.5\n')
    seen = []

    def look(item: object) -> None:
        if not seen:
            with Store.open() as store:
                seen.append(store.header("R").specification)
            path.write_text(EXAMPLE)  # what is asked afterwards changes nothing

    outcome = session.run("rotate-axis", path, {"rate_deg_per_s": "20"}, run_id="R", on_item=look)
    assert outcome.status == "finished"
    asked = Specification(offset=Limit(250.0, "nT"), r=1.5)
    assert seen == [asked]
    assert session.load_run("R").specification == asked
    assert json.loads(session.run_bundle("R").run_json)["specification"] == ASKED
    assert session.describe_run("R")["specification"] == ASKED
    assert execute(["show", "R"]) == 0
    assert "offset 250 nT; guard-band, r = 1.5" in capsys.readouterr().out
