"""The session's side of the guardian: it finds or starts one, gives it orders, and lets it hear that it lives."""

from __future__ import annotations

import json
import os
import select
import socket
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from labcal.bench.coils.at_zero import AtZero
from labcal.bench.essentials import Essentials, of_table
from labcal.bench.guardian import hung, wire
from labcal.bench.guardian.briefing import Briefing
from labcal.bench.guardian.last_read import LastRead
from labcal.bench.links import ports
from labcal.errors import InstrumentError

if TYPE_CHECKING:
    import subprocess

    from labcal.bench.clock import Clock
    from labcal.bench.config import BenchConfig

BEAT_S = 0.05
NOBODY_THERE = (FileNotFoundError, ConnectionRefusedError, BlockingIOError, PermissionError, socket.timeout)
STANDBY_S = 0.3  # by then the standby of a killed guardian has the ports
START_S, AGAIN_S = 20.0, 1.0
REPLY_S = 20.0  # longer than the slowest instrument's own timeouts
LOOK_S = 0.04
UNHEARD_S, STOPPED_S = 1.0, 0.1  # so long zero goes unheard by one that hangs; by one that was stopped
REPLACED_S = 2.0  # so long a guardian stands still before its session replaces it: those who stand by are sooner
CLOSE_S = 5.0
ENDS_S, ASK_AGAIN_S = 1.0, 0.1  # to say how the coils ended waits for no line
FREED_S = 0.2  # until the kernel has freed the ports of a process that was killed

NOT_OURS = InstrumentError(
    "another user's process answers as the guardian of this bench; it is not believed.",
    fault="in use",
    remedy="See in the folder of [safety] whose it is; `labcal bench off` sets zero.",
)


class Connection:
    """One connection to a living guardian. Raises OSError where it is gone."""

    def __init__(self, card: wire.Card) -> None:
        self.card = card
        self._socket = wire.connect(card, 2.0)
        self.uid = wire.peer(self._socket)  # whose guardian it is
        self.pid = wire.peer_process(self._socket)
        self._unheard_since_s: float | None = None  # an order of zero that was not acknowledged yet
        self._still_since_s: float | None = None  # it was stopped, and has not gone on since
        self._next_look_s = 0.0
        self._socket.settimeout(None)
        self._received, self._number, self._ordered = b"", 0, ""
        self._socket.sendall(wire.packed({"token": card.get("token", "")}))

    def beat(self) -> None:
        """Let it be heard; a guardian whose ear is full has heard enough."""
        self._socket.setblocking(False)
        try:
            self._socket.send(b'{"beat": 1}\n')
        except BlockingIOError:
            pass
        finally:
            self._socket.setblocking(True)

    def order(self, order: str, **what: Any) -> int:
        """Send an order; returns its number. That zero was heard is to be acknowledged."""
        self._number, self._ordered = self._number + 1, order
        message = {"id": self._number, "order": order, "with": what}
        if order == "zero" and self.card.get(wire.ACKNOWLEDGES):
            message["acknowledge"], self._unheard_since_s = True, time.monotonic()
        self._socket.sendall(wire.packed(message))
        return self._number

    def hangs(self, stopped_s: float = STOPPED_S) -> bool:
        """Whether who was ordered zero does not hear it for longer than one that runs needs, or was stopped."""
        now = time.monotonic()
        if self._unheard_since_s is not None and now - self._unheard_since_s > UNHEARD_S:
            return True
        if now >= self._next_look_s:
            self._next_look_s = now + LOOK_S
            stands_still = hung.stands_still(self.pid)
            self._still_since_s = (self._still_since_s or now) if stands_still else None
        return self._still_since_s is not None and now - self._still_since_s >= stopped_s

    def end_who_hangs(self) -> None:
        """Kill it, so that another can take its place. Raises InstrumentError where this process may not."""
        hung.ended(self.pid, self.uid, "was ordered zero" if self._ordered == "zero" else "answers nothing")

    def reply(self, number: int, wait_s: float) -> wire.Message | None:
        """The reply to that order, if it comes within `wait_s`."""
        if select.select([self._socket], [], [], wait_s)[0]:
            if not (data := self._socket.recv(65536)):
                raise ConnectionError("the guardian closed the connection")
            self._received += data
        *lines, self._received = self._received.split(b"\n")
        replies = [json.loads(line) for line in lines]
        if replies:
            self._unheard_since_s = None
        return next((dict(reply) for reply in replies if reply.get("id") == number and "heard" not in reply), None)

    def close(self) -> None:
        """Let go."""
        self._socket.close()


