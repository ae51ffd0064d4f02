"""Why an estimator gives no calibration and what to measure then; what a budget is made of."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

FITS = (
    QT_TRANSLATE_NOOP("Data", "turn the sensor about another body axis, or in a field of another magnitude"),
    QT_TRANSLATE_NOOP("Data", "the magnitudes do not determine all nine parameters: {0}"),
    QT_TRANSLATE_NOOP("Data", "the magnitudes do not determine all parameters: {0}"),
    QT_TRANSLATE_NOOP("Data", "I + E is not positive definite, so no real scale factors belong to it: {0}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows have both a reading and a reference magnitude; nine parameters need ten"),
    QT_TRANSLATE_NOOP("Data", "the field would be uncertain by {0} nT: {1}"),
    QT_TRANSLATE_NOOP("Data", "the field would be uncertain by {0} nT"),
    QT_TRANSLATE_NOOP(
        "Data",
        "Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {0}",
    ),
    QT_TRANSLATE_NOOP("Data", "the current {0} never changes, so its offset is part of the bias: leave it out"),
    QT_TRANSLATE_NOOP("Data", "the currents {0} are linearly dependent: leave one of them out"),
    QT_TRANSLATE_NOOP("Data", "run {0} has no channel {1}; it has {2}"),
    QT_TRANSLATE_NOOP("Data", "channel {0} is no current of the DUT, which is what `telemetry` takes"),
    QT_TRANSLATE_NOOP("Data", "the filter's covariance is no longer positive definite"),
    QT_TRANSLATE_NOOP(
        "Data",
        "the filter has diverged, or the sensor has changed: readings lie {0} times farther from what it expects "
        "than the noise of the first ones allows",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "the filter has diverged, or the sensor has changed: readings lie beyond all bounds farther from what it "
        "expects than the noise of the first ones allows",
    ),
    QT_TRANSLATE_NOOP("Data", "{0} readings with a magnitude; a start needs {1}"),
    QT_TRANSLATE_NOOP("Data", "the run is too short for {0} to begin"),
    QT_TRANSLATE_NOOP("Data", "the numbers broke down: {0}"),
    QT_TRANSLATE_NOOP("Data", "no row has both a reading and a reference"),
    QT_TRANSLATE_NOOP(
        "Data",
        "the run determines {0} of 12 parameters: 1 rotation axis in {1} segments; rotate about another body axis",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "the run determines {0} of 12 parameters: {1} rotation axes in {2} segments; rotate about another body axis",
    ),
    QT_TRANSLATE_NOOP("Data", "the run does not determine the parameters: the normal equations are singular"),
    QT_TRANSLATE_NOOP(
        "Data",
        "the run does not determine the parameters: {0}; add longer arcs, another axis or another magnitude",
    ),
    QT_TRANSLATE_NOOP("Data", "the likelihood has no clear summit"),
    QT_TRANSLATE_NOOP(
        "Data",
        "rotation segment {0} of {1} does not turn about its declared axis_body: at least {2} deg from it",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "there is no rotation segment that states its axis_body; rotate about known body axes",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "the magnitudes determine {0} of 9 parameters; rotate about another axis or use another magnitude",
    ),
    QT_TRANSLATE_NOOP("Data", "the run determines {0} of {1} parameters, not {2} and {3} more: {4}"),
    QT_TRANSLATE_NOOP(
        "Data", "the run determines only {0} combinations of the {1} parameters; open are {2} and {3} more: {4}"
    ),
    QT_TRANSLATE_NOOP("Data", "the run determines only {0} combinations of the {1} parameters; open are {2}: {3}"),
    QT_TRANSLATE_NOOP("Data", "the run determines {0} of {1} parameters, not {2}: {3}"),
    QT_TRANSLATE_NOOP("Data", "add a rotation about another body axis, or a field at another angle to the axis"),
    QT_TRANSLATE_NOOP("Data", "add a rotation about another body axis or a field of another magnitude"),
    QT_TRANSLATE_NOOP(
        "Data",
        "the readings lie close to one plane; turn the sensor about another body axis as well",
    ),
    QT_TRANSLATE_NOOP("Data", "quite another map fits as well"),
    QT_TRANSLATE_NOOP("Data", "its reference leaves the rotation of the map open"),
    QT_TRANSLATE_NOOP("Data", "there is no reference, so the scale is open: a field of known magnitude is needed"),
    QT_TRANSLATE_NOOP("Data", "{0} usable rows give {1} numbers; the map needs more than {2}"),
    QT_TRANSLATE_NOOP("Data", "the reference is zero throughout"),
    QT_TRANSLATE_NOOP("Data", "no map comes near these readings: they do not follow the reference at all"),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} never changes: nothing determines its scale; turn the sensor or look at the axis",
    ),
    QT_TRANSLATE_NOOP("Data", "the normal equations are not finite"),
    QT_TRANSLATE_NOOP("Data", "method {0} gives no calibration of run {1}: {2}"),
    QT_TRANSLATE_NOOP("Data", "run {0} has no reference: there is no residual to explain"),
    QT_TRANSLATE_NOOP("Data", "run {0} has {1} rows with a reading and a reference; {2} are needed"),
    QT_TRANSLATE_NOOP("Data", "run {0} does not even determine an offset: {1}"),
)
BUDGET = (  # of a calibration: sources of uncertainty, figures and where they hold
    QT_TRANSLATE_NOOP("Data", "noise of the run, through the fit"),
    QT_TRANSLATE_NOOP("Data", "noise of one reading"),
    QT_TRANSLATE_NOOP("Data", "structure that held-out residuals keep"),
    QT_TRANSLATE_NOOP("Data", "reference scale"),
    QT_TRANSLATE_NOOP("Data", "reference zero {0}"),
    QT_TRANSLATE_NOOP("Data", "reference zero"),
    QT_TRANSLATE_NOOP("Data", "reference alignment about {0}"),
    QT_TRANSLATE_NOOP("Data", "alignment about {0}"),
    QT_TRANSLATE_NOOP("Data", "rotation axes in the body about {0}"),
    QT_TRANSLATE_NOOP("Data", "rotation axes in the cage about {0}"),
    QT_TRANSLATE_NOOP("Data", "reference's temperature, scale"),
    QT_TRANSLATE_NOOP("Data", "reference's temperature, zero {0}"),
    QT_TRANSLATE_NOOP("Data", "reference's temperature, zero"),
    QT_TRANSLATE_NOOP("Data", "reference's drift since its certificate {0}"),
    QT_TRANSLATE_NOOP("Data", "reference's drift since its certificate"),
    QT_TRANSLATE_NOOP("Data", "coils' gradient over the distance {0}"),
    QT_TRANSLATE_NOOP("Data", "gradient over the distance {0}"),
    QT_TRANSLATE_NOOP("Data", "gradient over the distance"),
    QT_TRANSLATE_NOOP("Data", "time"),
    QT_TRANSLATE_NOOP("Data", "zero reading {0}"),
    QT_TRANSLATE_NOOP("Data", "off 90° {0}"),
    QT_TRANSLATE_NOOP("Data", "{0} µT along {1}, {2}"),
    QT_TRANSLATE_NOOP("Data", "{0} µT along {1}"),
)
