"""The line in order: bench → procedure → record → fit → loop → certificate. The command line and the window call it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from labcal import certificate, loop
from labcal.bench import shutdown
from labcal.bench.clock import Clock
from labcal.bench.coils.cage_file import CageCalibration, sha256_of, write_cage
from labcal.bench.coils.state import LabState
from labcal.bench.coils.zero import AtZero
from labcal.bench.identify import Identified, identify_all
from labcal.bench.opening import open_bench
from labcal.bench.specification import specification_of
from labcal.certificate import Entry, Signer, Verification, read_allowed_signers
from labcal.certificate.dcc import write_dcc
from labcal.certificate.report import calibration_page, check_form, closed_loop_page, run_page, write_report
from labcal.errors import InputError
from labcal.files import write_bytes
from labcal.fit import Fit, draft_calibration, fit, fit_all
from labcal.home import home
from labcal.loop import ClosedLoop
from labcal.model import Calibration
from labcal.outputs import claim, writing
from labcal.record import Run
from labcal.record.stream import Item
from labcal.runner import Answer, Control, Outcome, find, procedures, resume_run, run_procedure, yes_to_all
from labcal.runner.cage import approved_cage
from labcal.store import (
    Bundle,
    Checked,
    RunSummary,
    Store,
    bundle_files,
    bundle_of,
    describe,
    export,
    load_bundle,
    photos,
    save_bundle,
)
from labcal.store import check_store as store_check
from labcal.store.listing import FILE as STORE
from labcal.toml_file import named_files
from labcal.uncertainty.conformity import Changes, assess

if TYPE_CHECKING:
    from labcal.bench.look_again import Looked
    from labcal.fit.filters.history import History

Source = str | Path | Run  # a run id of the local store or a path to a bundle, a path, or the run itself
THIS_LAB = "this lab's trust list"
CALIBRATIONS = "calibrations"  # the window's drafts and certificates, in labcal's folder


def run(
    procedure: str,
    bench: Path,
    given: Mapping[str, str] | None = None,
    *,
    answer: Answer | None = None,
    dut: str | None = None,
    operator: str = "",
    clock: Clock | None = None,
    seed: int | None = None,
    run_id: str | None = None,
    store: Path | None = None,
    control: Control | None = None,
    tell: Callable[[Item], None] = lambda item: None,
    show: Callable[[LabState], None] = lambda state: None,
) -> Outcome:
    """Run a procedure (its name, or a file) on a bench into the store, with `given` settings {key: text}.

    Without `answer`, prompts are answered as far as `--yes` may. The clock is virtual where all links are emulated.
    `show` hears how the lab is, whenever it was read.
    """
    found, texts, filled = find(procedure), dict(given or {}), dict[str, Any]()
    if found.takes("calibration") and "calibration" in texts:
        filled["calibration"] = load_calibration(Path(texts.pop("calibration")))
    with closing(open_bench(bench, clock=clock, seed=seed)) as lab, Store.open(store) as kept:
        return run_procedure(
            lab, found, texts, filled=filled, store=kept, answer=answer or yes_to_all(lab.simulated), operator=operator,
            dut_serial=dut, bench_file=bench.read_text(encoding="utf-8"), cage_sha256=sha256_of(lab.config, bench),
            specification=specification_of(lab.config, bench), run_id=run_id, control=control, tell=tell, show=show,
        )  # fmt: skip


def resume(
    run: str,
    bench: Path,
    procedure: str | None = None,
    *,
    answer: Answer | None = None,
    dut: str | None = None,
    clock: Clock | None = None,
    seed: int | None = None,
    control: Control | None = None,
    tell: Callable[[Item], None] = lambda item: None,
    show: Callable[[LabState], None] = lambda state: None,
) -> Outcome:
    """Go on with an interrupted run of the local store after its last finished step.

    `procedure` names the file where the run's was a file of one's own.
    """
    with closing(open_bench(bench, clock=clock, seed=seed)) as lab, Store.open() as kept:
        found, ask = find(procedure or kept.header(run).procedure), answer or yes_to_all(lab.simulated)
        return resume_run(
            lab, found, run, store=kept, answer=ask, dut_serial=dut, control=control, tell=tell, show=show
        )


def approve_cage(run: str, name: str, out: Path, *, force: bool = False) -> CageCalibration:
    """Write what a run of `cage-calibration` found to `out`, approved by `name`; until then it is a draft."""
    [output] = claim("bench cage", out, force=force)
    with Store.open() as kept:
        found = approved_cage(kept.header(run), kept.status(run), kept.items(run, but="block"), name)
    with output.writing():
        write_cage(found, out)
    return found


def load_run(run: Source, channels: Sequence[str] | None = None) -> Run:
    """The run that `run` names, with all its channels or only those of these names. Raises InputError."""
    measured = run if isinstance(run, Run) else _run_of_name(run)
    try:
        return measured if channels is None else measured.with_channels(channels)
    except KeyError as error:
        raise InputError(str(error.args[0])) from None


def _run_of_name(run: str | Path) -> Run:
    if _is_path(run):
        return load_bundle(Path(run)).run()
    with Store.open() as store:
        return store.run(str(run))


def run_bundle(run: Source) -> Bundle:
    """The exported bundle of the run that `run` names, byte for byte; its `sha256` is the contract's run_sha256."""
    if isinstance(run, Run):
        return bundle_of(run)
    if _is_path(run):
        return load_bundle(Path(run))
    with Store.open() as store:
        return store.bundle(str(run))


