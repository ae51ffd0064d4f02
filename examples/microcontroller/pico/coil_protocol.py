"""labcal-coil/1, the firmware's side, in MicroPython (docs/microcontroller.md). It runs in CPython too, for tests."""

LONGEST_LINE = 48
ARGUMENTS = {"WHO": 0, "BEAT": 0, "SET?": 1, "MEAS?": 1, "OUT?": 1, "TRIP?": 1, "SET": 2, "OUT": 2}


def crc8(data):
    """CRC-8, polynomial 07h from 0: F4h for b"123456789"."""
    value = 0
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = (value << 1 ^ 0x07) & 0xFF if value & 0x80 else value << 1
    return value


def whole(text, most, sign=False):
    """A whole number of at most `most` digits; None for all else."""
    digits = text[1:] if sign and text[:1] == "-" else text
    if not 1 <= len(digits) <= most or not all(c in "0123456789" for c in digits):
        return None
    return int(text)


class Protocol:
    """`who`: maker, model, serial, firmware, channels, unit ("uA" or "ppm"), limit, watchdog_ms, sense (0, 1).

    `bridges` has drive(channel, value), open(channel), measured(channel), channels from 0.
    """

    def __init__(self, who, bridges):
        self.who, self.bridges, n = who, bridges, who["channels"]
        self.value, self.on, self.tripped = [0] * n, [False] * n, [False] * n
        self.silent_ms, self.left_ms, self.line, self.too_long = 0, 0, b"", False

    def begin(self):
        """All bridges open."""
        for c in range(self.who["channels"]):
            self.rest(c)

    def tick(self, silent_ms):
        """`silent_ms`: since the last valid line. To be called all the time."""
        self.silent_ms = silent_ms
        if not self.who["watchdog_ms"] or silent_ms <= self.who["watchdog_ms"]:
            return
        for c in range(self.who["channels"]):
            self.tripped[c] = self.tripped[c] or self.on[c]
            self.rest(c)

    def take(self, byte):
        """One byte (b"x") that came; the line to be sent, or None where nothing is to be said."""
        if byte != b"\n":
            self.too_long = self.too_long or len(self.line) >= LONGEST_LINE
            self.line = self.line if self.too_long else self.line + byte
            return None
        line, too_long, self.line, self.too_long = self.line, self.too_long, b"", False
        if line[-1:] == b"\r":
            line = line[:-1]
        return None if too_long else self.answer(line)

    def answer(self, line):
        """The reply to a whole, valid line; None for all else."""
        if len(line) < 5 or line[-3:-2] != b"*" or line[-2:] != b"%02X" % crc8(line[:-3]) or b"\0" in line:
            return None
        number, blank, words = "".join(chr(c) for c in line[:-3]).partition(" ")
        if whole(number, 3) is None or not blank:
            return None
        self.left_ms = max(0, self.who["watchdog_ms"] - self.silent_ms)
        self.silent_ms = 0
        why, said = self.obey(words)
        reply = " ".join((str(int(number)), "ERR" if why else "OK", why or said)).encode()
        return reply + b"*%02X\n" % crc8(reply)

    def obey(self, words):
        """Why not, or "", and what is answered."""
        word, *rest = words.split(" ")
        if word not in ARGUMENTS:
            return "word", ""
        if len(rest) != ARGUMENTS[word]:
            return "number", ""
        channel = whole(rest[0], 1) if rest else 1
        value = whole(rest[1], 9, True) if len(rest) > 1 else 0
        if channel is None or value is None:
            return "number", ""
        if not 1 <= channel <= self.who["channels"]:
            return "channel", ""
        return self.act(word, channel - 1, value)

    def act(self, word, c, value):
        """Likewise, of a word with its numbers."""
        if word == "SET":
            return self.set(c, value)
        if word == "OUT":
            return self.output(c, value)
        if word == "BEAT":
            return ("watchdog", "") if any(self.tripped) else ("", str(self.left_ms))
        if word == "WHO":
            form = "labcal-coil/1 %s %s %s %s channels=%d unit=%s limit=%d watchdog_ms=%d sense=%d"
            names = ("maker", "model", "serial", "firmware", "channels", "unit", "limit", "watchdog_ms", "sense")
            return "", form % tuple(self.who[name] for name in names)
        if word == "TRIP?":
            return "", "watchdog" if self.tripped[c] else "none"
        if word == "MEAS?":
            return "", str(self.bridges.measured(c))
        return "", str(self.value[c] if word == "SET?" else int(self.on[c]))

    def set(self, c, value):
        """A set-point: within the limit, and other than zero only where the bridge drives."""
        if abs(value) > self.who["limit"]:
            return "range", ""
        if value and not self.on[c]:
            return ("watchdog" if self.tripped[c] else "off"), ""
        self.value[c] = value
        if self.on[c]:
            self.bridges.drive(c, value)
        return "", str(value)

    def output(self, c, value):
        """On, at zero, or off: zero and open."""
        if value not in (0, 1):
            return "number", ""
        if value:
            if not self.on[c]:
                self.bridges.drive(c, 0)
            self.on[c], self.tripped[c] = True, False
        else:
            self.rest(c)
        return "", str(value)

    def rest(self, c):
        """Zero and open."""
        self.value[c], self.on[c] = 0, False
        self.bridges.open(c)
