"""A supply that is described by a table: its words, the checks of the table, and every table that comes with labcal."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest
from pydantic import TypeAdapter, ValidationError

from drivers.framing.scpi_table import TABLES, Table, names, shipped
from drivers.scpi_table import Settings, TableSupply
from labcal.bench.clock import RealClock
from labcal.bench.config import read_config
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.bench.loading import Loader
from labcal.bench.serve import toml
from labcal.errors import InputError, InstrumentError, LimitError
from labcal.testing.drivers import check_driver, installed

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
NONE = (b"SYST:ERR?\n", b"0  No Error\n")


def spd(*said: bytes) -> list[Exchange]:
    """What an SPD3303X is told, each followed by the question for errors."""
    return [exchange for one in said for exchange in ((one + b"\n", SILENT), NONE)]


def siglent(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(TableSupply, wire, model="siglent-spd3303x", channel=2, max_current_A=2.5, **stated)


def hmp(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(TableSupply, wire, model="rohde-schwarz-hmp", channel=3, **stated)


def test_an_spd3303x_is_told_its_channel_in_every_message() -> None:
    wire = [*spd(b"CH2:CURR 0.500"), (b"CH2:CURR?\n", b"0.500\n"), (b"MEAS:CURR? CH2\n", b"0.499\n")]
    with siglent(wire) as supply:
        supply.set_current(0.5)
        assert supply.measure_current() == 0.499


def test_its_output_is_a_bit_of_its_status() -> None:
    on = [*spd(b"CH2:VOLT 5.000"), (b"CH2:VOLT?\n", b"5.00\n"), *spd(b"OUTP CH2,ON"), (b"SYST:STAT?\n", b"0x0224\n")]
    with siglent([*on, *spd(b"OUTP CH2,OFF"), (b"SYST:STAT?\n", b"0x0014\n")]) as supply:
        supply.output(True)
        supply.output(False)


def test_another_channels_bit_is_not_its_own() -> None:
    wire = [*spd(b"OUTP CH2,OFF"), (b"SYST:STAT?\n", b"0x24\n")]
    with siglent(wire) as supply, pytest.raises(InstrumentError, match="reads back") as caught:
        supply.output(False)
    assert caught.value.fault == "read-back"


@pytest.mark.parametrize("reply", [b"\n", b"0xZZ\n", b"ON;OFF\n"])
def test_a_status_that_is_no_number_is_a_wrong_reply(reply: bytes) -> None:
    with siglent([*spd(b"OUTP CH2,OFF"), (b"SYST:STAT?\n", reply)]) as supply, pytest.raises(InstrumentError) as caught:
        supply.output(False)
    assert caught.value.fault == "wrong reply"


def test_an_hmp_is_told_its_channel_on_the_same_line_and_that_it_is_remote() -> None:
    fine = (b"SYST:ERR?\n", b'0, "No error"\n')
    wire = [(b"SYST:REM\n", SILENT), fine, (b"INST:NSEL 3;:CURR 0.5000\n", SILENT), fine,
            (b"INST:NSEL 3;:CURR?\n", b"0.5000\n"), (b"INST:NSEL 3;:CURR 0.2000\n", SILENT), fine,
            (b"INST:NSEL 3;:CURR?\n", b"0.2000\n")]  # fmt: skip
    with hmp(wire) as supply:
        supply.set_current(0.5)
        supply.set_current(0.2)


def test_zero_that_waits_for_nothing_says_remote_too() -> None:
    with hmp([(b"SYST:REM\n", SILENT), (b"INST:NSEL 3;:CURR 0.0000\n", SILENT)]) as supply:
        supply.write_current(0.0)


def test_what_it_refuses_is_said_and_remote_is_said_anew() -> None:
    fine = (b"SYST:ERR?\n", b'0, "No error"\n')
    wire = [(b"SYST:REM\n", SILENT), fine, (b"INST:NSEL 3;:CURR 0.5000\n", SILENT),
            (b"SYST:ERR?\n", b'-222, "Data out of range"\n'), (b"SYST:REM\n", SILENT), fine,
            (b"INST:NSEL 3;:CURR 0.2000\n", SILENT), fine, (b"INST:NSEL 3;:CURR?\n", b"0.2000\n")]  # fmt: skip
    with hmp(wire) as supply:
        with pytest.raises(InstrumentError, match="Data out of range") as caught:
            supply.set_current(0.5)
        supply.set_current(0.2)
    assert caught.value.fault == "refused"


@pytest.mark.parametrize(
    ("status", "kind"), [(b"1\n", "over-voltage"), (b"2\n", "over-current"), (b"16\n", "over-temp")]
)
def test_a_trip_of_a_6632b_is_a_bit_of_its_register(status: bytes, kind: str) -> None:
    wire = [(b"CURR 1.0000\n", SILENT), (b"SYST:ERR?\n", b'+0,"No error"\n'), (b"CURR?\n", b"+1.00000E+00\n"),
            (b"MEAS:CURR?\n", b"+2.10000E-04\n"), *[(b"STAT:QUES:COND?\n", status)] * 3]  # fmt: skip
    with scripted(TableSupply, wire, model="agilent-66xx") as supply:
        supply.set_current(1.0)
        with pytest.raises(InstrumentError, match=f"its {kind}.* protection tripped") as caught:
            supply.measure_current()
    assert caught.value.fault == "tripped"


def test_another_maker_or_model_is_refused() -> None:
    for said in (b"Siglent Technologies,SPD1305X,X,1\n", b"RIGOL TECHNOLOGIES,DP832,X,1\n"):
        with siglent([(b"*IDN?\n", said)]) as supply, pytest.raises(InstrumentError) as caught:
            supply.identify()
        assert caught.value.fault == "another instrument"


def test_a_supply_that_tells_no_errors_is_asked_for_none() -> None:
    table = TypeAdapter(Table).validate_python(plain(errors="", terminator="\r"))
    wire: list[Exchange] = [(b"*IDN?\r", b"ACME,PS 1,7,1\r"), (b"CURR 0.500\r", SILENT), (b"CURR?\r", b"0.500\r")]
    with scripted(TableSupply, wire, table=table) as supply:
        assert supply.identify().serial == "7"
        supply.set_current(0.5)


def test_a_supply_with_both_signs_takes_both_within_its_limit() -> None:
    table = TypeAdapter(Table).validate_python(plain(bipolar=True))
    wire: list[Exchange] = [(b"CURR -0.500\n", SILENT), (b"SYST:ERR?\n", b'0,"No error"\n'), (b"CURR?\n", b"-0.500\n")]
    with scripted(TableSupply, wire, table=table) as supply:
        assert supply.bipolar
        supply.set_current(-0.5)
        with pytest.raises(LimitError, match="nothing was sent"):
            supply.set_current(-1.01)


PBZ = b"KIKUSUI,PBZ40-10,AB000001,IFC02.00.0011 IOC02.00.0015\n"


def test_a_pbz_has_both_signs_once_it_says_that_it_is_in_constant_current() -> None:
    fine = (b"SYST:ERR?\n", b'0,"No error"\n')
    identification: list[Exchange] = [(b"*IDN?\n", PBZ), fine, (b"FUNC:MODE?\n", b"CC\n"), (b"FUNC:POL?\n", b"BIP\n"),
                                (b"VOLT:PROT:STAT?\n", b"LIM\n")]  # fmt: skip
    wire = [*identification, (b"CURR -1.5000\n", SILENT), fine, (b"CURR?\n", b"-1.5000\n")]
    with scripted(TableSupply, wire, model="kikusui-pbz", max_current_A=5.0) as supply:
        assert supply.identify().serial == "AB000001"
        supply.set_current(-1.5)
        assert not supply.can_open


MODES = {b"FUNC:MODE?\n": b"CC\n", b"FUNC:POL?\n": b"BIP\n", b"VOLT:PROT:STAT?\n": b"LIM\n"}


@pytest.mark.parametrize(
    ("question", "reply"),
    [(b"FUNC:MODE?\n", b"CV\n"), (b"FUNC:POL?\n", b"UNIP\n"), (b"VOLT:PROT:STAT?\n", b"TRIP\n")],
)
def test_a_pbz_in_another_mode_is_refused(question: bytes, reply: bytes) -> None:
    before = list(MODES.items())[: list(MODES).index(question)]
    wire: list[Exchange] = [(b"*IDN?\n", PBZ), (b"SYST:ERR?\n", b'0,"No error"\n'), *before, (question, reply)]
    with scripted(TableSupply, wire, model="kikusui-pbz") as supply, pytest.raises(InstrumentError) as caught:
        supply.identify()
    assert caught.value.fault == "wrong mode"
    assert "Set it at its panel" in caught.value.remedy


def test_the_voltage_of_a_pbz_is_limited_on_both_sides_before_its_output_goes_on() -> None:
    fine = (b"SYST:ERR?\n", b'0,"No error"\n')
    wire = [(b"VOLT:LIM:LOW -5.000\n", SILENT), fine, (b"VOLT:LIM:LOW?\n", b"-5.00000E+00\n"),
            (b"VOLT:LIM:UPP 5.000\n", SILENT), fine, (b"VOLT:LIM:UPP?\n", b"+5.00000E+00\n"),
            (b"OUTP 1\n", SILENT), fine, (b"OUTP?\n", b"1\n")]  # fmt: skip
    with scripted(TableSupply, wire, model="kikusui-pbz", compliance_V=5.0) as supply:
        supply.output(True)


def test_a_lower_limit_that_was_not_taken_keeps_the_output_off() -> None:
    wire = [(b"VOLT:LIM:LOW -5.000\n", SILENT), (b"SYST:ERR?\n", b'0,"No error"\n'), (b"VOLT:LIM:LOW?\n", b"-21.0\n")]
    with (
        scripted(TableSupply, wire, model="kikusui-pbz", compliance_V=5.0) as supply,
        pytest.raises(InstrumentError, match="-5 V and reads back -21 V") as caught,
    ):
        supply.output(True)
    assert caught.value.fault == "read-back"


def test_an_spd3303x_e_holds_hundredths() -> None:
    wire = [*spd(b"CH2:CURR 0.12"), (b"CH2:CURR?\n", b"0.12\n")]
    stated = TableSupply.recognise("Siglent Technologies,SPD3303X-E,SPD3XGB4150080,1.01.01.02.05,V3.0")
    with scripted(TableSupply, wire, **(stated or {}), channel=2, max_current_A=2.5) as supply:
        supply.set_current(0.1234)


def test_an_hmc_is_told_its_least_current_where_zero_is_meant() -> None:
    fine = (b"SYST:ERR?\n", b'0,"No error"\n')
    wire = [(b"INST:NSEL 1;:CURR 0.0005\n", SILENT), fine, (b"INST:NSEL 1;:CURR?\n", b"0.0005\n"),
            (b"INST:NSEL 1;:CURR 0.0005\n", SILENT)]  # fmt: skip
    with scripted(TableSupply, wire, model="rohde-schwarz-hmc804x") as supply:
        supply.set_current(0.0)
        supply.write_current(0.0)


def test_a_z_plus_is_selected_on_each_line_and_told_to_be_remote() -> None:
    fine = (b"SYST:ERR?\r\n", b'0,"No error"\r\n')
    wire = [(b"SYST:SET REM\r\n", SILENT), fine, (b"INST:NSEL 6;:CURR 0.5000\r\n", SILENT), fine,
            (b"INST:NSEL 6;:CURR?\r\n", b"0.5000\r\n")]  # fmt: skip
    with scripted(TableSupply, wire, model="tdk-lambda-zplus") as supply:
        supply.set_current(0.5)


def test_an_sm_that_is_programmed_by_its_panel_is_refused() -> None:
    wire: list[Exchange] = [(b"*IDN?\n", b"DELTA ELEKTRONIKA BV,SM70-CP-450,1,0,H0\n"), (b"SYST:ERR?\n", b"0,None\n"),
            (b"SYST:REM:CV?\n", b"Ethernet\n"), (b"SYST:REM:CC?\n", b"Front\n")]  # fmt: skip
    with scripted(TableSupply, wire, model="delta-sm") as supply, pytest.raises(InstrumentError, match="SYST:REM:CC"):
        supply.identify()


def plain(**other: Any) -> dict[str, Any]:
    """A table with the fewest words."""
    words = {
        "maker": "ACME", "models": "PS.*", "example": "ACME,PS 1,7,1", "set_current": "CURR {value:.3f}",
        "ask_current": "CURR?", "set_voltage": "VOLT {value:.3f}", "ask_voltage": "VOLT?", "output": "OUTP {on}",
        "ask_output": "OUTP?", "measure_current": "MEAS:CURR?", "most_A": 5.0, "most_V": 30.0,
    }  # fmt: skip
    return words | other


BAD = {
    "set_current": [
        ('"CURR {value}"', "digits"), ('"CURR 1.0"', "must have {value} once"), ('"CURR {value:.3f};*RST"', "never"),
        ('"CURR {amps:.3f}"', "braces"), ('"CURR {value.real:.3f}"', "must not have|braces"),
        ('"CURR {value:.3f"', "braces"),
        ('"CURR {value:.3f}\\n"', "one line"), ('"CURR µ{value:.3f}"', "ASCII"), ("5", "string"),
    ],
    "ask_current": [('"CURR"', "no question mark"), ('"CURR? {value:.3f}"', "must not have"), ('"CAL:CURR?"', "never")],
    "output": [('"OUTP 1"', "must have {on} once"), ('"OUTP:TRAC {on}"', "never")],
    "remote": [('"SYST:REM {on}"', "must not have")],
    "models": [('"PS["', "no regular expression"), ('"XX"', "example")],
    "channels": [("[1, 2]", "must have {channel}"), ("[0]", "greater than or equal to 1")],
    "output_bit": [("[4, 5]", "one bit for each"), ("[99]", "less than or equal to 31")],
    "trip_bit": [("{ ovp = 1 }", "trips has not")],
    "set_lower": [('"VOLT:LOW {value:.3f}"', "set_lower and ask_lower")],
    "terminator": [('"!"', "must be")],
    "most_A": [("0", "greater than 0"), ("0.5", "max_current_A must be at most 0.5 A")],
    "amps": [("1", "not a key that is known here")],
}  # fmt: skip


def bench(folder: Path, lines: str) -> Path:
    """The example's bench, its supply of x described by `lines`."""
    old = '[instruments.supply_x]\ndriver = "tti-pl"\nlink = "emulated://"\nrole = "coil-x"\n'
    text = EXAMPLE.read_text()
    assert old in text
    (path := folder / "bench.toml").write_text(text.replace(old, old.replace("tti-pl", "scpi-table") + lines))
    return path


