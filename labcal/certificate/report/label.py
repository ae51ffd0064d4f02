"""The label for the DUT itself: its serial large, whose it is, until when it is good, and a code of what was signed."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from typing import Any, cast

from labcal.certificate.report.front import code_text, stamp
from labcal.certificate.report.style import BAD, MUTED, TEXT, plot_style
from labcal.certificate.signing import Verification
from labcal.errors import InputError
from labcal.files import atomic
from labcal.model import Calibration

WIDE_MM, HIGH_MM, EDGE_MM = 62.0, 29.0, 2.5  # what label printers take
MM, DPI = 1 / 25.4, 300  # [in]
FORMS = (".pdf", ".svg", ".png")
NEEDED = "a label has a QR code: pip install 'labcal[paper]'"
LINES = ((5.5, 6.0, False), (11.5, 12.0, True), (16.5, 6.0, False), (20.5, 6.0, False), (25.0, 6.0, True))


def label_lines(c: Calibration, v: Verification, laboratory: str, calibrated: str) -> tuple[str, str, str, str, str]:
    """Whose, serial, when (ISO dates), number or run, and what it is not: in the order of the label."""
    until = f", good until {c.validity.until}" if c.validity.until else ""
    when = f"calibrated {calibrated}{until}" if calibrated else until.removeprefix(", ")
    return laboratory, c.dut.serial, when, c.number or f"run {c.run_id}", stamp(c, v)


def _renderer(sheet: Any) -> Any:
    """What knows how wide letters become."""
    from matplotlib.backends.backend_agg import RendererAgg

    return cast(Any, RendererAgg)(sheet.bbox.width, sheet.bbox.height, DPI)


def write_label(c: Calibration, v: Verification, laboratory: str, calibrated: str, out: Path) -> None:
    """Write the label of `c`, whose file was checked as `v`, 62 by 29 mm. Raises InputError."""
    if out.suffix.lower() not in FORMS:
        raise InputError(f"a label ends in {' or '.join(FORMS)}", file=out)
    try:
        import segno
    except ImportError:
        raise InputError(NEEDED, file=out) from None
    from matplotlib.figure import Figure

    code = segno.make(code_text(c, sha256(v.content).hexdigest()), error="m", micro=False)
    with plot_style(), atomic.replacing(out) as part:
        sheet = Figure(figsize=(WIDE_MM * MM, HIGH_MM * MM), facecolor="white", dpi=DPI)
        side = HIGH_MM - 2 * EDGE_MM
        place = sheet.add_axes((EDGE_MM / WIDE_MM, EDGE_MM / HIGH_MM, side / WIDE_MM, side / HIGH_MM))
        place.imshow([list(row) for row in code.matrix], cmap="binary", interpolation="nearest")
        place.axis("off")
        left, drawn = side + 2 * EDGE_MM, _renderer(sheet)
        for words, (down, pt, bold) in zip(label_lines(c, v, laboratory, calibrated), LINES, strict=True):
            colour = BAD if words == stamp(c, v) else TEXT if bold else MUTED
            weight = "bold" if bold else "normal"
            at = left / WIDE_MM, 1 - down / HIGH_MM
            line = sheet.text(*at, words, fontsize=pt, color=colour, fontweight=weight, va="center")
            wide_mm = line.get_window_extent(drawn).width / DPI / MM
            line.set_fontsize(min(pt, pt * (WIDE_MM - EDGE_MM - left) / max(wide_mm, 1.0)))  # the whole, if smaller
        kind = out.suffix.lower()[1:]
        dates = {"pdf": {"CreationDate": None}, "svg": {"Date": None}, "png": {}}[kind]
        sheet.savefig(part, format=kind, dpi=DPI, metadata=dates)
