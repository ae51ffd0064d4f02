"""pymodbus' own client at the network port of the emulated LabJack T7."""

from __future__ import annotations

from contextlib import closing

import pytest
from frames import read
from pymodbus.client import ModbusTcpClient
from served_benches import Line

from drivers.labjack_t7 import LabJackT7
from labcal.bench.driver_kit.testing import scripted

BY = "pymodbus"
FLOAT = ModbusTcpClient.DATATYPE.FLOAT32
PATIENT_S, READINGS = 30, 20


@pytest.mark.met("labjack-t7", BY, "product, range of an input, no such register; 20 readings as our driver has them")
def test_labjack(line: Line) -> None:
    with closing(ModbusTcpClient("127.0.0.1", port=line.port, timeout=PATIENT_S)) as box:
        assert box.connect()
        assert box.convert_from_registers(box.read_holding_registers(60000, count=2).registers, FLOAT) == 7.0
        box.write_registers(40000, box.convert_to_registers(10.0, FLOAT))
        assert box.convert_from_registers(box.read_holding_registers(40000, count=2).registers, FLOAT) == 10.0
        assert box.read_holding_registers(999, count=2).isError()
        words = [box.read_holding_registers(0, count=6).registers for _ in range(READINGS)]
        volts = [box.convert_from_registers(six, FLOAT) for six in words]
    wire = [read("0103 0000 0006", six) for six in words]
    with scripted(LabJackT7, wire, uT_per_V=(10.0, 10.0, 10.0)) as ours:
        for three in volts:
            ours._polls.start()
            ((values,),) = (block.values.tolist() for block in ours.read_until(ours._polls._next_s))
            assert values == pytest.approx([10_000.0 * volt for volt in three])
            assert 2_000.0 < sum(one**2 for one in values) ** 0.5 < 150_000.0
