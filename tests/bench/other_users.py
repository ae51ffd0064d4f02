"""Work done as other users of the computer: a child that loads what it needs as root, and then is somebody else."""

from __future__ import annotations

import atexit
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import Any

import pytest

ALICE, BOB, CARL = 40_001, 40_002, 40_003
OF_ROOT = pytest.mark.skipif(
    sys.platform != "linux" or os.geteuid() != 0, reason="needs root, to be several users in turn"
)
NURSERY = """
import json, os, pty, signal, socket, sys, tempfile, time, traceback
from pathlib import Path
import numpy as np
from labcal.bench.guardian import client, logbook, memory, server, wire
from labcal.bench.links import devices, holders, locks, open_link, places, ports
from labcal.bench.clock import RealClock
from labcal.errors import InputError, InstrumentError
import labcal.bench.off, multiprocessing, encodings.idna

def become(uid, groups, common, group, env, work):
    os.setgroups(groups); os.setresgid(uid, uid, uid); os.setresuid(uid, uid, uid)
    os.umask(0o077)  # whatever a user has, the group gets in
    os.environ.update(env)
    places.SHARED, tempfile.tempdir = (Path(common),), common
    exec(work, globals() | {"common": common, "group": group, "runtime": os.path.join(common, "of-group")})

def say(what): print(json.dumps(what), flush=True)

open_link("manual://", RealClock())
signal.signal(signal.SIGCHLD, signal.SIG_IGN)
asked = socket.socket(fileno=0)
asked.send(b"ready")
while True:
    told, ends, _, _ = socket.recv_fds(asked, 65536, 3)
    if not told: break
    if child := os.fork():
        for end in ends: os.close(end)
        asked.send(str(child).encode())
        continue
    for number, end in enumerate(ends): os.dup2(end, number); os.close(end)
    try: become(*json.loads(told))
    except SystemExit: pass
    except BaseException: traceback.print_exc()
    os._exit(0)
"""


@contextmanager
def common_folder() -> Iterator[Path]:
    """A place like /tmp, of its own."""
    folder = Path(tempfile.mkdtemp(prefix="labcal-test-", dir="/tmp"))
    folder.chmod(0o1777)
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def some_group() -> tuple[str, int]:
    """A group of this computer that is not root's."""
    import grp

    found = next(one for one in grp.getgrall() if one.gr_gid > 0)
    return found.gr_name, found.gr_gid


def group_folder(common: Path) -> Path:
    """What an administrator makes once."""
    folder = common / "of-group"
    folder.mkdir()
    os.chown(folder, -1, some_group()[1])
    folder.chmod(0o2770)
    return folder


@cache
def nursery() -> socket.socket:
    """A process that has loaded everything, and makes one child after another."""
    here, there = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    _children.append(subprocess.Popen([sys.executable, "-c", NURSERY], stdin=there))
    there.close()
    assert here.recv(16) == b"ready"
    atexit.register(here.close)
    return here


_children: list[subprocess.Popen[bytes]] = []


class User:
    """A child that is another user and does `work`, Python text; it lives until it is killed."""

    def __init__(self, uid: int, common: Path, work: str, *, member: bool = True, env: dict[str, str] | None = None):
        name, gid = some_group()
        told = json.dumps([uid, [gid] if member else [], str(common), name, env or {}, work])
        theirs_in, self._in = os.pipe()
        out, theirs_out = os.pipe()
        err, theirs_err = os.pipe()
        socket.send_fds(nursery(), [told.encode()], [theirs_in, theirs_out, theirs_err])
        for end in (theirs_in, theirs_out, theirs_err):
            os.close(end)
        self.pid = int(nursery().recv(16))
        self._out, self._err = os.fdopen(out), os.fdopen(err)

    def says(self) -> Any:
        """The next thing that it says."""
        line = self._out.readline()
        assert line, self._err.read()
        return json.loads(line)

    def go_on(self) -> None:
        """Let it read a line."""
        os.write(self._in, b"\n")

    def kill(self) -> None:
        """As a power cut would; returns when it is gone."""
        with suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        self._err.read()

    def close(self) -> None:
        """Be gone."""
        self.kill()
        os.close(self._in)
        self._out.close()
        self._err.close()


@contextmanager
def user(uid: int, common: Path, work: str, **how: Any) -> Iterator[User]:
    """One that is gone at the end."""
    child = User(uid, common, work, **how)
    try:
        yield child
    finally:
        child.close()


def done(uid: int, common: Path, work: str, **how: Any) -> Any:
    """What one says who does this and is gone."""
    with user(uid, common, work, **how) as child:
        return child.says()
