"""The DCC's own signature: XAdES (ETSI EN 319 132-1), enveloped, by a key and its X.509 certificate (extra `dcc`).

It says that whoever holds the key gave out these bytes of XML. It takes the place of no signature of the calibration
file: those are checked before, and lie beside that file.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from cryptography import x509
from cryptography.exceptions import UnsupportedAlgorithm
from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
from cryptography.hazmat.primitives.asymmetric.rsa import RSAPrivateKey
from cryptography.hazmat.primitives.serialization import Encoding, PublicFormat, load_pem_private_key

from labcal.errors import InputError
from labcal.files.plain_file import read_limited

LARGEST_BYTES = 2**17
SMALLEST_RSA = 2048  # bits
MISSING = "a signed DCC needs the extra `dcc` (signxml): pip install 'labcal[dcc]'"
HASH_OF_CURVE = {256: "sha256", 384: "sha384", 521: "sha512"}


@dataclass(frozen=True, slots=True)
class XmlKey:
    """Who signs the XML: a private key, and its certificate with those of its issuers, its own first."""

    key: RSAPrivateKey | EllipticCurvePrivateKey
    certificates: tuple[x509.Certificate, ...]

    @property
    def algorithm(self) -> str:
        """As the last part of its URI."""
        if isinstance(self.key, RSAPrivateKey):
            return "rsa-sha256"
        return f"ecdsa-{HASH_OF_CURVE[self.key.curve.key_size]}"


def read_xml_key(key_file: Path, certificate_file: Path, ask: Callable[[], str], now: datetime | None = None) -> XmlKey:
    """Read a key in PEM, for whose passphrase, if it has one, `ask` asks, and its certificates.

    Raises InputError: others may read the key, it is of another kind or too short, is not that of the certificate, or
    the certificate is not valid now.
    """
    key, certificates = _key(key_file, ask), _certificates(certificate_file)
    own, at = certificates[0], now or datetime.now(UTC)
    same = own.public_key().public_bytes(Encoding.DER, PublicFormat.SubjectPublicKeyInfo)
    if same != key.public_key().public_bytes(Encoding.DER, PublicFormat.SubjectPublicKeyInfo):
        raise InputError(f"its first certificate is not that of the key in {key_file.name}", file=certificate_file)
    if not own.not_valid_before_utc <= at <= own.not_valid_after_utc:
        valid = f"{own.not_valid_before_utc:%Y-%m-%d} to {own.not_valid_after_utc:%Y-%m-%d}"
        raise InputError(f"the certificate is valid from {valid}, not now; nothing was signed", file=certificate_file)
    return XmlKey(key, certificates)


def signed_xml(xml: bytes, by: XmlKey) -> bytes:
    """The document with its signature as the last child of its root. Raises InputError where signxml is missing."""
    try:
        from lxml import etree
        from signxml.xades.xades import XAdESDataObjectFormat, XAdESSigner
    except ImportError:
        raise InputError(MISSING) from None
    form = XAdESDataObjectFormat("Digital Calibration Certificate", "application/xml")
    digest = by.algorithm.partition("-")[2]
    signer = XAdESSigner(data_object_format=form, signature_algorithm=by.algorithm, digest_algorithm=digest)
    pem = [one.public_bytes(Encoding.PEM).decode() for one in by.certificates]
    root = signer.sign(etree.fromstring(xml), key=by.key, cert=pem, always_add_key_value=False)
    return bytes(etree.tostring(root, xml_declaration=True, encoding="UTF-8"))


def _key(path: Path, ask: Callable[[], str]) -> RSAPrivateKey | EllipticCurvePrivateKey:
    content = read_limited(path, LARGEST_BYTES)
    if os.name == "posix" and (mode := stat.S_IMODE(path.stat().st_mode)) & 0o077:
        raise InputError(f"others may read this key (mode {mode:o}); it is not used until `chmod 600`", file=path)
    try:
        try:
            key = load_pem_private_key(content, None)
        except TypeError:  # it is locked
            key = load_pem_private_key(content, ask().encode())
    except (ValueError, TypeError, UnsupportedAlgorithm):
        raise InputError("is no private key in PEM, or the passphrase is not its own", file=path) from None
    if isinstance(key, RSAPrivateKey) and key.key_size >= SMALLEST_RSA:
        return key
    if isinstance(key, EllipticCurvePrivateKey) and key.curve.key_size in HASH_OF_CURVE:
        return key
    raise InputError(f"is no RSA key of {SMALLEST_RSA} bits or more, nor one on P-256, P-384 or P-521", file=path)


def _certificates(path: Path) -> tuple[x509.Certificate, ...]:
    try:
        return tuple(x509.load_pem_x509_certificates(read_limited(path, LARGEST_BYTES)))
    except ValueError:
        raise InputError("holds no X.509 certificate in PEM", file=path) from None
