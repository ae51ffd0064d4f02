"""The emulators answer other programs too: messages that our own drivers never send, in the manuals' own bytes."""

from __future__ import annotations

from datetime import UTC, datetime
from importlib.metadata import entry_points
from typing import Any, get_type_hints

import pytest
from frames import rtu

from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.twin import open_twin

AZ_MOVE = "0000 0000 0000 0002 0000 0032 0000 03E8 0000 03E8 0000 03E8 0000 03E8"  # 50 steps further, at 1 kHz
ROLES = {
    "zaber": "platform", "oriental-az": "platform", "newport-esp301": "platform", "newport-smc100": "platform",
    "leadshine": "platform",
    "hmr2300": "reference", "metrolab": "reference",
    "waveshare-relay": "polarity",
}  # fmt: skip
WIRING: dict[str, dict[str, Any]] = {
    "waveshare-relay": {"x": 0},
    "riden-rd60xx": {"address": 1},
    "scpi-table": {"model": "bk-9130b"},
}
TALKS: list[tuple[str, list[tuple[bytes, bytes]]]] = [
    ("zaber", [
        (b"/\n", b"@01 0 OK IDLE WR 0:3E\r\n"),
        (b"/1 get deviceid\r", b"@01 0 OK IDLE WR 50117:70\r\n"),
        (b"/1 1 05 move abs 9\r\n", b"@01 1 05 RJ IDLE WR BADDATA:05\r\n"),
        (b"/home\r\n", b"@01 0 OK IDLE -- 0:8D\r\n"),
        (b"/1 0 move abs 10000:41\r\n", b"@01 0 OK BUSY -- 0:68\r\n"),
        (b"/1 0 move abs 10000:42\r\n/2 get pos\n", b""),
        (b"/1 get system.axiscount\n", b"@01 0 OK IDLE -- 1:8C\r\n"),
        (b"/1 1 07 move abs 384000 83886\n/1 1 08 stop\n/1 1 09 warnings\n",
         b"@01 1 07 OK BUSY -- 0:E0\r\n@01 1 08 OK BUSY NI 0:A2\r\n@01 1 09 OK IDLE NI 01 NI:DE\r\n"),
        (b"/1 1 move vel 9000\n", b"@01 1 OK BUSY -- 0:67\r\n"),
    ]),
    ("hmr2300", [
        (b"*00q\r", b"ASCII POLLED S/R ON ZERO OFF AVG OFF R ON ID= 00 20 sps\r"),
        (b"*99ID=\r*99ID\r", b"ID= 00\rID= 00\r"),
        (b"*00T\r", b"WE OFF\r"),
        (b"*00WE\r*00T\r", b"OK\rS/R OFF\r"),
        (b"*00WE\r*00B\r", b"OK\rBINARY ON\r"),
        (b"*00WE\r*00R=21\r", b"OK\rRe-enter\r"),
        (b"*00]S\r", b"SET\r"),
        (b"*00WE\rnoise\r*00A\r", b"OK\rRe-enter\rWE OFF\r"),
        (b"*00WE\r*07P\r*00A\r", b"OK\rASCII ON\r"),  # another's words are not its own
    ]),
    ("tti-pl", [
        (b"*ESR?\nV1V 5.0\n*ESR?\nV1?\n", b"128\r\n0\r\nV1 5.000\r\n"),
        (b"OVP1 20\nOVP1?\nOCP1?\n", b"VP1 20.000\r\nCP1 3.500\r\n"),
        (b"DELTAI1 0.1\nINCI1\nINCI1\nDECI1\nI1?\n", b"I1 0.1000\r\n"),
        (b"opall 1\nop1?\nLSR1?\nTRIPRST\nQER?\n", b"1\r\n2\r\n0\r\n"),
        (b"I1 1e9\n*ESR?\nEER?\n", b"16\r\n100\r\n"),
        (b"*RST;V1 5;I1 0.5\nV1?;I1?;*OPT?\n", b"V1 5.000;I1 0.5000;0\r\n"),
        (b"DELTAV1 0.1\nDELTAV1?\nIRANGE1 1;IRANGE1?\n", b"DELTAV1 0.100\r\n1\r\n"),
        (b"OP1 1;IRANGE1 2;*ESR?;EER?\n", b"16;104\r\n"),
        (b"OCP1 0.6\nOP1?\nI1 0.7\nOP1?;LSR1?;LSR1?\n", b"1\r\n0;8;0\r\n"),
        (b"WHAT?\n*ESR?;*ESR?\n*OPC?;*TST?\n", b"32;0\r\n1;0\r\n"),
    ]),
    ("rigol-dp800", [
        (b":APPL CH1,5.0,1.0\nAPPLY? CH1\n", b"CH1:30V/3A,5.000,1.0000\n"),
        (b":OUTP:OVP:VAL CH1,8.8\n:OUTP:OVP CH1,ON\n:OUTP:OVP:VAL? CH1\n:OUTP:OVP? CH1\n", b"8.800\nON\n"),
        (b":OUTP:OVP:QUES? CH1\n:STAT:QUES:INST:ISUM1:COND?\n:SYST:RWL ON\n", b"NO\n0\n"),
        (b":SOUR1:CURR .\nsystem:error?\n", b'-113,"Undefined header"\n'),
        (b":SOUR1:CURR 99\n:SYST:ERR?\n:SYST:ERR?\n", b'-222,"Data out of range"\n0,"No error"\n'),
        (b":INST:NSEL 1\n:VOLT 5;CURR 1;:OUTP ON\n:OUTP?;:INST?;:VOLT?\n", b"ON;CH1;5.000\n"),
        (b":OUTP:OCP:VAL CH1,0.8;:OUTP:OCP CH1,ON\n:OUTP? CH1\n:SOUR1:CURR 0.9\n", b"ON\n"),
        (b":OUTP:OCP:QUES? CH1\n:OUTP? CH1\n:STAT:QUES:INST:ISUM1:COND?\n", b"YES\nOFF\n8\n"),
        (b":OUTPut:OCP:CLEAR CH1\n:OUTPut:OCP:QUES? CH1\n*RST;*CLS;*OPC?\n:SOURce1:VOLTage?\n", b"NO\n1\n0.000\n"),
        (b":INST:NSEL 2;:SYSTem:ERRor?\n*ESR?;*STB?;*OPT?\n", b'-222,"Data out of range"\n16;0;0\n'),
    ]),
    ("waveshare-relay", [
        (bytes.fromhex("0105 00FF FF00 BC0A"), bytes.fromhex("0105 00FF FF00 BC0A")),
        (bytes.fromhex("0101 0000 0008 3DCC"), bytes.fromhex("0101 01FF 11C8")),
        (bytes.fromhex("0105 00FF 0000 FDFA"), bytes.fromhex("0105 00FF 0000 FDFA")),
        (bytes.fromhex("0103 8000"), b""),  # cut short
        (bytes.fromhex("0103 8000 0001 ADCA"), bytes.fromhex("0103 0201 2CB8 09")),
        (bytes.fromhex("0003 4000 0001 901B"), bytes.fromhex("0103 0200 0179 84")),  # who is there
        (rtu("010F 0000 0008 01 05"), rtu("010F 0000 0008")),
        (rtu("0101 0000 0008"), rtu("0101 01 05")),
        (rtu("000F 0001 0002 01 02"), b""),  # to all, and done
        (rtu("0101 0000 0008"), rtu("0101 01 05")),
        (rtu("0005 0002 0000"), b""),
        (rtu("0101 0000 0008"), rtu("0101 01 01")),
        (rtu("010F 0000 0009 02 FF01"), rtu("018F 02")),
        (rtu("010F 0000 0008 02 0000"), rtu("018F 03")),
    ]),
    ("riden-rd60xx", [
        (bytes.fromhex("0110 0008 0002 04 01F4 03E8 B2B9"), bytes.fromhex("0110 0008 0002 C00A")),
        (bytes.fromhex("0103 0008 0002 45C9"), bytes.fromhex("0103 04 01F4 03E8 BA83")),
        (rtu("0108 0000 1234"), rtu("0188 01")),
        (rtu("010F 0012 0001 01 01"), rtu("018F 01")),
    ]),
    ("ea-9000", [
        (bytes.fromhex("00050192FF002DFA"), bytes.fromhex("00050192FF002DFA")),
        (rtu("0001 0192 0001"), rtu("0001 01 01")),
        (rtu("0001 0195 0001"), rtu("0001 01 00")),
        (rtu("0001 0190 0001"), rtu("0081 02")),
        (rtu("0003 0226 0001"), rtu("0003 02 E147")),  # its over-voltage protection, as it comes: 110 %
        (rtu("0003 2328 0005"), rtu("0003 0A D0E5 0000 D0E5 0000 D0E5")),
        (rtu("0006 232A 4000"), rtu("0006 232A 4000")),  # no more current than this
        (rtu("0006 01F5 4001"), rtu("0086 04")),
        (rtu("0006 01F5 4000"), rtu("0006 01F5 4000")),
        (rtu("0006 01F4 4000"), rtu("0006 01F4 4000")),
        (rtu("0006 0229 2000"), rtu("0006 0229 2000")),  # its over-current protection below its set-point
        (rtu("0005 0195 FF00"), rtu("0005 0195 FF00")),
        (rtu("0003 01FA 0001"), rtu("0003 02 8803")),  # off, and an alarm
        (rtu("0005 019B FF00"), rtu("0005 019B FF00")),
        (rtu("0003 01FA 0001"), rtu("0003 02 0803")),  # acknowledged
    ]),
    ("ea-ps2000b", [
        (bytes.fromhex("73 00 04 00 77"), bytes.fromhex("83 00 04 43 20 00 00 00 EA")),  # 160 W
        (bytes.fromhex("F1 00 36 10 10 01 47"), bytes.fromhex("80 00 FF 00 01 7F")),
        (bytes.fromhex("F1 00 27 6E 01 01 87"), bytes.fromhex("80 00 FF 30 01 AF")),  # more than 110 %
        (bytes.fromhex("F1 00 27 02 00 01 1A"), bytes.fromhex("80 00 FF 00 01 7F")),  # over-current at 0.2 A
        (bytes.fromhex("71 00 27 00 98"), bytes.fromhex("81 00 27 02 00 00 AA")),
        (bytes.fromhex("F1 00 33 05 00 01 29"), bytes.fromhex("80 00 FF 00 01 7F")),
        (bytes.fromhex("F1 00 36 01 01 01 29"), bytes.fromhex("80 00 FF 00 01 7F")),
        (bytes.fromhex("75 00 47 00 BC"), bytes.fromhex("85 00 47 01 24 00 00 00 00 00 F1")),  # off, and why
    ]),
    ("oriental-az", [
        (rtu("0108 0000 1234"), rtu("0108 0000 1234")),
        (rtu("0108 0001 1234"), rtu("0188 01")),
        (rtu("0106 007D 0020"), rtu("0106 007D 0020")),
        (rtu("0106 007D 0000"), rtu("0106 007D 0000")),
        (rtu("0110 0058 0010 20" + AZ_MOVE + "0000 0000"), rtu("0110 0058 0010")),  # held, and not begun
        (rtu("0103 00CC 0002"), rtu("0103 04 0000 0000")),
        (rtu("0110 0058 0010 20" + AZ_MOVE + "0000 0001"), rtu("0110 0058 0010")),
        (rtu("0103 00CC 0002"), rtu("0103 04 0000 0032")),  # 50 steps from where it stood
        (rtu("0110 0058 0010 20" + AZ_MOVE + "0000 0001"), rtu("0110 0058 0010")),
        (rtu("0103 00CC 0002"), rtu("0103 04 0000 0064")),
        (rtu("0110 0058 0010 20" + AZ_MOVE.replace("0002", "0009") + "0000 0001"), rtu("0190 03")),
        (rtu("0106 0181 0001"), rtu("0106 0181 0001")),
    ]),
    ("leadshine", [
        (rtu("0106 6200 0001"), rtu("0106 6200 0001")),
        (rtu("0110 6201 0003 06 0000 0064 003C"), rtu("0110 6201 0003")),  # 100 pulses at 60 rpm
        (rtu("0103 602C 0002"), rtu("0103 04 0000 0000")),
        (rtu("0106 6002 0010"), rtu("0106 6002 0010")),
        (rtu("0103 602C 0002"), rtu("0103 04 0000 0064")),
        (rtu("0110 6200 0008 10 0001 0000 00C8 003C 0064 0064 0000 0010"), rtu("0110 6200 0008")),
        (rtu("0103 602C 0002"), rtu("0103 04 0000 00C8")),  # the last word has triggered it
        (rtu("0103 1003 0001"), rtu("0103 02 0032")),
        (rtu("0106 6208 0001"), rtu("0186 02")),
    ]),
    ("keysight-e36300", [
        (b"INST:NSEL 1\nVOLT 5\nVOLT?\nINSTrument:NSELect?\n", b"+5.00000000E+00\n1\n"),
        (b"APPL CH1,3,0.5\nCURR?\nVOLT? (@1)\n", b"+5.00000000E-01\n+3.00000000E+00\n"),
        (b"APPLY 2.5,0.25,(@1)\nINST:SEL OUTPUT1\nOUTP ON\nOUTP?\nCURR?\n", b"1\n+2.50000000E-01\n"),
        (b"INST:SEL CH2\nSYST:ERR?\nAPPL 99,1\nSYST:ERR?\n", b'-222,"Data out of range"\n' * 2),
        (b"SYST:LOC\nSYST:ERR?\n", b'+0,"No error"\n'),
        (b"VOLT 5.5, (@1)\nVOLT? (@1)\nsource:voltage:level:immediate:amplitude 4\nVOLT?\n",
         b"+5.50000000E+00\n+4.00000000E+00\n"),
        (b"OUTPut:STATe (@1)\n*CLS\nOUTP OFF,(@1)\n", b""),
        (b"MEASure:SCALar:CURRent:DC? (@1);:OUTPut:STATe? (@1)\n", b"+0.00000000E+00;0\n"),
        (b"*RST;*WAI;OUTP?;*OPC?\nNONSENSE\n*ESR?;*STB?;*CLS;*STB?\n", b"0;1\n32;4;0\n"),
    ]),
    ("scpi-table", [
        (b"INST:SEL CH1\nINST:SEL?;:INST:NSEL?\n", b"CH1;1\n"),
        (b"VOLT 12;:CURR 0.5;:CHAN:OUTP ON\nCHAN:OUTP?\n", b"1\n"),
        (b"", b""),  # a second, in which the current rises
        (b"MEASure:SCALar:VOLTage:DC?\n", b"3.0024\n"),
        (b"CHAN:OUTP 0\nCHAN:OUTP?\nINST:SEL CH3\nSYST:ERR?\n", b'0\n-222,"Data out of range"\n'),
    ]),
    ("kepco-bop", [
        (b"CURR 1\nSYST:ERR?\n*ESR?\n", b'-221,"Settings conflict"\n144\n'),
        (b"SYSTEM:REMOTE ON;:FUNCTION:MODE CURRENT;:VOLTAGE:LEVEL 20;:CURRENT 0.1;:OUTPUT ON\n", b""),
        (b"CURR?;OUTP?;FUNC:MODE?;:VOLT?\n", b"1.000E-1;1;1;2.000E1\n"),
        (b"*OPC?;*OPT?;*TST?;SYST:REM?\n*RST\nOUTP?;SYST:ERR?\n", b'1;0;0;1\n0;0,"No error"\n'),
    ]),
    ("newport-esp301", [
        (b"1MO?\r1SL?\r1SR?\r", b"0\r\n-720\r\n720\r\n"),
        (b"1MO;1VA10;1PA1;1WS200;1TP;1MD?\r", b""),
        (b"", b"1.0000\r\n1\r\n"),  # 1.1 s later
        (b"1VA41\r1PA721\r1PR-800\r2TP\rTP\r", b""),
        (b"TE?\rTE?\rTE?\rTE?\rTE?\rTE?\r1VA?\r", b"110\r\n106\r\n107\r\n9\r\n37\r\n0\r\n10.0000\r\n"),
        (b"1PR0.5\r", b""),
        (b"1TP\r1VA0\rTE?\r", b"1.5000\r\n7\r\n"),
    ]),
    ("newport-smc100", [
        (b"1AC?\r\n1PW?\r\n", b"1AC80\r\n1PW0\r\n"),
        (b"1PR5\r\n1TE\r\n", b"1TEH\r\n"),
        (b"1OR\r\n1TE\r\n1TS\r\n", b"1TE@\r\n1TS000032\r\n"),
        (b"1PR0.01\r\n1TE\r\n", b"1TE@\r\n"),
        (b"1TP\r\n1TS\r\n", b"1TP0.01000\r\n1TS000033\r\n"),
        (b"1OR\r\n1TE\r\n", b"1TEK\r\n"),  # it is referenced, and ready
        (b"1PA90\r\n1OR\r\n1TE\r\n1PA5\r\n1TE\r\n1TS\r\n", b"1TEM\r\n1TEM\r\n1TS000028\r\n"),
    ]),
    ("metrolab", [
        (b":FETC:TIM?;:FETC:TEMP?;*STB?\n", b"0x0;8123;0\n"),
        (b":INIT;:FETC:TIM?\n", b"0x3c336080\n"),  # 1.01 s
        (b":READ:ARR:X? 1,1;:FETC:X? 1;:FETC:TIM?\n", b"0.0T;0.0T;0x77ce2a80\n"),  # 2.01 s
        (b":READ? 3\n:FETCH:SCALAR:FLUX:Y? 2;:FETC:ARR:X? 3,4\n", b"0.000T\n0.00T;0.0000T,0.0000T,0.0000T\n"),
        (b":AVERAGE:COUNT 7;:AVER:COUN?;:SYSTEM:ERROR?\n", b'7;0,"No error"\n'),
        (b"*RST;:AVER:COUN?\n*OPC?;*ESR?\n", b"1\n1;128\n"),
    ]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "talk"), TALKS, ids=[name for name, _ in TALKS])
def test_it_answers_as_the_manual_says(name: str, talk: list[tuple[bytes, bytes]]) -> None:
    driver, emulator = (
        next(iter(entry_points(group=f"labcal.{of}", name=name))).load() for of in ("drivers", "emulators")
    )
    settings, clock = WIRING.get(name, {}), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    stated = get_type_hints(driver.__init__)["settings"](**settings)
    line = EmulatedLink(
        f"emulated://{name}", emulator(open_twin({}, 1), {ROLES.get(name, "coil-x"): settings}, stated), clock
    )
    for said, answered in talk:
        line.send(said)
        assert b"".join(piece for _, piece in line.receive(clock.now() + 1.0)) == answered, said
