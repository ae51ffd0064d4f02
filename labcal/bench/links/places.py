"""Where locks and sockets lie: in a folder of this user's alone, or in that of the group that `[safety]` names.

No environment variable has a say in it: two processes of one user, or of one group, must come to the same place. A
folder under /run/user would go with the last log-out, which a guardian outlives.
"""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from labcal.errors import InputError

SHARED = (Path("/tmp"), Path("/var/tmp"))  # by name, not by TMPDIR; whoever may write there cannot remove another's
OF_GROUPS = Path("/run")
OWN, OF_GROUP = 0o600, 0o660  # modes of files and sockets


@dataclass(frozen=True, slots=True)
class Group:
    """A group whose members find each other's locks in `folder`."""

    name: str
    gid: int
    folder: Path


_met: list[Group] = []


def meet(group: str | None, runtime: str | None = None) -> None:
    """From now on locks and sockets lie in the folder of `group`, `runtime` or /run/labcal-GROUP.

    Without a group they lie in this user's own; so they do where this raises InputError: the group or its folder is
    not there, or not as it must be, or this user is not in it.
    """
    _met.clear()
    if group is not None:
        _met.append(_entered(_group(group, runtime)))


def runtime_folder() -> Path:
    """The folder of sockets and locks."""
    return _met[0].folder if _met and _fault(_met[0]) is None else own_folder()


def group() -> Group | None:
    """The group that the runtime folder is of; None where it is this user's own."""
    return _met[0] if _met and _fault(_met[0]) is None else None


def belongs(file: int | Path) -> None:
    """Make a file or socket in the runtime folder this user's alone, or its group's."""
    if sys.platform == "win32":
        return
    of = group()
    if of is not None:
        os.chown(file, -1, of.gid)
    os.chmod(file, OWN if of is None else OF_GROUP)


