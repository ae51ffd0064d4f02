"""A link in a sentence goes by the name of its instrument: nobody at the bench knows what is on ttyUSB3."""

from __future__ import annotations

from collections.abc import Mapping


def named_links(text: str, links: Mapping[str, str], *, brief: bool = False) -> str:
    """`text` with the instrument's name before its link, which stands in brackets, or not at all; `links` by name.

    A link that several share is "the line of" them. The name that stands there already is not said twice, nor where
    it is told what answers "at" the link.
    """
    for link in sorted({*links.values()}, key=len, reverse=True):
        here = [name for name, its in links.items() if its == link]
        names = f"the line of {', '.join(here)}" if here[1:] else here[0]
        if f" at {link})" in text:
            return text
        if link in text:
            plain = text.replace(f"{names} ({link})", link, 1).replace(f"{names}: {link}", link, 1)
            return plain.replace(link, names if brief else f"{names} ({link})", 1)
    return text
