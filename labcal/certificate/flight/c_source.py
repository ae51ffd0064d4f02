"""`labcal_calibration.h` and `.c`: the map and the effects that fly, in C99 without allocation, and u beside the field.

Each effect's own text is its family's (`Family.in_c`); here it gets its numbers, its state and its place. Where a
parameter that does not enter linearly is uncertain, the effect is worked out a second time a step further, as `apply`
does.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.flight.c_helpers import HELPERS, STATES
from labcal.certificate.flight.c_templates import HEADER, SETTLED, SOURCE, filled
from labcal.certificate.flight.content import Content, Flown, stamps
from labcal.certificate.flight.vectors import Vectors, seen
from labcal.errors import InputError
from labcal.model.apply import ends_of_channels, left_out_variance, reading_noise, temperature_channel
from labcal.model.effects.c_form import CForm, Input, enumerator, given, mode_enumerator, real
from labcal.model.effects.c_smooth import seen_in_c
from labcal.model.effects.shape import DELAY, LESS_ITSELF
from labcal.model.pieces import ROUNDS, SETTLED_nT
from labcal.model.plausibility import stated_limits

Array = NDArray[np.float64]
EPSILON = 2.0**-24  # of a float
OF_THE_MAP, OF_AN_EFFECT = 16, 64  # roundings that the error of the float variant is stated for
SPARE = 4  # times the history that the rows need
SEARCHED_BY_RULE = ("changepoints", "own secant")


@dataclass(frozen=True, slots=True)
class Instance:
    """One effect with its C form, the steps of its uncertain shapes, its size and spread over the rows."""

    flown: Flown
    form: CForm
    steps: tuple[tuple[int, float], ...]  # place among the shapes, step
    size: float  # variance of one component that a row without it has more
    spread: float  # the same of a row whose channel is not known so much earlier

    @property
    def number(self) -> int:
        """Its place in the calibration's effects."""
        return self.flown.place


@dataclass(frozen=True, slots=True, eq=False)
class Program:
    """All that the C files are written from."""

    content: Content
    vectors: Vectors
    instances: tuple[Instance, ...]
    inputs: tuple[Input, ...]
    modes: dict[str, int]  # enumerators

    @property
    def temperature(self) -> Input | None:
        """The input that the calibration's temperature range speaks of."""
        calibration = self.content.calibration
        names = {one.channel: one for one in self.inputs if one.channel}
        found = temperature_channel(calibration, dict.fromkeys(names, np.zeros(0)))
        return None if found is None or calibration.validity.temperature_C is None else names[found]

    @property
    def history(self) -> int:
        """Rows that delays reach back over, with spare ones for a faster clock."""
        delays = [one.flown.effect.term.of(DELAY) for one in self.instances]
        reach = max([self.content.lag_s, *(d.value for d in delays if d is not None)])
        t_s = self.vectors.rows.t_s
        assert t_s is not None
        rows = int((np.arange(len(t_s)) - np.searchsorted(t_s, t_s - reach)).max()) if reach > 0 else 0
        return SPARE * (rows + 2) if reach > 0 else 1

    @property
    def float_error_nT(self) -> float:
        """What a component is off by at most where numbers are floats, over rows like those of the vectors."""
        affine, reading = self.content.calibration.affine, self.vectors.rows.reading
        largest = np.max(np.abs(reading) @ np.abs(affine.K).T + np.abs(affine.k_nT), axis=0)
        effects = sum(_largest(one, self.content, self.vectors) for one in self.instances)
        return float(EPSILON * (OF_THE_MAP * np.max(largest) + OF_AN_EFFECT * effects))


