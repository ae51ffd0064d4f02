"""What others hold their own parts to: a driver with its emulator, a procedure, an effect, an estimator, a page.

Each `check_…` is a plain function that raises AssertionError with a sentence that says what to do. Each is loaded when
it is first asked for: none of them needs what another is for, and only `check_page` needs Qt.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.testing.drivers import check_driver
    from labcal.testing.effects import check_effect
    from labcal.testing.estimators import check_estimator
    from labcal.testing.pages import check_page
    from labcal.testing.procedures import check_procedure

__all__ = ["check_driver", "check_effect", "check_estimator", "check_page", "check_procedure"]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"labcal.testing has no {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(f"{__name__}.{name.removeprefix('check_')}s"), name)
