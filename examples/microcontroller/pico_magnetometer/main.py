"""A magnetometer on I2C of a Raspberry Pi Pico, as a stream of its counts: copy this and mag_chips.py onto the board.

labcal's driver `i2c-board` reads it, over USB. Choose the chip and the pins, and nothing else.
"""

import time

from machine import I2C, Pin
from mag_chips import Lines, Rm3100

chip = Rm3100(I2C(0, sda=Pin(4), scl=Pin(5), freq=400000))  # or Mmc5983, Lis3mdl, Qmc5883, Bmm350
lines, there, PERIOD_MS = Lines(), False, 50

while True:
    begun = time.ticks_ms()
    try:
        there = there or chip.begin()
    except OSError:
        there = False
    line = lines.of(chip, begun)
    there = there and not line.split("*")[0].endswith("none")  # plugged in again it is set again
    print(line)
    time.sleep_ms(max(0, PERIOD_MS - time.ticks_diff(time.ticks_ms(), begun)))
