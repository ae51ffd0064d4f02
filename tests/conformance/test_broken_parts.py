"""Each check of `labcal.testing` fails for a part that breaks what it is about, and says what to do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from drivers.csv_line import CsvLine
from drivers.csv_line import Settings as CsvSettings
from drivers.emulators.kepco_bop import KepcoEmulator
from drivers.emulators.line import Lab
from drivers.emulators.tti_pl import TtiEmulator
from drivers.kepco_bop import KepcoBop
from drivers.tti_pl import Settings as TtiSettings
from drivers.tti_pl import TtiSupply
from drivers.zaber import ZaberStage
from labcal.bench import Bench
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.quantity import quantity
from labcal.bench.links import Link
from labcal.bench.steps import Procedure, energise, ready, record
from labcal.errors import Stopped
from labcal.fit import Fit
from labcal.fit.scalar.centered import centered
from labcal.fit.vector.ml import ml
from labcal.model import AffineMap
from labcal.record import Run
from labcal.record.stream import Prompt
from labcal.testing import check_driver, check_estimator, check_procedure
from labcal.testing.drivers import DriverCase, stages, streams
from labcal.testing.drivers.rig import installed

FORBIDDEN = [b"*RST\n"]


class IgnoresZero(TtiSupply):
    """Made safe it opens its output, gives its panel back, and keeps its set-point."""

    def make_safe(self) -> None:
        """Only half of it."""
        self.output(False)
        self.release()


class WaitsForZero(TtiSupply):
    """Written to it waits for what it holds."""

    def write_current(self, current_A: float) -> None:
        """As if nothing could be lost."""
        self.current = current_A


class LeavesAnAnswer(TtiSupply):
    """What its order of zero is answered comes when something else is asked."""

    def write_current(self, current_A: float) -> None:
        """With a question that nobody waits for."""
        super().write_current(current_A)
        self.write("I1?")


class Clips(TtiSupply):
    """Too much becomes as much as there is."""

    def set_current(self, current_A: float) -> None:
        """Clipped."""
        super().set_current(max(0.0, min(current_A, 3.0)))


class PositiveOnly(KepcoBop):
    """Bipolar by its own word, with the limits of one that is not."""

    current = quantity("CURR?", "CURR {value:.4f}", unit="A", doc="Control it.", limits=lambda s: (0.0, 3.0))


class Strict(TtiSupply):
    """Takes no byte for granted, and says so in an error of Python's."""

    def __init__(self, name: str, link: Link, clock: Clock, settings: TtiSettings) -> None:
        super().__init__(name, link, clock, settings)
        asked = self.query
        self.query = lambda text: asked(text).encode("ascii").decode()


class NoCoil(TtiEmulator):
    """It stands at no coil."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(lab, roles, settings)
        lab.coils["x"].drive = lambda *_: None


class OneUnit(TtiEmulator):
    """Whatever coil it is at, it is the same unit."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__(lab, {"coil-x": {}}, settings)


class AllowsReset(TtiSupply):
    """Nothing is forbidden."""

    never = ()


class Talks(TtiEmulator):
    """Fails where it is told no number."""

    def take(self, t_s: float, data: bytes) -> None:
        """As if every message held one."""
        if b"I1 " in data:
            float(data.split()[-1])
        super().take(t_s, data)


class Late(TtiEmulator):
    """Foresees its reply too late."""

    def due_s(self) -> float:
        """A second after it is on the line."""
        return super().due_s() + 1.0


@pytest.mark.parametrize(
    ("driver", "emulator", "says"),
    [
        (IgnoresZero, TtiEmulator, r"make_safe\(\) leaves .* A set: it sets zero and opens the output"),
        (WaitsForZero, TtiEmulator, r"write_current or write_off waits for an answer .*: put the order on the line"),
        (LeavesAnAnswer, TtiEmulator, r"lost its place after write_current\(0\) .* wait_for_quiet of labcal"),
        (Strict, TtiEmulator, r"raised UnicodeEncodeError .* in \w+ where its answers had .*: raise InstrumentError"),
        (TtiSupply, NoCoil, r"0 A flow in the simulated coil after set_current\(0\.5\): the emulator calls coil"),
        (TtiSupply, OneUnit, r"says serial number '\d+' at coil x and at coil y: make it from the role"),
        (Clips, TtiEmulator, r"set_current\(99\) must raise LimitError that says '99 A' and 'nothing was sent'"),
        (AllowsReset, TtiEmulator, r"could send b'\*RST\\n': add a pattern that matches it to `never`"),
        (TtiSupply, Talks, r"fails when it is sent .*: answer as the instrument would"),
        (TtiSupply, Late, r"due_s\(\) of the emulator says"),
    ],
)
def test_a_driver_or_emulator_that_breaks_a_promise(driver: Any, emulator: Any, says: str) -> None:
    with pytest.raises(AssertionError, match=says):
        check_driver(driver, emulator, forbidden=FORBIDDEN, to_panel=b"LOCAL\n")


