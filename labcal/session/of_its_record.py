"""What the record of its run has against a calibration, before any number of it is worked out again."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass

from labcal.certificate.recomputed import FIRST_VERSION
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration
from labcal.session.audited import noted_heads, noted_runs
from labcal.session.numbering import against_the_register
from labcal.store import Bundle, Store
from labcal.store.listing import FILE as STORE


@dataclass(frozen=True, slots=True)
class OfRecord:
    """`against` makes the file NOT VALID; `unshown` is what this record can neither confirm nor deny.

    `gone`: why the run is not at hand, "" where it is; `fault`: why the store cannot be asked.
    """

    against: tuple[str, ...] = ()
    unshown: tuple[str, ...] = ()
    gone: str = ""
    fault: str = ""


def of_its_record(stated: Calibration, bundle: Bundle | None) -> OfRecord:
    """`stated` beside the record of its run, that of `bundle` or else of the local store."""
    if bundle is not None:
        return _of_bundle(stated, bundle)
    if not (home() / STORE).exists():
        return OfRecord(gone=_gone(stated))
    try:
        with Store.open() as store:
            return _of_store(stated, store) if store.has(stated.run_id) else OfRecord(gone=_gone(stated))
    except InputError as fault:
        return OfRecord(fault=f"the store cannot be asked for its run: {fault}")


def deletions(store: Store) -> Iterator[str]:
    """Runs that the audit log has with another head than the store, or that are gone from it."""
    noted, heads, there = noted_runs(), noted_heads(), {run.run_id for run in store.runs()}
    firsts = {noted[run_id] for run_id in there & noted.keys()} - {""}
    since = False  # a store that was begun anew holds later runs alone
    for run_id in [*sorted(firsts - noted.keys()), *noted]:
        since = since or run_id in there | firsts
        if run_id not in there and since:
            yield f"run {run_id} is gone, which the audit log says was in this store"
        elif run_id in there and (why := _against_log(store, run_id, heads.get(run_id, ()))):
            yield f"run {run_id}: {why}"
    if noted and not since:
        yield f"run {list(noted)[-1]} is gone, as are all that the log has from before it, or this store was begun anew"
    yield from filter(None, [store.missing()])


def _of_bundle(stated: Calibration, bundle: Bundle) -> OfRecord:
    """A bundle's chain was walked when it was read; `verify` compares the two heads."""
    against: tuple[str, ...] = _of_head(stated, bundle.stated_chain is not None)
    against += _of_chained_cage(stated, bundle)
    unshown: tuple[str, ...] = _without_chain(stated) if bundle.stated_chain is None and stated.chain else ()
    unshown += _cage_not_shown(stated, bundle) + _unlike_noted(stated, bundle)
    with suppress(InputError), Store.open() as store:
        if bundle.stated_chain and store.has(stated.run_id) and store.has_head(stated.run_id, bundle.stated_chain):
            against = against or _of_cage(stated, store.cage_sha256(stated.run_id))
    return OfRecord(against, unshown)


def _of_store(stated: Calibration, store: Store) -> OfRecord:
    try:
        head_holds = store.has_head(stated.run_id, stated.chain)
    except InputError as misfit:
        return OfRecord((f"chain: {misfit.what}",))
    noted = noted_heads().get(stated.run_id, ())
    if store.status(stated.run_id) == "imported":
        return _of_imported(stated, store.bundle(stated.run_id))
    against = _of_cage(stated, store.cage_sha256(stated.run_id)) if head_holds else _another_head(stated)
    against += _of_head(stated, store.head_of(stated.run_id) is not None)
    if why := _against_log(store, stated.run_id, noted):
        against += (f"chain: {why}",)
    return OfRecord(against + against_the_register(stated))


def _of_imported(stated: Calibration, bundle: Bundle) -> OfRecord:
    if bundle.sha256 != stated.run_sha256:
        text = f"run_sha256: the run {stated.run_id} of this store is not the one that it states"
        return OfRecord((text,))
    against: tuple[str, ...] = _of_head(stated, bundle.stated_chain is not None)
    if bundle.stated_chain is not None and stated.chain and dict(stated.chain) != bundle.stated_chain:
        against += _another_head(stated)
    against += _of_chained_cage(stated, bundle)
    unshown: tuple[str, ...] = _without_chain(stated) if bundle.stated_chain is None and stated.chain else ()
    return OfRecord(against, unshown + _cage_not_shown(stated, bundle) + _unlike_noted(stated, bundle))


def _cage_not_shown(stated: Calibration, bundle: Bundle) -> tuple[str, ...]:
    if stated.cage_sha256 is None or bundle.chain:
        return ()
    return ("cage_sha256: its run came without the record that names its cage",)


def _of_chained_cage(stated: Calibration, bundle: Bundle) -> tuple[str, ...]:
    """The cage that is stated is the one of the bundle's chain; a draft of an imported run states none."""
    return _of_cage(stated, bundle.cage_sha256) if bundle.chain and stated.cage_sha256 is not None else ()


def _unlike_noted(stated: Calibration, bundle: Bundle) -> tuple[str, ...]:
    """What the audit log has against a bundle of a run that was recorded here."""
    if all(head.encode() in bundle.chain for head in noted_heads().get(stated.run_id, ())):
        return ()
    return (f"chain: the audit log says that {stated.run_id} was recorded here, and it came back without that",)


def _of_head(stated: Calibration, chained: bool) -> tuple[str, ...]:
    """A calibration of a run with a chain states its head, and is of the version that can."""
    if not chained or stated.chain is not None:
        return ()
    if stated.format == FIRST_VERSION:
        return (f"format: {FIRST_VERSION} is stated, and its run was recorded since calibrations are of a later one",)
    return ("chain: none is stated, and its run has one",)


def _another_head(stated: Calibration) -> tuple[str, ...]:
    return (f"chain: the head that it states is none of the run {stated.run_id} of this store",)


def _without_chain(stated: Calibration) -> tuple[str, ...]:
    return (f"chain: the run {stated.run_id} is here without its own, which would show the head that it states",)


def _of_cage(stated: Calibration, made: str | None) -> tuple[str, ...]:
    if stated.cage_sha256 == made:
        return ()
    said = (f"{digest[:12]}…" if digest else "none" for digest in (stated.cage_sha256, made))
    return ("cage_sha256: {} is stated, its run was driven by {}".format(*said),)


def _against_log(store: Store, run_id: str, noted: tuple[str, ...]) -> str:
    """What the audit log has against the chain of a recorded run; "" where nothing."""
    if store.status(run_id) == "imported" or all(store.has_link(run_id, head) for head in noted):
        return ""
    return "its chain is another than the one whose head the audit log took down when it ended"


def _gone(stated: Calibration) -> str:
    text = f"its run {stated.run_id} is not in this store"
    return (
        f"{text} any more, though the audit log says it was recorded here" if stated.run_id in noted_heads() else text
    )
