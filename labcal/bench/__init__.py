"""The lab as a procedure sees it: roles, the cage, the clock, and the file that says what stands where.

`Bench`, `Cage` and `open_bench` are loaded when they are asked for: who only wants coils off does not wait for them.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.bench.bench import Bench
    from labcal.bench.coils.cage import Cage
    from labcal.bench.opening import open_bench

_IS_IN = {"Bench": "labcal.bench.bench", "Cage": "labcal.bench.coils.cage", "open_bench": "labcal.bench.opening"}

__all__ = ["Bench", "Cage", "open_bench"]


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in _IS_IN:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_IS_IN[name]), name)
