"""A session that can open nothing more lets go of its guardian without a fault: how the run ended can still be said."""

from __future__ import annotations

import errno
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.guardian.client import GuardianClient
from labcal.bench.links import ports


class Config:
    """All that a client asks of a bench file."""

    guarded_links = ("serial:///dev/ttyUSB7",)


class Met(GuardianClient):
    """It has found its guardian."""

    def _meet(self, meanwhile: Callable[[], None] = lambda: None) -> dict[str, dict[str, Any]]:
        self._connection: Any = self
        self.hung_up = 0
        return {}

    def close(self) -> None:
        """The client's own, and the connection's, which it is as well."""
        self.hung_up += 1
        super().close()


def no_more(url: str) -> None:
    raise OSError(errno.EMFILE, "Too many open files", "/run")


def test_who_cannot_look_whether_the_ports_are_free_does_not_fail(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (bench := tmp_path / "bench.toml").write_text("")
    client = Met(bench, Config(), RealClock())  # type: ignore[arg-type]  # of a bench it asks for its links alone
    monkeypatch.setattr(ports, "holder", no_more)
    client.close()
    assert client.hung_up == 2
    assert not client.alive
