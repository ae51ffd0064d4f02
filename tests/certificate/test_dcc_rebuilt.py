"""The correction worked out again from the DCC alone, for every effect that ships: the enclosed file is taken out."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from test_flight_c import FORMS, SMOOTH, calibration, smooth, with_own_channels

from labcal.certificate.dcc import DCC, SI, dcc_xml
from labcal.certificate.report import Circumstances
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter
from labcal.model.apply import apply
from labcal.model.readings import readings_of
from labcal.model.smooth import Basis, Domain
from labcal.record import Administrative, Run
from labcal.record.administrative import Address, Laboratory

etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
NAMES = {"dcc": DCC, "si": SI}
SAID = Circumstances(Administrative(Laboratory("A lab", "Bern", "CH"), Address("X", "Y", "DE")))
CASES = [*FORMS, *SMOOTH]


@pytest.fixture(scope="module")
def run() -> Run:
    return with_own_channels()


def text_of(element: Any, path: str) -> str:
    return str(element.findtext(path, "", NAMES))


def numbers(element: Any) -> np.ndarray:
    [found] = [*element.iterfind(".//si:valueXMLList", NAMES), *element.iterfind("si:real/si:value", NAMES)]
    return np.array(found.text.split(), dtype=float)


def quantities(result: Any, kind: str) -> dict[str, Any]:
    found = result.iterfind(f".//dcc:quantity[@refType='{kind}']", NAMES)
    return {text_of(one, "dcc:name/dcc:content"): one for one in found}


def matrices(result: Any, named: str) -> dict[str, tuple[tuple[float, ...], ...]]:
    """Those whose name begins so, by what follows it, in the shape that the name says."""
    found = {}
    for name, one in quantities(result, "labcal_basis").items():
        if match := re.fullmatch(rf"{named}(.*): (\d+) by (\d+)", name):
            rows = numbers(one).reshape(int(match[2]), int(match[3]))
            found[match[1].strip()] = tuple(map(tuple, rows.tolist()))
    return found


def effect_of(result: Any) -> EffectRecord:
    """What the XML states of one effect: name, channels, reference values, parameters, and its basis."""
    said = text_of(result, "dcc:description/dcc:content")
    reference = {name: numbers(one)[0] for name, one in quantities(result, "labcal_channelReference").items()}
    values = quantities(result, "labcal_effectParameter")
    parameters = tuple(Parameter(name, numbers(one)[0], 0.0, "") for name, one in values.items())
    name = text_of(result, "dcc:name/dcc:content").partition(": ")[2]
    record = EffectRecord(name, tuple(reference), reference, "sensor", parameters, holdout_rms_before_nT=1.0)
    if (degree := re.search(r"B-splines of degree (\d)", said)) is None:
        return record
    knots = matrices(result, "knots of ")
    hulls = matrices(result, "corners of what was seen, ")
    s = np.reshape([p.value for p in parameters], (-1, 3))
    parts = {"knots": tuple(row for (row,) in knots.values()), "coefficients": tuple(map(tuple, s.tolist()))}
    parts |= {name: matrices(result, name)[""] for name in ("functions", "projection")}
    no_u = tuple(map(tuple, np.zeros((s.size, s.size)).tolist()))
    basis = Basis(kind="B-splines", degree=int(degree[1]), prior_nT=0.0, covariance=no_u, **parts)
    hull = tuple(zip(*(row for (row,) in hulls.values()), strict=True))
    return replace(record, inputs=tuple(knots), basis=basis, domain=(Domain(tuple(hulls), hull),))


def rebuilt(xml: bytes, like: Calibration) -> Calibration:
    """K, k and the effects from the XML; what says where they hold as it was."""
    root = etree.fromstring(xml)
    root.remove(root.find("dcc:document", NAMES))
    one = {kind: root.find(f".//dcc:result[@refType='labcal_{kind}']", NAMES) for kind in "Kk"}
    effects = tuple(effect_of(one) for one in root.iterfind(".//dcc:result[@refType='labcal_effect']", NAMES))
    affine = AffineMap.from_parameters(np.r_[numbers(one["K"]), numbers(one["k"])])
    return replace(like, affine=affine, effects=effects, covariance=None)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case if isinstance(case, str) else " ".join(case))
def test_every_effect_comes_again_from_the_xml_alone(case: str | tuple[str, ...], run: Run):
    """A form of an effect that has a name, or the inputs of one that has none."""
    made = calibration(*FORMS[case]) if isinstance(case, str) else replace(calibration(), effects=(smooth(case, run),))
    xml = dcc_xml(made, b"{}", "calibration.json", run, SAID)
    readings = readings_of(run)
    ours, theirs = apply(made, readings), apply(rebuilt(xml, made), readings)
    np.testing.assert_allclose(theirs.field_nT, ours.field_nT, rtol=1e-12, atol=1e-12 * 60_000)
    if made.effects:
        without = apply(replace(made, effects=()), readings)
        assert np.nanmax(np.abs(without.field_nT - ours.field_nT)) > 0.1
