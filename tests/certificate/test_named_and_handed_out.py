"""Whom a certificate names where its run does not say it, and the one folder that goes to the customer."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal import session
from labcal.certificate.laboratory import FILE, customer_beside, read_laboratory
from labcal.errors import InputError
from labcal.record.administrative import Address, Laboratory
from labcal.session.handing_out import hand_out_whole
from labcal.session.naming import name_on, named_on

LAB, CUSTOMER = Laboratory('A "lab" & Söhne', "Bern", "CH"), Address("Holm AS", "Oslo", "NO")
MENDED = Address("Holm A/S", "Oslo", "NO")
WORDS = "four plain words here"


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (home := tmp_path / "home").mkdir()
    monkeypatch.setenv("LABCAL_HOME", str(home))
    return home


def test_nobody_is_named_before_somebody_says_it_and_the_laboratory_is_remembered(home: Path, real_draft: Path):
    assert (named_on(real_draft).laboratory, named_on(real_draft).customer) == (None, None)
    said = name_on(real_draft, LAB, CUSTOMER)
    assert (said.laboratory, said.customer) == (LAB, CUSTOMER)
    assert read_laboratory(home / FILE).laboratory == LAB
    assert read_laboratory(home / FILE).customer is None  # of this certificate alone


def test_what_is_stated_is_not_stated_again(home: Path, real_draft: Path):
    name_on(real_draft, LAB, CUSTOMER)
    with pytest.raises(InputError, match="laboratory is stated already"):
        name_on(real_draft, LAB, None)
    assert name_on(real_draft, None, MENDED).customer == MENDED  # a slip, before it is signed
    session.new_key("jdoe@lab", WORDS)
    session.sign(real_draft, "jdoe@lab", WORDS)
    with pytest.raises(InputError, match="customer is stated already"):
        name_on(real_draft, None, CUSTOMER)
    assert customer_beside(real_draft) == MENDED


def test_one_folder_has_the_certificate_too_and_says_what_each_file_is(home: Path, real_draft: Path, tmp_path: Path):
    name_on(real_draft, LAB, CUSTOMER)
    session.new_key("jdoe@lab", WORDS)
    session.sign(real_draft, "jdoe@lab", WORDS)
    hand_out_whole(real_draft, tmp_path / "out", "EM-07-r1")
    there = sorted(one.name for one in (tmp_path / "out").iterdir())
    files = ["EM-07-r1-contents.txt", "EM-07-r1.json", "EM-07-r1.json.sshsig", "EM-07-r1.pdf", "allowed_signers"]
    assert there == files
    said = (tmp_path / "out" / "EM-07-r1-contents.txt").read_text(encoding="utf-8")
    assert all(any(line.startswith(f"{name}  ") for line in said.splitlines()) for name in files)
    hand_out_whole(real_draft, tmp_path / "out", "EM-07-r1")  # once more, over its own


def test_the_certificate_names_whom_the_file_beside_it_names(home: Path, real_draft: Path, tmp_path: Path):
    name_on(real_draft, LAB, CUSTOMER)
    session.report(str(real_draft), tmp_path / "out.html")
    page = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert "Holm AS, Oslo (NO)" in page
