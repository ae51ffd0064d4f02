"""A driver and its emulator held to the house's promises, byte for byte, in a simulated lab."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from labcal.testing.drivers import every, interlocks, nonsense, stages, streams, supplies
from labcal.testing.drivers.rig import DriverCase, DriverRig, installed

Promise = Callable[[DriverCase], None]

__all__ = ["DriverCase", "DriverRig", "Promise", "check_driver", "installed", "keep", "promises"]


def check_driver(
    driver: Any,
    emulator: Any = None,
    *,
    forbidden: Sequence[bytes],
    settings: Mapping[str, Any] | None = None,
    to_panel: bytes = b"",
    resolution_A: float = 0.001,
    knows_its_place: bool = False,
) -> None:
    """Hold a driver to every promise of its roles (`DriverCase` says what the keywords are).

    `driver` is its name in bench.toml, where it is installed with its emulator, or its class with that of its
    emulator. Raises AssertionError with a sentence for the first promise that is broken.
    """
    stated: dict[str, Any] = {
        "forbidden": forbidden,
        "settings": settings or {},
        "to_panel": to_panel,
        "resolution_A": resolution_A,
        "knows_its_place": knows_its_place,
    }
    case = installed(driver, **stated) if isinstance(driver, str) else DriverCase(driver, emulator, **stated)
    for promise in promises(case):
        keep(promise, case)


def keep(promise: Promise, case: DriverCase) -> None:
    """Hold a driver to one promise; whatever it raises in the attempt breaks it."""
    try:
        promise(case)
    except AssertionError:
        raise
    except Exception as error:
        title = (promise.__doc__ or promise.__name__).splitlines()[0]
        text = f"{case.driver.__name__} raised {type(error).__name__} ({error}) where this is tried: {title}"
        raise AssertionError(f"{text} Find the cause at the end of the traceback.") from error


def promises(case: DriverCase) -> list[Promise]:
    """What a driver of these roles promises: functions of a case that raise AssertionError where it is broken."""
    roles = set(case.driver.roles)
    found: list[Promise] = [*every.PROMISES, *nonsense.PROMISES]
    found += supplies.PROMISES * ("coil" in roles)
    found += interlocks.PROMISES * ("interlock" in roles)
    found += stages.PROMISES * ("platform" in roles and bool(case.driver.motorised))
    found += streams.PROMISES * bool(roles & {"reference", "dut"})
    return found
