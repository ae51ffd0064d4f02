"""A procedure's declaration becomes values, and every refusal says what was expected."""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Literal

import pytest

from labcal.bench.parameters import Limits, parameters_of, settings
from labcal.errors import InputError


def spin(
    bench: object,
    *,
    rate: Annotated[float, Limits(0.1, 36, unit="deg/s"), "how fast"] = 2.0,
    magnitudes_nT: Annotated[tuple[float, ...], Limits(1e3, 1e5, unit="nT")] = (2e4, 5e4),
    turns: Annotated[int, Limits(1, 9)] = 1,
    stepped: bool = False,
    sense: Literal["forward", "backward"] = "forward",
    orbit: Path | None = None,
    modes: tuple[str, ...] = ("nominal", "full"),
) -> Iterator[object]:
    yield rate


def test_the_declaration_carries_unit_range_default_and_words() -> None:
    rate = parameters_of(spin)[0]
    assert (rate.name, rate.unit, rate.default, rate.help) == ("rate", "deg/s", 2.0, "how fast")
    assert rate.expected == "a number from 0.1 to 36 deg/s"


def test_text_becomes_typed_values_and_the_rest_keeps_its_default() -> None:
    given = {"rate": "3", "magnitudes_nT": "30000, 40000", "turns": "2", "stepped": "yes", "sense": "backward"}
    values = settings(parameters_of(spin), given | {"orbit": "a.csv"})
    assert values == {
        "rate": 3.0,
        "magnitudes_nT": (3e4, 4e4),
        "turns": 2,
        "stepped": True,
        "sense": "backward",
        "orbit": Path("a.csv"),
        "modes": ("nominal", "full"),
    }


@pytest.mark.parametrize(
    ("key", "text", "says"),
    [
        ("rate", "99", "from 0.1 to 36 deg/s"),
        ("rate", "nan", "from 0.1 to 36 deg/s"),
        ("rate", "fast", "a number"),
        ("turns", "1.5", "a whole number"),
        ("magnitudes_nT", "20000,2", "several with commas"),
        ("magnitudes_nT", "", "is empty"),
        ("sense", "up", "one of forward, backward"),
        ("stepped", "perhaps", "yes or no"),
        ("speed", "1", "no parameter is called 'speed'"),
    ],
)
def test_what_is_wrong_is_refused_with_what_was_expected(key: str, text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        settings(parameters_of(spin), {key: text})


def test_a_default_outside_its_own_range_is_a_wrong_declaration() -> None:
    def wrong(bench: object, *, rate: Annotated[float, Limits(0, 1)] = 2.0) -> Iterator[object]:
        yield rate

    with pytest.raises(InputError, match="rate = 2"):
        parameters_of(wrong)
