"""A package with one effect, begun from an empirical term: its columns are filled in, the physics is left open."""

from __future__ import annotations

import json
import keyword
import re
from collections.abc import Mapping
from pathlib import Path
from string import Template
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.outputs import claim
from labcal.files.plain_file import read_limited
from labcal.loop.empirical.description import PHYSICS, shape_of
from labcal.model.effects import find
from labcal.model.effects.inputs import CHANNEL
from labcal.model.smooth import Basis, Domain

COMMAND = "effect new"
NAME = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*\Z")
LARGEST_BYTES = 64 * 2**20
COLUMNS = {  # of a shape: the functions of u, each with three parameters of its own
    "straight": "u", "quadratic": "u | u**2", "saturating": "np.tanh(u)", "resonant": "1 / (1 + u**2)",
    "a step": "np.tanh(u)", "wavy": "np.sin(u) | np.cos(u)", "a bent curve": "u**2 | u**3",
    "a product": "u * v", "a map": "u * v",
}  # fmt: skip
LINEAR = ("straight", "quadratic", "a bent curve", "a product", "a map")  # no width is searched


def new_effect(result: Path, name: str, folder: Path, *, force: bool = False) -> list[Path]:
    """Write the package `name` into `folder` from the empirical term of a result. Raises InputError."""
    _check_name(name)
    basis, domain, inputs = _term_of(result)
    texts = _texts(name, basis, domain, inputs)
    outputs = claim(COMMAND, *(folder / file for file in texts), inputs=(result,), force=force, with_folder=True)
    for output, text in zip(outputs, texts.values(), strict=True):
        output.path.parent.mkdir(parents=True, exist_ok=True)
        with output.writing() as path:
            write_text(path, text)
    return [output.path for output in outputs]


def _check_name(name: str) -> None:
    if not NAME.match(name) or keyword.iskeyword(name):
        raise InputError(f"{name!r} is no name for an effect: small letters, digits and single hyphens, as pump-field")
    if find(name) is not None:
        raise InputError(f"an effect {name} is installed already; choose another name")


def _term_of(result: Path) -> tuple[Basis, Domain, tuple[str, ...]]:
    """The empirical term that a result has accepted or proposes. Raises InputError where there is none."""
    try:
        stated = json.loads(read_limited(result, LARGEST_BYTES))
        terms = [e for e in (*stated["accepted"], *stated.get("proposed", ())) if e.get("basis")]
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError("is no result of close-loop --json", file=result) from error
    if not terms:
        raise InputError("holds no empirical term: close-loop found none, or none was needed", file=result)
    return _whole(terms[0], result)


def _whole(term: Mapping[str, Any], result: Path) -> tuple[Basis, Domain, tuple[str, ...]]:
    try:
        tables = {n: tuple(tuple(map(float, row)) for row in v) for n, v in term["basis"].items() if type(v) is list}
        basis = Basis(**{**term["basis"], **tables})
        [domain] = (Domain(tuple(d["inputs"]), tuple(tuple(map(float, p)) for p in d["hull"])) for d in term["domain"])
        inputs = tuple(map(str, term["inputs"]))
        shape_of(basis, np.array(domain.hull), inputs)
    except (KeyError, TypeError, ValueError, IndexError, AttributeError) as error:
        raise InputError("states an empirical term that is not whole", file=result) from error
    return basis, domain, inputs


def _texts(name: str, basis: Basis, domain: Domain, inputs: tuple[str, ...]) -> dict[str, str]:
    """Every file of the package, by its place."""
    looks = shape_of(basis, np.array(domain.hull), inputs)
    hull = np.array(domain.hull)
    low, high = hull.min(axis=0), hull.max(axis=0)
    zero = [float(f"{v:.4g}") for v in (low + high) / 2]
    if looks.at is not None:
        zero[0] = float(f"{looks.at:.4g}")
    spread = [float(f"{v:.3g}") for v in (high - low) / (8 if looks.kind not in LINEAR else 2)]
    channels = [i.removeprefix(CHANNEL) for i in inputs if i.startswith(CHANNEL)]
    functions = COLUMNS[looks.kind].split(" | ")
    said = {
        "name": name,
        "package": name.replace("-", "_"),
        "says": looks.says(inputs),
        "physics": PHYSICS[looks.kind],
        "inputs": repr(inputs),
        "zero": repr(tuple(zero)),
        "spread": repr(tuple(spread)),
        "channels": repr(tuple(channels)),
        "names": repr(tuple("cdefgh"[: len(functions)])),
        "columns": ", ".join(functions),
        "second": "\n    v = drive(scene, 1, SPREAD[1])" if len(inputs) > 1 else "",
        "width": "SPREAD[0]" if looks.kind in LINEAR else "term.at(WIDTH.name)",
        "shapes": "()" if looks.kind in LINEAR else "(WIDTH,)",
        "low": repr(float(f"{low[0]:.4g}")),
        "high": repr(float(f"{high[0]:.4g}")),
    }
    return {
        file: Template(text).substitute(said)
        for file, text in (
            ("pyproject.toml", PYPROJECT),
            ("README.md", README),
            (f"{said['package']}/__init__.py", '"""$says"""\n'),
            (f"{said['package']}/effect.py", EFFECT),
            ("tests/test_effect.py", TEST),
        )
    }


