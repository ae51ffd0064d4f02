"""Forgeries of a draft before it is signed, and what a lab sees that has the run: each ends with its field's name."""

from __future__ import annotations

import json
import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import rfc8785
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import session
from labcal.certificate import Signer, keys, read_calibration, signing
from labcal.certificate.calibration_file import calibration_bytes
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home
from labcal.loop import policy
from labcal.record import Channel
from labcal.session import working_out
from labcal.session.of_its_record import OfRecord
from labcal.store import write_bundle
from labcal.testing.made_up_runs import made_up_run

Edit = Callable[[dict[str, Any]], object]
ROWS = 60  # of a turn; three turns


@pytest.fixture(scope="module")
def prepared(tmp_path_factory: pytest.TempPathFactory) -> SimpleNamespace:
    """A home with a run whose sensor follows a current, 500, -300 and 100 nT/A, and what `labcal fit` makes of it."""
    current = np.where(np.arange(3 * ROWS) // 9 % 2 == 0, 1.0, 0.0)
    channel = Channel("i_load", "A", "current", current)
    made = made_up_run(rows=ROWS, fields_nT=((30e3, 20e3, 25e3),), channels=[channel], noise_nT=5.0)
    folder = tmp_path_factory.mktemp("prepared")
    write_bundle(made.with_effect(np.outer(current, [500.0, -300.0, 100.0])), folder / "run")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("LABCAL_HOME", str(folder / "home"))
        run_id = session.import_bundle(folder / "run")
        session.draft(run_id, session.fit_run(run_id)[1][0], folder / "cal.json")
    draft = (folder / "cal.json").read_bytes()
    return SimpleNamespace(run_id=run_id, bundle=folder / "run", home=folder / "home", draft=draft)


@pytest.fixture
def run_id(prepared: SimpleNamespace) -> str:
    """That run, in this test's own store."""
    shutil.copytree(prepared.home, home(), dirs_exist_ok=True)
    return str(prepared.run_id)


@pytest.fixture
def draft(run_id: str, prepared: SimpleNamespace, tmp_path: Path) -> Path:
    """That draft, for one test alone."""
    (path := tmp_path / "cal.json").write_bytes(prepared.draft)
    return path


@pytest.fixture
def trusting(lab: tuple[Signer, ...], tmp_path: Path) -> None:
    """Ada and Bob in this lab's trust list."""
    (tmp_path / "signers").write_text("".join(f"{signer.line()}\n" for signer in lab))
    session.trust_keys(tmp_path / "signers")


def edited(path: Path, edit: Edit) -> None:
    stated = json.loads(path.read_bytes())
    edit(stated)
    path.write_bytes(rfc8785.dumps(stated))


def signed_by_two_elsewhere(path: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey) -> None:
    """As any OpenSSH signs it, which works nothing out."""
    lab = keys.trusted(home())
    signing.sign(path, "ada", key, lab)
    signing.sign(path, "bob", other_key, lab)


def better_numbers(c: dict[str, Any]) -> None:
    c["K"] = [[v * 1.05 for v in row] for row in c["K"]]
    c["covariance"] = [[v / 1e6 for v in row] for row in c["covariance"]]


def another_device(c: dict[str, Any]) -> None:
    c["simulated"] = False
    c["dut"]["serial"] = "FLIGHT-001"


FORGERIES: list[tuple[Edit, str]] = [
    (better_numbers, "K[0][0]"),
    (another_device, "simulated"),
    (lambda c: c["dut"].update(serial="FLIGHT-001"), "dut.serial"),
    (lambda c: c["k_nT"].__setitem__(2, c["k_nT"][2] + 0.02 * c["covariance"][11][11] ** 0.5), "k_nT[2]"),
    (lambda c: c.update(covariance=[[v / 4 for v in row] for row in c["covariance"]]), "covariance[0][0]"),
    (lambda c: c["validity"].update(field_nT=[0.0, 1e6]), "validity.field_nT[0]"),
    (lambda c: c.update(operator="somebody else"), "operator"),
    (lambda c: c.update(not_covered=[]), "not_covered"),
    (lambda c: c["metrics"]["after"].update(noise_nT=0.1), "metrics.after.noise_nT"),
    (lambda c: c["made_by"].update(method="centered"), "made_by"),
    (lambda c: c["made_by"].update(empirical=True), "made_by.empirical"),
    (lambda c: c["made_by"].update(command="by hand"), "made_by"),
    (lambda c: c.update(run_sha256="ab" * 32), "run_sha256"),
    (lambda c: (better_numbers(c), c["made_by"].update(version="0.0.9")), "K[0][0]"),
    (lambda c: (better_numbers(c), c.update(made_by=None)), "K[0][0]"),
    (lambda c: (another_device(c), c.update(made_by=None)), "simulated"),
]


@pytest.mark.parametrize(("edit", "field"), FORGERIES)
def test_an_edited_draft_is_neither_approved_nor_signed(draft: Path, edit: Edit, field: str):
    session.new_key("ada", "correct horse")
    session.new_key("bob", "correct horse")
    edited(draft, edit)
    before = draft.read_bytes()
    for step in (lambda: session.approve(draft, "bob"), lambda: session.sign(draft, "ada", "correct horse")):
        with pytest.raises(InputError) as refused:
            step()
        assert f"({field}" in str(refused.value) or f"; {field}" in str(refused.value)
    assert draft.read_bytes() == before
    assert not signing.signature_files(draft)


@pytest.mark.usefixtures("trusting")
@pytest.mark.parametrize(("edit", "field"), [*FORGERIES[:5], FORGERIES[-1]])
def test_signed_elsewhere_it_is_not_valid_and_the_field_is_named(
    draft: Path, run_id: str, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, edit: Edit, field: str
):
    edited(draft, edit)
    signed_by_two_elsewhere(draft, key, other_key)
    for named in (None, run_id):
        result = session.verify(draft, run=named)
        assert result.status == "invalid"
        assert result.recomputed is not None
        assert field in "; ".join(result.recomputed.why)
        assert "It was made from the run that was named." not in result.sentences()


@pytest.mark.usefixtures("trusting")
def test_two_sign_what_the_run_gives_and_scripts_may_require_it(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, tmp_path: Path
):
    session.approve(draft, "bob")
    signing.sign(draft, "ada", key)
    assert execute(["verify", str(draft), "--json", str(tmp_path / "one.json")]) == 0
    assert execute(["verify", str(draft), "--require", "released"]) == 1
    signing.sign(draft, "bob", other_key)
    assert execute(["verify", str(draft), "--require", "released", "--json", str(tmp_path / "two.json")]) == 0
    one, two = (json.loads((tmp_path / name).read_text()) for name in ("one.json", "two.json"))
    assert (one["status"], one["recomputed"], one["why"]) == (
        "provisional",
        True,
        ["named as approver, but has not signed: bob"],
    )
    assert [(s["signer"], s["by"]) for s in two.pop("signatures")] == [("ada", "claimed"), ("bob", "claimed")]
    assert two == {"valid": True, "status": "released", "signers": ["ada", "bob"], "recomputed": True, "why": [],
                   "as_stated": []}  # fmt: skip


@pytest.mark.usefixtures("trusting")
def test_without_the_run_it_is_provisional_at_most(
    prepared: SimpleNamespace,
    draft: Path,
    key: Ed25519PrivateKey,
    other_key: Ed25519PrivateKey,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
):
    session.approve(draft, "bob")
    signed_by_two_elsewhere(draft, key, other_key)
    assert session.verify(draft).status == "released"
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "another lab"))
    elsewhere = session.verify(draft, tmp_path / "signers")
    assert (elsewhere.status, elsewhere.recomputed and elsewhere.recomputed.same) == ("provisional", None)
    assert "is not in this store" in " ".join(elsewhere.sentences())
    assert session.verify(draft, tmp_path / "signers", prepared.bundle).status == "released"


