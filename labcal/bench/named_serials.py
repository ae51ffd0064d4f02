"""Which serial each instrument of a bench is stated to have, and who names another one."""

from __future__ import annotations

from labcal.bench.bench import Bench
from labcal.bench.config import BenchConfig
from labcal.bench.serials import is_another
from labcal.record.stream import OTHER_SERIAL, Event


def stated_serial(config: BenchConfig, instrument: str) -> str:
    """As the [[equipment]] of that name states it; "" where none does."""
    return next((one.serial or "" for one in config.equipment if one.name == instrument), "")


def other_serials(bench: Bench) -> list[Event]:
    """An event for each instrument that named another serial than is stated, the run's for the DUT.

    A simulated DUT is whichever is asked for.
    """
    config = bench.config
    found = []
    for name, who in bench.known.items():
        is_dut = config.instruments[name].role == "dut"
        stated = "" if is_dut and config.unreal else bench.dut_serial if is_dut else stated_serial(config, name)
        if is_another(who.serial, stated):
            where = "this run is of" if is_dut else "bench.toml states"
            said = f"{name} names itself {who.serial}, and {where} {stated}"
            found.append(
                Event(
                    bench.clock.now(), OTHER_SERIAL, said, {"instrument": name, "named": who.serial, "stated": stated}
                )
            )
    return found