if sys.platform != "win32":
    import grp
    import pwd

    def own_folder() -> Path:
        """The folder of this user alone: the first of its places that is, else the first that can be made.

        What somebody else made under that name, a folder or a link, is passed by. The last place is a new one, which
        no other process finds: without agreement, but `labcal bench off` goes on.
        """
        places = list(_own_places())
        for place in places:
            if _is_own(place):
                return place
        for place in places:
            with suppress(OSError):
                place.mkdir(mode=0o700)
            if _is_own(place):
                return place
        return _nowhere_else()

    def folders() -> list[Path]:
        """Every runtime folder that this user may look into; an administrator's look goes into those of all users."""
        of_groups = [path for path in _called_ours(OF_GROUPS) if _may_enter(path)]
        bases = SHARED if os.getuid() == 0 else ()
        of_users = [path for base in bases for path in _called_ours(base) if _is_of_its_user(path)]
        return list(dict.fromkeys([runtime_folder(), own_folder(), *of_groups, *of_users]))

    def user_name(uid: int) -> str:
        """A user's name, or the number where the computer knows none."""
        try:
            return pwd.getpwuid(uid).pw_name
        except KeyError:
            return str(uid)

    def user() -> int:
        """The number of this process' user."""
        return os.getuid()

    def _own_places() -> Iterator[Path]:
        for base in SHARED:
            with suppress(OSError):
                stands = base.stat()
                others_keep_off = not stands.st_mode & 0o022 or stands.st_mode & stat.S_ISVTX
                if stands.st_uid in (0, os.getuid()) and others_keep_off:
                    yield base.resolve() / f"labcal-{os.getuid()}"
        with suppress(KeyError):
            yield Path(pwd.getpwuid(os.getuid()).pw_dir) / ".labcal-run"

    def _is_own(folder: Path) -> bool:
        """Whether it is this user's; one whose mode has been loosened is this user's alone afterwards."""
        try:
            stands = folder.lstat()  # a link that somebody else laid is not followed
            if not stat.S_ISDIR(stands.st_mode) or stands.st_uid != os.getuid():
                return False
            if stat.S_IMODE(stands.st_mode) != 0o700:
                folder.chmod(0o700)
        except OSError:
            return False
        return True

    def _may_enter(folder: Path) -> bool:
        return os.access(folder, os.R_OK | os.W_OK | os.X_OK)

    def _called_ours(base: Path) -> list[Path]:
        """In order of their names; there may be thousands of others beside them, and this is asked at every poll."""
        with suppress(OSError):
            return [base / name for name in sorted(os.listdir(base)) if name.startswith("labcal-")]
        return []

    def _is_of_its_user(folder: Path) -> bool:
        if not folder.name.removeprefix("labcal-").isdecimal():
            return False
        with suppress(OSError):
            stands = folder.lstat()
            return stat.S_ISDIR(stands.st_mode) and folder.name == f"labcal-{stands.st_uid}"
        return False

    def _group(name: str, runtime: str | None) -> Group:
        try:
            gid = grp.getgrnam(name).gr_gid
        except KeyError:
            raise InputError(f"this computer has no group {name!r}") from None
        return Group(name, gid, Path(runtime) if runtime else OF_GROUPS / f"labcal-{name}")

    def _entered(of: Group) -> Group:
        if not os.path.lexists(of.folder):
            with suppress(OSError):  # whoever may, makes it
                of.folder.mkdir(mode=0o700)
                os.chown(of.folder, -1, of.gid)
                of.folder.chmod(0o2770)
        if (fault := _fault(of)) is not None:
            raise InputError(fault)
        return of

    def _fault(of: Group) -> str | None:
        """Why this is not the group's folder, with what an administrator does about it; None where it is."""
        try:
            stands = of.folder.lstat()
        except FileNotFoundError:
            return f"{of.folder} is not there; an administrator makes it, once: {_command(of)}"
        except OSError as error:
            return f"{of.folder} cannot be looked at ({error.strerror})"
        alone = stat.S_ISDIR(stands.st_mode) and stands.st_gid == of.gid
        if not alone or stands.st_mode & 0o2077 != 0o2070:
            return f"{of.folder} is no folder of group {of.name} alone; an administrator removes it and makes it, " + (
                f"once: {_command(of)}"
            )
        if not _may_enter(of.folder):
            me = user_name(os.getuid())
            return (
                f"user {me} is not in group {of.name}, or was not at this log-in; an administrator says: "
                f"sudo usermod -aG {of.name} {me}, and {me} logs in again"
            )
        return None

    def _command(of: Group) -> str:
        kept = Path("/etc/tmpfiles.d")  # what makes it again at each start of the computer
        if of.folder.is_relative_to("/run") and kept.is_dir():
            file = kept / f"{of.folder.name}.conf"
            return (
                f"echo 'd {of.folder} 2770 root {of.name}' | sudo tee {file} && sudo systemd-tmpfiles --create {file}"
            )
        return f"sudo install -d -m 2770 -g {of.name} {of.folder}"

    @cache
    def _nowhere_else() -> Path:
        import tempfile

        return Path(tempfile.mkdtemp(prefix="labcal-"))
else:

    def own_folder() -> Path:
        """The folder of this user."""
        import tempfile

        folder = Path(tempfile.gettempdir()) / f"labcal-{os.environ.get('USERNAME', 'user')}"
        folder.mkdir(mode=0o700, exist_ok=True)
        return folder

    def folders() -> list[Path]:
        """The one that there is."""
        return [own_folder()]

    def _entered(of: Group) -> Group:
        return of

    def _fault(of: Group) -> str | None:
        return None

    def _group(name: str, runtime: str | None) -> Group:
        raise InputError("Windows has no such groups; leave it out")

    def user() -> int:
        """0: Windows counts its users otherwise."""
        return 0

    def user_name(uid: int) -> str:
        """A number; Windows counts its users otherwise."""
        return str(uid)
