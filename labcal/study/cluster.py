"""The other engine: the workers of a Dask cluster, whose scheduler brings a lost worker's jobs to another."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

from labcal.errors import InputError
from labcal.study.job import Job, Row
from labcal.study.work import work

MISSING = "--scheduler needs the extra `cluster`: pip install 'labcal[cluster]'"
CONNECT_S = 15
KEPT = "what was done is kept, the same command goes on with it"


def on_cluster(jobs: Sequence[Job], address: str, on_remark: Callable[[str], None]) -> Iterator[tuple[Job, Row]]:
    """Each job with its row, as they are done. Raises what a job raised, and InputError where the cluster is gone."""
    try:
        import distributed
        from distributed.comm.core import CommClosedError
    except ImportError:
        raise InputError(MISSING) from None
    client = _connected(distributed, address)
    try:
        _say_who_works(client, on_remark)
        yield from _as_done(distributed, client, jobs)
    except distributed.KilledWorker as error:
        raise InputError(f"workers ended again and again while they were at a job ({error}); {KEPT}") from None
    except (CommClosedError, distributed.client.FutureCancelledError, TimeoutError, OSError) as error:
        raise InputError(f"the scheduler at {address} is gone ({type(error).__name__}); {KEPT}") from None
    finally:
        client.close(timeout=2)


def _as_done(distributed: Any, client: Any, jobs: Sequence[Job]) -> Iterator[tuple[Job, Row]]:
    """The scheduler keeps no row after it was fetched."""
    named = {f"labcal-{job.key}": job for job in jobs}
    futures = client.map(on_worker, jobs, key=list(named), pure=True)
    for future in distributed.as_completed(futures, loop=client.loop):
        row = future.result()
        future.release()
        yield named[future.key], row


def on_worker(job: Job) -> Row:
    """`work`, with one thread of linear algebra however the worker was started."""
    from threadpoolctl import threadpool_limits

    with threadpool_limits(1):
        return work(job)


def _connected(distributed: Any, address: str) -> Any:
    try:
        return distributed.Client(address, timeout=CONNECT_S, set_as_default=False)
    except ValueError as error:
        raise InputError(f"--scheduler {address}: is no address such as tcp://127.0.0.1:8786 ({error})") from None
    except (OSError, TimeoutError) as error:
        said = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(f"no scheduler answers at {address} ({said}); start one: dask scheduler") from None


def _say_who_works(client: Any, on_remark: Callable[[str], None]) -> None:
    workers = client.scheduler_info(n_workers=-1)["workers"]
    if not workers:
        on_remark("The cluster has no worker yet; jobs wait for one (dask worker ADDRESS --nthreads 1).")
    if crowded := [name for name, worker in workers.items() if worker["nthreads"] > 1]:
        on_remark(
            f"{len(crowded)} workers have several threads and do one job at a time: start them with --nthreads 1."
        )
