"""The line in order: bench → procedure → record → fit → loop → certificate. The command line and the window call it.

Beside the line: `sources` (what names a run), `records` (the local store), `importing` (what others wrote), `trust`
(keys), `signing`, `numbering` (of certificates), `reporting`, `audited` (who did what), `working_out` (a calibration
worked out again from its run), `cage` (its own calibration), `instruments` (the bench without a procedure),
`archiving` (finished work of several labs in one place), `check_standard` (its charts, and who lets a run begin in
spite of them), `figures` (of a run's sensor), and `measuring`, where the loop closes on the instruments.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import closing, suppress
from dataclasses import replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Any

from labcal import certificate, loop
from labcal.bench.clock import Clock
from labcal.bench.coils.cage_file import sha256_of
from labcal.bench.coils.state import LabState
from labcal.bench.opening import open_bench
from labcal.bench.specification import specification_of
from labcal.certificate import Stated
from labcal.certificate.report import check_form, closed_loop_page, write_report
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.outputs import claim, writing
from labcal.fit import Fit, draft_calibration
from labcal.loop import ClosedLoop
from labcal.loop.narrative import of_other_judgements
from labcal.model import Calibration
from labcal.record import Run
from labcal.record.stream import Item
from labcal.runner import Answer, Control, Outcome, find, procedures, resume_run, run_procedure, yes_to_all
from labcal.runner.run import run_id_at
from labcal.session.audited import note, note_file, note_run, read_audit
from labcal.session.cage import approve_cage, cage_remark
from labcal.session.check_standard import Override, admitted
from labcal.session.fits import filter_history, fit_run, left_open
from labcal.session.foreign_calibration import FOREIGN_CALIBRATIONS, import_calibration
from labcal.session.importing import ImportRequest, ImportResult, import_foreign
from labcal.session.instruments import (
    coils_off,
    coils_off_and_stopped,
    earlier_supplies_are_gone,
    find_instruments,
    identify_instruments,
    look_again,
    prepare_to_read,
    read_lab,
    refuse_doubt,
    serve_bench,
)
from labcal.session.made_ready import begin_to_make_ready
from labcal.session.numbering import numbers, void_number
from labcal.session.records import (
    check_store,
    correct_serial,
    describe_run,
    export_run,
    import_bundle,
    keep_photo,
    runs,
)
from labcal.session.reporting import changed_since, label, report
from labcal.session.signing import NOTHING_STATED, approve, sign, verify
from labcal.session.sources import Source, is_path, load_run, paths, run_bundle, run_of
from labcal.session.trust import (
    asks_passphrase,
    handed_out,
    listed_keys,
    new_key,
    revoke_keys,
    sign_trust_list,
    trust_keys,
    trusted_keys,
)
from labcal.session.working_out import keep, made_by
from labcal.store import Store
from labcal.uncertainty.conformity import assess

__all__ = [
    "FOREIGN_CALIBRATIONS",
    "ImportRequest",
    "ImportResult",
    "Override",
    "Source",
    "apply_calibration",
    "approve",
    "approve_cage",
    "asks_passphrase",
    "cage_remark",
    "changed_since",
    "check_store",
    "close_loop",
    "coils_off",
    "coils_off_and_stopped",
    "correct_serial",
    "describe_run",
    "draft",
    "earlier_supplies_are_gone",
    "export_calibration",
    "export_run",
    "filter_history",
    "find_instruments",
    "fit_run",
    "hand_out",
    "identify_instruments",
    "import_bundle",
    "import_calibration",
    "import_foreign",
    "keep_photo",
    "label",
    "left_open",
    "listed_keys",
    "load_calibration",
    "load_run",
    "look_again",
    "new_key",
    "numbers",
    "one_cause",
    "paths",
    "prepare_to_read",
    "read_audit",
    "read_lab",
    "report",
    "resume",
    "revoke_keys",
    "run",
    "run_bundle",
    "run_of",
    "runs",
    "serve_bench",
    "sign",
    "sign_trust_list",
    "trust_keys",
    "trusted_keys",
    "verify",
    "void_number",
    "with_installed_procedure",
]


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
    on_item: Callable[[Item], None] = lambda item: None,
    show: Callable[[LabState], None] = lambda state: None,
    override: Override | None = None,
) -> Outcome:
    """Run a procedure (its name, or a file) on a bench into the store, with `given` settings {key: text}.

    Without `answer`, prompts are answered as far as `--yes` may. The clock is virtual where all links are emulated.
    `show` hears how the lab is, whenever it was read. While the bench's check standard is out of control only a person
    lets a run begin: `override`.
    """
    found, texts, filled = find(procedure), dict(given or {}), dict[str, Any]()
    if found.takes("calibration") and "calibration" in texts:
        filled["calibration"] = load_calibration(Path(texts.pop("calibration")))
    named = run_id or run_id_at(datetime.now(UTC))
    first = admitted(bench, dut, found.name, named, override)  # before any instrument is spoken to
    refuse_doubt(bench)
    remark = cage_remark(bench)
    with closing(open_bench(bench, clock=clock, seed=seed)) as lab, Store.open(store) as kept:
        if first is not None and override is not None:
            note("override", override.who, run=named, because=override.because, key=override.key)
        outcome = run_procedure(
            lab, found, texts, filled=filled, store=kept, answer=answer or yes_to_all(lab.simulated), operator=operator,
            dut_serial=dut, bench_file=bench.read_text(encoding="utf-8"), cage_sha256=sha256_of(lab.config, bench),
            specification=specification_of(lab.config, bench), run_id=run_id if first is None else named,
            remark=remark, control=control, on_item=on_item, show=show, first=first,
        )  # fmt: skip
        outcome = note_run(outcome, kept, operator) if store is None else outcome
    if store is None:
        begin_to_make_ready(outcome)
    return outcome.parted(lab.ended)


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
    on_item: Callable[[Item], None] = lambda item: None,
    show: Callable[[LabState], None] = lambda state: None,
) -> Outcome:
    """Go on with an interrupted run of the local store after its last finished step.

    `procedure` names the file where the run's was a file of one's own.
    """
    refuse_doubt(bench)
    remark = cage_remark(bench)
    with closing(open_bench(bench, clock=clock, seed=seed)) as lab, Store.open() as kept:
        found, ask = find(procedure or kept.header(run).procedure), answer or yes_to_all(lab.simulated)
        outcome = resume_run(
            lab, found, run, store=kept, answer=ask, dut_serial=dut, remark=remark, control=control, on_item=on_item,
            show=show,
        )  # fmt: skip
        outcome = note_run(outcome, kept, kept.header(run).operator)
    begin_to_make_ready(outcome)
    return outcome.parted(lab.ended)


def hand_out(calibration: Path, folder: Path, name: str = "") -> None:
    """Copy a calibration, its signatures and the keys they are checked against, revoked ones as such, to `folder`.

    There it is called `name`.json, where that is given; `folder` is made where there is none, in one that is there.
    Raises InputError, before anything is copied, where another file of one of these names is there.
    """
    with suppress(OSError):  # what is wrong with it is said where it is written into
        folder.mkdir()
    certificate.hand_out(calibration, folder, handed_out(), name)
    note_file("export", "", calibration)


def load_calibration(path: Path) -> Calibration:
    """Read a calibration file, checked. Raises InputError."""
    return certificate.read_calibration(path)


def draft(
    run: Source,
    found: Fit,
    out: Path,
    channels: Sequence[str] | None = None,
    *,
    stated: Stated = NOTHING_STATED,
    force: bool = False,
) -> Calibration:
    """Write the draft calibration that a fit of `run`, by these `channels` alone where they are named, makes."""
    [output] = claim("fit", out, inputs=paths(run), force=force)
    bundle = run_bundle(run)
    how, cage, chain = made_by("fit", found.method, channels), _cage_sha256(run), bundle.stated_chain
    made = draft_calibration(bundle.run(), found, bundle.sha256, cage_sha256=cage, made_by=how, chain=chain)
    made = stated.on(made)
    with output.writing():
        write_bytes(out, certificate.calibration_bytes(made))
    return made


def close_loop(
    run: Source,
    out: Path | None = None,
    progress: Callable[[str], None] = lambda text: None,
    *,
    report: Path | None = None,
    empirical: bool = False,
    stated: Stated = NOTHING_STATED,
    force: bool = False,
) -> ClosedLoop:
    """Trace the residual of `run` to its cause; the calibration with the effect goes to `out`, the page to `report`.

    `empirical` ships a term without a name where structure remains that no known effect carries.
    """
    outputs = {output.path: output for output in claim("close-loop", out, report, inputs=paths(run), force=force)}
    if report is not None:
        check_form(report)  # before the work, not after it
    bundle = run_bundle(run)
    measured = bundle.run()
    closed = with_installed_procedure(loop.close_loop(measured, progress, empirical=empirical))
    closed = replace(closed, remarks=(*closed.remarks, *of_other_judgements()))
    made = partial(draft_calibration, measured, closed.fit(), bundle.sha256, metrics=closed.metrics())
    if measured.specification is not None:
        closed = replace(closed, conformity=assess(made(), measured.specification, measured))
    if report is not None:
        with outputs[report].writing():
            write_report(closed_loop_page(closed, measured), report)
    if out is not None:
        how = made_by("close-loop", closed.fit().method, empirical=empirical)
        drafted = made(cage_sha256=_cage_sha256(run), made_by=how, chain=bundle.stated_chain)
        with outputs[out].writing():
            write_bytes(out, certificate.calibration_bytes(stated.on(drafted)))
        keep(drafted)
    return closed


def one_cause(run: str, effect: str, channels: tuple[str, ...]) -> loop.OneCause:
    """The residual of `run` without one cause and with it alone, whether the loop named it or not."""
    return loop.one_cause(load_run(run), effect, channels)


def _cage_sha256(run: Source) -> str | None:
    """SHA-256 of the cage calibration that a recorded run was driven by; a bundle does not tell."""
    if isinstance(run, Run) or is_path(run):
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
    return replace(closed, next_experiment=replace(proposed, procedure=next(fitting, None), settings={}))


def apply_calibration(
    calibration: Path,
    source: Path,
    out: Path,
    dut: str | None = None,
    *,
    require_signature: bool = False,
    on_remark: Callable[[str], None] = lambda remark: None,
    force: bool = False,
) -> certificate.AppliedFile:
    """Correct a recording of the calibration's DUT. Raises InputError where `dut` is another serial.

    `on_remark` gets what somebody who uses its numbers has to: unsigned, provisional, expired, superseded. With
    `require_signature` one that is not validly signed is refused, and it is worked out again where its run is at hand.
    """
    [output] = claim("apply", out, inputs=(calibration, source), force=force)
    standing = verify(calibration, only_kept=not require_signature)
    found = certificate.parse_calibration(standing.content, calibration)
    if require_signature and not standing.valid:
        raise InputError(
            f"is not validly signed ({'; '.join(standing.against())}); nothing was written", file=calibration
        )
    if dut is not None and dut != found.dut.serial:
        raise InputError(f"is the calibration of {found.dut.serial}, not of {dut}", file=calibration)
    certificate.check_effects(found, calibration)
    for remark in standing.remarks():
        on_remark(remark)
    with output.writing():
        return certificate.apply_file(found, source, out)


def export_calibration(
    calibration: Path, format_: str, folder: Path, *, require_signature: bool = False, force: bool = False
) -> str:
    """Write a calibration for those who fly it into `folder`; returns what its signatures are, in one sentence.

    Raises InputError where the format cannot hold it, or `require_signature` and none holds.
    """
    names = certificate.flight.FILES[format_]
    if folder.exists() and not folder.is_dir():
        raise InputError("is a file; an exported calibration is a folder: name one", file=folder)
    read = (calibration, *certificate.signature_files(calibration))
    outputs = claim("export", *(folder / name for name in names), inputs=read, force=force, with_folder=True)
    found = verify(calibration, only_kept=True)
    if require_signature and found.status not in ("released", "provisional"):
        raise InputError(f"is {found.status}, and --require-signature was said", file=calibration)
    stated = certificate.parse_calibration(found.content, calibration)
    certificate.check_effects(stated, calibration)
    content = certificate.flight.content_of(stated, found.content, certificate.flight.said_of(found))
    files = certificate.flight.flight_files(format_, content, run_of(stated))
    with writing(outputs):
        folder.mkdir(parents=True, exist_ok=True)
        for name, written in files.items():
            write_bytes(folder / name, written)
    return content.status
