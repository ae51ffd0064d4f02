"""The mark before the name of a page says in its tooltip what it means, and what made it change by itself."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QAbstractButton
from test_path import path as path


def tip(window, page):
    found = (one for one in window.sidebar.findChildren(QAbstractButton) if one.text()[2:].strip() == page)
    return next(found).toolTip()


@pytest.mark.parametrize(
    ("ages", "said"),
    [
        ((3, 3), "✓ every instrument answered within the last 4 s"),
        ((3, 180), "● no answer within the last 4 s, for nobody asked: reference."),
        ((180, 180), "○ no instrument answered within the last 4 s; Read all asks them"),
    ],
)
def test_the_mark_of_the_bench_names_whoever_has_not_answered_just_now(still, path, ages, said):
    lab, names = still.app_state.lab, ("supply_x", "reference")
    lights = tuple((name, "old", "") for name in names)
    lab.update(now=replace(lab.state.now, lights=lights, heard_old_s=tuple(zip(names, ages, strict=True))))
    first, _, why = tip(still, "Bench").partition("\n")
    assert first == "Bench (Ctrl+2)"
    assert why.startswith(said)


def test_an_open_run_says_which_run_would_fill_it(still, path):
    still.app_state.path.take_runs(())
    assert "○ no run yet that this DUT can be calibrated by" in tip(still, "Run")
    assert "○ still to be done" in tip(still, "Fit")
