"""What a worker does with a job: the same on every engine, one at a time in a process, one thread of linear algebra."""

from __future__ import annotations

import math
import threading

from labcal.errors import InputError, InstrumentError, LimitNotMet
from labcal.study.job import Cell, Job, Row

_one_at_a_time = threading.Lock()  # the threads of a Dask worker share clocks, warnings and temporary files


def work(job: Job) -> Row:
    """The job's row. What a lab would have to live with, as a limit not met or a run without a fit, stands in it.

    Raises InputError where this computer has another labcal than the one that asked.
    """
    from labcal.loop.parallel import serially
    from labcal.session.working_out import this_labcal

    if job.settings["version"] != this_labcal():
        text = f"this worker has {this_labcal()}, the study was begun by {job.settings['version']}: install the same"
        raise InputError(text)
    with _one_at_a_time, serially():
        try:
            return {name: _finite(value) for name, value in _row(job).items()}
        except (InstrumentError, LimitNotMet) as error:
            return {"why_not": str(error)}
        except InputError as error:
            return {"why_not": str(error.what)}


def _finite(value: Cell) -> Cell:
    """Nothing where a number is none."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _row(job: Job) -> Row:
    from labcal.study import fleet, trials

    if job.kind == "fleet":
        return fleet.worked_out_again(job.settings, job.places)
    return {"monte-carlo": trials.monte_carlo, "blind": trials.blind, "design": trials.design}[job.kind](job.settings)