def runs() -> list[RunSummary]:
    """The runs of the local store, the oldest first."""
    with Store.open() as store:
        return store.runs()


def describe_run(run: str) -> dict[str, Any]:
    """What the run that `run` names is: head, segments and what each offers, channels, measurements."""
    if _is_path(run):
        return describe(load_run(run), "a bundle, not in the store")
    with Store.open() as store:
        return store.describe(run)


def correct_serial(run: str, serial: str, who: str, made: Sequence[Path] = ()) -> None:
    """State another serial of a run's DUT, as an event of its record; the drafts `made` of it follow.

    Raises InputError once one of them is signed.
    """
    if signed := [path.name for path in made if certificate.signature_files(path)]:
        raise InputError(f"{signed[0]} is signed: its serial stands; another DUT needs a run of its own")
    with Store.open() as store:
        store.correct_serial(run, serial, who)
        bundle = store.bundle(run)
    for path in made:
        draft = load_calibration(path)
        corrected = replace(draft, dut=replace(draft.dut, serial=serial.strip()), run_sha256=bundle.sha256)
        write_bytes(path, certificate.calibration_bytes(corrected))


def keep_photo(path: Path) -> dict[str, str]:
    """Copy a photograph beside the store; what a note in a record says of it."""
    return photos.keep_photo(path)


def hand_out(calibration: Path, folder: Path) -> None:
    """Copy a calibration, its signatures and the keys they are checked against to `folder`.

    Raises InputError, before anything is copied, where another file of one of these names is there.
    """
    certificate.hand_out(calibration, folder, [entry.signer for entry in trusted_keys() if not entry.revoked])


def import_bundle(path: Path) -> str:
    """Take a bundle into the local store, byte for byte; returns its run id."""
    with Store.open() as store:
        return store.add_bundle(path)


def check_store(run: str | None = None) -> Checked:
    """Look through the local store, or one run of it, for the first thing that does not fit."""
    return store_check(home() / STORE, run)


def export_run(run: str, format_: Literal["bundle", "csv", "hdf5", "mat"], out: Path, *, force: bool = False) -> None:
    """Write the run that `run` names to `out`."""
    files, folder = (bundle_files(out), True) if format_ == "bundle" else ([out], False)
    outputs = claim("export", *files, inputs=paths(run), force=force, with_folder=folder)
    bundle = run_bundle(run)
    with writing(outputs):
        if format_ == "bundle":
            save_bundle(bundle, out)
        elif format_ == "csv":
            write_bytes(out, export.csv_table(bundle))
        else:
            write_bytes(out, export.hdf5(bundle.run()) if format_ == "hdf5" else export.mat(bundle.run()))


def paths(run: Source) -> list[Path]:
    """The path that `run` names, where it is none of the store's ids: what a command reads it from."""
    return [Path(run)] if not isinstance(run, Run) and _is_path(run) else []


def _is_path(run: str | Path) -> bool:
    """A plain word is a run id, unless a bundle of that name lies right here."""
    if isinstance(run, Path):
        return True
    here = Path(run)
    return "/" in run or "\\" in run or run.lower().endswith(".zip") or here.is_file() or (here / "run.json").is_file()


