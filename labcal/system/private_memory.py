"""A process that holds a secret keeps its memory to itself: no core dump, and no other process reads it."""

from __future__ import annotations

import sys
from contextlib import suppress

_PR_SET_DUMPABLE = 4  # prctl(2)


def kept_private() -> None:
    """From now on this process leaves no core dump, whoever collects them.

    On Linux no other process of this user then reads its memory or the environment it was started with; children
    that are other programs are as before. Elsewhere than on Linux the limit on the size of a dump stands alone, and
    on Windows nothing is done.
    """
    if sys.platform == "win32":
        return
    import resource

    with suppress(ValueError, OSError):
        resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_DUMPABLE, 0, 0, 0, 0)  # a limit alone stops no piped dump
