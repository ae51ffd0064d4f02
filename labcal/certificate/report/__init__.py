"""Reports for people: a page's content, and its shape as HTML or PDF."""

from __future__ import annotations

from pathlib import Path

from labcal import files
from labcal.certificate.report.calibration import calibration_page
from labcal.certificate.report.page import Page
from labcal.certificate.report.run import run_page
from labcal.errors import InputError

__all__ = ["Page", "calibration_page", "run_page", "write_report"]


def write_report(page: Page, path: Path) -> None:
    """Write `page` to `path`, whole or not at all, in the form its ending names. Raises InputError for another."""
    match path.suffix.lower():
        case ".html" | ".htm":
            from labcal.certificate.report.html import html

            files.write_text(path, html(page))
        case ".pdf":
            from labcal.certificate.report.pdf import write_pdf

            with files.replacing(path) as part:
                write_pdf(page, part)
        case _:
            raise InputError("a report ends in .html or .pdf", file=path)
