"""What `labcal --help` shows: every command that there is, and it fails for none."""

import subprocess
import sys
from collections.abc import Iterator
from typing import Any

import typer
from rich.text import Text

from labcal import cli

ALL_ALONE = """
import sys, typer
from labcal import cli
for name in cli.COMMANDS:
    for module in [one for one in sys.modules if one.startswith("labcal.cli.") and one != "labcal.cli.screen"]:
        del sys.modules[module]
    cli.app.registered_commands.clear()
    cli.app.registered_groups.clear()
    cli.execute([name, "--help"])
"""


def test_help_names_every_command(capsys):
    assert cli.execute(["--help"]) == 0
    said = capsys.readouterr().out
    assert [name for name in cli.COMMANDS if f" {name} " not in said] == []


def test_the_file_that_is_loaded_for_a_command_registers_it():
    said = subprocess.run([sys.executable, "-c", ALL_ALONE], capture_output=True, text=True, check=True)
    assert said.stderr == ""
    assert [name for name in cli.COMMANDS if f"Usage: labcal {name} " not in said.stdout] == []


def test_no_word_of_a_help_is_taken_for_markup():
    cli.execute(["--help"])  # which loads every command
    lost = [text for text in _helps(typer.main.get_command(cli.app)) if _shown(text) != text.replace("\\[", "[")]
    assert lost == []


def _helps(command: Any) -> Iterator[str]:
    yield command.help or ""
    yield from (param.help or "" for param in command.params)
    for one in getattr(command, "commands", {}).values():
        yield from _helps(one)


def _shown(text: str) -> str:
    return Text.from_markup(text).plain


def test_a_number_is_converted_and_one_that_is_none_refused(capsys):
    assert cli.execute(["demo", "--seed", "many"]) == 2
    assert "--seed" in capsys.readouterr().err


def test_what_finds_effects_and_statistics_are_loaded_by_nobody_who_needs_none():
    said = "import sys, labcal.session; print('scipy.stats' in sys.modules, 'labcal.loop.close' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", said], capture_output=True, text=True).stdout == "False False\n"
