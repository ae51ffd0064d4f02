"""How an HMR2300 is spoken to: words with its number, answered up to a carriage return; a stream is ended by ESC."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.links import Link, quoted
from labcal.bench.links.line import wait_for_quiet
from labcal.errors import InstrumentError

ESC = b"\x1b"
QUIET_S = 0.05  # after the stream was ended, until the last of it has come through an adapter
TRIES = 3  # at a line that does not fall quiet
EXTRA_S = 0.003  # behind a reply, in which a byte too much shows


@dataclass(frozen=True, slots=True)
class Words:
    """The line to the magnetometer `name`, whose number is `device`."""

    name: str
    link: Link
    clock: Clock
    device: int
    timeout_s: float

    def send(self, words: str) -> None:
        """Say it."""
        self.link.send(self._request(words))

    def ask(self, words: str, expected: str) -> str:
        """What follows the expected reply. Raises InstrumentError (refused) where it is another one."""
        came = self.link.ask(self._request(words), end=b"\r", timeout_s=self.timeout_s).decode("ascii", "replace")
        if not (reply := came.strip()).replace(" ", "_").startswith(expected.replace(" ", "_")):
            raise InstrumentError(
                f"{self.name}: {words!r} was answered with {quoted(reply)}, not {expected}.", fault="refused"
            )
        return reply[len(expected) :].strip(" _")

    def change(self, words: str, expected: str) -> None:
        """Change a setting, which must be allowed just before."""
        self.ask("WE", "OK")
        self.ask(words, expected)

    def poll(self, end: bytes | int) -> bytes:
        """One sample, with all that came too much behind it."""
        reply = self.link.ask(self._request("P"), end=end, timeout_s=self.timeout_s)
        return reply + b"".join(data for _, data in self.link.receive(self.clock.now() + EXTRA_S))

    def hush(self) -> None:
        """End the stream, and let the last of it go by."""
        self.link.send(ESC)
        wait_for_quiet(self.link, self.clock, QUIET_S)

    def silenced(self) -> None:
        """As `hush`, and see by an answer that the stream has ended. Raises InstrumentError where it does not."""
        for left in reversed(range(TRIES)):
            try:
                self.hush()
                self.ask("WE", "OK")
                return
            except InstrumentError:
                if not left:
                    raise

    def _request(self, words: str) -> bytes:
        return f"*{self.device:02d}{words}\r".encode()