def new_key(name: str, passphrase: str) -> Signer:
    """Make a private key for `name` under `passphrase`, and trust its public half."""
    return certificate.keys.new_key(home(), name, passphrase)


def trusted_keys() -> tuple[Entry, ...]:
    """Everybody in the lab's trust list."""
    return certificate.keys.entries(home())


def trust_keys(allowed_signers: Path) -> tuple[Signer, ...]:
    """Take the lines of an allowed_signers file into the lab's trust list; returns the new ones."""
    return certificate.keys.trust(home(), allowed_signers)


def revoke_keys(name: str) -> int:
    """Accept no signature any more by the keys of `name`; returns how many keys those are."""
    return certificate.keys.revoke(home(), name)


def load_calibration(path: Path) -> Calibration:
    """Read a calibration file, checked. Raises InputError."""
    return certificate.read_calibration(path)


def approve(calibration: Path, name: str) -> Calibration:
    """Write the approver's name into a draft."""
    return certificate.approve(calibration, name)


def sign(calibration: Path, name: str, passphrase: str) -> Path:
    """Sign the calibration as `name`; returns the path of the signature."""
    key = certificate.keys.open_key(home(), name, passphrase)
    return certificate.sign(calibration, name, key, certificate.keys.trusted(home()))


def verify(calibration: Path, allowed_signers: Path | None = None, run: Source | None = None) -> Verification:
    """Check every signature of the calibration against the lab's trust list, or the one that is named."""
    signers = read_allowed_signers(allowed_signers) if allowed_signers else certificate.keys.trusted(home())
    sha256 = None if run is None else run_bundle(run).sha256
    return certificate.verify(calibration, signers, certificate.keys.revoked(home()), datetime.now(UTC), sha256)


def fit_run(run: str, method: str = "ml", channels: tuple[str, ...] | None = None) -> tuple[Run, list[Fit]]:
    """Estimate a calibration by one method, or by "all"; `channels` limits what `telemetry` may use."""
    measured = load_run(run, channels)
    return measured, fit_all(measured) if method == "all" else [fit(measured, method)]


def filter_history(run: str, method: str) -> History:
    """How the estimate of a live filter grew with the readings of `run`."""
    from labcal.fit.filters import history

    return history.filter_history(load_run(run), method)


def draft(run: Source, found: Fit, out: Path, *, force: bool = False) -> Calibration:
    """Write the draft calibration that a fit of `run` makes."""
    [output] = claim("fit", out, inputs=paths(run), force=force)
    bundle = run_bundle(run)
    made = draft_calibration(bundle.run(), found, bundle.sha256, cage_sha256=_cage_sha256(run))
    with output.writing():
        write_bytes(out, certificate.calibration_bytes(made))
    return made


def close_loop(
    run: Source,
    out: Path | None = None,
    progress: Callable[[str], None] = lambda text: None,
    *,
    report: Path | None = None,
    force: bool = False,
) -> ClosedLoop:
    """Trace the residual of `run` to its cause; the calibration with the effect goes to `out`, the page to `report`."""
    outputs = {output.path: output for output in claim("close-loop", out, report, inputs=paths(run), force=force)}
    if report is not None:
        check_form(report)  # before the work, not after it
    bundle = run_bundle(run)
    measured = bundle.run()
    closed = with_installed_procedure(loop.close_loop(measured, progress))
    made = partial(draft_calibration, measured, closed.fit(), bundle.sha256, metrics=closed.metrics())
    if measured.specification is not None:
        closed = replace(closed, conformity=assess(made(), measured.specification, measured))
    if report is not None:
        with outputs[report].writing():
            write_report(closed_loop_page(closed, measured), report)
    if out is not None:
        with outputs[out].writing():
            write_bytes(out, certificate.calibration_bytes(made(cage_sha256=_cage_sha256(run))))
    return closed


def one_cause(run: str, effect: str, channels: tuple[str, ...]) -> loop.OneCause:
    """The residual of `run` without one cause and with it alone, whether the loop named it or not."""
    return loop.one_cause(load_run(run), effect, channels)


