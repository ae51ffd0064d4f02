from collections.abc import Iterator
from pathlib import Path

import made_up_runs as lab
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from labcal.errors import InputError
from labcal.fit import METHODS, fit, fit_all, methods, registry
from labcal.fit.swarm.particle_swarm import SwarmSettings
from labcal.fit.swarm.pso_axis import Options
from labcal.record import Dut, Reference, Run, Segment


def empty_run() -> Run:
    return Run(
        run_id="r",
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut(serial="s"),
        reference=Reference(kind="none"),
        segments=(Segment("a", "free"),),
        t_s=np.arange(5.0),
        segment_index=np.zeros(5, dtype=np.intp),
        reading=np.ones((5, 3)),
    )


def test_a_method_that_does_not_exist_is_named_with_those_that_do() -> None:
    with pytest.raises(InputError, match=r"no method 'magic'.*twostep"):
        fit(empty_run(), "magic")


def test_options_reach_the_method() -> None:
    run = lab.run_of(lab.tumbling(1, 400), 1)
    plain, field = fit(run, holdout=False), fit(run, holdout=False, white_in="field")
    assert not np.array_equal(plain.affine.K, field.affine.K)
    short = Options(SwarmSettings(iterations=5), polish=False)
    one, other = (fit(run, "pso-scalar", holdout=False, options=short, seed=seed) for seed in (0, 3))
    assert one.covariance is None
    assert not np.array_equal(one.affine.K, other.affine.K)


@pytest.mark.parametrize("method", METHODS)
def test_a_payload_that_spins_about_the_vertical_and_nods_a_little_is_calibrated_by_no_method(method: str) -> None:
    """A quadric nearly flat along the spin fits its magnitudes to the noise, with gains of many times one."""
    t = np.arange(1000) / 10
    nod = np.radians(3.0) * np.column_stack([np.sin(2 * np.pi * t / 3.1), np.cos(2 * np.pi * t / 4.3)])
    turns = Rotation.from_euler("ZYX", np.column_stack([2 * np.pi * t / 7, nod])).inv()
    found = fit(lab.run_of(turns.apply([20e3, 0, 43e3]), 0, noise=30.0), method, holdout=False)
    assert not found.ok
    assert found.affine is None


@pytest.mark.parametrize("method", METHODS)
def test_a_run_without_a_reference_gets_no_calibration(method: str) -> None:
    found = fit(empty_run(), method)
    assert not found.ok
    assert found.why_not


FOREIGN = """
from labcal.fit.result import Fit

def refuses(run, **options):
    return Fit("any", ok=False, why_not="not today")

def raises(run, **options):
    raise KeyError("temp_dut")

def breaks(run, **options):
    return 1 / 0

def other(run, **options):
    return "a map"
"""


@pytest.fixture
def foreign(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A package with estimators of its own, one of them with a name of ours."""
    info = tmp_path / "their_methods-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: their-methods\nVersion: 1.0\n")
    points = "".join(f"their-{name} = their_methods:{name}\n" for name in ("refuses", "raises", "breaks", "other"))
    (info / "entry_points.txt").write_text(f"[labcal.estimators]\n{points}ml = their_methods:raises\n")
    (tmp_path / "their_methods.py").write_text(FOREIGN)
    monkeypatch.syspath_prepend(tmp_path)
    registry._others.cache_clear()
    yield
    registry._others.cache_clear()


def test_estimators_of_other_packages_are_methods_after_ours(foreign: None) -> None:
    assert methods() == (*METHODS, "their-breaks", "their-other", "their-raises", "their-refuses")
    found = fit(empty_run(), "their-refuses")
    assert (found.method, found.ok, found.why_not) == ("their-refuses", False, "not today")
    assert not fit(empty_run(), "ml").ok  # ours, whoever else has the name
    assert "broke down" in str(fit(empty_run(), "their-breaks").why_not)


def test_one_that_fails_is_said_with_its_name_and_place_and_the_others_stand(foreign: None) -> None:
    place = r"their_methods\.py, line 8: entry point 'their-raises' of labcal\.estimators .* on run r: KeyError"
    with pytest.raises(InputError, match=place):
        fit(empty_run(), "their-raises")
    with pytest.raises(InputError, match=r"it gives a str, not a labcal\.fit\.Fit"):
        fit(empty_run(), "their-other")
    answers = {found.method: found for found in fit_all(empty_run())}
    assert set(answers) == set(methods())
    assert "KeyError" in str(answers["their-raises"].why_not)
