"""A port that this user may not open: which group to join, in the words of whoever opens the link."""

import errno
import sys
from types import SimpleNamespace

import pytest

if sys.platform == "win32":
    pytest.skip("Windows asks for no permission of ports", allow_module_level=True)

from labcal.bench.links import permission
from labcal.bench.links.gone import not_open


@pytest.fixture
def port(tmp_path, monkeypatch):
    """A port of root and its group, which this user may not open; the group's number and its members can be changed."""
    path = tmp_path / "ttyUSB0"
    path.touch()
    said = SimpleNamespace(path=str(path), gid=20, mode=0o20660, members=["jane"])
    monkeypatch.setattr(permission.os, "access", lambda path, mode: False)

    def stat(path):
        if path != said.path:
            raise FileNotFoundError(errno.ENOENT, "unplugged", path)
        return SimpleNamespace(st_uid=0, st_gid=said.gid, st_mode=said.mode)

    monkeypatch.setattr(permission.os, "stat", stat)
    group = SimpleNamespace(gr_name="dialout", gr_mem=said.members)
    monkeypatch.setattr(permission.grp, "getgrgid", lambda number: group)
    monkeypatch.setattr(
        permission.pwd, "getpwuid", lambda number: SimpleNamespace(pw_name="root" if not number else "j")
    )
    monkeypatch.setattr(permission.os, "geteuid", lambda: 1000)
    return said


@pytest.mark.parametrize("scheme", ["serial", "modbus-rtu", "usbtmc"])
def test_who_may_not_open_a_port_is_told_which_group_to_join(port, scheme):
    denied = PermissionError(errno.EACCES, "Permission denied", port.path)
    error = not_open(f"{scheme}://{port.path}?baud=9600", denied)
    assert error.fault == "link lost"  # tried again after a replug: udev gives the group its right a moment later
    assert "this user may not open it" in str(error)
    assert error.remedy == f"{port.path} is for group dialout: `sudo usermod -aG dialout j`, then log out and in again."


def test_who_has_just_joined_is_told_to_log_in_again(port):
    port.members.append("j")
    assert permission.not_allowed(port.path).startswith("j is in group dialout, and this login does not know it yet")


@pytest.mark.parametrize(("gid", "mode"), [(0, 0o20660), (20, 0o20600), (20, 0o20640)])
def test_where_no_group_helps_none_is_named(port, gid, mode):
    port.gid, port.mode = gid, mode
    assert permission.not_allowed(port.path) == (
        f"{port.path} is for its owner alone (root); a udev rule can give it to a group."
    )


def test_what_fails_for_another_reason_is_told_as_before(port):
    denied = PermissionError(errno.EACCES, "Permission denied", "/dev/elsewhere")
    for error in (
        not_open("serial:///dev/elsewhere", denied),
        not_open(f"serial://{port.path}", OSError(errno.EIO, "")),
    ):
        assert "the link does not open" in str(error)


def test_a_port_that_may_be_opened_is_not_spoken_of(tmp_path):
    (tmp_path / "port").touch()
    assert permission.not_allowed(str(tmp_path / "port")) == permission.not_allowed(str(tmp_path / "none")) == ""
