"""The watch: what it makes of new runs, whom it tells, and what it outlives."""

from __future__ import annotations

import json
import shutil
import socketserver
import threading
from collections.abc import Iterator
from dataclasses import replace
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import TypeVar

import pytest

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.files.home import for_children, home
from labcal.store import save_bundle
from labcal.store.bundle import bundle_of
from labcal.testing.made_up_runs import made_up_run
from labcal.years.notify import Mail, Webhook, notify
from labcal.years.watch import Source, look, watch

S = TypeVar("S", bound=socketserver.BaseServer)


class Mailbox(socketserver.ThreadingTCPServer):
    """Takes mail as SMTP has it, and keeps what it was given."""

    allow_reuse_address = daemon_threads = True

    def __init__(self) -> None:
        self.mails = list[str]()
        super().__init__(("127.0.0.1", 0), Session)

    @property
    def name(self) -> str:
        return f"127.0.0.1:{self.server_address[1]}"


class Session(socketserver.StreamRequestHandler):
    server: Mailbox

    def handle(self) -> None:
        self.say("220 here")
        for line in self.rfile:
            word = line.split(b" ")[0].strip().upper()
            if word == b"DATA":
                self.say("354 go on")
                self.server.mails.append(self.body())
                self.say("250 kept")
            elif word == b"QUIT":
                return self.say("221 bye")
            else:
                self.say("250 fine")
        return None

    def body(self) -> str:
        lines = []
        for line in self.rfile:
            if line == b".\r\n":
                break
            lines.append(line.decode())
        return "".join(lines)

    def say(self, text: str) -> None:
        self.wfile.write(f"{text}\r\n".encode())


class Hook(HTTPServer):
    """Takes JSON by POST; answers `code`."""

    def __init__(self, code: int = 200) -> None:
        self.posted, self.code = list[dict[str, object]](), code
        super().__init__(("127.0.0.1", 0), Posted)

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}/secret-path"


