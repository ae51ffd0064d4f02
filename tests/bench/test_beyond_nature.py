"""Numbers that no lab can mean are refused wherever a person states them."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal.bench.config import read_config
from labcal.bench.parameters import ParameterSpec
from labcal.errors import InputError

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "simulated.toml"


@pytest.mark.parametrize(
    ("stated", "instead"),
    [
        ("field_nT = 120000.0", "field_nT = 1e308"),
        ("field_nT = 100000.0", "field_nT = 1.1e9"),
        ("current_A = 2.5", "current_A = 1e5"),
        ("49942.0", "1e300"),
        ("nominal_nT_per_unit = 4.0", "nominal_nT_per_unit = 1e20"),
    ],
)
def test_a_bench_file_states_no_field_beyond_a_tesla(tmp_path: Path, stated: str, instead: str) -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    assert stated in text
    path = tmp_path / "bench.toml"
    path.write_text(text.replace(stated, instead, 1), encoding="utf-8")
    with pytest.raises(InputError, match="less than or equal to"):
        read_config(path)


@pytest.mark.parametrize(("name", "text"), [("field_nT", "1e308"), ("current_A", "-2e4"), ("turns", "nan")])
def test_a_setting_without_limits_has_those_of_nature(name: str, text: str) -> None:
    spec = ParameterSpec(name, "number", 0.0)
    assert spec.parse("1000") == 1000
    with pytest.raises(InputError, match=f"{name} = .* is refused"):
        spec.parse(text)
