"""The independent lab's recordings as runs of labcal."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import wrong_lab
from trials import as_run

from labcal.record import Run


@pytest.fixture
def recorded() -> Callable[..., tuple[Run, wrong_lab.Recorded]]:
    """A run of the independent lab, and its truth."""

    def make(seed: int, declared: wrong_lab.Declared, **more: object) -> tuple[Run, wrong_lab.Recorded]:
        found = wrong_lab.record(seed, declared, **more)
        return as_run(found), found

    return make
