"""The kinds of fault, by name: what is done, when zero is due, and what is expected of labcal then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import deeds
from benches import ALL, LINES_OF_THEIR_OWN, WATCHDOG_S, WITH_AN_INTERLOCK, WITH_CONTACTS, WITH_WATCHDOGS
from trial import Trial

SIGNALS = {
    "killed": deeds.killed,
    "stopped": deeds.stopped,
    "hung up on": deeds.hung_up_on,
    "told to end": deeds.told_to_end,
    "interrupted twice": deeds.interrupted_twice,
}
WHO = {
    "session": ("session",),
    "guardian": ("guardian",),
    "standby": ("standby",),
    "session and guardian": ("session", "guardian"),
    "session and standby": ("session", "standby"),
    "guardian and standby": ("guardian", "standby"),
    "all three": ("session", "guardian", "standby"),  # another one stands by
    "all of them": ("session", "guardian", "standbys"),
}
LATE_S = (0.3, 1.5, 4.0)


@dataclass(frozen=True)
class Kind:
    """One kind of fault.

    `stops`: somebody presses Ctrl-C a while after the deed. `hears`: zero can reach every supply. `obeys`: the supplies
    do what they hear. `late_s`: that they obey later. `never`: labcal cannot bring the coils to zero, and says so in
    docs/safety.md. `cut`: something else takes their current away, `late_s` later at most. `needs`: a program that is
    not everywhere. `window`: the run is begun in the window.
    """

    name: str
    group: str
    does: Callable[[Trial], None]
    stops: bool = False
    hears: bool = True
    obeys: bool = True
    late_s: float = 0.0
    never: bool = False
    cut: bool = False
    benches: tuple[str, ...] = ALL
    needs: str = ""
    standby_ready: bool = False
    session_stopped: bool = False
    any_procedure: bool = True
    window: bool = False


def _process(how: str, whom: str) -> Kind:
    who = WHO[whom]
    harmless = how in ("hung up on", "interrupted twice")  # for a guardian, which is nobody's child
    due = "session" in who or ("guardian" in who and not harmless)
    never = whom == "all of them" and how in ("killed", "stopped")
    return Kind(
        f"{whom} {how}", "processes", lambda trial: SIGNALS[how](trial, who, due), stops=not due, never=never,
        standby_ready=bool({"guardian", "standby", "standbys"} & {*who}),
        session_stopped="session" in who and how == "stopped",
    )  # fmt: skip


def _supply(name: str, does: Callable[[Trial], None], **what: object) -> Kind:
    return Kind(f"supply {name}", "supplies", does, stops=True, **what)  # type: ignore[arg-type]


def _else(name: str, group: str, does: Callable[[Trial], None], **what: object) -> Kind:
    return Kind(name, group, does, stops=True, **what)  # type: ignore[arg-type]


def _supplies() -> list[Kind]:
    late = [
        _supply(f"obeys {s:g} s late", lambda trial, s=s: deeds.trouble(trial, request_late_s=s), late_s=s)
        for s in LATE_S
    ]
    late += [_supply(f"answers {s:g} s late", lambda trial, s=s: deeds.trouble(trial, reply_late_s=s)) for s in LATE_S]
    return [
        *late,
        _supply("hears twice", lambda trial: deeds.trouble(trial, doubled_requests=True)),
        _supply("answers twice", lambda trial: deeds.trouble(trial, doubled_replies=True)),
        _supply("hears corrupt bytes", lambda trial: deeds.trouble(trial, corrupt_requests=0.25)),
        _supply("answers corrupt bytes", lambda trial: deeds.trouble(trial, corrupt_replies=0.25)),
        _supply("misses requests", lambda trial: deeds.trouble(trial, lost_requests=0.25)),
        _supply("misses answers", lambda trial: deeds.trouble(trial, lost_replies=0.25)),
        _supply("obeys and is mute", lambda trial: deeds.trouble(trial, lost_replies=1.0)),
        _supply("floods its line", lambda trial: deeds.trouble(trial, junk_bytes=4096)),
        _supply("is deaf", lambda trial: deeds.deaf(trial), hears=False),
        _supply("half open", deeds.half_open, benches=("tti",)),
        _supply("lies and measures truly", lambda trial: deeds.lies(trial, True), obeys=False),
        _supply("lies in everything", lambda trial: deeds.lies(trial, False), obeys=False),
        _supply("trips", deeds.trips),
        _supply("reboots to its panel's values", deeds.reboots),
        _supply("dropped and back", deeds.dropped_and_back),
        _supply("dropped", deeds.dropped, hears=False),
        _supply("ports swapped", deeds.swapped, benches=LINES_OF_THEIR_OWN),
    ]


def _sensors() -> list[Kind]:
    kinds = list[Kind]()
    for name in ("stage", "reference", "dut", "reversers"):
        benches = WITH_CONTACTS if name == "reversers" else ALL
        said = {"reversers": "relay", "dut": "DUT"}.get(name, name)
        kinds += [
            _else(f"{said} out", "sensors", lambda trial, n=name: deeds.out(trial, n), benches=benches),
            _else(f"{said} out and in", "sensors", lambda trial, n=name: deeds.out_and_in(trial, n), benches=benches),
            _else(f"{said} frozen", "sensors", lambda trial, n=name: deeds.frozen(trial, n), benches=benches),
        ]
    return [*kinds, _else("reference saturated by a truck", "sensors", deeds.truck)]


def _all_killed(trial: Trial) -> None:
    deeds.killed(trial, WHO["all of them"], True)


def _guardians_stopped(trial: Trial) -> None:
    deeds.stopped(trial, ("guardian", "standbys"), False)


def _nobody_left() -> list[Kind]:
    """What opens by itself where nobody beats, and what comes of it when it fails."""
    kinds = [
        Kind(f"all of them killed, with {what}", "processes", _all_killed, late_s=WATCHDOG_S, cut=True,
             standby_ready=True, benches=(bench,))
        for what, bench in (("an interlock", WITH_AN_INTERLOCK), ("watchdogs", WITH_WATCHDOGS))
    ]  # fmt: skip
    name, benches = "interlock", (WITH_AN_INTERLOCK,)
    return [
        *kinds,
        _else("interlock out", "sensors", lambda trial: deeds.out(trial, name), benches=benches),
        _else("interlock out and in", "sensors", lambda trial: deeds.out_and_in(trial, name), benches=benches),
        _else("interlock is deaf", "sensors", lambda trial: deeds.frozen(trial, name), benches=benches),
    ]


def _store() -> list[Kind]:
    return [
        _else("store full", "store", deeds.store_full),
        _else("store locked", "store", deeds.store_locked),
        _else("store read-only", "store", deeds.store_read_only, needs="strace"),
        _else("store unlinked", "store", deeds.store_unlinked),
        _else("store page overwritten", "store", deeds.page_overwritten),
        _else("store on a slow disk", "store", deeds.slow_disk, needs="strace"),
    ]


def _machine() -> list[Kind]:
    kinds = [
        Kind("suspended and woken", "machine", deeds.suspended, standby_ready=True),
        Kind("standby stopped and woken", "machine", deeds.standby_wakes, stops=True, standby_ready=True),
        Kind("guardian stopped and woken", "machine", deeds.guardian_wakes, standby_ready=True),
        Kind("terminal closed", "machine", deeds.terminal_closed),
        Kind("Ctrl-C", "machine", lambda trial: None, stops=True),
        Kind("bench off from elsewhere", "people", deeds.bench_off),
        Kind("all of them killed, then bench off", "people", deeds.all_killed_then_off),
        Kind("all of them killed, bench off too", "people", deeds.all_killed_and_off_too),
        Kind(
            "all of them stopped, then bench off",
            "people",
            deeds.all_stopped_then_off,
            standby_ready=True,
            session_stopped=True,
        ),
        Kind(
            "guardian and standbys stopped, then bench off",
            "people",
            deeds.guardian_stopped_then_off,
            standby_ready=True,
        ),
        Kind("guardian and standbys stopped", "processes", _guardians_stopped, stops=True, standby_ready=True),
        Kind("all of them killed, the file lost, then bench off", "people", deeds.all_killed_file_lost_then_off),
        _else("two labcals on one bench", "people", deeds.second_labcal),
        _else("two benches on one pair", "people", deeds.second_bench, benches=("riden-pair",)),
        _else("clock set back", "machine", lambda trial: deeds.clock_set(trial, -3600.0)),
        _else("clock set forward", "machine", lambda trial: deeds.clock_set(trial, 3600.0)),
    ]
    for whom in ("session", "guardian"):
        kinds += [
            _else(f"{whom} out of memory", "machine", lambda trial, w=whom: deeds.out_of_memory(trial, w)),
            _else(f"{whom} out of handles", "machine", lambda trial, w=whom: deeds.out_of_handles(trial, w)),
        ]
        kinds += [
            _else(
                f"a {call} of the {whom} fails", "system calls",
                lambda trial, w=whom, c=call: deeds.call_fails(trial, w, c), needs="strace",
            )
            for call in deeds.CALLS
        ]  # fmt: skip
    return kinds


def _window() -> list[Kind]:
    whom = {"window": ("session",), "window's worker": ("worker",), "window and its worker": ("session", "worker")}
    return [
        Kind(
            f"{name} {how}", "window", lambda trial, h=how, w=who: SIGNALS[h](trial, w, True),  # type: ignore[misc]
            window=True, session_stopped=True,
        )
        for name, who in whom.items()
        for how in ("killed", "stopped", "told to end")
    ]  # fmt: skip


def kinds() -> dict[str, Kind]:
    """Every kind by its name."""
    processes = [_process(how, whom) for how in SIGNALS for whom in WHO]
    every = [*processes, *_supplies(), *_nobody_left(), *_sensors(), *_store(), *_machine(), *_window()]
    return {kind.name: kind for kind in every}
