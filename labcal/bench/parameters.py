"""What a procedure may be given: its keyword parameters with unit, range and default, declared once, in its signature.

    def rotate_axis(bench: Bench, *, rate_deg_per_s: Annotated[float, Limits(0.1, 36, unit="deg/s"), "rate"] = 2.0)

The command line's `--set`, the window's form and the record's header all come from this declaration.
"""

from __future__ import annotations

import inspect
import math
import types
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from labcal.errors import InputError
from labcal.record.physical import largest

Value = Any  # float, int, bool, str, Path, a tuple of one of these, or None
Kind = Literal["number", "integer", "switch", "choice", "text", "file"]
WORDS = {"yes": True, "true": True, "on": True, "1": True, "no": False, "false": False, "off": False, "0": False}


@dataclass(frozen=True, slots=True)
class Limits:
    """The range of a number (of every number of a list), both ends allowed, and its unit."""

    lo: float
    hi: float
    unit: str = ""


@dataclass(frozen=True, slots=True)
class Least:
    """How many values a list has at least for what its procedure promises; `says` what does not come of fewer."""

    count: int
    says: str


@dataclass(frozen=True, slots=True)
class ParameterSpec:
    """One declared parameter. `many`: a list, written with commas. `optional`: "none" or nothing is allowed."""

    name: str
    kind: Kind
    default: Value  # None where `required`
    required: bool = False
    many: bool = False
    optional: bool = False
    limits: Limits | None = None
    choices: tuple[str, ...] = ()
    help: str = ""
    least: Least | None = None

    def shortfall(self, value: Value) -> str:
        """What does not come of this value, though it is allowed, a sentence; else ""."""
        return self.least.says if self.least and self.many and len(value or ()) < self.least.count else ""

    @property
    def unit(self) -> str:
        """The unit of the number; empty where it has none."""
        return self.limits.unit if self.limits else ""

    def parse(self, text: str) -> Value:
        """The value that `text` states. Raises InputError where it is none, or is out of range."""
        text = text.strip()
        if self.optional and text.lower() in ("", "none"):
            return None
        if not self.many:
            return self._checked(self._one(text))
        values = tuple(self._one(part.strip()) for part in text.split(",") if part.strip())
        return self._checked(values)

    def check(self, value: Value) -> Value:
        """`value` itself. Raises InputError where it is out of range."""
        return value if value is None and self.optional else self._checked(value)

    def restore(self, value: Any) -> Value:
        """The value as it was, from the JSON of a record's header."""
        if value is None:
            return None
        one = Path if self.kind == "file" else lambda v: v
        return tuple(one(v) for v in value) if self.many else one(value)

    def _one(self, text: str) -> Any:
        try:
            match self.kind:
                case "number":
                    return float(text)
                case "integer":
                    return int(text)
                case "switch":
                    return WORDS[text.lower()]
                case "file":
                    return Path(text).expanduser()
                case _:
                    return text
        except (ValueError, KeyError):
            raise InputError(f"{self.name} = {text!r}: expected {self.expected}") from None

    def _checked(self, value: Any) -> Any:
        for one in value if self.many else (value,):
            outside = self.limits and not (math.isfinite(one) and self.limits.lo <= one <= self.limits.hi)
            if not self.limits and self.kind in ("number", "integer") and not abs(one) <= largest(self.name):
                most = f"{largest(self.name):g} {self.unit}".rstrip()
                raise InputError(f"{self.name} = {shown(one)} is refused: no {self.kind} beyond {most} is meant")
            if outside or (self.choices and one not in self.choices):
                raise InputError(f"{self.name} = {one} is refused: expected {self.expected}")
        if self.many and not value and not self.optional:
            raise InputError(f"{self.name} is empty: expected {self.expected}")
        if self.many and not self._a_vector() and len(set(value)) < len(value):
            raise InputError(f"{self.name} states one twice: expected {self.expected}, no two alike")
        return value

    def _a_vector(self) -> bool:
        """Whether two numbers of its list may be alike: its default's are."""
        return self.default is not None and len(set(self.default)) < len(self.default)

    @property
    def expected(self) -> str:
        """What is allowed, in words: "a number from 1000 to 100000 nT"."""
        what = {"switch": "yes or no", "choice": f"one of {', '.join(self.choices)}"}.get(self.kind, f"a {self.kind}")
        what = what.replace("a integer", "a whole number")
        if self.limits:
            what += f" from {self.limits.lo:g} to {self.limits.hi:g} {self.limits.unit}".rstrip()
        return f"{what}, or several with commas" if self.many else what


