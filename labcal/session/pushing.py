"""Finished runs, signed calibrations and the audit log of this lab on their way into the archive; see `archiving`."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import closing
from dataclasses import dataclass, field
from datetime import datetime
from functools import partial
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Self

from labcal import audit, certificate
from labcal.archive import ready
from labcal.archive.ahead import ahead, worth_it
from labcal.archive.bundles import put
from labcal.archive.push import (
    AuditRow,
    Document,
    Known,
    Placed,
    known,
    last_entry,
    note_head,
    push_audit,
    push_calibration,
    push_placed,
    push_run,
    put_in_place,
    run_there,
)
from labcal.archive.run_to_push import FINISHED, RunToPush, of_bundle, of_store_into, read, taken
from labcal.archive.server import Archive, AwayError
from labcal.certificate.calibration_file import LARGEST_BYTES
from labcal.errors import InputError, InstrumentError
from labcal.files.home import home
from labcal.files.plain_file import read_limited
from labcal.model import Calibration
from labcal.session.archive_check import refuse_other_row
from labcal.session.audited import note_all, noted_signatures
from labcal.session.opened_archive import own_site, place_of_bundles
from labcal.session.signing import CALIBRATIONS, SUPERSEDING, signatures
from labcal.session.sources import is_path, run_bundle
from labcal.store import Bundle, Store, zipped_as
from labcal.store.listing import FILE as STORE

REPORTS = (".html", ".pdf", ".xml")
LARGEST_REPORT = 2**26
NOTED_EVERY_S = 0.5
AT_ONCE, PUTTING = 16, 3  # runs made ready before whose rows go there by one commit; threads that put bundles
LARGE = 2**25  # bytes in the store, 250 000 samples with their lines: to make it ready takes 250 MB


@dataclass(frozen=True, slots=True)
class Pushed:
    """What was new in the archive, and what could not be pushed, a sentence each."""

    shown: str
    site: str
    runs: int = 0
    calibrations: int = 0
    entries: int = 0
    refused: tuple[str, ...] = ()

    def in_words(self) -> str:
        """One line."""
        new = f"{self.runs} runs, {self.calibrations} calibrations, {self.entries} entries of the audit log"
        return f"{self.shown}, site {self.site}: new there {new}"


@dataclass(slots=True)
class Pusher:
    """One push: the archive, for which site, where bundles go, what is there already, and what came of it."""

    archive: Archive
    site: str
    place: str
    there: Known
    on_remark: Callable[[str], None]
    runs: int = 0
    calibrations: int = 0
    entries: int = 0
    refused: list[str] = field(default_factory=list)
    _unnoted: list[dict[str, str]] = field(default_factory=list)
    _noted_s: float = 0.0
    _made_from: dict[str, list[Path]] | None = None
    _noted: dict[str, datetime] | None = None

    @classmethod
    def at(cls, archive: Archive, bundles: str | None, on_remark: Callable[[str], None]) -> Self:
        """Ask the archive what it has of this site."""
        site = own_site(archive)
        return cls(archive, site, place_of_bundles(archive, bundles), known(archive, site), on_remark)

    def push(self, names: Sequence[str]) -> Pushed:
        """Push what is named, else all; then the audit log. What cannot be pushed is passed over and reported."""
        try:
            for name in names:
                self._one(name, self._named)
            if not names:
                self._new_runs()
                for path in _signed_calibrations():
                    self._one(str(path), self._named)
        finally:  # what is there is noted, whatever kept the rest back
            self._one("the audit log", lambda _: self._note())
        self._one("the audit log", lambda _: self._audit_log())
        counts = (self.runs, self.calibrations, self.entries)
        return Pushed(self.archive.address.shown, self.site, *counts, tuple(self.refused))

    def _one(self, name: str, push: Callable[[str], object]) -> None:
        try:
            push(name)
        except AwayError:
            raise
        except (InputError, InstrumentError) as fault:
            self.refused.append(str(fault))

    def _named(self, name: str) -> None:
        if certificate.looks_like_calibration(Path(name)):
            self._calibration(Path(name))
        else:
            digest = self._of_path(name) if is_path(name) else self._of_store(name)
            for path in self._calibrations_of(digest):
                self._calibration(path)

    def _calibrations_of(self, digest: str) -> list[Path]:
        """This lab's signed calibrations that were made from the run of this SHA-256."""
        if self._made_from is None:
            self._made_from = {}
            for path in _signed_calibrations():
                self._made_from.setdefault(certificate.read_calibration(path).run_sha256, []).append(path)
        return self._made_from.get(digest, [])

    def _new_runs(self) -> None:
        """Finished runs of the store whose chains the archive does not know."""
        if not (home() / STORE).is_file():
            return
        with closing(Store.read_only(home() / STORE)) as store:
            found = [(run.run_id, store.head_of(run.run_id)) for run in store.runs() if run.status in FINISHED]
            heads = {run_id: head for run_id, head in found if head is None or head not in self.there.heads}
            ready.forget_all_but(heads.values())
            ready.want()
            new = self._made_ready(heads)
            with TemporaryDirectory(prefix="labcal-push-", ignore_cleanup_errors=True) as folder:
                work, large = partial(of_store_into, folder), partial(_is_large, store)
                with closing(ahead(work, new, worth_it(len(new)), large)) as made:
                    for run_id, run in made:
                        self._one(run_id, partial(self._when_ready, run))

    def _made_ready(self, heads: Mapping[str, str | None]) -> list[str]:
        """Push those that were made ready before; returns the others, whose files are not there or not sound.

        Bundles are put in place by threads, for each waits for the disk, and their rows go there many at once.
        """
        there, without = [run_id for run_id, head in heads.items() if ready.is_kept(head)], set(heads)
        with closing(ahead(partial(self._in_place, heads), there, threads=PUTTING)) as found:
            while some := list(islice(found, AT_ONCE)):
                placed: list[Placed] = []
                for run_id, run in some:
                    self._one(run_id, partial(self._when_in_place, run, placed))
                    if run.exception() or run.result():
                        without.discard(run_id)
                self._one("", partial(self._rows, placed))
        return [run_id for run_id in heads if run_id in without]

    def _in_place(self, heads: Mapping[str, str | None], run_id: str) -> Placed | RunToPush | None:
        """A run that was made ready, its bundle put where bundles lie unless it is known to be there."""
        one = ready.kept(run_id, heads[run_id])
        return put_in_place(self.place, one) if one and one.sha256 not in self.there.runs else one

    def _when_in_place(self, run: Future[Placed | RunToPush | None], placed: list[Placed], _: str) -> None:
        one = run.result()
        if isinstance(one, Placed):
            placed.append(one)
        elif one:
            self._run(one)

    def _rows(self, placed: Sequence[Placed], _: str) -> None:
        """Add the rows of all, or of each alone where something keeps one of them back."""
        try:
            new = push_placed(self.archive, self.site, placed)
        except InputError as fault:
            if isinstance(fault, AwayError) or len(placed) == 1:
                raise
            for each in placed:
                self._one(each.run.run_id, partial(self._rows, [each]))
            return
        self._are_new([each.run for each in placed if each.run.sha256 in new])
        for each in placed:
            if each.run.sha256 not in new:
                self._one(each.run.run_id, partial(self._was_there, each.run))

    def _when_ready(self, run: Future[tuple[RunToPush, Path]], _: str) -> None:
        self._run(taken(*run.result()))

    def _of_path(self, path: str) -> str:
        bundle = run_bundle(path)
        return self._run(of_bundle(bundle), bundle)

    def _of_store(self, run_id: str) -> str:
        """Push a run of the store, looking at it though its chain may be known; returns its SHA-256."""
        found = read(run_id)
        return self._run(of_bundle(*found), found[0])

    def _run(self, one: RunToPush, bundle: Bundle | None = None) -> str:
        there = one.sha256 in self.there.runs and run_there(self.archive, self.site, one.sha256)
        if not there and push_run(self.archive, self.site, one, self.place):
            self._are_new([one])
        else:
            self._was_there(one, bundle=bundle)
        return one.sha256

    def _are_new(self, runs: Sequence[RunToPush]) -> None:
        self.runs += len(runs)
        self._say("run", [(one.run_id, one.sha256) for one in runs])
        for one in runs:
            ready.forget(one.kept_head)

    def _was_there(self, one: RunToPush, _: str = "", bundle: Bundle | None = None) -> None:
        """Look at the row of a run that was there already, or came in between."""
        if row := run_there(self.archive, self.site, one.sha256):
            refuse_other_row(one.row, row)
            self._make_whole(one, bundle, row["bundle_sha256"])
            note_head(self.archive, self.site, one.kept_head, one.sha256)
        ready.forget(one.kept_head)

    def _make_whole(self, one: RunToPush, bundle: Bundle | None, digest: str) -> None:
        """Put the bundle that is there once more, where its file was lost or damaged, by the deflate that made it."""
        same = one.zipped if one.bundle_sha256 == digest else None
        if content := same or (zipped_as(bundle, digest) if bundle else None):
            put(self.place, content, digest)

    def _calibration(self, path: Path) -> None:
        content, reports = read_limited(path, LARGEST_BYTES), list(_reports(path))
        signed = [file for file in certificate.signature_files(path) if file.is_file()]
        digest = audit.link_of(content)
        beside = {one.sha256 for one in reports} | {audit.link_of(read_limited(one, LARGEST_BYTES)) for one in signed}
        if signed and all((digest, one) in self.there.documents for one in beside):
            return
        calibration = certificate.parse_calibration(content, path)
        if not signed:
            raise InputError("is a draft: the archive takes a calibration that is signed", file=path)
        self._its_run(calibration)
        documents = [*self._signatures(path, content), *reports]
        if push_calibration(self.archive, self.site, calibration, content, documents):
            self.calibrations += 1
            self._say("calibration", [(path.name, digest)])

    def _signatures(self, path: Path, content: bytes) -> Iterator[Document]:
        """The signatures beside the file, with what this lab's trust list says of each now."""
        if self._noted is None:  # once for all: to look at every entry of a log of years takes seconds
            self._noted = noted_signatures()
        found = signatures(path, noted=self._noted)
        if found.content != content:
            raise InputError("was written to while it was read", file=path)
        for check in found.checks:
            if check.file.is_file():
                signature = read_limited(check.file, LARGEST_BYTES)
                yield Document("signature", check.file.name, signature, check.principal or "", check.objection or "")

    def _its_run(self, calibration: Calibration) -> None:
        """Push the run that the calibration was made from, where the store has it unchanged and it is not there yet."""
        if run_there(self.archive, self.site, calibration.run_sha256) or not (home() / STORE).is_file():
            return
        with closing(Store.read_only(home() / STORE)) as store:
            same = store.has(calibration.run_id) and store.bundle(calibration.run_id).sha256 == calibration.run_sha256
        if same:
            self._of_store(calibration.run_id)

    def _say(self, kind: str, found: Sequence[tuple[str, str]]) -> None:
        """Have all that is new there noted, then tell of each: who is stopped by that has noted what is there."""
        common = {"archive": self.archive.address.shown, "site": self.site}
        self._unnoted += [common | {"sha256": digest, kind: name} for name, digest in found]
        if time.monotonic() - self._noted_s > NOTED_EVERY_S:
            self._note()
        for name, _ in found:
            self.on_remark(f"{kind} {name}")

    def _note(self) -> None:
        """Note what was pushed since in this lab's audit log, at one go: the disk takes each entry alone in 15 ms."""
        abouts, self._unnoted, self._noted_s = self._unnoted, [], time.monotonic()
        if abouts:
            note_all("push", abouts)

    def _audit_log(self) -> None:
        """Push the entries that fit and are not there yet; none from the first on that does not fit.

        Raises InputError where the log here is not the one that was pushed before.
        """
        stored = audit.stored(home())
        if not stored:
            return
        log = audit.link_of(stored[0][1])
        last, links = last_entry(self.archive, self.site, log)
        if last and (last > len(stored) or links != {audit.link_of(stored[last - 1][1])}):
            what = f"entry {last}, which the archive has, is not here, or is another"
            raise InputError(f"the audit log was rewritten or put back since it was pushed: {what}", file=home())
        if last == len(stored):
            return
        found = audit.read(home())
        if found.fault:
            self.refused.append(f"the audit log from there on: {found.fault}")
        pairs = zip(found.entries[last:], stored[last:], strict=False)
        self.entries = push_audit(self.archive, self.site, log, [_entry(*pair) for pair in pairs])


def _is_large(store: Store, run_id: str) -> bool:
    return store.stored_bytes(run_id) > LARGE


def _signed_calibrations() -> Iterator[Path]:
    """The window's calibrations and those that took the place of others, so far as they are signed."""
    for folder in (home() / CALIBRATIONS, home() / SUPERSEDING):
        yield from (path for path in sorted(folder.glob("*.json")) if certificate.signature_files(path))


def _reports(path: Path) -> Iterator[Document]:
    """Reports beside the calibration that are called as it is: CAL.html, CAL.pdf, CAL.xml."""
    for file in (path.with_suffix(ending) for ending in REPORTS):
        if file.is_file():
            yield Document("report", file.name, read_limited(file, LARGEST_REPORT))


def _entry(entry: audit.Entry, row: audit.Row) -> AuditRow:
    number, text, signature = row
    link = audit.link_of(text)
    return AuditRow(number, link, entry.utc, entry.deed, entry.who, entry.machine, text, signature)
