"""A passphrase in the memory of labcal reaches no core dump."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

CANARY = "c4nary in the mine"
ABORTED = """
import os, sys
from pathlib import Path
from labcal.certificate.keys import new_key, open_key
kept = sys.argv[1] == "opens a key"
secret = os.environ["LABCAL_PASSPHRASE"]
if kept:
    new_key(Path("home"), "ada", secret)
    open_key(Path("home"), "ada", secret)
os.abort()
"""


def dumped(folder: Path, what: str) -> list[Path]:
    """The core dumps that a process which then aborts leaves in `folder`."""
    folder.mkdir()
    environment = {**os.environ, "LABCAL_PASSPHRASE": CANARY}
    words = ["bash", "-c", 'ulimit -c unlimited; exec "$@"', "bash", sys.executable, "-c", ABORTED, what]
    done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == -6, done.stderr
    return [path for path in folder.iterdir() if path.is_file()]


@pytest.mark.skipif(sys.platform != "linux", reason="core dumps are looked at where Linux leaves them")
def test_a_process_that_opened_a_key_leaves_no_core_dump(tmp_path: Path) -> None:
    before = dumped(tmp_path / "before", "opens none")
    if not before:
        pytest.skip("core dumps are off here, or go elsewhere (kernel.core_pattern)")
    assert any(CANARY.encode() in path.read_bytes() for path in before)
    assert dumped(tmp_path / "after", "opens a key") == []


@pytest.mark.skipif(sys.platform != "linux", reason="prctl is Linux's")
@pytest.mark.parametrize(
    "holds",
    [
        "from labcal.cli.keys import passphrase; passphrase('?')",
        "from labcal.certificate.pkcs8 import unlocked; unlocked(b'-----BEGIN ENCRYPTED PRIVATE KEY-----', 'x')",
        "from labcal.session.opened_archive import archive_address; archive_address('postgresql://a:b@h/d')",
        "import sys; sys.argv = ['labcal', 'nothing']; from labcal.cli import main; main()",
    ],
)
def test_who_holds_a_secret_may_not_be_dumped_even_to_a_pipe(holds: str) -> None:
    program = f"""
import contextlib, ctypes
with contextlib.suppress(Exception, SystemExit):
    {holds}
print(ctypes.CDLL(None).prctl(3, 0, 0, 0, 0))
"""
    environment = {**os.environ, "LABCAL_PASSPHRASE": CANARY}
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["0"]
