"""A page as one HTML file that needs nothing else: style and figures are inside."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from labcal.certificate.report.page import Page, Plot
from labcal.certificate.report.style import WIDTH_IN, plot_style


def html(page: Page) -> str:
    """The page's HTML. Everything a file or a run says is escaped."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined
    from markupsafe import Markup

    environment = Environment(
        loader=FileSystemLoader(Path(__file__).parent), autoescape=True, undefined=StrictUndefined, trim_blocks=True
    )
    environment.filters["svg"] = lambda plot: Markup(svg(plot))  # our own drawing; its texts are matplotlib's paths
    context: dict[str, Any] = {"page": page}
    return environment.get_template("page.html.j2").render(context)


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
