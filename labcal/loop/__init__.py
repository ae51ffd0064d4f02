"""Close the loop: residual → evidence → effect → refit → verdict.

Its names are loaded when they are asked for: who only reads results, or a run, does not wait for what finds effects.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.loop.close import close_loop
    from labcal.loop.result import ClosedLoop, Errors, NextExperiment, Pictures, Round
    from labcal.loop.single_effect import OneCause, one_cause

__all__ = ["ClosedLoop", "Errors", "NextExperiment", "OneCause", "Pictures", "Round", "close_loop", "one_cause"]
_OF_OTHERS = {"close_loop": "close", **dict.fromkeys(("OneCause", "one_cause"), "single_effect")}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_OF_OTHERS.get(name, 'result')}"), name)