class Posted(BaseHTTPRequestHandler):
    server: Hook

    def do_POST(self) -> None:
        self.server.posted.append(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(self.server.code)
        self.end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Not on stderr."""


@pytest.fixture
def mailbox() -> Iterator[Mailbox]:
    yield from serving(Mailbox())


@pytest.fixture
def hook() -> Iterator[Hook]:
    yield from serving(Hook())


def serving(server: S) -> Iterator[S]:
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield server
    server.shutdown()
    server.server_close()
    thread.join()


def bundle(folder: Path, name: str, seed: int = 0) -> Path:
    run = made_up_run(rows=24, noise_nT=5.0, seed=seed).run
    folder.mkdir(exist_ok=True)
    save_bundle(bundle_of(replace(run, run_id=name)), folder / f"{name}.zip")
    return folder / f"{name}.zip"


def test_a_new_run_is_drafted_and_told_and_a_broken_one_too_and_none_of_them_twice(
    tmp_path: Path, mailbox: Mailbox, hook: Hook, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, out = tmp_path / "in", tmp_path / "out"
    bundle(folder, "r1")
    (folder / "broken.zip").write_bytes(b"PK\x03\x04 no zip at all")
    words = ["watch", str(folder), "--once", "--out", str(out), "--mail", "ada@example.org", "--smtp", mailbox.name]
    words += ["--webhook", hook.url, "--json", "-"]
    assert labcal(words) == 1
    found = {one["run"]: one for one in json.loads(capsys.readouterr().out)}
    assert found["broken.zip"]["needs"]
    assert Path(found["r1"]["draft"]).is_file()
    assert Path(found["r1"]["report"]).is_file()
    assert not list(out.rglob("*.sshsig"))
    assert len(mailbox.mails) == 1
    assert "To: ada@example.org" in mailbox.mails[0]
    assert "broken.zip" in mailbox.mails[0]
    assert "nothing is signed" in mailbox.mails[0]
    assert {run["run"] for run in hook.posted[0]["runs"]} == {"r1", "broken.zip"}  # type: ignore[attr-defined]
    assert labcal(words) == 0
    assert json.loads(capsys.readouterr().out) == []
    assert len(mailbox.mails) == len(hook.posted) == 1


def test_who_could_not_be_told_is_told_at_the_next_look(tmp_path: Path, mailbox: Mailbox) -> None:
    folder, out = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    (folder / "broken.zip").write_bytes(b"nothing")
    nobody = Mail(("ada@example.org",), "labcal@localhost", "127.0.0.1:1")
    with pytest.raises(InputError, match=r"nobody was notified by mail over 127\.0\.0\.1:1"):
        look(Source(folder, settled_s=0), out, [nobody])
    assert look(Source(folder, settled_s=0), out, [replace(nobody, server=mailbox.name)]) == []
    assert "broken.zip" in mailbox.mails[0]


def test_a_webhook_that_fails_keeps_no_mail_back_and_its_address_is_not_said(mailbox: Mailbox) -> None:
    for refusing in serving(Hook(500)):
        with pytest.raises(InputError, match=r"webhook at 127\.0\.0\.1") as told:
            notify([Webhook(refusing.url), Mail(("a@b",), "c@d", mailbox.name)], "s", "t", {})
        assert "secret-path" not in str(told.value)
    assert len(mailbox.mails) == 1


CANARY = "c4nary"


@pytest.mark.parametrize(
    "url",
    [
        f"http://ada:{CANARY}@127.0.0.1:9/hook",
        f"http://127.0.0.1:9/{CANARY} x",
        f"http://127.0.0.1:9/{CANARY}\x01",
        f"http://127.0.0.1:{CANARY}/hook",
        f"http://[{CANARY}/hook",
        f"http://127.0.0.1:9/{CANARY}\u2028é",
    ],
)
def test_a_webhook_that_cannot_be_one_is_refused_and_not_repeated(
    url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["watch", str(tmp_path), "--once", "--webhook", url]) == 2
    monkeypatch.setenv("LABCAL_WEBHOOK", f"http://[{CANARY}/hook")
    assert labcal(["watch", str(tmp_path), "--once"]) == 2
    told = capsys.readouterr().err
    assert told.count("a webhook is an address that begins with http:// or https://") == 2
    assert CANARY not in told


def test_a_mail_server_s_password_is_not_taken_from_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["watch", str(tmp_path), "--once", "--mail", "a@b", "--smtp", f"ada:{CANARY}@mail.example:25"]
    assert labcal(words) == 2
    told = capsys.readouterr().err
    assert "LABCAL_SMTP_PASSWORD" in told
    assert CANARY not in told


def test_a_webhook_may_be_told_in_the_environment_alone(
    tmp_path: Path, hook: Hook, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "broken.zip").write_bytes(b"nothing")
    monkeypatch.setenv("LABCAL_WEBHOOK", hook.url)
    assert labcal(["watch", str(tmp_path / "in"), "--once", "--out", str(tmp_path / "out")]) == 1
    assert len(hook.posted) == 1
    assert "LABCAL_WEBHOOK" not in for_children()


class Babble(socketserver.StreamRequestHandler):
    def handle(self) -> None:
        self.rfile.readline()
        self.wfile.write(b"220 this is no HTTP\r\n")


def test_a_server_that_speaks_no_http_is_a_way_that_failed() -> None:
    for babbling in serving(socketserver.ThreadingTCPServer(("127.0.0.1", 0), Babble)):
        with pytest.raises(InputError, match=r"nobody was notified by the webhook at 127\.0\.0\.1: "):
            notify([Webhook(f"http://127.0.0.1:{babbling.server_address[1]}/hook")], "s", "t", {})


def test_a_fault_of_labcal_s_own_does_not_keep_the_address(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(*_: object) -> None:
        raise RuntimeError("it broke")

    words = ["watch", str(tmp_path), "--once", "--webhook", f"https://127.0.0.1:9/{CANARY}"]
    monkeypatch.setattr("sys.argv", ["labcal", *words])
    monkeypatch.setattr("labcal.years.watch.look", fails)
    assert labcal(words) == 2
    assert "a fault of labcal's own" in capsys.readouterr().err
    report = (home() / "last-fault.txt").read_text()
    assert "--webhook ***" in report
    assert CANARY not in report


def test_a_watch_goes_on_where_the_folder_was_away_and_takes_no_file_that_is_still_written(tmp_path: Path) -> None:
    folder, out, said, looks = tmp_path / "in", tmp_path / "out", list[str](), list[float]()

    class Enough(Exception):
        pass

    def wait(seconds: float) -> None:
        looks.append(seconds)
        if len(looks) == 2:
            folder.mkdir()
            (folder / "half.zip").write_bytes(b"half of it")
        if len(looks) == 4:
            raise Enough

    with pytest.raises(Enough):
        watch(Source(folder, settled_s=3600), out, [], 7.0, said.append, wait)
    assert looks == [7.0] * 4
    assert said == [f"{folder}: is no folder"]
    [found] = look(Source(folder, settled_s=0), out, [])
    assert found.run == "half.zip"
    (folder / "half.zip").write_bytes(b"half of it, and the rest")
    assert [one.run for one in look(Source(folder, settled_s=0), out, [])] == ["half.zip"]


def test_a_draft_that_a_person_has_changed_is_kept_where_its_run_comes_again(tmp_path: Path) -> None:
    source, out = Source(tmp_path / "in", settled_s=0), tmp_path / "out"
    given = bundle(tmp_path / "in", "r1")
    [first] = look(source, out, [])
    draft = Path(first.draft)
    untouched = draft.read_bytes()
    given.rename(given.with_name("elsewhere.zip"))
    [again] = look(source, out, [])
    assert not any("already" in need for need in again.needs)
    draft.write_bytes(untouched.replace(b'"approvers":[]', b'"approvers":["Ada"]'))
    approved = draft.read_bytes()
    assert approved != untouched
    shutil.copy(given.with_name("elsewhere.zip"), given)
    [third] = look(source, out, [])
    assert draft.read_bytes() == approved
    assert f"{draft}: is there already" in third.needs[0]


@pytest.mark.parametrize("place", [".", "keys", "bundles/mine"])
def test_a_watch_keeps_nothing_among_what_is_labcal_s_own(
    place: str, tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert labcal(["watch", str(tmp_path), "--out", str(home_of_its_own / place)]) == 2
    assert "labcal's own" in capsys.readouterr().err
    assert not list(home_of_its_own.iterdir())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "say the FOLDER"),
        (["{here}", "--archive", "postgresql://x/y"], "say the FOLDER"),
        (["{here}/none", "--once"], "is no folder"),
        (["{here}", "--once", "--mail", "nobody"], "no mail address"),
        (["{here}", "--once", "--mail", "a@b\nBcc: x@y"], "no mail address"),
        (["{here}", "--once", "--mail", "a@b", "--smtp", "h:x"], "HOST:PORT"),
        (["{here}", "--once", "--mail", "a@b", "--smtp", "[h"], "HOST:PORT"),
        (["{here}", "--once", "--webhook", "file:///etc/passwd"], "http://"),
        (["{here}", "--json", "-"], "--once"),
        (["{here}", "--once", "--out", "{here}/foreign"], "not what a watch keeps"),
    ],
)
def test_what_cannot_be_watched_is_refused(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "foreign").mkdir()
    (tmp_path / "foreign" / "watched.json").write_text("{}")
    assert labcal(["watch", *(word.format(here=tmp_path) for word in words)]) == 2
    assert said in capsys.readouterr().err
