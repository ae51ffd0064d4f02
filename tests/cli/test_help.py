"""What `labcal --help` shows: every command that there is, and it fails for none."""

from labcal import cli


def test_help_names_every_command(capsys):
    assert cli.execute(["--help"]) == 0
    said = capsys.readouterr().out
    assert [name for name in cli.COMMANDS if f" {name} " not in said] == []
