"""A DUT that names another serial than that of the run: asked about before it is mounted first, once."""

from __future__ import annotations

from labcal.bench.bench import Bench
from labcal.bench.named_serials import other_serials
from labcal.errors import InputError
from labcal.record.stream import Item, Prompt

KEY = "another-dut"
MOUNTS = "body_from_cage"  # in the drawing of a question to mount
NO, YES = "no", "yes"  # the first is what nobody's answer is: then nothing is measured


class AnotherDut:
    """Of one run. Where no driver reads a serial, or it is the one that is stated, nothing is asked."""

    def __init__(self) -> None:
        self._looked, self._said = False, ""

    def question(self, bench: Bench, item: Item) -> Prompt | None:
        """What is to be answered before `item`, the first question to mount; None before any other."""
        if self._looked or not isinstance(item, Prompt) or MOUNTS not in item.drawing:
            return None
        self._looked = True
        roles = {name: one.role for name, one in bench.config.instruments.items()}
        for found in other_serials(bench):
            if roles[found.data["instrument"]] == "dut":
                self._said = found.text
                text = f"{found.text}. Measure it as {found.data['stated']} all the same?"
                return Prompt(bench.clock.now(), KEY, text, (NO, YES))
        return None

    def take(self, answer: str | None) -> None:
        """Raises InputError where it is not to be measured."""
        if answer != YES:
            raise InputError(f"{self._said}: nothing was measured. Say which DUT it is, and begin anew.")
