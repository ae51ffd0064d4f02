"""An effect held to its physics: its columns, found where it is, left where it is not, the same after a file."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.certificate import calibration_bytes, parse_calibration
from labcal.errors import InputError
from labcal.fit import draft_calibration
from labcal.loop import ClosedLoop, close_loop
from labcal.model import Calibration
from labcal.model.apply import apply, apply_in_pieces
from labcal.model.effects import Family, Scene, Term, family, load
from labcal.model.readings import Readings
from labcal.model.records import EffectRecord
from labcal.record import Channel, Run
from labcal.testing.made_up_runs import MadeUp, made_up_run
from labcal.testing.require import require

Array = NDArray[np.float64]
Formula = Callable[[Scene, Mapping[str, float]], Array]
STEP = 1e-4  # of a parameter, for differences
AGREE = 1e-6  # of the largest column
PIECES = 3  # that a recording is applied in, which must not show
WITHIN_u, SHARE = 4.0, 0.03  # how far a parameter may be from the truth: in its uncertainty, and of itself
LEFT = 1.3  # rms after `apply` over the noise
SHA256 = "0" * 64


@dataclass(frozen=True)
class EffectTrial:
    """An effect, a run without it, what it would be there, and the same by a formula of its author's."""

    family: Family
    made: MadeUp
    truth: Mapping[str, float]
    formula: Formula

    @property
    def id(self) -> str:
        """How it is spoken of."""
        return f"effect {self.family.id!r}"

    @property
    def scene(self) -> Scene:
        """What its kernel looks at in the run without noise."""
        run = self.made.run
        channels = {c.name: c.values for c in run.channels}
        return Scene(run.t_s, run.segment_index, self.made.field_nT, channels, run.mode, self.made.true.K)

    def run(self) -> Run:
        """The run of a sensor that has it, as the formula says."""
        effect = np.zeros_like(self.made.field_nT)
        for _ in range(3):  # it may depend on the field that the sensor reads
            effect = self.says(_counted(self.scene.moved(effect), self.term()), self.truth)
        return self.made.with_effect(effect)

    def says(self, counted: Scene, values: Mapping[str, float]) -> Array:
        """What the formula gives (n, 3)."""
        try:
            effect = np.asarray(self.formula(counted, values), dtype=float)
        except KeyError as error:
            has = f"channels {', '.join(counted.channels) or 'none'}; values {', '.join(values)}"
            raise AssertionError(f"the formula of {self.id} asks for {error}; there are: {has}.") from error
        wanted = (len(counted), 3)
        text = f"the formula of {self.id} gives an array of shape {effect.shape}, not (rows, 3) = {wanted}."
        require(effect.shape == wanted, text)
        return effect

    def term(self) -> Term:
        """The term of its candidates that has just the parameters of the truth, at the truth."""
        terms = list(self.family.candidates(self.made.run))
        text = (
            f"{self.id}: candidates(run) is empty on a run with the channels {self._channels()}: which does it need, "
        )
        text += "of which quantity and role? A channel has to move, and to be as long as the run."
        require(terms, text)
        named = [t for t in terms if {n for n, _ in t.parameters} | {s.name for s in t.shape} == set(self.truth)]
        has = "; ".join(", ".join([n for n, _ in t.parameters] + [s.name for s in t.shape]) for t in terms)
        require(named, f"{self.id}: no candidate has just the parameters of `truth`; they have: {has}.")
        return named[0].with_values(**{s.name: self.truth[s.name] for s in named[0].shape})

    def _channels(self) -> str:
        said = (f"{c.name} ({c.quantity}, role {c.role}, {len(c.values)} rows)" for c in self.made.run.channels)
        return ", ".join(said) or "none"


def check_effect(
    effect: str,
    truth: Mapping[str, float],
    formula: Formula,
    *,
    channels: Callable[[Array], Sequence[Channel]] | Sequence[Channel] = (),
    rows: int = 100,
    noise_nT: float = 25.0,
) -> None:
    """Hold an installed effect to its physics on a made-up run of six turns of `rows` rows, 0.5 s apart.

    `truth`: a value of each of its parameters, the nonlinear ones too, large enough to be seen beside `noise_nT`.
    `formula(scene, values)`: the effect (n, 3) [nT of B] at parameters by name, written apart from the kernel; the
    scene's channels are counted from the effect's reference values. `channels`: what the run records beside the
    readings, or a function that makes them of its times (n,) [s].

    Its columns must be the formula's derivatives; the loop must find it in the run that has it, with the parameters of
    `truth`, and leave it in the run that has not; a sensor's must come back from a calibration file and be corrected by
    `apply`, in one piece and in several, that of the rig or of the data stand among the findings. An effect that looks
    at other rows has to say so. Raises AssertionError.

    "The formula's" is to 1e-6 of the largest: between two rows a channel goes straight, and where an effect remembers
    let what it follows stand still at first, for how a state begins is the kernel's own affair.
    """
    trial = _trial(effect, truth, formula, channels, rows, noise_nT)
    check_family(trial.family)
    check_derivative(trial)
    check_memory(trial)
    check_left_where_it_is_not(trial)
    closed = check_found(trial)
    check_round_trip(trial, closed)


