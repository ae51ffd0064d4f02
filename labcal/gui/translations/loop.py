"""What the loop says of a run: verdict, reasons, findings, what to measure next, and how far it is."""

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
        "Data", "This cause has no name: it is an empirical term, and holds only where it has been seen."
    ),
    QT_TRANSLATE_NOOP("Data", "a function of {0}"),
    QT_TRANSLATE_NOOP("Data", "Rows set aside"),
    QT_TRANSLATE_NOOP("Data", "{0} row set aside as {1}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}, {2} row set aside as {3}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}, {2} rows set aside as {3}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows set aside as {1}"),
    QT_TRANSLATE_NOOP("Data", "{0} rows ({1} %) set aside"),
    QT_TRANSLATE_NOOP("Data", "outliers"),
    QT_TRANSLATE_NOOP("Data", "saturation"),
    QT_TRANSLATE_NOOP("Data", "No effect was searched in such data."),
    QT_TRANSLATE_NOOP("Data", "with the others of {0} in, the held-out rms falls from {1} to {2} nT"),
    QT_TRANSLATE_NOOP("Data", "the held-out rms falls from {0} to {1} nT"),
    QT_TRANSLATE_NOOP("Data", "evidence over a slow wander without a name: {0}"),
    QT_TRANSLATE_NOOP("Data", "{0} nats, {1} needed"),
    QT_TRANSLATE_NOOP("Data", "no better than chance or a slow wander: evidence {0}"),
    QT_TRANSLATE_NOOP("Data", "too little evidence: {0}"),
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
    QT_TRANSLATE_NOOP("Data", "What is left {0}."),
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
    QT_TRANSLATE_NOOP("Data", "What is left is within what the run declares: {0}."),
    QT_TRANSLATE_NOOP("Data", "What is left has the shape of what the run declares, and is larger: {0}."),
    QT_TRANSLATE_NOOP("Data", "{0} nT held out, {1} beside it (noise alone: {2} nT)"),
    QT_TRANSLATE_NOOP("Data", "Likeliest: {0}."),
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
    QT_TRANSLATE_NOOP("Data", "The clocks do not agree: {0}; put right, the base model leaves {1} instead of {2} nT."),
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
NEXT = (  # what would tell, and why
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} do as well as each other on this run, and nothing that this lab's procedures do would separate "
        "them by {1} standard deviations",
    ),
    QT_TRANSLATE_NOOP(
        "Data",
        "{0} do as well as each other on this run; the experiment would bring them {1} standard deviations "
        "apart, as the fit predicts",
    ),
    QT_TRANSLATE_NOOP("Data", "structure remains that no known effect carries: {0}"),
    QT_TRANSLATE_NOOP(
        "Data",
        "what is left has the shape of errors that the run declares of its reference and mounting, and is larger",
    ),
    QT_TRANSLATE_NOOP(
        "Data", "compare the reference with a second one in two fields, mount the device anew, and repeat"
    ),
    QT_TRANSLATE_NOOP("Data", "more rows are set aside as outliers than a run may have that is called explained"),
    QT_TRANSLATE_NOOP("Data", "look at the link and its wiring, and repeat"),
    QT_TRANSLATE_NOOP("Data", "turn once forwards and once backwards: what stays at its angles belongs to the rig"),
    QT_TRANSLATE_NOOP("Data", "step the field up and down along each axis: what grows with the field shows its shape"),
    QT_TRANSLATE_NOOP("Data", "record at rest with the coils off, then switch what runs at that period off one by one"),
    QT_TRANSLATE_NOOP(
        "Data",
        "repeat the run unchanged and note what is switched: a step that does not come back was an event",
    ),
    QT_TRANSLATE_NOOP("Data", "switch every load and mode on and off at one attitude, and look for the two levels"),
    QT_TRANSLATE_NOOP("Data", "record for an hour at rest: a wander of the sensor goes on, one of the rig does not"),
    QT_TRANSLATE_NOOP("Data", "turn at half and at twice the rate: what belongs to angle or field comes again"),
    QT_TRANSLATE_NOOP("Data", "record at rest with the coils off: the noise that remains is the sensor's own"),
    QT_TRANSLATE_NOOP("Data", "repeat with another reference"),
    QT_TRANSLATE_NOOP("Data", "turn once forwards and once backwards in one mounting"),
    QT_TRANSLATE_NOOP("Data", "turn at half and at twice the rate, there and back, in one mounting"),
    QT_TRANSLATE_NOOP("Data", "repeat the run unchanged"),
    QT_TRANSLATE_NOOP("Data", "step the field up and down along one axis"),
    QT_TRANSLATE_NOOP("Data", "turn in two more coil fields, a third and twice as large"),
    QT_TRANSLATE_NOOP("Data", "switch every load on and off at one attitude"),
    QT_TRANSLATE_NOOP("Data", "warm the device and let it cool in two fields"),
    QT_TRANSLATE_NOOP("Data", "switch the power mode there and back at one attitude"),
    QT_TRANSLATE_NOOP("Data", "move the device by 5 cm and repeat the first turns"),
    QT_TRANSLATE_NOOP("Data", "turn the reference by 180° and repeat the first turns"),
    QT_TRANSLATE_NOOP("Data", "put the reference at twice its distance and repeat the first turns"),
    QT_TRANSLATE_NOOP("Data", "measure the bare platform's own field with the reference"),
    QT_TRANSLATE_NOOP("Data", "the run does not determine the whole map"),
    QT_TRANSLATE_NOOP("Data", "turn about all three body axes, in two fields at least"),
    QT_TRANSLATE_NOOP("Data", "an effect found in such data would be wrong"),
    QT_TRANSLATE_NOOP("Data", "put the bundle or the wiring right, and close the loop again"),
    QT_TRANSLATE_NOOP("Data", "the cause has no name yet. {0}"),
    QT_TRANSLATE_NOOP("Data", "Over {0} it is {1} about {2}: {3}."),
    QT_TRANSLATE_NOOP("Data", "Over {0} it is {1}: {2}."),
    QT_TRANSLATE_NOOP("Data", "Over {0} it is {1} about {2}: {3}"),
    QT_TRANSLATE_NOOP("Data", "Over {0} it is {1}: {2}"),
    QT_TRANSLATE_NOOP("Data", "It differs on the way back: something remembers, as iron and warm masses do."),
    QT_TRANSLATE_NOOP("Data", "It differs on the way back: something remembers, as iron and warm masses do"),
    QT_TRANSLATE_NOOP("Data", "straight"),
    QT_TRANSLATE_NOOP("Data", "quadratic"),
    QT_TRANSLATE_NOOP("Data", "saturating"),
    QT_TRANSLATE_NOOP("Data", "resonant"),
    QT_TRANSLATE_NOOP("Data", "a step"),
    QT_TRANSLATE_NOOP("Data", "wavy"),
    QT_TRANSLATE_NOOP("Data", "a bent curve"),
    QT_TRANSLATE_NOOP("Data", "a product"),
    QT_TRANSLATE_NOOP("Data", "a map"),
    QT_TRANSLATE_NOOP("Data", "a sensitivity to it that the library has no file for, or that follows another quantity"),
    QT_TRANSLATE_NOOP("Data", "heating by a current, a magnet's force, or a straight effect on both sides of a null"),
    QT_TRANSLATE_NOOP("Data", "a core or an amplifier at its limit, or a magnetic part that saturates"),
    QT_TRANSLATE_NOOP("Data", "a mechanical or electrical resonance, or a filter's edge, at that value"),
    QT_TRANSLATE_NOOP("Data", "a thermostat, a comparator or a changeover of range at that value"),
    QT_TRANSLATE_NOOP("Data", "interference, a converter's missing codes, or a beat with a clock"),
    QT_TRANSLATE_NOOP("Data", "a response of higher order; more range would show which"),
    QT_TRANSLATE_NOOP("Data", "a sensitivity to one that the other changes, as a gain that follows a temperature"),
    QT_TRANSLATE_NOOP("Data", "two causes that act together"),
    QT_TRANSLATE_NOOP("Data", "step the field up and down along each axis, through more than its range"),
    QT_TRANSLATE_NOOP("Data", "turn through many attitudes in one field, then in half of it"),
    QT_TRANSLATE_NOOP("Data", "turn at several rates, forwards and backwards"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude, warm the device and let it cool, over a wider range"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and step the current up and down through its range"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and move {0} up and down through more than its range, twice"),
    QT_TRANSLATE_NOOP("Data", "hold {0} and {1}; then the other way round"),
)
EXPERIMENTS = (  # of each effect
    QT_TRANSLATE_NOOP("Data", "mount the device turned by 180° about the platform axis and repeat"),
    QT_TRANSLATE_NOOP("Data", "repeat with the coils at zero, and with the reference turned by 180°"),
    QT_TRANSLATE_NOOP("Data", "hold the field along one axis and step it along another"),
    QT_TRANSLATE_NOOP("Data", "repeat with the reference at twice the distance"),
    QT_TRANSLATE_NOOP("Data", "hold all else and move its input up and down through its range, twice"),
    QT_TRANSLATE_NOOP(
        "Data",
        "turn the device by 90° on the platform and repeat: what the platform reads wrong stays at its angles",
    ),
    QT_TRANSLATE_NOOP("Data", "move the device by 5 cm and repeat one segment"),
    QT_TRANSLATE_NOOP("Data", "step the quantity that the channel measures in a large field and again in a small one"),
    QT_TRANSLATE_NOOP(
        "Data", "switch the device off and on, and repeat the segments before and after in the same field"
    ),
    QT_TRANSLATE_NOOP("Data", "warm the sensor in a large field and again in a small one"),
    QT_TRANSLATE_NOOP("Data", "step the field up and down through the same values, or turn backwards"),
    QT_TRANSLATE_NOOP("Data", "turn faster, and backwards: a lag grows with the rate and changes sign with it"),
    QT_TRANSLATE_NOOP("Data", "step the field along each axis through its whole range"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and step the quantity that the channel measures"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and switch the load that draws this current on and off"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and draw three or more levels of this current"),
    QT_TRANSLATE_NOOP("Data", "repeat the first segment at the end, and again after a pause"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and switch between the power modes"),
    QT_TRANSLATE_NOOP("Data", "repeat the segments before and after the step"),
    QT_TRANSLATE_NOOP("Data", "hold the attitude and warm the sensor, then let it cool"),
    QT_TRANSLATE_NOOP("Data", "record at rest, and again at another sampling rate: an alias moves"),
    QT_TRANSLATE_NOOP("Data", "compare the reference with a second one before and after"),
    QT_TRANSLATE_NOOP(
        "Data", "warm the room with the device kept as it is, and compare the reference with a second one"
    ),
    QT_TRANSLATE_NOOP("Data", "repeat the segment and look at the link"),
    QT_TRANSLATE_NOOP("Data", "repeat at half the field"),
    QT_TRANSLATE_NOOP("Data", "readings stop at the end of the range: {0}"),
)
PROGRESS = (
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
    QT_TRANSLATE_NOOP("Data", "so far {0}, not proven yet: {1} to {2} times the noise"),
    QT_TRANSLATE_NOOP("Data", "stopped while {0}; {1}"),
    QT_TRANSLATE_NOOP("Data", "nothing is known yet"),
)
