"""What was measured about one body axis, as the light of that axis looks at it."""

from __future__ import annotations

import re
from collections.abc import Mapping

from labcal.record.stream import Measurement

WORST = ("", "PASS", "CANNOT DECIDE", "MARGINAL", "FAIL")
AXIS_CHECKS = {  # what the light of an axis looks at, and how its measurements are named
    "coverage": "{axis}[+-].*: missing sectors",
    "noise": "{axis}[+-].*: noise",
    "sign": "{axis}[+-].*: wrong signs",
    "delay": "delay {axis}",
    "closure": "closure {axis}",
}
AT_A_CLOSURE = ("delay", "closure")  # of these, what a run looks at only where it closes the axis


def axis_checks(axis: str, measured: Mapping[str, Measurement], *, closes: bool = True) -> dict[str, str]:
    """The worst verdict of each of `AXIS_CHECKS` for one body axis; "" where nothing was measured yet.

    `closes`: the run closes this axis; another has no check of it that is to come.
    """
    patterns = {look: re.compile(pattern.format(axis=axis)) for look, pattern in AXIS_CHECKS.items()}
    found = {look: _worst(pattern, measured) for look, pattern in patterns.items()}
    return {look: verdict for look, verdict in found.items() if closes or verdict or look not in AT_A_CLOSURE}


def _worst(pattern: re.Pattern[str], measured: Mapping[str, Measurement]) -> str:
    about = [one.verdict for name, one in measured.items() if pattern.fullmatch(name)]
    return max(about, key=WORST.index, default="")
