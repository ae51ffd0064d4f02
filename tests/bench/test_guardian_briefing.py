"""A guardian needs nothing of its bench file once it was begun; one that cannot be found brings the coils to zero."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from served_lab import LABCAL, Served, Sessions, at_zero, children_of, guardians, log, until

from labcal.bench.config import read_config
from labcal.bench.guardian.briefing import LONGEST, Briefing, briefing_of
from labcal.bench.guardian.spawn import spawn
from labcal.bench.guardian.wire import fingerprint
from labcal.bench.links import ports

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL and ptys, which Windows lacks")


def killed_all() -> set[int]:
    """kill -9 of the guardian and of all that stand by it."""
    (first,) = guardians()
    until(lambda: len(children_of(first)) == 2)
    every = {*children_of(first), first}
    for pid in every:
        os.kill(pid, signal.SIGKILL)
    return every


def off(file: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*LABCAL, "bench", "off", str(file)], capture_output=True, text=True, check=False)


def test_a_briefing_is_the_bench_as_it_was_read(lab: Served) -> None:
    bench = Briefing(lab.file, read_config(lab.file), "abc")
    assert briefing_of(bench.line().decode()) == bench
    assert len(bench.line()) < LONGEST / 4
    assert briefing_of("") is briefing_of("\n") is briefing_of("[1]") is briefing_of('{"named": 1}') is None


def test_all_guardians_killed_while_the_file_is_gone_the_session_starts_another(lab: Served, session: Sessions) -> None:
    session("idle")
    lab.file.rename(lab.file.with_suffix(".away"))
    killed_all()
    until(lambda: at_zero(lab))
    lab.file.with_suffix(".away").rename(lab.file)


def test_who_stands_by_needs_no_file_either(lab: Served, session: Sessions) -> None:
    session("idle")
    (first,) = guardians()
    until(lambda: len(children_of(first)) == 2)
    before = set(children_of(first))
    lab.file.write_text("half [edited")
    for pid in before:
        os.kill(pid, signal.SIGKILL)
    until(lambda: len(set(children_of(first)) - before) == 2)
    until(lambda: "to zero" in log())
    os.kill(first, signal.SIGKILL)
    until(lambda: at_zero(lab))


@pytest.mark.parametrize("now", [pytest.param("gone", marks=pytest.mark.slow), "elsewhere"])
def test_off_by_a_link_that_leads_elsewhere_now(lab: Served, session: Sessions, tmp_path: Path, now: str) -> None:
    link, real = tmp_path / "link.toml", lab.file
    link.symlink_to(real)
    lab.file = link
    session("idle")
    link.unlink()
    if now == "elsewhere":
        (tmp_path / "half.toml").write_text("half [edited")
        link.symlink_to(tmp_path / "half.toml")
    done = off(link)
    assert at_zero(lab), done.stdout + done.stderr
    link.unlink(missing_ok=True)
    link.symlink_to(real)


def test_off_by_a_file_that_no_guardian_knows_names_the_bench_that_one_drives(lab: Served, session: Sessions) -> None:
    session("idle")
    other = lab.file.with_name("other.toml")
    other.write_text("half [edited")
    done = off(other)
    assert done.returncode == 2
    assert "a guardian drives the bench of" in done.stdout + done.stderr  # and perhaps another one, of a test beside
    assert str(lab.file) in done.stdout + done.stderr
    round_ = lab.file.with_name("round.toml")
    round_.symlink_to(round_)
    done = off(round_)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("what", ["lock", "socket"])
def test_one_that_cannot_be_found_any_more_brings_the_coils_to_zero(lab: Served, session: Sessions, what: str) -> None:
    session("idle")
    (first,) = guardians()
    folder = ports.runtime_folder()
    until(lambda: len(children_of(first)) == 2)
    cards = [card for card in ports.announced() if card.get("pid") == first]
    if what == "socket":
        Path(cards[0]["address"]).unlink()
    else:
        for path in folder.glob("port-*.lock"):
            if f'"pid": {first}' in path.read_text():
                path.unlink()
    until(lambda: at_zero(lab))
    assert "nobody could find it" in log()


def test_nothing_is_loaded_from_the_current_folder(
    lab: Served, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    trap, loaded = tmp_path / "trap", tmp_path / "loaded"
    trap.mkdir()
    for name in ("json", "serial", "labcal"):
        (trap / f"{name}.py").write_text(f"open({str(loaded)!r}, 'a').write({name!r})\nraise SystemExit\n")
    monkeypatch.chdir(trap)
    config = read_config(lab.file)
    child = spawn(Briefing(lab.file, config, fingerprint(lab.file)))
    until(lambda: any("address" in card for card in ports.announced() if card.get("pid") == child.pid))
    child.terminate()
    child.wait()
    assert not loaded.exists()


def test_a_pipe_is_no_bench_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "bench.toml")
    done = off(tmp_path / "bench.toml")
    assert done.returncode == 2
    assert "is not a regular file" in done.stdout + done.stderr
