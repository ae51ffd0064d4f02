"""A smooth function in C: its inputs, its basis, and where it has been seen, one row at a time.

The tables of the basis are double in either variant: what is taken off its columns is nearly what they are.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from labcal.model.effects.c_form import CForm, Input, given, reads
from labcal.model.effects.inputs import CHANNEL, FIELD, RATE, UNITS, WINDOW_S, value
from labcal.model.effects.regressors import AXES
from labcal.model.effects.term import Term
from labcal.model.smooth import ROUNDING, Basis, Domain, Table

FLOAT_ROUNDING = 1e-5  # of a hull's size, for a field in floats
FORMULA = (
    "E_i = sum of s_j,i [nT] times phi_j(x), less its projection on [1, a / {scale:g} nT] on each axis; "
    "phi of B-splines of degree {degree}, x = {names}"
)


def input_in_c(name: str) -> tuple[str, tuple[Input, ...]]:
    """The expression of an input (`labcal.model.effects.inputs`), a double, and what it needs to be given."""
    if name.startswith(CHANNEL):
        channel = given(name.removeprefix(CHANNEL), "")
        return reads(channel), (channel,)
    if name == RATE:
        what = f"how fast the field turns in B, by lines through its direction within {WINDOW_S:g} s either way of t_s"
        rate = Input("field_turns", UNITS[RATE], what, lambda scene: value(RATE, scene))
        return reads(rate), (rate,)
    kind, _, axis = name.partition("_")
    if not axis:
        return "length_of(now->field)", ()
    component = f"(double)now->field[{AXES.index(axis)}]"
    return (component if kind == FIELD else f"{component} / fmax(length_of(now->field), 1e-9)"), ()


def smooth_in_c(term: Term, basis: Basis, scale_nT: float) -> CForm:
    """C for a term of this basis, the field in its projection counted in units of `scale_nT`."""
    found = [input_in_c(name) for name in term.inputs]
    r, sizes = len(basis.functions[0]), [len(knots) - 1 for knots in basis.knots]
    lines = [f"static const double FUNCTIONS[{len(basis.functions)}][{r}] = {_table(basis.functions)};"]
    lines += [f"static const double TAKEN[12][{3 * r}] = {_table(basis.projection)};"]
    onto = [f"(double)now->field[{i}] / {scale_nT!r}" for i in range(3)]
    lines += [f"const double onto[4] = {{1.0, {', '.join(onto)}}};"]
    for place, (knots, size, (x, _)) in enumerate(zip(basis.knots, sizes, found, strict=True)):
        lines += [f"static const double KNOTS_{place}[{size + 1}] = {_row(knots)};", f"double b_{place}[{size}];"]
        lines += [f"b_splines(KNOTS_{place}, {size + 1}, {basis.degree}, {x}, b_{place});"]
    splines = [size - basis.degree for size in sizes]
    lines += [f"for (int j = 0; j < {r}; ++j) {{", "    double phi = 0.0;", *_summed(splines)]
    lines += ["    for (int i = 0; i < 3; ++i)", "        for (int k = 0; k < 3; ++k) {"]
    lines += ["            double less = i == k ? phi : 0.0;", "            for (int m = 0; m < 4; ++m)"]
    lines += ["                less -= onto[m] * TAKEN[3 * m + k][3 * j + i];"]
    lines += ["            e[3 * j + i][k] = (labcal_real)less;", "        }", "}"]
    formula = FORMULA.format(scale=scale_nT, degree=basis.degree, names=", ".join(term.inputs))
    inputs = tuple(dict.fromkeys(one for _, needed in found for one in needed))
    return CForm(formula, "\n".join(lines), inputs, helpers=("b_splines", *_lengths(x for x, _ in found)))


def seen_in_c(domains: Sequence[Domain]) -> tuple[str, tuple[str, ...]]:
    """Statements that return 1 for a row within all of the domains and 0 outside, and the helpers that they call."""
    edge = f"const double edge = sizeof(labcal_real) < sizeof(double) ? {FLOAT_ROUNDING!r} : {ROUNDING!r};"
    lines, helpers = [edge, "(void)now;"], dict[str, None]()
    for place, domain in enumerate(domains):
        values = [input_in_c(name)[0] for name in domain.inputs]
        helpers |= dict.fromkeys(_lengths(values))
        lines += _between(values[0], domain) if len(values) == 1 else _within(place, values, domain)
        helpers |= {} if len(values) == 1 else {"within": None}
    return "\n".join([*lines, "return 1;"]), tuple(helpers)


def _between(x: str, domain: Domain) -> list[str]:
    ends = [corner[0] for corner in domain.hull]
    low, high = min(ends), max(ends)
    margin = f"edge * {high - low!r}"
    return [f"if ({x} < {low!r} - {margin} || {x} > {high!r} + {margin})", "    return 0;"]


def _within(place: int, values: Sequence[str], domain: Domain) -> list[str]:
    hull = f"static const double HULL_{place}[{len(domain.hull)}][2] = {_table(domain.hull)};"
    call = f"within(HULL_{place}, {len(domain.hull)}, {', '.join(values)}, edge)"
    return [hull, f"if (!{call})", "    return 0;"]


def _summed(splines: Sequence[int]) -> list[str]:
    """The statements that add the weighted splines to phi."""
    if len(splines) == 1:
        return [f"    for (int s = 0; s < {splines[0]}; ++s)", "        phi += b_0[s] * FUNCTIONS[s][j];"]
    return [
        f"    for (int s = 0; s < {splines[0]}; ++s)",
        f"        for (int t = 0; t < {splines[1]}; ++t)",
        f"            phi += b_0[s] * b_1[t] * FUNCTIONS[{splines[1]} * s + t][j];",
    ]


def _lengths(expressions: Iterable[str]) -> tuple[str, ...]:
    return ("length_of",) if any("length_of" in x for x in expressions) else ()


def _table(rows: Table) -> str:
    return "{" + ",\n    ".join(map(_row, rows)) + "}"


def _row(values: Sequence[float]) -> str:
    return "{" + ", ".join(repr(float(v)) for v in values) + "}"
