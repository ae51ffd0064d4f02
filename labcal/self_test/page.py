"""The qualification as a page for people, in the form of all reports."""

from __future__ import annotations

from functools import partial
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

from labcal.certificate.report import Page, write_report
from labcal.certificate.report.page import Facts, Mark, Plot, Prose, Table, section, sections
from labcal.errors import InputError
from labcal.files.home import home, own_folder
from labcal.files.outputs import Output, claim
from labcal.self_test.result import Check, Qualification

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

PICTURE_IN = 3.4  # with all checks and the lines to sign on, one sheet
LINE = "_" * 48
HEADER = ("Check", "Result", "What was found")


def place_for(out: Path | None, *, force: bool = False) -> Output | None:
    """Where the page goes; None for labcal's own folder. Raises InputError, before any check, where it may not go."""
    if out is None:
        return None
    [output] = claim("self-test", out, force=force)
    if out.suffix.lower() != ".pdf":
        raise InputError("a qualification is a .pdf", file=out)
    return output


def write_page(found: Qualification, output: Output | None) -> Path:
    """Write the page, and say where it lies: of those in labcal's own folder each has its time as its name."""
    if output is None:
        kept = own_folder(own_folder(home()) / "self-tests") / f"self-test-{found.computer.when:%Y%m%dT%H%M%SZ}.pdf"
        write_report(qualification_page(found), kept)
        return kept
    with output.writing() as path:
        write_report(qualification_page(found), path)
    return output.path


def qualification_page(found: Qualification) -> Page:
    """The page: on what computer, every check, what to do, the window's picture, a line to sign on."""
    on = found.computer
    return Page(
        kind="Installation qualification",
        title=f"labcal {on.labcal} on {on.machine}",
        subtitle=f"{on.when:%Y-%m-%d %H:%M} UTC",
        simulated=False,
        marks=(Mark("PASSED", "good") if found.passed else Mark("NOT PASSED", "bad"),),
        facts=Facts(
            (
                ("labcal", f"{on.labcal}, in {on.folder}"),
                ("Python", on.python),
                ("System", on.system),
                ("User", on.user),
            )
        ),
        sections=sections(
            section("Checks", [Table(HEADER, tuple((c.name, c.result, c.said) for c in found.checks))]),
            section("What to do", [_todo(found.checks)]),
            section("Seen by", [Facts(tuple((name, LINE) for name in ("Name", "Date", "Signature")))]),
            section("The window, as it opened", [_picture(check) for check in found.checks]),
        ),
        footer="Made by `labcal self-test` on a simulated lab. It shows that this installation computes and signs as "
        "it should; of instruments it says nothing: `labcal bench check` does.",
    )


def _todo(checks: tuple[Check, ...]) -> Prose | None:
    wanted = tuple(f"{check.name}: {check.todo}" for check in checks if check.todo)
    return Prose(wanted) if wanted else None


def _picture(check: Check) -> Plot | None:
    if check.picture is None:
        return None
    return Plot(partial(_draw, check.picture), PICTURE_IN, "")


def _draw(picture: bytes, figure: FigureBase) -> None:
    from matplotlib.image import imread

    axes = figure.add_subplot()
    axes.imshow(imread(BytesIO(picture), format="png"))
    axes.set_axis_off()
