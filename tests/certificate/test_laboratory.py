"""The laboratory that certificates state, as its file says it."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal.certificate.laboratory import read_laboratory
from labcal.errors import InputError
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory

LABORATORY = Administrative(Laboratory("A lab & co", "Bern", "CH"), Address("X", "Y", "DE"))


def test_a_laboratory_is_read_or_refused(tmp_path: Path):
    path = tmp_path / "laboratory.toml"
    with pytest.raises(InputError, match="names its laboratory"):
        read_laboratory(path)
    whole = 'name = "A lab & co"\ncity = "Bern"\ncountry = "CH"\n[customer]\nname = "X"\ncity = "Y"\ncountry = "DE"\n'
    path.write_text(whole)
    assert read_laboratory(path) == LABORATORY
    for broken in (whole.replace("CH", "Swiss"), whole.replace("city", "town"), "name = "):
        path.write_text(broken)
        with pytest.raises(InputError, match="expected"):
            read_laboratory(path)
