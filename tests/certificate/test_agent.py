"""Keys that lie elsewhere: in an SSH agent, and in a FIDO security key."""

from __future__ import annotations

import base64
import hashlib
import os
import shutil
import socketserver
import struct
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal import session
from labcal.certificate import keys
from labcal.certificate.allowed_signers import read_allowed_signers
from labcal.certificate.signing import verify
from labcal.certificate.sshsig import NAMESPACE, SECURITY_KEY_TYPE, BadSignature, parse
from labcal.cli import execute
from labcal.errors import InputError
from labcal.files.home import home

CONTENT = b'{"format":"labcal-calibration/1"}'
TOUCHED, VERIFIED = 0x01, 0x04


def tool(name: str) -> str:
    return shutil.which(name) or pytest.skip(f"needs {name} of OpenSSH, which is not installed")


@pytest.fixture
def agent(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[str]:
    """A real ssh-agent with one key, whose private half lies nowhere; the line of its public half."""
    keygen, add, program = tool("ssh-keygen"), tool("ssh-add"), tool("ssh-agent")
    with TemporaryDirectory(prefix="agent") as folder:  # the path of a socket has to be short
        socket = Path(folder) / "socket"
        running = subprocess.Popen([program, "-D", "-a", str(socket)], stdout=subprocess.DEVNULL)
        try:
            end = time.monotonic() + 60
            while not socket.exists():
                assert running.poll() is None, "the agent ended"
                assert time.monotonic() < end, "the agent does not begin"
                time.sleep(0.02)
            monkeypatch.setenv("SSH_AUTH_SOCK", str(socket))
            key = tmp_path / "id"
            subprocess.run([keygen, "-q", "-t", "ed25519", "-N", "", "-C", "ada", "-f", str(key)], check=True)
            subprocess.run([add, "-q", str(key)], check=True, capture_output=True)
            key.unlink()
            yield key.with_suffix(".pub").read_text()
        finally:
            running.terminate()
            running.wait(timeout=30)


def trusting(folder: Path, line: str, name: str = "ada") -> None:
    (folder / "line").write_text(f"{name} {line}")
    session.trust_keys(folder / "line")


def test_a_key_in_the_agent_signs_and_openssh_agrees(
    agent: str, draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.delenv("LABCAL_PASSPHRASE", raising=False)
    trusting(tmp_path, agent)
    assert execute(["sign", str(draft), "--key", "ada"]) == 0
    assert session.verify(draft).signers == ("ada",)
    where = ["-f", str(keys.trust_list(home())), "-s", str(draft.with_name("cal.json.sshsig"))]
    command = [tool("ssh-keygen"), "-Y", "verify", *where, "-I", "ada", "-n", NAMESPACE]
    assert subprocess.run(command, input=draft.read_bytes(), capture_output=True, check=False).returncode == 0
    assert [key.name for key in home().rglob("*.pem")] == ["lab-key.pem"]  # of the audit log


def test_a_key_in_the_agent_administers_the_trust_list(agent: str, tmp_path: Path):
    trusting(tmp_path, agent)
    assert session.sign_trust_list("ada", "") == 1
    assert session.trusted_keys()


def test_what_the_agent_does_not_hold_or_nobody_trusts_signs_nothing(agent: str, draft: Path, tmp_path: Path):
    with pytest.raises(InputError, match="there is no key for ada here; `labcal keys new"):
        session.sign(draft, "ada", "")  # the agent has a key; whose it is, only the trust list says
    trusting(tmp_path, agent)
    session.revoke_keys("ada")
    with pytest.raises(InputError, match="there is no key for ada"):
        session.sign(draft, "ada", "")
    stranger = tmp_path / "other"
    subprocess.run([tool("ssh-keygen"), "-q", "-t", "ed25519", "-N", "", "-f", str(stranger)], check=True)
    trusting(tmp_path, stranger.with_suffix(".pub").read_text(), "bob")
    with pytest.raises(InputError, match="no SSH agent here holds theirs"):
        session.sign(draft, "bob", "")
    assert not list(draft.parent.glob("*.sshsig"))


@pytest.mark.usefixtures("agent")
def test_an_agent_that_is_gone_is_one_sentence(
    agent: str, draft: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    trusting(tmp_path, agent)
    for socket in ("", str(tmp_path / "gone")):
        monkeypatch.setenv("SSH_AUTH_SOCK", socket)
        assert execute(["sign", str(draft), "--key", "ada"]) == 2
    assert not list(draft.parent.glob("*.sshsig"))


def string(value: bytes) -> bytes:
    return struct.pack(">I", len(value)) + value


def security_key_blob(key: Ed25519PrivateKey, application: bytes = b"ssh:") -> bytes:
    return string(SECURITY_KEY_TYPE.encode()) + string(key.public_key().public_bytes_raw()) + string(application)


def of_authenticator(message: bytes, key: Ed25519PrivateKey, flags: int, application: bytes = b"ssh:") -> bytes:
    """What an authenticator with this key makes of a message (PROTOCOL.u2f): type, signature, flags and counter."""
    device = bytes([flags]) + struct.pack(">I", 41)
    raw = key.sign(hashlib.sha256(application).digest() + device + hashlib.sha256(message).digest())
    return string(SECURITY_KEY_TYPE.encode()) + string(raw) + device


def by_security_key(content: bytes, key: Ed25519PrivateKey, flags: int, application: bytes = b"ssh:") -> bytes:
    """Its signature of a file, armoured as `ssh-keygen -Y sign` does."""
    digest = hashlib.sha512(content).digest()
    message = b"SSHSIG" + string(NAMESPACE.encode()) + string(b"") + string(b"sha512") + string(digest)
    value = of_authenticator(message, key, flags, application)
    public = security_key_blob(key, application)
    parts = [string(public), string(NAMESPACE.encode()), string(b""), string(b"sha512"), string(value)]
    blob = b"SSHSIG" + struct.pack(">I", 1) + b"".join(parts)
    return b"-----BEGIN SSH SIGNATURE-----\n" + base64.encodebytes(blob) + b"-----END SSH SIGNATURE-----\n"


@pytest.fixture
def of_ada(key: Ed25519PrivateKey, tmp_path: Path) -> Path:
    """A trust list of Ada's security key."""
    line = f"{SECURITY_KEY_TYPE} {base64.b64encode(security_key_blob(key)).decode()}\n"
    (tmp_path / "of_ada").write_text(f'ada namespaces="{NAMESPACE}" {line}')
    return tmp_path / "of_ada"


def test_a_security_key_s_signature_holds_here_and_for_openssh(draft: Path, of_ada: Path, key: Ed25519PrivateKey):
    file = draft.with_name("cal.json.sshsig")
    file.write_bytes(by_security_key(draft.read_bytes(), key, TOUCHED | VERIFIED))
    session.trust_keys(of_ada)
    assert session.verify(draft).signers == ("ada",)
    where = ["-f", str(of_ada), "-s", str(file), "-I", "ada", "-n", NAMESPACE]
    command = [tool("ssh-keygen"), "-Y", "verify", *where]
    told = subprocess.run(command, input=draft.read_bytes(), capture_output=True, check=False)
    if b"unknown" in told.stderr or b"unsupported" in told.stderr:
        pytest.skip("this OpenSSH was built without security keys")
    assert told.returncode == 0, told.stderr


IDENTITIES, IDENTITIES_ANSWER, SIGN, SIGN_RESPONSE, FAILURE = 11, 12, 13, 14, 5  # the agent's protocol
Answer = Callable[[bytes], bytes | None]  # what is to be signed, and the signature


@contextmanager
def agent_of_a_security_key(public: bytes, answer: Answer) -> Iterator[str]:
    """An SSH agent that knows one FIDO key, whose authenticator is `answer`; the path of its socket."""

    class Handler(socketserver.StreamRequestHandler):
        def handle(self) -> None:
            while len(head := self.rfile.read(4)) == 4:
                asked = self.rfile.read(struct.unpack(">I", head)[0])
                self.wfile.write(string(self.reply(asked)))

        def reply(self, asked: bytes) -> bytes:
            if asked[0] == IDENTITIES:
                return bytes([IDENTITIES_ANSWER]) + struct.pack(">I", 1) + string(public) + string(b"token")
            of_key = 5 + len(public)
            if asked[0] != SIGN or asked[1:of_key] != string(public):
                return bytes([FAILURE])
            (length,) = struct.unpack(">I", asked[of_key : of_key + 4])
            made = answer(asked[of_key + 4 : of_key + 4 + length])
            return bytes([FAILURE]) if made is None else bytes([SIGN_RESPONSE]) + string(made)

    with TemporaryDirectory(prefix="agent") as folder:
        server = socketserver.ThreadingUnixStreamServer(f"{folder}/socket", Handler)
        server.daemon_threads = True
        serving = threading.Thread(target=server.serve_forever, args=(0.05,))
        serving.start()
        try:
            yield f"{folder}/socket"
        finally:
            server.shutdown()
            serving.join()
            server.server_close()


def test_a_security_key_in_an_agent_signs_and_openssh_agrees(
    draft: Path, of_ada: Path, key: Ed25519PrivateKey, monkeypatch: pytest.MonkeyPatch
):
    """`labcal sign` by the system's `ssh-keygen`, which asks an agent, which asks the authenticator for a touch."""
    keygen, _ = tool("ssh-keygen"), tool("ssh-add")
    session.trust_keys(of_ada)
    with agent_of_a_security_key(security_key_blob(key), lambda it: of_authenticator(it, key, TOUCHED)) as socket:
        monkeypatch.setenv("SSH_AUTH_SOCK", socket)
        assert execute(["sign", str(draft), "--key", "ada"]) == 0
    assert session.verify(draft).signers == ("ada",)
    where = ["-f", str(of_ada), "-s", str(draft.with_name("cal.json.sshsig")), "-I", "ada", "-n", NAMESPACE]
    told = subprocess.run([keygen, "-Y", "verify", *where], input=draft.read_bytes(), capture_output=True, check=False)
    assert told.returncode == 0, told.stderr
    assert b"ED25519-SK" in told.stdout


def test_a_security_key_in_an_agent_that_is_not_touched_or_says_no_leaves_no_signature(
    draft: Path, of_ada: Path, key: Ed25519PrivateKey, other_key: Ed25519PrivateKey, monkeypatch: pytest.MonkeyPatch
):
    tool("ssh-keygen"), tool("ssh-add")
    session.trust_keys(of_ada)
    answers: list[tuple[Answer, str]] = [
        (lambda it: of_authenticator(it, key, VERIFIED), "was made without a touch of its security key; nothing was"),
        (lambda it: None, "the SSH agent did not sign with the key of ada; nothing was written"),
        (lambda it: of_authenticator(it, other_key, TOUCHED), "did not sign|does not hold"),
        (lambda it: of_authenticator(it + b" ", key, TOUCHED), "did not sign|does not hold"),
    ]
    before = draft.read_bytes()
    for answer, says in answers:
        with agent_of_a_security_key(security_key_blob(key), answer) as socket:
            monkeypatch.setenv("SSH_AUTH_SOCK", socket)
            with pytest.raises(InputError, match=says):
                session.sign(draft, "ada", "")
        assert draft.read_bytes() == before  # no number is in it, so that it can be signed yet
    assert not list(draft.parent.glob("*.sshsig"))
    assert {one.state for one in session.numbers()} == {"void"}
    with agent_of_a_security_key(security_key_blob(key), lambda it: of_authenticator(it, key, TOUCHED)) as socket:
        monkeypatch.setenv("SSH_AUTH_SOCK", socket)
        session.sign(draft, "ada", "")
    assert session.verify(draft).signers == ("ada",)


def test_a_security_key_that_nobody_touched_signs_nothing(draft: Path, of_ada: Path, key: Ed25519PrivateKey):
    draft.with_name("cal.json.sshsig").write_bytes(by_security_key(draft.read_bytes(), key, VERIFIED))
    found = verify(draft, read_allowed_signers(of_ada), frozenset(), datetime.now(UTC))
    assert found.checks[0].objection == "was made without a touch of its security key"


def test_no_changed_byte_of_a_security_key_s_signature_holds(key: Ed25519PrivateKey):
    made = by_security_key(CONTENT, key, TOUCHED)
    parse(made).check(CONTENT)
    blob = base64.b64decode(b"".join(made.splitlines()[1:-1]))
    for place in range(len(blob)):
        broken = base64.encodebytes(blob[:place] + bytes([blob[place] ^ 0x10]) + blob[place + 1 :])
        with pytest.raises(BadSignature):
            parse(b"-----BEGIN SSH SIGNATURE-----\n" + broken + b"-----END SSH SIGNATURE-----\n").check(CONTENT)


def test_a_security_key_is_no_plain_key_of_the_same_bytes(key: Ed25519PrivateKey):
    """Nor does what it signs for one application hold for another's key."""
    made = base64.b64decode(b"".join(by_security_key(CONTENT, key, TOUCHED, b"ssh:web").splitlines()[1:-1]))
    other = made.replace(security_key_blob(key, b"ssh:web"), security_key_blob(key, b"ssh:lab"))
    armoured = b"-----BEGIN SSH SIGNATURE-----\n" + base64.encodebytes(other) + b"-----END SSH SIGNATURE-----\n"
    with pytest.raises(BadSignature, match="does not hold"):
        parse(armoured).check(CONTENT)


def test_the_environment_names_no_agent_where_none_is(draft: Path, of_ada: Path, monkeypatch: pytest.MonkeyPatch):
    session.trust_keys(of_ada)
    monkeypatch.delenv("SSH_AUTH_SOCK", raising=False)
    with pytest.raises(InputError, match="no SSH agent here holds theirs"):
        session.sign(draft, "ada", "")
    assert "SSH_AUTH_SOCK" not in os.environ
