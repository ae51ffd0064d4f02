"""labcal-mag/1, the firmware's side in MicroPython: five magnetometers on I2C, each reading a line of its counts."""

import time

NONE, FULL, FINE = "none", "full", ""  # it does not answer; its converter is at its end; counts


def signed(value, bits):
    """Two's complement."""
    return value - (1 << bits) if value >> (bits - 1) else value


def within(counts, least, most):
    """Whether no axis is at an end."""
    return FINE if all(least < c < most for c in counts) else FULL


class Chip:
    """Registers of a chip on a bus with the methods of `machine.I2C`. OSError: it did not acknowledge."""

    name, at = "", 0

    def __init__(self, bus, address=None):
        self.bus, self.at = bus, self.at if address is None else address

    def put(self, register, value):
        """Write one register."""
        self.bus.writeto_mem(self.at, register, bytes([value]))

    def get(self, register, count=1):
        """Read from one register on."""
        return self.bus.readfrom_mem(self.at, register, count)

    def ready(self, register, bit, tries):
        """Wait for a bit of its status."""
        for _ in range(tries):
            if self.get(register)[0] & bit:
                return
            time.sleep(0.001)
        raise OSError("not ready")


class Rm3100(Chip):
    """PNI RM3100: 24 bits, high byte first; its scale goes with the cycle count."""

    name, at, cycles = "rm3100", 0x20, 200

    def begin(self):
        """True: it is that chip, and was set."""
        if self.get(0x36)[0] != 0x22:
            return False
        for register in range(0x04, 0x0A):
            self.put(register, self.cycles if register & 1 else 0)
        return True

    def read(self):
        """State, and x, y, z in its own axes."""
        self.put(0x00, 0x70)
        self.ready(0x34, 0x80, 60)
        raw = self.get(0x24, 9)
        counts = [signed(raw[k] << 16 | raw[k + 1] << 8 | raw[k + 2], 24) for k in (0, 3, 6)]
        return within(counts, -8388608, 8388607), counts


class Mmc5983(Chip):
    """MEMSIC MMC5983MA: 18 bits; the reading after SET less that after RESET, so its bridge's offset is out."""

    name, at = "mmc5983", 0x30

    def begin(self):
        """True: it is that chip, and was set."""
        if self.get(0x2F)[0] != 0x30:
            return False
        self.put(0x0A, 0x00)
        return True

    def read(self):
        """State, and x, y, z in its own axes."""
        after, state = [], FINE
        for word in (0x08, 0x10):
            self.put(0x09, word)
            time.sleep(0.001)
            self.put(0x09, 0x01)
            self.ready(0x08, 0x01, 30)
            raw = self.get(0x00, 7)
            after.append([raw[2 * k] << 10 | raw[2 * k + 1] << 2 | raw[6] >> (6 - 2 * k) & 3 for k in range(3)])
            state = state or within(after[-1], 0, 262143)
        return state, [after[0][k] - after[1][k] for k in range(3)]


def low_first(raw):
    """16 bits, low byte first, of chips that measure by themselves."""
    return [signed(raw[k + 1] << 8 | raw[k], 16) for k in (0, 2, 4)]


class Lis3mdl(Chip):
    """ST LIS3MDL at +-4 gauss and 20 Hz, its finest performance on all axes."""

    name, at = "lis3mdl", 0x1C

    def begin(self):
        """True: it is that chip, and was set."""
        if self.get(0x0F)[0] != 0x3D:
            return False
        for register, value in ((0x20, 0x74), (0x21, 0x00), (0x23, 0x0C), (0x24, 0x40), (0x22, 0x00)):
            self.put(register, value)
        return True

    def read(self):
        """State, and x, y, z in its own axes."""
        self.ready(0x27, 0x08, 100)
        counts = low_first(self.get(0xA8, 6))  # 28h, counted on
        return within(counts, -32768, 32767), counts


class Qmc5883(Chip):
    """QST QMC5883L (not its pin-compatible forerunner HMC5883L, nor a QMC5883P) at +-2 gauss and 50 Hz."""

    name, at = "qmc5883", 0x0D

    def begin(self):
        """True: it is that chip, and was set."""
        if self.get(0x0D)[0] != 0xFF:
            return False
        self.put(0x0B, 0x01)
        self.put(0x09, 0x05)
        return True

    def read(self):
        """State, and x, y, z in its own axes."""
        self.ready(0x06, 0x01, 60)
        raw = self.get(0x00, 7)
        counts = low_first(raw)
        return FULL if raw[6] & 0x02 else within(counts, -32768, 32767), counts


class Bmm350(Chip):
    """Bosch BMM350 at 25 Hz: 24 bits, low byte first, as they are before the corrections that its memory holds."""

    name, at = "bmm350", 0x14

    def get(self, register, count=1):
        """Read from one register on; two bytes come before each answer."""
        return Chip.get(self, register, count + 2)[2:]

    def begin(self):
        """True: it is that chip, and was set."""
        if self.get(0x00)[0] != 0x33:
            return False
        self.put(0x50, 0x80)
        for register, value in ((0x06, 0x07), (0x06, 0x05), (0x04, 0x26), (0x06, 0x02), (0x05, 0x07), (0x06, 0x01)):
            self.put(register, value)  # its magnetic reset, the rate, three axes, on
            time.sleep(0.04)
        return True

    def read(self):
        """State, and x, y, z in its own axes."""
        self.ready(0x30, 0x04, 60)
        raw = self.get(0x31, 9)
        counts = [signed(raw[k + 2] << 16 | raw[k + 1] << 8 | raw[k], 24) for k in (0, 3, 6)]
        return within(counts, -8388608, 8388607), counts


def crc16(data):
    """CRC-16 with polynomial 1021h from FFFFh, not reflected: 29B1h for "123456789"."""
    value = 0xFFFF
    for byte in data:
        value ^= byte << 8
        for _ in range(8):
            value = (value << 1 ^ 0x1021) & 0xFFFF if value & 0x8000 else value << 1
    return value


class Lines:
    """The next line of a chip: NUMBER CHIP MS X Y Z*HHHH, or NUMBER CHIP MS full*HHHH, … none*HHHH."""

    def __init__(self):
        self.number = 0

    def of(self, chip, now_ms):
        """One line, without its end."""
        try:
            state, counts = chip.read()
        except OSError:
            state, counts = NONE, []
        said = state or " ".join(map(str, counts))
        text = f"{self.number} {chip.name} {now_ms} {said}"
        self.number = (self.number + 1) % 1000
        return f"{text}*{crc16(text.encode()):04X}"
