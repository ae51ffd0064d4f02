"""A page as one HTML file that needs nothing else: style and figures are inside."""

from __future__ import annotations

import io
from pathlib import Path
from typing import TYPE_CHECKING, Any

from labcal.certificate.report.page import Page, Plot
from labcal.certificate.report.style import WIDTH_IN, plot_style

if TYPE_CHECKING:
    from markupsafe import Markup


def html(page: Page) -> str:
    """The page's HTML. Everything a file or a run says is escaped."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markupsafe import Markup

    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined, trim_blocks=True
    )
    environment.filters["svg"] = lambda plot: Markup(svg(plot))  # our own drawing; its texts are matplotlib's paths
    environment.filters["css"] = css_string
    context: dict[str, Any] = {"page": page}
    return environment.get_template("page.html.j2").render(context)


def css_string(text: str) -> Markup:
    """`text` as a string of a style sheet: nothing in it ends the string or the sheet."""
    from markupsafe import Markup

    return Markup('"' + "".join(c if c.isalnum() or c in " .,-" else f"\\{ord(c):x} " for c in text) + '"')


def svg(plot: Plot) -> str:
    """The figure as inline SVG, WIDTH_IN wide; texts are outlines, dense points one picture inside."""
    from matplotlib.figure import Figure

    with plot_style():
        figure = Figure(figsize=(WIDTH_IN, plot.height_in), layout="constrained", dpi=150)
        plot.draw(figure)
        out = io.StringIO()
        figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None}, transparent=True)
    text = out.getvalue()
    return text[text.index("<svg") :].replace("<svg ", '<svg role="img" ', 1)
