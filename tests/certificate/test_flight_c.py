"""Calibrations in C: compiled with every warning as an error, each form of each effect gives what `apply` gives."""

from __future__ import annotations

import hashlib
import math
import re
import shutil
import subprocess
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

from labcal.certificate import read_calibration
from labcal.certificate.flight import flight_files
from labcal.certificate.flight.content import content_of
from labcal.certificate.flight.vectors import scene
from labcal.errors import InputError
from labcal.loop.empirical.splines import functions_of_length, splines_of, table
from labcal.model import Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply
from labcal.model.effects import families, registry
from labcal.model.effects.inputs import channels_of, values
from labcal.model.readings import readings_of
from labcal.model.smooth import Domain, convex_hull
from labcal.record import Channel, Run
from labcal.store import read_bundle

PREFLIGHT = Path(__file__).parents[2] / "examples" / "short-preflight"
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-Wconversion", "-pedantic")
CC = shutil.which("cc") or shutil.which("gcc")
needs_cc = pytest.mark.skipif(CC is None, reason="needs a C compiler")

C = {"c_x": 50.0, "c_y": -3.0, "c_z": 10.0}
CURRENT, WARM = (("i",), {"i": 0.2}), (("temp",), {"temp": 20.0})
NONE = ((), {})
NINE = tuple(product("xyz", "xyz"))
PINNED = {"a_nT": 12000.0, "pinning_nT": 5000.0}
RELAYS = {"r_nT": 4000.0, "middles_nT": 9000.0, "sd_ln": 0.5}
BAR = {"lon_deg": 30.0, "lat_deg": 20.0, "kept": 1.0}
KNOWN = ("secant_s", "kept", "begins_on", "begins", "less_itself", "t_ref_s")  # exactly


def each(**values: float) -> dict[str, float]:
    """The same on each axis."""
    return {f"{name}_{axis}": value for name, value in values.items() for axis in "xyz"}