def test_a_bipolar_supply_that_drives_one_way_alone() -> None:
    with pytest.raises(AssertionError, match=r"is bipolar and refuses set_current\(-0\.5\) .* limits="):
        check_driver(PositiveOnly, KepcoEmulator, forbidden=FORBIDDEN)


@pytest.mark.parametrize(
    ("stated", "forbidden", "says"),
    [
        ({"roles": "coil"}, FORBIDDEN, r'roles is \'coil\': a tuple of words, such as \("coil",\)'),
        ({"roles": ("coil-x",)}, FORBIDDEN, r"roles names 'coil-x'; the roles are coil, "),
        ({"never": rb"\*RST"}, FORBIDDEN, r"never is b'.*': a tuple of patterns in bytes, such as"),
        ({"never": (r"\*RST",)}, FORBIDDEN, r"never is \('.*',\): a tuple of patterns in bytes, such as"),
        ({}, ["*RST\n"], r"forbidden is \['.*'\]: a list of messages in bytes, such as"),
        ({"roles": ()}, FORBIDDEN, r"roles is \(\): a tuple of words"),
    ],
)
def test_what_is_stated_in_another_form(stated: dict[str, Any], forbidden: Any, says: str) -> None:
    driver: Any = type("Stated", (TtiSupply,), {"__doc__": "Another form.", **stated})
    with pytest.raises(AssertionError, match=says):
        check_driver(driver, TtiEmulator, forbidden=forbidden, to_panel=b"LOCAL\n")


def test_a_class_that_is_no_driver_or_comes_without_its_emulator() -> None:
    with pytest.raises(AssertionError, match=r"int states no `roles`"):
        check_driver(int, TtiEmulator, forbidden=FORBIDDEN)
    with pytest.raises(AssertionError, match=r"No emulator for TtiSupply: check_driver\(Driver, Emulator"):
        check_driver(TtiSupply, forbidden=FORBIDDEN)


def test_a_supply_whose_settings_have_no_greatest_current() -> None:
    @dataclass(frozen=True)
    class Fewer:
        """All but one."""

        compliance_V: float = 20.0

    class Unlimited(TtiSupply):
        """Nobody states what it may carry."""

        def __init__(self, name: str, link: Link, clock: Clock, settings: Any) -> None:
            super().__init__(name, link, clock, settings)

    Unlimited.__init__.__annotations__["settings"] = Fewer
    with pytest.raises(AssertionError, match=r"The Settings of Unlimited lack max_current_A: a supply has one"):
        check_driver(Unlimited, TtiEmulator, forbidden=FORBIDDEN)


def test_a_magnetometer_that_reads_its_own_frames_otherwise() -> None:
    class Otherwise(CsvLine):
        @staticmethod
        def parse_again(settings: CsvSettings, raw: bytes) -> NDArray[np.float64]:
            return CsvLine.parse_again(settings, raw[: raw.rindex(b"\n")])

    case = replace(installed("csv-line", forbidden=[b"x"]), driver=Otherwise)
    with pytest.raises(AssertionError, match=r"parse_again: the raw frames of its blocks.* give other samples"):
        streams.it_reads_its_own_frames_again_alike(case)


def test_a_driver_that_is_not_installed_is_told_where_it_is_declared() -> None:
    with pytest.raises(AssertionError, match=r"has 'my-supply' in labcal\.drivers\. Declare my-supply = "):
        check_driver("my-supply", forbidden=FORBIDDEN)


def test_a_stage_that_says_it_arrived_wherever_it_stopped() -> None:
    class Trusting(ZaberStage):
        def moving(self) -> bool:
            return self.state()[1]

    case = replace(installed("zaber", forbidden=[b"/renumber\r\n"]), driver=Trusting)
    assert isinstance(case, DriverCase)
    with pytest.raises(AssertionError, match=r"must raise InstrumentError .fault='not arrived'. when it stands short"):
        stages.held_it_has_not_arrived(case)


def energised(bench: Bench) -> Procedure:
    """Put 20 µT on z for a second."""
    yield from ready(bench, "The coils go on. Hands off?")
    yield from energise(bench, (0.0, 0.0, 20_000.0))
    yield from record(bench, 1.0)


