"""A PostgreSQL of the tests' own: started by an ordinary user in a temporary folder, on a socket in it alone."""

from __future__ import annotations

import getpass
import os
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from psycopg import Connection

OWNER = "keeper"
WITHIN_S = 120  # for a server that never starts, not for a busy machine
NUMBERS = count()
SETTINGS = "-c listen_addresses= -c shared_buffers=16MB -c max_connections=30 -c autovacuum=off"
HASTY = "-F"  # it does not wait for the disk, for what is lost in tests is no loss


class NoServerError(Exception):
    """Why none can be started here."""


def programs() -> Path:
    """The folder of initdb and pg_ctl, the newest where there are several."""
    if found := shutil.which("initdb"):
        return Path(found).resolve().parent
    newest = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda one: int(one.parts[-3]))
    if not newest:
        raise NoServerError("PostgreSQL's server programs are not installed: 'sudo apt-get install postgresql'")
    return newest[-1].parent


def ordinary_user() -> str | None:
    """Who starts the server: None is whoever runs the tests; for root, whom it refuses, somebody else."""
    if os.name != "posix":
        raise NoServerError("the tests start PostgreSQL as POSIX systems do")
    if os.geteuid() != 0:
        return None
    import pwd

    names = {one.pw_name for one in pwd.getpwall()}
    found = next((name for name in ("postgres", "nobody") if name in names), None)
    if found is None:
        raise NoServerError("PostgreSQL refuses root, and there is no ordinary user here to start it")
    return found


@dataclass(frozen=True)
class Server:
    """A running server. Everybody on this machine who can enter its folder is whoever they say they are."""

    folder: Path
    programs: Path
    user: str | None = None
    settings: str = SETTINGS

    def control(self, *words: str | Path) -> None:
        """`pg_ctl`, as whoever the server belongs to."""
        done([self.programs / "pg_ctl", "-D", self.folder / "data", "-w", "-t", str(WITHIN_S), *words], self.user)

    def start(self) -> None:
        self.control("-l", self.folder / "log", "-o", f"{self.settings} -k {self.folder}", "start")

    def kill(self) -> None:
        """SIGKILL to the server and to each process that works for it, until none is left."""
        first = int((self.folder / "data" / "postmaster.pid").read_text().split()[0])
        left = {first, *children_of(first)}
        while left:
            for process in left:
                with suppress(ProcessLookupError):
                    os.kill(process, signal.SIGKILL)
            time.sleep(0.02)
            left = {one for one in left if Path(f"/proc/{one}").exists()}

    def url(self, database: str, user: str = OWNER) -> str:
        return f"postgresql://{user}@/{database}?host={self.folder}"

    def connect(self, database: str = "postgres", user: str = OWNER) -> Connection[tuple[object, ...]]:
        import psycopg

        return psycopg.connect(self.url(database, user), autocommit=True)

    def busy_s(self) -> float:
        """Processor time of the server and of all who asked it and have gone: whoever has not is waited for."""
        with self.connect() as connection:
            others = "SELECT count(*) FROM pg_stat_activity WHERE application_name = 'labcal'"
            while connection.execute(others).fetchone() != (0,):
                time.sleep(0.01)
        process = (self.folder / "data" / "postmaster.pid").read_text().split()[0]
        ticks = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[11:15]
        return sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK")

    def database(self) -> str:
        """A new database with nothing in it."""
        name = f"lab{next(NUMBERS)}"
        with self.connect() as connection:
            connection.execute(f"CREATE DATABASE {name}")
        return name


@contextmanager
def server(*, hasty: bool = True) -> Iterator[Server]:
    """Raises NoServerError."""
    settings = f"{HASTY} {SETTINGS}" if hasty else SETTINGS
    found, user = programs(), ordinary_user()
    folder = Path(tempfile.mkdtemp(prefix="labcal-pg-", dir="/tmp"))
    try:
        shutil.chown(folder, user or getpass.getuser())
        made = ["-U", OWNER, "-A", "trust", "-N", "--wal-segsize=1", "-E", "UTF8", "--locale=C"]
        done([found / "initdb", "-D", folder / "data", *made], user)
        running = Server(folder, found, user, settings)
        running.start()
        try:
            yield running
        finally:
            running.control("-m", "immediate", "stop")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def children_of(process: int) -> set[int]:
    """The processes that it began, by their ids."""
    found = set[int]()
    for status in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            if int(status.read_text().rpartition(")")[2].split()[1]) == process:
                found.add(int(status.parent.name))
    return found


def done(words: list[str | Path], user: str | None) -> None:
    told = subprocess.run(words, user=user, cwd="/", stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if told.returncode:
        raise NoServerError(f"{Path(words[0]).name}: {told.stdout[-300:]} {told.stderr[-300:]}")
