"""Reports for people: a page's content, and its shape as HTML or PDF."""

from __future__ import annotations

from pathlib import Path

from labcal.certificate.report.archival_pdf import NEEDED, is_there, write_archival_pdf
from labcal.certificate.report.calibration import calibration_page
from labcal.certificate.report.circumstances import Circumstances
from labcal.certificate.report.closed_loop import closed_loop_page
from labcal.certificate.report.html import html
from labcal.certificate.report.page import Page
from labcal.certificate.report.pdf import write_pdf
from labcal.certificate.report.run import run_page
from labcal.errors import InputError
from labcal.files import atomic

__all__ = ["Circumstances", "Page", "calibration_page", "check_form", "closed_loop_page", "run_page", "write_report"]

FORMS = (".html", ".pdf")


def write_report(page: Page, path: Path) -> str:
    """Write `page` to `path`, whole or not at all, in the form its ending names. Raises InputError for another.

    Returns what a certificate's PDF is not, in a sentence, where the extra `paper` is not there; "" else.
    """
    check_form(path)
    with atomic.replacing(path) as part:
        if path.suffix.lower() != ".pdf":
            part.write_text(html(page), encoding="utf-8", newline="\n")
        elif page.front is not None and is_there():
            write_archival_pdf(page, page.front, part)
        else:
            write_pdf(page, part)
            return NEEDED if page.front is not None else ""
    return ""


def check_form(path: Path) -> None:
    """Raise InputError unless the ending of `path` names a form that reports have."""
    if path.suffix.lower() not in FORMS:
        raise InputError(f"a report ends in {' or '.join(FORMS)}", file=path)
