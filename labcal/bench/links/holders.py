"""Who holds a lock, as the kernel knows it: which process, whose, which program, since when.

Nothing that anybody wrote is believed. Linux tells it in /proc; elsewhere nothing is known.
"""

from __future__ import annotations

import os
import socket
import struct
import sys
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from ipaddress import ip_address
from pathlib import Path

from labcal.bench.links import places

PROC = Path("/proc")
ESTABLISHED = "01"
SHOWN = 80  # characters of a command line


@dataclass(frozen=True, slots=True)
class Process:
    """A living process: its number, its user's number, what was typed to begin it, and when it began (UTC)."""

    pid: int
    uid: int
    program: str
    begun: datetime

    @property
    def whose(self) -> str:
        """' of user alice'; nothing where it is the user's own."""
        return "" if self.uid == places.user() else f" of user {places.user_name(self.uid)}"


def locker(path: Path | str) -> int | None:
    """The process that has locked this very file, by the kernel's own list; the file is not opened."""
    if sys.platform == "win32":
        return None
    try:
        stands = os.stat(path, follow_symlinks=False)
        listed = (PROC / "locks").read_text(encoding="utf-8")
    except (OSError, ValueError):
        return None
    place = f"{os.major(stands.st_dev):02x}:{os.minor(stands.st_dev):02x}:{stands.st_ino}"
    for words in map(str.split, listed.splitlines()):
        if "FLOCK" in words[1:2] and words[5:6] == [place]:
            return int(words[4])
    return None


def process(pid: int | None) -> Process | None:
    """What is known of a process; None where it is gone."""
    if pid is None:
        return None
    folder = PROC / str(pid)
    with suppress(OSError, ValueError, IndexError):
        words = (folder / "cmdline").read_bytes().decode("utf-8", "replace").split("\0")
        typed = " ".join([os.path.basename(words[0]), *words[1:]]).strip()
        return Process(pid, folder.stat().st_uid, typed[:SHOWN], _begun(folder))
    return None


def _begun(folder: Path) -> datetime:
    if sys.platform == "win32":
        raise OSError("Windows has no /proc")
    ticks = int((folder / "stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()[19])
    booted = next(line for line in (PROC / "stat").read_text(encoding="utf-8").splitlines() if line.startswith("btime"))
    return datetime.fromtimestamp(int(booted.split()[1]) + ticks / os.sysconf("SC_CLK_TCK"), UTC)


def users_of(device: str) -> set[int]:
    """The processes, as far as this user may look, that have this device open. No file is touched: one may hang."""
    found = set[int]()
    for file in PROC.glob("[0-9]*/fd/*"):
        with suppress(OSError):
            if os.readlink(file) == device:
                found.add(int(file.parts[2]))
    return found


def connected(host: str, port: int) -> set[int]:
    """The numbers of the users whose programs on this computer are connected to this place."""
    found = set[int]()
    with suppress(OSError, ValueError, IndexError):
        ends = {str(end[4][0]) for end in socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)}
        ends |= {f"::ffff:{address}" for address in ends if ":" not in address}
        places_there = {f"{_kernels(address)}:{port:04X}" for address in ends}
        for table in ("tcp", "tcp6"):
            for line in (PROC / "net" / table).read_text(encoding="utf-8").splitlines()[1:]:
                words = line.split()
                if words[3] == ESTABLISHED and words[2] in places_there:
                    found.add(int(words[7]))
    return found


def _kernels(address: str) -> str:
    """An address as /proc/net/tcp writes it: words of 32 bits, in this computer's order of bytes."""
    packed = ip_address(address).packed
    return "".join(f"{word:08X}" for word in struct.unpack(f"={len(packed) // 4}I", packed))
