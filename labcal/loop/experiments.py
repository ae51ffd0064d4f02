"""What could be measured next, and which of it tells two explanations apart on the fitted model."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Experiment:
    """Something that the lab can do; a procedure may run it (`procedure` its name and the values it is given)."""

    do: str  # one sentence for the technician
    separates: tuple[tuple[str, str], ...] = ()  # pairs of effect ids that no fit of the same run tells apart
    procedure: str | None = None
    person: bool = False  # mounting, heating and switching stay a person's steps


TWINS: tuple[tuple[str, str, str], ...] = (
    (
        "offset-temperature",
        "offset-drift",
        "warm the sensor and let it cool again: a drift does not come back",
    ),
    ("offset-channel", "offset-drift", "let the channel return to its first value and repeat the first segment"),
    ("offset-current", "offset-drift", "switch the load off and on twice: a drift does not follow it"),
    ("offset-step", "offset-drift", "repeat the first segment twice, an hour apart"),
    ("offset-step", "offset-mode", "switch the power mode back and forth and see whether the offset follows"),
    ("offset-temperature", "gain-temperature", "warm the sensor in a large field and again with the coils at zero"),
    ("lag", "hysteresis", "turn at half and at twice the rate: a lag grows with the rate, hysteresis does not"),
    ("offset-current", "offset-current-squared", "draw three or more levels of the current at one attitude"),
    ("cage-field", "field-gradient", "repeat at another coil field: a gradient grows with it, a fixed field does not"),
    ("cage-field", "reference-drift", "compare the reference with a second one before and after"),
    ("axis-tilt", "field-gradient", "mount the device turned by 180° about the platform axis and repeat"),
    ("nonlinearity", "cross-field", "step the field along one axis alone, then along two together"),
    (
        "dut-dipole-at-reference",
        "field-gradient",
        "repeat in two coil fields: a moment does not grow with them",
    ),
)


def between(first: str, second: str) -> str | None:
    """The step that tells two effects apart, where one is known."""
    for a, b, do in TWINS:
        if {a, b} == {first, second}:
            return do
    return None
