"""Who approved and signed which bytes is in the lab's audit log."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import pytest

from labcal import session
from labcal.errors import InputError

PASSPHRASE = "correct horse battery"


def test_approving_and_signing_are_in_the_audit_log_and_what_was_refused_is_not(draft: Path) -> None:
    for name in ("ada", "bob"):
        session.new_key(name, PASSPHRASE)
    approved = session.approve(draft, "bob")
    signature = session.sign(draft, "ada", PASSPHRASE)
    with pytest.raises(InputError):
        session.approve(draft, "ada")
    found = session.read_audit()
    assert (found.fault, approved.approvers) == ("", ("bob",))
    assert [(e.deed, e.who) for e in found.entries[-2:]] == [("approve", "bob"), ("sign", "ada")]
    one, two = (e.about for e in found.entries[-2:])
    digest = sha256(draft.read_bytes()).hexdigest()
    told = {"file": draft.name, "sha256": digest, "number": approved.number}
    assert one == told
    assert two == told | {"signature": sha256(signature.read_bytes()).hexdigest()}
