"""Several users of one computer: who holds a port is seen by all, zero is the group's, and nobody's leftovers block."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest
from other_users import ALICE, BOB, CARL, OF_ROOT, done, some_group, user

from labcal.bench.guardian.wire import OTHER_BENCH
from labcal.bench.links import places, ports

pytestmark = OF_ROOT
PORT = "tcp://192.0.2.1:9221"
HOLDS = f"say(ports.hold([{PORT!r}])); ports.announce({{'pid': os.getpid()}}); say('holds'); sys.stdin.read()"
OF_GROUP = f"port = {PORT!r}; ports.meet(group, runtime); "
ROUND = f"[[ports.hold([{PORT!r}]), ports.let_go()][0], os.path.basename(ports.runtime_folder())]"


# the user's own place


def test_no_environment_variable_says_who_holds_a_port(common: Path, tmp_path: Path) -> None:
    names = ("TMPDIR", "TMP", "TEMP", "HOME", "LABCAL_HOME", "XDG_RUNTIME_DIR", "XDG_DATA_HOME")
    with user(ALICE, common, HOLDS) as first:
        assert [first.says(), first.says()] == [True, "holds"]
        for name in names:
            seen = done(ALICE, common, f"say(ports.holder({PORT!r}))", env={name: str(tmp_path)})
            assert seen == {"pid": first.pid}
        assert done(BOB, common, f"say(ports.holder({PORT!r}))") is None
    assert done(ALICE, common, f"say({ROUND})", env=dict.fromkeys(names, str(tmp_path))) == [True, f"labcal-{ALICE}"]


def squat(kind: str, place: Path, victim: Path) -> None:
    """Somebody else is first."""
    if kind.endswith("folder"):
        place.mkdir(mode=0o700 if kind == "closed folder" else 0o777)
    elif kind == "link":
        place.symlink_to(victim)
    elif kind == "pipe":
        os.mkfifo(place)
    else:
        place.write_text("mine")
    os.chown(place, CARL, CARL, follow_symlinks=False)


@pytest.mark.parametrize("kind", ["folder", "closed folder", "link", "pipe", "file"])
def test_a_name_that_somebody_else_took_first_is_passed_by_and_all_agree(common: Path, kind: str) -> None:
    victim, second = common / "victim", common / "second"
    for folder in (victim, second):
        folder.mkdir()
    second.chmod(0o1777)
    os.chown(victim, ALICE, ALICE)
    squat(kind, place := common / f"labcal-{ALICE}", victim)
    of_two = f"places.SHARED = (Path(common), Path({str(second)!r})); "
    with user(ALICE, common, of_two + HOLDS) as first:
        assert [first.says(), first.says()] == [True, "holds"]
        assert done(ALICE, common, of_two + f"say(ports.holder({PORT!r}))") == {"pid": first.pid}
        place.rmdir() if kind.endswith("folder") else place.unlink()  # the squatter goes, and nobody is led astray
        assert done(ALICE, common, of_two + f"say(ports.holder({PORT!r}))") == {"pid": first.pid}
    assert list(victim.iterdir()) == []


def test_where_every_name_was_taken_a_port_is_held_all_the_same(common: Path) -> None:
    squat("folder", common / f"labcal-{ALICE}", common)
    assert done(ALICE, common, f"say({ROUND})")[0] is True  # such a number has no home either


def test_a_place_that_anybody_may_empty_is_not_used(common: Path) -> None:
    common.chmod(0o777)
    assert done(ALICE, common, f"say({ROUND})")[1] != f"labcal-{ALICE}"


def test_a_folder_whose_mode_was_loosened_is_this_users_alone_again(common: Path) -> None:
    folder = common / f"labcal-{ALICE}"
    squat("folder", folder, common)
    os.chown(folder, ALICE, ALICE)
    assert done(ALICE, common, f"say({ROUND})") == [True, folder.name]
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


# the group's folder


def test_what_one_of_the_group_holds_the_others_see_and_the_next_shift_inherits(common: Path, of_group: Path) -> None:
    with user(ALICE, common, OF_GROUP + HOLDS) as first:
        assert [first.says(), first.says()] == [True, "holds"]
        (lock,) = of_group.glob("port-*.lock")
        assert (stat.S_IMODE(lock.stat().st_mode), lock.stat().st_gid) == (0o660, some_group()[1])
        tries = f"""