def parameters_of(procedure: Callable[..., Any]) -> tuple[ParameterSpec, ...]:
    """The declared parameters of a procedure, in order. Raises InputError for a declaration that makes no sense."""
    hints = get_type_hints(procedure, include_extras=True)
    keywords = (p for p in inspect.signature(procedure).parameters.values() if p.kind is p.KEYWORD_ONLY)
    return tuple(_spec(p, hints[p.name]) for p in keywords if p.name in hints and p.name not in RUNNER_GIVES)


def shown(number: float) -> str:
    """A number in a sentence, however many digits it has."""
    text = str(number)
    return text if len(text) <= 40 else f"{text[:20]}… ({len(text)} digits)"


def for_modes(spec: ParameterSpec, modes: tuple[str, ...]) -> ParameterSpec:
    """`spec` for a DUT with these power modes: a choice of them where it wants one; any text where none is known."""
    if spec.name not in POWER_MODES or spec.kind != "text" or not modes:
        return spec
    return replace(spec, kind="choice", choices=modes)


def for_rate(spec: ParameterSpec, fastest_deg_per_s: float | None) -> ParameterSpec:
    """`spec` where DUT and platform turn no faster: a rate's range ends there; as it is where no limit is known."""
    if spec.name != RATE or spec.limits is None or fastest_deg_per_s is None:
        return spec
    return replace(spec, limits=replace(spec.limits, hi=min(spec.limits.hi, fastest_deg_per_s)))


RATE = "rate_deg_per_s"  # the keyword of how fast the platform turns with the DUT
POWER_MODES = ("mode", "modes")  # keywords that name power modes of the DUT, by which a run refuses those it has not
# Stated as the others are, where a procedure declares it, and read before the bench is opened.
CALIBRATION = ParameterSpec(
    "calibration", "file", None, optional=True, help="the DUT's own, that is judged; without one nothing is"
)
RUNNER_GIVES = ("resume", CALIBRATION.name)  # keywords that are filled for the procedure: what was done, a file read


def settings(specs: Iterable[ParameterSpec], given: Mapping[str, str]) -> dict[str, Value]:
    """The values to call with: defaults and what `given` says. Raises InputError naming an unknown key."""
    known = {spec.name: spec for spec in specs}
    for key in given:
        if key not in known:
            raise InputError(f"no parameter is called {key!r}; there are: {', '.join(known) or 'none'}")
    missing = [name for name, spec in known.items() if spec.required and name not in given]
    if missing:
        raise InputError(f"{missing[0]} has no default: say --set {missing[0]}=… ({known[missing[0]].expected})")
    return {name: spec.parse(given[name]) if name in given else spec.default for name, spec in known.items()}


def _spec(parameter: inspect.Parameter, hint: Any) -> ParameterSpec:
    extras: tuple[Any, ...] = ()
    if get_origin(hint) is Annotated:
        hint, *rest = get_args(hint)
        extras = tuple(rest)
    hint, optional = _without_none(hint)
    many = get_origin(hint) is tuple
    hint = get_args(hint)[0] if many else hint
    limits = next((e for e in extras if isinstance(e, Limits)), None)
    words = next((e for e in extras if isinstance(e, str)), "")
    least = next((e for e in extras if isinstance(e, Least)), None)
    choices = tuple(get_args(hint)) if get_origin(hint) is Literal else ()
    kinds: dict[Any, Kind] = {float: "number", int: "integer", bool: "switch", str: "text", Path: "file"}
    kind: Kind | None = "choice" if choices else kinds.get(hint)
    if kind is None:
        raise InputError(f"parameter {parameter.name}: {hint} is not a type a parameter can have")
    required = parameter.default is inspect.Parameter.empty
    default = None if required else parameter.default
    spec = ParameterSpec(parameter.name, kind, default, required, many, optional, limits, choices, words, least)
    if not required:
        spec.check(default)
    return spec


def _without_none(hint: Any) -> tuple[Any, bool]:
    if get_origin(hint) not in (Union, types.UnionType):
        return hint, False
    rest = [h for h in get_args(hint) if h is not type(None)]
    return (rest[0], True) if len(rest) == 1 else (hint, False)
