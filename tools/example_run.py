"""Make examples/short-preflight again: a short preflight of the simulated lab, its calibration, signed.

python tools/example_run.py examples/short-preflight
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.certificate import sign_simulated
from labcal.demo import START, simulated_bench
from labcal.demo.folder import CALIBRATION, RUN, STORE, TRUST
from labcal.store import Store, write_bundle

SHORT = {"modes": "nominal", "reverse": "no", "timing_nT": "1000", "zero_s": "2"}
CHANNELS = ("temp_dut", "i_radio")  # of thirteen: the example is to be small


def main(folder: Path) -> None:
    """Write run.zip, calibration.json, its signature and allowed_signers to `folder`."""
    with TemporaryDirectory() as scratch:
        session.run(
            "preflight", simulated_bench(), SHORT, operator="example", clock=VirtualClock(START), seed=5,
            run_id=folder.name, store=Path(scratch) / STORE,
        ).raise_fault()  # fmt: skip
        with Store.open(Path(scratch) / STORE) as store:
            folder.mkdir(parents=True, exist_ok=True)
            write_bundle(store.run(folder.name).with_channels(CHANNELS), folder / RUN)
    session.close_loop(str(folder / RUN), folder / CALIBRATION, force=True)
    sign_simulated(folder / CALIBRATION, folder / TRUST)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
