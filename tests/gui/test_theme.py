import pytest

from labcal.gui.numbers import duration, field, number
from labcal.gui.theme import DARK, LIGHT, contrast


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
@pytest.mark.parametrize("ink", ["text", "muted", "accent", "good", "warning", "bad", "axis_x", "axis_y", "axis_z"])
def test_every_ink_can_be_read_on_every_ground(theme, ink):
    for ground in ("page", "surface", "sunken"):
        assert contrast(getattr(theme, ink), getattr(theme, ground)) >= 4.5, (ink, ground)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
def test_marks_can_be_read_on_their_own_colour(theme):
    assert contrast(theme.on_accent, theme.accent) >= 4.5
    assert contrast(theme.surface, theme.warning) >= 4.5
    assert contrast(theme.surface, theme.bad) >= 4.5


def test_contrast_of_black_on_white_is_the_standard_s_21():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)


def test_numbers_have_one_format():
    assert number(19998.72) == "+19\u202f998.7"
    assert number(-3.25, 2) == "\u22123.25"
    assert field(-19998.7, "µT") == "\u221219.9987"
    assert field(100.0, "mG") == "+1.000"
    assert (duration(400), duration(4000)) == ("06:40", "1:06:40")
