"""The bench: every instrument of a bench.toml by name and by role, on one clock, read in one loop."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Collection, Mapping
from contextlib import ExitStack
from functools import partial
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from labcal.bench.at_a_question import currents_or_away, zero_anew
from labcal.bench.clock import Clock
from labcal.bench.coils.at_zero import AtZero, words_of_slow_zero
from labcal.bench.coils.cage import Cage
from labcal.bench.coils.cage_file import Place
from labcal.bench.coils.channels import COIL_CHANNELS
from labcal.bench.coils.doubt import StoredDoubt
from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading
from labcal.bench.config import BenchConfig, ReferenceConfig
from labcal.bench.driver_kit.identities import refuse_one_at_two_links, the_same
from labcal.bench.driver_kit.roles import (
    ByHand,
    ChannelSpec,
    CoilSupply,
    DutStream,
    Identity,
    Instrument,
    Magnetometer,
    RotationPlatform,
)
from labcal.bench.guarded_identification import all_identified
from labcal.bench.guardian.client import GuardianClient
from labcal.bench.identification import HOLDS_S, Identifications, Identifies
from labcal.bench.listening import Listening
from labcal.bench.named_links import named_links
from labcal.bench.platform import BenchPlatform
from labcal.bench.simulated_operator import SimulatedOperator
from labcal.bench.stopping import zero_and_stop
from labcal.bench.streams.reconnect import AWAY, bring_back
from labcal.bench.streams.reference import blind
from labcal.bench.streams.samples import block_of
from labcal.bench.streams.watch import RestPoll
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event, Prompt, Stream

COIL_POLL_S = 1.0
SEE_S = 0.2  # of the reference, and at least one sample
MOTOR_CHANNEL = ChannelSpec("motor_on", "1", "other", "platform")


class Reopens(Protocol):
    """A link that can be opened again after it was lost."""

    def reopen(self) -> None:
        """Open it. Raises InstrumentError (link lost)."""
        ...


class Bench:
    """Instruments in their roles. Angles are the contract's (`angle_sign` is applied), currents are signed.

    `simulated_operator` does to a simulated lab what a prompt asks; None in a real one. `dut_serial`: of the run's
    DUT. `carry`: what the DUT's place has beyond a remote reference's; None where unknown, or it stands at the DUT.
    """

    def __init__(
        self,
        config: BenchConfig,
        clock: Clock,
        instruments: Mapping[str, Instrument],
        supplies: Mapping[str, CoilSupply],
        platform: RotationPlatform,
        reference: Magnetometer,
        dut: DutStream,
        simulated_operator: SimulatedOperator | None = None,
        links: Mapping[str, Reopens] | None = None,
        guardian: GuardianClient | None = None,
        contacts: Collection[str] = (),
        carry: Place | None = None,
    ) -> None:
        self.name, self.config, self.clock, self.simulated = config.name, config, clock, config.simulated
        self.platform, self.reference, self.dut, self.dut_serial = platform, reference, dut, config.dut.serial
        self.by_hand = next((i for i in instruments.values() if isinstance(i, ByHand)), None)
        self._guardian = guardian
        if guardian is not None:
            guardian.look = lambda: self.look()
        self.cage = Cage(
            config.cage, supplies, clock, dut_limits=config.dut.limits, wait=self._wait_until,
            guardian=guardian.zero if guardian else None, contacts=contacts, see=self._field_seen,
            blind=blind(config.reference), latch=StoredDoubt(config.guarded_links), where=self._where,
        )  # fmt: skip
        self._instruments, self.simulated_operator, self.carry = dict(instruments), simulated_operator, carry
        self._links, self._known, self._known_s = links or {}, dict[str, Identity](), -math.inf
        self._listening = Listening(config, clock, self.cage, dut, reference, self.reconnect, carry, self._waited_for)
        if isinstance(platform, BenchPlatform):
            platform.bring_back = self._bring_stage_back
        self._polled: dict[tuple[Stream, str, tuple[str, ...]], list[tuple[float, ...]]] = {}  # rows of t_s and values
        self.look: Callable[[], None] = lambda: None  # while anybody waits; what it raises ends the waiting
        self._next_angle_s = self._next_coils_s = math.inf
        self._heard_s: dict[str, float] = {}  # what is polled, by name
        self._look = RestPoll(self._at_rest_only(), self._ask_again)
        self.asking = False  # a person: with the coils at zero nothing is missed until the answer
        self.hands_near = True  # as far as is known: nothing is energised or turned before somebody denies it
        self.field_taken = False  # by a pause, from a procedure that has not said since which field it wants
        self.promised = ("", 0.0)  # what "hands off" was said to last, and the largest field of that [nT]
        self.announced: list[str] = []  # what has come on and turned since the step began, in words
        self.homed = False  # the platform, by whoever has this bench now
        self._stands: PlatformReading | None = None  # as it was read last

    def state(self) -> LabState:
        """The lab as it was last read, each part with its time on the bench's clock."""
        watched = self._listening.last_s()
        coils = {self.cage.supplies[coil.axis].name: coil for coil in self.cage.coils()}
        heard = [self._heard(name, watched | self._heard_s, coils.get(name)) for name in self._instruments]
        alive = None if self._guardian is None else self._guardian.alive
        field = self._listening.field.since(self.cage.settled_s)
        field = field.asked(self.cage.asked_nT, changing=self.cage.changing)
        return LabState(self.cage.coils(), self.cage.witness, alive, tuple(heard), field, self._stands)

    def sentence(self) -> str:
        """What may be said of the coils now."""
        return self.state().sentence(self.clock.now())

    def instruments(self) -> Mapping[str, Instrument]:
        """Every instrument by its name in bench.toml."""
        return self._instruments

    def _where(self, name: str) -> str:
        """An instrument for a person to find: its name, who answered as it, and at which port."""
        stated, known = self.config.instruments[name], self._known.get(name)
        who = f"{known.model} {known.serial}".strip() if known else stated.driver
        return f"{name} ({who} at {stated.link})"

    @property
    def known(self) -> Mapping[str, Identity]:
        """Who said who they are when they were asked last."""
        return self._known

    def identities(self, begun: Identifications | None = None) -> dict[str, Identity]:
        """Ask every instrument who it is. Raises InstrumentError naming the first that is silent or another.

        A supply that answers at the links of two coils is another for both. `begun`: those that were asked already.
        Who has said so within HOLDS_S, on links that stayed open, is not asked again.
        """
        if self.clock.now() - self._known_s < HOLDS_S:
            return dict(self._known)
        asked: Mapping[str, Identifies] = self._instruments if begun is None else begun.instead(self._instruments)
        self._known = all_identified(asked, self.config, self.clock)
        links = {name: one.link for name, one in self.config.instruments.items() if one.role.startswith("coil-")}
        refuse_one_at_two_links({name: self._known[name] for name in links}, links)
        self._known_s = self.clock.now()
        return dict(self._known)

    def reconnect(self, name: str) -> Identity:
        """Open the lost link of an instrument again. Raises InstrumentError where another one answers than before."""
        self._known_s = -math.inf
        self._links[name].reopen()
        return the_same(name, self._instruments[name].identify, self._known.get(name))

    @property
    def channels(self) -> tuple[ChannelSpec, ...]:
        """All housekeeping channels that `stream_until` delivers: the DUT's, the coils' and the platform's."""
        return (*self.dut.channels, *COIL_CHANNELS, MOTOR_CHANNEL)

    @property
    def reference_kind(self) -> Literal["vector", "scalar", "none"]:
        """What the record may call the field at the DUT: a remote reference that nothing carries there is none."""
        stated = self.config.reference
        return "none" if stated.place == "remote" and self.carry is None else stated.kind

    @property
    def reference_stated(self) -> ReferenceConfig:
        """What is stated of the reference; carried to the DUT, with the uncertainty of that in scale and zero."""
        stated, carry = self.config.reference, self.carry
        if carry is None:
            return stated
        ppm = 1e6 * carry.u_matrix_nT_per_A / float(np.linalg.norm(self.cage.matrix_nT_per_A, axis=0).min())
        wider = {
            "u_scale_ppm": stated.u_scale_ppm and float(np.hypot(stated.u_scale_ppm, ppm)),
            "u_offset_nT": stated.u_offset_nT and float(np.hypot(stated.u_offset_nT, carry.u_offset_nT)),
        }
        return stated.model_copy(update=wider)

    def start(self) -> None:
        """Begin all streams; from here on nothing that arrives is lost, ramps included."""
        self._listening.start()
        self._next_angle_s = self._next_coils_s = self.clock.now()

    def stream_until(self, t_s: float) -> list[Block]:
        """Everything that arrived up to `t_s` on the bench's clock, in blocks at their own stamps; waits for it."""
        self._wait_until(t_s)
        polled, self._polled = self._polled, {}
        return self._listening.take() + [block_of(*what, rows) for what, rows in polled.items()]

    def events(self) -> list[Event]:
        """What the streams lost since this was asked last: gaps, wrong checksums, broken frames."""
        return sorted(self._listening.events(), key=lambda event: event.t_s)

    def news(self) -> list[Event]:
        """What has fallen silent, or was lost, or is back, since this was asked last; in the order that it happened.

        With the coils at zero somebody may be at its plug: hands are near until they are denied again.
        """
        news = sorted(self._listening.news() + self._look.news(), key=lambda event: event.t_s)
        self.hands_near = self.hands_near or (bool(news) and not self.cage.on)
        return news

    def named(self, text: str, *, brief: bool = False) -> str:
        """`text` with the instruments' names before their links, or in their place."""
        return named_links(text, {name: one.link for name, one in self.config.instruments.items()}, brief=brief)

    def handled(self, prompt: Prompt) -> None:
        """A person does at the DUT's place what `prompt` asks: the ambient field of before judges no current then."""
        self.hands_near = True
        asked = set(prompt.drawing)
        elsewhere = prompt.key == "ready" or (bool(asked) and asked <= {"angle_deg", "mode"})
        if prompt.acts and not elsewhere:
            moved = bool(asked & {"reference_m", "reference_turned"})
            self.cage.check.outdated(self.clock.now(), reference_moved=moved, by_hands=True)

    def stop(self) -> None:
        """End all streams."""
        self._listening.stop()

    def make_safe(self) -> None:
        """Coils to zero first, then every instrument to rest; a failure of one does not skip another."""
        with ExitStack() as steps:
            steps.callback(self.rest_instruments)
            steps.callback(self.zero_and_stop)

    def zero_and_stop(self) -> None:
        """Coils to zero; a platform that may turn is told to stop once that is ordered, whichever supply is dead."""
        zero_and_stop(self.cage, self.platform, self._guardian, self._links.get(self.platform.name))

    def wait_for_ends(self) -> None:
        """Where the guardian still tries to read a coil back at zero it is waited for, once and for a while."""
        if self._guardian is not None:
            self._guardian.wait_for_ends()

    @property
    def ended(self) -> tuple[AtZero, ...]:
        """How the coils ended by the guardian's last word, times on the monotonic clock; empty where there is none."""
        return tuple(self._guardian.ended) if self._guardian is not None else ()

    def state_with_ends(self) -> LabState:
        """The state now, with what the guardian read back at last where nobody has read it since."""
        by_s = time.monotonic() - self.clock.now()
        return self.state().shifted(by_s).with_ends(self.ended).shifted(-by_s)

    def slow_zero(self) -> str:
        """What may be said of a way to zero that takes long, while it does; "" else."""
        ordered = self._guardian is None or self._guardian.zero_is_ordered
        return words_of_slow_zero(self.cage.to_zero_since_s, ordered)

    def stop_platform(self) -> str:
        """Stop the platform, see that it stands, and say so; "" of one without a motor."""
        if self.by_hand is not None or not isinstance(self.platform, BenchPlatform):
            return ""
        self.homed = self.homed and not self.platform.may_turn  # one that was stopped looks for its zero again
        self._stands = self.platform.brought_to_rest(self.clock)
        self._heard_s |= {} if self._stands.read_s is None else {self.platform.name: self._stands.read_s}
        return self._stands.sentence(self.clock.now())

    def look_at_platform(self) -> None:
        """Read where a platform with a motor is, for whoever is asked next; the record has it as it is polled."""
        if self.by_hand is None and isinstance(self.platform, BenchPlatform):
            (angle, moving), t = self.platform.state(), self.clock.now()
            self._stands, self._heard_s[self.platform.name] = PlatformReading(angle, moving, t), t

    def still_wrong(self) -> str:
        """What does not answer yet, in a sentence for whoever wants to begin again; "" where nothing is known."""
        wrong = [f"{one.name} ({one.fault})" for one in self.state().instruments if one.fault]
        return f"Still lost: {', '.join(wrong)}. Put that right first: a step begun now fails again." if wrong else ""

    def rest_instruments(self) -> None:
        """Every instrument to rest, after the coils; a failure of one does not skip another."""
        with ExitStack() as steps:
            first = self.platform.name  # for a supply that is dead is waited for
            for name in (*(name for name in reversed(self._instruments) if name != first), first):
                steps.callback(self._instruments[name].make_safe)

    def close(self) -> None:
        """Let go of every link."""
        with ExitStack() as steps:
            if self._guardian is not None:
                steps.callback(self._guardian.close)
            for instrument in self._instruments.values():
                steps.callback(instrument.close)

    def __enter__(self) -> Bench:
        return self

    def __exit__(self, *_: object) -> None:
        with ExitStack() as steps:
            steps.callback(self.close)
            steps.callback(self.make_safe)

    def _wait_until(self, t_s: float) -> None:
        if self._listening.on:  # however late it is: on a slow line a ramp has no time left to wait
            self.look()
        while self._listening.on and self.clock.now() < t_s:
            listen_s = self._listening.due_s()
            self.clock.wait_until(min(t_s, self._next_angle_s, self._next_coils_s, listen_s))
            self._poll()
            self.look()
            if listen_s <= self.clock.now() < t_s:
                self._listening.listen()
        self.clock.wait_until(t_s)
        if self._listening.on:
            self._listening.listen()

    def _field_seen(self) -> NDArray[np.float64] | None:
        """The mean (3,) of what the reference sends next, C; None where none streams that sees the coils."""
        if not self._listening.on or blind(self.config.reference):
            return None
        begun, rows = self.clock.now(), np.empty((0, 3))
        while not len(rows):
            self._wait_until(self.clock.now() + SEE_S)
            rows = self._listening.reference_since(begun)
        return np.asarray(rows.mean(axis=0))

    def _poll(self) -> None:
        if self.clock.now() >= self._next_angle_s:
            self._next_angle_s = self.clock.now() + self.config.platform.poll_s
            self._poll_platform()
        if self.clock.now() >= self._next_coils_s:
            self._next_coils_s = self.clock.now() + COIL_POLL_S
            self._poll_coils()
        self._look.at(self.clock.now())

    def _waited_for(self) -> bool:
        """Whether what is lost may come back as late as it likes: a person is asked, and no coil is on."""
        return self.asking and not self.cage.on

    def _bring_stage_back(self, lost: InstrumentError) -> None:
        """Wait for the stage's line; while a person is asked it is looked for again and again instead."""
        if self._waited_for():
            raise lost
        bring_back(partial(self.reconnect, self.platform.name), self.clock, lost, look=lambda: self.look())

    def _poll_platform(self) -> None:
        t, name = self.clock.now(), self.platform.name
        if self._waited_for() and self._look.wrong(name):
            return  # it is asked again there
        try:
            if self.asking and self._stands is not None and self._stands.moving is not False:
                self.platform.make_safe()  # its first word: it may turn, and who is asked may reach in
            angle, moving = self.platform.state()
        except InstrumentError as fault:
            if not self._waited_for() or fault.fault not in AWAY:
                raise
            self._look.gone(name, fault, t)
            self._stands = PlatformReading(fault=fault.fault)
            return
        if self.by_hand is None:
            self._stands = PlatformReading(angle, moving, t)
        self._look.heard(name, t)
        self._heard_s[name] = t
        if self.by_hand is None or not moving:  # hands tell no angle before they are taken off
            self._keep("angle", name, ("angle_deg",), t, angle)
        self._keep("channel", name, (MOTOR_CHANNEL.name,), t, float(moving and self.by_hand is None))

    def _poll_coils(self) -> None:
        t = self.clock.now()
        currents = currents_or_away(self.cage, self._look, t, waited_for=self._waited_for())
        if currents is None:
            return
        values = np.column_stack([currents, np.where(np.signbit(currents), -1.0, 1.0)]).ravel().tolist()
        self._keep("channel", "cage", tuple(c.name for c in COIL_CHANNELS), t, *values)

    def _at_rest_only(self) -> list[str]:
        """What nobody hears of while it rests: contacts that are on a real line."""
        there = self.config.instruments.items()
        return [n for n, one in there if one.role == "polarity" and not one.link.startswith("emulated://")]

    def _ask_again(self, name: str) -> None:
        """See that an instrument still answers; its lost line is opened again."""
        if self._look.wrong(name) == "link lost":
            self.reconnect(name)
        if name == self.platform.name:
            self.platform.make_safe()  # first: it went on while nobody could hear of it
        if self._look.wrong(name) != "link lost":
            self._instruments[name].identify()
        zero_anew(self.cage, name)
        self._heard_s[name] = self.clock.now()
        if name == self.platform.name:
            self.look_at_platform()  # who answers again is not said to be unknown until it is polled

    def _heard(self, name: str, heard_s: Mapping[str, float | None], coil: CoilReading | None) -> Heard:
        away = self.platform.away if isinstance(self.platform, BenchPlatform) and name == self.platform.name else ""
        wrong = [away, self._look.wrong(name), *self._listening.wrong(name)]
        known = Heard(name, heard_s.get(name), next(filter(None, wrong), ""))
        return known if coil is None else Heard(name, coil.read_s, coil.fault)

    def _keep(self, stream: Stream, source: str, columns: tuple[str, ...], t_s: float, *values: float) -> None:
        self._polled.setdefault((stream, source, columns), []).append((t_s, *values))