def _trial(
    effect: str,
    truth: Mapping[str, float],
    formula: Formula,
    channels: Callable[[Array], Sequence[Channel]] | Sequence[Channel],
    rows: int,
    noise_nT: float,
) -> EffectTrial:
    try:
        found = family(effect)
    except InputError as error:
        text = f'{error}: declare it in [project.entry-points."labcal.effects"] and install again.'
        raise AssertionError(text) from error
    times = made_up_run(rows=rows).run.t_s
    recorded = channels(times) if callable(channels) else channels
    text = f"effect {effect!r}: `channels` has to give a list of labcal.record.Channel, each with an array of values."
    require(all(isinstance(c, Channel) and isinstance(c.values, np.ndarray) for c in _each(recorded)), text)
    return EffectTrial(found, made_up_run(rows=rows, noise_nT=noise_nT, channels=recorded), truth, formula)


def _each(recorded: object) -> Sequence[object]:
    return recorded if isinstance(recorded, Sequence) else (recorded, None)


def check_family(found: Family) -> None:
    """It says what would show it."""
    text = f"effect {found.id!r} names no experiment: Family(…, experiment='what would show it')."
    require(found.experiment, text)


def check_derivative(trial: EffectTrial) -> None:
    """Each column is the formula's derivative, also beside the truth of each nonlinear parameter."""
    term = trial.term()
    _check_columns(trial, term, trial.truth)
    for shape in term.shape:
        for factor in (0.8, 1.25):
            beside = {**trial.truth, shape.name: trial.truth[shape.name] * factor}
            _check_columns(trial, term.with_values(**{shape.name: beside[shape.name]}), beside)


def _check_columns(trial: EffectTrial, term: Term, values: Mapping[str, float]) -> None:
    columns, counted = term.columns(trial.scene), _counted(trial.scene, term)
    wanted = (len(trial.scene), 3, len(term.parameters))
    text = f"the kernel of {trial.id} gives columns of shape {columns.shape}, not (rows, 3, parameters) = {wanted}."
    require(columns.shape == wanted, text)
    at = ", ".join(f"{s.name} = {values[s.name]:g}" for s in term.shape)
    for number, (name, unit) in enumerate(term.parameters):
        step = STEP * (abs(values[name]) or 1.0)
        up, down = (trial.says(counted, {**values, name: values[name] + sign * step}) for sign in (1, -1))
        numeric = (up - down) / (2 * step)
        apart = np.abs(columns[:, :, number] - numeric)
        off, row = float(np.max(apart)), int(np.argmax(np.max(apart, axis=1)))
        largest = max(float(np.max(np.abs(numeric))), 1e-12)
        text = f"column {name} [{unit}] of {trial.id} is not the derivative of the formula{' at ' + at if at else ''}"
        text += f", by {off:.3g} nT per unit in row {row} of {len(trial.scene)}; the largest is {largest:.3g}, and they"
        text += f" have to agree to {AGREE:g} of that: look at sign, unit and reference value"
        text += "; of one that remembers at how it begins, and that a channel goes straight between two rows."
        require(off <= AGREE * largest, text)
    text = f"{trial.id} is not its columns times its parameters{' at ' + at if at else ''}: a constant is left over."
    beta = np.array([values[name] for name, _ in term.parameters])
    whole = trial.says(counted, values)
    scale = AGREE * max(float(np.max(np.abs(whole))), 1e-12)
    require(np.max(np.abs(columns @ beta - whole)) <= scale, text)


def _counted(scene: Scene, term: Term) -> Scene:
    """The scene with the channels counted from where the effect counts them."""
    counted = {name: values - term.reference_value.get(name, 0.0) for name, values in scene.channels.items()}
    return replace(scene, channels=counted)


