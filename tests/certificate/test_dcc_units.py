"""Units of the DCC by the names of D-SI, and those of covariances."""

from __future__ import annotations

import pytest

from labcal.certificate.dcc import si_unit
from labcal.certificate.dcc.units import product

pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")


@pytest.mark.parametrize(
    ("unit", "name"),
    [
        ("nT", r"\nano\tesla"),
        ("nT/degC", r"\nano\tesla\per\degreecelsius"),
        ("1/nT", r"\per\nano\tesla"),
        ("1", r"\one"),
        ("count", "|count"),
        ("nT/A^2", r"\nano\tesla\per\ampere\tothe{2}"),
        ("nT/mA", "|nT/mA"),
        ("nT/", r"\nano\tesla"),
    ],
)
def test_units_have_their_si_names(unit: str, name: str):
    assert si_unit(unit) == name


@pytest.mark.parametrize(
    ("one", "other", "name"),
    [
        ("nT/A", "nT/A", r"\nano\tesla\tothe{2}\per\ampere\tothe{2}"),
        ("nT/A", "nT", r"\nano\tesla\tothe{2}\per\ampere"),
        ("nT", "1/nT", r"\one"),
        ("1/nT", "1/degC", r"\per\nano\tesla\degreecelsius"),
        ("1", "1", r"\one"),
        ("nT/count", "nT/A", "|nT^2/(count·A)"),
        ("nT/count", "nT", "|nT^2/count"),
    ],
)
def test_the_unit_of_a_covariance_is_one_fraction(one: str, other: str, name: str):
    """What stands behind D-SI's per is below the line: nT/A times nT is no nT/(A nT)."""
    assert product(one, other) == name
