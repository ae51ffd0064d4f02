"""The guardian's ear: sessions and callers on its socket, one thread each, so that no order hides a heartbeat."""

from __future__ import annotations

import hmac
import json
import os
import socket
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from typing import Any

from labcal.bench.guardian.controller import Guardian
from labcal.bench.guardian.wire import (
    OTHER_BENCH,
    TRIED_AGAIN,
    Message,
    another_user,
    fault_message,
    packed,
    peer,
    peer_process,
    zero_message,
)
from labcal.bench.links.holders import process
from labcal.bench.links.places import user, user_name
from labcal.errors import InstrumentError

LINE_BYTES = 65536  # no order is longer
WINDOW = " labcal.gui."  # in what was typed to begin its worker
TOKEN_S = 5.0  # to say who one is
CALLERS, ORDERS = 32, 64  # at once; and of one caller not worked off yet: then it is not listened to
STALE_S = 3.0  # a session that has been silent so long, with the coils at zero, makes room for another
FOR_THE_SESSION = ("set_current", "output", "modbus", "reopen")
KINDS: dict[str, tuple[type, ...]] = {
    "current_A": (float, int), "on": (bool,), "axis": (str,), "name": (str,), "within_s": (float,)
}  # fmt: skip


@dataclass
class Caller:
    """Whoever is connected. `heard_s`: when anything last came from it (monotonic clock). `uid`: whose, where known."""

    socket: socket.socket
    who: str = "a caller"
    heard_s: float = field(default_factory=time.monotonic)
    gone: bool = False
    uid: int | None = None
    since: datetime = field(default_factory=lambda: datetime.now(UTC))
    room: threading.Semaphore = field(default_factory=lambda: threading.Semaphore(ORDERS))

    @property
    def whose(self) -> str:
        """' of user bob' where it is another than the guardian's."""
        return f" of user {user_name(self.uid)}" if self.uid is not None and another_user(self.uid) else ""

    def send(self, message: Message) -> None:
        """Answer; a caller that has left, or reads nothing, is not waited for."""
        with suppress(OSError):
            self.socket.sendall(packed(message))


