"""A cause for a technician: what happens, in plain words; its id is what files and commands call it. No widgets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from labcal.gui.translations.sentences import in_words
from labcal.gui.viewmodels.study import cause_name
from labcal.model.records import EffectRecord, Rival

Cause = EffectRecord | Rival


def in_plain_words(one: Cause, phrases: Mapping[str, str]) -> str:
    """What happens, with its channels: "the gain changes with temperature (T_box)"; its id where nothing is said."""
    said = phrases.get(one.effect) or one.effect
    return cause_name(said if said == one.effect else in_words(said), one.channels)


def id_beside(one: Cause, phrases: Mapping[str, str]) -> str:
    """Its id, which stands beside plain words; "" where it stands in their place."""
    return "" if phrases.get(one.effect, one.effect) == one.effect else one.effect


def with_id(one: Cause, phrases: Mapping[str, str]) -> str:
    """Both in one line: "the gain changes with temperature (T_box) – gain-temperature"."""
    return " – ".join(filter(None, (in_plain_words(one, phrases), id_beside(one, phrases))))


def ids_beside(causes: Sequence[Cause], phrases: Mapping[str, str]) -> str:
    """Those of several, each once."""
    return ", ".join(dict.fromkeys(filter(None, (id_beside(one, phrases) for one in causes))))
