"""One canary for each place where a secret is typed or configured: none is found again, wherever one looks.

Looked at are every file that labcal leaves (the data home, results, bundles, reports, the problem report), zips and
PDFs unpacked; what it prints; the catalogue and the server's log; and while it works, the command line of each
process and the environment of each that it starts.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import threading
import zipfile
import zlib
from base64 import b64encode
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from conftest import rows_of
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
from fleet import build
from postgres import Server, children_of

from labcal.certificate.keys import open_key
from labcal.files.home import home
from labcal.gui.ipc.lines import write_line
from labcal.gui.ipc.messages import Approve, Command, ListArchivedRuns, NewKey, Request, Sign
from labcal.gui.ipc.wire import Fault
from labcal.gui.problem_report import save_problem

TYPED, WRONG = "c4nary-typed in the window", "c4nary-wrong one typed"
GIVEN = {
    "LABCAL_PASSPHRASE": "c4nary-passphrase of a key",
    "PGPASSWORD": "c4nary-pg",
    "LABCAL_SMTP_PASSWORD": "c4nary-smtp",
    "LABCAL_WEBHOOK": "http://127.0.0.1:9/c4nary-hook",
    "AWS_SECRET_ACCESS_KEY": "c4nary-s3",
    "AWS_SESSION_TOKEN": "c4nary-token",
}
PROGRAM = """
import json, sys
from labcal.cli import execute
from labcal.system.private_memory import kept_private
if __name__ == "__main__":
    kept_private()
    codes = [execute(words) for words in json.loads(sys.argv[1])]
    print("codes", codes)
"""


@dataclass
class Watched:
    """What others could read of processes while they worked."""

    commands: set[bytes] = field(default_factory=set)
    environments: dict[bytes, bytes] = field(default_factory=dict)  # by the command line
    children: set[int] = field(default_factory=set)

    def look(self, first: int) -> None:
        """At a process, and at all that it has begun; a fork that is no program yet is still the one it came of."""
        todo = [(first, b"")]
        while todo:
            process, of = todo.pop()
            with suppress(OSError):
                command = Path(f"/proc/{process}/cmdline").read_bytes()
                self.commands.add(command)
                todo += [(child, command) for child in children_of(process)]
                if process != first and command not in (b"", of):
                    self.environments[command] = Path(f"/proc/{process}/environ").read_bytes()
                    self.children.add(process)


@contextmanager
def watched(process: int, into: Watched) -> Iterator[None]:
    over = threading.Event()

    def watch() -> None:
        while not over.wait(0.02):
            into.look(process)

    thread = threading.Thread(target=watch)
    thread.start()
    try:
        yield
    finally:
        over.set()
        thread.join()


def run(words: list[str], environment: dict[str, str], seen: Watched) -> str:
    """What it prints, on both streams."""
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=environment, text=True)
    with watched(process.pid, seen):
        return process.communicate()[0]


def ask_worker(commands: list[Command[Any]], environment: dict[str, str], seen: Watched) -> tuple[list[str], str]:
    """How a worker of the window ends each command, in order, and all that it said."""
    words, pipe = [sys.executable, "-P", "-m", "labcal.gui.ipc.worker"], subprocess.PIPE
    process = subprocess.Popen(words, stdin=pipe, stdout=pipe, stderr=subprocess.STDOUT, env=environment, text=True)
    assert process.stdin is not None
    assert process.stdout is not None
    ends, told = list[str](), ""
    with process, watched(process.pid, seen):
        for number, command in enumerate(commands, 1):
            process.stdin.write(write_line(Request(number, command)) + "\n")
            process.stdin.flush()
            while len(ends) < number:
                told += (line := process.stdout.readline())
                assert line, told
                if (said := json.loads(line) if line.startswith("{") else {}).get("is") in ("Done", "Failed"):
                    ends.append(said["is"])
        process.stdin.close()
        told += process.stdout.read()
    return ends, told


def everything_in(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Each file with its bytes, what is in zips, and the streams of PDFs."""
    for path in (path for path in folder.rglob("*") if path.is_file()):
        content = path.read_bytes()
        yield str(path), content
        if content.startswith(b"PK"):
            with zipfile.ZipFile(path) as packed:
                yield from ((f"{path}: {name}", packed.read(name)) for name in packed.namelist())
        if content.startswith(b"%PDF"):
            for stream in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL):
                with suppress(zlib.error):
                    yield f"{path}: a stream", zlib.decompress(stream)


def found_again(where: str, content: bytes) -> list[str]:
    """The canaries that are there, as they are or in base64."""
    coded = [secret for secret in (*GIVEN.values(), TYPED, WRONG, "c4nary-db") if b64encode(secret.encode()) in content]
    return [f"{where}: {one!r}" for one in (*re.findall(rb"c4nary-\w+", content), *coded)]


