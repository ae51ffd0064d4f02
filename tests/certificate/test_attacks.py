"""Forgeries round about the numbers: each ends in a refusal that names its field, and none in a released file."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
import rfc8785
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import audit, session
from labcal.certificate import Signer, keys, read_calibration, register, signing, sshsig
from labcal.certificate.agent import public_half
from labcal.certificate.allowed_signers import own_line
from labcal.errors import InputError
from labcal.files.home import home
from labcal.record import RunHeader
from labcal.record.stream import Block, SegmentClosed, SegmentOpened
from labcal.store import Store, save_bundle, write_bundle
from labcal.testing.made_up_runs import made_up_run

Edit = Callable[[dict[str, Any]], object]
WORDS = "correct horse"
STRANGE = {
    "effect": "core", "channels": [], "reference_value": {}, "belongs_to": "rig", "provisional": False,
    "parameters": [], "holdout_rms_before_nT": None, "holdout_rms_after_nT": None, "improvement_ci95_nT": None,
    "p_value": None, "rivals": [], "why": "",
}  # fmt: skip


@pytest.fixture
def draft(tmp_path: Path) -> Path:
    """What `labcal fit` makes of a run of the store; Ada, Bob and Eve have keys."""
    write_bundle(made_up_run(rows=60, fields_nT=((30e3, 20e3, 25e3),), noise_nT=5.0).run, tmp_path / "run")
    run = session.import_bundle(tmp_path / "run")
    path = tmp_path / "cal.json"
    session.draft(run, session.fit_run(run)[1][0], path)
    for name in ("ada", "bob", "eve"):
        session.new_key(name, WORDS)
    return path


def edited(path: Path, *edits: Edit) -> None:
    stated = json.loads(path.read_bytes())
    for edit in edits:
        edit(stated)
    path.write_bytes(rfc8785.dumps(stated))


def refused(step: Callable[[], object], path: Path, field: str) -> None:
    before = path.read_bytes()
    with pytest.raises(InputError) as fault:
        step()
    assert field in str(fault.value)
    assert path.read_bytes() == before
    assert not signing.signature_files(path)


def another_version(c: dict[str, Any]) -> None:
    """As another version would have made it, which alone is compared less closely."""
    c["made_by"]["version"], c["software"] = "0.0.9", "labcal 0.0.9"


def flight_model(c: dict[str, Any]) -> None:
    c["simulated"] = False
    c["dut"]["serial"] = "FLIGHT-001"


PASSED: dict[str, Any] = {
    "quantity": "offset x", "value": 1.0, "U": 0.1, "limit": 5.0, "unit": "nT", "rule": "simple-acceptance",
    "result": "pass", "risk": 0.0, "tur": 9.0,
}  # fmt: skip


def smaller_everywhere(c: dict[str, Any]) -> None:
    """Every u of the file by a twentieth, as a version would write it: within a tenth of U."""
    c["covariance"] = [[0.95**2 * value for value in row] for row in c["covariance"]]
    for one in c["budget"]:
        one.update(U=0.95 * one["U"], rows=[row | {"u": 0.95 * row["u"]} for row in one["rows"]])


OF_ANOTHER_VERSION: list[tuple[Edit, str]] = [
    (lambda c: [one.update(U=one["U"] / 100) for one in c["budget"]], "(budget.b x"),
    (lambda c: c.update(not_covered=[]), "(not_covered: 0 is stated"),
    (lambda c: c.update(specification=[PASSED]), "(specification: 1 of them"),
    (lambda c: c["metrics"]["after"].update(rms_scalar_nT=0.01), "(metrics.after.rms_scalar_nT"),
    (lambda c: c["instruments"][0].update(serial="PTB-1"), "(instruments[0].serial"),
    (lambda c: c.update(k_at={"temp": 20.0}), "(k_at"),
    (lambda c: c["covariance"][0].__setitem__(9, 0.0) or c["covariance"][9].__setitem__(0, 0.0), "(covariance[0][9]"),
    (lambda c: c["findings"].append(STRANGE | {"effect": "axis-tilt"}), "findings"),
    (lambda c: c.update(software="labcal 9.9"), "(software"),
    (lambda c: c["K"][0].__setitem__(0, c["K"][0][0] + 0.1 * c["covariance"][0][0] ** 0.5), "(K[0][0]"),
    (smaller_everywhere, "(budget.b x"),
]


def test_what_another_version_may_differ_in_is_no_way_round_the_numbers(draft: Path):
    honest = draft.read_bytes()
    for edit, field in OF_ANOTHER_VERSION:
        draft.write_bytes(honest)
        edited(draft, another_version, edit)
        refused(lambda: session.approve(draft, "bob"), draft, field)
    draft.write_bytes(honest)
    edited(draft, another_version)
    session.approve(draft, "bob")


def test_what_cannot_be_worked_out_still_states_its_own_run(draft: Path, key: Ed25519PrivateKey, tmp_path: Path):
    """An effect, a method or a command that nobody has: the numbers stay open, whose they are does not."""
    (tmp_path / "signers").write_text(own_line("carol", public_half(key)).line())
    session.trust_keys(tmp_path / "signers")
    honest = draft.read_bytes()
    for edit in (
        lambda c: (c["made_by"].update(command="close-loop"), c["findings"].append(STRANGE)),
        lambda c: c["made_by"].update(method="of-another-package"),
        lambda c: c["made_by"].update(command="by hand"),
    ):
        draft.write_bytes(honest)
        edited(
            draft, another_version, edit, lambda c: (c["dut"].update(serial="FLIGHT-001"), c.update(simulated=False))
        )
        refused(lambda: session.approve(draft, "bob"), draft, 'dut.serial: "FLIGHT-001" is stated')
        refused(lambda: session.sign(draft, "ada", WORDS), draft, "simulated: false is stated")
        signing.sign(draft, "carol", key)
        found = session.verify(draft)
        assert found.status == "invalid"
        assert "simulated: false" in "; ".join(found.sentences())
        signing.signature_files(draft)[0].unlink()


def test_what_people_state_is_what_somebody_stated(draft: Path):
    honest = draft.read_bytes()
    for edit, field in (
        (lambda c: c["validity"].update(until="2020-01-01"), "validity.until: 2020-01-01 is past"),
        (lambda c: c.update(supersedes="all of them"), "supersedes: "),
        (lambda c: c.update(number="SIM-OTHER-2026-0001"), "number: SIM-OTHER-2026-0001 is stated, and a draft"),
        (lambda c: c.update(approvers=["bob"]), "number: none is stated, and an approval gives one"),
    ):
        draft.write_bytes(honest)
        edited(draft, edit)
        refused(lambda: session.sign(draft, "ada", WORDS), draft, field)
        refused(lambda: session.approve(draft, "eve"), draft, field.partition(":")[0])


def test_what_was_approved_is_what_is_signed(draft: Path):
    session.approve(draft, "bob")
    approved = draft.read_bytes()
    for edit, field in (
        (lambda c: c.update(issued_utc="2019-01-01T00:00:00Z"), "issued_utc: is not as bob approved it"),
        (lambda c: c.update(issued_utc="2139-01-01T00:00:00Z"), "issued_utc: 2139-01-01T00:00:00Z is later than"),
        (lambda c: c.update(issued_utc="yesterday"), "issued_utc: 'yesterday' is no time of a known zone"),
        (lambda c: c["validity"].update(until="2099-01-01"), "validity.until: is not as bob approved it"),
        (lambda c: c.update(supersedes="ab" * 32), "supersedes: is not as bob approved it"),
        (lambda c: c.update(approvers=["eve"]), "approvers: is not as bob approved it"),
        (lambda c: c.update(number="PTB 1"), "number: 'PTB 1' is no LAB-BENCH-YEAR-NNNN"),
        (lambda c: c.update(number="PTB-CAGE-2026-0001"), "number: PTB-CAGE-2026-0001 is stated, and bob approved it"),
        (lambda c: c.update(number=None), "number: none is stated"),
    ):
        draft.write_bytes(approved)
        edited(draft, edit)
        refused(lambda: session.sign(draft, "ada", WORDS), draft, field)
    draft.write_bytes(approved)
    session.approve(draft, "eve")  # whose approval changes approvers and date
    session.sign(draft, "ada", WORDS)


def test_a_number_that_was_void_or_given_out_is_known_beside_the_register(draft: Path, tmp_path: Path):
    calibration = session.approve(draft, "bob")
    assert calibration.number
    session.void_number(calibration.number, "thrown away")
    with closing(sqlite3.connect(home() / register.FILE)) as file, file:
        file.execute("UPDATE certificate SET state = 'taken', reason = ''")
    refused(lambda: session.sign(draft, "ada", WORDS), draft, f"{calibration.number} is void, as the audit log says")
    (home() / register.FILE).unlink()
    again = tmp_path / "again.json"
    run = calibration.run_id
    session.draft(run, session.fit_run(run)[1][0], again)
    refused(lambda: session.approve(again, "bob"), again, f"{calibration.number} was given out before")


def without_guards(statements: list[str]) -> None:
    with closing(sqlite3.connect(home() / "store.sqlite", isolation_level=None)) as store:
        guards = store.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
        for name, _ in guards:
            store.execute(f"DROP TRIGGER {name}")
        for statement in statements:
            store.execute(statement)
        for _, sql in guards:
            store.execute(sql)


@pytest.mark.usefixtures("trusting")
def test_without_its_run_it_is_provisional_though_its_numbers_were_kept(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    session.approve(draft, "eve")
    for name, of in (("ada", key), ("eve", other_key)):
        signing.sign(draft, name, of)
    assert session.verify(draft).status == "released"
    without_guards([f"DELETE FROM {table}" for table in ("chain", "status", "bundle", "origin", "run")])
    found = session.verify(draft)
    assert found.status == "provisional"
    assert f"its run {read_calibration(draft).run_id} is not in this store" in " ".join(found.sentences())


def test_a_store_that_cannot_be_asked_is_no_way_round_it(draft: Path):
    with closing(sqlite3.connect(home() / "store.sqlite")) as store:
        store.execute("DROP TRIGGER bundle_update")
    edited(draft, lambda c: c["k_nT"].__setitem__(0, 1e3))
    for step in (lambda: session.approve(draft, "bob"), lambda: session.sign(draft, "ada", WORDS)):
        refused(step, draft, "another program has changed this store")


@pytest.mark.usefixtures("trusting")
@pytest.mark.parametrize(
    ("edit", "field"),
    [
        (lambda c: c.update(chain={"head": "ab" * 32, "rows": 5}), "chain: "),
        (lambda c: c.update(cage_sha256="ab" * 32), "cage_sha256: "),
    ],
)
def test_a_head_or_a_cage_that_the_record_does_not_show_is_provisional(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, edit: Edit, field: str
):
    edited(draft, edit)
    session.approve(draft, "eve")
    for name, of in (("ada", key), ("eve", other_key)):
        signing.sign(draft, name, of)
    found = session.verify(draft)
    assert found.status == "provisional"
    assert found.recomputed is not None
    assert found.recomputed.why[0].startswith(field)


NEW_OF_2 = (
    "budget",
    "chain",
    "covariance_of",
    "issued_utc",
    "k_at",
    "made_by",
    "not_covered",
    "number",
    "specification",
)


@pytest.mark.usefixtures("trusting")
def test_a_file_of_the_first_version_is_provisional_whoever_signs_it(
    draft: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey
):
    """It has no place for what is left out: budget, number, the chain of its record, what is not covered."""
    edited(draft, lambda c: [c.pop(name) for name in NEW_OF_2], lambda c: c.update(format="labcal-calibration/1"))
    session.approve(draft, "eve")
    for name, of in (("ada", key), ("eve", other_key)):
        signing.sign(draft, name, of)
    found = session.verify(draft)
    assert found.recomputed is not None
    assert found.recomputed.same
    assert found.status == "provisional"
    assert "labcal-calibration/1 has no place for" in " ".join(found.limits())


@pytest.fixture
def trusting(lab: tuple[Signer, ...], draft: Path, tmp_path: Path) -> None:
    """Ada's and Eve's keys are `key` and `other_key`."""
    keys.trust_list(home()).unlink()
    lines = [f"{lab[0].line()}\n", f"{lab[1].line().replace('bob', 'eve', 1)}\n"]
    (tmp_path / "signers").write_text("".join(lines))
    session.trust_keys(tmp_path / "signers")


@pytest.fixture
def released(tmp_path: Path) -> Path:
    """A calibration of a run that this lab recorded on its bench `cage`, with its number, signed by two."""
    path = recorded(tmp_path / "released.json")
    session.approve(path, "bob")
    for name in ("bob", "ada"):
        session.sign(path, name, WORDS)
    return path


def recorded(path: Path, began: str = "", *, operator: str = "Grace", simulated: bool = True) -> Path:
    """A draft of a run that this lab recorded on its bench `cage`; Ada and Bob have keys."""
    made = made_up_run(rows=60, fields_nT=((30e3, 20e3, 25e3),), noise_nT=5.0).run
    began, bench = began or made.started_utc, 'name = "cage"'
    header = RunHeader("r-cage", began, simulated, operator, made.dut, made.reference, bench=bench)
    with Store.open() as store, store.begin(header) as writer:
        for number, segment in enumerate(made.segments):
            rows = made.segment_index == number
            t = made.t_s[rows]
            writer.write(SegmentOpened(t[0], segment))
            for stream, names, values in (
                ("dut", ("dut_x", "dut_y", "dut_z"), made.reading[rows]),
                ("reference", ("ref_x", "ref_y", "ref_z"), made.reference_vector[rows]),
                ("platform", ("angle_deg",), made.angle_deg[rows, None]),
            ):
                writer.write(Block(stream, stream, names, t, values, b""))
            writer.write(SegmentClosed(t[-1]))
    session.draft("r-cage", session.fit_run("r-cage")[1][0], path)
    for name in ("ada", "bob"):
        session.new_key(name, WORDS)
    return path


def signed_elsewhere(path: Path) -> None:
    """By both keys, past every check of `labcal sign`."""
    for name, file in (("bob", f"{path}.sshsig"), ("ada", f"{path}.2.sshsig")):
        Path(file).write_text(sshsig.sign(path.read_bytes(), keys.open_key(home(), name, WORDS)))


@pytest.mark.parametrize(
    ("edit", "says"),
    [
        (lambda c: c.update(number="SIM-CAGE-2026-0009"), "number: SIM-CAGE-2026-0009 was never given out"),
        (lambda c: c.update(number="PTB 1"), "number: 'PTB 1' is no LAB-BENCH-YEAR-NNNN"),
        (lambda c: c.update(issued_utc="2019-01-01T00:00:00Z"), "issued_utc: 2019-01-01T00:00:00Z is before"),
    ],
)
def test_number_and_date_of_issue_are_those_of_the_register(released: Path, edit: Edit, says: str):
    assert session.verify(released).status == "released"
    edited(released, edit)
    signed_elsewhere(released)
    found = session.verify(released)
    assert found.status == "invalid"
    assert says in " ".join(found.against())


def test_a_register_that_was_lost_speaks_against_no_certificate(released: Path):
    (home() / register.FILE).unlink()
    assert session.verify(released).status == "released"
    register.take(home(), "SIM", "cage", "another", "cal.json", "2027-01-01T00:00:00Z")
    assert session.verify(released).status == "released"


def test_a_date_of_issue_that_is_no_time_is_refused(released: Path):
    edited(released, lambda c: c.update(issued_utc="2026-11-24T00:06:21Zx"))
    signed_elsewhere(released)
    with pytest.raises(InputError, match=r"issued_utc: .*is no time of a known zone"):
        session.verify(released)


def test_one_that_is_issued_in_the_future_is_provisional(released: Path):
    edited(released, lambda c: c.update(issued_utc="2139-01-01T00:00:00Z"))
    signed_elsewhere(released)
    found = session.verify(released)
    assert found.status == "provisional"
    assert "issued_utc is later than this computer's clock" in " ".join(found.sentences())


def test_one_that_was_approved_past_the_register_is_provisional(released: Path):
    edited(released, lambda c: c.update(number=None))
    signed_elsewhere(released)
    found = session.verify(released)
    assert found.status == "provisional"
    assert "no number and date of issue, which an approval gives" in " ".join(found.sentences())


def test_one_that_nobody_measured_is_provisional_whoever_signs_it(tmp_path: Path):
    path = recorded(tmp_path / "cal.json", operator="")
    edited(path, lambda c: c.update(approvers=["bob"], number="SIM-CAGE-2026-0001", issued_utc="2026-11-21T12:00:00Z"))
    signed_elsewhere(path)
    found = session.verify(path)
    assert found.status == "provisional"
    assert "nobody is said to have measured it" in " ".join(found.sentences())


def test_a_clock_before_its_run_began_issues_nothing(tmp_path: Path):
    path = recorded(tmp_path / "cal.json", "2139-01-01T00:00:00Z", simulated=False)
    for step in (lambda: session.approve(path, "bob"), lambda: session.sign(path, "ada", WORDS)):
        refused(step, path, "is before its run began, 2139-01-01T00:00:00Z")


def test_a_bundle_of_a_run_that_was_recorded_here_has_what_the_audit_log_took_down(released: Path, tmp_path: Path):
    with Store.open() as store:
        save_bundle(store.bundle("r-cage", with_chain=True), tmp_path / "run.zip")
    assert session.verify(released, run=tmp_path / "run.zip").status == "released"
    audit.append(home(), "run", "Grace", {"run": "r-cage", "chain": "ab" * 32})
    found = session.verify(released, run=tmp_path / "run.zip")
    assert found.status == "provisional"
    assert "the audit log says that r-cage was recorded here" in " ".join(found.sentences())


def test_the_cage_of_an_imported_run_is_the_one_that_its_chain_names(tmp_path: Path):
    draft = recorded(tmp_path / "cal.json")
    with Store.open() as store:
        save_bundle(store.bundle("r-cage", with_chain=True), tmp_path / "run.zip")
    (home() / "store.sqlite").rename(tmp_path / "away.sqlite")
    session.import_bundle(tmp_path / "run.zip")
    edited(draft, lambda c: c.update(cage_sha256="ab" * 32))
    refused(
        lambda: session.approve(draft, "bob"), draft, "cage_sha256: abababababab… is stated, its run was driven by none"
    )
