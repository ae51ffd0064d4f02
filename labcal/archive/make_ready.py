"""`python -m labcal.archive.make_ready RUN`: a run that has ended made ready for the next push, after everybody else.

A process of its own, which says nothing: where it cannot, the push does it.
"""

from __future__ import annotations

import shutil
import sys
from contextlib import closing, suppress

from labcal.errors import InputError, InstrumentError
from labcal.files.home import home
from labcal.system.workers import stand_back

LEAST_FREE = 2**32  # bytes of the disk that are left to runs
LARGEST = 2**27  # bytes of a run in the store: 1 GB of memory


def main(run_id: str) -> None:
    """Make one run ready, where neither disk nor memory is needed by others."""
    stand_back()  # before what takes long to load
    from labcal.archive import ready
    from labcal.archive.run_to_push import of_store
    from labcal.store import Store
    from labcal.store.listing import FILE as STORE

    with suppress(OSError, InputError, InstrumentError):
        with closing(Store.read_only(home() / STORE)) as store:
            size = store.stored_bytes(run_id)
        if size <= LARGEST and shutil.disk_usage(ready.folder()).free >= LEAST_FREE + size:
            ready.keep(of_store(run_id))


if __name__ == "__main__":
    main(sys.argv[1])
