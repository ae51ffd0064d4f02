"""`labcal report`: a page for people."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import typer

from labcal.cli import app
from labcal.cli.keys import passphrase
from labcal.cli.results import FORCE
from labcal.cli.screen import say
from labcal.errors import InputError


@app.command(rich_help_panel="Certificate")
def report(
    source: str = typer.Argument(..., metavar="RUN|CAL", help="A run, or a calibration file (*.json)."),
    out: Path = typer.Option(..., metavar="FILE", help="FILE.html or FILE.pdf; of a calibration also FILE.xml (DCC)."),
    allowed_signers: Path | None = typer.Option(None, help="Check CAL's signatures against this list, not the lab's."),
    before: Path | None = typer.Option(
        None, metavar="OLDCAL", help="Say what changed since this calibration, not since the lab's own before CAL."
    ),
    xml_key: Path | None = typer.Option(
        None, "--xml-key", metavar="KEY.pem", help="Sign a DCC's XML (XAdES) with this key, RSA or ECDSA."
    ),
    xml_cert: Path | None = typer.Option(
        None, "--xml-cert", metavar="CERT.pem", help="The key's X.509 certificate, then those of its issuers."
    ),
    label: bool = typer.Option(False, "--label", help="A label for the DUT: FILE.pdf, FILE.svg or FILE.png."),
    force: bool = FORCE,
) -> None:
    """Write the report of a run, or the certificate of a calibration; with --label the label for its DUT.

    A certificate's PDF is PDF/A-3b with the signed file inside where the extra `paper` is there, else a plain one, and
    stderr says so; its XML needs the extra `dcc`.
    """
    from labcal import session
    from labcal.session.reporting import XmlKeyFiles

    if (xml_key is None) != (xml_cert is None):
        raise InputError("--xml-key and --xml-cert belong together: a key, and the certificate that says whose it is")
    if label:
        return _label(source, out, allowed_signers, before or xml_key, force)
    by = None
    if xml_key is not None and xml_cert is not None:
        by = XmlKeyFiles(xml_key, xml_cert, partial(passphrase, f"Passphrase of {xml_key.name}: "))
    on_remark = partial(say, err=True)
    session.report(source, out, allowed_signers, before=before, xml_key=by, on_remark=on_remark, force=force)
    return say(out)


def _label(source: str, out: Path, allowed_signers: Path | None, of_a_report: Path | None, force: bool) -> None:
    from labcal import session

    if of_a_report is not None:
        raise InputError("--label goes without --before, --xml-key and --xml-cert: they are of a report")
    session.label(Path(source), out, allowed_signers, force=force)
    say(out)