SMOOTH = (("channel:temp",), ("field",), ("rate",), ("channel:i", "attitude_y"), ("field_x", "channel:temp"))
FORMS = {
    "map": (),
    "current": (("offset-current", *CURRENT, C),),
    "behind": (("offset-current", *CURRENT, {**C, "tau_s": 3.0}),),
    "late": (("offset-current", *CURRENT, {**C, "delay_s": 1.7}),),
    "ahead": (("offset-channel", *CURRENT, {**C, "delay_s": -0.9}),),
    "several": (("offset-current", *CURRENT, {f"c{tau}s_{a}": 20.0 + tau for tau in (0, 3, 12) for a in "xyz"}),),
    "heat": (("offset-current-squared", ("i",), {"i": 0.0}, {**C, "tau_s": 8.0}),),
    "a square that is late": (("offset-current-squared", ("i",), {"i": 0.0}, {**C, "delay_s": 0.7}),),
    "a square seen late": (("offset-current-squared", ("i",), {"i": 0.0}, {**C, "delay_s": -1.3}),),
    "curved": (("offset-temperature", *WARM, {**C, "d_x": 1.0, "d_y": 0.5, "d_z": 2.0, "tau_s": 25.0}),),
    "branches": (("offset-temperature", *WARM, {**C, **each(b=30.0), "r_C": 0.4}),),
    "branched-slopes": (("offset-temperature", *WARM, {**C, **each(b=30.0, f=4.0), "r_C": 0.4}),),
    "bent-gains": (("gain-temperature", *WARM, {**each(g=1e-4, h=3e-5), "tau_s": 30.0}),),
    "leading": (("offset-temperature", *WARM, {**C, "tau_s": -40.0}),),
    "gains": (("gain-temperature", *WARM, {"g_x": 1e-4, "g_y": 2e-4, "g_z": -1e-4, "tau_s": 30.0}),),
    "matrix": (("gain-temperature", *WARM, {f"g_{i}{j}": 1e-5 * k for k, (i, j) in enumerate(NINE, 1)}),),
    "fed-gains": (("gain-channel", *CURRENT, each(g=1e-3, h=3e-4)),),
    "fed-matrix": (("gain-channel", *CURRENT, {f"g_{i}{j}": 1e-4 * k for k, (i, j) in enumerate(NINE, 1)}),),
    "mode": (("offset-mode", *NONE, {f"c_{a} full power": 20.0 for a in "xyz"}), ("offset-current", *CURRENT, C)),
    "powers": (("nonlinearity", *NONE, each(c2=1e-7, c3=1e-12, o2=2e-7, k1=1e-3)),),
    "saturates": (("nonlinearity", *NONE, {f"body_t1_{a}": 900.0 for a in "xyz"} | {"s_nT": 20000.0}),),
    "across": (("cross-field", *NONE, {"q_x:xy": 1e-7, "q_y:yzz": 1e-12, "q_z:xxyy": 1e-17}),),
    "across-body": (("cross-field", *NONE, {"body_q_x:xy": 1e-7, "body_q_z:yy": -2e-7}),),
    "dahl": (("hysteresis", *NONE, {**C, "w_nT": 4000.0}),),
    "stop": (("hysteresis", *NONE, {"c_x": 0.02, "c_y": 0.03, "c_z": 0.01, "r_nT": 4000.0}),),
    "stop-alone": (("hysteresis", *NONE, each(c=0.3) | {"r_nT": 4000.0, "less_itself": 1.0}),),
    "core-alone": (("hysteresis", *NONE, each(c=2000.0, t1=900.0) | PINNED | {"less_itself": 1.0}),),
    "kept": (("hysteresis", *NONE, {f"c{r}_{a}": 0.02 for r in (500, 4000) for a in "xyz"} | {"kept": 1.0}),),
    "anew": (("hysteresis", *NONE, {f"body_c{r}_{a}": 0.02 for r in (500, 4000) for a in "xyz"} | {"kept": 0.0}),),
    "play": (
        (
            "hysteresis", *NONE,
            each(c=9.0, t1=5.0, a2=1e-9, a3=1e-13, a4=1e-18, a5=1e-22) | {"r_nT": 1000.0, "s_nT": 20000.0},
        ),
    ),
    "relays": (("hysteresis", *NONE, each(c=60.0, t1=40.0) | RELAYS),),
    "core": (("hysteresis", *NONE, each(c=60.0, t1=40.0) | PINNED | {"begins_on": 0.4, "begins": 0.3}),),
    "core-body": (("hysteresis", *NONE, each(body_c=60.0, body_t1=40.0) | PINNED),),
    "bar": (("hysteresis", *NONE, each(body_c2000=0.01, body_c6000=0.02) | BAR),),
    "lag": (("lag", *NONE, {"lag_s": 0.35, "secant_s": 0.35}), ("offset-current", *CURRENT, {**C, "tau_s": 3.0})),
    "clock-ahead": (("lag", *NONE, {"lag_s": -0.2, "secant_s": -0.2}), ("offset-current", *CURRENT, C)),
    "bound": (
        ("offset-drift", *NONE, {"c1_x": 0.4, "c1_y": 0.2, "c1_z": -0.1, "t_ref_s": 10.0}),
        ("offset-current", *CURRENT, C),
        ("offset-step", *NONE, {**C, "t_step_s": 100.0}),
        ("gain-step", *NONE, {"g_x": 1e-4, "g_y": 2e-4, "g_z": -1e-4, "t_step_s": 100.0}),
        ("periodic", *NONE, {f"{w}_{a}": 8.0 for w in ("cos", "sin") for a in "xyz"} | {"f_Hz": 0.4}),
    ),
}  # fmt: skip


@pytest.fixture(scope="module")
def run() -> Run:
    return with_own_channels()


def with_own_channels() -> Run:
    """The simulated preflight of the example, with a current, a temperature and a power mode of our own."""
    recorded = read_bundle(PREFLIGHT / "run.zip")
    t = recorded.t_s
    own = (
        Channel("i", "A", "current", np.where(np.sin(t / 11) > 0, 0.4, 0.1) + 0.02 * np.sin(t)),
        Channel("temp", "degC", "temperature", 20 + t / 500 + np.sin(t / 90)),
    )
    mode = np.where(np.sin(t / 31) > 0, "nominal", "full power")
    return replace(recorded, channels=own, row_mode=mode)


