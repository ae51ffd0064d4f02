"""What the card above every page says of coils and platform, while coils are not confirmed at zero."""

from __future__ import annotations

from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.beside_coils import beside_coils
from labcal.gui.viewmodels.by_hand import pressed_words
from labcal.gui.viewmodels.field_witness import card_words
from labcal.gui.widgets.fault_card import FaultCard


def say_coils(card: FaultCard, app_state: AppState) -> None:
    """As they are known now."""
    known = beside_coils(app_state.lab.state.now), pressed_words(app_state.off.pressed)
    said = ". ".join(one.rstrip(".") for one in known if one)
    card.say_coils(app_state.coil_words(), app_state.by_hand(), said, pressed=bool(app_state.off.pressed))
    card.say_gravest(card_words(app_state.lab.state.now))
    card.say_not_read(app_state.off.not_read())
    card.say_platform(app_state.platform_words(), told=app_state.off.told)
