"""What the commands of the years write as JSON: finite numbers only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any

from labcal.quality.control_chart import Chart, spread_false_alarm_rate
from labcal.quality.intercomparison import Intercomparison
from labcal.quality.western_electric import average_run_length
from labcal.session.check_standard import Charts, why
from labcal.years.study_of_gage import Study
from labcal.years.trend import Trend, shortest


def charts_document(found: Charts) -> dict[str, Any]:
    """`labcal-charts/1`."""
    rules, n = found.stated.rules, 1 if found.stated.between else found.stated.repeats
    return {
        "format": "labcal-charts/1",
        "serial": found.serial,
        "in_control": not found.out if any(isinstance(c, Chart) for c in found.of.values()) else None,
        "false_alarms": {
            "average_run_length": {str(rule): average_run_length((rule,)) for rule in rules}
            | {"any": average_run_length(rules)},
            "spread_rate": spread_false_alarm_rate(n) if n > 1 else None,  # a moving range alarms nobody
        },
        "points": [[run.run_id for run in point] for point in found.points],
        "charts": [_chart(name, found.units.get(name, ""), one) for name, one in found.of.items()],
        "not_used": list(found.not_used),
    }


def _chart(name: str, unit: str, chart: Chart | str) -> dict[str, Any]:
    if isinstance(chart, str):
        return {"quantity": name, "unit": unit, "why_not": chart}
    return {
        "quantity": name,
        "unit": unit,
        "why_not": None,
        "centre": chart.centre,
        "sigma": chart.sigma,
        "baseline": chart.baseline,
        "means_differ": chart.differ,
        "out_of_control": chart.out_of_control,
        "why": why(chart),
        "points": [
            {
                "mean": float(chart.mean[i]), "spread": finite(chart.spread[i]), "n": int(chart.n[i]),
                "limits": [float(chart.lower[i]), float(chart.upper[i])],
                "spread_limits": [float(chart.spread_lower[i]), float(chart.spread_upper[i])],
                "rules_broken": list(chart.broken[i]), "spread_out": bool(chart.spread_out[i]),
            }
            for i in range(len(chart.mean))
        ],
    }  # fmt: skip


def study_document(study: Study) -> dict[str, Any]:
    """`labcal-gage/1`."""
    figures = asdict(study.found)
    head = {"format": "labcal-gage/1", "quantity": study.quantity, "unit": study.unit}
    return {
        **head,
        "levels": dict(study.levels),
        "repeats": study.repeats,
        "simulated": study.simulated,
        **figures,
        "remarks": list(study.remarks),
    }


def trend_document(serial: str, found: Sequence[Trend]) -> dict[str, Any]:
    """`labcal-intervals/1`."""
    by = {method: {"days": days, "quantity": name} for method, (days, name) in shortest(found).items()}
    return {"format": "labcal-intervals/1", "serial": serial, "intervals": by, "figures": [_trend(t) for t in found]}


def _trend(trend: Trend) -> dict[str, Any]:
    line = trend.drift
    drifts = (
        {"why_not": line}
        if isinstance(line, str)
        else {"per_year": line.rate, "u": line.u_rate, "interval": list(line.interval), "scatter": line.scatter}
    )
    return {
        "quantity": trend.quantity,
        "unit": trend.unit,
        "days": trend.days.tolist(),
        "values": trend.values.tolist(),
        "u": [finite(one) for one in trend.u],
        "drift": drifts,
        "proposals": [asdict(one) for one in trend.proposals],
    }


def comparison_document(serial: str, found: Mapping[str, tuple[str, Intercomparison]]) -> dict[str, Any]:
    """`labcal-intercomparison/1`."""
    figures = [{"quantity": name, "unit": unit, **asdict(one)} for name, (unit, one) in found.items()]
    return {"format": "labcal-intercomparison/1", "serial": serial, "figures": figures}


def finite(value: Any) -> float | None:
    """The number; None where it is none."""
    return float(value) if isfinite(value) else None
