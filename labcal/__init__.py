"""labcal calibrates a magnetometer before it flies. A newcomer reads `labcal.session` first.

What a notebook needs is here (docs/api.md), and loaded when it is asked for: `import labcal` alone is light.
"""

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from labcal.version import __version__

if TYPE_CHECKING:
    from labcal.api import (
        Calibration,
        InputError,
        InstrumentError,
        close_loop,
        fit,
        load_calibration,
        load_run,
        run,
        verify,
    )

__all__ = [
    "Calibration",
    "InputError",
    "InstrumentError",
    "__version__",
    "close_loop",
    "fit",
    "load_calibration",
    "load_run",
    "run",
    "verify",
]


def _of_the_face(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module("labcal.api"), name)


if not TYPE_CHECKING:  # to a type checker the names above are all there is
    __getattr__ = _of_the_face


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


class Face(ModuleType):
    """`labcal.fit` is the function, also once the room of that name is loaded.

    The room is reached by `from labcal.fit import …`.
    """

    @property
    def fit(self) -> Any:
        """The public function."""
        return _of_the_face("fit")

    @fit.setter
    def fit(self, room: ModuleType) -> None:
        """The import system offers each room that it has loaded; this one is not taken."""


sys.modules[__name__].__class__ = Face
