"""Memory that a long computation has let go of is given back to the system: a process that stays would keep it."""

from __future__ import annotations

import gc
import sys
from contextlib import suppress


def give_back_memory() -> None:
    """Collect what is in cycles, and have the allocator return its free pages where it can (glibc's malloc_trim(3)).

    The search of the loop works in several threads, each of which has an arena of its own: hundreds of MB stay there.
    """
    gc.collect()
    if sys.platform == "linux":
        import ctypes

        with suppress(AttributeError):  # a C library without it
            ctypes.CDLL(None).malloc_trim(0)
