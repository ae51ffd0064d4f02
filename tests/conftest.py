"""Fixtures that every room's tests share."""

from __future__ import annotations

import gc
import os
import shutil
import tempfile
from collections.abc import Generator, Iterator
from multiprocessing.util import get_temp_dir
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
os.environ.setdefault("PYSIDE6_OPTION_LAZY", "0")  # as labcal.gui sets it, but pytest-qt imports Qt before
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the commands do: threads cost more than small matrices are

# A property fails for what it says, never for how busy the machine is, and tries the same examples everywhere.
settings.register_profile("labcal", deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("labcal")

LONGEST = ("test_blind_short.py", "test_demo.py", "test_signed_lab.py")
WAITING = {"archive", "bench", "bundle", "campaign", "cli", "clients", "runner", "store", "study"}  # rooms


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """What is loaded by then is left alone by the collector: a third of the time of tests that compute."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest files first; then files that compute and files that wait for a line or a guardian, by turns.

    Of several processes none waits for a long file at the end, and while some wait the others compute.
    """
    files, place = list(dict.fromkeys(item.path for item in items)), dict[Path, float]()
    for waits in (True, False):
        of_kind = [path for path in files if bool(WAITING & set(path.parts)) is waits]
        place |= {path: number / len(of_kind) for number, path in enumerate(of_kind)}
    items.sort(key=lambda item: (item.path.name not in LONGEST, place[item.path]))


@pytest.fixture(autouse=True)
def collected_here() -> Iterator[None]:
    """A thread that serves a lab must not be the one in which a window of another test ends."""
    from labcal.system.garbage import collect_if_due

    yield
    collect_if_due()


@pytest.fixture(autouse=True)
def nobody_heard() -> None:
    """Ports and terminals are given out again: who answered at one in another test has not answered in this."""
    from labcal.bench.links import heard_before

    heard_before.forget()


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder of measured data and schemas beside the project; skips where it is absent."""
    folder = Path(__file__).resolve().parents[2] / "shared"
    if not folder.is_dir():
        pytest.skip("needs the folder `shared` beside the project (measured data and schemas), which is not here")
    return folder


@pytest.fixture(scope="session", autouse=True)
def runtime_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Temporary files lie in a folder of this run's; locks do on Windows alone: elsewhere no environment moves them."""
    tmp_path_factory.getbasetemp()
    get_temp_dir()  # multiprocessing's own is cleared away later than this folder
    folder = tempfile.mkdtemp(prefix="labcal-", dir="/tmp" if os.name == "posix" else None)
    before = os.nice(0) if os.name == "posix" else 0
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TMPDIR", folder)
        patch.setattr(tempfile, "tempdir", folder)
        yield
    shutil.rmtree(folder, ignore_errors=True)
    assert os.name != "posix" or os.nice(0) == before, "a test has put this process last in line: those after it wait"


@pytest.fixture(autouse=True)
def home_of_its_own(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Store, keys and settings of each test lie in a folder of its own."""
    home = tmp_path_factory.mktemp("home")
    monkeypatch.setenv("LABCAL_HOME", str(home))
    return home
