"""A key that never lies on this computer: an SSH agent holds it, or a security key does, and it signs by `ssh-keygen`.

labcal sends no words to the agent itself: the system's own tools do, and what they return is checked like any other
signature before it is written.
"""

from __future__ import annotations

import base64
import os
import shutil
import subprocess
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import sshsig
from labcal.certificate.allowed_signers import Signer
from labcal.certificate.sshsig import NAMESPACE, BadSignature, public_key_blob
from labcal.errors import InputError
from labcal.files.home import for_children

ASKED_S = 30.0  # an agent that stands still longer answers nobody
TOUCHED_S = 120.0  # for somebody to touch their security key, or to agree


@dataclass(frozen=True, slots=True)
class AgentKey:
    """Somebody's key in the agent, by its public half."""

    signer: Signer

    def sign(self, content: bytes, namespace: str = NAMESPACE) -> str:
        """The armoured signature of `content`. Raises InputError where the agent makes none that holds."""
        with TemporaryDirectory() as folder:
            public = Path(folder) / "key.pub"
            public.write_text(f"{self.signer.key_type} {base64.b64encode(self.signer.key).decode()}\n")
            made = _asked(
                "ssh-keygen", "-Y", "sign", "-n", namespace, "-f", str(public), given=content, within=TOUCHED_S
            )
        if made is None:
            raise InputError(f"the SSH agent did not sign with the key of {self.signer.principal}; nothing was written")
        try:
            signature = sshsig.parse(made)
            signature.check(content, namespace)
        except BadSignature as error:
            raise InputError(f"what the SSH agent signed {error}; nothing was written") from None
        if signature.public_key != self.signer.key:
            raise InputError(f"the SSH agent signed with another key than that of {self.signer.principal}")
        return made.decode("ascii")


Key = Ed25519PrivateKey | AgentKey


def in_agent(signers: Iterable[Signer]) -> AgentKey | None:
    """The first of these keys that this user's SSH agent holds; None where it holds none, or there is no agent."""
    if not os.environ.get("SSH_AUTH_SOCK") and os.name == "posix":
        return None
    listed = (_asked("ssh-add", "-L", within=ASKED_S) or b"").decode(errors="replace")
    held = {tuple(line.split()[:2]) for line in listed.splitlines()}
    there = (s for s in signers if (s.key_type, base64.b64encode(s.key).decode()) in held)
    return next(map(AgentKey, there), None)


def public_half(key: Key) -> bytes:
    """Its public key in SSH wire format."""
    return key.signer.key if isinstance(key, AgentKey) else public_key_blob(key.public_key())


def signed(content: bytes, key: Key, namespace: str = NAMESPACE) -> str:
    """The armoured signature of `content` by `key`. Raises InputError where an agent makes none."""
    return key.sign(content, namespace) if isinstance(key, AgentKey) else sshsig.sign(content, key, namespace)


def _asked(program: str, *words: str, given: bytes = b"", within: float) -> bytes | None:
    """What the program answers; None where it is not there, fails, or takes longer than `within` seconds."""
    if (found := shutil.which(program)) is None:
        return None
    try:
        done = subprocess.run([found, *words], env=for_children(), input=given, capture_output=True, timeout=within)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None