def program_of(content: Content, vectors: Vectors) -> Program:
    """Raises InputError naming an effect that has no form in C."""
    sizes = seen(content, vectors)
    instances = []
    for one, over in zip(content.effects, sizes, strict=True):
        if one.effect.family.in_c is None:
            words = "its package states none (Family.in_c); --format json and mat take it"
            raise InputError(f"{one.said} has no form in C: {words}")
        size = float(np.mean(left_out_variance(content.calibration, one.record, one.effect, over)))
        form = one.effect.family.in_c(one.effect.term)
        if not isinstance(form, CForm):
            raise InputError(f"{one.said}: what its package states as in_c gives no CForm")
        instances.append(Instance(one, form, _steps(one, vectors), size, float(np.mean(over.variance))))
    plain = [given(name, "") for one in content.effects for name in one.record.channels]
    inputs = {one.name: one for instance in instances for one in instance.form.inputs}
    inputs |= {one.name: one for one in plain if _is_temperature(content, one) and one.name not in inputs}
    return Program(content, vectors, tuple(instances), tuple(inputs.values()), _modes(content))


def header(program: Program) -> str:
    """`labcal_calibration.h`."""
    inputs = [f"    {enumerator(one)}, /* {_in(one.unit)}{_ascii(one.what)} */" for one in program.inputs]
    modes = [f"    {name} = {number}," for name, number in program.modes.items()]
    values = {
        "ABOUT": _about(program),
        "SHA256": program.content.sha256,
        "FLOAT_ERROR": f"{program.float_error_nT:.3g}",
        "INPUTS": "\n".join([*inputs, "    LABCAL_INPUTS"]),
        "PLACES": str(max(len(program.inputs), 1)),
        "MODES": "\n".join(modes),
        "HISTORY": str(program.history),
        "STATES": STATES.rstrip(),
        "EFFECTS": "\n".join(_state_types(program)),
        "MEMBERS": "\n".join(_state_members(program)),
    }
    return filled(HEADER, values)


def source(program: Program) -> str:
    """`labcal_calibration.c`."""
    content, calibration = program.content, program.content.calibration
    needed = {name for one in program.instances for name in one.form.helpers}
    needed |= {n for one in program.instances if one.flown.record.basis for n in seen_in_c(one.flown.record.domain)[1]}
    needed |= {"earlier"} if _keeps_channels(program) else set()
    needed |= {"sum", "keep"} if program.instances else set()
    needed |= {"further"} if any(one.steps for one in program.instances) else set()
    values = {
        "K": _matrix("K", calibration.affine.K),
        "OFFSET": _row("OFFSET", calibration.affine.k_nT),
        "AXES": _matrix("AXES", content.axes) if "along_axis" in needed else "",
        "ALONG": _matrix("ALONG", np.asarray(np.linalg.inv(content.axes), dtype=np.float64)),
        "FACTOR": _matrix("FACTOR", _factor(content.covariance)),
        "CONSTANT": real(float(np.mean(content.constant_nT2))),
        "HELPERS": "\n".join(text for name, text in HELPERS.items() if name in needed),
        "EFFECTS": "\n".join(_functions(program)),
        "LAG": repr(float(content.lag_s)),
        "TAKE": "\n".join(_stamped(program)),
        "BLOCKS": "\n".join(_blocks(program)),
        "RANGE": "\n".join(_ranges(program)),
    }
    return filled(SOURCE, values)


def _largest(one: Instance, content: Content, vectors: Vectors) -> float:
    """The largest sum of an effect's parts, each for itself: they may cancel, their roundings do not [nT]."""
    if stamps(one.flown.effect):
        return 0.0
    from labcal.certificate.flight.vectors import scene

    columns = one.flown.effect.term.columns(scene(content, vectors.stamped))
    return float(np.max(np.abs(columns) @ np.abs(one.flown.effect.beta)))


def _steps(one: Flown, vectors: Vectors) -> tuple[tuple[int, float], ...]:
    u = {p.name: p.u for p in one.record.parameters}
    t_s = vectors.stamped.t_s
    assert t_s is not None
    shapes = [(i, s) for i, s in enumerate(one.effect.term.shape) if s.kind.found_by not in SEARCHED_BY_RULE]
    steps = [(i, s.step(t_s)) for i, s in shapes if u[s.name] > 0]
    return tuple((i, float(step)) for i, step in steps if np.isfinite(step) and step > 0)


def _is_temperature(content: Content, one: Input) -> bool:
    names = dict.fromkeys((n for e in content.effects for n in e.record.channels), np.zeros(0))
    return one.channel is not None and one.channel == temperature_channel(content.calibration, names)


