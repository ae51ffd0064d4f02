"""The window, watched: where it breaks off, what it said and where it stood are kept, and it is started again there.

A person who closes it, or a system that ends it (SIGTERM, SIGINT, SIGHUP), is obeyed. A run goes on in its own process
while its window is started again, and goes to zero, to be gone on with, where none comes back.
"""

from __future__ import annotations

import json
import os
import platform
import re
import signal
import subprocess
import sys
import threading
import time
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from labcal.files.atomic import write_bytes
from labcal.files.confidential import without_secrets
from labcal.files.home import ARCHIVE, FILE, for_children, home, own_folder
from labcal.system import run_door
from labcal.system.qt_packages import QT_PACKAGES

WINDOW = (sys.executable, "-P", "-m", "labcal.gui")
CLOSED, CANNOT = 0, 2  # by a person; and said in one sentence why not
WANTED = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGINT", "SIGHUP") if hasattr(signal, name))
AT_ONCE_S, TRIES = 20.0, 3  # broken off so often within so long of its start it is not started again
LOG_BYTES = 200_000  # of the end of what it said
NO_SCREEN = "no Qt platform plugin could be initialized"
NO_ANSWER = re.compile(r"could not connect to display *(\S*)")  # as Qt says it once all of its libraries are loaded
PACKAGES = ("labcal", "PySide6-Essentials", "pyqtgraph", "numpy", "scipy")


@dataclass(frozen=True, slots=True)
class WindowEnd:
    """How the window ended: exit code (below zero: a signal's number), what it said, where it stood."""

    code: int
    log: str
    state: dict[str, Any]
    lived_s: float

    @property
    def worker(self) -> int:
        """The process of the run that went on when the window ended; 0 where none did."""
        run = self.state.get("run")
        worker = run.get("worker") if isinstance(run, dict) else 0
        return worker if type(worker) is int else 0

    @property
    def broke_off(self) -> bool:
        """Whether nobody wanted it."""
        return self.code not in (CLOSED, CANNOT, *(-number for number in WANTED)) and NO_SCREEN not in self.log


def watch(given: Sequence[str], say: Callable[[str], None], command: Sequence[str] = WINDOW) -> int:
    """Run the window until it is closed; returns its exit code, 2 where it breaks off again and again at once."""
    again: tuple[str, ...] = ()
    soon = 0
    while (ended := once([*command, *given, *again])).broke_off:
        report = keep_report(ended)
        soon = soon + 1 if ended.lived_s < AT_ONCE_S else 0
        if soon == TRIES:
            run_door.send_to_its_end(ended.worker)
            say(f"labcal gui: the window broke off {soon} times as soon as it was open; please report it with {report}")
            return CANNOT
        say(f"labcal gui: the window broke off ({how(ended.code)}) and is started again; kept: {report}")
        again = (
            "--after-crash",
            str(report),
            "--page",
            str(ended.state.get("page", "")),
            "--worker",
            str(ended.worker),
        )
    run_door.send_to_its_end(ended.worker)
    if NO_SCREEN in ended.log:
        say(f"labcal gui: {no_screen(ended.log, os.environ)}")
        return CANNOT
    if ended.log.strip():
        say(ended.log.strip())
    return ended.code if ended.code >= 0 else 128 - ended.code


def no_screen(log: str, environment: Mapping[str, str]) -> str:
    """Why Qt has no screen, by what it said: the display does not answer, none is named, or libraries are missing."""
    if found := NO_ANSWER.search(log):
        display = found[1] or environment.get("DISPLAY", "")
        if display:
            return f"the screen {display} (DISPLAY) does not answer: start it, or name another one"
        return "there is no screen: DISPLAY names none, as over ssh without -X; start a desktop, or name one"
    return f"Qt reaches no screen; on Debian: apt-get install {' '.join(QT_PACKAGES)}"


def once(command: Sequence[str]) -> WindowEnd:
    """Run the window once; Ctrl-C reaches it too, and it is waited for."""
    begun = time.monotonic()
    with TemporaryDirectory(prefix="labcal-window-") as place:
        state, log = Path(place) / "state.json", Path(place) / "log.txt"
        environment = {**for_children(), "PYTHONFAULTHANDLER": "1"}
        url = os.environ.get(ARCHIVE, "")
        words = [*command, "--state", str(state), *(["--archive"] if url else [])]
        with log.open("wb") as said:
            process = subprocess.Popen(words, stdin=subprocess.PIPE if url else None, stderr=said, env=environment)
            with _passed_on_to(process):
                _tell(process, url)
                code = _waited_for(process)
        return WindowEnd(code, without_secrets(_end_of(log)), _read(state), time.monotonic() - begun)


def _waited_for(process: subprocess.Popen[bytes]) -> int:
    while True:
        with suppress(KeyboardInterrupt):
            return process.wait()


@contextmanager
def _passed_on_to(process: subprocess.Popen[bytes]) -> Iterator[None]:
    """Whoever ends `labcal gui` by its name means the window, which is not left without its watch (but by SIGKILL)."""

    def pass_on(number: int, _: object) -> None:
        process.send_signal(number)

    heard = [number for number in WANTED if signal.getsignal(number) is signal.SIG_DFL]  # nohup has SIGHUP ignored
    heard = heard if threading.current_thread() is threading.main_thread() else []
    for number in heard:
        signal.signal(number, pass_on)
    try:
        yield
    finally:
        for number in heard:
            signal.signal(number, signal.SIG_DFL)


def _tell(process: subprocess.Popen[bytes], url: str) -> None:
    """The archive's URL, which may state a password, goes by the window's standard input, for nobody else to read."""
    if process.stdin is not None:
        with suppress(OSError), process.stdin as line:  # a window that is gone already needs none
            line.write(f"{url}\n".encode())


def keep_report(ended: WindowEnd) -> Path:
    """Keep one .zip: what it said, where it stood, the guardian's last lines, versions. No key, no passphrase."""
    folder = own_folder(own_folder(home()) / "crashes")
    report = folder / f"window-{datetime.now(UTC):%Y%m%dT%H%M%S.%fZ}.zip"
    about = {
        "ended": how(ended.code),
        "lived_s": round(ended.lived_s, 1),
        "python": sys.version,
        "system": platform.platform(),
        "packages": {name: _version(name) for name in PACKAGES},
    }
    packed = BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("crash.json", json.dumps(about, indent=1))
        archive.writestr("state.json", without_secrets(json.dumps(ended.state, indent=1)))
        archive.writestr("log.txt", ended.log)
        archive.writestr("guardian.log", without_secrets(_end_of(home() / "guardian.log")))
    write_bytes(report, packed.getvalue(), FILE)
    return report


def how(code: int) -> str:
    """In words."""
    if code >= 0:
        return f"exit {code}" if code < 1 << 31 else f"code {code:#x}"
    try:
        return signal.Signals(-code).name
    except ValueError:
        return f"signal {-code}"


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "not installed"


def _end_of(path: Path) -> str:
    try:
        with path.open("rb") as file:
            file.seek(max(0, path.stat().st_size - LOG_BYTES))
            return file.read().decode(errors="replace")
    except OSError:
        return ""


def _read(path: Path) -> dict[str, Any]:
    try:
        said = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return said if isinstance(said, dict) else {}
