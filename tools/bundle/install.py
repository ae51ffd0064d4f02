"""Installs labcal from this folder, for this user, without a network. `install.sh` and `install.ps1` call it.

    install.sh                  verify every file, install beside what is there, try it, and only then use it
    install.sh --roll-back      use the version before again
    install.sh --remove         take labcal away; runs, keys and settings stay

Needs nothing but Python. Runs, keys and settings lie elsewhere, in the user's data folder, and are not touched.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

SUMS, COMPLETE = "SHA256SUMS", "complete"
WINDOWS = sys.platform == "win32"
UNTOLD = ("__pycache__",)  # Python's own, made when this file is read


class Refused(Exception):
    """What is asked for is not done; the message says why, and what stands as before."""


def verified(bundle: Path) -> str:
    """The SHA-256 of the list of hashes, where every file of the folder is on it and has its hash. Raises Refused."""
    listed = read_sums(bundle / SUMS)
    there = {path.relative_to(bundle).as_posix() for path in bundle.rglob("*") if path.is_file()}
    there = {name for name in there if not any(part in UNTOLD for part in name.split("/"))} - {SUMS}
    for name in sorted(there - listed.keys()):
        raise Refused(f"{name} is not on the list {SUMS}: nothing was installed")
    for name, stated in sorted(listed.items()):
        if name not in there:
            raise Refused(f"{name} is missing: nothing was installed; copy the whole folder again")
        if sha256(bundle / name) != stated:
            raise Refused(f"{name} is not the file that was packed: nothing was installed; copy the folder again")
    return sha256(bundle / SUMS)


def read_sums(path: Path) -> dict[str, str]:
    """Hash by name, from lines as sha256sum writes them. Raises Refused."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeError) as error:
        raise Refused(f"{path}: {error}: nothing was installed") from None
    listed = {}
    for line in lines:
        stated, _, name = line.partition("  ")
        if len(stated) != 64 or not name or ".." in name.split("/") or name.startswith("/"):
            raise Refused(f"{path}: {line[:80]!r} is no line of hashes: nothing was installed")
        listed[name] = stated
    return listed


def sha256(path: Path) -> str:
    """In hex."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def install(bundle: Path, prefix: Path, *, self_test: bool) -> None:
    """Install the folder's version and use it from here on. Raises Refused, with what was there as before."""
    sums = verified(bundle)
    about = json.loads((bundle / "bundle.json").read_text(encoding="utf-8"))
    say(f"every file is as it was packed; {SUMS} itself has SHA-256 {sums}")
    check_python(about["python"])
    place = prefix / "versions" / f"{about['version']}-{sums[:8]}"
    if not (place / COMPLETE).exists():
        fill(bundle, place)
    try:
        tried(place, self_test=self_test)
    except Refused:
        if place.name != current(prefix):
            shutil.rmtree(place)
        raise
    use(prefix, place.name)
    launcher = write_launcher(prefix)
    write_desktop_entry(bundle, launcher)
    say(f"labcal {about['version']} is installed: {launcher}")


def check_python(wanted: str) -> None:
    """Raise Refused where the wheels are for another Python."""
    here = f"{sys.version_info[0]}.{sys.version_info[1]}"
    if here != wanted:
        raise Refused(
            f"this folder is for Python {wanted}, this is {here}: nothing was installed. Install Python {wanted} "
            "(Windows: python.org, for this user alone; Debian: python3), or have the folder made for this one"
        )


def fill(bundle: Path, place: Path) -> None:
    """Make the environment `place`, from the wheels alone and each by its hash. Raises Refused, with nothing left."""
    shutil.rmtree(place, ignore_errors=True)  # of a try that was cut off
    place.parent.mkdir(parents=True, exist_ok=True)
    try:
        say("making an environment ...")
        asked([sys.executable, "-m", "venv", "--without-pip", str(place)])
        [pip] = (bundle / "wheels").glob("pip-*.whl")
        wanted = bundle / f"requirements-{'windows' if WINDOWS else 'linux'}.txt"
        say(f"installing {len(wanted.read_text().splitlines())} packages (a minute or two) ...")
        asked([program(place, "python"), f"{pip}/pip", "--isolated", "install", "--disable-pip-version-check",
               "--no-cache-dir", "--no-index", "--find-links", str(bundle / "wheels"), "--require-hashes", "--no-deps",
               "--requirement", str(wanted)])  # fmt: skip
        if not WINDOWS:
            add_libraries(bundle / "lib", place / "system-libraries")
        (place / COMPLETE).touch()
    except BaseException:
        shutil.rmtree(place, ignore_errors=True)
        raise


def add_libraries(given: Path, folder: Path) -> None:
    """Copy those of the folder's system libraries that this computer lacks."""
    known = said_by(["/sbin/ldconfig", "-p"])
    lacking = [file for file in sorted(given.glob("*.so*")) if f"{file.name} " not in known]
    for file in lacking:
        folder.mkdir(exist_ok=True)
        shutil.copyfile(file, folder / file.name)
    if lacking:
        say(f"added for the window: {', '.join(file.name for file in lacking)}")


def tried(place: Path, *, self_test: bool) -> None:
    """Raise Refused where the new version does not run, or does not pass its own test."""
    asked([program(place, "labcal"), "--version"])
    if self_test:
        say("trying it ...")
        environment = {**os.environ, **library_path(place)}
        if subprocess.run([program(place, "labcal"), "self-test"], env=environment, check=False).returncode:
            raise Refused("labcal does not pass its self-test here; what was installed before is in use as before")


