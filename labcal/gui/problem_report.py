"""The problem report: one .zip with what a developer asks for first, and no key, secret or recording in it."""

from __future__ import annotations

import json
import platform
import sys
import zipfile
from dataclasses import asdict
from importlib.metadata import version
from io import BytesIO
from pathlib import Path

from labcal.files.atomic import write_bytes
from labcal.files.confidential import without_secrets
from labcal.files.outputs import claim
from labcal.gui.ipc.wire import Fault

PACKAGES = ("labcal", "PySide6-Essentials", "pyqtgraph", "numpy", "scipy")


def save_problem(
    out: Path, fault: Fault | None, bench: str, steps: list[tuple[str, str]], simulated: bool | None
) -> None:
    """Write fault, versions, bench file and steps to `out`, which a dialogue has asked for. Raises InputError."""
    [output] = claim("problem report", out, inputs=[Path(bench)] if bench else (), force=True)
    about = {
        "fault": asdict(fault) if fault is not None else None,
        "steps": steps,
        "simulated": simulated,
        "python": sys.version,
        "system": platform.platform(),
        "packages": {name: version(name) for name in PACKAGES},
    }
    packed = BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("problem.json", without_secrets(json.dumps(about, indent=1, default=str)))
        if bench and Path(bench).is_file():
            text = Path(bench).read_text(encoding="utf-8", errors="replace")
            archive.writestr("bench.toml", without_secrets(text))
    with output.writing():
        write_bytes(out, packed.getvalue())
