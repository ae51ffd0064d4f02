"""Three instruments that send at their own pace, in a process of their own: every sample carries its number.

`python stream_sources.py UDP_PORT` prints the pty of an HMR2300 (binary, 154 sps, it answers its commands) and the TCP
port of a 1 kHz text line; 1 kHz of space packets go to the UDP port. On a line at its standard input it ends and
prints how many samples of each it has sent.
"""

from __future__ import annotations

import select
import socket
import struct
import sys
import time
from contextlib import suppress
from types import SimpleNamespace

import numpy as np

from drivers.emulators.hmr2300 import Hmr2300Emulator
from drivers.framing import ccsds
from drivers.framing.crc16 import crc16
from labcal.bench.serve import PtyOutlet

KHZ = 1000


class Numbered:
    """A lab whose reference reads the number of the sample, in two digits of base 20 000."""

    def __init__(self) -> None:
        self.sent = 0

    def reference_nT(self, times: np.ndarray) -> np.ndarray:
        number = self.sent + np.arange(len(times))
        self.sent += len(times)
        return np.column_stack([number // 20_000, number % 20_000, -number % 20_000])


def packet(number: int, t_s: float) -> bytes:
    data = round(t_s * 65536).to_bytes(6, "big") + struct.pack(">3f", number, 0.5, -0.5) + b"\0\0"
    body = ccsds.build(100, number, data, secondary=True)[:-2]
    return body + crc16(body).to_bytes(2, "big")


def main() -> None:
    udp, to = socket.socket(socket.AF_INET, socket.SOCK_DGRAM), ("127.0.0.1", int(sys.argv[1]))
    listener, pty = socket.create_server(("127.0.0.1", 0)), PtyOutlet("serial", 19200)
    lab = Numbered()
    hmr2300 = Hmr2300Emulator(lab, {}, SimpleNamespace(id=0))
    print(pty.url, listener.getsockname()[1], flush=True)
    text = listener.accept()[0]
    begun, sent = time.monotonic(), 0
    while not select.select([sys.stdin], [], [], 0)[0]:
        now = time.monotonic() - begun
        if data := pty.read():
            hmr2300.take(now, data)
        for _, piece in hmr2300.emit(now):
            pty.write(piece)
        due = int(now * KHZ)
        if sent < due:
            lines = [f"{k / KHZ:.3f},{k},0.25,-0.25\n" for k in range(sent, due)]
            with suppress(ConnectionError):  # who listened has gone
                text.sendall("".join(lines).encode())
            for number in range(sent, due):
                udp.sendto(packet(number, number / KHZ), to)
            sent = due
        time.sleep(0.0005)
    print(lab.sent, sent, sent, flush=True)


if __name__ == "__main__":
    main()