class GuardianClient:
    """A session's guardian: the orders of `Server`, as methods. Reconnects to the successor of one that was killed.

    `meanwhile` is called, more than once, while one that was just started begins; it raises nothing.
    """

    def __init__(
        self, path: Path, config: BenchConfig, clock: Clock, meanwhile: Callable[[], None] = lambda: None
    ) -> None:
        self._bench, self._clock = Briefing(path, config, wire.fingerprint(path)), clock
        self._urls = config.guarded_links
        self._connection: Connection | None = None
        self._next_beat_s = 0.0
        self._lost, self._start_after_s = False, 0.0  # lost, and nobody has heard it yet
        self._untold = set[str]()  # coils whose orders have not met the loss: another's question may have
        self._failed = False  # to find or start one, when that was last tried: then nobody waits so long again
        self._started: subprocess.Popen[bytes] | None = None
        self.zero_is_ordered = False  # the last that was sent: nothing was lost since
        self._read = LastRead(clock)
        self.ended: list[AtZero] = []  # how the coils ended, as last heard of
        self._in_vain = False  # waited until all of them were read back at zero
        self.look: Callable[[], None] = lambda: None  # while an answer is waited for, but that of zero; it may raise
        self.once_ordered: Callable[[], None] = lambda: None  # zero: done while it is waited for; raises nothing
        self.facts: dict[str, dict[str, Any]] = self._meet(meanwhile)
        clock.while_waiting(self._beat)

    def ask(self, order: str, **what: Any) -> Any:
        """Give an order and wait for its reply; everything that waits on the clock goes on meanwhile.

        Raises InstrumentError or LimitError as the guardian says, InstrumentError (guardian lost) where it is gone.
        """
        reported = what.get("axis") in self._untold
        self._untold.discard(what.get("axis", ""))
        if self._lost or reported:
            self._lost = False
            raise self._read.gone()
        if self._connection is None:
            self._meet()
        try:
            answer = self._replied(self._open(), order, what)
        except OSError as error:
            self._lose()
            self._lost = False
            self._untold.discard(what.get("axis", ""))
            raise self._read.gone() from error
        if order == "measure_current":
            self._read.keep(what["axis"], answer)
        return answer

    @property
    def alive(self) -> bool:
        """Whether it is connected."""
        return self._connection is not None

    def zero(self, why: str) -> list[AtZero]:
        """Every coil to zero and open."""
        ended = [wire.zero_of(end) for end in self.ask("zero", why=why)]
        self._untold.clear()  # what holds now is sent with it
        for end in ended:
            if end.current_A is not None:
                self._read.keep(end.axis, end.current_A, end.read_s)
        return ended

    def wait_for_ends(self) -> None:
        """Hear how the coils `ended`, as their guardian read them last; wait, once, until each was read back at zero.

        It goes on trying what did not answer, and alone knows when that came to zero.
        """
        deadline = time.monotonic() + CLOSE_S * (not self._in_vain)
        while _left(ended := self._ends()) and time.monotonic() < deadline:
            self._clock.wait_until(self._clock.now() + ASK_AGAIN_S)
        self._in_vain = _left(ended)
        self.ended = ended or self.ended

    def close(self) -> None:
        """End the session, and wait until the guardian has let go of the ports, as far as it can."""
        self.wait_for_ends()
        connection, self._connection = self._connection, None
        if connection is None:
            return
        connection.close()
        if self._in_vain:  # it keeps the ports
            return
        deadline = time.monotonic() + CLOSE_S
        with suppress(OSError):  # who cannot look, out of handles, does not wait, and can say how the run ended
            while any(ports.holder(url) is not None for url in self._urls) and time.monotonic() < deadline:
                time.sleep(0.01)

    def _ends(self) -> list[AtZero] | None:
        """Asked as anybody may, so that the successor of one that was lost is heard too; None: it is at work still."""
        with suppress(OSError):
            if (connection := found(self._urls)) is not None:
                with closing(connection):
                    return None if wire.another_user(connection.uid) else self._said_of_ends(connection)
        return []

    def _said_of_ends(self, connection: Connection) -> list[AtZero] | None:
        number, deadline = connection.order("ends"), time.monotonic() + ENDS_S
        while (reply := connection.reply(number, 0.002)) is None and time.monotonic() < deadline:
            self._clock.wait_until(self._clock.now() + 1e-4)  # the beat goes on
        return None if reply is None else [wire.zero_of(end) for end in reply.get("value", [])]

    def _replied(self, connection: Connection, order: str, what: dict[str, Any]) -> Any:
        number, deadline = connection.order(order, **what), time.monotonic() + REPLY_S
        self.zero_is_ordered = order == "zero"
        if order == "zero":
            self.once_ordered()
        while (reply := connection.reply(number, 0.002)) is None:
            self._clock.wait_until(self._clock.now() + 1e-4)  # lines are looked at, and the beat goes on
            if connection.hangs(STOPPED_S if order == "zero" else REPLACED_S):
                self._replace(connection)
                raise ConnectionError("the guardian hung")
            if order != "zero":
                self.look()
            if self._connection is None or time.monotonic() > deadline:
                raise ConnectionError("no reply")
        if "error" in reply:
            raise wire.fault_of(reply["error"])
        return reply["value"]

    def _open(self) -> Connection:
        if self._connection is None:
            raise self._read.gone()
        return self._connection

    def _beat(self) -> None:
        now = time.monotonic()
        if self._lost and now > self._start_after_s:
            self._start_another()
            self._start_after_s = now + STANDBY_S
        if self._connection is None or now < self._next_beat_s:
            return
        self._next_beat_s = now + BEAT_S
        try:
            self._connection.beat()
        except OSError:
            self._lose()

    def _replace(self, who_hangs: Connection) -> None:
        """End it and start another at once: those who stand by have let it hang, or would be done by now."""
        who_hangs.end_who_hangs()
        self._lose(stood_by=False)
        deadline = time.monotonic() + FREED_S
        while any(ports.holder(url) is not None for url in self._urls) and time.monotonic() < deadline:
            time.sleep(0.005)
        self._start_another()

    def _lose(self, *, stood_by: bool = True) -> None:
        """The guardian is gone. Its standby is at it already; where that is too, another one is started soon.

        At once, where those who `stood_by` had let it hang.
        """
        if self._connection is not None:
            self._connection.close()
            self._connection, self._lost, self._started = None, True, None
            self._untold = set(self.facts)
            self.zero_is_ordered = False
            self._start_after_s = time.monotonic() + STANDBY_S * stood_by

    def _start_another(self) -> None:
        """Start a guardian, unless there is one that has the ports or is about to take them."""
        if self._started is not None and self._started.poll() is None:
            return
        if all(ports.holder(url) is None for url in self._urls):
            if not self._start_after_s:  # a successor asks nobody
                ports.refuse_connected(self._urls)
            from labcal.bench.guardian.spawn import SUCCESSOR, spawn  # not for who only says off

            self._started = spawn(self._bench, *([SUCCESSOR] if self._start_after_s else []))

    def _meet(self, meanwhile: Callable[[], None] = lambda: None) -> dict[str, dict[str, Any]]:
        """Find the guardian of these ports, or start one, and be its session."""
        me, deadline = f"session {os.getpid()}", time.monotonic() + (AGAIN_S if self._failed else START_S)
        self._failed = True
        not_met = InstrumentError(
            "the guardian did not start.", fault="guardian lost", remedy="See guardian.log in labcal's data folder."
        )
        while time.monotonic() < deadline:
            try:
                if (connection := found(self._urls)) is not None:
                    self._connection = connection
                    hello = self._replied(connection, "hello", {"who": me, "bench": self._bench.fingerprint})
                    if wire.another_user(connection.uid):
                        raise NOT_OURS
                    self._failed = False
                    return dict(hello["facts"])
                if time.monotonic() > self._start_after_s:
                    self._start_another()
                    meanwhile()
            except OSError:
                self._forget()
            except InstrumentError as fault:
                self._forget()
                if fault.fault != wire.OTHER_BENCH:
                    raise
                not_met = InstrumentError(fault.what, fault="in use", remedy=fault.remedy, mends=fault.mends)
            self._clock.wait_until(self._clock.now() + 0.02)  # whoever watches hears that it takes long
        raise not_met

    def _forget(self) -> None:
        if self._connection is not None:
            self._connection.close()
        self._connection = None