def library_path(place: Path) -> dict[str, str]:
    """The environment in which added libraries are found."""
    libraries = place / "system-libraries"
    before = os.environ.get("LD_LIBRARY_PATH", "")
    return {"LD_LIBRARY_PATH": f"{libraries}:{before}".rstrip(":")} if libraries.is_dir() else {}


def current(prefix: Path, name: str = "current") -> str:
    """The version in use, or the one before; "" where there is none."""
    try:
        return (prefix / name).read_text(encoding="utf-8").strip()
    except FileNotFoundError:
        return ""


def use(prefix: Path, version: str) -> None:
    """Have `version` used from here on; the one in use until now is kept as the one before."""
    before = current(prefix)
    if before != version:
        if before:
            replace(prefix / "previous", before + "\n")
        replace(prefix / "current", version + "\n")


def roll_back(prefix: Path) -> None:
    """Use the version before again. Raises Refused where there is none."""
    before = current(prefix, "previous")
    if not before or not (prefix / "versions" / before / COMPLETE).exists():
        raise Refused("there is no version before this one: nothing was changed")
    use(prefix, before)
    say(f"{before} is in use again; runs, keys and settings are as they were")


def write_launcher(prefix: Path) -> Path:
    """The command that starts the version in use."""
    if WINDOWS:
        launcher = prefix / "labcal.cmd"
        replace(
            launcher,
            '@set /p LABCAL_VERSION=<"%~dp0current"\n@"%~dp0versions\\%LABCAL_VERSION%\\Scripts\\labcal.exe" %*\n',
        )
        return launcher
    launcher = Path.home() / ".local" / "bin" / "labcal"
    replace(launcher, f"""#!/bin/sh
# Starts the labcal that is in use; its installer wrote this.
prefix={shlex.quote(str(prefix))}
here="$prefix/versions/$(cat "$prefix/current")"
if [ -d "$here/system-libraries" ]; then
    export LD_LIBRARY_PATH="$here/system-libraries${{LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}}"
fi
exec "$here/bin/labcal" "$@"
""")  # fmt: skip
    launcher.chmod(0o755)
    return launcher


def write_desktop_entry(bundle: Path, launcher: Path) -> None:
    """Put labcal among the desktop's programs, but on Windows."""
    if WINDOWS:
        return
    icon, entry = desktop_files()
    icon.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(bundle / "labcal.svg", icon)
    command = str(launcher).replace("\\", "\\\\").replace('"', '\\"').replace("%", "%%")
    replace(entry, f"""[Desktop Entry]
Type=Application
Name=labcal
Comment=Calibrate a magnetometer before it flies
Exec="{command}" gui
Icon=labcal
Terminal=false
Categories=Science;Engineering;
""")  # fmt: skip


def desktop_files() -> tuple[Path, Path]:
    """Icon and desktop entry."""
    share = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return share / "icons" / "hicolor" / "scalable" / "apps" / "labcal.svg", share / "applications" / "labcal.desktop"


def remove(prefix: Path) -> None:
    """Take away all that this installs. Raises Refused where nothing of it is there."""
    if not (prefix / "versions").is_dir():
        raise Refused(f"labcal is not installed in {prefix}: nothing was removed")
    files = (prefix / "labcal.cmd",) if WINDOWS else (Path.home() / ".local" / "bin" / "labcal", *desktop_files())
    for path in (*files, prefix / "current", prefix / "previous"):
        path.unlink(missing_ok=True)
    shutil.rmtree(prefix / "versions")
    say("labcal is removed; runs, keys and settings are where they were")


def replace(path: Path, text: str) -> None:
    """Write a file whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.part")
    part.write_text(text, encoding="utf-8", newline="\r\n" if path.suffix == ".cmd" else "\n")
    os.replace(part, path)


def program(place: Path, name: str) -> str:
    """A program of an environment."""
    return str(place / "Scripts" / f"{name}.exe") if WINDOWS else str(place / "bin" / name)


def asked(command: list[str]) -> None:
    """Run a program. Raises Refused with the end of what it said where it fails."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PIP_", "PYTHON"))}
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", env=environment, check=False)
    if done.returncode:
        last = " | ".join((done.stderr or done.stdout).strip().splitlines()[-3:])
        raise Refused(f"{Path(command[0]).name} failed: {last}: what was installed before is in use as before")


def said_by(command: list[str]) -> str:
    """What a program prints; "" where there is no such program."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout
    except OSError:
        return ""


def default_prefix() -> Path:
    """Where this user's programs go."""
    if WINDOWS:
        return Path(os.environ["LOCALAPPDATA"]) / "Programs" / "labcal"
    return Path.home() / ".local" / "lib" / "labcal"


def say(text: str) -> None:
    """One line."""
    print(text, flush=True)


def main(given: Iterable[str] | None = None) -> int:
    """Do what is asked; exit 1 with one sentence where it is refused."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--prefix", type=Path, default=None, help=f"default: {default_prefix()}")
    parser.add_argument("--roll-back", action="store_true", help="use the version before again")
    parser.add_argument("--remove", action="store_true", help="take labcal away")
    parser.add_argument("--no-self-test", action="store_true", help="do not try it before it is used")
    wanted = parser.parse_args(None if given is None else list(given))
    prefix = (wanted.prefix or default_prefix()).expanduser().absolute()
    try:
        if wanted.roll_back:
            roll_back(prefix)
        elif wanted.remove:
            remove(prefix)
        else:
            install(Path(__file__).resolve().parent, prefix, self_test=not wanted.no_self_test)
    except (Refused, OSError) as error:
        print(f"install: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