def own(folder: Path, table: dict[str, Any], **spoilt: str) -> Path:
    head = "instruments.supply_x.settings.table"
    stated = toml({key: value for key, value in table.items() if key not in spoilt}, head)
    lines = "\n".join(f"{key} = {value}" for key, value in spoilt.items())
    return bench(folder, stated.replace(f"[{head}]", f"[{head}]\n{lines}"))


@pytest.mark.parametrize(("key", "value", "told"), [(k, v, w) for k, cases in BAD.items() for v, w in cases])
def test_a_table_that_cannot_be_right_is_refused_with_its_line(tmp_path: Path, key: str, value: str, told: str) -> None:
    path = own(tmp_path, plain(), **{key: value})
    with pytest.raises(InputError, match=told) as caught:
        Loader(path, read_config(path), RealClock(), 0).look_over()
    line = path.read_text().splitlines()[(caught.value.line or 0) - 1]
    assert line.startswith((key, "[instruments.supply_x.settings.table]", "[instruments.supply_x"))
    if "supply_x.settings.table." + key in str(caught.value):
        assert line.startswith(f"{key} = "), "the line of the key itself, where one key is at fault"


def test_a_key_that_is_missing_is_named(tmp_path: Path) -> None:
    table = plain()
    del table["ask_output"]
    path = own(tmp_path, table)
    with pytest.raises(InputError, match=r"ask_output: is missing"):
        Loader(path, read_config(path), RealClock(), 0).look_over()


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("", "state model"),
        ('settings = { model = "acme" }', "there is no table 'acme'; there are agilent-603x"),
        ('settings = { model = "siglent-spd3303x", channel = 3 }', "channel must be one of 1, 2"),
        ('settings = { model = "siglent-spd3303x", max_current_A = 3.3 }', "at most 3.2 A"),
        ('settings = { model = "agilent-e3631a", compliance_V = 12 }', "at most 6.18 V"),
    ],
)
def test_settings_that_do_not_fit_their_table_are_refused(tmp_path: Path, lines: str, told: str) -> None:
    path = bench(tmp_path, lines + "\n")
    with pytest.raises(InputError, match=told):
        Loader(path, read_config(path), RealClock(), 0).look_over()


