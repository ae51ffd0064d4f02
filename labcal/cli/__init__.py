"""The command line: one file for each group of commands, and one place that turns faults into exit codes."""

from __future__ import annotations

import errno
import gc
import os
import re
import sys
from typing import Any, cast

import typer
from typer.core import TyperGroup

from labcal.cli.screen import say
from labcal.errors import InputError, InstrumentError, LimitError, LimitNotMet, Stopped, words_of_system
from labcal.files.home import SECRETS
from labcal.files.text_safety import in_utf8, without_passwords
from labcal.system.private_memory import kept_private
from labcal.version import __version__

DONE, NEGATIVE, WRONG_INPUT, INSTRUMENT_FAILED, STOPPED = 0, 1, 2, 3, 130

TOO_LITTLE = (errno.EMFILE, errno.ENFILE, errno.ENOMEM)  # handles, of this process or of all, and memory

# What typer raises for a wrong word on the command line; it comes from click, or from typer's own copy of it.
UsageFault = cast("type[typer.BadParameter]", typer.BadParameter.__mro__[2])

# The matrices here are small: threads of the linear algebra would only wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

COMMANDS = (
    *("demo", "gui", "self-test", "bench", "run", "runs", "show", "import", "export", "check-store", "audit"),
    *("fit", "close-loop", "apply", "keys", "approve", "sign", "verify", "report", "numbers", "conformity", "compare"),
    *("push", "archive", "study", "charts", "rr", "intervals", "intercompare", "fleet", "watch", "plugins", "effect"),
)
# The file here that registers a command, where it has not the command's own name.
FILES = {
    **dict.fromkeys(("show", "import", "export", "check-store"), "runs"),
    **dict.fromkeys(("fit", "apply"), "fitting"),
    **dict.fromkeys(("approve", "sign", "verify"), "signing"),
    **dict.fromkeys(("charts", "rr", "intervals", "intercompare", "fleet"), "years"),
    "self-test": "self_test",
    "close-loop": "loop",
    "compare": "conformity",
    "push": "archive",
}


class InTheOrderOfTheWork(TyperGroup):
    """The commands as the lab's day needs them, not as their files are named."""

    def list_commands(self, ctx: Any) -> list[str]:
        """The names of all commands; one that COMMANDS does not know is a fault of ours."""
        return sorted(super().list_commands(ctx), key=COMMANDS.index)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """The command of this name, which converts no option that was not given."""
        command = super().get_command(ctx, cmd_name)
        for one in (command, *getattr(command, "commands", {}).values()):
            _convert_less(one)
        return command

    def get_params(self, ctx: Any) -> Any:
        """Its own options, likewise."""
        return [_taken_as_it_is(param) for param in super().get_params(ctx)]


def _convert_less(command: Any) -> None:
    if command is not None and "get_params" not in vars(command):
        params = command.get_params
        command.get_params = lambda ctx: [_taken_as_it_is(param) for param in params(ctx)]


def _taken_as_it_is(param: Any) -> Any:
    """What was not given is not converted: typer loads pydantic for that, which takes longer than a short command."""
    if "process_value" in vars(param) or param.nargs != 1 or param.multiple:
        return param
    convert, call = param.process_value, param.callback

    def process_value(ctx: Any, value: Any) -> Any:
        if value is None and not param.required:
            return None if call is None else call(ctx, param, None)
        return convert(ctx, value)

    param.process_value = process_value
    return param


app = typer.Typer(
    name="labcal",
    cls=InTheOrderOfTheWork,
    help="Calibrate a magnetometer before it flies: run the bench, fit, close the loop, sign.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"labcal {__version__}")
        raise typer.Exit


@app.callback()
def root(
    version: bool = typer.Option(False, "--version", callback=_version, is_eager=True, help="Print the version."),
) -> None:
    """Calibrate a magnetometer before it flies: run the bench, fit, close the loop, sign."""


def main() -> None:
    """Run the command line; every fault ends in one sentence and its exit code (contract: commands)."""
    in_utf8()
    if any(name in os.environ for name in SECRETS):
        kept_private()
    gc.set_threshold(50_000)  # libraries that load make many objects, and nearly all of them stay
    sys.exit(execute(sys.argv[1:]))


def execute(arguments: list[str]) -> int:
    """Run one command, such as ["runs"]; every fault ends in one sentence on stderr. Returns the exit code."""
    try:
        _load(arguments)
        code = app(arguments, prog_name="labcal", standalone_mode=False)
        if code == STOPPED:  # typer answers Ctrl-C with this code and no word
            return _say("stopped", STOPPED)
        return code if isinstance(code, int) else DONE
    except UsageFault as error:
        return _say_usage(error)
    except (KeyboardInterrupt, typer.Abort, Stopped):
        return _say("stopped", STOPPED)
    except LimitNotMet as error:
        return _say(str(error), NEGATIVE)
    except (InputError, LimitError) as error:
        return _say(str(error), WRONG_INPUT)
    except InstrumentError as error:
        return _say(str(error), INSTRUMENT_FAILED)
    except UnicodeError as error:
        return _say(f"a text here is no UTF-8 ({error.reason if hasattr(error, 'reason') else error})", WRONG_INPUT)
    except OSError as error:
        if error.errno in TOO_LITTLE:  # whatever was opened just then is not to blame
            return _say(f"the system gives labcal no more: {error.strerror}", WRONG_INPUT)
        return _say(words_of_system(error), WRONG_INPUT)
    except Exception as error:
        return _say(_report_of(error), WRONG_INPUT)


def _load(arguments: list[str]) -> None:
    """Register the command that these words begin with, and no other; all of them where that is none."""
    from importlib import import_module

    first = arguments[0] if arguments else ""
    import_module(f"labcal.cli.{FILES.get(first, first) if first in COMMANDS else 'commands'}")


def _report_of(error: Exception) -> str:
    """Keep the details of a fault of ours in a file, and say what happened and where they are."""
    from traceback import format_exception

    from labcal.files.atomic import write_bytes
    from labcal.files.confidential import without_secrets
    from labcal.files.home import FILE, home, own_folder
    from labcal.files.text_safety import replace_unseen

    what = f"a fault of labcal's own: {type(error).__name__}: {error}"
    report = home() / "last-fault.txt"
    try:
        own_folder(report.parent)
        given = re.sub(r"(--webhook[= ])\S+", r"\1***", " ".join(sys.argv[1:]))
        text = f"labcal {given}\n\n{''.join(format_exception(error))}"
        write_bytes(report, without_secrets(replace_unseen(text)).encode(), FILE)
    except OSError:
        return what
    return f"{what}; please report it with the file {report}"


def _say_usage(error: typer.BadParameter) -> int:
    """A wrong word on the command line in one sentence; a group without a command shows its help."""
    message = error.format_message().strip().removesuffix(".").replace("Value error, ", "")
    if not message:  # the help stands there already
        return WRONG_INPUT
    return _say(f"{message}; see `{error.ctx.command_path if error.ctx else 'labcal'} --help`", WRONG_INPUT)


def _say(sentence: str, code: int) -> int:
    say(f"labcal: {without_passwords(sentence)}", err=True)
    return code
