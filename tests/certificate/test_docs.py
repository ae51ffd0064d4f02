"""The lines in docs/certificate.md that check a file without labcal do what they say."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from labcal.certificate import sign
from labcal.certificate.allowed_signers import own_line
from labcal.certificate.sshsig import public_key_blob

DOCS = Path(__file__).parents[2] / "docs" / "certificate.md"


@pytest.mark.parametrize("tool", ["ssh-keygen", "openssl"])
def test_the_documented_lines_accept_the_file_and_refuse_a_changed_one(draft: Path, key: Ed25519PrivateKey, tool: str):
    for needed in (tool, "sh", "awk", "base64"):
        if not shutil.which(needed):
            pytest.skip(f"needs {needed}, which is not installed")
    lines = next(block for block in re.findall(r"```sh\n(.*?)```", DOCS.read_text(), re.DOTALL) if tool in block)
    file = draft.rename(draft.with_name("calibration.json"))
    sign(file, "ada@lab.example", key)
    line = own_line("ada@lab.example", public_key_blob(key.public_key())).line()
    (file.parent / "allowed_signers").write_text(f"{line}\n")

    def accepts() -> bool:
        return subprocess.run(["sh", "-c", lines], cwd=file.parent, capture_output=True, check=False).returncode == 0

    assert accepts()
    file.write_bytes(file.read_bytes().replace(b"112.5", b"112.6"))
    assert not accepts()
