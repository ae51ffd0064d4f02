"""Where an archive is: a PostgreSQL URL whose password is shown to nobody, and where its bundles lie."""

from __future__ import annotations

from dataclasses import dataclass, field
from urllib.parse import parse_qsl, unquote, urlsplit

from labcal.errors import InputError

LIKE = "postgresql://USER@HOST/DATABASE"
KINDS = ("postgresql", "postgres")
OURS = ("bundles", "site")  # what stands after the ? and is not for PostgreSQL
SIGNS = "signs such as @ : / ? # in a password are written %40 %3A %2F %3F %23"
SECRET = ("password", "sslpassword", "passfile", "sslkey")  # settings of libpq that are, or lead to, a secret


@dataclass(frozen=True, slots=True)
class ServerAddress:
    """An archive's place. `shown` is for people; `password` and `settings` (for libpq) stand in no text."""

    shown: str
    user: str | None
    host: str | None
    port: int | None
    database: str
    bundles: str | None
    site: str | None
    password: str | None = field(repr=False)
    settings: tuple[tuple[str, str], ...] = field(repr=False)

    @property
    def has_password(self) -> bool:
        """Whether the URL itself states one."""
        return bool(self.password) or any(name in SECRET[:2] for name, _ in self.settings)

    def without_secrets(self, text: str) -> str:
        """`text` with *** where it repeats a secret of the URL."""
        secrets = [self.password, *(value for name, value in self.settings if name in SECRET[:2])]
        for secret in sorted(filter(None, secrets), key=len, reverse=True):
            text = text.replace(secret, "***")
        return text


def parse_address(url: str) -> ServerAddress:
    """The address that `url` states. Raises InputError, which repeats nothing of a URL that cannot be read."""
    try:
        parts = urlsplit(url)
        port = parts.port
        query = parse_qsl(parts.query, keep_blank_values=True, strict_parsing=bool(parts.query))
    except ValueError:
        raise _unreadable() from None
    if parts.scheme not in KINDS or parts.fragment or "@" in parts.path or not parts.path.strip("/"):
        raise _unreadable()
    stated = dict(query)
    user = unquote(parts.username) if parts.username else None
    database = unquote(parts.path.removeprefix("/"))
    return ServerAddress(
        shown=_shown(user, parts.hostname or stated.get("host", ""), port, database),
        user=user,
        host=parts.hostname,
        port=port,
        database=database,
        bundles=stated.get("bundles") or None,
        site=stated.get("site") or None,
        password=unquote(parts.password) if parts.password else None,
        settings=tuple((name, value) for name, value in stated.items() if name not in OURS),
    )


def _shown(user: str | None, host: str, port: int | None, database: str) -> str:
    return f"postgresql://{f'{user}@' if user else ''}{host}{f':{port}' if port else ''}/{database}"


def _unreadable() -> InputError:
    return InputError(f"the archive's URL is none such as {LIKE} ({SIGNS})")
