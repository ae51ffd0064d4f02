"""The public face: what a notebook or a script needs, each a thin call of the rooms. `import labcal` offers it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from labcal import session
from labcal.certificate import Verification
from labcal.demo import simulated_bench
from labcal.errors import InputError, InstrumentError
from labcal.fit import Fit
from labcal.fit import fit as estimate
from labcal.loop import ClosedLoop
from labcal.model import Calibration
from labcal.record import Run
from labcal.runner import Answer, Outcome
from labcal.system.one_thread import one_thread

__all__ = [
    "Calibration",
    "InputError",
    "InstrumentError",
    "close_loop",
    "fit",
    "load_calibration",
    "load_run",
    "run",
    "verify",
]


@contextmanager
def _as_input_error() -> Iterator[None]:
    """A file that cannot be opened is the caller's to mend, as every other fault of the input."""
    try:
        yield
    except OSError as error:
        raise InputError(error.strerror or str(error), file=error.filename) from None
    except UnicodeError as error:
        raise InputError(f"a text here is no UTF-8 ({error})") from None


@_as_input_error()
def load_run(run: str | Path | Run, *, channels: Sequence[str] | None = None) -> Run:
    """Load what was measured.

    Parameters
    ----------
    run : str, Path or Run
        A run id of the local store, or the path of a bundle: a folder, or a zip of it.
    channels : sequence of str, optional
        Keep only the housekeeping channels of these names.

    Returns
    -------
    Run
        Frozen, with n rows: `t_s` (n,) in s, `reading` (n, 3) in `dut.unit`, `reference_vector` (n, 3) in nT in the
        cage frame, `angle_deg` (n,), `segments` and `channels`. NaN is a missing value.

    Raises
    ------
    InputError
        No such run, file or channel, or the first fault of the bundle with its file, line and column.

    Examples
    --------
    >>> import labcal
    >>> run = labcal.load_run("examples/short-preflight/run.zip", channels=["temp_dut", "i_radio"])
    >>> len(run), run.reading.shape, run.dut.unit
    (1321, (1321, 3), 'count')
    >>> [channel.name for channel in run.channels]
    ['temp_dut', 'i_radio']
    """
    return session.load_run(run, channels)


@_as_input_error()
@one_thread()
def fit(
    run: str | Path | Run,
    method: str = "ml",
    *,
    channels: Sequence[str] | None = None,
    out: str | Path | None = None,
    force: bool = False,
) -> Fit:
    """Estimate a calibration: b = K m - k, the reading m in `dut.unit`, the field b in nT in body axes.

    Parameters
    ----------
    run : str, Path or Run
        A run id of the local store, the path of a bundle, or a run.
    method : str
        "ml" (maximum likelihood), or another of docs/fit.md.
    channels : sequence of str, optional
        The housekeeping that the method "telemetry" may use.
    out : str or Path, optional
        Write a draft calibration file here. It names the bytes that it came from: those of the record where the run
        is given by its id or path, else those of the bundle that this very run would make.
    force : bool
        Replace a file that is there; a signed one never is.

    Returns
    -------
    Fit
        `affine.K` (3, 3) in nT per unit and `affine.k_nT` (3,); `covariance` (12, 12), K row by row, then k;
        `rms_scalar_nT` and `holdout_rms_scalar_nT`, residuals of the magnitude. Where the run does not determine a
        calibration, `ok` is False and `why_not` a sentence.

    Raises
    ------
    InputError
        No such run, channel or method, or a file that may not be written.

    Examples
    --------
    >>> import labcal
    >>> found = labcal.fit("examples/short-preflight/run.zip")
    >>> found.ok, found.affine.K.shape, found.covariance.shape
    (True, (3, 3), (12, 12))
    >>> print(f"{found.rms_scalar_nT:.0f} nT")
    72 nT
    """
    source = session.load_run(run)
    found = estimate(source if channels is None else session.load_run(source, channels), method)
    if out is not None:
        session.draft(run, found, Path(out), channels, force=force)
    return found


@_as_input_error()
@one_thread()
def close_loop(
    run: str | Path | Run,
    *,
    out: str | Path | None = None,
    report: str | Path | None = None,
    empirical: bool = False,
    force: bool = False,
    progress: Callable[[str], None] = lambda step: None,
) -> ClosedLoop:
    """Find what a calibration leaves over, trace it to its cause, add that to the model and prove that it helped.

    Parameters
    ----------
    run : str, Path or Run
        A run id of the local store, the path of a bundle, or a run.
    out : str or Path, optional
        Write the calibration with the effects found here, as `fit` does.
    report : str or Path, optional
        Write the page for people here, `.html` or `.pdf`.
    empirical : bool
        Where structure remains that no known effect carries, ship a smooth function of what is recorded; else it
        stands under `proposed`.
    force : bool
        Replace files that are there; a signed one never is.
    progress : callable
        Hears the name of each step as it begins.

    Returns
    -------
    ClosedLoop
        `verdict` ("clean", "explained", "partly-explained", "ambiguous" or "unexplained"), `summary`, a sentence,
        `accepted` and `rejected` effects, `before` and `after`, each with `holdout_rms_nT`, and `next_experiment`.

    Raises
    ------
    InputError
        No such run, one that says too little, or a file that may not be written.

    Examples
    --------
    >>> import labcal
    >>> closed = labcal.close_loop("examples/short-preflight/run.zip")
    >>> closed.verdict
    'explained'
    >>> [(cause.effect, cause.channels) for cause in closed.accepted]
    [('offset-current', ('i_radio',))]
    >>> print(f"{closed.before.holdout_rms_nT:.0f} nT -> {closed.after.holdout_rms_nT:.0f} nT")
    125 nT -> 36 nT
    """
    return session.close_loop(run, _path(out), progress, report=_path(report), empirical=empirical, force=force)


