"""What labcal makes in its folder is its user's alone, whatever the umask, and nobody else makes a dead run alive."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import cli, session
from labcal.bench.guardian import logbook
from labcal.errors import InstrumentError
from labcal.files.home import for_children, own_folder
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import Store
from labcal.store.photos import keep_photo

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))
posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no modes")


@pytest.fixture
def wide_open() -> Iterator[None]:
    """A umask under which everything would be everybody's."""
    before = os.umask(0)
    yield
    os.umask(before)


def begun(store: Store) -> None:
    with store.begin(HEADER) as writer:
        writer.write(Event(0.0, "note", "a"))


def fault_of_ours(*_: object, **__: object) -> None:
    raise RuntimeError("x")


@posix
@pytest.mark.usefixtures("wide_open")
def test_folders_are_0700_and_files_0600_whatever_the_umask(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = tmp_path / "a" / "b" / "labcal"
    monkeypatch.setenv("LABCAL_HOME", str(home))
    with Store.open() as store, store.begin(HEADER) as writer:
        writer.write(Event(0.0, "note", "a"))
        writer.commit()
        (tmp_path / "p.jpg").write_bytes(b"\xff\xd8\xff")
        keep_photo(tmp_path / "p.jpg")
        session.new_key("ada", "correct horse")
        logbook.note("hello")
        assert logbook.written(30.0)
        monkeypatch.setattr(cli, "app", fault_of_ours)
        assert cli.execute(["runs"]) == 2
        modes = {str(path.relative_to(home)): mode_of(path) for path in [home, *home.rglob("*")]}
    assert {"store.sqlite-wal", "store.sqlite-shm", "store.sqlite-writers/r1.lock"} <= set(modes)
    assert {"keys/ada.pem", "keys/allowed_signers", "photos", ".", "guardian.log", "last-fault.txt"} <= set(modes)
    wrong = {name: oct(mode) for name, mode in modes.items() if mode != (0o700 if (home / name).is_dir() else 0o600)}
    assert not wrong


@posix
def test_what_was_made_open_is_closed_when_its_owner_opens_it(home_of_its_own: Path) -> None:
    with Store.open() as store:
        begun(store)
        loose = [home_of_its_own, store.path, *home_of_its_own.rglob("*")]
        for path in loose:
            path.chmod(0o755 if path.is_dir() else 0o644)
    with Store.open() as store:
        store.begin(replace(HEADER, run_id="r2")).finish("stopped")
        assert [oct(mode_of(p)) for p in (home_of_its_own, store.path)] == ["0o700", "0o600"]
        assert mode_of(store.path.with_name("store.sqlite-writers")) == 0o700


@posix
def test_a_folder_that_others_share_is_left_to_them(tmp_path: Path) -> None:
    shared = tmp_path / "shared"
    shared.mkdir()
    shared.chmod(0o1777)
    own_folder(shared)
    assert mode_of(shared) == 0o1777
    chosen = tmp_path / "chosen"
    chosen.mkdir(mode=0o755)
    Store.open(chosen / "s.sqlite").close()  # a folder that somebody named is theirs, the store in it is not
    assert [oct(mode_of(p)) for p in (chosen, chosen / "s.sqlite")] == ["0o755", "0o600"]


@posix
@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root may become another user")
def test_another_user_reads_nothing_and_locks_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for folder in (tmp_path, *tmp_path.parents[:2]):
        folder.chmod(0o755)  # so that only labcal's own modes are in the way
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "labcal"))
    with Store.open() as store:
        begun(store)
        lock = store.lock_file("r1")
        for path in (store.path, lock, tmp_path / "labcal"):
            assert "Permission denied" in as_nobody(path)
        (tmp_path / "labcal").chmod(0o755)
        lock.parent.chmod(0o755)
        for path in (store.path, lock):
            assert "Permission denied" in as_nobody(path), "the file itself is closed too"


