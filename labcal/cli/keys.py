"""`labcal keys`: who may sign, and whose signature counts."""

from __future__ import annotations

import getpass
import os
import sys
from datetime import UTC, datetime
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from labcal.cli import app
from labcal.cli.screen import console, say, say_lines
from labcal.errors import InputError
from labcal.files.home import PASSPHRASE
from labcal.system.private_memory import kept_private

if TYPE_CHECKING:
    from labcal.certificate import KeyEntry


class Role(StrEnum):
    """What a person may do with a calibration."""

    measure = "measure"
    approve = "approve"
    release = "release"


keys = typer.Typer(help="Keys that sign, and keys that are trusted.", no_args_is_help=True)
app.add_typer(keys, name="keys", rich_help_panel="Certificate")


@keys.command("new")
def new(name: str = typer.Option(..., help="The person, as in ada@lab.example.")) -> None:
    """Make a key for a person, locked with a passphrase, and trust it in this lab."""
    from labcal import session
    from labcal.certificate.sshsig import fingerprint

    signer = session.new_key(name, passphrase(f"New passphrase for {name}: ", again=True))
    say(f"key of {signer.principal}: {fingerprint(signer.key)}")
    _say_unsigned()


@keys.command("list")
def list_keys(
    allowed_signers: bool = typer.Option(False, "--allowed-signers", help="Print the trust list as OpenSSH reads it."),
) -> None:
    """Show whose signatures this lab accepts."""
    from rich.table import Column, Table

    from labcal import session

    if allowed_signers:
        return say_lines(entry.to_hand_out().line() for entry in session.trusted_keys())
    entries, objection = session.listed_keys()
    roles = [Column("Roles", no_wrap=True, min_width=7)] if any(entry.signer.roles for entry in entries) else []
    table = Table("Person", Column("Key", no_wrap=True, min_width=50), "Private key", "Trusted", *roles, box=None)
    for entry in entries:
        table.add_row(*_row(entry), *(["\n".join(entry.signer.roles) or "none"] if roles else []))
    if objection:
        say(f"NOT TRUSTED: {objection}", err=True)
    return console().print(table if table.row_count else "No keys yet: `labcal keys new --name PERSON` makes one.")


@keys.command("trust")
def trust(
    file: Path = typer.Argument(..., help="Lines as `labcal keys list --allowed-signers` prints them."),
    role: list[Role] = typer.Option(
        [],
        "--role",
        help="What those in FILE may do; more than once for more. Once anybody has a role, others need one.",
    ),
) -> None:
    """Accept the signatures of the people in an allowed_signers file, and give them roles."""
    from labcal import session
    from labcal.certificate.sshsig import fingerprint

    changed = session.trust_keys(file, [one.value for one in role])
    for signer in changed:
        may = f", may {', '.join(signer.roles)}" if signer.roles else ""
        objection = f", {signer.revocation()}" if signer.revoked else ""
        say(f"trusted: {signer.principal} {fingerprint(signer.key)}{may}{objection}")
    if not changed:
        say("nothing new: all of them are known already")
    _say_unsigned()


@keys.command("sign")
def sign_list(
    key: str = typer.Option(..., help="Who administers the list: at first anybody of it, then who it was."),
) -> None:
    """Sign the trust list: from then on a change of it counts only once the same person has signed it again."""
    from labcal import session

    lines = session.sign_trust_list(key, own_passphrase(key))
    say(f"the trust list of {lines} line{'s' * (lines != 1)} is signed by {key}, who administers it")


@keys.command("revoke")
def revoke(
    name: str = typer.Argument(..., help="The person whose keys are lost."),
    since: str | None = typer.Option(
        None, "--from", metavar="DATE", help="Keep what is shown to be signed before that date, 0:00 UTC."
    ),
) -> None:
    """Accept nothing any more that a person's present keys have signed or will sign."""
    from labcal import session

    said = f"revoked: {session.revoke_keys(name, _date(since))} key(s) of {name}"
    say(said if since is None else f"{said} from {since} on; what only claims to be from before does not count")
    _say_unsigned()


def _say_unsigned() -> None:
    """Say so where the list that was changed waits for the signature of who administers it."""
    from labcal import session

    if (objection := session.listed_keys()[1]) is not None:
        say(objection, err=True)


def _date(stated: str | None) -> datetime | None:
    try:
        return None if stated is None else datetime.strptime(stated, "%Y-%m-%d").replace(tzinfo=UTC)
    except ValueError:
        raise InputError(f"--from {stated}: is no date like 2026-11-21; nothing was revoked") from None


def passphrase(question: str, *, again: bool = False) -> str:
    """The passphrase from LABCAL_PASSPHRASE, else asked at the terminal (twice for a new one). Raises InputError.

    It leaves the environment as it is read: nobody whom this process starts gets it, nor who reads its memory.
    """
    kept_private()
    if (stated := os.environ.pop(PASSPHRASE, None)) is not None:
        return stated
    if not sys.stdin.isatty():
        raise InputError("there is no terminal to ask for the passphrase; set LABCAL_PASSPHRASE")
    first = getpass.getpass(question)
    if again and first != getpass.getpass("Once more: "):
        raise InputError("the two passphrases differ; nothing was made")
    return first


def own_passphrase(name: str) -> str:
    """The passphrase of the key of `name`; empty where theirs does not lie here, for an SSH agent asks by itself."""
    from labcal import session

    return passphrase(f"Passphrase of {name}: ") if session.asks_passphrase(name) else ""


def _row(entry: KeyEntry) -> tuple[str, str, str, str]:
    from labcal.certificate.sshsig import fingerprint

    until = f"until {entry.signer.valid_before:%Y-%m-%d}" if entry.signer.valid_before else "yes"
    trusted = entry.to_hand_out().revocation() if entry.revoked else until
    return entry.signer.principal, fingerprint(entry.signer.key), "here" if entry.private_key_here else "", trusted
