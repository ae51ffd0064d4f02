"""README's two commands on a Debian that has nothing but what README names, in a root of its own (debootstrap)."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PATIENCE_S = 3600
CERTIFICATES = Path("/etc/ssl/certs/ca-certificates.crt")
PASSED_ON = ("PIP_INDEX_URL", "PIP_EXTRA_INDEX_URL", "http_proxy", "https_proxy", "no_proxy")

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        sys.platform != "linux" or os.geteuid() != 0 or not shutil.which("debootstrap"),
        reason="needs root on a Debian with debootstrap",
    ),
]


def named_in_readme() -> list[str]:
    """The packages that README asks for, as it writes them."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    [command] = re.findall(r"sudo apt-get install (.*?)```", text, re.DOTALL)
    return command.replace("\\", " ").split()


class Debian:
    """A root that holds a minimal Debian, with this computer's way to the network."""

    def __init__(self, root: Path) -> None:
        self.root = root
        made = subprocess.run(
            ["debootstrap", "--variant=minbase", "bookworm", root], capture_output=True, text=True, timeout=PATIENCE_S
        )
        assert made.returncode == 0, made.stdout[-2000:]
        shutil.copy("/etc/resolv.conf", root / "etc" / "resolv.conf")

    def trust_as_here(self) -> None:
        """Whom this computer trusts: after Debian's own list came with the packages, and would replace it."""
        if CERTIFICATES.exists():
            shutil.copy(CERTIFICATES, self.root / CERTIFICATES.relative_to("/"))

    def run(self, words: str) -> str:
        """What a shell there says to `words`; fails the test where they fail."""
        passed = {name: os.environ[name] for name in PASSED_ON if name in os.environ}
        environment = {"HOME": "/root", "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LANG": "C.UTF-8", **passed}
        environment |= {"PIP_CERT": str(CERTIFICATES)} if CERTIFICATES.exists() else {}
        done = subprocess.run(
            ["chroot", self.root, "bash", "-c", words], env=environment, capture_output=True, text=True,
            timeout=PATIENCE_S,
        )  # fmt: skip
        assert done.returncode == 0, f"{words}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
        return done.stdout


@pytest.fixture(scope="module")
def debian(tmp_path_factory: pytest.TempPathFactory) -> Debian:
    found = Debian(tmp_path_factory.mktemp("debian") / "root")
    found.run("apt-get update -q")
    found.run(f"DEBIAN_FRONTEND=noninteractive apt-get install -y -q {' '.join(named_in_readme())}")
    found.trust_as_here()
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, capture_output=True, timeout=60, check=True).stdout
    (found.root / "root" / "labcal").mkdir()
    subprocess.run(["tar", "-x", "-C", found.root / "root" / "labcal"], input=archive, timeout=60, check=True)
    return found


def test_the_first_command_ends_in_a_signed_file(debian: Debian) -> None:
    said = debian.run("cd /root/labcal && make demo")
    assert re.search(r"^signature +valid *$", said, re.MULTILINE), said[-2000:]
    assert (debian.root / "root" / "labcal" / "demo-out" / "calibration.json.sshsig").is_file()


def test_no_library_of_the_window_is_missing(debian: Debian) -> None:
    libraries = ".venv/lib/python3*/site-packages/PySide6/Qt/plugins/platforms/libqxcb.so"
    assert "not found" not in debian.run(f"cd /root/labcal && ldd {libraries}")
