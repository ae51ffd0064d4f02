"""What a study file may say: whatever it says else is refused with one sentence, before a job begins."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal.cli import execute as labcal

HEAD = 'format = "labcal-study/1"\n'
MC, FLEET, DESIGN = (HEAD + f'kind = "{kind}"\n' for kind in ("monte-carlo", "fleet", "design"))
HOSTILE = {
    "": "kind must be one of",
    "kind = 3\n": "kind must be one of",
    HEAD + 'kind = "sweep"\n': "kind must be one of",
    'kind = "blind"\n': "format is missing",
    'format = "labcal-study/2"\nkind = "blind"\n': "format must be 'labcal-study/1'",
    MC + "sedes = 3\n": "sedes",
    MC + "seeds = 0\n": "seeds",
    MC + "seeds = [5, 2]\n": "seeds: the last one comes before the first",
    MC + "seeds = -3\n": "seeds",
    MC + "seeds = [0, 4000000000]\n": "jobs; at most 100000",
    MC + "seeds = 1e9\n": "seeds",
    MC + "field_nT = nan\n": "field_nT",
    MC + "field_nT = inf\n": "field_nT",
    MC + "accuracy_deg = -1\n": "accuracy_deg",
    MC + 'method = "magic"\n': "there is no method 'magic'",
    MC + 'procedure = "dance"\n': "there is no procedure 'dance'",
    MC + 'procedure = "./nowhere.py"\n': "there is no such file",
    MC + 'bench = "nowhere.toml"\n': "nowhere.toml",
    MC + "[settings]\nspeed = 3\n": "no parameter is called 'speed'",
    MC + "[settings]\nmodes = {a = 1}\n": "settings.modes: a procedure takes",
    MC + "[settings]\ninclination_deg = 300\n": "inclination_deg",
    MC + "[grid.settings]\ninclination_deg = [40.0, 300.0]\n": "inclination_deg",
    MC + "[grid]\nnoise = [1, 2]\n": "noise: each of its values is a table",
    MC + "[grid.settings]\nzero_s = 3\n": "settings.zero_s: a dimension is a list",
    MC + "[lab.twin.dut]\nnoise_nT = -5.0\n": "lab.dut.noise_nT",
    MC + "[lab.twin.effects.gremlin]\n": "effects.gremlin: there is no such effect",
    MC + "[lab.twin.effects.lag]\nlate_s = nan\n": "lab: Out of range float",
    MC + "[lab.twin.effects.lag]\nlate_s = 2026-01-01\n": "lab: Object of type date",
    MC + "[lab.twin.effects.lag]\nnonsense = 3\n": "effects.lag.nonsense: no such parameter",
    MC + "[lab]\nname = 3\n": "lab.name",
    MC + '[lab.instruments.supply_x]\nlink = "serial:///dev/ttyUSB0"\n': "lab: the table [twin] is for",
    DESIGN: "accuracy_deg is missing",
    DESIGN
    + "accuracy_deg = 0.1\n[settings]\nmagnitudes_nT = [1e4, 2e4, 3e4, 4e4]\n": "a design is chosen from at most",
    DESIGN + 'accuracy_deg = 0.1\nprocedure = "flip"\n': "a design is chosen from the rotations of a preflight",
    DESIGN + "accuracy_deg = [0.1, 0.0]\n": "accuracy_deg",
    FLEET + 'runs = "nowhere"\n': "is no folder",
    FLEET + 'runs = "."\n': "holds no calibration file",
    FLEET + 'runs = "."\nby = "magic"\n': "'magic' is none of",
    FLEET + 'runs = "."\neffect = { id = "gremlin" }\n': "no installed package describes the effect 'gremlin'",
    FLEET + 'runs = "."\nby = "ml"\neffect = { id = "lag" }\n': "leave `by` out",
    FLEET + "runs = 3\n": "runs",
    FLEET + "seeds = 3\n": "seeds",
    "format = [": "is not TOML",
    "a" + ".a" * 500 + " = 1\n": "nested too deeply",
}


@pytest.mark.parametrize(
    "text",
    [pytest.param(text, marks=pytest.mark.slow if n % 3 else ()) for n, text in enumerate(HOSTILE)],
    ids=lambda text: repr(text[-40:]),
)
def test_a_file_that_says_nothing_sensible_is_refused(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("study.toml").write_text(text)
    assert labcal(["study", "study.toml"]) == 2
    told = capsys.readouterr().err
    assert HOSTILE[text].lower() in told.lower()
    assert len(told.strip().splitlines()) == 1
    assert not Path("study-out").exists()


def test_what_is_no_file_of_this_kind_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"\xff\xfe\x00")
    for name in (tmp_path, tmp_path / "gone.toml", "/dev/zero", binary):
        assert labcal(["study", str(name), "--out", str(tmp_path / "out")]) == 2
        assert len(capsys.readouterr().err.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


def test_processes_are_not_asked_of_a_cluster(capsys: pytest.CaptureFixture[str]) -> None:
    assert labcal(["study", "x.toml", "--scheduler", "tcp://127.0.0.1:1", "--processes", "2"]) == 2
    assert "--processes" in capsys.readouterr().err