def _modes(content: Content) -> dict[str, int]:
    known = dict.fromkeys(content.calibration.validity.modes)
    for one in content.effects:
        if one.effect.family.modes is not None:
            known |= dict.fromkeys(one.effect.family.modes(one.effect.term))
    named = [name for name in map(mode_enumerator, known) if name != mode_enumerator("")]
    return {"LABCAL_OTHER_MODE": -1, mode_enumerator(""): 0} | {name: i for i, name in enumerate(named, start=1)}


def _factor(covariance: Array) -> Array:
    """F (p, r) with covariance = F F^T, from which a sum of squares is never negative (eigenvectors of it scaled)."""
    u = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    unit = np.where(u > 0, u, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(unit, unit))
    kept = values > 1e-13 * max(float(values.max(initial=0.0)), 1e-300)
    factor = u[:, None] * vectors[:, kept] * np.sqrt(values[kept])
    return factor if factor.shape[1] else np.zeros((len(u), 1))


def _keeps_channels(program: Program) -> bool:
    return program.content.lag_s > 0 and any(one.channel for one in program.inputs)


def _about(program: Program) -> str:
    content, calibration = program.content, program.content.calibration
    low, high = calibration.validity.field_nT
    said = [
        f"Calibration of {calibration.dut.serial} {calibration.dut.model}".rstrip() + f", run {calibration.run_id}",
        "SIMULATED: it describes no real sensor" if calibration.simulated else "",
        content.status,
        "",
        f"b = K m - k - sum of effects [nT, body axes], m the reading [{calibration.dut.unit}], x y z.",
        f"It holds from {low:.6g} to {high:.6g} nT"
        + (f", until {calibration.validity.until}" if calibration.validity.until else "")
        + "; outside flags are set, and u grows.",
        f"u: standard uncertainty (k = 1) of one component [nT], noise included. Not covered: "
        f"{'; '.join(calibration.not_covered) or 'nothing is stated'}",
        f"k belongs to: {calibration.k_means().removeprefix('at ') or 'any value of any channel'}",
        f"A reading stamped t is of the field at t - ({content.lag_s:.9g} s): found.t_s says which time."
        if content.lag_s
        else "",
        "",
    ]
    for one in program.instances:
        said += [f"{one.flown.said}: {one.form.formula}", f"    {_stated(one.flown)}"]
    for record, rms in zip(content.left_out, content.left_out_nT, strict=True):
        u = float(np.sqrt(np.mean(rms**2)))
        said.append(f"LEFT OUT, for it is bound to the run's own time: {record.effect}; u has {u:.3g} nT more for it")
    lines = [line for text in said for line in (textwrap.wrap(_ascii(text), 112) or [""])]
    return "\n".join(f" * {line}".rstrip() for line in lines)


def _stated(one: Flown) -> str:
    numbers = (f"{p.name} = {p.value:.6g} +- {p.u:.2g} {p.unit}".rstrip() for p in one.record.parameters)
    starts = (f"{name} from {value:.6g}" for name, value in one.record.reference_value.items())
    return "; ".join([*numbers, *starts])


def _ascii(text: str) -> str:
    """Words of a file in a comment of C: nothing ends it, nothing goes on in the next line."""
    plain = text.replace("−", "-").replace("µ", "u").replace("°", "deg ").encode("ascii", "replace").decode()
    plain = "".join(c if c.isprintable() else "?" for c in plain)
    return plain.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?").replace("\\", "/")


def _in(unit: str) -> str:
    return f"[{_ascii(unit)}] " if unit.strip("/s") else ""


def _state_types(program: Program) -> Iterator[str]:
    for one in program.instances:
        if one.form.state:
            yield f"typedef struct {{ {one.form.state} }} labcal_effect_{one.number};"


def _state_members(program: Program) -> Iterator[str]:
    if _keeps_channels(program):
        yield f"    labcal_history channel[{len(program.inputs)}];"
    for one in program.instances:
        if one.form.state:
            yield f"    labcal_effect_{one.number} effect_{one.number}[{1 + len(one.steps)}];"


