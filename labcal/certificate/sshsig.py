"""SSHSIG, the detached signature that `ssh-keygen -Y verify` checks (OpenSSH, PROTOCOL.sshsig, PROTOCOL.u2f)."""

from __future__ import annotations

import base64
import binascii
import hashlib
import struct
from dataclasses import dataclass

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey

NAMESPACE = "labcal-calibration"
KEY_TYPE = "ssh-ed25519"
SECURITY_KEY_TYPE = "sk-ssh-ed25519@openssh.com"  # a FIDO authenticator's

_MAGIC = b"SSHSIG"
_BEGIN, _END = "-----BEGIN SSH SIGNATURE-----", "-----END SSH SIGNATURE-----"
_COLUMNS = 70
_TOUCHED = 0x01  # of a security key's flags: a person was there


class BadSignature(ValueError):
    """A signature that does not hold, or cannot be read; the message says why in a few words."""


@dataclass(frozen=True, slots=True)
class Signature:
    """What a signature file states: whose key (`public_key`, SSH wire format), for what, and the signature itself."""

    public_key: bytes
    namespace: str
    hash_name: str
    value: bytes
    by_device: bytes = b""  # a security key's flags (1) and counter (4), which it signs too

    def check(self, content: bytes, namespace: str = NAMESPACE) -> None:
        """Raise BadSignature unless this key signed exactly these bytes for that purpose."""
        if self.namespace != namespace:
            raise BadSignature(f"made for {self.namespace!r}, not for {namespace!r}")
        signed = _signed(content, self.namespace, self.hash_name)
        if self.by_device:
            if not self.by_device[0] & _TOUCHED:
                raise BadSignature("was made without a touch of its security key")
            application = hashlib.sha256(_parts(self.public_key)[2]).digest()
            signed = application + self.by_device + hashlib.sha256(signed).digest()
        try:
            Ed25519PublicKey.from_public_bytes(raw_public_key(self.public_key)).verify(self.value, signed)
        except InvalidSignature:
            raise BadSignature("does not hold: the file is not the one that was signed") from None


def sign(content: bytes, key: Ed25519PrivateKey, namespace: str = NAMESPACE) -> str:
    """The armoured signature of `content`, byte for byte what `ssh-keygen -Y sign` writes for this key."""
    value = _string(KEY_TYPE) + _string(key.sign(_signed(content, namespace, "sha512")))
    public = _string(public_key_blob(key.public_key()))
    fields = struct.pack(">I", 1) + public + _string(namespace) + _string("") + _string("sha512") + _string(value)
    text = base64.b64encode(_MAGIC + fields).decode()
    lines = [text[i : i + _COLUMNS] for i in range(0, len(text), _COLUMNS)]
    return "\n".join([_BEGIN, *lines, _END, ""])


def parse(armoured: bytes) -> Signature:
    """Read an armoured signature. Raises BadSignature where it is not whole, or nothing labcal checks."""
    blob = _Wire(_unarmoured(armoured))
    if blob.take(len(_MAGIC)) != _MAGIC or blob.take(4) != struct.pack(">I", 1):
        raise BadSignature("is not an SSH signature of version 1")
    public_key, namespace, _, hash_name, value = (blob.string() for _ in range(5))
    inner = _Wire(value)
    if (kind := inner.string().decode(errors="replace")) not in (KEY_TYPE, SECURITY_KEY_TYPE):
        raise BadSignature(f"is of type {kind!r}; labcal checks {KEY_TYPE} and {SECURITY_KEY_TYPE} alone")
    if kind != _parts(public_key)[0]:
        raise BadSignature(f"is of type {kind!r}, and its key is of another")
    if hash_name not in (b"sha512", b"sha256"):
        raise BadSignature("uses a hash that SSH signatures do not have")
    raw, by_device = inner.string(), inner.take(5) if kind == SECURITY_KEY_TYPE else b""
    signature = Signature(public_key, namespace.decode(errors="replace"), hash_name.decode(), raw, by_device)
    if blob.rest or inner.rest:
        raise BadSignature("has bytes after its end")
    return signature


def public_key_blob(key: Ed25519PublicKey) -> bytes:
    """The public key in SSH wire format: what stands as base64 in `.pub` and allowed_signers files."""
    return _string(KEY_TYPE) + _string(key.public_bytes_raw())


def raw_public_key(blob: bytes) -> bytes:
    """The 32 bytes of an Ed25519 key, also a security key's, from its SSH wire format. Raises BadSignature."""
    return _parts(blob)[1]


def _parts(blob: bytes) -> tuple[str, bytes, bytes]:
    """Type, 32 bytes and, of a security key, application. Raises BadSignature."""
    wire = _Wire(blob)
    kind, raw = wire.string().decode(errors="replace"), wire.string()
    application = wire.string() if kind == SECURITY_KEY_TYPE else b""
    if kind not in (KEY_TYPE, SECURITY_KEY_TYPE) or len(raw) != 32 or wire.rest:
        raise BadSignature(f"its key is not {KEY_TYPE}")
    return kind, raw, application


def fingerprint(blob: bytes) -> str:
    """`SHA256:…`, as ssh-keygen prints it."""
    return "SHA256:" + base64.b64encode(hashlib.sha256(blob).digest()).decode().rstrip("=")


def _signed(content: bytes, namespace: str, hash_name: str) -> bytes:
    digest = hashlib.new(hash_name, content).digest()
    return _MAGIC + _string(namespace) + _string("") + _string(hash_name) + _string(digest)


def _string(value: str | bytes) -> bytes:
    content = value.encode() if isinstance(value, str) else value
    return struct.pack(">I", len(content)) + content


def _unarmoured(armoured: bytes) -> bytes:
    try:
        text = armoured.decode("ascii").strip()
        if not (text.startswith(_BEGIN) and text.endswith(_END)):
            raise BadSignature("is not a whole SSH signature: its first or last line is missing")
        return base64.b64decode("".join(text[len(_BEGIN) : -len(_END)].split()), validate=True)
    except (UnicodeDecodeError, binascii.Error):
        raise BadSignature("is not a whole SSH signature: its text is damaged") from None


class _Wire:
    """Bytes read from the front: fixed lengths and length-prefixed strings (RFC 4251, section 5)."""

    def __init__(self, content: bytes) -> None:
        self.rest = content

    def take(self, length: int) -> bytes:
        if len(self.rest) < length:
            raise BadSignature("is cut short")
        taken, self.rest = self.rest[:length], self.rest[length:]
        return taken

    def string(self) -> bytes:
        (length,) = struct.unpack(">I", self.take(4))
        return self.take(length)
