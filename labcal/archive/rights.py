"""Who may see and add whose rows: a PostgreSQL role in a lab, kept by the server's own row security."""

from __future__ import annotations

from typing import Literal, cast

from sqlalchemy import Connection, Executable, text
from sqlalchemy.dialects.postgresql import insert

from labcal.archive.server import Archive
from labcal.archive.tables import MEMBER, OF_A_SITE, SCHEMA
from labcal.errors import InputError

Duty = Literal["read", "push", "nothing"]
ALL = "*"
OWN_LABS = text(
    f"SELECT CASE WHEN row_security_active('{SCHEMA}.run') THEN {SCHEMA}.labs('{{push}}') END"  # NULL: the owner
)


def grant(archive: Archive, role: str, lab: str, duty: Duty) -> None:
    """Let a role that the server has see a lab's rows (`read`), add to them as well (`push`), or neither any more.

    Raises InputError where there is no such role, or this one may not.
    """
    if not lab.strip() or (lab == ALL and duty == "push"):
        raise InputError("a lab has a name; all of them, *, can be read and not pushed to")
    with archive.transaction() as connection:
        quoted = connection.scalar(
            text("SELECT quote_ident(rolname) FROM pg_roles WHERE rolname = :role"), {"role": role}
        )
        if quoted is None:
            message = f"the server has no role {role!r}: its administrator makes one (CREATE ROLE … LOGIN)"
            raise InputError(f"{archive.address.shown}: {message}")
        connection.execute(MEMBER.delete().where(MEMBER.c.role == role, MEMBER.c.lab == lab))
        if duty != "nothing":
            connection.execute(insert(MEMBER).values(role=role, lab=lab, duty=duty))
        for statement in _granted(quoted, duty):
            connection.execute(statement)


def own_lab(connection: Connection) -> str | None:
    """The one lab that whoever asks may push for; None for the archive's owner, whom row security does not bind.

    Raises InputError where there is none, or several.
    """
    labs = cast("list[str] | None", connection.scalar(OWN_LABS))
    if labs is None:
        return None
    if not labs:
        raise InputError("this role may push for no lab: `labcal archive grant ROLE --lab LAB --may push` by the owner")
    if len(labs) > 1:
        raise InputError(f"this role may push for {', '.join(sorted(labs))}: `?site=LAB` at the URL's end says which")
    return labs[0]


def _granted(role: str, duty: Duty) -> list[Executable]:
    """What a role needs beside the rows' own policies. Tables are named one by one: no other is opened by it."""
    if duty == "nothing":
        return []
    names = ", ".join(str(table) for table in OF_A_SITE)
    others = f"{SCHEMA}.setting, {SCHEMA}.member, {SCHEMA}.alembic_version"
    said = [f"GRANT USAGE ON SCHEMA {SCHEMA} TO {role}", f"GRANT SELECT ON {names}, {others} TO {role}"]
    said += [f"GRANT INSERT ON {names} TO {role}"] if duty == "push" else []
    return [text(one.replace(":", "\\:")) for one in said]
