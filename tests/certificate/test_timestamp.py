"""A time that is shown: a token of a time-stamping authority beside the signature, made here by `openssl ts`."""

from __future__ import annotations

import json
import re
import shutil
import sqlite3
import subprocess
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime, timedelta
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Event, Thread

import pytest

from labcal import session
from labcal.certificate.timestamp import shown_utc
from labcal.cli import execute
from labcal.files.home import home

PASSPHRASE = "correct horse"
CONFIG = """
[req]
distinguished_name = dn
[dn]
[tsa_cert]
basicConstraints = critical,CA:FALSE
keyUsage = critical,digitalSignature
extendedKeyUsage = critical,timeStamping
[tsa]
default_tsa = here
[here]
serial = {folder}/serial
signer_cert = {folder}/ca.pem
certs = {folder}/ca.pem
signer_key = {folder}/ca.key
signer_digest = sha256
default_policy = 1.2.3.4.1
digests = sha256, sha512
accuracy = secs:1
"""


def authority(folder: Path) -> Path:
    """A time-stamping authority of its own in `folder`."""
    openssl = shutil.which("openssl") or pytest.skip("needs openssl, which is not installed")
    folder.mkdir()
    (folder / "ts.cnf").write_text(CONFIG.format(folder=folder))
    (folder / "serial").write_text("01\n")
    new = [
        "req",
        "-x509",
        "-newkey",
        "rsa:2048",
        "-nodes",
        "-subj",
        "/CN=time",
        "-days",
        "30",
        "-extensions",
        "tsa_cert",
    ]
    where = ["-config", str(folder / "ts.cnf"), "-keyout", str(folder / "ca.key"), "-out", str(folder / "ca.pem")]
    subprocess.run([openssl, *new, *where], check=True, capture_output=True)
    return folder


def stamp(signature: Path, by: Path, of: bytes | None = None) -> None:
    """A token for the signature file beside it, or for other bytes."""
    data = by / "data"
    data.write_bytes(signature.read_bytes() if of is None else of)
    query, reply = by / "query", signature.with_name(f"{signature.name}.tsr")
    ask = ["openssl", "ts", "-query", "-data", str(data), "-sha256", "-cert", "-out", str(query)]
    answer = ["openssl", "ts", "-reply", "-queryfile", str(query), "-config", str(by / "ts.cnf"), "-out", str(reply)]
    for command in (ask, answer):
        subprocess.run(command, check=True, capture_output=True)


def day(days: int) -> datetime:
    return datetime.now(UTC) + timedelta(days=days)


def token_utc(draft: Path) -> datetime | None:
    """The time that the token of the first signature shows, whatever the audit log does."""
    signature = draft.with_name(f"{draft.name}.sshsig")
    return shown_utc(signature, signature.read_bytes(), home() / "keys" / "timestamp_ca.pem")


def test_what_a_trusted_authority_stamped_before_outlives_its_key(draft: Path, tmp_path: Path):
    ours, theirs = authority(tmp_path / "ours"), authority(tmp_path / "theirs")
    session.new_key("ada", PASSPHRASE)
    signature = session.sign(draft, "ada", PASSPHRASE)
    session.revoke_keys("ada", day(1).replace(hour=0))  # as seen from the day after
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")

    def shown() -> datetime | None:
        return token_utc(draft)

    assert shown() is None
    stamp(signature, ours)
    seen = shown()
    assert seen is not None
    assert abs(seen - day(0)) < timedelta(minutes=30)
    for forge in (
        lambda: stamp(signature, theirs),  # an authority that nobody trusts
        lambda: stamp(signature, ours, b"another signature"),
        lambda: signature.with_name(f"{signature.name}.tsr").write_bytes(b"\x30\x03no"),
    ):
        forge()
        assert shown() is None


def der(tag: int, content: bytes) -> bytes:
    size = len(content)
    return bytes([tag]) + (bytes([size]) if size < 128 else b"\x82" + size.to_bytes(2, "big")) + content


def test_words_beside_a_token_are_no_time_of_it(draft: Path, tmp_path: Path):
    """The status of a reply is signed by nobody, and openssl prints its words before the token's own time."""
    ours = authority(tmp_path / "ours")
    session.new_key("ada", PASSPHRASE)
    signature = session.sign(draft, "ada", PASSPHRASE)
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    stamp(signature, ours)
    honest = token_utc(draft)
    reply = signature.with_name(f"{signature.name}.tsr")
    token = reply.with_name("token")
    out = ["openssl", "ts", "-reply", "-in", str(reply), "-token_out", "-out", str(token)]
    subprocess.run(out, check=True, capture_output=True)
    words = der(0x30, der(0x0C, b"x\nTime stamp: Jan  1 00:00:00 2020 GMT\n"))
    reply.write_bytes(der(0x30, der(0x30, der(0x02, b"\0") + words) + token.read_bytes()))
    assert honest is not None
    assert token_utc(draft) == honest


