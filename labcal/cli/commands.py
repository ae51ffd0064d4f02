"""Registers every command group on the app, in the order of the lab's work."""

from __future__ import annotations

from labcal.cli import (  # noqa: F401  each registers its commands
    app,
    archive,
    audit,
    bench,
    conformity,
    demo,
    effect,
    fitting,
    gui,
    keys,
    loop,
    numbers,
    plugins,
    report,
    run,
    runs,
    self_test,
    signing,
    study,
    watch,
    years,
)
