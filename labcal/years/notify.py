"""Notify a person by mail or a webhook; what cannot be sent is an InputError, and somebody tries again."""

from __future__ import annotations

import json
import os
import re
import smtplib
import ssl
import urllib.error
import urllib.request
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from email.message import EmailMessage
from email.utils import parseaddr
from http.client import HTTPException
from typing import Any
from urllib.parse import urlsplit

from labcal.errors import InputError
from labcal.files.home import SMTP_PASSWORD
from labcal.files.text_safety import one_line

PATIENCE_S = 30.0
USER = "LABCAL_SMTP_USER"  # for a server that asks who sends
LOOPBACK = ("127.0.0.1", "localhost", "::1")


@dataclass(frozen=True, slots=True)
class Mail:
    """To whom, from whom, over which server: HOST or HOST:PORT (25)."""

    to: tuple[str, ...]
    sender: str
    server: str

    def __post_init__(self) -> None:
        for one in (*self.to, self.sender):
            if not one.isprintable() or "@" not in parseaddr(one)[1]:
                raise InputError(f"{one!r} is no mail address")
        _host_and_port(self.server)


@dataclass(frozen=True, slots=True)
class Webhook:
    """An address that takes JSON by POST; it stands in no text, for its path is often its password."""

    url: str = field(repr=False)

    def __post_init__(self) -> None:
        try:
            parts = urlsplit(self.url)
            said = parts.scheme in ("http", "https") and parts.hostname and parts.port != 0 and "@" not in parts.netloc
        except ValueError:
            said = False
        if not said or not re.fullmatch(r"[!-~]+", self.url):
            raise InputError(
                "a webhook is an address that begins with http:// or https://, without blanks, letters beyond ASCII "
                "(they are written %E2%80%A6), or a name and a password before the host"
            )


Way = Mail | Webhook


def notify(ways: Sequence[Way], subject: str, text: str, document: Mapping[str, Any]) -> None:
    """Send it every way. Raises InputError for the first that failed, after the others were tried."""
    faults = []
    for way in ways:
        try:
            _mail(way, subject, text) if isinstance(way, Mail) else _post(way, document)
        except (OSError, HTTPException, smtplib.SMTPException, ValueError) as fault:  # URLError is an OSError
            faults.append(f"nobody was notified by {_named(way)}: {one_line(str(fault))}")
    if faults:
        raise InputError("; ".join(faults))


def _named(way: Way) -> str:
    """Without a webhook's path."""
    return f"mail over {way.server}" if isinstance(way, Mail) else f"the webhook at {urlsplit(way.url).hostname}"


def _mail(way: Mail, subject: str, text: str) -> None:
    message = EmailMessage()
    message["Subject"], message["From"], message["To"] = one_line(subject), way.sender, ", ".join(way.to)
    message.set_content(text)
    host, port = _host_and_port(way.server)
    with smtplib.SMTP(host, port, timeout=PATIENCE_S) as server:
        server.ehlo()
        secure = server.has_extn("starttls")
        if secure:
            server.starttls(context=ssl.create_default_context())
        if user := os.environ.get(USER):
            if not secure and host not in LOOPBACK:
                raise ValueError("the server takes no TLS: the password was not sent")
            server.login(user, os.environ.get(SMTP_PASSWORD, ""))
        server.send_message(message)


def _post(way: Webhook, document: Mapping[str, Any]) -> None:
    body = json.dumps(document, ensure_ascii=False, allow_nan=False).encode()
    head = {"Content-Type": "application/json", "User-Agent": "labcal"}
    request = urllib.request.Request(way.url, data=body, headers=head, method="POST")
    with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
        answer.read(1024)


def _host_and_port(server: str) -> tuple[str, int]:
    """The two parts of HOST:PORT. Raises InputError."""
    if "@" in server:
        raise InputError(f"--smtp is HOST or HOST:PORT; name and password belong into {USER} and {SMTP_PASSWORD}")
    try:
        parts = urlsplit(f"smtp://{server}")
        host, port = parts.hostname, parts.port or 25
    except ValueError:
        host, port = None, 0
    if not host or not port or parts.path:
        raise InputError(f"--smtp is HOST or HOST:PORT, found {server!r}")
    return host, port