def test_what_was_worked_out_is_kept_by_what_it_came_from(draft: Path, monkeypatch: pytest.MonkeyPatch):
    stated = read_calibration(draft)
    assert working_out.recomputed(stated, only_kept=True).same is None
    steps: list[str] = []
    assert working_out.recomputed(stated, progress=steps.append).same
    assert steps == ["working the calibration out again: fitting by ml"]
    assert working_out.recomputed(stated, progress=steps.append, only_kept=True).same
    assert len(steps) == 1
    (kept,) = (home() / working_out.FOLDER).iterdir()
    kept.write_bytes(b"{}")
    assert working_out.recomputed(stated, progress=steps.append).same
    assert len(steps) == 2
    monkeypatch.setattr(working_out, "__version__", "9.9.9")
    assert working_out.recomputed(stated, only_kept=True).same  # by the very version that made it


@pytest.mark.usefixtures("trusting")
def test_a_run_that_does_not_fit_its_chain_makes_it_not_valid_though_its_numbers_are_kept(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    session.approve(draft, "bob")
    signed_by_two_elsewhere(draft, key, other_key)
    assert session.verify(draft).status == "released"
    with closing(sqlite3.connect(home() / "store.sqlite")) as store, store:
        (guard,) = store.execute("SELECT sql FROM sqlite_master WHERE name = 'bundle_update'").fetchone()
        store.execute("DROP TRIGGER bundle_update")
        store.execute("UPDATE bundle SET samples_csv = samples_csv || x'0a'")
        store.execute(guard)
    result = session.verify(draft)
    assert result.status == "invalid"
    assert "chain: run" in " ".join(result.sentences())
    assert not working_out.recomputed(read_calibration(draft)).holds


@pytest.mark.usefixtures("trusting")
def test_where_another_version_differs_the_signature_stands(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, monkeypatch: pytest.MonkeyPatch
):
    def moved(by_u: float) -> None:
        u = np.sqrt(np.diag(made.covariance)) if made.covariance is not None else np.zeros(12)
        affine = replace(made.affine, k_nT=made.affine.k_nT + by_u * u[9:12])
        draft.write_bytes(calibration_bytes(replace(made, affine=affine)))

    session.new_key("eve", "correct horse")
    made = read_calibration(draft)
    monkeypatch.setattr(working_out, "__version__", "9.9.9")
    moved(0.02)  # a draft that nobody has approved can be made again
    with pytest.raises(InputError, match=r"\(k_nT\[0\]: .* is stated, its run gives"):
        session.approve(draft, "bob")
    moved(0.009)
    session.approve(draft, "bob")
    made = read_calibration(draft)
    moved(0.19 - 0.009)
    assert working_out.recomputed(read_calibration(draft)).same
    moved(0.21 - 0.009)
    with pytest.raises(InputError, match=r"\(k_nT\[0\]: .* is stated, its run gives"):
        session.sign(draft, "eve", "correct horse")
    signed_by_two_elsewhere(draft, key, other_key)
    result = session.verify(draft)
    assert result.valid
    assert (result.status, result.recomputed and result.recomputed.same) == ("provisional", False)
    assert "The signature stands." in " ".join(result.sentences())


def test_an_effect_of_a_package_that_is_not_there_is_named(draft: Path):
    edited(draft, lambda c: c["made_by"].update(version=f"{c['made_by']['version']} core 1.0", command="close-loop"))
    edited(draft, lambda c: c["findings"].append(STRANGE))
    found = working_out.recomputed(read_calibration(draft))
    assert found.same is None
    assert found.why == ("findings[0]: no installed package describes the effect 'core'",)


STRANGE = {
    "effect": "core", "channels": [], "reference_value": {}, "belongs_to": "rig", "provisional": False,
    "parameters": [], "holdout_rms_before_nT": None, "holdout_rms_after_nT": None, "improvement_ci95_nT": None,
    "p_value": None, "rivals": [], "why": "",
}  # fmt: skip


def test_the_loop_s_calibration_comes_again_whole_and_by_its_final_fit(
    run_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    path = tmp_path / "loop.json"
    closed = session.close_loop(run_id, path)
    stated = read_calibration(path)
    assert [cause.effect for cause in closed.accepted] == ["offset-current"]
    assert working_out.recomputed(stated, only_kept=True).same
    for kept in (home() / working_out.FOLDER).iterdir():
        kept.unlink()
    assert working_out.recomputed(stated).same
    edited(path, lambda c: c["effects"][0]["parameters"][0].update(value=501.0))
    found = working_out.recomputed(read_calibration(path))
    assert not found.holds
    assert found.why[0].startswith("effects[0].parameters[0].value: 501 is stated")
    for kept in (home() / working_out.FOLDER).iterdir():
        kept.unlink()
    monkeypatch.setattr(working_out, "__version__", "9.9.9")
    assert working_out.recomputed(stated, only_kept=True).same is None
    assert working_out.recomputed(stated).same
    assert working_out.recomputed(stated, only_kept=True).same
    with monkeypatch.context() as patch:
        patch.setattr(working_out, "sources", lambda: "another day")  # of the same version
        assert working_out.recomputed(stated, only_kept=True).same is None
    assert not working_out.recomputed(read_calibration(path)).same
    path.write_bytes(calibration_bytes(stated))
    edited(path, lambda c: c["effects"][0]["domain"][0]["hull"][1].__setitem__(0, 50.0))
    assert working_out.recomputed(read_calibration(path)).why[0].startswith("effects[0].domain[0].hull[1][0]: 50 is")
    for name in ("holdout_rms_nT", "noise_beside_readings_nT"):  # `apply` takes part of its u_nT from both
        path.write_bytes(calibration_bytes(stated))
        edited(path, lambda c, name=name: c["metrics"]["after"].update({name: 0.01}))
        assert working_out.recomputed(read_calibration(path)).why[0].startswith(f"metrics.after.{name}: 0.01 is stated")


def test_what_was_decided_by_other_judgements_is_another_versions(
    run_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """Said in the remarks and the file, and not compared with what is kept of the usual ones."""
    path = tmp_path / "loop.json"
    with monkeypatch.context() as here:
        here.setattr(policy, "POLICY", policy.Policy(min_evidence=20.0))
        closed = session.close_loop(run_id, path)
        stated = read_calibration(path)
        assert working_out.recomputed(stated, only_kept=True).same
    assert "Decided by other judgements than labcal's own: min_evidence 20 (12)." in closed.remarks
    assert stated.made_by
    assert stated.made_by["version"] == f"{working_out.__version__} min_evidence 20.0"
    shutil.rmtree(home() / working_out.FOLDER)
    found = working_out.recomputed(stated)
    assert found.same
    assert "effects[0].why" in found.as_stated


def test_structure_that_is_left_comes_again_between_versions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """What held-out residuals keep is most of its U, and no final fit alone shows it."""
    made, wander = made_up_run(rows=60, fields_nT=((30e3, 20e3, 25e3),), noise_nT=5.0), np.zeros((180, 3))
    steps = np.random.default_rng(3).normal(0, 30, wander.shape)
    for i in range(1, len(wander)):
        wander[i] = 0.9 * wander[i - 1] + steps[i]
    write_bundle(made.with_effect(wander), tmp_path / "wanders")
    run, path = session.import_bundle(tmp_path / "wanders"), tmp_path / "loop.json"
    assert session.close_loop(run, path).verdict == "unexplained"
    stated = read_calibration(path)
    assert any(row["source"].startswith("structure") for one in stated.budget for row in one["rows"])
    shutil.rmtree(home() / working_out.FOLDER)
    monkeypatch.setattr(working_out, "__version__", "9.9.9")
    assert working_out.recomputed(stated).same
    edited(path, lambda c: c["metrics"]["after"].update(holdout_rms_nT=5.0, holdout_beside_declared_nT=5.0))
    found = working_out.recomputed(read_calibration(path))
    assert found.holds
    assert "metrics.after.holdout_" in "; ".join(found.why)


def test_a_corrected_serial_keeps_what_was_worked_out(draft: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(working_out, "of_its_record", lambda stated, bundle: OfRecord())  # the run is imported
    stated = read_calibration(draft)
    corrected = replace(stated, dut=replace(stated.dut, serial="S2"), run_sha256="ab" * 32)
    working_out.keep_corrected(stated, corrected)
    assert working_out.recomputed(corrected, only_kept=True).same is None
    assert working_out.recomputed(stated).same
    working_out.keep_corrected(stated, corrected)
    assert working_out.recomputed(corrected, only_kept=True).same


@pytest.mark.usefixtures("trusting")
@pytest.mark.parametrize(
    ("operator", "approvers", "said"),
    [
        ("\N{CYRILLIC SMALL LETTER A}da", ["ada"], "approvers[0]: ada and"),
        ("test", ["eve"], "approvers[0]: eve is nobody of the trust list"),
        ("test", ["bob", "B.ob@lab"], "approvers[1]: B.ob@lab and bob"),
    ],
)
def test_nobody_signs_where_one_person_stands_for_two(draft: Path, operator: str, approvers: list[str], said: str):
    session.new_key("eva", "correct horse")
    edited(draft, lambda c: c.update(operator=operator, approvers=approvers))
    with pytest.raises(InputError) as refused:
        session.sign(draft, "eva", "correct horse")
    assert said in str(refused.value)
    assert not signing.signature_files(draft)


@pytest.mark.usefixtures("trusting")
def test_only_somebody_of_the_trust_list_approves_and_nobody_where_no_operator_is_stated(draft: Path):
    with pytest.raises(InputError, match="eve is nobody of the trust list"):
        session.approve(draft, "eve")
    session.approve(draft, "bob")
    edited(draft, lambda c: c.update(operator=" ", approvers=[]))
    with pytest.raises(InputError, match="operator: nobody is said to have measured it"):
        session.approve(draft, "bob")


@pytest.mark.parametrize(
    "effect",
    [
        {"effect": "offset-current", "channels": ["i_load"], "reference_value": {}},
        {"effect": "offset-current", "channels": ["gone"], "reference_value": {"gone": 0.0}},
        {"effect": "nonlinearity", "parameters": [{"name": "c_", "value": 1.0, "u": 0.0, "unit": ""}]},
        {"effect": "cross-field", "parameters": [{"name": "xy", "value": 1e300, "u": 0.0, "unit": ""}] * 2},
    ],
)
def test_an_effect_that_is_not_whole_is_a_sentence(draft: Path, effect: dict[str, Any]):
    edited(draft, lambda c: c.update(made_by=None, effects=[STRANGE | {"belongs_to": "sensor"} | effect]))
    found = working_out.recomputed(read_calibration(draft))
    assert found.same is False
    assert found.why[0].startswith("effects")