@posix
@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root may become another user")
@pytest.mark.parametrize(("mode", "made"), [(0o555, False), (0o555, True)])
def test_a_store_that_may_not_be_written_is_a_sentence(tmp_path: Path, mode: int, made: bool) -> None:
    for folder in (tmp_path, *tmp_path.parents[:2]):
        folder.chmod(0o755)
    place = tmp_path / "place"
    place.mkdir()
    if made:
        Store.open(place / "s.sqlite").close()
        (place / "s.sqlite").chmod(0o444)
    place.chmod(mode)
    program = "from pathlib import Path; from labcal.store import Store; import os; os.setgid(65534); os.setuid(65534)"
    told = subprocess.run(
        [sys.executable, "-c", f"{program}; Store.open(Path({str(place / 's.sqlite')!r}))"],
        capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2],
    ).stderr.splitlines()[-1]  # fmt: skip
    assert told.startswith("labcal.errors.InputError: ")
    assert "the store cannot be opened or written" in told


def as_nobody(path: Path) -> str:
    """What another user is told who opens `path` for reading, which is all that a lock needs."""
    program = "import os, sys; os.setgid(65534); os.setuid(65534); (os.listdir if path[-1] == '/' else open)(path)"
    named = f"path = {str(path) + '/' * path.is_dir()!r}; {program}"
    return subprocess.run([sys.executable, "-c", named], capture_output=True, text=True, check=False).stderr


DIES = """
import os, sys
from labcal.store import Store
from labcal.record import Dut, Reference, RunHeader
writer = Store.open().begin(RunHeader("r1", "2026-03-02T08:15:00Z", True, "", Dut("SN1"), Reference("none")))
writer.commit()
os._exit(9)
"""
HOLDS = """
import fcntl, sys
file = open(sys.argv[1])
fcntl.flock(file, fcntl.LOCK_EX)
print("held", flush=True)
sys.stdin.read()
"""


@contextmanager
def held_by_a_stranger(path: Path) -> Iterator[None]:
    with subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "held\n"
        yield
        holder.communicate()


@posix
def test_a_lock_that_a_stranger_holds_makes_no_dead_run_alive() -> None:
    subprocess.run([sys.executable, "-W", "ignore", "-c", DIES], check=False)
    with Store.open() as store:
        lock = store.lock_file("r1")
        with held_by_a_stranger(lock):
            assert store.status("r1") == "interrupted"
            with pytest.raises(InstrumentError, match="locked by a program that is no writer"):
                store.resume("r1")
        store.resume("r1").finish("finished")


@posix
def test_a_number_that_another_process_has_now_is_not_the_writer() -> None:
    with Store.open() as store:
        begun(store)
        lock = store.lock_file("r1")
        pid, ticks, host = lock.read_text().split()
        assert int(pid) == os.getpid()
        if ticks == "-":
            pytest.skip("this system does not tell when a process began")
        with held_by_a_stranger(lock):
            from labcal.store.liveness import is_alive

            assert is_alive(lock)  # this very process, which it names, lives
            lock.write_text(f"{pid} {int(ticks) + 1} {host}")
            assert not is_alive(lock)
            lock.write_text(f"{pid} {int(ticks) + 1} elsewhere")
            assert is_alive(lock), "of another computer's processes nothing is known here"
            lock.write_text("")
            assert is_alive(lock), "a writer of an earlier version names nobody"


def test_no_process_that_labcal_starts_is_told_the_passphrase(monkeypatch: pytest.MonkeyPatch) -> None:
    from labcal.cli.keys import passphrase

    monkeypatch.setenv("LABCAL_PASSPHRASE", "secret")
    monkeypatch.setenv("KEPT", "1")
    assert "LABCAL_PASSPHRASE" not in for_children()
    assert for_children()["KEPT"] == "1"
    assert passphrase("?") == "secret"
    assert "LABCAL_PASSPHRASE" not in os.environ


STARTS = ("Popen(", "subprocess.run(", "QProcess(")
CLEAN = ("for_children()", "_environment()")


def test_every_place_that_starts_a_process_gives_it_a_clean_environment() -> None:
    import labcal

    root = Path(labcal.__file__).parent
    starting = {
        str(path.relative_to(root)): path.read_text(encoding="utf-8")
        for path in root.rglob("*.py")
        if any(word in path.read_text(encoding="utf-8") for word in STARTS)
    }
    assert starting
    assert not [name for name, text in starting.items() if not any(word in text for word in CLEAN)]


def mode_of(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)