def leaves_it_on(bench: Bench) -> Procedure:
    """Zero at its end, and only there."""
    yield from energised(bench)
    bench.cage.zero()


def undoes_exceptions_alone(bench: Bench) -> Procedure:
    """What is not an Exception leaves the coils on."""
    try:
        yield from energised(bench)
    except Exception:
        bench.cage.zero()
        raise
    bench.cage.zero()


def goes_on(bench: Bench) -> Procedure:
    """Whatever happens is kept to itself."""
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        try:
            yield from energised(bench)
        except (Exception, Stopped):
            return


def asks_nobody(bench: Bench) -> Procedure:
    """Energises at once, by the cage itself."""
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)
        bench.cage.set_field((0.0, 0.0, 20_000.0), confirm_signs=False)
        yield from record(bench, 1.0)


def turns_under_hands(bench: Bench) -> Procedure:
    """Asks for something more after hands off, and turns."""
    yield from ready(bench, "The platform turns. Hands off?")
    yield Prompt(bench.clock.now(), "cover", "Put the cover on.", acts=True)
    bench.platform.home()
    while bench.platform.moving():
        yield from record(bench, 0.5)
    bench.platform.move_to(90.0, 10.0)
    yield from record(bench, 1.0)


def never_zero(bench: Bench) -> Procedure:
    """Leaves it to others."""
    yield from energised(bench)


@pytest.mark.parametrize(
    ("procedure", "says"),
    [
        pytest.param(never_zero, r"leaves 0\.\d+ A in a coil at its end: with ExitStack", marks=pytest.mark.slow),
        (leaves_it_on, r"leaves 0\.\d+ A in a coil after a stop at .*: with ExitStack"),
        pytest.param(
            undoes_exceptions_alone, r"leaves 0\.\d+ A in a coil after (a stop|Ctrl-C) at", marks=pytest.mark.slow
        ),
        (goes_on, r"ends as 'finished' after an exception at .*: let what it does not know pass"),
        (asks_nobody, r"asks-nobody energises at .* where nobody has said hands off: yield from ready"),
        (turns_under_hands, r"turns-under-hands turns the platform at .* where nobody has said hands off"),
    ],
)
def test_a_procedure_that_breaks_a_promise(procedure: Callable[..., Procedure], says: str) -> None:
    with pytest.raises(AssertionError, match=says):
        check_procedure(procedure, moments=3)


def scaled(by: float) -> Callable[..., Fit]:
    def estimator(run: Run) -> Fit:
        found = centered(run)
        return found if found.covariance is None else replace(found, covariance=by * found.covariance)

    return estimator


def with_map(change: Callable[[AffineMap], AffineMap]) -> Callable[..., Fit]:
    def estimator(run: Run) -> Fit:
        found = ml(run)
        return found if found.affine is None else replace(found, affine=change(found.affine))

    return estimator


def sure(run: Run) -> Fit:
    """Answers whatever it is asked."""
    found = ml(run)
    return found if found.ok else Fit("sure", ok=True, affine=AffineMap.nominal(1.0), frame_known=True)


DRAWN = np.random.default_rng(0)


def drawn(run: Run) -> Fit:
    """Another answer each time."""
    found = ml(run)
    if found.affine is None:
        return found
    return replace(found, affine=replace(found.affine, k_nT=found.affine.k_nT + DRAWN.normal(0, 0.1, 3)))


@pytest.mark.parametrize(
    ("by", "says"), [(0.25, r"are [12]\.\d+ times its .* is too small"), (4.0, r"are 0\.\d+ times its .* is too large")]
)
def test_an_estimator_that_is_too_sure_or_not_sure_enough(by: float, says: str) -> None:
    with pytest.raises(AssertionError, match=says):
        check_estimator(scaled(by), ["scalar"], seeds=10)


@pytest.mark.parametrize(
    ("estimator", "says"),
    [
        (with_map(lambda a: AffineMap(a.K.T, a.k_nT)), r"is off by .* of the map without noise"),
        (with_map(lambda a: AffineMap(a.K, -a.k_nT)), r"is off by .* of the map without noise"),
        (with_map(lambda a: AffineMap(a.K, a.k_nT + 20 * a.K[0])), r"gives another answer to turned readings"),
        (sure, r"calibrates a run without a reference: answer Fit"),
        (drawn, r"answers the same run twice differently"),
    ],
)
def test_an_estimator_that_breaks_its_contract(estimator: Callable[..., Fit], says: str) -> None:
    with pytest.raises(AssertionError, match=says):
        check_estimator(estimator, ["axis"], seeds=10, exact=0.01)
