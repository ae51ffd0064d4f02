"""What has left the lab, and which runs are done with: kept by the window from one day to the next."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSettings

from labcal.gui.ipc.answers import CalibrationFile

MOST = 500  # of each are remembered


class HandedOut:
    """Files that were handed out as they stand, and runs after which the next DUT came."""

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings

    def add(self, one: CalibrationFile) -> None:
        """This file, with the signatures that it has."""
        self._keep("handed_out", _name(one))

    def take_folder(self, folder: str) -> None:
        """Where something was handed out last."""
        self._settings.setValue("handed_out_to", folder)

    def folder(self) -> str:
        """Where that was; "" where nothing was yet."""
        return str(self._settings.value("handed_out_to", "") or "")

    def holds(self, one: CalibrationFile) -> bool:
        """Whether it was handed out with all its signatures."""
        return _name(one) in self._kept("handed_out")

    def verify(self, one: CalibrationFile) -> None:
        """This file was checked as it stands, and holds."""
        self._keep("verified", _name(one))

    def verified(self, one: CalibrationFile) -> bool:
        """Whether it was checked with all its signatures."""
        return _name(one) in self._kept("verified")

    def close(self, run_id: str) -> None:
        """The DUT of this run is done with."""
        self._keep("closed_runs", run_id)

    def closed(self, run_id: str) -> bool:
        """Whether the next DUT came after this run."""
        return run_id in self._kept("closed_runs")

    def _kept(self, key: str) -> list[str]:
        return str(self._settings.value(key, "") or "").split("\n")

    def _keep(self, key: str, name: str) -> None:
        before = [one for one in self._kept(key) if one not in ("", name)]
        self._settings.setValue(key, "\n".join([*before, name][-MOST:]))


def _name(one: CalibrationFile) -> str:
    return f"{Path(one.path).name} {len(one.standing.signatures)}"
