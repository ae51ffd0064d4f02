"""The lab as a procedure sees it: roles, the cage, the clock, and the file that says what stands where.

Its two classes are loaded when they are asked for: who only wants the coils off does not wait for them.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.bench.bench import Bench, open_bench
    from labcal.bench.cage import Cage

__all__ = ["Bench", "Cage", "open_bench"]


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module("labcal.bench.cage" if name == "Cage" else "labcal.bench.bench"), name)