def calibration(*effects: tuple, u: float = 0.05, **more) -> Calibration:
    """The example's map with these effects."""
    made = read_calibration(PREFLIGHT / "calibration.json")
    records = tuple(
        EffectRecord(
            name, channels, reference, "sensor",
            tuple(Parameter(k, v, 0.0 if k in KNOWN else abs(v) * u, "") for k, v in values.items()),
            holdout_rms_before_nT=30.0, holdout_rms_after_nT=12.0,
        )
        for name, channels, reference, values in effects
    )  # fmt: skip
    covariance = None if made.covariance is None else made.covariance[:12, :12]
    stated = {
        "effects": records, "covariance": covariance, "covariance_of": made.covariance_of[:12], "k_at": {},
        "validity": Validity((30e3, 50.2e3), (19.5, 22.0), ("nominal", "full power")),
    }  # fmt: skip
    return replace(made, **{**stated, **more})


def exported(made: Calibration, run: Run | None, folder: Path) -> Path:
    for name, content in flight_files("c", content_of(made, b"the file", "unsigned"), run).items():
        (folder / name).write_bytes(content)
    return folder


def compiled(folder: Path, *more: str) -> Path:
    program = folder / f"check{''.join(more)}"
    command = [str(CC), *STRICT, *more, "-o", str(program), "main.c", "labcal_calibration.c", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return program


def checked(folder: Path, *more: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([compiled(folder, *more)], cwd=folder, capture_output=True, text=True, check=False)


@needs_cc
@pytest.mark.parametrize(
    "form", [pytest.param(one, marks=pytest.mark.slow if n % 2 else ()) for n, one in enumerate(FORMS)]
)
def test_each_form_gives_in_c_what_apply_gives(form: str, run: Run, tmp_path: Path) -> None:
    folder = exported(calibration(*FORMS[form]), run, tmp_path)
    done = checked(folder)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_effect_that_ships_is_tried_in_one_of_its_forms() -> None:
    tried = {effect[0] for effects in FORMS.values() for effect in effects} | {"empirical"}  # by SMOOTH
    ours = {f.id for f in families() if f.belongs_to == "sensor" and f.kernel.__module__.startswith("labcal.")}
    assert tried == ours, "each effect of the sensor has a case in FORMS of this file, with channels and parameters"
    grounded = [f.id for f in families() if f.id in ours and not f.bound_to_run and f.in_c is None]
    assert grounded == [], "state `in_c` of these, or `bound_to_run`"


def smooth(inputs: tuple[str, ...], run: Run) -> EffectRecord:
    """A function of these that is no simple one; part of the run lies where it was not seen."""
    content = content_of(calibration(), b"", "")
    seen = values(inputs, scene(content, readings_of(run)))
    plain, random = splines_of(seen), np.random.default_rng(len(inputs))
    functions = functions_of_length(len(inputs), 0.35)[:, :7]
    coefficients = 40 * random.normal(size=(functions.shape[1], 3))
    basis = replace(
        plain, prior_nT=60.0, functions=table(functions), coefficients=table(coefficients),
        projection=table(0.05 * random.normal(size=(12, coefficients.size))),
        covariance=table(4.0 * np.eye(coefficients.size)),
    )  # fmt: skip
    middle, ends = seen.mean(axis=0), np.quantile(seen, [[0.1], [1.0]], axis=0)[:, 0]
    hull = convex_hull(middle + 0.9 * (seen - middle)) if len(inputs) == 2 else ends
    names = [f"s{j}_{axis}" for j in range(len(coefficients)) for axis in "xyz"]
    parameters = (Parameter(n, v, 2.0, "nT") for n, v in zip(names, coefficients.ravel().tolist(), strict=True))
    channels = channels_of(inputs)
    return EffectRecord(
        "empirical", channels, dict.fromkeys(channels, 0.2), "sensor", tuple(parameters), holdout_rms_before_nT=30.0,
        holdout_rms_after_nT=12.0, inputs=inputs, basis=basis, domain=(Domain(inputs, table(hull)),),
    )  # fmt: skip


@needs_cc
@pytest.mark.parametrize(
    "inputs", [pytest.param(one, marks=pytest.mark.slow if n % 2 else ()) for n, one in enumerate(SMOOTH)], ids=" ".join
)
def test_a_function_without_a_name_gives_in_c_what_apply_gives(
    inputs: tuple[str, ...], run: Run, tmp_path: Path
) -> None:
    """Its inputs, its basis, and where it was seen: there it is large, and elsewhere it is left out."""
    made = replace(calibration(*FORMS["late"]), effects=(smooth(inputs, run), *calibration(*FORMS["late"]).effects))
    applied = apply(made, readings_of(run))
    out = np.array(["domain" in flag for flag in applied.flags])
    without = apply(replace(made, effects=made.effects[1:]), readings_of(run))
    assert 0.02 < out.mean() < 0.9
    assert np.abs(applied.field_nT - without.field_nT)[~out].max() > 20
    folder = exported(made, run, tmp_path)
    for more in ((), ("-DLABCAL_FLOAT32",)):
        done = checked(folder, *more)
        assert done.returncode == 0, done.stdout + done.stderr
    text = (folder / "labcal_calibration.c").read_text()
    (folder / "labcal_calibration.c").write_text(text.replace("double phi = 0.0;", "double phi = 0.01;"))
    assert checked(folder).returncode == 1


@needs_cc
@pytest.mark.parametrize("inputs", [("channel:temp",), ("field_x", "channel:temp")], ids=" ".join)
def test_vectors_without_the_run_go_where_a_channel_was_seen(inputs: tuple[str, ...], run: Run, tmp_path: Path) -> None:
    """About where the channel counts from, which nothing says was seen, the term is left out in every row."""
    folder = exported(replace(calibration(), effects=(smooth(inputs, run),)), None, tmp_path)
    assert checked(folder).returncode == 0
    text = (folder / "labcal_calibration.c").read_text()
    (folder / "labcal_calibration.c").write_text(text.replace("double phi = 0.0;", "double phi = 0.01;"))
    assert checked(folder).returncode == 1


@needs_cc
def test_the_check_fails_where_a_number_differs(run: Run, tmp_path: Path) -> None:
    folder = exported(calibration(*FORMS["behind"]), run, tmp_path)
    text = (folder / "labcal_calibration.c").read_text()
    for good, bad in (("R(50.0)", "R(50.1)"), ("{3.0}", "{3.05}"), ("#define LAG_S 0.0", "#define LAG_S 0.1")):
        assert good in text
        (folder / "labcal_calibration.c").write_text(text.replace(good, bad))
        assert checked(folder).returncode == 1, bad


@needs_cc
def test_floats_are_off_by_what_the_header_says_and_32_bits_give_the_same(run: Run, tmp_path: Path) -> None:
    effects = (*FORMS["play"], *FORMS["curved"], *FORMS["late"], *FORMS["matrix"])
    folder = exported(calibration(*effects), run, tmp_path)
    done = checked(folder, "-DLABCAL_FLOAT32")
    assert done.returncode == 0, done.stdout
    stated = float(re.search(r"FLOAT32_ERROR_NT ([\d.e-]+)", (folder / "labcal_calibration.h").read_text())[1])
    off = float(re.search(r"within ([\d.e-]+) nT", done.stdout)[1])
    assert 0.02 * stated < off <= stated
    (tmp_path / "links.c").write_text("#include <math.h>\nint main(void) { return (int)sin(0.0); }\n")
    links = subprocess.run([str(CC), "-m32", "links.c", "-lm"], cwd=tmp_path, capture_output=True, check=False)
    if links.returncode == 0:
        assert checked(folder, "-m32").returncode == 0


@needs_cc
def test_a_channel_that_is_missing_leaves_its_effect_out_and_u_grows(run: Run, tmp_path: Path) -> None:
    folder = exported(calibration(*FORMS["current"]), run, tmp_path)
    (folder / "main.c").write_text(
        '#include "labcal_calibration.h"\n#include <math.h>\n#include <stdio.h>\n'
        "int main(void)\n{\n    static labcal_state state;\n    labcal_field with, without, none;\n"
        "    labcal_row row = {0, 0, LABCAL_NO_MODE, {3820, -522, -3647}, {1.2}};\n"
        "    unsigned flags;\n    labcal_begin(&state);\n"
        "    labcal_apply(&state, &row, &with);\n    row.input[LABCAL_IN_i] = NAN;\n"
        "    flags = labcal_apply(&state, &row, &without);\n    row.reading[1] = NAN;\n"
        '    printf("%.6f %.3f %.3f %u %u", (double)(without.b_nT[0] - with.b_nT[0]), (double)with.u_nT,\n'
        "           (double)without.u_nT, flags & LABCAL_LEFT_OUT, labcal_apply(&state, &row, &none));\n"
        "    return !isnan(none.b_nT[0]);\n}\n"
    )
    done = checked(folder)
    more, u, grown, left_out, no_reading = done.stdout.split()
    assert (done.returncode, float(more), left_out, no_reading) == (0, 50.0, "16", "64")
    assert float(grown) > float(u)


@needs_cc
def test_a_channel_where_its_effect_was_not_seen_grows_u_as_apply_does(run: Run, tmp_path: Path) -> None:
    made = calibration(*FORMS["current"])
    seen = replace(made.effects[0], domain=(Domain(("channel:i",), ((0.15,), (0.3,))),))
    folder = exported(replace(made, effects=(seen,)), run, tmp_path)
    assert "LABCAL_DOMAIN, &flags" in (folder / "labcal_calibration.c").read_text()
    assert checked(folder).returncode == 0


def test_effects_bound_to_the_run_are_named_and_their_u_is_added(run: Run) -> None:
    files = flight_files("c", content_of(calibration(*FORMS["bound"]), b"x", "unsigned"), run)
    header = files["labcal_calibration.h"].decode()
    assert [name in header for name in ("offset-drift", "offset-step", "periodic")] == [True] * 3
    plain = flight_files("c", content_of(calibration(*FORMS["current"]), b"x", "unsigned"), run)
    u = [float(f["test_vectors.csv"].decode().splitlines()[9].split(",")[-1]) for f in (files, plain)]
    assert math.sqrt(u[0] ** 2 - u[1] ** 2) > 0.4 * 175 / math.sqrt(12)  # a drift of 0.4 nT/s over the span of 175 s


@pytest.mark.parametrize(("in_c", "says"), [(None, " has no form in C"), (lambda term: "text", ": .* gives no CForm")])
def test_an_effect_without_a_form_in_c_is_refused_by_name(
    in_c: object, says: str, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    without = tuple(replace(f, in_c=in_c) if f.id == "offset-current" else f for f in families())
    monkeypatch.setattr(registry, "families", lambda: without)
    with pytest.raises(InputError, match=rf"effects\[0\]: offset-current of i{says}"):
        flight_files("c", content_of(calibration(*FORMS["current"]), b"x", "unsigned"), run)


@needs_cc
def test_words_of_the_file_stay_words_and_without_the_run_vectors_are_made_up(tmp_path: Path) -> None:
    made = calibration(("offset-current", ("i */ x",), {"i */ x": 0.2}, C))
    made = replace(made, dut=replace(made.dut, serial='*/ int x; /* ??/ \\ "'), not_covered=("*/\n#error",))
    folder = exported(made, None, tmp_path)
    assert checked(folder).returncode == 0
    header = (folder / "labcal_calibration.h").read_text()
    assert hashlib.sha256(b"the file").hexdigest() in header
    assert "made up" in (folder / "main.c").read_text()


def test_the_same_calibration_gives_the_same_bytes(run: Run) -> None:
    for format_ in ("c", "json", "mat"):
        first, again = (flight_files(format_, content_of(calibration(*FORMS["late"]), b"x", ""), run) for _ in "ab")
        assert first == again


@needs_cc
def test_where_nothing_is_known_of_the_uncertainty_there_is_no_u(tmp_path: Path) -> None:
    made = calibration(covariance=None, metrics={"before": {}, "after": {}})
    folder = exported(made, None, tmp_path)
    assert "R(NAN)" in (folder / "labcal_calibration.c").read_text()
    assert checked(folder).returncode == 0


@needs_cc
def test_the_example_s_own_calibration_on_its_own_run(tmp_path: Path) -> None:
    folder = exported(read_calibration(PREFLIGHT / "calibration.json"), read_bundle(PREFLIGHT / "run.zip"), tmp_path)
    done = checked(folder, "-O2")
    assert done.returncode == 0, done.stdout
    assert "1321 rows" in done.stdout
    assert "i_radio" in (folder / "test_vectors.csv").read_text().splitlines()[0]