@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="process lists are looked at in /proc")
@pytest.mark.parametrize("whole", [False, pytest.param(True, marks=pytest.mark.slow)], ids=["short", "whole"])
def test_no_secret_is_found_again(postgres: Server, database: str, url: str, tmp_path: Path, whole: bool) -> None:
    """In short: wherever a secret goes, without what only reads and writes what lies there already."""
    fleet = build(tmp_path / "fleet", 2).parent
    cal, place = fleet / "cal-000.json", url.replace("//keeper@", "//keeper:c4nary-db@")
    environment = {**os.environ, **GIVEN, "LABCAL_ARCHIVE": place, "LABCAL_SMTP_USER": "ada"}
    mail = ["--mail", "a@example.org", "--smtp", "127.0.0.1:9"]
    makes_a_key = [
        ["import", str(fleet / "run-000")],
        ["fit", "fleet-0", "--method", "ml", "--out", str(cal), "--force"],
        ["keys", "new", "--name", "ada"],
        ["approve", str(cal), "--as", "ada"],
    ]
    signs = [
        ["sign", str(cal), "--key", "ada"],
        ["verify", str(cal)],
        ["push"],
        ["push", str(fleet / "run-001"), "--bundles", "s3://nowhere"],
        ["archive", "runs", "--archive", "postgresql://keeper@127.0.0.1:9/nowhere"],
        ["watch", str(fleet), "--once", "--out", str(tmp_path / "watched"), *mail],
        ["audit", "--json", str(tmp_path / "audit.json")],
    ]
    more = [
        ["report", str(cal), "--out", str(tmp_path / "cal.pdf")],
        ["report", str(cal), "--out", str(tmp_path / "cal.html")],
        ["push", str(cal)],
        ["archive", "check"],
        ["study", str(fleet / "study.toml"), "--processes", "2", "--out", str(tmp_path / "study")],
        ["export", "fleet-0", "--format", "bundle", "--out", str(tmp_path / "run.zip")],
        ["show", "fleet-0", "--json", str(tmp_path / "show.json")],
    ]
    seen = Watched()
    printed = ""
    for commands in (makes_a_key, signs, *([more] if whole else [])):
        printed += run([sys.executable, "-c", PROGRAM, json.dumps(commands)], environment, seen)
    codes = [json.loads(line) for line in re.findall("^codes (.*)", printed, re.MULTILINE)]
    assert codes == [[0, 0, 0, 0], [0, 0, 0, 2, 2, 2, 0], *([[0] * len(more)] if whole else [])], printed
    assert len(seen.children) >= 2 or not whole  # the study's processes

    asked = [NewKey("typed", TYPED), Approve(str(fleet / "cal-001.json"), "typed"),
             Sign(str(fleet / "cal-001.json"), "typed", WRONG), Sign(str(fleet / "cal-001.json"), "typed", TYPED),
             ListArchivedRuns(place), ListArchivedRuns(place.replace("/lab", "/no_lab"))]  # fmt: skip
    quiet = {name: value for name, value in os.environ.items() if name not in GIVEN}
    ends, told = ask_worker(asked, quiet, seen)
    assert ends == ["Done", "Done", "Failed", "Done", "Done", "Failed"], told
    printed += told

    bench = tmp_path / "bench.toml"
    stated = f'# smtp_password: {GIVEN["LABCAL_SMTP_PASSWORD"]}\nlink = "tcp://a:c4nary-link@h:1"\ntoken = "c4nary-t"\n'
    bench.write_text(stated)
    fault = Fault("crash", f"no answer from {place}", "", f"connect({place!r}, password='c4nary-db')")
    save_problem(tmp_path / "problem.zip", fault, str(bench), [("connect", place)], simulated=False)
    bench.unlink()

    key = open_key(home(), "ada", GIVEN["LABCAL_PASSPHRASE"])
    raw = key.private_bytes(Encoding.Raw, PrivateFormat.Raw, NoEncryption())
    files = [*everything_in(home()), *everything_in(tmp_path)]
    kept = {path for path, _ in files}
    assert {str(home() / "audit.sqlite"), str(tmp_path / "problem.zip: bench.toml")} <= kept
    everywhere = [
        *files,
        ("printed", printed.encode()),
        ("catalogue", repr(rows_of(postgres, database)).encode()),
        ("server's log", (postgres.folder / "log").read_bytes()),
        *(("a command line", one) for one in seen.commands),
        *((f"the environment of {command!r}", one) for command, one in seen.environments.items()),
    ]
    assert [one for where, content in everywhere for one in found_again(where, content)] == []
    forms = (raw, b64encode(raw), raw.hex().encode())
    assert [where for where, content in everywhere if any(form in content for form in forms)] == []
