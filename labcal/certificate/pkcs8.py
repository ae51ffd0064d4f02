"""A private key under a passphrase: encrypted PKCS#8 (RFC 5958) that `openssl pkey` opens.

The derivation is PBES2 with PBKDF2-HMAC-SHA256 and AES-256-CBC (RFC 8018, A.4), written here because
`cryptography` offers no choice of rounds for this format and takes 2048, three hundred times too few.
"""

from __future__ import annotations

import base64
import os
import textwrap

from cryptography.hazmat.primitives import hashes, padding
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.ciphers import Cipher
from cryptography.hazmat.primitives.ciphers.algorithms import AES256
from cryptography.hazmat.primitives.ciphers.modes import CBC
from cryptography.hazmat.primitives.kdf.pbkdf2 import PBKDF2HMAC
from cryptography.hazmat.primitives.serialization import (
    Encoding,
    NoEncryption,
    PrivateFormat,
    load_pem_private_key,
)

from labcal.system.private_memory import kept_private

ROUNDS = 600_000  # a third of a second; OWASP's figure for PBKDF2-HMAC-SHA256

_PBES2 = bytes.fromhex("06092a864886f70d01050d")
_PBKDF2 = bytes.fromhex("06092a864886f70d01050c")
_HMAC_SHA256 = bytes.fromhex("06082a864886f70d02090500")  # with its NULL parameter
_AES256_CBC = bytes.fromhex("060960864801650304012a")


def locked(key: Ed25519PrivateKey, passphrase: str) -> bytes:
    """The PEM text of `key`, readable with `passphrase` alone."""
    salt, iv = os.urandom(16), os.urandom(16)
    plain = key.private_bytes(Encoding.DER, PrivateFormat.PKCS8, NoEncryption())
    derived = PBKDF2HMAC(hashes.SHA256(), 32, salt, ROUNDS).derive(_bytes(passphrase))
    derivation = _sequence(_PBKDF2, _sequence(_octets(salt), _integer(ROUNDS), _sequence(_HMAC_SHA256)))
    scheme = _sequence(_PBES2, _sequence(derivation, _sequence(_AES256_CBC, _octets(iv))))
    return _pem(_sequence(scheme, _octets(_encrypted(plain, derived, iv))))


def unlocked(pem: bytes, passphrase: str) -> Ed25519PrivateKey:
    """The key in the PEM text. Raises ValueError where the passphrase is wrong or it is no encrypted Ed25519 key."""
    if b"-----BEGIN ENCRYPTED PRIVATE KEY-----" not in pem:
        raise ValueError("is not an encrypted private key (PKCS#8)")
    try:
        key = load_pem_private_key(pem, _bytes(passphrase))
    except Exception as error:  # its parser raises of many kinds for a wrong passphrase and for damage alike
        raise ValueError("does not open: the passphrase is wrong or the file is damaged") from error
    if not isinstance(key, Ed25519PrivateKey):
        raise ValueError("is not an Ed25519 key")
    return key


def _bytes(passphrase: str) -> bytes:
    """UTF-8; bytes of the environment that are none pass as they are. This process keeps its memory from now on."""
    kept_private()
    return passphrase.encode(errors="surrogateescape")


def _encrypted(plain: bytes, key: bytes, iv: bytes) -> bytes:
    pad, cipher = padding.PKCS7(128).padder(), Cipher(AES256(key), CBC(iv)).encryptor()
    return cipher.update(pad.update(plain) + pad.finalize()) + cipher.finalize()


def _pem(der: bytes) -> bytes:
    lines = textwrap.wrap(base64.b64encode(der).decode(), 64)
    return "\n".join(
        ["-----BEGIN ENCRYPTED PRIVATE KEY-----", *lines, "-----END ENCRYPTED PRIVATE KEY-----", ""]
    ).encode()


def _sequence(*parts: bytes) -> bytes:
    return _tagged(0x30, b"".join(parts))


def _octets(content: bytes) -> bytes:
    return _tagged(0x04, content)


def _integer(value: int) -> bytes:
    return _tagged(0x02, value.to_bytes(value.bit_length() // 8 + 1, "big"))


def _tagged(tag: int, content: bytes) -> bytes:
    length = len(content)
    return bytes([tag, length] if length < 0x80 else [tag, 0x81, length]) + content  # all here is below 256 bytes
