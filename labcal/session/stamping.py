"""When a signature was there: a token of the time-stamping authority that the laboratory names."""

from __future__ import annotations

from pathlib import Path

from labcal import certificate
from labcal.certificate.laboratory import FILE as LABORATORY
from labcal.certificate.laboratory import read_laboratory
from labcal.certificate.timestamp import fetch_token
from labcal.errors import InputError
from labcal.files.home import home
from labcal.session.numbering import header_of


def stamp(signature: Path, run_id: str) -> str | None:
    """Ask for a token of the signature file; returns what came of it, None where the laboratory names no authority.

    Nothing that goes wrong on the way takes the signature back: its time is then only claimed.
    """
    try:
        if (url := timestamp_url(run_id)) is None:
            return None
        return f"{signature.name}: {url} shows it at {fetch_token(signature, url, authorities()):%Y-%m-%d %H:%M:%S} UTC"
    except (InputError, OSError) as fault:
        return f"{signature.name}: its time is only claimed: {fault}"


def authorities() -> Path:
    """Where the certificates of the time-stamping authorities lie that this lab believes."""
    return certificate.keys.trust_list(home()).with_name("timestamp_ca.pem")


def timestamp_url(run_id: str) -> str | None:
    """Whom to ask: as `laboratory.toml` here says, else as bench.toml said when the run was recorded here.

    What a run says that was imported is another's word, and nobody is asked by it.
    """
    if (home() / LABORATORY).exists():
        stated = read_laboratory(home() / LABORATORY).laboratory
        if stated is not None and stated.timestamp_url is not None:
            return stated.timestamp_url
    header = header_of(run_id)
    laboratory = header.administrative.laboratory if header and header.administrative else None
    return laboratory.timestamp_url if laboratory else None