def _left(ended: Iterable[AtZero] | None) -> bool:
    return ended is None or any(end.current_A is None for end in ended)


def ask_once(connection: Connection, order: str, **what: Any) -> Any:
    """Give one order and wait for its reply, outside a session. Raises InstrumentError as the guardian says.

    A guardian that does not hear an order of zero is ended; that raises ConnectionError.
    """
    return answered(connection, connection.order(order, **what))


def answered(connection: Connection, number: int) -> Any:
    """What is replied to the order of this number; as `ask_once`."""
    deadline = time.monotonic() + REPLY_S
    while (reply := connection.reply(number, 0.05)) is None:
        if connection.hangs():
            connection.end_who_hangs()
            raise ConnectionError("the guardian hung")
        if time.monotonic() > deadline:
            raise InstrumentError(
                f"the guardian has not answered for {REPLY_S:g} s: it hangs, or was stopped; how the coils are is not "
                "known.",
                fault="guardian lost",
                remedy="Switch the supplies off by hand.",
                mends="guardian.log names its process: end it, then say off again.",
            )
    if "error" in reply:
        raise wire.fault_of(reply["error"])
    return reply["value"]


def found(urls: Iterable[str]) -> Connection | None:
    """A connection to the guardian that holds any of these ports; None where there is none (yet)."""
    return next(connections(urls), None)