def check_memory(trial: EffectTrial) -> None:
    """One that looks at other rows says so: what each row has by itself is what it has among the others."""
    term = trial.term()
    if trial.family.reach_s(term) is not None:
        return
    whole, half = term.columns(trial.scene), np.arange(len(trial.scene)) % 2 == 1
    off = np.max(np.abs(term.columns(trial.scene.select(half)) - whole[half]))
    text = f"{trial.id} gives other columns where half of the rows are left out: it looks at other rows, and does not "
    text += "say so. A shape of the kind TIME_CONSTANT, DELAY or SECANT says it, of a term that follows a channel, or "
    text += "Family(…, reach_s=…), with 0 of a state (labcal/model/effects/memory.py)."
    require(off <= AGREE * max(float(np.max(np.abs(whole))), 1e-12), text)


def check_left_where_it_is_not(trial: EffectTrial) -> None:
    """The run without it is clean."""
    closed = close_loop(trial.made.run)
    named = [e.effect for e in closed.accepted]
    text = f"{trial.id} is named in a run that has not got it: are its columns far more than its parameters?"
    require(trial.family.id not in named, text)
    require(closed.verdict == "clean", f"The run without {trial.id} is {closed.verdict}, not clean: {closed.summary}")


def check_found(trial: EffectTrial) -> ClosedLoop:
    """The run with it is explained by it alone, with the parameters of the truth."""
    closed = close_loop(trial.run())
    named = [e.effect for e in closed.accepted]
    text = f"The run with {trial.id} is {closed.verdict} by {', '.join(named) or 'nothing'}"
    text += f": is `truth` large beside the noise, and is a grid near its nonlinear parameter? {closed.summary}"
    require((closed.verdict, named) == ("explained", [trial.family.id]), text)
    _check_values(trial, closed.accepted[0])
    return closed


def _check_values(trial: EffectTrial, record: EffectRecord) -> None:
    found = {p.name: p for p in record.parameters}
    text = f"{trial.id} is found with the parameters {', '.join(found)}, not with those of `truth`."
    require(set(found) == set(trial.truth), text)
    for name, true in trial.truth.items():
        p = found[name]
        require(np.isfinite(p.u) and p.u > 0, f"{trial.id}: parameter {name} has no uncertainty.")
        off = abs(p.value - true)
        text = f"{trial.id}: {name} = {p.value:.5g} ± {p.u:.2g} {p.unit} where the truth is {true:.5g}: sign or scale."
        require(off <= WITHIN_u * p.u + SHARE * abs(true), text)


def check_round_trip(trial: EffectTrial, closed: ClosedLoop) -> None:
    """From a calibration file it is the same effect, and `apply` takes it off."""
    run = trial.run()
    made = draft_calibration(run, closed.fit(), SHA256)
    back = parse_calibration(calibration_bytes(made), "the calibration file")
    if trial.family.belongs_to != "sensor":
        text = (
            f"{trial.id} belongs to the {trial.family.belongs_to} and must stand among the findings of a calibration."
        )
        require([e.effect for e in back.findings] == [trial.family.id] and not back.effects, text)
        return
    text = (
        f"{trial.id} is found and not written into the calibration: over the channel's range, settled, it is smaller "
    )
    text += "than its uncertainty. Let the channel move further, or make `truth` larger."
    require(made.effects, text)
    text = f"{trial.id} is another after a calibration file: name its nonlinear parameters in Family(…, shapes=…)."
    one, other = (load(c.effects[0]).predict(trial.scene) for c in (made, back))
    require(np.array_equal(one, other), text)
    shapes = {s.name: s.value for s in load(back.effects[0]).term.shape}
    require(set(shapes) == {s.name for s in trial.term().shape}, text)
    check_applied(trial, run, back)


def check_applied(trial: EffectTrial, run: Run, calibration: Calibration) -> None:
    """It corrects the run that has it, in one piece and in several."""
    channels = {c.name: c.values for c in run.channels}
    readings = Readings(run.reading, run.t_s, run.segment_index, run.mode, channels)
    applied = apply(calibration, readings)
    error = applied.field_nT - trial.made.field_nT
    rms = float(np.sqrt(np.mean(error**2)))
    noise = float(run.dut.noise_nT or 0.0) * float(np.linalg.norm(trial.made.true.K, 2))
    text = f"apply leaves {rms:.1f} nT of the run with {trial.id}, where the noise is {noise:.1f} nT"
    require(rms <= LEFT * noise, f"{text}: what the calibration file states does not give back the effect.")
    pieces = apply_in_pieces(calibration, readings, -(-len(run) // PIECES))
    off = float(np.max(np.abs(np.concatenate([p.field_nT for p in pieces]) - applied.field_nT)))
    text = f"apply of {trial.id} is off by {off:.3g} nT where the recording comes in {PIECES} pieces. With in_pieces "
    text += "its kernel goes on from `scene.past`, as low_passed(…, scene.past, …) does; else leave in_pieces out."
    require(off <= AGREE * max(rms, 1.0), text)
