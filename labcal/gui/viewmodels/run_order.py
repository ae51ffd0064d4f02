"""What a worker is told to run, for the DUT and the operator at the top. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QSettings

from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.lab import LabState


def run_order(procedure: str, given: dict[str, str], bench: str, state: LabState, settings: QSettings) -> RunProcedure:
    """`procedure` on `bench` with what is `given`, at the simulated pace that was chosen."""
    seed, pace = settings.value("seed"), str(settings.value("pace", "20 times"))
    return RunProcedure(
        procedure, bench, given, state.dut_serial, state.operator, pace, int(str(seed)) if seed else None
    )
