"""The public face: light, typed, told in docs/api.md, and every example of it runs."""

from __future__ import annotations

import doctest
import importlib.util
import runpy
import subprocess
import sys
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

import labcal
from labcal import api
from labcal.system.one_thread import one_thread

ROOT = Path(__file__).parents[1]
SHORT = ROOT / "examples" / "short-preflight"
CALLS = (*(getattr(labcal, name) for name in labcal.__all__ if name[0].islower()), labcal.Calibration.apply)


def told_by(code: str) -> set[str]:
    return {*subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()}


def test_import_alone_loads_no_room_and_no_library() -> None:
    loaded = told_by("import sys, labcal; print(*sys.modules)")
    assert {name for name in loaded if name.startswith("labcal")} == {"labcal", "labcal.version"}
    assert not {"numpy", "scipy", "PySide6", "pydantic"} & loaded


def test_fit_is_the_function_though_its_room_was_loaded_first_and_nothing_needs_window_or_command_line() -> None:
    room = "import sys, labcal.fit.registry; from labcal.fit import METHODS; import labcal.fit.scalar"
    face = "from labcal import fit; [getattr(labcal, name) for name in labcal.__all__]"
    said = told_by(f"{room}; {face}; print(labcal.fit is fit, fit.__module__, *sys.modules)")
    assert {"True", "labcal.api", "numpy", "labcal.fit.registry"} <= said
    assert not {"PySide6", "pyqtgraph", "typer", "labcal.cli", "labcal.gui"} & said


def test_every_name_is_there_and_no_other() -> None:
    assert {*labcal.__all__} == {*api.__all__, "__version__"}
    assert all(getattr(labcal, name) is getattr(api, name) for name in api.__all__)
    assert {*labcal.__all__} <= {*dir(labcal)}
    with pytest.raises(AttributeError, match="module 'labcal' has no attribute 'fits'"):
        labcal.fits  # noqa: B018


@pytest.mark.parametrize("call", CALLS, ids=lambda call: call.__name__)
def test_each_call_says_what_it_takes_gives_and_raises_and_its_example_runs(
    call: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(ROOT)
    text = str(call.__doc__)
    assert all(f"{title}\n" in text for title in ("Parameters", "Returns", "Raises", "Examples"))
    example = doctest.DocTestParser().get_doctest(text, {}, getattr(call, "__name__", ""), "labcal/api.py", 0)
    said: list[str] = []
    assert doctest.DocTestRunner().run(example, out=said.append) == (0, len(example.examples)), "".join(said)
    assert len(example.examples) > 2  # that of `verify`: the calibration that is shipped is what its run gives


def test_the_page_of_the_face_is_made_of_its_docstrings() -> None:
    spec = importlib.util.spec_from_file_location("api_reference", ROOT / "tools" / "api_reference.py")
    assert spec is not None
    assert spec.loader is not None
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    page = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    assert page == tool.page(), "python tools/api_reference.py docs/api.md"
    assert {name.split(".")[0] for name in tool.ORDER} == {n for n in api.__all__ if not n.endswith("Error")}


@pytest.mark.slow
def test_the_notebook_runs_from_the_first_cell_to_the_last(capsys: pytest.CaptureFixture[str]) -> None:
    cells = runpy.run_path(str(ROOT / "examples" / "notebook.py"))
    assert cells["outcome"].status == "finished"
    assert cells["closed"].verdict == "explained"
    assert np.sqrt(np.nanmean(cells["error_nT"] ** 2)) < 1.2 * cells["run"].dut.noise_nT
    assert not cells["result"].valid
    assert "offset-current i_radio: c_x" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: labcal.load_run("nowhere.zip"), "nowhere.zip: there is no such file or folder"),
        (lambda: labcal.load_run(Path("nowhere")), "nowhere: there is no such file or folder"),
        (lambda: labcal.load_run("20260101T000000-abcd"), "20260101T000000-abcd"),
        (lambda: labcal.load_run(SHORT / "run.zip", channels=["i_x"]), "no channel 'i_x' in run short-preflight"),
        (lambda: labcal.load_run(ROOT / "README.md"), "README.md: not a readable zip file"),
        (lambda: labcal.fit(SHORT / "run.zip", "magic"), "there is no method 'magic'; the methods are ml"),
        (lambda: labcal.fit("nowhere/at/all"), "all: there is no such file or folder"),
        (lambda: labcal.close_loop("nowhere.zip"), "nowhere.zip: there is no such file or folder"),
        (lambda: labcal.close_loop(SHORT / "run.zip", out=SHORT / "run.zip"), "run.zip"),
        (lambda: labcal.load_calibration("nowhere.json"), "nowhere.json: No such file"),
        (lambda: labcal.load_calibration(SHORT), "short-preflight: is not a regular file"),
        (lambda: labcal.verify("nowhere.json"), "nowhere.json: No such file"),
        (lambda: labcal.verify(SHORT / "calibration.json", "nowhere"), "nowhere: No such file"),
        (lambda: labcal.run("rotate-axis", "nowhere.toml"), "nowhere.toml"),
        (lambda: labcal.run("walk"), "walk"),
        (lambda: labcal.run("rotate-axis", settings={"angle": 3}), "no parameter is called 'angle'"),
        (lambda: labcal.run("preflight", settings={"magnitudes_nT": (20e3, 1e9)}), "magnitudes_nT = 1000000000.0 is"),
    ],
)
def test_what_is_wrong_is_one_sentence_of_labcal(call: object, words: str) -> None:
    with pytest.raises(labcal.InputError) as caught:
        call()  # type: ignore[operator]
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("reading", "more", "words"),
    [
        ([[1.0, 2.0]], {}, "column reading: expected n rows of three numbers; this has the shape (1, 2)"),
        (np.zeros((2, 3, 3)), {}, "column reading: expected n rows of three numbers; this has the shape (2, 3, 3)"),
        ([["a", "b", "c"]], {}, "column reading: expected numbers"),
        ([[1.0, 2.0], [3.0]], {}, "column reading: expected numbers"),
        (np.ones((2, 3)), {"t_s": [0.0]}, "column t_s: has the shape (1,); there are 2 readings"),
        (np.ones((2, 3)), {"channels": {"i_radio": [0.1] * 3}}, "column i_radio: has the shape (3,)"),
        (np.ones((2, 3)), {"t_s": [0, 1], "segment": "aa"}, "column segment: has the shape (1,)"),
        (np.ones((2, 3)), {"t_s": [0, 1], "segment": ["a", "a"]}, "column i_radio: the calibration's effects need"),
    ],
)
def test_columns_that_do_not_fit_are_named(reading: object, more: dict, words: str) -> None:
    with pytest.raises(labcal.InputError) as caught:
        labcal.load_calibration(SHORT / "calibration.json").apply(reading, **more)
    assert words in str(caught.value)


