"""What others rely on of the bench's rooms: a driver's first names for the kit, and `bench off` without a wait."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module

import pytest


@pytest.mark.parametrize(
    ("first", "now", "names"),
    [
        ("roles", "roles", ["CoilSupply", "DutStream", "Identity", "Magnetometer", "RotationPlatform", "ChannelSpec"]),
        ("instrument", "quantity", ["quantity", "decimal", "DECIMAL"]),
        ("settings", "settings", ["Positive", "NotNegative", "Count", "Address", "Output"]),
        ("testing", "testing", ["scripted", "SILENT", "UNPLUGGED"]),
    ],
)
def test_a_driver_of_another_package_finds_the_kit_under_its_first_names(
    first: str, now: str, names: list[str]
) -> None:
    old, kit = import_module(f"labcal.bench.{first}"), import_module(f"labcal.bench.driver_kit.{now}")
    assert [getattr(old, name) for name in names] == [getattr(kit, name) for name in names]


def test_who_only_wants_the_coils_off_waits_for_no_numpy() -> None:
    ask = "import sys, labcal.bench.shutdown; print(*{'numpy', 'pydantic', 'scipy'} & {*sys.modules})"
    said = subprocess.run([sys.executable, "-c", ask], capture_output=True, text=True, check=True, timeout=60)
    assert said.stdout.strip() == ""