def _functions(program: Program) -> Iterator[str]:
    """Each effect's own function, and its numbers."""
    for one in program.instances:
        n, term = one.number, one.flown.effect.term
        yield f"/* {_ascii(one.flown.said)}: {_ascii(one.form.formula)} */"
        if term.shape:
            base = np.array([shape.value for shape in term.shape])
            rows = [base, *(base + step * (np.arange(len(base)) == i) for i, step in one.steps)]
            yield _doubles(f"SHAPE_{n}", rows)
        beta = np.zeros(len(one.flown.effect.beta)) if one.form.stamps else one.flown.effect.beta
        yield _row(f"BETA_{n}", beta).rstrip()
        yield f"static const int PLACE_{n}[{len(beta)}] = {{{', '.join(map(str, _places(one)))}}};"
        yield f"static void effect_{n}({', '.join(_parameters(one))})\n{{"
        yield "    (void)now;\n" + ("    (void)shape;\n" if term.shape else "") + textwrap.indent(one.form.body, "    ")
        yield "}\n"
        if one.flown.effect.term.of(LESS_ITSELF) is not None:
            yield _settled(n, len(one.flown.effect.beta))
        if one.flown.record.basis is not None:
            inside = textwrap.indent(seen_in_c(one.flown.record.domain)[0], "    ")
            yield f"static int seen_{n}(const labcal_now *now)\n{{\n{inside}\n}}\n"


def _settled(number: int, parameters: int) -> str:
    """The function that works an effect out in the field without it, from the same state until that changes nothing."""
    values = {"N": str(number), "P": str(parameters), "ROUNDS": str(ROUNDS), "SETTLED": repr(SETTLED_nT)}
    return filled(SETTLED, values)


def _parameters(one: Instance) -> list[str]:
    shape = ["const double shape[]"] if one.flown.effect.term.shape else []
    state = [f"labcal_effect_{one.number} *state"] if one.form.state else []
    return [*shape, *state, "labcal_now *now", "labcal_real e[][3]"]


def _places(one: Instance) -> list[int]:
    """Where the linear parameters stand among all."""
    names = [p.name for p in one.flown.record.parameters]
    return [one.flown.first + names.index(name) for name, _ in one.flown.effect.term.parameters]


def _stamped(program: Program) -> Iterator[str]:
    """The inputs at the time that the field belongs to."""
    for place, one in enumerate(program.inputs):
        value = f"row->input[{enumerator(one)}]"
        if one.channel and _keeps_channels(program):
            value = f"isfinite({value}) ? earlier(&state->channel[{place}], &now, {value}, LAG_S) : {value}"
        yield f"    now.input[{enumerator(one)}] = {value};"


def _blocks(program: Program) -> Iterator[str]:
    """Each effect taken off the field, with its columns."""
    for one in program.instances:
        n, p = one.number, len(one.flown.effect.beta)
        names = [q.name for q in one.flown.record.parameters]
        how = "settled" if one.flown.effect.term.of(LESS_ITSELF) is not None else "effect"
        calls = [f"{how}_{n}({', '.join(_arguments(one, i))});" for i in range(1 + len(one.steps))]
        known, seen_there = _known(program, one), f"seen_{n}(&now)" if one.flown.record.basis is not None else ""
        lines = [f"if ({known}{f' && {seen_there}' if seen_there else ''}) {{"]
        lines += [f"    labcal_real e[{p}][3], value[3];", "    now.late = 0;"]
        lines += ["    memset(e, 0, sizeof e);", f"    {calls[0]}", f"    sum(e, BETA_{n}, {p}, value);"]
        lines += [f"    keep(e, PLACE_{n}, {p}, slopes);", "    for (int j = 0; j < 3; ++j)"]
        lines += ["        found->b_nT[j] -= value[j];"]
        if "earlier" in one.form.helpers:
            lines += [
                "    if (now.late) {",
                "        flags |= LABCAL_LATE;",
                f"        variance += {real(one.spread)};",
                "    }",
            ]
        for (place, step), call in zip(one.steps, calls[1:], strict=True):
            at = one.flown.first + names.index(one.flown.effect.term.shape[place].name)
            lines += [
                "    memset(e, 0, sizeof e);",
                f"    {call}",
                f"    further(e, BETA_{n}, {p}, value, {real(step)}, slopes[{at}]);",
            ]
        why = f"{known} ? LABCAL_DOMAIN : LABCAL_LEFT_OUT" if seen_there else "LABCAL_LEFT_OUT"
        lines += ["} else {", f"    flags |= {why};", f"    variance += {real(one.size)};", "}"]
        yield textwrap.indent("\n".join([f"/* {_ascii(one.flown.said)} */", *lines]), "    ")


