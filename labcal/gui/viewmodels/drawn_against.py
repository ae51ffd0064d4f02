"""What a residual is drawn against, in words: a channel's own name says nothing to whoever did not wire it."""

from __future__ import annotations

from labcal.gui.translations.translate import translated

OWN = ("", "time  s", "angle  deg", "field  nT")  # of every run
BY_UNIT = {"A": "current {0}", "degC": "temperature {0}", "V": "voltage {0}"}


def against_words(name: str) -> str:
    """The words of a chooser and of an axis for `name`, its unit behind two blanks: "current i_eps  A"."""
    if name in OWN:
        return translated(name)
    channel, _, unit = name.partition("  ")
    return f"{translated(BY_UNIT.get(unit, 'channel {0}')).format(channel)}  {unit}".rstrip()
