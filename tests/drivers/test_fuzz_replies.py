"""Damaged replies to every driver that asks: never a crash, a hang, or a value that was not sent.

With a checksum (Modbus, Zaber) any one byte of a reply is turned, lost or put in, and a value must be the one that was
sent. Plain text can notice none of it: there a value is good that stands in the reply, read by a rule of this file.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any, get_type_hints

import pytest
from frames import rtu
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from drivers.framing.zaber import checksum
from drivers.kepco_bop import KepcoBop
from drivers.keysight_e36300 import KeysightSupply
from drivers.korad_ka3005p import KoradSupply
from drivers.metrolab import Metrolab
from drivers.newport_esp301 import Esp301Stage
from drivers.newport_smc100 import Smc100Stage
from drivers.rigol_dp800 import RigolSupply
from drivers.tti_pl import TtiSupply
from drivers.zaber import ZaberStage
from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError

FRAMES = 40
Damage = tuple[int, str, int, int]  # which reply, what, where, with what
DAMAGES = st.lists(
    st.tuples(st.integers(0, FRAMES - 1), st.sampled_from(["turn", "lose", "put", "twice"]), st.integers(0, 10**6),
              st.integers(1, 255)),
    max_size=12, unique_by=lambda damage: damage[0],
)  # fmt: skip
NUMBER = r"[+-]?(?:[0-9]+[.]?[0-9]*|[.][0-9]+)(?:[eE][+-]?[0-9]+)?"


class Replier:
    """Answers each request with the next reply, 1 ms later."""

    def __init__(self, replies: list[bytes]) -> None:
        self._replies, self._waiting = replies, list[tuple[float, bytes]]()
        self.request = b""

    def take(self, t_s: float, data: bytes) -> None:
        self.request = data
        self._waiting.append((t_s + 0.001, self._replies.pop(0)))

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        due = [piece for piece in self._waiting if piece[0] <= until_s]
        self._waiting = self._waiting[len(due) :]
        return due


@dataclass(frozen=True)
class Target:
    """`reply` to question k; `ask` puts it; `read`: what a damaged reply may be read as (None: only what was sent)."""

    driver: Any
    reply: Callable[[int], bytes]
    ask: Callable[[Any], float]
    sent: Callable[[int], float]
    read: Callable[[bytes], set[float]] | None
    settings: dict[str, Any] = field(default_factory=dict)


def numbers(form: str) -> Callable[[bytes], set[float]]:
    """A reader of the whole of a first line in `form`, where NUMBER is its number."""

    def read(reply: bytes) -> set[float]:
        lines = reply.replace(b"\x11", b"").replace(b"\x13", b"").decode("latin-1").split("\n")
        found = [re.fullmatch(rf"[ \r]*{form.replace('NUMBER', f'({NUMBER})')}[ \r]*", line) for line in lines]
        return {float(match[1]) for match in found if match}

    return read


def amps(k: int) -> float:
    return k / 20


def zaber(k: int) -> bytes:
    body = f"01 1 {k + 1:02d} OK IDLE -- {1000 * k}"
    return f"@{body}:{checksum(body.encode())}\r\n".encode()


def zaber_stage(driver: Any) -> float:
    driver._steps_per_turn, driver._stage.summed = 360, True
    return float(driver.angle_deg())


def five(reply: bytes) -> set[float]:
    """The first five characters, such as 0.500."""
    text = reply[:5].decode("latin-1")
    return {float(text)} if re.fullmatch(r"[0-9][.][0-9]{3}", text) else set()


def tesla(reply: bytes) -> set[float]:
    """The first of three numbers, each with its unit [nT]."""
    nT = {"T": 1e9, "mT": 1e6, "MT": 1e6, "uT": 1e3, "UT": 1e3, "nT": 1.0, "NT": 1.0, "G": 1e5, "mG": 100.0, "kG": 1e8}
    part = f"[ \r]*({NUMBER}) *([a-zA-Zµ]+)[ \r]*"
    found = (re.fullmatch(";".join([part] * 3), line) for line in reply.decode("utf-8", "replace").split("\n"))
    return {float(match[1]) * nT[match[2]] for match in found if match and match[2] in nT}


def metrolab(driver: Any) -> float:
    reading = driver.reading(0.0)
    if reading is None or max(map(abs, reading[0])) >= driver.settings.full_scale_nT:
        raise InstrumentError("no good reading, or overloaded")
    return float(reading[0][0])


def supply(driver: Any) -> float:
    return float(driver.measure_current())


TARGETS = {
    "rigol-dp800": Target(RigolSupply, lambda k: b"%.4f\n" % amps(k), supply, amps, numbers("NUMBER")),
    "tti-pl": Target(TtiSupply, lambda k: b"%.3fA\r\n" % amps(k), supply, amps, numbers("NUMBER *A")),
    "kepco-bop": Target(KepcoBop, lambda k: b"%.4f\r\n" % -amps(k), supply, lambda k: -amps(k), numbers("NUMBER")),
    "keysight-e36300": Target(KeysightSupply, lambda k: b"%+.8E\n" % amps(k), supply, amps, numbers("NUMBER")),
    "korad-ka3005p": Target(KoradSupply, lambda k: b"%.3f" % amps(k), supply, amps, five),
    "newport-esp301": Target(
        Esp301Stage, lambda k: b"%.4f\r\n" % (k / 4), lambda d: d.angle_deg(), lambda k: k / 4, numbers("NUMBER")
    ),
    "newport-smc100": Target(
        Smc100Stage,
        lambda k: b"1TP%.4f\r\n" % (k / 4),
        lambda d: d.angle_deg(),
        lambda k: k / 4,
        numbers("1TP *NUMBER"),
        {"tries": 1},
    ),
    "zaber": Target(ZaberStage, zaber, zaber_stage, lambda k: 1000.0 * k, None),
    "metrolab": Target(
        Metrolab, lambda k: b"%.9fT;0.000000100T;-1uT\n" % (k * 1e-6), metrolab, lambda k: k * 1000.0, tesla
    ),
}


def damaged(target: Target, damages: list[Damage]) -> list[bytes]:
    replies = [target.reply(k) for k in range(FRAMES)]
    for number, what, where, value in damages:
        reply = replies[number]
        at = where % len(reply)
        replies[number] = {
            "turn": reply[:at] + bytes([reply[at] ^ value]) + reply[at + 1 :],
            "lose": reply[:at] + reply[at + 1 :],
            "put": reply[:at] + bytes([value]) + reply[at:],
            "twice": reply + reply,
        }[what]
    return replies


def survives(target: Target, damages: list[Damage]) -> None:
    replies, hurt = damaged(target, damages), {number for number, *_ in damages}
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    link, hints = EmulatedLink("emulated://fuzz", Replier(list(replies)), clock), get_type_hints(target.driver.__init__)
    driver = target.driver("fuzz", link, clock, hints["settings"](**target.settings))
    after = False  # a reply cut short may cost the one after it
    for k in range(FRAMES):
        try:
            value = target.ask(driver)
        except InstrumentError:
            assert k in hurt or after, k
            after = True
            continue
        finally:
            clock.wait_until(clock.now() + 0.1)
        allowed = {target.sent(k)} | (target.read(replies[k]) if target.read and k in hurt else set())
        assert any(abs(value - good) <= 1e-9 * max(1.0, abs(good)) for good in allowed), (k, value, allowed)
        after = False


@pytest.mark.parametrize("examples", [20, pytest.param(2500, marks=pytest.mark.slow)])  # of 40 replies each
@pytest.mark.parametrize("name", sorted(TARGETS))
def test_no_damaged_reply_makes_a_value_that_was_not_sent(name: str, examples: int) -> None:
    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(DAMAGES)
    def campaign(damages: list[Damage]) -> None:
        survives(TARGETS[name], damages)

    campaign()


def words(k: int) -> list[int]:
    return [k, 0xFFFF - k, 257 * k]


@pytest.mark.parametrize("examples", [20, pytest.param(2500, marks=pytest.mark.slow)])
def test_no_damaged_modbus_frame_makes_registers_that_were_not_sent(examples: int) -> None:
    """40 frames each; the CRC finds every one byte that is turned, lost or put in."""
    target = Target(None, lambda k: rtu("0103 06 " + "".join(f"{w:04X}" for w in words(k))), float, float, None)

    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(DAMAGES)
    def campaign(damages: list[Damage]) -> None:
        clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
        line = EmulatedLink("emulated://fuzz", Replier(damaged(target, damages)), clock)
        link, hurt = ModbusLink(line, clock, timeout_s=0.05, quiet_s=0.05), {number for number, *_ in damages}
        for k in range(FRAMES):
            try:
                assert link.read_holding(1, 0, 3) == words(k)
            except InstrumentError:
                assert k in hurt

    campaign()
