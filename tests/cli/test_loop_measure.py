"""What the loop proposes is a procedure that is installed."""

from __future__ import annotations

from dataclasses import make_dataclass
from importlib.metadata import entry_points
from typing import Any

from labcal import session
from labcal.loop import NextExperiment
from labcal.model.records import EffectRecord, Rival
from labcal.runner import procedures


def closed_with(effect: str, rival: str) -> Any:
    """As much of a closed loop as a proposal needs."""
    cause = EffectRecord(effect, (), {}, "sensor", (), rivals=(Rival(rival, (), 1.0),))
    kind = make_dataclass("Closed", ["accepted", "next_experiment"])
    return kind((cause,), NextExperiment("they do as well", "turn faster", None))


def test_the_rivals_choose_the_procedure_that_separates_them() -> None:
    assert session.with_installed_procedure(closed_with("lag", "hysteresis")).next_experiment.procedure in (
        "rate-sweep",
        "reverse",
    )
    found = session.with_installed_procedure(closed_with("offset-current", "offset-drift"))
    assert found.next_experiment.procedure == "current-coupling"
    assert session.with_installed_procedure(closed_with("outliers", "saturation")).next_experiment.procedure is None


def test_every_pair_names_effects_that_there_are() -> None:
    known = {entry.name for entry in entry_points(group="labcal.effects")}
    assert {e for p in procedures().values() for pair in p.separates for e in pair} <= known