PYPROJECT = """[build-system]
requires = ["hatchling>=1.25"]
build-backend = "hatchling.build"

[project]
name = "$name"
version = "0.1"
description = "An effect for labcal"
requires-python = ">=3.11"
dependencies = ["labcal"]

[project.entry-points."labcal.effects"]
$name = "$package.effect:FAMILY"

[tool.hatch.build.targets.wheel]
packages = ["$package"]
"""
README = """# $name

Begun from an empirical term. $says

1. `pip install -e .` beside labcal; from then on `labcal close-loop` tries the effect.
2. Put the physics into `$package/effect.py`: the formula, the parameters' names and units, where a channel is zero.
3. `pytest` holds the columns to the formula in `tests/test_effect.py`, which is written apart from them, and the effect
   to what `labcal.testing.check_effect` asks of any.
"""
EFFECT = '''"""$says

Begun from an empirical term, which said only what it looks like. What is it? ($physics)
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.model.effects import Family, Scene, Shape, Term
from labcal.model.effects.inputs import value
from labcal.model.effects.protocol import Array
from labcal.model.effects.regressors import on_each_axis, per_axis
from labcal.record import Run

INPUTS = $inputs
CHANNELS = $channels
ZERO = $zero  # where each input counts as none
SPREAD = $spread  # of each input, in its own unit
WIDTH = Shape("width", SPREAD[0], "1", tuple(float(SPREAD[0] * f) for f in np.geomspace(0.25, 4.0, 9)))


def drive(scene: Scene, place: int, width: float) -> Array:
    """An input (n,), counted from its zero in widths."""
    return np.asarray((value(INPUTS[place], scene) - ZERO[place]) / width)


def kernel(term: Term, scene: Scene) -> Array:
    """The derivative of the effect by each parameter (n, 3, p) [nT per nT]: replace the functions by the physics."""
    u = drive(scene, 0, $width)$second
    return np.concatenate([on_each_axis(column) for column in ($columns,)], axis=2)


def candidates(run: Run) -> Sequence[Term]:
    """One form, where the run has what it needs."""
    if set(CHANNELS) - {channel.name for channel in run.channels}:
        return []
    parameters = tuple(p for name in $names for p in per_axis(name, "nT"))
    zero = {name.removeprefix("channel:"): at for name, at in zip(INPUTS, ZERO) if name.startswith("channel:")}
    return [Term(kernel, parameters, CHANNELS, zero, $shapes)]


FAMILY = Family(
    "$name",
    "sensor",
    kernel,
    candidates,
    shapes=$shapes,
    phrase="$name",  # what happens, for a technician: "the gain changes with temperature"
    experiment="hold all else and move it up and down through its range, twice",
)
'''
TEST = '''"""The columns against the same formula, written apart from them; then all that any effect is held to."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from $package.effect import CHANNELS, SPREAD, ZERO, WIDTH, FAMILY

from labcal.model.effects import Scene
from labcal.record import Channel
from labcal.testing import check_effect

SIZES = {f"{name}_{axis}": size for name, whole in zip("cdefgh", (1.0, 0.7)) for axis, size in
         zip("xyz", (whole * 300.0, whole * -200.0, whole * 100.0)) if name in $names}  # fmt: skip


def recorded(t_s: np.ndarray) -> list[Channel]:
    """The channels it follows, moved through what the term has seen."""
    moved = [np.sin(t_s / (11.0 + 7.3 * i)) for i in range(len(CHANNELS))]
    return [
        Channel(name, "1", "other", at + 4 * spread * x)
        for name, at, spread, x in zip(CHANNELS, ZERO, SPREAD, moved)
    ]


def formula(scene: Scene, values: Mapping[str, float]) -> np.ndarray:
    """The physics again: channels come counted from their zero. Write yours here, apart from the kernel."""
    x = [scene.channels[name] for name in CHANNELS]
    u = x[0] / values.get(WIDTH.name, SPREAD[0])
    v = x[1] / SPREAD[1] if len(x) > 1 else None
    functions = ($columns,)
    return sum(f[:, None] * [values[f"{n}_{a}"] for a in "xyz"] for n, f in zip($names, functions))


def test_the_effect() -> None:
    truth = {**SIZES, **{shape.name: shape.value for shape in FAMILY.shapes}}
    check_effect("$name", truth, formula, channels=recorded)
'''
