"""A coil supply out of a Raspberry Pi Pico and three H-bridges: copy this and coil_protocol.py onto the board.

labcal's driver `microcontroller` speaks to it, over USB. Change pins, limit and sense, and nothing else.
"""

import select
import sys
import time

import micropython
from coil_protocol import Protocol
from machine import ADC, PWM, WDT, Pin

WHO = {
    "maker": "my-lab", "model": "pico-bridge", "serial": "0001", "firmware": "1.0", "channels": 3, "unit": "ppm",
    "limit": 900000, "watchdog_ms": 1000, "sense": 1,
}  # fmt: skip
FORWARD, BACKWARD, SENSE = (2, 4, 6), (3, 5, 7), (26, 27, 28)
SENSE_ZERO, SENSE_UA_PER_COUNT = 32768, 272  # counts of 16 bits at 0 A; of a sensor of 185 mV/A at 3.3 V
PWM_HZ = 20000


class Bridges:
    """Two inputs a bridge, such as DRV8871."""

    def __init__(self):
        self.forward, self.backward = [self.pwm(p) for p in FORWARD], [self.pwm(p) for p in BACKWARD]
        self.sense, self.applied = [ADC(p) for p in SENSE], [0, 0, 0]

    def pwm(self, pin):
        """A pin that is low."""
        Pin(pin, Pin.OUT, value=0)
        pwm = PWM(Pin(pin))
        pwm.freq(PWM_HZ)
        pwm.duty_u16(0)
        return pwm

    def drive(self, c, value):
        """Apply a signed duty."""
        down, up = (self.forward[c], self.backward[c]) if value < 0 else (self.backward[c], self.forward[c])
        down.duty_u16(0)  # one side down before the other goes up
        up.duty_u16(abs(value) * 65535 // 1000000)
        self.applied[c] = value

    def open(self, c):
        """Both inputs low: the bridge lets go."""
        self.forward[c].duty_u16(0)
        self.backward[c].duty_u16(0)
        self.applied[c] = 0

    def measured(self, c):
        """What flows [uA]; without a sensor what is applied."""
        if not WHO["sense"]:
            return self.applied[c]
        return (self.sense[c].read_u16() - SENSE_ZERO) * SENSE_UA_PER_COUNT


protocol = Protocol(WHO, Bridges())
protocol.begin()
micropython.kbd_intr(-1)  # no byte of the line may end this program
guard = WDT(timeout=500)  # a loop that hangs resets the board, and a reset opens the bridges
incoming = select.poll()
incoming.register(sys.stdin, select.POLLIN)
heard_ms = time.ticks_ms()
while True:
    guard.feed()
    protocol.tick(time.ticks_diff(time.ticks_ms(), heard_ms))
    if incoming.poll(1):
        reply = protocol.take(sys.stdin.buffer.read(1))
        if reply is not None:
            heard_ms = time.ticks_ms()
            sys.stdout.buffer.write(reply)
