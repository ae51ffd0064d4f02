"""`labcal watch`: new runs are worked out while nobody sits there, and a person is notified."""

from __future__ import annotations

import os
from pathlib import Path

import typer

from labcal.cli import DONE, NEGATIVE, app
from labcal.cli.results import FORCE, JSON, json_path, write_json
from labcal.cli.screen import say_lines
from labcal.errors import InputError
from labcal.files.home import WEBHOOK
from labcal.files.outputs import claim


@app.command(rich_help_panel="Years")
def watch(
    folder: Path | None = typer.Argument(None, metavar="[FOLDER]", help="A folder into which bundles come."),
    archive: str | None = typer.Option(None, "--archive", metavar="URL", help="The archive, not a folder."),
    out: Path = typer.Option(Path("watched"), metavar="DIR", help="Drafts, reports, and what was looked at already."),
    mail: list[str] = typer.Option([], metavar="ADDRESS", help="Who is notified."),
    smtp: str = typer.Option("localhost", metavar="HOST[:PORT]", help="The server that takes the mail."),
    sender: str = typer.Option("labcal@localhost", "--from", metavar="ADDRESS", help="Whom the mail is from."),
    webhook: list[str] = typer.Option(
        [], metavar="URL", help="An address that takes JSON by POST; those of LABCAL_WEBHOOK too."
    ),
    every: float = typer.Option(60.0, min=1.0, max=86_400.0, metavar="SECONDS", help="How often to look."),
    once: bool = typer.Option(False, "--once", help="Look once. Exit code 1: something needs eyes."),
    json: str | None = JSON,
    force: bool = FORCE,
) -> int:
    """Fit, loop and draft every new run and notify a person, until Ctrl-C. Nothing is ever signed.

    A mail server that asks for a name and a password is given LABCAL_SMTP_USER and LABCAL_SMTP_PASSWORD. Everybody on
    this machine can read a command line: an address whose path is its password belongs into LABCAL_WEBHOOK.
    """
    from labcal.years.notify import Mail, Webhook
    from labcal.years.watch import COMMAND, Source, document, look, require_folder
    from labcal.years.watch import watch as watching

    if (folder is None) == (archive is None):
        raise InputError("say the FOLDER that is watched, or --archive URL")
    if json is not None and not once:
        raise InputError("--json is what one look found: say --once too")
    if folder is not None and not folder.is_dir():
        raise InputError("is no folder", file=folder)
    claim(COMMAND, *(path for path in (json_path(json),) if path), force=force)
    require_folder(out)
    ways: list[Mail | Webhook] = [Mail(tuple(mail), sender, smtp)] if mail else []
    ways += [Webhook(url) for url in (*webhook, *os.environ.get(WEBHOOK, "").split())]
    if not once:
        watching(Source(folder, archive), out, ways, every, _say)
    found = look(Source(folder, archive, 0.0), out, ways, (lambda one: None) if json == "-" else _say)
    if json is not None:
        write_json([document(one) for one in found], json, COMMAND, force=force)
    return NEGATIVE if any(one.needs for one in found) else DONE


def _say(text: str) -> None:
    say_lines(text.splitlines())
