"""What the loop says of a run: verdict, reasons, findings, and how far it is."""

from PySide6.QtCore import QT_TRANSLATE_NOOP

REASONS = (  # of the verdict and of each candidate
    QT_TRANSLATE_NOOP("Data", "{0} to {1} nT held out (noise alone: {2} nT)"),
    QT_TRANSLATE_NOOP(
        "Data",
        "The base model reaches the noise beside what the run declares of its reference and mounting: {0}.",
    ),
    QT_TRANSLATE_NOOP("Data", "The base model reaches the noise: {0}."),
    QT_TRANSLATE_NOOP("Data", "{0} explains part of the residual, {1} % of its square above the noise: {2}."),
    QT_TRANSLATE_NOOP("Data", "{0} explain part of the residual, {1} % of its square above the noise: {2}."),
    QT_TRANSLATE_NOOP("Data", "{0} explains part of the residual: {1}."),
    QT_TRANSLATE_NOOP("Data", "{0} explain part of the residual: {1}."),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} explains the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers "
        "nothing is called explained.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} explain the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers "
        "nothing is called explained.",
    ),
    QT_TRANSLATE_NOOP("Data", "{0} explains the residual: {1}; but {2} does as well on this run."),
    QT_TRANSLATE_NOOP("Data", "{0} explain the residual: {1}; but {2} does as well on this run."),
    QT_TRANSLATE_NOOP("Data", "{0} explains the residual: {1}; but {2} do as well on this run."),
    QT_TRANSLATE_NOOP("Data", "{0} explain the residual: {1}; but {2} do as well on this run."),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} explains the residual beside what the run declares of its reference and mounting: {1}.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} explain the residual beside what the run declares of its reference and mounting: {1}.",
    ),
    QT_TRANSLATE_NOOP("Data", "{0} explains the residual: {1}."),
    QT_TRANSLATE_NOOP("Data", "{0} explain the residual: {1}."),
    QT_TRANSLATE_NOOP("Data", "There is structure that no known effect carries: {0}."),
    QT_TRANSLATE_NOOP("Data", "Beside the rows set aside there is structure that no known effect carries: {0}."),
    QT_TRANSLATE_NOOP(
        "Data",
        "This cause has no name: it is an empirical term, and holds only where it has been seen.",
    ),
    QT_TRANSLATE_NOOP("Data", "a function of {0}"),
    QT_TRANSLATE_NOOP("Data", "Rows set aside"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}, {2} row set aside as {3}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}, {2} rows set aside as {3}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}"),
    QT_TRANSLATE_NOOP("Data", "{0} row set aside as {1}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows ({1} %) set aside"),
    QT_TRANSLATE_NOOP("Data", "outliers"),
    QT_TRANSLATE_NOOP("Data", "saturation"),
    QT_TRANSLATE_NOOP("Data", "No effect was searched in such data."),
    QT_TRANSLATE_NOOP("Data", "with the others of {0} in, the held-out rms falls from {1} to {2} nT"),
    QT_TRANSLATE_NOOP("Data", "the held-out rms falls from {0} to {1} nT"),
    QT_TRANSLATE_NOOP(
        "Data", "with the others of {0} in, it alone takes {1} nT off the held-out rms beside declared errors"
    ),
    QT_TRANSLATE_NOOP("Data", "it alone takes {0} nT off the held-out rms beside declared errors"),
    QT_TRANSLATE_NOOP("Data", "evidence over a slow wander without a name: {0}"),
    QT_TRANSLATE_NOOP("Data", "{0} nats, {1} needed"),
    QT_TRANSLATE_NOOP("Data", "no better than chance or a slow wander: evidence {0}"),
    QT_TRANSLATE_NOOP("Data", "no better than chance or a slow wander"),
    QT_TRANSLATE_NOOP("Data", "too little evidence: {0}"),
    QT_TRANSLATE_NOOP("Data", "too little evidence"),
    QT_TRANSLATE_NOOP("Data", "takes {0} times the noise's square off the residual: not worth its parameters"),
    QT_TRANSLATE_NOOP(
        "Data",
        "takes {0} times the noise's square off the residual in sample, but other forms of what is accepted "
        "take as much",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "taken to first order ({0} to {1} nT held out), and given up: fitted in full, map and effects "
        "together leave {2} nT",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "taken ({0} to {1} nT held out), and given up: it would be more than half of the field, and the "
        "others would undo it",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "taken ({0} to {1} nT held out), and given up: it is no larger than its uncertainty, declared errors "
        "included; what is not there would seem as large in {2} % of runs",
    ),
    QT_TRANSLATE_NOOP("Data", "does as well as {0} in its place ({1} nT held out): a rival, neither is sure"),
    QT_TRANSLATE_NOOP(
        "Data",
        "taken, and given up on held-out blocks: {0} to {1} nT, a gain of {2} to {3} nT that may be none",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "taken, and given up on held-out blocks: {0} to {1} nT, but it is a detail beside others, or too much"
        " is left for its name to be sure",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "What is left is more than noise, though no single test (white in each segment, independent of every "
        "channel, of field, angle and time) finds of what shape.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "What is left shows no material structure: white in each segment, independent of every channel, of "
        "field, angle and time.",
    ),
    QT_TRANSLATE_NOOP("Data", "What is left: {0}"),
    QT_TRANSLATE_NOOP("Data", "{0} more tests fail"),
    QT_TRANSLATE_NOOP("Data", "follows itself from row to row, most in segment {0}"),
    QT_TRANSLATE_NOOP("Data", "goes with time (correlation {0})"),
    QT_TRANSLATE_NOOP("Data", "goes with {0} (correlation {1})"),
    QT_TRANSLATE_NOOP("Data", "comes again wherever the field is the same ({0} % of its square)"),
    QT_TRANSLATE_NOOP("Data", "the field along {0}"),
    QT_TRANSLATE_NOOP("Data", "the field's magnitude"),
    QT_TRANSLATE_NOOP("Data", "the angle's sine"),
    QT_TRANSLATE_NOOP("Data", "the angle's cosine"),
)
SHAPES = (  # of what is left
    QT_TRANSLATE_NOOP("Data", "a line with a period of {0} s, on {1}"),
    QT_TRANSLATE_NOOP("Data", "a step at t = {0} s, on {1}"),
    QT_TRANSLATE_NOOP(
        "Data",
        "two levels with {0} changes between them, each kept for about {1} s (telegraph-like), on {2}",
    ),
    QT_TRANSLATE_NOOP("Data", "a wander like a random walk, on {0}"),
    QT_TRANSLATE_NOOP("Data", "a wander that remembers itself for about {0} s, on {1}"),
    QT_TRANSLATE_NOOP("Data", "more noise than is stated, without memory from row to row, on {0}"),
    QT_TRANSLATE_NOOP("Data", "mostly in fields of {0} to {1} µT, mostly at angles of {2} to {3}°"),
    QT_TRANSLATE_NOOP("Data", "mostly in fields of {0} to {1} µT"),
    QT_TRANSLATE_NOOP("Data", "mostly at angles of {0} to {1}°"),
    QT_TRANSLATE_NOOP("Data", "the magnitude"),
    QT_TRANSLATE_NOOP("Data", "all axes"),
    QT_TRANSLATE_NOOP("Data", "axis {0}"),
    QT_TRANSLATE_NOOP("Data", "axes {0}"),
)
FINDINGS = (  # of the data and the rig
    QT_TRANSLATE_NOOP(
        "Data",
        "The selection ended without a set of effects that held-out data support whole; what its last round "
        "left stands.",
    ),
    QT_TRANSLATE_NOOP("Data", "k is the offset at {0}."),
    QT_TRANSLATE_NOOP(
        "Data",
        "In another recording {0} begins {1} nT astray (one standard deviation) until the field has wiped "
        "that out: the held-out error does not hold it, u_nT does.",
    ),
    QT_TRANSLATE_NOOP("Data", "{0}: what K and k take as well"),
    QT_TRANSLATE_NOOP("Data", "{0} in place of {1}: another map"),
    QT_TRANSLATE_NOOP("Data", "What is left is within what the run declares: {0}."),
    QT_TRANSLATE_NOOP("Data", "What is left has the shape of what the run declares, and is larger: {0}."),
    QT_TRANSLATE_NOOP("Data", "What is left {0}."),
    QT_TRANSLATE_NOOP("Data", "{0} nT held out, {1} beside it (noise alone: {2} nT)"),
    QT_TRANSLATE_NOOP("Data", "Likeliest: {0}."),
    QT_TRANSLATE_NOOP("Data", "Decided by other judgements than labcal's own: {0}."),
    QT_TRANSLATE_NOOP("Data", "Declared errors leave as much or more in {0} % of runs."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Declared errors leave as much or more in {0} % of runs: check these, or declare them as large as they are.",
    ),
    QT_TRANSLATE_NOOP("Data", "reference scale ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "reference zero ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "reference alignment ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "reference's temperature, scale ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "reference's temperature, zero ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "reference's drift since its certificate ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "coils' gradient over the distance ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "gradient over the distance ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "rotation axes in the cage ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "rotation axes in the body ({0}) {1} nT"),
    QT_TRANSLATE_NOOP("Data", "time ({0}) {1} nT"),
    QT_TRANSLATE_NOOP(
        "Data",
        "The noise, whose level is not stated, follows itself for about {0} s and goes with nothing that is "
        "recorded: {1} nT.",
    ),
    QT_TRANSLATE_NOOP("Data", "State the device's noise, measured at rest, to be sure."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The noise measured at rest is {0} times the declared one: the floor of {1} nT that results are "
        "compared with may be wrong.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "The noise measured from row to row is {0} times the declared one: the floor of {1} nT that results "
        "are compared with may be wrong.",
    ),
    QT_TRANSLATE_NOOP("Data", "Channels with {0}: {1}. They can show no cause."),
    QT_TRANSLATE_NOOP("Data", "no value in this run"),
    QT_TRANSLATE_NOOP("Data", "one value all through this run"),
    QT_TRANSLATE_NOOP("Data", "no value, nor a sure one between two others, in most rows"),
    QT_TRANSLATE_NOOP("Data", "Channels {0} and {1} are one signal: no fit tells which is the cause."),
    QT_TRANSLATE_NOOP("Data", "The correction {0} is uncertain by {1} nT at {2}: the run did not go there."),
    QT_TRANSLATE_NOOP("Data", "{0} in {1} µT along {2}"),
    QT_TRANSLATE_NOOP("Data", "{0} in {1} µT across the axes"),
    QT_TRANSLATE_NOOP("Data", "It is not written into the calibration."),
    QT_TRANSLATE_NOOP("Data", "Missing: large fields along every axis at both ends of {0}."),
    QT_TRANSLATE_NOOP("Data", "Missing: both ends of {0} for long enough."),
    QT_TRANSLATE_NOOP("Data", "Of {0}, {1} are, one by one, not pinned down by this run (value below U, k = 2)."),
    QT_TRANSLATE_NOOP("Data", "Of {0}, {1} is not pinned down by this run (value below U, k = 2)."),
    QT_TRANSLATE_NOOP("Data", "The reading along {0} is the same in every row."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The readings come to {0} nT, the reference to {1} nT: the unit or nominal_nT_per_unit of one of them"
        " is not as declared.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "This run does not determine the whole map ({0} alone): too few axes or fields are excited; a whole "
        "map would leave {1} instead of {2} nT, and be anyone's guess.",
    ),
    QT_TRANSLATE_NOOP("Data", "Turn about the other body axes too."),
    QT_TRANSLATE_NOOP(
        "Data",
        "The fitted map mirrors the axes ({0}): an axis of the device or of the reference is flipped or two "
        "are swapped.",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "The fitted map turns the axes ({0}): the mounting or the names of the axes are not as declared.",
    ),
    QT_TRANSLATE_NOOP("Data", "{0} is the device's {1}"),
    QT_TRANSLATE_NOOP(
        "Data",
        "The run fits far better {0}: the base model leaves {1} instead of {2} nT ({3} fits as well).",
    ),
    QT_TRANSLATE_NOOP("Data", "The run fits far better {0}: the base model leaves {1} instead of {2} nT."),
    QT_TRANSLATE_NOOP("Data", "with the reference taken in the body's frame, not the cage's"),
    QT_TRANSLATE_NOOP("Data", "with the reference taken in the cage's frame, not the body's"),
    QT_TRANSLATE_NOOP("Data", "with the platform's angle counted the other way"),
    QT_TRANSLATE_NOOP("Data", "with the platform's angle taken in radians, not degrees"),
    QT_TRANSLATE_NOOP("Data", "with the reference's {0} and {1} swapped and {2} flipped"),
    QT_TRANSLATE_NOOP("Data", "with the reference's {0} and {1} swapped"),
    QT_TRANSLATE_NOOP("Data", "with the reference's x, y, z read as {0} and {1} flipped"),
    QT_TRANSLATE_NOOP("Data", "with the reference's x, y, z read as {0}"),
    QT_TRANSLATE_NOOP("Data", "with the reference's {0} flipped"),
    QT_TRANSLATE_NOOP(
        "Data",
        "The clocks do not agree: {0}; put right, the base model leaves {1} instead of {2} nT.",
    ),
    QT_TRANSLATE_NOOP("Data", "the stamps of the device under test seem {0} s late"),
    QT_TRANSLATE_NOOP("Data", "the stamps of the device under test seem {0} s early"),
    QT_TRANSLATE_NOOP("Data", "the stamps of the reference seem {0} s late"),
    QT_TRANSLATE_NOOP("Data", "the stamps of the reference seem {0} s early"),
    QT_TRANSLATE_NOOP("Data", "the stamps of the platform's angle seem {0} s late"),
    QT_TRANSLATE_NOOP("Data", "the stamps of the platform's angle seem {0} s early"),
    QT_TRANSLATE_NOOP(
        "Data",
        "The readings do not follow the reference: the base model leaves {0} of {1} nT, and no flip or "
        "exchange of axes and no offset of a clock explains it.",
    ),
)
PROGRESS = (
    QT_TRANSLATE_NOOP("Data", "working the calibration out again: {0}"),
    QT_TRANSLATE_NOOP("Data", "fitting by {0}"),
    QT_TRANSLATE_NOOP("Data", "fitting the base model"),
    QT_TRANSLATE_NOOP("Data", "fitting the map with the effects that are named"),
    QT_TRANSLATE_NOOP("Data", "scoring every effect"),
    QT_TRANSLATE_NOOP("Data", "scoring {0} beside {1}"),
    QT_TRANSLATE_NOOP("Data", "scoring {0}"),
    QT_TRANSLATE_NOOP("Data", "every effect"),
    QT_TRANSLATE_NOOP("Data", "all candidates"),
    QT_TRANSLATE_NOOP("Data", "delay scan"),
    QT_TRANSLATE_NOOP("Data", "spectral lines"),
    QT_TRANSLATE_NOOP("Data", "pairs that hide each other"),
    QT_TRANSLATE_NOOP("Data", "the selection on each part of the blocks"),
    QT_TRANSLATE_NOOP("Data", "what does as well"),
    QT_TRANSLATE_NOOP("Data", "this run takes about {0} s more and may be stopped"),
    QT_TRANSLATE_NOOP("Data", "holding out blocks of time"),
    QT_TRANSLATE_NOOP("Data", "so far nothing has the evidence of a name"),
    QT_TRANSLATE_NOOP(
        "Data", "a cause is in sight, not proven yet: what is left over falls from {0} to {1} times the noise ({2})"
    ),
    QT_TRANSLATE_NOOP("Data", "stopped while {0}; {1}"),
    QT_TRANSLATE_NOOP("Data", "nothing is known yet"),
)
