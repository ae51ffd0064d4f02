"""What is secret is taken out of a text for others, and the text is still what it was otherwise."""

import json
import tomllib

import pytest

from labcal.files.confidential import without_secrets

CANARY = "c4nary in # the 'mine"


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ('password = "{0}" # of the lab', 'password = "***" # of the lab'),
        ("# archive: smtp_password: c4nary in the mine", "# archive: smtp_password: ***"),
        ("api-key=c4nary\nrange = 3", "api-key=***\nrange = 3"),
        ('link = "tcp://ada:{0}@127.0.0.1:5025"', None),
        ("no reply in 1.0 s from tcp://127.0.0.1:5025", "no reply in 1.0 s from tcp://127.0.0.1:5025"),
        ("the passphrase is wrong or the file is damaged", "the passphrase is wrong or the file is damaged"),
    ],
)
def test_what_is_called_a_password_is_starred(text: str, left: str | None) -> None:
    found = without_secrets(text.format("c4nary"))
    assert "c4nary" not in found
    assert left is None or found == left


def test_toml_and_json_stay_what_they_are() -> None:
    toml = without_secrets(f'name = "bench"\npassphrase = "{CANARY}"\nTOKEN = \'c4nary"\'\n')
    assert tomllib.loads(toml) == {"name": "bench", "passphrase": "***", "TOKEN": "***"}
    inner = json.dumps({"password": "c4nary", "n": 1})
    said = json.loads(without_secrets(json.dumps({"token": "c4nary", "details": f"sent {inner}", "n": 2})))
    assert said["n"] == 2
    assert said["token"] == "***"
    assert "c4nary" not in said["details"]


def test_what_this_process_was_given_in_confidence_goes_wherever_it_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PGPASSWORD", "c4nary")
    monkeypatch.setenv("LABCAL_SMTP_PASSWORD", "ab")
    assert without_secrets("it said c4nary about it") == "it said (PGPASSWORD) about it"