class Server:
    """Takes orders for a guardian. `session` is the one caller that may energise; others may ask and say off.

    Only the user whose guardian it is may be the session; whoever else reaches the socket is of the group.
    """

    def __init__(self, guardian: Guardian, listener: socket.socket, token: str, fingerprint: str) -> None:
        self.session: Caller | None = None
        self.had_session = False
        self.dismissed = threading.Event()  # asked to make room for a session with another bench file
        self._guardian, self._listener, self._token, self._fingerprint = guardian, listener, token, fingerprint
        self.ready = threading.Event()  # set when the first zero has been tried
        self._orders: dict[str, Callable[..., Any]] = {
            "facts": guardian.facts,
            "ends": lambda: [zero_message(end) for end in guardian.ends()],
            "identify": lambda name, within_s=0.0: asdict(guardian.identify(name, within_s)),
            "reopen": guardian.reopen,
            "modbus": guardian.modbus,
            "set_current": guardian.set_current,
            "set_point": guardian.set_point,
            "measure_current": guardian.measure_current,
            "read": guardian.read,
            "output": guardian.output,
        }

    def start(self) -> None:
        """Listen from now on."""
        threading.Thread(target=self._accept, daemon=True).start()

    def part(self, session: Caller) -> None:
        """This session has ended."""
        if self.session is session:
            self.session = None

    def _accept(self) -> None:
        places = threading.Semaphore(CALLERS)
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            if places.acquire(blocking=False):
                threading.Thread(
                    target=self._serve, args=(Caller(connection, uid=peer(connection)), places), daemon=True
                ).start()
            else:
                connection.close()

    def _serve(self, caller: Caller, places: threading.Semaphore) -> None:
        """Hear one caller out; whoever says what is no order has hung up."""
        try:
            with caller.socket, ThreadPoolExecutor(1) as worker:
                with suppress(Exception):
                    self._hear(caller, worker)
                caller.gone = True  # at once, and not when what it has ordered is worked off
        finally:
            caller.gone = True
            places.release()

    def _hear(self, caller: Caller, worker: ThreadPoolExecutor) -> None:
        """Read lines; orders go to a thread of their own and are worked off in turn."""
        lines = caller.socket.makefile("rb")
        caller.socket.settimeout(TOKEN_S)
        if not hmac.compare_digest(str(json.loads(lines.readline(LINE_BYTES))["token"]).encode(), self._token.encode()):
            return
        caller.socket.settimeout(None)
        while (line := lines.readline(LINE_BYTES)).endswith(b"\n"):
            message = json.loads(line)
            if not isinstance(message, dict):
                return
            caller.heard_s = time.monotonic()
            if "order" in message:
                self._hasten(caller, message)
                if message.get("acknowledge"):  # whoever hears nothing ends this process, and another takes its place
                    caller.send({"id": message.get("id"), "heard": True})
                caller.room.acquire()
                worker.submit(self._answer, caller, message)

    def _hasten(self, caller: Caller, message: Message) -> None:
        """Zero waits for no order before it: what is under way on the lines ends now."""
        if message["order"] == "zero" and isinstance(message.get("with", {}), dict) and self.ready.is_set():
            self._guardian.order_zero(_why(caller, message), by_session=caller is self.session)

    def _answer(self, caller: Caller, message: Message) -> None:
        try:
            reply = {"value": self._obey(caller, message)}
        except InstrumentError as fault:
            reply = {"error": fault_message(fault)}
        except Exception as error:  # whatever it is, the caller hears of it and the guardian lives
            what = f"the guardian failed at {message['order']}: {type(error).__name__}: {error}."
            reply = {"error": fault_message(InstrumentError(what, fault="guardian failed"))}
        caller.room.release()
        caller.send({"id": message.get("id")} | reply)
        if message["order"] == "zero" and caller is not self.session:  # a person at the bench, who first hears of it
            self._guardian.give_back()

    def _obey(self, caller: Caller, message: Message) -> Any:
        order, what = message["order"], message.get("with", {})
        self.ready.wait()
        if order == "hello":
            return self._welcome(caller, **what)
        if order == "status":
            guardian = self._guardian
            return {
                "energised": guardian.energised,
                "in_hand": guardian.in_hand,
                "unresolved": sorted(guardian.unresolved),
            }
        if order == "zero":
            by_session = caller is self.session
            return [zero_message(end) for end in self._guardian.zero(_why(caller, message), by_session=by_session)]
        if order in FOR_THE_SESSION and (caller is not self.session or caller.gone):
            raise InstrumentError("only the session that drives this bench sets currents.", fault="forbidden")
        if not all(isinstance(what[name], kinds) for name, kinds in KINDS.items() if name in what):
            raise InstrumentError(f"{order} with {what} is no order.", fault="forbidden")
        return self._orders[order](**what)

    def _welcome(self, caller: Caller, who: str, bench: str) -> Message:
        """Take the caller as the session. Refused while another one drives, or zero is not confirmed.

        Where it has another bench file or is another user's, it is refused too, and the guardian makes room.
        """
        other_bench = bench != self._fingerprint or bool(caller.whose)
        self._part_from_before(caller, who)
        self._refuse_second(caller, bench)
        if other_bench:
            self.dismissed.set()
        for fault in self._guardian.unresolved.values():
            raise InstrumentError(
                fault.what,
                fault=OTHER_BENCH if other_bench else fault.fault,
                remedy=f"{fault.remedy} {TRIED_AGAIN}",
                mends=f"Guardian {os.getpid()} of user {user_name(user())} goes on trying; "
                f"where it will never answer: kill {os.getpid()}.",
            )
        if other_bench:
            raise InstrumentError(
                "the guardian has read another bench file, or is another user's; it makes room.", fault=OTHER_BENCH
            )
        for coil in self._guardian.coils.values():
            coil.tripped = None
        caller.who, self.session, self.had_session = who, caller, True
        return {"facts": self._guardian.facts()}

    def _part_from_before(self, caller: Caller, who: str) -> None:
        """The same session again, whose connection has failed: what it has set goes to zero first."""
        before = self.session
        if before is not None and before is not caller and (before.who, before.uid) == (who, caller.uid):
            before.gone = True
            self._guardian.zero(f"the connection to {who} was lost")
            self.part(before)

    def _refuse_second(self, caller: Caller, bench: str) -> None:
        other = self.session
        if other is None or other is caller or other.gone:
            return
        if time.monotonic() - other.heard_s > STALE_S and not self._guardian.energised:
            return
        whose = f" of user {user_name(user())}" if caller.whose else ""
        which, its = (
            ("another bench at these ports", "its coils to ") if bench != self._fingerprint else ("this bench", "")
        )
        raise InstrumentError(
            f"{_named(other)}{whose} drives {which}{f' since {other.since:%Y-%m-%d %H:%M} UTC' if whose else ''}.",
            fault="in use",
            remedy=f"{'Ask for it to be ended' if whose else 'End it'} first; `labcal bench off` sets {its}zero now.",
        )


def _named(caller: Caller) -> str:
    """With the word of the kernel on who that is: a person who looks for a session finds a window."""
    there = process(peer_process(caller.socket))
    window = there is not None and WINDOW in there.program
    return f"labcal's window ({caller.who})" if window else caller.who


def _why(caller: Caller, message: Message) -> str:
    return str(message.get("with", {}).get("why", f"{caller.who} said so")) + caller.whose
