"""What a command may write over: every option of every command that names a file to write, walked."""

from __future__ import annotations

import inspect
import os
import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import typer
from typer.models import OptionInfo

import labcal.cli.commands
from labcal.cli import app
from labcal.cli import execute as labcal
from labcal.record import Dut, Reference, Run, Segment
from labcal.store import Store, write_bundle

GOLDEN = Path(__file__).parents[1] / "golden"
SIMULATED = Path(__file__).parents[2] / "examples" / "simulated.toml"
READ = (
    "bench",
    "allowed_signers",
    "specification",
    "before",
    "supersedes",
    "result",
    "table",
    "xml_key",
    "xml_cert",
)  # options that name a file to read
# What is asked for with each option that names a file to write, and the file's name. A command that is not here is
# new: give it `--force`, and `labcal.files.outputs.claim` before its work.
ASKED = {
    "demo --out": ("demo", "report.html"),
    "self-test --out": ("self-test", "self-test.pdf"),
    "fit --out": ("fit {bundle}", "cal.json"),
    "fit --json": ("fit {bundle}", "fit.json"),
    "apply --out": ("apply {calibration} {readings}", "out.csv"),
    "close-loop --out": ("close-loop {bundle}", "cal.json"),
    "close-loop --json": ("close-loop {bundle}", "loop.json"),
    "close-loop --report": ("close-loop {bundle}", "loop.html"),
    "verify --json": ("verify {calibration}", "verify.json"),
    "report --out": ("report {calibration}", "report.html"),
    "conformity --json": ("conformity {calibration} --specification {specification}", "lines.json"),
    "compare --json": ("compare {calibration} {calibration}", "changes.json"),
    "runs --json": ("runs", "runs.json"),
    "audit --json": ("audit", "audit.json"),
    "numbers --json": ("numbers", "numbers.json"),
    "show --json": ("show {bundle}", "show.json"),
    "import --out": ("import {readings} --from csv --map {mapping}", "imported.zip"),
    "import --map": ("import {readings} --from csv --guess", "guess.toml"),
    "export --out": ("export {bundle} --format csv", "samples.csv"),
    "bench serve --out": ("bench serve {bench}", "served.toml"),
    "bench find --out": ("bench find emulated://", "found.toml"),
    "bench cage --out": ("bench cage RUN --as Roe", "cage.json"),
}
ELSEWHERE = {
    "effect new --out",  # a folder of a package: tests/loop/test_effect_new.py
    *("archive runs --json", "archive calibrations --json", "archive get --out"),  # tests/archive/test_outputs_of_it.py
    "study --out",  # a folder that is gone on with: tests/study/test_resume.py
    "watch --out",  # likewise: tests/years/test_watch.py
    *(
        f"{name} {option}"
        for name in ("charts", "rr", "intervals", "intercompare", "fleet")
        for option in ("--json", "--out")
    ),  # tests/years/test_outputs_of_the_years.py
    "watch --json",  # there too
}
READS = {
    "demo --out": (), "self-test --out": (),
    "runs --json": (), "audit --json": (), "numbers --json": (), "bench cage --out": (), "bench find --out": (),
    "apply --out": ("{calibration}", "{readings}"), "report --out": ("{calibration}",),
    "verify --json": ("{calibration}",),
    "conformity --json": ("{calibration}", "{specification}"), "compare --json": ("{calibration}",),
    "bench serve --out": ("{bench}",), "import --out": ("{readings}", "{mapping}"), "import --map": ("{readings}",),
}  # fmt: skip


MAPPING = """format = "labcal-mapping/1"
dut = { serial = "SN1" }
time = { column = "i_eps", unit = "s" }
reading = { columns = ["dut_x", "dut_y", "dut_z"], unit = "nT" }
reference = { kind = "none" }
"""


def commands(group: typer.Typer, name: str = "") -> Iterator[tuple[str, dict[str, inspect.Parameter]]]:
    for command in group.registered_commands:
        assert command.callback is not None
        words = f"{name}{command.name or command.callback.__name__.strip('_')}"
        yield words, dict(inspect.signature(command.callback).parameters)
    for inner in group.registered_groups:
        assert inner.typer_instance is not None
        yield from commands(inner.typer_instance, f"{name}{inner.name} ")


def writing(parameters: dict[str, inspect.Parameter]) -> list[str]:
    """The options that name a file to write."""
    found = []
    for name, parameter in parameters.items():
        option = parameter.default
        if isinstance(option, OptionInfo) and name not in READ:
            path = "Path" in str(parameter.annotation) or "FILE" in str(option.metavar)
            found += [next(iter(option.param_decls), f"--{name}")] if path else []
    return found


