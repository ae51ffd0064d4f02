"""Who may open a device: why this user may not, and what they do about it."""

from __future__ import annotations

import os
import sys
from contextlib import suppress

if sys.platform != "win32":
    import grp
    import pwd
    import stat

    def not_allowed(port: str) -> str:
        """What this user does to be allowed to open the device `port`; "" where they may, or there is no such file."""
        try:
            found = os.stat(port)
        except (OSError, ValueError):  # unplugged meanwhile, or no file at all
            return ""
        if os.access(port, os.R_OK | os.W_OK):
            return ""
        group, user = _group(found.st_gid), _user()
        if found.st_gid == 0 or found.st_mode & (stat.S_IRGRP | stat.S_IWGRP) != stat.S_IRGRP | stat.S_IWGRP:
            return f"{port} is for its owner alone ({_owner(found.st_uid)}); a udev rule can give it to a group."
        if user in _members(found.st_gid):
            return f"{user} is in group {group}, and this login does not know it yet: log out and in again."
        return f"{port} is for group {group}: `sudo usermod -aG {group} {user}`, then log out and in again."

    def _user() -> str:
        with suppress(KeyError):
            return pwd.getpwuid(os.geteuid()).pw_name
        return str(os.geteuid())

    def _owner(number: int) -> str:
        with suppress(KeyError):
            return pwd.getpwuid(number).pw_name
        return str(number)

    def _group(number: int) -> str:
        with suppress(KeyError):
            return grp.getgrgid(number).gr_name
        return str(number)

    def _members(number: int) -> list[str]:
        with suppress(KeyError):
            return grp.getgrgid(number).gr_mem
        return []
else:

    def not_allowed(port: str) -> str:
        """Nothing: Windows asks for no permission of ports."""
        return ""