say([ports.holder({PORT!r}), ports.hold([{PORT!r}]), ports.announced(), ports.holding({PORT!r})])
try: ports.claim({PORT!r})
except InstrumentError as fault: say([fault.fault, str(fault)])
"""
        with user(BOB, common, OF_GROUP + tries) as other:
            card = {"pid": first.pid}
            assert other.says() == [card, False, [card], first.pid]
            fault, said = other.says()
        assert fault == "in use"
        assert f"of user {ALICE} (process {first.pid}) holds this port since 20" in said
        first.kill()
        assert done(BOB, common, OF_GROUP + f"say({ROUND})") == [True, of_group.name]
        assert list(of_group.iterdir()) == []  # and takes the dead one's file away


def junk(kind: str, place: Path, victim: Path) -> None:
    """What another member may leave where a lock belongs."""
    if kind == "link":
        place.symlink_to(victim)
    elif kind == "second name":
        os.link(victim, place)
    elif kind == "pipe":
        os.mkfifo(place, 0o666)
    elif kind == "folder":
        (place / "full").mkdir(parents=True)
    else:
        place.write_text("nobody else may read it")
        place.chmod(0o600)
    os.chown(place, ALICE, some_group()[1], follow_symlinks=False)


@pytest.mark.parametrize("kind", ["link", "second name", "pipe", "folder", "closed file"])
def test_what_is_no_lock_file_is_neither_followed_nor_waited_for(common: Path, of_group: Path, kind: str) -> None:
    name = done(BOB, common, OF_GROUP + f"say(ports._lock_file(ports.port_of({PORT!r})).name)")
    (victim := common / "victim").write_text("dear")
    os.chown(victim, BOB, some_group()[1])
    victim.chmod(0o660)
    junk(kind, of_group / name, victim)
    looks = f"say([ports.holder({PORT!r}), ports.announced()]); say({ROUND})"
    with user(BOB, common, OF_GROUP + looks) as bob:
        assert bob.says() == [None, []]
        assert bob.says() == [True, of_group.name]
    assert victim.read_text() == "dear"


def test_a_lock_that_is_held_is_not_set_aside_for_its_looks(common: Path, of_group: Path) -> None:
    with user(ALICE, common, OF_GROUP + HOLDS) as first:
        assert [first.says(), first.says()] == [True, "holds"]
        (lock,) = of_group.glob("port-*.lock")
        os.link(lock, of_group / "another name")
        assert done(BOB, common, OF_GROUP + f"say(ports.hold([{PORT!r}]))") is False
        lock.chmod(0o600)
        assert done(BOB, common, OF_GROUP + f"say([ports.holder({PORT!r}), ports.hold([{PORT!r}])])") == [{}, False]
        assert lock.exists()


def refused(common: Path, uid: int, *, member: bool = True) -> str:
    """Why this user cannot meet the group; its locks lie in the own place then, and are held there."""
    meets = f"""
