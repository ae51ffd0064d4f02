"""Two homes push into one archive at once: all of both is there, once, and pushed again nothing changes."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import rows_of
from made_lab import signed_calibrations, stored_runs
from postgres import Server

from labcal import audit
from labcal.session import archiving

CALIBRATIONS = 4
MINE = {"aalto": range(6), "glasgow": range(4, 10)}  # numbers of runs: two have the same name and rows in both
KEYS = {"run": 2, "kept_head": 2, "calibration": 2, "instrument": 3, "effect": 3, "parameter": 3, "document": 3}


@pytest.fixture
def homes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[str, Path]:
    """Of two labs: runs, calibrations signed by keys of their own, a report beside each, and an audit log."""
    made = {site: tmp_path / site for site in MINE}
    for site, home in made.items():
        monkeypatch.setenv("LABCAL_HOME", str(home))
        stored_runs(MINE[site], 50)
        signed_calibrations(CALIBRATIONS)
        for file in (home / "calibrations").glob("*.json"):
            file.with_suffix(".html").write_text(f"<p>{file.stem} of {site}")
        audit.append(home, "trust", "ada", {"of": site})
    return made


def pushed_at_once(pushes: list[tuple[Path, str]]) -> list[str]:
    """What `labcal push` of each home to its URL says, the processes begun together."""
    processes = [
        subprocess.Popen(
            [sys.executable, "-m", "labcal", "push", "--archive", url],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env={**os.environ, "LABCAL_HOME": str(home)},
        )
        for home, url in pushes
    ]  # fmt: skip
    told = [process.communicate()[0] for process in processes]
    assert [process.returncode for process in processes] == [0] * len(pushes), told
    return [one.splitlines()[-1].partition("new there ")[2] for one in told]


def logs(server: Server, database: str) -> dict[str, list[tuple[int, bytes, bytes]]]:
    """Of each site its log's entries, in order, as they lie there."""
    found: dict[str, list[tuple[int, bytes, bytes]]] = {}
    for row in rows_of(server, database)["audit"]:
        number, entry, signature = row[3], row[8], row[9]
        assert isinstance(number, int)
        assert isinstance(entry, bytes)
        assert isinstance(signature, bytes)
        found.setdefault(str(row[0]), []).append((number, entry, signature))
    return {site: sorted(entries) for site, entries in found.items()}


def test_two_sites_at_once(homes: dict[str, Path], postgres: Server, database: str, url: str) -> None:
    pushes = [(home, url.replace("site=aalto", f"site={site}")) for site, home in homes.items()]
    begun = {site: len(audit.stored(home)) for site, home in homes.items()}
    for said, site in zip(pushed_at_once(pushes), MINE, strict=True):
        entries = begun[site] + 6 + CALIBRATIONS  # each that is new in the archive is an entry too
        assert said == f"6 runs, {CALIBRATIONS} calibrations, {entries} entries of the audit log"
    there = rows_of(postgres, database)
    for name, width in KEYS.items():
        keys = [row[:width] for row in there[name]]
        assert len(set(keys)) == len(keys) > 0, name
    for site in MINE:
        mine = {name: [row for row in rows if row[0] == site] for name, rows in there.items()}
        assert sorted(str(row[2]) for row in mine["run"]) == sorted(f"size-{n}" for n in MINE[site])
        assert (len(mine["calibration"]), len(mine["document"])) == (CALIBRATIONS, 2 * CALIBRATIONS)
        reports = {row[7].decode() for row in mine["document"] if row[3] == "report" and isinstance(row[7], bytes)}
        assert reports == {f"<p>years-{n} of {site}" for n in range(CALIBRATIONS)}
    assert logs(postgres, database) == {site: audit.stored(home) for site, home in homes.items()}
    assert set(pushed_at_once(pushes)) == {"0 runs, 0 calibrations, 0 entries of the audit log"}
    assert rows_of(postgres, database) == there
    assert archiving.check_archive(url, None) == []


@pytest.mark.slow
def test_two_machines_of_one_site_at_once(homes: dict[str, Path], postgres: Server, database: str, url: str) -> None:
    said = pushed_at_once([(home, url) for home in homes.values()])
    there = rows_of(postgres, database)
    names = sorted(str(row[2]) for row in there["run"])
    assert names == sorted(f"size-{n}" for n in range(10))  # what both have is one: it is the same bundle
    assert sum(int(one.split()[0]) for one in said) == 10
    assert len(there["calibration"]) == CALIBRATIONS  # the same files
    assert len({row[2] for row in there["document"] if row[3] == "signature"}) == 2 * CALIBRATIONS  # of two keys
    mine = {str(row[1]): str(row[0]) for row in there["audit"]}
    assert (len(mine), set(mine.values())) == (2, {"aalto"})  # logs of one site, each from its first entry to its last
    assert len(there["audit"]) == sum(len(audit.stored(home)) for home in homes.values())
    assert archiving.check_archive(url, None) == []
