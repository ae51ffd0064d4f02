from __future__ import annotations

import os
from pathlib import Path

import pytest

from labcal.files.home import home, secrets_aside


def test_home_is_where_the_environment_says(home_of_its_own: Path):
    assert home() == home_of_its_own


@pytest.mark.parametrize("unset", ["", None])
def test_without_it_home_is_the_user_s_data_folder(monkeypatch: pytest.MonkeyPatch, unset: str | None):
    monkeypatch.setenv("LABCAL_HOME", unset) if unset is not None else monkeypatch.delenv("LABCAL_HOME")
    assert home().is_absolute()
    assert home().name == "labcal"


def broken() -> None:
    with secrets_aside():
        assert "PGPASSWORD" not in os.environ
        raise RuntimeError


def test_secrets_are_put_aside_and_back_whatever_happens(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PGPASSWORD", "c4nary")
    with pytest.raises(RuntimeError):
        broken()
    assert os.environ["PGPASSWORD"] == "c4nary"