def _arguments(one: Instance, variant: int) -> list[str]:
    shape = [f"SHAPE_{one.number}[{variant}]"] if one.flown.effect.term.shape else []
    state = [f"&state->effect_{one.number}[{variant}]"] if one.form.state else []
    return [*shape, *state, "&now", "e"]


def _known(program: Program, one: Instance) -> str:
    """The condition on which a row has what the effect needs."""
    needed = [f"isfinite(now.input[{enumerator(i)}])" for i in one.form.inputs if not i.where_it_begins]
    own = one.flown.effect.family.modes
    if own is not None:
        mine = own(one.flown.effect.term)
        base = [mode for mode in program.content.calibration.validity.modes if mode not in mine]
        needed.append(f"({' || '.join(f'now.mode == {mode_enumerator(m)}' for m in [*mine, *(base or [''])])})")
    return " && ".join(needed) or "1"


def _ranges(program: Program) -> Iterator[str]:
    """What is beyond the validity, and how much u grows by it, as `apply` says."""
    calibration = program.content.calibration
    low, high = calibration.validity.field_nT
    noise = 3 * reading_noise(calibration)
    yield f"    growth += excess(length, {low!r}, {high!r}, {noise!r}, LABCAL_FIELD_RANGE, &flags);"
    if (one := program.temperature) is not None and calibration.validity.temperature_C is not None:
        cold, hot = calibration.validity.temperature_C
        said = f"now.input[{enumerator(one)}], {cold!r}, {hot!r}, 0.0, LABCAL_TEMPERATURE_RANGE"
        yield f"    growth += excess({said}, &flags);"
    inputs = {one.channel: one for one in program.inputs if one.channel}
    for channel, (least, most) in ends_of_channels(calibration).items():
        if channel in inputs:
            value = f"now.input[{enumerator(inputs[channel])}]"
            said = f"{value}, {least!r}, {most!r}, 0.0, LABCAL_DOMAIN"
            yield f"    growth += isfinite({value}) ? excess({said}, &flags) : 0.0;"
    if calibration.validity.modes:
        valid = [mode_enumerator(m) for m in ("", *calibration.validity.modes)]
        yield f"    if ({' && '.join(f'now.mode != {name}' for name in dict.fromkeys(valid))}) {{"
        yield "        flags |= LABCAL_MODE;\n        growth += 1.0;\n    }"
    floor = max(reading_noise(calibration), 1.0)
    for axis, sign, limit in stated_limits(calibration):
        yield f"    saturated |= row->reading[{axis}] {sign} {real(limit)};"
    yield "    if (saturated) {\n        flags |= LABCAL_SATURATED;"
    yield f"        growth += 0.1 * length / {floor!r};\n    }}"


def _matrix(name: str, values: Array) -> str:
    rows = ",\n".join(f"    {{{', '.join(map(real, row))}}}" for row in values)
    return f"static const labcal_real {name}[{values.shape[0]}][{values.shape[1]}] = {{\n{rows}}};\n"


def _doubles(name: str, rows: Sequence[Array]) -> str:
    written = ", ".join(f"{{{', '.join(repr(float(v)) for v in row)}}}" for row in rows)
    return f"static const double {name}[{len(rows)}][{len(rows[0])}] = {{{written}}};"


def _row(name: str, values: Sequence[float] | Array) -> str:
    return f"static const labcal_real {name}[{len(values)}] = {{{', '.join(map(real, values))}}};\n"
