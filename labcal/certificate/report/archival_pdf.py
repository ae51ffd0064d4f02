"""A certificate as PDF/A-3b (ISO 19005-3): set from its HTML, the files it was printed from inside (extra `paper`)."""

from __future__ import annotations

import logging
import warnings
from hashlib import sha256
from pathlib import Path
from typing import Any

from labcal.certificate.report.html import html
from labcal.certificate.report.page import Front, Page
from labcal.errors import InputError
from labcal.files.home import secrets_aside

VARIANT = "pdf/a-3b"
NEEDED = (
    "a plain PDF without the signed file inside: PDF/A needs the extra `paper` (pip install 'labcal[paper]'; it sets "
    "pages by Pango, which the system has to have)"
)


def typesetter() -> Any:
    """The package that sets a certificate's pages. Raises InputError where it, or the system's Pango, is not there."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what its next versions will need
        try:
            with secrets_aside():  # it looks for its libraries by gcc and ld
                import weasyprint
        except (ImportError, OSError):
            raise InputError(NEEDED) from None
    for name in ("weasyprint", "fontTools"):  # what they say of style sheets and fonts is for nobody here
        logging.getLogger(name).setLevel(logging.CRITICAL)
    return weasyprint


def is_there() -> bool:
    """Whether the package that sets a certificate's pages is, and the system's Pango."""
    try:
        typesetter()
    except InputError:
        return False
    return True


def write_archival_pdf(page: Page, front: Front, path: Path) -> None:
    """Write `page` to `path`; it states when the files were put in. Raises InputError without the extra."""
    weasyprint = typesetter()
    attached = [
        weasyprint.Attachment(string=content, name=name, description=said, relationship="Data")
        for name, content, said in front.attached
    ]
    nothing_from_elsewhere = weasyprint.URLFetcher(allowed_protocols=["data"])
    options = {"pdf_variant": VARIANT, "attachments": attached}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)  # it leaves its colour profile open
        texts = [text := html(page), text.replace("<html", '<html class="tight"', 1)]
        sets = [weasyprint.HTML(string=text, url_fetcher=nothing_from_elsewhere).render(**options) for text in texts]
        tight = len(sets[1].pages) < len(sets[0].pages)  # smaller gaps, where that saves a sheet
        own = sha256(texts[tight].encode()).hexdigest()[:32].encode()
        sets[tight].write_pdf(path, finisher=_each_once, pdf_identifier=own, **options)


def _each_once(_: Any, pdf: Any) -> None:
    """The files that belong to the document (AF), each once: WeasyPrint 70 names an attachment twice."""
    if files := pdf.catalog.get("AF"):
        files[:] = dict.fromkeys(files)
