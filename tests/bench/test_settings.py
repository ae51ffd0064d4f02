"""Settings of a driver that cannot be: refused with file, line and key while the bench file is read."""

from __future__ import annotations

from pathlib import Path

import pytest
from served_lab import EXAMPLE

from labcal.bench.opening import load_bench
from labcal.errors import InputError

WRONG = [
    ("coil-x", "riden-rd60xx", "address = 300", "address: must be less than or equal to 247"),
    ("coil-x", "riden-rd60xx", "address = 0", "address: must be greater than or equal to 1"),
    ("coil-x", "tti-pl", "timeout_s = 0.0", "timeout_s: must be greater than 0"),
    ("coil-x", "tti-pl", "max_current_A = -1.0", "max_current_A: must be greater than 0"),
    ("coil-x", "tti-pl", "output = 9", "output: must be less than or equal to 4"),
    ("polarity", "waveshare-relay", "x = 99", "x: must be less than or equal to 31"),
    ("polarity", "waveshare-relay", "x = 0, y = 0, z = 1", "each axis has a relay of its own"),
    ("platform", "leadshine", "gear = 0.0", "gear: must be greater than 0"),
    ("platform", "oriental-az", "steps_per_turn = 0", "steps_per_turn: must be greater than or equal to 1"),
    ("platform", "zaber", "address = 0", "address: must be greater than or equal to 1"),
    ("reference", "hmr2300", "invalid = -1", "invalid: must be greater than or equal to 0"),
    ("reference", "hmr2300", "mode = 'poll'", "mode: must be 'continuous' or 'polled'"),
]


def with_instrument(role: str, driver: str, rest: str) -> str:
    """The example, with another instrument in this role."""
    blocks = EXAMPLE.read_text(encoding="utf-8").split("\n[")
    (at,) = (k for k, block in enumerate(blocks) if f'role = "{role}"' in block)
    head = blocks[at].partition("\n")[0]
    blocks[at] = f'{head}\ndriver = "{driver}"\nrole = "{role}"\n{rest}\n'
    return "\n[".join(blocks)


@pytest.mark.parametrize(("role", "driver", "settings", "says"), WRONG)
def test_a_setting_that_cannot_be_is_refused(role: str, driver: str, settings: str, says: str, tmp_path: Path) -> None:
    file = tmp_path / "bench.toml"
    file.write_text(with_instrument(role, driver, f'link = "emulated://"\nsettings = {{ {settings} }}'))
    with pytest.raises(InputError) as caught:
        load_bench(file, None, 1)
    assert says in str(caught.value)
    assert caught.value.line is not None


def test_one_output_cannot_drive_two_coils(tmp_path: Path) -> None:
    file = tmp_path / "bench.toml"
    text = with_instrument("coil-x", "tti-pl", 'link = "emulated://one"')
    file.write_text(text.replace('link = "emulated://"\nrole = "coil-y"', 'link = "emulated://one"\nrole = "coil-y"'))
    with pytest.raises(InputError, match="supply_x has the same link, address and output"):
        load_bench(file, None, 1)
