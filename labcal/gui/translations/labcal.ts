<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>AnswerForCard</name>
    <message>
        <source>Answer for this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It begins though the check standard is out of control. Name and reason stand in its record and in the audit log; with a key they are signed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who answers for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The person who lets this run begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why it may begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is known of the check standard: it was dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose key signs it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of this key; asked each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin this run; it is noted who answered for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no key: not signed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>AppState</name>
    <message>
        <source>A run goes on; open another bench after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening {0} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanned {0}; a run goes on, its DUT stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanned {0}; hands off: scan again once hands may go in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanned {0}: it is the DUT at the top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench first: yours, or the simulated lab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan or type the DUT&apos;s serial at the top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer first whether {0} is the DUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>your turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hands off, measuring</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ArchivedViewModel</name>
    <message>
        <source>The archive has not answered.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BenchEditor</name>
    <message>
        <source>Settings of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings of a bench file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a value as TOML has it: 2.5, true, [1.0, 2.0], text between quotation marks; an empty one takes the setting away. In brackets: what holds where nothing is stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What would change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with the file, and check what it says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write these lines into the file; all others stay as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the instruments; what was not saved is forgotten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} unless stated. {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (over several lines: change it in the file)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} changed, not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Not a bench file then: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ A bench file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BenchPage</name>
    <message>
        <source>Instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask every instrument who it is. Nothing is energised or moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go of every link, read the bench file again and ask every instrument who it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole lab without hardware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings of this bench file, limits first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask who answers on this computer&apos;s lines, and write a draft of a bench file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench file, or take the simulated lab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A draft of a bench file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking who answers on this computer&apos;s lines …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} answered: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} of {1} instruments answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All {0} instruments answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who answers for it says so on the terminal: labcal bench check {0} --clear-as NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments: after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all arrows to one scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as read last, not now; all arrows to one scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bench file (.toml): what stands in the lab, on which lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments; check them after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instruments of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, simulated: whichever DUT is typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ambient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;{0} here, outdoors: {1} ± {2} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;br&gt;at most {0} A a coil&lt;br&gt;at most {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CageView</name>
    <message>
        <source>The cage with its field vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, to look from another side</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CalibrationViews</name>
    <message>
        <source>What of the calibration is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As found, as left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In short</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Causes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No specification was stated for this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This DUT has no earlier calibration.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>No camera: OpenCV is not installed (pip install &apos;labcal[camera]&apos;).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No camera answers at {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera {0} gives no picture any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera has given no picture yet …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera has given no picture for {0:.0f} s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the camera: the DUT as it stands now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CausesTable</name>
    <message>
        <source>Off the held-out rms beside declared errors, by it alone; –: not worked out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether it is enough for a name; –: it is for another reason that it is not named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What files and commands call it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidates; choose one to see what it alone would change</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CertificatePage</name>
    <message>
        <source>Calibrations, the newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± U (k=2) is of the parameter in its line alone. That of a component of the field, its mounting included, is under Uncertainty; rms on the Fit and Loop pages is standard (k=1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a calibration, or say at the top which DUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The signed file is {0}, in the folder {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is handed out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its signatures are files beside it, {0}.sshsig: copy them into its folder, and verify it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checked at {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No calibration of {0} yet: a fit, and the trace of what it leaves, write a draft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator {0}; approved by {1}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Choose</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every setting as it was before anybody typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast simulated time passes: as in the lab, faster, or as fast as the computer goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks every instrument who it is, then begins. Nothing is energised before you are asked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rehearse this on the simulated lab: field, rate, angles, temperature, time, and what you are asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the rehearsal; nothing was begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Unfinished run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rehearsing on the simulated lab …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this measures is added to run {0}; then the cause is decided again, by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its settings are those that tell most there; the next run has the usual ones again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct what is red at the top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct what is red at the top, and what is marked ✕ above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A setting is not accepted: see above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be begun as it is set: the plan says why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the plan</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Client</name>
    <message>
        <source>The work was ended by this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CloseAtRest</name>
    <message>
        <source>Close the window?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lab is left as it is said here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the window closed the guardian keeps trying to bring every coil to zero; nobody sees whether it does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No guardian holds the supplies: COILS OFF is given once more on closing; nobody sees what becomes of it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>A run goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What is missing is measured later: Go on, on the Start page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What was measured is kept; this procedure cannot be gone on with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep running behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window goes out of sight, and comes back when you are needed or the run has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CoilsOff</name>
    <message>
        <source>Coils off: no bench is open, this window drives no coil.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coils off: reading them back …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking the zero: coils to zero, then what the reference sees …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has seen it stand yet: its line may be silent, or kept by another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press COILS OFF (F12): it stops the platform as well. Hands off until you see it stand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF does not reach it: stop it at its controller. Hands off until you see it stand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The platform kept turning: COILS OFF is given anew, and stops it …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer yet from: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By hand: at its panel, or at its mains switch.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ComparisonView</name>
    <message>
        <source>Runs without a calibration are fitted now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: two runs compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0}, calibration {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0}, fitted now (it has no calibration)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two runs compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the list of runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What of the two runs is drawn over each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residuals of the magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loci on the sphere, calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the residuals are drawn against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>band: the larger noise that the two fits make of their own residuals, k=2; none is stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>band: the larger of the two runs&apos; stated noises of |b|, k=2, as on the Fit page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reference, no residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faint: behind the sphere</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CoveredBar</name>
    <message>
        <source>How much of the circle the turn about this axis has seen, in sectors of 15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, this turn: {1} % of the circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} % of the circle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Data</name>
    <message>
        <source>coils at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero; {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT at zero by the reference: {0}. {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT at zero by the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils not read back in this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils on: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils on: {0}, read back {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform turns, at {0}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform stands at {0}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform stands at {0}°, read {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}; not watched since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}; not watched since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference has no ambient field to compare with yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still lost: {0}. Put that right first: a step begun now fails again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taking the coils to zero: ordered, not read back yet …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils read back at zero by their supplies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils may be on: a run goes on, and nothing was read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils may be on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils not read back since they were ordered off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform turns, at {0}°, read {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned, {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}, silent since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}, silent since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for a guardian that takes the order of zero …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a simulated lab the reference is not read at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s ambient field is from before hands were at the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference was moved since its ambient field was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils at zero, by their supplies and by the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference sees more change than a mounting makes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference has sent nothing since the currents settled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is not streaming</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is at its full scale and cannot vouch for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link to the reference is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference repeats one reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}, {1} s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference agreed when it was last looked at, {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it sees {0} nT, {1} nT expected: {2} µT apart, {3} µT allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} UTC, {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: open the output of {2} at its panel, or switch it off at its mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: switch off {2} at its mains (no command opens its output)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at {0} ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the outputs that can open, or switch the supplies off at their mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mount the DUT with body {0} up along the platform axis, body {1} towards the cage&apos;s {2}, at platform angle 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan the serial of the DUT as it is mounted now: this run is of {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: that is not the DUT of this run. Mount {1}, then scan its serial again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mount the DUT with body Z up, body X towards the cage&apos;s X; then {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it always stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned by 180° about its own {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned by 180° about its {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why is axis {0} redone? What was measured stays in the record, marked as not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why is {0} skipped?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is slow: rows wait {0} s in memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk takes what is recorded again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: body {1} is up, not {2}. Mount it again: this turn says nothing of {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the DUT to power mode {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the load {0} on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the load {0} off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor off at its plug.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor on again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort). No faster than {1} deg/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm the DUT within its limits, then let it cool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the DUT off the platform, some metres away. Leave the reference and all else as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the DUT away and put the reference at its place, on a stand that does not turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the reference at the {0}&apos;s place: {1} mm from the DUT&apos;s place, in C.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the reference at {0} mm from the DUT&apos;s place, in C, turned as it always stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the reference {0} mm above the DUT&apos;s place, on the platform axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the reference {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the scalar sensor into the cage&apos;s centre, its dead zones away from the fields.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap the two leads of the half of coil {0} that stands towards +{1}. They must come back before anything else is measured, also if this run is stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the two leads of the half of coil {0} that stands towards +{1} back as they were.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are all covers of the DUT as they will fly, and the others off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are the batteries those that will fly, and connected?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are all tools out of the cage?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are phones, keys and watches out of the room?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do chairs and trolleys stand at their marks?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file {0}. File of the photograph ({1}), or empty:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File of the photograph ({0}), or empty:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go up to {0} µT, then the field rotates. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played as {1} wants them. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT in all directions. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT in six directions. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The platform turns to {0}°. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to {0} µT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reference has confirmed it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the DUT still mounted with body {0} up, exactly as it was before the interruption?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT as the DUT warms and cools. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to {0} µT. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The platform turns to {0}°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT, the platform turns. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT and stays. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field goes to {0} µT, later with the DUT turning in it. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The field steps up to {0} µT. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go to {0} µT and the platform turns. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils go up to {0} µT and the platform turns. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coils step by {0} µT and the platform turns. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A square wave of {0} µT follows. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT in turn. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each coil alternates from {0} µT downwards. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coil {0} makes a gradient now, with the current of {1} µT. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every load is switched in turn, the others stay off. Hands off?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} of {1} figures changed by more than their uncertainty; the largest is E_n = {2} ({3}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No figure changed by more than its uncertainty; the largest is E_n = {0} ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the sensor changed cannot be said: a calibration states no uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offsets are not of the same state: as found {0}, as left {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offsets are those at {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at any state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of the two is simulated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the earlier corrects {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the later corrects {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number of this bench: they match {1} (dut.serial_pattern)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a label ends in {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a report ends in {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a run needs the serial number of its DUT: --dut SERIAL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} is of DUT {1}, the bench has {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} is of {1}, not of {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} was changed since run {1} began: start it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} cannot go on after an interruption: start it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: is signed already ({1}); only a draft can be approved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is signed: its serial stands; another DUT needs a run of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another person than the operator approves: --as NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aborted by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whoever ran this is gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window stood still for more than 4 seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only the session that drives this bench sets currents.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no reply in {1} s, {2} came.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is it switched on, and is the link in bench.toml the right one?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the link was lost ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the link was lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the link does not open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the link does not open ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}; where that is as it should be, accept = [&quot;{1}&quot;] in the mapping says so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: are axes swapped or turned about?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings fit the reference with axes {0} {1} times better than as stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: is the unit of one of them wrong, by a factor of {1}?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings of {0} nT in the median beside a reference of {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: write the mapping by hand; it has {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no three columns beside a clock look like a magnetometer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: letters and digits, and . : + # ( ) - or blanks between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, which have no \ .. or control characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, where a / parts folders; a bench whose serials have one says so (dut.serial_pattern)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: would lie among what is labcal&apos;s own; name another folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a label has a QR code: pip install &apos;labcal[paper]&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the operator&apos;s name must be one printable line of at most {0} letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{0}” is no name: letters, digits, blanks, and . , &apos; - _ @ + &amp; / ( ) between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} is none to be gone on with: it is {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: is no bench file: nothing that stands in it is of a bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} is not a key that is known here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}; nothing was made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the passphrase is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the passphrase has {0} characters and needs {1}: four words are easy to keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the passphrase is {0}: four words are easy to keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three signs over and over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of the key&apos;s own person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a common word alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row of the keyboard, or of the alphabet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the archive cannot be reached: {1}; nothing is lost: what is not there yet goes there with the next push</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: there is no archive here that this role can see: its owner makes it by `labcal archive init`</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: its catalogue is of version {1}, and this labcal works with {2}: its owner runs `labcal archive init` once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a newer labcal made its catalogue (version {1}, this one knows {2}): update labcal here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the archive needs SQLAlchemy, Alembic and psycopg: pip install &apos;labcal[archive]&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: bundles cannot be kept or read there: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the check standard {1} is out of control ({2}). No procedure begins on this bench: measure it again (--dut {3}), or let a person answer for it: --override NAME --because TEXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the check standard {0} is out of control ({1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No procedure begins on this bench: measure the check standard again, or let a person answer for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by the operator, to be gone on with later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is it switched on, are address and baud rate right, are A and B not swapped?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another process ({0}) keeps the platform&apos;s line and does not stop it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has answered at this link before: is its plug in at both ends, and has it power?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: this user may not open it ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: this user may not open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: another program has opened it ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: another program has opened it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the guardian did not start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a guardian holds the ports and does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the guardian has not answered for {0} s: it hangs, or was stopped; how the coils are is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is tried again and again; no run begins before it answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the supplies off by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero was ordered for all coils: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero was ordered{0}; what was being asked of this line was given up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See guardian.log; what was measured since then was measured without them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See guardian.log in labcal&apos;s data folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and nothing flows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and {2} A flows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the winding whole, does the voltage suffice? Set the coils off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square over {2} s, its limit is {3} A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the winding cool, then use less current or shorter times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: the contacts did not switch to {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the relay and its supply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the interlock is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It closes when every coil is read back at zero; `guardian.log` says which is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: its {1} protection tripped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a reading at full scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} samples came in {2} s, too few to say anything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at its power and its cable, or listen for longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the computer&apos;s clock was set back by {0} s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the clock right and start the run again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch {0} off by hand before anything else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero, open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VALID: signed by {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT VALID: {0} carries no signature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT VALID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was made from the run that was named.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was not made from the run that was named ({0} differs).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worked out again from its run, it is the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was not worked out again: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}. The signature stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROVISIONAL: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXPIRED: it was good until {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SUPERSEDED: by the calibration of run {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED: it describes no real sensor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no approver is named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named as approver, but is the operator: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named as approver, but has not signed: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>named as approver, but has not the role approve: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its operator, {0}, has not the role measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody but its operator has signed who has the role release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its numbers were not confirmed by its run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its run did not measure {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured by this run, and held as they stand: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unexplained by the closed loop: {0} nT are left of held-out rows, where noise alone leaves {1}; U takes that for random.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its run did not measure {0}: nobody can approve that; turn about the other body axes as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero, not open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the same reading for {1} s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no temperature for {1} s, and it has a limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} is {2} degC, its limit is {3} degC.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a field of {1} nT is seen, the limit is {2} nT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no samples came from {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it sent nothing at {1} of this turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: still not seen: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is its plug in at both ends, and has it power? Nobody can tell from here which it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the sensor off and on, and look at its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the ambient field what it was when it was measured last?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names, and is its link the right one?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug it in, see that nobody else has opened it, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names? Look at its cable, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at its panel, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for what holds it, home it and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the stage, home it and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: there is no key for {1} here; `labcal keys new --name {2}` makes one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: does not open: the passphrase is wrong or the file is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} has a key already; a second one would replace it (`labcal keys revoke {2}` where it is lost)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken off by its store: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken off: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No whole calibration can come of one body axis: it does not determine all 12 parameters of the map. It repeats or checks turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alternate each coil&apos;s current with falling amplitude, and compare the ambient field before and after.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the DUT at rest: the coils play directions all over; K and k in the cage&apos;s frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check sign, order and handedness of cage, reference and DUT, and the sense of the angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the reference&apos;s due date, its zero by 180° turns, and its magnitude against direction and a standard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find where DUT and reference stand, from the gradients of coil pairs with one half reversed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go through the checklist; every &quot;no&quot; is named at the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold a field by feedback on the reference, taken over from the open-loop set-point without a bump.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map the field of each coil over the working volume, computed and probed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure heading and magnitude error at independent positions; `calibration`, where it is stated, is judged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure mean, drift, noise and mains of the room, and say whether it is fit for the job.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure offset and gain against the DUT&apos;s temperature while it changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s offset from four attitudes in the ambient field, coils off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s permanent and induced dipole from what the reference sees of it at two distances.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix and offset at the DUT&apos;s place and at the reference&apos;s; a draft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix, its squareness and the ambient field by a scalar sensor in the centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the delay of DUT, reference and angle against the set-point and each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the platform&apos;s own field with the reference at the DUT&apos;s place, coils off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play a field history, with the tracking error recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat one rotation, with the coils off in between.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step the field along a body axis (or two together) and measure the departure from a straight line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch each load and measure the bias per ampere (3 × N) and its delay, coils off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole calibration before flight, from the zero to the closing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn once forwards and once backwards at one rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the DUT about one body axis in one steady field; one axis is not enough for a calibration by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn there and back at several rates in one mounting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[cage.geometry] with halves that a person can reverse; a vector reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector reference that can be moved, the coils&apos; geometry in bench.toml</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vector reference, first at the DUT&apos;s place, then at its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an absolute scalar sensor in the cage&apos;s centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing magnetic in the cage that must not be touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT as it will fly, and a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT at rest in the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a table of the field, an orbit, or a simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a vector reference at its place, or an approved cage calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT free to be turned over by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor, a vector reference that can be moved beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on the platform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on the platform, a vector reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on the platform, its calibration file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s own, that is judged; without one nothing is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on the platform, loads of the spacecraft that can be switched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT on the platform, remounted three times; a vector reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT with its thermometer, a means to warm it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bare fixture with the motor, a vector reference at the DUT&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cage as it will be used, coils off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference on the platform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Altitude km</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apart mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift nT per min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Due days</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Epoch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Homogeneity ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit Am2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnitudes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mains hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Misfit mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mountings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relay ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U cage ppm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U mounting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s power mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axis mounted along the platform axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field from the platform axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude of the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest departure that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of every turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded in each field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fields that no fit sees, at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how well the axis is mounted; 0: not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: as fast as timing and the range allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error that timing may make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: continuous, else stepped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils-off zero before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long to listen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the mains, looked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long to listen for it, at the fastest rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest amplitude of it that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the rotation that is planned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fastest drift that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest noise of one sample that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step of the field on each coil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the small turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far an axis may point beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest step of each coil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps of one sign, from zero to the largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest uncertainty of the matrix that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest change from bench.toml that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest difference of the polarities</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest departure from the line that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest difference of up and down that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>side of the square coils</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance of a pair, in sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the working volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points probed with the reference on each axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of each coil while probed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each point and sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probe against computed that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ask for a photograph of each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels to switch; none: every current channel of the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times each load is switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on, and off, each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first amplitude, within coil and DUT limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reversals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at each amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axes up, in turn: at least two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the reference above it: at least two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertainty of each coordinate of its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reversed between turns: the induced part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in each field at rest, with the DUT and without</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest moment that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total field x, y, z in C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long it is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the feedback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part of the error taken back each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>errors below this are left: the supplies&apos; own step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms error that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field, all over the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field, each in all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axis along the platform axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms error at those fields that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the zero through the run that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded in each attitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how well an attitude is met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axis along the platform axis and the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axis stepped together with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps of one sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of each coil with both halves alike</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from where the reference is stated that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the coils&apos; geometry that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded with the motor holding, and off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest signature that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV t_s,b_x,b_y,b_z [s, nT in C]; none: the orbit below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>udp://HOST:PORT: as a simulator sends it (docs/field-source.md)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the circular orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>start, ISO 8601 UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the satellite is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of orbit time, at most of a source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between two set-points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orbit seconds played in one second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that the source may be silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a field from the source, beside its quickest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms tracking error that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body axes, each mounted along the platform axis in turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field magnitudes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last magnitude also reversed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s power modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timing uncertainty, at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at a position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils-off zero, first and last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest closure that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how well an axis is mounted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each there and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>age of its calibration that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded in each attitude and field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field in six directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest zero that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest spread of the magnitude that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ambient magnitude by a standard; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the standard; 0: not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how truly it is turned by 180°; 0: not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the cage&apos;s field, by direction; 0: not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils off between two turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of both turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timing uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>full turns, there and back by turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of each coil alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field that rotates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field that rotates, at two moduli</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms error of the magnitude there that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>departure from square that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height of the wave; one ramp step at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps of the pseudo-random wave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length of a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned to and fro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>longest delay that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature channel of the DUT; empty: the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the platform axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times every field is visited</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each visit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fields and angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded at each position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between positions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms heading error that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms magnitude error that passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from {0} to {1}, or several with commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number from {0} to {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}, or several with commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text, or several with commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of {0}, or several with commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the sensor about another body axis, or in a field of another magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the magnitudes do not determine all nine parameters: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the magnitudes do not determine all parameters: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I + E is not positive definite, so no real scale factors belong to it: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} rows have both a reading and a reference magnitude; nine parameters need ten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current {0} never changes, so its offset is part of the bias: leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the currents {0} are linearly dependent: leave one of them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} has no channel {1}; it has {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel {0} is no current of the DUT, which is what `telemetry` takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the filter&apos;s covariance is no longer positive definite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie {0} times farther from what it expects than the noise of the first ones allows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie beyond all bounds farther from what it expects than the noise of the first ones allows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} readings with a magnitude; a start needs {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run is too short for {0} to begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the numbers broke down: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no row has both a reading and a reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: 1 rotation axis in {1} segments; rotate about another body axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: {1} rotation axes in {2} segments; rotate about another body axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run does not determine the parameters: the normal equations are singular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run does not determine the parameters: {0}; add longer arcs, another axis or another magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the likelihood has no clear summit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation segment {0} of {1} does not turn about its declared axis_body: at least {2} deg from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no rotation segment that states its axis_body; rotate about known body axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the magnitudes determine {0} of 9 parameters; rotate about another axis or use another magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2} and {3} more: {4}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2} and {3} more: {4}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2}: {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2}: {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add a rotation about another body axis, or a field at another angle to the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add a rotation about another body axis or a field of another magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings lie close to one plane; turn the sensor about another body axis as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quite another map fits as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its reference leaves the rotation of the map open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reference, so the scale is open: a field of known magnitude is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} usable rows give {1} numbers; the map needs more than {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is zero throughout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no map comes near these readings: they do not follow the reference at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} never changes: nothing determines its scale; turn the sensor or look at the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the normal equations are not finite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>method {0} gives no calibration of run {1}: {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} has no reference: there is no residual to explain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} has {1} rows with a reading and a reference; {2} are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} does not even determine an offset: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise of the run, through the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise of one reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>structure that held-out residuals keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference zero {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference alignment about {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alignment about {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation axes in the body about {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation axes in the cage about {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient over the distance {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient over the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero reading {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off 90° {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} µT along {1}, {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} µT along {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} to {1} nT held out (noise alone: {2} nT)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The base model reaches the noise beside what the run declares of its reference and mounting: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The base model reaches the noise: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains part of the residual: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain part of the residual: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} does as well on this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} does as well on this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} do as well on this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} do as well on this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is structure that no known effect carries: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside the rows set aside there is structure that no known effect carries: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This cause has no name: it is an empirical term, and holds only where it has been seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a function of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows set aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} row set aside as {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} row set aside as {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} rows set aside as {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} rows ({1} %) set aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outliers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No effect was searched in such data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the others of {0} in, the held-out rms falls from {1} to {2} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the held-out rms falls from {0} to {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the others of {0} in, it alone takes {1} nT off the held-out rms beside declared errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it alone takes {0} nT off the held-out rms beside declared errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evidence over a slow wander without a name: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} nats, {1} needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no better than chance or a slow wander: evidence {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little evidence: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual: not worth its parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual in sample, but other forms of what is accepted take as much</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken to first order ({0} to {1} nT held out), and given up: fitted in full, map and effects together leave {2} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it would be more than half of the field, and the others would undo it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it is no larger than its uncertainty, declared errors included; what is not there would seem as large in {2} % of runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does as well as {0} in its place ({1} nT held out): a rival, neither is sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, a gain of {2} to {3} nT that may be none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, but it is a detail beside others, or too much is left for its name to be sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left is more than noise, though no single test (white in each segment, independent of every channel, of field, angle and time) finds of what shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left shows no material structure: white in each segment, independent of every channel, of field, angle and time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} more tests fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>follows itself from row to row, most in segment {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes with time (correlation {0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes with {0} (correlation {1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comes again wherever the field is the same ({0} % of its square)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field along {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field&apos;s magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the angle&apos;s sine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the angle&apos;s cosine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line with a period of {0} s, on {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a step at t = {0} s, on {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two levels with {0} changes between them, each kept for about {1} s (telegraph-like), on {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a wander like a random walk, on {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a wander that remembers itself for about {0} s, on {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more noise than is stated, without memory from row to row, on {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT, mostly at angles of {2} to {3}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mostly at angles of {0} to {1}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axes {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selection ended without a set of effects that held-out data support whole; what its last round left stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k is the offset at {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In another recording {0} begins {1} nT astray (one standard deviation) until the field has wiped that out: the held-out error does not hold it, u_nT does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: what K and k take as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} in place of {1}: another map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left is within what the run declares: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left has the shape of what the run declares, and is larger: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} nT held out, {1} beside it (noise alone: {2} nT)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Likeliest: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decided by other judgements than labcal&apos;s own: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs: check these, or declare them as large as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference scale ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference zero ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference alignment ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient over the distance ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation axes in the cage ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation axes in the body ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time ({0}) {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise, whose level is not stated, follows itself for about {0} s and goes with nothing that is recorded: {1} nT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State the device&apos;s noise, measured at rest, to be sure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise measured at rest is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise measured from row to row is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels with {0}: {1}. They can show no cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value in this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one value all through this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no value, nor a sure one between two others, in most rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels {0} and {1} are one signal: no fit tells which is the cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The correction {0} is uncertain by {1} nT at {2}: the run did not go there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} in {1} µT along {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} in {1} µT across the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not written into the calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing: large fields along every axis at both ends of {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing: both ends of {0} for long enough.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of {0}, {1} are, one by one, not pinned down by this run (value below U, k = 2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of {0}, {1} is not pinned down by this run (value below U, k = 2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reading along {0} is the same in every row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings come to {0} nT, the reference to {1} nT: the unit or nominal_nT_per_unit of one of them is not as declared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run does not determine the whole map ({0} alone): too few axes or fields are excited; a whole map would leave {1} instead of {2} nT, and be anyone&apos;s guess.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn about the other body axes too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fitted map mirrors the axes ({0}): an axis of the device or of the reference is flipped or two are swapped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fitted map turns the axes ({0}): the mounting or the names of the axes are not as declared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is the device&apos;s {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT ({3} fits as well).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference taken in the body&apos;s frame, not the cage&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference taken in the cage&apos;s frame, not the body&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the platform&apos;s angle counted the other way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the platform&apos;s angle taken in radians, not degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped and {2} flipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0} and {1} flipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} flipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clocks do not agree: {0}; put right, the base model leaves {1} instead of {2} nT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings do not follow the reference: the base model leaves {0} of {1} nT, and no flip or exchange of axes and no offset of a clock explains it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>working the calibration out again: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitting by {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run, and nothing that this lab&apos;s procedures do would separate them by {1} standard deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run; the experiment would bring them {1} standard deviations apart, as the fit predicts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>structure remains that no known effect carries: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is left has the shape of errors that the run declares of its reference and mounting, and is larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compare the reference with a second one in two fields, mount the device anew, and repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more rows are set aside as outliers than a run may have that is called explained</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at the link and its wiring, and repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn once forwards and once backwards: what stays at its angles belongs to the rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the field up and down along each axis: what grows with the field shows its shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>record at rest with the coils off, then switch what runs at that period off one by one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat the run unchanged and note what is switched: a step that does not come back was an event</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch every load and mode on and off at one attitude, and look for the two levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>record for an hour at rest: a wander of the sensor goes on, one of the rig does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn at half and at twice the rate: what belongs to angle or field comes again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>record at rest with the coils off: the noise that remains is the sensor&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat with another reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn once forwards and once backwards in one mounting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn at half and at twice the rate, there and back, in one mounting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat the run unchanged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the field up and down along one axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn in two more coil fields, a third and twice as large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch every load on and off at one attitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warm the device and let it cool in two fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the power mode there and back at one attitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat the first turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the reference by 180° and repeat the first turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put the reference at twice its distance and repeat the first turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measure the bare platform&apos;s own field with the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run does not determine the whole map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn about all three body axes, in two fields at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an effect found in such data would be wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put the bundle or the wiring right, and close the loop again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cause has no name yet. {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resonant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wavy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a bent curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a product</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensitivity to it that the library has no file for, or that follows another quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heating by a current, a magnet&apos;s force, or a straight effect on both sides of a null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a core or an amplifier at its limit, or a magnetic part that saturates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a mechanical or electrical resonance, or a filter&apos;s edge, at that value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thermostat, a comparator or a changeover of range at that value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interference, a converter&apos;s missing codes, or a beat with a clock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a response of higher order; more range would show which</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sensitivity to one that the other changes, as a gain that follows a temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two causes that act together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the field up and down along each axis, through more than its range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn through many attitudes in one field, then in half of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn at several rates, forwards and backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude, warm the device and let it cool, over a wider range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and step the current up and down through its range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and move {0} up and down through more than its range, twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold {0} and {1}; then the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mount the device turned by 180° about the platform axis and repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat with the coils at zero, and with the reference turned by 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the field along one axis and step it along another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat with the reference at twice the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold all else and move its input up and down through its range, twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the device by 90° on the platform and repeat: what the platform reads wrong stays at its angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat one segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the quantity that the channel measures in a large field and again in a small one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch the device off and on, and repeat the segments before and after in the same field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warm the sensor in a large field and again in a small one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the field up and down through the same values, or turn backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn faster, and backwards: a lag grows with the rate and changes sign with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step the field along each axis through its whole range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and step the quantity that the channel measures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and switch the load that draws this current on and off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and draw three or more levels of this current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat the first segment at the end, and again after a pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and switch between the power modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat the segments before and after the step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold the attitude and warm the sensor, then let it cool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>record at rest, and again at another sampling rate: an alias moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compare the reference with a second one before and after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warm the room with the device kept as it is, and compare the reference with a second one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat the segment and look at the link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat at half the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings stop at the end of the range: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitting the base model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitting the map with the effects that are named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scoring every effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scoring {0} beside {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scoring {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every effect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delay scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spectral lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pairs that hide each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the selection on each part of the blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what does as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this run takes about {0} s more and may be stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holding out blocks of time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so far nothing has the evidence of a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cause is in sight, not proven yet: what is left over falls from {0} to {1} times the noise ({2})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped while {0}; {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is known yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offsets so far: not yet determined by the turns made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offsets so far, from magnitudes alone: {0} nT (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offsets so far: the quick estimate of this procedure, from magnitudes alone, does not follow these readings; verdict and Fit do not rest on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offsets so far: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axes, handedness and angle are as stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the angle runs the wrong way round: turn angle_sign in bench.toml</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a turn by {0}° is seen by the DUT as {1}°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis shows {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis points {1}° beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s axes are left-handed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis shows {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis points {1}° beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s axes are left-handed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} nT, within which the zero lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} nT is beyond {2} nT; something moved or drifted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} is beyond its limit of {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: not seen: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}. Measure it as {3} all the same?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}: nothing was measured. Say which DUT it is, and begin anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} names itself {1}, and bench.toml states {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} skipped: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not used: {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it answers again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now; ambient field {2} nT before, {3} nT now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after the silence: ambient field {0} nT before, {1} nT now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the run waits: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run ends: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes on after an interruption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no turn was finished before the interruption: it begins anew, and nothing of before is used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns kept from before the interruption: {0}; the zero, the axes and the timing are measured again: they tell whether anything moved or drifted since</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0} came to zero without a ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the room is fit for the job</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the room is not fit for the job: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT above what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT below what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iron near by, or the reference&apos;s unit and scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of {0} no field is expected: WMM is here from {1} to {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Hz is not distinguishable from {1} at {2}/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a steady field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Hz is seen as a steady field at {1} {2} samples/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Hz falls on the rotation at {1} {2} samples/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s calibration of {0} is {1} days old, beyond {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not covered by the uncertainties, because it is not stated: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not covered by the uncertainty of the tracking error: the reference&apos;s own errors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For cage and surroundings; this is no deperm of a spacecraft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>departure from the centre, each coil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draft: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bias per ampere, one column a load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moment m = p + X b of the DUT, in its body axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ambient field as tracked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K and k in the cage&apos;s frame, k in the middle of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too few directions for harmonics: what K and k do not hold is not reported by degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field is the reference&apos;s, measured at the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field is that of the calibrated cage, its ambient part followed by the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset from four attitudes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field and reading along the direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the places are as if the halves towards − had been reversed, or position_m has another sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field number {0} stands {1} s after it came</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}; {1} fields set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No heading is judged: of the field the reference tells the magnitude alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the reference, because the run does not state it: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the reference, because the run states it as 0: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame as mounted; mounting uncertainty not included.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The direction of the platform&apos;s axis in the cage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the supplies&apos; read-back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the supplies&apos; currents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the reference was put</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the sensor was put</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s turn against the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference&apos;s own linearity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the direction of the platform&apos;s axis in the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT&apos;s mounting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the half turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the platform&apos;s angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alignment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>own calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x along coil x: matrix_nT_per_A = {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} needs a vector reference and three numbers, --set field_nT=0,0,30000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} needs a vector reference; for a scalar one see {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} needs a scalar reference ([reference] kind); for a vector one see {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference stands elsewhere: {0} needs [cage] calibration, from {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} needs a vector reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} needs a platform with a motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} must be at least two, and different</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT has no current channel {0}; it has {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT has no temperature channel {0}; it has {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>configuration: {0} not as stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the coils have moved the field by {1} nT and the reading not at all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no field stood for as long as one sample of the reference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} takes a file or a source, not both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locate needs the coils&apos; geometry: state [cage.geometry] size_m, and in halves the coils of which one half can be reversed at its terminals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no coil&apos;s halves can be reversed ([cage.geometry] halves): near its middle the field of a pair does not change with the place to first order, and tells none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no half was reversed: the field of a pair as it should be is flat at its middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sensor does not see three coils in three directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the sensor sees fits no place inside the coils: are the halves reversed as asked?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the currents do not span all three coils: step each coil at two currents at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these turns do not determine all of the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these fields do not determine K, k and drift: they lie in a plane, or follow the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} fields are too few: K, k and drift need {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these currents do not determine the coils: each alone in both signs, and every two together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the magnitudes are those of no three coils: does the sensor follow the currents?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these currents do not determine coils and ambient field: turn the field all round, in two sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} magnitudes are too few: coils, ambient field and its course need {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two rows at least are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time does not go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is no finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this column is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is no regular file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>epoch = {0}: expected ISO 8601, as 2026-01-01T00:00:00</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run has no channel {0}, which {1} rests on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this run has nothing to show of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cage calibration file, from the folder of bench.toml</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a table, or a file: labcal.bench.specification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a ramp, before the field is believed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after each mounting its serial is asked for, and no other is taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after it no procedure begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it came in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it states it, with k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the cage: its number here, or an address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at which it holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns are the coil axes in C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the sensor&apos;s axes, subtracted first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude with the coils at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a whole serial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of it while it was measured, peak to peak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of its locks and sockets; /run/labcal-GROUP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of one axis of one sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the computer&apos;s users</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the difference of what the two halves of a pair make, relative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the field at the centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the windings, where a channel tells it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of what the coils make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>planetary index of those hours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>root mean square over `rms_window_s`: what the wire bears for ever</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is known of it and not corrected; each with its own uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the coils at zero, of any component along any direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the same reading so long, it is stuck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without a sample so long, it is silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|angle| that the cables bear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nT a unit of the reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nT a year</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest field at the DUT {0} µT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the platform&apos;s limit is {3} °/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the DUT&apos;s limit in bench.toml is {3} °/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what a person is asked, {0}× in all:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT {0} axis: angle off its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference {0} axis: angle off its direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mounting and zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ambient field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field downwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field upwards again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} m, DUT away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} m, {1} up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>covers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>batteries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the platform rests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axes-check: {0}. Mount it again where it is not mounted as asked; else look at its axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT kept within {0} to {1} °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no temperature limits are stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {0} min, without a person&apos;s steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: missing sectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: wrong signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delay {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closure {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closure, {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closing: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero since the interruption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT less reference, coils off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT less reference, first position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT less reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn seen by the DUT, less turn made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT behind the set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference behind the set-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT behind the angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise density {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>amplitude of {0} Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude by {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Hz in reference samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Hz in dut samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: uncertainty of the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: settling time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: departure from the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: up less down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>departure from the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up less down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computed departure in the volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probe less computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: bias {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the ambient field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>permanent moment {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>induced moment {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest induced moment in {0} µT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms error while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open-loop error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift of the zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} µT, degree {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verify: rms error with bench.toml&apos;s matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verify: rms error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verify: largest error in units of U by noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms tracking error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter of the latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter of the source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>departure from a straight line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference from DUT: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less what is stated: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: field at the reference over that at the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>once a turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turning less holding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holding less off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude against direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnitude less the standard&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>age of its calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>components against constant modulus, largest E_n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constant {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} from square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ambient {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current at zero {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} at {1} µT per {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms heading error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms magnitude error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: polarity + less −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT: change from bench.toml</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axes-check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sync-check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closure-{0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep at the DUT&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep at the reference&apos;s place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}-on-{1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}-off-{1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}-on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wait for the source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half-{0}-reversed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half-{0}-back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as they should be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motor off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero by half turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>six directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constant modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no better than chance or a slow wander</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, then check the zero again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then check the zero again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the supplies state {0} A, and the reference does not see that: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does every supply obey, are signs and constants right, was something magnetic moved? axes-check tells which coil it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has its output gone off by itself, is the winding open? Set the coils off, look at its panel, and find out why before it is cleared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a field of {0} nT is beyond the limit of {1}, {2} nT; nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A would take {2} s to ramp down, more than {3} s; lower current_A or raise ramp_A_per_s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, at {1}: {2}. Nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, then measure again: `labcal bench check FILE` lifts this where reference and supplies agree, with --clear-as NAME where a person answers for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows after zero was set; the contacts were not moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: after its contacts were set, a step of {1} A was seen by the reference as {2} A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for a contact that hangs or is welded, then run axes-check.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square would soon be reached, its limit is {2} A; nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows {2} s after zero was set (zero is below {3} A).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch {0} off by hand, then look at its panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See that it sends, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it stopped {1}° from its target of {2}°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it homes at {1} deg/s, the DUT&apos;s limit is {2} deg/s; nothing was moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower the homing speed on the stage itself, or take the DUT off and home it with its own program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} answers, before it was {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the instruments in as bench.toml says, and begin again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: its name came damaged ({1}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} answers here and as {2}: the same instrument answers on both links.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the links in bench.toml, then begin again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} was set to {2} and reads back {3}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the instrument&apos;s panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} came back as {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the guardian is gone ({1}); how the coils are is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say `labcal bench off`, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another user&apos;s process answers as the guardian of this bench; it is not believed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guardian.log names its process: end it, then say off again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: the guardian before is gone; it had ordered zero and reported no read-back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: zero has not been read back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: a step of {1} A is beyond the {2} A that its ramp of {3} A/s allows now; nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows; its output is not opened under current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ramp it to zero first; or `labcal bench off`.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it did not answer in the time that there is on the way to zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} How the coils are is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} A was not sent: this coil was ordered to zero, and {1} A is the most that it may still hear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: its output was not closed: this coil was ordered to zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a field of {0} nT of the coils alone is beyond the limit of {1} nT, Earth&apos;s {2} nT taken off; nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cage&apos;s calibration is not there: no field is set by it; nothing was set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not reached: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} failed ({2}); its port is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} was sent and {2} came back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do two talk on this line at once? Without an adapter that echoes, take echo=1 out of the link.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it babbles: more than {1} KiB came without an end, beginning with {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is it the instrument that bench.toml names? Pull its cable and plug it in again, or switch it off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} registers came where {2} were asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no valid Modbus reply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: does not answer as it should.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not answer as it should.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: the reply belongs to another request.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: a program of user {1} is connected to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask user {0} to end it, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End that program, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End it, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it comes again, look at its cable and its adapter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>returned no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its other end has hung up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1}° is beyond the ±{2}° of the cables; nothing was sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: another process has this port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the dial&apos;s reading is entered after each turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} deg/s is too fast: DUT and platform allow {1} deg/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} deg/s is beyond the DUT&apos;s limit of {1} deg/s; nothing was moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the system gives this process no more ({0}); how the coils are is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the supplies off by hand, or say off again in a new terminal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field source has sent no new field for {0} s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} was {1} when run {2} began, now it is {3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run {0} was begun on another bench: a real, a simulated and a served one are not the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bench holds {0}, the run is of {1}: nothing was moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taking to zero from here what no guardian holds: not read back yet …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before that: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked this time; {0} s ago: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT confirmed at zero: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero of coil {0} is not confirmed, and tried again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>supplies and reference agree again, {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the connection to the guardian was lost; {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last read before that (UTC): {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no current was read through it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a guardian holds the ports and hangs, or was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Have it ended, then say off again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the file and say off again, or switch this supply off by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open the output of {0} at its panel, or switch it off at its mains</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switch off {0} at its mains (no command opens its output)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the DUT come back into its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the windings cool, then use less current.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it sends again, after {1} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: it answers again, {1} s after its loss was noticed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}; every row is kept by now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, kept by the store {1} s later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}; {1} cannot be gone on with: start it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what was not committed is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it held is lost where there is no copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} s ago: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the guardian failed at {0}: {1}: {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the connection to {0} was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>session {0} orders it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>labcal bench off, process {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil {0}: zero was ordered for all coils: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero was ordered; what was being asked of this line was given up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work was ended by this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>labcal itself made a mistake here; the details hold what it says of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no run goes on here that could be come back to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the rotation axis is not where it was declared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something at the cage or the table adds a field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reading along one axis changes with the field across it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference sees the DUT&apos;s own magnetism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset follows what was recorded, for no known cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the platform reads its angle wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the DUT is off the cage&apos;s centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the gain changes with a recorded channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the gain jumps at one moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the gain changes with temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>magnetic parts remember earlier fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings come later than the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reading is not proportional to the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset changes with a recorded channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset changes with a current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset changes with the square of a current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset drifts with time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset differs between power modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset jumps at one moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the offset changes with temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a periodic disturbance lies on the readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference drifts with time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference changes with temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single readings lie far off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>readings are at the end of their range</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Drop</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen calibration alone again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a calibration .json with its .sshsig beside it, or drop it on the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify a calibration</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EarlierCard</name>
    <message>
        <source>They are gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Supplies of an earlier session do not answer: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If one of them stands somewhere still, switch it off by hand, then press COILS OFF (F12).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where they were taken away, or a simulated lab was served anew, say so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Supplies of an earlier session are not at zero: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is at their links any more: they are asked for no more, and the audit log has your name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EarlierSupplies</name>
    <message>
        <source>a supply of an earlier session is not at zero: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: gone, says {1}; it is kept in the audit log</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FaultCard</name>
    <message>
        <source>Whether hands may go in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what labcal itself says about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a problem report …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A .zip with the details, settings and versions, no keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the zero now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coils to zero, then what the reference sees; nothing is energised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put this card away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For who mends labcal; a problem report holds it:</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FitPage</name>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate by maximum likelihood, the default method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate by every method, to see whether they agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a draft calibration from the selected method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find what causes what is left over: the Loop page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the fit is good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each of them says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See what was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit finds what turns a reading into field: the gains K and the offset k of the sensor. All methods compares eleven ways.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>b = K m − k: the field b [nT] of the reading m. K are nine gains, a row for each axis of the field; k is the offset [nT].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a run above, then Fit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value ± U, k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a column to see its pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computing: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures and the figures of each method are not kept: Fit works them out again, side by side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first method takes some seconds.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FitViews</name>
    <message>
        <source>The figures of the papers that the methods are from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the residual is drawn against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|b|  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bias of the reading  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degree of spherical harmonics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms of the residual  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loci on the sphere (Riwanto 2017, figs. 5, 7)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual of the magnitude (Crassidis 2003, fig. 3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magnitude and reference (Springmann 2011, figs. 2, 4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram of the residual (Springmann 2011, fig. 7)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bias and 3σ as readings come (Crassidis 2003, figs. 1, 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual on the sphere, by degree (Risbo 2003)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grey: as read   strong: calibrated   faint: behind the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ekf, or the filter that is chosen above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines: what scatter alone gives   2: products of two components   3: a cubic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>band: the noise that this method makes of its own residual, k=2; none is stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>band: the stated noise of |b|, k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line: the noise that this method makes of its own residual; none is stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line: the stated noise of |b|</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Frame</name>
    <message>
        <source>What is next for this DUT, whichever page is open (Ctrl+N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next has just changed, and did nothing. It is now: {0}. Press it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (Ctrl+{1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the page {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys   F1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which keys there are, and what each does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark or light; until then as the system has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters to be read from two metres, and back (F11)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until somebody logs in; COILS OFF works all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two tones where you are needed, three where it is done; or neither</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window in this language; not while a run goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coils off, at any moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held for {0} s: the answer on the button of this key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the next field or button; Shift and Tab goes back, Space presses a button or picks a row, but no answer that mounts, energises or moves: its own key is held</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>GoingDown</name>
    <message>
        <source>Closing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Going to zero; the window closes after that …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run ends, and the window does not close (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HANDS OFF: not at zero yet. The window does not close by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run has ended; the window closes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: DUT, day …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several words narrow it down: EM-07 yesterday explained; or 22.11.2026</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at this run on the Fit page; nothing recorded is ever changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As bundle, CSV, HDF5 or MATLAB file; of several runs a bundle each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct serial …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DUT was another one: an event of the record, until a calibration of the run is signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run bundle (.zip) or a recording of others; or drop the file on the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose two runs (Ctrl and a click): their figures, residuals and loci</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No such run. A run from the Run page, or an imported bundle, comes up here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} UTC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bundle as it was pushed (.zip): import it on this computer to open it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of this computer, or those of all benches in the archive, which are only looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the runs are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive was not read. {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking the archive …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive has no such run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the serial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial of the DUT of run {0}:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run {0}: DUT {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing {0} with {1} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bundle of each chosen run, into this folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is there already; nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run bundles (*.zip)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings of others (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HoldButton</name>
    <message>
        <source>▲ Let go of {0}: it was down before this question came. Then hold it for 0.7 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ {0} was pressed before this question took an answer. Press it anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold {1} for 0.7 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Let go too early: the mouse has left the button. Hold {1} for 0.7 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold this button, or {1}, for 0.7 s.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While this sheet is open no key answers a question; COILS OFF (F12) works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put this sheet away (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabWatch</name>
    <message>
        <source>the guardian of the last session has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still at work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on and reads the instruments itself; the DUT is read again in its next step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading every instrument; nothing is set …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} of {1} instruments were read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the guardian of the last session has {0} until {1} is read back at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; another process has {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LazyPage</name>
    <message>
        <source>This page is being made ready …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All other pages work. Mend the package that brings this page, or uninstall it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message>
        <source>Show the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LeftWithoutEnd</name>
    <message>
        <source>Another process still drives a run of {0} on this bench: wait until it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Live</name>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pausing …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait where the next step begins, with the coils at zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End this run now, in order. The coils go to zero; what was measured is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is missing of this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured is kept in the History. To measure again: Close, then Begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here that is Go on: what was finished is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run has ended: Close, then Begin measures anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the procedures; the run is in the History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose run this is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate the calibration from this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it was mounted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Or Close, and begin anew.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LockScreen</name>
    <message>
        <source>Who works here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your name in the trust list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name, or scan your badge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your name stands in the record from here on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF (F12) works all the same. A name says who is meant; signing still asks for your key.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LoginViewModel</name>
    <message>
        <source>Nobody of the trust list has the name {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log in first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has not the role measure in the trust list.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Logo</name>
    <message>
        <source>The laboratory&apos;s logo</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LoopPage</name>
    <message>
        <source>Choose a run above, then let its residual be traced to a cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find what causes what is left over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The draft with the accepted effects: approve and sign it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1  What is left over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These figures are beside the errors that the run declares; above they are in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{0}” explains it about as well as “{1}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure what would tell them apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to it: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the residual is drawn against; the named cause first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run is of {0}; the DUT at the top is {1}. Put {0} on the bench, and scan it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The loop&apos;s own words: held-out rms, tests, rows set aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band: the noise of one axis of one row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No cause was searched for: 4 says why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3  What could cause it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside declared errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2  What it changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4  Still not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its plan is shown on the Run page before anything moves, and the run is started there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work it out again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking at the residual; a whole preflight takes some minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the residual of this run to its cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures and the figures of each cause are not kept: “Work it out again” makes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>or {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows set aside: {0} {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2  With “{0}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured by the procedure {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that this run could show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure what is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one to see what it alone would change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computing …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it alone would leave {0} nT of the rows of the fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Mounting</name>
    <message>
        <source>Drawing: body {0} up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing of a dial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn for platform angle 0°; where it stands is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform at {0}°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NamedSerials</name>
    <message>
        <source>{0}: is this the right sensor?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names itself {0}, not {1}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NamesCard</name>
    <message>
        <source>Named on the certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laboratory on the certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The laboratory is asked for once. Its logo: logo.png or logo.svg in labcal&apos;s folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Customer on the certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For no customer in particular? Leave it empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The laboratory is remembered for every certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State the laboratory, or the customer, anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>City</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A country is two letters, as DE, or its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep waits for: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being kept …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laboratory: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Country, as DE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Customer: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate names no laboratory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate names no customer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate names no laboratory and no customer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate of {0}, for {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ “{0}” is no country: two letters, as DE, or its name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NoFit</name>
    <message>
        <source>The other methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate by every method that was not tried yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the preflight of this DUT on the Run page</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OneDut</name>
    <message>
        <source>{0}: what is being computed goes on.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>Report …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For people as .html or .pdf, for machines as a DCC (.xml, PTB&apos;s schema)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A folder with all that goes to the customer; the certificate on paper, a label for the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply to readings …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the field, its uncertainty and flags to a .csv of readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4  Hand it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All into one folder …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print the certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print a label for the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label as a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent to the printer: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking the printer …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the calibration to: a folder, or the name of a new one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handed out into {0}:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing the certificate …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings of this DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the field goes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParameterForm</name>
    <message>
        <source>Settings that most runs leave as they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▾ Fewer settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▸ More settings: {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PathViewModel</name>
    <message>
        <source>was stopped before its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it did not measure would be missing in the calibration. Measure again on the Run page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it has not measured yet would be missing: go on with it on the Start page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run {0} {1}. {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer the question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for the other process</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the platform (COILS OFF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See to the coils</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See to {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say which DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say who works here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try the other methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>was broken off: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>was broken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See how far the trace is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See how far the fit is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See what is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure {0} again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve and sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a new draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second signature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand it out, as {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PausedHands</name>
    <message>
        <source>Whether hands may go in</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Printer</name>
    <message>
        <source>this computer has no program {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} ended with {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not printed ({0}): opened, to be printed from there.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProcedureList</name>
    <message>
        <source>Procedures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By name, by what it does, or by what it needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None is found. Fewer words, or a part of one?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PromptCard</name>
    <message>
        <source>Question to you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YOUR TURN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the coils are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether hands may go in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the platform is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What moved while an instrument was silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who names another serial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated bench began anew: its platform is at its zero, nothing has turned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the path of a file into the answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan it, or type it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not yet: what it waits for stands above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every instrument answers again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skipped, it is missing, and this run does not come back to it; only Redo axis, where that is offered at the next mounting, turns its axis again. The verdict says so, and a calibration may lack what it would tell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No: nothing is measured, and the run ends. Yes: the record says that you answered so.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, or hold the key for a moment. Enter does nothing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the button, or its key, until it is full. Enter does nothing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scan answers by itself; what is typed is sent by Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes: it goes on as it stands. No: mount it again first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No turn was finished: either way it begins with the first step again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Either way turns that were finished stay as they are, with their ticks: each mounting has a phase of its own in the fit. First the zero, the axes and the timing are measured again, to see whether anything moved or drifted; then only what is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on without a file; the record says so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, or hold {0} for 0.7 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold this button, or {0}, for 0.7 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file for the record</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordWords</name>
    <message>
        <source>What the procedure noted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that the procedure noted, in its order; no verdict rests on its estimates</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordingView</name>
    <message>
        <source>Recording {0}: what its columns are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What its columns are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: check every line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct a value as a mapping has it (docs/import.md): &quot;uT&quot;, [&quot;y&quot;, &quot;x&quot;, &quot;-z&quot;], &quot;Bx [nT]&quot;; an empty one takes the line away. accept: [&quot;axes&quot;] lets that doubt pass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the list of runs; nothing is imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the recording by the corrected mapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it into the store by this mapping, as a run of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {0} …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Not imported so: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ It can be imported. {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} changed, not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported: run {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunChooser</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run to look at, the newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is being measured: its run can be looked at once it has ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run in the store has not ended yet: it can be looked at then.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunHeadline</name>
    <message>
        <source>What happens now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunNotes</name>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a remark with its time into the record, and Enter: “lift moved”. History shows it with the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photo …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a photograph into the record, with the note as its words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept in the run&apos;s record, which History shows: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A photograph for the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>photograph</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RunViewModel</name>
    <message>
        <source>Coming back to the run that goes on …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking every instrument who it is …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands off: it goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pauses where the next step begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coils off: the run ends …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ScanCard</name>
    <message>
        <source>From here on this is the serial of the DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan is forgotten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DUT is the one before again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: no serial has blanks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanned {0}. Is it the DUT from here on? Until now: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The DUT is {0}, in place of {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShownBar</name>
    <message>
        <source>This page shows the DUT to be measured again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From here on this is the DUT to be measured: the one that is mounted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To be measured: {0}; the marks at the left and Next are of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which DUT is to be measured is not said yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown: {0}. {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks at the left and Next are of no run yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks at the left and Next are of another run: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to that run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put it away</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Whether hands have to be off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the unit of what is shown: nT, µT, mG. Entry fields keep theirs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FIELD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS   A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read every instrument now: currents, field, angle, who answers. Nothing is set or moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PLATFORM</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>INSTRUMENTS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated: began anew at its zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all answer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SigningSteps</name>
    <message>
        <source>1  Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name: letters, digits and . _ @ + - without blanks, as ada.smith. Passphrase: ten characters or more, no single common word, row of keys or name; four words are easy to keep; nothing brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the new key; asked at each signature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Typed twice: nothing can bring it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name that this person signs under</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a key for this name, and trust it in this lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2  Approve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No passphrase: an approval is a name in the draft. It binds once this person has signed (3). After the first signature nobody can be added.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who approves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another person than the operator, by the name that they sign under</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write this name into the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3  Sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These exact bytes: a signed file can no longer be changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who signs, of those who have a key here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who signs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of this person&apos;s key; asked each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign the file as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Until when it is good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key&apos;s name is {0}, made of “{1}”; or type another one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has a key now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve it all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Approve it all the same?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign it all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose who signs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type the passphrase first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} Sign it all the same?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SortedTable</name>
    <message>
        <source>Click to sort by this column, again to turn the order round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in a table: its order turned round</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Standing</name>
    <message>
        <source>The window broke off, and was started again. What it said last is kept in {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run that went on is broken off by its own process: go on with it on Start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run went on meanwhile in its own process: here it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Last closing check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cage calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preflight on the Run page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole lab without hardware, to learn on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking into the store.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on: {0}, DUT {1}. See the Run page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bench file states no calibration date.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrated {0}, {1} days ago.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ due</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ in date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The procedure cage-calibration, on the Run page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signs and axes, the procedure axes-check: 1 minute of measuring, 3 with your own time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file of what stands in this lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready. {0} is to be measured on {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ A run of {0} did not come to its end: go on with it below, or measure anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Not ready: see what is said of the coils.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Not ready: {0}. See the Bench page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coil constants only: Check the cage measures the matrix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The matrix is that of the approved cage calibration {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A matrix without a date: Check the cage says whether it holds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked {0}, {1} days ago.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At its end a run comes back to a position of before, and has to read the same there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No finished run in the store has a closing check.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run from the Run page, or a bundle imported on the History page, comes up here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatedFields</name>
    <message>
        <source>Good until</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last day on which it is good, as 2027-11-21; empty: no date is stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last day, or empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The calibration of the same serial that this one takes the place of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supersedes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supersedes none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supersedes {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is over: the last day on which it is good is today or later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{0}” is no day; write it like 2027-11-21 or {1}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StepCard</name>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is done in this step</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StepList</name>
    <message>
        <source>Steps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyViewModel</name>
    <message>
        <source>history of {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given up</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Table</name>
    <message>
        <source>in a table: its chosen rows to the clipboard, or all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>When it is done, and when you are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} of simulated time left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done at about {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are needed at {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You are needed within a minute: {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Serial number of the device under test: type it, or scan it at any moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who works here now; stands in the record and in the calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether hands have to be off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take every coil to zero now (F12). Works in every state and asks nothing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TraceProgress</name>
    <message>
        <source>tracing … {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Traced, {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Trend</name>
    <message>
        <source>Calibrations over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bars: U, k=2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero readings, scale factors from nominal, angles between the axes; gain: from the first calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No calibration of this DUT yet: its parameters and their U come up here, one dot a day.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrations of {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>UnfinishedRuns</name>
    <message>
        <source>▲ Unfinished run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns that were finished are kept; the zero, the axes and the timing are measured again. Where none was finished it begins with the first step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} more on the History page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a bench first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>VerdictCard</name>
    <message>
        <source>DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pictures and every value with its limit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>what is next for this DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letters to be read from two metres, and back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} files were dropped together; nothing was done with them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop one at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window has no room for larger letters: make it larger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unmute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller   F11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger   F11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a problem report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not complete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mounted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leads swapped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leads put back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands off: begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo axis {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset and first position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Path copied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path of what was just written, to be pasted elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open that run on the page that computes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in the file manager what was just written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record a run, or import one on the History page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No run yet: record one on the Run page, or import a bundle on the History page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Morning check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands off: try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mount it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ This cannot be done as asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ An instrument failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ The record is not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ The check standard is out of control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ The guardian failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ The clock was set back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the platform may still turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ A limit is not met</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>■ Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ This page cannot be shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ Something in labcal broke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ The work broke off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ CLEAN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ EXPLAINED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ PARTLY EXPLAINED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? AMBIGUOUS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ UNEXPLAINED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coverage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body {0} up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mount it with body {0} up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mount it as at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>voltage {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cage X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cage Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>instrument</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>procedure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U (k=2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>row 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field  µT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>meaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>figure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>risk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± U (k=2) is that of the difference; beyond E_n = ±1 the DUT has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of the two is traced, the other is not: what differs may be what tracing took out. Trace both, or none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are of two DUTs. ± U (k=2) is that of the difference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of the two is not explained: what differs may be its error, and says nothing of the DUT yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PASS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MARGINAL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CANNOT DECIDE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conditional pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conditional fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In specification?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In specification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In specification, conditionally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in specification, conditionally</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in specification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Risk: how probably the true value is beyond its limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held-out |b|  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis error, worst  deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>declared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>static</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inertial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nadir</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle  deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>field  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time  s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several, with commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>20 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset k x  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset k y  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset k z  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ppm from the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DUT  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot: {0} against {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>residual  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held-out rms  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no fields all round at one magnitude: see field-sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan says how long this takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Their key is not on this computer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First a key (1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the approval (2). Nobody there? Sign alone: it is valid, and PROVISIONAL.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once it is signed (3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once {0} has signed; before that as PROVISIONAL.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handed out. Next: another DUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As PROVISIONAL: nobody approved it before it was signed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As PROVISIONAL: why is said above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key can bear “{0}”: letters, digits and . _ @ + - alone, as in ada.smith</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has a key here already, as {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two passphrases differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} is the operator, {1}: another person approves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write this picture to a .png file, as it is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the coils may be on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Broken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>■ Stopped by COILS OFF (F12)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>today</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no marks between thousands: 20000, not 20 000, 20,000 or 20.000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point stands before decimals here: 1.5, not 1,5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a blank after each comma, and a point before decimals: 20000, 50000.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>non-orthogonality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by COILS OFF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>broken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every point that is drawn to the clipboard, as columns x and y of each curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Needs: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About {0:g} min of measuring, and your own time beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With a key here: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whoever signed has a key elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody has a key here. Make one for the person who approves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only {0} has a key here. Make one for who approves: another person than {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed without an approval: nobody can be added any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another person than {0} looks at the figures below, and approves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First a key of another person than {0} (1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not use it: make a new draft on the Fit page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the operator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} has to sign. The operator may sign as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good to use as PROVISIONAL; {0} has still to sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer (plug? power?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer (link lost)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heard {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heard before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not read in this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read {0} s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: not read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: not read since {0}; move the mouse, and it is read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: the coils are not being read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: the platform is not being read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ Hands may go in: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● Hands may go in: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: a run of {0} was cut off; the coils are not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off: another process drives a run of {0}; the coils may be on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF done {0}: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop it at its controller, and see it stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the platform was ordered to stop, and is not seen to stand yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>press COILS OFF (F12) first: it stops the platform too, if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF was pressed, and stops it if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform may turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is left over but noise. The calibration may be signed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The error has a cause: {0}. It is in the draft, which may be signed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of the error has a cause: {0}. It is in the draft; something else is left over: see 4 before you sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This may be the cause: {0}. Another one does as well: measure what tells them apart (4), then sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something is wrong that nothing known explains. Do not sign: see 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ NOT ENOUGH FOR A WHOLE MAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run does not determine the whole map: too few axes or fields were measured, so no cause was searched for. That says nothing against the DUT. What to measure stands at 4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms of the vector, with declared errors; noise alone {0} nT rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before → after: held-out rms of the vector, with the errors in it that the run declares of reference and mounting; noise alone, of one such row: {0} nT, {1}; the figure on the Fit page is of |b| alone, without direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>explains nothing beyond what is named already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>explains too little to be worth its parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in files and commands: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, or {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} at {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows that were set aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every morning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test a DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage and its reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit, Loop, Certificate: Next leads there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No calibration of a DUT comes of this procedure. Next leads on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Within U of its limit: measure that part again, or Fit and see.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at what was measured, mend the cause, and measure again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing of it had a limit: look at what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was measured is kept. To measure again: Close, then Begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished turns are kept; Go on measures the zero, the axes and the timing again, then what is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend what is said above, then measure again: Close, then Begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PASS of the measurement: |value| + U (k=2) is within its limit ({0} of {0}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not measured: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}, without {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NOT MEASURED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was measured, so this says nothing of the DUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be gone on with: a result of {0} is worked out from one recording without a gap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The delay is how late the DUT reads behind the platform&apos;s angle. It comes of turns there and back about one axis without a break between; after Go on too few of those are left. To get it: sync-check, or a new preflight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How good the calibration is, Fit and Loop judge.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit, and trace what is left over. Still open then? Measure longer, or with less noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One axis: not enough for a calibration by itself. Measure the others too, or a preflight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: finished turns are kept; the zero, the axes, the timing and the step that broke off are measured again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No turn was finished: Go on begins with the first step again, and uses nothing of what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: no turn was finished, so it begins with the first step again, and uses nothing of what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was measured: Go on begins with the first step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To measure again: Close, then Begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FAIL where |value| − U (k=2) is beyond the limit: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MARGINAL where the limit lies within ± U (k=2): {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CANNOT DECIDE where U (k=2) exceeds half the limit: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It did not come to its end, so it has no verdict, and gives no calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DONE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ not valid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ provisional</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ expired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ superseded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to do now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not use it any more: measure anew, or take the calibration that came after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good until {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No last day of use is stated: it never expires by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That day is stated by who approves (2), by the interval of your lab; labcal works none out here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So it was stated when it was approved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None was when it was approved, and none can be added any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UNEXPLAINED: what is left of held-out rows has no known cause, and U takes it for random.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its run did not measure {0}: they were held as they stand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody can approve it: turn about the other body axes as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed it stays PROVISIONAL, for its run did not measure it whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As {0}: why is said above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Handed out as {0}. Next: another DUT.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AMBIGUOUS, the cause is not certain: {0}. It may be another: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PROVISIONAL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>handed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ No calibration from this run by {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ No calibration from this run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset and gains did not come out of these rows, so nothing can be traced or signed of this run. The DUT may still be good.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: the other methods. Some of them need less of a run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: measure again, with turns about x, y and z and in more than one magnitude, as preflight does it. Look first at the pictures below: a turn that stands apart from the others is the one that went wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a result: {0}. What is said above is of {1}, and does not rest on them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a result: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left over is the rms of |b| in held-out rows; its noise is what is stated of |b| in one reading. The figure on the Loop page is of the whole vector in such rows, its direction too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} nT rms of |b| are left over; no noise is stated to compare it with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No specification is stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace the residual.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ The calibration is good in size: {0} nT rms of |b| are left over, no more than its noise, {1} nT rms. The loop judges the direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ The map alone is not enough: {0} nT rms of |b| are left over, its noise is {1} nT rms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The Loop page says what was found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The loop&apos;s draft holds its cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ This run does not determine the whole map, however little is left over: {0}. It is good for a check, and for no calibration.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening the simulated lab …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guardian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only in a run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to zero when a session ends, breaks off or no longer answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ No answer from {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ No answer from {0} instruments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here that is “{0}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run did not end by itself within seconds, so its process was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then “{0}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept of this run: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} → {1} nT rms of the vector, noise alone {2} nT rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>offset k {0} nT by {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run goes on: the coils may be on. Hands off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hands off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} s simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HANDS OFF – no answer from {0}; {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HANDS OFF – {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HANDS OFF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Hands off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field and the platform come next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the next field or turn comes unasked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the platform turns next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF: the run stops …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the step is broken off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: no answer from {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ One interruption: {0}. Measured again: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}. Measured again: {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ One interruption: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at {0}, for {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before its first step, for {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before its first step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody knows how long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noted, in the run&apos;s record (History shows it): {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noted: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The procedure noted {0} more, the last: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates on the way: {0} notes; no verdict rests on them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimates on the way: 1 note; no verdict rests on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Open in the run itself: {0}. An approval takes that as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(not seen: {0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} COILS OFF: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference agreed {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No comparison: run {0} is {1}; what it lacks would look like a change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: {1} A when last read, {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: see to plug, power and cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read all asks again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they have answered at these links before: are their plugs in at both ends, and have they power?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guardian is lost. COILS OFF (F12) works without it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coil z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>platform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ No answer from {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put that right first: see to plug and power. “Hands off” is not taken before it answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See to plug and power as well: nothing is measured before it answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (since {1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First press COILS OFF (F12), then switch off by hand the supply that does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First stop the platform at its controller, and see it stand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First wait until hands may go in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer from all {0} instruments at {1}: look at their common line, not at each plug.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer from all {0} instruments: is the rack’s power off, or the adapter or network gone?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer from {0} instruments, all {1} at {2} among them: look at that common line first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ The zero was checked: supplies and reference agree. A run may begin again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the certificate, for people</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the calibration, for programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a signature of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>when it was signed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the keys to verify it by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this list, for the customer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} in the store</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} of {1} in the store</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a key (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Approve (2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign (3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand it out (4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the method {0}. Zero reading: what the sensor indicates in no field; the offset k of b = K m − k is under Map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of one component of the field: up to {0} nT (k = 2), {1} % of it from {2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U of one component of the field: {0} nT (k = 2), mostly from the mounting, declared good to {1}°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To lower it, mount more exactly and declare that (u_mounting_deg): docs/certificate.md</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it is made of: docs/certificate.md</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the declared mounting ({0})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference sees {0} µT along {1} more than with the coils off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field says: still on ({1}, {0} µT more than with the coils off, {2})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coil is still on by the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ HANDS OFF: a coil is still on, the field says so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: not confirmed at zero when the window closed, {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: not confirmed at a standstill when the window closed, {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {0} s more, said at {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {0} s more, longer than was said before; said at {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} · run of {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF (F12), then switch off by hand: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch off by hand: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still to be read: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (last read {1})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COILS OFF was pressed at {0}; nobody has confirmed it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero, output open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero, output not open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0}: answers again, no answer from {1} to {2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Not traced: {0} nT of |b| are left over beyond the map, and nobody has looked for their cause.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To do here: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Not traced: nobody has looked for the cause of what is left over beyond the map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are of two DUTs: their offsets and gains are no change of one, and stand in no table. Residuals and loci of both are drawn below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes off  nT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? rival</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>– not named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does about as well as “{0}”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back {0}, out since {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The instruments of your lab: open its bench file, and see that each answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You mount the DUT about each axis; coils and platform do the rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset, scale and angles from that run, each with its uncertainty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left over is traced to its cause, and tried on held-out data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another person approves, you sign, and it is handed out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured already, and kept: {0} (how late the reading follows the field).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost: {0}, which comes of turns there and back without a break, and too few of those are left to measure. To get it: sync-check, or a new preflight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ done for this DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● it goes on now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ done, and something of it is open: the page says what</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ it failed: the page says why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ still to be done for this DUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ every instrument answered within the last {0} s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● no answer within the last {0} s, for nobody asked: {1}. By themselves they are asked now and then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✕ no answer: {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ no instrument answered within the last {0} s; Read all asks them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ a run that this DUT can be calibrated by is finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ the last run that was to calibrate this DUT did not come to its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ no run yet that this DUT can be calibrated by: a preflight is one, a turn about one axis is none</source>
        <translation></translation>
    </message>
    <message>
        <source>Open a bench file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>being asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not looked at at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To look at it opens its port: that resets many a microcontroller, or switches what it sends. Read all asks it who it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read again in the next step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being traced: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being fitted: {0}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bench that was open stays open: {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begun on the bench {0}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ Begun on the bench {0}; {1} is open. Open {0} first: with other instruments it does not go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (served)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{0} (not simulated)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The buttons of the run have just changed: nothing was done. Press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gain K {0} by {1}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a reading along {1} adds to the field along {0}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WorkBar</name>
    <message>
        <source>Something is being computed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