def connections(urls: Iterable[str], known: Sequence[object] = ()) -> Iterator[Connection]:
    """One to each guardian that holds any of these ports, but to those at the `known` addresses."""
    addresses = list(known)
    for url in urls:
        card = ports.holder(url) or {}
        if "address" in card and card["address"] not in addresses:
            addresses.append(card["address"])
            with suppress(*NOBODY_THERE):
                yield Connection(card)


def guarding(bench: Path, known: Sequence[object] = ()) -> list[Connection]:
    """One to each guardian that was started for this bench file, whatever the file, or a link, says now.

    Those at the `known` addresses are left out. There are two where the file was replaced and a second session begun.
    """
    addresses, there = list(known), list[Connection]()
    for card in ports.announced():
        if wire.is_of(bench, card) and "address" in card and card["address"] not in addresses:
            addresses.append(card["address"])
            with suppress(*NOBODY_THERE):
                there.append(Connection(card))
    return there


def is_guarded(bench: Path) -> bool:
    """Whether a guardian of this bench file lives: it keeps trying until each coil is read back at zero."""
    return any("address" in card and wire.is_of(bench, card) for card in ports.announced())


def driven_before(bench: Path) -> list[Essentials]:
    """What guardians drove that were started for this bench file and died without bringing it to an end."""
    tables = (card.get(ports.DRIVEN) for card in ports.left_behind() if wire.is_of(bench, card))
    benches = [of_table(table) for table in tables if isinstance(table, dict)]
    return [one for k, one in enumerate(benches) if one is not None and one not in benches[:k]]


def guarded_benches() -> list[str]:
    """The bench files of all guardians that this user may see, as they were named."""
    return sorted({str(card.get("named", card["bench"])) for card in ports.announced() if "bench" in card})