def _cage_sha256(run: Source) -> str | None:
    """SHA-256 of the cage calibration that a recorded run was driven by; a bundle does not tell."""
    if isinstance(run, Run) or _is_path(run):
        return None
    with Store.open() as store:
        return store.cage_sha256(str(run))


def with_installed_procedure(closed: ClosedLoop) -> ClosedLoop:
    """With a procedure that is installed: the loop's own choice, else one that says it separates the rivals."""
    proposed = closed.next_experiment
    if proposed is None or proposed.procedure in (there := procedures()):
        return closed
    rivals = [{cause.effect, rival.effect} for cause in closed.accepted for rival in cause.rivals]
    fitting = (p.name for p in there.values() if any(set(pair) in rivals for pair in p.separates))
    return replace(closed, next_experiment=replace(proposed, procedure=next(fitting, None)))


def apply_calibration(
    calibration: Path, source: Path, out: Path, dut: str | None = None, *, force: bool = False
) -> certificate.AppliedFile:
    """Correct a recording of the calibration's DUT. Raises InputError where `dut` is another serial."""
    [output] = claim("apply", out, inputs=(calibration, source), force=force)
    found = load_calibration(calibration)
    if dut is not None and dut != found.dut.serial:
        raise InputError(f"is the calibration of {found.dut.serial}, not of {dut}", file=calibration)
    certificate.check_effects(found, calibration)
    with output.writing():
        return certificate.apply_file(found, source, out)


def report(
    source: str, out: Path, allowed_signers: Path | None = None, *, before: Path | None = None, force: bool = False
) -> None:
    """Write the report of a calibration file or of a run, as `.html` or `.pdf`; a calibration's also as DCC `.xml`.

    A calibration's page says what changed since that of `before`, else since the lab's own before it, if there is one.
    """
    read = [*paths(source), Path(source), *(file for file in (allowed_signers, before) if file)]
    [output] = claim("report", out, inputs=read, force=force)
    with output.writing():
        if certificate.looks_like_calibration(Path(source)):
            return _report_calibration(Path(source), out, allowed_signers, before)
        bundle = run_bundle(source)
        run = bundle.run()
        return write_report(run_page(run, bundle.sha256, fit(run, holdout=False)), out)


def _report_calibration(path: Path, out: Path, allowed_signers: Path | None, before: Path | None) -> None:
    verification = verify(path, allowed_signers)
    calibration = certificate.parse_calibration(verification.content, path)
    run = run_of(calibration)
    if out.suffix.lower() == ".xml":
        return write_dcc(calibration, verification.content, path.name, run, home() / "laboratory.toml", out)
    checked = f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC, against {allowed_signers or THIS_LAB}"
    changed = certificate.changed_from(calibration, before) if before else changed_since(calibration)
    return write_report(calibration_page(calibration, verification, checked, run, changed), out)


def changed_since(calibration: Calibration) -> Changes | None:
    """What changed since the calibration before this one of the same DUT in this lab's folder; None where none is."""
    started = {run.run_id: run.started_utc for run in runs()}
    return certificate.changed_since(calibration, home() / CALIBRATIONS, started)


def run_of(calibration: Calibration) -> Run | None:
    """The run a calibration came from, where this store has it unchanged."""
    try:
        bundle = run_bundle(calibration.run_id)
    except InputError:
        return None
    return bundle.run() if bundle.sha256 == calibration.run_sha256 else None


def greetings(bench: Path) -> list[Identified]:
    """Ask every instrument of a bench.toml who it is; silent ones are in the list, with why."""
    return identify_all(bench)


def serve_bench(bench: Path, out: Path, ready: Callable[[], None], *, force: bool = False) -> None:
    """Put the emulated instruments of `bench` on TCP ports and ptys until interrupted; `out` is the bench to use."""
    from labcal.bench.serve import serve

    [output] = claim("bench serve", out, inputs=named_files(bench), force=force)

    def written() -> None:
        output.remember()
        ready()

    serve(bench, out, written)


def look_again(bench: Path, clear_as: str = "") -> Looked | None:
    """Measure again where a zero of this bench is in doubt; None where none is. `clear_as`: who answers for it."""
    from labcal.bench.look_again import look_again

    return look_again(bench, clear_as)


def coils_off(bench: Path) -> list[AtZero]:
    """Every coil to zero and open, one report an axis."""
    return shutdown.coils_off(bench)
