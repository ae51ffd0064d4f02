"""The budget on paper, in the certificate for machines and in the file: the same numbers, the largest first."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from labcal.certificate.calibration_file import calibration_bytes, parse_calibration
from labcal.certificate.dcc import dcc_xml
from labcal.certificate.report import Circumstances
from labcal.certificate.report.budget import budget_blocks, draw_shares, field_blocks, largest
from labcal.fit import draft_calibration, fit
from labcal.model import Calibration
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory
from labcal.store import load_bundle
from labcal.uncertainty.budget import Budget, Correlation, Row

ROOT = Path(__file__).parents[2]
ROWS = (
    Row("reference zero x", "B", "normal", 30.0, "nT", -0.9, np.inf),  # 27 nT
    Row("noise of one reading", "A", "normal", 12.0, "nT", 1.0, 8.0),  # 12 nT
    Row("reference scale", "B", "normal", 400.0, "ppm", 0.05, np.inf),  # 20 nT
)


@pytest.fixture
def budgeted(calibration: Calibration) -> Calibration:
    field = Budget("b x", "50 µT along +x", "nT", ROWS, (Correlation("k_x", "0:c_x", 0.67),))
    scale = Budget("scale x", "", "nT/count", (replace(ROWS[2], sensitivity=5e-7),))
    return replace(calibration, budget=(field.as_json(), scale.as_json()))


def test_a_budget_survives_the_file(budgeted: Calibration) -> None:
    again = parse_calibration(calibration_bytes(budgeted))
    assert calibration_bytes(again) == calibration_bytes(budgeted)
    field = again.budget[0]
    assert field["rows"][0]["share"] == pytest.approx(27**2 / (27**2 + 12**2 + 20**2), rel=1e-5)
    assert field["dof"] == pytest.approx((27**2 + 12**2 + 20**2) ** 2 / (12**4 / 8), rel=1e-5)
    assert again.budget[1]["dof"] is None
    assert again.budget[1]["k"] == pytest.approx(2.0, abs=1e-4)


def test_on_paper_the_largest_contribution_comes_first(budgeted: Calibration) -> None:
    overview, figures, _, in_full, _ = [*field_blocks(budgeted), *budget_blocks(budgeted)]
    assert overview.rows[0][0] == "50 µT along +x"
    assert (
        overview.rows[0][-1] == "reference zero x 57\u00a0%, reference scale 31\u00a0%" == largest(budgeted.budget[0])
    )
    assert figures.rows[0][:3] == ("scale x", "–", "0.00040")
    assert [row[0] for row in in_full.rows] == ["reference zero x", "reference scale", "noise of one reading"]
    assert [row[-1] for row in in_full.rows] == ["∞", "∞", "8"]
    assert in_full.rows[0][3:7] == ("30 nT", "−0.9", "27.0", "57.3 %")
    assert "k_x and 0:c_x +0.67" in in_full.caption


def test_the_picture_stacks_each_quantity_to_its_whole_variance(budgeted: Calibration) -> None:
    figure = Figure()
    draw_shares(figure, budgeted.budget)
    (axes,) = figure.axes
    ends = {round(bar.get_y(), 3): 0.0 for bar in axes.patches}
    for bar in axes.patches:
        ends[round(bar.get_y(), 3)] += bar.get_width()
    assert list(ends.values()) == pytest.approx([1.0, 1.0], abs=1e-5)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "reference zero",
        "noise of one reading",
        "reference scale",
    ]


def test_without_a_budget_nothing_is_shown(calibration: Calibration) -> None:
    assert budget_blocks(calibration) == []


def test_the_certificate_for_machines_lists_every_contribution(budgeted: Calibration) -> None:
    etree = pytest.importorskip("lxml.etree")
    run = load_bundle(ROOT / "examples" / "short-preflight" / "run.zip").run()
    lab = Circumstances(Administrative(Laboratory("A lab", "Bern", "CH"), Address("A lab", "Bern", "CH")))
    text = dcc_xml(budgeted, calibration_bytes(budgeted), "cal.json", run, lab)
    names = {"dcc": "https://ptb.de/dcc", "si": "https://ptb.de/si"}
    root = etree.fromstring(text)
    results = {r.findtext("dcc:name/dcc:content", namespaces=names): r for r in root.iterfind(".//dcc:result", names)}
    found = results["Contributions to the standard uncertainty of b x at 50 µT along +x"]
    parts = [float(v) for v in found.findtext(".//si:valueXMLList", namespaces=names).split()]
    assert parts == pytest.approx([27.0, 12.0, 20.0])
    said = found.findtext("dcc:description/dcc:content", namespaces=names)
    assert "reference scale (type B, normal, u = 400 ppm, sensitivity 0.05, 31.4 %)" in said
    assert "k at i_eps = 0.25 A" in results


def test_a_method_that_tells_its_sources_apart_has_a_budget_of_its_own() -> None:
    run = load_bundle(ROOT / "examples" / "short-preflight" / "run.zip").run()
    made = draft_calibration(run, fit(run, "twostep", holdout=False), "0" * 64)
    sources = {row["source"] for row in made.budget[0]["rows"]}
    assert {"noise of the run, through the fit", "noise of one reading"} < sources
    assert not any("axes" in source for source in sources)  # of magnitudes a turn moves nothing
