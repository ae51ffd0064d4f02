"""Row security: the server itself refuses what a lab's role may not do, whatever program asks."""

from __future__ import annotations

from itertools import count

import pytest
from conftest import Bundle
from postgres import Server

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.session import archiving

NUMBERS = count()


@pytest.fixture
def role(postgres: Server) -> str:
    """A role of the server that has no right yet."""
    name = f"person{next(NUMBERS)}"
    with postgres.connect() as connection:
        connection.execute(f"CREATE ROLE {name} LOGIN")
    return name


@pytest.fixture
def as_role(url: str, role: str) -> str:
    """The archive as that role finds it, without a site: its lab is the site."""
    return url.replace("//keeper@", f"//{role}@").replace("&site=aalto", "")


def granted(url: str, role: str, lab: str, may: str) -> None:
    assert labcal(["archive", "grant", role, "--lab", lab, "--may", may, "--archive", url]) == 0


def test_a_role_pushes_for_its_own_lab_and_sees_no_other(url: str, role: str, as_role: str, bundle: Bundle) -> None:
    archiving.push(url, [str(bundle())])
    with pytest.raises(InputError, match="permission denied"):
        archiving.push(as_role, [str(bundle())])
    granted(url, role, "glasgow", "push")
    assert archiving.push(as_role, [str(bundle("r2"))]).site == "glasgow"
    assert [one["run_id"] for one in archiving.archived_runs(as_role)] == ["r2"]
    [own] = [one for one in archiving.archived_runs(url) if one["site"] == "glasgow"]
    assert own["pushed_by"] == role
    granted(url, role, "aalto", "read")
    told = archiving.push(f"{as_role}&site=aalto", [str(bundle("r3"))]).refused
    assert "violates row-level security policy" in told[0]
    granted(url, role, "*", "read")
    assert len(archiving.archived_runs(as_role)) == 2
    for lab in ("*", "aalto", "glasgow"):
        granted(url, role, lab, "nothing")
    assert archiving.archived_runs(as_role) == []


@pytest.mark.parametrize(
    "deed",
    [
        "UPDATE labcal.{} SET site = site",
        "DELETE FROM labcal.{}",
        "TRUNCATE labcal.{}",
        "ALTER TABLE labcal.{} DISABLE ROW LEVEL SECURITY",
        "INSERT INTO labcal.member VALUES (CURRENT_USER, 'aalto', 'push')",
        "UPDATE labcal.setting SET value = '/elsewhere'",
    ],
)
def test_no_role_changes_a_row_not_even_of_its_own_lab(
    deed: str, postgres: Server, database: str, url: str, role: str, bundle: Bundle
) -> None:
    from psycopg.errors import InsufficientPrivilege

    archiving.push(url, [str(bundle())])
    granted(url, role, "aalto", "push")
    with postgres.connect(database, role) as connection:
        assert connection.execute("SELECT count(*) FROM labcal.run").fetchone() == (1,)
        for table in ("run", "instrument", "calibration", "parameter", "document", "audit"):
            with pytest.raises(InsufficientPrivilege):
                connection.execute(deed.format(table))


def test_nobody_adds_rows_under_another_s_name_or_lab(postgres: Server, database: str, url: str, role: str) -> None:
    from psycopg.errors import InsufficientPrivilege

    granted(url, role, "glasgow", "push")
    row = "'{site}', 'ab', 'r', now(), 'finished', true, 'S', 'M', 'nT', '', '', 'none', '', 0, NULL, '', 0, now(), "
    row += "'{by}'"
    with postgres.connect(database, role) as connection:
        for site, by in (("aalto", role), ("glasgow", "keeper")):
            with pytest.raises(InsufficientPrivilege, match="row-level security"):
                connection.execute(f"INSERT INTO labcal.run VALUES ({row.format(site=site, by=by)})")
        for table, rest in (("kept_head", "'h', 's'"), ("audit", "'l', 'h', 1, '', '', '', '', '', ''")):
            with pytest.raises(InsufficientPrivilege, match="row-level security"):
                connection.execute(f"INSERT INTO labcal.{table} VALUES ('aalto', {rest})")
        connection.execute(f"INSERT INTO labcal.run VALUES ({row.format(site='glasgow', by=role)})")


def test_a_group_s_right_is_its_members(postgres: Server, url: str, role: str, as_role: str, bundle: Bundle) -> None:
    with postgres.connect() as connection:
        connection.execute(f"CREATE ROLE {role}_group")
        connection.execute(f"GRANT {role}_group TO {role}")
    granted(url, f"{role}_group", "aalto", "push")
    assert archiving.push(as_role, [str(bundle())]).site == "aalto"
    granted(url, role, "glasgow", "push")
    with pytest.raises(InputError, match=r"may push for aalto, glasgow: `\?site=LAB`"):
        archiving.push(as_role, [])


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["nobody-here", "--lab", "a", "--may", "read"], "has no role 'nobody-here'"),
        (["keeper", "--lab", "*", "--may", "push"], "can be read and not pushed to"),
        (["keeper", "--lab", " ", "--may", "read"], "a lab has a name"),
    ],
)
def test_a_right_that_cannot_be_given_is_refused(
    words: list[str], told: str, url: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["archive", "grant", *words, "--archive", url]) == 2
    assert told in capsys.readouterr().err
