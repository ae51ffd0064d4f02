"""bench.toml: what is wrong is named with file, line and key."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from labcal.bench.config import line_of, read_config
from labcal.errors import InputError

GOOD = """\
name = "cage-2"

[cage]
matrix_nT_per_A = [[50000, 100, 0], [0, 50000, 0], [0, 0, 50000]]
limits = { current_A = 2.0, ramp_A_per_s = [2, 2, 2], field_nT = 120000 }

[dut]
serial = "EM-07"
unit = "count"

[instruments]
x = { driver = "tti-pl", link = "emulated://", role = "coil-x" }
y = { driver = "tti-pl", link = "emulated://", role = "coil-y" }
z = { driver = "tti-pl", link = "emulated://", role = "coil-z" }
stage = { driver = "zaber", link = "emulated://", role = "platform" }
ref = { driver = "hmr2300", link = "emulated://", role = "reference" }

[instruments.dut]
driver = "csv-line"
link = "emulated://"
role = "dut"

[twin]
secret = 1
"""


def config_of(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "bench.toml"
    path.write_text(text)
    return path


def test_a_good_file_is_read_and_the_twin_is_never_dumped(tmp_path: Path) -> None:
    config = read_config(config_of(tmp_path, GOOD))
    assert config.simulated
    assert config.cage.limits.current_A == (2.0, 2.0, 2.0)
    np.testing.assert_array_equal(config.cage.matrix[:, 1], [100, 50000, 0])
    assert "secret" not in config.model_dump_json()
    assert "secret" not in repr(config)


@pytest.mark.parametrize(
    ("old", "new", "line", "says"),
    [
        ('unit = "count"', 'unit = "furlong"', 9, "dut.unit"),
        ('serial = "EM-07"', 'serial = "EM-07"\nserail = 1', 9, "dut.serail is not a key"),
        ('serial = "EM-07"', 'serail = "EM-07"', 8, "dut.serail is not a key"),
        ("current_A = 2.0", "current_A = true", 5, "cage.limits.current_A"),
        ("current_A = 2.0", f"current_A = {'9' * 5000}", None, "is not TOML"),
        ("secret = 1", f"secret = {'[' * 100_000}", None, "nested too deeply"),
        ("secret = 1", f"{'a.' * 20_000}a = 1", None, "nested too deeply"),
        ("secret = 1", f"# {'x' * 300_000}", None, "is longer than 256 KiB"),
        ("current_A = 2.0", "current_A = -2.0", 5, "cage.limits.current_A"),
        ("current_A = 2.0", "current_A = nan", 5, "cage.limits.current_A"),
        ('role = "coil-y"', 'role = "coil-x"', None, "two instruments have the role coil-x: x, y"),
        ('link = "emulated://", role = "platform"', 'link = "ttyUSB0", role = "platform"', 15, "stage.link"),
        ("[50000, 100, 0], [0, 50000, 0]", "[50000, 100, 0], [50000, 100, 0]", 3, "singular"),
        ("name =", "name", 1, "is not TOML"),
        ("name =", "\ufeffname =", 1, "byte order mark"),
        ('name = "cage-2"', 'name = "cage\\u001b[31m"', 1, "name has characters that cannot be printed"),
        ("current_A = 2.0", "current_A = [2.0, 2.0]", 5, "current_A must be one number, or three, one for each axis"),
        ('serial = "EM-07"', 'model = "EM-07"', 7, "dut.serial is missing"),
        ('serial = "EM-07"', 'serial = ""', 8, "dut.serial must not be empty"),
        ("ramp_A_per_s = [2, 2, 2]", "ramp_A_per_s = [2, 0, 2]", 5, "ramp_A_per_s.1 must be greater than 0"),
    ],
)
def test_a_fault_names_file_line_and_key(tmp_path: Path, old: str, new: str, line: int | None, says: str) -> None:
    path = config_of(tmp_path, GOOD.replace(old, new, 1))
    with pytest.raises(InputError) as caught:
        read_config(path)
    assert says in str(caught.value)
    assert caught.value.file == path
    if line is not None:
        assert caught.value.line == line


def test_the_line_found_is_the_nearest_key_that_is_stated() -> None:
    text = "[a]\nb = 1\n[a.c]\nd = 2\n"
    assert line_of(text, ("a", "b")) == 2
    assert line_of(text, ("a", "c", "d", "0")) == 4
    assert line_of(text, ("a", "c", "missing")) == 3
    assert line_of(text, ("z",)) is None


def test_the_group_of_safety_and_its_folder_are_read(tmp_path: Path) -> None:
    stated = '[safety]\ngroup = "magnetics"\nruntime = "/run/labcal"\n'
    (tmp_path / "bench.toml").write_text(GOOD + stated)
    safety = read_config(tmp_path / "bench.toml").safety
    assert (safety.group, safety.runtime) == ("magnetics", "/run/labcal")


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ('group = ""', "safety.group must be the name of a group"),
        ('group = "a b"', "safety.group must be the name of a group"),
        ('group = "../x"', "safety.group must be the name of a group"),
        ('group = "g"\nruntime = "run"', "safety.runtime must be the whole path of a folder"),
        ('group = "g"\nruntime = "/run/../x"', "safety.runtime must be the whole path"),
        ('group = "g"\nruntime = "/' + "x" * 60 + '"', "of at most 60"),
        ('runtime = "/run/labcal"', "runtime is the folder of a group: state group too"),
        ("team = 1", "safety.team is not a key"),
    ],
)
def test_a_group_or_folder_that_can_be_none_is_refused(tmp_path: Path, stated: str, said: str) -> None:
    (tmp_path / "bench.toml").write_text(f"{GOOD}\n[safety]\n{stated}\n")
    with pytest.raises(InputError) as caught:
        read_config(tmp_path / "bench.toml")
    assert said in str(caught.value)
