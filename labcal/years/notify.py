"""Notify a person by mail or a webhook; what cannot be sent is an InputError, and somebody tries again."""

from __future__ import annotations

import json
import os
import smtplib
import ssl
import urllib.error
import urllib.request
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from email.message import EmailMessage
from email.utils import parseaddr
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
    """An address that takes JSON by POST."""

    url: str

    def __post_init__(self) -> None:
        parts = urlsplit(self.url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise InputError("a webhook is an address that begins with http:// or https://")


Way = Mail | Webhook


def notify(ways: Sequence[Way], subject: str, text: str, document: Mapping[str, Any]) -> None:
    """Send it every way. Raises InputError for the first that failed, after the others were tried."""
    faults = []
    for way in ways:
        try:
            _mail(way, subject, text) if isinstance(way, Mail) else _post(way, document)
        except (OSError, smtplib.SMTPException, ValueError) as fault:  # URLError is an OSError
            faults.append(f"nobody was notified by {_named(way)}: {one_line(str(fault))}")
    if faults:
        raise InputError("; ".join(faults))


def _named(way: Way) -> str:
    """Without what a webhook's path may hold: it is often its password."""
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
    parts = urlsplit(f"smtp://{server}")
    try:
        port = parts.port or 25
    except ValueError:
        port = 0
    if not parts.hostname or not port or parts.path:
        raise InputError(f"--smtp is HOST or HOST:PORT, found {server!r}")
    return parts.hostname, port
