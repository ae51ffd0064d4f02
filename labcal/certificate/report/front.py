"""The front of a certificate: its number, what stands on every sheet, and the code that says what is signed."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path

from labcal.certificate.report.page import Front
from labcal.certificate.signing import Verification, signature_files
from labcal.model import Calibration

NO_NUMBER = "without a number"
LARGEST_IMAGE_BYTES = 500_000
IMAGES = ("logo", "accreditation")  # in labcal's folder, as .svg or .png
KINDS = {".svg": "image/svg+xml", ".png": "image/png"}


def front_of(c: Calibration, v: Verification, images: tuple[str, ...] = ()) -> Front:
    """The front of the certificate of `c`, whose file was checked as `v`."""
    digest, number = sha256(v.content).hexdigest(), c.number or NO_NUMBER
    said = f"{number} · {c.dut.serial} · SHA-256 {digest[:16]}…"
    return Front(
        f"No. {number}" if c.number else number.capitalize(),
        said,
        stamp(c, v),
        images,
        _code(code_text(c, digest)),
        _attached(v),
    )


def code_text(c: Calibration, digest: str) -> str:
    """What a QR code on paper says: the certificate's number, else the run, and the SHA-256 of the file."""
    return f"{c.number or c.run_id} sha256:{digest}"


def stamp(c: Calibration, v: Verification) -> str:
    """What must be seen on every sheet of something that is no valid certificate of a real sensor; else empty."""
    said = ["SIMULATED"] if c.simulated else []
    if not v.checks:
        said.append("DRAFT, NOT SIGNED")
    elif not v.valid:
        said.append("SIGNATURE NOT VALID")
    return " · ".join(said)


def images_in(folder: Path, *, accredited: bool = True) -> tuple[str, ...]:
    """The logo and the accreditation mark in `folder`, as far as they are there and small enough to be printed.

    Without `accredited` the logo alone: nothing simulated is in an accreditation's scope.
    """
    names = IMAGES if accredited else IMAGES[:1]
    there = (folder / f"{name}{ending}" for name in names for ending in KINDS)
    return tuple(_data(KINDS[f.suffix], f.read_bytes()) for f in there if _printable(f))


def _printable(file: Path) -> bool:
    return file.is_file() and file.stat().st_size <= LARGEST_IMAGE_BYTES


def _attached(v: Verification) -> tuple[tuple[str, bytes, str], ...]:
    """The calibration file and its signatures, which the PDF holds."""
    signed: Iterable[Path] = signature_files(v.file) if v.file.exists() else ()
    signatures = tuple((file.name, file.read_bytes(), "signature of the calibration file") for file in signed)
    return ((v.file.name, v.content, "the calibration file that this certificate is printed from"), *signatures)


def _code(text: str) -> str:
    """A QR code of `text`; empty where the extra that draws it is not installed (the text stands on the page too)."""
    try:
        import segno
    except ImportError:
        return ""
    drawn = io.BytesIO()
    segno.make(text, error="m", micro=False).save(drawn, kind="svg", border=2, xmldecl=False, scale=2)
    return _data("image/svg+xml", drawn.getvalue())


def _data(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"