def test_a_table_of_ones_own_comes_through_bench_serve_as_it_was(tmp_path: Path) -> None:
    path = own(tmp_path, plain(trips={"over-voltage": "VOLT:PROT:TRIP?"}))
    config = read_config(path)
    served = tomllib.loads(toml(config.model_dump(mode="json", exclude_defaults=True)))
    assert served["instruments"]["supply_x"]["settings"]["table"] == config.instruments["supply_x"].settings["table"]


def test_every_table_is_shipped_whole_and_says_what_is_unsure() -> None:
    assert len(names()) >= 12
    for name in names():
        text = (TABLES / f"{name}.toml").read_text()
        assert text.startswith("# "), name
        assert any(words in text for words in ("Unsure", "unsure", "nothing else may be wired")), name
        assert shipped(name).most_A > 0


@pytest.mark.parametrize("name", names())
def test_its_emulator_understands_every_word_of_a_table(name: str) -> None:
    table = shipped(name)
    rig = installed("scpi-table", forbidden=[], settings={"model": name, "channel": table.channels[-1]}).rig()
    rig.driver.identify()
    rig.driver.output(True)
    rig.driver.set_current(0.5)
    rig.wait(0.5)
    assert rig.coil_A() == pytest.approx(0.5, abs=table.resolution_A)
    assert rig.driver.measure_current() == pytest.approx(0.5, abs=0.01)
    assert rig.driver.trip() == ""
    for trip in table.trips:
        rig.emulator.trip(rig.clock.now(), table.channels[-1], trip)
        rig.wait(0.5)
        with pytest.raises(InstrumentError, match=f"{trip}.* protection tripped"):
            rig.driver.measure_current()
    rig.driver.make_safe()
    rig.wait(0.5)
    assert rig.coil_A() == pytest.approx(0.0, abs=0.001)


@pytest.mark.parametrize("asked", [b"SOURce:CURrent?", b"SOUR:CUR?", b"SOURCE:CURRENT?"])
def test_the_emulated_sm_knows_the_makers_own_short_words_and_the_long_ones(asked: bytes) -> None:
    rig = installed("scpi-table", forbidden=[], settings={"model": "delta-sm"}).rig()
    rig.line.send(b"SOURce:CURrent 1.5\n")
    assert float(rig.line.ask(asked + b"\n", end=b"\n", timeout_s=1.0)) == 1.5


def test_a_table_of_ones_own_keeps_the_promises_of_a_supply() -> None:
    table = TypeAdapter(Table).validate_python(plain())
    check_driver("scpi-table", forbidden=[b"*RST\n"], settings={"table": table})


def test_settings_alone_are_checked_as_in_a_file() -> None:
    with pytest.raises(ValidationError, match="state model"):
        TypeAdapter(Settings).validate_python({})
