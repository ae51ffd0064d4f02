"""A preflight on real lines whose program is killed, and resumed by another program to its very end."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from short_preflight import SHORT

from labcal.record.stream import Step
from labcal.store import Store

LABCAL = [sys.executable, "-c", "from labcal.cli import main; main()"]
STEPS = ("zero", "axes-check", "sync-check", "mount-z", "z+20uT-nominal", "closure-z", "closing")


@contextmanager
def served(bench: Path) -> Iterator[Path]:
    """The emulated instruments of `bench` on ports and ptys, from a process of their own."""
    out = bench.with_name("served.toml")
    words = ["bench", "serve", str(bench), "--out", str(out)]
    with subprocess.Popen([*LABCAL, *words], stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            assert any("ready" in line for line in process.stdout)
            yield out
        finally:
            process.terminate()


class Technician:
    """Runs `labcal run …` on a terminal of its own, answers every question by its first choice; `sees` each step."""

    def __init__(self, sees: Callable[[str, subprocess.Popen[str]], None] = lambda step, run: None) -> None:
        self._sees, self.asked = sees, list[str]()

    def run(self, *words: str) -> tuple[int, str, str]:
        """Exit code, what it said at its end on stdout, and on stderr."""
        mine, its = os.openpty()
        told = list[str]()
        with subprocess.Popen(
            [*LABCAL, "run", *words, "--progress", "json"],
            stdin=its, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        ) as process:  # fmt: skip
            assert process.stderr is not None
            assert process.stdout is not None
            for line in process.stderr:
                told.append(line)
                self._notice(line, mine, process)
            said = process.stdout.read()
        os.close(mine)
        os.close(its)
        return process.returncode, said, "".join(told)

    def _notice(self, line: str, terminal: int, process: subprocess.Popen[str]) -> None:
        _, found, text = line.partition('{"item": ')
        item = json.loads(found + text) if found else {}
        if item.get("item") == "prompt":
            self.asked.append(item["key"])
            os.write(terminal, ((item["choices"] or ["seen"])[0] + "\n").encode())
        if item.get("item") == "step":
            self._sees(item["name"], process)


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo terminals, which Windows does not have")
def test_a_run_on_real_lines_that_was_killed_is_resumed_to_its_end(bench_file: Callable[..., Path]) -> None:
    chance = random.Random()
    at, later_s = chance.choice(STEPS), chance.uniform(0.0, 2.0)

    def kill(step: str, process: subprocess.Popen[str]) -> None:
        if step == at:
            time.sleep(later_s)
            process.kill()

    with served(bench_file()) as bench:
        where = ["--bench", str(bench)]
        chosen = [word for key, value in SHORT.items() for word in ("--set", f"{key}={value}")]
        code, _, told = Technician(kill).run("preflight", *where, *chosen)
        assert code == -9, told
        with Store.open() as store:
            (run,) = store.runs()
            before, status = list(store.items(run.run_id)), store.status(run.run_id)
        assert status == "interrupted", (at, later_s)
        person = Technician()
        code, said, told = person.run("--resume", run.run_id, *where)
        assert (code, said) == (0, f"{run.run_id}\n"), (at, later_s, told)
        assert "finished; coils at zero" in told
        assert person.asked[0] == "mounting-stands"
    with Store.open() as store:
        assert store.status(run.run_id) == "finished"
        after = list(store.items(run.run_id))
    steps = [i.name for i in after[len(before) :] if isinstance(i, Step)]
    assert steps[:3] == ["zero", "axes-check", "sync-check"]
    assert steps[-1] == "closing"
    assert [i.t_s for i in before if isinstance(i, Step)] == [
        i.t_s for i in after[: len(before)] if isinstance(i, Step)
    ]
