from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.certificate.calibration_file import LARGEST_BYTES, calibration_bytes, parse_calibration, read_calibration
from labcal.errors import InputError
from labcal.model import AffineMap, Calibration

GOLDEN = Path(__file__).parents[1] / "golden" / "calibration-1.json"
GOLDEN_2 = GOLDEN.with_name("calibration-2.json")
# fmt: off
CONTRACT_FIELDS = {
    "format", "run_id", "simulated", "dut", "K", "k_nT", "covariance", "frame_known", "effects", "findings",
    "validity", "span_s", "metrics", "instruments", "run_sha256", "cage_sha256", "supersedes", "software", "operator",
    "approvers",
}
ADDED_FIELDS = {
    "covariance_of", "k_at", "budget", "not_covered", "specification", "made_by", "chain", "number", "issued_utc",
}
EFFECT_FIELDS = {
    "effect", "channels", "reference_value", "belongs_to", "provisional", "parameters", "holdout_rms_before_nT",
    "holdout_rms_after_nT", "improvement_ci95_nT", "p_value", "rivals", "why",
}
# fmt: on


def test_file_has_exactly_the_contract_s_fields(calibration: Calibration):
    stated = json.loads(calibration_bytes(calibration))
    assert set(stated) == CONTRACT_FIELDS | ADDED_FIELDS
    assert set(json.loads(GOLDEN.read_bytes())) == CONTRACT_FIELDS
    assert set(stated["dut"]) == {"serial", "model", "unit", "nominal_nT_per_unit"}
    assert set(stated["validity"]) == {"field_nT", "temperature_C", "modes", "until"}
    assert set(stated["metrics"]) == {"before", "after"}
    assert set(stated["effects"][0]) == set(stated["findings"][0]) == EFFECT_FIELDS
    assert set(stated["effects"][0]["parameters"][0]) == {"name", "value", "u", "unit"}
    assert set(stated["effects"][0]["rivals"][0]) == {"effect", "channels", "holdout_rms_after_nT"}


def test_golden_file_reads_and_repeats_byte_for_byte(calibration: Calibration):
    assert calibration_bytes(read_calibration(GOLDEN)) == GOLDEN.read_bytes()
    assert calibration_bytes(replace(calibration, format="labcal-calibration/1")) == GOLDEN.read_bytes()


def joint(calibration: Calibration) -> Calibration:
    """As the loop ships it: k is correlated with the current's coefficients."""
    names = (*calibration.covariance_of, "0:c_x", "0:c_y", "0:c_z")
    C = np.diag([1e-10] * 9 + [4.0] * 3 + [0.16] * 3)
    for axis in range(3):
        C[9 + axis, 12 + axis] = C[12 + axis, 9 + axis] = 0.67 * 2.0 * 0.4
    return replace(calibration, covariance=C, covariance_of=names, k_at={"i_eps": 0.25}, not_covered=("Ageing.",))


def test_the_second_version_holds_one_covariance_of_map_and_effects(calibration: Calibration):
    assert calibration_bytes(joint(calibration)) == GOLDEN_2.read_bytes()
    again = read_calibration(GOLDEN_2)
    assert calibration_bytes(again) == GOLDEN_2.read_bytes()
    assert again.joint_covariance()[9, 12] == pytest.approx(0.67 * 2.0 * 0.4)
    assert again.k_means() == "at i_eps = 0.25 A"
    old = read_calibration(GOLDEN).joint_covariance()
    assert old.shape == (15, 15)
    assert old[12, 12] == pytest.approx(0.16)
    assert not old[:12, 12:].any()


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (lambda s: s["covariance_of"].__setitem__(12, "1:c_x"), "covariance_of: .*1:c_x is not there"),
        (lambda s: s["covariance_of"].__setitem__(0, "k_x"), "covariance_of: names one thing twice"),
        (lambda s: s["covariance_of"].pop(), "covariance: has 15 rows for 14 names"),
        (lambda s: s["covariance"].pop(), "covariance: is not square"),
        (lambda s: s.update(made_by={"command": "fit"}), "made_by"),
    ],
)
def test_a_covariance_that_does_not_say_of_what_is_refused(
    calibration: Calibration, change: Callable[[dict[str, Any]], object], where: str
):
    stated = json.loads(calibration_bytes(joint(calibration)))
    change(stated)
    with pytest.raises(InputError, match=where):
        parse_calibration(json.dumps(stated).encode())