def test_a_run_and_its_columns_are_corrected_alike() -> None:
    run, calibration = labcal.load_run(SHORT / "run.zip"), labcal.load_calibration(SHORT / "calibration.json")
    names = np.array([segment.id for segment in run.segments])[run.segment_index]
    channels = {channel.name: channel.values.tolist() for channel in run.channels}
    whole = calibration.apply(run)
    columns = calibration.apply(run.reading.tolist(), t_s=run.t_s, segment=names, mode=run.mode, channels=channels)
    np.testing.assert_array_equal(columns.field_nT, whole.field_nT)
    assert columns.flags == whole.flags
    assert np.nanstd(np.linalg.norm(whole.field_nT, axis=1) - run.magnitude_nT) < 30


def test_a_single_reading_is_one_row() -> None:
    calibration = labcal.load_calibration(ROOT / "tests" / "golden" / "calibration-1.json")
    needs = {"t_s": 0.0, "segment": "a", "mode": "full", "channels": dict.fromkeys(
        (name for effect in calibration.effects for name in effect.channels), 0.0)}  # fmt: skip
    assert calibration.apply([20_000, 0, 30_000], **needs).field_nT.shape == (1, 3)


def test_a_fit_is_written_as_a_draft_and_replaced_only_where_asked(tmp_path: Path) -> None:
    run, out = labcal.load_run(SHORT / "run.zip"), tmp_path / "cal.json"
    found = labcal.fit(run, "centered", out=out)
    calibration = labcal.load_calibration(str(out))
    np.testing.assert_array_equal(calibration.affine.K, found.affine.K)
    assert calibration.run_sha256 == labcal.load_calibration(SHORT / "calibration.json").run_sha256
    out.write_text("somebody's own")
    with pytest.raises(labcal.InputError, match=r"cal\.json"):
        labcal.fit(run, "centered", out=out)
    assert out.read_text() == "somebody's own"
    labcal.fit(run, "centered", out=out, force=True)
    assert labcal.load_calibration(out).run_id == "short-preflight"


def linear_algebra() -> set[int]:
    """How many threads each library of linear algebra has."""
    return {pool["num_threads"] for pool in threadpool_info() if pool["user_api"] == "blas"}


WORKING = (labcal.fit, labcal.close_loop, labcal.verify, labcal.run)


def test_one_thread_lasts_until_the_last_of_several_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OPENBLAS_NUM_THREADS")
    with threadpool_limits(2), ExitStack() as second:
        with one_thread():
            second.enter_context(one_thread())
        assert linear_algebra() == {1}
        second.close()
        assert linear_algebra() == {2}


@pytest.mark.parametrize(("stated", "threads"), [(None, 1), ("2", 2)], ids=["nobody chose", "the user chose"])
@pytest.mark.parametrize("call", WORKING, ids=lambda call: call.__name__)
def test_a_call_that_works_something_out_has_one_thread_of_linear_algebra(
    monkeypatch: pytest.MonkeyPatch, call: Callable[..., object], stated: str | None, threads: int
) -> None:
    monkeypatch.delenv("OPENBLAS_NUM_THREADS")
    if stated is not None:
        monkeypatch.setenv("OPENBLAS_NUM_THREADS", stated)
    seen: list[set[int]] = []

    def work(path: object, *_: object, **__: object) -> NoReturn:
        seen.append(linear_algebra())
        raise FileNotFoundError(2, "No such file", str(path))

    for name in ("load_run", "close_loop", "verify", "run"):
        monkeypatch.setattr(f"labcal.session.{name}", work)
    with threadpool_limits(2):
        with pytest.raises(labcal.InputError):
            call("nowhere")
        assert linear_algebra() == {2}
    assert seen == [{threads}]
