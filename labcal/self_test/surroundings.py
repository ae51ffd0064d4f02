"""What this computer gives labcal: a folder, ports, a screen."""

from __future__ import annotations

import getpass
import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Iterable
from datetime import UTC, datetime
from glob import glob
from pathlib import Path
from tempfile import TemporaryFile

from labcal.bench.links.permission import not_allowed
from labcal.files.home import for_children, home, own_folder
from labcal.self_test.installed import python_version
from labcal.self_test.result import Check, Computer
from labcal.system.qt_packages import QT_PACKAGES
from labcal.version import __version__

PORTS = ("/dev/ttyUSB*", "/dev/ttyACM*", "/dev/usbtmc*")
ROOM_BYTES = 1 << 30  # a run of an hour at 1 kHz takes about a third of it
PATIENCE_S = 120.0
WINDOW = ("-P", "-m", "labcal.gui", "--once")


def computer() -> Computer:
    """What is qualified here, now."""
    return Computer(
        labcal=__version__,
        folder=Path(__file__).parents[1],
        python=python_version(),
        system=platform.platform(),
        machine=platform.node(),
        user=getpass.getuser(),
        when=datetime.now(UTC),
    )


def check_folder() -> Check:
    """Store, keys and settings have a place, and there is room."""
    place = own_folder(home())
    with TemporaryFile(dir=place) as file:
        file.write(b"labcal")
    free = shutil.disk_usage(place).free
    said = f"{place}, {free / 2**30:.0f} GiB free"
    if free < ROOM_BYTES:
        return Check("", "FAIL", said, "Make room: less than 1 GiB is no place for runs.")
    return Check("", "pass", said)


def check_ports(patterns: Iterable[str] = PORTS) -> Check:
    """This user may use the USB instruments that are plugged in."""
    ports = sorted(path for pattern in patterns for path in glob(pattern))
    if sys.platform == "win32":
        return Check("", "not shown", "Windows asks for no permission; a port is known to be usable when it is opened")
    if not ports:
        return Check("", "not shown", "no USB instrument is plugged in")
    closed = {port: said for port in ports if (said := not_allowed(port))}
    if closed:
        return Check("", "FAIL", f"this user may not open {', '.join(closed)}", next(iter(closed.values())))
    return Check("", "pass", f"this user may open {', '.join(ports)}")


def check_window(place: Path) -> Check:
    """The window opens with all its pages, on the screen where there is one."""
    place.mkdir(parents=True)
    picture, offscreen = place / "window.png", not has_screen()
    environment = {**for_children(), "LABCAL_HOME": str(place)}
    if offscreen:
        environment["QT_QPA_PLATFORM"] = "offscreen"
    done = subprocess.run(
        [sys.executable, *WINDOW, str(picture)], env=environment, capture_output=True, text=True, timeout=PATIENCE_S,
        errors="replace", check=False,
    )  # fmt: skip
    if done.returncode or not picture.is_file():
        said = (done.stderr.strip().splitlines() or ["it said nothing"])[-1]
        todo = "" if sys.platform == "win32" else f"On Debian: apt-get install {' '.join(QT_PACKAGES)}"
        return Check("", "FAIL", f"it ended with {done.returncode}: {said}", todo)
    where = "off screen, for there is no display here" if offscreen else "on this screen"
    return Check("", "pass", f"opened with all its pages, {where}", picture=picture.read_bytes())


def has_screen() -> bool:
    """Whether a window could be seen: by what the system's environment says."""
    wanted = os.environ.get("QT_QPA_PLATFORM", "")
    if wanted:
        return wanted not in ("offscreen", "minimal")
    return sys.platform in ("win32", "darwin") or any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))