try: ports.meet(group, runtime)
except InputError as error: say([str(error), *{ROUND}])
"""
    said, held, where = done(uid, common, meets, member=member)
    assert (held, where) == (True, f"labcal-{uid}")
    assert "\n" not in said
    return str(said)


def test_without_the_groups_folder_it_says_what_an_administrator_does_once(common: Path) -> None:
    common.chmod(0o1755)
    (common / f"labcal-{BOB}").mkdir(mode=0o700)
    os.chown(common / f"labcal-{BOB}", BOB, BOB)
    group, _ = some_group()
    command = f"sudo install -d -m 2770 -g {group} {common}/of-group"
    said = refused(common, BOB)
    assert said.endswith(f"of-group is not there; an administrator makes it, once: {command}")
    assert os.system(command.removeprefix("sudo ")) == 0
    assert done(BOB, common, OF_GROUP + f"say({ROUND})") == [True, "of-group"]


@pytest.mark.parametrize("wrong", ["open to all", "another group", "no setgid", "link", "file"])
def test_a_folder_that_is_not_the_groups_alone_is_refused(common: Path, of_group: Path, wrong: str) -> None:
    if wrong in ("link", "file"):
        of_group.rename(common / "elsewhere")
        of_group.symlink_to("elsewhere") if wrong == "link" else of_group.touch()
    else:
        os.chown(of_group, 0, 0 if wrong == "another group" else some_group()[1])
        of_group.chmod({"open to all": 0o2777, "no setgid": 0o770}.get(wrong, 0o2770))
    assert "is no folder of group" in refused(common, BOB)


def test_who_is_not_in_the_group_is_told_how_to_come_in(common: Path, of_group: Path) -> None:
    assert f"sudo usermod -aG {some_group()[0]} {CARL}" in refused(common, CARL, member=False)


def test_whoever_may_makes_the_groups_folder(common: Path) -> None:
    assert done(BOB, common, OF_GROUP + f"say({ROUND})") == [True, "of-group"]
    stands = (common / "of-group").stat()
    assert (stat.S_IMODE(stands.st_mode), stands.st_gid) == (0o2770, some_group()[1])


def test_a_group_that_is_none_is_said_to_be(common: Path) -> None:
    says = "\ntry: ports.meet('no-such-group')\nexcept InputError as error: say(str(error))"
    assert done(BOB, common, says) == "this computer has no group 'no-such-group'"


def test_what_windings_have_borne_under_one_user_the_next_one_knows(common: Path, of_group: Path) -> None:
    keeps = f"""
kept = duty.DutyRecord([{PORT!r}])
kept.keep(np.array([0.0, %s, 1.0]), 1.0)
logbook.written(at_most_s=30)
say(kept.recall(1e6).round(2).tolist())
"""
    assert done(ALICE, common, OF_GROUP + keeps % 4.0) == [0.0, 4.0, 1.0]
    os.mkfifo(of_group / next(of_group.glob("duty-*")).name.replace(str(ALICE), "0"))
    assert done(BOB, common, OF_GROUP + keeps % 2.0) == [0.0, 4.0, 1.0]


# the guardian's ear

CALLS = f"""
found = client.found([{PORT!r}])
def ask(order, **what):
    try: return client.ask_once(found, order, **what)
    except InstrumentError as fault: return [fault.fault, str(fault)]
"""


def test_zero_is_the_groups_and_energising_its_users(common: Path, of_group: Path) -> None:
    guards = """
class Coils:
    coils, unresolved, energised, heard = {}, {}, False, []
    def zero(self, why, *, by_session=False): self.heard.append(why); return []
    def give_back(self): pass
    def order_zero(self, why, *, by_session=False): pass
    def facts(self): return {}
    def set_current(self, axis, current_A): self.heard.append(current_A)
    identify = reopen = modbus = set_point = measure_current = read = output = facts
listener, card = wire.listen()
guards = server.Server(Coils(), listener, card["token"], "f" * 64)
guards.ready.set(); guards.start()
ports.hold([port]); ports.announce(card); say(card["address"])
while sys.stdin.readline(): say([Coils.heard, guards.dismissed.is_set()])
"""
    hello = "ask('hello', who='session 5', bench='f' * 64)"
    energise = "ask('set_current', axis='x', current_A=1.0)"
    with user(ALICE, common, OF_GROUP + guards) as alice:
        address = Path(alice.says())
        assert address.parent == of_group
        assert (stat.S_IMODE(address.stat().st_mode), address.stat().st_gid) == (0o660, some_group()[1])
        owns = OF_GROUP + CALLS + f"say([{hello}, {energise}]); sys.stdin.read()"
        with user(ALICE, common, owns) as session:
            assert session.says() == [{"facts": {}}, None]
            tries = OF_GROUP + CALLS + f"say([{hello}, {energise}, ask('zero', why='off')])"
            (busy, told), (fault, _), zeroed = done(BOB, common, tries)
            assert (busy, fault, zeroed) == ("in use", "forbidden", [])
            assert f"session 5 of user {ALICE} drives this bench since 20" in told
        alice.go_on()
        assert alice.says() == [[1.0, f"off of user {BOB}"], False]
        makes_room = OF_GROUP + CALLS + f"say([{hello}, {energise}])"
        (fault, said), (forbidden, _) = done(BOB, common, makes_room)
        assert (fault, forbidden) == (OTHER_BENCH, "forbidden")
        assert "another user's; it makes room" in said
        alice.go_on()
        assert alice.says()[1] is True
        outside = f"""
