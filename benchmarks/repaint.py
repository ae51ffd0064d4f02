"""A window that repaints three curves 33 times a second until it is ended."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QTimer


def main() -> None:
    app = pg.mkQApp()
    window, rng = pg.PlotWidget(), np.random.default_rng(0)
    curves = [window.plot(pen=colour) for colour in "rgb"]
    window.resize(1200, 700)
    window.show()
    timer = QTimer()
    timer.timeout.connect(lambda: [curve.setData(rng.normal(size=6000)) for curve in curves])
    timer.start(30)
    print("painting", flush=True)
    app.exec()


if __name__ == "__main__":
    main()
