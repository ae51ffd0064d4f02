"""A session's guardian is gone: each coil's next order hears of it, whoever heard of it first, until zero was told."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from labcal.bench.clock import RealClock
from labcal.bench.guardian.client import GuardianClient
from labcal.errors import InstrumentError


class Config:
    """All that a client asks of a bench file."""

    guarded_links = ("serial:///dev/ttyUSB7",)


class Guardian:
    """One that answers until it is killed."""

    def __init__(self) -> None:
        self.killed = False
        self.heard = list[str]()

    def order(self, order: str, **what: Any) -> int:
        if self.killed:
            raise BrokenPipeError
        self.heard.append(order)
        return 1

    def reply(self, number: int, timeout_s: float) -> dict[str, Any]:
        return {"value": [] if self.heard[-1] == "zero" else 0.0}

    def beat(self) -> None:
        pass

    def close(self) -> None:
        pass


class Client(GuardianClient):
    """It finds the next guardian at once."""

    def _meet(self, meanwhile: Callable[[], None] = lambda: None) -> dict[str, dict[str, Any]]:
        self._connection: Any = Guardian()
        return {axis: {} for axis in "xyz"}

    def kill(self) -> None:
        self._connection.killed = True


@pytest.fixture
def client(tmp_path: Path) -> Client:
    (bench := tmp_path / "bench.toml").write_text("")
    return Client(bench, Config(), RealClock())  # type: ignore[arg-type]  # of a bench it asks for its links alone


def test_a_coil_hears_of_the_loss_that_another_question_met(client: Client) -> None:
    client.kill()
    with pytest.raises(InstrumentError, match="the connection to the guardian was lost"):
        client.ask("identify", name="reversers")
    for axis in "xy":
        with pytest.raises(InstrumentError, match="the connection to the guardian was lost"):
            client.ask("set_current", axis=axis, current_A=1.0)
    assert client.ask("measure_current", axis="x") == 0.0
    with pytest.raises(InstrumentError, match="the connection to the guardian was lost"):
        client.ask("measure_current", axis="z")


def test_after_zero_was_told_nobody_hears_of_it_again(client: Client) -> None:
    client.kill()
    with pytest.raises(InstrumentError, match="the connection to the guardian was lost"):
        client.ask("measure_current", axis="x")
    client.zero("the run ended")
    assert [client.ask("measure_current", axis=axis) for axis in "xyz"] == [0.0, 0.0, 0.0]
