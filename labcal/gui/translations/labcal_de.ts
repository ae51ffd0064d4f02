<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AnswerForCard</name>
    <message>
        <source>Answer for this run</source>
        <translation>Für diesen Lauf einstehen</translation>
    </message>
    <message>
        <source>It begins though the check standard is out of control. Name and reason stand in its record and in the audit log; with a key they are signed.</source>
        <translation>Er beginnt, obwohl das Prüfnormal außer Kontrolle ist. Name und Grund stehen in seiner Aufzeichnung und im Prüfprotokoll; mit einem Schlüssel sind sie signiert.</translation>
    </message>
    <message>
        <source>Who answers for it</source>
        <translation>Wer dafür einsteht</translation>
    </message>
    <message>
        <source>The person who lets this run begin</source>
        <translation>Die Person, die diesen Lauf beginnen lässt</translation>
    </message>
    <message>
        <source>Why it may begin</source>
        <translation>Warum er beginnen darf</translation>
    </message>
    <message>
        <source>What is known of the check standard: it was dropped</source>
        <translation>Was man vom Prüfnormal weiß: es ist heruntergefallen</translation>
    </message>
    <message>
        <source>Whose key signs it</source>
        <translation>Wessen Schlüssel es signiert</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>Kennwort</translation>
    </message>
    <message>
        <source>Of this key; asked each time</source>
        <translation>Dieses Schlüssels; jedes Mal gefragt</translation>
    </message>
    <message>
        <source>Let it begin</source>
        <translation>Beginnen lassen</translation>
    </message>
    <message>
        <source>Begin this run; it is noted who answered for it</source>
        <translation>Diesen Lauf beginnen; es wird notiert, wer dafür einsteht</translation>
    </message>
    <message>
        <source>no key: not signed</source>
        <translation>kein Schlüssel: nicht signiert</translation>
    </message>
</context>
<context>
    <name>AppState</name>
    <message>
        <source>A run goes on; open another bench after it.</source>
        <translation>Eine Messung läuft; einen anderen Messplatz danach öffnen.</translation>
    </message>
    <message>
        <source>Opening {0} …</source>
        <translation>{0} wird geöffnet …</translation>
    </message>
    <message>
        <source>Scanned {0}; a run goes on, its DUT stays.</source>
        <translation>{0} gescannt; eine Messung läuft, ihr Prüfling bleibt.</translation>
    </message>
    <message>
        <source>Scanned {0}; hands off: scan again once hands may go in.</source>
        <translation>{0} gescannt; Hände weg: noch einmal scannen, sobald Hände hinein dürfen.</translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: {0}</source>
        <translation>✕ Gescannt und nicht übernommen: {0}</translation>
    </message>
    <message>
        <source>Scanned {0}: it is the DUT at the top.</source>
        <translation>{0} gescannt: Das ist der Prüfling oben.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>Der Messplatz wird geöffnet …</translation>
    </message>
    <message>
        <source>Open a bench first: yours, or the simulated lab.</source>
        <translation>Zuerst einen Messplatz öffnen: den eigenen oder das simulierte Labor.</translation>
    </message>
    <message>
        <source>Scan or type the DUT&apos;s serial at the top.</source>
        <translation>Oben die Seriennummer des Prüflings scannen oder eingeben.</translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation>Oben den Namen des Bedieners eingeben.</translation>
    </message>
    <message>
        <source>Answer first whether {0} is the DUT.</source>
        <translation>Zuerst beantworten, ob {0} der Prüfling ist.</translation>
    </message>
    <message>
        <source>your turn</source>
        <translation>Sie sind dran</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pausiert</translation>
    </message>
    <message>
        <source>hands off, measuring</source>
        <translation>Hände weg, es wird gemessen</translation>
    </message>
</context>
<context>
    <name>ArchivedViewModel</name>
    <message>
        <source>The archive has not answered.</source>
        <translation>Das Archiv hat nicht geantwortet.</translation>
    </message>
</context>
<context>
    <name>BenchEditor</name>
    <message>
        <source>Settings of {0}</source>
        <translation>Einstellungen von {0}</translation>
    </message>
    <message>
        <source>Settings of a bench file</source>
        <translation>Einstellungen einer Messplatzdatei</translation>
    </message>
    <message>
        <source>limits first</source>
        <translation>Grenzen zuerst</translation>
    </message>
    <message>
        <source>Type a value as TOML has it: 2.5, true, [1.0, 2.0], text between quotation marks; an empty one takes the setting away. In brackets: what holds where nothing is stated.</source>
        <translation>Werte wie in TOML schreiben: 2.5, true, [1.0, 2.0], Text in Anführungszeichen; ein leerer nimmt die Einstellung weg. In Klammern: was gilt, wo nichts angegeben ist.</translation>
    </message>
    <message>
        <source>What would change</source>
        <translation>Was sich ändern würde</translation>
    </message>
    <message>
        <source>Show changes</source>
        <translation>Änderungen zeigen</translation>
    </message>
    <message>
        <source>Compare with the file, and check what it says</source>
        <translation>Mit der Datei vergleichen und prüfen, was sie sagt</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Write these lines into the file; all others stay as they are</source>
        <translation>Diese Zeilen in die Datei schreiben; alle anderen bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the instruments; what was not saved is forgotten</source>
        <translation>Zu den Geräten; was nicht gespeichert wurde, ist vergessen</translation>
    </message>
    <message>
        <source>{0} unless stated. {1}</source>
        <translation>{0}, wenn nicht angegeben. {1}</translation>
    </message>
    <message>
        <source>{0} (over several lines: change it in the file)</source>
        <translation>{0} (über mehrere Zeilen: in der Datei ändern)</translation>
    </message>
    <message>
        <source>{0} changed, not saved</source>
        <translation>{0} geändert, nicht gespeichert</translation>
    </message>
    <message>
        <source>▲ Not a bench file then: {0}</source>
        <translation>▲ Dann keine Messplatzdatei: {0}</translation>
    </message>
    <message>
        <source>✓ A bench file</source>
        <translation>✓ Eine Messplatzdatei</translation>
    </message>
    <message>
        <source>Saved: {0}</source>
        <translation>Gespeichert: {0}</translation>
    </message>
    <message>
        <source>The file is as it was.</source>
        <translation>Die Datei ist, wie sie war.</translation>
    </message>
</context>
<context>
    <name>BenchPage</name>
    <message>
        <source>Instruments</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Check all</source>
        <translation>Alle prüfen</translation>
    </message>
    <message>
        <source>Ask every instrument who it is. Nothing is energised or moved.</source>
        <translation>Jedes Gerät fragen, wer es ist. Nichts wird bestromt oder bewegt.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>Let go of every link, read the bench file again and ask every instrument who it is</source>
        <translation>Alle Verbindungen lösen, die Messplatzdatei neu lesen und jedes Gerät fragen, wer es ist</translation>
    </message>
    <message>
        <source>Open a bench file …</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>A bench file (.toml): what stands in the lab, on which lines</source>
        <translation>Eine Messplatzdatei (.toml): was im Labor steht, an welchen Leitungen</translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>A whole lab without hardware</source>
        <translation>Ein ganzes Labor ohne Geräte</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>Settings of this bench file, limits first</source>
        <translation>Einstellungen dieser Messplatzdatei, Grenzen zuerst</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Neu …</translation>
    </message>
    <message>
        <source>Ask who answers on this computer&apos;s lines, and write a draft of a bench file</source>
        <translation>Fragen, wer an den Leitungen dieses Rechners antwortet, und eine Messplatzdatei entwerfen</translation>
    </message>
    <message>
        <source>Open a bench file, or take the simulated lab.</source>
        <translation>Eine Messplatzdatei öffnen oder das simulierte Labor nehmen.</translation>
    </message>
    <message>
        <source>The cage</source>
        <translation>Der Käfig</translation>
    </message>
    <message>
        <source>A draft of a bench file</source>
        <translation>Entwurf einer Messplatzdatei</translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments; check them after it.</source>
        <translation>Eine Messung läuft und hält die Geräte; danach prüfen.</translation>
    </message>
    <message>
        <source>Asking who answers on this computer&apos;s lines …</source>
        <translation>Es wird gefragt, wer an den Leitungen dieses Rechners antwortet …</translation>
    </message>
    <message>
        <source>{0} answered: {1}</source>
        <translation>{0} antworteten: {1}</translation>
    </message>
    <message>
        <source>Asking …</source>
        <translation>Wird gefragt …</translation>
    </message>
    <message>
        <source>{0} of {1} instruments answered</source>
        <translation>{0} von {1} Geräten haben geantwortet</translation>
    </message>
    <message>
        <source>All {0} instruments answered</source>
        <translation>Alle {0} Geräte haben geantwortet</translation>
    </message>
    <message>
        <source>Who answers for it says so on the terminal: labcal bench check {0} --clear-as NAME</source>
        <translation>Wer dafür einsteht, sagt es im Terminal: labcal bench check {0} --clear-as NAME</translation>
    </message>
    <message>
        <source>Instruments of {0}</source>
        <translation>Geräte von {0}</translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments: after it.</source>
        <translation>Eine Messung läuft und hält die Geräte: danach.</translation>
    </message>
    <message>
        <source>{0}, simulated: whichever DUT is typed</source>
        <translation>{0}, simuliert: jeder Prüfling, der oben steht</translation>
    </message>
    <message>
        <source>all arrows to one scale</source>
        <translation>alle Pfeile in einem Maßstab</translation>
    </message>
    <message>
        <source>as read last, not now; all arrows to one scale</source>
        <translation>wie zuletzt gelesen, nicht jetzt; alle Pfeile in einem Maßstab</translation>
    </message>
    <message>
        <source>applied</source>
        <translation>angelegt</translation>
    </message>
    <message>
        <source>ambient</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>&lt;br&gt;{0} here, outdoors: {1} ± {2} nT</source>
        <translation>&lt;br&gt;{0} hier, im Freien: {1} ± {2} nT</translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;br&gt;at most {0} A a coil&lt;br&gt;at most {1} nT</source>
        <translation>&lt;br&gt;&lt;br&gt;höchstens {0} A je Spule&lt;br&gt;höchstens {1} nT</translation>
    </message>
</context>
<context>
    <name>CageView</name>
    <message>
        <source>The cage with its field vectors</source>
        <translation>Der Käfig mit seinen Feldvektoren</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, to look from another side</source>
        <translation>Ziehen oder Pfeiltasten: von einer anderen Seite ansehen</translation>
    </message>
</context>
<context>
    <name>CalibrationViews</name>
    <message>
        <source>What of the calibration is shown</source>
        <translation>Was von der Kalibrierung gezeigt wird</translation>
    </message>
    <message>
        <source>As found, as left</source>
        <translation>Vorgefunden, hinterlassen</translation>
    </message>
    <message>
        <source>In short</source>
        <translation>Kurz gefasst</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Ursachen</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>No specification was stated for this run.</source>
        <translation>Für diese Messung war keine Spezifikation angegeben.</translation>
    </message>
    <message>
        <source>This DUT has no earlier calibration.</source>
        <translation>Dieser Prüfling hat keine frühere Kalibrierung.</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>No camera: OpenCV is not installed (pip install &apos;labcal[camera]&apos;).</source>
        <translation>Keine Kamera: OpenCV ist nicht installiert (pip install &apos;labcal[camera]&apos;).</translation>
    </message>
    <message>
        <source>No camera answers at {0}.</source>
        <translation>Unter {0} antwortet keine Kamera.</translation>
    </message>
    <message>
        <source>The camera {0} gives no picture any more.</source>
        <translation>Die Kamera {0} liefert kein Bild mehr.</translation>
    </message>
    <message>
        <source>The camera has given no picture yet …</source>
        <translation>Die Kamera hat noch kein Bild geliefert …</translation>
    </message>
    <message>
        <source>The camera has given no picture for {0:.0f} s.</source>
        <translation>Die Kamera hat seit {0:.0f} s kein Bild geliefert.</translation>
    </message>
    <message>
        <source>Picture of the camera: the DUT as it stands now</source>
        <translation>Bild der Kamera: der Prüfling, wie er jetzt steht</translation>
    </message>
</context>
<context>
    <name>CausesTable</name>
    <message>
        <source>Off the held-out rms beside declared errors, by it alone; –: not worked out</source>
        <translation>Von der zurückgehaltenen rms neben angegebenen Fehlern, durch sie allein; –: nicht ausgerechnet</translation>
    </message>
    <message>
        <source>Whether it is enough for a name; –: it is for another reason that it is not named</source>
        <translation>Ob es für eine Benennung genügt; –: sie ist aus einem anderen Grund nicht benannt</translation>
    </message>
    <message>
        <source>What files and commands call it</source>
        <translation>Wie Dateien und Befehle es nennen</translation>
    </message>
    <message>
        <source>Candidates; choose one to see what it alone would change</source>
        <translation>Kandidaten; einen wählen zeigt, was er allein ändern würde</translation>
    </message>
</context>
<context>
    <name>CertificatePage</name>
    <message>
        <source>Calibrations, the newest first</source>
        <translation>Kalibrierungen, die neueste zuerst</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Eine Kalibrierung wählen</translation>
    </message>
    <message>
        <source>± U (k=2) is of the parameter in its line alone. That of a component of the field, its mounting included, is under Uncertainty; rms on the Fit and Loop pages is standard (k=1).</source>
        <translation>± U (k=2) gilt für den Parameter der Zeile allein. Die einer Feldkomponente, mit der Montage darin, steht unter Unsicherheit; rms auf den Seiten Fit und Ursachen ist Standard (k=1).</translation>
    </message>
    <message>
        <source>Choose a calibration, or say at the top which DUT.</source>
        <translation>Eine Kalibrierung wählen, oder oben den Prüfling angeben.</translation>
    </message>
    <message>
        <source>The signed file is {0}, in the folder {1}</source>
        <translation>Die signierte Datei ist {0}, im Ordner {1}</translation>
    </message>
    <message>
        <source>Operator {0}.</source>
        <translation>Bediener {0}.</translation>
    </message>
    <message>
        <source>{0} is handed out.</source>
        <translation>{0} ist ausgegeben.</translation>
    </message>
    <message>
        <source>Its signatures are files beside it, {0}.sshsig: copy them into its folder, and verify it again.</source>
        <translation>Die Signaturen sind Dateien daneben, {0}.sshsig: in denselben Ordner kopieren und neu prüfen.</translation>
    </message>
    <message>
        <source>checked at {0}</source>
        <translation>geprüft um {0}</translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation>U: k=2</translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation>Die Seite, auf der das getan wird</translation>
    </message>
    <message>
        <source>No calibration of {0} yet: a fit, and the trace of what it leaves, write a draft.</source>
        <translation>Noch keine Kalibrierung von {0}: Ein Fit und die Suche nach dem, was er übrig lässt, schreiben einen Entwurf.</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>niemand</translation>
    </message>
    <message>
        <source>Operator {0}; approved by {1}.</source>
        <translation>Bediener {0}; genehmigt von {1}.</translation>
    </message>
</context>
<context>
    <name>Choose</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Usual settings</source>
        <translation>Übliche Einstellungen</translation>
    </message>
    <message>
        <source>Every setting as it was before anybody typed</source>
        <translation>Jede Einstellung, wie sie war, bevor jemand etwas eingetippt hat</translation>
    </message>
    <message>
        <source>The plan</source>
        <translation>Der Plan</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>How fast simulated time passes: as in the lab, faster, or as fast as the computer goes</source>
        <translation>Wie schnell die simulierte Zeit vergeht: wie im Labor, schneller oder so schnell der Rechner kann</translation>
    </message>
    <message>
        <source>Asks every instrument who it is, then begins. Nothing is energised before you are asked.</source>
        <translation>Fragt jedes Gerät, wer es ist, und beginnt. Nichts wird bestromt, bevor Sie gefragt werden.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Rehearse this on the simulated lab: field, rate, angles, temperature, time, and what you are asked</source>
        <translation>Am simulierten Labor proben: Feld, Drehrate, Winkel, Temperatur, Zeit und was Sie gefragt werden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End the rehearsal; nothing was begun</source>
        <translation>Die Probe beenden; es wurde nichts begonnen</translation>
    </message>
    <message>
        <source>▲ Unfinished run</source>
        <translation>▲ Unvollendete Messung</translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation>Was daran fehlt; Sie werden gefragt, ob der Einbau noch steht</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Weiter mit {0}</translation>
    </message>
    <message>
        <source>Rehearsing on the simulated lab …</source>
        <translation>Probe am simulierten Labor …</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>aufgegeben</translation>
    </message>
    <message>
        <source>What this measures is added to run {0}; then the cause is decided again, by itself.</source>
        <translation>Was dies misst, kommt zur Messung {0}; danach wird die Ursache von selbst neu entschieden.</translation>
    </message>
    <message>
        <source>Its settings are those that tell most there; the next run has the usual ones again.</source>
        <translation>Die Einstellungen sind die, die dort am meisten sagen; die nächste Messung hat wieder die üblichen.</translation>
    </message>
    <message>
        <source>Correct what is red at the top.</source>
        <translation>Berichtigen Sie, was oben rot ist.</translation>
    </message>
    <message>
        <source>Correct what is red at the top, and what is marked ✕ above.</source>
        <translation>Berichtigen Sie, was oben rot ist, und was darüber mit ✕ markiert ist.</translation>
    </message>
    <message>
        <source>A setting is not accepted: see above.</source>
        <translation>Eine Einstellung wird nicht angenommen: siehe oben.</translation>
    </message>
    <message>
        <source>It cannot be begun as it is set: the plan says why.</source>
        <translation>So eingestellt kann es nicht beginnen: Der Plan sagt, warum.</translation>
    </message>
    <message>
        <source>the plan</source>
        <translation>den Plan</translation>
    </message>
</context>
<context>
    <name>Client</name>
    <message>
        <source>The work was ended by this window.</source>
        <translation>Die Arbeit wurde von diesem Fenster beendet.</translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation>Die Arbeit sagte, was dieses Fenster nicht lesen kann, und wurde von ihm beendet.</translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation>Die Arbeit endete von selbst (Code {0}).</translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation>Die Arbeit ist abgestürzt (Code {0}).</translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation>Die Arbeit wurde abgebrochen (Signal {0}).</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Der Arbeitsprozess war nicht zu starten.</translation>
    </message>
</context>
<context>
    <name>CloseAtRest</name>
    <message>
        <source>Close the window?</source>
        <translation>Fenster schließen?</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation>Nichts schließen (Esc)</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>The lab is left as it is said here</source>
        <translation>Das Labor bleibt so zurück, wie es hier steht</translation>
    </message>
    <message>
        <source>With the window closed the guardian keeps trying to bring every coil to zero; nobody sees whether it does.</source>
        <translation>Ist das Fenster zu, versucht der Wächter weiter, jede Spule auf null zu bringen; niemand sieht, ob es gelingt.</translation>
    </message>
    <message>
        <source>No guardian holds the supplies: COILS OFF is given once more on closing; nobody sees what becomes of it.</source>
        <translation>Kein Wächter hält die Netzgeräte: SPULEN AUS wird beim Schließen noch einmal gegeben; niemand sieht, was daraus wird.</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>A run goes on</source>
        <translation>Eine Messung läuft</translation>
    </message>
    <message>
        <source>A run goes on: {0}</source>
        <translation>Eine Messung läuft: {0}</translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What was measured is kept; this procedure cannot be gone on with.</source>
        <translation>Die Spulen gehen auf null, das Fenster schließt. Gemessenes bleibt; mit dieser Prozedur geht es nicht weiter.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What is missing is measured later: Go on, on the Start page.</source>
        <translation>Die Spulen gehen auf null, das Fenster schließt. Was fehlt, wird später gemessen: Weiter, auf der Startseite.</translation>
    </message>
    <message>
        <source>Keep running behind</source>
        <translation>Im Hintergrund weiter</translation>
    </message>
    <message>
        <source>The window goes out of sight, and comes back when you are needed or the run has ended.</source>
        <translation>Das Fenster verschwindet und kommt wieder, wenn Sie gebraucht werden oder die Messung zu Ende ist.</translation>
    </message>
    <message>
        <source>Back to the run</source>
        <translation>Zurück zur Messung</translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation>Nichts schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>CoilsOff</name>
    <message>
        <source>Coils off: no bench is open, this window drives no coil.</source>
        <translation>Spulen aus: Kein Messplatz ist offen, dieses Fenster treibt keine Spule.</translation>
    </message>
    <message>
        <source>Coils off: reading them back …</source>
        <translation>Spulen aus: werden zurückgelesen …</translation>
    </message>
    <message>
        <source>Checking the zero: coils to zero, then what the reference sees …</source>
        <translation>Die Null wird geprüft: Spulen auf Null, dann was die Referenz sieht …</translation>
    </message>
    <message>
        <source>Nobody has seen it stand yet: its line may be silent, or kept by another program.</source>
        <translation>Noch niemand hat ihn stehen sehen: Vielleicht schweigt seine Leitung, oder ein anderes Programm behält sie.</translation>
    </message>
    <message>
        <source>Press COILS OFF (F12): it stops the platform as well. Hands off until you see it stand.</source>
        <translation>SPULEN AUS (F12) drücken: Das hält auch den Tisch an. Hände weg, bis Sie ihn stehen sehen.</translation>
    </message>
    <message>
        <source>COILS OFF does not reach it: stop it at its controller. Hands off until you see it stand.</source>
        <translation>SPULEN AUS erreicht ihn nicht: am Controller anhalten. Hände weg, bis Sie ihn stehen sehen.</translation>
    </message>
    <message>
        <source>The platform kept turning: COILS OFF is given anew, and stops it …</source>
        <translation>Der Tisch drehte weiter: SPULEN AUS wird noch einmal gegeben, und hält ihn an …</translation>
    </message>
    <message>
        <source>No answer yet from: {0}</source>
        <translation>Noch keine Antwort von: {0}</translation>
    </message>
    <message>
        <source>By hand: at its panel, or at its mains switch.</source>
        <translation>Von Hand: an seinem Bedienfeld oder am Netzschalter.</translation>
    </message>
</context>
<context>
    <name>ComparisonView</name>
    <message>
        <source>Runs without a calibration are fitted now.</source>
        <translation>Messungen ohne Kalibrierung werden jetzt ausgewertet.</translation>
    </message>
    <message>
        <source>{0}: two runs compared</source>
        <translation>{0}: zwei Messungen verglichen</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>run {0}, calibration {1}</source>
        <translation>Messung {0}, Kalibrierung {1}</translation>
    </message>
    <message>
        <source>run {0}, fitted now (it has no calibration)</source>
        <translation>Messung {0}, jetzt ausgewertet (sie hat keine Kalibrierung)</translation>
    </message>
    <message>
        <source>Two runs compared</source>
        <translation>Zwei Messungen verglichen</translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation>U: k=2</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the list of runs</source>
        <translation>Zur Liste der Messungen</translation>
    </message>
    <message>
        <source>What of the two runs is drawn over each other</source>
        <translation>Was von den beiden Messungen übereinander gezeichnet wird</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Residuals of the magnitude</source>
        <translation>Reste des Betrags</translation>
    </message>
    <message>
        <source>Loci on the sphere, calibrated</source>
        <translation>Ortskurven auf der Kugel, kalibriert</translation>
    </message>
    <message>
        <source>What the residuals are drawn against</source>
        <translation>Wogegen die Reste gezeichnet werden</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Gegen</translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation>Rest von |b|  nT</translation>
    </message>
    <message>
        <source>band: the larger noise that the two fits make of their own residuals, k=2; none is stated</source>
        <translation>Band: das größere Rauschen, das die beiden Auswertungen aus ihrem eigenen Rest machen, k=2; keines ist angegeben</translation>
    </message>
    <message>
        <source>band: the larger of the two runs&apos; stated noises of |b|, k=2, as on the Fit page</source>
        <translation>Band: das größere der angegebenen Rauschen von |b| der beiden Messungen, k=2, wie auf der Seite Fit</translation>
    </message>
    <message>
        <source>no reference, no residual</source>
        <translation>ohne Referenz kein Rest</translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation>Mittel {0} nT, rms {1} nT</translation>
    </message>
    <message>
        <source>faint: behind the sphere</source>
        <translation>blass: hinter der Kugel</translation>
    </message>
</context>
<context>
    <name>CoveredBar</name>
    <message>
        <source>How much of the circle the turn about this axis has seen, in sectors of 15°</source>
        <translation>Wie viel des Kreises die Drehung um diese Achse gesehen hat, in Sektoren von 15°</translation>
    </message>
    <message>
        <source>{0}, this turn: {1} % of the circle</source>
        <translation>{0}, diese Drehung: {1} % des Kreises</translation>
    </message>
    <message>
        <source>{0}: {1} % of the circle</source>
        <translation>{0}: {1} % des Kreises</translation>
    </message>
</context>
<context>
    <name>Data</name>
    <message>
        <source>coils at zero</source>
        <translation>Spulen auf null</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero; {0}</source>
        <translation>Spulen NICHT als null bestätigt; {0}</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero</source>
        <translation>Spulen NICHT als null bestätigt</translation>
    </message>
    <message>
        <source>NOT at zero by the reference: {0}. {1}</source>
        <translation>Nach der Referenz NICHT auf null: {0}. {1}</translation>
    </message>
    <message>
        <source>NOT at zero by the reference</source>
        <translation>Nach der Referenz NICHT auf null</translation>
    </message>
    <message>
        <source>coils not read back in this session</source>
        <translation>Spulen in dieser Sitzung nicht zurückgelesen</translation>
    </message>
    <message>
        <source>coils on: {0}</source>
        <translation>Spulen an: {0}</translation>
    </message>
    <message>
        <source>coils on: {0}, read back {1}</source>
        <translation>Spulen an: {0}, zurückgelesen {1}</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill</source>
        <translation>Stillstand des Tisches NICHT bestätigt</translation>
    </message>
    <message>
        <source>platform turns, at {0}°</source>
        <translation>Tisch dreht, bei {0}°</translation>
    </message>
    <message>
        <source>platform stands at {0}°</source>
        <translation>Tisch steht bei {0}°</translation>
    </message>
    <message>
        <source>platform stands at {0}°, read {1}</source>
        <translation>Tisch steht bei {0}°, gelesen {1}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}; not watched since</source>
        <translation>Spulen bei Null bestätigt {0}; seitdem nicht beobachtet</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}; not watched since</source>
        <translation>Spulen nach Aussage der Netzgeräte bei Null gelesen {0}; seitdem nicht beobachtet</translation>
    </message>
    <message>
        <source>the reference has no ambient field to compare with yet</source>
        <translation>die Referenz hat noch kein Umgebungsfeld zum Vergleich</translation>
    </message>
    <message>
        <source>Still lost: {0}. Put that right first: a step begun now fails again.</source>
        <translation>Noch verloren: {0}. Erst beheben: ein jetzt begonnener Schritt scheitert wieder.</translation>
    </message>
    <message>
        <source>taking the coils to zero: ordered, not read back yet …</source>
        <translation>Die Spulen gehen auf null: befohlen, noch nicht zurückgelesen …</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero: {0}</source>
        <translation>Spulen NICHT als null bestätigt: {0}</translation>
    </message>
    <message>
        <source>coils read back at zero by their supplies</source>
        <translation>Spulen von ihren Netzgeräten bei null zurückgelesen</translation>
    </message>
    <message>
        <source>coils may be on: a run goes on, and nothing was read yet</source>
        <translation>Spulen vielleicht an: eine Messung läuft, und noch nichts wurde gelesen</translation>
    </message>
    <message>
        <source>coils may be on</source>
        <translation>Spulen vielleicht an</translation>
    </message>
    <message>
        <source>coils not read back since they were ordered off</source>
        <translation>Spulen nicht zurückgelesen, seit ihr Ausschalten befohlen wurde</translation>
    </message>
    <message>
        <source>coils on</source>
        <translation>Spulen an</translation>
    </message>
    <message>
        <source>platform turns</source>
        <translation>Tisch dreht</translation>
    </message>
    <message>
        <source>platform turns, at {0}°, read {1}</source>
        <translation>Tisch dreht, bei {0}°, gelesen {1}</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned</source>
        <translation>Stillstand des Tisches NICHT bestätigt: bei {0}° drehte er</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned, {1}</source>
        <translation>Stillstand des Tisches NICHT bestätigt: bei {0}° drehte er, {1}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}</source>
        <translation>Spulen als null bestätigt {0}</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}</source>
        <translation>Spulen nach Aussage der Netzgeräte bei Null gelesen {0}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}, silent since</source>
        <translation>Spulen als null bestätigt {0}, seitdem stumm</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}, silent since</source>
        <translation>Spulen nach Aussage der Netzgeräte bei Null gelesen {0}, seitdem stumm</translation>
    </message>
    <message>
        <source>waiting for a guardian that takes the order of zero …</source>
        <translation>Warten auf einen Wächter, der den Befehl der Null annimmt …</translation>
    </message>
    <message>
        <source>of a simulated lab the reference is not read at rest</source>
        <translation>die Referenz eines simulierten Labors wird in Ruhe nicht gelesen</translation>
    </message>
    <message>
        <source>the reference does not answer</source>
        <translation>die Referenz antwortet nicht</translation>
    </message>
    <message>
        <source>the reference&apos;s ambient field is from before hands were at the DUT</source>
        <translation>das Umgebungsfeld der Referenz ist von vor dem letzten Griff an den Prüfling</translation>
    </message>
    <message>
        <source>the reference was moved since its ambient field was measured</source>
        <translation>die Referenz wurde bewegt, seit ihr Umgebungsfeld gemessen wurde</translation>
    </message>
    <message>
        <source>coils at zero, by their supplies and by the field</source>
        <translation>Spulen auf null, nach ihren Netzgeräten und nach dem Feld</translation>
    </message>
    <message>
        <source>the reference sees more change than a mounting makes</source>
        <translation>die Referenz sieht eine größere Änderung, als ein Einbau macht</translation>
    </message>
    <message>
        <source>the reference has sent nothing since the currents settled</source>
        <translation>die Referenz hat nichts gesendet, seit die Ströme stehen</translation>
    </message>
    <message>
        <source>the reference is not streaming</source>
        <translation>die Referenz sendet nicht</translation>
    </message>
    <message>
        <source>the reference is at its full scale and cannot vouch for it</source>
        <translation>die Referenz ist am Ende ihres Messbereichs und kann nichts bezeugen</translation>
    </message>
    <message>
        <source>the link to the reference is lost</source>
        <translation>die Verbindung zur Referenz ist verloren</translation>
    </message>
    <message>
        <source>the reference repeats one reading</source>
        <translation>die Referenz wiederholt einen Messwert</translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}, {1} s ago</source>
        <translation>die Referenz wird nochmals angesehen: {0}, vor {1} s</translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}</source>
        <translation>die Referenz wird nochmals angesehen: {0}</translation>
    </message>
    <message>
        <source>the reference agreed when it was last looked at, {0}</source>
        <translation>die Referenz stimmte zu, als sie zuletzt angesehen wurde, {0}</translation>
    </message>
    <message>
        <source>it sees {0} nT, {1} nT expected: {2} µT apart, {3} µT allowed</source>
        <translation>sie sieht {0} nT, erwartet {1} nT: {2} µT Abstand, {3} µT erlaubt</translation>
    </message>
    <message>
        <source>{0} UTC, {1}</source>
        <translation>{0} UTC, {1}</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: open the output of {2} at its panel, or switch it off at its mains</source>
        <translation>Es ist, als flössen {0} A in Spule {1}: Den Ausgang von {2} an seinem Gerät öffnen oder am Netzschalter ausschalten</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: switch off {2} at its mains (no command opens its output)</source>
        <translation>Es ist, als flössen {0} A in Spule {1}: {2} am Netzschalter ausschalten (kein Befehl öffnet seinen Ausgang)</translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation>vor {0} s</translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation>vor {0} min</translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation>vor {0} h</translation>
    </message>
    <message>
        <source>at {0} ({1})</source>
        <translation>um {0} ({1})</translation>
    </message>
    <message>
        <source>Open the outputs that can open, or switch the supplies off at their mains</source>
        <translation>Die Ausgänge öffnen, die öffnen können, oder die Netzgeräte am Netzschalter ausschalten</translation>
    </message>
    <message>
        <source>Mount the DUT with body {0} up along the platform axis, body {1} towards the cage&apos;s {2}, at platform angle 0.</source>
        <translation>Den Prüfling mit Körperachse {0} nach oben längs der Tischachse einbauen, Körperachse {1} zur {2}-Achse des Käfigs, bei Tischwinkel 0.</translation>
    </message>
    <message>
        <source>Scan the serial of the DUT as it is mounted now: this run is of {0}.</source>
        <translation>Die Seriennummer des Prüflings scannen, wie er jetzt eingebaut ist: diese Messung gilt {0}.</translation>
    </message>
    <message>
        <source>{0}: that is not the DUT of this run. Mount {1}, then scan its serial again.</source>
        <translation>{0}: das ist nicht der Prüfling dieser Messung. {1} einbauen, dann seine Seriennummer nochmals scannen.</translation>
    </message>
    <message>
        <source>Mount the DUT with body Z up, body X towards the cage&apos;s X; then {0}.</source>
        <translation>Den Prüfling mit Körperachse Z nach oben einbauen, Körperachse X zum X des Käfigs; dann {0}.</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>wie er steht</translation>
    </message>
    <message>
        <source>as it always stands</source>
        <translation>wie sie immer steht</translation>
    </message>
    <message>
        <source>turned by 180° about its own {0}</source>
        <translation>um 180° um die eigene Achse {0} gedreht</translation>
    </message>
    <message>
        <source>turned by 180° about its {0}</source>
        <translation>um 180° um seine Achse {0} gedreht</translation>
    </message>
    <message>
        <source>Why is axis {0} redone? What was measured stays in the record, marked as not used.</source>
        <translation>Warum wird Achse {0} wiederholt? Was gemessen wurde, bleibt in der Aufzeichnung, als nicht verwendet markiert.</translation>
    </message>
    <message>
        <source>Why is {0} skipped?</source>
        <translation>Warum wird {0} übersprungen?</translation>
    </message>
    <message>
        <source>the disk is slow: rows wait {0} s in memory</source>
        <translation>die Platte ist langsam: Zeilen warten {0} s im Speicher</translation>
    </message>
    <message>
        <source>the disk takes what is recorded again</source>
        <translation>die Platte nimmt wieder auf, was aufgezeichnet wird</translation>
    </message>
    <message>
        <source>{0}: body {1} is up, not {2}. Mount it again: this turn says nothing of {2}.</source>
        <translation>{0}: Körperachse {1} ist oben, nicht {2}. Neu montieren: Diese Drehung sagt nichts über {2}.</translation>
    </message>
    <message>
        <source>Switch the DUT to power mode {0}.</source>
        <translation>Den Prüfling in den Betriebszustand {0} schalten.</translation>
    </message>
    <message>
        <source>Switch the load {0} on.</source>
        <translation>Die Last {0} einschalten.</translation>
    </message>
    <message>
        <source>Switch the load {0} off.</source>
        <translation>Die Last {0} ausschalten.</translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor off at its plug.</source>
        <translation>Den Motor des Tisches am Stecker ausschalten.</translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor on again.</source>
        <translation>Den Motor des Tisches wieder einschalten.</translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort). No faster than {1} deg/s.</source>
        <translation>Den Tisch auf {0}° seiner Skala drehen, Hände weg, und eingeben, was sie anzeigt (oder: abort). Nicht schneller als {1} Grad/s.</translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort).</source>
        <translation>Den Tisch auf {0}° seiner Skala drehen, Hände weg, und eingeben, was sie anzeigt (oder: abort).</translation>
    </message>
    <message>
        <source>Warm the DUT within its limits, then let it cool.</source>
        <translation>Den Prüfling innerhalb seiner Grenzen erwärmen, dann abkühlen lassen.</translation>
    </message>
    <message>
        <source>Take the DUT off the platform, some metres away. Leave the reference and all else as it is.</source>
        <translation>Den Prüfling vom Tisch nehmen, einige Meter weit weg. Referenz und alles andere lassen, wie es ist.</translation>
    </message>
    <message>
        <source>Take the DUT away and put the reference at its place, on a stand that does not turn.</source>
        <translation>Den Prüfling wegnehmen und die Referenz an seinen Ort stellen, auf einen Ständer, der sich nicht dreht.</translation>
    </message>
    <message>
        <source>Put the reference at the {0}&apos;s place: {1} mm from the DUT&apos;s place, in C.</source>
        <translation>Die Referenz an den Ort von {0} stellen: {1} mm vom Ort des Prüflings, in C.</translation>
    </message>
    <message>
        <source>Put the reference at {0} mm from the DUT&apos;s place, in C, turned as it always stands.</source>
        <translation>Die Referenz bei {0} mm vom Ort des Prüflings aufstellen, in C, gedreht wie immer.</translation>
    </message>
    <message>
        <source>Put the reference {0} mm above the DUT&apos;s place, on the platform axis.</source>
        <translation>Die Referenz {0} mm über den Ort des Prüflings stellen, auf die Tischachse.</translation>
    </message>
    <message>
        <source>Put the reference {0}.</source>
        <translation>Die Referenz so aufstellen: {0}.</translation>
    </message>
    <message>
        <source>Put the scalar sensor into the cage&apos;s centre, its dead zones away from the fields.</source>
        <translation>Den Skalarsensor in die Mitte des Käfigs stellen, seine toten Zonen weg von den Feldern.</translation>
    </message>
    <message>
        <source>Swap the two leads of the half of coil {0} that stands towards +{1}. They must come back before anything else is measured, also if this run is stopped.</source>
        <translation>Die zwei Anschlüsse der Hälfte von Spule {0}, die zu +{1} hin steht, vertauschen. Sie müssen zurück, bevor irgendetwas anderes gemessen wird, auch wenn diese Messung angehalten wird.</translation>
    </message>
    <message>
        <source>Put the two leads of the half of coil {0} that stands towards +{1} back as they were.</source>
        <translation>Die zwei Anschlüsse der Hälfte von Spule {0}, die zu +{1} hin steht, zurücktauschen, wie sie waren.</translation>
    </message>
    <message>
        <source>Are all covers of the DUT as they will fly, and the others off?</source>
        <translation>Sind alle Abdeckungen des Prüflings wie im Flug, und die anderen ab?</translation>
    </message>
    <message>
        <source>Are the batteries those that will fly, and connected?</source>
        <translation>Sind die Batterien die des Flugs, und angeschlossen?</translation>
    </message>
    <message>
        <source>Are all tools out of the cage?</source>
        <translation>Ist alles Werkzeug aus dem Käfig?</translation>
    </message>
    <message>
        <source>Are phones, keys and watches out of the room?</source>
        <translation>Sind Telefone, Schlüssel und Uhren aus dem Raum?</translation>
    </message>
    <message>
        <source>Do chairs and trolleys stand at their marks?</source>
        <translation>Stehen Stühle und Wagen auf ihren Marken?</translation>
    </message>
    <message>
        <source>There is no file {0}. File of the photograph ({1}), or empty:</source>
        <translation>Es gibt keine Datei {0}. Datei des Fotos ({1}), oder leer:</translation>
    </message>
    <message>
        <source>File of the photograph ({0}), or empty:</source>
        <translation>Datei des Fotos ({0}), oder leer:</translation>
    </message>
    <message>
        <source>The coils go up to {0} µT, then the field rotates. Hands off?</source>
        <translation>Die Spulen gehen bis {0} µT, dann dreht sich das Feld. Hände weg?</translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played as {1} wants them. Hands off?</source>
        <translation>Felder bis {0} µT werden abgespielt, wie {1} sie will. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT in all directions. Hands off?</source>
        <translation>Das Feld geht auf {0} µT in alle Richtungen. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT in six directions. Hands off?</source>
        <translation>Das Feld geht auf {0} µT in sechs Richtungen. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT. Hands off?</source>
        <translation>Das Feld geht auf {0} µT. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn. Hands off?</source>
        <translation>Das Feld geht auf {0} µT, und der Tisch kann drehen. Hände weg?</translation>
    </message>
    <message>
        <source>The platform turns to {0}°. Hands off?</source>
        <translation>Der Tisch dreht auf {0}°. Hände weg?</translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°. Hands off?</source>
        <translation>Als Nächstes sucht der Tisch seine Null und dreht auf {0}°. Hände weg?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT.</source>
        <translation>Die Spulen gehen auf {0} µT.</translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn.</source>
        <translation>Die Spulen gehen auf {0} µT, und der Tisch kann drehen.</translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°.</source>
        <translation>Als Nächstes sucht der Tisch seine Null und dreht auf {0}°.</translation>
    </message>
    <message>
        <source>The field goes to {0} µT.</source>
        <translation>Das Feld geht auf {0} µT.</translation>
    </message>
    <message>
        <source>no reference has confirmed it</source>
        <translation>keine Referenz hat es bestätigt</translation>
    </message>
    <message>
        <source>Is the DUT still mounted with body {0} up, exactly as it was before the interruption?</source>
        <translation>Ist der Prüfling noch mit Körperachse {0} nach oben eingebaut, genau wie vor der Unterbrechung?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT as the DUT warms and cools. Hands off?</source>
        <translation>Das Feld geht auf {0} µT, während der Prüfling warm wird und abkühlt. Hände weg?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT. Hands off?</source>
        <translation>Die Spulen gehen auf {0} µT. Hände weg?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn. Hands off?</source>
        <translation>Die Spulen gehen auf {0} µT, und der Tisch kann drehen. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn.</source>
        <translation>Das Feld geht auf {0} µT, und die Plattform kann sich drehen.</translation>
    </message>
    <message>
        <source>The platform turns to {0}°.</source>
        <translation>Die Plattform dreht sich auf {0}°.</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, the platform turns. Hands off?</source>
        <translation>Das Feld geht auf {0} µT, der Tisch dreht. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT and stays. Hands off?</source>
        <translation>Das Feld geht auf {0} µT und bleibt. Hände weg?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, later with the DUT turning in it. Hands off?</source>
        <translation>Das Feld geht auf {0} µT, später dreht der Prüfling darin. Hände weg?</translation>
    </message>
    <message>
        <source>The field steps up to {0} µT. Hands off?</source>
        <translation>Das Feld geht in Stufen bis {0} µT. Hände weg?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT and the platform turns. Hands off?</source>
        <translation>Die Spulen gehen auf {0} µT, und der Tisch dreht. Hände weg?</translation>
    </message>
    <message>
        <source>The coils go up to {0} µT and the platform turns. Hands off?</source>
        <translation>Die Spulen gehen bis {0} µT und die Plattform dreht. Hände weg?</translation>
    </message>
    <message>
        <source>The coils step by {0} µT and the platform turns. Hands off?</source>
        <translation>Die Spulen gehen um {0} µT in Stufen, und der Tisch dreht. Hände weg?</translation>
    </message>
    <message>
        <source>A square wave of {0} µT follows. Hands off?</source>
        <translation>Ein Rechteck von {0} µT folgt. Hände weg?</translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT in turn. Hands off?</source>
        <translation>Jede Spule geht nacheinander auf {0} µT. Hände weg?</translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT. Hands off?</source>
        <translation>Jede Spule geht auf {0} µT. Hände weg?</translation>
    </message>
    <message>
        <source>Each coil alternates from {0} µT downwards. Hands off?</source>
        <translation>Jede Spule wechselt von {0} µT abwärts. Hände weg?</translation>
    </message>
    <message>
        <source>Coil {0} makes a gradient now, with the current of {1} µT. Hands off?</source>
        <translation>Spule {0} macht jetzt einen Gradienten, mit dem Strom, der sonst {1} µT macht. Hände weg?</translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played. Hands off?</source>
        <translation>Felder bis {0} µT werden abgespielt. Hände weg?</translation>
    </message>
    <message>
        <source>Every load is switched in turn, the others stay off. Hands off?</source>
        <translation>Jede Last wird nacheinander geschaltet, die anderen bleiben aus. Hände weg?</translation>
    </message>
    <message>
        <source>{0} of {1} figures changed by more than their uncertainty; the largest is E_n = {2} ({3}).</source>
        <translation>{0} von {1} Größen haben sich um mehr als ihre Unsicherheit geändert; am meisten E_n = {2} ({3}).</translation>
    </message>
    <message>
        <source>No figure changed by more than its uncertainty; the largest is E_n = {0} ({1}).</source>
        <translation>Keine Größe hat sich um mehr als ihre Unsicherheit geändert; am meisten E_n = {0} ({1}).</translation>
    </message>
    <message>
        <source>Whether the sensor changed cannot be said: a calibration states no uncertainty.</source>
        <translation>Ob sich der Sensor geändert hat, lässt sich nicht sagen: Eine Kalibrierung nennt keine Unsicherheit.</translation>
    </message>
    <message>
        <source>Offsets are not of the same state: as found {0}, as left {1}.</source>
        <translation>Nullpunkte sind nicht vom selben Zustand: vorgefunden {0}, hinterlassen {1}.</translation>
    </message>
    <message>
        <source>Offsets are those at {0}.</source>
        <translation>Nullpunkte sind die bei {0}.</translation>
    </message>
    <message>
        <source>at any state</source>
        <translation>bei jedem Zustand</translation>
    </message>
    <message>
        <source>One of the two is simulated.</source>
        <translation>Eines der beiden ist simuliert.</translation>
    </message>
    <message>
        <source>Only the earlier corrects {0}.</source>
        <translation>Nur die frühere korrigiert {0}.</translation>
    </message>
    <message>
        <source>Only the later corrects {0}.</source>
        <translation>Nur die spätere korrigiert {0}.</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number of this bench: they match {1} (dut.serial_pattern)</source>
        <translation>»{0}« ist keine Seriennummer dieses Messplatzes: sie entsprechen {1} (dut.serial_pattern)</translation>
    </message>
    <message>
        <source>{0}: a label ends in {1}</source>
        <translation>{0}: ein Etikett endet auf {1}</translation>
    </message>
    <message>
        <source>{0}: a report ends in {1}</source>
        <translation>{0}: ein Bericht endet auf {1}</translation>
    </message>
    <message>
        <source>a run needs the serial number of its DUT: --dut SERIAL</source>
        <translation>eine Messung braucht die Seriennummer ihres Prüflings</translation>
    </message>
    <message>
        <source>run {0} is of DUT {1}, the bench has {2}</source>
        <translation>Messung {0} ist von Prüfling {1}, auf dem Messplatz steht {2}</translation>
    </message>
    <message>
        <source>run {0} is of {1}, not of {2}</source>
        <translation>Messung {0} ist von {1}, nicht von {2}</translation>
    </message>
    <message>
        <source>{0} was changed since run {1} began: start it anew</source>
        <translation>{0} wurde geändert, seit Messung {1} begann: neu beginnen</translation>
    </message>
    <message>
        <source>{0} cannot go on after an interruption: start it anew</source>
        <translation>{0} kann nach einer Unterbrechung nicht weiter: neu beginnen</translation>
    </message>
    <message>
        <source>{0}: there is no such file</source>
        <translation>{0}: diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>{0}: is signed already ({1}); only a draft can be approved</source>
        <translation>{0}: ist schon signiert ({1}); nur ein Entwurf kann genehmigt werden</translation>
    </message>
    <message>
        <source>{0} is signed: its serial stands; another DUT needs a run of its own</source>
        <translation>{0} ist signiert: Die Seriennummer steht fest; ein anderer Prüfling braucht seine eigene Messung</translation>
    </message>
    <message>
        <source>another person than the operator approves: --as NAME</source>
        <translation>genehmigen muss ein anderer Mensch als der Bediener</translation>
    </message>
    <message>
        <source>aborted by the operator</source>
        <translation>vom Bediener abgebrochen</translation>
    </message>
    <message>
        <source>stopped by the operator</source>
        <translation>vom Bediener gestoppt</translation>
    </message>
    <message>
        <source>whoever ran this is gone</source>
        <translation>wer dies fuhr, ist weg</translation>
    </message>
    <message>
        <source>the window stood still for more than 4 seconds</source>
        <translation>das Fenster stand länger als 4 Sekunden still</translation>
    </message>
    <message>
        <source>only the session that drives this bench sets currents.</source>
        <translation>Nur wer diesen Messplatz fährt, stellt Ströme ein.</translation>
    </message>
    <message>
        <source>{0}: no reply in {1} s, {2} came.</source>
        <translation>{0}: keine Antwort in {1} s, {2} kam.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>only {0}</source>
        <translation>nur {0}</translation>
    </message>
    <message>
        <source>Is it switched on, and is the link in bench.toml the right one?</source>
        <translation>Ist es eingeschaltet, und stimmt die Verbindung in bench.toml?</translation>
    </message>
    <message>
        <source>{0}: the link was lost ({1}).</source>
        <translation>{0}: Die Verbindung ging verloren ({1}).</translation>
    </message>
    <message>
        <source>{0}: the link was lost.</source>
        <translation>{0}: Die Verbindung ging verloren.</translation>
    </message>
    <message>
        <source>{0}: the link does not open.</source>
        <translation>{0}: Die Verbindung lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>{0}: the link does not open ({1}).</source>
        <translation>{0}: Die Verbindung lässt sich nicht öffnen ({1}).</translation>
    </message>
    <message>
        <source>{0}; where that is as it should be, accept = [&quot;{1}&quot;] in the mapping says so</source>
        <translation>{0}; wo das so sein soll, sagt es accept = [&quot;{1}&quot;] in der Zuordnung</translation>
    </message>
    <message>
        <source>{0}: are axes swapped or turned about?</source>
        <translation>{0}: sind Achsen vertauscht oder umgedreht?</translation>
    </message>
    <message>
        <source>the readings fit the reference with axes {0} {1} times better than as stated</source>
        <translation>die Messwerte passen zur Referenz mit den Achsen {0} {1}-mal besser als mit den angegebenen</translation>
    </message>
    <message>
        <source>{0}: is the unit of one of them wrong, by a factor of {1}?</source>
        <translation>{0}: ist eine der beiden Einheiten falsch, um den Faktor {1}?</translation>
    </message>
    <message>
        <source>readings of {0} nT in the median beside a reference of {1} nT</source>
        <translation>Messwerte von {0} nT im Median neben einer Referenz von {1} nT</translation>
    </message>
    <message>
        <source>{0}: write the mapping by hand; it has {1}</source>
        <translation>{0}: die Zuordnung von Hand schreiben; die Datei hat {1}</translation>
    </message>
    <message>
        <source>{0}: no three columns beside a clock look like a magnetometer</source>
        <translation>{0}: keine drei Spalten neben einer Zeit sehen nach einem Magnetometer aus</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: letters and digits, and . : + # ( ) - or blanks between them</source>
        <translation>»{0}« ist keine Seriennummer: Buchstaben und Ziffern, dazwischen . : + # ( ) - oder Leerzeichen</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, which have no \ .. or control characters</source>
        <translation>»{0}« ist keine Seriennummer: sie wird Teil von Dateinamen, in denen kein \ oder .. und keine Steuerzeichen stehen</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, where a / parts folders; a bench whose serials have one says so (dut.serial_pattern)</source>
        <translation>»{0}« ist keine Seriennummer: sie wird Teil von Dateinamen, in denen / Ordner trennt; ein Messplatz, dessen Seriennummern eines haben, sagt es (dut.serial_pattern)</translation>
    </message>
    <message>
        <source>{0}: would lie among what is labcal&apos;s own; name another folder</source>
        <translation>{0}: läge unter dem, was labcal gehört; einen anderen Ordner nennen</translation>
    </message>
    <message>
        <source>{0}: a label has a QR code: pip install &apos;labcal[paper]&apos;</source>
        <translation>{0}: ein Etikett hat einen QR-Code: pip install &apos;labcal[paper]&apos;</translation>
    </message>
    <message>
        <source>the operator&apos;s name must be one printable line of at most {0} letters</source>
        <translation>der Name der Bedienperson muss eine druckbare Zeile von höchstens {0} Zeichen sein</translation>
    </message>
    <message>
        <source>“{0}” is no name: letters, digits, blanks, and . , &apos; - _ @ + &amp; / ( ) between them</source>
        <translation>»{0}« ist kein Name: Buchstaben, Ziffern, Leerzeichen, dazwischen . , &apos; - _ @ + &amp; / ( )</translation>
    </message>
    <message>
        <source>run {0} is none to be gone on with: it is {1}</source>
        <translation>Messung {0} ist nicht fortzusetzen: sie ist {1}</translation>
    </message>
    <message>
        <source>{0}: is no bench file: nothing that stands in it is of a bench</source>
        <translation>{0}: ist keine Datei eines Messplatzes: Nichts, was darin steht, gehört zu einem</translation>
    </message>
    <message>
        <source>{0}: {1} is not a key that is known here</source>
        <translation>{0}: {1} ist kein Schlüssel, der hier bekannt ist</translation>
    </message>
    <message>
        <source>{0}; nothing was made</source>
        <translation>{0}; nichts wurde gemacht</translation>
    </message>
    <message>
        <source>the passphrase is empty</source>
        <translation>das Kennwort ist leer</translation>
    </message>
    <message>
        <source>the passphrase has {0} characters and needs {1}: four words are easy to keep</source>
        <translation>das Kennwort hat {0} Zeichen und braucht {1}: vier Wörter sind leicht zu merken</translation>
    </message>
    <message>
        <source>the passphrase is {0}: four words are easy to keep</source>
        <translation>das Kennwort ist {0}: vier Wörter sind leicht zu merken</translation>
    </message>
    <message>
        <source>three signs over and over</source>
        <translation>drei Zeichen immer wieder</translation>
    </message>
    <message>
        <source>the name of the key&apos;s own person</source>
        <translation>der Name der Person selbst</translation>
    </message>
    <message>
        <source>a common word alone</source>
        <translation>ein gewöhnliches Wort allein</translation>
    </message>
    <message>
        <source>a row of the keyboard, or of the alphabet</source>
        <translation>eine Reihe der Tastatur oder des Alphabets</translation>
    </message>
    <message>
        <source>{0}: the archive cannot be reached: {1}; nothing is lost: what is not there yet goes there with the next push</source>
        <translation>{0}: das Archiv ist nicht zu erreichen: {1}; nichts ist verloren: was noch nicht dort ist, kommt mit dem nächsten Übertragen dorthin</translation>
    </message>
    <message>
        <source>{0}: there is no archive here that this role can see: its owner makes it by `labcal archive init`</source>
        <translation>{0}: hier gibt es kein Archiv, das diese Rolle sehen kann: sein Eigentümer legt es mit `labcal archive init` an</translation>
    </message>
    <message>
        <source>{0}: its catalogue is of version {1}, and this labcal works with {2}: its owner runs `labcal archive init` once</source>
        <translation>{0}: sein Katalog hat die Version {1}, dieses labcal arbeitet mit {2}: sein Eigentümer ruft einmal `labcal archive init` auf</translation>
    </message>
    <message>
        <source>{0}: a newer labcal made its catalogue (version {1}, this one knows {2}): update labcal here</source>
        <translation>{0}: ein neueres labcal hat seinen Katalog angelegt (Version {1}, dieses kennt {2}): labcal hier aktualisieren</translation>
    </message>
    <message>
        <source>the archive needs SQLAlchemy, Alembic and psycopg: pip install &apos;labcal[archive]&apos;</source>
        <translation>das Archiv braucht SQLAlchemy, Alembic und psycopg: pip install &apos;labcal[archive]&apos;</translation>
    </message>
    <message>
        <source>{0}: bundles cannot be kept or read there: {1}</source>
        <translation>{0}: Pakete sind dort nicht abzulegen oder zu lesen: {1}</translation>
    </message>
    <message>
        <source>{0}: the check standard {1} is out of control ({2}). No procedure begins on this bench: measure it again (--dut {3}), or let a person answer for it: --override NAME --because TEXT</source>
        <translation>{0}: das Prüfnormal {1} ist außer Kontrolle ({2}). Auf diesem Messplatz beginnt keine Prozedur: es noch einmal messen (seine Nummer als Prüfling; --dut {3}), oder jemand steht auf der Befehlszeile dafür ein: --override NAME --because TEXT</translation>
    </message>
    <message>
        <source>the check standard {0} is out of control ({1})</source>
        <translation>das Prüfnormal {0} ist außer Kontrolle ({1})</translation>
    </message>
    <message>
        <source>No procedure begins on this bench: measure the check standard again, or let a person answer for it.</source>
        <translation>Auf diesem Messplatz beginnt keine Prozedur: das Prüfnormal noch einmal messen, oder eine Person dafür einstehen lassen.</translation>
    </message>
    <message>
        <source>stopped by the operator, to be gone on with later</source>
        <translation>vom Bediener angehalten, um später fortzufahren</translation>
    </message>
    <message>
        <source>Is it switched on, are address and baud rate right, are A and B not swapped?</source>
        <translation>Ist es eingeschaltet, stimmen Adresse und Baudrate, sind A und B nicht vertauscht?</translation>
    </message>
    <message>
        <source>another process ({0}) keeps the platform&apos;s line and does not stop it</source>
        <translation>ein anderer Prozess ({0}) behält die Leitung des Tisches und hält ihn nicht an</translation>
    </message>
    <message>
        <source>It has answered at this link before: is its plug in at both ends, and has it power?</source>
        <translation>Es hat an dieser Verbindung schon geantwortet: Steckt sein Stecker an beiden Enden, und hat es Strom?</translation>
    </message>
    <message>
        <source>{0}: this user may not open it ({1}).</source>
        <translation>{0}: Dieser Benutzer darf es nicht öffnen ({1}).</translation>
    </message>
    <message>
        <source>{0}: this user may not open it.</source>
        <translation>{0}: Dieser Benutzer darf es nicht öffnen.</translation>
    </message>
    <message>
        <source>{0}: another program has opened it ({1}).</source>
        <translation>{0}: Ein anderes Programm hat es geöffnet ({1}).</translation>
    </message>
    <message>
        <source>{0}: another program has opened it.</source>
        <translation>{0}: Ein anderes Programm hat es geöffnet.</translation>
    </message>
    <message>
        <source>the guardian did not start.</source>
        <translation>Der Wächter ist nicht gestartet.</translation>
    </message>
    <message>
        <source>a guardian holds the ports and does not answer.</source>
        <translation>Ein Wächter hält die Anschlüsse und antwortet nicht.</translation>
    </message>
    <message>
        <source>the guardian has not answered for {0} s: it hangs, or was stopped; how the coils are is not known.</source>
        <translation>Der Wächter hat seit {0} s nicht geantwortet: Er hängt oder wurde angehalten; wie die Spulen stehen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>It is tried again and again; no run begins before it answers.</source>
        <translation>Es wird immer wieder versucht; kein Lauf beginnt, bevor es antwortet.</translation>
    </message>
    <message>
        <source>Switch the supplies off by hand.</source>
        <translation>Die Netzgeräte von Hand ausschalten.</translation>
    </message>
    <message>
        <source>zero was ordered for all coils: {0}.</source>
        <translation>Für alle Spulen wurde null befohlen: {0}.</translation>
    </message>
    <message>
        <source>zero was ordered{0}; what was being asked of this line was given up.</source>
        <translation>Null wurde befohlen{0}; was auf dieser Leitung gefragt war, wurde aufgegeben.</translation>
    </message>
    <message>
        <source>See guardian.log; what was measured since then was measured without them.</source>
        <translation>Siehe guardian.log; was seither gemessen wurde, wurde ohne sie gemessen.</translation>
    </message>
    <message>
        <source>See guardian.log in labcal&apos;s data folder.</source>
        <translation>Siehe guardian.log im Datenordner von labcal.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and nothing flows.</source>
        <translation>Spule {0}: {1} A wurden eingestellt, und nichts fließt.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and {2} A flows.</source>
        <translation>Spule {0}: {1} A wurden eingestellt, und {2} A fließen.</translation>
    </message>
    <message>
        <source>Is the winding whole, does the voltage suffice? Set the coils off.</source>
        <translation>Ist die Wicklung heil, reicht die Spannung? Spulen ausschalten.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square over {2} s, its limit is {3} A.</source>
        <translation>Spule {0}: {1} A effektiv über {2} s, die Grenze ist {3} A.</translation>
    </message>
    <message>
        <source>Let the winding cool, then use less current or shorter times.</source>
        <translation>Die Wicklung abkühlen lassen, dann weniger Strom oder kürzere Zeiten nehmen.</translation>
    </message>
    <message>
        <source>coil {0}: the contacts did not switch to {1}.</source>
        <translation>Spule {0}: Die Kontakte haben nicht auf {1} geschaltet.</translation>
    </message>
    <message>
        <source>Look at the relay and its supply.</source>
        <translation>Das Relais und seine Versorgung ansehen.</translation>
    </message>
    <message>
        <source>{0}: the interlock is open.</source>
        <translation>{0}: Die Verriegelung ist offen.</translation>
    </message>
    <message>
        <source>It closes when every coil is read back at zero; `guardian.log` says which is not.</source>
        <translation>Sie schließt, wenn jede Spule auf null zurückgelesen ist; `guardian.log` sagt, welche es nicht ist.</translation>
    </message>
    <message>
        <source>{0}: its {1} protection tripped.</source>
        <translation>{0}: Der Schutz ({1}) hat ausgelöst.</translation>
    </message>
    <message>
        <source>{0}: a reading at full scale.</source>
        <translation>{0}: eine Ablesung am Anschlag.</translation>
    </message>
    <message>
        <source>{0}: {1} samples came in {2} s, too few to say anything.</source>
        <translation>{0}: {1} Werte kamen in {2} s, zu wenige, um etwas zu sagen.</translation>
    </message>
    <message>
        <source>Look at its power and its cable, or listen for longer.</source>
        <translation>Versorgung und Kabel ansehen, oder länger hören.</translation>
    </message>
    <message>
        <source>the computer&apos;s clock was set back by {0} s.</source>
        <translation>Die Uhr des Computers wurde um {0} s zurückgestellt.</translation>
    </message>
    <message>
        <source>Set the clock right and start the run again.</source>
        <translation>Die Uhr richtig stellen und die Messung neu beginnen.</translation>
    </message>
    <message>
        <source>Switch {0} off by hand before anything else.</source>
        <translation>Vor allem anderen {0} von Hand ausschalten.</translation>
    </message>
    <message>
        <source>zero, open</source>
        <translation>null, offen</translation>
    </message>
    <message>
        <source>VALID: signed by {0}.</source>
        <translation>GÜLTIG: signiert von {0}.</translation>
    </message>
    <message>
        <source>NOT VALID: {0} carries no signature.</source>
        <translation>NICHT GÜLTIG: {0} trägt keine Signatur.</translation>
    </message>
    <message>
        <source>NOT VALID.</source>
        <translation>NICHT GÜLTIG.</translation>
    </message>
    <message>
        <source>It was made from the run that was named.</source>
        <translation>Es wurde aus der genannten Messung gemacht.</translation>
    </message>
    <message>
        <source>It was not made from the run that was named ({0} differs).</source>
        <translation>Es wurde nicht aus der genannten Messung gemacht ({0} weicht ab).</translation>
    </message>
    <message>
        <source>Worked out again from its run, it is the same.</source>
        <translation>Aus seiner Messung neu gerechnet, ist es dasselbe.</translation>
    </message>
    <message>
        <source>It was not worked out again: {0}.</source>
        <translation>Es wurde nicht neu gerechnet: {0}.</translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}. The signature stands.</source>
        <translation>Aus seiner Messung neu gerechnet, weicht es ab: {0}. Die Signatur gilt.</translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}.</source>
        <translation>Aus seiner Messung neu gerechnet, weicht es ab: {0}.</translation>
    </message>
    <message>
        <source>PROVISIONAL: {0}.</source>
        <translation>VORLÄUFIG: {0}.</translation>
    </message>
    <message>
        <source>EXPIRED: it was good until {0}.</source>
        <translation>ABGELAUFEN: gültig war es bis {0}.</translation>
    </message>
    <message>
        <source>SUPERSEDED: by the calibration of run {0}.</source>
        <translation>ERSETZT: durch die Kalibrierung aus Messung {0}.</translation>
    </message>
    <message>
        <source>SIMULATED: it describes no real sensor.</source>
        <translation>SIMULIERT: Es beschreibt keinen wirklichen Sensor.</translation>
    </message>
    <message>
        <source>no approver is named</source>
        <translation>kein Genehmigender ist genannt</translation>
    </message>
    <message>
        <source>named as approver, but is the operator: {0}</source>
        <translation>als Genehmigender genannt, aber Bediener: {0}</translation>
    </message>
    <message>
        <source>named as approver, but has not signed: {0}</source>
        <translation>als Genehmigender genannt, hat aber nicht signiert: {0}</translation>
    </message>
    <message>
        <source>named as approver, but has not the role approve: {0}</source>
        <translation>als Genehmiger genannt, aber ohne die Rolle approve: {0}</translation>
    </message>
    <message>
        <source>its operator, {0}, has not the role measure</source>
        <translation>Bediener {0} hat die Rolle measure nicht</translation>
    </message>
    <message>
        <source>nobody but its operator has signed who has the role release</source>
        <translation>niemand außer dem Bediener hat signiert, der die Rolle release hat</translation>
    </message>
    <message>
        <source>its numbers were not confirmed by its run</source>
        <translation>seine Zahlen wurden von seiner Messung nicht bestätigt</translation>
    </message>
    <message>
        <source>its run did not measure {0}</source>
        <translation>ihre Messung hat {0} nicht bestimmt</translation>
    </message>
    <message>
        <source>Not measured by this run, and held as they stand: {0}.</source>
        <translation>Von dieser Messung nicht bestimmt, und geblieben, wie sie sind: {0}.</translation>
    </message>
    <message>
        <source>Unexplained by the closed loop: {0} nT are left of held-out rows, where noise alone leaves {1}; U takes that for random.</source>
        <translation>Vom geschlossenen Kreis nicht erklärt: {0} nT bleiben in zurückgehaltenen Zeilen, wo Rauschen allein {1} lässt; U nimmt das als zufällig.</translation>
    </message>
    <message>
        <source>its run did not measure {0}: nobody can approve that; turn about the other body axes as well</source>
        <translation>ihre Messung hat {0} nicht bestimmt: das kann niemand genehmigen; auch um die anderen Körperachsen drehen</translation>
    </message>
    <message>
        <source>zero, not open</source>
        <translation>null, nicht offen</translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s.</source>
        <translation>{0}: seit {1} s kein Wert.</translation>
    </message>
    <message>
        <source>{0}: no answer.</source>
        <translation>{0}: keine Antwort.</translation>
    </message>
    <message>
        <source>{0}: the same reading for {1} s.</source>
        <translation>{0}: seit {1} s dieselbe Ablesung.</translation>
    </message>
    <message>
        <source>{0}: no temperature for {1} s, and it has a limit.</source>
        <translation>{0}: seit {1} s keine Temperatur, und sie hat eine Grenze.</translation>
    </message>
    <message>
        <source>{0}: {1} is {2} degC, its limit is {3} degC.</source>
        <translation>{0}: {1} ist {2} °C, die Grenze ist {3} °C.</translation>
    </message>
    <message>
        <source>{0}: a field of {1} nT is seen, the limit is {2} nT.</source>
        <translation>{0}: Ein Feld von {1} nT wird gesehen, die Grenze ist {2} nT.</translation>
    </message>
    <message>
        <source>no samples came from {0}.</source>
        <translation>von {0} kamen keine Werte.</translation>
    </message>
    <message>
        <source>{0}: it sent nothing at {1} of this turn.</source>
        <translation>{0}: Er sandte bei {1} dieser Drehung nichts.</translation>
    </message>
    <message>
        <source>{0}: still not seen: {1}.</source>
        <translation>{0}: noch nicht gesehen: {1}.</translation>
    </message>
    <message>
        <source>Is its plug in at both ends, and has it power? Nobody can tell from here which it is.</source>
        <translation>Steckt sein Stecker an beiden Enden, und hat es Strom? Von hier aus kann niemand sagen, woran es liegt.</translation>
    </message>
    <message>
        <source>Switch the sensor off and on, and look at its range.</source>
        <translation>Den Sensor aus- und einschalten und seinen Messbereich ansehen.</translation>
    </message>
    <message>
        <source>Is the ambient field what it was when it was measured last?</source>
        <translation>Ist das Umgebungsfeld, wie es zuletzt gemessen wurde?</translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names, and is its link the right one?</source>
        <translation>Ist es das Gerät, das bench.toml nennt, und stimmt seine Verbindung?</translation>
    </message>
    <message>
        <source>Plug it in, see that nobody else has opened it, then try again.</source>
        <translation>Einstecken, nachsehen, dass es niemand sonst geöffnet hat, dann noch einmal.</translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names? Look at its cable, then try again.</source>
        <translation>Ist es das Gerät, das bench.toml nennt? Das Kabel ansehen, dann noch einmal.</translation>
    </message>
    <message>
        <source>Look at its panel, then try again.</source>
        <translation>Seine Anzeige ansehen, dann noch einmal.</translation>
    </message>
    <message>
        <source>Look for what holds it, home it and try again.</source>
        <translation>Suchen, was es aufhält, es auf null fahren und noch einmal.</translation>
    </message>
    <message>
        <source>Look at the stage, home it and try again.</source>
        <translation>Den Tisch ansehen, auf null fahren und noch einmal.</translation>
    </message>
    <message>
        <source>{0}: there is no key for {1} here; `labcal keys new --name {2}` makes one</source>
        <translation>{0}: Für {1} gibt es hier keinen Schlüssel; `labcal keys new --name {2}` macht einen</translation>
    </message>
    <message>
        <source>{0}: does not open: the passphrase is wrong or the file is damaged</source>
        <translation>{0}: öffnet sich nicht: Das Kennwort ist falsch oder die Datei beschädigt</translation>
    </message>
    <message>
        <source>{0}: {1} has a key already; a second one would replace it (`labcal keys revoke {2}` where it is lost)</source>
        <translation>{0}: {1} hat schon einen Schlüssel; ein zweiter würde ihn ersetzen (`labcal keys revoke {2}`, wo er verloren ist)</translation>
    </message>
    <message>
        <source>broken off by its store: {0}</source>
        <translation>vom Speicher unterbrochen: {0}</translation>
    </message>
    <message>
        <source>broken off: {0}</source>
        <translation>unterbrochen: {0}</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>eingelesen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>No whole calibration can come of one body axis: it does not determine all 12 parameters of the map. It repeats or checks turns.</source>
        <translation>Aus einer Körperachse allein wird keine ganze Kalibrierung: Sie bestimmt nicht alle 12 Parameter der Abbildung. Sie wiederholt oder prüft Drehungen.</translation>
    </message>
    <message>
        <source>Alternate each coil&apos;s current with falling amplitude, and compare the ambient field before and after.</source>
        <translation>Den Strom jeder Spule mit fallender Amplitude wechseln lassen und das Umgebungsfeld vorher und nachher vergleichen.</translation>
    </message>
    <message>
        <source>Calibrate the DUT at rest: the coils play directions all over; K and k in the cage&apos;s frame.</source>
        <translation>Den ruhenden Prüfling kalibrieren: Die Spulen stellen Richtungen ringsum ein; K und k im System des Käfigs.</translation>
    </message>
    <message>
        <source>Check sign, order and handedness of cage, reference and DUT, and the sense of the angle.</source>
        <translation>Vorzeichen, Reihenfolge und Händigkeit von Käfig, Referenz und Prüfling und den Drehsinn prüfen.</translation>
    </message>
    <message>
        <source>Check the reference&apos;s due date, its zero by 180° turns, and its magnitude against direction and a standard.</source>
        <translation>Fälligkeit der Referenz prüfen, ihren Nullpunkt durch 180°-Drehungen und ihren Betrag gegen Richtung und Normal.</translation>
    </message>
    <message>
        <source>Find where DUT and reference stand, from the gradients of coil pairs with one half reversed.</source>
        <translation>Finden, wo Prüfling und Referenz stehen, aus den Gradienten von Spulenpaaren mit einer umgepolten Hälfte.</translation>
    </message>
    <message>
        <source>Go through the checklist; every &quot;no&quot; is named at the end.</source>
        <translation>Die Checkliste durchgehen; jedes Nein wird am Ende genannt.</translation>
    </message>
    <message>
        <source>Hold a field by feedback on the reference, taken over from the open-loop set-point without a bump.</source>
        <translation>Ein Feld durch Rückführung der Referenz halten, stoßfrei aus dem gesteuerten Sollwert übernommen.</translation>
    </message>
    <message>
        <source>Map the field of each coil over the working volume, computed and probed.</source>
        <translation>Das Feld jeder Spule über das Nutzvolumen kartieren, gerechnet und gemessen.</translation>
    </message>
    <message>
        <source>Measure heading and magnitude error at independent positions; `calibration`, where it is stated, is judged.</source>
        <translation>Richtungs- und Betragsfehler an unabhängigen Stellungen messen; `calibration` wird beurteilt, wo sie angegeben ist.</translation>
    </message>
    <message>
        <source>Measure mean, drift, noise and mains of the room, and say whether it is fit for the job.</source>
        <translation>Mittel, Drift, Rauschen und Netzbrumm des Raums messen und sagen, ob er sich eignet.</translation>
    </message>
    <message>
        <source>Measure offset and gain against the DUT&apos;s temperature while it changes.</source>
        <translation>Nullpunkt und Verstärkung über der Temperatur des Prüflings messen, während sie sich ändert.</translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s offset from four attitudes in the ambient field, coils off.</source>
        <translation>Den Nullpunkt des Prüflings aus vier Lagen im Umgebungsfeld messen, Spulen aus.</translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s permanent and induced dipole from what the reference sees of it at two distances.</source>
        <translation>Dauer- und induziertes Dipolmoment des Prüflings messen, aus dem, was die Referenz in zwei Abständen davon sieht.</translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix and offset at the DUT&apos;s place and at the reference&apos;s; a draft.</source>
        <translation>Matrix von Strom zu Feld und Nullfeld am Ort des Prüflings und der Referenz messen; ein Entwurf.</translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix, its squareness and the ambient field by a scalar sensor in the centre.</source>
        <translation>Matrix von Strom zu Feld, ihre Rechtwinkligkeit und das Umgebungsfeld mit einem Skalarsensor in der Mitte messen.</translation>
    </message>
    <message>
        <source>Measure the delay of DUT, reference and angle against the set-point and each other.</source>
        <translation>Den Verzug von Prüfling, Referenz und Winkel gegen den Sollwert und gegeneinander messen.</translation>
    </message>
    <message>
        <source>Measure the platform&apos;s own field with the reference at the DUT&apos;s place, coils off.</source>
        <translation>Das Eigenfeld des Tisches mit der Referenz am Ort des Prüflings messen, Spulen aus.</translation>
    </message>
    <message>
        <source>Play a field history, with the tracking error recorded.</source>
        <translation>Einen Feldverlauf abspielen und den Folgefehler aufzeichnen.</translation>
    </message>
    <message>
        <source>Repeat one rotation, with the coils off in between.</source>
        <translation>Eine Drehung wiederholen, dazwischen Spulen aus.</translation>
    </message>
    <message>
        <source>Step the field along a body axis (or two together) and measure the departure from a straight line.</source>
        <translation>Das Feld entlang einer Körperachse (oder zweier zugleich) stufen und die Abweichung von einer Geraden messen.</translation>
    </message>
    <message>
        <source>Switch each load and measure the bias per ampere (3 × N) and its delay, coils off.</source>
        <translation>Jede Last schalten und die Störung je Ampere (3 × N) und ihren Verzug messen, Spulen aus.</translation>
    </message>
    <message>
        <source>The whole calibration before flight, from the zero to the closing.</source>
        <translation>Die ganze Kalibrierung vor dem Flug, vom Nullpunkt bis zur Schlussprüfung.</translation>
    </message>
    <message>
        <source>Turn once forwards and once backwards at one rate.</source>
        <translation>Einmal vorwärts und einmal rückwärts drehen, mit einer Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Turn the DUT about one body axis in one steady field; one axis is not enough for a calibration by itself.</source>
        <translation>Den Prüfling in einem ruhigen Feld um eine Körperachse drehen; eine Achse allein reicht für keine Kalibrierung.</translation>
    </message>
    <message>
        <source>Turn there and back at several rates in one mounting.</source>
        <translation>Mit mehreren Geschwindigkeiten hin und zurück drehen, ohne umzubauen.</translation>
    </message>
    <message>
        <source>[cage.geometry] with halves that a person can reverse; a vector reference</source>
        <translation>[cage.geometry] mit Hälften, die ein Mensch umpolen kann; eine Vektorreferenz</translation>
    </message>
    <message>
        <source>a vector reference</source>
        <translation>eine Vektorreferenz</translation>
    </message>
    <message>
        <source>a vector reference that can be moved, the coils&apos; geometry in bench.toml</source>
        <translation>eine bewegliche Vektorreferenz, die Geometrie der Spulen in bench.toml</translation>
    </message>
    <message>
        <source>a vector reference, first at the DUT&apos;s place, then at its own</source>
        <translation>eine Vektorreferenz, erst am Ort des Prüflings, dann an ihrem eigenen</translation>
    </message>
    <message>
        <source>an absolute scalar sensor in the cage&apos;s centre</source>
        <translation>ein absoluter Skalarsensor in der Mitte des Käfigs</translation>
    </message>
    <message>
        <source>nothing magnetic in the cage that must not be touched</source>
        <translation>nichts Magnetisches im Käfig, das nicht berührt werden darf</translation>
    </message>
    <message>
        <source>the DUT as it will fly, and a camera</source>
        <translation>der Prüfling, wie er fliegen wird, und eine Kamera</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage</source>
        <translation>der Prüfling ruht im Käfig</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a table of the field, an orbit, or a simulator</source>
        <translation>der Prüfling ruht im Käfig; eine Tabelle des Felds, eine Bahn oder ein Simulator</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a vector reference at its place, or an approved cage calibration</source>
        <translation>der Prüfling ruht im Käfig; eine Vektorreferenz an seinem Ort oder eine genehmigte Käfigkalibrierung</translation>
    </message>
    <message>
        <source>the DUT free to be turned over by hand</source>
        <translation>der Prüfling lässt sich von Hand wenden</translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor</source>
        <translation>der Prüfling auf einem Tisch mit Motor</translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor, a vector reference that can be moved beside it</source>
        <translation>der Prüfling auf einem Tisch mit Motor, daneben eine bewegliche Vektorreferenz</translation>
    </message>
    <message>
        <source>the DUT on the platform</source>
        <translation>der Prüfling auf dem Tisch</translation>
    </message>
    <message>
        <source>the DUT on the platform, a vector reference</source>
        <translation>der Prüfling auf dem Tisch, eine Vektorreferenz</translation>
    </message>
    <message>
        <source>the DUT on the platform, its calibration file</source>
        <translation>der Prüfling auf dem Tisch, seine Kalibrierdatei</translation>
    </message>
    <message>
        <source>the DUT&apos;s own, that is judged; without one nothing is</source>
        <translation>die des Prüflings, die beurteilt wird; ohne sie wird nichts beurteilt</translation>
    </message>
    <message>
        <source>the DUT on the platform, loads of the spacecraft that can be switched</source>
        <translation>der Prüfling auf dem Tisch, schaltbare Lasten des Raumfahrzeugs</translation>
    </message>
    <message>
        <source>the DUT on the platform, remounted three times; a vector reference</source>
        <translation>der Prüfling auf dem Tisch, dreimal umgebaut; eine Vektorreferenz</translation>
    </message>
    <message>
        <source>the DUT with its thermometer, a means to warm it</source>
        <translation>der Prüfling mit seinem Thermometer, etwas zum Erwärmen</translation>
    </message>
    <message>
        <source>the bare fixture with the motor, a vector reference at the DUT&apos;s place</source>
        <translation>die leere Halterung mit dem Motor, eine Vektorreferenz am Ort des Prüflings</translation>
    </message>
    <message>
        <source>the cage as it will be used, coils off</source>
        <translation>der Käfig, wie er benutzt wird, Spulen aus</translation>
    </message>
    <message>
        <source>the reference on the platform</source>
        <translation>die Referenz auf dem Tisch</translation>
    </message>
    <message>
        <source>Altitude km</source>
        <translation>Höhe km</translation>
    </message>
    <message>
        <source>Apart mm</source>
        <translation>Abstand mm</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Change ppm</source>
        <translation>Änderung ppm</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Chip</source>
        <translation>Takt</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>Closure</source>
        <translation>Schluss</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Zyklen</translation>
    </message>
    <message>
        <source>Dead</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Drift nT per min</source>
        <translation>Drift nT/min</translation>
    </message>
    <message>
        <source>Due days</source>
        <translation>Fällig nach Tagen</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Verweilen</translation>
    </message>
    <message>
        <source>Epoch</source>
        <translation>Zeitpunkt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Oberwellen</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Homogeneity ppm</source>
        <translation>Homogenität ppm</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Limit Am2</source>
        <translation>Grenze Am²</translation>
    </message>
    <message>
        <source>Limit ppm</source>
        <translation>Grenze ppm</translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation>Linearität</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Magnitudes</source>
        <translation>Beträge</translation>
    </message>
    <message>
        <source>Mains</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Mains hz</source>
        <translation>Netz Hz</translation>
    </message>
    <message>
        <source>Max age</source>
        <translation>Höchstes Alter</translation>
    </message>
    <message>
        <source>Misfit mm</source>
        <translation>Abweichung mm</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Model ppm</source>
        <translation>Modell ppm</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>Modulus</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>Mountings</source>
        <translation>Einbauten</translation>
    </message>
    <message>
        <source>N directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Drehraten</translation>
    </message>
    <message>
        <source>Relay ppm</source>
        <translation>Relais ppm</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Scale ppm</source>
        <translation>Skala ppm</translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation>Zweite Achse</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Stille</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Rechter Winkel</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Wie oft</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Zeitfehler</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Drehungen</translation>
    </message>
    <message>
        <source>U cage ppm</source>
        <translation>U Käfig ppm</translation>
    </message>
    <message>
        <source>U mounting</source>
        <translation>U Einbau</translation>
    </message>
    <message>
        <source>U place</source>
        <translation>U Ort</translation>
    </message>
    <message>
        <source>U standard</source>
        <translation>U Normal</translation>
    </message>
    <message>
        <source>U time</source>
        <translation>U Zeit</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>U Drehung</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüffelder</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>the DUT&apos;s power mode</source>
        <translation>Betriebszustand des Prüflings</translation>
    </message>
    <message>
        <source>body axis mounted along the platform axis</source>
        <translation>Körperachse, die längs der Tischachse steht</translation>
    </message>
    <message>
        <source>field from the platform axis</source>
        <translation>Feld gegen die Tischachse</translation>
    </message>
    <message>
        <source>magnitude of the field</source>
        <translation>Betrag des Felds</translation>
    </message>
    <message>
        <source>recorded at each step</source>
        <translation>je Stufe aufgezeichnet</translation>
    </message>
    <message>
        <source>largest departure that passes</source>
        <translation>größte Abweichung, die besteht</translation>
    </message>
    <message>
        <source>of every turn</source>
        <translation>jeder Drehung</translation>
    </message>
    <message>
        <source>recorded in each field</source>
        <translation>je Feld aufgezeichnet</translation>
    </message>
    <message>
        <source>fields that no fit sees, at the end</source>
        <translation>Felder am Ende, die kein Fit sieht</translation>
    </message>
    <message>
        <source>how well the axis is mounted; 0: not stated</source>
        <translation>wie genau die Achse steht; 0: nicht genannt</translation>
    </message>
    <message>
        <source>0: as fast as timing and the range allow</source>
        <translation>0: so schnell, wie die Zeiten und der Bereich es erlauben</translation>
    </message>
    <message>
        <source>error that timing may make</source>
        <translation>erlaubter Fehler durch Zeitversatz</translation>
    </message>
    <message>
        <source>0: continuous, else stepped</source>
        <translation>0: stetig, sonst in Schritten</translation>
    </message>
    <message>
        <source>coils-off zero before</source>
        <translation>Nullpunkt davor, Spulen aus</translation>
    </message>
    <message>
        <source>how long to listen</source>
        <translation>wie lange gehört wird</translation>
    </message>
    <message>
        <source>the mains</source>
        <translation>das Netz</translation>
    </message>
    <message>
        <source>of the mains, looked for</source>
        <translation>des Netzes, die gesucht werden</translation>
    </message>
    <message>
        <source>how long to listen for it, at the fastest rate</source>
        <translation>wie lange danach gehört wird, so schnell wie möglich</translation>
    </message>
    <message>
        <source>largest amplitude of it that passes</source>
        <translation>größte Amplitude davon, die besteht</translation>
    </message>
    <message>
        <source>of the rotation that is planned</source>
        <translation>der geplanten Drehung</translation>
    </message>
    <message>
        <source>fastest drift that passes</source>
        <translation>schnellste Drift, die besteht</translation>
    </message>
    <message>
        <source>largest noise of one sample that passes</source>
        <translation>größtes Rauschen eines Werts, das besteht</translation>
    </message>
    <message>
        <source>step of the field on each coil</source>
        <translation>Feldstufe je Spule</translation>
    </message>
    <message>
        <source>the small turn</source>
        <translation>die kleine Drehung</translation>
    </message>
    <message>
        <source>how far an axis may point beside</source>
        <translation>wie weit eine Achse danebenzeigen darf</translation>
    </message>
    <message>
        <source>largest step of each coil</source>
        <translation>größte Stufe je Spule</translation>
    </message>
    <message>
        <source>steps of one sign, from zero to the largest</source>
        <translation>Stufen eines Vorzeichens, von null bis zur größten</translation>
    </message>
    <message>
        <source>largest uncertainty of the matrix that passes</source>
        <translation>größte Unsicherheit der Matrix, die besteht</translation>
    </message>
    <message>
        <source>largest change from bench.toml that passes</source>
        <translation>größte Änderung gegen bench.toml, die besteht</translation>
    </message>
    <message>
        <source>largest difference of the polarities</source>
        <translation>größter Unterschied der Polungen</translation>
    </message>
    <message>
        <source>largest departure from the line that passes</source>
        <translation>größte Abweichung von der Geraden, die besteht</translation>
    </message>
    <message>
        <source>largest difference of up and down that passes</source>
        <translation>größter Unterschied von auf und ab, der besteht</translation>
    </message>
    <message>
        <source>side of the square coils</source>
        <translation>Seite der quadratischen Spulen</translation>
    </message>
    <message>
        <source>distance of a pair, in sides</source>
        <translation>Abstand eines Paars, in Seiten</translation>
    </message>
    <message>
        <source>of the working volume</source>
        <translation>des Nutzvolumens</translation>
    </message>
    <message>
        <source>points probed with the reference on each axis</source>
        <translation>mit der Referenz gemessene Punkte je Achse</translation>
    </message>
    <message>
        <source>of each coil while probed</source>
        <translation>jeder Spule während der Messung</translation>
    </message>
    <message>
        <source>recorded at each point and sign</source>
        <translation>je Punkt und Vorzeichen aufgezeichnet</translation>
    </message>
    <message>
        <source>probe against computed that passes</source>
        <translation>gemessen gegen gerechnet, was besteht</translation>
    </message>
    <message>
        <source>ask for a photograph of each</source>
        <translation>von jedem ein Foto verlangen</translation>
    </message>
    <message>
        <source>channels to switch; none: every current channel of the DUT</source>
        <translation>zu schaltende Kanäle; keine: jeder Stromkanal des Prüflings</translation>
    </message>
    <message>
        <source>times each load is switched on</source>
        <translation>wie oft jede Last eingeschaltet wird</translation>
    </message>
    <message>
        <source>on, and off, each time</source>
        <translation>jeweils ein und aus</translation>
    </message>
    <message>
        <source>first amplitude, within coil and DUT limits</source>
        <translation>erste Amplitude, in den Grenzen von Spule und Prüfling</translation>
    </message>
    <message>
        <source>reversals</source>
        <translation>Umpolungen</translation>
    </message>
    <message>
        <source>last amplitude</source>
        <translation>letzte Amplitude</translation>
    </message>
    <message>
        <source>at each amplitude</source>
        <translation>je Amplitude</translation>
    </message>
    <message>
        <source>body axes up, in turn: at least two</source>
        <translation>Körperachsen nach oben, nacheinander: mindestens zwei</translation>
    </message>
    <message>
        <source>of the reference above it: at least two</source>
        <translation>der Referenz darüber: mindestens zwei</translation>
    </message>
    <message>
        <source>uncertainty of each coordinate of its place</source>
        <translation>Unsicherheit jeder Koordinate ihres Orts</translation>
    </message>
    <message>
        <source>reversed between turns: the induced part</source>
        <translation>zwischen Drehungen umgepolt: der induzierte Anteil</translation>
    </message>
    <message>
        <source>in each field at rest, with the DUT and without</source>
        <translation>je Feld in Ruhe, mit und ohne Prüfling</translation>
    </message>
    <message>
        <source>largest moment that passes</source>
        <translation>größtes Moment, das besteht</translation>
    </message>
    <message>
        <source>total field x, y, z in C</source>
        <translation>ganzes Feld x, y, z in C</translation>
    </message>
    <message>
        <source>how long it is held</source>
        <translation>wie lange es gehalten wird</translation>
    </message>
    <message>
        <source>of the feedback</source>
        <translation>der Rückführung</translation>
    </message>
    <message>
        <source>part of the error taken back each time</source>
        <translation>Anteil des Fehlers, der jedes Mal ausgeglichen wird</translation>
    </message>
    <message>
        <source>errors below this are left: the supplies&apos; own step</source>
        <translation>kleinere Fehler bleiben: die Stufe der Netzgeräte</translation>
    </message>
    <message>
        <source>rms error that passes</source>
        <translation>Effektivfehler, der besteht</translation>
    </message>
    <message>
        <source>of the field, all over the sphere</source>
        <translation>des Felds, rings um die Kugel</translation>
    </message>
    <message>
        <source>of the field, each in all</source>
        <translation>des Felds, jeder ringsum</translation>
    </message>
    <message>
        <source>body axis along the platform axis</source>
        <translation>Körperachse längs der Tischachse</translation>
    </message>
    <message>
        <source>rms error at those fields that passes</source>
        <translation>Effektivfehler bei diesen Feldern, der besteht</translation>
    </message>
    <message>
        <source>change of the zero through the run that passes</source>
        <translation>Änderung des Nullpunkts über die Messung, die besteht</translation>
    </message>
    <message>
        <source>recorded in each attitude</source>
        <translation>je Lage aufgezeichnet</translation>
    </message>
    <message>
        <source>how well an attitude is met</source>
        <translation>wie genau eine Lage getroffen wird</translation>
    </message>
    <message>
        <source>body axis along the platform axis and the field</source>
        <translation>Körperachse längs Tischachse und Feld</translation>
    </message>
    <message>
        <source>body axis stepped together with it</source>
        <translation>Körperachse, die mitgestuft wird</translation>
    </message>
    <message>
        <source>largest field</source>
        <translation>größtes Feld</translation>
    </message>
    <message>
        <source>steps of one sign</source>
        <translation>Stufen eines Vorzeichens</translation>
    </message>
    <message>
        <source>of each coil with both halves alike</source>
        <translation>jeder Spule mit gleichgepolten Hälften</translation>
    </message>
    <message>
        <source>recorded at each sign</source>
        <translation>je Vorzeichen aufgezeichnet</translation>
    </message>
    <message>
        <source>from where the reference is stated that passes</source>
        <translation>vom genannten Ort der Referenz, was besteht</translation>
    </message>
    <message>
        <source>of the coils&apos; geometry that passes</source>
        <translation>der Spulengeometrie, was besteht</translation>
    </message>
    <message>
        <source>of the turn</source>
        <translation>der Drehung</translation>
    </message>
    <message>
        <source>recorded with the motor holding, and off</source>
        <translation>aufgezeichnet mit haltendem und mit abgeschaltetem Motor</translation>
    </message>
    <message>
        <source>largest signature that passes</source>
        <translation>größtes Eigenfeld, das besteht</translation>
    </message>
    <message>
        <source>CSV t_s,b_x,b_y,b_z [s, nT in C]; none: the orbit below</source>
        <translation>CSV t_s,b_x,b_y,b_z [s, nT in C]; keine: die Bahn unten</translation>
    </message>
    <message>
        <source>udp://HOST:PORT: as a simulator sends it (docs/field-source.md)</source>
        <translation>udp://HOST:PORT: wie ein Simulator es sendet (docs/field-source.md)</translation>
    </message>
    <message>
        <source>of the circular orbit</source>
        <translation>der Kreisbahn</translation>
    </message>
    <message>
        <source>of the orbit</source>
        <translation>der Bahn</translation>
    </message>
    <message>
        <source>start, ISO 8601 UTC</source>
        <translation>Beginn, ISO 8601 UTC</translation>
    </message>
    <message>
        <source>how the satellite is held</source>
        <translation>wie der Satellit gehalten wird</translation>
    </message>
    <message>
        <source>of orbit time, at most of a source</source>
        <translation>der Bahnzeit, bei einer Quelle höchstens</translation>
    </message>
    <message>
        <source>between two set-points</source>
        <translation>zwischen zwei Sollwerten</translation>
    </message>
    <message>
        <source>orbit seconds played in one second</source>
        <translation>in einer Sekunde gespielte Bahnsekunden</translation>
    </message>
    <message>
        <source>that the source may be silent</source>
        <translation>die die Quelle schweigen darf</translation>
    </message>
    <message>
        <source>of a field from the source, beside its quickest</source>
        <translation>eines Felds der Quelle, gegen ihr schnellstes</translation>
    </message>
    <message>
        <source>rms tracking error that passes</source>
        <translation>effektiver Folgefehler, der besteht</translation>
    </message>
    <message>
        <source>body axes, each mounted along the platform axis in turn</source>
        <translation>Körperachsen, jede nacheinander längs der Tischachse eingebaut</translation>
    </message>
    <message>
        <source>field magnitudes</source>
        <translation>Beträge des Felds</translation>
    </message>
    <message>
        <source>the last magnitude also reversed</source>
        <translation>der letzte Betrag auch umgekehrt</translation>
    </message>
    <message>
        <source>the DUT&apos;s power modes</source>
        <translation>Betriebszustände des Prüflings</translation>
    </message>
    <message>
        <source>timing uncertainty, at least</source>
        <translation>Zeitunsicherheit, mindestens</translation>
    </message>
    <message>
        <source>recorded at a position</source>
        <translation>je Stellung aufgezeichnet</translation>
    </message>
    <message>
        <source>coils-off zero, first and last</source>
        <translation>Nullpunkt mit Spulen aus, zuerst und zuletzt</translation>
    </message>
    <message>
        <source>largest closure that passes</source>
        <translation>größter Schlussfehler, der besteht</translation>
    </message>
    <message>
        <source>how well an axis is mounted</source>
        <translation>wie genau eine Achse steht</translation>
    </message>
    <message>
        <source>each there and back</source>
        <translation>jede hin und zurück</translation>
    </message>
    <message>
        <source>age of its calibration that passes</source>
        <translation>Alter ihrer Kalibrierung, das besteht</translation>
    </message>
    <message>
        <source>recorded in each attitude and field</source>
        <translation>je Lage und Feld aufgezeichnet</translation>
    </message>
    <message>
        <source>of the field in six directions</source>
        <translation>des Felds in sechs Richtungen</translation>
    </message>
    <message>
        <source>largest zero that passes</source>
        <translation>größter Nullpunkt, der besteht</translation>
    </message>
    <message>
        <source>largest spread of the magnitude that passes</source>
        <translation>größte Streuung des Betrags, die besteht</translation>
    </message>
    <message>
        <source>ambient magnitude by a standard; 0: none</source>
        <translation>Umgebungsfeld nach einem Normal; 0: keines</translation>
    </message>
    <message>
        <source>of the standard; 0: not stated</source>
        <translation>des Normals; 0: nicht genannt</translation>
    </message>
    <message>
        <source>how truly it is turned by 180°; 0: not stated</source>
        <translation>wie genau um 180° gewendet wird; 0: nicht genannt</translation>
    </message>
    <message>
        <source>of the cage&apos;s field, by direction; 0: not stated</source>
        <translation>des Käfigfelds, je Richtung; 0: nicht genannt</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>wie oft</translation>
    </message>
    <message>
        <source>coils off between two turns</source>
        <translation>Spulen aus zwischen zwei Drehungen</translation>
    </message>
    <message>
        <source>of both turns</source>
        <translation>beider Drehungen</translation>
    </message>
    <message>
        <source>timing uncertainty</source>
        <translation>Zeitunsicherheit</translation>
    </message>
    <message>
        <source>recorded at each stop</source>
        <translation>je Halt aufgezeichnet</translation>
    </message>
    <message>
        <source>full turns, there and back by turns</source>
        <translation>ganze Drehungen, abwechselnd hin und zurück</translation>
    </message>
    <message>
        <source>of each coil alone</source>
        <translation>jeder Spule allein</translation>
    </message>
    <message>
        <source>of the field that rotates</source>
        <translation>des drehenden Felds</translation>
    </message>
    <message>
        <source>of the field that rotates, at two moduli</source>
        <translation>des drehenden Felds, bei zwei Beträgen</translation>
    </message>
    <message>
        <source>rms error of the magnitude there that passes</source>
        <translation>Effektivfehler des Betrags dort, der besteht</translation>
    </message>
    <message>
        <source>departure from square that passes</source>
        <translation>Abweichung vom rechten Winkel, die besteht</translation>
    </message>
    <message>
        <source>height of the wave; one ramp step at most</source>
        <translation>Höhe der Welle; höchstens eine Rampenstufe</translation>
    </message>
    <message>
        <source>steps of the pseudo-random wave</source>
        <translation>Stufen der Pseudozufallswelle</translation>
    </message>
    <message>
        <source>length of a step</source>
        <translation>Länge einer Stufe</translation>
    </message>
    <message>
        <source>turned to and fro</source>
        <translation>hin und her gedreht</translation>
    </message>
    <message>
        <source>longest delay that passes</source>
        <translation>längster Verzug, der besteht</translation>
    </message>
    <message>
        <source>temperature channel of the DUT; empty: the first</source>
        <translation>Temperaturkanal des Prüflings; leer: der erste</translation>
    </message>
    <message>
        <source>along the platform axis</source>
        <translation>längs der Tischachse</translation>
    </message>
    <message>
        <source>times every field is visited</source>
        <translation>wie oft jedes Feld angefahren wird</translation>
    </message>
    <message>
        <source>recorded at each visit</source>
        <translation>je Besuch aufgezeichnet</translation>
    </message>
    <message>
        <source>fields and angles</source>
        <translation>Felder und Winkel</translation>
    </message>
    <message>
        <source>of the field</source>
        <translation>des Felds</translation>
    </message>
    <message>
        <source>recorded at each position</source>
        <translation>je Stellung aufgezeichnet</translation>
    </message>
    <message>
        <source>between positions</source>
        <translation>zwischen den Stellungen</translation>
    </message>
    <message>
        <source>rms heading error that passes</source>
        <translation>effektiver Richtungsfehler, der besteht</translation>
    </message>
    <message>
        <source>rms magnitude error that passes</source>
        <translation>effektiver Betragsfehler, der besteht</translation>
    </message>
    <message>
        <source>a number from {0} to {1}, or several with commas</source>
        <translation>eine Zahl von {0} bis {1}, oder mehrere mit Kommas</translation>
    </message>
    <message>
        <source>a number from {0} to {1}</source>
        <translation>eine Zahl von {0} bis {1}</translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}, or several with commas</source>
        <translation>eine ganze Zahl von {0} bis {1}, oder mehrere mit Kommas</translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}</source>
        <translation>eine ganze Zahl von {0} bis {1}</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a text, or several with commas</source>
        <translation>ein Text, oder mehrere mit Kommas</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>eine Datei</translation>
    </message>
    <message>
        <source>one of {0}, or several with commas</source>
        <translation>eines von {0}, oder mehrere mit Kommas</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>eines von {0}</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>ja oder nein</translation>
    </message>
    <message>
        <source>turn the sensor about another body axis, or in a field of another magnitude</source>
        <translation>den Sensor um eine andere Körperachse drehen oder in einem Feld anderer Größe</translation>
    </message>
    <message>
        <source>the magnitudes do not determine all nine parameters: {0}</source>
        <translation>die Beträge bestimmen nicht alle neun Parameter: {0}</translation>
    </message>
    <message>
        <source>the magnitudes do not determine all parameters: {0}</source>
        <translation>die Beträge bestimmen nicht alle Parameter: {0}</translation>
    </message>
    <message>
        <source>I + E is not positive definite, so no real scale factors belong to it: {0}</source>
        <translation>I + E ist nicht positiv definit, also gehören keine reellen Skalenfaktoren dazu: {0}</translation>
    </message>
    <message>
        <source>{0} rows have both a reading and a reference magnitude; nine parameters need ten</source>
        <translation>{0} Zeilen haben Messwert und Referenzbetrag; neun Parameter brauchen zehn</translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT: {1}</source>
        <translation>das Feld wäre um {0} nT unsicher: {1}</translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT</source>
        <translation>das Feld wäre um {0} nT unsicher</translation>
    </message>
    <message>
        <source>Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {0}</source>
        <translation>Gauß-Newton kommt nicht zur Ruhe, die Beträge bestimmen die Parameter also kaum: {0}</translation>
    </message>
    <message>
        <source>the current {0} never changes, so its offset is part of the bias: leave it out</source>
        <translation>der Strom {0} ändert sich nie, sein Nullpunkt gehört also zur Störung: weglassen</translation>
    </message>
    <message>
        <source>the currents {0} are linearly dependent: leave one of them out</source>
        <translation>die Ströme {0} sind linear abhängig: einen davon weglassen</translation>
    </message>
    <message>
        <source>run {0} has no channel {1}; it has {2}</source>
        <translation>Messung {0} hat keinen Kanal {1}; sie hat {2}</translation>
    </message>
    <message>
        <source>channel {0} is no current of the DUT, which is what `telemetry` takes</source>
        <translation>Kanal {0} ist kein Strom des Prüflings; nur solche nimmt `telemetry`</translation>
    </message>
    <message>
        <source>the filter&apos;s covariance is no longer positive definite</source>
        <translation>die Kovarianz des Filters ist nicht mehr positiv definit</translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie {0} times farther from what it expects than the noise of the first ones allows</source>
        <translation>Das Filter hat den Sensor verloren, oder der Sensor hat sich verändert: Messwerte liegen {0}-mal weiter von dem, was es erwartet, als das Rauschen der ersten erlaubt</translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie beyond all bounds farther from what it expects than the noise of the first ones allows</source>
        <translation>Das Filter hat den Sensor verloren, oder der Sensor hat sich verändert: Messwerte liegen über alle Grenzen weiter von dem, was es erwartet, als das Rauschen der ersten erlaubt</translation>
    </message>
    <message>
        <source>{0} readings with a magnitude; a start needs {1}</source>
        <translation>{0} Werte mit einem Betrag; ein Anfang braucht {1}</translation>
    </message>
    <message>
        <source>the run is too short for {0} to begin</source>
        <translation>die Messung ist zu kurz, als dass {0} beginnen könnte</translation>
    </message>
    <message>
        <source>the numbers broke down: {0}</source>
        <translation>die Zahlen brachen zusammen: {0}</translation>
    </message>
    <message>
        <source>no row has both a reading and a reference</source>
        <translation>keine Zeile hat Messwert und Referenz</translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: 1 rotation axis in {1} segments; rotate about another body axis</source>
        <translation>die Messung bestimmt {0} von 12 Parametern: 1 Drehachse in {1} Abschnitten; um eine andere Körperachse drehen</translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: {1} rotation axes in {2} segments; rotate about another body axis</source>
        <translation>die Messung bestimmt {0} von 12 Parametern: {1} Drehachsen in {2} Abschnitten; um eine andere Körperachse drehen</translation>
    </message>
    <message>
        <source>the run does not determine the parameters: the normal equations are singular</source>
        <translation>die Messung bestimmt die Parameter nicht: Die Normalgleichungen sind singulär</translation>
    </message>
    <message>
        <source>the run does not determine the parameters: {0}; add longer arcs, another axis or another magnitude</source>
        <translation>die Messung bestimmt die Parameter nicht: {0}; längere Bögen, eine andere Achse oder einen anderen Betrag hinzunehmen</translation>
    </message>
    <message>
        <source>the likelihood has no clear summit</source>
        <translation>die Likelihood hat keinen klaren Gipfel</translation>
    </message>
    <message>
        <source>rotation segment {0} of {1} does not turn about its declared axis_body: at least {2} deg from it</source>
        <translation>Drehabschnitt {0} von {1} dreht nicht um sein angegebenes axis_body: mindestens {2} deg daneben</translation>
    </message>
    <message>
        <source>there is no rotation segment that states its axis_body; rotate about known body axes</source>
        <translation>kein Drehabschnitt nennt sein axis_body; um bekannte Körperachsen drehen</translation>
    </message>
    <message>
        <source>the magnitudes determine {0} of 9 parameters; rotate about another axis or use another magnitude</source>
        <translation>die Beträge bestimmen {0} von 9 Parametern; um eine andere Achse drehen oder einen anderen Betrag nehmen</translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2} and {3} more: {4}</source>
        <translation>die Messung bestimmt {0} von {1} Parametern, nicht {2} und {3} weitere: {4}</translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2} and {3} more: {4}</source>
        <translation>die Messung bestimmt nur {0} Kombinationen der {1} Parameter; offen sind {2} und {3} weitere: {4}</translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2}: {3}</source>
        <translation>die Messung bestimmt nur {0} Kombinationen der {1} Parameter; offen sind {2}: {3}</translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2}: {3}</source>
        <translation>die Messung bestimmt {0} von {1} Parametern, nicht {2}: {3}</translation>
    </message>
    <message>
        <source>add a rotation about another body axis, or a field at another angle to the axis</source>
        <translation>eine Drehung um eine andere Körperachse hinzunehmen oder ein Feld in anderem Winkel zur Achse</translation>
    </message>
    <message>
        <source>add a rotation about another body axis or a field of another magnitude</source>
        <translation>eine Drehung um eine andere Körperachse oder ein Feld anderer Größe hinzunehmen</translation>
    </message>
    <message>
        <source>the readings lie close to one plane; turn the sensor about another body axis as well</source>
        <translation>die Messwerte liegen nahe einer Ebene; den Sensor auch um eine andere Körperachse drehen</translation>
    </message>
    <message>
        <source>quite another map fits as well</source>
        <translation>eine ganz andere Abbildung passt ebenso</translation>
    </message>
    <message>
        <source>its reference leaves the rotation of the map open</source>
        <translation>seine Referenz lässt die Drehung der Abbildung offen</translation>
    </message>
    <message>
        <source>there is no reference, so the scale is open: a field of known magnitude is needed</source>
        <translation>es gibt keine Referenz, der Maßstab ist also offen: ein Feld bekannter Größe ist nötig</translation>
    </message>
    <message>
        <source>{0} usable rows give {1} numbers; the map needs more than {2}</source>
        <translation>{0} brauchbare Zeilen geben {1} Zahlen; die Abbildung braucht mehr als {2}</translation>
    </message>
    <message>
        <source>the reference is zero throughout</source>
        <translation>die Referenz ist durchweg null</translation>
    </message>
    <message>
        <source>no map comes near these readings: they do not follow the reference at all</source>
        <translation>keine Abbildung kommt diesen Werten nahe: Sie folgen der Referenz gar nicht</translation>
    </message>
    <message>
        <source>{0} never changes: nothing determines its scale; turn the sensor or look at the axis</source>
        <translation>{0} ändert sich nie: Nichts bestimmt seinen Maßstab; den Sensor drehen oder die Achse ansehen</translation>
    </message>
    <message>
        <source>the normal equations are not finite</source>
        <translation>die Normalgleichungen sind nicht endlich</translation>
    </message>
    <message>
        <source>method {0} gives no calibration of run {1}: {2}</source>
        <translation>Verfahren {0} gibt keine Kalibrierung der Messung {1}: {2}</translation>
    </message>
    <message>
        <source>run {0} has no reference: there is no residual to explain</source>
        <translation>Messung {0} hat keine Referenz: Es gibt keinen Rest zu erklären</translation>
    </message>
    <message>
        <source>run {0} has {1} rows with a reading and a reference; {2} are needed</source>
        <translation>Messung {0} hat {1} Zeilen mit Messwert und Referenz; {2} sind nötig</translation>
    </message>
    <message>
        <source>run {0} does not even determine an offset: {1}</source>
        <translation>Messung {0} bestimmt nicht einmal einen Nullpunkt: {1}</translation>
    </message>
    <message>
        <source>noise of the run, through the fit</source>
        <translation>Rauschen der Messung, durch die Anpassung</translation>
    </message>
    <message>
        <source>noise of one reading</source>
        <translation>Rauschen eines Messwerts</translation>
    </message>
    <message>
        <source>structure that held-out residuals keep</source>
        <translation>Struktur, die zurückgehaltene Reste behalten</translation>
    </message>
    <message>
        <source>reference scale</source>
        <translation>Maßstab der Referenz</translation>
    </message>
    <message>
        <source>reference zero {0}</source>
        <translation>Nullpunkt der Referenz {0}</translation>
    </message>
    <message>
        <source>reference zero</source>
        <translation>Nullpunkt der Referenz</translation>
    </message>
    <message>
        <source>reference alignment about {0}</source>
        <translation>Ausrichtung der Referenz um {0}</translation>
    </message>
    <message>
        <source>alignment about {0}</source>
        <translation>Ausrichtung um {0}</translation>
    </message>
    <message>
        <source>rotation axes in the body about {0}</source>
        <translation>Drehachsen im Körper um {0}</translation>
    </message>
    <message>
        <source>rotation axes in the cage about {0}</source>
        <translation>Drehachsen im Käfig um {0}</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale</source>
        <translation>Temperatur der Referenz, Maßstab</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero {0}</source>
        <translation>Temperatur der Referenz, Nullpunkt {0}</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero</source>
        <translation>Temperatur der Referenz, Nullpunkt</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate {0}</source>
        <translation>Drift der Referenz seit ihrem Schein {0}</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate</source>
        <translation>Drift der Referenz seit ihrem Schein</translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance {0}</source>
        <translation>Gradient der Spulen über den Abstand {0}</translation>
    </message>
    <message>
        <source>gradient over the distance {0}</source>
        <translation>Gradient über den Abstand {0}</translation>
    </message>
    <message>
        <source>gradient over the distance</source>
        <translation>Gradient über den Abstand</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>zero reading {0}</source>
        <translation>Nullpunkt {0}</translation>
    </message>
    <message>
        <source>off 90° {0}</source>
        <translation>Abweichung von 90° {0}</translation>
    </message>
    <message>
        <source>{0} µT along {1}, {2}</source>
        <translation>{0} µT längs {1}, {2}</translation>
    </message>
    <message>
        <source>{0} µT along {1}</source>
        <translation>{0} µT längs {1}</translation>
    </message>
    <message>
        <source>{0} to {1} nT held out (noise alone: {2} nT)</source>
        <translation>zurückgehalten {0} auf {1} nT (Rauschen allein: {2} nT)</translation>
    </message>
    <message>
        <source>The base model reaches the noise beside what the run declares of its reference and mounting: {0}.</source>
        <translation>Das Grundmodell erreicht das Rauschen neben dem, was die Messung von Referenz und Einbau angibt: {0}.</translation>
    </message>
    <message>
        <source>The base model reaches the noise: {0}.</source>
        <translation>Das Grundmodell erreicht das Rauschen: {0}.</translation>
    </message>
    <message>
        <source>{0} explains part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation>{0} erklärt einen Teil des Rests, {1} % seines Quadrats über dem Rauschen: {2}.</translation>
    </message>
    <message>
        <source>{0} explain part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation>{0} erklären einen Teil des Rests, {1} % seines Quadrats über dem Rauschen: {2}.</translation>
    </message>
    <message>
        <source>{0} explains part of the residual: {1}.</source>
        <translation>{0} erklärt einen Teil des Rests: {1}.</translation>
    </message>
    <message>
        <source>{0} explain part of the residual: {1}.</source>
        <translation>{0} erklären einen Teil des Rests: {1}.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation>{0} erklärt den Rest: {1}; doch von einer Messung, von der mehr als {2} % der Zeilen als Ausreißer weggelegt sind, heißt nichts erklärt.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation>{0} erklären den Rest: {1}; doch von einer Messung, von der mehr als {2} % der Zeilen als Ausreißer weggelegt sind, heißt nichts erklärt.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} does as well on this run.</source>
        <translation>{0} erklärt den Rest: {1}; doch {2} tut es bei dieser Messung ebenso.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} does as well on this run.</source>
        <translation>{0} erklären den Rest: {1}; doch {2} tut es bei dieser Messung ebenso.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} do as well on this run.</source>
        <translation>{0} erklärt den Rest: {1}; doch {2} tun es bei dieser Messung ebenso.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} do as well on this run.</source>
        <translation>{0} erklären den Rest: {1}; doch {2} tun es bei dieser Messung ebenso.</translation>
    </message>
    <message>
        <source>{0} explains the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation>{0} erklärt den Rest neben dem, was die Messung von Referenz und Einbau angibt: {1}.</translation>
    </message>
    <message>
        <source>{0} explain the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation>{0} erklären den Rest neben dem, was die Messung von Referenz und Einbau angibt: {1}.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}.</source>
        <translation>{0} erklärt den Rest: {1}.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}.</source>
        <translation>{0} erklären den Rest: {1}.</translation>
    </message>
    <message>
        <source>There is structure that no known effect carries: {0}.</source>
        <translation>Es ist Struktur da, die kein bekannter Effekt trägt: {0}.</translation>
    </message>
    <message>
        <source>Beside the rows set aside there is structure that no known effect carries: {0}.</source>
        <translation>Neben den weggelegten Zeilen ist Struktur da, die kein bekannter Effekt trägt: {0}.</translation>
    </message>
    <message>
        <source>This cause has no name: it is an empirical term, and holds only where it has been seen.</source>
        <translation>Diese Ursache hat keinen Namen: Sie ist ein empirischer Term und gilt nur, wo sie gesehen wurde.</translation>
    </message>
    <message>
        <source>a function of {0}</source>
        <translation>eine Funktion von {0}</translation>
    </message>
    <message>
        <source>Rows set aside</source>
        <translation>Weggelegte Zeilen</translation>
    </message>
    <message>
        <source>{0} row set aside as {1}</source>
        <translation>{0} Zeile weggelegt als {1}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} row set aside as {3}</source>
        <translation>{0} Zeilen weggelegt als {1}, {2} Zeile als {3}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} rows set aside as {3}</source>
        <translation>{0} Zeilen weggelegt als {1}, {2} als {3}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}</source>
        <translation>{0} Zeilen weggelegt als {1}</translation>
    </message>
    <message>
        <source>{0} rows ({1} %) set aside</source>
        <translation>{0} Zeilen ({1} %) weggelegt</translation>
    </message>
    <message>
        <source>outliers</source>
        <translation>Ausreißer</translation>
    </message>
    <message>
        <source>saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>No effect was searched in such data.</source>
        <translation>In solchen Daten wurde kein Effekt gesucht.</translation>
    </message>
    <message>
        <source>with the others of {0} in, the held-out rms falls from {1} to {2} nT</source>
        <translation>mit den anderen von {0} darin fällt die zurückgehaltene rms von {1} auf {2} nT</translation>
    </message>
    <message>
        <source>the held-out rms falls from {0} to {1} nT</source>
        <translation>die zurückgehaltene rms fällt von {0} auf {1} nT</translation>
    </message>
    <message>
        <source>with the others of {0} in, it alone takes {1} nT off the held-out rms beside declared errors</source>
        <translation>mit den anderen von {0} darin nimmt sie allein {1} nT von der zurückgehaltenen rms neben angegebenen Fehlern</translation>
    </message>
    <message>
        <source>it alone takes {0} nT off the held-out rms beside declared errors</source>
        <translation>sie allein nimmt {0} nT von der zurückgehaltenen rms neben angegebenen Fehlern</translation>
    </message>
    <message>
        <source>evidence over a slow wander without a name: {0}</source>
        <translation>Evidenz gegenüber einem langsamen Wandern ohne Namen: {0}</translation>
    </message>
    <message>
        <source>{0} nats, {1} needed</source>
        <translation>{0} nat, {1} sind nötig</translation>
    </message>
    <message>
        <source>no better than chance or a slow wander: evidence {0}</source>
        <translation>nicht besser als Zufall oder ein langsames Wandern: Evidenz {0}</translation>
    </message>
    <message>
        <source>too little evidence: {0}</source>
        <translation>zu wenig Evidenz: {0}</translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual: not worth its parameters</source>
        <translation>nimmt vom Rest das {0}-fache des Rauschquadrats: seine Parameter nicht wert</translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual in sample, but other forms of what is accepted take as much</source>
        <translation>nimmt vom Rest in der Stichprobe das {0}-fache des Rauschquadrats, doch andere Formen des Angenommenen nehmen ebenso viel</translation>
    </message>
    <message>
        <source>taken to first order ({0} to {1} nT held out), and given up: fitted in full, map and effects together leave {2} nT</source>
        <translation>in erster Ordnung genommen (zurückgehalten {0} auf {1} nT) und aufgegeben: ganz angepasst lassen Abbildung und Effekte zusammen {2} nT übrig</translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it would be more than half of the field, and the others would undo it</source>
        <translation>genommen (zurückgehalten {0} auf {1} nT) und aufgegeben: Es wäre mehr als das halbe Feld, und die anderen höben es auf</translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it is no larger than its uncertainty, declared errors included; what is not there would seem as large in {2} % of runs</source>
        <translation>genommen (zurückgehalten {0} auf {1} nT) und aufgegeben: Es ist nicht größer als seine Unsicherheit samt den angegebenen Fehlern; was nicht da ist, sähe in {2} % der Messungen ebenso groß aus</translation>
    </message>
    <message>
        <source>does as well as {0} in its place ({1} nT held out): a rival, neither is sure</source>
        <translation>tut an Stelle von {0} ebenso viel (zurückgehalten {1} nT): ein Rivale, keiner ist sicher</translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, a gain of {2} to {3} nT that may be none</source>
        <translation>genommen und auf zurückgehaltenen Blöcken aufgegeben: {0} auf {1} nT, ein Gewinn von {2} bis {3} nT, der keiner sein kann</translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, but it is a detail beside others, or too much is left for its name to be sure</source>
        <translation>genommen und auf zurückgehaltenen Blöcken aufgegeben: {0} auf {1} nT, doch neben anderen ist es eine Einzelheit, oder es bleibt zu viel übrig, als dass sein Name sicher wäre</translation>
    </message>
    <message>
        <source>What is left is more than noise, though no single test (white in each segment, independent of every channel, of field, angle and time) finds of what shape.</source>
        <translation>Was übrig ist, ist mehr als Rauschen, doch kein einzelner Test (weiß in jedem Abschnitt, unabhängig von jedem Kanal, von Feld, Winkel und Zeit) findet, von welcher Gestalt.</translation>
    </message>
    <message>
        <source>What is left shows no material structure: white in each segment, independent of every channel, of field, angle and time.</source>
        <translation>Was übrig ist, zeigt keine wesentliche Struktur: weiß in jedem Abschnitt, unabhängig von jedem Kanal, von Feld, Winkel und Zeit.</translation>
    </message>
    <message>
        <source>What is left: {0}</source>
        <translation>Was übrig ist: {0}</translation>
    </message>
    <message>
        <source>What is left {0}.</source>
        <translation>Was übrig ist, {0}.</translation>
    </message>
    <message>
        <source>{0} more tests fail</source>
        <translation>{0} weitere Tests schlagen fehl</translation>
    </message>
    <message>
        <source>follows itself from row to row, most in segment {0}</source>
        <translation>folgt sich selbst von Zeile zu Zeile, am meisten im Abschnitt {0}</translation>
    </message>
    <message>
        <source>goes with time (correlation {0})</source>
        <translation>geht mit der Zeit (Korrelation {0})</translation>
    </message>
    <message>
        <source>goes with {0} (correlation {1})</source>
        <translation>geht mit {0} (Korrelation {1})</translation>
    </message>
    <message>
        <source>comes again wherever the field is the same ({0} % of its square)</source>
        <translation>kommt wieder, wo das Feld dasselbe ist ({0} % seines Quadrats)</translation>
    </message>
    <message>
        <source>the field along {0}</source>
        <translation>dem Feld längs {0}</translation>
    </message>
    <message>
        <source>the field&apos;s magnitude</source>
        <translation>dem Betrag des Felds</translation>
    </message>
    <message>
        <source>the angle&apos;s sine</source>
        <translation>dem Sinus des Winkels</translation>
    </message>
    <message>
        <source>the angle&apos;s cosine</source>
        <translation>dem Kosinus des Winkels</translation>
    </message>
    <message>
        <source>a line with a period of {0} s, on {1}</source>
        <translation>eine Linie mit einer Periode von {0} s, auf {1}</translation>
    </message>
    <message>
        <source>a step at t = {0} s, on {1}</source>
        <translation>eine Stufe bei t = {0} s, auf {1}</translation>
    </message>
    <message>
        <source>two levels with {0} changes between them, each kept for about {1} s (telegraph-like), on {2}</source>
        <translation>zwei Pegel mit {0} Wechseln dazwischen, jeder etwa {1} s gehalten (wie ein Telegraf), auf {2}</translation>
    </message>
    <message>
        <source>a wander like a random walk, on {0}</source>
        <translation>ein Wandern wie ein Zufallsweg, auf {0}</translation>
    </message>
    <message>
        <source>a wander that remembers itself for about {0} s, on {1}</source>
        <translation>ein Wandern, das sich etwa {0} s an sich erinnert, auf {1}</translation>
    </message>
    <message>
        <source>more noise than is stated, without memory from row to row, on {0}</source>
        <translation>mehr Rauschen als angegeben, ohne Gedächtnis von Zeile zu Zeile, auf {0}</translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT, mostly at angles of {2} to {3}°</source>
        <translation>meist in Feldern von {0} bis {1} µT, meist bei Winkeln von {2} bis {3}°</translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT</source>
        <translation>meist in Feldern von {0} bis {1} µT</translation>
    </message>
    <message>
        <source>mostly at angles of {0} to {1}°</source>
        <translation>meist bei Winkeln von {0} bis {1}°</translation>
    </message>
    <message>
        <source>the magnitude</source>
        <translation>dem Betrag</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>allen Achsen</translation>
    </message>
    <message>
        <source>axis {0}</source>
        <translation>Achse {0}</translation>
    </message>
    <message>
        <source>axes {0}</source>
        <translation>den Achsen {0}</translation>
    </message>
    <message>
        <source>The selection ended without a set of effects that held-out data support whole; what its last round left stands.</source>
        <translation>Die Auswahl endete ohne eine Gruppe von Effekten, die zurückgehaltene Daten ganz stützen; es gilt, was ihre letzte Runde übrig ließ.</translation>
    </message>
    <message>
        <source>k is the offset at {0}.</source>
        <translation>k ist der Nullpunkt bei {0}.</translation>
    </message>
    <message>
        <source>In another recording {0} begins {1} nT astray (one standard deviation) until the field has wiped that out: the held-out error does not hold it, u_nT does.</source>
        <translation>In einer anderen Aufzeichnung beginnt {0} um {1} nT daneben (eine Standardabweichung), bis das Feld das gelöscht hat: Der zurückgehaltene Fehler enthält es nicht, u_nT schon.</translation>
    </message>
    <message>
        <source>{0}: what K and k take as well</source>
        <translation>{0}: was K und k ebenso nehmen</translation>
    </message>
    <message>
        <source>{0} in place of {1}: another map</source>
        <translation>{0} statt {1}: eine andere Abbildung</translation>
    </message>
    <message>
        <source>What is left is within what the run declares: {0}.</source>
        <translation>Was übrig ist, liegt in dem, was die Messung angibt: {0}.</translation>
    </message>
    <message>
        <source>What is left has the shape of what the run declares, and is larger: {0}.</source>
        <translation>Was übrig ist, hat die Gestalt dessen, was die Messung angibt, und ist größer: {0}.</translation>
    </message>
    <message>
        <source>{0} nT held out, {1} beside it (noise alone: {2} nT)</source>
        <translation>zurückgehalten {0} nT, {1} daneben (Rauschen allein: {2} nT)</translation>
    </message>
    <message>
        <source>Likeliest: {0}.</source>
        <translation>Am wahrscheinlichsten: {0}.</translation>
    </message>
    <message>
        <source>Decided by other judgements than labcal&apos;s own: {0}.</source>
        <translation>Entschieden nach anderen Maßstäben als denen von labcal: {0}.</translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs.</source>
        <translation>Angegebene Fehler lassen in {0} % der Messungen so viel oder mehr übrig.</translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs: check these, or declare them as large as they are.</source>
        <translation>Angegebene Fehler lassen in {0} % der Messungen so viel oder mehr übrig: Diese prüfen oder so groß angeben, wie sie sind.</translation>
    </message>
    <message>
        <source>reference scale ({0}) {1} nT</source>
        <translation>Maßstab der Referenz ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference zero ({0}) {1} nT</source>
        <translation>Nullpunkt der Referenz ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference alignment ({0}) {1} nT</source>
        <translation>Ausrichtung der Referenz ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale ({0}) {1} nT</source>
        <translation>Temperatur der Referenz, Maßstab ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero ({0}) {1} nT</source>
        <translation>Temperatur der Referenz, Nullpunkt ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate ({0}) {1} nT</source>
        <translation>Drift der Referenz seit ihrem Schein ({0}) {1} nT</translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance ({0}) {1} nT</source>
        <translation>Gradient der Spulen über den Abstand ({0}) {1} nT</translation>
    </message>
    <message>
        <source>gradient over the distance ({0}) {1} nT</source>
        <translation>Gradient über den Abstand ({0}) {1} nT</translation>
    </message>
    <message>
        <source>rotation axes in the cage ({0}) {1} nT</source>
        <translation>Drehachsen im Käfig ({0}) {1} nT</translation>
    </message>
    <message>
        <source>rotation axes in the body ({0}) {1} nT</source>
        <translation>Drehachsen im Körper ({0}) {1} nT</translation>
    </message>
    <message>
        <source>time ({0}) {1} nT</source>
        <translation>Zeit ({0}) {1} nT</translation>
    </message>
    <message>
        <source>The noise, whose level is not stated, follows itself for about {0} s and goes with nothing that is recorded: {1} nT.</source>
        <translation>Das Rauschen, dessen Größe nicht angegeben ist, folgt sich etwa {0} s lang und geht mit nichts Aufgezeichnetem: {1} nT.</translation>
    </message>
    <message>
        <source>State the device&apos;s noise, measured at rest, to be sure.</source>
        <translation>Um sicher zu sein, das Rauschen des Prüflings angeben, in Ruhe gemessen.</translation>
    </message>
    <message>
        <source>The noise measured at rest is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation>Das in Ruhe gemessene Rauschen ist das {0}-fache des angegebenen: Der Boden von {1} nT, mit dem Ergebnisse verglichen werden, kann falsch sein.</translation>
    </message>
    <message>
        <source>The noise measured from row to row is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation>Das von Zeile zu Zeile gemessene Rauschen ist das {0}-fache des angegebenen: Der Boden von {1} nT, mit dem Ergebnisse verglichen werden, kann falsch sein.</translation>
    </message>
    <message>
        <source>Channels with {0}: {1}. They can show no cause.</source>
        <translation>Kanäle mit {0}: {1}. Sie können keine Ursache zeigen.</translation>
    </message>
    <message>
        <source>no value in this run</source>
        <translation>keinem Wert in dieser Messung</translation>
    </message>
    <message>
        <source>one value all through this run</source>
        <translation>einem einzigen Wert durch die ganze Messung</translation>
    </message>
    <message>
        <source>no value, nor a sure one between two others, in most rows</source>
        <translation>in den meisten Zeilen keinem Wert, auch keinem sicheren zwischen zwei anderen</translation>
    </message>
    <message>
        <source>Channels {0} and {1} are one signal: no fit tells which is the cause.</source>
        <translation>Die Kanäle {0} und {1} sind ein Signal: Keine Anpassung sagt, welcher die Ursache ist.</translation>
    </message>
    <message>
        <source>The correction {0} is uncertain by {1} nT at {2}: the run did not go there.</source>
        <translation>Die Korrektur {0} ist um {1} nT unsicher bei {2}: Dorthin kam die Messung nicht.</translation>
    </message>
    <message>
        <source>{0} in {1} µT along {2}</source>
        <translation>{0} in {1} µT längs {2}</translation>
    </message>
    <message>
        <source>{0} in {1} µT across the axes</source>
        <translation>{0} in {1} µT quer zu den Achsen</translation>
    </message>
    <message>
        <source>It is not written into the calibration.</source>
        <translation>Sie wird nicht in die Kalibrierung geschrieben.</translation>
    </message>
    <message>
        <source>Missing: large fields along every axis at both ends of {0}.</source>
        <translation>Es fehlen: große Felder längs jeder Achse an beiden Enden von {0}.</translation>
    </message>
    <message>
        <source>Missing: both ends of {0} for long enough.</source>
        <translation>Es fehlen: beide Enden von {0}, lange genug.</translation>
    </message>
    <message>
        <source>Of {0}, {1} are, one by one, not pinned down by this run (value below U, k = 2).</source>
        <translation>Von {0} sind {1}, einzeln genommen, durch diese Messung nicht bestimmt (Wert unter U, k = 2).</translation>
    </message>
    <message>
        <source>Of {0}, {1} is not pinned down by this run (value below U, k = 2).</source>
        <translation>Von {0} ist {1} durch diese Messung nicht bestimmt (Wert unter U, k = 2).</translation>
    </message>
    <message>
        <source>The reading along {0} is the same in every row.</source>
        <translation>Der Messwert längs {0} ist in jeder Zeile derselbe.</translation>
    </message>
    <message>
        <source>The readings come to {0} nT, the reference to {1} nT: the unit or nominal_nT_per_unit of one of them is not as declared.</source>
        <translation>Die Messwerte kommen auf {0} nT, die Referenz auf {1} nT: Einheit oder nominal_nT_per_unit von einem ist nicht wie angegeben.</translation>
    </message>
    <message>
        <source>This run does not determine the whole map ({0} alone): too few axes or fields are excited; a whole map would leave {1} instead of {2} nT, and be anyone&apos;s guess.</source>
        <translation>Diese Messung bestimmt nicht die ganze Abbildung (nur {0}): Zu wenige Achsen oder Felder sind angeregt; eine ganze Abbildung ließe {1} statt {2} nT übrig und wäre geraten.</translation>
    </message>
    <message>
        <source>Turn about the other body axes too.</source>
        <translation>Auch um die anderen Körperachsen drehen.</translation>
    </message>
    <message>
        <source>The fitted map mirrors the axes ({0}): an axis of the device or of the reference is flipped or two are swapped.</source>
        <translation>Die angepasste Abbildung spiegelt die Achsen ({0}): Eine Achse des Prüflings oder der Referenz ist umgedreht, oder zwei sind vertauscht.</translation>
    </message>
    <message>
        <source>The fitted map turns the axes ({0}): the mounting or the names of the axes are not as declared.</source>
        <translation>Die angepasste Abbildung dreht die Achsen ({0}): Einbau oder Namen der Achsen sind nicht wie angegeben.</translation>
    </message>
    <message>
        <source>{0} is the device&apos;s {1}</source>
        <translation>{0} ist {1} des Prüflings</translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT ({3} fits as well).</source>
        <translation>Die Messung passt viel besser {0}: Das Grundmodell lässt {1} statt {2} nT übrig (ebenso passt {3}).</translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT.</source>
        <translation>Die Messung passt viel besser {0}: Das Grundmodell lässt {1} statt {2} nT übrig.</translation>
    </message>
    <message>
        <source>with the reference taken in the body&apos;s frame, not the cage&apos;s</source>
        <translation>mit der Referenz im System des Körpers statt des Käfigs</translation>
    </message>
    <message>
        <source>with the reference taken in the cage&apos;s frame, not the body&apos;s</source>
        <translation>mit der Referenz im System des Käfigs statt des Körpers</translation>
    </message>
    <message>
        <source>with the platform&apos;s angle counted the other way</source>
        <translation>mit dem Tischwinkel andersherum gezählt</translation>
    </message>
    <message>
        <source>with the platform&apos;s angle taken in radians, not degrees</source>
        <translation>mit dem Tischwinkel in Radiant statt Grad</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped and {2} flipped</source>
        <translation>mit {0} und {1} der Referenz vertauscht und {2} umgedreht</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped</source>
        <translation>mit {0} und {1} der Referenz vertauscht</translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0} and {1} flipped</source>
        <translation>mit x, y, z der Referenz gelesen als {0} und {1} umgedreht</translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0}</source>
        <translation>mit x, y, z der Referenz gelesen als {0}</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} flipped</source>
        <translation>mit {0} der Referenz umgedreht</translation>
    </message>
    <message>
        <source>The clocks do not agree: {0}; put right, the base model leaves {1} instead of {2} nT.</source>
        <translation>Die Uhren stimmen nicht überein: {0}; richtiggestellt lässt das Grundmodell {1} statt {2} nT übrig.</translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s late</source>
        <translation>die Zeitstempel des Prüflings scheinen {0} s zu spät</translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s early</source>
        <translation>die Zeitstempel des Prüflings scheinen {0} s zu früh</translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s late</source>
        <translation>die Zeitstempel der Referenz scheinen {0} s zu spät</translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s early</source>
        <translation>die Zeitstempel der Referenz scheinen {0} s zu früh</translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s late</source>
        <translation>die Zeitstempel des Tischwinkels scheinen {0} s zu spät</translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s early</source>
        <translation>die Zeitstempel des Tischwinkels scheinen {0} s zu früh</translation>
    </message>
    <message>
        <source>The readings do not follow the reference: the base model leaves {0} of {1} nT, and no flip or exchange of axes and no offset of a clock explains it.</source>
        <translation>Die Messwerte folgen der Referenz nicht: Das Grundmodell lässt {0} von {1} nT übrig, und kein Umdrehen oder Vertauschen von Achsen und kein Versatz einer Uhr erklärt es.</translation>
    </message>
    <message>
        <source>working the calibration out again: {0}</source>
        <translation>die Kalibrierung wird noch einmal gerechnet: {0}</translation>
    </message>
    <message>
        <source>fitting by {0}</source>
        <translation>Anpassung nach {0}</translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run, and nothing that this lab&apos;s procedures do would separate them by {1} standard deviations</source>
        <translation>{0} tun bei dieser Messung gleich viel, und nichts, was die Abläufe dieses Labors tun, trennte sie um {1} Standardabweichungen</translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run; the experiment would bring them {1} standard deviations apart, as the fit predicts</source>
        <translation>{0} tun bei dieser Messung gleich viel; der Versuch brächte sie nach der Anpassung {1} Standardabweichungen auseinander</translation>
    </message>
    <message>
        <source>structure remains that no known effect carries: {0}</source>
        <translation>es bleibt Struktur, die kein bekannter Effekt trägt: {0}</translation>
    </message>
    <message>
        <source>what is left has the shape of errors that the run declares of its reference and mounting, and is larger</source>
        <translation>was übrig ist, hat die Gestalt von Fehlern, die die Messung von Referenz und Einbau angibt, und ist größer</translation>
    </message>
    <message>
        <source>compare the reference with a second one in two fields, mount the device anew, and repeat</source>
        <translation>die Referenz in zwei Feldern mit einer zweiten vergleichen, den Prüfling neu einbauen, wiederholen</translation>
    </message>
    <message>
        <source>more rows are set aside as outliers than a run may have that is called explained</source>
        <translation>es sind mehr Zeilen als Ausreißer weggelegt, als eine Messung haben darf, die erklärt heißt</translation>
    </message>
    <message>
        <source>look at the link and its wiring, and repeat</source>
        <translation>die Verbindung und ihre Leitungen ansehen, wiederholen</translation>
    </message>
    <message>
        <source>turn once forwards and once backwards: what stays at its angles belongs to the rig</source>
        <translation>einmal vorwärts und einmal rückwärts drehen: Was an seinen Winkeln bleibt, gehört zum Aufbau</translation>
    </message>
    <message>
        <source>step the field up and down along each axis: what grows with the field shows its shape</source>
        <translation>das Feld längs jeder Achse in Stufen auf und ab: Was mit dem Feld wächst, zeigt seine Gestalt</translation>
    </message>
    <message>
        <source>record at rest with the coils off, then switch what runs at that period off one by one</source>
        <translation>in Ruhe mit ausgeschalteten Spulen aufzeichnen, dann einzeln ausschalten, was mit dieser Periode läuft</translation>
    </message>
    <message>
        <source>repeat the run unchanged and note what is switched: a step that does not come back was an event</source>
        <translation>die Messung unverändert wiederholen und notieren, was geschaltet wird: Eine Stufe, die nicht wiederkommt, war ein Ereignis</translation>
    </message>
    <message>
        <source>switch every load and mode on and off at one attitude, and look for the two levels</source>
        <translation>jede Last und jeden Zustand in einer Lage ein- und ausschalten und nach den zwei Pegeln sehen</translation>
    </message>
    <message>
        <source>record for an hour at rest: a wander of the sensor goes on, one of the rig does not</source>
        <translation>eine Stunde in Ruhe aufzeichnen: Ein Wandern des Sensors geht weiter, eines des Aufbaus nicht</translation>
    </message>
    <message>
        <source>turn at half and at twice the rate: what belongs to angle or field comes again</source>
        <translation>mit halber und doppelter Rate drehen: Was zu Winkel oder Feld gehört, kommt wieder</translation>
    </message>
    <message>
        <source>record at rest with the coils off: the noise that remains is the sensor&apos;s own</source>
        <translation>in Ruhe mit ausgeschalteten Spulen aufzeichnen: Das Rauschen, das bleibt, ist das des Sensors</translation>
    </message>
    <message>
        <source>repeat with another reference</source>
        <translation>mit einer anderen Referenz wiederholen</translation>
    </message>
    <message>
        <source>turn once forwards and once backwards in one mounting</source>
        <translation>in einem Einbau einmal vorwärts und einmal rückwärts drehen</translation>
    </message>
    <message>
        <source>turn at half and at twice the rate, there and back, in one mounting</source>
        <translation>in einem Einbau mit halber und doppelter Rate hin und zurück drehen</translation>
    </message>
    <message>
        <source>repeat the run unchanged</source>
        <translation>die Messung unverändert wiederholen</translation>
    </message>
    <message>
        <source>step the field up and down along one axis</source>
        <translation>das Feld längs einer Achse in Stufen auf und ab</translation>
    </message>
    <message>
        <source>turn in two more coil fields, a third and twice as large</source>
        <translation>in zwei weiteren Spulenfeldern drehen, einem Drittel und dem Doppelten</translation>
    </message>
    <message>
        <source>switch every load on and off at one attitude</source>
        <translation>jede Last in einer Lage ein- und ausschalten</translation>
    </message>
    <message>
        <source>warm the device and let it cool in two fields</source>
        <translation>den Prüfling in zwei Feldern wärmen und abkühlen lassen</translation>
    </message>
    <message>
        <source>switch the power mode there and back at one attitude</source>
        <translation>den Betriebszustand in einer Lage hin und zurück schalten</translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat the first turns</source>
        <translation>den Prüfling um 5 cm versetzen und die ersten Drehungen wiederholen</translation>
    </message>
    <message>
        <source>turn the reference by 180° and repeat the first turns</source>
        <translation>die Referenz um 180° drehen und die ersten Drehungen wiederholen</translation>
    </message>
    <message>
        <source>put the reference at twice its distance and repeat the first turns</source>
        <translation>die Referenz in den doppelten Abstand stellen und die ersten Drehungen wiederholen</translation>
    </message>
    <message>
        <source>measure the bare platform&apos;s own field with the reference</source>
        <translation>das Eigenfeld des leeren Tisches mit der Referenz messen</translation>
    </message>
    <message>
        <source>the run does not determine the whole map</source>
        <translation>die Messung bestimmt nicht die ganze Abbildung</translation>
    </message>
    <message>
        <source>turn about all three body axes, in two fields at least</source>
        <translation>um alle drei Körperachsen drehen, in mindestens zwei Feldern</translation>
    </message>
    <message>
        <source>an effect found in such data would be wrong</source>
        <translation>ein Effekt, der in solchen Daten gefunden würde, wäre falsch</translation>
    </message>
    <message>
        <source>put the bundle or the wiring right, and close the loop again</source>
        <translation>Daten oder Leitungen richtigstellen und die Ursache neu suchen</translation>
    </message>
    <message>
        <source>the cause has no name yet. {0}</source>
        <translation>die Ursache hat noch keinen Namen. {0}</translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}.</source>
        <translation>Über {0} ist es {1} um {2}: {3}.</translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}.</source>
        <translation>Über {0} ist es {1}: {2}.</translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}</source>
        <translation>Über {0} ist es {1} um {2}: {3}</translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}</source>
        <translation>Über {0} ist es {1}: {2}</translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do.</source>
        <translation>Auf dem Rückweg ist es anders: Etwas erinnert sich, wie es Eisen und warme Massen tun.</translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do</source>
        <translation>Auf dem Rückweg ist es anders: Etwas erinnert sich, wie es Eisen und warme Massen tun</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>saturating</source>
        <translation>sättigend</translation>
    </message>
    <message>
        <source>resonant</source>
        <translation>resonant</translation>
    </message>
    <message>
        <source>a step</source>
        <translation>eine Stufe</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>wellig</translation>
    </message>
    <message>
        <source>a bent curve</source>
        <translation>eine gebogene Kurve</translation>
    </message>
    <message>
        <source>a product</source>
        <translation>ein Produkt</translation>
    </message>
    <message>
        <source>a map</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a sensitivity to it that the library has no file for, or that follows another quantity</source>
        <translation>eine Empfindlichkeit dafür, für die die Sammlung keine Datei hat oder die einer anderen Größe folgt</translation>
    </message>
    <message>
        <source>heating by a current, a magnet&apos;s force, or a straight effect on both sides of a null</source>
        <translation>Erwärmung durch einen Strom, die Kraft eines Magneten oder ein gerader Effekt zu beiden Seiten einer Null</translation>
    </message>
    <message>
        <source>a core or an amplifier at its limit, or a magnetic part that saturates</source>
        <translation>ein Kern oder Verstärker an seiner Grenze oder ein magnetisches Teil, das sättigt</translation>
    </message>
    <message>
        <source>a mechanical or electrical resonance, or a filter&apos;s edge, at that value</source>
        <translation>eine mechanische oder elektrische Resonanz oder die Flanke eines Filters bei diesem Wert</translation>
    </message>
    <message>
        <source>a thermostat, a comparator or a changeover of range at that value</source>
        <translation>ein Thermostat, ein Komparator oder ein Wechsel des Messbereichs bei diesem Wert</translation>
    </message>
    <message>
        <source>interference, a converter&apos;s missing codes, or a beat with a clock</source>
        <translation>Störung, fehlende Codes eines Wandlers oder eine Schwebung mit einem Takt</translation>
    </message>
    <message>
        <source>a response of higher order; more range would show which</source>
        <translation>eine Antwort höherer Ordnung; mehr Bereich zeigte, welche</translation>
    </message>
    <message>
        <source>a sensitivity to one that the other changes, as a gain that follows a temperature</source>
        <translation>eine Empfindlichkeit für das eine, die das andere ändert, wie eine Verstärkung, die einer Temperatur folgt</translation>
    </message>
    <message>
        <source>two causes that act together</source>
        <translation>zwei Ursachen, die zusammen wirken</translation>
    </message>
    <message>
        <source>step the field up and down along each axis, through more than its range</source>
        <translation>das Feld längs jeder Achse in Stufen auf und ab, über mehr als seinen Bereich</translation>
    </message>
    <message>
        <source>turn through many attitudes in one field, then in half of it</source>
        <translation>in einem Feld durch viele Lagen drehen, dann in seiner Hälfte</translation>
    </message>
    <message>
        <source>turn at several rates, forwards and backwards</source>
        <translation>mit mehreren Raten drehen, vorwärts und rückwärts</translation>
    </message>
    <message>
        <source>hold the attitude, warm the device and let it cool, over a wider range</source>
        <translation>die Lage halten, den Prüfling wärmen und abkühlen lassen, über einen weiteren Bereich</translation>
    </message>
    <message>
        <source>hold the attitude and step the current up and down through its range</source>
        <translation>die Lage halten und den Strom in Stufen durch seinen Bereich auf und ab</translation>
    </message>
    <message>
        <source>hold the attitude and move {0} up and down through more than its range, twice</source>
        <translation>die Lage halten und {0} zweimal über mehr als seinen Bereich auf und ab bewegen</translation>
    </message>
    <message>
        <source>hold {0} and {1}; then the other way round</source>
        <translation>{0} festhalten und {1}; dann umgekehrt</translation>
    </message>
    <message>
        <source>mount the device turned by 180° about the platform axis and repeat</source>
        <translation>den Prüfling um 180° um die Tischachse gedreht einbauen und wiederholen</translation>
    </message>
    <message>
        <source>repeat with the coils at zero, and with the reference turned by 180°</source>
        <translation>mit den Spulen auf null wiederholen, und mit der Referenz um 180° gedreht</translation>
    </message>
    <message>
        <source>hold the field along one axis and step it along another</source>
        <translation>das Feld längs einer Achse halten und längs einer anderen in Stufen ändern</translation>
    </message>
    <message>
        <source>repeat with the reference at twice the distance</source>
        <translation>mit der Referenz im doppelten Abstand wiederholen</translation>
    </message>
    <message>
        <source>hold all else and move its input up and down through its range, twice</source>
        <translation>alles andere halten und seinen Eingang zweimal durch seinen Bereich auf und ab bewegen</translation>
    </message>
    <message>
        <source>turn the device by 90° on the platform and repeat: what the platform reads wrong stays at its angles</source>
        <translation>den Prüfling auf dem Tisch um 90° drehen und wiederholen: Was der Tisch falsch abliest, bleibt an seinen Winkeln</translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat one segment</source>
        <translation>den Prüfling um 5 cm versetzen und einen Abschnitt wiederholen</translation>
    </message>
    <message>
        <source>step the quantity that the channel measures in a large field and again in a small one</source>
        <translation>die Größe, die der Kanal misst, in einem großen Feld in Stufen ändern und wieder in einem kleinen</translation>
    </message>
    <message>
        <source>switch the device off and on, and repeat the segments before and after in the same field</source>
        <translation>den Prüfling aus- und einschalten und die Abschnitte davor und danach im selben Feld wiederholen</translation>
    </message>
    <message>
        <source>warm the sensor in a large field and again in a small one</source>
        <translation>den Sensor in einem großen Feld wärmen und wieder in einem kleinen</translation>
    </message>
    <message>
        <source>step the field up and down through the same values, or turn backwards</source>
        <translation>das Feld in Stufen durch dieselben Werte auf und ab, oder rückwärts drehen</translation>
    </message>
    <message>
        <source>turn faster, and backwards: a lag grows with the rate and changes sign with it</source>
        <translation>schneller drehen, und rückwärts: Ein Verzug wächst mit der Rate und wechselt mit ihr das Vorzeichen</translation>
    </message>
    <message>
        <source>step the field along each axis through its whole range</source>
        <translation>das Feld längs jeder Achse in Stufen durch seinen ganzen Bereich</translation>
    </message>
    <message>
        <source>hold the attitude and step the quantity that the channel measures</source>
        <translation>die Lage halten und die Größe, die der Kanal misst, in Stufen ändern</translation>
    </message>
    <message>
        <source>hold the attitude and switch the load that draws this current on and off</source>
        <translation>die Lage halten und die Last, die diesen Strom zieht, ein- und ausschalten</translation>
    </message>
    <message>
        <source>hold the attitude and draw three or more levels of this current</source>
        <translation>die Lage halten und drei oder mehr Stufen dieses Stroms ziehen</translation>
    </message>
    <message>
        <source>repeat the first segment at the end, and again after a pause</source>
        <translation>den ersten Abschnitt am Ende wiederholen, und nach einer Pause noch einmal</translation>
    </message>
    <message>
        <source>hold the attitude and switch between the power modes</source>
        <translation>die Lage halten und zwischen den Betriebszuständen schalten</translation>
    </message>
    <message>
        <source>repeat the segments before and after the step</source>
        <translation>die Abschnitte vor und nach der Stufe wiederholen</translation>
    </message>
    <message>
        <source>hold the attitude and warm the sensor, then let it cool</source>
        <translation>die Lage halten und den Sensor wärmen, dann abkühlen lassen</translation>
    </message>
    <message>
        <source>record at rest, and again at another sampling rate: an alias moves</source>
        <translation>in Ruhe aufzeichnen, und mit einer anderen Abtastrate noch einmal: Ein Alias wandert</translation>
    </message>
    <message>
        <source>compare the reference with a second one before and after</source>
        <translation>die Referenz vorher und nachher mit einer zweiten vergleichen</translation>
    </message>
    <message>
        <source>warm the room with the device kept as it is, and compare the reference with a second one</source>
        <translation>den Raum wärmen, den Prüfling lassen, wie er ist, und die Referenz mit einer zweiten vergleichen</translation>
    </message>
    <message>
        <source>repeat the segment and look at the link</source>
        <translation>den Abschnitt wiederholen und die Verbindung ansehen</translation>
    </message>
    <message>
        <source>repeat at half the field</source>
        <translation>bei halbem Feld wiederholen</translation>
    </message>
    <message>
        <source>readings stop at the end of the range: {0}</source>
        <translation>Messwerte enden am Rand des Bereichs: {0}</translation>
    </message>
    <message>
        <source>fitting the base model</source>
        <translation>das Grundmodell wird angepasst</translation>
    </message>
    <message>
        <source>fitting the map with the effects that are named</source>
        <translation>die Abbildung wird mit den benannten Effekten angepasst</translation>
    </message>
    <message>
        <source>scoring every effect</source>
        <translation>jeder Effekt wird bewertet</translation>
    </message>
    <message>
        <source>scoring {0} beside {1}</source>
        <translation>geprüft wird: {0}, verglichen mit: {1}</translation>
    </message>
    <message>
        <source>scoring {0}</source>
        <translation>bewertet wird {0}</translation>
    </message>
    <message>
        <source>every effect</source>
        <translation>jeder Effekt</translation>
    </message>
    <message>
        <source>all candidates</source>
        <translation>alle Kandidaten</translation>
    </message>
    <message>
        <source>delay scan</source>
        <translation>die Suche nach Verzügen</translation>
    </message>
    <message>
        <source>spectral lines</source>
        <translation>die Suche nach Linien</translation>
    </message>
    <message>
        <source>pairs that hide each other</source>
        <translation>Paare, die einander verdecken</translation>
    </message>
    <message>
        <source>the selection on each part of the blocks</source>
        <translation>die Auswahl auf jedem Teil der Blöcke</translation>
    </message>
    <message>
        <source>what does as well</source>
        <translation>was ebenso gut passt</translation>
    </message>
    <message>
        <source>this run takes about {0} s more and may be stopped</source>
        <translation>diese Messung braucht noch etwa {0} s und darf abgebrochen werden</translation>
    </message>
    <message>
        <source>holding out blocks of time</source>
        <translation>Zeitblöcke werden zurückgehalten</translation>
    </message>
    <message>
        <source>so far nothing has the evidence of a name</source>
        <translation>bisher hat nichts die Evidenz eines Namens</translation>
    </message>
    <message>
        <source>a cause is in sight, not proven yet: what is left over falls from {0} to {1} times the noise ({2})</source>
        <translation>eine Ursache ist in Sicht, noch nicht bewiesen: Was übrig bleibt, fällt vom {0}- auf das {1}-Fache des Rauschens ({2})</translation>
    </message>
    <message>
        <source>stopped while {0}; {1}</source>
        <translation>abgebrochen: {0}; {1}</translation>
    </message>
    <message>
        <source>nothing is known yet</source>
        <translation>noch ist nichts bekannt</translation>
    </message>
    <message>
        <source>offsets so far: not yet determined by the turns made</source>
        <translation>Nullpunkte bisher: durch die gemachten Drehungen noch nicht bestimmt</translation>
    </message>
    <message>
        <source>offsets so far, from magnitudes alone: {0} nT (k = 2)</source>
        <translation>Nullpunkte bisher, allein aus Beträgen: {0} nT (k = 2)</translation>
    </message>
    <message>
        <source>offsets so far: the quick estimate of this procedure, from magnitudes alone, does not follow these readings; verdict and Fit do not rest on it</source>
        <translation>Offsets bisher: die schnelle Schätzung dieser Prozedur, aus Beträgen allein, folgt diesen Ablesungen nicht; Urteil und Fit beruhen nicht darauf</translation>
    </message>
    <message>
        <source>offsets so far: {0}</source>
        <translation>Nullpunkte bisher: {0}</translation>
    </message>
    <message>
        <source>axes, handedness and angle are as stated</source>
        <translation>Achsen, Händigkeit und Winkel sind wie angegeben</translation>
    </message>
    <message>
        <source>the angle runs the wrong way round: turn angle_sign in bench.toml</source>
        <translation>der Winkel läuft falsch herum: angle_sign in bench.toml umdrehen</translation>
    </message>
    <message>
        <source>a turn by {0}° is seen by the DUT as {1}°</source>
        <translation>eine Drehung um {0}° sieht der Prüfling als {1}°</translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis shows {1}</source>
        <translation>Prüfling: Achse {0} zeigt {1}</translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis points {1}° beside</source>
        <translation>Prüfling: Achse {0} zeigt {1}° daneben</translation>
    </message>
    <message>
        <source>the DUT&apos;s axes are left-handed</source>
        <translation>Prüfling: die Achsen sind linkshändig</translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis shows {1}</source>
        <translation>Referenz: Achse {0} zeigt {1}</translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis points {1}° beside</source>
        <translation>Referenz: Achse {0} zeigt {1}° daneben</translation>
    </message>
    <message>
        <source>the reference&apos;s axes are left-handed</source>
        <translation>Referenz: die Achsen sind linkshändig</translation>
    </message>
    <message>
        <source>{0}: {1} nT, within which the zero lies</source>
        <translation>{0}: {1} nT, innerhalb deren der Nullpunkt liegt</translation>
    </message>
    <message>
        <source>{0}: {1} nT is beyond {2} nT; something moved or drifted</source>
        <translation>{0}: {1} nT ist über {2} nT; etwas hat sich bewegt oder ist gedriftet</translation>
    </message>
    <message>
        <source>{0}: {1} is beyond its limit of {2}</source>
        <translation>{0}: {1} ist über der Grenze von {2}</translation>
    </message>
    <message>
        <source>{0}: not seen: {1}</source>
        <translation>{0}: nicht gesehen: {1}</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}</source>
        <translation>{0} nennt sich {1}, und diese Messung ist von {2}</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}. Measure it as {3} all the same?</source>
        <translation>{0} nennt sich {1}, und diese Messung ist von {2}. Trotzdem als {3} messen?</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}: nothing was measured. Say which DUT it is, and begin anew.</source>
        <translation>{0} nennt sich {1}, und diese Messung ist von {2}: nichts wurde gemessen. Sagen, welcher Prüfling es ist, und neu beginnen.</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and bench.toml states {2}</source>
        <translation>{0} nennt sich {1}, und bench.toml gibt {2} an</translation>
    </message>
    <message>
        <source>{0} skipped: {1}</source>
        <translation>{0} ausgelassen: {1}</translation>
    </message>
    <message>
        <source>not used: {0}: {1}</source>
        <translation>nicht verwendet: {0}: {1}</translation>
    </message>
    <message>
        <source>{0}: it answers again</source>
        <translation>{0}: antwortet wieder</translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now; ambient field {2} nT before, {3} nT now</source>
        <translation>nach der Stille: Tisch vorher {0}°, jetzt {1}°; Umgebungsfeld vorher {2} nT, jetzt {3} nT</translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now</source>
        <translation>nach der Stille: Tisch vorher {0}°, jetzt {1}°</translation>
    </message>
    <message>
        <source>after the silence: ambient field {0} nT before, {1} nT now</source>
        <translation>nach der Stille: Umgebungsfeld vorher {0} nT, jetzt {1} nT</translation>
    </message>
    <message>
        <source>the end of the run waits: {0}</source>
        <translation>das Ende der Messung wartet: {0}</translation>
    </message>
    <message>
        <source>the run ends: {0}</source>
        <translation>die Messung endet: {0}</translation>
    </message>
    <message>
        <source>goes on after an interruption</source>
        <translation>geht nach einer Unterbrechung weiter</translation>
    </message>
    <message>
        <source>no turn was finished before the interruption: it begins anew, and nothing of before is used</source>
        <translation>vor der Unterbrechung wurde keine Drehung fertig: es beginnt neu, und nichts von vorher wird verwendet</translation>
    </message>
    <message>
        <source>turns kept from before the interruption: {0}; the zero, the axes and the timing are measured again: they tell whether anything moved or drifted since</source>
        <translation>von vor der Unterbrechung bleiben Drehungen: {0}; Null, Achsen und Zeiten werden noch einmal gemessen: sie sagen, ob sich seither etwas bewegt hat oder gedriftet ist</translation>
    </message>
    <message>
        <source>goes on</source>
        <translation>geht weiter</translation>
    </message>
    <message>
        <source>coil {0} came to zero without a ramp</source>
        <translation>Spule {0} ging ohne Rampe auf null</translation>
    </message>
    <message>
        <source>the room is fit for the job</source>
        <translation>der Raum eignet sich</translation>
    </message>
    <message>
        <source>the room is not fit for the job: {0}</source>
        <translation>der Raum eignet sich nicht: {0}</translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT above what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation>seine {0} nT liegen {1} nT über dem, was {2} im Freien erwartet ({3} nT, U = {4} nT, k = 2)</translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT below what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation>seine {0} nT liegen {1} nT unter dem, was {2} im Freien erwartet ({3} nT, U = {4} nT, k = 2)</translation>
    </message>
    <message>
        <source>iron near by, or the reference&apos;s unit and scale</source>
        <translation>Eisen in der Nähe oder Einheit und Maßstab der Referenz</translation>
    </message>
    <message>
        <source>of {0} no field is expected: WMM is here from {1} to {2}</source>
        <translation>für {0} wird kein Feld erwartet: WMM gibt es hier von {1} bis {2}</translation>
    </message>
    <message>
        <source>{0} Hz is not distinguishable from {1} at {2}/s</source>
        <translation>{0} Hz ist bei {2}/s nicht von {1} zu unterscheiden</translation>
    </message>
    <message>
        <source>a steady field</source>
        <translation>einem festen Feld</translation>
    </message>
    <message>
        <source>{0} Hz is seen as a steady field at {1} {2} samples/s</source>
        <translation>{0} Hz ist bei {1} Werten/s ({2}) ein festes Feld</translation>
    </message>
    <message>
        <source>{0} Hz falls on the rotation at {1} {2} samples/s</source>
        <translation>{0} Hz fällt bei {1} Werten/s ({2}) auf die Drehung</translation>
    </message>
    <message>
        <source>the reference&apos;s calibration of {0} is {1} days old, beyond {2}</source>
        <translation>die Kalibrierung der Referenz vom {0} ist {1} Tage alt, mehr als {2}</translation>
    </message>
    <message>
        <source>Not covered by the uncertainties, because it is not stated: {0}.</source>
        <translation>Von den Unsicherheiten nicht erfasst, weil nicht angegeben: {0}.</translation>
    </message>
    <message>
        <source>Not covered by the uncertainty of the tracking error: the reference&apos;s own errors.</source>
        <translation>Von der Unsicherheit des Folgefehlers nicht erfasst: die eigenen Fehler der Referenz.</translation>
    </message>
    <message>
        <source>For cage and surroundings; this is no deperm of a spacecraft.</source>
        <translation>Für Käfig und Umgebung; dies ist keine Entmagnetisierung eines Raumfahrzeugs.</translation>
    </message>
    <message>
        <source>departure from the centre, each coil</source>
        <translation>Abweichung von der Mitte, je Spule</translation>
    </message>
    <message>
        <source>draft: {0}</source>
        <translation>Entwurf: {0}</translation>
    </message>
    <message>
        <source>bias per ampere, one column a load</source>
        <translation>Störung je Ampere, eine Spalte je Last</translation>
    </message>
    <message>
        <source>moment m = p + X b of the DUT, in its body axes</source>
        <translation>Moment m = p + X b des Prüflings, in seinen Körperachsen</translation>
    </message>
    <message>
        <source>the ambient field as tracked</source>
        <translation>das Umgebungsfeld, wie es verfolgt wurde</translation>
    </message>
    <message>
        <source>K and k in the cage&apos;s frame, k in the middle of the run</source>
        <translation>K und k im System des Käfigs, k in der Mitte der Messung</translation>
    </message>
    <message>
        <source>too few directions for harmonics: what K and k do not hold is not reported by degree</source>
        <translation>zu wenige Richtungen für Kugelfunktionen: was K und k nicht halten, wird nicht nach Grad berichtet</translation>
    </message>
    <message>
        <source>the field is the reference&apos;s, measured at the DUT</source>
        <translation>das Feld ist das der Referenz, am Prüfling gemessen</translation>
    </message>
    <message>
        <source>the field is that of the calibrated cage, its ambient part followed by the reference</source>
        <translation>das Feld ist das des kalibrierten Käfigs, die Umgebung von der Referenz verfolgt</translation>
    </message>
    <message>
        <source>offset from four attitudes</source>
        <translation>Nullpunkt aus vier Lagen</translation>
    </message>
    <message>
        <source>field and reading along the direction</source>
        <translation>Feld und Messwert längs der Richtung</translation>
    </message>
    <message>
        <source>the places are as if the halves towards − had been reversed, or position_m has another sign</source>
        <translation>die Orte sind, als wären die Hälften bei − umgepolt, oder position_m hat ein anderes Vorzeichen</translation>
    </message>
    <message>
        <source>field number {0} stands {1} s after it came</source>
        <translation>Feld Nummer {0} steht {1} s, nachdem es kam</translation>
    </message>
    <message>
        <source>{0}; {1} fields set</source>
        <translation>{0}; {1} Felder gestellt</translation>
    </message>
    <message>
        <source>No heading is judged: of the field the reference tells the magnitude alone.</source>
        <translation>Keine Richtung wird beurteilt: Vom Feld nennt die Referenz nur den Betrag.</translation>
    </message>
    <message>
        <source>Of the reference, because the run does not state it: {0}.</source>
        <translation>Von der Referenz, weil die Messung es nicht angibt: {0}.</translation>
    </message>
    <message>
        <source>Of the reference, because the run states it as 0: {0}.</source>
        <translation>Von der Referenz, weil die Messung 0 angibt: {0}.</translation>
    </message>
    <message>
        <source>Frame as mounted; mounting uncertainty not included.</source>
        <translation>System wie eingebaut; Unsicherheit des Einbaus nicht enthalten.</translation>
    </message>
    <message>
        <source>The direction of the platform&apos;s axis in the cage.</source>
        <translation>Die Richtung der Tischachse im Käfig.</translation>
    </message>
    <message>
        <source>the supplies&apos; read-back</source>
        <translation>das Rücklesen der Netzgeräte</translation>
    </message>
    <message>
        <source>the supplies&apos; currents</source>
        <translation>die Ströme der Netzgeräte</translation>
    </message>
    <message>
        <source>where the reference was put</source>
        <translation>wohin die Referenz gestellt wurde</translation>
    </message>
    <message>
        <source>where the sensor was put</source>
        <translation>wohin der Sensor gestellt wurde</translation>
    </message>
    <message>
        <source>the reference&apos;s turn against the cage</source>
        <translation>die Drehung der Referenz gegen den Käfig</translation>
    </message>
    <message>
        <source>the reference&apos;s own linearity</source>
        <translation>die Linearität der Referenz selbst</translation>
    </message>
    <message>
        <source>the direction of the platform&apos;s axis in the cage</source>
        <translation>die Richtung der Tischachse im Käfig</translation>
    </message>
    <message>
        <source>the DUT&apos;s mounting</source>
        <translation>der Einbau des Prüflings</translation>
    </message>
    <message>
        <source>the standard</source>
        <translation>das Normal</translation>
    </message>
    <message>
        <source>the half turns</source>
        <translation>die halben Drehungen</translation>
    </message>
    <message>
        <source>the cage</source>
        <translation>der Käfig</translation>
    </message>
    <message>
        <source>the platform&apos;s angle</source>
        <translation>der Winkel des Tisches</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>own calibration</source>
        <translation>eigene Kalibrierung</translation>
    </message>
    <message>
        <source>x along coil x: matrix_nT_per_A = {0}</source>
        <translation>x längs Spule x: matrix_nT_per_A = {0}</translation>
    </message>
    <message>
        <source>{0} needs a vector reference and three numbers, --set field_nT=0,0,30000</source>
        <translation>{0} braucht eine Vektorreferenz und drei Zahlen, --set field_nT=0,0,30000</translation>
    </message>
    <message>
        <source>{0} needs a vector reference; for a scalar one see {1}</source>
        <translation>{0} braucht eine Vektorreferenz; für eine skalare siehe {1}</translation>
    </message>
    <message>
        <source>{0} needs a scalar reference ([reference] kind); for a vector one see {1}</source>
        <translation>{0} braucht eine skalare Referenz ([reference] kind); für eine vektorielle siehe {1}</translation>
    </message>
    <message>
        <source>the reference stands elsewhere: {0} needs [cage] calibration, from {1}</source>
        <translation>die Referenz steht woanders: {0} braucht [cage] calibration, von {1}</translation>
    </message>
    <message>
        <source>{0} needs a vector reference</source>
        <translation>{0} braucht eine Vektorreferenz</translation>
    </message>
    <message>
        <source>{0} needs a platform with a motor</source>
        <translation>{0} braucht einen Tisch mit Motor</translation>
    </message>
    <message>
        <source>{0} must be at least two, and different</source>
        <translation>{0} müssen mindestens zwei und verschieden sein</translation>
    </message>
    <message>
        <source>the DUT has no current channel {0}; it has {1}</source>
        <translation>der Prüfling hat keinen Stromkanal {0}; er hat {1}</translation>
    </message>
    <message>
        <source>the DUT has no temperature channel {0}; it has {1}</source>
        <translation>der Prüfling hat keinen Temperaturkanal {0}; er hat {1}</translation>
    </message>
    <message>
        <source>configuration: {0} not as stated</source>
        <translation>Konfiguration: {0} nicht wie angegeben</translation>
    </message>
    <message>
        <source>{0}: the coils have moved the field by {1} nT and the reading not at all.</source>
        <translation>{0}: Die Spulen haben das Feld um {1} nT bewegt, den Messwert gar nicht.</translation>
    </message>
    <message>
        <source>no field stood for as long as one sample of the reference.</source>
        <translation>kein Feld stand so lange wie ein Wert der Referenz.</translation>
    </message>
    <message>
        <source>{0} takes a file or a source, not both</source>
        <translation>{0} nimmt eine Datei oder eine Quelle, nicht beides</translation>
    </message>
    <message>
        <source>locate needs the coils&apos; geometry: state [cage.geometry] size_m, and in halves the coils of which one half can be reversed at its terminals</source>
        <translation>locate braucht die Geometrie der Spulen: [cage.geometry] size_m angeben, und in halves die Spulen, deren eine Hälfte an den Klemmen umgepolt werden kann</translation>
    </message>
    <message>
        <source>no coil&apos;s halves can be reversed ([cage.geometry] halves): near its middle the field of a pair does not change with the place to first order, and tells none</source>
        <translation>keiner Spule Hälften sind umpolbar ([cage.geometry] halves): Nahe der Mitte ändert sich das Feld eines Paars in erster Ordnung nicht mit dem Ort und verrät keinen</translation>
    </message>
    <message>
        <source>no half was reversed: the field of a pair as it should be is flat at its middle</source>
        <translation>keine Hälfte war umgepolt: Das Feld eines Paars, wie es sein soll, ist in der Mitte flach</translation>
    </message>
    <message>
        <source>the sensor does not see three coils in three directions</source>
        <translation>der Sensor sieht nicht drei Spulen in drei Richtungen</translation>
    </message>
    <message>
        <source>what the sensor sees fits no place inside the coils: are the halves reversed as asked?</source>
        <translation>was der Sensor sieht, passt zu keinem Ort in den Spulen: Sind die Hälften wie verlangt umgepolt?</translation>
    </message>
    <message>
        <source>the currents do not span all three coils: step each coil at two currents at least</source>
        <translation>die Ströme umfassen nicht alle drei Spulen: jede Spule in mindestens zwei Strömen stufen</translation>
    </message>
    <message>
        <source>these turns do not determine all of the moment</source>
        <translation>diese Drehungen bestimmen nicht das ganze Moment</translation>
    </message>
    <message>
        <source>these fields do not determine K, k and drift: they lie in a plane, or follow the time</source>
        <translation>diese Felder bestimmen K, k und Drift nicht: Sie liegen in einer Ebene oder folgen der Zeit</translation>
    </message>
    <message>
        <source>{0} fields are too few: K, k and drift need {1}</source>
        <translation>{0} Felder sind zu wenige: K, k und Drift brauchen {1}</translation>
    </message>
    <message>
        <source>these currents do not determine the coils: each alone in both signs, and every two together</source>
        <translation>diese Ströme bestimmen die Spulen nicht: jede allein in beiden Vorzeichen, und je zwei zusammen</translation>
    </message>
    <message>
        <source>the magnitudes are those of no three coils: does the sensor follow the currents?</source>
        <translation>die Beträge sind die von keinen drei Spulen: Folgt der Sensor den Strömen?</translation>
    </message>
    <message>
        <source>these currents do not determine coils and ambient field: turn the field all round, in two sizes</source>
        <translation>diese Ströme bestimmen Spulen und Umgebungsfeld nicht: das Feld ganz herum drehen, in zwei Größen</translation>
    </message>
    <message>
        <source>{0} magnitudes are too few: coils, ambient field and its course need {1}</source>
        <translation>{0} Beträge sind zu wenige: Spulen, Umgebungsfeld und sein Verlauf brauchen {1}</translation>
    </message>
    <message>
        <source>two rows at least are needed</source>
        <translation>mindestens zwei Zeilen sind nötig</translation>
    </message>
    <message>
        <source>time does not go on</source>
        <translation>die Zeit geht nicht weiter</translation>
    </message>
    <message>
        <source>{0} is no finite number</source>
        <translation>{0} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>this column is missing</source>
        <translation>diese Spalte fehlt</translation>
    </message>
    <message>
        <source>is no regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>epoch = {0}: expected ISO 8601, as 2026-01-01T00:00:00</source>
        <translation>epoch = {0}: erwartet wird ISO 8601, wie 2026-01-01T00:00:00</translation>
    </message>
    <message>
        <source>the run has no channel {0}, which {1} rests on</source>
        <translation>die Messung hat keinen Kanal {0}, auf dem {1} beruht</translation>
    </message>
    <message>
        <source>this run has nothing to show of {0}</source>
        <translation>diese Messung hat von {0} nichts zu zeigen</translation>
    </message>
    <message>
        <source>a cage calibration file, from the folder of bench.toml</source>
        <translation>eine Datei mit Käfigkalibrierung, vom Ordner von bench.toml aus</translation>
    </message>
    <message>
        <source>a table, or a file: labcal.bench.specification</source>
        <translation>eine Tabelle oder eine Datei: labcal.bench.specification</translation>
    </message>
    <message>
        <source>after a ramp, before the field is believed</source>
        <translation>nach einer Rampe, bevor dem Feld geglaubt wird</translation>
    </message>
    <message>
        <source>after each mounting its serial is asked for, and no other is taken</source>
        <translation>nach jedem Einbau wird seine Seriennummer verlangt und keine andere genommen</translation>
    </message>
    <message>
        <source>after it no procedure begins</source>
        <translation>danach beginnt kein Ablauf</translation>
    </message>
    <message>
        <source>as it came in</source>
        <translation>wie er hereinkam</translation>
    </message>
    <message>
        <source>as it states it, with k</source>
        <translation>wie er es angibt, mit k</translation>
    </message>
    <message>
        <source>at the cage: its number here, or an address</source>
        <translation>am Käfig: ihre Nummer hier oder eine Adresse</translation>
    </message>
    <message>
        <source>at which it holds</source>
        <translation>bei der es gilt</translation>
    </message>
    <message>
        <source>columns are the coil axes in C</source>
        <translation>Spalten sind die Spulenachsen in C</translation>
    </message>
    <message>
        <source>in the sensor&apos;s axes, subtracted first</source>
        <translation>in den Achsen des Sensors, zuerst abgezogen</translation>
    </message>
    <message>
        <source>magnitude with the coils at zero</source>
        <translation>Betrag mit den Spulen auf null</translation>
    </message>
    <message>
        <source>of a whole serial</source>
        <translation>einer ganzen Seriennummer</translation>
    </message>
    <message>
        <source>of it while it was measured, peak to peak</source>
        <translation>davon während der Messung, von Spitze zu Spitze</translation>
    </message>
    <message>
        <source>of its locks and sockets; /run/labcal-GROUP</source>
        <translation>seiner Sperren und Sockets; /run/labcal-GROUP</translation>
    </message>
    <message>
        <source>of one axis of one sample</source>
        <translation>einer Achse eines Werts</translation>
    </message>
    <message>
        <source>of the computer&apos;s users</source>
        <translation>der Benutzer des Rechners</translation>
    </message>
    <message>
        <source>of the difference of what the two halves of a pair make, relative</source>
        <translation>des Unterschieds dessen, was die zwei Hälften eines Paars machen, relativ</translation>
    </message>
    <message>
        <source>of the field at the centre</source>
        <translation>des Felds in der Mitte</translation>
    </message>
    <message>
        <source>of the windings, where a channel tells it</source>
        <translation>der Wicklungen, wo ein Kanal sie nennt</translation>
    </message>
    <message>
        <source>of what the coils make</source>
        <translation>dessen, was die Spulen machen</translation>
    </message>
    <message>
        <source>planetary index of those hours</source>
        <translation>planetarischer Index dieser Stunden</translation>
    </message>
    <message>
        <source>root mean square over `rms_window_s`: what the wire bears for ever</source>
        <translation>Effektivwert über `rms_window_s`: was der Draht auf Dauer trägt</translation>
    </message>
    <message>
        <source>what is known of it and not corrected; each with its own uncertainty</source>
        <translation>was davon bekannt und nicht korrigiert ist; jedes mit eigener Unsicherheit</translation>
    </message>
    <message>
        <source>with the coils at zero, of any component along any direction</source>
        <translation>mit den Spulen auf null, jeder Komponente längs jeder Richtung</translation>
    </message>
    <message>
        <source>with the same reading so long, it is stuck</source>
        <translation>mit so lange demselben Wert hängt er fest</translation>
    </message>
    <message>
        <source>without a sample so long, it is silent</source>
        <translation>so lange ohne Wert ist er stumm</translation>
    </message>
    <message>
        <source>|angle| that the cables bear</source>
        <translation>|Winkel|, den die Kabel tragen</translation>
    </message>
    <message>
        <source>nT a unit of the reading</source>
        <translation>nT je Einheit des Messwerts</translation>
    </message>
    <message>
        <source>nT a year</source>
        <translation>nT im Jahr</translation>
    </message>
    <message>
        <source>largest field at the DUT {0} µT</source>
        <translation>größtes Feld am Prüfling {0} µT</translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the platform&apos;s limit is {3} °/s</source>
        <translation>dreht zwischen {0} und {1}°, am schnellsten mit {2} °/s; die Grenze der Plattform ist {3} °/s</translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the DUT&apos;s limit in bench.toml is {3} °/s</source>
        <translation>dreht zwischen {0} und {1}°, am schnellsten mit {2} °/s; die Grenze des Prüflings in bench.toml ist {3} °/s</translation>
    </message>
    <message>
        <source>what a person is asked, {0}× in all:</source>
        <translation>was ein Mensch gefragt wird, insgesamt {0}×:</translation>
    </message>
    <message>
        <source>DUT {0} axis: angle off its direction</source>
        <translation>Prüfling, Achse {0}: Winkel zu ihrer Richtung</translation>
    </message>
    <message>
        <source>reference {0} axis: angle off its direction</source>
        <translation>Referenz, Achse {0}: Winkel zu ihrer Richtung</translation>
    </message>
    <message>
        <source>mounting and zero</source>
        <translation>Einbau und Nullmessung</translation>
    </message>
    <message>
        <source>ambient field</source>
        <translation>Umgebungsfeld</translation>
    </message>
    <message>
        <source>mains</source>
        <translation>Netzfrequenz</translation>
    </message>
    <message>
        <source>field before</source>
        <translation>Feld davor</translation>
    </message>
    <message>
        <source>field after</source>
        <translation>Feld danach</translation>
    </message>
    <message>
        <source>field upwards</source>
        <translation>Feld aufwärts</translation>
    </message>
    <message>
        <source>field downwards</source>
        <translation>Feld abwärts</translation>
    </message>
    <message>
        <source>field upwards again</source>
        <translation>Feld wieder aufwärts</translation>
    </message>
    <message>
        <source>{0} m, DUT away</source>
        <translation>{0} m, ohne Prüfling</translation>
    </message>
    <message>
        <source>{0} m, {1} up</source>
        <translation>{0} m, {1} oben</translation>
    </message>
    <message>
        <source>verify</source>
        <translation>Nachprüfung</translation>
    </message>
    <message>
        <source>covers</source>
        <translation>Abdeckungen</translation>
    </message>
    <message>
        <source>batteries</source>
        <translation>Batterien</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>phones</source>
        <translation>Telefone</translation>
    </message>
    <message>
        <source>chairs</source>
        <translation>Stühle</translation>
    </message>
    <message>
        <source>the platform rests</source>
        <translation>der Tisch ruht</translation>
    </message>
    <message>
        <source>axes-check: {0}. Mount it again where it is not mounted as asked; else look at its axes.</source>
        <translation>Achsenprüfung: {0}. Neu einbauen, wenn er nicht wie verlangt eingebaut ist; sonst seine Achsen ansehen.</translation>
    </message>
    <message>
        <source>DUT kept within {0} to {1} °C</source>
        <translation>Prüfling zwischen {0} und {1} °C gehalten</translation>
    </message>
    <message>
        <source>no temperature limits are stated</source>
        <translation>keine Temperaturgrenzen sind angegeben</translation>
    </message>
    <message>
        <source>about {0} min, without a person&apos;s steps</source>
        <translation>etwa {0} min, ohne die Schritte eines Menschen</translation>
    </message>
    <message>
        <source>{0}: missing sectors</source>
        <translation>{0}: fehlende Sektoren</translation>
    </message>
    <message>
        <source>{0}: noise</source>
        <translation>{0}: Rauschen</translation>
    </message>
    <message>
        <source>{0}: wrong signs</source>
        <translation>{0}: falsche Vorzeichen</translation>
    </message>
    <message>
        <source>delay {0}</source>
        <translation>Verzug {0}</translation>
    </message>
    <message>
        <source>closure {0}</source>
        <translation>Schluss {0}</translation>
    </message>
    <message>
        <source>closure, {0}</source>
        <translation>Schluss, {0}</translation>
    </message>
    <message>
        <source>zero: {0}</source>
        <translation>Nullmessung: {0}</translation>
    </message>
    <message>
        <source>closing: {0}</source>
        <translation>Abschluss: {0}</translation>
    </message>
    <message>
        <source>zero since the interruption</source>
        <translation>Nullpunkt seit der Unterbrechung</translation>
    </message>
    <message>
        <source>DUT less reference, coils off</source>
        <translation>Prüfling weniger Referenz, Spulen aus</translation>
    </message>
    <message>
        <source>DUT less reference, first position</source>
        <translation>Prüfling weniger Referenz, erste Stellung</translation>
    </message>
    <message>
        <source>DUT less reference</source>
        <translation>Prüfling weniger Referenz</translation>
    </message>
    <message>
        <source>rotation rate</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>turn seen by the DUT, less turn made</source>
        <translation>vom Prüfling gesehene Drehung weniger gemachte</translation>
    </message>
    <message>
        <source>DUT behind the set-point</source>
        <translation>Prüfling hinter dem Sollwert</translation>
    </message>
    <message>
        <source>reference behind the set-point</source>
        <translation>Referenz hinter dem Sollwert</translation>
    </message>
    <message>
        <source>DUT behind the angle</source>
        <translation>Prüfling hinter dem Winkel</translation>
    </message>
    <message>
        <source>mean {0}</source>
        <translation>Mittel {0}</translation>
    </message>
    <message>
        <source>drift {0}</source>
        <translation>Drift {0}</translation>
    </message>
    <message>
        <source>noise {0}</source>
        <translation>Rauschen {0}</translation>
    </message>
    <message>
        <source>noise density {0}</source>
        <translation>Rauschdichte {0}</translation>
    </message>
    <message>
        <source>amplitude of {0} Hz</source>
        <translation>Amplitude von {0} Hz</translation>
    </message>
    <message>
        <source>magnitude by {0}</source>
        <translation>Betrag nach {0}</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>{0} Hz in reference samples</source>
        <translation>{0} Hz in Werten der Referenz</translation>
    </message>
    <message>
        <source>{0} Hz in dut samples</source>
        <translation>{0} Hz in Werten des Prüflings</translation>
    </message>
    <message>
        <source>{0}: uncertainty of the matrix</source>
        <translation>{0}: Unsicherheit der Matrix</translation>
    </message>
    <message>
        <source>{0}: settling time</source>
        <translation>{0}: Einschwingzeit</translation>
    </message>
    <message>
        <source>{0}: departure from the line</source>
        <translation>{0}: Abweichung von der Geraden</translation>
    </message>
    <message>
        <source>{0}: up less down</source>
        <translation>{0}: aufwärts weniger abwärts</translation>
    </message>
    <message>
        <source>departure from the line</source>
        <translation>Abweichung von der Geraden</translation>
    </message>
    <message>
        <source>up less down</source>
        <translation>aufwärts weniger abwärts</translation>
    </message>
    <message>
        <source>computed departure in the volume</source>
        <translation>berechnete Abweichung im Volumen</translation>
    </message>
    <message>
        <source>probe less computed</source>
        <translation>Sonde weniger Rechnung</translation>
    </message>
    <message>
        <source>{0}: bias {1}</source>
        <translation>{0}: Störung {1}</translation>
    </message>
    <message>
        <source>change of the ambient field</source>
        <translation>Änderung des Umgebungsfelds</translation>
    </message>
    <message>
        <source>permanent moment {0}</source>
        <translation>Dauermoment {0}</translation>
    </message>
    <message>
        <source>induced moment {0}</source>
        <translation>induziertes Moment {0}</translation>
    </message>
    <message>
        <source>largest induced moment in {0} µT</source>
        <translation>größtes induziertes Moment in {0} µT</translation>
    </message>
    <message>
        <source>rms error while held</source>
        <translation>rms-Fehler beim Halten</translation>
    </message>
    <message>
        <source>open-loop error</source>
        <translation>Fehler ohne Regelung</translation>
    </message>
    <message>
        <source>drift of the zero</source>
        <translation>Drift des Nullpunkts</translation>
    </message>
    <message>
        <source>{0} µT, degree {1}</source>
        <translation>{0} µT, Grad {1}</translation>
    </message>
    <message>
        <source>verify: rms error with bench.toml&apos;s matrix</source>
        <translation>Nachprüfung: rms-Fehler mit der Matrix von bench.toml</translation>
    </message>
    <message>
        <source>verify: rms error</source>
        <translation>Nachprüfung: rms-Fehler</translation>
    </message>
    <message>
        <source>verify: largest error in units of U by noise</source>
        <translation>Nachprüfung: größter Fehler in Einheiten von U durch Rauschen</translation>
    </message>
    <message>
        <source>rms tracking error</source>
        <translation>rms-Folgefehler</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>jitter of the latency</source>
        <translation>Schwanken der Latenz</translation>
    </message>
    <message>
        <source>jitter of the source</source>
        <translation>Schwanken der Quelle</translation>
    </message>
    <message>
        <source>departure from a straight line</source>
        <translation>Abweichung von einer Geraden</translation>
    </message>
    <message>
        <source>reference from DUT: {0}</source>
        <translation>Referenz vom Prüfling aus: {0}</translation>
    </message>
    <message>
        <source>less what is stated: {0}</source>
        <translation>weniger dem Genannten: {0}</translation>
    </message>
    <message>
        <source>coil {0}: field at the reference over that at the DUT</source>
        <translation>Spule {0}: Feld an der Referenz durch das am Prüfling</translation>
    </message>
    <message>
        <source>once a turn</source>
        <translation>einmal je Drehung</translation>
    </message>
    <message>
        <source>turning less holding</source>
        <translation>drehend weniger haltend</translation>
    </message>
    <message>
        <source>holding less off</source>
        <translation>haltend weniger aus</translation>
    </message>
    <message>
        <source>zero {0}</source>
        <translation>Nullpunkt {0}</translation>
    </message>
    <message>
        <source>magnitude against direction</source>
        <translation>Betrag über der Richtung</translation>
    </message>
    <message>
        <source>magnitude less the standard&apos;s</source>
        <translation>Betrag weniger dem des Normals</translation>
    </message>
    <message>
        <source>age of its calibration</source>
        <translation>Alter ihrer Kalibrierung</translation>
    </message>
    <message>
        <source>components against constant modulus, largest E_n</source>
        <translation>Komponenten gegen festen Betrag, größtes E_n</translation>
    </message>
    <message>
        <source>constant {0}</source>
        <translation>Konstante {0}</translation>
    </message>
    <message>
        <source>{0} from square</source>
        <translation>{0} vom rechten Winkel</translation>
    </message>
    <message>
        <source>ambient {0}</source>
        <translation>Umgebung {0}</translation>
    </message>
    <message>
        <source>current at zero {0}</source>
        <translation>Strom bei null {0}</translation>
    </message>
    <message>
        <source>{0} at {1} µT per {2}</source>
        <translation>{0} bei {1} µT je {2}</translation>
    </message>
    <message>
        <source>offset {0}</source>
        <translation>Nullpunkt {0}</translation>
    </message>
    <message>
        <source>rms heading error</source>
        <translation>rms-Richtungsfehler</translation>
    </message>
    <message>
        <source>rms magnitude error</source>
        <translation>rms-Betragsfehler</translation>
    </message>
    <message>
        <source>{0}: polarity + less −</source>
        <translation>{0}: Polarität + weniger −</translation>
    </message>
    <message>
        <source>DUT: change from bench.toml</source>
        <translation>Prüfling: Änderung gegen bench.toml</translation>
    </message>
    <message>
        <source>axes-check</source>
        <translation>Achsenprüfung</translation>
    </message>
    <message>
        <source>sync-check</source>
        <translation>Zeitprüfung</translation>
    </message>
    <message>
        <source>closure-{0}</source>
        <translation>Schluss {0}</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>Abschluss</translation>
    </message>
    <message>
        <source>coil {0}</source>
        <translation>Spule {0}</translation>
    </message>
    <message>
        <source>sweep at the DUT&apos;s place</source>
        <translation>Abfahren am Ort des Prüflings</translation>
    </message>
    <message>
        <source>sweep at the reference&apos;s place</source>
        <translation>Abfahren am Ort der Referenz</translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation>Punkt {0}</translation>
    </message>
    <message>
        <source>{0}-on-{1}</source>
        <translation>{0} an {1}</translation>
    </message>
    <message>
        <source>{0}-off-{1}</source>
        <translation>{0} aus {1}</translation>
    </message>
    <message>
        <source>{0}-on</source>
        <translation>{0} an</translation>
    </message>
    <message>
        <source>{0}-off</source>
        <translation>{0} aus</translation>
    </message>
    <message>
        <source>open loop</source>
        <translation>ohne Regelung</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>field steps</source>
        <translation>Feldstufen</translation>
    </message>
    <message>
        <source>wait for the source</source>
        <translation>Warten auf die Quelle</translation>
    </message>
    <message>
        <source>play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>half-{0}-reversed</source>
        <translation>Hälfte {0} umgepolt</translation>
    </message>
    <message>
        <source>half-{0}-back</source>
        <translation>Hälfte {0} zurück</translation>
    </message>
    <message>
        <source>as they should be</source>
        <translation>wie sie sein sollen</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>drehend</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>haltend</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>Motor aus</translation>
    </message>
    <message>
        <source>zero by half turns</source>
        <translation>Nullpunkt durch halbe Drehungen</translation>
    </message>
    <message>
        <source>six directions</source>
        <translation>sechs Richtungen</translation>
    </message>
    <message>
        <source>components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>constant modulus</source>
        <translation>fester Betrag</translation>
    </message>
    <message>
        <source>round {0}</source>
        <translation>Runde {0}</translation>
    </message>
    <message>
        <source>position {0}</source>
        <translation>Stellung {0}</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>photographs</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>no better than chance or a slow wander</source>
        <translation>nicht besser als Zufall oder ein langsames Wandern</translation>
    </message>
    <message>
        <source>too little evidence</source>
        <translation>zu wenig Evidenz</translation>
    </message>
    <message>
        <source>{0}, then check the zero again.</source>
        <translation>{0}, dann die Null erneut prüfen.</translation>
    </message>
    <message>
        <source>Then check the zero again.</source>
        <translation>Dann die Null erneut prüfen.</translation>
    </message>
    <message>
        <source>the supplies state {0} A, and the reference does not see that: {1}.</source>
        <translation>Die Netzgeräte melden {0} A, und die Referenz sieht das nicht: {1}.</translation>
    </message>
    <message>
        <source>Does every supply obey, are signs and constants right, was something magnetic moved? axes-check tells which coil it is.</source>
        <translation>Gehorcht jedes Netzgerät, stimmen Vorzeichen und Konstanten, wurde etwas Magnetisches bewegt? axes-check sagt, welche Spule es ist.</translation>
    </message>
    <message>
        <source>Has its output gone off by itself, is the winding open? Set the coils off, look at its panel, and find out why before it is cleared.</source>
        <translation>Ist sein Ausgang von selbst ausgegangen, ist die Wicklung offen? Spulen aus, auf sein Bedienfeld sehen, und den Grund finden, bevor es zurückgesetzt wird.</translation>
    </message>
    <message>
        <source>a field of {0} nT is beyond the limit of {1}, {2} nT; nothing was set.</source>
        <translation>Ein Feld von {0} nT liegt über der Grenze von {1}, {2} nT; nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A would take {2} s to ramp down, more than {3} s; lower current_A or raise ramp_A_per_s.</source>
        <translation>Spule {0}: {1} A bräuchten {2} s bis null, mehr als {3} s; current_A senken oder ramp_A_per_s erhöhen.</translation>
    </message>
    <message>
        <source>{0}, at {1}: {2}. Nothing was set.</source>
        <translation>{0}, um {1}: {2}. Nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>{0}, then measure again: `labcal bench check FILE` lifts this where reference and supplies agree, with --clear-as NAME where a person answers for it.</source>
        <translation>{0}, dann noch einmal messen: `labcal bench check FILE` hebt das auf, wo Referenz und Netzgeräte übereinstimmen, mit --clear-as NAME, wo jemand dafür einsteht.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows after zero was set; the contacts were not moved.</source>
        <translation>Spule {0}: {1} A fließen noch, nachdem null gesetzt wurde; die Kontakte wurden nicht bewegt.</translation>
    </message>
    <message>
        <source>coil {0}: after its contacts were set, a step of {1} A was seen by the reference as {2} A.</source>
        <translation>Spule {0}: Nach dem Stellen ihrer Kontakte sah die Referenz einen Schritt von {1} A als {2} A.</translation>
    </message>
    <message>
        <source>Look for a contact that hangs or is welded, then run axes-check.</source>
        <translation>Nach einem Kontakt sehen, der hängt oder verschweißt ist, dann axes-check.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square would soon be reached, its limit is {2} A; nothing was set.</source>
        <translation>Spule {0}: Bald wären {1} A effektiv erreicht, ihre Grenze ist {2} A; nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows {2} s after zero was set (zero is below {3} A).</source>
        <translation>Spule {0}: {1} A fließen noch {2} s, nachdem null gesetzt wurde (null ist unter {3} A).</translation>
    </message>
    <message>
        <source>Switch {0} off by hand, then look at its panel.</source>
        <translation>{0} von Hand ausschalten, dann auf sein Bedienfeld sehen.</translation>
    </message>
    <message>
        <source>See that it sends, then try again.</source>
        <translation>Dafür sorgen, dass es sendet, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>{0}: it stopped {1}° from its target of {2}°.</source>
        <translation>{0}: hielt {1}° vor dem Ziel von {2}°.</translation>
    </message>
    <message>
        <source>{0}: it homes at {1} deg/s, the DUT&apos;s limit is {2} deg/s; nothing was moved.</source>
        <translation>{0}: fährt mit {1} deg/s zum Nullpunkt, die Grenze des Prüflings ist {2} deg/s; nichts wurde bewegt.</translation>
    </message>
    <message>
        <source>Lower the homing speed on the stage itself, or take the DUT off and home it with its own program.</source>
        <translation>Die Geschwindigkeit dafür am Drehtisch selbst senken, oder den Prüfling abnehmen und den Tisch mit seinem eigenen Programm zum Nullpunkt fahren.</translation>
    </message>
    <message>
        <source>{0}: {1} answers, before it was {2}.</source>
        <translation>{0}: {1} antwortet, vorher war es {2}.</translation>
    </message>
    <message>
        <source>Plug the instruments in as bench.toml says, and begin again.</source>
        <translation>Die Geräte so einstecken, wie bench.toml es sagt, und neu beginnen.</translation>
    </message>
    <message>
        <source>{0}: its name came damaged ({1}).</source>
        <translation>{0}: sein Name kam beschädigt an ({1}).</translation>
    </message>
    <message>
        <source>{0}: {1} answers here and as {2}: the same instrument answers on both links.</source>
        <translation>{0}: {1} antwortet hier und als {2}: An beiden Verbindungen antwortet dasselbe Gerät.</translation>
    </message>
    <message>
        <source>Correct the links in bench.toml, then begin again.</source>
        <translation>Die Verbindungen in bench.toml berichtigen, dann neu beginnen.</translation>
    </message>
    <message>
        <source>{0}: {1} was set to {2} and reads back {3}.</source>
        <translation>{0}: {1} wurde auf {2} gesetzt und liest sich als {3} zurück.</translation>
    </message>
    <message>
        <source>Look at the instrument&apos;s panel.</source>
        <translation>Auf das Bedienfeld des Geräts sehen.</translation>
    </message>
    <message>
        <source>{0}: {1} came back as {2}.</source>
        <translation>{0}: {1} kam als {2} zurück.</translation>
    </message>
    <message>
        <source>{0}: the guardian is gone ({1}); how the coils are is not known.</source>
        <translation>{0}: Der Wächter ist fort ({1}); wie die Spulen stehen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Say `labcal bench off`, then try again.</source>
        <translation>COILS OFF (`labcal bench off`), dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>another user&apos;s process answers as the guardian of this bench; it is not believed.</source>
        <translation>Ein Prozess eines anderen Benutzers antwortet als Wächter dieses Messplatzes; ihm wird nicht geglaubt.</translation>
    </message>
    <message>
        <source>guardian.log names its process: end it, then say off again.</source>
        <translation>guardian.log nennt seinen Prozess: ihn beenden, dann noch einmal ausschalten.</translation>
    </message>
    <message>
        <source>coil {0}: the guardian before is gone; it had ordered zero and reported no read-back.</source>
        <translation>Spule {0}: Der Wächter davor ist fort; er hatte null befohlen und kein Rücklesen gemeldet.</translation>
    </message>
    <message>
        <source>coil {0}: zero has not been read back.</source>
        <translation>Spule {0}: null wurde nicht zurückgelesen.</translation>
    </message>
    <message>
        <source>coil {0}: a step of {1} A is beyond the {2} A that its ramp of {3} A/s allows now; nothing was set.</source>
        <translation>Spule {0}: Ein Schritt von {1} A ist mehr als die {2} A, die ihre Rampe von {3} A/s jetzt erlaubt; nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows; its output is not opened under current.</source>
        <translation>Spule {0}: {1} A fließen noch; unter Strom wird ihr Ausgang nicht geöffnet.</translation>
    </message>
    <message>
        <source>Ramp it to zero first; or `labcal bench off`.</source>
        <translation>Erst auf null fahren; oder COILS OFF (`labcal bench off`).</translation>
    </message>
    <message>
        <source>it did not answer in the time that there is on the way to zero.</source>
        <translation>es antwortete nicht in der Zeit, die auf dem Weg zu null bleibt.</translation>
    </message>
    <message>
        <source>{0} How the coils are is not known.</source>
        <translation>{0} Wie die Spulen stehen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>{0} A was not sent: this coil was ordered to zero, and {1} A is the most that it may still hear.</source>
        <translation>{0} A wurden nicht gesendet: Für diese Spule ist null befohlen, und {1} A ist das Höchste, was sie noch bekommen darf.</translation>
    </message>
    <message>
        <source>{0}: its output was not closed: this coil was ordered to zero.</source>
        <translation>{0}: sein Ausgang wurde nicht geschlossen: Für diese Spule ist null befohlen.</translation>
    </message>
    <message>
        <source>a field of {0} nT of the coils alone is beyond the limit of {1} nT, Earth&apos;s {2} nT taken off; nothing was set.</source>
        <translation>Ein Feld von {0} nT allein aus den Spulen liegt über der Grenze von {1} nT, das Erdfeld von {2} nT abgezogen; nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>the cage&apos;s calibration is not there: no field is set by it; nothing was set.</source>
        <translation>Die Kalibrierung des Spulenkäfigs fehlt: Nach ihr wird kein Feld eingestellt; nichts wurde eingestellt.</translation>
    </message>
    <message>
        <source>not reached: {0}.</source>
        <translation>nicht erreicht: {0}.</translation>
    </message>
    <message>
        <source>{0}: {1} failed ({2}); its port is there.</source>
        <translation>{0}: {1} misslang ({2}); sein Anschluss ist da.</translation>
    </message>
    <message>
        <source>{0}: {1} was sent and {2} came back.</source>
        <translation>{0}: {1} wurde gesendet, und {2} kam zurück.</translation>
    </message>
    <message>
        <source>Do two talk on this line at once? Without an adapter that echoes, take echo=1 out of the link.</source>
        <translation>Reden zwei zugleich auf dieser Leitung? Ohne einen Adapter mit Echo echo=1 aus der Verbindung nehmen.</translation>
    </message>
    <message>
        <source>{0}: it babbles: more than {1} KiB came without an end, beginning with {2}.</source>
        <translation>{0}: es redet ohne Ende: Mehr als {1} KiB kamen ohne Schluss, zu Beginn {2}.</translation>
    </message>
    <message>
        <source>Is it the instrument that bench.toml names? Pull its cable and plug it in again, or switch it off.</source>
        <translation>Ist es das Gerät, das bench.toml nennt? Sein Kabel ziehen und wieder einstecken, oder es ausschalten.</translation>
    </message>
    <message>
        <source>{0}: {1} registers came where {2} were asked for.</source>
        <translation>{0}: {1} Register kamen, wo {2} gefragt waren.</translation>
    </message>
    <message>
        <source>{0}: no valid Modbus reply.</source>
        <translation>{0}: keine gültige Modbus-Antwort.</translation>
    </message>
    <message>
        <source>{0}: does not answer as it should.</source>
        <translation>{0}: antwortet nicht so, wie es soll.</translation>
    </message>
    <message>
        <source>does not answer as it should.</source>
        <translation>antwortet nicht so, wie es soll.</translation>
    </message>
    <message>
        <source>{0}: the reply belongs to another request.</source>
        <translation>{0}: Die Antwort gehört zu einer anderen Anfrage.</translation>
    </message>
    <message>
        <source>{0}: a program of user {1} is connected to it.</source>
        <translation>{0}: Ein Programm des Benutzers {1} ist damit verbunden.</translation>
    </message>
    <message>
        <source>Ask user {0} to end it, then try again.</source>
        <translation>Den Benutzer {0} bitten, es zu beenden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>End that program, then try again.</source>
        <translation>Das Programm beenden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>End it, then try again.</source>
        <translation>Es beenden, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile.</source>
        <translation>Es beenden, oder die Sitzung, die diesen Messplatz fährt; COILS OFF (`labcal bench off`) bringt seine Spulen inzwischen auf null.</translation>
    </message>
    <message>
        <source>Try again; if it comes again, look at its cable and its adapter.</source>
        <translation>Noch einmal versuchen; kommt es wieder, nach Kabel und Adapter sehen.</translation>
    </message>
    <message>
        <source>returned no data</source>
        <translation>gab keine Daten zurück</translation>
    </message>
    <message>
        <source>its other end has hung up</source>
        <translation>die Gegenseite hat aufgelegt</translation>
    </message>
    <message>
        <source>{0}: {1}° is beyond the ±{2}° of the cables; nothing was sent.</source>
        <translation>{0}: {1}° sind mehr als die ±{2}° der Kabel; nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>{0}: another process has this port.</source>
        <translation>{0}: Ein anderer Prozess hat diesen Anschluss.</translation>
    </message>
    <message>
        <source>Check that the dial&apos;s reading is entered after each turn.</source>
        <translation>Prüfen, ob nach jeder Drehung die Ablesung der Skala eingegeben wird.</translation>
    </message>
    <message>
        <source>{0} deg/s is too fast: DUT and platform allow {1} deg/s</source>
        <translation>{0} deg/s sind zu schnell: Prüfling und Drehtisch erlauben {1} deg/s</translation>
    </message>
    <message>
        <source>{0} deg/s is beyond the DUT&apos;s limit of {1} deg/s; nothing was moved.</source>
        <translation>{0} deg/s liegen über der Grenze des Prüflings von {1} deg/s; nichts wurde bewegt.</translation>
    </message>
    <message>
        <source>the system gives this process no more ({0}); how the coils are is not known.</source>
        <translation>Das System gibt diesem Prozess nichts mehr ({0}); wie die Spulen stehen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Switch the supplies off by hand, or say off again in a new terminal.</source>
        <translation>Die Netzgeräte von Hand ausschalten, oder in einem neuen Terminal noch einmal ausschalten.</translation>
    </message>
    <message>
        <source>the field source has sent no new field for {0} s.</source>
        <translation>Die Feldquelle hat seit {0} s kein neues Feld gesendet.</translation>
    </message>
    <message>
        <source>{0} was {1} when run {2} began, now it is {3}</source>
        <translation>{0} war {1}, als Messung {2} begann, jetzt ist es {3}</translation>
    </message>
    <message>
        <source>run {0} was begun on another bench: a real, a simulated and a served one are not the same</source>
        <translation>Messung {0} wurde an einem anderen Messplatz begonnen: ein echter, ein simulierter und ein bereitgestellter sind nicht derselbe</translation>
    </message>
    <message>
        <source>the bench holds {0}, the run is of {1}: nothing was moved</source>
        <translation>auf dem Messplatz steht {0}, die Messung ist von {1}: nichts wurde bewegt</translation>
    </message>
    <message>
        <source>taking to zero from here what no guardian holds: not read back yet …</source>
        <translation>was kein Wächter hält, wird von hier auf null gebracht: noch nicht zurückgelesen …</translation>
    </message>
    <message>
        <source>before that: {0}</source>
        <translation>davor: {0}</translation>
    </message>
    <message>
        <source>not asked this time; {0} s ago: {1}</source>
        <translation>diesmal nicht gefragt; vor {0} s: {1}</translation>
    </message>
    <message>
        <source>NOT confirmed at zero: {0}</source>
        <translation>NICHT auf null bestätigt: {0}</translation>
    </message>
    <message>
        <source>zero of coil {0} is not confirmed, and tried again</source>
        <translation>null der Spule {0} ist nicht bestätigt, und wird noch einmal versucht</translation>
    </message>
    <message>
        <source>supplies and reference agree again, {0}: {1}</source>
        <translation>Netzgeräte und Referenz stimmen wieder überein, {0}: {1}</translation>
    </message>
    <message>
        <source>the connection to the guardian was lost; {0}.</source>
        <translation>Die Verbindung zum Wächter ging verloren; {0}.</translation>
    </message>
    <message>
        <source>last read before that (UTC): {0}</source>
        <translation>davor zuletzt gelesen (UTC): {0}</translation>
    </message>
    <message>
        <source>no current was read through it</source>
        <translation>durch ihn wurde kein Strom gelesen</translation>
    </message>
    <message>
        <source>a guardian holds the ports and hangs, or was stopped.</source>
        <translation>Ein Wächter hält die Anschlüsse und hängt oder wurde angehalten.</translation>
    </message>
    <message>
        <source>Have it ended, then say off again.</source>
        <translation>Ihn beenden lassen, dann noch einmal ausschalten.</translation>
    </message>
    <message>
        <source>Correct the file and say off again, or switch this supply off by hand.</source>
        <translation>Die Datei berichtigen und noch einmal ausschalten, oder dieses Netzgerät von Hand ausschalten.</translation>
    </message>
    <message>
        <source>open the output of {0} at its panel, or switch it off at its mains</source>
        <translation>den Ausgang von {0} an seinem Bedienfeld öffnen, oder es am Netz ausschalten</translation>
    </message>
    <message>
        <source>switch off {0} at its mains (no command opens its output)</source>
        <translation>{0} am Netz ausschalten (kein Befehl öffnet seinen Ausgang)</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: {2}</source>
        <translation>Es ist, als flössen {0} A in Spule {1}: {2}</translation>
    </message>
    <message>
        <source>Let the DUT come back into its range.</source>
        <translation>Den Prüfling in seinen Bereich zurückkommen lassen.</translation>
    </message>
    <message>
        <source>Let the windings cool, then use less current.</source>
        <translation>Die Wicklungen abkühlen lassen, dann weniger Strom nehmen.</translation>
    </message>
    <message>
        <source>{0}: it sends again, after {1} s</source>
        <translation>{0}: sendet wieder, nach {1} s</translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s</source>
        <translation>{0}: seit {1} s kein Messwert</translation>
    </message>
    <message>
        <source>{0}: no answer</source>
        <translation>{0}: keine Antwort</translation>
    </message>
    <message>
        <source>{0}: it answers again, {1} s after its loss was noticed</source>
        <translation>{0}: antwortet wieder, {1} s nachdem sein Ausfall bemerkt wurde</translation>
    </message>
    <message>
        <source>{0}; every row is kept by now</source>
        <translation>{0}; jede Zeile ist inzwischen gespeichert</translation>
    </message>
    <message>
        <source>{0}, kept by the store {1} s later</source>
        <translation>{0}, vom Speicher {1} s später behalten</translation>
    </message>
    <message>
        <source>{0}; {1} cannot be gone on with: start it anew</source>
        <translation>{0}; {1} kann nicht weiter: neu beginnen</translation>
    </message>
    <message>
        <source>what was not committed is lost</source>
        <translation>was nicht geschrieben war, ist verloren</translation>
    </message>
    <message>
        <source>what it held is lost where there is no copy</source>
        <translation>was er enthielt, ist verloren, wo es keine Kopie gibt</translation>
    </message>
    <message>
        <source>{0} s ago: {1}</source>
        <translation>vor {0} s: {1}</translation>
    </message>
    <message>
        <source>the guardian failed at {0}: {1}: {2}.</source>
        <translation>Der Wächter scheiterte bei {0}: {1}: {2}.</translation>
    </message>
    <message>
        <source>the connection to {0} was lost</source>
        <translation>die Verbindung zu {0} ging verloren</translation>
    </message>
    <message>
        <source>session {0} orders it</source>
        <translation>Sitzung {0} befiehlt es</translation>
    </message>
    <message>
        <source>labcal bench off, process {0}</source>
        <translation>labcal bench off, Prozess {0}</translation>
    </message>
    <message>
        <source>coil {0}: zero was ordered for all coils: {1}.</source>
        <translation>Spule {0}: Für alle Spulen wurde null befohlen: {1}.</translation>
    </message>
    <message>
        <source>zero was ordered; what was being asked of this line was given up.</source>
        <translation>Null wurde befohlen; was auf dieser Leitung gefragt wurde, wurde aufgegeben.</translation>
    </message>
    <message>
        <source>The work was ended by this window.</source>
        <translation>Die Arbeit wurde von diesem Fenster beendet.</translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation>Die Arbeit wurde gewaltsam beendet (Signal {0}).</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Der Arbeitsprozess ließ sich nicht starten.</translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation>Die Arbeit sagte, was dieses Fenster nicht lesen kann, und wurde von ihm beendet.</translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation>Die Arbeit endete von selbst (Ende {0}).</translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation>Die Arbeit stürzte ab (Code {0}).</translation>
    </message>
    <message>
        <source>labcal itself made a mistake here; the details hold what it says of it.</source>
        <translation>labcal selbst hat hier einen Fehler gemacht; was es dazu sagt, steht in den Details.</translation>
    </message>
    <message>
        <source>no run goes on here that could be come back to</source>
        <translation>hier läuft keine Messung, zu der man zurückkehren könnte</translation>
    </message>
    <message>
        <source>the rotation axis is not where it was declared</source>
        <translation>die Drehachse liegt nicht, wo angegeben</translation>
    </message>
    <message>
        <source>something at the cage or the table adds a field</source>
        <translation>etwas am Käfig oder am Tisch fügt ein Feld hinzu</translation>
    </message>
    <message>
        <source>the reading along one axis changes with the field across it</source>
        <translation>die Anzeige längs einer Achse ändert sich mit dem Feld quer dazu</translation>
    </message>
    <message>
        <source>the reference sees the DUT&apos;s own magnetism</source>
        <translation>die Referenz sieht den Magnetismus des Prüflings</translation>
    </message>
    <message>
        <source>the offset follows what was recorded, for no known cause</source>
        <translation>der Offset folgt dem Aufgezeichneten, ohne bekannte Ursache</translation>
    </message>
    <message>
        <source>the platform reads its angle wrong</source>
        <translation>der Tisch liest seinen Winkel falsch ab</translation>
    </message>
    <message>
        <source>the DUT is off the cage&apos;s centre</source>
        <translation>der Prüfling ist nicht in der Mitte des Käfigs</translation>
    </message>
    <message>
        <source>the gain changes with a recorded channel</source>
        <translation>die Verstärkung ändert sich mit einem aufgezeichneten Kanal</translation>
    </message>
    <message>
        <source>the gain jumps at one moment</source>
        <translation>die Verstärkung springt zu einem Zeitpunkt</translation>
    </message>
    <message>
        <source>the gain changes with temperature</source>
        <translation>die Verstärkung ändert sich mit der Temperatur</translation>
    </message>
    <message>
        <source>magnetic parts remember earlier fields</source>
        <translation>magnetische Teile behalten frühere Felder</translation>
    </message>
    <message>
        <source>the readings come later than the field</source>
        <translation>die Anzeige kommt später als das Feld</translation>
    </message>
    <message>
        <source>the reading is not proportional to the field</source>
        <translation>die Anzeige ist dem Feld nicht proportional</translation>
    </message>
    <message>
        <source>the offset changes with a recorded channel</source>
        <translation>der Offset ändert sich mit einem aufgezeichneten Kanal</translation>
    </message>
    <message>
        <source>the offset changes with a current</source>
        <translation>der Offset ändert sich mit einem Strom</translation>
    </message>
    <message>
        <source>the offset changes with the square of a current</source>
        <translation>der Offset ändert sich mit dem Quadrat eines Stroms</translation>
    </message>
    <message>
        <source>the offset drifts with time</source>
        <translation>der Offset driftet mit der Zeit</translation>
    </message>
    <message>
        <source>the offset differs between power modes</source>
        <translation>der Offset ist in jeder Betriebsart anders</translation>
    </message>
    <message>
        <source>the offset jumps at one moment</source>
        <translation>der Offset springt zu einem Zeitpunkt</translation>
    </message>
    <message>
        <source>the offset changes with temperature</source>
        <translation>der Offset ändert sich mit der Temperatur</translation>
    </message>
    <message>
        <source>a periodic disturbance lies on the readings</source>
        <translation>eine periodische Störung liegt auf der Anzeige</translation>
    </message>
    <message>
        <source>the reference drifts with time</source>
        <translation>die Referenz driftet mit der Zeit</translation>
    </message>
    <message>
        <source>the reference changes with temperature</source>
        <translation>die Referenz ändert sich mit der Temperatur</translation>
    </message>
    <message>
        <source>single readings lie far off</source>
        <translation>einzelne Anzeigen liegen weit daneben</translation>
    </message>
    <message>
        <source>readings are at the end of their range</source>
        <translation>Anzeigen stehen am Ende ihres Bereichs</translation>
    </message>
</context>
<context>
    <name>Drop</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>The chosen calibration alone again</source>
        <translation>Wieder nur die gewählte Kalibrierung</translation>
    </message>
    <message>
        <source>Verify a file …</source>
        <translation>Datei prüfen …</translation>
    </message>
    <message>
        <source>Choose a calibration .json with its .sshsig beside it, or drop it on the window</source>
        <translation>Eine Kalibrierung .json mit ihrer .sshsig daneben wählen, oder auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>Verify a calibration</source>
        <translation>Eine Kalibrierung prüfen</translation>
    </message>
</context>
<context>
    <name>EarlierCard</name>
    <message>
        <source>They are gone</source>
        <translation>Sie sind nicht mehr da</translation>
    </message>
    <message>
        <source>▲ Supplies of an earlier session do not answer: {0}</source>
        <translation>▲ Netzgeräte einer früheren Sitzung antworten nicht: {0}</translation>
    </message>
    <message>
        <source>If one of them stands somewhere still, switch it off by hand, then press COILS OFF (F12).</source>
        <translation>Steht eines davon noch irgendwo, von Hand ausschalten, dann SPULEN AUS (F12) drücken.</translation>
    </message>
    <message>
        <source>Where they were taken away, or a simulated lab was served anew, say so.</source>
        <translation>Wurden sie entfernt oder ein simuliertes Labor neu bereitgestellt, hier angeben.</translation>
    </message>
    <message>
        <source>✕ Supplies of an earlier session are not at zero: {0}</source>
        <translation>✕ Netzgeräte einer früheren Sitzung sind nicht auf Null: {0}</translation>
    </message>
    <message>
        <source>Nothing is at their links any more: they are asked for no more, and the audit log has your name</source>
        <translation>An ihren Leitungen ist nichts mehr: sie werden nicht mehr gefragt, und im Prüfprotokoll steht Ihr Name</translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation>Oben den Namen des Bedieners eingeben.</translation>
    </message>
</context>
<context>
    <name>EarlierSupplies</name>
    <message>
        <source>a supply of an earlier session is not at zero: {0}</source>
        <translation>ein Netzgerät einer früheren Sitzung ist nicht auf Null: {0}</translation>
    </message>
    <message>
        <source>{0}: gone, says {1}; it is kept in the audit log</source>
        <translation>{0}: nicht mehr da, sagt {1}; es steht im Prüfprotokoll</translation>
    </message>
</context>
<context>
    <name>FaultCard</name>
    <message>
        <source>Whether hands may go in</source>
        <translation>Ob Hände hinein dürfen</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Show what labcal itself says about it</source>
        <translation>Zeigen, was labcal selbst dazu sagt</translation>
    </message>
    <message>
        <source>Save a problem report …</source>
        <translation>Problembericht sichern …</translation>
    </message>
    <message>
        <source>A .zip with the details, settings and versions, no keys</source>
        <translation>Eine .zip mit Einzelheiten, Einstellungen und Versionen, ohne Schlüssel</translation>
    </message>
    <message>
        <source>Check the zero now</source>
        <translation>Null jetzt prüfen</translation>
    </message>
    <message>
        <source>Coils to zero, then what the reference sees; nothing is energised</source>
        <translation>Spulen auf Null, dann was die Referenz sieht; nichts wird unter Strom gesetzt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Put this card away</source>
        <translation>Diese Karte schließen</translation>
    </message>
    <message>
        <source>For who mends labcal; a problem report holds it:</source>
        <translation>Für die, die labcal reparieren; ein Problembericht enthält es:</translation>
    </message>
</context>
<context>
    <name>FitPage</name>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>Estimate by maximum likelihood, the default method</source>
        <translation>Mit Maximum Likelihood schätzen, dem Standardverfahren</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>Alle Verfahren</translation>
    </message>
    <message>
        <source>Estimate by every method, to see whether they agree</source>
        <translation>Mit jedem Verfahren schätzen, um zu sehen, ob sie übereinstimmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation>Beenden, was gerechnet wird; Fertiges bleibt</translation>
    </message>
    <message>
        <source>Make a draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Write a draft calibration from the selected method</source>
        <translation>Aus dem gewählten Verfahren einen Kalibrierentwurf schreiben</translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation>Rest erklären</translation>
    </message>
    <message>
        <source>Find what causes what is left over: the Loop page</source>
        <translation>Finden, woher der Rest kommt: Seite Ursachen</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Verfahren nebeneinander</translation>
    </message>
    <message>
        <source>value ± U, k=2</source>
        <translation>Wert ± U, k=2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Choose a column to see its pictures</source>
        <translation>Eine Spalte wählen zeigt ihre Bilder</translation>
    </message>
    <message>
        <source>Whether the fit is good</source>
        <translation>Ob die Anpassung gut ist</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>What each of them says</source>
        <translation>Was jedes von ihnen sagt</translation>
    </message>
    <message>
        <source>computing: {0}</source>
        <translation>rechnet: {0}</translation>
    </message>
    <message>
        <source>See what was found</source>
        <translation>Ergebnis ansehen</translation>
    </message>
    <message>
        <source>Pictures and the figures of each method are not kept: Fit works them out again, side by side.</source>
        <translation>Bilder und die Zahlen jedes Verfahrens werden nicht aufbewahrt: Fit rechnet sie noch einmal, nebeneinander.</translation>
    </message>
    <message>
        <source>Fit finds what turns a reading into field: the gains K and the offset k of the sensor. All methods compares eleven ways.</source>
        <translation>Fit findet, was aus einer Anzeige das Feld macht: die Verstärkungen K und den Offset k des Sensors. Alle Verfahren vergleicht elf Wege.</translation>
    </message>
    <message>
        <source>b = K m − k: the field b [nT] of the reading m. K are nine gains, a row for each axis of the field; k is the offset [nT].</source>
        <translation>b = K m − k: das Feld b [nT] zur Anzeige m. K sind neun Verstärkungen, eine Zeile je Achse des Feldes; k ist der Offset [nT].</translation>
    </message>
    <message>
        <source>The first method takes some seconds.</source>
        <translation>Das erste Verfahren braucht einige Sekunden.</translation>
    </message>
    <message>
        <source>Choose a run above, then Fit.</source>
        <translation>Oben eine Messung wählen, dann Fit.</translation>
    </message>
</context>
<context>
    <name>FitViews</name>
    <message>
        <source>The figures of the papers that the methods are from</source>
        <translation>Die Bilder der Arbeiten, aus denen die Verfahren sind</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>What the residual is drawn against</source>
        <translation>Wogegen der Rest gezeichnet ist</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>Gegen</translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation>Rest von |b|  nT</translation>
    </message>
    <message>
        <source>|b|  nT</source>
        <translation>|b|  nT</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>bias of the reading  nT</source>
        <translation>Nullpunkt des Messwerts  nT</translation>
    </message>
    <message>
        <source>degree of spherical harmonics</source>
        <translation>Grad der Kugelfunktionen</translation>
    </message>
    <message>
        <source>rms of the residual  nT</source>
        <translation>rms des Rests  nT</translation>
    </message>
    <message>
        <source>Loci on the sphere (Riwanto 2017, figs. 5, 7)</source>
        <translation>Bahnen auf der Kugel (Riwanto 2017, Bilder 5, 7)</translation>
    </message>
    <message>
        <source>Residual of the magnitude (Crassidis 2003, fig. 3)</source>
        <translation>Rest des Betrags (Crassidis 2003, Bild 3)</translation>
    </message>
    <message>
        <source>Magnitude and reference (Springmann 2011, figs. 2, 4)</source>
        <translation>Betrag und Referenz (Springmann 2011, Bilder 2, 4)</translation>
    </message>
    <message>
        <source>Histogram of the residual (Springmann 2011, fig. 7)</source>
        <translation>Histogramm des Rests (Springmann 2011, Bild 7)</translation>
    </message>
    <message>
        <source>Bias and 3σ as readings come (Crassidis 2003, figs. 1, 2)</source>
        <translation>Nullpunkt und 3σ, wie Messwerte kommen (Crassidis 2003, Bilder 1, 2)</translation>
    </message>
    <message>
        <source>Residual on the sphere, by degree (Risbo 2003)</source>
        <translation>Rest auf der Kugel, nach Grad (Risbo 2003)</translation>
    </message>
    <message>
        <source>grey: as read   strong: calibrated   faint: behind the sphere</source>
        <translation>grau: wie gelesen   kräftig: kalibriert   blass: hinter der Kugel</translation>
    </message>
    <message>
        <source>the ekf, or the filter that is chosen above</source>
        <translation>das EKF oder das oben gewählte Filter</translation>
    </message>
    <message>
        <source>lines: what scatter alone gives   2: products of two components   3: a cubic</source>
        <translation>Linien: was Streuung allein gibt   2: Produkte zweier Komponenten   3: kubisch</translation>
    </message>
    <message>
        <source>band: the noise that this method makes of its own residual, k=2; none is stated</source>
        <translation>Band: das Rauschen, das dieses Verfahren aus seinem eigenen Rest macht, k=2; keines ist angegeben</translation>
    </message>
    <message>
        <source>band: the stated noise of |b|, k=2</source>
        <translation>Band: das angegebene Rauschen von |b|, k=2</translation>
    </message>
    <message>
        <source>line: the noise that this method makes of its own residual; none is stated</source>
        <translation>Linie: das Rauschen, das dieses Verfahren aus seinem eigenen Rest macht; keines ist angegeben</translation>
    </message>
    <message>
        <source>line: the stated noise of |b|</source>
        <translation>Linie: das angegebene Rauschen von |b|</translation>
    </message>
    <message>
        <source>as read</source>
        <translation>wie gelesen</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>kalibriert</translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation>Mittel {0} nT, rms {1} nT</translation>
    </message>
</context>
<context>
    <name>Frame</name>
    <message>
        <source>What is next for this DUT, whichever page is open (Ctrl+N)</source>
        <translation>Was für diesen Prüfling als Nächstes kommt, auf jeder Seite (Ctrl+N)</translation>
    </message>
    <message>
        <source>Next has just changed, and did nothing. It is now: {0}. Press it again.</source>
        <translation>„Nächstes“ hat sich eben geändert und nichts getan. Jetzt heißt es: {0}. Noch einmal drücken.</translation>
    </message>
    <message>
        <source>{0} (Ctrl+{1})</source>
        <translation>{0} (Strg+{1})</translation>
    </message>
    <message>
        <source>the page {0}</source>
        <translation>die Seite {0}</translation>
    </message>
    <message>
        <source>Keys   F1</source>
        <translation>Tasten   F1</translation>
    </message>
    <message>
        <source>Which keys there are, and what each does</source>
        <translation>Welche Tasten es gibt und was jede tut</translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation>dieses Blatt</translation>
    </message>
    <message>
        <source>Dark or light; until then as the system has it</source>
        <translation>Dunkel oder hell; bis dahin wie das System</translation>
    </message>
    <message>
        <source>Letters to be read from two metres, and back (F11)</source>
        <translation>Schrift, die man aus zwei Metern liest, und zurück (F11)</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Until somebody logs in; COILS OFF works all the same</source>
        <translation>Bis sich jemand anmeldet; SPULEN AUS geht trotzdem</translation>
    </message>
    <message>
        <source>Two tones where you are needed, three where it is done; or neither</source>
        <translation>Zwei Töne, wo Sie gebraucht werden, drei, wo es fertig ist; oder keine</translation>
    </message>
    <message>
        <source>The window in this language; not while a run goes on</source>
        <translation>Das Fenster in dieser Sprache; nicht während einer Messung</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Nächstes: {0}</translation>
    </message>
    <message>
        <source>coils off, at any moment</source>
        <translation>Spulen aus, jederzeit</translation>
    </message>
    <message>
        <source>held for {0} s: the answer on the button of this key</source>
        <translation>{0} s gehalten: die Antwort auf dem Knopf dieser Taste</translation>
    </message>
    <message>
        <source>to the next field or button; Shift and Tab goes back, Space presses a button or picks a row, but no answer that mounts, energises or moves: its own key is held</source>
        <translation>zum nächsten Feld oder Knopf; Umschalt und Tab geht zurück, Leertaste drückt oder wählt, aber keine Antwort, die montiert, bestromt oder bewegt: deren eigene Taste wird gehalten</translation>
    </message>
</context>
<context>
    <name>GoingDown</name>
    <message>
        <source>Closing</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Going to zero; the window closes after that …</source>
        <translation>Es geht auf null; danach schließt das Fenster …</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>The run ends, and the window does not close (Esc)</source>
        <translation>Die Messung endet, und das Fenster schließt nicht (Esc)</translation>
    </message>
    <message>
        <source>HANDS OFF: not at zero yet. The window does not close by itself.</source>
        <translation>HÄNDE WEG: noch nicht bei null. Das Fenster schließt sich nicht von selbst.</translation>
    </message>
    <message>
        <source>The run has ended; the window closes.</source>
        <translation>Die Messung ist zu Ende; das Fenster schließt.</translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Runs</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Search: DUT, day …</source>
        <translation>Prüfling, Tag …</translation>
    </message>
    <message>
        <source>Several words narrow it down: EM-07 yesterday explained; or 22.11.2026</source>
        <translation>Mehrere Wörter engen ein: EM-07 gestern explained; oder 22.11.2026</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Look at this run on the Fit page; nothing recorded is ever changed</source>
        <translation>Diese Messung auf der Seite Fit ansehen; Aufgezeichnetes ändert sich nie</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Export …</translation>
    </message>
    <message>
        <source>As bundle, CSV, HDF5 or MATLAB file; of several runs a bundle each</source>
        <translation>Als Paket, CSV-, HDF5- oder MATLAB-Datei; von mehreren Messungen je ein Paket</translation>
    </message>
    <message>
        <source>Correct serial …</source>
        <translation>Nummer ändern …</translation>
    </message>
    <message>
        <source>The DUT was another one: an event of the record, until a calibration of the run is signed</source>
        <translation>Der Prüfling war ein anderer: ein Ereignis der Aufzeichnung, bis eine Kalibrierung der Messung unterschrieben ist</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Import …</translation>
    </message>
    <message>
        <source>A run bundle (.zip) or a recording of others; or drop the file on the window</source>
        <translation>Ein Bündel (.zip) oder eine fremde Aufzeichnung; oder die Datei auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Choose two runs (Ctrl and a click): their figures, residuals and loci</source>
        <translation>Zwei Messungen wählen (Strg und ein Klick): ihre Kennwerte, Reste und Ortskurven</translation>
    </message>
    <message>
        <source>No such run. A run from the Run page, or an imported bundle, comes up here.</source>
        <translation>Keine solche Messung. Eine Messung der Seite Messen oder ein importiertes Bündel erscheint hier.</translation>
    </message>
    <message>
        <source>{0} UTC</source>
        <translation>{0} UTC</translation>
    </message>
    <message>
        <source>The bundle as it was pushed (.zip): import it on this computer to open it</source>
        <translation>Das Paket, wie es übertragen wurde (.zip): auf diesem Rechner importieren, um es zu öffnen</translation>
    </message>
    <message>
        <source>Runs of this computer, or those of all benches in the archive, which are only looked at</source>
        <translation>Messungen dieses Rechners, oder die aller Messplätze im Archiv, die nur angesehen werden</translation>
    </message>
    <message>
        <source>Where the runs are</source>
        <translation>Wo die Messungen liegen</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>The archive was not read. {0}</source>
        <translation>Das Archiv wurde nicht gelesen. {0}</translation>
    </message>
    <message>
        <source>Asking the archive …</source>
        <translation>Das Archiv wird gefragt …</translation>
    </message>
    <message>
        <source>The archive has no such run.</source>
        <translation>Das Archiv hat keine solche Messung.</translation>
    </message>
    <message>
        <source>Correct the serial</source>
        <translation>Seriennummer berichtigen</translation>
    </message>
    <message>
        <source>Serial of the DUT of run {0}:</source>
        <translation>Seriennummer des Prüflings der Messung {0}:</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Run {0}: DUT {1}</source>
        <translation>Messung {0}: Prüfling {1}</translation>
    </message>
    <message>
        <source>Comparing {0} with {1} …</source>
        <translation>{0} wird mit {1} verglichen …</translation>
    </message>
    <message>
        <source>Export the run</source>
        <translation>Messung exportieren</translation>
    </message>
    <message>
        <source>A bundle of each chosen run, into this folder</source>
        <translation>Ein Paket je gewählter Messung, in diesen Ordner</translation>
    </message>
    <message>
        <source>{0} is there already; nothing was written.</source>
        <translation>{0} gibt es schon; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Exported: {0}</source>
        <translation>Exportiert: {0}</translation>
    </message>
    <message>
        <source>Run bundles (*.zip)</source>
        <translation>Bündel (*.zip)</translation>
    </message>
    <message>
        <source>Recordings of others (*)</source>
        <translation>Fremde Aufzeichnungen (*)</translation>
    </message>
    <message>
        <source>Import a run</source>
        <translation>Messung importieren</translation>
    </message>
</context>
<context>
    <name>HoldButton</name>
    <message>
        <source>▲ Let go of {0}: it was down before this question came. Then hold it for 0.7 s.</source>
        <translation>▲ {0} loslassen: die Taste war schon unten, bevor diese Frage kam. Dann 0,7 s halten.</translation>
    </message>
    <message>
        <source>▲ {0} was pressed before this question took an answer. Press it anew.</source>
        <translation>▲ {0} wurde gedrückt, bevor diese Frage eine Antwort nahm. Neu drücken.</translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold {1} for 0.7 s.</source>
        <translation>▲ Zu früh losgelassen, nach {0} s: {1} 0,7 s halten.</translation>
    </message>
    <message>
        <source>▲ Let go too early: the mouse has left the button. Hold {1} for 0.7 s.</source>
        <translation>▲ Zu früh losgelassen: die Maus hat den Knopf verlassen. {1} 0,7 s halten.</translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold this button, or {1}, for 0.7 s.</source>
        <translation>▲ Zu früh losgelassen, nach {0} s: diesen Knopf oder {1} 0,7 s halten.</translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>While this sheet is open no key answers a question; COILS OFF (F12) works.</source>
        <translation>Solange dieses Blatt offen ist, beantwortet keine Taste eine Frage; SPULEN AUS (F12) wirkt.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Put this sheet away (Esc)</source>
        <translation>Dieses Blatt schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>LabWatch</name>
    <message>
        <source>the guardian of the last session has it</source>
        <translation>beim Wächter der letzten Sitzung</translation>
    </message>
    <message>
        <source>still at work</source>
        <translation>noch an der Arbeit</translation>
    </message>
    <message>
        <source>A run goes on and reads the instruments itself; the DUT is read again in its next step.</source>
        <translation>Eine Messung läuft und liest die Geräte selbst; der Prüfling wird in ihrem nächsten Schritt wieder gelesen.</translation>
    </message>
    <message>
        <source>Reading every instrument; nothing is set …</source>
        <translation>Alle Geräte werden gelesen; nichts wird gestellt …</translation>
    </message>
    <message>
        <source>{0} of {1} instruments were read</source>
        <translation>{0} von {1} Geräten wurden gelesen</translation>
    </message>
    <message>
        <source>; the guardian of the last session has {0} until {1} is read back at zero</source>
        <translation>; der Wächter der letzten Sitzung hält {0}, bis {1} bei null zurückgelesen ist</translation>
    </message>
    <message>
        <source>; another process has {0}</source>
        <translation>; ein anderer Prozess hat {0}</translation>
    </message>
</context>
<context>
    <name>LazyPage</name>
    <message>
        <source>This page is being made ready …</source>
        <translation>Diese Seite wird vorbereitet …</translation>
    </message>
    <message>
        <source>All other pages work. Mend the package that brings this page, or uninstall it.</source>
        <translation>Alle anderen Seiten gehen. Das Paket dieser Seite richten oder entfernen.</translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message>
        <source>Show the run</source>
        <translation>Messung zeigen</translation>
    </message>
    <message>
        <source>COILS OFF</source>
        <translation>SPULEN AUS</translation>
    </message>
</context>
<context>
    <name>LeftWithoutEnd</name>
    <message>
        <source>Another process still drives a run of {0} on this bench: wait until it has ended.</source>
        <translation>Ein anderer Prozess führt auf diesem Messplatz noch eine Messung von {0}: warten, bis sie zu Ende ist.</translation>
    </message>
</context>
<context>
    <name>Live</name>
    <message>
        <source>Whose run this is</source>
        <translation>Wessen Messung das ist</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pausing …</source>
        <translation>Pause folgt …</translation>
    </message>
    <message>
        <source>Wait where the next step begins, with the coils at zero</source>
        <translation>Am Beginn des nächsten Schritts warten, Spulen auf null</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>End this run now, in order. The coils go to zero; what was measured is kept.</source>
        <translation>Diese Messung jetzt geordnet beenden. Die Spulen gehen auf null; Gemessenes bleibt.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back to the procedures; the run is in the History</source>
        <translation>Zurück zu den Prozeduren; die Messung steht im Verlauf</translation>
    </message>
    <message>
        <source>What is missing of this run</source>
        <translation>Was an dieser Messung fehlt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>Estimate the calibration from this run</source>
        <translation>Die Kalibrierung aus dieser Messung schätzen</translation>
    </message>
    <message>
        <source>as it was mounted</source>
        <translation>wie eingebaut</translation>
    </message>
    <message>
        <source>Here that is Go on: what was finished is kept.</source>
        <translation>Hier ist das „Weiter“: Was fertig ist, bleibt.</translation>
    </message>
    <message>
        <source>This run has ended: Close, then Begin measures anew.</source>
        <translation>Diese Messung ist zu Ende: „Schließen“, dann misst „Beginnen“ von vorn.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>What was measured is kept in the History. To measure again: Close, then Begin.</source>
        <translation>Gemessenes bleibt im Verlauf. Neu messen: Schließen, dann Beginnen.</translation>
    </message>
    <message>
        <source>{0} Or Close, and begin anew.</source>
        <translation>{0} Oder Schließen und neu beginnen.</translation>
    </message>
</context>
<context>
    <name>LockScreen</name>
    <message>
        <source>Who works here?</source>
        <translation>Wer arbeitet hier?</translation>
    </message>
    <message>
        <source>Your name in the trust list</source>
        <translation>Ihr Name in der Vertrauensliste</translation>
    </message>
    <message>
        <source>Name, or scan your badge</source>
        <translation>Name, oder Ausweis scannen</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Your name stands in the record from here on</source>
        <translation>Ihr Name steht von hier an in der Aufzeichnung</translation>
    </message>
    <message>
        <source>COILS OFF (F12) works all the same. A name says who is meant; signing still asks for your key.</source>
        <translation>SPULEN AUS (F12) geht trotzdem. Ein Name sagt, wer gemeint ist; unterschrieben wird weiterhin mit Ihrem Schlüssel.</translation>
    </message>
</context>
<context>
    <name>LoginViewModel</name>
    <message>
        <source>Nobody of the trust list has the name {0}.</source>
        <translation>Niemand in der Vertrauensliste heißt {0}.</translation>
    </message>
    <message>
        <source>Log in first.</source>
        <translation>Zuerst anmelden.</translation>
    </message>
    <message>
        <source>{0} has not the role measure in the trust list.</source>
        <translation>{0} hat in der Vertrauensliste nicht die Rolle measure.</translation>
    </message>
</context>
<context>
    <name>Logo</name>
    <message>
        <source>The laboratory&apos;s logo</source>
        <translation>Das Logo des Labors</translation>
    </message>
</context>
<context>
    <name>LoopPage</name>
    <message>
        <source>Trace the residual</source>
        <translation>Rest erklären</translation>
    </message>
    <message>
        <source>Find what causes what is left over</source>
        <translation>Finden, woher der Rest kommt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation>Beenden, was gerechnet wird; Fertiges bleibt</translation>
    </message>
    <message>
        <source>To the certificate</source>
        <translation>Zum Zertifikat</translation>
    </message>
    <message>
        <source>The draft with the accepted effects: approve and sign it</source>
        <translation>Der Entwurf mit den angenommenen Effekten: genehmigen und unterschreiben</translation>
    </message>
    <message>
        <source>In figures</source>
        <translation>In Zahlen</translation>
    </message>
    <message>
        <source>The loop&apos;s own words: held-out rms, tests, rows set aside</source>
        <translation>In Worten des Verfahrens: zurückgehaltene rms, Tests, weggelegte Zeilen</translation>
    </message>
    <message>
        <source>1  What is left over</source>
        <translation>1  Was bleibt</translation>
    </message>
    <message>
        <source>noise k=2</source>
        <translation>Rauschen k=2</translation>
    </message>
    <message>
        <source>Band: the noise of one axis of one row</source>
        <translation>Band: das Rauschen einer Achse einer Zeile</translation>
    </message>
    <message>
        <source>3  What could cause it</source>
        <translation>3  Mögliche Ursachen</translation>
    </message>
    <message>
        <source>beside declared errors</source>
        <translation>neben angegebenen Fehlern</translation>
    </message>
    <message>
        <source>2  What it changes</source>
        <translation>2  Was es ändert</translation>
    </message>
    <message>
        <source>Choose one to see what it alone would change.</source>
        <translation>Eine wählen zeigt, was sie allein ändern würde.</translation>
    </message>
    <message>
        <source>No cause was searched for: 4 says why.</source>
        <translation>Nach keiner Ursache wurde gesucht: 4 sagt, warum.</translation>
    </message>
    <message>
        <source>What the residual is drawn against; the named cause first</source>
        <translation>Wogegen der Rest gezeichnet ist; die benannte Ursache zuerst</translation>
    </message>
    <message>
        <source>4  Still not known</source>
        <translation>4  Noch nicht bekannt</translation>
    </message>
    <message>
        <source>Its plan is shown on the Run page before anything moves, and the run is started there</source>
        <translation>Sein Plan steht auf der Seite Messen, bevor sich etwas bewegt; dort wird der Lauf gestartet</translation>
    </message>
    <message>
        <source>This run is of {0}; the DUT at the top is {1}. Put {0} on the bench, and scan it.</source>
        <translation>Diese Messung ist von {0}; der Prüfling oben ist {1}. {0} auf den Messplatz stellen und scannen.</translation>
    </message>
    <message>
        <source>Work it out again</source>
        <translation>Noch einmal rechnen</translation>
    </message>
    <message>
        <source>Choose a run above, then let its residual be traced to a cause.</source>
        <translation>Oben eine Messung wählen, dann ihren Rest auf eine Ursache zurückführen lassen.</translation>
    </message>
    <message>
        <source>Looking at the residual; a whole preflight takes some minutes.</source>
        <translation>Der Rest wird untersucht; ein ganzer Preflight dauert einige Minuten.</translation>
    </message>
    <message>
        <source>Trace the residual of this run to its cause.</source>
        <translation>Den Rest dieser Messung auf seine Ursache zurückführen.</translation>
    </message>
    <message>
        <source>Pictures and the figures of each cause are not kept: “Work it out again” makes them.</source>
        <translation>Bilder und die Zahlen jeder Ursache werden nicht aufbewahrt: „Noch einmal rechnen“ macht sie.</translation>
    </message>
    <message>
        <source>These figures are beside the errors that the run declares; above they are in it.</source>
        <translation>Diese Zahlen sind neben den Fehlern, die die Messung angibt; oben sind sie darin.</translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation>wie kalibriert</translation>
    </message>
    <message>
        <source>or {0}</source>
        <translation>oder {0}</translation>
    </message>
    <message>
        <source>Added to it: {0}.</source>
        <translation>Hinzugefügt: {0}.</translation>
    </message>
    <message>
        <source>Rows set aside: {0} {1}</source>
        <translation>Weggelegte Zeilen: {0} {1}</translation>
    </message>
    <message>
        <source>“{0}” explains it about as well as “{1}”.</source>
        <translation>„{0}“ erklärt es etwa so gut wie „{1}“.</translation>
    </message>
    <message>
        <source>Measured by the procedure {0}.</source>
        <translation>Gemessen mit der Prozedur {0}.</translation>
    </message>
    <message>
        <source>Nothing that this run could show.</source>
        <translation>Nichts, was diese Messung zeigen könnte.</translation>
    </message>
    <message>
        <source>Measure what would tell them apart</source>
        <translation>Messen, was sie unterscheidet</translation>
    </message>
    <message>
        <source>Measure what is missing</source>
        <translation>Messen, was fehlt</translation>
    </message>
    <message>
        <source>2  With “{0}”</source>
        <translation>2  Mit „{0}“</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>rechnet …</translation>
    </message>
    <message>
        <source>it alone would leave {0} nT of the rows of the fit</source>
        <translation>sie allein ließe {0} nT in den Zeilen des Fits</translation>
    </message>
    <message>
        <source>with it</source>
        <translation>mit ihr</translation>
    </message>
</context>
<context>
    <name>Mounting</name>
    <message>
        <source>Drawing: body {0} up</source>
        <translation>Zeichnung: Körperachse {0} oben</translation>
    </message>
    <message>
        <source>Drawing of a dial</source>
        <translation>Zeichnung einer Skale</translation>
    </message>
    <message>
        <source>drawn for platform angle 0°; where it stands is not known</source>
        <translation>gezeichnet für Tischwinkel 0°; wo er steht, ist nicht bekannt</translation>
    </message>
    <message>
        <source>platform at {0}°</source>
        <translation>Tisch bei {0}°</translation>
    </message>
</context>
<context>
    <name>NamedSerials</name>
    <message>
        <source>{0}: is this the right sensor?</source>
        <translation>{0}: Ist das der richtige Sensor?</translation>
    </message>
    <message>
        <source>names itself {0}, not {1}</source>
        <translation>nennt sich {0}, nicht {1}</translation>
    </message>
</context>
<context>
    <name>NamesCard</name>
    <message>
        <source>Named on the certificate</source>
        <translation>Genannt auf dem Zertifikat</translation>
    </message>
    <message>
        <source>Laboratory on the certificate</source>
        <translation>Labor auf dem Zertifikat</translation>
    </message>
    <message>
        <source>The laboratory is asked for once. Its logo: logo.png or logo.svg in labcal&apos;s folder.</source>
        <translation>Nach dem Labor wird einmal gefragt. Sein Logo: logo.png oder logo.svg im Ordner von labcal.</translation>
    </message>
    <message>
        <source>Customer on the certificate</source>
        <translation>Kunde auf dem Zertifikat</translation>
    </message>
    <message>
        <source>For no customer in particular? Leave it empty.</source>
        <translation>Für keinen bestimmten Kunden? Leer lassen.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>The laboratory is remembered for every certificate</source>
        <translation>Das Labor wird für jedes Zertifikat gemerkt</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>State the laboratory, or the customer, anew</source>
        <translation>Labor oder Kunden neu angeben</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>A country is two letters, as DE, or its name.</source>
        <translation>Ein Land sind zwei Buchstaben, etwa DE, oder sein Name.</translation>
    </message>
    <message>
        <source>Keep waits for: {0}.</source>
        <translation>Übernehmen wartet auf: {0}.</translation>
    </message>
    <message>
        <source>Being kept …</source>
        <translation>Wird übernommen …</translation>
    </message>
    <message>
        <source>Laboratory: {0}</source>
        <translation>Labor: {0}</translation>
    </message>
    <message>
        <source>Country, as DE</source>
        <translation>Land, etwa DE</translation>
    </message>
    <message>
        <source>Customer: {0}</source>
        <translation>Kunde: {0}</translation>
    </message>
    <message>
        <source>The certificate names no laboratory.</source>
        <translation>Das Zertifikat nennt kein Labor.</translation>
    </message>
    <message>
        <source>The certificate names no customer.</source>
        <translation>Das Zertifikat nennt keinen Kunden.</translation>
    </message>
    <message>
        <source>The certificate names no laboratory and no customer.</source>
        <translation>Das Zertifikat nennt kein Labor und keinen Kunden.</translation>
    </message>
    <message>
        <source>Certificate of {0}, for {1}.</source>
        <translation>Zertifikat von {0}, für {1}.</translation>
    </message>
    <message>
        <source>✕ “{0}” is no country: two letters, as DE, or its name.</source>
        <translation>✕ „{0}“ ist kein Land: zwei Buchstaben, wie DE, oder sein Name.</translation>
    </message>
</context>
<context>
    <name>NoFit</name>
    <message>
        <source>The other methods</source>
        <translation>Die anderen Verfahren</translation>
    </message>
    <message>
        <source>Estimate by every method that was not tried yet</source>
        <translation>Mit jedem Verfahren schätzen, das noch nicht versucht wurde</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>To the preflight of this DUT on the Run page</source>
        <translation>Zum preflight dieses Prüflings auf der Seite Messen</translation>
    </message>
</context>
<context>
    <name>OneDut</name>
    <message>
        <source>{0}: what is being computed goes on.</source>
        <translation>{0}: Was gerechnet wird, läuft weiter.</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>Report …</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>For people as .html or .pdf, for machines as a DCC (.xml, PTB&apos;s schema)</source>
        <translation>Für Menschen als .html oder .pdf, für Maschinen als DCC (.xml, Schema der PTB)</translation>
    </message>
    <message>
        <source>A folder with all that goes to the customer; the certificate on paper, a label for the DUT</source>
        <translation>Ein Ordner mit allem, was an den Kunden geht; das Zertifikat auf Papier, ein Etikett für den Prüfling</translation>
    </message>
    <message>
        <source>Apply to readings …</source>
        <translation>Anwenden …</translation>
    </message>
    <message>
        <source>Add the field, its uncertainty and flags to a .csv of readings</source>
        <translation>Einer .csv mit Messwerten das Feld, seine Unsicherheit und Kennzeichen zufügen</translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>4  Hand it out</source>
        <translation>4  Ausgeben</translation>
    </message>
    <message>
        <source>All into one folder …</source>
        <translation>Alles in einen Ordner …</translation>
    </message>
    <message>
        <source>Print the certificate</source>
        <translation>Kalibrierschein drucken</translation>
    </message>
    <message>
        <source>Print a label for the DUT</source>
        <translation>Etikett für den Prüfling drucken</translation>
    </message>
    <message>
        <source>Label as a file …</source>
        <translation>Etikett als Datei …</translation>
    </message>
    <message>
        <source>Sent to the printer: {0}</source>
        <translation>An den Drucker gegeben: {0}</translation>
    </message>
    <message>
        <source>Asking the printer …</source>
        <translation>Der Drucker wird gefragt …</translation>
    </message>
    <message>
        <source>Write the label</source>
        <translation>Das Etikett schreiben</translation>
    </message>
    <message>
        <source>Written: {0}</source>
        <translation>Geschrieben: {0}</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Bericht wird geschrieben …</translation>
    </message>
    <message>
        <source>Copy the calibration to: a folder, or the name of a new one</source>
        <translation>Die Kalibrierung kopieren nach: ein Ordner, oder der Name eines neuen</translation>
    </message>
    <message>
        <source>Copy here</source>
        <translation>Hierher kopieren</translation>
    </message>
    <message>
        <source>Handed out into {0}:</source>
        <translation>Ausgegeben nach {0}:</translation>
    </message>
    <message>
        <source>Writing the certificate …</source>
        <translation>Das Zertifikat wird geschrieben …</translation>
    </message>
    <message>
        <source>Readings of this DUT</source>
        <translation>Messwerte dieses Prüflings</translation>
    </message>
    <message>
        <source>Where the field goes</source>
        <translation>Wohin das Feld geschrieben wird</translation>
    </message>
</context>
<context>
    <name>ParameterForm</name>
    <message>
        <source>Settings that most runs leave as they are</source>
        <translation>Einstellungen, die die meisten Messungen lassen, wie sie sind</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Eine Datei wählen</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>expected {0}</source>
        <translation>erwartet {0}</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>▾ Fewer settings</source>
        <translation>▾ Weniger Einstellungen</translation>
    </message>
    <message>
        <source>▸ More settings: {0}</source>
        <translation>▸ Weitere Einstellungen: {0}</translation>
    </message>
</context>
<context>
    <name>PathViewModel</name>
    <message>
        <source>was stopped before its end</source>
        <translation>wurde vor ihrem Ende gestoppt</translation>
    </message>
    <message>
        <source>still goes on</source>
        <translation>läuft noch</translation>
    </message>
    <message>
        <source>What it did not measure would be missing in the calibration. Measure again on the Run page.</source>
        <translation>Was sie nicht gemessen hat, würde der Kalibrierung fehlen. Auf der Seite Messen neu messen.</translation>
    </message>
    <message>
        <source>What it has not measured yet would be missing: go on with it on the Start page.</source>
        <translation>Was sie noch nicht gemessen hat, würde fehlen: auf der Seite Start weiter.</translation>
    </message>
    <message>
        <source>Run {0} {1}. {2}</source>
        <translation>Messung {0} {1}. {2}</translation>
    </message>
    <message>
        <source>Open a bench</source>
        <translation>Messplatz öffnen</translation>
    </message>
    <message>
        <source>See the run</source>
        <translation>Messung ansehen</translation>
    </message>
    <message>
        <source>Answer the question</source>
        <translation>Die Frage beantworten</translation>
    </message>
    <message>
        <source>Wait for the other process</source>
        <translation>Auf den anderen Prozess warten</translation>
    </message>
    <message>
        <source>Stop the platform (COILS OFF)</source>
        <translation>Tisch anhalten (SPULEN AUS)</translation>
    </message>
    <message>
        <source>See to the coils</source>
        <translation>Nach den Spulen sehen</translation>
    </message>
    <message>
        <source>See to {0}</source>
        <translation>Nach {0} sehen</translation>
    </message>
    <message>
        <source>Say which DUT</source>
        <translation>Prüfling nennen</translation>
    </message>
    <message>
        <source>Say who works here</source>
        <translation>Sagen, wer arbeitet</translation>
    </message>
    <message>
        <source>Try the other methods</source>
        <translation>Die anderen Verfahren versuchen</translation>
    </message>
    <message>
        <source>Calibrate {0}</source>
        <translation>{0} kalibrieren</translation>
    </message>
    <message>
        <source>was broken off: {0}</source>
        <translation>wurde unterbrochen: {0}</translation>
    </message>
    <message>
        <source>was broken off</source>
        <translation>wurde unterbrochen</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Weiter mit {0}</translation>
    </message>
    <message>
        <source>See how far the trace is</source>
        <translation>Suche läuft: ansehen</translation>
    </message>
    <message>
        <source>See how far the fit is</source>
        <translation>Rechnung läuft: ansehen</translation>
    </message>
    <message>
        <source>Fit the run</source>
        <translation>Messung fitten</translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation>Rest erklären</translation>
    </message>
    <message>
        <source>See what is not known</source>
        <translation>Sehen, was offen ist</translation>
    </message>
    <message>
        <source>Correct {0}</source>
        <translation>{0} berichtigen</translation>
    </message>
    <message>
        <source>Measure {0} again</source>
        <translation>{0} neu messen</translation>
    </message>
    <message>
        <source>Approve and sign</source>
        <translation>Genehmigen und signieren</translation>
    </message>
    <message>
        <source>Make a new draft</source>
        <translation>Neuen Entwurf machen</translation>
    </message>
    <message>
        <source>The second signature</source>
        <translation>Die zweite Signatur</translation>
    </message>
    <message>
        <source>The next DUT</source>
        <translation>Der nächste Prüfling</translation>
    </message>
    <message>
        <source>Hand it out, as {0}</source>
        <translation>Ausgeben, als {0}</translation>
    </message>
    <message>
        <source>Hand it out</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signieren</translation>
    </message>
</context>
<context>
    <name>PausedHands</name>
    <message>
        <source>Whether hands may go in</source>
        <translation>Ob Hände hinein dürfen</translation>
    </message>
</context>
<context>
    <name>Printer</name>
    <message>
        <source>this computer has no program {0}</source>
        <translation>dieser Rechner hat kein Programm {0}</translation>
    </message>
    <message>
        <source>{0} ended with {1}</source>
        <translation>{0} endete mit {1}</translation>
    </message>
    <message>
        <source>Not printed ({0}): opened, to be printed from there.</source>
        <translation>Nicht gedruckt ({0}): geöffnet, um von dort zu drucken.</translation>
    </message>
</context>
<context>
    <name>ProcedureList</name>
    <message>
        <source>Procedures</source>
        <translation>Prozeduren</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>By name, by what it does, or by what it needs</source>
        <translation>Nach Namen, nach Zweck oder nach Bedarf</translation>
    </message>
    <message>
        <source>None is found. Fewer words, or a part of one?</source>
        <translation>Keine gefunden. Weniger Wörter, oder ein Teil davon?</translation>
    </message>
</context>
<context>
    <name>PromptCard</name>
    <message>
        <source>Question to you</source>
        <translation>Frage an Sie</translation>
    </message>
    <message>
        <source>YOUR TURN</source>
        <translation>SIE SIND DRAN</translation>
    </message>
    <message>
        <source>How the coils are</source>
        <translation>Wie es um die Spulen steht</translation>
    </message>
    <message>
        <source>Write it here</source>
        <translation>Hier schreiben</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Whether hands may go in</source>
        <translation>Ob Hände hinein dürfen</translation>
    </message>
    <message>
        <source>How the platform is</source>
        <translation>Wie der Tisch steht</translation>
    </message>
    <message>
        <source>What moved while an instrument was silent</source>
        <translation>Was sich bewegt hat, während ein Gerät schwieg</translation>
    </message>
    <message>
        <source>Who names another serial</source>
        <translation>Wer eine andere Seriennummer nennt</translation>
    </message>
    <message>
        <source>The simulated bench began anew: its platform is at its zero, nothing has turned.</source>
        <translation>Der simulierte Prüfstand hat neu begonnen: Sein Tisch steht auf null, nichts hat sich gedreht.</translation>
    </message>
    <message>
        <source>Write the path of a file into the answer</source>
        <translation>Den Pfad einer Datei in die Antwort schreiben</translation>
    </message>
    <message>
        <source>Scan it, or type it</source>
        <translation>Scannen oder tippen</translation>
    </message>
    <message>
        <source>Not yet: what it waits for stands above.</source>
        <translation>Noch nicht: worauf es wartet, steht oben.</translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation>{0}: antwortet wieder</translation>
    </message>
    <message>
        <source>Every instrument answers again.</source>
        <translation>Jedes Gerät antwortet wieder.</translation>
    </message>
    <message>
        <source>Skipped, it is missing, and this run does not come back to it; only Redo axis, where that is offered at the next mounting, turns its axis again. The verdict says so, and a calibration may lack what it would tell.</source>
        <translation>Übersprungen fehlt es, und diese Messung kommt nicht darauf zurück; nur „Achse neu“, wo das beim nächsten Einbau angeboten wird, dreht seine Achse noch einmal. Das Urteil sagt es, und einer Kalibrierung kann fehlen, was es gezeigt hätte.</translation>
    </message>
    <message>
        <source>No: nothing is measured, and the run ends. Yes: the record says that you answered so.</source>
        <translation>Nein: Nichts wird gemessen, und die Messung endet. Ja: In der Aufzeichnung steht, dass so geantwortet wurde.</translation>
    </message>
    <message>
        <source>Click, or hold the key for a moment. Enter does nothing here.</source>
        <translation>Klicken oder die Taste einen Moment halten. Die Eingabetaste tut hier nichts.</translation>
    </message>
    <message>
        <source>Hold the button, or its key, until it is full. Enter does nothing here.</source>
        <translation>Knopf oder Taste halten, bis er voll ist. Enter tut hier nichts.</translation>
    </message>
    <message>
        <source>A scan answers by itself; what is typed is sent by Enter.</source>
        <translation>Ein Scan antwortet von selbst; Getipptes sendet die Eingabetaste.</translation>
    </message>
    <message>
        <source>Yes: it goes on as it stands. No: mount it again first.</source>
        <translation>Ja: Es geht weiter, wie er steht. Nein: Zuerst neu einbauen.</translation>
    </message>
    <message>
        <source>No turn was finished: either way it begins with the first step again.</source>
        <translation>Keine Drehung ist fertig: In beiden Fällen beginnt es wieder mit dem ersten Schritt.</translation>
    </message>
    <message>
        <source>Either way turns that were finished stay as they are, with their ticks: each mounting has a phase of its own in the fit. First the zero, the axes and the timing are measured again, to see whether anything moved or drifted; then only what is missing.</source>
        <translation>In beiden Fällen bleiben fertige Drehungen mit ihren Haken, wie sie sind: Jeder Einbau hat im Fit seine eigene Phase. Zuerst werden Null, Achsen und Zeiten noch einmal gemessen, um zu sehen, ob sich etwas bewegt hat oder gedriftet ist; dann nur, was fehlt.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Go on without a file; the record says so</source>
        <translation>Ohne Datei weiter; die Aufzeichnung sagt es</translation>
    </message>
    <message>
        <source>Answer: {0}</source>
        <translation>Antwort: {0}</translation>
    </message>
    <message>
        <source>Click, or hold {0} for 0.7 s</source>
        <translation>Klicken oder {0} 0,7 s halten</translation>
    </message>
    <message>
        <source>Hold this button, or {0}, for 0.7 s</source>
        <translation>Diesen Knopf oder {0} 0,7 s lang halten</translation>
    </message>
    <message>
        <source>A file for the record</source>
        <translation>Eine Datei für die Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>RecordWords</name>
    <message>
        <source>What the procedure noted</source>
        <translation>Was die Prozedur vermerkt hat</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>All that the procedure noted, in its order; no verdict rests on its estimates</source>
        <translation>Alles, was die Prozedur vermerkt hat, der Reihe nach; kein Urteil beruht auf ihren Schätzungen</translation>
    </message>
</context>
<context>
    <name>RecordingView</name>
    <message>
        <source>Recording {0}: what its columns are</source>
        <translation>Aufzeichnung {0}: was ihre Spalten sind</translation>
    </message>
    <message>
        <source>What its columns are</source>
        <translation>Was ihre Spalten sind</translation>
    </message>
    <message>
        <source>guessed: check every line</source>
        <translation>geraten: jede Zeile prüfen</translation>
    </message>
    <message>
        <source>Correct a value as a mapping has it (docs/import.md): &quot;uT&quot;, [&quot;y&quot;, &quot;x&quot;, &quot;-z&quot;], &quot;Bx [nT]&quot;; an empty one takes the line away. accept: [&quot;axes&quot;] lets that doubt pass.</source>
        <translation>Einen Wert so berichtigen, wie er in einer Zuordnung steht (docs/import.md): &quot;uT&quot;, [&quot;y&quot;, &quot;x&quot;, &quot;-z&quot;], &quot;Bx [nT]&quot;; ein leerer nimmt die Zeile weg. accept: [&quot;axes&quot;] lässt diesen Zweifel gelten.</translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation>Ihre Messwerte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the list of runs; nothing is imported</source>
        <translation>Zur Liste der Messungen; nichts wird importiert</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Read the recording by the corrected mapping</source>
        <translation>Die Aufzeichnung nach der berichtigten Zuordnung lesen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Take it into the store by this mapping, as a run of its own</source>
        <translation>Nach dieser Zuordnung als eigene Messung in den Speicher übernehmen</translation>
    </message>
    <message>
        <source>Reading {0} …</source>
        <translation>{0} wird gelesen …</translation>
    </message>
    <message>
        <source>▲ Not imported so: {0}</source>
        <translation>▲ So nicht importierbar: {0}</translation>
    </message>
    <message>
        <source>✓ It can be imported. {0}</source>
        <translation>✓ Kann importiert werden. {0}</translation>
    </message>
    <message>
        <source>{0} changed, not checked</source>
        <translation>{0} geändert, nicht geprüft</translation>
    </message>
    <message>
        <source>Imported: run {0}</source>
        <translation>Importiert: Messung {0}</translation>
    </message>
</context>
<context>
    <name>RunChooser</name>
    <message>
        <source>Run</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>The run to look at, the newest first</source>
        <translation>Die Messung zum Ansehen, die neueste zuerst</translation>
    </message>
    <message>
        <source>Choose a run</source>
        <translation>Messung wählen</translation>
    </message>
    <message>
        <source>{0} is being measured: its run can be looked at once it has ended.</source>
        <translation>{0} wird gemessen: ansehen lässt sich die Messung, sobald sie zu Ende ist.</translation>
    </message>
    <message>
        <source>The run in the store has not ended yet: it can be looked at then.</source>
        <translation>Die Messung im Speicher ist noch nicht zu Ende: danach lässt sie sich ansehen.</translation>
    </message>
</context>
<context>
    <name>RunHeadline</name>
    <message>
        <source>What happens now</source>
        <translation>Was jetzt geschieht</translation>
    </message>
</context>
<context>
    <name>RunNotes</name>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Put a remark with its time into the record, and Enter: “lift moved”. History shows it with the run</source>
        <translation>Eine Bemerkung mit ihrer Zeit in die Aufzeichnung schreiben, dann Enter: „Lift bewegt“. Der Verlauf zeigt sie bei der Messung</translation>
    </message>
    <message>
        <source>Photo …</source>
        <translation>Foto …</translation>
    </message>
    <message>
        <source>Put a photograph into the record, with the note as its words</source>
        <translation>Ein Foto in die Aufzeichnung legen, die Notiz als Text</translation>
    </message>
    <message>
        <source>Kept in the run&apos;s record, which History shows: {0}</source>
        <translation>In der Aufzeichnung der Messung, die der Verlauf zeigt: {0}</translation>
    </message>
    <message>
        <source>A photograph for the record</source>
        <translation>Ein Foto für die Aufzeichnung</translation>
    </message>
    <message>
        <source>photograph</source>
        <translation>Foto</translation>
    </message>
</context>
<context>
    <name>RunViewModel</name>
    <message>
        <source>Coming back to the run that goes on …</source>
        <translation>Zurück zur laufenden Messung …</translation>
    </message>
    <message>
        <source>Asking every instrument who it is …</source>
        <translation>Jedes Gerät wird gefragt, wer es ist …</translation>
    </message>
    <message>
        <source>Hands off: it goes on.</source>
        <translation>Hände weg: Es geht weiter.</translation>
    </message>
    <message>
        <source>It goes on.</source>
        <translation>Es geht weiter.</translation>
    </message>
    <message>
        <source>Pauses where the next step begins.</source>
        <translation>Pausiert am Beginn des nächsten Schritts.</translation>
    </message>
    <message>
        <source>{0} begun</source>
        <translation>{0} begonnen</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird beendet …</translation>
    </message>
    <message>
        <source>Coils off: the run ends …</source>
        <translation>Spulen aus: Die Messung endet …</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation>Geht weiter</translation>
    </message>
</context>
<context>
    <name>ScanCard</name>
    <message>
        <source>From here on this is the serial of the DUT</source>
        <translation>Ab hier ist das die Seriennummer des Prüflings</translation>
    </message>
    <message>
        <source>The scan is forgotten</source>
        <translation>Der Scan wird vergessen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The DUT is the one before again</source>
        <translation>Der Prüfling ist wieder der vorige</translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: no serial has blanks</source>
        <translation>✕ Gescannt und nicht übernommen: Keine Seriennummer hat Leerzeichen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>Scanned {0}. Is it the DUT from here on? Until now: {1}.</source>
        <translation>{0} gescannt. Ist das ab hier der Prüfling? Bisher: {1}.</translation>
    </message>
    <message>
        <source>The DUT is {0}, in place of {1}.</source>
        <translation>Der Prüfling ist {0}, statt {1}.</translation>
    </message>
    <message>
        <source>Take {0}</source>
        <translation>{0} nehmen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Leave {0}</source>
        <translation>{0} lassen</translation>
    </message>
</context>
<context>
    <name>ShownBar</name>
    <message>
        <source>This page shows the DUT to be measured again</source>
        <translation>Diese Seite zeigt wieder den Prüfling, der zu messen ist</translation>
    </message>
    <message>
        <source>From here on this is the DUT to be measured: the one that is mounted</source>
        <translation>Ab jetzt ist dies der Prüfling, der zu messen ist: der montierte</translation>
    </message>
    <message>
        <source>To be measured: {0}; the marks at the left and Next are of it.</source>
        <translation>Zu messen: {0}; die Zeichen links und „Nächstes“ gelten ihm.</translation>
    </message>
    <message>
        <source>Which DUT is to be measured is not said yet.</source>
        <translation>Welcher Prüfling zu messen ist, ist noch nicht gesagt.</translation>
    </message>
    <message>
        <source>Shown: {0}. {1}</source>
        <translation>Gezeigt: {0}. {1}</translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation>Zurück zu {0}</translation>
    </message>
    <message>
        <source>Measure {0}</source>
        <translation>{0} messen</translation>
    </message>
    <message>
        <source>The marks at the left and Next are of no run yet.</source>
        <translation>Die Zeichen links und „Nächstes“ gelten noch keiner Messung.</translation>
    </message>
    <message>
        <source>The marks at the left and Next are of another run: {0}.</source>
        <translation>Die Zeichen links und „Nächstes“ gelten einer anderen Messung: {0}.</translation>
    </message>
    <message>
        <source>Back to that run</source>
        <translation>Zurück zu jener Messung</translation>
    </message>
    <message>
        <source>Put it away</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Whether hands have to be off</source>
        <translation>Ob die Hände weg sein müssen</translation>
    </message>
    <message>
        <source>Change the unit of what is shown: nT, µT, mG. Entry fields keep theirs.</source>
        <translation>Einheit der Anzeige wechseln: nT, µT, mG. Eingabefelder behalten ihre.</translation>
    </message>
    <message>
        <source>FIELD</source>
        <translation>FELD</translation>
    </message>
    <message>
        <source>COILS   A</source>
        <translation>SPULEN   A</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Alle lesen</translation>
    </message>
    <message>
        <source>Read every instrument now: currents, field, angle, who answers. Nothing is set or moved.</source>
        <translation>Jetzt jedes Gerät lesen: Ströme, Feld, Winkel, wer antwortet. Nichts wird gestellt oder bewegt.</translation>
    </message>
    <message>
        <source>PLATFORM</source>
        <translation>TISCH</translation>
    </message>
    <message>
        <source>INSTRUMENTS</source>
        <translation>GERÄTE</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>simulated: began anew at its zero</source>
        <translation>simuliert: neu begonnen, bei null</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>dreht</translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation>Kein Messplatz ist offen.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>Der Messplatz wird geöffnet …</translation>
    </message>
    <message>
        <source>all answer</source>
        <translation>alle antworten</translation>
    </message>
</context>
<context>
    <name>SigningSteps</name>
    <message>
        <source>1  Key</source>
        <translation>1  Schlüssel</translation>
    </message>
    <message>
        <source>Name: letters, digits and . _ @ + - without blanks, as ada.smith. Passphrase: ten characters or more, no single common word, row of keys or name; four words are easy to keep; nothing brings it back.</source>
        <translation>Name: Buchstaben, Ziffern und . _ @ + - ohne Leerzeichen, wie ada.smith. Kennwort: zehn Zeichen oder mehr, kein gewöhnliches Wort allein, keine Tastenreihe, kein Name; vier Wörter sind leicht zu merken; nichts bringt es zurück.</translation>
    </message>
    <message>
        <source>Whose key</source>
        <translation>Wessen Schlüssel</translation>
    </message>
    <message>
        <source>New passphrase</source>
        <translation>Neues Kennwort</translation>
    </message>
    <message>
        <source>Of the new key; asked at each signature</source>
        <translation>Des neuen Schlüssels; wird bei jeder Unterschrift gefragt</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Nochmal</translation>
    </message>
    <message>
        <source>Typed twice: nothing can bring it back</source>
        <translation>Zweimal eingeben: nichts bringt es zurück</translation>
    </message>
    <message>
        <source>The name that this person signs under</source>
        <translation>Der Name, unter dem diese Person unterschreibt</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neuer Schlüssel</translation>
    </message>
    <message>
        <source>Make a key for this name, and trust it in this lab</source>
        <translation>Einen Schlüssel für diesen Namen machen, dem dieses Labor traut</translation>
    </message>
    <message>
        <source>2  Approve</source>
        <translation>2  Genehmigen</translation>
    </message>
    <message>
        <source>No passphrase: an approval is a name in the draft. It binds once this person has signed (3). After the first signature nobody can be added.</source>
        <translation>Kein Kennwort: Eine Genehmigung ist ein Name im Entwurf. Sie bindet, sobald diese Person unterschrieben hat (3). Nach der ersten Unterschrift kommt niemand mehr dazu.</translation>
    </message>
    <message>
        <source>Who approves</source>
        <translation>Wer genehmigt</translation>
    </message>
    <message>
        <source>Another person than the operator, by the name that they sign under</source>
        <translation>Ein anderer Mensch als der Bediener, unter dem Namen, mit dem er unterschreibt</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Genehmigen</translation>
    </message>
    <message>
        <source>Write this name into the draft</source>
        <translation>Diesen Namen in den Entwurf schreiben</translation>
    </message>
    <message>
        <source>3  Sign</source>
        <translation>3  Signieren</translation>
    </message>
    <message>
        <source>These exact bytes: a signed file can no longer be changed.</source>
        <translation>Genau diese Bytes: Eine signierte Datei lässt sich nicht mehr ändern.</translation>
    </message>
    <message>
        <source>Who signs, of those who have a key here</source>
        <translation>Wer unterschreibt, von denen mit einem Schlüssel hier</translation>
    </message>
    <message>
        <source>Who signs</source>
        <translation>Wer unterschreibt</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>Kennwort</translation>
    </message>
    <message>
        <source>Of this person&apos;s key; asked each time</source>
        <translation>Des Schlüssels dieser Person; wird jedes Mal gefragt</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signieren</translation>
    </message>
    <message>
        <source>Sign the file as it is</source>
        <translation>Die Datei signieren, wie sie ist</translation>
    </message>
    <message>
        <source>Until when it is good</source>
        <translation>Bis wann sie gilt</translation>
    </message>
    <message>
        <source>The key&apos;s name is {0}, made of “{1}”; or type another one.</source>
        <translation>Der Name des Schlüssels ist {0}, aus „{1}“; oder einen anderen tippen.</translation>
    </message>
    <message>
        <source>{0} has a key now.</source>
        <translation>{0} hat jetzt einen Schlüssel.</translation>
    </message>
    <message>
        <source>Approve it all the same</source>
        <translation>Trotzdem genehmigen</translation>
    </message>
    <message>
        <source>{0} Approve it all the same?</source>
        <translation>{0} Trotzdem genehmigen?</translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation>Genehmigt von {0}.</translation>
    </message>
    <message>
        <source>Sign it all the same</source>
        <translation>Trotzdem signieren</translation>
    </message>
    <message>
        <source>Choose who signs.</source>
        <translation>Wählen Sie, wer unterschreibt.</translation>
    </message>
    <message>
        <source>Type the passphrase first.</source>
        <translation>Geben Sie zuerst das Kennwort ein.</translation>
    </message>
    <message>
        <source>{0} Sign it all the same?</source>
        <translation>{0} Trotzdem signieren?</translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation>Signiert von {0}.</translation>
    </message>
</context>
<context>
    <name>SortedTable</name>
    <message>
        <source>Click to sort by this column, again to turn the order round</source>
        <translation>Klick sortiert nach dieser Spalte, noch einer kehrt um</translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the right</source>
        <translation>in einer Tabelle: nach der Spalte rechts daneben sortiert</translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the left</source>
        <translation>in einer Tabelle: nach der Spalte links daneben sortiert</translation>
    </message>
    <message>
        <source>in a table: its order turned round</source>
        <translation>in einer Tabelle: ihre Reihenfolge umgekehrt</translation>
    </message>
</context>
<context>
    <name>Standing</name>
    <message>
        <source>The window broke off, and was started again. What it said last is kept in {0}.</source>
        <translation>Das Fenster brach ab und wurde neu gestartet. Was es zuletzt sagte, liegt in {0}.</translation>
    </message>
    <message>
        <source>A run that went on is broken off by its own process: go on with it on Start.</source>
        <translation>Eine laufende Messung wird von ihrem eigenen Prozess unterbrochen: auf Start weiter.</translation>
    </message>
    <message>
        <source>The run went on meanwhile in its own process: here it is.</source>
        <translation>Die Messung lief inzwischen in ihrem eigenen Prozess weiter: Hier ist sie.</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Check the cage</source>
        <translation>Käfig prüfen</translation>
    </message>
    <message>
        <source>The procedure cage-calibration, on the Run page</source>
        <translation>Die Prozedur cage-calibration auf der Seite Messen</translation>
    </message>
    <message>
        <source>Last closing check</source>
        <translation>Letzte Schlussprüfung</translation>
    </message>
    <message>
        <source>Reference sensor</source>
        <translation>Referenzsensor</translation>
    </message>
    <message>
        <source>Cage calibration</source>
        <translation>Käfigkalibrierung</translation>
    </message>
    <message>
        <source>Last runs</source>
        <translation>Letzte Messungen</translation>
    </message>
    <message>
        <source>Signs and axes, the procedure axes-check: 1 minute of measuring, 3 with your own time</source>
        <translation>Vorzeichen und Achsen, Prozedur axes-check: 1 Minute Messzeit, 3 mit Ihrer Zeit</translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation>Die Seite, auf der das getan wird</translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation>Prüfling kalibrieren</translation>
    </message>
    <message>
        <source>The preflight on the Run page</source>
        <translation>Der Preflight auf der Seite Messen</translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>A whole lab without hardware, to learn on</source>
        <translation>Ein ganzes Labor ohne Geräte, zum Lernen</translation>
    </message>
    <message>
        <source>Open a bench …</source>
        <translation>Messplatz öffnen …</translation>
    </message>
    <message>
        <source>Looking into the store.</source>
        <translation>Der Speicher wird gelesen.</translation>
    </message>
    <message>
        <source>A run goes on: {0}, DUT {1}. See the Run page.</source>
        <translation>Eine Messung läuft: {0}, Prüfling {1}. Siehe Seite Messen.</translation>
    </message>
    <message>
        <source>Ready. {0} is to be measured on {1}.</source>
        <translation>Bereit. {0} wird auf {1} gemessen.</translation>
    </message>
    <message>
        <source>✕ Not ready: see what is said of the coils.</source>
        <translation>✕ Nicht bereit: siehe, was von den Spulen gesagt ist.</translation>
    </message>
    <message>
        <source>✕ Not ready: {0}. See the Bench page.</source>
        <translation>✕ Nicht bereit: {0}. Siehe die Seite Messplatz.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>Der Messplatz wird geöffnet …</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation>Kein Messplatz ist offen.</translation>
    </message>
    <message>
        <source>The bench file states no calibration date.</source>
        <translation>Die Messplatzdatei nennt kein Kalibrierdatum.</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>Calibrated {0}, {1} days ago.</source>
        <translation>Kalibriert {0}, vor {1} Tagen.</translation>
    </message>
    <message>
        <source>▲ due</source>
        <translation>▲ fällig</translation>
    </message>
    <message>
        <source>✓ in date</source>
        <translation>✓ gültig</translation>
    </message>
    <message>
        <source>▲ not measured</source>
        <translation>▲ nicht gemessen</translation>
    </message>
    <message>
        <source>The file of what stands in this lab</source>
        <translation>Die Datei dessen, was in diesem Labor steht</translation>
    </message>
    <message>
        <source>▲ A run of {0} did not come to its end: go on with it below, or measure anew.</source>
        <translation>▲ Eine Messung von {0} kam nicht an ihr Ende: unten weiter, oder neu messen.</translation>
    </message>
    <message>
        <source>Coil constants only: Check the cage measures the matrix.</source>
        <translation>Nur Spulenkonstanten: „Käfig prüfen“ misst die Matrix.</translation>
    </message>
    <message>
        <source>The matrix is that of the approved cage calibration {0}.</source>
        <translation>Die Matrix ist die der genehmigten Käfigkalibrierung {0}.</translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation>✓ genehmigt</translation>
    </message>
    <message>
        <source>A matrix without a date: Check the cage says whether it holds.</source>
        <translation>Eine Matrix ohne Datum: „Käfig prüfen“ sagt, ob sie gilt.</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? nicht geprüft</translation>
    </message>
    <message>
        <source>Checked {0}, {1} days ago.</source>
        <translation>Geprüft {0}, vor {1} Tagen.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>stimmt</translation>
    </message>
    <message>
        <source>At its end a run comes back to a position of before, and has to read the same there.</source>
        <translation>Am Ende kommt eine Messung in eine Stellung von vorher zurück und muss dort dasselbe anzeigen.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>No finished run in the store has a closing check.</source>
        <translation>Keine fertige Messung im Speicher hat eine Schlussprüfung.</translation>
    </message>
    <message>
        <source>A run from the Run page, or a bundle imported on the History page, comes up here.</source>
        <translation>Eine Messung der Seite Messen oder ein im Verlauf importiertes Bündel erscheint hier.</translation>
    </message>
</context>
<context>
    <name>StatedFields</name>
    <message>
        <source>Last day, or empty</source>
        <translation>Letzter Tag, oder leer</translation>
    </message>
    <message>
        <source>The last day on which it is good, as 2027-11-21; empty: no date is stated</source>
        <translation>Der letzte Tag, an dem sie gilt, etwa 2027-11-21; leer: kein Datum</translation>
    </message>
    <message>
        <source>Good until</source>
        <translation>Gültig bis</translation>
    </message>
    <message>
        <source>The calibration of the same serial that this one takes the place of</source>
        <translation>Die Kalibrierung derselben Seriennummer, die diese ersetzt</translation>
    </message>
    <message>
        <source>Supersedes</source>
        <translation>Ersetzt</translation>
    </message>
    <message>
        <source>Supersedes none</source>
        <translation>Ersetzt keine</translation>
    </message>
    <message>
        <source>Supersedes {0}</source>
        <translation>Ersetzt {0}</translation>
    </message>
    <message>
        <source>{0} is over: the last day on which it is good is today or later</source>
        <translation>{0} ist vorbei: Der letzte Tag der Gültigkeit ist heute oder später</translation>
    </message>
    <message>
        <source>“{0}” is no day; write it like 2027-11-21 or {1}</source>
        <translation>„{0}“ ist kein Tag; schreiben Sie ihn wie 2027-11-21 oder {1}</translation>
    </message>
</context>
<context>
    <name>StepCard</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What is done in this step</source>
        <translation>Was in diesem Schritt getan wird</translation>
    </message>
</context>
<context>
    <name>StepList</name>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
</context>
<context>
    <name>StudyViewModel</name>
    <message>
        <source>history of {0}</source>
        <translation>Verlauf von {0}</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>aufgegeben</translation>
    </message>
</context>
<context>
    <name>Table</name>
    <message>
        <source>in a table: its chosen rows to the clipboard, or all</source>
        <translation>in einer Tabelle: ihre gewählten Zeilen in die Zwischenablage, oder alle</translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>When it is done, and when you are needed</source>
        <translation>Wann es fertig ist, und wann Sie gebraucht werden</translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} left</source>
        <translation>Schritt {0} von {1} · noch {2}</translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} of simulated time left</source>
        <translation>Schritt {0} von {1} · noch {2} simulierte Zeit</translation>
    </message>
    <message>
        <source>Done at about {0}</source>
        <translation>Fertig gegen {0}</translation>
    </message>
    <message>
        <source>You are needed at {0}: {1}</source>
        <translation>Sie werden um {0} gebraucht: {1}</translation>
    </message>
    <message>
        <source>You are needed within a minute: {0}</source>
        <translation>Sie werden in einer Minute gebraucht: {0}</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Serial number of the device under test: type it, or scan it at any moment</source>
        <translation>Seriennummer des Prüflings: eintippen oder jederzeit scannen</translation>
    </message>
    <message>
        <source>Who works here now; stands in the record and in the calibration</source>
        <translation>Wer hier jetzt arbeitet; steht in Aufzeichnung und Kalibrierung</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>Prüfling</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>nötig</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>Whether hands have to be off</source>
        <translation>Ob die Hände weg sein müssen</translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation>SPULEN AUS   F12</translation>
    </message>
    <message>
        <source>Take every coil to zero now (F12). Works in every state and asks nothing.</source>
        <translation>Jede Spule jetzt auf null (F12). Geht in jedem Zustand und fragt nichts.</translation>
    </message>
</context>
<context>
    <name>TraceProgress</name>
    <message>
        <source>tracing … {0}</source>
        <translation>sucht … {0}</translation>
    </message>
    <message>
        <source>Traced, {0}: {1}</source>
        <translation>Zurückverfolgt, {0}: {1}</translation>
    </message>
</context>
<context>
    <name>Trend</name>
    <message>
        <source>Calibrations over time</source>
        <translation>Kalibrierungen über die Zeit</translation>
    </message>
    <message>
        <source>bars: U, k=2</source>
        <translation>Balken: U, k=2</translation>
    </message>
    <message>
        <source>Zero readings, scale factors from nominal, angles between the axes; gain: from the first calibration</source>
        <translation>Nullanzeigen, Skalenfaktoren gegen Nennwert, Winkel zwischen den Achsen; Verstärkung: gegen die erste Kalibrierung</translation>
    </message>
    <message>
        <source>No calibration of this DUT yet: its parameters and their U come up here, one dot a day.</source>
        <translation>Noch keine Kalibrierung dieses Prüflings: Parameter und U erscheinen hier, ein Punkt je Tag.</translation>
    </message>
    <message>
        <source>Calibrations of {0}</source>
        <translation>Kalibrierungen von {0}</translation>
    </message>
</context>
<context>
    <name>UnfinishedRuns</name>
    <message>
        <source>▲ Unfinished run</source>
        <translation>▲ Unvollendete Messung</translation>
    </message>
    <message>
        <source>Turns that were finished are kept; the zero, the axes and the timing are measured again. Where none was finished it begins with the first step.</source>
        <translation>Fertige Drehungen bleiben; Null, Achsen und Zeiten werden neu gemessen. Wo keine fertig wurde, beginnt es mit dem ersten Schritt.</translation>
    </message>
    <message>
        <source>{0} more on the History page.</source>
        <translation>{0} weitere auf der Seite Verlauf.</translation>
    </message>
    <message>
        <source>Open a bench first.</source>
        <translation>Zuerst einen Messplatz öffnen.</translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation>Was daran fehlt; Sie werden gefragt, ob der Einbau noch steht</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Weiter mit {0}</translation>
    </message>
</context>
<context>
    <name>VerdictCard</name>
    <message>
        <source>DUT</source>
        <translation>Prüfling</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Was gemessen wurde</translation>
    </message>
    <message>
        <source>The pictures and every value with its limit</source>
        <translation>Die Bilder und jeder Wert mit seiner Grenze</translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>what is next for this DUT</source>
        <translation>was für diesen Prüfling als Nächstes kommt</translation>
    </message>
    <message>
        <source>letters to be read from two metres, and back</source>
        <translation>Schrift, die man aus zwei Metern liest, und zurück</translation>
    </message>
    <message>
        <source>{0} files were dropped together; nothing was done with them.</source>
        <translation>{0} Dateien wurden zusammen fallen gelassen; mit ihnen wurde nichts gemacht.</translation>
    </message>
    <message>
        <source>Drop one at a time.</source>
        <translation>Eine nach der anderen fallen lassen.</translation>
    </message>
    <message>
        <source>The window has no room for larger letters: make it larger.</source>
        <translation>Das Fenster hat keinen Platz für größere Buchstaben: vergrößern Sie es.</translation>
    </message>
    <message>
        <source>Go dark</source>
        <translation>Abdunkeln</translation>
    </message>
    <message>
        <source>Go light</source>
        <translation>Aufhellen</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Ton beenden</translation>
    </message>
    <message>
        <source>Unmute</source>
        <translation>Ton zulassen</translation>
    </message>
    <message>
        <source>Begin {0}</source>
        <translation>{0} beginnen</translation>
    </message>
    <message>
        <source>Smaller   F11</source>
        <translation>Kleiner   F11</translation>
    </message>
    <message>
        <source>Larger   F11</source>
        <translation>Größer   F11</translation>
    </message>
    <message>
        <source>Save a problem report</source>
        <translation>Problembericht sichern</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Messplatz</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Ursachen</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation>SPULEN AUS   F12</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Mounted</source>
        <translation>Montiert</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Hingestellt</translation>
    </message>
    <message>
        <source>Taken away</source>
        <translation>Weggenommen</translation>
    </message>
    <message>
        <source>Leads swapped</source>
        <translation>Anschlüsse getauscht</translation>
    </message>
    <message>
        <source>Leads put back</source>
        <translation>Anschlüsse zurückgetauscht</translation>
    </message>
    <message>
        <source>Switched</source>
        <translation>Umgeschaltet</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Eingeschaltet</translation>
    </message>
    <message>
        <source>Warmed</source>
        <translation>Erwärmt</translation>
    </message>
    <message>
        <source>Hands off: begin</source>
        <translation>Hände weg: beginnen</translation>
    </message>
    <message>
        <source>Redo axis {0}</source>
        <translation>Achse {0} neu</translation>
    </message>
    <message>
        <source>offset and first position</source>
        <translation>Offset und erste Stellung</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>antwortet</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>noch nicht gehört</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>nicht gefragt</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>✓ Path copied</source>
        <translation>✓ Pfad kopiert</translation>
    </message>
    <message>
        <source>The path of what was just written, to be pasted elsewhere</source>
        <translation>Der Pfad des eben Geschriebenen, zum Einfügen anderswo</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Open that run on the page that computes it</source>
        <translation>Diese Messung auf der Seite öffnen, die sie rechnet</translation>
    </message>
    <message>
        <source>Show in the file manager what was just written</source>
        <translation>Im Dateimanager zeigen, was eben geschrieben wurde</translation>
    </message>
    <message>
        <source>Go to Run</source>
        <translation>Zum Messen</translation>
    </message>
    <message>
        <source>Record a run, or import one on the History page</source>
        <translation>Eine Messung aufnehmen oder im Verlauf importieren</translation>
    </message>
    <message>
        <source>No run yet: record one on the Run page, or import a bundle on the History page.</source>
        <translation>Noch keine Messung: auf der Seite Messen aufnehmen oder im Verlauf ein Bündel importieren.</translation>
    </message>
    <message>
        <source>Morning check</source>
        <translation>Morgenprüfung</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Messung stoppen</translation>
    </message>
    <message>
        <source>Hands off: try again</source>
        <translation>Hände weg: noch einmal</translation>
    </message>
    <message>
        <source>Mount it again</source>
        <translation>Neu montieren</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>Schritt auslassen</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>✕ This cannot be done as asked</source>
        <translation>✕ So ist das nicht zu machen</translation>
    </message>
    <message>
        <source>✕ An instrument failed</source>
        <translation>✕ Ein Gerät hat versagt</translation>
    </message>
    <message>
        <source>✕ The record is not kept</source>
        <translation>✕ Die Aufzeichnung wird nicht gesichert</translation>
    </message>
    <message>
        <source>✕ The check standard is out of control</source>
        <translation>✕ Das Prüfnormal ist außer Kontrolle</translation>
    </message>
    <message>
        <source>✕ The guardian failed</source>
        <translation>✕ Der Wächter ist ausgefallen</translation>
    </message>
    <message>
        <source>✕ The clock was set back</source>
        <translation>✕ Die Uhr wurde zurückgestellt</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the platform may still turn</source>
        <translation>✕ HÄNDE WEG: Der Tisch kann noch drehen</translation>
    </message>
    <message>
        <source>✕ A limit is not met</source>
        <translation>✕ Eine Grenze ist nicht eingehalten</translation>
    </message>
    <message>
        <source>■ Stopped</source>
        <translation>■ Gestoppt</translation>
    </message>
    <message>
        <source>✕ This page cannot be shown</source>
        <translation>✕ Diese Seite ist nicht zu zeigen</translation>
    </message>
    <message>
        <source>✕ Something in labcal broke</source>
        <translation>✕ In labcal ist etwas kaputtgegangen</translation>
    </message>
    <message>
        <source>✕ The work broke off</source>
        <translation>✕ Die Arbeit brach ab</translation>
    </message>
    <message>
        <source>✓ CLEAN</source>
        <translation>✓ SAUBER</translation>
    </message>
    <message>
        <source>✓ EXPLAINED</source>
        <translation>✓ ERKLÄRT</translation>
    </message>
    <message>
        <source>▲ PARTLY EXPLAINED</source>
        <translation>▲ TEILS ERKLÄRT</translation>
    </message>
    <message>
        <source>? AMBIGUOUS</source>
        <translation>? MEHRDEUTIG</translation>
    </message>
    <message>
        <source>✕ UNEXPLAINED</source>
        <translation>✕ UNERKLÄRT</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>Polung</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>closure</source>
        <translation>Schluss</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
    <message>
        <source>body {0}</source>
        <translation>Körper {0}</translation>
    </message>
    <message>
        <source>body {0} up</source>
        <translation>Körper {0} oben</translation>
    </message>
    <message>
        <source>mount it with body {0} up</source>
        <translation>mit Körper {0} oben einbauen</translation>
    </message>
    <message>
        <source>mount it as at first</source>
        <translation>wie am Anfang einbauen</translation>
    </message>
    <message>
        <source>current {0}</source>
        <translation>Strom {0}</translation>
    </message>
    <message>
        <source>temperature {0}</source>
        <translation>Temperatur {0}</translation>
    </message>
    <message>
        <source>voltage {0}</source>
        <translation>Spannung {0}</translation>
    </message>
    <message>
        <source>channel {0}</source>
        <translation>Kanal {0}</translation>
    </message>
    <message>
        <source>cage X</source>
        <translation>Käfig X</translation>
    </message>
    <message>
        <source>cage Y</source>
        <translation>Käfig Y</translation>
    </message>
    <message>
        <source>role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>who answered</source>
        <translation>wer antwortete</translation>
    </message>
    <message>
        <source>last reading</source>
        <translation>letzter Messwert</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>started</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>today</source>
        <translation>heute</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>gestern</translation>
    </message>
    <message>
        <source>no marks between thousands: 20000, not 20 000, 20,000 or 20.000</source>
        <translation>keine Zeichen zwischen Tausendern: 20000, nicht 20 000, 20,000 oder 20.000</translation>
    </message>
    <message>
        <source>a point stands before decimals here: 1.5, not 1,5</source>
        <translation>hier steht ein Punkt vor Dezimalen: 1.5, nicht 1,5</translation>
    </message>
    <message>
        <source>a blank after each comma, and a point before decimals: 20000, 50000.5</source>
        <translation>ein Leerzeichen nach jedem Komma und ein Punkt vor Dezimalen: 20000, 50000.5</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>Prüfling</translation>
    </message>
    <message>
        <source>procedure</source>
        <translation>Prozedur</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>site</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>U (k=2)</source>
        <translation>U (k=2)</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>limit ±</source>
        <translation>Grenze ±</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>row 1</source>
        <translation>Zeile 1</translation>
    </message>
    <message>
        <source>row 2</source>
        <translation>Zeile 2</translation>
    </message>
    <message>
        <source>row 3</source>
        <translation>Zeile 3</translation>
    </message>
    <message>
        <source>field  µT</source>
        <translation>Feld  µT</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>risk</source>
        <translation>Risiko</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>vorgefunden</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>hinterlassen</translation>
    </message>
    <message>
        <source>earlier</source>
        <translation>früher</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
    <message>
        <source>± U (k=2) is that of the difference; beyond E_n = ±1 the DUT has changed.</source>
        <translation>± U (k=2) ist die der Differenz; jenseits von E_n = ±1 hat sich der Prüfling verändert.</translation>
    </message>
    <message>
        <source>One of the two is traced, the other is not: what differs may be what tracing took out. Trace both, or none.</source>
        <translation>Bei einem der beiden ist der Rest erklärt, beim anderen nicht: Der Unterschied kann sein, was dabei herausgenommen wurde. Bei beiden den Rest erklären, oder bei keinem.</translation>
    </message>
    <message>
        <source>They are of two DUTs. ± U (k=2) is that of the difference.</source>
        <translation>Sie sind von zwei Prüflingen. ± U (k=2) ist die des Unterschieds.</translation>
    </message>
    <message>
        <source>One of the two is not explained: what differs may be its error, and says nothing of the DUT yet.</source>
        <translation>Eine der beiden ist nicht erklärt: Was sich unterscheidet, kann ihr Fehler sein und sagt noch nichts über den Prüfling.</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>{0} changed</source>
        <translation>{0} geändert</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>BESTANDEN</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NICHT BESTANDEN</translation>
    </message>
    <message>
        <source>MARGINAL</source>
        <translation>GRENZFALL</translation>
    </message>
    <message>
        <source>CANNOT DECIDE</source>
        <translation>UNENTSCHEIDBAR</translation>
    </message>
    <message>
        <source>conditional pass</source>
        <translation>bedingt bestanden</translation>
    </message>
    <message>
        <source>conditional fail</source>
        <translation>bedingt nicht bestanden</translation>
    </message>
    <message>
        <source>In specification?</source>
        <translation>In der Spezifikation?</translation>
    </message>
    <message>
        <source>In specification</source>
        <translation>In der Spezifikation</translation>
    </message>
    <message>
        <source>In specification, conditionally</source>
        <translation>In der Spezifikation, bedingt</translation>
    </message>
    <message>
        <source>Not in specification, conditionally</source>
        <translation>Nicht in der Spezifikation, bedingt</translation>
    </message>
    <message>
        <source>Not in specification</source>
        <translation>Nicht in der Spezifikation</translation>
    </message>
    <message>
        <source>Risk: how probably the true value is beyond its limit.</source>
        <translation>Risiko: wie wahrscheinlich der wahre Wert jenseits seiner Grenze liegt.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>held-out |b|  nT</source>
        <translation>zurückgehalten |b|  nT</translation>
    </message>
    <message>
        <source>axis error, worst  deg</source>
        <translation>Achsfehler, größter  Grad</translation>
    </message>
    <message>
        <source>look</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Ursachen</translation>
    </message>
    <message>
        <source>all rows</source>
        <translation>alle Zeilen</translation>
    </message>
    <message>
        <source>declared</source>
        <translation>angegeben</translation>
    </message>
    <message>
        <source>static</source>
        <translation>in Ruhe gemessen</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>aus Differenzen</translation>
    </message>
    <message>
        <source>inertial</source>
        <translation>inertial</translation>
    </message>
    <message>
        <source>nadir</source>
        <translation>zum Nadir</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>angle  deg</source>
        <translation>Winkel  deg</translation>
    </message>
    <message>
        <source>field  nT</source>
        <translation>Feld  nT</translation>
    </message>
    <message>
        <source>time  s</source>
        <translation>Zeit  s</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bezugssystem</translation>
    </message>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>several, with commas</source>
        <translation>mehrere, mit Kommas</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>20 times</source>
        <translation>20-fach</translation>
    </message>
    <message>
        <source>100 times</source>
        <translation>100-fach</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>sofort</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>Skalenfaktor</translation>
    </message>
    <message>
        <source>non-orthogonality</source>
        <translation>Nichtorthogonalität</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>nT</source>
        <translation>nT</translation>
    </message>
    <message>
        <source>ppm from the first</source>
        <translation>ppm gegen die erste</translation>
    </message>
    <message>
        <source>DUT  nT</source>
        <translation>Prüfling  nT</translation>
    </message>
    <message>
        <source>Plot: {0} against {1}</source>
        <translation>Diagramm: {0} über {1}</translation>
    </message>
    <message>
        <source>residual  nT</source>
        <translation>Rest  nT</translation>
    </message>
    <message>
        <source>held-out rms  nT</source>
        <translation>zurückgehaltene rms  nT</translation>
    </message>
    <message>
        <source>no fields all round at one magnitude: see field-sphere</source>
        <translation>keine Felder ringsum bei einem Betrag: siehe field-sphere</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>eingelesen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Write this picture to a .png file, as it is shown</source>
        <translation>Dieses Bild als .png schreiben, wie es zu sehen ist</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Every point that is drawn to the clipboard, as columns x and y of each curve</source>
        <translation>Jeder gezeichnete Punkt in die Zwischenablage, als Spalten x und y jeder Kurve</translation>
    </message>
    <message>
        <source>Needs: {0}</source>
        <translation>Braucht: {0}</translation>
    </message>
    <message>
        <source>About {0:g} min of measuring, and your own time beside it</source>
        <translation>Etwa {0:g} min Messzeit, dazu Ihre eigene</translation>
    </message>
    <message>
        <source>The plan says how long this takes</source>
        <translation>Wie lange das dauert, sagt der Plan</translation>
    </message>
    <message>
        <source>With a key here: {0}.</source>
        <translation>Mit Schlüssel hier: {0}.</translation>
    </message>
    <message>
        <source>Whoever signed has a key elsewhere.</source>
        <translation>Wer unterschrieb, hat anderswo einen Schlüssel.</translation>
    </message>
    <message>
        <source>Nobody has a key here. Make one for the person who approves.</source>
        <translation>Niemand hat hier einen Schlüssel. Einen für die Person machen, die genehmigt.</translation>
    </message>
    <message>
        <source>Only {0} has a key here. Make one for who approves: another person than {1}.</source>
        <translation>Nur {0} hat hier einen Schlüssel. Einen für die Person machen, die genehmigt: nicht {1}.</translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation>Genehmigt von {0}.</translation>
    </message>
    <message>
        <source>Signed without an approval: nobody can be added any more.</source>
        <translation>Ohne Genehmigung signiert: Niemand kommt mehr dazu.</translation>
    </message>
    <message>
        <source>Another person than {0} looks at the figures below, and approves.</source>
        <translation>Ein anderer Mensch als {0} sieht die Werte unten an und genehmigt.</translation>
    </message>
    <message>
        <source>First a key of another person than {0} (1).</source>
        <translation>Zuerst ein Schlüssel eines anderen Menschen als {0} (1).</translation>
    </message>
    <message>
        <source>Do not use it: make a new draft on the Fit page.</source>
        <translation>Nicht verwenden: auf der Seite Fit einen neuen Entwurf machen.</translation>
    </message>
    <message>
        <source>Their key is not on this computer.</source>
        <translation>Ihr Schlüssel ist nicht auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation>Signiert von {0}.</translation>
    </message>
    <message>
        <source>First a key (1).</source>
        <translation>Zuerst ein Schlüssel (1).</translation>
    </message>
    <message>
        <source>After the approval (2). Nobody there? Sign alone: it is valid, and PROVISIONAL.</source>
        <translation>Nach der Genehmigung (2). Niemand da? Allein signieren: gültig und VORLÄUFIG.</translation>
    </message>
    <message>
        <source>Once it is signed (3).</source>
        <translation>Sobald sie signiert ist (3).</translation>
    </message>
    <message>
        <source>Once {0} has signed; before that as PROVISIONAL.</source>
        <translation>Sobald {0} signiert hat; vorher als VORLÄUFIG.</translation>
    </message>
    <message>
        <source>Handed out. Next: another DUT.</source>
        <translation>Ausgegeben. Als Nächstes: ein anderer Prüfling.</translation>
    </message>
    <message>
        <source>As PROVISIONAL: nobody approved it before it was signed.</source>
        <translation>Als VORLÄUFIG: Niemand hat sie vor der Unterschrift genehmigt.</translation>
    </message>
    <message>
        <source>As PROVISIONAL: why is said above.</source>
        <translation>Als VORLÄUFIG: warum, steht oben.</translation>
    </message>
    <message>
        <source>No key can bear “{0}”: letters, digits and . _ @ + - alone, as in ada.smith</source>
        <translation>Kein Schlüssel kann »{0}« heißen: nur Buchstaben, Ziffern und . _ @ + -, wie ada.smith</translation>
    </message>
    <message>
        <source>{0} has a key here already, as {1}.</source>
        <translation>{0} hat hier schon einen Schlüssel, als {1}.</translation>
    </message>
    <message>
        <source>The two passphrases differ.</source>
        <translation>Die beiden Kennwörter sind verschieden.</translation>
    </message>
    <message>
        <source>{0} is the operator, {1}: another person approves.</source>
        <translation>{0} ist der Bediener, {1}: Ein anderer Mensch genehmigt.</translation>
    </message>
    <message>
        <source>the operator</source>
        <translation>der Bediener</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the coils may be on</source>
        <translation>✕ HÄNDE WEG: Die Spulen können eingeschaltet sein</translation>
    </message>
    <message>
        <source>▲ Broken off</source>
        <translation>▲ Unterbrochen</translation>
    </message>
    <message>
        <source>■ Stopped by COILS OFF (F12)</source>
        <translation>■ Durch SPULEN AUS (F12) gestoppt</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>zero reading</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>offset k</source>
        <translation>Offset k</translation>
    </message>
    <message>
        <source>offset k x  nT</source>
        <translation>Offset k x  nT</translation>
    </message>
    <message>
        <source>offset k y  nT</source>
        <translation>Offset k y  nT</translation>
    </message>
    <message>
        <source>offset k z  nT</source>
        <translation>Offset k z  nT</translation>
    </message>
    <message>
        <source>closed loop</source>
        <translation>geschlossener Kreis</translation>
    </message>
    <message>
        <source>stopped by COILS OFF</source>
        <translation>durch SPULEN AUS gestoppt</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>{0} has to sign. The operator may sign as well.</source>
        <translation>{0} muss unterschreiben. Der Bediener darf es auch.</translation>
    </message>
    <message>
        <source>Good to use as PROVISIONAL; {0} has still to sign.</source>
        <translation>Als VORLÄUFIG brauchbar; {0} muss noch unterschreiben.</translation>
    </message>
    <message>
        <source>no answer (plug? power?)</source>
        <translation>keine Antwort (Stecker? Strom?)</translation>
    </message>
    <message>
        <source>no answer (link lost)</source>
        <translation>keine Antwort (Leitung verloren)</translation>
    </message>
    <message>
        <source>heard {0}</source>
        <translation>gehört {0}</translation>
    </message>
    <message>
        <source>heard before</source>
        <translation>früher gehört</translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation>vor {0} s</translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation>vor {0} min</translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation>vor {0} h</translation>
    </message>
    <message>
        <source>changing</source>
        <translation>ändert sich</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>not read in this step</source>
        <translation>in diesem Schritt nicht gelesen</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>read {0} s ago</source>
        <translation>gelesen vor {0} s</translation>
    </message>
    <message>
        <source>▲ Hands off: {0}</source>
        <translation>▲ Hände weg: {0}</translation>
    </message>
    <message>
        <source>▲ Hands off: not read yet</source>
        <translation>▲ Hände weg: noch nicht gelesen</translation>
    </message>
    <message>
        <source>▲ Hands off: not read since {0}; move the mouse, and it is read again</source>
        <translation>▲ Hände weg: seit {0} nicht gelesen; die Maus bewegen, dann wird wieder gelesen</translation>
    </message>
    <message>
        <source>▲ Hands off: the coils are not being read</source>
        <translation>▲ Hände weg: die Spulen werden nicht gelesen</translation>
    </message>
    <message>
        <source>▲ Hands off: the platform is not being read</source>
        <translation>▲ Hände weg: der Tisch wird nicht gelesen</translation>
    </message>
    <message>
        <source>✓ Hands may go in: {0}</source>
        <translation>✓ Hände dürfen hinein: {0}</translation>
    </message>
    <message>
        <source>● Hands may go in: {0}</source>
        <translation>● Hände dürfen hinein: {0}</translation>
    </message>
    <message>
        <source>▲ Hands off: a run of {0} was cut off; the coils are not known</source>
        <translation>▲ Hände weg: eine Messung von {0} wurde abgeschnitten; der Zustand der Spulen ist nicht bekannt</translation>
    </message>
    <message>
        <source>▲ Hands off: another process drives a run of {0}; the coils may be on</source>
        <translation>▲ Hände weg: ein anderer Prozess führt eine Messung von {0}; die Spulen sind vielleicht an</translation>
    </message>
    <message>
        <source>COILS OFF done {0}: {1}</source>
        <translation>SPULEN AUS erledigt {0}: {1}</translation>
    </message>
    <message>
        <source>stop it at its controller, and see it stand</source>
        <translation>an seinem Steuergerät anhalten, und sehen, dass er steht</translation>
    </message>
    <message>
        <source>the platform was ordered to stop, and is not seen to stand yet</source>
        <translation>der Tisch wurde angehalten, und niemand hat ihn bisher stehen sehen</translation>
    </message>
    <message>
        <source>press COILS OFF (F12) first: it stops the platform too, if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation>zuerst SPULEN AUS (F12) drücken: Das hält auch den Tisch an, wenn er erreichbar ist. Dreht er weiter, an seinem Steuergerät anhalten</translation>
    </message>
    <message>
        <source>COILS OFF was pressed, and stops it if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation>SPULEN AUS wurde gedrückt und hält ihn an, wenn er erreichbar ist. Dreht er weiter, an seinem Steuergerät anhalten</translation>
    </message>
    <message>
        <source>platform turning</source>
        <translation>Tisch dreht</translation>
    </message>
    <message>
        <source>platform may turn</source>
        <translation>Tisch dreht vielleicht</translation>
    </message>
    <message>
        <source>Nothing is left over but noise. The calibration may be signed.</source>
        <translation>Nur Rauschen bleibt übrig. Die Kalibrierung darf unterschrieben werden.</translation>
    </message>
    <message>
        <source>The error has a cause: {0}. It is in the draft, which may be signed.</source>
        <translation>Der Fehler hat eine Ursache: {0}. Sie steht im Entwurf, der unterschrieben werden darf.</translation>
    </message>
    <message>
        <source>A part of the error has a cause: {0}. It is in the draft; something else is left over: see 4 before you sign.</source>
        <translation>Ein Teil des Fehlers hat eine Ursache: {0}. Sie steht im Entwurf; etwas anderes bleibt übrig: vor der Unterschrift 4 ansehen.</translation>
    </message>
    <message>
        <source>This may be the cause: {0}. Another one does as well: measure what tells them apart (4), then sign.</source>
        <translation>Das kann die Ursache sein: {0}. Eine andere erklärt es ebenso gut: Messen, was sie unterscheidet (4), dann unterschreiben.</translation>
    </message>
    <message>
        <source>Something is wrong that nothing known explains. Do not sign: see 4.</source>
        <translation>Etwas stimmt nicht, was nichts Bekanntes erklärt. Nicht unterschreiben: siehe 4.</translation>
    </message>
    <message>
        <source>▲ NOT ENOUGH FOR A WHOLE MAP</source>
        <translation>▲ REICHT NICHT FÜR EINE GANZE ABBILDUNG</translation>
    </message>
    <message>
        <source>This run does not determine the whole map: too few axes or fields were measured, so no cause was searched for. That says nothing against the DUT. What to measure stands at 4.</source>
        <translation>Diese Messung bestimmt die Abbildung nicht ganz: zu wenige Achsen oder Felder wurden gemessen, deshalb wurde nach keiner Ursache gesucht. Gegen den Prüfling sagt das nichts. Was zu messen ist, steht bei 4.</translation>
    </message>
    <message>
        <source>rms of the vector, with declared errors; noise alone {0} nT rms</source>
        <translation>rms des Vektors, mit angegebenen Fehlern; Rauschen allein {0} nT rms</translation>
    </message>
    <message>
        <source>before → after: held-out rms of the vector, with the errors in it that the run declares of reference and mounting; noise alone, of one such row: {0} nT, {1}; the figure on the Fit page is of |b| alone, without direction</source>
        <translation>vorher → nachher: zurückgehaltene rms des Vektors, mit den Fehlern darin, die die Messung von Referenz und Einbau angibt; Rauschen allein, einer solchen Zeile: {0} nT, {1}; die Zahl auf der Seite Fit gilt nur |b|, ohne Richtung</translation>
    </message>
    <message>
        <source>explains nothing beyond what is named already</source>
        <translation>erklärt nichts, was das schon Genannte nicht erklärt</translation>
    </message>
    <message>
        <source>explains too little to be worth its parameters</source>
        <translation>erklärt zu wenig für seine Parameter</translation>
    </message>
    <message>
        <source>in files and commands: {0}</source>
        <translation>in Dateien und Befehlen: {0}</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} und {1}</translation>
    </message>
    <message>
        <source>{0}, or {1}</source>
        <translation>{0}, oder {1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} oder {1}</translation>
    </message>
    <message>
        <source>{0} at {1}</source>
        <translation>{0} bei {1}</translation>
    </message>
    <message>
        <source>rows that were set aside</source>
        <translation>weggelegte Zeilen</translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation>Prüfling kalibrieren</translation>
    </message>
    <message>
        <source>Every morning</source>
        <translation>Jeden Morgen</translation>
    </message>
    <message>
        <source>Test a DUT</source>
        <translation>Prüfling testen</translation>
    </message>
    <message>
        <source>The cage and its reference</source>
        <translation>Der Käfig und seine Referenz</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Fit, Loop, Certificate: Next leads there.</source>
        <translation>Fit, Ursachen, Zertifikat: „Nächstes“ führt dorthin.</translation>
    </message>
    <message>
        <source>No calibration of a DUT comes of this procedure. Next leads on.</source>
        <translation>Aus dieser Prozedur entsteht keine Kalibrierung eines Prüflings. „Nächstes“ führt fort.</translation>
    </message>
    <message>
        <source>Within U of its limit: measure that part again, or Fit and see.</source>
        <translation>Innerhalb U an der Grenze: diesen Teil neu messen, oder fitten und sehen.</translation>
    </message>
    <message>
        <source>Look at what was measured, mend the cause, and measure again.</source>
        <translation>Gemessenes ansehen, Ursache beheben, neu messen.</translation>
    </message>
    <message>
        <source>Nothing of it had a limit: look at what was measured.</source>
        <translation>Nichts davon hatte eine Grenze: Gemessenes ansehen.</translation>
    </message>
    <message>
        <source>What was measured is kept. To measure again: Close, then Begin.</source>
        <translation>Gemessenes bleibt. Neu messen: Schließen, dann Beginnen.</translation>
    </message>
    <message>
        <source>Finished turns are kept; Go on measures the zero, the axes and the timing again, then what is missing.</source>
        <translation>Fertige Drehungen bleiben; Weiter misst Null, Achsen und Zeiten noch einmal, dann was fehlt.</translation>
    </message>
    <message>
        <source>Mend what is said above, then measure again: Close, then Begin.</source>
        <translation>Oben Genanntes beheben, dann neu messen: Schließen, dann Beginnen.</translation>
    </message>
    <message>
        <source>PASS of the measurement: |value| + U (k=2) is within its limit ({0} of {0}).</source>
        <translation>BESTANDEN hat die Messung: |Wert| + U (k=2) liegt innerhalb der Grenze ({0} von {0}).</translation>
    </message>
    <message>
        <source>Not measured: {0}.</source>
        <translation>Nicht gemessen: {0}.</translation>
    </message>
    <message>
        <source>{0}, without {1}</source>
        <translation>{0}, ohne {1}</translation>
    </message>
    <message>
        <source>NOT MEASURED</source>
        <translation>NICHT GEMESSEN</translation>
    </message>
    <message>
        <source>Nothing was measured, so this says nothing of the DUT.</source>
        <translation>Nichts wurde gemessen, also sagt das nichts über den Prüfling.</translation>
    </message>
    <message>
        <source>It cannot be gone on with: a result of {0} is worked out from one recording without a gap.</source>
        <translation>Er kann nicht weiter: ein Ergebnis von {0} wird aus einer Aufnahme ohne Lücke berechnet.</translation>
    </message>
    <message>
        <source>The delay is how late the DUT reads behind the platform&apos;s angle. It comes of turns there and back about one axis without a break between; after Go on too few of those are left. To get it: sync-check, or a new preflight.</source>
        <translation>Der Verzug sagt, wie spät der Prüfling hinter dem Winkel der Plattform liest. Er kommt aus Drehungen hin und zurück um eine Achse ohne Unterbrechung; nach Weiter bleiben davon zu wenige. So bekommt man ihn: sync-check oder ein neuer Preflight.</translation>
    </message>
    <message>
        <source>How good the calibration is, Fit and Loop judge.</source>
        <translation>Wie gut die Kalibrierung ist, beurteilen Fit und Ursachen.</translation>
    </message>
    <message>
        <source>Fit, and trace what is left over. Still open then? Measure longer, or with less noise.</source>
        <translation>Anpassen und den Rest erklären. Dann noch offen? Länger messen oder mit weniger Rauschen.</translation>
    </message>
    <message>
        <source>One axis: not enough for a calibration by itself. Measure the others too, or a preflight.</source>
        <translation>Eine Achse: für eine Kalibrierung allein zu wenig. Auch die anderen messen, oder einen Preflight.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: finished turns are kept; the zero, the axes, the timing and the step that broke off are measured again.</source>
        <translation>Beheben Sie, was oben steht, dann Weiter: Fertige Drehungen bleiben; Null, Achsen, Zeiten und der abgebrochene Schritt werden noch einmal gemessen.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on.</source>
        <translation>Beheben Sie, was oben steht, dann Weiter.</translation>
    </message>
    <message>
        <source>No turn was finished: Go on begins with the first step again, and uses nothing of what was measured.</source>
        <translation>Keine Drehung ist fertig: Weiter beginnt wieder mit dem ersten Schritt und nutzt nichts von dem, was gemessen wurde.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: no turn was finished, so it begins with the first step again, and uses nothing of what was measured.</source>
        <translation>Beheben Sie, was oben steht, dann Weiter: Keine Drehung ist fertig, darum beginnt es wieder mit dem ersten Schritt und nutzt nichts von dem, was gemessen wurde.</translation>
    </message>
    <message>
        <source>Nothing was measured: Go on begins with the first step.</source>
        <translation>Nichts wurde gemessen: Weiter beginnt mit dem ersten Schritt.</translation>
    </message>
    <message>
        <source>To measure again: Close, then Begin.</source>
        <translation>Neu messen: Schließen, dann Beginnen.</translation>
    </message>
    <message>
        <source>FAIL where |value| − U (k=2) is beyond the limit: {0}.</source>
        <translation>NICHT BESTANDEN, wo |Wert| − U (k=2) jenseits der Grenze liegt: {0}.</translation>
    </message>
    <message>
        <source>MARGINAL where the limit lies within ± U (k=2): {0}.</source>
        <translation>GRENZFALL, wo die Grenze innerhalb ± U (k=2) liegt: {0}.</translation>
    </message>
    <message>
        <source>CANNOT DECIDE where U (k=2) exceeds half the limit: {0}.</source>
        <translation>UNENTSCHEIDBAR, wo U (k=2) die halbe Grenze übersteigt: {0}.</translation>
    </message>
    <message>
        <source>It did not come to its end, so it has no verdict, and gives no calibration.</source>
        <translation>Sie kam nicht zu ihrem Ende, hat also kein Urteil und gibt keine Kalibrierung.</translation>
    </message>
    <message>
        <source>DONE</source>
        <translation>FERTIG</translation>
    </message>
    <message>
        <source>○ draft</source>
        <translation>○ Entwurf</translation>
    </message>
    <message>
        <source>✕ not valid</source>
        <translation>✕ ungültig</translation>
    </message>
    <message>
        <source>▲ provisional</source>
        <translation>▲ vorläufig</translation>
    </message>
    <message>
        <source>▲ expired</source>
        <translation>▲ abgelaufen</translation>
    </message>
    <message>
        <source>▲ superseded</source>
        <translation>▲ ersetzt</translation>
    </message>
    <message>
        <source>✓ released</source>
        <translation>✓ freigegeben</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>to do now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>not any more</source>
        <translation>nicht mehr</translation>
    </message>
    <message>
        <source>Do not use it any more: measure anew, or take the calibration that came after it.</source>
        <translation>Nicht mehr verwenden: neu messen, oder die Kalibrierung nehmen, die danach kam.</translation>
    </message>
    <message>
        <source>Good until {0}.</source>
        <translation>Gilt bis {0}.</translation>
    </message>
    <message>
        <source>No last day of use is stated: it never expires by itself.</source>
        <translation>Kein letzter Tag ist angegeben: Sie läuft nie von selbst ab.</translation>
    </message>
    <message>
        <source>That day is stated by who approves (2), by the interval of your lab; labcal works none out here.</source>
        <translation>Diesen Tag gibt an, wer genehmigt (2), nach der Frist Ihres Labors; labcal berechnet hier keinen.</translation>
    </message>
    <message>
        <source>So it was stated when it was approved.</source>
        <translation>So wurde es bei der Genehmigung angegeben.</translation>
    </message>
    <message>
        <source>None was when it was approved, and none can be added any more.</source>
        <translation>Bei der Genehmigung wurde keiner angegeben, und es kann keiner mehr dazukommen.</translation>
    </message>
    <message>
        <source>another one</source>
        <translation>eine andere</translation>
    </message>
    <message>
        <source>UNEXPLAINED: what is left of held-out rows has no known cause, and U takes it for random.</source>
        <translation>UNERKLÄRT: was in zurückgehaltenen Zeilen bleibt, hat keine bekannte Ursache, und U nimmt es als zufällig.</translation>
    </message>
    <message>
        <source>Its run did not measure {0}: they were held as they stand.</source>
        <translation>Ihre Messung hat {0} nicht bestimmt: sie blieben, wie sie sind.</translation>
    </message>
    <message>
        <source>Nobody can approve it: turn about the other body axes as well.</source>
        <translation>Niemand kann sie genehmigen: auch um die anderen Körperachsen drehen.</translation>
    </message>
    <message>
        <source>Signed it stays PROVISIONAL, for its run did not measure it whole.</source>
        <translation>Signiert bleibt sie VORLÄUFIG, denn ihre Messung hat sie nicht ganz bestimmt.</translation>
    </message>
    <message>
        <source>As {0}: why is said above.</source>
        <translation>Als {0}: warum, steht oben.</translation>
    </message>
    <message>
        <source>Handed out as {0}. Next: another DUT.</source>
        <translation>Ausgegeben als {0}. Als Nächstes: ein anderer Prüfling.</translation>
    </message>
    <message>
        <source>AMBIGUOUS, the cause is not certain: {0}. It may be another: {1}.</source>
        <translation>MEHRDEUTIG, die Ursache ist nicht sicher: {0}. Es kann eine andere sein: {1}.</translation>
    </message>
    <message>
        <source>PROVISIONAL</source>
        <translation>VORLÄUFIG</translation>
    </message>
    <message>
        <source>handed out</source>
        <translation>ausgegeben</translation>
    </message>
    <message>
        <source>✕ No calibration from this run by {0}</source>
        <translation>✕ Keine Kalibrierung aus dieser Messung mit {0}</translation>
    </message>
    <message>
        <source>✕ No calibration from this run</source>
        <translation>✕ Keine Kalibrierung aus dieser Messung</translation>
    </message>
    <message>
        <source>Offset and gains did not come out of these rows, so nothing can be traced or signed of this run. The DUT may still be good.</source>
        <translation>Offset und Verstärkungen kamen aus diesen Zeilen nicht heraus, also lässt sich von dieser Messung nichts ergründen oder unterschreiben. Der Prüfling kann trotzdem gut sein.</translation>
    </message>
    <message>
        <source>Why: {0}.</source>
        <translation>Warum: {0}.</translation>
    </message>
    <message>
        <source>Next: the other methods. Some of them need less of a run.</source>
        <translation>Als Nächstes: die anderen Verfahren. Einige brauchen weniger von einer Messung.</translation>
    </message>
    <message>
        <source>Next: measure again, with turns about x, y and z and in more than one magnitude, as preflight does it. Look first at the pictures below: a turn that stands apart from the others is the one that went wrong.</source>
        <translation>Als Nächstes: neu messen, mit Drehungen um x, y und z und bei mehr als einer Feldstärke, wie preflight es tut. Vorher die Bilder unten ansehen: Eine Drehung, die abseits der anderen liegt, ist die, die missriet.</translation>
    </message>
    <message>
        <source>Without a result: {0}. What is said above is of {1}, and does not rest on them.</source>
        <translation>Ohne Ergebnis: {0}. Was oben steht, ist von {1} und beruht nicht darauf.</translation>
    </message>
    <message>
        <source>Without a result: {0}.</source>
        <translation>Ohne Ergebnis: {0}.</translation>
    </message>
    <message>
        <source>What is left over is the rms of |b| in held-out rows; its noise is what is stated of |b| in one reading. The figure on the Loop page is of the whole vector in such rows, its direction too.</source>
        <translation>Was übrig bleibt, ist die rms von |b| in zurückgehaltenen Zeilen; sein Rauschen ist das für |b| in einem Messwert angegebene. Die Zahl auf der Seite Loop gilt dem ganzen Vektor in solchen Zeilen, auch seiner Richtung.</translation>
    </message>
    <message>
        <source>{0} nT rms of |b| are left over; no noise is stated to compare it with.</source>
        <translation>{0} nT rms von |b| bleiben übrig; es ist kein Rauschen zum Vergleich angegeben.</translation>
    </message>
    <message>
        <source>No specification is stated.</source>
        <translation>Es ist keine Spezifikation angegeben.</translation>
    </message>
    <message>
        <source>Trace the residual.</source>
        <translation>Den Rest erklären.</translation>
    </message>
    <message>
        <source>✓ The calibration is good in size: {0} nT rms of |b| are left over, no more than its noise, {1} nT rms. The loop judges the direction.</source>
        <translation>✓ Die Kalibrierung ist dem Betrag nach gut: {0} nT rms von |b| bleiben übrig, nicht mehr als sein Rauschen, {1} nT rms. Die Richtung beurteilt die Seite Ursachen.</translation>
    </message>
    <message>
        <source>▲ The map alone is not enough: {0} nT rms of |b| are left over, its noise is {1} nT rms.</source>
        <translation>▲ Die Abbildung allein genügt nicht: {0} nT rms von |b| bleiben übrig, sein Rauschen ist {1} nT rms.</translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The Loop page says what was found.</source>
        <translation>Der Rest wurde untersucht: {0}. Was gefunden wurde, steht auf der Seite Ursachen.</translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The loop&apos;s draft holds its cause.</source>
        <translation>Der Rest wurde untersucht: {0}. Die Ursache steht im Entwurf, den die Seite Ursachen gemacht hat.</translation>
    </message>
    <message>
        <source>▲ This run does not determine the whole map, however little is left over: {0}. It is good for a check, and for no calibration.</source>
        <translation>▲ Diese Messung bestimmt nicht die ganze Abbildung, so wenig auch übrig bleibt: {0}. Sie taugt für eine Prüfung und für keine Kalibrierung.</translation>
    </message>
    <message>
        <source>Opening the simulated lab …</source>
        <translation>Das simulierte Labor wird geöffnet …</translation>
    </message>
    <message>
        <source>guardian</source>
        <translation>Wächter</translation>
    </message>
    <message>
        <source>only in a run</source>
        <translation>nur während einer Messung</translation>
    </message>
    <message>
        <source>The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to zero when a session ends, breaks off or no longer answers.</source>
        <translation>Der Wächter ist ein eigenes Programm neben labcal: Er hält die Leitungen der Netzgeräte und bringt jede Spule auf null, wenn eine Sitzung endet, abbricht oder nicht mehr antwortet.</translation>
    </message>
    <message>
        <source>✕ No answer from {0}</source>
        <translation>✕ Keine Antwort von {0}</translation>
    </message>
    <message>
        <source>✕ No answer from {0} instruments</source>
        <translation>✕ Keine Antwort von {0} Geräten</translation>
    </message>
    <message>
        <source>Here that is “{0}”.</source>
        <translation>Hier heißt das „{0}“.</translation>
    </message>
    <message>
        <source>The run did not end by itself within seconds, so its process was ended.</source>
        <translation>Der Lauf endete nicht binnen Sekunden von selbst, darum wurde sein Prozess beendet.</translation>
    </message>
    <message>
        <source>Then “{0}”.</source>
        <translation>Dann „{0}“.</translation>
    </message>
    <message>
        <source>Kept of this run: {0}</source>
        <translation>Aufbewahrt von dieser Messung: {0}</translation>
    </message>
    <message>
        <source>{0} → {1} nT rms of the vector, noise alone {2} nT rms</source>
        <translation>{0} → {1} nT rms des Vektors, Rauschen allein {2} nT rms</translation>
    </message>
    <message>
        <source>offset k {0} nT by {1}</source>
        <translation>Offset k {0} nT nach {1}</translation>
    </message>
    <message>
        <source>A run goes on: the coils may be on. Hands off.</source>
        <translation>Eine Messung läuft: die Spulen sind vielleicht an. Hände weg.</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Beginnt</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Endet</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pausiert</translation>
    </message>
    <message>
        <source>Hands off</source>
        <translation>Hände weg</translation>
    </message>
    <message>
        <source>{0} s simulated</source>
        <translation>{0} s simuliert</translation>
    </message>
    <message>
        <source>HANDS OFF – no answer from {0}; {1}</source>
        <translation>HÄNDE WEG – keine Antwort von {0}; {1}</translation>
    </message>
    <message>
        <source>HANDS OFF – {0}</source>
        <translation>HÄNDE WEG – {0}</translation>
    </message>
    <message>
        <source>HANDS OFF</source>
        <translation>HÄNDE WEG</translation>
    </message>
    <message>
        <source>▲ Hands off</source>
        <translation>▲ Hände weg</translation>
    </message>
    <message>
        <source>the field and the platform come next</source>
        <translation>als Nächstes kommen Feld und Tisch</translation>
    </message>
    <message>
        <source>the next field or turn comes unasked</source>
        <translation>das nächste Feld oder die nächste Drehung kommt ungefragt</translation>
    </message>
    <message>
        <source>the platform turns next</source>
        <translation>als Nächstes dreht der Tisch</translation>
    </message>
    <message>
        <source>COILS OFF: the run stops …</source>
        <translation>SPULEN AUS: die Messung hält an …</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>es wird angehalten</translation>
    </message>
    <message>
        <source>the step is broken off</source>
        <translation>der Schritt ist abgebrochen</translation>
    </message>
    <message>
        <source>the run begins</source>
        <translation>die Messung beginnt</translation>
    </message>
    <message>
        <source>the run goes on</source>
        <translation>die Messung geht weiter</translation>
    </message>
    <message>
        <source>{0}: no answer from {1}</source>
        <translation>{0}: keine Antwort von {1}</translation>
    </message>
    <message>
        <source>▲ One interruption: {0}. Measured again: {1}.</source>
        <translation>▲ Eine Unterbrechung: {0}. Noch einmal gemessen: {1}.</translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}. Measured again: {2}.</source>
        <translation>▲ {0} Unterbrechungen: {1}. Noch einmal gemessen: {2}.</translation>
    </message>
    <message>
        <source>▲ One interruption: {0}.</source>
        <translation>▲ Eine Unterbrechung: {0}.</translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}.</source>
        <translation>▲ {0} Unterbrechungen: {1}.</translation>
    </message>
    <message>
        <source>at {0}, for {1}</source>
        <translation>bei {0}, Dauer: {1}</translation>
    </message>
    <message>
        <source>before its first step, for {0}</source>
        <translation>vor dem ersten Schritt, Dauer: {0}</translation>
    </message>
    <message>
        <source>at {0}</source>
        <translation>bei {0}</translation>
    </message>
    <message>
        <source>before its first step</source>
        <translation>vor dem ersten Schritt</translation>
    </message>
    <message>
        <source>nobody knows how long</source>
        <translation>niemand weiß, wie lange</translation>
    </message>
    <message>
        <source>{0} s</source>
        <translation>{0} s</translation>
    </message>
    <message>
        <source>{0} min</source>
        <translation>{0} min</translation>
    </message>
    <message>
        <source>{0} h</source>
        <translation>{0} h</translation>
    </message>
    <message>
        <source>Noted, in the run&apos;s record (History shows it): {0}</source>
        <translation>Notiert, in der Aufzeichnung der Messung (der Verlauf zeigt es): {0}</translation>
    </message>
    <message>
        <source>Noted: {0}</source>
        <translation>Vermerkt: {0}</translation>
    </message>
    <message>
        <source>The procedure noted {0} more, the last: {1}</source>
        <translation>Die Prozedur vermerkte {0} weitere, zuletzt: {1}</translation>
    </message>
    <message>
        <source>Estimates on the way: {0} notes; no verdict rests on them.</source>
        <translation>Schätzungen unterwegs: {0} Vermerke; kein Urteil beruht darauf.</translation>
    </message>
    <message>
        <source>Estimates on the way: 1 note; no verdict rests on it.</source>
        <translation>Schätzungen unterwegs: 1 Vermerk; kein Urteil beruht darauf.</translation>
    </message>
    <message>
        <source>▲ Open in the run itself: {0}. An approval takes that as it is.</source>
        <translation>▲ Offen in der Messung selbst: {0}. Eine Genehmigung nimmt das so hin.</translation>
    </message>
    <message>
        <source>{0} not measured</source>
        <translation>{0} nicht gemessen</translation>
    </message>
    <message>
        <source>(not seen: {0})</source>
        <translation>(nicht gesehen: {0})</translation>
    </message>
    <message>
        <source>{0} COILS OFF: {1}</source>
        <translation>{0} SPULEN AUS: {1}</translation>
    </message>
    <message>
        <source>the reference agreed {0}</source>
        <translation>die Referenz stimmte {0} zu</translation>
    </message>
    <message>
        <source>platform stands</source>
        <translation>Tisch steht</translation>
    </message>
    <message>
        <source>No comparison: run {0} is {1}; what it lacks would look like a change.</source>
        <translation>Kein Vergleich: Messung {0} ist {1}; was ihm fehlt, sähe wie eine Änderung aus.</translation>
    </message>
    <message>
        <source>{0}: {1} A when last read, {2}</source>
        <translation>{0}: {1} A, als zuletzt gelesen wurde, {2}</translation>
    </message>
    <message>
        <source>{0}: see to plug, power and cable.</source>
        <translation>{0}: Stecker, Strom und Kabel ansehen.</translation>
    </message>
    <message>
        <source>Read all asks again.</source>
        <translation>„Alles lesen“ fragt wieder.</translation>
    </message>
    <message>
        <source>they have answered at these links before: are their plugs in at both ends, and have they power?</source>
        <translation>sie haben über diese Verbindungen schon geantwortet: stecken ihre Stecker an beiden Enden, und haben sie Strom?</translation>
    </message>
    <message>
        <source>The guardian is lost. COILS OFF (F12) works without it.</source>
        <translation>Der Wächter ist verloren. SPULEN AUS (F12) wirkt ohne ihn.</translation>
    </message>
    <message>
        <source>coil x</source>
        <translation>Spule x</translation>
    </message>
    <message>
        <source>coil y</source>
        <translation>Spule y</translation>
    </message>
    <message>
        <source>coil z</source>
        <translation>Spule z</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>interlock</source>
        <translation>Verriegelung</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>✕ No answer from {0}.</source>
        <translation>✕ Keine Antwort von {0}.</translation>
    </message>
    <message>
        <source>Put that right first: see to plug and power. “Hands off” is not taken before it answers.</source>
        <translation>Erst das beheben: nach Stecker und Strom sehen. „Hände weg“ gilt nicht, bevor es antwortet.</translation>
    </message>
    <message>
        <source>See to plug and power as well: nothing is measured before it answers.</source>
        <translation>Auch nach Stecker und Strom sehen: Es wird nichts gemessen, bevor es antwortet.</translation>
    </message>
    <message>
        <source>{0} (since {1})</source>
        <translation>{0} (seit {1})</translation>
    </message>
    <message>
        <source>First press COILS OFF (F12), then switch off by hand the supply that does not answer.</source>
        <translation>Zuerst SPULEN AUS (F12) drücken, dann das Netzgerät, das nicht antwortet, von Hand ausschalten.</translation>
    </message>
    <message>
        <source>First stop the platform at its controller, and see it stand.</source>
        <translation>Zuerst den Tisch an seinem Steuergerät anhalten, und sehen, dass er steht.</translation>
    </message>
    <message>
        <source>First wait until hands may go in.</source>
        <translation>Zuerst warten, bis Hände hinein dürfen.</translation>
    </message>
    <message>
        <source>No answer from all {0} instruments at {1}: look at their common line, not at each plug.</source>
        <translation>Keine Antwort von allen {0} Geräten an {1}: nach ihrer gemeinsamen Leitung sehen, nicht nach jedem Stecker.</translation>
    </message>
    <message>
        <source>No answer from all {0} instruments: is the rack’s power off, or the adapter or network gone?</source>
        <translation>Keine Antwort von allen {0} Geräten: Ist der Strom des Schranks aus, oder Adapter oder Netz weg?</translation>
    </message>
    <message>
        <source>No answer from {0} instruments, all {1} at {2} among them: look at that common line first.</source>
        <translation>Keine Antwort von {0} Geräten, darunter alle {1} an {2}: zuerst nach dieser gemeinsamen Leitung sehen.</translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation>{0}: antwortet wieder</translation>
    </message>
    <message>
        <source>✓ The zero was checked: supplies and reference agree. A run may begin again.</source>
        <translation>✓ Die Null wurde geprüft: Netzgeräte und Referenz stimmen überein. Eine Messung darf wieder beginnen.</translation>
    </message>
    <message>
        <source>the certificate, for people</source>
        <translation>das Zertifikat, für Menschen</translation>
    </message>
    <message>
        <source>the calibration, for programs</source>
        <translation>die Kalibrierung, für Programme</translation>
    </message>
    <message>
        <source>a signature of it</source>
        <translation>eine Signatur davon</translation>
    </message>
    <message>
        <source>when it was signed</source>
        <translation>wann sie signiert wurde</translation>
    </message>
    <message>
        <source>the keys to verify it by</source>
        <translation>die Schlüssel zum Prüfen</translation>
    </message>
    <message>
        <source>this list, for the customer</source>
        <translation>diese Liste, für den Kunden</translation>
    </message>
    <message>
        <source>{0} in the store</source>
        <translation>{0} im Speicher</translation>
    </message>
    <message>
        <source>{0} of {1} in the store</source>
        <translation>{0} von {1} im Speicher</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Genehmigen</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signieren</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Make a key (1)</source>
        <translation>Einen Schlüssel anlegen (1)</translation>
    </message>
    <message>
        <source>Approve (2)</source>
        <translation>Genehmigen (2)</translation>
    </message>
    <message>
        <source>Sign (3)</source>
        <translation>Signieren (3)</translation>
    </message>
    <message>
        <source>Hand it out (4)</source>
        <translation>Ausgeben (4)</translation>
    </message>
    <message>
        <source>By the method {0}. Zero reading: what the sensor indicates in no field; the offset k of b = K m − k is under Map.</source>
        <translation>Nach der Methode {0}. Nullpunkt: was der Sensor ohne Feld anzeigt; der Offset k von b = K m − k steht unter Abbildung.</translation>
    </message>
    <message>
        <source>U of one component of the field: up to {0} nT (k = 2), {1} % of it from {2}.</source>
        <translation>U einer Feldkomponente: bis zu {0} nT (k = 2), {1} % davon aus {2}.</translation>
    </message>
    <message>
        <source>U of one component of the field: {0} nT (k = 2), mostly from the mounting, declared good to {1}°.</source>
        <translation>U einer Feldkomponente: {0} nT (k = 2), das meiste aus der Montage, die auf {1}° genau angegeben ist.</translation>
    </message>
    <message>
        <source>To lower it, mount more exactly and declare that (u_mounting_deg): docs/certificate.md</source>
        <translation>Kleiner wird es, wenn genauer montiert und das angegeben wird (u_mounting_deg): docs/certificate.md</translation>
    </message>
    <message>
        <source>What it is made of: docs/certificate.md</source>
        <translation>Woraus es besteht: docs/certificate.md</translation>
    </message>
    <message>
        <source>the declared mounting ({0})</source>
        <translation>die angegebene Montage ({0})</translation>
    </message>
    <message>
        <source>the reference sees {0} µT along {1} more than with the coils off</source>
        <translation>die Referenz sieht {0} µT längs {1} mehr als bei ausgeschalteten Spulen</translation>
    </message>
    <message>
        <source>the field says: still on ({1}, {0} µT more than with the coils off, {2})</source>
        <translation>das Feld sagt: noch an ({1}, {0} µT mehr als bei ausgeschalteten Spulen, {2})</translation>
    </message>
    <message>
        <source>a coil is still on by the field</source>
        <translation>eine Spule ist nach dem Feld noch an</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: a coil is still on, the field says so</source>
        <translation>✕ HÄNDE WEG: Eine Spule ist noch an, das sagt das Feld</translation>
    </message>
    <message>
        <source>{0}: not confirmed at zero when the window closed, {1}</source>
        <translation>{0}: nicht bei null bestätigt, als das Fenster geschlossen wurde, {1}</translation>
    </message>
    <message>
        <source>{0}: not confirmed at a standstill when the window closed, {1}</source>
        <translation>{0}: Stillstand nicht bestätigt, als das Fenster geschlossen wurde, {1}</translation>
    </message>
    <message>
        <source>about {0} s more, said at {1}</source>
        <translation>noch etwa {0} s, gesagt um {1}</translation>
    </message>
    <message>
        <source>about {0} s more, longer than was said before; said at {1}</source>
        <translation>noch etwa {0} s, länger als vorher gesagt; gesagt um {1}</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Nächstes: {0}</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>kann nicht angezeigt werden</translation>
    </message>
    <message>
        <source>{0} · run of {1}</source>
        <translation>{0} · Messung vom {1}</translation>
    </message>
    <message>
        <source>COILS OFF (F12), then switch off by hand: {0}</source>
        <translation>SPULEN AUS (F12), dann von Hand ausschalten: {0}</translation>
    </message>
    <message>
        <source>Switch off by hand: {0}</source>
        <translation>Von Hand ausschalten: {0}</translation>
    </message>
    <message>
        <source>Still to be read: {0}</source>
        <translation>Noch zu lesen: {0}</translation>
    </message>
    <message>
        <source>{0} (last read {1})</source>
        <translation>{0} (zuletzt gelesen {1})</translation>
    </message>
    <message>
        <source>COILS OFF was pressed at {0}; nobody has confirmed it</source>
        <translation>SPULEN AUS wurde um {0} gedrückt; niemand hat es bestätigt</translation>
    </message>
    <message>
        <source>zero, output open</source>
        <translation>null, Ausgang offen</translation>
    </message>
    <message>
        <source>zero, output not open</source>
        <translation>null, Ausgang nicht offen</translation>
    </message>
    <message>
        <source>{0}: answers again, no answer from {1} to {2}</source>
        <translation>{0}: antwortet wieder, keine Antwort von {1} bis {2}</translation>
    </message>
    <message>
        <source>▲ Not traced: {0} nT of |b| are left over beyond the map, and nobody has looked for their cause.</source>
        <translation>▲ Rest nicht erklärt: {0} nT von |b| bleiben über die Abbildung hinaus übrig, und niemand hat nach ihrer Ursache gesucht.</translation>
    </message>
    <message>
        <source>To do here: {0}</source>
        <translation>Hier zu tun: {0}</translation>
    </message>
    <message>
        <source>▲ Not traced: nobody has looked for the cause of what is left over beyond the map.</source>
        <translation>▲ Rest nicht erklärt: Niemand hat nach der Ursache dessen gesucht, was über die Abbildung hinaus übrig bleibt.</translation>
    </message>
    <message>
        <source>They are of two DUTs: their offsets and gains are no change of one, and stand in no table. Residuals and loci of both are drawn below.</source>
        <translation>Sie sind von zwei Prüflingen: Offsets und Skalenfaktoren sind keine Änderung von einem und stehen in keiner Tabelle. Reste und Ortskurven von beiden sind unten gezeichnet.</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>takes off  nT</source>
        <translation>nimmt weg  nT</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>Evidenz</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>in files</source>
        <translation>in Dateien</translation>
    </message>
    <message>
        <source>✓ named</source>
        <translation>✓ benannt</translation>
    </message>
    <message>
        <source>? rival</source>
        <translation>? Rivale</translation>
    </message>
    <message>
        <source>– not named</source>
        <translation>– nicht benannt</translation>
    </message>
    <message>
        <source>enough</source>
        <translation>genug</translation>
    </message>
    <message>
        <source>too little</source>
        <translation>zu wenig</translation>
    </message>
    <message>
        <source>does about as well as “{0}”</source>
        <translation>tut es etwa so gut wie „{0}“</translation>
    </message>
    <message>
        <source>no evidence</source>
        <translation>keine Evidenz</translation>
    </message>
    <message>
        <source>back {0}, out since {1}</source>
        <translation>wieder da {0}, weg seit {1}</translation>
    </message>
    <message>
        <source>The instruments of your lab: open its bench file, and see that each answers.</source>
        <translation>Die Geräte Ihres Labors: die Messplatzdatei öffnen und sehen, dass jedes antwortet.</translation>
    </message>
    <message>
        <source>You mount the DUT about each axis; coils and platform do the rest.</source>
        <translation>Sie bauen den Prüfling um jede Achse ein; Spulen und Tisch tun das Übrige.</translation>
    </message>
    <message>
        <source>Offset, scale and angles from that run, each with its uncertainty.</source>
        <translation>Nullpunkt, Skalenfaktor und Winkel aus dieser Messung, je mit Unsicherheit.</translation>
    </message>
    <message>
        <source>What is left over is traced to its cause, and tried on held-out data.</source>
        <translation>Was übrig bleibt, wird auf seine Ursache zurückgeführt und an zurückgehaltenen Daten geprüft.</translation>
    </message>
    <message>
        <source>Another person approves, you sign, and it is handed out.</source>
        <translation>Eine andere Person genehmigt, Sie signieren, und die Datei wird ausgegeben.</translation>
    </message>
    <message>
        <source>Measured already, and kept: {0} (how late the reading follows the field).</source>
        <translation>Schon gemessen, und bleibt: {0} (wie spät die Anzeige dem Feld folgt).</translation>
    </message>
    <message>
        <source>Lost: {0}, which comes of turns there and back without a break, and too few of those are left to measure. To get it: sync-check, or a new preflight.</source>
        <translation>Verloren: {0}; er kommt aus Drehungen hin und zurück ohne Unterbrechung, und davon sind zu wenige noch zu messen. So bekommt man ihn: sync-check oder ein neuer Preflight.</translation>
    </message>
    <message>
        <source>✓ done for this DUT</source>
        <translation>✓ für diesen Prüfling erledigt</translation>
    </message>
    <message>
        <source>● it goes on now</source>
        <translation>● es läuft jetzt</translation>
    </message>
    <message>
        <source>▲ done, and something of it is open: the page says what</source>
        <translation>▲ erledigt, und etwas davon ist offen: Die Seite sagt, was</translation>
    </message>
    <message>
        <source>✕ it failed: the page says why</source>
        <translation>✕ es ist gescheitert: Die Seite sagt, warum</translation>
    </message>
    <message>
        <source>○ still to be done for this DUT</source>
        <translation>○ für diesen Prüfling noch zu tun</translation>
    </message>
    <message>
        <source>✓ every instrument answered within the last {0} s</source>
        <translation>✓ jedes Gerät hat in den letzten {0} s geantwortet</translation>
    </message>
    <message>
        <source>● no answer within the last {0} s, for nobody asked: {1}. By themselves they are asked now and then.</source>
        <translation>● keine Antwort in den letzten {0} s, denn niemand hat gefragt: {1}. Von selbst werden sie ab und zu gefragt.</translation>
    </message>
    <message>
        <source>✕ no answer: {1}</source>
        <translation>✕ keine Antwort: {1}</translation>
    </message>
    <message>
        <source>○ no instrument answered within the last {0} s; Read all asks them</source>
        <translation>○ kein Gerät hat in den letzten {0} s geantwortet; Alle lesen fragt sie</translation>
    </message>
    <message>
        <source>✓ a run that this DUT can be calibrated by is finished</source>
        <translation>✓ eine Messung, mit der dieser Prüfling kalibriert werden kann, ist fertig</translation>
    </message>
    <message>
        <source>▲ the last run that was to calibrate this DUT did not come to its end</source>
        <translation>▲ die letzte Messung, die diesen Prüfling kalibrieren sollte, kam nicht zu ihrem Ende</translation>
    </message>
    <message>
        <source>○ no run yet that this DUT can be calibrated by: a preflight is one, a turn about one axis is none</source>
        <translation>○ noch keine Messung, mit der dieser Prüfling kalibriert werden kann: Ein Preflight ist eine, eine Drehung um eine Achse keine</translation>
    </message>
    <message>
        <source>Open a bench file</source>
        <translation>Messplatzdatei öffnen</translation>
    </message>
    <message>
        <source>being asked</source>
        <translation>wird gefragt</translation>
    </message>
    <message>
        <source>not looked at at rest</source>
        <translation>in Ruhe nicht abgefragt</translation>
    </message>
    <message>
        <source>To look at it opens its port: that resets many a microcontroller, or switches what it sends. Read all asks it who it is.</source>
        <translation>Wer nach ihm sieht, öffnet seinen Port: das setzt manchen Mikrocontroller zurück oder stellt um, was er sendet. Alle lesen fragt ihn, wer er ist.</translation>
    </message>
    <message>
        <source>read again in the next step</source>
        <translation>im nächsten Schritt wieder gelesen</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>und {0} weitere</translation>
    </message>
    <message>
        <source>Being traced: {0}</source>
        <translation>Rest wird erklärt: {0}</translation>
    </message>
    <message>
        <source>Being fitted: {0}</source>
        <translation>Wird gefittet: {0}</translation>
    </message>
    <message>
        <source>The bench that was open stays open: {0}.</source>
        <translation>Der Messplatz, der offen war, bleibt offen: {0}.</translation>
    </message>
    <message>
        <source>Begun on the bench {0}.</source>
        <translation>Begonnen am Messplatz {0}.</translation>
    </message>
    <message>
        <source>▲ Begun on the bench {0}; {1} is open. Open {0} first: with other instruments it does not go on.</source>
        <translation>▲ Begonnen am Messplatz {0}; offen ist {1}. Zuerst {0} öffnen: mit anderen Geräten geht sie nicht weiter.</translation>
    </message>
    <message>
        <source>{0} (simulated)</source>
        <translation>{0} (simuliert)</translation>
    </message>
    <message>
        <source>{0} (served)</source>
        <translation>{0} (bereitgestellt)</translation>
    </message>
    <message>
        <source>{0} (not simulated)</source>
        <translation>{0} (nicht simuliert)</translation>
    </message>
    <message>
        <source>The buttons of the run have just changed: nothing was done. Press again.</source>
        <translation>Die Knöpfe der Messung haben gerade gewechselt: nichts wurde getan. Noch einmal drücken.</translation>
    </message>
    <message>
        <source>gain K {0} by {1}</source>
        <translation>Verstärkung K {0} aus {1}</translation>
    </message>
    <message>
        <source>What a reading along {1} adds to the field along {0}.</source>
        <translation>Was eine Anzeige entlang {1} zum Feld entlang {0} beiträgt.</translation>
    </message>
</context>
<context>
    <name>WorkBar</name>
    <message>
        <source>Something is being computed</source>
        <translation>Es wird gerechnet</translation>
    </message>
</context>
</TS>
