"""Each `labcal …` that README, CONTRIBUTING or a page of docs/ prints is a command with these options."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from typer.main import get_command

import labcal.cli.commands  # noqa: F401  registers every command
from labcal.cli import app

ROOT = Path(__file__).parents[2]
PAGES = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "examples/plugin/README.md")),
    *sorted((ROOT / "docs").glob("*.md")),
]
ALWAYS = {"--help", "--version"}
SAID = re.compile(r"labcal (\d|is )")  # what an installer prints, no command


def printed(text: str) -> Iterator[str]:
    """Lines of code blocks, and what stands between backticks, that begin with `labcal`."""
    for block in re.findall(r"```(?:sh)?\n(.*?)```", text, re.DOTALL):
        lines = re.findall(r"^(?:[\w./]*bin/)?labcal .*", block.replace("\\\n", " "), re.MULTILINE)
        yield from (line for line in lines if not SAID.match(line))
    yield from re.findall(r"`(labcal [^`]+)`", re.sub(r"```.*?```", "", text, flags=re.DOTALL).replace("\n", " "))


def unknown(line: str) -> list[str]:
    """The words of a printed command that labcal does not know: the command, or options."""
    words, command = shlex.split(line, comments=True)[1:], get_command(app)
    while words and (found := getattr(command, "commands", {}).get(words[0])) is not None:
        command, words = found, words[1:]
    has = {name for parameter in command.params for name in (*parameter.opts, *parameter.secondary_opts)} | ALWAYS
    wrong = [word.partition("=")[0] for word in words if word.startswith("--") and word.partition("=")[0] not in has]
    groups: dict[str, Any] = getattr(command, "commands", {})
    return [*(words[:1] if groups and words and not words[0].startswith("-") else []), *wrong]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_printed_commands_are_commands(page: Path) -> None:
    wrong = {line: words for line in printed(page.read_text(encoding="utf-8")) if (words := unknown(line))}
    assert wrong == {}, "the page prints what labcal does not know"


def test_what_is_no_command_is_seen() -> None:
    lines = printed("```sh\nlabcal fly now\n```\nSay `labcal bench land X` or `labcal fit RUN --fast`, `labcal runs`.")
    assert [unknown(line) for line in lines] == [["fly"], ["land"], ["--fast"], []]
