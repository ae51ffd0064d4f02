"""One value of a TOML text changed: every other line, comments and blanks included, stays as it was."""

import tomllib
from pathlib import Path

import pytest

from labcal.errors import InputError
from labcal.files.toml_edit import edited, stated

EXAMPLE = (Path(__file__).parents[1] / "examples" / "simulated.toml").read_text(encoding="utf-8")
TEXT = """# a bench
name = "cage # 2" # whose

[cage.limits] # what the wire bears
current_A = 2.5   # A, each
# ramp_A_per_s =      # full current down within 1.5 s
rows = [
    [1.0, 2.0]
]

["odd name".x]
a = 1
"""


def other_lines(old, new):
    return [line for line in old.splitlines() if line not in new.splitlines()]


@pytest.mark.parametrize(
    ("keys", "value", "gone", "come"),
    [
        (("name",), '"b"', 'name = "cage # 2" # whose', 'name = "b" # whose'),
        (("cage", "limits", "current_A"), "3.0", "current_A = 2.5   # A, each", "current_A = 3.0   # A, each"),
        (
            ("cage", "limits", "ramp_A_per_s"),
            "2.0",
            "# ramp_A_per_s =      # full current down within 1.5 s",
            "ramp_A_per_s = 2.0  # full current down within 1.5 s",
        ),
        (("cage", "limits", "current_A"), "", "current_A = 2.5   # A, each", ""),
    ],
)
def test_one_line_is_another_and_its_comment_stays(keys, value, gone, come):
    new = edited(TEXT, keys, value)
    assert other_lines(TEXT, new) == [gone]
    assert come in new.splitlines()


def test_what_is_new_comes_at_the_end_of_its_table_or_in_one_of_its_own():
    assert "surprise = true\nseed = 3\n" in edited(EXAMPLE, ("twin", "seed"), "3")
    made = edited(EXAMPLE.removesuffix("\n"), ("safety", "group"), '"lab"')
    assert made.startswith(EXAMPLE)
    assert tomllib.loads(made)["safety"] == {"group": "lab"}


@pytest.mark.parametrize("value", ["3,0", "two", "1\ny = 2", "3 # more", '"open', "[1", "1]"])
def test_what_is_no_value_is_refused_by_name(value):
    with pytest.raises(InputError, match=r"cage\.limits\.current_A: .* is no value of TOML"):
        edited(EXAMPLE, ("cage", "limits", "current_A"), value)


def test_what_cannot_be_changed_in_one_line_is_left_to_the_file():
    assert stated(EXAMPLE, ("cage", "matrix_nT_per_A")) is None
    with pytest.raises(InputError, match="change it in the file itself"):
        edited(EXAMPLE, ("cage", "matrix_nT_per_A"), "[1.0]")
    with pytest.raises(InputError, match="name is no table"):
        edited(EXAMPLE, ("name", "x"), "1")
