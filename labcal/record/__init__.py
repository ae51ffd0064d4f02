"""What was measured: a `Run` and what each of its segments offers an estimator.

Its names are loaded when they are asked for: who only lists runs does not wait for the arrays.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from labcal.record.administrative import Administrative
    from labcal.record.header import ChannelSpec, RunHeader
    from labcal.record.observation import Observation, carry, offers
    from labcal.record.run import Channel, Dut, Reference, Run, Segment
    from labcal.record.sampling import period_s
    from labcal.record.specification import Limit, Specification

__all__ = [
    "Administrative",
    "Channel",
    "ChannelSpec",
    "Dut",
    "Limit",
    "Observation",
    "Reference",
    "Run",
    "RunHeader",
    "Segment",
    "Specification",
    "carry",
    "offers",
    "period_s",
]
_OF_OTHERS = {
    "Administrative": "administrative",
    **dict.fromkeys(("ChannelSpec", "RunHeader"), "header"),
    **dict.fromkeys(("Observation", "carry", "offers"), "observation"),
    "period_s": "sampling",
    **dict.fromkeys(("Limit", "Specification"), "specification"),
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_OF_OTHERS.get(name, 'run')}"), name)