@_as_input_error()
def load_calibration(path: str | Path) -> Calibration:
    """Read a calibration file. Its signatures are another matter: `verify`.

    Parameters
    ----------
    path : str or Path
        A file of the format `labcal-calibration/2`, or 1.

    Returns
    -------
    Calibration
        `affine`, the sensor's `effects`, `covariance` (p, p) of K row by row, k and their parameters (`covariance_of`),
        `validity`; `apply` corrects readings.

    Raises
    ------
    InputError
        No such file, or what is wrong in it and where.

    Examples
    --------
    >>> import labcal
    >>> calibration = labcal.load_calibration("examples/short-preflight/calibration.json")
    >>> calibration.run_id, calibration.simulated
    ('short-preflight', True)
    >>> [effect.effect for effect in calibration.effects]
    ['offset-current']
    """
    return session.load_calibration(Path(path))


@_as_input_error()
@one_thread()
def verify(
    calibration: str | Path, allowed_signers: str | Path | None = None, run: str | Path | Run | None = None
) -> Verification:
    """Check every signature of a calibration file, and work it out again where its run is at hand.

    Parameters
    ----------
    calibration : str or Path
        The calibration file; its signatures lie beside it.
    allowed_signers : str or Path, optional
        Trust the signers of this file; without it, this lab's trust list.
    run : str, Path or Run, optional
        Check too that the calibration came from this run; without it, the store is asked for its run.

    Returns
    -------
    Verification
        `valid`, `status` ("released", "provisional", "unsigned", "invalid", "expired" or "superseded"), the
        names of the `signers`, `checks` of each signature, `recomputed` (`same`: whether the run gives it again, `why`
        it does not), and `sentences()` for people.

    Raises
    ------
    InputError
        No such file or run, or a list of signers that cannot be read. A signature that does not hold is no error.

    Examples
    --------
    >>> import labcal
    >>> folder = "examples/short-preflight"
    >>> result = labcal.verify(f"{folder}/calibration.json", f"{folder}/allowed_signers", f"{folder}/run.zip")
    >>> result.valid, result.run_matches
    (True, True)
    >>> labcal.verify(f"{folder}/calibration.json").valid  # this lab trusts nobody yet
    False
    """
    return session.verify(Path(calibration), _path(allowed_signers), run)


@_as_input_error()
@one_thread()
def run(
    procedure: str = "preflight",
    bench: str | Path | None = None,
    settings: Mapping[str, object] | None = None,
    *,
    dut: str | None = None,
    operator: str = "",
    seed: int | None = None,
    answer: Answer | None = None,
) -> Outcome:
    """Run a procedure and keep what it measures in the local store; the coils end at zero, however it ends.

    Parameters
    ----------
    procedure : str
        Its name (`labcal run` lists them), or the path of a file of your own.
    bench : str or Path, optional
        The bench file; without it, the simulated lab, as fast as the computer goes.
    settings : mapping, optional
        Parameters of the procedure, {name: value}; a list is a tuple or a text with commas.
    dut : str, optional
        Serial number of the DUT, instead of the bench file's.
    operator : str
        Who measures; it stands in the record.
    seed : int, optional
        Of the simulated lab: the same seed hides the same effect.
    answer : callable, optional
        Answers a prompt with one of its `choices`. Without it, prompts are answered on a simulated bench; on a real
        one, what mounts, energises, moves or switches a load is refused before that is done.

    Returns
    -------
    Outcome
        `run_id`, the true final `status`, and the measurements that missed their limits, `failed`.

    Raises
    ------
    InputError
        No such procedure, bench or parameter, or a value out of range: nothing was energised.
    InstrumentError
        An instrument failed: what happened and what to do. A set-point beyond a limit of the bench is one too.

    Examples
    --------
    >>> import labcal
    >>> outcome = labcal.run("rotate-axis", settings={"axis": "x", "magnitude_nT": 40_000}, seed=5)
    >>> outcome.status
    'finished'
    >>> labcal.load_run(outcome.run_id).segments[0].id
    'x+40uT'
    """
    bench_file = simulated_bench() if bench is None else Path(bench)
    given = {name: _as_text(value) for name, value in (settings or {}).items()}
    outcome = session.run(procedure, bench_file, given, answer=answer, dut=dut, operator=operator, seed=seed)
    if outcome.fault is not None:
        raise outcome.fault
    return outcome


def _path(stated: str | Path | None) -> Path | None:
    return None if stated is None else Path(stated)


def _as_text(value: Any) -> str:
    """A setting as `--set` would say it."""
    return ",".join(map(str, value)) if isinstance(value, list | tuple) else str(value)
