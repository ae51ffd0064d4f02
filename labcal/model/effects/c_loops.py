"""Loops in C: what `labcal.model.effects.hysteresis` does to all rows, one row at a time.

A stop is kept as its play (the field less the stop), so that nothing adds up from row to row. `begins` says what a
loop does at its beginning: 0 at rest in the field that it is in, in each segment; 1 demagnetised before each segment;
2 before the first alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from labcal.model.effects.c_form import CForm

LOOP = "E = c z(s) along each of the sensor's axes"
BEGINS = {
    "0": "each segment begins at rest in its field",
    "1": "demagnetised before each segment",
    "2": "demagnetised before the first row",
}


def dahl(s: str, width: str) -> CForm:
    """Dahl's loop of a width, along each of the sensor's axes."""
    lines = [
        f"along_axis(e[{i}], {i}, (labcal_real)dahl(&state->loop[{i}], now, {s}[{i}], {width}));" for i in range(3)
    ]
    formula = f"{LOOP}, c [nT]; Dahl's loop dz = (sign(ds) - z) |ds| / w_nT, s [nT]; {BEGINS['0']}"
    return CForm(formula, "\n".join(lines), state="labcal_dahl loop[3];", helpers=("along_axis", "dahl"))


def stops(s: str, thresholds: Sequence[str], begins: str) -> CForm:
    """Stops of one threshold or several, along each of the sensor's axes."""
    lines = [
        f"along_axis(e[{3 * k + i}], {i}, stop(&state->stop[{3 * k + i}], now, {s}[{i}], {r}, {begins}));"
        for k, r in enumerate(thresholds)
        for i in range(3)
    ]
    formula = f"{LOOP}, c [1]; z [nT] the field s since it turned, within +-r of each threshold [nT]; {BEGINS[begins]}"
    return CForm(formula, "\n".join(lines), state=_stops(3 * len(thresholds)), helpers=("along_axis", "stop"))


def bar(lon: str, lat: str, thresholds: Sequence[str], begins: str) -> CForm:
    """A soft bar: stops of the field along one direction of the body, each with a field of its own."""
    lines = [
        f"const double lon = {lon} * 0.017453292519943295, lat = {lat} * 0.017453292519943295;",
        "const double x = cos(lat) * cos(lon), y = cos(lat) * sin(lon), z = sin(lat);",
        "const labcal_real s = (labcal_real)(x * (double)now->field[0] + y * (double)now->field[1]"
        " + z * (double)now->field[2]);",
    ]
    lines += [
        f"on_each_axis(e + {3 * k}, stop(&state->stop[{k}], now, s, {r}, {begins}));" for k, r in enumerate(thresholds)
    ]
    formula = (
        "E = c z(s), c [1] for each axis of B; s [nT] the field along lon_deg (x to y), lat_deg (to z); "
        f"z [nT] the field since it turned, within +-r of each threshold [nT]; {BEGINS[begins]}"
    )
    return CForm(formula, "\n".join(lines), state=_stops(len(thresholds)), helpers=("on_each_axis", "stop"))


def saturating(s: str, threshold: str, level: str, powers: Sequence[int]) -> CForm:
    """A bounded function of the play, about a curve of its own: a tanh, and powers."""
    lines = []
    for i in range(3):
        own, u = f"{s}[{i}]", f"{s}[{i}] / {level}"
        loop = f"saturating({own}, stop(&state->stop[{i}], now, {own}, {threshold}, 0), {level})"
        curve = [f"bend({u})", *(" * ".join([own] * k) for k in powers)]
        lines += [f"along_axis(e[{3 * k + i}], {i}, {value});" for k, value in enumerate([loop, *curve])]
    formula = (
        "E = c (tanh(p/s_nT) - tanh(s/s_nT)) + t1 (tanh u - u) + sum a_k s^k along each of the sensor's axes; s [nT], "
        f"u = s/s_nT, p = s less its stop within +-r_nT; c, t1 [nT]; {BEGINS['0']}"
    )
    helpers = ("along_axis", "stop", "bend", "saturating")
    return CForm(formula, "\n".join(lines), state=_stops(3), helpers=helpers)


def relays(s: str, width: str, level: str, spread: str, points: Iterable[float], weights: Iterable[float]) -> CForm:
    """Relays of all widths, a bounded function of the play of each, about the relays' own curve."""
    lines, each = list[str](), [(float(x), float(w)) for x, w in zip(points, weights, strict=True)]
    widths = ", ".join(f"(labcal_real)((double){width} * exp((double){spread} * {x!r}))" for x, _ in each)
    lines.append(f"const labcal_real width[{len(each)}] = {{{widths}}};")
    lines.append(f"static const double share[{len(each)}] = {{{', '.join(repr(w) for _, w in each)}}};")
    for i in range(3):
        own = f"{s}[{i}]"
        lines.append(
            f"along_axis(e[{i}], {i}, relays(state->stop + {len(each) * i}, now, {own}, {level}, width, share,"
            f" {len(each)}));"
        )
        lines.append(f"along_axis(e[{3 + i}], {i}, bend({own} / {level}));")
    formula = (
        "E = c (R - tanh u) + t1 (tanh u - u) along each of the sensor's axes; s [nT], u = s/middles_nT, R the mean of "
        "tanh(p/middles_nT) over widths whose logarithm is normal about ln r_nT with deviation sd_ln, p = s less its "
        f"stop within +-width; c, t1 [nT]; {BEGINS['0']}"
    )
    helpers = ("along_axis", "stop", "bend", "saturating", "relays")
    return CForm(formula, "\n".join(lines), state=_stops(3 * len(each)), helpers=helpers)


def core(s: str, bend: str, pin: str, part: str) -> CForm:
    """A core's magnetisation, less its curve, and the curve's bend."""
    lines = []
    for i in range(3):
        own = f"{s}[{i}]"
        lines.append(f"along_axis(e[{i}], {i}, magnetised(&state->core[{i}], now, {own}, {bend}, {pin}, {part}));")
        lines.append(f"along_axis(e[{3 + i}], {i}, (labcal_real)bent((double){own} / (double){bend}));")
    formula = (
        "E = c (M - L(s/a_nT)) + t1 (L(u) - u/3) along each of the sensor's axes, L(u) = coth u - 1/u, u = s/a_nT; "
        "dM/ds = (L(s/a_nT) - M)/pinning_nT, s rising, or its negative, s falling, where that moves M to L, else 0; "
        "s [nT]; c, t1 [nT]; each segment begins at M = begins_on L"
    )
    helpers = ("along_axis", "langevin", "bent", "magnetised")
    return CForm(formula, "\n".join(lines), state="labcal_core core[3];", helpers=helpers)


def _stops(count: int) -> str:
    return f"labcal_stop stop[{count}];"
