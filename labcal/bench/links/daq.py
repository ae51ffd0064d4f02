"""daq:// analogue inputs through their maker's own module, asked by lines: daq://u6, daq://u6/360012345, daq://ni/Dev1.

`who` is answered by maker, model, serial and version; `ain 0,1,2 single 10 4` by the mean of four readings of each
input [V], `differential` in place of `single` measures each against the next; what cannot be done by `?` and why.
"""

from __future__ import annotations

import errno
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout, suppress
from functools import partial
from importlib import import_module
from io import StringIO
from typing import Any, Protocol, TypeVar

from labcal.errors import InputError

T = TypeVar("T")
FORM = "expected daq://u6, daq://u6/SERIAL or daq://ni/NAME, such as daq://ni/Dev1"
GAINS = {10.0: 0, 1.0: 1, 0.1: 2, 0.01: 3}  # of a U6, by range [V]


class Box(Protocol):
    """What both makers' boxes can do."""

    def who(self) -> Sequence[str]:
        """Maker, model, serial, version."""
        ...

    def volts(self, inputs: Sequence[int], differential: bool, range_V: float, count: int) -> Sequence[float]:
        """The mean of `count` readings of each input."""
        ...

    def close(self) -> None:
        """Let go."""
        ...


class DaqPort:
    """A box whose module is asked when a line is written; the answer is there at the next look."""

    byte_s = 0.0

    def __init__(self, address: str) -> None:
        kind, _, which = address.partition("/")
        if kind not in BOXES or ((kind == "ni") != bool(which) and not which.isdigit()):
            raise InputError(f"link 'daq://{address}': {FORM}")
        self._box = _called(lambda: BOXES[kind](which))
        self._said = b""

    def read(self) -> bytes:
        """What was answered since the last look."""
        said, self._said = self._said, b""
        return said

    def write(self, data: bytes) -> None:
        """Ask. Raises OSError where the box is gone."""
        for line in data.decode("ascii", "replace").splitlines():
            self._said += _called(partial(self._answer, line.split())).encode() + b"\n"

    def there(self) -> bool:
        """It is, unless an error says otherwise."""
        return True

    def close(self) -> None:
        """Let go."""
        with suppress(OSError):
            _called(self._box.close)

    def _answer(self, words: Sequence[str]) -> str:
        try:
            match words:
                case ["who"]:
                    return ",".join(self._box.who())
                case ["ain", inputs, ("single" | "differential") as wiring, range_V, count]:
                    numbers = [int(one) for one in inputs.split(",")]
                    read = self._box.volts(numbers, wiring == "differential", float(range_V), int(count))
                    return ",".join(f"{volts:.7f}" for volts in read)
        except ValueError as why:
            return f"? {why}"
        return "? not known"


class U6:
    """A LabJack U6 through LabJackPython, which applies the box's own calibration."""

    def __init__(self, serial: str) -> None:
        with redirect_stdout(StringIO()):  # without its driver the module says so on stdout
            module, maker = _module("u6", "LabJackPython"), _module("LabJackPython", "LabJackPython")
        if maker.staticLib is None:
            raise InputError("daq://u6 needs LabJack's own driver on this computer (Linux, macOS: the Exodriver)")
        self._device = module.U6(autoOpen=False)
        self._device.open(**({"firstFound": False, "serial": int(serial)} if serial else {}))
        self._facts = self._device.configU6()

    def who(self) -> Sequence[str]:
        """As its configuration says."""
        facts = self._facts
        return "LabJack", str(facts["DeviceName"]), str(facts["SerialNumber"]), str(facts["FirmwareVersion"])

    def volts(self, inputs: Sequence[int], differential: bool, range_V: float, count: int) -> Sequence[float]:
        """One input after the other, `count` times."""
        if range_V not in GAINS:
            raise ValueError(f"a U6 has the ranges {', '.join(f'{one:g}' for one in GAINS)} V")
        options = {"gainIndex": GAINS[range_V], "differential": differential}
        rows = [[self._device.getAIN(one, **options) for one in inputs] for _ in range(count)]
        return [sum(column) / count for column in zip(*rows, strict=True)]

    def close(self) -> None:
        """Let go."""
        self._device.close()


class Ni:
    """A device of National Instruments through nidaqmx: one task, made anew where other inputs are asked for."""

    def __init__(self, name: str) -> None:
        self._modules = _module("nidaqmx", "nidaqmx")
        self._name, self._task = name, None
        self._made: tuple[float, ...] = ()
        device = import_module("nidaqmx.system").Device(name)
        self._facts = str(device.product_type), f"{device.serial_num:X}"

    def who(self) -> Sequence[str]:
        """Its type and serial number."""
        return "National Instruments", *self._facts, ""

    def volts(self, inputs: Sequence[int], differential: bool, range_V: float, count: int) -> Sequence[float]:
        """`count` readings of all inputs, as fast as it gives them."""
        if (made := (*inputs, differential, range_V)) != self._made:
            self.close()
            self._task, self._made = self._begun(inputs, differential, range_V), made
        rows: Any = self._task
        return [sum(row) / count for row in rows.read(number_of_samples_per_channel=count)]

    def close(self) -> None:
        """Let go."""
        task: Any = self._task
        self._task, self._made = None, ()
        if task is not None:
            task.close()

    def _begun(self, inputs: Sequence[int], differential: bool, range_V: float) -> Any:
        kinds = import_module("nidaqmx.constants").TerminalConfiguration
        task = self._modules.Task()
        wiring = kinds.DIFF if differential else kinds.RSE
        for one in inputs:
            task.ai_channels.add_ai_voltage_chan(
                f"{self._name}/ai{one}", terminal_config=wiring, min_val=-range_V, max_val=range_V
            )
        return task


BOXES: dict[str, Callable[[str], Box]] = {"u6": U6, "ni": Ni}


def _module(name: str, package: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        raise InputError(f"daq:// needs {package} here; install it: pip install 'labcal[daq]'") from error


def _called(call: Callable[[], T]) -> T:
    """What a maker's module raises is a lost line; each has errors of its own, and some raise plain Exception."""
    try:
        return call()
    except (InputError, OSError):
        raise
    except Exception as error:
        raise OSError(errno.EIO, f"{type(error).__name__}: {error}") from error