def test_the_shown_time_decides_and_not_the_clock(draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    ours = authority(tmp_path / "ours")
    session.new_key("ada", PASSPHRASE)
    signature = session.sign(draft, "ada", PASSPHRASE)
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    stamp(signature, ours)
    session.revoke_keys("ada", day(1))
    monkeypatch.setattr("labcal.session.signing.datetime", Later)
    found = session.verify(draft)
    assert found.valid
    told = found.signed_at(found.checks[0])  # by the log, unless the token was made in the same second
    assert told.endswith((" UTC, shown by the audit log", " UTC, shown by its time-stamp token"))
    (tmp_path / "given").mkdir()
    session.hand_out(draft, tmp_path / "given")
    assert (tmp_path / "given" / f"{signature.name}.tsr").exists()
    signature.with_name(f"{signature.name}.tsr").unlink()
    by_the_log = session.verify(draft)
    assert by_the_log.valid
    assert by_the_log.signed_at(by_the_log.checks[0]).endswith(" UTC, shown by the audit log")
    (home() / "audit.sqlite").rename(tmp_path / "gone")
    assert "is revoked from" in str(session.verify(draft).checks[0].objection)
    session.new_key("ada", PASSPHRASE)


def test_the_audit_log_shows_when_a_signature_was_made_unless_it_was_edited(
    draft: Path, capsys: pytest.CaptureFixture[str]
):
    session.new_key("ada", PASSPHRASE)
    session.sign(draft, "ada", PASSPHRASE)
    [noted] = [entry.utc for entry in session.read_audit().entries if entry.deed == "sign"]
    assert execute(["verify", str(draft), "--json", "-"]) == 0
    [said] = json.loads(capsys.readouterr().out)["signatures"]
    assert said == {
        "file": "cal.json.sshsig", "signer": "ada", "good": True, "utc": f"{noted[:19]}Z", "by": "audit log"
    }  # fmt: skip
    with closing(sqlite3.connect(home() / "audit.sqlite")) as log:
        [guard] = log.execute("SELECT sql FROM sqlite_master WHERE name = 'entry_update'").fetchone()
        log.execute("DROP TRIGGER entry_update")
        log.execute("UPDATE entry SET text = replace(text, ?, ?)", (noted, "2020-01-01T00:00:00.000Z"))
        log.execute(guard)
        log.commit()
    assert execute(["verify", str(draft)]) == 0
    assert re.search(r"; \d{4}-\d\d-\d\dT[\d:]{8}Z, claimed$", capsys.readouterr().out, re.MULTILINE)


def test_a_clock_that_was_put_back_shows_nothing_earlier_than_it_had_told(draft: Path, monkeypatch: pytest.MonkeyPatch):
    with monkeypatch.context() as patch:
        patch.setattr("labcal.audit.log.datetime", Later)
        session.new_key("ada", PASSPHRASE)
    session.sign(draft, "ada", PASSPHRASE)
    [check] = session.verify(draft).checks
    assert check.shown is not None
    assert check.shown.utc > day(1)


class Earlier(datetime):
    """A clock forty days and an hour behind."""

    @classmethod
    def now(cls, tz: object = None) -> datetime:
        """Forty days and an hour before now."""
        return day(-40) - timedelta(hours=1)


def test_what_shows_a_signature_later_than_its_date_says_no_more_than_that(
    draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    ours = authority(tmp_path / "ours")
    session.new_key("ada", PASSPHRASE)
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    monkeypatch.setattr("labcal.session.numbering.datetime", Earlier)  # an issue that is put back
    signature = session.sign(draft, "ada", PASSPHRASE)
    (home() / "audit.sqlite").unlink()
    stamp(signature, ours)
    assert execute(["verify", str(draft)]) == 0
    token = r"no later than \d{4}-\d\d-\d\d [\d:]{8} UTC, shown by its time-stamp token, 40 days after the file states"
    assert re.search(token, capsys.readouterr().out)


Reply = Callable[[bytes], bytes]


@contextmanager
def serving(reply: Reply) -> Iterator[str]:
    """An authority on this computer's own network that answers a query with `reply` of it; gives its address."""
    asked = []

    class Answers(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            asked.append(self.headers["Content-Type"])
            content = reply(self.rfile.read(int(self.headers["Content-Length"])))
            self.send_response(200)
            self.send_header("Content-Type", "application/timestamp-reply")
            self.send_header("Content-Length", str(len(content)))
            self.end_headers()
            self.wfile.write(content)

        def log_message(self, format: str, *args: object) -> None:
            """Nothing to stderr."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Answers)
    server.daemon_threads = True
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}/tsa"
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
    assert set(asked) <= {"application/timestamp-query"}


def replies(by: Path) -> Reply:
    """As `openssl ts -reply` of this authority answers."""

    def reply(query: bytes) -> bytes:
        (by / "asked").write_bytes(query)
        command = ["openssl", "ts", "-reply", "-queryfile", str(by / "asked"), "-config", str(by / "ts.cnf")]
        subprocess.run([*command, "-out", str(by / "answer")], check=True, capture_output=True)
        return (by / "answer").read_bytes()

    return reply


def laboratory_with(url: str) -> None:
    text = f'name = "Lab"\ncity = "Bern"\ncountry = "CH"\ntimestamp_url = "{url}"\n'
    (home() / "laboratory.toml").write_text(text)


def test_the_token_is_asked_for_as_it_is_signed_and_lies_beside_the_signature(
    draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    ours, said = authority(tmp_path / "ours"), list[str]()
    session.new_key("ada", PASSPHRASE)
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    with serving(replies(ours)) as url:
        laboratory_with(url)
        signature = session.sign(draft, "ada", PASSPHRASE, on_remark=said.append)
    shown = token_utc(draft)
    assert shown is not None
    assert abs(shown - day(0)) < timedelta(minutes=30)
    assert said == [f"{signature.name}: {url} shows it at {shown:%Y-%m-%d %H:%M:%S} UTC"]
    command = ["openssl", "ts", "-verify", "-data", str(signature), "-in", f"{signature}.tsr"]
    done = subprocess.run([*command, "-CAfile", str(ours / "ca.pem")], capture_output=True, text=True)
    assert "Verification: OK" in done.stdout + done.stderr


def test_whatever_comes_in_place_of_a_token_is_not_kept_and_the_signature_stands(
    draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("NO_PROXY", "127.0.0.1")
    ours, theirs = authority(tmp_path / "ours"), authority(tmp_path / "theirs")
    session.new_key("ada", PASSPHRASE)
    cases: list[tuple[Reply, str]] = [
        (lambda query: b"<html>sign in</html>", "is no token that the certificates in timestamp_ca.pem vouch for"),
        (lambda query: b"0" * 2**18, "answers more than 131072 bytes"),
        (replies(theirs), "is no token that the certificates in timestamp_ca.pem vouch for"),
    ]
    missing = "timestamp_ca.pem: the certificates of its authority are missing, by which a token is checked"
    assert missing in signed_again(draft, "http://127.0.0.1:9/none")
    shutil.copy(ours / "ca.pem", home() / "keys" / "timestamp_ca.pem")
    for reply, why in cases:
        with serving(reply) as url:
            told = signed_again(draft, url)
        assert re.search(why, told), told
        assert "its time is only claimed" in told
    waits = Event()
    monkeypatch.setattr("labcal.certificate.timestamp.ANSWERED_S", 0.5)
    with serving(lambda query: bytes(waits.wait(60))) as url:
        assert re.search("no answer within|timed out", signed_again(draft, url))
        waits.set()
    assert "refused" in signed_again(draft, "http://127.0.0.1:9/none").lower()  # nothing listens there
    assert "timestamp_url must be as http://HOST/PATH" in signed_again(draft, "file:///etc/passwd")


def signed_again(draft: Path, url: str) -> str:
    """What is said of the time where this address is to be asked; the signature holds, and no token is there."""
    said = list[str]()
    laboratory_with(url)
    draft.with_name(f"{draft.name}.sshsig").unlink(missing_ok=True)
    session.sign(draft, "ada", PASSPHRASE, on_remark=said.append)
    [check] = session.verify(draft).checks
    assert check.objection is None
    assert check.shown is None or check.shown.by == "audit log"
    assert not list(draft.parent.glob("*.tsr"))
    return " ".join(said)


class Later(datetime):
    """A clock two days on."""

    @classmethod
    def now(cls, tz: object = None) -> datetime:
        """Two days from now."""
        return day(2)
