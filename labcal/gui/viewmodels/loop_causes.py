"""Every cause that the loop looked at, with its standing and why. No widgets."""

from __future__ import annotations

from collections.abc import Callable

from labcal.gui.ipc.answers import Loop
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.loop_words import as_a_drop
from labcal.gui.viewmodels.study import cause_name
from labcal.model.records import EffectRecord, Rival

Cause = EffectRecord | Rival


def cause(effect: Cause) -> str:
    """An effect and its channels: "offset-current (i_radio)"."""
    return cause_name(effect.effect, effect.channels)


def candidates(loop: Loop, said: Callable[[str], str] = str) -> list[tuple[str, Cause, str]]:
    """Every cause there was: its standing, itself, and why, as it is `said`; the named ones first."""
    found: list[tuple[str, Cause, str]] = [
        ("accepted", effect, in_words(as_a_drop(said(effect.why)))) for effect in loop.accepted
    ]
    for effect in loop.accepted:
        found += [
            ("rival", rival, translated("does about as well as {0}").format(cause(effect))) for rival in effect.rivals
        ]
    return found + [("rejected", effect, in_words(said(effect.why))) for effect in loop.rejected]