def test_bytes_are_canonical_json(calibration: Calibration):
    text = calibration_bytes(calibration).decode()
    plain = json.dumps(json.loads(text), sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    assert text == plain.replace("1e-09", "1e-9")  # Python's own writing of floats differs there alone
    assert "Häberli" in text


def test_reading_gives_back_what_was_written(calibration: Calibration, draft: Path):
    again = read_calibration(draft)
    np.testing.assert_array_equal(again.affine.K, calibration.affine.K)
    np.testing.assert_array_equal(again.affine.k_nT, calibration.affine.k_nT)
    np.testing.assert_array_equal(again.covariance, calibration.covariance)
    for name in ("dut", "effects", "findings", "validity", "span_s", "run_sha256", "instruments", "operator"):
        assert getattr(again, name) == getattr(calibration, name), name


def test_a_calibration_without_loop_metrics_repeats_too(calibration: Calibration):
    first = calibration_bytes(replace(calibration, metrics={}, covariance=None, effects=(), findings=()))
    assert calibration_bytes(parse_calibration(first)) == first


def put(*steps: Any, value: Any) -> Callable[[dict[str, Any]], None]:
    def change(stated: Any) -> None:
        for step in steps[:-1]:
            stated = stated[step]
        stated[steps[-1]] = value

    return change


@pytest.mark.parametrize(
    ("change", "where"),
    [
        (put("format", value="labcal-calibration/3"), "format"),
        (put("novelty", value=1), "novelty"),
        (put("\x1b[2J", value=1), r"'\\x1b\[2J'"),
        (put("effects", 0, "parameters", 1, "u", value=-1), r"effects\[0\]\.parameters\[1\]\.u"),
        (put("effects", 0, "novelty", value=1), r"effects\[0\]\.novelty"),
        (put("K", 1, value=[0, 0, 0]), "K: is not invertible"),
        (put("K", value=[[0, 0, 0]] * 3), "K: is not invertible"),
        (put("K", 2, value=[1, 2]), r"K\[2\]"),
        (put("K", 0, 0, value="1"), r"K\[0\]\[0\]"),
        (put("k_nT", 0, value=True), r"k_nT\[0\]"),
        (put("covariance", 0, 1, value=1e-11), "covariance: is not symmetric"),
        (put("covariance", 0, 0, value=-1), "covariance: has a negative variance"),
        (put("covariance", value=[[1.0] * 12] * 11), "covariance"),
        (put("span_s", value=[10, 0]), "span_s: .*backward"),
        (put("validity", "field_nT", value=[2, 1]), "validity.field_nT"),
        (put("validity", "modes", value=["safe", "safe"]), "validity.modes"),
        (put("validity", "until", value="next year"), "validity.until"),
        (put("effects", 0, "belongs_to", value="rig"), "effects: .*findings"),
        (put("findings", 0, "belongs_to", value="sensor"), "findings: .*effects"),
        (put("run_sha256", value="AB" * 32), "run_sha256"),
        (put("run_sha256", value="ab" * 32 + "\n"), "run_sha256"),
        (put("dut", "unit", value="gauss"), "dut.unit"),
        (put("approvers", value=["Ada", "Ada"]), "approvers"),
        (put("approvers", value=["\x1b[2JAda"]), r"approvers\[0\]: .*U\+001B"),
        (put("dut", "serial", value="FM\u202e70"), r"dut\.serial: .*U\+202E"),
    ],
)
def test_a_fault_is_named_with_its_path(
    calibration: Calibration, tmp_path: Path, change: Callable[[dict[str, Any]], None], where: str
):
    stated = json.loads(calibration_bytes(calibration))
    change(stated)
    path = tmp_path / "bad.json"
    path.write_text(json.dumps(stated))
    with pytest.raises(InputError, match=where) as caught:
        read_calibration(path)
    assert caught.value.file == path


def test_an_indefinite_covariance_is_refused(calibration: Calibration):
    stated = json.loads(calibration_bytes(calibration))
    stated["covariance"][0][1] = stated["covariance"][1][0] = 2e-10  # correlation 2
    with pytest.raises(InputError, match="covariance: is not positive semi-definite"):
        parse_calibration(json.dumps(stated).encode())


def test_every_field_but_the_evidence_of_an_effect_is_required(calibration: Calibration):
    stated = json.loads(calibration_bytes(calibration))
    for name in CONTRACT_FIELDS:
        short = {key: value for key, value in stated.items() if key != name}
        with pytest.raises(InputError, match=f"{name}: field required"):
            parse_calibration(json.dumps(short).encode())


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"", "is not JSON"),
        (b'{"a": 1', "is not JSON"),
        (b'{"format": "labcal-calibration/1"} {}', "is not JSON: Extra data"),
        (b'{"format": 1, "format": 2}', "'format' twice"),
        (b'{"k_nT": [NaN, 0, 0]}', "NaN"),
        (b'{"k_nT": [1e999, 0, 0]}', "field required|finite"),
        (b"[" * 200_000, "nested too deeply|is not JSON"),
        (b"[" + b"9" * 5000 + b"]", "digits|dictionary|object"),
        (b"\xff\xfe{\x00}\x00", "is not UTF-8"),
        (b"\xef\xbb\xbf{}", "is not JSON|BOM"),
        (b'"text"', "object"),
    ],
)
def test_broken_json_is_one_sentence(content: bytes, what: str):
    with pytest.raises(InputError, match=what) as caught:
        parse_calibration(content, "cal.json")
    assert str(caught.value).startswith("cal.json")
    assert "\n" not in str(caught.value)


def test_infinity_and_lone_surrogates_are_refused(calibration: Calibration):
    whole = calibration_bytes(calibration)
    with pytest.raises(InputError, match=r"k_nT\[0\]"):
        parse_calibration(whole.replace(b'"k_nT":[120', b'"k_nT":[1e999'))
    with pytest.raises(InputError):
        parse_calibration(whole.replace(b'"FM-07"', rb'"\ud800"'))


def test_huge_and_strange_files_are_refused_unread(tmp_path: Path):
    huge = tmp_path / "huge.json"
    with huge.open("wb") as out:
        out.truncate(LARGEST_BYTES + 1)
    with pytest.raises(InputError, match="larger than"):
        read_calibration(huge)
    os.mkfifo(tmp_path / "pipe")
    for strange in (tmp_path, tmp_path / "pipe", Path("/dev/zero")):
        with pytest.raises(InputError, match="not a regular file"):
            read_calibration(strange)


def test_what_could_not_be_read_is_not_written(calibration: Calibration):
    singular = replace(calibration, affine=AffineMap(np.zeros((3, 3)), np.zeros(3)))
    with pytest.raises(InputError, match="K: is not invertible"):
        calibration_bytes(singular)
    lost = replace(calibration, affine=AffineMap(calibration.affine.K, np.array([np.nan, 0, 0])))
    with pytest.raises(InputError, match=r"k_nT\[0\]"):
        calibration_bytes(lost)
