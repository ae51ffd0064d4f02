"""What others wrote, shown: on the terminal nothing acts, in a spreadsheet nothing is worked out."""

from __future__ import annotations

import ast
import json
from pathlib import Path

import pytest

from labcal import cli
from labcal.cli.screen import console, say
from labcal.errors import InputError
from labcal.files.spreadsheet import first_formula, is_formula, shielded_row
from labcal.files.text_safety import escape_unseen, one_line, replace_unseen
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Event
from labcal.store import Bundle, Store
from labcal.store.export import csv_table

CLI = Path(cli.__file__).parent
ACTS = [
    "\x1b[2J",
    "\x07",
    "\x9b2J",
    "\u202eabc",
    "\u2066",
    "\u200b",
    "\u200f",
    "\ufeff",
    "\u2028",
    "\U000e0041",
    "\ud800",
]
FORMULAS = ["=cmd|' /C calc'!A0", "+cmd|' /C calc'!A0", "@SUM(1)", "\t1", "\r=1", "\uff1d1", "-2+3+cmd|x!A", "  =1"]
NONE = ["-5", "+5.2e-3", "-.5", "1e+05", "-", "+x-20uT", "-z", "x=1", "2026-03-02T08:15:00+00:00", "a@b", "", "-1e30"]


@pytest.mark.parametrize("text", ACTS)
def test_what_acts_on_a_terminal_or_is_not_seen_is_marked(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert text[0] not in replace_unseen(text)
    say(f"a{text}b\nc")
    console().print(f"a{text}b [/not a markup] :smile:")
    told = capsys.readouterr().out
    assert told.splitlines()[0].count("\ufffd") == 1
    assert told.splitlines()[0].endswith("b c")
    assert "[/not a markup] :smile:" in told
    assert text[0] not in told
    assert json.loads(escape_unseen(json.dumps({"k": text}, ensure_ascii=False))) == {"k": text}
    assert text[0] not in escape_unseen(json.dumps({"k": text}, ensure_ascii=False))


def test_what_is_meant_is_left(capsys: pytest.CaptureFixture[str]) -> None:
    assert replace_unseen("Grüße, 测试 µT\tand\nmore") == "Grüße, 测试 µT\tand\nmore"
    assert one_line("two\r\nlines\there") == "two lines here"
    console(force_terminal=True, color_system="standard").print("red", style="red")
    assert "\x1b[31mred" in capsys.readouterr().out


def test_the_command_line_prints_through_one_place_only() -> None:
    for file in CLI.glob("*.py"):
        if file.name != "screen.py":
            tree = ast.parse(file.read_text(encoding="utf-8"))
            calls = {
                node.func.id
                for node in ast.walk(tree)
                if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
            }
            assert not calls & {"print", "Console"}, file.name


def test_names_that_were_recorded_reach_no_terminal_as_they_are(capsys: pytest.CaptureFixture[str]) -> None:
    dut = Dut("SN\x1b[2J\u202e1\nrun ok", "model", "nT", 1.0, 25.0)
    header = RunHeader("r1", "2026-03-02T08:15:00Z", False, "Ro\x9be", dut, Reference("none"))
    with Store.open() as store, store.begin(header) as writer:
        writer.write(Event(0.0, "note", "x"))
    assert cli.execute(["runs"]) == 0
    assert cli.execute(["show", "no\x1b[2Jsuch\nrun"]) == 2
    assert cli.execute(["runs", "--json", "-"]) == 0
    told = capsys.readouterr()
    assert not set(told.out + told.err) & set("\x1b\x9b\u202e")
    assert told.err.strip().count("\n") == 0


def test_formulas_are_told_from_numbers_and_names() -> None:
    assert [text for text in FORMULAS if not is_formula(text)] == []
    assert [text for text in NONE if is_formula(text)] == []
    assert shielded_row('1,"=a,b",-5,+x') == '1,"\'=a,b",-5,+x'
    assert shielded_row("=a\rb,1") == '"\'=a\rb",1'
    assert shielded_row('-1.5,"a,b",1e+05') == '-1.5,"a,b",1e+05'
    assert first_formula("t_s,segment\n1,x\n2,=x\n") == (3, "=x")


def test_a_table_of_formulas_is_exported_as_a_bundle_only() -> None:
    fine, not_fine = b"t_s,segment\n-1e+05,+x-20uT\n", b"t_s,=cmd|x\n1,a\n"
    assert csv_table(Bundle(b"", fine, Path("r"))) == fine
    with pytest.raises(InputError, match=r"samples\.csv, line 1: .*--format bundle"):
        csv_table(Bundle(b"", not_fine, Path("r")))
