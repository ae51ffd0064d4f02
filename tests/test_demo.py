"""The whole line, from the emulated wire to a file that somebody without labcal can check."""

import filecmp
import json
import os
import shutil
import subprocess
import sys
import zipfile

import pytest

from labcal import cli
from labcal.demo.folder import make_room
from labcal.errors import InputError
from labcal.record.stream import Measurement
from labcal.store import Store

SEED = "3"
SHORT = {"axes": "x,y", "modes": "nominal", "magnitudes_nT": "20000", "reverse": "no", "zero_s": "2", "dwell_s": "1"}


@pytest.fixture(scope="module", params=["short", pytest.param("whole", marks=pytest.mark.slow)])
def finished(tmp_path_factory, request):
    """One demo, run as a person would, into a pipe: where it wrote. The short one: half of the axes and fields."""
    folder, preflight = tmp_path_factory.mktemp("demo"), SHORT if request.param == "short" else {}
    return folder, preflight, run(folder, home_of(folder), preflight)


@pytest.fixture(scope="module")
def demo(finished):
    """Where it wrote, and what it printed."""
    folder, _, process = finished
    return folder, process.stdout


def test_into_a_pipe_it_says_every_few_seconds_what_it_is_at(finished):
    _, preflight, process = finished
    lines = process.stderr.splitlines()
    assert len(lines) >= (1 if preflight else 3)  # the short one is through before most of its lines would come
    assert all(line.startswith("  ... ") for line in lines)
    assert preflight or any("scoring" in line for line in lines)


def home_of(folder):
    """labcal's folder of the first demo, where it keeps what it worked out."""
    return folder.parent / f"{folder.name}-home"


def run(folder, home, preflight=(), seed=SEED):
    begin = f"from labcal import cli, demo; demo.PREFLIGHT.update({dict(preflight)}); cli.main()"
    command = [sys.executable, "-c", begin, "demo", "--seed", seed, "--out", str(folder)]
    environment = {**os.environ, "LABCAL_HOME": str(home)}
    return subprocess.run(command, capture_output=True, text=True, check=True, env=environment)


def test_it_leaves_what_it_promises_and_says_so(demo):
    folder, said = demo
    for name in ("run.zip", "calibration.json", "calibration.json.sshsig", "allowed_signers", "report.html"):
        assert (folder / name).is_file(), name
        assert name in said.replace("\n", "")


def test_the_cage_is_checked_before_the_preflight(demo):
    folder, said = demo
    assert "cage check" in said
    with Store.open(folder / "labcal-demo.sqlite") as store:
        cage, preflight = store.runs()
        assert (cage.procedure, cage.status) == ("cage-calibration", "finished")
        assert cage.started_utc < preflight.started_utc
        limits = {item.name for item in store.items(cage.run_id) if isinstance(item, Measurement) and item.limit}
    assert "DUT: uncertainty of the matrix" in limits


def test_everything_it_writes_says_simulated(demo):
    folder, said = demo
    assert "SIMULATED" in said
    assert "SIMULATED" in (folder / "report.html").read_text()
    assert json.loads((folder / "calibration.json").read_text())["simulated"] is True
    with zipfile.ZipFile(folder / "run.zip") as bundle:
        assert json.loads(bundle.read("run.json"))["simulated"] is True


def test_the_error_falls_and_the_signature_holds(demo):
    _, said = demo
    assert "signature" in said
    assert "DOES NOT HOLD" not in said
    line = next(line for line in said.splitlines() if line.startswith("held-out error"))
    before, after = (float(part.split()[-2]) for part in line.split("→"))
    assert after < before


def test_the_hidden_effect_is_written_nowhere_in_the_run(demo):
    folder, _ = demo
    with zipfile.ZipFile(folder / "run.zip") as bundle:
        header = bundle.read("run.json").decode()
    for word in ("effect", "surprise", "twin", "i_radio_nT", "offset-"):
        assert word not in header


def test_the_same_seed_gives_the_same_bytes_and_a_second_call_works(finished, home_of_its_own, tmp_path):
    """Another process, with a home of its own, in the same folder."""
    folder, preflight, _ = finished
    shutil.copytree(folder, tmp_path / "first")
    run(folder, home_of_its_own, preflight)
    same, *others = filecmp.cmpfiles(tmp_path / "first", folder, ["run.zip", "calibration.json"], shallow=False)
    assert (same, *others) == (["run.zip", "calibration.json"], [], [])


def test_somebody_without_labcal_can_check_the_signature(demo):
    keygen = shutil.which("ssh-keygen")
    if keygen is None:
        pytest.skip("needs OpenSSH's ssh-keygen, which is not installed")
    folder, _ = demo
    command = [keygen, "-Y", "verify", "-f", str(folder / "allowed_signers"), "-I", "simulated"]
    command += ["-n", "labcal-calibration", "-s", str(folder / "calibration.json.sshsig")]
    content = (folder / "calibration.json").read_bytes()
    assert subprocess.run(command, input=content, capture_output=True).returncode == 0
    changed = content.replace(b"1", b"2", 1)
    assert subprocess.run(command, input=changed, capture_output=True).returncode != 0


def test_verify_says_yes_to_the_demo_and_no_without_its_trust_list(demo, monkeypatch):
    folder, _ = demo
    monkeypatch.setenv("LABCAL_HOME", str(home_of(folder)))
    arguments = ["verify", str(folder / "calibration.json"), "--allowed-signers", str(folder / "allowed_signers")]
    assert cli.execute([*arguments, "--run", str(folder / "run.zip")]) == 0
    assert cli.execute(["verify", str(folder / "calibration.json")]) == 1  # a lab that trusts nobody


def test_only_what_a_demo_left_gives_way_to_the_next(demo, tmp_path):
    folder = tmp_path / "again"
    shutil.copytree(demo[0], folder)
    (folder / "my notes.txt").write_text("kept")
    spoilt = {
        "report.html": b"<!doctype html>my own page",
        "run.zip": b"PK",
        "allowed_signers": b'ada@lab namespaces="labcal-calibration" ssh-ed25519 AAAA',
        "calibration.json.2.sshsig": b"of a person",
    }
    for name, content in spoilt.items():
        before = (folder / name).read_bytes() if (folder / name).exists() else None
        (folder / name).write_bytes(content)
        there = {path: path.read_bytes() for path in folder.iterdir() if path.is_file()}
        with pytest.raises(InputError, match=r"is there already|is signed|is the name of a signature"):
            make_room(folder)
        assert {path: path.read_bytes() for path in folder.iterdir() if path.is_file()} == there
        (folder / name).unlink() if before is None else (folder / name).write_bytes(before)
    make_room(folder)
    assert [path.name for path in folder.iterdir() if path.is_file()] == ["my notes.txt"]


def test_a_demo_says_which_file_is_in_its_way(tmp_path, capsys):
    (tmp_path / "report.html").write_text("mine")
    assert cli.execute(["demo", "--out", str(tmp_path)]) == 2
    assert capsys.readouterr().err == f"labcal: {tmp_path / 'report.html'}: is there already; --force replaces it\n"


@pytest.mark.parametrize("place", [".", "keys", "bundles"])
def test_a_demo_leaves_nothing_among_what_is_labcal_s_own(place, home_of_its_own):
    """Its trust list among the lab's keys would have the lab trust a key that lived in memory only."""
    with pytest.raises(InputError, match="labcal's own"):
        make_room(home_of_its_own / place, force=True)
    assert not list(home_of_its_own.iterdir())
