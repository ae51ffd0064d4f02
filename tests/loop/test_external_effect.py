"""An effect in one file outside the project: picked up by its entry point, it cures a run nothing else explains."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.model.effects import Family, Form, Scene, families
from labcal.model.effects.regressors import on_each_axis, per_axis
from labcal.record import Run

PERIOD_S = 37.0  # of the pump


def kernel(form: Form, scene: Scene) -> np.ndarray:
    """A pump that runs for the first fifth of every period."""
    return on_each_axis((np.mod(scene.t_s, PERIOD_S) < 0.2 * PERIOD_S).astype(float))


def candidates(run: Run) -> list[Form]:
    return [Form(kernel, per_axis("c", "nT"))]


PUMP = Family("pump", "sensor", kernel, candidates, experiment="switch the pump off", bound_to_run=True)


def _write_run(folder: Path) -> None:
    """Rotations about three axes in two fields, with the pump's offset in the readings."""
    draw = np.random.default_rng(5)
    rows, segments = [], []
    for number in range(6):
        axis, size = np.eye(3)[number % 3], (20000.0, 50000.0)[number // 3]
        segments.append(
            {"id": f"r{number}", "kind": "rotation", "axis_body": axis.tolist(), "axis_cage": axis.tolist()}
        )
        for t in 100.0 * number + np.arange(0, 90, 0.5):
            angle = np.radians(4 * (t - 100 * number))
            ref = size * np.array([0.5, 0.6, 0.62])
            along = (axis @ ref) * axis
            seen = along + np.cos(angle) * (ref - along) - np.sin(angle) * np.cross(axis, ref)
            reading = 1.05 * seen + 800 + draw.normal(0, 20, 3)
            reading += np.array([300, -200, 150]) * (np.mod(t, PERIOD_S) < 0.2 * PERIOD_S)
            cells = [f"{t:.2f}", f"r{number}", *(f"{v:.2f}" for v in (*reading, *ref)), f"{np.degrees(angle):.3f}"]
            rows.append(",".join(cells))
    header = "t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z,angle_deg"
    (folder / "samples.csv").write_text("\n".join([header, *rows]) + "\n")
    dut = {"serial": "P1", "model": "M", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": 20.0}
    head = {"format": "labcal-run/1", "run_id": "pump", "started_utc": "2026-05-01T00:00:00Z", "simulated": True,
            "operator": "", "dut": dut,
            "reference": {"kind": "vector", "serial": "R"}, "segments": segments, "channels": {}}  # fmt: skip
    (folder / "run.json").write_text(json.dumps(head))


@pytest.fixture
def pump_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if another package's entry point of labcal.effects named PUMP."""
    import labcal.loop.search
    import labcal.model.effects.registry as registry

    more = (*families(), PUMP)
    for module in (labcal.loop.search, registry):
        monkeypatch.setattr(module, "families", lambda: more)


def test_without_the_effect_the_run_is_unexplained(tmp_path: Path) -> None:
    _write_run(tmp_path)
    closed = session.close_loop(str(tmp_path))
    assert closed.verdict in ("unexplained", "partly-explained")


def test_with_the_effect_it_is_explained(tmp_path: Path, pump_installed: None) -> None:
    _write_run(tmp_path)
    closed = session.close_loop(str(tmp_path))
    assert (closed.verdict, [e.effect for e in closed.accepted]) == ("explained", ["pump"])
    found = {p.name: p for p in closed.accepted[0].parameters}
    for name, true in (("c_x", 300 / 1.05), ("c_y", -200 / 1.05), ("c_z", 150 / 1.05)):
        assert abs(found[name].value - true) < 4 * found[name].u + 1
        assert 0.3 < found[name].u < 3.0  # 20 nT over 1080 rows, a fifth of them with the pump on