try: wire.connect({{"address": {str(address)!r}}}, 1.0)
except OSError as error: say(error.errno)
"""
        assert done(CARL, common, outside, member=False) == 13
        alice.kill()
    assert address.exists()
    assert done(BOB, common, OF_GROUP + guards) != str(address)
    assert not address.exists()  # who begins sweeps the dead one's away


def test_a_member_who_plays_the_guardian_is_not_believed_by_anothers_session(common: Path, of_group: Path) -> None:
    plays = """
class Plays:
    coils, unresolved, energised = {}, {}, False
    def __getattr__(self, name): return lambda *_, **__: {}
server.Server._welcome = lambda *_, **__: {"facts": {}}
listener, card = wire.listen()
guards = server.Server(Plays(), listener, card["token"], "f" * 64)
guards.ready.set(); guards.start()
ports.hold([port]); ports.announce(card); say("plays"); sys.stdin.read()
"""
    meets = f"""
class Config: guarded_links = [{PORT!r}]
(bench := Path(common) / "bench.toml").write_text("")
try: client.GuardianClient(bench, Config, RealClock())
except InstrumentError as fault: say([fault.fault, str(fault)])
"""
    with user(BOB, common, OF_GROUP + plays) as bob:
        assert bob.says() == "plays"
        fault, said = done(ALICE, common, OF_GROUP + meets)
    assert (fault, "is not believed" in said) == ("in use", True)


def test_an_administrator_looks_into_the_places_of_all_users(common: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(places, "SHARED", (common,))
    with user(ALICE, common, HOLDS) as alice:
        assert [alice.says(), alice.says()] == [True, "holds"]
        squat("folder", common / "labcal-7", common)  # a user's folder that is not that user's
        assert {"pid": alice.pid} in ports.announced()
        assert common / "labcal-7" not in places.folders()


@pytest.mark.parametrize(
    "lies", [{"address": 22}, {"address": []}, {"address": "\0x"}, {"address": "/x" * 99}, {"address": "/"}]
)
def test_a_card_that_lies_leads_nobody_astray(common: Path, of_group: Path, lies: dict[str, object]) -> None:
    holds = f"ports.hold([port]); ports.announce({lies!r} | {{'bench': '/lab/bench.toml'}}); say(0); sys.stdin.read()"
    looks = "\nfound = [client.found([port]), *client.guarding(Path('/lab/bench.toml'))]\nsay(found)"
    with user(ALICE, common, OF_GROUP + holds) as alice:
        assert alice.says() == 0
        if lies["address"] == "/x" * 99:
            looks = "\ntry: client.found([port])\nexcept OSError: say([None])"
        assert done(BOB, common, OF_GROUP + looks) == [None]


def test_a_guardian_from_before_the_group_was_stated_is_found(common: Path, of_group: Path) -> None:
    with user(ALICE, common, HOLDS) as alice:
        assert [alice.says(), alice.says()] == [True, "holds"]
        asks = f"say([ports.holder({PORT!r}), ports.holding({PORT!r})])"
        assert done(ALICE, common, OF_GROUP + asks) == [{"pid": alice.pid}, alice.pid]
        assert done(0, common, asks) == [{"pid": alice.pid}, alice.pid]  # an administrator's look
        assert done(BOB, common, OF_GROUP + asks) == [None, None]