class Place:
    """A folder with all that commands read, and the way to ask for a file there."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        write_bundle(sphere(), folder / "bundle")
        shutil.copy(GOLDEN / "calibration-1.json", folder / "calibration-1.json")
        shutil.copy(SIMULATED, folder / "bench.toml")
        (folder / "readings.csv").write_text("dut_x,dut_y,dut_z,i_eps\n1,2,3,0.1\n")
        (folder / "map.toml").write_text(MAPPING)
        (folder / "limits.toml").write_text('offset = { limit = 1e6, unit = "nT" }\n')
        self.named = {
            "specification": folder / "limits.toml", "mapping": folder / "map.toml",
            "bundle": folder / "bundle", "calibration": folder / "calibration-1.json",
            "readings": folder / "readings.csv", "bench": folder / "bench.toml",
        }  # fmt: skip

    def ask(self, case: str, out: Path | str, *more: str) -> int:
        given = str(Path(out).parent) if case == "demo --out" and isinstance(out, Path) else str(out)
        words = ASKED[case][0].format_map({name: str(path) for name, path in self.named.items()}).split(" ")
        return labcal([*words, case.split()[-1], given, *more])

    def inputs(self, case: str) -> list[Path]:
        named = [Path(text.format_map({n: str(p) for n, p in self.named.items()})) for text in READS.get(case, ("",))]
        return named if case in READS else [self.folder / "bundle" / "samples.csv", self.folder / "bundle" / "run.json"]


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    monkeypatch.chdir(tmp_path)
    return Place(tmp_path)


def sphere() -> Run:
    """200 directions at 30 µT, seen by a DUT with a scale and an offset beside a sensor in the same frame."""
    draw = np.random.default_rng(1)
    directions = draw.normal(size=(200, 3))
    field = 30e3 * directions / np.linalg.norm(directions, axis=1)[:, None]
    return Run(
        run_id="sphere",
        started_utc="2026-03-02T08:15:00Z",
        simulated=True,
        operator="",
        dut=Dut("SN1", "model", "nT", 1.0, 25.0),
        reference=Reference("vector", noise_nT=3.0),
        segments=(Segment("all", "free", reference_frame="body"),),
        t_s=np.arange(200.0),
        segment_index=np.zeros(200, dtype=np.intp),
        reading=1.05 * field + 800 + draw.normal(0, 25, field.shape),
        reference_vector=field,
        reference_magnitude=None,
        angle_deg=None,
        row_mode=None,
        channels=(),
    )


def bytes_below(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_every_option_that_names_a_file_to_write_is_walked_here_and_its_command_has_force() -> None:
    found = {f"{name} {option}" for name, parameters in commands(app) for option in writing(parameters)}
    assert found == ASKED.keys() | ELSEWHERE
    lacking = [name for name, parameters in commands(app) if writing(parameters) and "force" not in parameters]
    assert not lacking


@pytest.mark.parametrize("case", ASKED)
def test_a_file_that_is_there_is_kept_until_force_is_said(
    case: str, place: Place, capsys: pytest.CaptureFixture[str]
) -> None:
    out = place.folder / ASKED[case][1]
    out.write_text("the work of a week")
    link = place.folder / f"link-{out.name}"
    link.symlink_to(out)
    for name in (
        (out,) if case == "demo --out" else (out, link, Path(out.name), out.parent / "bundle" / ".." / out.name)
    ):
        assert place.ask(case, name) == 2
        told = capsys.readouterr().err
        assert "is there already; --force replaces it" in told
        assert len(told.strip().splitlines()) == 1
    assert out.read_text() == "the work of a week"
    assert link.is_symlink()


@pytest.mark.parametrize(
    "case", [pytest.param(one, marks=pytest.mark.slow if n % 3 else ()) for n, one in enumerate(ASKED)]
)
def test_not_even_force_replaces_store_signed_or_input(
    case: str, place: Place, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Store.open().close()
    elsewhere = place.folder / "other.db"
    sqlite3.connect(elsewhere).execute("CREATE TABLE t (x)").connection.close()
    (place.folder / "hard").symlink_to(home_of_its_own / "store.sqlite")
    signed = place.folder / ASKED[case][1]
    signed.write_text("{}")
    (place.folder / f"{signed.name}.2.sshsig").write_text("-----BEGIN SSH SIGNATURE-----")
    never = [signed, Path(f"{signed}.2.sshsig"), Path(f"{signed}.sshsig"), elsewhere, place.folder / "hard"]
    own = ("store.sqlite", "store.sqlite-wal", "STORE.sqlite", "keys/allowed_signers", "window.ini", "laboratory.toml")
    never += [home_of_its_own / name for name in own] + place.inputs(case)
    before = bytes_below(place.folder) | bytes_below(home_of_its_own)
    for out in [signed] if case == "demo --out" else never:
        assert place.ask(case, out, "--force") == 2, out
        told = capsys.readouterr().err
        assert any(word in told for word in ("signed", "signature", "store", "own", "reads")), out
    assert bytes_below(place.folder) | bytes_below(home_of_its_own) == before


@pytest.mark.parametrize(
    "case",
    [
        pytest.param(case, marks=pytest.mark.slow if n % 3 else ())
        for n, case in enumerate(case for case in ASKED if case != "demo --out")
    ],
)
def test_what_is_no_file_is_refused_at_once(case: str, place: Place) -> None:
    os.mkfifo("pipe")
    os.symlink("nowhere", "gone")
    before = sorted(os.listdir())
    for out in ("/dev/null", "pipe", ".", "", "gone", "no/such/folder/x", "n" * 300):
        assert place.ask(case, out, "--force") == 2, out
    assert sorted(os.listdir()) == before


@pytest.mark.parametrize("case", [case for case in ASKED if case != "demo --out" and "--json" not in case])
def test_a_result_that_is_no_json_does_not_go_to_standard_output(case: str, place: Place) -> None:
    assert place.ask(case, "-") == 2
    assert not Path("-").exists()


FAST = ["fit --out", "fit --json", "apply --out", "report --out", "runs --json", "show --json", "export --out"]


@pytest.mark.parametrize("case", FAST)
def test_the_same_command_replaces_what_it_wrote_and_nobody_touched(case: str, place: Place) -> None:
    out = place.folder / ASKED[case][1]
    assert place.ask(case, out) == 0
    first = out.read_bytes()
    assert place.ask(case, out) == 0
    out.write_bytes(first + b" ")  # somebody's own work from here on
    assert place.ask(case, out) == 2
    assert out.read_bytes() == first + b" "
    assert place.ask(case, out, "--force") == 0
    assert out.read_bytes() != first + b" "
    other = next(c for c in FAST if c.split()[0] != case.split()[0] and "report" not in c)
    assert place.ask(other, out) == 2


@pytest.mark.parametrize("case", ["fit --out", "fit --json", "show --json", "report --out"])
def test_a_result_beside_the_bundle_that_it_is_of_is_no_input(case: str, place: Place) -> None:
    place.named["calibration"] = place.folder / "bundle"  # `report` of the run itself
    out = place.folder / "bundle" / ASKED[case][1]
    assert [place.ask(case, out) for _ in range(2)] == [0, 0]
    assert place.ask(case, place.folder / "bundle" / "chain.jsonl", "--force") == 2  # would be read as its chain


def test_a_way_through_a_folder_that_is_not_there_is_no_way_around(place: Place) -> None:
    before = bytes_below(place.folder)
    run = str(place.folder / "bundle")
    for out in (run, "not there/../bundle", "./bundle/"):
        assert labcal(["export", run, "--format", "bundle", "--out", out, "--force"]) == 2
    assert bytes_below(place.folder) == before


def test_a_bundle_lies_in_no_folder_of_labcal_s_own(place: Place, home_of_its_own: Path) -> None:
    for out in (home_of_its_own, home_of_its_own / "keys"):
        assert labcal(["export", str(place.folder / "bundle"), "--format", "bundle", "--out", str(out), "--force"]) == 2
    assert not list(home_of_its_own.iterdir())


def test_a_folder_of_results_takes_no_signature_s_name(place: Place) -> None:
    words = ["export", str(place.folder / "calibration-1.json"), "--format", "json", "--out"]
    assert labcal([*words, str(place.folder / "calibration-1.json.2.sshsig")]) == 2
    assert not (place.folder / "calibration-1.json.2.sshsig").exists()
    assert labcal([*words, str(place.folder / "exported")]) == 0


@pytest.mark.parametrize("name", ["approved/1.json", "runs-going-on/1.json", "logo.svg", "new.json", "New/new.json"])
def test_in_labcal_s_folder_only_drafts_are_written(place: Place, home_of_its_own: Path, name: str) -> None:
    out = home_of_its_own / name
    out.parent.mkdir(exist_ok=True)
    for there in (False, True):
        if there:
            out.write_text("labcal's own\n")
        assert place.ask("runs --json", out, "--force") == 2
        assert out.exists() == there
    (home_of_its_own / "calibrations").mkdir()
    assert place.ask("runs --json", home_of_its_own / "calibrations" / "draft.json") == 0
