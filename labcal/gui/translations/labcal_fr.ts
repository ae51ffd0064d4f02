<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AnswerForCard</name>
    <message>
        <source>Answer for this run</source>
        <translation>Répondre de cette mesure</translation>
    </message>
    <message>
        <source>It begins though the check standard is out of control. Name and reason stand in its record and in the audit log; with a key they are signed.</source>
        <translation>Elle commence bien que l’étalon de contrôle soit hors de contrôle. Le nom et la raison figurent dans son enregistrement et dans le journal d’audit&#xa0;; avec une clé, ils sont signés.</translation>
    </message>
    <message>
        <source>Who answers for it</source>
        <translation>Qui en répond</translation>
    </message>
    <message>
        <source>The person who lets this run begin</source>
        <translation>La personne qui laisse commencer cette mesure</translation>
    </message>
    <message>
        <source>Why it may begin</source>
        <translation>Pourquoi commencer</translation>
    </message>
    <message>
        <source>What is known of the check standard: it was dropped</source>
        <translation>Ce que l’on sait de l’étalon de contrôle&#xa0;: il est tombé</translation>
    </message>
    <message>
        <source>Whose key signs it</source>
        <translation>Dont la clé signe</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>Phrase de passe</translation>
    </message>
    <message>
        <source>Of this key; asked each time</source>
        <translation>De cette clé&#xa0;; demandée à chaque fois</translation>
    </message>
    <message>
        <source>Let it begin</source>
        <translation>Laisser commencer</translation>
    </message>
    <message>
        <source>Begin this run; it is noted who answered for it</source>
        <translation>Commencer cette mesure&#xa0;; on note qui en répond</translation>
    </message>
    <message>
        <source>no key: not signed</source>
        <translation>pas de clé&#xa0;: non signé</translation>
    </message>
</context>
<context>
    <name>AppState</name>
    <message>
        <source>A run goes on; open another bench after it.</source>
        <translation>Une mesure est en cours&#xa0;; ouvrez un autre banc après elle.</translation>
    </message>
    <message>
        <source>Opening {0} …</source>
        <translation>Ouverture de {0} …</translation>
    </message>
    <message>
        <source>Scanned {0}; a run goes on, its DUT stays.</source>
        <translation>{0} lu&#xa0;; une mesure est en cours, son DUT reste.</translation>
    </message>
    <message>
        <source>Scanned {0}; hands off: scan again once hands may go in.</source>
        <translation>{0} scanné&#xa0;; mains loin&#xa0;: scannez encore dès que les mains peuvent entrer.</translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: {0}</source>
        <translation>✕ Lu, et non retenu&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Scanned {0}: it is the DUT at the top.</source>
        <translation>{0} lu&#xa0;: c&apos;est le DUT indiqué en haut.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>L&apos;ouverture du banc est en cours …</translation>
    </message>
    <message>
        <source>Open a bench first: yours, or the simulated lab.</source>
        <translation>Ouvrez d&apos;abord un banc&#xa0;: le vôtre, ou le laboratoire simulé.</translation>
    </message>
    <message>
        <source>Scan or type the DUT&apos;s serial at the top.</source>
        <translation>Lisez ou tapez en haut le numéro de série du DUT.</translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation>Tapez en haut le nom de l&apos;opérateur.</translation>
    </message>
    <message>
        <source>Answer first whether {0} is the DUT.</source>
        <translation>Répondez d&apos;abord si {0} est le DUT.</translation>
    </message>
    <message>
        <source>your turn</source>
        <translation>à vous</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pause</translation>
    </message>
    <message>
        <source>hands off, measuring</source>
        <translation>mains loin, mesure en cours</translation>
    </message>
</context>
<context>
    <name>ArchivedViewModel</name>
    <message>
        <source>The archive has not answered.</source>
        <translation>L’archive n’a pas répondu.</translation>
    </message>
</context>
<context>
    <name>BenchEditor</name>
    <message>
        <source>Settings of {0}</source>
        <translation>Réglages de {0}</translation>
    </message>
    <message>
        <source>Settings of a bench file</source>
        <translation>Réglages d&apos;un fichier de banc</translation>
    </message>
    <message>
        <source>limits first</source>
        <translation>limites d&apos;abord</translation>
    </message>
    <message>
        <source>Type a value as TOML has it: 2.5, true, [1.0, 2.0], text between quotation marks; an empty one takes the setting away. In brackets: what holds where nothing is stated.</source>
        <translation>Écrire la valeur comme en TOML&#xa0;: 2.5, true, [1.0, 2.0], texte entre guillemets&#xa0;; une valeur vide retire le réglage. Entre crochets&#xa0;: ce qui vaut où rien n&apos;est indiqué.</translation>
    </message>
    <message>
        <source>What would change</source>
        <translation>Ce qui changerait</translation>
    </message>
    <message>
        <source>Show changes</source>
        <translation>Voir les changements</translation>
    </message>
    <message>
        <source>Compare with the file, and check what it says</source>
        <translation>Comparer au fichier, et vérifier ce qu&apos;il dit</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Write these lines into the file; all others stay as they are</source>
        <translation>Écrire ces lignes dans le fichier&#xa0;; toutes les autres restent telles quelles</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>To the instruments; what was not saved is forgotten</source>
        <translation>Aux instruments&#xa0;; ce qui n&apos;a pas été enregistré est oublié</translation>
    </message>
    <message>
        <source>{0} unless stated. {1}</source>
        <translation>{0} sauf indication. {1}</translation>
    </message>
    <message>
        <source>{0} (over several lines: change it in the file)</source>
        <translation>{0} (sur plusieurs lignes&#xa0;: à changer dans le fichier)</translation>
    </message>
    <message>
        <source>{0} changed, not saved</source>
        <translation>{0} changés, non enregistrés</translation>
    </message>
    <message>
        <source>▲ Not a bench file then: {0}</source>
        <translation>▲ Ce ne serait pas un fichier de banc&#xa0;: {0}</translation>
    </message>
    <message>
        <source>✓ A bench file</source>
        <translation>✓ Un fichier de banc</translation>
    </message>
    <message>
        <source>Saved: {0}</source>
        <translation>Enregistré&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The file is as it was.</source>
        <translation>Le fichier est tel qu&apos;il était.</translation>
    </message>
</context>
<context>
    <name>BenchPage</name>
    <message>
        <source>Instruments</source>
        <translation>Instruments</translation>
    </message>
    <message>
        <source>Check all</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Ask every instrument who it is. Nothing is energised or moved.</source>
        <translation>Demander à chaque instrument qui il est. Rien n&apos;est alimenté ni déplacé.</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconnecter</translation>
    </message>
    <message>
        <source>Let go of every link, read the bench file again and ask every instrument who it is</source>
        <translation>Lâcher toutes les liaisons, relire le fichier du banc et demander à chaque instrument qui il est</translation>
    </message>
    <message>
        <source>Open a bench file …</source>
        <translation>Ouvrir un fichier …</translation>
    </message>
    <message>
        <source>A bench file (.toml): what stands in the lab, on which lines</source>
        <translation>Un fichier de banc (.toml)&#xa0;: ce qui se trouve au labo, sur quelles lignes</translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>A whole lab without hardware</source>
        <translation>Un laboratoire entier sans matériel</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Modifier …</translation>
    </message>
    <message>
        <source>Settings of this bench file, limits first</source>
        <translation>Réglages de ce fichier de banc, limites d&apos;abord</translation>
    </message>
    <message>
        <source>New …</source>
        <translation>Nouveau …</translation>
    </message>
    <message>
        <source>Ask who answers on this computer&apos;s lines, and write a draft of a bench file</source>
        <translation>Demander qui répond sur les lignes de cet ordinateur, et écrire une ébauche de fichier de banc</translation>
    </message>
    <message>
        <source>Open a bench file, or take the simulated lab.</source>
        <translation>Ouvrez un fichier de banc, ou prenez le laboratoire simulé.</translation>
    </message>
    <message>
        <source>The cage</source>
        <translation>La cage</translation>
    </message>
    <message>
        <source>A draft of a bench file</source>
        <translation>Ébauche d&apos;un fichier de banc</translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments; check them after it.</source>
        <translation>Une mesure est en cours et tient les instruments&#xa0;; vérifiez-les après.</translation>
    </message>
    <message>
        <source>Asking who answers on this computer&apos;s lines …</source>
        <translation>On demande qui répond sur les lignes de cet ordinateur …</translation>
    </message>
    <message>
        <source>{0} answered: {1}</source>
        <translation>{0} ont répondu&#xa0;: {1}</translation>
    </message>
    <message>
        <source>Asking …</source>
        <translation>Interrogation …</translation>
    </message>
    <message>
        <source>{0} of {1} instruments answered</source>
        <translation>{0} instruments sur {1} ont répondu</translation>
    </message>
    <message>
        <source>All {0} instruments answered</source>
        <translation>Les {0} instruments ont tous répondu</translation>
    </message>
    <message>
        <source>Who answers for it says so on the terminal: labcal bench check {0} --clear-as NAME</source>
        <translation>Qui en répond le dit au terminal&#xa0;: labcal bench check {0} --clear-as NAME</translation>
    </message>
    <message>
        <source>Instruments of {0}</source>
        <translation>Instruments de {0}</translation>
    </message>
    <message>
        <source>A run goes on and holds the instruments: after it.</source>
        <translation>Une mesure est en cours et tient les appareils&#xa0;: après elle.</translation>
    </message>
    <message>
        <source>{0}, simulated: whichever DUT is typed</source>
        <translation>{0}, simulé&#xa0;: quel que soit le DUT saisi</translation>
    </message>
    <message>
        <source>all arrows to one scale</source>
        <translation>toutes les flèches à la même échelle</translation>
    </message>
    <message>
        <source>as read last, not now; all arrows to one scale</source>
        <translation>comme lu en dernier, pas maintenant&#xa0;; toutes les flèches à la même échelle</translation>
    </message>
    <message>
        <source>applied</source>
        <translation>appliqué</translation>
    </message>
    <message>
        <source>ambient</source>
        <translation>ambiant</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>&lt;br&gt;{0} here, outdoors: {1} ± {2} nT</source>
        <translation>&lt;br&gt;{0} ici, dehors&#xa0;: {1} ± {2} nT</translation>
    </message>
    <message>
        <source>&lt;br&gt;&lt;br&gt;at most {0} A a coil&lt;br&gt;at most {1} nT</source>
        <translation>&lt;br&gt;&lt;br&gt;au plus {0} A par bobine&lt;br&gt;au plus {1} nT</translation>
    </message>
</context>
<context>
    <name>CageView</name>
    <message>
        <source>The cage with its field vectors</source>
        <translation>La cage et ses vecteurs de champ</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys, to look from another side</source>
        <translation>Glissez, ou touches fléchées, pour regarder d&apos;un autre côté</translation>
    </message>
</context>
<context>
    <name>CalibrationViews</name>
    <message>
        <source>What of the calibration is shown</source>
        <translation>Ce qui est montré de l&apos;étalonnage</translation>
    </message>
    <message>
        <source>As found, as left</source>
        <translation>Avant, après</translation>
    </message>
    <message>
        <source>In short</source>
        <translation>En bref</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Transformation</translation>
    </message>
    <message>
        <source>Causes</source>
        <translation>Causes</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Incertitude</translation>
    </message>
    <message>
        <source>No specification was stated for this run.</source>
        <translation>Aucune spécification n&apos;était indiquée pour cette mesure.</translation>
    </message>
    <message>
        <source>This DUT has no earlier calibration.</source>
        <translation>Ce DUT n&apos;a pas d&apos;étalonnage antérieur.</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>No camera: OpenCV is not installed (pip install &apos;labcal[camera]&apos;).</source>
        <translation>Pas de caméra&#xa0;: OpenCV n&apos;est pas installé (pip install &apos;labcal[camera]&apos;).</translation>
    </message>
    <message>
        <source>No camera answers at {0}.</source>
        <translation>Aucune caméra ne répond à {0}.</translation>
    </message>
    <message>
        <source>The camera {0} gives no picture any more.</source>
        <translation>La caméra {0} ne donne plus d&apos;image.</translation>
    </message>
    <message>
        <source>The camera has given no picture yet …</source>
        <translation>La caméra n&apos;a pas encore donné d&apos;image …</translation>
    </message>
    <message>
        <source>The camera has given no picture for {0:.0f} s.</source>
        <translation>La caméra n&apos;a donné aucune image depuis {0:.0f} s.</translation>
    </message>
    <message>
        <source>Picture of the camera: the DUT as it stands now</source>
        <translation>Image de la caméra&#xa0;: le DUT tel qu&apos;il se trouve maintenant</translation>
    </message>
</context>
<context>
    <name>CausesTable</name>
    <message>
        <source>Off the held-out rms beside declared errors, by it alone; –: not worked out</source>
        <translation>Du rms mis de côté, à part les erreurs déclarées, par elle seule&#xa0;; –&#xa0;: non calculé</translation>
    </message>
    <message>
        <source>Whether it is enough for a name; –: it is for another reason that it is not named</source>
        <translation>Si cela suffit pour la nommer&#xa0;; –&#xa0;: c&apos;est pour une autre raison qu&apos;elle ne l&apos;est pas</translation>
    </message>
    <message>
        <source>What files and commands call it</source>
        <translation>Le nom qu&apos;il a dans les fichiers et les commandes</translation>
    </message>
    <message>
        <source>Candidates; choose one to see what it alone would change</source>
        <translation>Candidats&#xa0;; choisissez-en un pour voir ce qu&apos;il changerait seul</translation>
    </message>
</context>
<context>
    <name>CertificatePage</name>
    <message>
        <source>Calibrations, the newest first</source>
        <translation>Étalonnages, le plus récent d&apos;abord</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Choisir un étalonnage</translation>
    </message>
    <message>
        <source>± U (k=2) is of the parameter in its line alone. That of a component of the field, its mounting included, is under Uncertainty; rms on the Fit and Loop pages is standard (k=1).</source>
        <translation>± U (k=2) est celle du seul paramètre de la ligne. Celle d&apos;une composante du champ, montage compris, est sous Incertitude&#xa0;; le rms des pages Ajuster et Causes est type (k=1).</translation>
    </message>
    <message>
        <source>Choose a calibration, or say at the top which DUT.</source>
        <translation>Choisissez un étalonnage, ou indiquez en haut quel DUT.</translation>
    </message>
    <message>
        <source>The signed file is {0}, in the folder {1}</source>
        <translation>Le fichier signé est {0}, dans le dossier {1}</translation>
    </message>
    <message>
        <source>Operator {0}.</source>
        <translation>Opérateur {0}.</translation>
    </message>
    <message>
        <source>{0} is handed out.</source>
        <translation>{0} est remis.</translation>
    </message>
    <message>
        <source>Its signatures are files beside it, {0}.sshsig: copy them into its folder, and verify it again.</source>
        <translation>Ses signatures sont des fichiers à côté, {0}.sshsig&#xa0;: les copier dans le même dossier et vérifier à nouveau.</translation>
    </message>
    <message>
        <source>checked at {0}</source>
        <translation>vérifié à {0}</translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation>U&#xa0;: k=2</translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation>La page où cela se fait</translation>
    </message>
    <message>
        <source>No calibration of {0} yet: a fit, and the trace of what it leaves, write a draft.</source>
        <translation>Pas encore d’étalonnage de {0}&#xa0;: un ajustement et l’explication de son résidu écrivent un projet.</translation>
    </message>
    <message>
        <source>nobody yet</source>
        <translation>personne encore</translation>
    </message>
    <message>
        <source>Operator {0}; approved by {1}.</source>
        <translation>Opérateur {0}&#xa0;; approuvé par {1}.</translation>
    </message>
</context>
<context>
    <name>Choose</name>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Usual settings</source>
        <translation>Réglages habituels</translation>
    </message>
    <message>
        <source>Every setting as it was before anybody typed</source>
        <translation>Chaque réglage comme il était avant toute saisie</translation>
    </message>
    <message>
        <source>The plan</source>
        <translation>Le plan</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
    </message>
    <message>
        <source>How fast simulated time passes: as in the lab, faster, or as fast as the computer goes</source>
        <translation>Vitesse du temps simulé&#xa0;: comme au laboratoire, plus vite, ou aussi vite que l&apos;ordinateur</translation>
    </message>
    <message>
        <source>Asks every instrument who it is, then begins. Nothing is energised before you are asked.</source>
        <translation>Demande à chaque instrument qui il est, puis commence. Rien n&apos;est alimenté avant qu&apos;on vous le demande.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Rehearse this on the simulated lab: field, rate, angles, temperature, time, and what you are asked</source>
        <translation>Répéter sur le laboratoire simulé&#xa0;: champ, vitesse, angles, température, durée, et ce qu&apos;on vous demande</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>End the rehearsal; nothing was begun</source>
        <translation>Arrêter la répétition&#xa0;; rien n&apos;a commencé</translation>
    </message>
    <message>
        <source>▲ Unfinished run</source>
        <translation>▲ Mesure inachevée</translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation>Ce qui y manque&#xa0;; on vous demande si le montage est encore en place</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Continuer {0}</translation>
    </message>
    <message>
        <source>Rehearsing on the simulated lab …</source>
        <translation>Répétition sur le laboratoire simulé …</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>abandonné</translation>
    </message>
    <message>
        <source>What this measures is added to run {0}; then the cause is decided again, by itself.</source>
        <translation>Ce que cela mesure s&apos;ajoute à la mesure {0}&#xa0;; puis la cause est de nouveau décidée, d&apos;elle-même.</translation>
    </message>
    <message>
        <source>Its settings are those that tell most there; the next run has the usual ones again.</source>
        <translation>Les réglages sont ceux qui en disent le plus&#xa0;; la mesure suivante a de nouveau les habituels.</translation>
    </message>
    <message>
        <source>Correct what is red at the top.</source>
        <translation>Corrigez ce qui est rouge en haut.</translation>
    </message>
    <message>
        <source>Correct what is red at the top, and what is marked ✕ above.</source>
        <translation>Corrigez ce qui est rouge en haut, et ce qui est marqué ✕ ci-dessus.</translation>
    </message>
    <message>
        <source>A setting is not accepted: see above.</source>
        <translation>Un réglage n&apos;est pas accepté&#xa0;: voir plus haut.</translation>
    </message>
    <message>
        <source>It cannot be begun as it is set: the plan says why.</source>
        <translation>Ainsi réglé, cela ne peut commencer&#xa0;: le plan dit pourquoi.</translation>
    </message>
    <message>
        <source>the plan</source>
        <translation>le plan</translation>
    </message>
</context>
<context>
    <name>Client</name>
    <message>
        <source>The work was ended by this window.</source>
        <translation>Le travail a été arrêté par cette fenêtre.</translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation>Le travail a dit ce que cette fenêtre ne peut lire, et elle l&apos;a arrêté.</translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation>Le travail s&apos;est arrêté de lui-même (code {0}).</translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation>Le travail s&apos;est planté (code {0}).</translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation>Le travail a été tué (signal {0}).</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Le processus de travail n&apos;a pas pu démarrer.</translation>
    </message>
</context>
<context>
    <name>CloseAtRest</name>
    <message>
        <source>Close the window?</source>
        <translation>Fermer la fenêtre&#xa0;?</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Rester</translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation>Ne rien fermer (Échap)</translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation>Fermer quand même</translation>
    </message>
    <message>
        <source>The lab is left as it is said here</source>
        <translation>Le labo reste dans l&apos;état décrit ici</translation>
    </message>
    <message>
        <source>With the window closed the guardian keeps trying to bring every coil to zero; nobody sees whether it does.</source>
        <translation>La fenêtre fermée, le gardien essaie encore de ramener chaque bobine à zéro&#xa0;; personne ne voit s&apos;il y parvient.</translation>
    </message>
    <message>
        <source>No guardian holds the supplies: COILS OFF is given once more on closing; nobody sees what becomes of it.</source>
        <translation>Aucun gardien ne tient les alimentations&#xa0;: BOBINES À ZÉRO est redonné à la fermeture&#xa0;; personne n&apos;en voit l&apos;effet.</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>A run goes on</source>
        <translation>Une mesure est en cours</translation>
    </message>
    <message>
        <source>A run goes on: {0}</source>
        <translation>Une mesure est en cours&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What was measured is kept; this procedure cannot be gone on with.</source>
        <translation>Les bobines vont à zéro, la fenêtre se ferme. Ce qui a été mesuré est gardé&#xa0;; cette procédure ne peut pas être reprise.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>The coils go to zero, the window closes. What is missing is measured later: Go on, on the Start page.</source>
        <translation>Les bobines vont à zéro, la fenêtre se ferme. Ce qui manque est mesuré plus tard&#xa0;: Continuer, à la page d&apos;accueil.</translation>
    </message>
    <message>
        <source>Keep running behind</source>
        <translation>Continuer en arrière-plan</translation>
    </message>
    <message>
        <source>The window goes out of sight, and comes back when you are needed or the run has ended.</source>
        <translation>La fenêtre disparaît, et revient quand on a besoin de vous ou que la mesure est finie.</translation>
    </message>
    <message>
        <source>Back to the run</source>
        <translation>Retour à la mesure</translation>
    </message>
    <message>
        <source>Close nothing (Esc)</source>
        <translation>Ne rien fermer (Échap)</translation>
    </message>
</context>
<context>
    <name>CoilsOff</name>
    <message>
        <source>Coils off: no bench is open, this window drives no coil.</source>
        <translation>Bobines à zéro&#xa0;: aucun banc n&apos;est ouvert, cette fenêtre ne pilote aucune bobine.</translation>
    </message>
    <message>
        <source>Coils off: reading them back …</source>
        <translation>Bobines à zéro&#xa0;: relecture …</translation>
    </message>
    <message>
        <source>Checking the zero: coils to zero, then what the reference sees …</source>
        <translation>Le zéro est vérifié&#xa0;: bobines à zéro, puis ce que voit la référence …</translation>
    </message>
    <message>
        <source>Nobody has seen it stand yet: its line may be silent, or kept by another program.</source>
        <translation>Personne ne l’a encore vue arrêtée&#xa0;: sa ligne est peut-être muette, ou gardée par un autre programme.</translation>
    </message>
    <message>
        <source>Press COILS OFF (F12): it stops the platform as well. Hands off until you see it stand.</source>
        <translation>Appuyez sur BOBINES À ZÉRO (F12)&#xa0;: la plate-forme s’arrête aussi. Mains loin jusqu’à ce que vous la voyiez arrêtée.</translation>
    </message>
    <message>
        <source>COILS OFF does not reach it: stop it at its controller. Hands off until you see it stand.</source>
        <translation>BOBINES À ZÉRO ne l’atteint pas&#xa0;: arrêtez-la à son contrôleur. Mains loin jusqu’à ce que vous la voyiez arrêtée.</translation>
    </message>
    <message>
        <source>The platform kept turning: COILS OFF is given anew, and stops it …</source>
        <translation>La plate-forme tournait encore&#xa0;: BOBINES À ZÉRO est donné de nouveau, et l’arrête …</translation>
    </message>
    <message>
        <source>No answer yet from: {0}</source>
        <translation>Pas encore de réponse de&#xa0;: {0}</translation>
    </message>
    <message>
        <source>By hand: at its panel, or at its mains switch.</source>
        <translation>À la main&#xa0;: à son panneau, ou à son interrupteur secteur.</translation>
    </message>
</context>
<context>
    <name>ComparisonView</name>
    <message>
        <source>Runs without a calibration are fitted now.</source>
        <translation>Les mesures sans étalonnage sont ajustées maintenant.</translation>
    </message>
    <message>
        <source>{0}: two runs compared</source>
        <translation>{0}&#xa0;: deux mesures comparées</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>run {0}, calibration {1}</source>
        <translation>mesure {0}, étalonnage {1}</translation>
    </message>
    <message>
        <source>run {0}, fitted now (it has no calibration)</source>
        <translation>mesure {0}, ajustée maintenant (elle n&apos;a pas d&apos;étalonnage)</translation>
    </message>
    <message>
        <source>Two runs compared</source>
        <translation>Deux mesures comparées</translation>
    </message>
    <message>
        <source>U: k=2</source>
        <translation>U&#xa0;: k=2</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>To the list of runs</source>
        <translation>À la liste des mesures</translation>
    </message>
    <message>
        <source>What of the two runs is drawn over each other</source>
        <translation>Ce qui des deux mesures est tracé l&apos;un sur l&apos;autre</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Residuals of the magnitude</source>
        <translation>Résidus du module</translation>
    </message>
    <message>
        <source>Loci on the sphere, calibrated</source>
        <translation>Lieux sur la sphère, étalonnés</translation>
    </message>
    <message>
        <source>What the residuals are drawn against</source>
        <translation>En fonction de quoi les résidus sont tracés</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>En fonction de</translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation>résidu de |b|  nT</translation>
    </message>
    <message>
        <source>band: the larger noise that the two fits make of their own residuals, k=2; none is stated</source>
        <translation>bande&#xa0;: le plus grand bruit que les deux ajustements tirent de leur propre résidu, k=2&#xa0;; aucun n&apos;est indiqué</translation>
    </message>
    <message>
        <source>band: the larger of the two runs&apos; stated noises of |b|, k=2, as on the Fit page</source>
        <translation>bande&#xa0;: le plus grand des bruits de |b| indiqués par les deux mesures, k=2, comme à la page Ajuster</translation>
    </message>
    <message>
        <source>no reference, no residual</source>
        <translation>sans référence, pas de résidu</translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation>moyenne {0} nT, rms {1} nT</translation>
    </message>
    <message>
        <source>faint: behind the sphere</source>
        <translation>pâle&#xa0;: derrière la sphère</translation>
    </message>
</context>
<context>
    <name>CoveredBar</name>
    <message>
        <source>How much of the circle the turn about this axis has seen, in sectors of 15°</source>
        <translation>Part du cercle vue par le tour autour de cet axe, en secteurs de 15°</translation>
    </message>
    <message>
        <source>{0}, this turn: {1} % of the circle</source>
        <translation>{0}, ce tour&#xa0;: {1} % du cercle</translation>
    </message>
    <message>
        <source>{0}: {1} % of the circle</source>
        <translation>{0}&#xa0;: {1} % du cercle</translation>
    </message>
</context>
<context>
    <name>Data</name>
    <message>
        <source>coils at zero</source>
        <translation>bobines à zéro</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero; {0}</source>
        <translation>zéro des bobines NON confirmé&#xa0;; {0}</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero</source>
        <translation>zéro des bobines NON confirmé</translation>
    </message>
    <message>
        <source>NOT at zero by the reference: {0}. {1}</source>
        <translation>PAS à zéro selon la référence&#xa0;: {0}. {1}</translation>
    </message>
    <message>
        <source>NOT at zero by the reference</source>
        <translation>PAS à zéro selon la référence</translation>
    </message>
    <message>
        <source>coils not read back in this session</source>
        <translation>bobines non relues dans cette session</translation>
    </message>
    <message>
        <source>coils on: {0}</source>
        <translation>bobines sous courant&#xa0;: {0}</translation>
    </message>
    <message>
        <source>coils on: {0}, read back {1}</source>
        <translation>bobines sous courant&#xa0;: {0}, relu {1}</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill</source>
        <translation>arrêt de la plate-forme NON confirmé</translation>
    </message>
    <message>
        <source>platform turns, at {0}°</source>
        <translation>la plate-forme tourne, à {0}°</translation>
    </message>
    <message>
        <source>platform stands at {0}°</source>
        <translation>la plate-forme est arrêtée à {0}°</translation>
    </message>
    <message>
        <source>platform stands at {0}°, read {1}</source>
        <translation>la plate-forme est arrêtée à {0}°, lue {1}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}; not watched since</source>
        <translation>bobines confirmées à zéro {0}&#xa0;; non surveillées depuis</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}; not watched since</source>
        <translation>bobines relues à zéro d&apos;après les alimentations {0}&#xa0;; non surveillées depuis</translation>
    </message>
    <message>
        <source>the reference has no ambient field to compare with yet</source>
        <translation>la référence n&apos;a pas encore de champ ambiant à comparer</translation>
    </message>
    <message>
        <source>Still lost: {0}. Put that right first: a step begun now fails again.</source>
        <translation>Toujours perdu&#xa0;: {0}. Réparez d&apos;abord&#xa0;: une étape commencée maintenant échoue encore.</translation>
    </message>
    <message>
        <source>taking the coils to zero: ordered, not read back yet …</source>
        <translation>Les bobines vont à zéro&#xa0;: ordonné, pas encore relu …</translation>
    </message>
    <message>
        <source>coils NOT confirmed at zero: {0}</source>
        <translation>bobines NON confirmées à zéro&#xa0;: {0}</translation>
    </message>
    <message>
        <source>coils read back at zero by their supplies</source>
        <translation>bobines relues à zéro par leurs alimentations</translation>
    </message>
    <message>
        <source>coils may be on: a run goes on, and nothing was read yet</source>
        <translation>bobines peut-être alimentées&#xa0;: une mesure est en cours, et rien n’a encore été lu</translation>
    </message>
    <message>
        <source>coils may be on</source>
        <translation>bobines peut-être alimentées</translation>
    </message>
    <message>
        <source>coils not read back since they were ordered off</source>
        <translation>bobines non relues depuis l’ordre de les couper</translation>
    </message>
    <message>
        <source>coils on</source>
        <translation>bobines alimentées</translation>
    </message>
    <message>
        <source>platform turns</source>
        <translation>la plate-forme tourne</translation>
    </message>
    <message>
        <source>platform turns, at {0}°, read {1}</source>
        <translation>la plate-forme tourne, à {0}°, lu {1}</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned</source>
        <translation>arrêt de la plate-forme NON confirmé&#xa0;: à {0}° elle tournait</translation>
    </message>
    <message>
        <source>platform NOT confirmed at a standstill: at {0}° it turned, {1}</source>
        <translation>arrêt de la plate-forme NON confirmé&#xa0;: à {0}° elle tournait, {1}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}</source>
        <translation>bobines confirmées à zéro {0}</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}</source>
        <translation>bobines relues à zéro d&apos;après les alimentations {0}</translation>
    </message>
    <message>
        <source>coils confirmed at zero {0}, silent since</source>
        <translation>bobines confirmées à zéro {0}, muettes depuis</translation>
    </message>
    <message>
        <source>coils read back at zero by the supply&apos;s word {0}, silent since</source>
        <translation>bobines relues à zéro d&apos;après les alimentations {0}, muettes depuis</translation>
    </message>
    <message>
        <source>waiting for a guardian that takes the order of zero …</source>
        <translation>En attente d&apos;un gardien qui prenne l&apos;ordre de mise à zéro …</translation>
    </message>
    <message>
        <source>of a simulated lab the reference is not read at rest</source>
        <translation>la référence d’un laboratoire simulé n’est pas lue au repos</translation>
    </message>
    <message>
        <source>the reference does not answer</source>
        <translation>la référence ne répond pas</translation>
    </message>
    <message>
        <source>the reference&apos;s ambient field is from before hands were at the DUT</source>
        <translation>le champ ambiant de la référence date d&apos;avant la dernière intervention sur le DUT</translation>
    </message>
    <message>
        <source>the reference was moved since its ambient field was measured</source>
        <translation>la référence a été déplacée depuis la mesure de son champ ambiant</translation>
    </message>
    <message>
        <source>coils at zero, by their supplies and by the field</source>
        <translation>bobines à zéro, selon leurs alimentations et selon le champ</translation>
    </message>
    <message>
        <source>the reference sees more change than a mounting makes</source>
        <translation>la référence voit un changement plus grand que celui d’un montage</translation>
    </message>
    <message>
        <source>the reference has sent nothing since the currents settled</source>
        <translation>la référence n&apos;a rien envoyé depuis que les courants sont stables</translation>
    </message>
    <message>
        <source>the reference is not streaming</source>
        <translation>la référence n&apos;envoie rien</translation>
    </message>
    <message>
        <source>the reference is at its full scale and cannot vouch for it</source>
        <translation>la référence est en bout d&apos;échelle et ne peut en répondre</translation>
    </message>
    <message>
        <source>the link to the reference is lost</source>
        <translation>la liaison avec la référence est perdue</translation>
    </message>
    <message>
        <source>the reference repeats one reading</source>
        <translation>la référence répète une même lecture</translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}, {1} s ago</source>
        <translation>la référence est examinée de nouveau&#xa0;: {0}, il y a {1} s</translation>
    </message>
    <message>
        <source>the reference is looked at again: {0}</source>
        <translation>la référence est examinée de nouveau&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the reference agreed when it was last looked at, {0}</source>
        <translation>la référence concordait au dernier examen, {0}</translation>
    </message>
    <message>
        <source>it sees {0} nT, {1} nT expected: {2} µT apart, {3} µT allowed</source>
        <translation>elle voit {0} nT, attendu {1} nT&#xa0;: écart {2} µT, permis {3} µT</translation>
    </message>
    <message>
        <source>{0} UTC, {1}</source>
        <translation>{0} UTC, {1}</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: open the output of {2} at its panel, or switch it off at its mains</source>
        <translation>C&apos;est comme si {0} A passaient dans la bobine {1}&#xa0;: ouvrir la sortie de {2} sur l&apos;appareil, ou le couper au secteur</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: switch off {2} at its mains (no command opens its output)</source>
        <translation>C&apos;est comme si {0} A passaient dans la bobine {1}&#xa0;: couper {2} au secteur (aucune commande n&apos;ouvre sa sortie)</translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation>il y a {0} s</translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation>il y a {0} min</translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation>il y a {0} h</translation>
    </message>
    <message>
        <source>at {0} ({1})</source>
        <translation>à {0} ({1})</translation>
    </message>
    <message>
        <source>Open the outputs that can open, or switch the supplies off at their mains</source>
        <translation>Ouvrir les sorties qui peuvent s&apos;ouvrir, ou couper les alimentations au secteur</translation>
    </message>
    <message>
        <source>Mount the DUT with body {0} up along the platform axis, body {1} towards the cage&apos;s {2}, at platform angle 0.</source>
        <translation>Monter le DUT axe {0} du corps vers le haut le long de l&apos;axe du plateau, axe {1} du corps vers le {2} de la cage, plateau à l&apos;angle 0.</translation>
    </message>
    <message>
        <source>Scan the serial of the DUT as it is mounted now: this run is of {0}.</source>
        <translation>Lisez le numéro de série du DUT tel qu&apos;il est monté maintenant&#xa0;: cette mesure porte sur {0}.</translation>
    </message>
    <message>
        <source>{0}: that is not the DUT of this run. Mount {1}, then scan its serial again.</source>
        <translation>{0}&#xa0;: ce n&apos;est pas le DUT de cette mesure. Montez {1}, puis lisez de nouveau son numéro de série.</translation>
    </message>
    <message>
        <source>Mount the DUT with body Z up, body X towards the cage&apos;s X; then {0}.</source>
        <translation>Monter le DUT axe Z du corps vers le haut, axe X du corps vers le X de la cage&#xa0;; puis {0}.</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>as it always stands</source>
        <translation>comme elle est toujours</translation>
    </message>
    <message>
        <source>turned by 180° about its own {0}</source>
        <translation>tournée de 180° autour de son propre {0}</translation>
    </message>
    <message>
        <source>turned by 180° about its {0}</source>
        <translation>tourné de 180° autour de son {0}</translation>
    </message>
    <message>
        <source>Why is axis {0} redone? What was measured stays in the record, marked as not used.</source>
        <translation>Pourquoi refaire l&apos;axe {0}&#xa0;? Ce qui a été mesuré reste dans l&apos;enregistrement, marqué non utilisé.</translation>
    </message>
    <message>
        <source>Why is {0} skipped?</source>
        <translation>Pourquoi sauter {0}&#xa0;?</translation>
    </message>
    <message>
        <source>the disk is slow: rows wait {0} s in memory</source>
        <translation>le disque est lent&#xa0;: des lignes attendent {0} s en mémoire</translation>
    </message>
    <message>
        <source>the disk takes what is recorded again</source>
        <translation>le disque reprend ce qui est enregistré</translation>
    </message>
    <message>
        <source>{0}: body {1} is up, not {2}. Mount it again: this turn says nothing of {2}.</source>
        <translation>{0}&#xa0;: l&apos;axe {1} du corps est en haut, pas {2}. Remontez-le&#xa0;: ce tour ne dit rien de {2}.</translation>
    </message>
    <message>
        <source>Switch the DUT to power mode {0}.</source>
        <translation>Mettre le DUT dans le mode d&apos;alimentation {0}.</translation>
    </message>
    <message>
        <source>Switch the load {0} on.</source>
        <translation>Allumer la charge {0}.</translation>
    </message>
    <message>
        <source>Switch the load {0} off.</source>
        <translation>Couper la charge {0}.</translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor off at its plug.</source>
        <translation>Couper le moteur du plateau à sa prise.</translation>
    </message>
    <message>
        <source>Switch the platform&apos;s motor on again.</source>
        <translation>Rallumer le moteur du plateau.</translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort). No faster than {1} deg/s.</source>
        <translation>Tourner le plate-forme à {0}° de son cadran, mains loin, et entrer ce qu&apos;il indique (ou&#xa0;: abort). Pas plus vite que {1} deg/s.</translation>
    </message>
    <message>
        <source>Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort).</source>
        <translation>Tourner le plate-forme à {0}° de son cadran, mains loin, et entrer ce qu&apos;il indique (ou&#xa0;: abort).</translation>
    </message>
    <message>
        <source>Warm the DUT within its limits, then let it cool.</source>
        <translation>Chauffer le DUT dans ses limites, puis le laisser refroidir.</translation>
    </message>
    <message>
        <source>Take the DUT off the platform, some metres away. Leave the reference and all else as it is.</source>
        <translation>Retirer le DUT du plateau, à quelques mètres. Laisser la référence et tout le reste en place.</translation>
    </message>
    <message>
        <source>Take the DUT away and put the reference at its place, on a stand that does not turn.</source>
        <translation>Retirer le DUT et mettre la référence à sa place, sur un support qui ne tourne pas.</translation>
    </message>
    <message>
        <source>Put the reference at the {0}&apos;s place: {1} mm from the DUT&apos;s place, in C.</source>
        <translation>Mettre la référence à la place de {0}&#xa0;: {1} mm de la place du DUT, en C.</translation>
    </message>
    <message>
        <source>Put the reference at {0} mm from the DUT&apos;s place, in C, turned as it always stands.</source>
        <translation>Mettre la référence à {0} mm de la place du DUT, en C, orientée comme toujours.</translation>
    </message>
    <message>
        <source>Put the reference {0} mm above the DUT&apos;s place, on the platform axis.</source>
        <translation>Mettre la référence {0} mm au-dessus de la place du DUT, sur l&apos;axe du plateau.</translation>
    </message>
    <message>
        <source>Put the reference {0}.</source>
        <translation>Mettre la référence ainsi&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Put the scalar sensor into the cage&apos;s centre, its dead zones away from the fields.</source>
        <translation>Mettre le capteur scalaire au centre de la cage, ses zones mortes hors des champs.</translation>
    </message>
    <message>
        <source>Swap the two leads of the half of coil {0} that stands towards +{1}. They must come back before anything else is measured, also if this run is stopped.</source>
        <translation>Échanger les deux fils de la moitié de la bobine {0} qui est vers +{1}. Ils doivent être remis avant toute autre mesure, même si celle-ci est arrêtée.</translation>
    </message>
    <message>
        <source>Put the two leads of the half of coil {0} that stands towards +{1} back as they were.</source>
        <translation>Remettre les deux fils de la moitié de la bobine {0} qui est vers +{1} comme ils étaient.</translation>
    </message>
    <message>
        <source>Are all covers of the DUT as they will fly, and the others off?</source>
        <translation>Tous les capots du DUT sont-ils comme en vol, et les autres retirés&#xa0;?</translation>
    </message>
    <message>
        <source>Are the batteries those that will fly, and connected?</source>
        <translation>Les batteries sont-elles celles du vol, et branchées&#xa0;?</translation>
    </message>
    <message>
        <source>Are all tools out of the cage?</source>
        <translation>Tous les outils sont-ils hors de la cage&#xa0;?</translation>
    </message>
    <message>
        <source>Are phones, keys and watches out of the room?</source>
        <translation>Téléphones, clés et montres sont-ils hors de la pièce&#xa0;?</translation>
    </message>
    <message>
        <source>Do chairs and trolleys stand at their marks?</source>
        <translation>Chaises et chariots sont-ils sur leurs marques&#xa0;?</translation>
    </message>
    <message>
        <source>There is no file {0}. File of the photograph ({1}), or empty:</source>
        <translation>Il n&apos;y a pas de fichier {0}. Fichier de la photo ({1}), ou vide&#xa0;:</translation>
    </message>
    <message>
        <source>File of the photograph ({0}), or empty:</source>
        <translation>Fichier de la photo ({0}), ou vide&#xa0;:</translation>
    </message>
    <message>
        <source>The coils go up to {0} µT, then the field rotates. Hands off?</source>
        <translation>Les bobines vont jusqu’à {0} µT, puis le champ tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played as {1} wants them. Hands off?</source>
        <translation>Des champs jusqu’à {0} µT sont joués comme {1} les veut. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT in all directions. Hands off?</source>
        <translation>Le champ va à {0} µT dans toutes les directions. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT in six directions. Hands off?</source>
        <translation>Le champ va à {0} µT dans six directions. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT. Hands off?</source>
        <translation>Le champ va à {0} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn. Hands off?</source>
        <translation>Le champ va à {0} µT, et le plateau peut tourner. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The platform turns to {0}°. Hands off?</source>
        <translation>La plate-forme tourne à {0}°. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°. Hands off?</source>
        <translation>Ensuite le plateau cherche son zéro et tourne à {0}°. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT.</source>
        <translation>Les bobines vont à {0} µT.</translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn.</source>
        <translation>Les bobines vont à {0} µT, et la plateforme peut tourner.</translation>
    </message>
    <message>
        <source>Next the platform looks for its zero and turns to {0}°.</source>
        <translation>Ensuite le plateau cherche son zéro et tourne à {0}°.</translation>
    </message>
    <message>
        <source>The field goes to {0} µT.</source>
        <translation>Le champ passe à {0} µT.</translation>
    </message>
    <message>
        <source>no reference has confirmed it</source>
        <translation>aucune référence ne l’a confirmé</translation>
    </message>
    <message>
        <source>Is the DUT still mounted with body {0} up, exactly as it was before the interruption?</source>
        <translation>Le DUT est-il encore monté axe {0} du corps vers le haut, exactement comme avant l&apos;interruption&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT as the DUT warms and cools. Hands off?</source>
        <translation>Le champ va à {0} µT pendant que le DUT chauffe et refroidit. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT. Hands off?</source>
        <translation>Les bobines vont à {0} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT, and the platform may turn. Hands off?</source>
        <translation>Les bobines vont à {0} µT, et la plateforme peut tourner. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, and the platform may turn.</source>
        <translation>Le champ passe à {0} µT, et la plateforme peut tourner.</translation>
    </message>
    <message>
        <source>The platform turns to {0}°.</source>
        <translation>La plateforme tourne à {0}°.</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, the platform turns. Hands off?</source>
        <translation>Le champ va à {0} µT, le plateau tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT and stays. Hands off?</source>
        <translation>Le champ va à {0} µT et y reste. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field goes to {0} µT, later with the DUT turning in it. Hands off?</source>
        <translation>Le champ va à {0} µT, plus tard le DUT y tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The field steps up to {0} µT. Hands off?</source>
        <translation>Le champ monte par paliers à {0} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils go to {0} µT and the platform turns. Hands off?</source>
        <translation>Les bobines vont à {0} µT et le plateau tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils go up to {0} µT and the platform turns. Hands off?</source>
        <translation>Les bobines vont jusqu’à {0} µT et la plateforme tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>The coils step by {0} µT and the platform turns. Hands off?</source>
        <translation>Les bobines font des pas de {0} µT et le plateau tourne. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>A square wave of {0} µT follows. Hands off?</source>
        <translation>Un signal carré de {0} µT suit. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT in turn. Hands off?</source>
        <translation>Chaque bobine va tour à tour à {0} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Each coil goes to {0} µT. Hands off?</source>
        <translation>Chaque bobine va à {0} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Each coil alternates from {0} µT downwards. Hands off?</source>
        <translation>Chaque bobine alterne à partir de {0} µT vers le bas. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Coil {0} makes a gradient now, with the current of {1} µT. Hands off?</source>
        <translation>La bobine {0} fait maintenant un gradient, avec le courant qui fait sinon {1} µT. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Fields up to {0} µT are played. Hands off?</source>
        <translation>Des champs jusqu&apos;à {0} µT sont joués. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>Every load is switched in turn, the others stay off. Hands off?</source>
        <translation>Chaque charge est commutée tour à tour, les autres restent coupées. Mains loin&#xa0;?</translation>
    </message>
    <message>
        <source>{0} of {1} figures changed by more than their uncertainty; the largest is E_n = {2} ({3}).</source>
        <translation>{0} grandeurs sur {1} ont changé de plus que leur incertitude&#xa0;; la plus forte est E_n = {2} ({3}).</translation>
    </message>
    <message>
        <source>No figure changed by more than its uncertainty; the largest is E_n = {0} ({1}).</source>
        <translation>Aucune grandeur n&apos;a changé de plus que son incertitude&#xa0;; la plus forte est E_n = {0} ({1}).</translation>
    </message>
    <message>
        <source>Whether the sensor changed cannot be said: a calibration states no uncertainty.</source>
        <translation>On ne peut dire si le capteur a changé&#xa0;: un étalonnage n&apos;indique pas d&apos;incertitude.</translation>
    </message>
    <message>
        <source>Offsets are not of the same state: as found {0}, as left {1}.</source>
        <translation>Les décalages ne sont pas du même état&#xa0;: trouvé {0}, laissé {1}.</translation>
    </message>
    <message>
        <source>Offsets are those at {0}.</source>
        <translation>Les décalages sont ceux à {0}.</translation>
    </message>
    <message>
        <source>at any state</source>
        <translation>à tout état</translation>
    </message>
    <message>
        <source>One of the two is simulated.</source>
        <translation>L&apos;un des deux est simulé.</translation>
    </message>
    <message>
        <source>Only the earlier corrects {0}.</source>
        <translation>Seul l&apos;ancien corrige {0}.</translation>
    </message>
    <message>
        <source>Only the later corrects {0}.</source>
        <translation>Seul le nouveau corrige {0}.</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number of this bench: they match {1} (dut.serial_pattern)</source>
        <translation>«&#xa0;{0}&#xa0;» n&apos;est pas un numéro de série de ce banc&#xa0;: ils suivent {1} (dut.serial_pattern)</translation>
    </message>
    <message>
        <source>{0}: a label ends in {1}</source>
        <translation>{0}&#xa0;: une étiquette se termine par {1}</translation>
    </message>
    <message>
        <source>{0}: a report ends in {1}</source>
        <translation>{0}&#xa0;: un rapport se termine par {1}</translation>
    </message>
    <message>
        <source>a run needs the serial number of its DUT: --dut SERIAL</source>
        <translation>une mesure exige le numéro de série de son DUT</translation>
    </message>
    <message>
        <source>run {0} is of DUT {1}, the bench has {2}</source>
        <translation>la mesure {0} est du DUT {1}, sur le banc se trouve {2}</translation>
    </message>
    <message>
        <source>run {0} is of {1}, not of {2}</source>
        <translation>la mesure {0} est de {1}, non de {2}</translation>
    </message>
    <message>
        <source>{0} was changed since run {1} began: start it anew</source>
        <translation>{0} a changé depuis le début de la mesure {1}&#xa0;: recommencer</translation>
    </message>
    <message>
        <source>{0} cannot go on after an interruption: start it anew</source>
        <translation>{0} ne peut continuer après une interruption&#xa0;: recommencer</translation>
    </message>
    <message>
        <source>{0}: there is no such file</source>
        <translation>{0}&#xa0;: ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>{0}: is signed already ({1}); only a draft can be approved</source>
        <translation>{0}&#xa0;: est déjà signé ({1})&#xa0;; seul un brouillon peut être approuvé</translation>
    </message>
    <message>
        <source>{0} is signed: its serial stands; another DUT needs a run of its own</source>
        <translation>{0} est signé&#xa0;: son numéro reste&#xa0;; un autre DUT demande sa propre mesure</translation>
    </message>
    <message>
        <source>another person than the operator approves: --as NAME</source>
        <translation>une autre personne que l&apos;opérateur approuve</translation>
    </message>
    <message>
        <source>aborted by the operator</source>
        <translation>abandonné par l&apos;opérateur</translation>
    </message>
    <message>
        <source>stopped by the operator</source>
        <translation>arrêté par l&apos;opérateur</translation>
    </message>
    <message>
        <source>whoever ran this is gone</source>
        <translation>celui qui menait ceci est parti</translation>
    </message>
    <message>
        <source>the window stood still for more than 4 seconds</source>
        <translation>la fenêtre est restée figée plus de 4 secondes</translation>
    </message>
    <message>
        <source>only the session that drives this bench sets currents.</source>
        <translation>Seul celui qui pilote ce banc règle les courants.</translation>
    </message>
    <message>
        <source>{0}: no reply in {1} s, {2} came.</source>
        <translation>{0}&#xa0;: pas de réponse en {1} s, reçu&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>only {0}</source>
        <translation>seulement {0}</translation>
    </message>
    <message>
        <source>Is it switched on, and is the link in bench.toml the right one?</source>
        <translation>Est-il allumé, et la liaison de bench.toml est-elle la bonne&#xa0;?</translation>
    </message>
    <message>
        <source>{0}: the link was lost ({1}).</source>
        <translation>{0}&#xa0;: la liaison a été perdue ({1}).</translation>
    </message>
    <message>
        <source>{0}: the link was lost.</source>
        <translation>{0}&#xa0;: la liaison a été perdue.</translation>
    </message>
    <message>
        <source>{0}: the link does not open.</source>
        <translation>{0}&#xa0;: la liaison ne s&apos;ouvre pas.</translation>
    </message>
    <message>
        <source>{0}: the link does not open ({1}).</source>
        <translation>{0}&#xa0;: la liaison ne s&apos;ouvre pas ({1}).</translation>
    </message>
    <message>
        <source>{0}; where that is as it should be, accept = [&quot;{1}&quot;] in the mapping says so</source>
        <translation>{0}&#xa0;; si c’est voulu, accept = [&quot;{1}&quot;] dans la correspondance le dit</translation>
    </message>
    <message>
        <source>{0}: are axes swapped or turned about?</source>
        <translation>{0}&#xa0;: des axes sont-ils permutés ou retournés&#xa0;?</translation>
    </message>
    <message>
        <source>the readings fit the reference with axes {0} {1} times better than as stated</source>
        <translation>les mesures s’accordent avec la référence, selon les axes {0} {1} fois mieux que selon ceux indiqués</translation>
    </message>
    <message>
        <source>{0}: is the unit of one of them wrong, by a factor of {1}?</source>
        <translation>{0}&#xa0;: l’une des deux unités est-elle fausse, d’un facteur {1}&#xa0;?</translation>
    </message>
    <message>
        <source>readings of {0} nT in the median beside a reference of {1} nT</source>
        <translation>des mesures de {0} nT en médiane à côté d’une référence de {1} nT</translation>
    </message>
    <message>
        <source>{0}: write the mapping by hand; it has {1}</source>
        <translation>{0}&#xa0;: écrivez la correspondance à la main&#xa0;; le fichier a {1}</translation>
    </message>
    <message>
        <source>{0}: no three columns beside a clock look like a magnetometer</source>
        <translation>{0}&#xa0;: aucun groupe de trois colonnes à côté d’un temps ne ressemble à un magnétomètre</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: letters and digits, and . : + # ( ) - or blanks between them</source>
        <translation>«&#xa0;{0}&#xa0;» n&apos;est pas un numéro de série&#xa0;: lettres et chiffres, entre eux .&#xa0;: + # ( ) - ou des espaces</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, which have no \ .. or control characters</source>
        <translation>«&#xa0;{0}&#xa0;» n&apos;est pas un numéro de série&#xa0;: il entre dans des noms de fichiers, sans \ ni .. ni caractères de commande</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number: it becomes part of file names, where a / parts folders; a bench whose serials have one says so (dut.serial_pattern)</source>
        <translation>«&#xa0;{0}&#xa0;» n&apos;est pas un numéro de série&#xa0;: il entre dans des noms de fichiers, où / sépare les dossiers&#xa0;; un banc dont les numéros en ont un le dit (dut.serial_pattern)</translation>
    </message>
    <message>
        <source>{0}: would lie among what is labcal&apos;s own; name another folder</source>
        <translation>{0}&#xa0;: serait parmi ce qui appartient à labcal&#xa0;; indiquez un autre dossier</translation>
    </message>
    <message>
        <source>{0}: a label has a QR code: pip install &apos;labcal[paper]&apos;</source>
        <translation>{0}&#xa0;: une étiquette a un code QR&#xa0;: pip install &apos;labcal[paper]&apos;</translation>
    </message>
    <message>
        <source>the operator&apos;s name must be one printable line of at most {0} letters</source>
        <translation>le nom de l&apos;opérateur doit être une ligne imprimable d&apos;au plus {0} lettres</translation>
    </message>
    <message>
        <source>“{0}” is no name: letters, digits, blanks, and . , &apos; - _ @ + &amp; / ( ) between them</source>
        <translation>«&#xa0;{0}&#xa0;» n&apos;est pas un nom&#xa0;: lettres, chiffres, espaces, et entre eux . , &apos; - _ @ + &amp; / ( )</translation>
    </message>
    <message>
        <source>run {0} is none to be gone on with: it is {1}</source>
        <translation>la mesure {0} n&apos;est pas à continuer&#xa0;: elle est {1}</translation>
    </message>
    <message>
        <source>{0}: is no bench file: nothing that stands in it is of a bench</source>
        <translation>{0}&#xa0;: ce n’est pas un fichier de banc&#xa0;: rien de ce qui s’y trouve n’est d’un banc</translation>
    </message>
    <message>
        <source>{0}: {1} is not a key that is known here</source>
        <translation>{0}&#xa0;: {1} n’est pas une clé connue ici</translation>
    </message>
    <message>
        <source>{0}; nothing was made</source>
        <translation>{0}&#xa0;; rien n&apos;a été fait</translation>
    </message>
    <message>
        <source>the passphrase is empty</source>
        <translation>la phrase de passe est vide</translation>
    </message>
    <message>
        <source>the passphrase has {0} characters and needs {1}: four words are easy to keep</source>
        <translation>la phrase de passe a {0} caractères, il en faut {1}&#xa0;: quatre mots se retiennent bien</translation>
    </message>
    <message>
        <source>the passphrase is {0}: four words are easy to keep</source>
        <translation>la phrase de passe est {0}&#xa0;: quatre mots se retiennent bien</translation>
    </message>
    <message>
        <source>three signs over and over</source>
        <translation>trois signes répétés</translation>
    </message>
    <message>
        <source>the name of the key&apos;s own person</source>
        <translation>le nom de la personne elle-même</translation>
    </message>
    <message>
        <source>a common word alone</source>
        <translation>un mot courant seul</translation>
    </message>
    <message>
        <source>a row of the keyboard, or of the alphabet</source>
        <translation>une rangée du clavier ou de l&apos;alphabet</translation>
    </message>
    <message>
        <source>{0}: the archive cannot be reached: {1}; nothing is lost: what is not there yet goes there with the next push</source>
        <translation>{0}&#xa0;: l’archive est hors d’atteinte&#xa0;: {1}&#xa0;; rien n’est perdu&#xa0;: ce qui n’y est pas encore y ira au prochain envoi</translation>
    </message>
    <message>
        <source>{0}: there is no archive here that this role can see: its owner makes it by `labcal archive init`</source>
        <translation>{0}&#xa0;: il n’y a ici aucune archive que ce rôle puisse voir&#xa0;: son propriétaire la crée par `labcal archive init`</translation>
    </message>
    <message>
        <source>{0}: its catalogue is of version {1}, and this labcal works with {2}: its owner runs `labcal archive init` once</source>
        <translation>{0}&#xa0;: son catalogue est de version {1}, et ce labcal travaille avec {2}&#xa0;: son propriétaire lance une fois `labcal archive init`</translation>
    </message>
    <message>
        <source>{0}: a newer labcal made its catalogue (version {1}, this one knows {2}): update labcal here</source>
        <translation>{0}&#xa0;: un labcal plus récent a fait son catalogue (version {1}, celui-ci connaît {2})&#xa0;: mettre labcal à jour ici</translation>
    </message>
    <message>
        <source>the archive needs SQLAlchemy, Alembic and psycopg: pip install &apos;labcal[archive]&apos;</source>
        <translation>l’archive a besoin de SQLAlchemy, Alembic et psycopg&#xa0;: pip install &apos;labcal[archive]&apos;</translation>
    </message>
    <message>
        <source>{0}: bundles cannot be kept or read there: {1}</source>
        <translation>{0}&#xa0;: les paquets ne peuvent y être gardés ni lus&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0}: the check standard {1} is out of control ({2}). No procedure begins on this bench: measure it again (--dut {3}), or let a person answer for it: --override NAME --because TEXT</source>
        <translation>{0}&#xa0;: l’étalon de contrôle {1} est hors de contrôle ({2}). Aucune procédure ne commence sur ce banc&#xa0;: le mesurer à nouveau (son numéro comme DUT&#xa0;; --dut {3}), ou quelqu’un en répond sur la ligne de commande&#xa0;: --override NAME --because TEXT</translation>
    </message>
    <message>
        <source>the check standard {0} is out of control ({1})</source>
        <translation>l’étalon de contrôle {0} est hors de contrôle ({1})</translation>
    </message>
    <message>
        <source>No procedure begins on this bench: measure the check standard again, or let a person answer for it.</source>
        <translation>Aucune procédure ne commence sur ce banc&#xa0;: mesurer de nouveau l’étalon de contrôle, ou laisser une personne en répondre.</translation>
    </message>
    <message>
        <source>stopped by the operator, to be gone on with later</source>
        <translation>arrêtée par l’opérateur, pour être poursuivie plus tard</translation>
    </message>
    <message>
        <source>Is it switched on, are address and baud rate right, are A and B not swapped?</source>
        <translation>Est-il allumé, l’adresse et le débit sont-ils justes, A et B ne sont-ils pas inversés&#xa0;?</translation>
    </message>
    <message>
        <source>another process ({0}) keeps the platform&apos;s line and does not stop it</source>
        <translation>un autre processus ({0}) garde la ligne de la plate-forme et ne l’arrête pas</translation>
    </message>
    <message>
        <source>It has answered at this link before: is its plug in at both ends, and has it power?</source>
        <translation>Il a déjà répondu sur cette liaison&#xa0;: sa prise tient-elle aux deux bouts, et est-il alimenté&#xa0;?</translation>
    </message>
    <message>
        <source>{0}: this user may not open it ({1}).</source>
        <translation>{0}&#xa0;: cet utilisateur n&apos;a pas le droit de l&apos;ouvrir ({1}).</translation>
    </message>
    <message>
        <source>{0}: this user may not open it.</source>
        <translation>{0}&#xa0;: cet utilisateur n&apos;a pas le droit de l&apos;ouvrir.</translation>
    </message>
    <message>
        <source>{0}: another program has opened it ({1}).</source>
        <translation>{0}&#xa0;: un autre programme l&apos;a ouvert ({1}).</translation>
    </message>
    <message>
        <source>{0}: another program has opened it.</source>
        <translation>{0}&#xa0;: un autre programme l&apos;a ouvert.</translation>
    </message>
    <message>
        <source>the guardian did not start.</source>
        <translation>Le gardien n&apos;a pas démarré.</translation>
    </message>
    <message>
        <source>a guardian holds the ports and does not answer.</source>
        <translation>Un gardien tient les ports et ne répond pas.</translation>
    </message>
    <message>
        <source>the guardian has not answered for {0} s: it hangs, or was stopped; how the coils are is not known.</source>
        <translation>Le gardien n&apos;a pas répondu depuis {0} s&#xa0;: il est bloqué ou arrêté&#xa0;; l&apos;état des bobines n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>It is tried again and again; no run begins before it answers.</source>
        <translation>On réessaie sans cesse&#xa0;; aucune mesure ne commence avant qu’elle ne réponde.</translation>
    </message>
    <message>
        <source>Switch the supplies off by hand.</source>
        <translation>Éteindre les alimentations à la main.</translation>
    </message>
    <message>
        <source>zero was ordered for all coils: {0}.</source>
        <translation>Zéro a été ordonné pour toutes les bobines&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>zero was ordered{0}; what was being asked of this line was given up.</source>
        <translation>Zéro a été ordonné{0}&#xa0;; ce qu&apos;on demandait sur cette ligne a été abandonné.</translation>
    </message>
    <message>
        <source>See guardian.log; what was measured since then was measured without them.</source>
        <translation>Voir guardian.log&#xa0;; ce qui a été mesuré depuis l&apos;a été sans elles.</translation>
    </message>
    <message>
        <source>See guardian.log in labcal&apos;s data folder.</source>
        <translation>Voir guardian.log dans le dossier de données de labcal.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and nothing flows.</source>
        <translation>bobine {0}&#xa0;: {1} A réglés et rien ne passe.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A was set and {2} A flows.</source>
        <translation>bobine {0}&#xa0;: {1} A réglés et {2} A passent.</translation>
    </message>
    <message>
        <source>Is the winding whole, does the voltage suffice? Set the coils off.</source>
        <translation>L&apos;enroulement est-il intact, la tension suffit-elle&#xa0;? Couper les bobines.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square over {2} s, its limit is {3} A.</source>
        <translation>bobine {0}&#xa0;: {1} A efficaces sur {2} s, sa limite est {3} A.</translation>
    </message>
    <message>
        <source>Let the winding cool, then use less current or shorter times.</source>
        <translation>Laisser refroidir l&apos;enroulement, puis moins de courant ou des temps plus courts.</translation>
    </message>
    <message>
        <source>coil {0}: the contacts did not switch to {1}.</source>
        <translation>bobine {0}&#xa0;: les contacts n&apos;ont pas commuté sur {1}.</translation>
    </message>
    <message>
        <source>Look at the relay and its supply.</source>
        <translation>Examiner le relais et son alimentation.</translation>
    </message>
    <message>
        <source>{0}: the interlock is open.</source>
        <translation>{0}&#xa0;: le verrouillage est ouvert.</translation>
    </message>
    <message>
        <source>It closes when every coil is read back at zero; `guardian.log` says which is not.</source>
        <translation>Il se ferme quand chaque bobine est relue à zéro&#xa0;; `guardian.log` dit laquelle ne l&apos;est pas.</translation>
    </message>
    <message>
        <source>{0}: its {1} protection tripped.</source>
        <translation>{0}&#xa0;: la protection ({1}) s&apos;est déclenchée.</translation>
    </message>
    <message>
        <source>{0}: a reading at full scale.</source>
        <translation>{0}&#xa0;: une lecture en butée.</translation>
    </message>
    <message>
        <source>{0}: {1} samples came in {2} s, too few to say anything.</source>
        <translation>{0}&#xa0;: {1} échantillons en {2} s, trop peu pour conclure.</translation>
    </message>
    <message>
        <source>Look at its power and its cable, or listen for longer.</source>
        <translation>Examiner alimentation et câble, ou écouter plus longtemps.</translation>
    </message>
    <message>
        <source>the computer&apos;s clock was set back by {0} s.</source>
        <translation>L&apos;horloge de l&apos;ordinateur a été reculée de {0} s.</translation>
    </message>
    <message>
        <source>Set the clock right and start the run again.</source>
        <translation>Remettre l&apos;horloge à l&apos;heure et recommencer la mesure.</translation>
    </message>
    <message>
        <source>Switch {0} off by hand before anything else.</source>
        <translation>Avant tout, couper {0} à la main.</translation>
    </message>
    <message>
        <source>zero, open</source>
        <translation>zéro, ouverte</translation>
    </message>
    <message>
        <source>VALID: signed by {0}.</source>
        <translation>VALIDE&#xa0;: signé par {0}.</translation>
    </message>
    <message>
        <source>NOT VALID: {0} carries no signature.</source>
        <translation>NON VALIDE&#xa0;: {0} ne porte pas de signature.</translation>
    </message>
    <message>
        <source>NOT VALID.</source>
        <translation>NON VALIDE.</translation>
    </message>
    <message>
        <source>It was made from the run that was named.</source>
        <translation>Il a été fait de la mesure nommée.</translation>
    </message>
    <message>
        <source>It was not made from the run that was named ({0} differs).</source>
        <translation>Il n&apos;a pas été fait de la mesure nommée ({0} diffère).</translation>
    </message>
    <message>
        <source>Worked out again from its run, it is the same.</source>
        <translation>Recalculé de sa mesure, il est le même.</translation>
    </message>
    <message>
        <source>It was not worked out again: {0}.</source>
        <translation>Il n&apos;a pas été recalculé&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}. The signature stands.</source>
        <translation>Recalculé de sa mesure, il diffère&#xa0;: {0}. La signature tient.</translation>
    </message>
    <message>
        <source>Worked out again from its run it differs: {0}.</source>
        <translation>Recalculé de sa mesure, il diffère&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>PROVISIONAL: {0}.</source>
        <translation>PROVISOIRE&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>EXPIRED: it was good until {0}.</source>
        <translation>EXPIRÉ&#xa0;: il valait jusqu&apos;au {0}.</translation>
    </message>
    <message>
        <source>SUPERSEDED: by the calibration of run {0}.</source>
        <translation>REMPLACÉ&#xa0;: par l&apos;étalonnage de la mesure {0}.</translation>
    </message>
    <message>
        <source>SIMULATED: it describes no real sensor.</source>
        <translation>SIMULÉ&#xa0;: il ne décrit aucun capteur réel.</translation>
    </message>
    <message>
        <source>no approver is named</source>
        <translation>aucun approbateur n&apos;est nommé</translation>
    </message>
    <message>
        <source>named as approver, but is the operator: {0}</source>
        <translation>nommé approbateur, mais opérateur&#xa0;: {0}</translation>
    </message>
    <message>
        <source>named as approver, but has not signed: {0}</source>
        <translation>nommé approbateur, mais n&apos;a pas signé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>named as approver, but has not the role approve: {0}</source>
        <translation>nommé comme approbateur, mais sans le rôle approve&#xa0;: {0}</translation>
    </message>
    <message>
        <source>its operator, {0}, has not the role measure</source>
        <translation>l&apos;opérateur {0} n&apos;a pas le rôle measure</translation>
    </message>
    <message>
        <source>nobody but its operator has signed who has the role release</source>
        <translation>personne d&apos;autre que l&apos;opérateur n&apos;a signé qui ait le rôle release</translation>
    </message>
    <message>
        <source>its numbers were not confirmed by its run</source>
        <translation>ses nombres n&apos;ont pas été confirmés par sa mesure</translation>
    </message>
    <message>
        <source>its run did not measure {0}</source>
        <translation>sa mesure n&apos;a pas déterminé {0}</translation>
    </message>
    <message>
        <source>Not measured by this run, and held as they stand: {0}.</source>
        <translation>Non déterminés par cette mesure, et restés tels quels&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Unexplained by the closed loop: {0} nT are left of held-out rows, where noise alone leaves {1}; U takes that for random.</source>
        <translation>Inexpliqué par la boucle&#xa0;: {0} nT restent dans les lignes réservées, là où le bruit seul en laisse {1}&#xa0;; U le prend pour aléatoire.</translation>
    </message>
    <message>
        <source>its run did not measure {0}: nobody can approve that; turn about the other body axes as well</source>
        <translation>sa mesure n&apos;a pas déterminé {0}&#xa0;: personne ne peut l&apos;approuver&#xa0;; tourner aussi autour des autres axes du corps</translation>
    </message>
    <message>
        <source>zero, not open</source>
        <translation>zéro, non ouverte</translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s.</source>
        <translation>{0}&#xa0;: aucun échantillon depuis {1} s.</translation>
    </message>
    <message>
        <source>{0}: no answer.</source>
        <translation>{0}&#xa0;: pas de réponse.</translation>
    </message>
    <message>
        <source>{0}: the same reading for {1} s.</source>
        <translation>{0}&#xa0;: la même lecture depuis {1} s.</translation>
    </message>
    <message>
        <source>{0}: no temperature for {1} s, and it has a limit.</source>
        <translation>{0}&#xa0;: pas de température depuis {1} s, et elle a une limite.</translation>
    </message>
    <message>
        <source>{0}: {1} is {2} degC, its limit is {3} degC.</source>
        <translation>{0}&#xa0;: {1} est à {2} °C, sa limite est {3} °C.</translation>
    </message>
    <message>
        <source>{0}: a field of {1} nT is seen, the limit is {2} nT.</source>
        <translation>{0}&#xa0;: un champ de {1} nT est vu, la limite est {2} nT.</translation>
    </message>
    <message>
        <source>no samples came from {0}.</source>
        <translation>aucun échantillon n&apos;est venu de {0}.</translation>
    </message>
    <message>
        <source>{0}: it sent nothing at {1} of this turn.</source>
        <translation>{0}&#xa0;: il n&apos;a rien envoyé à {1} de ce tour.</translation>
    </message>
    <message>
        <source>{0}: still not seen: {1}.</source>
        <translation>{0}&#xa0;: toujours pas vu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Is its plug in at both ends, and has it power? Nobody can tell from here which it is.</source>
        <translation>Sa prise est-elle branchée aux deux bouts, et est-il alimenté&#xa0;? D’ici, personne ne peut dire lequel des deux.</translation>
    </message>
    <message>
        <source>Switch the sensor off and on, and look at its range.</source>
        <translation>Éteindre et rallumer le capteur, et examiner sa plage.</translation>
    </message>
    <message>
        <source>Is the ambient field what it was when it was measured last?</source>
        <translation>Le champ ambiant est-il celui mesuré en dernier&#xa0;?</translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names, and is its link the right one?</source>
        <translation>Est-ce l&apos;appareil que nomme bench.toml, et sa liaison est-elle la bonne&#xa0;?</translation>
    </message>
    <message>
        <source>Plug it in, see that nobody else has opened it, then try again.</source>
        <translation>Le brancher, vérifier que nul autre ne l&apos;a ouvert, puis réessayer.</translation>
    </message>
    <message>
        <source>Is this the instrument that bench.toml names? Look at its cable, then try again.</source>
        <translation>Est-ce l&apos;appareil que nomme bench.toml&#xa0;? Examiner son câble, puis réessayer.</translation>
    </message>
    <message>
        <source>Look at its panel, then try again.</source>
        <translation>Regarder son afficheur, puis réessayer.</translation>
    </message>
    <message>
        <source>Look for what holds it, home it and try again.</source>
        <translation>Chercher ce qui le retient, le remettre à l&apos;origine et réessayer.</translation>
    </message>
    <message>
        <source>Look at the stage, home it and try again.</source>
        <translation>Examiner la platine, la remettre à l&apos;origine et réessayer.</translation>
    </message>
    <message>
        <source>{0}: there is no key for {1} here; `labcal keys new --name {2}` makes one</source>
        <translation>{0}&#xa0;: pas de clé pour {1} ici&#xa0;; `labcal keys new --name {2}` en fait une</translation>
    </message>
    <message>
        <source>{0}: does not open: the passphrase is wrong or the file is damaged</source>
        <translation>{0}&#xa0;: ne s&apos;ouvre pas&#xa0;: la phrase de passe est fausse ou le fichier endommagé</translation>
    </message>
    <message>
        <source>{0}: {1} has a key already; a second one would replace it (`labcal keys revoke {2}` where it is lost)</source>
        <translation>{0}&#xa0;: {1} a déjà une clé&#xa0;; une seconde la remplacerait (`labcal keys revoke {2}` si elle est perdue)</translation>
    </message>
    <message>
        <source>broken off by its store: {0}</source>
        <translation>interrompue par le magasin&#xa0;: {0}</translation>
    </message>
    <message>
        <source>broken off: {0}</source>
        <translation>interrompue&#xa0;: {0}</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>interrompue</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminée</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêtée</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>importée</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>No whole calibration can come of one body axis: it does not determine all 12 parameters of the map. It repeats or checks turns.</source>
        <translation>D’un seul axe du corps ne peut venir aucun étalonnage entier&#xa0;: il ne détermine pas les 12 paramètres de l’application. Il répète ou vérifie des rotations.</translation>
    </message>
    <message>
        <source>Alternate each coil&apos;s current with falling amplitude, and compare the ambient field before and after.</source>
        <translation>Faire alterner le courant de chaque bobine à amplitude décroissante et comparer le champ ambiant avant et après.</translation>
    </message>
    <message>
        <source>Calibrate the DUT at rest: the coils play directions all over; K and k in the cage&apos;s frame.</source>
        <translation>Étalonner le DUT au repos&#xa0;: les bobines parcourent toutes les directions&#xa0;; K et k dans le repère de la cage.</translation>
    </message>
    <message>
        <source>Check sign, order and handedness of cage, reference and DUT, and the sense of the angle.</source>
        <translation>Vérifier signe, ordre et orientation de la cage, de la référence et du DUT, et le sens de l&apos;angle.</translation>
    </message>
    <message>
        <source>Check the reference&apos;s due date, its zero by 180° turns, and its magnitude against direction and a standard.</source>
        <translation>Vérifier l&apos;échéance de la référence, son zéro par des tours de 180° et son module selon la direction et un étalon.</translation>
    </message>
    <message>
        <source>Find where DUT and reference stand, from the gradients of coil pairs with one half reversed.</source>
        <translation>Trouver où sont le DUT et la référence, d&apos;après les gradients de paires de bobines dont une moitié est inversée.</translation>
    </message>
    <message>
        <source>Go through the checklist; every &quot;no&quot; is named at the end.</source>
        <translation>Parcourir la liste de contrôle&#xa0;; chaque «&#xa0;non&#xa0;» est nommé à la fin.</translation>
    </message>
    <message>
        <source>Hold a field by feedback on the reference, taken over from the open-loop set-point without a bump.</source>
        <translation>Maintenir un champ par asservissement à la référence, repris sans à-coup de la consigne en boucle ouverte.</translation>
    </message>
    <message>
        <source>Map the field of each coil over the working volume, computed and probed.</source>
        <translation>Cartographier le champ de chaque bobine dans le volume utile, calculé et mesuré.</translation>
    </message>
    <message>
        <source>Measure heading and magnitude error at independent positions; `calibration`, where it is stated, is judged.</source>
        <translation>Mesurer l&apos;erreur de cap et de module à des positions indépendantes&#xa0;; `calibration` est jugé, s&apos;il est indiqué.</translation>
    </message>
    <message>
        <source>Measure mean, drift, noise and mains of the room, and say whether it is fit for the job.</source>
        <translation>Mesurer moyenne, dérive, bruit et secteur de la salle et dire si elle convient.</translation>
    </message>
    <message>
        <source>Measure offset and gain against the DUT&apos;s temperature while it changes.</source>
        <translation>Mesurer décalage et gain selon la température du DUT pendant qu&apos;elle change.</translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s offset from four attitudes in the ambient field, coils off.</source>
        <translation>Mesurer le décalage du DUT dans quatre attitudes du champ ambiant, bobines coupées.</translation>
    </message>
    <message>
        <source>Measure the DUT&apos;s permanent and induced dipole from what the reference sees of it at two distances.</source>
        <translation>Mesurer le dipôle permanent et induit du DUT d&apos;après ce qu&apos;en voit la référence à deux distances.</translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix and offset at the DUT&apos;s place and at the reference&apos;s; a draft.</source>
        <translation>Mesurer la matrice courant-champ et le décalage à la place du DUT et de la référence&#xa0;; un brouillon.</translation>
    </message>
    <message>
        <source>Measure the current-to-field matrix, its squareness and the ambient field by a scalar sensor in the centre.</source>
        <translation>Mesurer la matrice courant-champ, son orthogonalité et le champ ambiant par un capteur scalaire au centre.</translation>
    </message>
    <message>
        <source>Measure the delay of DUT, reference and angle against the set-point and each other.</source>
        <translation>Mesurer le retard du DUT, de la référence et de l&apos;angle sur la consigne et entre eux.</translation>
    </message>
    <message>
        <source>Measure the platform&apos;s own field with the reference at the DUT&apos;s place, coils off.</source>
        <translation>Mesurer le champ propre du plateau, la référence à la place du DUT, bobines coupées.</translation>
    </message>
    <message>
        <source>Play a field history, with the tracking error recorded.</source>
        <translation>Jouer une histoire de champ et enregistrer l&apos;erreur de poursuite.</translation>
    </message>
    <message>
        <source>Repeat one rotation, with the coils off in between.</source>
        <translation>Répéter une rotation, bobines coupées entre-temps.</translation>
    </message>
    <message>
        <source>Step the field along a body axis (or two together) and measure the departure from a straight line.</source>
        <translation>Échelonner le champ le long d&apos;un axe du corps (ou de deux) et mesurer l&apos;écart à une droite.</translation>
    </message>
    <message>
        <source>Switch each load and measure the bias per ampere (3 × N) and its delay, coils off.</source>
        <translation>Commuter chaque charge et mesurer le biais par ampère (3 × N) et son retard, bobines coupées.</translation>
    </message>
    <message>
        <source>The whole calibration before flight, from the zero to the closing.</source>
        <translation>Tout l&apos;étalonnage avant le vol, du zéro à la fermeture.</translation>
    </message>
    <message>
        <source>Turn once forwards and once backwards at one rate.</source>
        <translation>Tourner une fois en avant et une fois en arrière à une même vitesse.</translation>
    </message>
    <message>
        <source>Turn the DUT about one body axis in one steady field; one axis is not enough for a calibration by itself.</source>
        <translation>Tourner le DUT autour d’un axe du corps dans un champ constant&#xa0;; un seul axe ne suffit pas pour un étalonnage.</translation>
    </message>
    <message>
        <source>Turn there and back at several rates in one mounting.</source>
        <translation>Tourner aller et retour à plusieurs vitesses, sans remontage.</translation>
    </message>
    <message>
        <source>[cage.geometry] with halves that a person can reverse; a vector reference</source>
        <translation>[cage.geometry] avec des moitiés qu&apos;une personne peut inverser&#xa0;; une référence vectorielle</translation>
    </message>
    <message>
        <source>a vector reference</source>
        <translation>une référence vectorielle</translation>
    </message>
    <message>
        <source>a vector reference that can be moved, the coils&apos; geometry in bench.toml</source>
        <translation>une référence vectorielle mobile, la géométrie des bobines dans bench.toml</translation>
    </message>
    <message>
        <source>a vector reference, first at the DUT&apos;s place, then at its own</source>
        <translation>une référence vectorielle, d&apos;abord à la place du DUT, puis à la sienne</translation>
    </message>
    <message>
        <source>an absolute scalar sensor in the cage&apos;s centre</source>
        <translation>un capteur scalaire absolu au centre de la cage</translation>
    </message>
    <message>
        <source>nothing magnetic in the cage that must not be touched</source>
        <translation>rien de magnétique dans la cage à quoi on ne doive toucher</translation>
    </message>
    <message>
        <source>the DUT as it will fly, and a camera</source>
        <translation>le DUT tel qu&apos;il volera, et un appareil photo</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage</source>
        <translation>le DUT au repos dans la cage</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a table of the field, an orbit, or a simulator</source>
        <translation>le DUT au repos dans la cage&#xa0;; une table du champ, une orbite ou un simulateur</translation>
    </message>
    <message>
        <source>the DUT at rest in the cage; a vector reference at its place, or an approved cage calibration</source>
        <translation>le DUT au repos dans la cage&#xa0;; une référence vectorielle à sa place, ou un étalonnage de cage approuvé</translation>
    </message>
    <message>
        <source>the DUT free to be turned over by hand</source>
        <translation>le DUT peut être retourné à la main</translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor</source>
        <translation>le DUT sur un plateau à moteur</translation>
    </message>
    <message>
        <source>the DUT on a platform with a motor, a vector reference that can be moved beside it</source>
        <translation>le DUT sur un plateau à moteur, à côté une référence vectorielle mobile</translation>
    </message>
    <message>
        <source>the DUT on the platform</source>
        <translation>le DUT sur le plateau</translation>
    </message>
    <message>
        <source>the DUT on the platform, a vector reference</source>
        <translation>le DUT sur le plateau, une référence vectorielle</translation>
    </message>
    <message>
        <source>the DUT on the platform, its calibration file</source>
        <translation>le DUT sur le plateau, son fichier d&apos;étalonnage</translation>
    </message>
    <message>
        <source>the DUT&apos;s own, that is judged; without one nothing is</source>
        <translation>celui de l&apos;appareil, qui est jugé&#xa0;; sans lui, rien ne l&apos;est</translation>
    </message>
    <message>
        <source>the DUT on the platform, loads of the spacecraft that can be switched</source>
        <translation>le DUT sur le plateau, des charges du véhicule spatial qu&apos;on peut commuter</translation>
    </message>
    <message>
        <source>the DUT on the platform, remounted three times; a vector reference</source>
        <translation>le DUT sur le plateau, remonté trois fois&#xa0;; une référence vectorielle</translation>
    </message>
    <message>
        <source>the DUT with its thermometer, a means to warm it</source>
        <translation>le DUT avec son thermomètre, de quoi le chauffer</translation>
    </message>
    <message>
        <source>the bare fixture with the motor, a vector reference at the DUT&apos;s place</source>
        <translation>le support nu avec le moteur, une référence vectorielle à la place du DUT</translation>
    </message>
    <message>
        <source>the cage as it will be used, coils off</source>
        <translation>la cage telle qu&apos;elle servira, bobines coupées</translation>
    </message>
    <message>
        <source>the reference on the platform</source>
        <translation>la référence sur le plateau</translation>
    </message>
    <message>
        <source>Altitude km</source>
        <translation>Altitude km</translation>
    </message>
    <message>
        <source>Apart mm</source>
        <translation>Écart mm</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>Attitude</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Change ppm</source>
        <translation>Changement ppm</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Voie</translation>
    </message>
    <message>
        <source>Chip</source>
        <translation>Créneau</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Créneaux</translation>
    </message>
    <message>
        <source>Closure</source>
        <translation>Fermeture</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Cycles</translation>
    </message>
    <message>
        <source>Dead</source>
        <translation>Zone morte</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Drift nT per min</source>
        <translation>Dérive nT/min</translation>
    </message>
    <message>
        <source>Due days</source>
        <translation>Échéance jours</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Maintien</translation>
    </message>
    <message>
        <source>Epoch</source>
        <translation>Époque</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Champs</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmoniques</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Cap</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Tenue</translation>
    </message>
    <message>
        <source>Homogeneity ppm</source>
        <translation>Homogénéité ppm</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hystérésis</translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Dernière</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Limit Am2</source>
        <translation>Limite Am²</translation>
    </message>
    <message>
        <source>Limit ppm</source>
        <translation>Limite ppm</translation>
    </message>
    <message>
        <source>Linearity</source>
        <translation>Linéarité</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Charges</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>Magnitudes</source>
        <translation>Modules</translation>
    </message>
    <message>
        <source>Mains</source>
        <translation>Secteur</translation>
    </message>
    <message>
        <source>Mains hz</source>
        <translation>Secteur Hz</translation>
    </message>
    <message>
        <source>Max age</source>
        <translation>Âge maximal</translation>
    </message>
    <message>
        <source>Misfit mm</source>
        <translation>Écart mm</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Model ppm</source>
        <translation>Modèle ppm</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Modes</translation>
    </message>
    <message>
        <source>Modulus</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>Mountings</source>
        <translation>Montages</translation>
    </message>
    <message>
        <source>N directions</source>
        <translation>Directions</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Bruit</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Période</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Photos</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>Relay ppm</source>
        <translation>Relais ppm</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>Scale ppm</source>
        <translation>Échelle ppm</translation>
    </message>
    <message>
        <source>Second axis</source>
        <translation>Second axe</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Silence</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Allure</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Équerrage</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Étalon</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Paliers</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Tour</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>U cage ppm</source>
        <translation>U cage ppm</translation>
    </message>
    <message>
        <source>U mounting</source>
        <translation>U montage</translation>
    </message>
    <message>
        <source>U place</source>
        <translation>U place</translation>
    </message>
    <message>
        <source>U standard</source>
        <translation>U étalon</translation>
    </message>
    <message>
        <source>U time</source>
        <translation>U temps</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>U tour</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>the DUT&apos;s power mode</source>
        <translation>mode d&apos;alimentation du DUT</translation>
    </message>
    <message>
        <source>body axis mounted along the platform axis</source>
        <translation>axe du corps monté le long de l&apos;axe du plateau</translation>
    </message>
    <message>
        <source>field from the platform axis</source>
        <translation>champ par rapport à l&apos;axe du plateau</translation>
    </message>
    <message>
        <source>magnitude of the field</source>
        <translation>module du champ</translation>
    </message>
    <message>
        <source>recorded at each step</source>
        <translation>enregistré à chaque palier</translation>
    </message>
    <message>
        <source>largest departure that passes</source>
        <translation>plus grand écart admis</translation>
    </message>
    <message>
        <source>of every turn</source>
        <translation>de chaque tour</translation>
    </message>
    <message>
        <source>recorded in each field</source>
        <translation>enregistré dans chaque champ</translation>
    </message>
    <message>
        <source>fields that no fit sees, at the end</source>
        <translation>champs de fin qu&apos;aucun ajustement ne voit</translation>
    </message>
    <message>
        <source>how well the axis is mounted; 0: not stated</source>
        <translation>précision du montage de l&apos;axe&#xa0;; 0&#xa0;: non indiquée</translation>
    </message>
    <message>
        <source>0: as fast as timing and the range allow</source>
        <translation>0&#xa0;: aussi vite que les temps et la plage le permettent</translation>
    </message>
    <message>
        <source>error that timing may make</source>
        <translation>erreur admise due au temps</translation>
    </message>
    <message>
        <source>0: continuous, else stepped</source>
        <translation>0&#xa0;: continu, sinon par pas</translation>
    </message>
    <message>
        <source>coils-off zero before</source>
        <translation>zéro bobines coupées avant</translation>
    </message>
    <message>
        <source>how long to listen</source>
        <translation>durée d&apos;écoute</translation>
    </message>
    <message>
        <source>the mains</source>
        <translation>le secteur</translation>
    </message>
    <message>
        <source>of the mains, looked for</source>
        <translation>du secteur, recherchées</translation>
    </message>
    <message>
        <source>how long to listen for it, at the fastest rate</source>
        <translation>durée d&apos;écoute du secteur, à la cadence la plus rapide</translation>
    </message>
    <message>
        <source>largest amplitude of it that passes</source>
        <translation>plus grande amplitude admise</translation>
    </message>
    <message>
        <source>of the rotation that is planned</source>
        <translation>de la rotation prévue</translation>
    </message>
    <message>
        <source>fastest drift that passes</source>
        <translation>dérive la plus rapide admise</translation>
    </message>
    <message>
        <source>largest noise of one sample that passes</source>
        <translation>plus grand bruit d&apos;un échantillon admis</translation>
    </message>
    <message>
        <source>step of the field on each coil</source>
        <translation>échelon du champ sur chaque bobine</translation>
    </message>
    <message>
        <source>the small turn</source>
        <translation>la petite rotation</translation>
    </message>
    <message>
        <source>how far an axis may point beside</source>
        <translation>écart d&apos;axe admis</translation>
    </message>
    <message>
        <source>largest step of each coil</source>
        <translation>plus grand échelon de chaque bobine</translation>
    </message>
    <message>
        <source>steps of one sign, from zero to the largest</source>
        <translation>échelons d&apos;un signe, de zéro au plus grand</translation>
    </message>
    <message>
        <source>largest uncertainty of the matrix that passes</source>
        <translation>plus grande incertitude de la matrice admise</translation>
    </message>
    <message>
        <source>largest change from bench.toml that passes</source>
        <translation>plus grand changement admis par rapport à bench.toml</translation>
    </message>
    <message>
        <source>largest difference of the polarities</source>
        <translation>plus grande différence des polarités</translation>
    </message>
    <message>
        <source>largest departure from the line that passes</source>
        <translation>plus grand écart à la droite admis</translation>
    </message>
    <message>
        <source>largest difference of up and down that passes</source>
        <translation>plus grande différence montée-descente admise</translation>
    </message>
    <message>
        <source>side of the square coils</source>
        <translation>côté des bobines carrées</translation>
    </message>
    <message>
        <source>distance of a pair, in sides</source>
        <translation>distance d&apos;une paire, en côtés</translation>
    </message>
    <message>
        <source>of the working volume</source>
        <translation>du volume utile</translation>
    </message>
    <message>
        <source>points probed with the reference on each axis</source>
        <translation>points sondés par la référence sur chaque axe</translation>
    </message>
    <message>
        <source>of each coil while probed</source>
        <translation>de chaque bobine pendant la mesure</translation>
    </message>
    <message>
        <source>recorded at each point and sign</source>
        <translation>enregistré à chaque point et signe</translation>
    </message>
    <message>
        <source>probe against computed that passes</source>
        <translation>mesuré contre calculé, admis</translation>
    </message>
    <message>
        <source>ask for a photograph of each</source>
        <translation>demander une photo de chacun</translation>
    </message>
    <message>
        <source>channels to switch; none: every current channel of the DUT</source>
        <translation>voies à commuter&#xa0;; aucune&#xa0;: toutes les voies de courant du DUT</translation>
    </message>
    <message>
        <source>times each load is switched on</source>
        <translation>nombre d&apos;enclenchements de chaque charge</translation>
    </message>
    <message>
        <source>on, and off, each time</source>
        <translation>en marche puis arrêt, chaque fois</translation>
    </message>
    <message>
        <source>first amplitude, within coil and DUT limits</source>
        <translation>première amplitude, dans les limites de la bobine et du DUT</translation>
    </message>
    <message>
        <source>reversals</source>
        <translation>inversions</translation>
    </message>
    <message>
        <source>last amplitude</source>
        <translation>dernière amplitude</translation>
    </message>
    <message>
        <source>at each amplitude</source>
        <translation>à chaque amplitude</translation>
    </message>
    <message>
        <source>body axes up, in turn: at least two</source>
        <translation>axes du corps vers le haut, tour à tour&#xa0;: au moins deux</translation>
    </message>
    <message>
        <source>of the reference above it: at least two</source>
        <translation>de la référence au-dessus&#xa0;: au moins deux</translation>
    </message>
    <message>
        <source>uncertainty of each coordinate of its place</source>
        <translation>incertitude de chaque coordonnée de sa place</translation>
    </message>
    <message>
        <source>reversed between turns: the induced part</source>
        <translation>inversé entre les tours&#xa0;: la part induite</translation>
    </message>
    <message>
        <source>in each field at rest, with the DUT and without</source>
        <translation>dans chaque champ au repos, avec et sans DUT</translation>
    </message>
    <message>
        <source>largest moment that passes</source>
        <translation>plus grand moment admis</translation>
    </message>
    <message>
        <source>total field x, y, z in C</source>
        <translation>champ total x, y, z dans C</translation>
    </message>
    <message>
        <source>how long it is held</source>
        <translation>durée de maintien</translation>
    </message>
    <message>
        <source>of the feedback</source>
        <translation>de l&apos;asservissement</translation>
    </message>
    <message>
        <source>part of the error taken back each time</source>
        <translation>part de l&apos;erreur reprise chaque fois</translation>
    </message>
    <message>
        <source>errors below this are left: the supplies&apos; own step</source>
        <translation>les erreurs plus petites restent&#xa0;: le pas des alimentations</translation>
    </message>
    <message>
        <source>rms error that passes</source>
        <translation>erreur efficace admise</translation>
    </message>
    <message>
        <source>of the field, all over the sphere</source>
        <translation>du champ, sur toute la sphère</translation>
    </message>
    <message>
        <source>of the field, each in all</source>
        <translation>du champ, chacun dans toutes</translation>
    </message>
    <message>
        <source>body axis along the platform axis</source>
        <translation>axe du corps le long de l&apos;axe du plateau</translation>
    </message>
    <message>
        <source>rms error at those fields that passes</source>
        <translation>erreur efficace admise à ces champs</translation>
    </message>
    <message>
        <source>change of the zero through the run that passes</source>
        <translation>changement du zéro admis pendant la mesure</translation>
    </message>
    <message>
        <source>recorded in each attitude</source>
        <translation>enregistré dans chaque attitude</translation>
    </message>
    <message>
        <source>how well an attitude is met</source>
        <translation>précision d&apos;une attitude</translation>
    </message>
    <message>
        <source>body axis along the platform axis and the field</source>
        <translation>axe du corps le long de l&apos;axe du plateau et du champ</translation>
    </message>
    <message>
        <source>body axis stepped together with it</source>
        <translation>axe du corps échelonné avec lui</translation>
    </message>
    <message>
        <source>largest field</source>
        <translation>plus grand champ</translation>
    </message>
    <message>
        <source>steps of one sign</source>
        <translation>échelons d&apos;un signe</translation>
    </message>
    <message>
        <source>of each coil with both halves alike</source>
        <translation>de chaque bobine, moitiés de même sens</translation>
    </message>
    <message>
        <source>recorded at each sign</source>
        <translation>enregistré à chaque signe</translation>
    </message>
    <message>
        <source>from where the reference is stated that passes</source>
        <translation>de la place indiquée de la référence, admis</translation>
    </message>
    <message>
        <source>of the coils&apos; geometry that passes</source>
        <translation>de la géométrie des bobines, admis</translation>
    </message>
    <message>
        <source>of the turn</source>
        <translation>du tour</translation>
    </message>
    <message>
        <source>recorded with the motor holding, and off</source>
        <translation>enregistré moteur en maintien, et coupé</translation>
    </message>
    <message>
        <source>largest signature that passes</source>
        <translation>plus grande signature admise</translation>
    </message>
    <message>
        <source>CSV t_s,b_x,b_y,b_z [s, nT in C]; none: the orbit below</source>
        <translation>CSV t_s,b_x,b_y,b_z [s, nT dans C]&#xa0;; aucun&#xa0;: l&apos;orbite ci-dessous</translation>
    </message>
    <message>
        <source>udp://HOST:PORT: as a simulator sends it (docs/field-source.md)</source>
        <translation>udp://HOST:PORT&#xa0;: comme un simulateur l&apos;envoie (docs/field-source.md)</translation>
    </message>
    <message>
        <source>of the circular orbit</source>
        <translation>de l&apos;orbite circulaire</translation>
    </message>
    <message>
        <source>of the orbit</source>
        <translation>de l&apos;orbite</translation>
    </message>
    <message>
        <source>start, ISO 8601 UTC</source>
        <translation>début, ISO 8601 UTC</translation>
    </message>
    <message>
        <source>how the satellite is held</source>
        <translation>attitude du satellite</translation>
    </message>
    <message>
        <source>of orbit time, at most of a source</source>
        <translation>de temps d&apos;orbite, au plus pour une source</translation>
    </message>
    <message>
        <source>between two set-points</source>
        <translation>entre deux consignes</translation>
    </message>
    <message>
        <source>orbit seconds played in one second</source>
        <translation>secondes d&apos;orbite jouées en une seconde</translation>
    </message>
    <message>
        <source>that the source may be silent</source>
        <translation>pendant laquelle la source peut se taire</translation>
    </message>
    <message>
        <source>of a field from the source, beside its quickest</source>
        <translation>d&apos;un champ de la source, par rapport au plus rapide</translation>
    </message>
    <message>
        <source>rms tracking error that passes</source>
        <translation>erreur de poursuite efficace admise</translation>
    </message>
    <message>
        <source>body axes, each mounted along the platform axis in turn</source>
        <translation>axes du corps, montés tour à tour le long de l&apos;axe du plateau</translation>
    </message>
    <message>
        <source>field magnitudes</source>
        <translation>modules du champ</translation>
    </message>
    <message>
        <source>the last magnitude also reversed</source>
        <translation>le dernier module aussi inversé</translation>
    </message>
    <message>
        <source>the DUT&apos;s power modes</source>
        <translation>modes d&apos;alimentation du DUT</translation>
    </message>
    <message>
        <source>timing uncertainty, at least</source>
        <translation>incertitude de temps, au moins</translation>
    </message>
    <message>
        <source>recorded at a position</source>
        <translation>enregistré à une position</translation>
    </message>
    <message>
        <source>coils-off zero, first and last</source>
        <translation>zéro bobines coupées, au début et à la fin</translation>
    </message>
    <message>
        <source>largest closure that passes</source>
        <translation>plus grand écart de fermeture admis</translation>
    </message>
    <message>
        <source>how well an axis is mounted</source>
        <translation>précision du montage d&apos;un axe</translation>
    </message>
    <message>
        <source>each there and back</source>
        <translation>chacune aller et retour</translation>
    </message>
    <message>
        <source>age of its calibration that passes</source>
        <translation>âge de son étalonnage admis</translation>
    </message>
    <message>
        <source>recorded in each attitude and field</source>
        <translation>enregistré dans chaque attitude et champ</translation>
    </message>
    <message>
        <source>of the field in six directions</source>
        <translation>du champ dans six directions</translation>
    </message>
    <message>
        <source>largest zero that passes</source>
        <translation>plus grand zéro admis</translation>
    </message>
    <message>
        <source>largest spread of the magnitude that passes</source>
        <translation>plus grande dispersion du module admise</translation>
    </message>
    <message>
        <source>ambient magnitude by a standard; 0: none</source>
        <translation>module ambiant selon un étalon&#xa0;; 0&#xa0;: aucun</translation>
    </message>
    <message>
        <source>of the standard; 0: not stated</source>
        <translation>de l&apos;étalon&#xa0;; 0&#xa0;: non indiquée</translation>
    </message>
    <message>
        <source>how truly it is turned by 180°; 0: not stated</source>
        <translation>précision du retournement de 180°&#xa0;; 0&#xa0;: non indiquée</translation>
    </message>
    <message>
        <source>of the cage&apos;s field, by direction; 0: not stated</source>
        <translation>du champ de la cage, par direction&#xa0;; 0&#xa0;: non indiquée</translation>
    </message>
    <message>
        <source>how often</source>
        <translation>nombre de fois</translation>
    </message>
    <message>
        <source>coils off between two turns</source>
        <translation>bobines coupées entre deux tours</translation>
    </message>
    <message>
        <source>of both turns</source>
        <translation>des deux tours</translation>
    </message>
    <message>
        <source>timing uncertainty</source>
        <translation>incertitude de temps</translation>
    </message>
    <message>
        <source>recorded at each stop</source>
        <translation>enregistré à chaque arrêt</translation>
    </message>
    <message>
        <source>full turns, there and back by turns</source>
        <translation>tours complets, aller et retour alternés</translation>
    </message>
    <message>
        <source>of each coil alone</source>
        <translation>de chaque bobine seule</translation>
    </message>
    <message>
        <source>of the field that rotates</source>
        <translation>du champ tournant</translation>
    </message>
    <message>
        <source>of the field that rotates, at two moduli</source>
        <translation>du champ tournant, à deux modules</translation>
    </message>
    <message>
        <source>rms error of the magnitude there that passes</source>
        <translation>erreur efficace du module admise</translation>
    </message>
    <message>
        <source>departure from square that passes</source>
        <translation>écart à l&apos;angle droit admis</translation>
    </message>
    <message>
        <source>height of the wave; one ramp step at most</source>
        <translation>hauteur de l&apos;onde&#xa0;; au plus un pas de rampe</translation>
    </message>
    <message>
        <source>steps of the pseudo-random wave</source>
        <translation>pas de l&apos;onde pseudo-aléatoire</translation>
    </message>
    <message>
        <source>length of a step</source>
        <translation>durée d&apos;un pas</translation>
    </message>
    <message>
        <source>turned to and fro</source>
        <translation>tourné en va-et-vient</translation>
    </message>
    <message>
        <source>longest delay that passes</source>
        <translation>plus long retard admis</translation>
    </message>
    <message>
        <source>temperature channel of the DUT; empty: the first</source>
        <translation>voie de température du DUT&#xa0;; vide&#xa0;: la première</translation>
    </message>
    <message>
        <source>along the platform axis</source>
        <translation>le long de l&apos;axe du plateau</translation>
    </message>
    <message>
        <source>times every field is visited</source>
        <translation>nombre de visites de chaque champ</translation>
    </message>
    <message>
        <source>recorded at each visit</source>
        <translation>enregistré à chaque visite</translation>
    </message>
    <message>
        <source>fields and angles</source>
        <translation>champs et angles</translation>
    </message>
    <message>
        <source>of the field</source>
        <translation>du champ</translation>
    </message>
    <message>
        <source>recorded at each position</source>
        <translation>enregistré à chaque position</translation>
    </message>
    <message>
        <source>between positions</source>
        <translation>entre les positions</translation>
    </message>
    <message>
        <source>rms heading error that passes</source>
        <translation>erreur de cap efficace admise</translation>
    </message>
    <message>
        <source>rms magnitude error that passes</source>
        <translation>erreur de module efficace admise</translation>
    </message>
    <message>
        <source>a number from {0} to {1}, or several with commas</source>
        <translation>un nombre de {0} à {1}, ou plusieurs avec des virgules</translation>
    </message>
    <message>
        <source>a number from {0} to {1}</source>
        <translation>un nombre de {0} à {1}</translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}, or several with commas</source>
        <translation>un nombre entier de {0} à {1}, ou plusieurs avec des virgules</translation>
    </message>
    <message>
        <source>a whole number from {0} to {1}</source>
        <translation>un nombre entier de {0} à {1}</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a text, or several with commas</source>
        <translation>un texte, ou plusieurs avec des virgules</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>un fichier</translation>
    </message>
    <message>
        <source>one of {0}, or several with commas</source>
        <translation>l&apos;un de {0}, ou plusieurs avec des virgules</translation>
    </message>
    <message>
        <source>one of {0}</source>
        <translation>l&apos;un de {0}</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>oui ou non</translation>
    </message>
    <message>
        <source>turn the sensor about another body axis, or in a field of another magnitude</source>
        <translation>tournez le capteur autour d&apos;un autre axe du corps, ou dans un champ d&apos;un autre module</translation>
    </message>
    <message>
        <source>the magnitudes do not determine all nine parameters: {0}</source>
        <translation>les modules ne déterminent pas les neuf paramètres&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the magnitudes do not determine all parameters: {0}</source>
        <translation>les modules ne déterminent pas tous les paramètres&#xa0;: {0}</translation>
    </message>
    <message>
        <source>I + E is not positive definite, so no real scale factors belong to it: {0}</source>
        <translation>I + E n&apos;est pas définie positive, donc aucun facteur d&apos;échelle réel n&apos;y correspond&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} rows have both a reading and a reference magnitude; nine parameters need ten</source>
        <translation>{0} lignes ont une lecture et un module de référence&#xa0;; neuf paramètres en demandent dix</translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT: {1}</source>
        <translation>le champ serait incertain de {0} nT&#xa0;: {1}</translation>
    </message>
    <message>
        <source>the field would be uncertain by {0} nT</source>
        <translation>le champ serait incertain de {0} nT</translation>
    </message>
    <message>
        <source>Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {0}</source>
        <translation>Gauss-Newton ne se stabilise pas, donc les modules déterminent à peine les paramètres&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the current {0} never changes, so its offset is part of the bias: leave it out</source>
        <translation>le courant {0} ne change jamais, son décalage fait donc partie du biais&#xa0;: omettez-le</translation>
    </message>
    <message>
        <source>the currents {0} are linearly dependent: leave one of them out</source>
        <translation>les courants {0} sont linéairement dépendants&#xa0;: omettez-en un</translation>
    </message>
    <message>
        <source>run {0} has no channel {1}; it has {2}</source>
        <translation>la mesure {0} n&apos;a pas de voie {1}&#xa0;; elle a {2}</translation>
    </message>
    <message>
        <source>channel {0} is no current of the DUT, which is what `telemetry` takes</source>
        <translation>la voie {0} n&apos;est pas un courant du DUT&#xa0;; c&apos;est ce que prend `telemetry`</translation>
    </message>
    <message>
        <source>the filter&apos;s covariance is no longer positive definite</source>
        <translation>la covariance du filtre n&apos;est plus définie positive</translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie {0} times farther from what it expects than the noise of the first ones allows</source>
        <translation>le filtre a divergé, ou le capteur a changé&#xa0;: les lectures sont {0} fois plus loin de ce qu&apos;il attend que le bruit des premières ne le permet</translation>
    </message>
    <message>
        <source>the filter has diverged, or the sensor has changed: readings lie beyond all bounds farther from what it expects than the noise of the first ones allows</source>
        <translation>le filtre a divergé, ou le capteur a changé&#xa0;: les lectures sont au-delà de toute borne plus loin de ce qu&apos;il attend que le bruit des premières ne le permet</translation>
    </message>
    <message>
        <source>{0} readings with a magnitude; a start needs {1}</source>
        <translation>{0} lectures avec un module&#xa0;; un départ en demande {1}</translation>
    </message>
    <message>
        <source>the run is too short for {0} to begin</source>
        <translation>la mesure est trop courte pour que {0} commence</translation>
    </message>
    <message>
        <source>the numbers broke down: {0}</source>
        <translation>les nombres ont lâché&#xa0;: {0}</translation>
    </message>
    <message>
        <source>no row has both a reading and a reference</source>
        <translation>aucune ligne n&apos;a à la fois une lecture et une référence</translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: 1 rotation axis in {1} segments; rotate about another body axis</source>
        <translation>la mesure détermine {0} paramètres sur 12&#xa0;: 1 axe de rotation dans {1} segments&#xa0;; tournez autour d&apos;un autre axe du corps</translation>
    </message>
    <message>
        <source>the run determines {0} of 12 parameters: {1} rotation axes in {2} segments; rotate about another body axis</source>
        <translation>la mesure détermine {0} paramètres sur 12&#xa0;: {1} axes de rotation dans {2} segments&#xa0;; tournez autour d&apos;un autre axe du corps</translation>
    </message>
    <message>
        <source>the run does not determine the parameters: the normal equations are singular</source>
        <translation>la mesure ne détermine pas les paramètres&#xa0;: les équations normales sont singulières</translation>
    </message>
    <message>
        <source>the run does not determine the parameters: {0}; add longer arcs, another axis or another magnitude</source>
        <translation>la mesure ne détermine pas les paramètres&#xa0;: {0}&#xa0;; ajoutez des arcs plus longs, un autre axe ou un autre module</translation>
    </message>
    <message>
        <source>the likelihood has no clear summit</source>
        <translation>la vraisemblance n&apos;a pas de sommet net</translation>
    </message>
    <message>
        <source>rotation segment {0} of {1} does not turn about its declared axis_body: at least {2} deg from it</source>
        <translation>le segment de rotation {0} sur {1} ne tourne pas autour de son axis_body déclaré&#xa0;: à au moins {2} deg</translation>
    </message>
    <message>
        <source>there is no rotation segment that states its axis_body; rotate about known body axes</source>
        <translation>aucun segment de rotation n&apos;indique son axis_body&#xa0;; tournez autour d&apos;axes connus du corps</translation>
    </message>
    <message>
        <source>the magnitudes determine {0} of 9 parameters; rotate about another axis or use another magnitude</source>
        <translation>les modules déterminent {0} paramètres sur 9&#xa0;; tournez autour d&apos;un autre axe ou prenez un autre module</translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2} and {3} more: {4}</source>
        <translation>la mesure détermine {0} paramètres sur {1}, pas {2} ni {3} autres&#xa0;: {4}</translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2} and {3} more: {4}</source>
        <translation>la mesure ne détermine que {0} combinaisons des {1} paramètres&#xa0;; restent ouverts {2} et {3} autres&#xa0;: {4}</translation>
    </message>
    <message>
        <source>the run determines only {0} combinations of the {1} parameters; open are {2}: {3}</source>
        <translation>la mesure ne détermine que {0} combinaisons des {1} paramètres&#xa0;; restent ouverts {2}&#xa0;: {3}</translation>
    </message>
    <message>
        <source>the run determines {0} of {1} parameters, not {2}: {3}</source>
        <translation>la mesure détermine {0} paramètres sur {1}, pas {2}&#xa0;: {3}</translation>
    </message>
    <message>
        <source>add a rotation about another body axis, or a field at another angle to the axis</source>
        <translation>ajoutez une rotation autour d&apos;un autre axe du corps, ou un champ sous un autre angle de l&apos;axe</translation>
    </message>
    <message>
        <source>add a rotation about another body axis or a field of another magnitude</source>
        <translation>ajoutez une rotation autour d&apos;un autre axe du corps ou un champ d&apos;un autre module</translation>
    </message>
    <message>
        <source>the readings lie close to one plane; turn the sensor about another body axis as well</source>
        <translation>les lectures sont proches d&apos;un plan&#xa0;; tournez aussi le capteur autour d&apos;un autre axe du corps</translation>
    </message>
    <message>
        <source>quite another map fits as well</source>
        <translation>une tout autre application convient aussi</translation>
    </message>
    <message>
        <source>its reference leaves the rotation of the map open</source>
        <translation>sa référence laisse ouverte la rotation de l&apos;application</translation>
    </message>
    <message>
        <source>there is no reference, so the scale is open: a field of known magnitude is needed</source>
        <translation>il n&apos;y a pas de référence, l&apos;échelle est donc ouverte&#xa0;: il faut un champ de module connu</translation>
    </message>
    <message>
        <source>{0} usable rows give {1} numbers; the map needs more than {2}</source>
        <translation>{0} lignes utilisables donnent {1} nombres&#xa0;; l&apos;application en demande plus de {2}</translation>
    </message>
    <message>
        <source>the reference is zero throughout</source>
        <translation>la référence est nulle partout</translation>
    </message>
    <message>
        <source>no map comes near these readings: they do not follow the reference at all</source>
        <translation>aucune application n&apos;approche ces lectures&#xa0;: elles ne suivent pas du tout la référence</translation>
    </message>
    <message>
        <source>{0} never changes: nothing determines its scale; turn the sensor or look at the axis</source>
        <translation>{0} ne change jamais&#xa0;: rien ne détermine son échelle&#xa0;; tournez le capteur ou regardez l&apos;axe</translation>
    </message>
    <message>
        <source>the normal equations are not finite</source>
        <translation>les équations normales ne sont pas finies</translation>
    </message>
    <message>
        <source>method {0} gives no calibration of run {1}: {2}</source>
        <translation>la méthode {0} ne donne pas d&apos;étalonnage de la mesure {1}&#xa0;: {2}</translation>
    </message>
    <message>
        <source>run {0} has no reference: there is no residual to explain</source>
        <translation>la mesure {0} n&apos;a pas de référence&#xa0;: il n&apos;y a pas de résidu à expliquer</translation>
    </message>
    <message>
        <source>run {0} has {1} rows with a reading and a reference; {2} are needed</source>
        <translation>la mesure {0} a {1} lignes avec une lecture et une référence&#xa0;; il en faut {2}</translation>
    </message>
    <message>
        <source>run {0} does not even determine an offset: {1}</source>
        <translation>la mesure {0} ne détermine même pas un décalage&#xa0;: {1}</translation>
    </message>
    <message>
        <source>noise of the run, through the fit</source>
        <translation>bruit de la mesure, à travers l&apos;ajustement</translation>
    </message>
    <message>
        <source>noise of one reading</source>
        <translation>bruit d&apos;une lecture</translation>
    </message>
    <message>
        <source>structure that held-out residuals keep</source>
        <translation>structure que gardent les résidus mis de côté</translation>
    </message>
    <message>
        <source>reference scale</source>
        <translation>échelle de la référence</translation>
    </message>
    <message>
        <source>reference zero {0}</source>
        <translation>zéro de la référence {0}</translation>
    </message>
    <message>
        <source>reference zero</source>
        <translation>zéro de la référence</translation>
    </message>
    <message>
        <source>reference alignment about {0}</source>
        <translation>alignement de la référence autour de {0}</translation>
    </message>
    <message>
        <source>alignment about {0}</source>
        <translation>alignement autour de {0}</translation>
    </message>
    <message>
        <source>rotation axes in the body about {0}</source>
        <translation>axes de rotation dans le corps autour de {0}</translation>
    </message>
    <message>
        <source>rotation axes in the cage about {0}</source>
        <translation>axes de rotation dans la cage autour de {0}</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale</source>
        <translation>température de la référence, échelle</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero {0}</source>
        <translation>température de la référence, zéro {0}</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero</source>
        <translation>température de la référence, zéro</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate {0}</source>
        <translation>dérive de la référence depuis son certificat {0}</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate</source>
        <translation>dérive de la référence depuis son certificat</translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance {0}</source>
        <translation>gradient des bobines sur la distance {0}</translation>
    </message>
    <message>
        <source>gradient over the distance {0}</source>
        <translation>gradient sur la distance {0}</translation>
    </message>
    <message>
        <source>gradient over the distance</source>
        <translation>gradient sur la distance</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>zero reading {0}</source>
        <translation>lecture à zéro {0}</translation>
    </message>
    <message>
        <source>off 90° {0}</source>
        <translation>écart à 90° {0}</translation>
    </message>
    <message>
        <source>{0} µT along {1}, {2}</source>
        <translation>{0} µT selon {1}, {2}</translation>
    </message>
    <message>
        <source>{0} µT along {1}</source>
        <translation>{0} µT selon {1}</translation>
    </message>
    <message>
        <source>{0} to {1} nT held out (noise alone: {2} nT)</source>
        <translation>{0} à {1} nT mis de côté (bruit seul&#xa0;: {2} nT)</translation>
    </message>
    <message>
        <source>The base model reaches the noise beside what the run declares of its reference and mounting: {0}.</source>
        <translation>Le modèle de base atteint le bruit, à côté de ce que la mesure déclare de sa référence et de son montage&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>The base model reaches the noise: {0}.</source>
        <translation>Le modèle de base atteint le bruit&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>{0} explains part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation>{0} explique une partie du résidu, {1} % de son carré au-dessus du bruit&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>{0} explain part of the residual, {1} % of its square above the noise: {2}.</source>
        <translation>{0} expliquent une partie du résidu, {1} % de son carré au-dessus du bruit&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>{0} explains part of the residual: {1}.</source>
        <translation>{0} explique une partie du résidu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} explain part of the residual: {1}.</source>
        <translation>{0} expliquent une partie du résidu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation>{0} explique le résidu&#xa0;: {1}&#xa0;; mais d&apos;une mesure dont plus de {2} % des lignes sont écartées comme aberrantes, rien n&apos;est dit expliqué.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but of a run with more than {2} % of its rows set aside as outliers nothing is called explained.</source>
        <translation>{0} expliquent le résidu&#xa0;: {1}&#xa0;; mais d&apos;une mesure dont plus de {2} % des lignes sont écartées comme aberrantes, rien n&apos;est dit expliqué.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} does as well on this run.</source>
        <translation>{0} explique le résidu&#xa0;: {1}&#xa0;; mais {2} fait aussi bien sur cette mesure.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} does as well on this run.</source>
        <translation>{0} expliquent le résidu&#xa0;: {1}&#xa0;; mais {2} fait aussi bien sur cette mesure.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}; but {2} do as well on this run.</source>
        <translation>{0} explique le résidu&#xa0;: {1}&#xa0;; mais {2} font aussi bien sur cette mesure.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}; but {2} do as well on this run.</source>
        <translation>{0} expliquent le résidu&#xa0;: {1}&#xa0;; mais {2} font aussi bien sur cette mesure.</translation>
    </message>
    <message>
        <source>{0} explains the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation>{0} explique le résidu, à côté de ce que la mesure déclare de sa référence et de son montage&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} explain the residual beside what the run declares of its reference and mounting: {1}.</source>
        <translation>{0} expliquent le résidu, à côté de ce que la mesure déclare de sa référence et de son montage&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} explains the residual: {1}.</source>
        <translation>{0} explique le résidu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>{0} explain the residual: {1}.</source>
        <translation>{0} expliquent le résidu&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>There is structure that no known effect carries: {0}.</source>
        <translation>Il y a une structure qu&apos;aucun effet connu ne porte&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Beside the rows set aside there is structure that no known effect carries: {0}.</source>
        <translation>À côté des lignes écartées, il y a une structure qu&apos;aucun effet connu ne porte&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>This cause has no name: it is an empirical term, and holds only where it has been seen.</source>
        <translation>Cette cause n&apos;a pas de nom&#xa0;: c&apos;est un terme empirique, qui ne vaut que là où on l&apos;a vu.</translation>
    </message>
    <message>
        <source>a function of {0}</source>
        <translation>une fonction de {0}</translation>
    </message>
    <message>
        <source>Rows set aside</source>
        <translation>Les lignes écartées</translation>
    </message>
    <message>
        <source>{0} row set aside as {1}</source>
        <translation>{0} ligne écartée comme {1}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} row set aside as {3}</source>
        <translation>{0} lignes écartées comme {1}, {2} ligne comme {3}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}, {2} rows set aside as {3}</source>
        <translation>{0} lignes écartées comme {1}, {2} comme {3}</translation>
    </message>
    <message>
        <source>{0} rows set aside as {1}</source>
        <translation>{0} lignes écartées comme {1}</translation>
    </message>
    <message>
        <source>{0} rows ({1} %) set aside</source>
        <translation>{0} lignes ({1} %) écartées</translation>
    </message>
    <message>
        <source>outliers</source>
        <translation>valeurs aberrantes</translation>
    </message>
    <message>
        <source>saturation</source>
        <translation>saturation</translation>
    </message>
    <message>
        <source>No effect was searched in such data.</source>
        <translation>Aucun effet n&apos;a été cherché dans de telles données.</translation>
    </message>
    <message>
        <source>with the others of {0} in, the held-out rms falls from {1} to {2} nT</source>
        <translation>avec les autres de {0}, le rms mis de côté tombe de {1} à {2} nT</translation>
    </message>
    <message>
        <source>the held-out rms falls from {0} to {1} nT</source>
        <translation>le rms mis de côté tombe de {0} à {1} nT</translation>
    </message>
    <message>
        <source>with the others of {0} in, it alone takes {1} nT off the held-out rms beside declared errors</source>
        <translation>avec les autres de {0}, elle seule ôte {1} nT du rms mis de côté, à part les erreurs déclarées</translation>
    </message>
    <message>
        <source>it alone takes {0} nT off the held-out rms beside declared errors</source>
        <translation>elle seule ôte {0} nT du rms mis de côté, à part les erreurs déclarées</translation>
    </message>
    <message>
        <source>evidence over a slow wander without a name: {0}</source>
        <translation>évidence face à une lente dérive sans nom&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} nats, {1} needed</source>
        <translation>{0} nats, {1} nécessaires</translation>
    </message>
    <message>
        <source>no better than chance or a slow wander: evidence {0}</source>
        <translation>pas mieux que le hasard ou une lente dérive&#xa0;: évidence {0}</translation>
    </message>
    <message>
        <source>too little evidence: {0}</source>
        <translation>trop peu d&apos;évidence&#xa0;: {0}</translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual: not worth its parameters</source>
        <translation>ôte au résidu {0} fois le carré du bruit&#xa0;: ne vaut pas ses paramètres</translation>
    </message>
    <message>
        <source>takes {0} times the noise&apos;s square off the residual in sample, but other forms of what is accepted take as much</source>
        <translation>ôte au résidu, dans l&apos;échantillon, {0} fois le carré du bruit, mais d&apos;autres formes de ce qui est retenu en ôtent autant</translation>
    </message>
    <message>
        <source>taken to first order ({0} to {1} nT held out), and given up: fitted in full, map and effects together leave {2} nT</source>
        <translation>pris au premier ordre ({0} à {1} nT mis de côté), puis abandonné&#xa0;: ajustés en entier, application et effets laissent ensemble {2} nT</translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it would be more than half of the field, and the others would undo it</source>
        <translation>pris ({0} à {1} nT mis de côté), puis abandonné&#xa0;: ce serait plus de la moitié du champ, et les autres l&apos;annuleraient</translation>
    </message>
    <message>
        <source>taken ({0} to {1} nT held out), and given up: it is no larger than its uncertainty, declared errors included; what is not there would seem as large in {2} % of runs</source>
        <translation>pris ({0} à {1} nT mis de côté), puis abandonné&#xa0;: il n&apos;est pas plus grand que son incertitude, erreurs déclarées comprises&#xa0;; ce qui n&apos;existe pas paraîtrait aussi grand dans {2} % des mesures</translation>
    </message>
    <message>
        <source>does as well as {0} in its place ({1} nT held out): a rival, neither is sure</source>
        <translation>fait aussi bien que {0} à sa place ({1} nT mis de côté)&#xa0;: un rival, aucun n&apos;est sûr</translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, a gain of {2} to {3} nT that may be none</source>
        <translation>pris, puis abandonné sur les blocs mis de côté&#xa0;: {0} à {1} nT, un gain de {2} à {3} nT qui peut être nul</translation>
    </message>
    <message>
        <source>taken, and given up on held-out blocks: {0} to {1} nT, but it is a detail beside others, or too much is left for its name to be sure</source>
        <translation>pris, puis abandonné sur les blocs mis de côté&#xa0;: {0} à {1} nT, mais c&apos;est un détail à côté d&apos;autres, ou il reste trop pour que son nom soit sûr</translation>
    </message>
    <message>
        <source>What is left is more than noise, though no single test (white in each segment, independent of every channel, of field, angle and time) finds of what shape.</source>
        <translation>Ce qui reste est plus que du bruit, mais aucun test seul (blanc dans chaque segment, indépendant de chaque voie, du champ, de l&apos;angle et du temps) n&apos;en trouve la forme.</translation>
    </message>
    <message>
        <source>What is left shows no material structure: white in each segment, independent of every channel, of field, angle and time.</source>
        <translation>Ce qui reste ne montre aucune structure notable&#xa0;: blanc dans chaque segment, indépendant de chaque voie, du champ, de l&apos;angle et du temps.</translation>
    </message>
    <message>
        <source>What is left: {0}</source>
        <translation>Ce qui reste&#xa0;: {0}</translation>
    </message>
    <message>
        <source>What is left {0}.</source>
        <translation>Ce qui reste {0}.</translation>
    </message>
    <message>
        <source>{0} more tests fail</source>
        <translation>{0} autres tests échouent</translation>
    </message>
    <message>
        <source>follows itself from row to row, most in segment {0}</source>
        <translation>se suit lui-même de ligne en ligne, surtout dans le segment {0}</translation>
    </message>
    <message>
        <source>goes with time (correlation {0})</source>
        <translation>va avec le temps (corrélation {0})</translation>
    </message>
    <message>
        <source>goes with {0} (correlation {1})</source>
        <translation>va avec {0} (corrélation {1})</translation>
    </message>
    <message>
        <source>comes again wherever the field is the same ({0} % of its square)</source>
        <translation>revient partout où le champ est le même ({0} % de son carré)</translation>
    </message>
    <message>
        <source>the field along {0}</source>
        <translation>le champ selon {0}</translation>
    </message>
    <message>
        <source>the field&apos;s magnitude</source>
        <translation>le module du champ</translation>
    </message>
    <message>
        <source>the angle&apos;s sine</source>
        <translation>le sinus de l&apos;angle</translation>
    </message>
    <message>
        <source>the angle&apos;s cosine</source>
        <translation>le cosinus de l&apos;angle</translation>
    </message>
    <message>
        <source>a line with a period of {0} s, on {1}</source>
        <translation>une raie de période {0} s, sur {1}</translation>
    </message>
    <message>
        <source>a step at t = {0} s, on {1}</source>
        <translation>un saut à t = {0} s, sur {1}</translation>
    </message>
    <message>
        <source>two levels with {0} changes between them, each kept for about {1} s (telegraph-like), on {2}</source>
        <translation>deux niveaux avec {0} passages de l&apos;un à l&apos;autre, chacun tenu environ {1} s (comme un télégraphe), sur {2}</translation>
    </message>
    <message>
        <source>a wander like a random walk, on {0}</source>
        <translation>une dérive comme une marche aléatoire, sur {0}</translation>
    </message>
    <message>
        <source>a wander that remembers itself for about {0} s, on {1}</source>
        <translation>une dérive qui se souvient d&apos;elle-même environ {0} s, sur {1}</translation>
    </message>
    <message>
        <source>more noise than is stated, without memory from row to row, on {0}</source>
        <translation>plus de bruit qu&apos;indiqué, sans mémoire de ligne en ligne, sur {0}</translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT, mostly at angles of {2} to {3}°</source>
        <translation>surtout dans des champs de {0} à {1} µT, surtout aux angles de {2} à {3}°</translation>
    </message>
    <message>
        <source>mostly in fields of {0} to {1} µT</source>
        <translation>surtout dans des champs de {0} à {1} µT</translation>
    </message>
    <message>
        <source>mostly at angles of {0} to {1}°</source>
        <translation>surtout aux angles de {0} à {1}°</translation>
    </message>
    <message>
        <source>the magnitude</source>
        <translation>le module</translation>
    </message>
    <message>
        <source>all axes</source>
        <translation>tous les axes</translation>
    </message>
    <message>
        <source>axis {0}</source>
        <translation>l&apos;axe {0}</translation>
    </message>
    <message>
        <source>axes {0}</source>
        <translation>les axes {0}</translation>
    </message>
    <message>
        <source>The selection ended without a set of effects that held-out data support whole; what its last round left stands.</source>
        <translation>La sélection s&apos;est terminée sans groupe d&apos;effets que les données mises de côté soutiennent en entier&#xa0;; ce que son dernier tour a laissé demeure.</translation>
    </message>
    <message>
        <source>k is the offset at {0}.</source>
        <translation>k est le décalage à {0}.</translation>
    </message>
    <message>
        <source>In another recording {0} begins {1} nT astray (one standard deviation) until the field has wiped that out: the held-out error does not hold it, u_nT does.</source>
        <translation>Dans un autre enregistrement, {0} commence à {1} nT d&apos;écart (un écart-type) jusqu&apos;à ce que le champ l&apos;ait effacé&#xa0;: l&apos;erreur mise de côté ne le contient pas, u_nT si.</translation>
    </message>
    <message>
        <source>{0}: what K and k take as well</source>
        <translation>{0}&#xa0;: ce que K et k prennent aussi</translation>
    </message>
    <message>
        <source>{0} in place of {1}: another map</source>
        <translation>{0} au lieu de {1}&#xa0;: une autre transformation</translation>
    </message>
    <message>
        <source>What is left is within what the run declares: {0}.</source>
        <translation>Ce qui reste est dans ce que la mesure déclare&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>What is left has the shape of what the run declares, and is larger: {0}.</source>
        <translation>Ce qui reste a la forme de ce que la mesure déclare, en plus grand&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>{0} nT held out, {1} beside it (noise alone: {2} nT)</source>
        <translation>{0} nT mis de côté, {1} à côté (bruit seul&#xa0;: {2} nT)</translation>
    </message>
    <message>
        <source>Likeliest: {0}.</source>
        <translation>Le plus probable&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Decided by other judgements than labcal&apos;s own: {0}.</source>
        <translation>Décidé selon d&apos;autres critères que ceux de labcal&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs.</source>
        <translation>Les erreurs déclarées laissent autant ou plus dans {0} % des mesures.</translation>
    </message>
    <message>
        <source>Declared errors leave as much or more in {0} % of runs: check these, or declare them as large as they are.</source>
        <translation>Les erreurs déclarées laissent autant ou plus dans {0} % des mesures&#xa0;: vérifiez-les, ou déclarez-les aussi grandes qu&apos;elles sont.</translation>
    </message>
    <message>
        <source>reference scale ({0}) {1} nT</source>
        <translation>échelle de la référence ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference zero ({0}) {1} nT</source>
        <translation>zéro de la référence ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference alignment ({0}) {1} nT</source>
        <translation>alignement de la référence ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, scale ({0}) {1} nT</source>
        <translation>température de la référence, échelle ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s temperature, zero ({0}) {1} nT</source>
        <translation>température de la référence, zéro ({0}) {1} nT</translation>
    </message>
    <message>
        <source>reference&apos;s drift since its certificate ({0}) {1} nT</source>
        <translation>dérive de la référence depuis son certificat ({0}) {1} nT</translation>
    </message>
    <message>
        <source>coils&apos; gradient over the distance ({0}) {1} nT</source>
        <translation>gradient des bobines sur la distance ({0}) {1} nT</translation>
    </message>
    <message>
        <source>gradient over the distance ({0}) {1} nT</source>
        <translation>gradient sur la distance ({0}) {1} nT</translation>
    </message>
    <message>
        <source>rotation axes in the cage ({0}) {1} nT</source>
        <translation>axes de rotation dans la cage ({0}) {1} nT</translation>
    </message>
    <message>
        <source>rotation axes in the body ({0}) {1} nT</source>
        <translation>axes de rotation dans le corps ({0}) {1} nT</translation>
    </message>
    <message>
        <source>time ({0}) {1} nT</source>
        <translation>temps ({0}) {1} nT</translation>
    </message>
    <message>
        <source>The noise, whose level is not stated, follows itself for about {0} s and goes with nothing that is recorded: {1} nT.</source>
        <translation>Le bruit, dont le niveau n&apos;est pas indiqué, se suit environ {0} s et ne va avec rien d&apos;enregistré&#xa0;: {1} nT.</translation>
    </message>
    <message>
        <source>State the device&apos;s noise, measured at rest, to be sure.</source>
        <translation>Pour être sûr, indiquez le bruit du DUT, mesuré au repos.</translation>
    </message>
    <message>
        <source>The noise measured at rest is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation>Le bruit mesuré au repos est {0} fois celui déclaré&#xa0;: le plancher de {1} nT auquel les résultats sont comparés peut être faux.</translation>
    </message>
    <message>
        <source>The noise measured from row to row is {0} times the declared one: the floor of {1} nT that results are compared with may be wrong.</source>
        <translation>Le bruit mesuré de ligne en ligne est {0} fois celui déclaré&#xa0;: le plancher de {1} nT auquel les résultats sont comparés peut être faux.</translation>
    </message>
    <message>
        <source>Channels with {0}: {1}. They can show no cause.</source>
        <translation>Voies avec {0}&#xa0;: {1}. Elles ne peuvent montrer aucune cause.</translation>
    </message>
    <message>
        <source>no value in this run</source>
        <translation>aucune valeur dans cette mesure</translation>
    </message>
    <message>
        <source>one value all through this run</source>
        <translation>une seule valeur dans toute la mesure</translation>
    </message>
    <message>
        <source>no value, nor a sure one between two others, in most rows</source>
        <translation>aucune valeur, ni une sûre entre deux autres, dans la plupart des lignes</translation>
    </message>
    <message>
        <source>Channels {0} and {1} are one signal: no fit tells which is the cause.</source>
        <translation>Les voies {0} et {1} sont un seul signal&#xa0;: aucun ajustement ne dit laquelle est la cause.</translation>
    </message>
    <message>
        <source>The correction {0} is uncertain by {1} nT at {2}: the run did not go there.</source>
        <translation>La correction {0} est incertaine de {1} nT à {2}&#xa0;: la mesure n&apos;y est pas allée.</translation>
    </message>
    <message>
        <source>{0} in {1} µT along {2}</source>
        <translation>{0} dans {1} µT selon {2}</translation>
    </message>
    <message>
        <source>{0} in {1} µT across the axes</source>
        <translation>{0} dans {1} µT en travers des axes</translation>
    </message>
    <message>
        <source>It is not written into the calibration.</source>
        <translation>Elle n&apos;est pas écrite dans l&apos;étalonnage.</translation>
    </message>
    <message>
        <source>Missing: large fields along every axis at both ends of {0}.</source>
        <translation>Il manque&#xa0;: de grands champs selon chaque axe aux deux bouts de {0}.</translation>
    </message>
    <message>
        <source>Missing: both ends of {0} for long enough.</source>
        <translation>Il manque&#xa0;: les deux bouts de {0}, assez longtemps.</translation>
    </message>
    <message>
        <source>Of {0}, {1} are, one by one, not pinned down by this run (value below U, k = 2).</source>
        <translation>De {0}, {1} ne sont pas, un à un, fixés par cette mesure (valeur sous U, k = 2).</translation>
    </message>
    <message>
        <source>Of {0}, {1} is not pinned down by this run (value below U, k = 2).</source>
        <translation>De {0}, {1} n&apos;est pas fixé par cette mesure (valeur sous U, k = 2).</translation>
    </message>
    <message>
        <source>The reading along {0} is the same in every row.</source>
        <translation>La lecture selon {0} est la même dans chaque ligne.</translation>
    </message>
    <message>
        <source>The readings come to {0} nT, the reference to {1} nT: the unit or nominal_nT_per_unit of one of them is not as declared.</source>
        <translation>Les lectures sont de {0} nT, la référence de {1} nT&#xa0;: l&apos;unité ou nominal_nT_per_unit de l&apos;un n&apos;est pas comme déclaré.</translation>
    </message>
    <message>
        <source>This run does not determine the whole map ({0} alone): too few axes or fields are excited; a whole map would leave {1} instead of {2} nT, and be anyone&apos;s guess.</source>
        <translation>Cette mesure ne détermine pas toute l&apos;application ({0} seulement)&#xa0;: trop peu d&apos;axes ou de champs sont excités&#xa0;; une application entière laisserait {1} au lieu de {2} nT, et serait devinée.</translation>
    </message>
    <message>
        <source>Turn about the other body axes too.</source>
        <translation>Tournez aussi autour des autres axes du corps.</translation>
    </message>
    <message>
        <source>The fitted map mirrors the axes ({0}): an axis of the device or of the reference is flipped or two are swapped.</source>
        <translation>L&apos;application ajustée reflète les axes ({0})&#xa0;: un axe du DUT ou de la référence est retourné, ou deux sont échangés.</translation>
    </message>
    <message>
        <source>The fitted map turns the axes ({0}): the mounting or the names of the axes are not as declared.</source>
        <translation>L&apos;application ajustée tourne les axes ({0})&#xa0;: le montage ou les noms des axes ne sont pas comme déclaré.</translation>
    </message>
    <message>
        <source>{0} is the device&apos;s {1}</source>
        <translation>{0} est le {1} du DUT</translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT ({3} fits as well).</source>
        <translation>La mesure s&apos;ajuste bien mieux {0}&#xa0;: le modèle de base laisse {1} au lieu de {2} nT ({3} va aussi).</translation>
    </message>
    <message>
        <source>The run fits far better {0}: the base model leaves {1} instead of {2} nT.</source>
        <translation>La mesure s&apos;ajuste bien mieux {0}&#xa0;: le modèle de base laisse {1} au lieu de {2} nT.</translation>
    </message>
    <message>
        <source>with the reference taken in the body&apos;s frame, not the cage&apos;s</source>
        <translation>avec la référence prise dans le repère du corps, non de la cage</translation>
    </message>
    <message>
        <source>with the reference taken in the cage&apos;s frame, not the body&apos;s</source>
        <translation>avec la référence prise dans le repère de la cage, non du corps</translation>
    </message>
    <message>
        <source>with the platform&apos;s angle counted the other way</source>
        <translation>avec l&apos;angle du plateau compté dans l&apos;autre sens</translation>
    </message>
    <message>
        <source>with the platform&apos;s angle taken in radians, not degrees</source>
        <translation>avec l&apos;angle du plateau pris en radians, non en degrés</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped and {2} flipped</source>
        <translation>avec {0} et {1} de la référence échangés et {2} retourné</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} and {1} swapped</source>
        <translation>avec {0} et {1} de la référence échangés</translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0} and {1} flipped</source>
        <translation>avec x, y, z de la référence lus comme {0} et {1} retourné</translation>
    </message>
    <message>
        <source>with the reference&apos;s x, y, z read as {0}</source>
        <translation>avec x, y, z de la référence lus comme {0}</translation>
    </message>
    <message>
        <source>with the reference&apos;s {0} flipped</source>
        <translation>avec {0} de la référence retourné</translation>
    </message>
    <message>
        <source>The clocks do not agree: {0}; put right, the base model leaves {1} instead of {2} nT.</source>
        <translation>Les horloges ne s&apos;accordent pas&#xa0;: {0}&#xa0;; corrigées, le modèle de base laisse {1} au lieu de {2} nT.</translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s late</source>
        <translation>les dates du DUT semblent en retard de {0} s</translation>
    </message>
    <message>
        <source>the stamps of the device under test seem {0} s early</source>
        <translation>les dates du DUT semblent en avance de {0} s</translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s late</source>
        <translation>les dates de la référence semblent en retard de {0} s</translation>
    </message>
    <message>
        <source>the stamps of the reference seem {0} s early</source>
        <translation>les dates de la référence semblent en avance de {0} s</translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s late</source>
        <translation>les dates de l&apos;angle du plateau semblent en retard de {0} s</translation>
    </message>
    <message>
        <source>the stamps of the platform&apos;s angle seem {0} s early</source>
        <translation>les dates de l&apos;angle du plateau semblent en avance de {0} s</translation>
    </message>
    <message>
        <source>The readings do not follow the reference: the base model leaves {0} of {1} nT, and no flip or exchange of axes and no offset of a clock explains it.</source>
        <translation>Les lectures ne suivent pas la référence&#xa0;: le modèle de base laisse {0} de {1} nT, et ni retournement ni échange d&apos;axes ni décalage d&apos;horloge ne l&apos;explique.</translation>
    </message>
    <message>
        <source>working the calibration out again: {0}</source>
        <translation>l&apos;étalonnage est recalculé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>fitting by {0}</source>
        <translation>ajustement par {0}</translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run, and nothing that this lab&apos;s procedures do would separate them by {1} standard deviations</source>
        <translation>{0} font aussi bien l&apos;un que l&apos;autre sur cette mesure, et rien de ce que font les procédures de ce laboratoire ne les séparerait de {1} écarts-types</translation>
    </message>
    <message>
        <source>{0} do as well as each other on this run; the experiment would bring them {1} standard deviations apart, as the fit predicts</source>
        <translation>{0} font aussi bien l&apos;un que l&apos;autre sur cette mesure&#xa0;; l&apos;essai les écarterait de {1} écarts-types, selon l&apos;ajustement</translation>
    </message>
    <message>
        <source>structure remains that no known effect carries: {0}</source>
        <translation>il reste une structure qu&apos;aucun effet connu ne porte&#xa0;: {0}</translation>
    </message>
    <message>
        <source>what is left has the shape of errors that the run declares of its reference and mounting, and is larger</source>
        <translation>ce qui reste a la forme d&apos;erreurs que la mesure déclare de sa référence et de son montage, en plus grand</translation>
    </message>
    <message>
        <source>compare the reference with a second one in two fields, mount the device anew, and repeat</source>
        <translation>comparez la référence à une seconde dans deux champs, remontez le DUT, et recommencez</translation>
    </message>
    <message>
        <source>more rows are set aside as outliers than a run may have that is called explained</source>
        <translation>plus de lignes sont écartées comme aberrantes que n&apos;en peut avoir une mesure dite expliquée</translation>
    </message>
    <message>
        <source>look at the link and its wiring, and repeat</source>
        <translation>regardez la liaison et son câblage, et recommencez</translation>
    </message>
    <message>
        <source>turn once forwards and once backwards: what stays at its angles belongs to the rig</source>
        <translation>tournez une fois en avant et une fois en arrière&#xa0;: ce qui reste à ses angles appartient au montage</translation>
    </message>
    <message>
        <source>step the field up and down along each axis: what grows with the field shows its shape</source>
        <translation>faites monter et descendre le champ par paliers selon chaque axe&#xa0;: ce qui croît avec le champ montre sa forme</translation>
    </message>
    <message>
        <source>record at rest with the coils off, then switch what runs at that period off one by one</source>
        <translation>enregistrez au repos, bobines coupées, puis arrêtez un à un ce qui marche à cette période</translation>
    </message>
    <message>
        <source>repeat the run unchanged and note what is switched: a step that does not come back was an event</source>
        <translation>répétez la mesure telle quelle et notez ce qui est commuté&#xa0;: un saut qui ne revient pas était un événement</translation>
    </message>
    <message>
        <source>switch every load and mode on and off at one attitude, and look for the two levels</source>
        <translation>allumez et coupez chaque charge et mode dans une attitude, et cherchez les deux niveaux</translation>
    </message>
    <message>
        <source>record for an hour at rest: a wander of the sensor goes on, one of the rig does not</source>
        <translation>enregistrez une heure au repos&#xa0;: une dérive du capteur continue, celle du montage non</translation>
    </message>
    <message>
        <source>turn at half and at twice the rate: what belongs to angle or field comes again</source>
        <translation>tournez à la moitié et au double de la vitesse&#xa0;: ce qui tient à l&apos;angle ou au champ revient</translation>
    </message>
    <message>
        <source>record at rest with the coils off: the noise that remains is the sensor&apos;s own</source>
        <translation>enregistrez au repos, bobines coupées&#xa0;: le bruit qui reste est celui du capteur</translation>
    </message>
    <message>
        <source>repeat with another reference</source>
        <translation>recommencez avec une autre référence</translation>
    </message>
    <message>
        <source>turn once forwards and once backwards in one mounting</source>
        <translation>tournez une fois en avant et une fois en arrière dans un même montage</translation>
    </message>
    <message>
        <source>turn at half and at twice the rate, there and back, in one mounting</source>
        <translation>tournez à la moitié et au double de la vitesse, aller et retour, dans un même montage</translation>
    </message>
    <message>
        <source>repeat the run unchanged</source>
        <translation>répétez la mesure telle quelle</translation>
    </message>
    <message>
        <source>step the field up and down along one axis</source>
        <translation>faites monter et descendre le champ par paliers selon un axe</translation>
    </message>
    <message>
        <source>turn in two more coil fields, a third and twice as large</source>
        <translation>tournez dans deux autres champs des bobines, un tiers et le double</translation>
    </message>
    <message>
        <source>switch every load on and off at one attitude</source>
        <translation>allumez et coupez chaque charge dans une attitude</translation>
    </message>
    <message>
        <source>warm the device and let it cool in two fields</source>
        <translation>chauffez le DUT et laissez-le refroidir dans deux champs</translation>
    </message>
    <message>
        <source>switch the power mode there and back at one attitude</source>
        <translation>changez le mode d&apos;alimentation, aller et retour, dans une attitude</translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat the first turns</source>
        <translation>déplacez le DUT de 5 cm et répétez les premiers tours</translation>
    </message>
    <message>
        <source>turn the reference by 180° and repeat the first turns</source>
        <translation>tournez la référence de 180° et répétez les premiers tours</translation>
    </message>
    <message>
        <source>put the reference at twice its distance and repeat the first turns</source>
        <translation>mettez la référence au double de sa distance et répétez les premiers tours</translation>
    </message>
    <message>
        <source>measure the bare platform&apos;s own field with the reference</source>
        <translation>mesurez le champ propre du plateau nu avec la référence</translation>
    </message>
    <message>
        <source>the run does not determine the whole map</source>
        <translation>la mesure ne détermine pas toute l&apos;application</translation>
    </message>
    <message>
        <source>turn about all three body axes, in two fields at least</source>
        <translation>tournez autour des trois axes du corps, dans deux champs au moins</translation>
    </message>
    <message>
        <source>an effect found in such data would be wrong</source>
        <translation>un effet trouvé dans de telles données serait faux</translation>
    </message>
    <message>
        <source>put the bundle or the wiring right, and close the loop again</source>
        <translation>corrigez les données ou le câblage, et cherchez de nouveau la cause</translation>
    </message>
    <message>
        <source>the cause has no name yet. {0}</source>
        <translation>la cause n&apos;a pas encore de nom. {0}</translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}.</source>
        <translation>En fonction de {0}, c&apos;est {1} autour de {2}&#xa0;: {3}.</translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}.</source>
        <translation>En fonction de {0}, c&apos;est {1}&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>Over {0} it is {1} about {2}: {3}</source>
        <translation>En fonction de {0}, c&apos;est {1} autour de {2}&#xa0;: {3}</translation>
    </message>
    <message>
        <source>Over {0} it is {1}: {2}</source>
        <translation>En fonction de {0}, c&apos;est {1}&#xa0;: {2}</translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do.</source>
        <translation>Il diffère au retour&#xa0;: quelque chose se souvient, comme le font le fer et les masses chaudes.</translation>
    </message>
    <message>
        <source>It differs on the way back: something remembers, as iron and warm masses do</source>
        <translation>Il diffère au retour&#xa0;: quelque chose se souvient, comme le font le fer et les masses chaudes</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>droit</translation>
    </message>
    <message>
        <source>quadratic</source>
        <translation>quadratique</translation>
    </message>
    <message>
        <source>saturating</source>
        <translation>saturant</translation>
    </message>
    <message>
        <source>resonant</source>
        <translation>résonant</translation>
    </message>
    <message>
        <source>a step</source>
        <translation>un saut</translation>
    </message>
    <message>
        <source>wavy</source>
        <translation>ondulé</translation>
    </message>
    <message>
        <source>a bent curve</source>
        <translation>une courbe pliée</translation>
    </message>
    <message>
        <source>a product</source>
        <translation>un produit</translation>
    </message>
    <message>
        <source>a map</source>
        <translation>une surface</translation>
    </message>
    <message>
        <source>a sensitivity to it that the library has no file for, or that follows another quantity</source>
        <translation>une sensibilité pour laquelle la bibliothèque n&apos;a pas de fichier, ou qui suit une autre grandeur</translation>
    </message>
    <message>
        <source>heating by a current, a magnet&apos;s force, or a straight effect on both sides of a null</source>
        <translation>l&apos;échauffement par un courant, la force d&apos;un aimant, ou un effet droit des deux côtés d&apos;un zéro</translation>
    </message>
    <message>
        <source>a core or an amplifier at its limit, or a magnetic part that saturates</source>
        <translation>un noyau ou un amplificateur à sa limite, ou une pièce magnétique qui sature</translation>
    </message>
    <message>
        <source>a mechanical or electrical resonance, or a filter&apos;s edge, at that value</source>
        <translation>une résonance mécanique ou électrique, ou le bord d&apos;un filtre, à cette valeur</translation>
    </message>
    <message>
        <source>a thermostat, a comparator or a changeover of range at that value</source>
        <translation>un thermostat, un comparateur ou un changement de gamme à cette valeur</translation>
    </message>
    <message>
        <source>interference, a converter&apos;s missing codes, or a beat with a clock</source>
        <translation>une interférence, des codes manquants d&apos;un convertisseur, ou un battement avec une horloge</translation>
    </message>
    <message>
        <source>a response of higher order; more range would show which</source>
        <translation>une réponse d&apos;ordre supérieur&#xa0;; plus d&apos;étendue montrerait laquelle</translation>
    </message>
    <message>
        <source>a sensitivity to one that the other changes, as a gain that follows a temperature</source>
        <translation>une sensibilité à l&apos;un que l&apos;autre change, comme un gain qui suit une température</translation>
    </message>
    <message>
        <source>two causes that act together</source>
        <translation>deux causes qui agissent ensemble</translation>
    </message>
    <message>
        <source>step the field up and down along each axis, through more than its range</source>
        <translation>faites monter et descendre le champ selon chaque axe, au-delà de son étendue</translation>
    </message>
    <message>
        <source>turn through many attitudes in one field, then in half of it</source>
        <translation>tournez par de nombreuses attitudes dans un champ, puis dans sa moitié</translation>
    </message>
    <message>
        <source>turn at several rates, forwards and backwards</source>
        <translation>tournez à plusieurs vitesses, en avant et en arrière</translation>
    </message>
    <message>
        <source>hold the attitude, warm the device and let it cool, over a wider range</source>
        <translation>tenez l&apos;attitude, chauffez le DUT et laissez-le refroidir, sur une plus grande étendue</translation>
    </message>
    <message>
        <source>hold the attitude and step the current up and down through its range</source>
        <translation>tenez l&apos;attitude et faites monter et descendre le courant dans son étendue</translation>
    </message>
    <message>
        <source>hold the attitude and move {0} up and down through more than its range, twice</source>
        <translation>tenez l&apos;attitude et faites monter et descendre {0} au-delà de son étendue, deux fois</translation>
    </message>
    <message>
        <source>hold {0} and {1}; then the other way round</source>
        <translation>fixez {0} et {1}&#xa0;; puis l&apos;inverse</translation>
    </message>
    <message>
        <source>mount the device turned by 180° about the platform axis and repeat</source>
        <translation>montez le DUT tourné de 180° autour de l&apos;axe du plateau et recommencez</translation>
    </message>
    <message>
        <source>repeat with the coils at zero, and with the reference turned by 180°</source>
        <translation>recommencez avec les bobines à zéro, et avec la référence tournée de 180°</translation>
    </message>
    <message>
        <source>hold the field along one axis and step it along another</source>
        <translation>tenez le champ selon un axe et changez-le par paliers selon un autre</translation>
    </message>
    <message>
        <source>repeat with the reference at twice the distance</source>
        <translation>recommencez avec la référence au double de la distance</translation>
    </message>
    <message>
        <source>hold all else and move its input up and down through its range, twice</source>
        <translation>tenez tout le reste et faites monter et descendre son entrée dans son étendue, deux fois</translation>
    </message>
    <message>
        <source>turn the device by 90° on the platform and repeat: what the platform reads wrong stays at its angles</source>
        <translation>tournez le DUT de 90° sur le plateau et recommencez&#xa0;: ce que le plateau lit mal reste à ses angles</translation>
    </message>
    <message>
        <source>move the device by 5 cm and repeat one segment</source>
        <translation>déplacez le DUT de 5 cm et répétez un segment</translation>
    </message>
    <message>
        <source>step the quantity that the channel measures in a large field and again in a small one</source>
        <translation>changez par paliers la grandeur que la voie mesure dans un grand champ, puis dans un petit</translation>
    </message>
    <message>
        <source>switch the device off and on, and repeat the segments before and after in the same field</source>
        <translation>coupez et rallumez le DUT, et répétez les segments d&apos;avant et d&apos;après dans le même champ</translation>
    </message>
    <message>
        <source>warm the sensor in a large field and again in a small one</source>
        <translation>chauffez le capteur dans un grand champ, puis dans un petit</translation>
    </message>
    <message>
        <source>step the field up and down through the same values, or turn backwards</source>
        <translation>faites monter et descendre le champ par les mêmes valeurs, ou tournez en arrière</translation>
    </message>
    <message>
        <source>turn faster, and backwards: a lag grows with the rate and changes sign with it</source>
        <translation>tournez plus vite, et en arrière&#xa0;: un retard croît avec la vitesse et change de signe avec elle</translation>
    </message>
    <message>
        <source>step the field along each axis through its whole range</source>
        <translation>faites varier le champ par paliers selon chaque axe dans toute son étendue</translation>
    </message>
    <message>
        <source>hold the attitude and step the quantity that the channel measures</source>
        <translation>tenez l&apos;attitude et changez par paliers la grandeur que la voie mesure</translation>
    </message>
    <message>
        <source>hold the attitude and switch the load that draws this current on and off</source>
        <translation>tenez l&apos;attitude et allumez puis coupez la charge qui tire ce courant</translation>
    </message>
    <message>
        <source>hold the attitude and draw three or more levels of this current</source>
        <translation>tenez l&apos;attitude et tirez trois niveaux ou plus de ce courant</translation>
    </message>
    <message>
        <source>repeat the first segment at the end, and again after a pause</source>
        <translation>répétez le premier segment à la fin, puis encore après une pause</translation>
    </message>
    <message>
        <source>hold the attitude and switch between the power modes</source>
        <translation>tenez l&apos;attitude et passez d&apos;un mode d&apos;alimentation à l&apos;autre</translation>
    </message>
    <message>
        <source>repeat the segments before and after the step</source>
        <translation>répétez les segments avant et après le saut</translation>
    </message>
    <message>
        <source>hold the attitude and warm the sensor, then let it cool</source>
        <translation>tenez l&apos;attitude et chauffez le capteur, puis laissez-le refroidir</translation>
    </message>
    <message>
        <source>record at rest, and again at another sampling rate: an alias moves</source>
        <translation>enregistrez au repos, puis à une autre cadence&#xa0;: un repliement se déplace</translation>
    </message>
    <message>
        <source>compare the reference with a second one before and after</source>
        <translation>comparez la référence à une seconde avant et après</translation>
    </message>
    <message>
        <source>warm the room with the device kept as it is, and compare the reference with a second one</source>
        <translation>chauffez la salle en gardant le DUT tel qu&apos;il est, et comparez la référence à une seconde</translation>
    </message>
    <message>
        <source>repeat the segment and look at the link</source>
        <translation>répétez le segment et regardez la liaison</translation>
    </message>
    <message>
        <source>repeat at half the field</source>
        <translation>recommencez à la moitié du champ</translation>
    </message>
    <message>
        <source>readings stop at the end of the range: {0}</source>
        <translation>les lectures s&apos;arrêtent au bout de l&apos;étendue&#xa0;: {0}</translation>
    </message>
    <message>
        <source>fitting the base model</source>
        <translation>ajustement du modèle de base</translation>
    </message>
    <message>
        <source>fitting the map with the effects that are named</source>
        <translation>ajustement de l&apos;application avec les effets nommés</translation>
    </message>
    <message>
        <source>scoring every effect</source>
        <translation>évaluation de chaque effet</translation>
    </message>
    <message>
        <source>scoring {0} beside {1}</source>
        <translation>évaluation&#xa0;: {0} à côté de {1}</translation>
    </message>
    <message>
        <source>scoring {0}</source>
        <translation>évaluation&#xa0;: {0}</translation>
    </message>
    <message>
        <source>every effect</source>
        <translation>chaque effet</translation>
    </message>
    <message>
        <source>all candidates</source>
        <translation>tous les candidats</translation>
    </message>
    <message>
        <source>delay scan</source>
        <translation>la recherche de retards</translation>
    </message>
    <message>
        <source>spectral lines</source>
        <translation>la recherche de raies</translation>
    </message>
    <message>
        <source>pairs that hide each other</source>
        <translation>les paires qui se cachent l&apos;une l&apos;autre</translation>
    </message>
    <message>
        <source>the selection on each part of the blocks</source>
        <translation>la sélection sur chaque partie des blocs</translation>
    </message>
    <message>
        <source>what does as well</source>
        <translation>ce qui fait aussi bien</translation>
    </message>
    <message>
        <source>this run takes about {0} s more and may be stopped</source>
        <translation>cette mesure demande encore environ {0} s et peut être arrêtée</translation>
    </message>
    <message>
        <source>holding out blocks of time</source>
        <translation>mise de côté de blocs de temps</translation>
    </message>
    <message>
        <source>so far nothing has the evidence of a name</source>
        <translation>jusqu&apos;ici rien n&apos;a l&apos;évidence d&apos;un nom</translation>
    </message>
    <message>
        <source>a cause is in sight, not proven yet: what is left over falls from {0} to {1} times the noise ({2})</source>
        <translation>une cause est en vue, pas encore prouvée&#xa0;: ce qui reste passe de {0} à {1} fois le bruit ({2})</translation>
    </message>
    <message>
        <source>stopped while {0}; {1}</source>
        <translation>arrêté&#xa0;: {0}&#xa0;; {1}</translation>
    </message>
    <message>
        <source>nothing is known yet</source>
        <translation>rien n&apos;est encore connu</translation>
    </message>
    <message>
        <source>offsets so far: not yet determined by the turns made</source>
        <translation>décalages jusqu&apos;ici&#xa0;: pas encore déterminés par les tours faits</translation>
    </message>
    <message>
        <source>offsets so far, from magnitudes alone: {0} nT (k = 2)</source>
        <translation>décalages jusqu&apos;ici, d&apos;après les seuls modules&#xa0;: {0} nT (k = 2)</translation>
    </message>
    <message>
        <source>offsets so far: the quick estimate of this procedure, from magnitudes alone, does not follow these readings; verdict and Fit do not rest on it</source>
        <translation>offsets jusqu’ici&#xa0;: l’estimation rapide de cette procédure, des seules normes, ne suit pas ces lectures&#xa0;; ni le verdict ni Ajuster ne reposent sur elle</translation>
    </message>
    <message>
        <source>offsets so far: {0}</source>
        <translation>décalages jusqu&apos;ici&#xa0;: {0}</translation>
    </message>
    <message>
        <source>axes, handedness and angle are as stated</source>
        <translation>axes, orientation et angle sont comme indiqué</translation>
    </message>
    <message>
        <source>the angle runs the wrong way round: turn angle_sign in bench.toml</source>
        <translation>l&apos;angle va dans le mauvais sens&#xa0;: changez angle_sign dans bench.toml</translation>
    </message>
    <message>
        <source>a turn by {0}° is seen by the DUT as {1}°</source>
        <translation>une rotation de {0}° est vue par le DUT comme {1}°</translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis shows {1}</source>
        <translation>DUT&#xa0;: l&apos;axe {0} montre {1}</translation>
    </message>
    <message>
        <source>the DUT&apos;s {0} axis points {1}° beside</source>
        <translation>DUT&#xa0;: l&apos;axe {0} pointe {1}° à côté</translation>
    </message>
    <message>
        <source>the DUT&apos;s axes are left-handed</source>
        <translation>DUT&#xa0;: les axes sont gauches</translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis shows {1}</source>
        <translation>référence&#xa0;: l&apos;axe {0} montre {1}</translation>
    </message>
    <message>
        <source>the reference&apos;s {0} axis points {1}° beside</source>
        <translation>référence&#xa0;: l&apos;axe {0} pointe {1}° à côté</translation>
    </message>
    <message>
        <source>the reference&apos;s axes are left-handed</source>
        <translation>référence&#xa0;: les axes sont gauches</translation>
    </message>
    <message>
        <source>{0}: {1} nT, within which the zero lies</source>
        <translation>{0}&#xa0;: {1} nT, dans lesquels se trouve le zéro</translation>
    </message>
    <message>
        <source>{0}: {1} nT is beyond {2} nT; something moved or drifted</source>
        <translation>{0}&#xa0;: {1} nT dépasse {2} nT&#xa0;; quelque chose a bougé ou dérivé</translation>
    </message>
    <message>
        <source>{0}: {1} is beyond its limit of {2}</source>
        <translation>{0}&#xa0;: {1} dépasse sa limite de {2}</translation>
    </message>
    <message>
        <source>{0}: not seen: {1}</source>
        <translation>{0}&#xa0;: non vu&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}</source>
        <translation>{0} se nomme {1}, et cette mesure est de {2}</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}. Measure it as {3} all the same?</source>
        <translation>{0} se nomme {1}, et cette mesure est de {2}. Le mesurer quand même comme {3}&#xa0;?</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and this run is of {2}: nothing was measured. Say which DUT it is, and begin anew.</source>
        <translation>{0} se nomme {1}, et cette mesure est de {2}&#xa0;: rien n&apos;a été mesuré. Dire de quel capteur il s&apos;agit, et recommencer.</translation>
    </message>
    <message>
        <source>{0} names itself {1}, and bench.toml states {2}</source>
        <translation>{0} se nomme {1}, et bench.toml indique {2}</translation>
    </message>
    <message>
        <source>{0} skipped: {1}</source>
        <translation>{0} omis&#xa0;: {1}</translation>
    </message>
    <message>
        <source>not used: {0}: {1}</source>
        <translation>non utilisé&#xa0;: {0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>{0}: it answers again</source>
        <translation>{0}&#xa0;: répond de nouveau</translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now; ambient field {2} nT before, {3} nT now</source>
        <translation>après le silence&#xa0;: plate-forme {0}° avant, {1}° maintenant&#xa0;; champ ambiant {2} nT avant, {3} nT maintenant</translation>
    </message>
    <message>
        <source>after the silence: platform {0}° before, {1}° now</source>
        <translation>après le silence&#xa0;: plate-forme {0}° avant, {1}° maintenant</translation>
    </message>
    <message>
        <source>after the silence: ambient field {0} nT before, {1} nT now</source>
        <translation>après le silence&#xa0;: champ ambiant {0} nT avant, {1} nT maintenant</translation>
    </message>
    <message>
        <source>the end of the run waits: {0}</source>
        <translation>la fin de la mesure attend&#xa0;: {0}</translation>
    </message>
    <message>
        <source>the run ends: {0}</source>
        <translation>la mesure se termine&#xa0;: {0}</translation>
    </message>
    <message>
        <source>goes on after an interruption</source>
        <translation>continue après une interruption</translation>
    </message>
    <message>
        <source>no turn was finished before the interruption: it begins anew, and nothing of before is used</source>
        <translation>aucune rotation n&apos;était terminée avant l&apos;interruption&#xa0;: on recommence, et rien d&apos;avant n&apos;est utilisé</translation>
    </message>
    <message>
        <source>turns kept from before the interruption: {0}; the zero, the axes and the timing are measured again: they tell whether anything moved or drifted since</source>
        <translation>rotations gardées d&apos;avant l&apos;interruption&#xa0;: {0}&#xa0;; le zéro, les axes et les temps sont mesurés encore&#xa0;: ils disent si quelque chose a bougé ou dérivé depuis</translation>
    </message>
    <message>
        <source>goes on</source>
        <translation>continue</translation>
    </message>
    <message>
        <source>coil {0} came to zero without a ramp</source>
        <translation>la bobine {0} est allée à zéro sans rampe</translation>
    </message>
    <message>
        <source>the room is fit for the job</source>
        <translation>la salle convient</translation>
    </message>
    <message>
        <source>the room is not fit for the job: {0}</source>
        <translation>la salle ne convient pas&#xa0;: {0}</translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT above what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation>ses {0} nT sont {1} nT au-dessus de ce que {2} attend dehors ({3} nT, U = {4} nT, k = 2)</translation>
    </message>
    <message>
        <source>its {0} nT are {1} nT below what {2} expects outdoors ({3} nT, U = {4} nT, k = 2)</source>
        <translation>ses {0} nT sont {1} nT en dessous de ce que {2} attend dehors ({3} nT, U = {4} nT, k = 2)</translation>
    </message>
    <message>
        <source>iron near by, or the reference&apos;s unit and scale</source>
        <translation>du fer à proximité, ou l&apos;unité et l&apos;échelle de la référence</translation>
    </message>
    <message>
        <source>of {0} no field is expected: WMM is here from {1} to {2}</source>
        <translation>pour {0} aucun champ n&apos;est attendu&#xa0;: WMM va ici de {1} à {2}</translation>
    </message>
    <message>
        <source>{0} Hz is not distinguishable from {1} at {2}/s</source>
        <translation>{0} Hz ne se distingue pas de {1} à {2}/s</translation>
    </message>
    <message>
        <source>a steady field</source>
        <translation>un champ constant</translation>
    </message>
    <message>
        <source>{0} Hz is seen as a steady field at {1} {2} samples/s</source>
        <translation>{0} Hz est vu comme un champ constant à {1} valeurs/s ({2})</translation>
    </message>
    <message>
        <source>{0} Hz falls on the rotation at {1} {2} samples/s</source>
        <translation>{0} Hz tombe sur la rotation à {1} valeurs/s ({2})</translation>
    </message>
    <message>
        <source>the reference&apos;s calibration of {0} is {1} days old, beyond {2}</source>
        <translation>l&apos;étalonnage de la référence du {0} a {1} jours, plus que {2}</translation>
    </message>
    <message>
        <source>Not covered by the uncertainties, because it is not stated: {0}.</source>
        <translation>Non couvert par les incertitudes, car non indiqué&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Not covered by the uncertainty of the tracking error: the reference&apos;s own errors.</source>
        <translation>Non couvert par l&apos;incertitude de l&apos;erreur de suivi&#xa0;: les erreurs propres de la référence.</translation>
    </message>
    <message>
        <source>For cage and surroundings; this is no deperm of a spacecraft.</source>
        <translation>Pour la cage et son entourage&#xa0;; ce n&apos;est pas la désaimantation d&apos;un véhicule spatial.</translation>
    </message>
    <message>
        <source>departure from the centre, each coil</source>
        <translation>écart au centre, chaque bobine</translation>
    </message>
    <message>
        <source>draft: {0}</source>
        <translation>brouillon&#xa0;: {0}</translation>
    </message>
    <message>
        <source>bias per ampere, one column a load</source>
        <translation>biais par ampère, une colonne par charge</translation>
    </message>
    <message>
        <source>moment m = p + X b of the DUT, in its body axes</source>
        <translation>moment m = p + X b du DUT, dans ses axes</translation>
    </message>
    <message>
        <source>the ambient field as tracked</source>
        <translation>le champ ambiant tel que suivi</translation>
    </message>
    <message>
        <source>K and k in the cage&apos;s frame, k in the middle of the run</source>
        <translation>K et k dans le repère de la cage, k au milieu de la mesure</translation>
    </message>
    <message>
        <source>too few directions for harmonics: what K and k do not hold is not reported by degree</source>
        <translation>trop peu de directions pour les harmoniques&#xa0;: ce que K et k ne portent pas n&apos;est pas rapporté par degré</translation>
    </message>
    <message>
        <source>the field is the reference&apos;s, measured at the DUT</source>
        <translation>le champ est celui de la référence, mesuré au DUT</translation>
    </message>
    <message>
        <source>the field is that of the calibrated cage, its ambient part followed by the reference</source>
        <translation>le champ est celui de la cage étalonnée, sa part ambiante suivie par la référence</translation>
    </message>
    <message>
        <source>offset from four attitudes</source>
        <translation>décalage d&apos;après quatre attitudes</translation>
    </message>
    <message>
        <source>field and reading along the direction</source>
        <translation>champ et lecture selon la direction</translation>
    </message>
    <message>
        <source>the places are as if the halves towards − had been reversed, or position_m has another sign</source>
        <translation>les places sont comme si les moitiés vers − avaient été inversées, ou position_m a un autre signe</translation>
    </message>
    <message>
        <source>field number {0} stands {1} s after it came</source>
        <translation>le champ numéro {0} est établi {1} s après son arrivée</translation>
    </message>
    <message>
        <source>{0}; {1} fields set</source>
        <translation>{0}&#xa0;; {1} champs réglés</translation>
    </message>
    <message>
        <source>No heading is judged: of the field the reference tells the magnitude alone.</source>
        <translation>Aucune direction n&apos;est jugée&#xa0;: du champ, la référence ne donne que le module.</translation>
    </message>
    <message>
        <source>Of the reference, because the run does not state it: {0}.</source>
        <translation>De la référence, car la mesure ne l&apos;indique pas&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Of the reference, because the run states it as 0: {0}.</source>
        <translation>De la référence, car la mesure indique 0&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Frame as mounted; mounting uncertainty not included.</source>
        <translation>Repère tel que monté&#xa0;; incertitude du montage non comprise.</translation>
    </message>
    <message>
        <source>The direction of the platform&apos;s axis in the cage.</source>
        <translation>La direction de l&apos;axe du plateau dans la cage.</translation>
    </message>
    <message>
        <source>the supplies&apos; read-back</source>
        <translation>la relecture des alimentations</translation>
    </message>
    <message>
        <source>the supplies&apos; currents</source>
        <translation>les courants des alimentations</translation>
    </message>
    <message>
        <source>where the reference was put</source>
        <translation>où la référence a été mise</translation>
    </message>
    <message>
        <source>where the sensor was put</source>
        <translation>où le capteur a été mis</translation>
    </message>
    <message>
        <source>the reference&apos;s turn against the cage</source>
        <translation>la rotation de la référence par rapport à la cage</translation>
    </message>
    <message>
        <source>the reference&apos;s own linearity</source>
        <translation>la linéarité propre de la référence</translation>
    </message>
    <message>
        <source>the direction of the platform&apos;s axis in the cage</source>
        <translation>la direction de l&apos;axe du plateau dans la cage</translation>
    </message>
    <message>
        <source>the DUT&apos;s mounting</source>
        <translation>le montage du DUT</translation>
    </message>
    <message>
        <source>the standard</source>
        <translation>l&apos;étalon</translation>
    </message>
    <message>
        <source>the half turns</source>
        <translation>les demi-tours</translation>
    </message>
    <message>
        <source>the cage</source>
        <translation>la cage</translation>
    </message>
    <message>
        <source>the platform&apos;s angle</source>
        <translation>l&apos;angle du plateau</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>alignement</translation>
    </message>
    <message>
        <source>own calibration</source>
        <translation>étalonnage propre</translation>
    </message>
    <message>
        <source>x along coil x: matrix_nT_per_A = {0}</source>
        <translation>x le long de la bobine x&#xa0;: matrix_nT_per_A = {0}</translation>
    </message>
    <message>
        <source>{0} needs a vector reference and three numbers, --set field_nT=0,0,30000</source>
        <translation>{0} demande une référence vectorielle et trois nombres, --set field_nT=0,0,30000</translation>
    </message>
    <message>
        <source>{0} needs a vector reference; for a scalar one see {1}</source>
        <translation>{0} demande une référence vectorielle&#xa0;; pour une scalaire, voir {1}</translation>
    </message>
    <message>
        <source>{0} needs a scalar reference ([reference] kind); for a vector one see {1}</source>
        <translation>{0} demande une référence scalaire ([reference] kind)&#xa0;; pour une vectorielle, voir {1}</translation>
    </message>
    <message>
        <source>the reference stands elsewhere: {0} needs [cage] calibration, from {1}</source>
        <translation>la référence est ailleurs&#xa0;: {0} demande [cage] calibration, de {1}</translation>
    </message>
    <message>
        <source>{0} needs a vector reference</source>
        <translation>{0} demande une référence vectorielle</translation>
    </message>
    <message>
        <source>{0} needs a platform with a motor</source>
        <translation>{0} demande un plateau à moteur</translation>
    </message>
    <message>
        <source>{0} must be at least two, and different</source>
        <translation>{0} doivent être au moins deux, et différents</translation>
    </message>
    <message>
        <source>the DUT has no current channel {0}; it has {1}</source>
        <translation>le DUT n&apos;a pas de voie de courant {0}&#xa0;; il a {1}</translation>
    </message>
    <message>
        <source>the DUT has no temperature channel {0}; it has {1}</source>
        <translation>le DUT n&apos;a pas de voie de température {0}&#xa0;; il a {1}</translation>
    </message>
    <message>
        <source>configuration: {0} not as stated</source>
        <translation>configuration&#xa0;: {0} pas comme indiqué</translation>
    </message>
    <message>
        <source>{0}: the coils have moved the field by {1} nT and the reading not at all.</source>
        <translation>{0}&#xa0;: les bobines ont déplacé le champ de {1} nT, et la lecture pas du tout.</translation>
    </message>
    <message>
        <source>no field stood for as long as one sample of the reference.</source>
        <translation>aucun champ n&apos;a duré un échantillon de la référence.</translation>
    </message>
    <message>
        <source>{0} takes a file or a source, not both</source>
        <translation>{0} prend un fichier ou une source, pas les deux</translation>
    </message>
    <message>
        <source>locate needs the coils&apos; geometry: state [cage.geometry] size_m, and in halves the coils of which one half can be reversed at its terminals</source>
        <translation>locate demande la géométrie des bobines&#xa0;: indiquez [cage.geometry] size_m, et dans halves les bobines dont une moitié peut être inversée à ses bornes</translation>
    </message>
    <message>
        <source>no coil&apos;s halves can be reversed ([cage.geometry] halves): near its middle the field of a pair does not change with the place to first order, and tells none</source>
        <translation>les moitiés d&apos;aucune bobine ne peuvent être inversées ([cage.geometry] halves)&#xa0;: près du milieu, le champ d&apos;une paire ne change pas avec la place au premier ordre, et n&apos;en révèle aucune</translation>
    </message>
    <message>
        <source>no half was reversed: the field of a pair as it should be is flat at its middle</source>
        <translation>aucune moitié n&apos;était inversée&#xa0;: le champ d&apos;une paire comme elle doit être est plat en son milieu</translation>
    </message>
    <message>
        <source>the sensor does not see three coils in three directions</source>
        <translation>le capteur ne voit pas trois bobines dans trois directions</translation>
    </message>
    <message>
        <source>what the sensor sees fits no place inside the coils: are the halves reversed as asked?</source>
        <translation>ce que voit le capteur ne correspond à aucune place dans les bobines&#xa0;: les moitiés sont-elles inversées comme demandé&#xa0;?</translation>
    </message>
    <message>
        <source>the currents do not span all three coils: step each coil at two currents at least</source>
        <translation>les courants ne couvrent pas les trois bobines&#xa0;: réglez chaque bobine à deux courants au moins</translation>
    </message>
    <message>
        <source>these turns do not determine all of the moment</source>
        <translation>ces tours ne déterminent pas tout le moment</translation>
    </message>
    <message>
        <source>these fields do not determine K, k and drift: they lie in a plane, or follow the time</source>
        <translation>ces champs ne déterminent pas K, k et la dérive&#xa0;: ils sont dans un plan, ou suivent le temps</translation>
    </message>
    <message>
        <source>{0} fields are too few: K, k and drift need {1}</source>
        <translation>{0} champs sont trop peu&#xa0;: K, k et la dérive en demandent {1}</translation>
    </message>
    <message>
        <source>these currents do not determine the coils: each alone in both signs, and every two together</source>
        <translation>ces courants ne déterminent pas les bobines&#xa0;: chacune seule dans les deux signes, et deux à deux</translation>
    </message>
    <message>
        <source>the magnitudes are those of no three coils: does the sensor follow the currents?</source>
        <translation>les modules ne sont ceux d&apos;aucun trio de bobines&#xa0;: le capteur suit-il les courants&#xa0;?</translation>
    </message>
    <message>
        <source>these currents do not determine coils and ambient field: turn the field all round, in two sizes</source>
        <translation>ces courants ne déterminent pas les bobines et le champ ambiant&#xa0;: tournez le champ tout autour, en deux modules</translation>
    </message>
    <message>
        <source>{0} magnitudes are too few: coils, ambient field and its course need {1}</source>
        <translation>{0} modules sont trop peu&#xa0;: bobines, champ ambiant et son évolution en demandent {1}</translation>
    </message>
    <message>
        <source>two rows at least are needed</source>
        <translation>il faut au moins deux lignes</translation>
    </message>
    <message>
        <source>time does not go on</source>
        <translation>le temps n&apos;avance pas</translation>
    </message>
    <message>
        <source>{0} is no finite number</source>
        <translation>{0} n&apos;est pas un nombre fini</translation>
    </message>
    <message>
        <source>this column is missing</source>
        <translation>cette colonne manque</translation>
    </message>
    <message>
        <source>is no regular file</source>
        <translation>n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>epoch = {0}: expected ISO 8601, as 2026-01-01T00:00:00</source>
        <translation>epoch = {0}&#xa0;: ISO 8601 attendu, comme 2026-01-01T00:00:00</translation>
    </message>
    <message>
        <source>the run has no channel {0}, which {1} rests on</source>
        <translation>la mesure n&apos;a pas de voie {0}, sur laquelle repose {1}</translation>
    </message>
    <message>
        <source>this run has nothing to show of {0}</source>
        <translation>cette mesure n&apos;a rien à montrer de {0}</translation>
    </message>
    <message>
        <source>a cage calibration file, from the folder of bench.toml</source>
        <translation>un fichier d&apos;étalonnage de cage, depuis le dossier de bench.toml</translation>
    </message>
    <message>
        <source>a table, or a file: labcal.bench.specification</source>
        <translation>une table, ou un fichier&#xa0;: labcal.bench.specification</translation>
    </message>
    <message>
        <source>after a ramp, before the field is believed</source>
        <translation>après une rampe, avant que le champ soit cru</translation>
    </message>
    <message>
        <source>after each mounting its serial is asked for, and no other is taken</source>
        <translation>après chaque montage son numéro de série est demandé, et aucun autre n&apos;est pris</translation>
    </message>
    <message>
        <source>after it no procedure begins</source>
        <translation>après cela aucune procédure ne commence</translation>
    </message>
    <message>
        <source>as it came in</source>
        <translation>tel qu&apos;il est arrivé</translation>
    </message>
    <message>
        <source>as it states it, with k</source>
        <translation>comme il l&apos;indique, avec k</translation>
    </message>
    <message>
        <source>at the cage: its number here, or an address</source>
        <translation>à la cage&#xa0;: son numéro ici, ou une adresse</translation>
    </message>
    <message>
        <source>at which it holds</source>
        <translation>à laquelle cela vaut</translation>
    </message>
    <message>
        <source>columns are the coil axes in C</source>
        <translation>les colonnes sont les axes des bobines en C</translation>
    </message>
    <message>
        <source>in the sensor&apos;s axes, subtracted first</source>
        <translation>dans les axes du capteur, soustrait d&apos;abord</translation>
    </message>
    <message>
        <source>magnitude with the coils at zero</source>
        <translation>module avec les bobines à zéro</translation>
    </message>
    <message>
        <source>of a whole serial</source>
        <translation>d&apos;un numéro de série entier</translation>
    </message>
    <message>
        <source>of it while it was measured, peak to peak</source>
        <translation>de cela pendant la mesure, crête à crête</translation>
    </message>
    <message>
        <source>of its locks and sockets; /run/labcal-GROUP</source>
        <translation>de ses verrous et sockets&#xa0;; /run/labcal-GROUP</translation>
    </message>
    <message>
        <source>of one axis of one sample</source>
        <translation>d&apos;un axe d&apos;un échantillon</translation>
    </message>
    <message>
        <source>of the computer&apos;s users</source>
        <translation>des utilisateurs de l&apos;ordinateur</translation>
    </message>
    <message>
        <source>of the difference of what the two halves of a pair make, relative</source>
        <translation>de la différence de ce que font les deux moitiés d&apos;une paire, relative</translation>
    </message>
    <message>
        <source>of the field at the centre</source>
        <translation>du champ au centre</translation>
    </message>
    <message>
        <source>of the windings, where a channel tells it</source>
        <translation>des enroulements, là où une voie la donne</translation>
    </message>
    <message>
        <source>of what the coils make</source>
        <translation>de ce que font les bobines</translation>
    </message>
    <message>
        <source>planetary index of those hours</source>
        <translation>indice planétaire de ces heures</translation>
    </message>
    <message>
        <source>root mean square over `rms_window_s`: what the wire bears for ever</source>
        <translation>valeur efficace sur `rms_window_s`&#xa0;: ce que le fil supporte pour toujours</translation>
    </message>
    <message>
        <source>what is known of it and not corrected; each with its own uncertainty</source>
        <translation>ce qu&apos;on en sait et ne corrige pas&#xa0;; chacun avec sa propre incertitude</translation>
    </message>
    <message>
        <source>with the coils at zero, of any component along any direction</source>
        <translation>avec les bobines à zéro, de toute composante selon toute direction</translation>
    </message>
    <message>
        <source>with the same reading so long, it is stuck</source>
        <translation>avec si longtemps la même lecture, il est bloqué</translation>
    </message>
    <message>
        <source>without a sample so long, it is silent</source>
        <translation>si longtemps sans échantillon, il est muet</translation>
    </message>
    <message>
        <source>|angle| that the cables bear</source>
        <translation>|angle| que les câbles supportent</translation>
    </message>
    <message>
        <source>nT a unit of the reading</source>
        <translation>nT par unité de la lecture</translation>
    </message>
    <message>
        <source>nT a year</source>
        <translation>nT par an</translation>
    </message>
    <message>
        <source>largest field at the DUT {0} µT</source>
        <translation>plus grand champ au DUT {0} µT</translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the platform&apos;s limit is {3} °/s</source>
        <translation>tourne entre {0} et {1}°, au plus vite à {2} °/s&#xa0;; la limite du plateau est {3} °/s</translation>
    </message>
    <message>
        <source>turns between {0} and {1}°, the fastest at {2} °/s; the DUT&apos;s limit in bench.toml is {3} °/s</source>
        <translation>tourne entre {0} et {1}°, au plus vite à {2} °/s&#xa0;; la limite du DUT dans bench.toml est {3} °/s</translation>
    </message>
    <message>
        <source>what a person is asked, {0}× in all:</source>
        <translation>ce qui est demandé à une personne, {0}× en tout&#xa0;:</translation>
    </message>
    <message>
        <source>DUT {0} axis: angle off its direction</source>
        <translation>DUT, axe {0}&#xa0;: angle avec sa direction</translation>
    </message>
    <message>
        <source>reference {0} axis: angle off its direction</source>
        <translation>référence, axe {0}&#xa0;: angle avec sa direction</translation>
    </message>
    <message>
        <source>mounting and zero</source>
        <translation>montage et zéro</translation>
    </message>
    <message>
        <source>ambient field</source>
        <translation>champ ambiant</translation>
    </message>
    <message>
        <source>mains</source>
        <translation>secteur électrique</translation>
    </message>
    <message>
        <source>field before</source>
        <translation>champ avant</translation>
    </message>
    <message>
        <source>field after</source>
        <translation>champ après</translation>
    </message>
    <message>
        <source>field upwards</source>
        <translation>champ montant</translation>
    </message>
    <message>
        <source>field downwards</source>
        <translation>champ descendant</translation>
    </message>
    <message>
        <source>field upwards again</source>
        <translation>champ montant de nouveau</translation>
    </message>
    <message>
        <source>{0} m, DUT away</source>
        <translation>{0} m, DUT retiré</translation>
    </message>
    <message>
        <source>{0} m, {1} up</source>
        <translation>{0} m, {1} en haut</translation>
    </message>
    <message>
        <source>verify</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>covers</source>
        <translation>capots</translation>
    </message>
    <message>
        <source>batteries</source>
        <translation>batteries</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>outils</translation>
    </message>
    <message>
        <source>phones</source>
        <translation>téléphones</translation>
    </message>
    <message>
        <source>chairs</source>
        <translation>chaises</translation>
    </message>
    <message>
        <source>the platform rests</source>
        <translation>le plateau est au repos</translation>
    </message>
    <message>
        <source>axes-check: {0}. Mount it again where it is not mounted as asked; else look at its axes.</source>
        <translation>contrôle des axes&#xa0;: {0}. Remontez-le s’il n’est pas monté comme demandé&#xa0;; sinon, regardez ses axes.</translation>
    </message>
    <message>
        <source>DUT kept within {0} to {1} °C</source>
        <translation>DUT tenu entre {0} et {1} °C</translation>
    </message>
    <message>
        <source>no temperature limits are stated</source>
        <translation>aucune limite de température n&apos;est indiquée</translation>
    </message>
    <message>
        <source>about {0} min, without a person&apos;s steps</source>
        <translation>environ {0} min, sans les gestes d&apos;une personne</translation>
    </message>
    <message>
        <source>{0}: missing sectors</source>
        <translation>{0}&#xa0;: secteurs manquants</translation>
    </message>
    <message>
        <source>{0}: noise</source>
        <translation>{0}&#xa0;: bruit</translation>
    </message>
    <message>
        <source>{0}: wrong signs</source>
        <translation>{0}&#xa0;: signes faux</translation>
    </message>
    <message>
        <source>delay {0}</source>
        <translation>retard {0}</translation>
    </message>
    <message>
        <source>closure {0}</source>
        <translation>bouclage {0}</translation>
    </message>
    <message>
        <source>closure, {0}</source>
        <translation>bouclage, {0}</translation>
    </message>
    <message>
        <source>zero: {0}</source>
        <translation>zéro&#xa0;: {0}</translation>
    </message>
    <message>
        <source>closing: {0}</source>
        <translation>clôture&#xa0;: {0}</translation>
    </message>
    <message>
        <source>zero since the interruption</source>
        <translation>zéro depuis l&apos;interruption</translation>
    </message>
    <message>
        <source>DUT less reference, coils off</source>
        <translation>DUT moins référence, bobines coupées</translation>
    </message>
    <message>
        <source>DUT less reference, first position</source>
        <translation>DUT moins référence, première position</translation>
    </message>
    <message>
        <source>DUT less reference</source>
        <translation>DUT moins référence</translation>
    </message>
    <message>
        <source>rotation rate</source>
        <translation>vitesse de rotation</translation>
    </message>
    <message>
        <source>turn seen by the DUT, less turn made</source>
        <translation>rotation vue par le DUT, moins celle faite</translation>
    </message>
    <message>
        <source>DUT behind the set-point</source>
        <translation>DUT derrière la consigne</translation>
    </message>
    <message>
        <source>reference behind the set-point</source>
        <translation>référence derrière la consigne</translation>
    </message>
    <message>
        <source>DUT behind the angle</source>
        <translation>DUT derrière l&apos;angle</translation>
    </message>
    <message>
        <source>mean {0}</source>
        <translation>moyenne {0}</translation>
    </message>
    <message>
        <source>drift {0}</source>
        <translation>dérive {0}</translation>
    </message>
    <message>
        <source>noise {0}</source>
        <translation>bruit {0}</translation>
    </message>
    <message>
        <source>noise density {0}</source>
        <translation>densité de bruit {0}</translation>
    </message>
    <message>
        <source>amplitude of {0} Hz</source>
        <translation>amplitude de {0} Hz</translation>
    </message>
    <message>
        <source>magnitude by {0}</source>
        <translation>module selon {0}</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>module</translation>
    </message>
    <message>
        <source>{0} Hz in reference samples</source>
        <translation>{0} Hz dans les valeurs de la référence</translation>
    </message>
    <message>
        <source>{0} Hz in dut samples</source>
        <translation>{0} Hz dans les valeurs du DUT</translation>
    </message>
    <message>
        <source>{0}: uncertainty of the matrix</source>
        <translation>{0}&#xa0;: incertitude de la matrice</translation>
    </message>
    <message>
        <source>{0}: settling time</source>
        <translation>{0}&#xa0;: temps d&apos;établissement</translation>
    </message>
    <message>
        <source>{0}: departure from the line</source>
        <translation>{0}&#xa0;: écart à la droite</translation>
    </message>
    <message>
        <source>{0}: up less down</source>
        <translation>{0}&#xa0;: montée moins descente</translation>
    </message>
    <message>
        <source>departure from the line</source>
        <translation>écart à la droite</translation>
    </message>
    <message>
        <source>up less down</source>
        <translation>montée moins descente</translation>
    </message>
    <message>
        <source>computed departure in the volume</source>
        <translation>écart calculé dans le volume</translation>
    </message>
    <message>
        <source>probe less computed</source>
        <translation>sonde moins calcul</translation>
    </message>
    <message>
        <source>{0}: bias {1}</source>
        <translation>{0}&#xa0;: biais {1}</translation>
    </message>
    <message>
        <source>change of the ambient field</source>
        <translation>changement du champ ambiant</translation>
    </message>
    <message>
        <source>permanent moment {0}</source>
        <translation>moment permanent {0}</translation>
    </message>
    <message>
        <source>induced moment {0}</source>
        <translation>moment induit {0}</translation>
    </message>
    <message>
        <source>largest induced moment in {0} µT</source>
        <translation>plus grand moment induit dans {0} µT</translation>
    </message>
    <message>
        <source>rms error while held</source>
        <translation>erreur rms pendant le maintien</translation>
    </message>
    <message>
        <source>open-loop error</source>
        <translation>erreur en boucle ouverte</translation>
    </message>
    <message>
        <source>drift of the zero</source>
        <translation>dérive du zéro</translation>
    </message>
    <message>
        <source>{0} µT, degree {1}</source>
        <translation>{0} µT, degré {1}</translation>
    </message>
    <message>
        <source>verify: rms error with bench.toml&apos;s matrix</source>
        <translation>vérification&#xa0;: erreur rms avec la matrice de bench.toml</translation>
    </message>
    <message>
        <source>verify: rms error</source>
        <translation>vérification&#xa0;: erreur rms</translation>
    </message>
    <message>
        <source>verify: largest error in units of U by noise</source>
        <translation>vérification&#xa0;: plus grande erreur en unités de U par le bruit</translation>
    </message>
    <message>
        <source>rms tracking error</source>
        <translation>erreur rms de suivi</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>latence</translation>
    </message>
    <message>
        <source>jitter of the latency</source>
        <translation>gigue de la latence</translation>
    </message>
    <message>
        <source>jitter of the source</source>
        <translation>gigue de la source</translation>
    </message>
    <message>
        <source>departure from a straight line</source>
        <translation>écart à une droite</translation>
    </message>
    <message>
        <source>reference from DUT: {0}</source>
        <translation>référence vue du DUT&#xa0;: {0}</translation>
    </message>
    <message>
        <source>less what is stated: {0}</source>
        <translation>moins ce qui est indiqué&#xa0;: {0}</translation>
    </message>
    <message>
        <source>coil {0}: field at the reference over that at the DUT</source>
        <translation>bobine {0}&#xa0;: champ à la référence sur celui au DUT</translation>
    </message>
    <message>
        <source>once a turn</source>
        <translation>une fois par tour</translation>
    </message>
    <message>
        <source>turning less holding</source>
        <translation>en rotation moins en maintien</translation>
    </message>
    <message>
        <source>holding less off</source>
        <translation>en maintien moins coupé</translation>
    </message>
    <message>
        <source>zero {0}</source>
        <translation>zéro {0}</translation>
    </message>
    <message>
        <source>magnitude against direction</source>
        <translation>module selon la direction</translation>
    </message>
    <message>
        <source>magnitude less the standard&apos;s</source>
        <translation>module moins celui de l&apos;étalon</translation>
    </message>
    <message>
        <source>age of its calibration</source>
        <translation>âge de son étalonnage</translation>
    </message>
    <message>
        <source>components against constant modulus, largest E_n</source>
        <translation>composantes contre module constant, plus grand E_n</translation>
    </message>
    <message>
        <source>constant {0}</source>
        <translation>constante {0}</translation>
    </message>
    <message>
        <source>{0} from square</source>
        <translation>{0} de l&apos;angle droit</translation>
    </message>
    <message>
        <source>ambient {0}</source>
        <translation>ambiant {0}</translation>
    </message>
    <message>
        <source>current at zero {0}</source>
        <translation>courant à zéro {0}</translation>
    </message>
    <message>
        <source>{0} at {1} µT per {2}</source>
        <translation>{0} à {1} µT par {2}</translation>
    </message>
    <message>
        <source>offset {0}</source>
        <translation>décalage {0}</translation>
    </message>
    <message>
        <source>rms heading error</source>
        <translation>erreur rms de direction</translation>
    </message>
    <message>
        <source>rms magnitude error</source>
        <translation>erreur rms de module</translation>
    </message>
    <message>
        <source>{0}: polarity + less −</source>
        <translation>{0}&#xa0;: polarité + moins −</translation>
    </message>
    <message>
        <source>DUT: change from bench.toml</source>
        <translation>DUT&#xa0;: changement depuis bench.toml</translation>
    </message>
    <message>
        <source>axes-check</source>
        <translation>contrôle des axes</translation>
    </message>
    <message>
        <source>sync-check</source>
        <translation>contrôle des temps</translation>
    </message>
    <message>
        <source>closure-{0}</source>
        <translation>bouclage {0}</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>clôture</translation>
    </message>
    <message>
        <source>coil {0}</source>
        <translation>bobine {0}</translation>
    </message>
    <message>
        <source>sweep at the DUT&apos;s place</source>
        <translation>balayage à la place du DUT</translation>
    </message>
    <message>
        <source>sweep at the reference&apos;s place</source>
        <translation>balayage à la place de la référence</translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation>point {0}</translation>
    </message>
    <message>
        <source>{0}-on-{1}</source>
        <translation>{0} allumé {1}</translation>
    </message>
    <message>
        <source>{0}-off-{1}</source>
        <translation>{0} coupé {1}</translation>
    </message>
    <message>
        <source>{0}-on</source>
        <translation>{0} allumé</translation>
    </message>
    <message>
        <source>{0}-off</source>
        <translation>{0} coupé</translation>
    </message>
    <message>
        <source>open loop</source>
        <translation>boucle ouverte</translation>
    </message>
    <message>
        <source>held</source>
        <translation>tenu</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>sphère</translation>
    </message>
    <message>
        <source>field steps</source>
        <translation>paliers de champ</translation>
    </message>
    <message>
        <source>wait for the source</source>
        <translation>attente de la source</translation>
    </message>
    <message>
        <source>play</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>half-{0}-reversed</source>
        <translation>moitié {0} inversée</translation>
    </message>
    <message>
        <source>half-{0}-back</source>
        <translation>moitié {0} remise</translation>
    </message>
    <message>
        <source>as they should be</source>
        <translation>comme elles doivent être</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>en rotation</translation>
    </message>
    <message>
        <source>holding</source>
        <translation>en maintien</translation>
    </message>
    <message>
        <source>motor off</source>
        <translation>moteur coupé</translation>
    </message>
    <message>
        <source>zero by half turns</source>
        <translation>zéro par demi-tours</translation>
    </message>
    <message>
        <source>six directions</source>
        <translation>six directions</translation>
    </message>
    <message>
        <source>components</source>
        <translation>composantes</translation>
    </message>
    <message>
        <source>constant modulus</source>
        <translation>module constant</translation>
    </message>
    <message>
        <source>round {0}</source>
        <translation>tour {0}</translation>
    </message>
    <message>
        <source>position {0}</source>
        <translation>position {0}</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>en avant</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>en arrière</translation>
    </message>
    <message>
        <source>room</source>
        <translation>salle</translation>
    </message>
    <message>
        <source>photographs</source>
        <translation>photos</translation>
    </message>
    <message>
        <source>no better than chance or a slow wander</source>
        <translation>pas mieux que le hasard ou une lente dérive</translation>
    </message>
    <message>
        <source>too little evidence</source>
        <translation>trop peu d&apos;évidence</translation>
    </message>
    <message>
        <source>{0}, then check the zero again.</source>
        <translation>{0}, puis vérifier de nouveau le zéro.</translation>
    </message>
    <message>
        <source>Then check the zero again.</source>
        <translation>Puis vérifier de nouveau le zéro.</translation>
    </message>
    <message>
        <source>the supplies state {0} A, and the reference does not see that: {1}.</source>
        <translation>Les alimentations annoncent {0} A, et la référence ne le voit pas&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>Does every supply obey, are signs and constants right, was something magnetic moved? axes-check tells which coil it is.</source>
        <translation>Chaque alimentation obéit-elle, signes et constantes sont-ils justes, un objet magnétique a-t-il bougé&#xa0;? axes-check dit quelle bobine c&apos;est.</translation>
    </message>
    <message>
        <source>Has its output gone off by itself, is the winding open? Set the coils off, look at its panel, and find out why before it is cleared.</source>
        <translation>Sa sortie s&apos;est-elle coupée d&apos;elle-même, l&apos;enroulement est-il ouvert&#xa0;? Couper les bobines, regarder sa face avant, et trouver la cause avant de réarmer.</translation>
    </message>
    <message>
        <source>a field of {0} nT is beyond the limit of {1}, {2} nT; nothing was set.</source>
        <translation>Un champ de {0} nT dépasse la limite de {1}, {2} nT&#xa0;; rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A would take {2} s to ramp down, more than {3} s; lower current_A or raise ramp_A_per_s.</source>
        <translation>bobine {0}&#xa0;: {1} A mettraient {2} s à redescendre, plus que {3} s&#xa0;; baisser current_A ou augmenter ramp_A_per_s.</translation>
    </message>
    <message>
        <source>{0}, at {1}: {2}. Nothing was set.</source>
        <translation>{0}, à {1}&#xa0;: {2}. Rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>{0}, then measure again: `labcal bench check FILE` lifts this where reference and supplies agree, with --clear-as NAME where a person answers for it.</source>
        <translation>{0}, puis mesurer de nouveau&#xa0;: `labcal bench check FILE` lève ceci où référence et alimentations s&apos;accordent, avec --clear-as NAME où une personne en répond.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows after zero was set; the contacts were not moved.</source>
        <translation>bobine {0}&#xa0;: {1} A passent encore après la mise à zéro&#xa0;; les contacts n&apos;ont pas bougé.</translation>
    </message>
    <message>
        <source>coil {0}: after its contacts were set, a step of {1} A was seen by the reference as {2} A.</source>
        <translation>bobine {0}&#xa0;: après le réglage de ses contacts, un pas de {1} A a été vu par la référence comme {2} A.</translation>
    </message>
    <message>
        <source>Look for a contact that hangs or is welded, then run axes-check.</source>
        <translation>Chercher un contact coincé ou soudé, puis lancer axes-check.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A root mean square would soon be reached, its limit is {2} A; nothing was set.</source>
        <translation>bobine {0}&#xa0;: {1} A efficaces seraient bientôt atteints, sa limite est {2} A&#xa0;; rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows {2} s after zero was set (zero is below {3} A).</source>
        <translation>bobine {0}&#xa0;: {1} A passent encore {2} s après la mise à zéro (zéro est sous {3} A).</translation>
    </message>
    <message>
        <source>Switch {0} off by hand, then look at its panel.</source>
        <translation>Éteindre {0} à la main, puis regarder sa face avant.</translation>
    </message>
    <message>
        <source>See that it sends, then try again.</source>
        <translation>Faire qu&apos;il émette, puis réessayer.</translation>
    </message>
    <message>
        <source>{0}: it stopped {1}° from its target of {2}°.</source>
        <translation>{0}&#xa0;: arrêté à {1}° de sa cible de {2}°.</translation>
    </message>
    <message>
        <source>{0}: it homes at {1} deg/s, the DUT&apos;s limit is {2} deg/s; nothing was moved.</source>
        <translation>{0}&#xa0;: prend son origine à {1} deg/s, la limite du DUT est {2} deg/s&#xa0;; rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>Lower the homing speed on the stage itself, or take the DUT off and home it with its own program.</source>
        <translation>Baisser cette vitesse sur la platine même, ou retirer le DUT et prendre l&apos;origine par son propre programme.</translation>
    </message>
    <message>
        <source>{0}: {1} answers, before it was {2}.</source>
        <translation>{0}&#xa0;: {1} répond, avant c&apos;était {2}.</translation>
    </message>
    <message>
        <source>Plug the instruments in as bench.toml says, and begin again.</source>
        <translation>Brancher les instruments comme le dit bench.toml, et recommencer.</translation>
    </message>
    <message>
        <source>{0}: its name came damaged ({1}).</source>
        <translation>{0}&#xa0;: son nom est arrivé abîmé ({1}).</translation>
    </message>
    <message>
        <source>{0}: {1} answers here and as {2}: the same instrument answers on both links.</source>
        <translation>{0}&#xa0;: {1} répond ici et comme {2}&#xa0;: le même instrument répond sur les deux liaisons.</translation>
    </message>
    <message>
        <source>Correct the links in bench.toml, then begin again.</source>
        <translation>Corriger les liaisons dans bench.toml, puis recommencer.</translation>
    </message>
    <message>
        <source>{0}: {1} was set to {2} and reads back {3}.</source>
        <translation>{0}&#xa0;: {1} a été mis à {2} et se relit {3}.</translation>
    </message>
    <message>
        <source>Look at the instrument&apos;s panel.</source>
        <translation>Regarder la face avant de l&apos;instrument.</translation>
    </message>
    <message>
        <source>{0}: {1} came back as {2}.</source>
        <translation>{0}&#xa0;: {1} est revenu comme {2}.</translation>
    </message>
    <message>
        <source>{0}: the guardian is gone ({1}); how the coils are is not known.</source>
        <translation>{0}&#xa0;: le gardien n&apos;est plus là ({1})&#xa0;; l&apos;état des bobines n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>Say `labcal bench off`, then try again.</source>
        <translation>COILS OFF (`labcal bench off`), puis réessayer.</translation>
    </message>
    <message>
        <source>another user&apos;s process answers as the guardian of this bench; it is not believed.</source>
        <translation>un processus d&apos;un autre utilisateur répond comme gardien de ce banc&#xa0;; on ne le croit pas.</translation>
    </message>
    <message>
        <source>guardian.log names its process: end it, then say off again.</source>
        <translation>guardian.log nomme son processus&#xa0;: le terminer, puis couper de nouveau.</translation>
    </message>
    <message>
        <source>coil {0}: the guardian before is gone; it had ordered zero and reported no read-back.</source>
        <translation>bobine {0}&#xa0;: le gardien précédent n&apos;est plus là&#xa0;; il avait ordonné zéro et n&apos;a annoncé aucune relecture.</translation>
    </message>
    <message>
        <source>coil {0}: zero has not been read back.</source>
        <translation>bobine {0}&#xa0;: le zéro n&apos;a pas été relu.</translation>
    </message>
    <message>
        <source>coil {0}: a step of {1} A is beyond the {2} A that its ramp of {3} A/s allows now; nothing was set.</source>
        <translation>bobine {0}&#xa0;: un pas de {1} A dépasse les {2} A que sa rampe de {3} A/s permet maintenant&#xa0;; rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>coil {0}: {1} A still flows; its output is not opened under current.</source>
        <translation>bobine {0}&#xa0;: {1} A passent encore&#xa0;; sa sortie ne s&apos;ouvre pas sous courant.</translation>
    </message>
    <message>
        <source>Ramp it to zero first; or `labcal bench off`.</source>
        <translation>La mener d&apos;abord à zéro&#xa0;; ou COILS OFF (`labcal bench off`).</translation>
    </message>
    <message>
        <source>it did not answer in the time that there is on the way to zero.</source>
        <translation>il n&apos;a pas répondu dans le temps qu&apos;il y a sur le chemin du zéro.</translation>
    </message>
    <message>
        <source>{0} How the coils are is not known.</source>
        <translation>{0} L&apos;état des bobines n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>{0} A was not sent: this coil was ordered to zero, and {1} A is the most that it may still hear.</source>
        <translation>{0} A n&apos;ont pas été envoyés&#xa0;: le zéro est ordonné pour cette bobine, et {1} A est le plus qu&apos;elle puisse encore recevoir.</translation>
    </message>
    <message>
        <source>{0}: its output was not closed: this coil was ordered to zero.</source>
        <translation>{0}&#xa0;: sa sortie n&apos;a pas été fermée&#xa0;: le zéro est ordonné pour cette bobine.</translation>
    </message>
    <message>
        <source>a field of {0} nT of the coils alone is beyond the limit of {1} nT, Earth&apos;s {2} nT taken off; nothing was set.</source>
        <translation>un champ de {0} nT des seules bobines dépasse la limite de {1} nT, les {2} nT de la Terre déduits&#xa0;; rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>the cage&apos;s calibration is not there: no field is set by it; nothing was set.</source>
        <translation>l&apos;étalonnage de la cage n&apos;est pas là&#xa0;: aucun champ n&apos;est réglé d&apos;après lui&#xa0;; rien n&apos;a été réglé.</translation>
    </message>
    <message>
        <source>not reached: {0}.</source>
        <translation>non atteint&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>{0}: {1} failed ({2}); its port is there.</source>
        <translation>{0}&#xa0;: {1} a échoué ({2})&#xa0;; son port est là.</translation>
    </message>
    <message>
        <source>{0}: {1} was sent and {2} came back.</source>
        <translation>{0}&#xa0;: {1} a été envoyé et {2} est revenu.</translation>
    </message>
    <message>
        <source>Do two talk on this line at once? Without an adapter that echoes, take echo=1 out of the link.</source>
        <translation>Deux parlent-ils à la fois sur cette ligne&#xa0;? Sans adaptateur à écho, retirer echo=1 de la liaison.</translation>
    </message>
    <message>
        <source>{0}: it babbles: more than {1} KiB came without an end, beginning with {2}.</source>
        <translation>{0}&#xa0;: il parle sans fin&#xa0;: plus de {1} Kio sont venus sans terminaison, commençant par {2}.</translation>
    </message>
    <message>
        <source>Is it the instrument that bench.toml names? Pull its cable and plug it in again, or switch it off.</source>
        <translation>Est-ce l&apos;instrument que nomme bench.toml&#xa0;? Débrancher et rebrancher son câble, ou l&apos;éteindre.</translation>
    </message>
    <message>
        <source>{0}: {1} registers came where {2} were asked for.</source>
        <translation>{0}&#xa0;: {1} registres sont venus pour {2} demandés.</translation>
    </message>
    <message>
        <source>{0}: no valid Modbus reply.</source>
        <translation>{0}&#xa0;: pas de réponse Modbus valable.</translation>
    </message>
    <message>
        <source>{0}: does not answer as it should.</source>
        <translation>{0}&#xa0;: ne répond pas comme il le devrait.</translation>
    </message>
    <message>
        <source>does not answer as it should.</source>
        <translation>ne répond pas comme il le devrait.</translation>
    </message>
    <message>
        <source>{0}: the reply belongs to another request.</source>
        <translation>{0}&#xa0;: la réponse appartient à une autre demande.</translation>
    </message>
    <message>
        <source>{0}: a program of user {1} is connected to it.</source>
        <translation>{0}&#xa0;: un programme de l&apos;utilisateur {1} y est connecté.</translation>
    </message>
    <message>
        <source>Ask user {0} to end it, then try again.</source>
        <translation>Demander à l&apos;utilisateur {0} de le terminer, puis réessayer.</translation>
    </message>
    <message>
        <source>End that program, then try again.</source>
        <translation>Terminer ce programme, puis réessayer.</translation>
    </message>
    <message>
        <source>End it, then try again.</source>
        <translation>Le terminer, puis réessayer.</translation>
    </message>
    <message>
        <source>End it, or the session that drives this bench; `labcal bench off` brings its coils to zero meanwhile.</source>
        <translation>Le terminer, ou la session qui pilote ce banc&#xa0;; COILS OFF (`labcal bench off`) ramène entre-temps ses bobines à zéro.</translation>
    </message>
    <message>
        <source>Try again; if it comes again, look at its cable and its adapter.</source>
        <translation>Réessayer&#xa0;; si cela revient, regarder son câble et son adaptateur.</translation>
    </message>
    <message>
        <source>returned no data</source>
        <translation>n&apos;a rendu aucune donnée</translation>
    </message>
    <message>
        <source>its other end has hung up</source>
        <translation>l&apos;autre bout a raccroché</translation>
    </message>
    <message>
        <source>{0}: {1}° is beyond the ±{2}° of the cables; nothing was sent.</source>
        <translation>{0}&#xa0;: {1}° dépassent les ±{2}° des câbles&#xa0;; rien n&apos;a été envoyé.</translation>
    </message>
    <message>
        <source>{0}: another process has this port.</source>
        <translation>{0}&#xa0;: un autre processus a ce port.</translation>
    </message>
    <message>
        <source>Check that the dial&apos;s reading is entered after each turn.</source>
        <translation>Vérifier que la lecture du cadran est entrée après chaque rotation.</translation>
    </message>
    <message>
        <source>{0} deg/s is too fast: DUT and platform allow {1} deg/s</source>
        <translation>{0} deg/s est trop rapide&#xa0;: DUT et plateforme permettent {1} deg/s</translation>
    </message>
    <message>
        <source>{0} deg/s is beyond the DUT&apos;s limit of {1} deg/s; nothing was moved.</source>
        <translation>{0} deg/s dépasse la limite du DUT de {1} deg/s&#xa0;; rien n&apos;a bougé.</translation>
    </message>
    <message>
        <source>the system gives this process no more ({0}); how the coils are is not known.</source>
        <translation>le système ne donne plus rien à ce processus ({0})&#xa0;; l&apos;état des bobines n&apos;est pas connu.</translation>
    </message>
    <message>
        <source>Switch the supplies off by hand, or say off again in a new terminal.</source>
        <translation>Éteindre les alimentations à la main, ou couper de nouveau dans un nouveau terminal.</translation>
    </message>
    <message>
        <source>the field source has sent no new field for {0} s.</source>
        <translation>la source du champ n&apos;a pas envoyé de nouveau champ depuis {0} s.</translation>
    </message>
    <message>
        <source>{0} was {1} when run {2} began, now it is {3}</source>
        <translation>{0} était {1} quand la mesure {2} a commencé, maintenant c&apos;est {3}</translation>
    </message>
    <message>
        <source>run {0} was begun on another bench: a real, a simulated and a served one are not the same</source>
        <translation>la mesure {0} a été commencée sur un autre banc&#xa0;: un banc réel, un banc simulé et un banc servi ne sont pas le même</translation>
    </message>
    <message>
        <source>the bench holds {0}, the run is of {1}: nothing was moved</source>
        <translation>le banc porte {0}, la mesure est de {1}&#xa0;: rien n&apos;a bougé</translation>
    </message>
    <message>
        <source>taking to zero from here what no guardian holds: not read back yet …</source>
        <translation>ce qu&apos;aucun gardien ne tient est mené à zéro d&apos;ici&#xa0;: pas encore relu …</translation>
    </message>
    <message>
        <source>before that: {0}</source>
        <translation>avant cela&#xa0;: {0}</translation>
    </message>
    <message>
        <source>not asked this time; {0} s ago: {1}</source>
        <translation>pas demandé cette fois&#xa0;; il y a {0} s&#xa0;: {1}</translation>
    </message>
    <message>
        <source>NOT confirmed at zero: {0}</source>
        <translation>zéro NON confirmé&#xa0;: {0}</translation>
    </message>
    <message>
        <source>zero of coil {0} is not confirmed, and tried again</source>
        <translation>le zéro de la bobine {0} n&apos;est pas confirmé, nouvel essai</translation>
    </message>
    <message>
        <source>supplies and reference agree again, {0}: {1}</source>
        <translation>alimentations et référence s&apos;accordent de nouveau, {0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>the connection to the guardian was lost; {0}.</source>
        <translation>la liaison avec le gardien a été perdue&#xa0;; {0}.</translation>
    </message>
    <message>
        <source>last read before that (UTC): {0}</source>
        <translation>lu en dernier avant cela (UTC)&#xa0;: {0}</translation>
    </message>
    <message>
        <source>no current was read through it</source>
        <translation>aucun courant n&apos;a été lu par lui</translation>
    </message>
    <message>
        <source>a guardian holds the ports and hangs, or was stopped.</source>
        <translation>un gardien tient les ports et reste bloqué, ou a été arrêté.</translation>
    </message>
    <message>
        <source>Have it ended, then say off again.</source>
        <translation>Le faire terminer, puis couper de nouveau.</translation>
    </message>
    <message>
        <source>Correct the file and say off again, or switch this supply off by hand.</source>
        <translation>Corriger le fichier et couper de nouveau, ou éteindre cette alimentation à la main.</translation>
    </message>
    <message>
        <source>open the output of {0} at its panel, or switch it off at its mains</source>
        <translation>ouvrir la sortie de {0} sur sa face avant, ou la couper au secteur</translation>
    </message>
    <message>
        <source>switch off {0} at its mains (no command opens its output)</source>
        <translation>couper {0} au secteur (aucun ordre n&apos;ouvre sa sortie)</translation>
    </message>
    <message>
        <source>It is as if {0} A flowed in coil {1}: {2}</source>
        <translation>C&apos;est comme si {0} A passaient dans la bobine {1}&#xa0;: {2}</translation>
    </message>
    <message>
        <source>Let the DUT come back into its range.</source>
        <translation>Laisser le DUT revenir dans sa plage.</translation>
    </message>
    <message>
        <source>Let the windings cool, then use less current.</source>
        <translation>Laisser refroidir les enroulements, puis prendre moins de courant.</translation>
    </message>
    <message>
        <source>{0}: it sends again, after {1} s</source>
        <translation>{0}&#xa0;: émet de nouveau, après {1} s</translation>
    </message>
    <message>
        <source>{0}: no sample for {1} s</source>
        <translation>{0}&#xa0;: aucun échantillon depuis {1} s</translation>
    </message>
    <message>
        <source>{0}: no answer</source>
        <translation>{0}&#xa0;: pas de réponse</translation>
    </message>
    <message>
        <source>{0}: it answers again, {1} s after its loss was noticed</source>
        <translation>{0}&#xa0;: répond de nouveau, {1} s après que sa perte a été remarquée</translation>
    </message>
    <message>
        <source>{0}; every row is kept by now</source>
        <translation>{0}&#xa0;; chaque ligne est gardée maintenant</translation>
    </message>
    <message>
        <source>{0}, kept by the store {1} s later</source>
        <translation>{0}, gardé par le magasin {1} s plus tard</translation>
    </message>
    <message>
        <source>{0}; {1} cannot be gone on with: start it anew</source>
        <translation>{0}&#xa0;; {1} ne peut pas être continué&#xa0;: recommencer</translation>
    </message>
    <message>
        <source>what was not committed is lost</source>
        <translation>ce qui n&apos;était pas écrit est perdu</translation>
    </message>
    <message>
        <source>what it held is lost where there is no copy</source>
        <translation>ce qu&apos;il contenait est perdu s&apos;il n&apos;y a pas de copie</translation>
    </message>
    <message>
        <source>{0} s ago: {1}</source>
        <translation>il y a {0} s&#xa0;: {1}</translation>
    </message>
    <message>
        <source>the guardian failed at {0}: {1}: {2}.</source>
        <translation>le gardien a échoué à {0}&#xa0;: {1}&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>the connection to {0} was lost</source>
        <translation>la liaison avec {0} a été perdue</translation>
    </message>
    <message>
        <source>session {0} orders it</source>
        <translation>la session {0} l&apos;ordonne</translation>
    </message>
    <message>
        <source>labcal bench off, process {0}</source>
        <translation>labcal bench off, processus {0}</translation>
    </message>
    <message>
        <source>coil {0}: zero was ordered for all coils: {1}.</source>
        <translation>bobine {0}&#xa0;: le zéro a été ordonné pour toutes les bobines&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>zero was ordered; what was being asked of this line was given up.</source>
        <translation>le zéro a été ordonné&#xa0;; ce qu&apos;on demandait sur cette ligne a été abandonné.</translation>
    </message>
    <message>
        <source>The work was ended by this window.</source>
        <translation>Le travail a été terminé par cette fenêtre.</translation>
    </message>
    <message>
        <source>The work was killed (signal {0}).</source>
        <translation>Le travail a été tué (signal {0}).</translation>
    </message>
    <message>
        <source>The worker process could not be started.</source>
        <translation>Le processus de travail n&apos;a pas pu démarrer.</translation>
    </message>
    <message>
        <source>The work said what this window cannot read, and was ended by it.</source>
        <translation>Le travail a dit ce que cette fenêtre ne peut lire, et a été terminé par elle.</translation>
    </message>
    <message>
        <source>The work ended by itself (exit {0}).</source>
        <translation>Le travail s&apos;est terminé de lui-même (sortie {0}).</translation>
    </message>
    <message>
        <source>The work crashed (code {0}).</source>
        <translation>Le travail a planté (code {0}).</translation>
    </message>
    <message>
        <source>labcal itself made a mistake here; the details hold what it says of it.</source>
        <translation>labcal lui-même a fait une erreur ici&#xa0;; ce qu’il en dit se trouve dans les détails.</translation>
    </message>
    <message>
        <source>no run goes on here that could be come back to</source>
        <translation>aucune mesure n&apos;est en cours ici, à laquelle revenir</translation>
    </message>
    <message>
        <source>the rotation axis is not where it was declared</source>
        <translation>l&apos;axe de rotation n&apos;est pas là où il a été déclaré</translation>
    </message>
    <message>
        <source>something at the cage or the table adds a field</source>
        <translation>quelque chose sur la cage ou la table ajoute un champ</translation>
    </message>
    <message>
        <source>the reading along one axis changes with the field across it</source>
        <translation>la lecture d&apos;un axe change avec le champ en travers</translation>
    </message>
    <message>
        <source>the reference sees the DUT&apos;s own magnetism</source>
        <translation>la référence voit le magnétisme propre du DUT</translation>
    </message>
    <message>
        <source>the offset follows what was recorded, for no known cause</source>
        <translation>le décalage suit ce qui a été enregistré, sans cause connue</translation>
    </message>
    <message>
        <source>the platform reads its angle wrong</source>
        <translation>la plateforme lit mal son angle</translation>
    </message>
    <message>
        <source>the DUT is off the cage&apos;s centre</source>
        <translation>le DUT n&apos;est pas au centre de la cage</translation>
    </message>
    <message>
        <source>the gain changes with a recorded channel</source>
        <translation>le gain change avec une voie enregistrée</translation>
    </message>
    <message>
        <source>the gain jumps at one moment</source>
        <translation>le gain saute à un instant</translation>
    </message>
    <message>
        <source>the gain changes with temperature</source>
        <translation>le gain change avec la température</translation>
    </message>
    <message>
        <source>magnetic parts remember earlier fields</source>
        <translation>des pièces magnétiques gardent les champs passés</translation>
    </message>
    <message>
        <source>the readings come later than the field</source>
        <translation>les lectures viennent après le champ</translation>
    </message>
    <message>
        <source>the reading is not proportional to the field</source>
        <translation>la lecture n&apos;est pas proportionnelle au champ</translation>
    </message>
    <message>
        <source>the offset changes with a recorded channel</source>
        <translation>le décalage change avec une voie enregistrée</translation>
    </message>
    <message>
        <source>the offset changes with a current</source>
        <translation>le décalage change avec un courant</translation>
    </message>
    <message>
        <source>the offset changes with the square of a current</source>
        <translation>le décalage change avec le carré d&apos;un courant</translation>
    </message>
    <message>
        <source>the offset drifts with time</source>
        <translation>le décalage dérive avec le temps</translation>
    </message>
    <message>
        <source>the offset differs between power modes</source>
        <translation>le décalage diffère selon le mode d&apos;alimentation</translation>
    </message>
    <message>
        <source>the offset jumps at one moment</source>
        <translation>le décalage saute à un instant</translation>
    </message>
    <message>
        <source>the offset changes with temperature</source>
        <translation>le décalage change avec la température</translation>
    </message>
    <message>
        <source>a periodic disturbance lies on the readings</source>
        <translation>une perturbation périodique s&apos;ajoute aux lectures</translation>
    </message>
    <message>
        <source>the reference drifts with time</source>
        <translation>la référence dérive avec le temps</translation>
    </message>
    <message>
        <source>the reference changes with temperature</source>
        <translation>la référence change avec la température</translation>
    </message>
    <message>
        <source>single readings lie far off</source>
        <translation>des lectures isolées sont très loin</translation>
    </message>
    <message>
        <source>readings are at the end of their range</source>
        <translation>des lectures sont au bout de leur étendue</translation>
    </message>
</context>
<context>
    <name>Drop</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The chosen calibration alone again</source>
        <translation>De nouveau l’étalonnage choisi seul</translation>
    </message>
    <message>
        <source>Verify a file …</source>
        <translation>Vérifier un fichier …</translation>
    </message>
    <message>
        <source>Choose a calibration .json with its .sshsig beside it, or drop it on the window</source>
        <translation>Choisir un étalonnage .json avec son .sshsig à côté, ou le déposer sur la fenêtre</translation>
    </message>
    <message>
        <source>Verify a calibration</source>
        <translation>Vérifier un étalonnage</translation>
    </message>
</context>
<context>
    <name>EarlierCard</name>
    <message>
        <source>They are gone</source>
        <translation>Elles ne sont plus là</translation>
    </message>
    <message>
        <source>▲ Supplies of an earlier session do not answer: {0}</source>
        <translation>▲ Des alimentations d’une session antérieure ne répondent pas&#xa0;: {0}</translation>
    </message>
    <message>
        <source>If one of them stands somewhere still, switch it off by hand, then press COILS OFF (F12).</source>
        <translation>Si l’une d’elles se trouve encore quelque part, l&apos;éteindre à la main, puis appuyer sur BOBINES À ZÉRO (F12).</translation>
    </message>
    <message>
        <source>Where they were taken away, or a simulated lab was served anew, say so.</source>
        <translation>Si elles ont été retirées, ou si un laboratoire simulé a été servi de nouveau, le dire ici.</translation>
    </message>
    <message>
        <source>✕ Supplies of an earlier session are not at zero: {0}</source>
        <translation>✕ Des alimentations d’une session antérieure ne sont pas à zéro&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Nothing is at their links any more: they are asked for no more, and the audit log has your name</source>
        <translation>Plus rien n’est sur leurs liaisons&#xa0;: elles ne sont plus interrogées, et le journal d’audit porte votre nom</translation>
    </message>
    <message>
        <source>Type the operator&apos;s name at the top.</source>
        <translation>Tapez en haut le nom de l&apos;opérateur.</translation>
    </message>
</context>
<context>
    <name>EarlierSupplies</name>
    <message>
        <source>a supply of an earlier session is not at zero: {0}</source>
        <translation>une alimentation d’une session antérieure n’est pas à zéro&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0}: gone, says {1}; it is kept in the audit log</source>
        <translation>{0}&#xa0;: plus là, selon {1}&#xa0;; c&apos;est gardé dans le journal d’audit</translation>
    </message>
</context>
<context>
    <name>FaultCard</name>
    <message>
        <source>Whether hands may go in</source>
        <translation>Si les mains peuvent entrer</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>Show what labcal itself says about it</source>
        <translation>Montrer ce que labcal lui-même en dit</translation>
    </message>
    <message>
        <source>Save a problem report …</source>
        <translation>Enregistrer un rapport de problème …</translation>
    </message>
    <message>
        <source>A .zip with the details, settings and versions, no keys</source>
        <translation>Un .zip avec détails, réglages et versions, sans clés</translation>
    </message>
    <message>
        <source>Check the zero now</source>
        <translation>Vérifier le zéro maintenant</translation>
    </message>
    <message>
        <source>Coils to zero, then what the reference sees; nothing is energised</source>
        <translation>Bobines à zéro, puis ce que voit la référence&#xa0;; rien n’est mis sous courant</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Put this card away</source>
        <translation>Fermer cette carte</translation>
    </message>
    <message>
        <source>For who mends labcal; a problem report holds it:</source>
        <translation>Pour qui répare labcal&#xa0;; un rapport de problème le contient&#xa0;:</translation>
    </message>
</context>
<context>
    <name>FitPage</name>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Estimate by maximum likelihood, the default method</source>
        <translation>Estimer par maximum de vraisemblance, la méthode par défaut</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Estimate by every method, to see whether they agree</source>
        <translation>Estimer par chaque méthode, pour voir si elles s&apos;accordent</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation>Arrêter ce qui se calcule&#xa0;; ce qui est fait reste</translation>
    </message>
    <message>
        <source>Make a draft</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Write a draft calibration from the selected method</source>
        <translation>Écrire un projet d&apos;étalonnage avec la méthode choisie</translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation>Expliquer le résidu</translation>
    </message>
    <message>
        <source>Find what causes what is left over: the Loop page</source>
        <translation>Trouver d&apos;où vient ce qui reste&#xa0;: page Causes</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Méthodes côte à côte</translation>
    </message>
    <message>
        <source>value ± U, k=2</source>
        <translation>valeur ± U, k=2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>Choose a column to see its pictures</source>
        <translation>Choisir une colonne montre ses images</translation>
    </message>
    <message>
        <source>Whether the fit is good</source>
        <translation>Si l&apos;ajustement est bon</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Pourquoi</translation>
    </message>
    <message>
        <source>What each of them says</source>
        <translation>Ce que dit chacune</translation>
    </message>
    <message>
        <source>computing: {0}</source>
        <translation>calcul&#xa0;: {0}</translation>
    </message>
    <message>
        <source>See what was found</source>
        <translation>Voir le résultat</translation>
    </message>
    <message>
        <source>Pictures and the figures of each method are not kept: Fit works them out again, side by side.</source>
        <translation>Les images et les chiffres de chaque méthode ne sont pas gardés&#xa0;: Ajuster les recalcule, côte à côte.</translation>
    </message>
    <message>
        <source>Fit finds what turns a reading into field: the gains K and the offset k of the sensor. All methods compares eleven ways.</source>
        <translation>Ajuster trouve ce qui fait d&apos;une lecture un champ&#xa0;: les gains K et le décalage k du capteur. Toutes compare onze voies.</translation>
    </message>
    <message>
        <source>b = K m − k: the field b [nT] of the reading m. K are nine gains, a row for each axis of the field; k is the offset [nT].</source>
        <translation>b = K m − k&#xa0;: le champ b [nT] de la lecture m. K, ce sont neuf gains, une ligne par axe du champ&#xa0;; k est le décalage [nT].</translation>
    </message>
    <message>
        <source>The first method takes some seconds.</source>
        <translation>La première méthode prend quelques secondes.</translation>
    </message>
    <message>
        <source>Choose a run above, then Fit.</source>
        <translation>Choisissez une mesure ci-dessus, puis Ajuster.</translation>
    </message>
</context>
<context>
    <name>FitViews</name>
    <message>
        <source>The figures of the papers that the methods are from</source>
        <translation>Les figures des articles d&apos;où viennent les méthodes</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>What the residual is drawn against</source>
        <translation>En fonction de quoi le résidu est tracé</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>En fonction de</translation>
    </message>
    <message>
        <source>residual of |b|  nT</source>
        <translation>résidu de |b|  nT</translation>
    </message>
    <message>
        <source>|b|  nT</source>
        <translation>|b|  nT</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>échantillons</translation>
    </message>
    <message>
        <source>bias of the reading  nT</source>
        <translation>biais de la lecture  nT</translation>
    </message>
    <message>
        <source>degree of spherical harmonics</source>
        <translation>degré des harmoniques sphériques</translation>
    </message>
    <message>
        <source>rms of the residual  nT</source>
        <translation>rms du résidu  nT</translation>
    </message>
    <message>
        <source>Loci on the sphere (Riwanto 2017, figs. 5, 7)</source>
        <translation>Lieux sur la sphère (Riwanto 2017, fig. 5, 7)</translation>
    </message>
    <message>
        <source>Residual of the magnitude (Crassidis 2003, fig. 3)</source>
        <translation>Résidu du module (Crassidis 2003, fig. 3)</translation>
    </message>
    <message>
        <source>Magnitude and reference (Springmann 2011, figs. 2, 4)</source>
        <translation>Module et référence (Springmann 2011, fig. 2, 4)</translation>
    </message>
    <message>
        <source>Histogram of the residual (Springmann 2011, fig. 7)</source>
        <translation>Histogramme du résidu (Springmann 2011, fig. 7)</translation>
    </message>
    <message>
        <source>Bias and 3σ as readings come (Crassidis 2003, figs. 1, 2)</source>
        <translation>Biais et 3σ au fil des lectures (Crassidis 2003, fig. 1, 2)</translation>
    </message>
    <message>
        <source>Residual on the sphere, by degree (Risbo 2003)</source>
        <translation>Résidu sur la sphère, par degré (Risbo 2003)</translation>
    </message>
    <message>
        <source>grey: as read   strong: calibrated   faint: behind the sphere</source>
        <translation>gris&#xa0;: tel que lu   soutenu&#xa0;: étalonné   pâle&#xa0;: derrière la sphère</translation>
    </message>
    <message>
        <source>the ekf, or the filter that is chosen above</source>
        <translation>l&apos;ekf, ou le filtre choisi ci-dessus</translation>
    </message>
    <message>
        <source>lines: what scatter alone gives   2: products of two components   3: a cubic</source>
        <translation>lignes&#xa0;: ce que donne la dispersion seule   2&#xa0;: produits de deux composantes   3&#xa0;: cubique</translation>
    </message>
    <message>
        <source>band: the noise that this method makes of its own residual, k=2; none is stated</source>
        <translation>bande&#xa0;: le bruit que cette méthode tire de son propre résidu, k=2&#xa0;; aucun n&apos;est indiqué</translation>
    </message>
    <message>
        <source>band: the stated noise of |b|, k=2</source>
        <translation>bande&#xa0;: le bruit indiqué de |b|, k=2</translation>
    </message>
    <message>
        <source>line: the noise that this method makes of its own residual; none is stated</source>
        <translation>ligne&#xa0;: le bruit que cette méthode tire de son propre résidu&#xa0;; aucun n&apos;est indiqué</translation>
    </message>
    <message>
        <source>line: the stated noise of |b|</source>
        <translation>ligne&#xa0;: le bruit indiqué de |b|</translation>
    </message>
    <message>
        <source>as read</source>
        <translation>tel que lu</translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation>étalonné</translation>
    </message>
    <message>
        <source>mean {0} nT, rms {1} nT</source>
        <translation>moyenne {0} nT, rms {1} nT</translation>
    </message>
</context>
<context>
    <name>Frame</name>
    <message>
        <source>What is next for this DUT, whichever page is open (Ctrl+N)</source>
        <translation>La suite pour ce DUT, quelle que soit la page (Ctrl+N)</translation>
    </message>
    <message>
        <source>Next has just changed, and did nothing. It is now: {0}. Press it again.</source>
        <translation>Suite vient de changer et n&apos;a rien fait. C&apos;est maintenant&#xa0;: {0}. Appuyer de nouveau.</translation>
    </message>
    <message>
        <source>{0} (Ctrl+{1})</source>
        <translation>{0} (Ctrl+{1})</translation>
    </message>
    <message>
        <source>the page {0}</source>
        <translation>la page {0}</translation>
    </message>
    <message>
        <source>Keys   F1</source>
        <translation>Touches   F1</translation>
    </message>
    <message>
        <source>Which keys there are, and what each does</source>
        <translation>Quelles touches il y a, et ce que fait chacune</translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation>cette feuille</translation>
    </message>
    <message>
        <source>Dark or light; until then as the system has it</source>
        <translation>Sombre ou clair&#xa0;; jusque-là comme le système</translation>
    </message>
    <message>
        <source>Letters to be read from two metres, and back (F11)</source>
        <translation>Lettres lisibles à deux mètres, et retour (F11)</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Until somebody logs in; COILS OFF works all the same</source>
        <translation>Jusqu&apos;à ce que quelqu&apos;un s&apos;identifie&#xa0;; BOBINES À ZÉRO marche quand même</translation>
    </message>
    <message>
        <source>Two tones where you are needed, three where it is done; or neither</source>
        <translation>Deux tons quand on a besoin de vous, trois quand c&apos;est fini&#xa0;; ou aucun</translation>
    </message>
    <message>
        <source>The window in this language; not while a run goes on</source>
        <translation>La fenêtre dans cette langue&#xa0;; pas pendant une mesure</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Suite&#xa0;: {0}</translation>
    </message>
    <message>
        <source>coils off, at any moment</source>
        <translation>bobines à zéro, à tout moment</translation>
    </message>
    <message>
        <source>held for {0} s: the answer on the button of this key</source>
        <translation>tenue {0} s&#xa0;: la réponse du bouton de cette touche</translation>
    </message>
    <message>
        <source>to the next field or button; Shift and Tab goes back, Space presses a button or picks a row, but no answer that mounts, energises or moves: its own key is held</source>
        <translation>au champ ou bouton suivant&#xa0;; Maj et Tab revient, Espace presse un bouton ou choisit une ligne, mais aucune réponse qui monte, alimente ou déplace&#xa0;: sa propre touche est maintenue</translation>
    </message>
</context>
<context>
    <name>GoingDown</name>
    <message>
        <source>Closing</source>
        <translation>Fermeture</translation>
    </message>
    <message>
        <source>Going to zero; the window closes after that …</source>
        <translation>Retour à zéro&#xa0;; la fenêtre se ferme ensuite …</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Rester</translation>
    </message>
    <message>
        <source>The run ends, and the window does not close (Esc)</source>
        <translation>La mesure s&apos;arrête, et la fenêtre ne se ferme pas (Échap)</translation>
    </message>
    <message>
        <source>HANDS OFF: not at zero yet. The window does not close by itself.</source>
        <translation>MAINS LOIN&#xa0;: pas encore à zéro. La fenêtre ne se ferme pas d’elle-même.</translation>
    </message>
    <message>
        <source>The run has ended; the window closes.</source>
        <translation>La mesure est terminée&#xa0;; la fenêtre se ferme.</translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Runs</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Search: DUT, day …</source>
        <translation>DUT, jour …</translation>
    </message>
    <message>
        <source>Several words narrow it down: EM-07 yesterday explained; or 22.11.2026</source>
        <translation>Plusieurs mots précisent&#xa0;: EM-07 hier explained&#xa0;; ou 22.11.2026</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Look at this run on the Fit page; nothing recorded is ever changed</source>
        <translation>Regarder cette mesure à la page Ajuster&#xa0;; rien d&apos;enregistré ne change jamais</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exporter …</translation>
    </message>
    <message>
        <source>As bundle, CSV, HDF5 or MATLAB file; of several runs a bundle each</source>
        <translation>En paquet, CSV, HDF5 ou MATLAB&#xa0;; de plusieurs mesures un paquet chacune</translation>
    </message>
    <message>
        <source>Correct serial …</source>
        <translation>Corriger …</translation>
    </message>
    <message>
        <source>The DUT was another one: an event of the record, until a calibration of the run is signed</source>
        <translation>Le DUT était un autre&#xa0;: un événement de l&apos;enregistrement, jusqu&apos;à la signature d&apos;un étalonnage</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Importer …</translation>
    </message>
    <message>
        <source>A run bundle (.zip) or a recording of others; or drop the file on the window</source>
        <translation>Un paquet de mesures (.zip) ou un enregistrement tiers&#xa0;; ou déposez le fichier sur la fenêtre</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Choose two runs (Ctrl and a click): their figures, residuals and loci</source>
        <translation>Choisir deux mesures (Ctrl et un clic)&#xa0;: leurs valeurs, résidus et lieux</translation>
    </message>
    <message>
        <source>No such run. A run from the Run page, or an imported bundle, comes up here.</source>
        <translation>Aucune telle mesure. Une mesure de la page Mesure, ou un paquet importé, apparaît ici.</translation>
    </message>
    <message>
        <source>{0} UTC</source>
        <translation>{0} UTC</translation>
    </message>
    <message>
        <source>The bundle as it was pushed (.zip): import it on this computer to open it</source>
        <translation>Le paquet tel qu’il fut envoyé (.zip)&#xa0;: l’importer sur cet ordinateur pour l’ouvrir</translation>
    </message>
    <message>
        <source>Runs of this computer, or those of all benches in the archive, which are only looked at</source>
        <translation>Les mesures de cet ordinateur, ou celles de tous les bancs dans l’archive, que l’on ne fait que consulter</translation>
    </message>
    <message>
        <source>Where the runs are</source>
        <translation>Où sont les mesures</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>Cet ordinateur</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>The archive was not read. {0}</source>
        <translation>L’archive n’a pas été lue. {0}</translation>
    </message>
    <message>
        <source>Asking the archive …</source>
        <translation>L’archive est interrogée …</translation>
    </message>
    <message>
        <source>The archive has no such run.</source>
        <translation>L’archive n’a pas de telle mesure.</translation>
    </message>
    <message>
        <source>Correct the serial</source>
        <translation>Corriger le numéro</translation>
    </message>
    <message>
        <source>Serial of the DUT of run {0}:</source>
        <translation>Numéro de série du DUT de la mesure {0}&#xa0;:</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Rien n&apos;a été changé.</translation>
    </message>
    <message>
        <source>Run {0}: DUT {1}</source>
        <translation>Mesure {0}&#xa0;: DUT {1}</translation>
    </message>
    <message>
        <source>Comparing {0} with {1} …</source>
        <translation>Comparaison de {0} avec {1} …</translation>
    </message>
    <message>
        <source>Export the run</source>
        <translation>Exporter la mesure</translation>
    </message>
    <message>
        <source>A bundle of each chosen run, into this folder</source>
        <translation>Un paquet par mesure choisie, dans ce dossier</translation>
    </message>
    <message>
        <source>{0} is there already; nothing was written.</source>
        <translation>{0} existe déjà&#xa0;; rien n&apos;a été écrit.</translation>
    </message>
    <message>
        <source>Choose another folder.</source>
        <translation>Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Exported: {0}</source>
        <translation>Exporté&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Run bundles (*.zip)</source>
        <translation>Paquets de mesures (*.zip)</translation>
    </message>
    <message>
        <source>Recordings of others (*)</source>
        <translation>Enregistrements tiers (*)</translation>
    </message>
    <message>
        <source>Import a run</source>
        <translation>Importer une mesure</translation>
    </message>
</context>
<context>
    <name>HoldButton</name>
    <message>
        <source>▲ Let go of {0}: it was down before this question came. Then hold it for 0.7 s.</source>
        <translation>▲ Lâchez {0}&#xa0;: la touche était déjà enfoncée avant cette question. Puis tenez-la 0,7 s.</translation>
    </message>
    <message>
        <source>▲ {0} was pressed before this question took an answer. Press it anew.</source>
        <translation>▲ {0} a été pressée avant que cette question prenne une réponse. Pressez de nouveau.</translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold {1} for 0.7 s.</source>
        <translation>▲ Lâché trop tôt, après {0} s&#xa0;: tenir {1} 0,7 s.</translation>
    </message>
    <message>
        <source>▲ Let go too early: the mouse has left the button. Hold {1} for 0.7 s.</source>
        <translation>▲ Lâché trop tôt&#xa0;: la souris a quitté le bouton. Tenir {1} 0,7 s.</translation>
    </message>
    <message>
        <source>▲ Let go too early, after {0} s: hold this button, or {1}, for 0.7 s.</source>
        <translation>▲ Lâché trop tôt, après {0} s&#xa0;: tenir ce bouton, ou {1}, 0,7 s.</translation>
    </message>
</context>
<context>
    <name>KeySheet</name>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>While this sheet is open no key answers a question; COILS OFF (F12) works.</source>
        <translation>Tant que cette feuille est ouverte, aucune touche ne répond à une question&#xa0;; BOBINES À ZÉRO (F12) agit.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Put this sheet away (Esc)</source>
        <translation>Fermer cette feuille (Échap)</translation>
    </message>
</context>
<context>
    <name>LabWatch</name>
    <message>
        <source>the guardian of the last session has it</source>
        <translation>tenu par le gardien de la dernière session</translation>
    </message>
    <message>
        <source>still at work</source>
        <translation>encore au travail</translation>
    </message>
    <message>
        <source>A run goes on and reads the instruments itself; the DUT is read again in its next step.</source>
        <translation>Une mesure est en cours et lit elle-même les appareils&#xa0;; le DUT est relu à son étape suivante.</translation>
    </message>
    <message>
        <source>Reading every instrument; nothing is set …</source>
        <translation>Lecture de tous les appareils&#xa0;; rien n&apos;est réglé …</translation>
    </message>
    <message>
        <source>{0} of {1} instruments were read</source>
        <translation>{0} appareils sur {1} ont été lus</translation>
    </message>
    <message>
        <source>; the guardian of the last session has {0} until {1} is read back at zero</source>
        <translation>&#xa0;; le gardien de la dernière session tient {0} jusqu’à ce que {1} soit relu à zéro</translation>
    </message>
    <message>
        <source>; another process has {0}</source>
        <translation>&#xa0;; un autre processus tient {0}</translation>
    </message>
</context>
<context>
    <name>LazyPage</name>
    <message>
        <source>This page is being made ready …</source>
        <translation>Cette page est en préparation …</translation>
    </message>
    <message>
        <source>All other pages work. Mend the package that brings this page, or uninstall it.</source>
        <translation>Toutes les autres pages marchent. Réparez le paquet de cette page, ou retirez-le.</translation>
    </message>
</context>
<context>
    <name>Leaving</name>
    <message>
        <source>Show the run</source>
        <translation>Montrer la mesure</translation>
    </message>
    <message>
        <source>COILS OFF</source>
        <translation>BOBINES À ZÉRO</translation>
    </message>
</context>
<context>
    <name>LeftWithoutEnd</name>
    <message>
        <source>Another process still drives a run of {0} on this bench: wait until it has ended.</source>
        <translation>Un autre processus conduit encore une mesure de {0} sur ce banc&#xa0;: attendre qu&apos;elle soit terminée.</translation>
    </message>
</context>
<context>
    <name>Live</name>
    <message>
        <source>Whose run this is</source>
        <translation>À qui est cette mesure</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pausing …</source>
        <translation>Pause à venir …</translation>
    </message>
    <message>
        <source>Wait where the next step begins, with the coils at zero</source>
        <translation>Attendre au début de l&apos;étape suivante, bobines à zéro</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>End this run now, in order. The coils go to zero; what was measured is kept.</source>
        <translation>Terminer cette mesure, en ordre. Les bobines vont à zéro&#xa0;; le mesuré est gardé.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Back to the procedures; the run is in the History</source>
        <translation>Retour aux procédures&#xa0;; la mesure est dans l&apos;Historique</translation>
    </message>
    <message>
        <source>What is missing of this run</source>
        <translation>Ce qui manque à cette mesure</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Fit</translation>
    </message>
    <message>
        <source>Estimate the calibration from this run</source>
        <translation>Estimer l&apos;étalonnage à partir de cette mesure</translation>
    </message>
    <message>
        <source>as it was mounted</source>
        <translation>tel que monté</translation>
    </message>
    <message>
        <source>Here that is Go on: what was finished is kept.</source>
        <translation>Ici, c&apos;est «&#xa0;Continuer&#xa0;»&#xa0;: ce qui est terminé est gardé.</translation>
    </message>
    <message>
        <source>This run has ended: Close, then Begin measures anew.</source>
        <translation>Cette mesure est finie&#xa0;: «&#xa0;Fermer&#xa0;», puis «&#xa0;Démarrer&#xa0;» mesure de nouveau.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>What was measured is kept in the History. To measure again: Close, then Begin.</source>
        <translation>Le mesuré reste dans l&apos;Historique. Pour remesurer&#xa0;: Fermer, puis Démarrer.</translation>
    </message>
    <message>
        <source>{0} Or Close, and begin anew.</source>
        <translation>{0} Ou Fermer, et recommencer.</translation>
    </message>
</context>
<context>
    <name>LockScreen</name>
    <message>
        <source>Who works here?</source>
        <translation>Qui travaille ici&#xa0;?</translation>
    </message>
    <message>
        <source>Your name in the trust list</source>
        <translation>Votre nom dans la liste de confiance</translation>
    </message>
    <message>
        <source>Name, or scan your badge</source>
        <translation>Nom, ou scannez votre badge</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Entrer</translation>
    </message>
    <message>
        <source>Your name stands in the record from here on</source>
        <translation>Votre nom figure dans l&apos;enregistrement à partir d&apos;ici</translation>
    </message>
    <message>
        <source>COILS OFF (F12) works all the same. A name says who is meant; signing still asks for your key.</source>
        <translation>BOBINES À ZÉRO (F12) marche quand même. Un nom dit de qui il s&apos;agit&#xa0;; signer demande toujours votre clé.</translation>
    </message>
</context>
<context>
    <name>LoginViewModel</name>
    <message>
        <source>Nobody of the trust list has the name {0}.</source>
        <translation>Personne de la liste de confiance ne s&apos;appelle {0}.</translation>
    </message>
    <message>
        <source>Log in first.</source>
        <translation>Identifiez-vous d&apos;abord.</translation>
    </message>
    <message>
        <source>{0} has not the role measure in the trust list.</source>
        <translation>{0} n&apos;a pas le rôle measure dans la liste de confiance.</translation>
    </message>
</context>
<context>
    <name>Logo</name>
    <message>
        <source>The laboratory&apos;s logo</source>
        <translation>Le logo du laboratoire</translation>
    </message>
</context>
<context>
    <name>LoopPage</name>
    <message>
        <source>Trace the residual</source>
        <translation>Expliquer le résidu</translation>
    </message>
    <message>
        <source>Find what causes what is left over</source>
        <translation>Trouver d&apos;où vient ce qui reste</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>End what is being computed; what is done stays</source>
        <translation>Arrêter ce qui se calcule&#xa0;; ce qui est fait reste</translation>
    </message>
    <message>
        <source>To the certificate</source>
        <translation>Au certificat</translation>
    </message>
    <message>
        <source>The draft with the accepted effects: approve and sign it</source>
        <translation>Le projet avec les effets retenus&#xa0;: approuver et signer</translation>
    </message>
    <message>
        <source>In figures</source>
        <translation>En chiffres</translation>
    </message>
    <message>
        <source>The loop&apos;s own words: held-out rms, tests, rows set aside</source>
        <translation>Les mots du calcul&#xa0;: rms mis de côté, tests, lignes écartées</translation>
    </message>
    <message>
        <source>1  What is left over</source>
        <translation>1  Ce qui reste</translation>
    </message>
    <message>
        <source>noise k=2</source>
        <translation>bruit k=2</translation>
    </message>
    <message>
        <source>Band: the noise of one axis of one row</source>
        <translation>Bande&#xa0;: le bruit d’un axe d’une ligne</translation>
    </message>
    <message>
        <source>3  What could cause it</source>
        <translation>3  Causes possibles</translation>
    </message>
    <message>
        <source>beside declared errors</source>
        <translation>à part les erreurs déclarées</translation>
    </message>
    <message>
        <source>2  What it changes</source>
        <translation>2  Ce que cela change</translation>
    </message>
    <message>
        <source>Choose one to see what it alone would change.</source>
        <translation>Choisissez-en une pour voir ce qu&apos;elle seule changerait.</translation>
    </message>
    <message>
        <source>No cause was searched for: 4 says why.</source>
        <translation>Aucune cause n’a été cherchée&#xa0;: 4 dit pourquoi.</translation>
    </message>
    <message>
        <source>What the residual is drawn against; the named cause first</source>
        <translation>En fonction de quoi le résidu est tracé&#xa0;; la cause nommée d&apos;abord</translation>
    </message>
    <message>
        <source>4  Still not known</source>
        <translation>4  Encore inconnu</translation>
    </message>
    <message>
        <source>Its plan is shown on the Run page before anything moves, and the run is started there</source>
        <translation>Son plan est montré à la page Mesure avant tout mouvement&#xa0;; c&apos;est là qu&apos;on démarre</translation>
    </message>
    <message>
        <source>This run is of {0}; the DUT at the top is {1}. Put {0} on the bench, and scan it.</source>
        <translation>Cette mesure est de {0}&#xa0;; le DUT en haut est {1}. Mettez {0} sur le banc, et lisez son code.</translation>
    </message>
    <message>
        <source>Work it out again</source>
        <translation>Recalculer</translation>
    </message>
    <message>
        <source>Choose a run above, then let its residual be traced to a cause.</source>
        <translation>Choisissez une mesure ci-dessus, puis faites remonter son résidu à une cause.</translation>
    </message>
    <message>
        <source>Looking at the residual; a whole preflight takes some minutes.</source>
        <translation>Examen du résidu&#xa0;; un préflight entier prend quelques minutes.</translation>
    </message>
    <message>
        <source>Trace the residual of this run to its cause.</source>
        <translation>Remonter du résidu de cette mesure à sa cause.</translation>
    </message>
    <message>
        <source>Pictures and the figures of each cause are not kept: “Work it out again” makes them.</source>
        <translation>Les images et les chiffres de chaque cause ne sont pas gardés&#xa0;: «&#xa0;Recalculer&#xa0;» les refait.</translation>
    </message>
    <message>
        <source>These figures are beside the errors that the run declares; above they are in it.</source>
        <translation>Ces chiffres sont à part les erreurs que la mesure déclare&#xa0;; en haut elles y sont.</translation>
    </message>
    <message>
        <source>as calibrated</source>
        <translation>tel qu&apos;étalonné</translation>
    </message>
    <message>
        <source>or {0}</source>
        <translation>ou {0}</translation>
    </message>
    <message>
        <source>Added to it: {0}.</source>
        <translation>Ajouté&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Rows set aside: {0} {1}</source>
        <translation>Lignes écartées&#xa0;: {0} {1}</translation>
    </message>
    <message>
        <source>“{0}” explains it about as well as “{1}”.</source>
        <translation>«&#xa0;{0}&#xa0;» l&apos;explique à peu près aussi bien que «&#xa0;{1}&#xa0;».</translation>
    </message>
    <message>
        <source>Measured by the procedure {0}.</source>
        <translation>Mesuré par la procédure {0}.</translation>
    </message>
    <message>
        <source>Nothing that this run could show.</source>
        <translation>Rien que cette mesure puisse montrer.</translation>
    </message>
    <message>
        <source>Measure what would tell them apart</source>
        <translation>Mesurer ce qui les distingue</translation>
    </message>
    <message>
        <source>Measure what is missing</source>
        <translation>Mesurer ce qui manque</translation>
    </message>
    <message>
        <source>2  With “{0}”</source>
        <translation>2  Avec «&#xa0;{0}&#xa0;»</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcul …</translation>
    </message>
    <message>
        <source>it alone would leave {0} nT of the rows of the fit</source>
        <translation>elle seule laisserait {0} nT des lignes ajustées</translation>
    </message>
    <message>
        <source>with it</source>
        <translation>avec elle</translation>
    </message>
</context>
<context>
    <name>Mounting</name>
    <message>
        <source>Drawing: body {0} up</source>
        <translation>Dessin&#xa0;: axe {0} du corps en haut</translation>
    </message>
    <message>
        <source>Drawing of a dial</source>
        <translation>Dessin d&apos;un cadran</translation>
    </message>
    <message>
        <source>drawn for platform angle 0°; where it stands is not known</source>
        <translation>dessiné pour l’angle 0° de la plate-forme&#xa0;; où elle se trouve n’est pas connu</translation>
    </message>
    <message>
        <source>platform at {0}°</source>
        <translation>plate-forme à {0}°</translation>
    </message>
</context>
<context>
    <name>NamedSerials</name>
    <message>
        <source>{0}: is this the right sensor?</source>
        <translation>{0}&#xa0;: est-ce le bon capteur&#xa0;?</translation>
    </message>
    <message>
        <source>names itself {0}, not {1}</source>
        <translation>se nomme {0}, et non {1}</translation>
    </message>
</context>
<context>
    <name>NamesCard</name>
    <message>
        <source>Named on the certificate</source>
        <translation>Nommés sur le certificat</translation>
    </message>
    <message>
        <source>Laboratory on the certificate</source>
        <translation>Laboratoire sur le certificat</translation>
    </message>
    <message>
        <source>The laboratory is asked for once. Its logo: logo.png or logo.svg in labcal&apos;s folder.</source>
        <translation>Le laboratoire n&apos;est demandé qu&apos;une fois. Son logo&#xa0;: logo.png ou logo.svg dans le dossier de labcal.</translation>
    </message>
    <message>
        <source>Customer on the certificate</source>
        <translation>Client sur le certificat</translation>
    </message>
    <message>
        <source>For no customer in particular? Leave it empty.</source>
        <translation>Pour aucun client en particulier&#xa0;? Laisser vide.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>The laboratory is remembered for every certificate</source>
        <translation>Le laboratoire est retenu pour chaque certificat</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Modifier …</translation>
    </message>
    <message>
        <source>State the laboratory, or the customer, anew</source>
        <translation>Indiquer de nouveau le laboratoire ou le client</translation>
    </message>
    <message>
        <source>City</source>
        <translation>Ville</translation>
    </message>
    <message>
        <source>A country is two letters, as DE, or its name.</source>
        <translation>Un pays s’écrit en deux lettres, comme FR, ou par son nom.</translation>
    </message>
    <message>
        <source>Keep waits for: {0}.</source>
        <translation>Garder attend&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Being kept …</source>
        <translation>Est gardé …</translation>
    </message>
    <message>
        <source>Laboratory: {0}</source>
        <translation>Laboratoire&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Country, as DE</source>
        <translation>Pays, comme FR</translation>
    </message>
    <message>
        <source>Customer: {0}</source>
        <translation>Client&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The certificate names no laboratory.</source>
        <translation>Le certificat ne nomme aucun laboratoire.</translation>
    </message>
    <message>
        <source>The certificate names no customer.</source>
        <translation>Le certificat ne nomme aucun client.</translation>
    </message>
    <message>
        <source>The certificate names no laboratory and no customer.</source>
        <translation>Le certificat ne nomme ni laboratoire ni client.</translation>
    </message>
    <message>
        <source>Certificate of {0}, for {1}.</source>
        <translation>Certificat de {0}, pour {1}.</translation>
    </message>
    <message>
        <source>✕ “{0}” is no country: two letters, as DE, or its name.</source>
        <translation>✕ «&#xa0;{0}&#xa0;» n’est pas un pays&#xa0;: deux lettres, comme DE, ou son nom.</translation>
    </message>
</context>
<context>
    <name>NoFit</name>
    <message>
        <source>The other methods</source>
        <translation>Les autres méthodes</translation>
    </message>
    <message>
        <source>Estimate by every method that was not tried yet</source>
        <translation>Estimer par chaque méthode pas encore essayée</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Mesurer de nouveau</translation>
    </message>
    <message>
        <source>To the preflight of this DUT on the Run page</source>
        <translation>Au preflight de ce DUT sur la page Mesure</translation>
    </message>
</context>
<context>
    <name>OneDut</name>
    <message>
        <source>{0}: what is being computed goes on.</source>
        <translation>{0}&#xa0;: le calcul en cours continue.</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>Report …</source>
        <translation>Rapport …</translation>
    </message>
    <message>
        <source>For people as .html or .pdf, for machines as a DCC (.xml, PTB&apos;s schema)</source>
        <translation>Pour les personnes en .html ou .pdf, pour les machines en DCC (.xml, schéma de la PTB)</translation>
    </message>
    <message>
        <source>A folder with all that goes to the customer; the certificate on paper, a label for the DUT</source>
        <translation>Un dossier avec tout ce qui va au client&#xa0;; le certificat sur papier, une étiquette pour le DUT</translation>
    </message>
    <message>
        <source>Apply to readings …</source>
        <translation>Appliquer …</translation>
    </message>
    <message>
        <source>Add the field, its uncertainty and flags to a .csv of readings</source>
        <translation>Ajouter le champ, son incertitude et ses repères à un .csv de lectures</translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation>Remettre</translation>
    </message>
    <message>
        <source>4  Hand it out</source>
        <translation>4  Remettre</translation>
    </message>
    <message>
        <source>All into one folder …</source>
        <translation>Tout dans un dossier …</translation>
    </message>
    <message>
        <source>Print the certificate</source>
        <translation>Imprimer le certificat</translation>
    </message>
    <message>
        <source>Print a label for the DUT</source>
        <translation>Imprimer une étiquette pour le DUT</translation>
    </message>
    <message>
        <source>Label as a file …</source>
        <translation>Étiquette en fichier …</translation>
    </message>
    <message>
        <source>Sent to the printer: {0}</source>
        <translation>Envoyé à l&apos;imprimante&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Asking the printer …</source>
        <translation>L&apos;imprimante est interrogée …</translation>
    </message>
    <message>
        <source>Write the label</source>
        <translation>Écrire l&apos;étiquette</translation>
    </message>
    <message>
        <source>Written: {0}</source>
        <translation>Écrit&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Écriture du rapport …</translation>
    </message>
    <message>
        <source>Copy the calibration to: a folder, or the name of a new one</source>
        <translation>Copier l&apos;étalonnage vers&#xa0;: un dossier, ou le nom d&apos;un nouveau</translation>
    </message>
    <message>
        <source>Copy here</source>
        <translation>Copier ici</translation>
    </message>
    <message>
        <source>Handed out into {0}:</source>
        <translation>Remis dans {0}&#xa0;:</translation>
    </message>
    <message>
        <source>Writing the certificate …</source>
        <translation>Écriture du certificat …</translation>
    </message>
    <message>
        <source>Readings of this DUT</source>
        <translation>Lectures de ce DUT</translation>
    </message>
    <message>
        <source>Where the field goes</source>
        <translation>Où écrire le champ</translation>
    </message>
</context>
<context>
    <name>ParameterForm</name>
    <message>
        <source>Settings that most runs leave as they are</source>
        <translation>Réglages que la plupart des mesures laissent tels quels</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Choisir …</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>requis</translation>
    </message>
    <message>
        <source>expected {0}</source>
        <translation>attendu {0}</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>▾ Fewer settings</source>
        <translation>▾ Moins de réglages</translation>
    </message>
    <message>
        <source>▸ More settings: {0}</source>
        <translation>▸ Autres réglages&#xa0;: {0}</translation>
    </message>
</context>
<context>
    <name>PathViewModel</name>
    <message>
        <source>was stopped before its end</source>
        <translation>a été arrêtée avant sa fin</translation>
    </message>
    <message>
        <source>still goes on</source>
        <translation>est encore en cours</translation>
    </message>
    <message>
        <source>What it did not measure would be missing in the calibration. Measure again on the Run page.</source>
        <translation>Ce qu&apos;elle n&apos;a pas mesuré manquerait à l&apos;étalonnage. Remesurez à la page Mesure.</translation>
    </message>
    <message>
        <source>What it has not measured yet would be missing: go on with it on the Start page.</source>
        <translation>Ce qu&apos;elle n&apos;a pas encore mesuré manquerait&#xa0;: continuez à la page Accueil.</translation>
    </message>
    <message>
        <source>Run {0} {1}. {2}</source>
        <translation>La mesure {0} {1}. {2}</translation>
    </message>
    <message>
        <source>Open a bench</source>
        <translation>Ouvrir un banc</translation>
    </message>
    <message>
        <source>See the run</source>
        <translation>Voir la mesure</translation>
    </message>
    <message>
        <source>Answer the question</source>
        <translation>Répondre à la question</translation>
    </message>
    <message>
        <source>Wait for the other process</source>
        <translation>Attendre l&apos;autre processus</translation>
    </message>
    <message>
        <source>Stop the platform (COILS OFF)</source>
        <translation>Arrêter la plate-forme (BOBINES À ZÉRO)</translation>
    </message>
    <message>
        <source>See to the coils</source>
        <translation>S&apos;occuper des bobines</translation>
    </message>
    <message>
        <source>See to {0}</source>
        <translation>S&apos;occuper de {0}</translation>
    </message>
    <message>
        <source>Say which DUT</source>
        <translation>Nommer le DUT</translation>
    </message>
    <message>
        <source>Say who works here</source>
        <translation>Dire qui travaille</translation>
    </message>
    <message>
        <source>Try the other methods</source>
        <translation>Essayer les autres méthodes</translation>
    </message>
    <message>
        <source>Calibrate {0}</source>
        <translation>Étalonner {0}</translation>
    </message>
    <message>
        <source>was broken off: {0}</source>
        <translation>a été interrompue&#xa0;: {0}</translation>
    </message>
    <message>
        <source>was broken off</source>
        <translation>a été interrompue</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Continuer {0}</translation>
    </message>
    <message>
        <source>See how far the trace is</source>
        <translation>Voir la recherche en cours</translation>
    </message>
    <message>
        <source>See how far the fit is</source>
        <translation>Voir l&apos;ajustement en cours</translation>
    </message>
    <message>
        <source>Fit the run</source>
        <translation>Ajuster la mesure</translation>
    </message>
    <message>
        <source>Trace the residual</source>
        <translation>Expliquer le résidu</translation>
    </message>
    <message>
        <source>See what is not known</source>
        <translation>Voir ce qui reste inconnu</translation>
    </message>
    <message>
        <source>Correct {0}</source>
        <translation>Corriger {0}</translation>
    </message>
    <message>
        <source>Measure {0} again</source>
        <translation>Mesurer {0} de nouveau</translation>
    </message>
    <message>
        <source>Approve and sign</source>
        <translation>Approuver et signer</translation>
    </message>
    <message>
        <source>Make a new draft</source>
        <translation>Faire un nouveau projet</translation>
    </message>
    <message>
        <source>The second signature</source>
        <translation>La seconde signature</translation>
    </message>
    <message>
        <source>The next DUT</source>
        <translation>Le DUT suivant</translation>
    </message>
    <message>
        <source>Hand it out, as {0}</source>
        <translation>Remettre le certificat, comme {0}</translation>
    </message>
    <message>
        <source>Hand it out</source>
        <translation>Remettre le certificat</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signer</translation>
    </message>
</context>
<context>
    <name>PausedHands</name>
    <message>
        <source>Whether hands may go in</source>
        <translation>Si les mains peuvent entrer</translation>
    </message>
</context>
<context>
    <name>Printer</name>
    <message>
        <source>this computer has no program {0}</source>
        <translation>cet ordinateur n&apos;a pas de programme {0}</translation>
    </message>
    <message>
        <source>{0} ended with {1}</source>
        <translation>{0} s&apos;est terminé avec {1}</translation>
    </message>
    <message>
        <source>Not printed ({0}): opened, to be printed from there.</source>
        <translation>Non imprimé ({0})&#xa0;: ouvert, à imprimer de là.</translation>
    </message>
</context>
<context>
    <name>ProcedureList</name>
    <message>
        <source>Procedures</source>
        <translation>Procédures</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>By name, by what it does, or by what it needs</source>
        <translation>Par nom, par but, ou par besoin</translation>
    </message>
    <message>
        <source>None is found. Fewer words, or a part of one?</source>
        <translation>Rien trouvé. Moins de mots, ou une partie&#xa0;?</translation>
    </message>
</context>
<context>
    <name>PromptCard</name>
    <message>
        <source>Question to you</source>
        <translation>Question pour vous</translation>
    </message>
    <message>
        <source>YOUR TURN</source>
        <translation>À VOUS</translation>
    </message>
    <message>
        <source>How the coils are</source>
        <translation>État des bobines</translation>
    </message>
    <message>
        <source>Write it here</source>
        <translation>Écrivez-le ici</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Choisir un fichier …</translation>
    </message>
    <message>
        <source>Whether hands may go in</source>
        <translation>Si les mains peuvent entrer</translation>
    </message>
    <message>
        <source>How the platform is</source>
        <translation>État de la plateforme</translation>
    </message>
    <message>
        <source>What moved while an instrument was silent</source>
        <translation>Ce qui a bougé pendant qu’un instrument se taisait</translation>
    </message>
    <message>
        <source>Who names another serial</source>
        <translation>Qui nomme un autre numéro de série</translation>
    </message>
    <message>
        <source>The simulated bench began anew: its platform is at its zero, nothing has turned.</source>
        <translation>Le banc simulé a recommencé&#xa0;: sa plate-forme est à zéro, rien n&apos;a tourné.</translation>
    </message>
    <message>
        <source>Write the path of a file into the answer</source>
        <translation>Écrire le chemin d&apos;un fichier dans la réponse</translation>
    </message>
    <message>
        <source>Scan it, or type it</source>
        <translation>Lisez-le ou tapez-le</translation>
    </message>
    <message>
        <source>Not yet: what it waits for stands above.</source>
        <translation>Pas encore&#xa0;: ce qui est attendu est écrit au-dessus.</translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation>{0}&#xa0;: répond de nouveau</translation>
    </message>
    <message>
        <source>Every instrument answers again.</source>
        <translation>Chaque instrument répond de nouveau.</translation>
    </message>
    <message>
        <source>Skipped, it is missing, and this run does not come back to it; only Redo axis, where that is offered at the next mounting, turns its axis again. The verdict says so, and a calibration may lack what it would tell.</source>
        <translation>Sautée, elle manque, et cette mesure n&apos;y revient pas&#xa0;; seul «&#xa0;Refaire l&apos;axe&#xa0;», s&apos;il est proposé au montage suivant, refait tourner son axe. Le verdict le dit, et un étalonnage peut manquer de ce qu&apos;elle aurait montré.</translation>
    </message>
    <message>
        <source>No: nothing is measured, and the run ends. Yes: the record says that you answered so.</source>
        <translation>Non&#xa0;: rien n’est mesuré, et la mesure prend fin. Oui&#xa0;: l’enregistrement dit que vous avez répondu ainsi.</translation>
    </message>
    <message>
        <source>Click, or hold the key for a moment. Enter does nothing here.</source>
        <translation>Cliquez, ou tenez la touche un instant. Entrée ne fait rien ici.</translation>
    </message>
    <message>
        <source>Hold the button, or its key, until it is full. Enter does nothing here.</source>
        <translation>Maintenir le bouton, ou sa touche, jusqu’à ce qu’il soit plein. Entrée ne fait rien ici.</translation>
    </message>
    <message>
        <source>A scan answers by itself; what is typed is sent by Enter.</source>
        <translation>Une lecture répond d&apos;elle-même&#xa0;; ce qui est tapé est envoyé par Entrée.</translation>
    </message>
    <message>
        <source>Yes: it goes on as it stands. No: mount it again first.</source>
        <translation>Oui&#xa0;: on continue tel quel. Non&#xa0;: le remonter d&apos;abord.</translation>
    </message>
    <message>
        <source>No turn was finished: either way it begins with the first step again.</source>
        <translation>Aucune rotation n’est terminée&#xa0;: dans les deux cas on recommence à la première étape.</translation>
    </message>
    <message>
        <source>Either way turns that were finished stay as they are, with their ticks: each mounting has a phase of its own in the fit. First the zero, the axes and the timing are measured again, to see whether anything moved or drifted; then only what is missing.</source>
        <translation>Dans les deux cas, les rotations terminées restent, cochées&#xa0;: chaque montage a sa propre phase dans l&apos;ajustement. D&apos;abord le zéro, les axes et les temps sont mesurés encore, pour voir si quelque chose a bougé ou dérivé&#xa0;; puis seulement ce qui manque.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Go on without a file; the record says so</source>
        <translation>Continuer sans fichier&#xa0;; l&apos;enregistrement le dit</translation>
    </message>
    <message>
        <source>Answer: {0}</source>
        <translation>Réponse&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Click, or hold {0} for 0.7 s</source>
        <translation>Cliquez, ou tenez {0} 0,7 s</translation>
    </message>
    <message>
        <source>Hold this button, or {0}, for 0.7 s</source>
        <translation>Maintenir ce bouton, ou {0}, pendant 0,7 s</translation>
    </message>
    <message>
        <source>A file for the record</source>
        <translation>Un fichier pour l&apos;enregistrement</translation>
    </message>
</context>
<context>
    <name>RecordWords</name>
    <message>
        <source>What the procedure noted</source>
        <translation>Ce que la procédure a noté</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
    <message>
        <source>All that the procedure noted, in its order; no verdict rests on its estimates</source>
        <translation>Tout ce que la procédure a noté, dans l’ordre&#xa0;; aucun verdict ne repose sur ses estimations</translation>
    </message>
</context>
<context>
    <name>RecordingView</name>
    <message>
        <source>Recording {0}: what its columns are</source>
        <translation>Enregistrement {0}&#xa0;: ce que sont ses colonnes</translation>
    </message>
    <message>
        <source>What its columns are</source>
        <translation>Ce que sont ses colonnes</translation>
    </message>
    <message>
        <source>guessed: check every line</source>
        <translation>deviné&#xa0;: vérifiez chaque ligne</translation>
    </message>
    <message>
        <source>Correct a value as a mapping has it (docs/import.md): &quot;uT&quot;, [&quot;y&quot;, &quot;x&quot;, &quot;-z&quot;], &quot;Bx [nT]&quot;; an empty one takes the line away. accept: [&quot;axes&quot;] lets that doubt pass.</source>
        <translation>Corrigez une valeur telle qu’elle figure dans une correspondance (docs/import.md)&#xa0;: &quot;uT&quot;, [&quot;y&quot;, &quot;x&quot;, &quot;-z&quot;], &quot;Bx [nT]&quot;&#xa0;; une valeur vide supprime la ligne. accept&#xa0;: [&quot;axes&quot;] lève ce doute.</translation>
    </message>
    <message>
        <source>Its readings</source>
        <translation>Ses mesures</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>To the list of runs; nothing is imported</source>
        <translation>Vers la liste des mesures&#xa0;; rien n’est importé</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Read the recording by the corrected mapping</source>
        <translation>Lire l’enregistrement selon la correspondance corrigée</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Take it into the store by this mapping, as a run of its own</source>
        <translation>L’ajouter à la base selon cette correspondance, comme une mesure à part</translation>
    </message>
    <message>
        <source>Reading {0} …</source>
        <translation>Lecture de {0} …</translation>
    </message>
    <message>
        <source>▲ Not imported so: {0}</source>
        <translation>▲ Non importable ainsi&#xa0;: {0}</translation>
    </message>
    <message>
        <source>✓ It can be imported. {0}</source>
        <translation>✓ Peut être importé. {0}</translation>
    </message>
    <message>
        <source>{0} changed, not checked</source>
        <translation>{0} modifié(s), non vérifié(s)</translation>
    </message>
    <message>
        <source>Imported: run {0}</source>
        <translation>Importé&#xa0;: mesure {0}</translation>
    </message>
</context>
<context>
    <name>RunChooser</name>
    <message>
        <source>Run</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>The run to look at, the newest first</source>
        <translation>La mesure à regarder, la plus récente d&apos;abord</translation>
    </message>
    <message>
        <source>Choose a run</source>
        <translation>Choisir une mesure</translation>
    </message>
    <message>
        <source>{0} is being measured: its run can be looked at once it has ended.</source>
        <translation>{0} est en cours de mesure&#xa0;: la mesure pourra être regardée une fois finie.</translation>
    </message>
    <message>
        <source>The run in the store has not ended yet: it can be looked at then.</source>
        <translation>La mesure conservée n’est pas encore finie&#xa0;: elle pourra être regardée ensuite.</translation>
    </message>
</context>
<context>
    <name>RunHeadline</name>
    <message>
        <source>What happens now</source>
        <translation>Ce qui se passe</translation>
    </message>
</context>
<context>
    <name>RunNotes</name>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Put a remark with its time into the record, and Enter: “lift moved”. History shows it with the run</source>
        <translation>Mettre une remarque avec son heure dans l&apos;enregistrement, puis Entrée&#xa0;: «&#xa0;ascenseur en marche&#xa0;». L&apos;historique la montre avec la mesure</translation>
    </message>
    <message>
        <source>Photo …</source>
        <translation>Photo …</translation>
    </message>
    <message>
        <source>Put a photograph into the record, with the note as its words</source>
        <translation>Mettre une photo dans l&apos;enregistrement, la note pour légende</translation>
    </message>
    <message>
        <source>Kept in the run&apos;s record, which History shows: {0}</source>
        <translation>Gardé dans l&apos;enregistrement de la mesure, que l&apos;historique montre&#xa0;: {0}</translation>
    </message>
    <message>
        <source>A photograph for the record</source>
        <translation>Une photo pour l&apos;enregistrement</translation>
    </message>
    <message>
        <source>photograph</source>
        <translation>photo</translation>
    </message>
</context>
<context>
    <name>RunViewModel</name>
    <message>
        <source>Coming back to the run that goes on …</source>
        <translation>Retour à la mesure en cours …</translation>
    </message>
    <message>
        <source>Asking every instrument who it is …</source>
        <translation>On demande à chaque instrument qui il est …</translation>
    </message>
    <message>
        <source>Hands off: it goes on.</source>
        <translation>Mains loin&#xa0;: cela continue.</translation>
    </message>
    <message>
        <source>It goes on.</source>
        <translation>Cela continue.</translation>
    </message>
    <message>
        <source>Pauses where the next step begins.</source>
        <translation>Pause au début de l&apos;étape suivante.</translation>
    </message>
    <message>
        <source>{0} begun</source>
        <translation>{0} commencé</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Arrêt …</translation>
    </message>
    <message>
        <source>Coils off: the run ends …</source>
        <translation>Bobines à zéro&#xa0;: la mesure se termine …</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation>Continue</translation>
    </message>
</context>
<context>
    <name>ScanCard</name>
    <message>
        <source>From here on this is the serial of the DUT</source>
        <translation>Désormais, c&apos;est le numéro de série du DUT</translation>
    </message>
    <message>
        <source>The scan is forgotten</source>
        <translation>La lecture est oubliée</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Défaire</translation>
    </message>
    <message>
        <source>The DUT is the one before again</source>
        <translation>Le DUT est de nouveau le précédent</translation>
    </message>
    <message>
        <source>✕ Scanned, and not taken: no serial has blanks</source>
        <translation>✕ Scanné, et non repris&#xa0;: aucun numéro de série n’a d’espace</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Scanned {0}. Is it the DUT from here on? Until now: {1}.</source>
        <translation>{0} lu. Est-ce désormais le DUT&#xa0;? Jusqu&apos;ici&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>The DUT is {0}, in place of {1}.</source>
        <translation>Le DUT est {0}, au lieu de {1}.</translation>
    </message>
    <message>
        <source>Take {0}</source>
        <translation>Prendre {0}</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Leave {0}</source>
        <translation>Laisser {0}</translation>
    </message>
</context>
<context>
    <name>ShownBar</name>
    <message>
        <source>This page shows the DUT to be measured again</source>
        <translation>Cette page montre de nouveau le DUT à mesurer</translation>
    </message>
    <message>
        <source>From here on this is the DUT to be measured: the one that is mounted</source>
        <translation>Dès maintenant c’est le DUT à mesurer&#xa0;: celui qui est monté</translation>
    </message>
    <message>
        <source>To be measured: {0}; the marks at the left and Next are of it.</source>
        <translation>À mesurer&#xa0;: {0}&#xa0;; les marques à gauche et Suite concernent celui-ci.</translation>
    </message>
    <message>
        <source>Which DUT is to be measured is not said yet.</source>
        <translation>Le DUT à mesurer n’est pas encore indiqué.</translation>
    </message>
    <message>
        <source>Shown: {0}. {1}</source>
        <translation>Affiché&#xa0;: {0}. {1}</translation>
    </message>
    <message>
        <source>Back to {0}</source>
        <translation>Retour à {0}</translation>
    </message>
    <message>
        <source>Measure {0}</source>
        <translation>Mesurer {0}</translation>
    </message>
    <message>
        <source>The marks at the left and Next are of no run yet.</source>
        <translation>Les marques à gauche et Suite ne sont encore d’aucune mesure.</translation>
    </message>
    <message>
        <source>The marks at the left and Next are of another run: {0}.</source>
        <translation>Les marques à gauche et Suite sont d’une autre mesure&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Back to that run</source>
        <translation>Retour à cette mesure</translation>
    </message>
    <message>
        <source>Put it away</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Whether hands have to be off</source>
        <translation>S’il faut tenir les mains loin</translation>
    </message>
    <message>
        <source>Change the unit of what is shown: nT, µT, mG. Entry fields keep theirs.</source>
        <translation>Changer l&apos;unité affichée&#xa0;: nT, µT, mG. Les champs de saisie gardent la leur.</translation>
    </message>
    <message>
        <source>FIELD</source>
        <translation>CHAMP</translation>
    </message>
    <message>
        <source>COILS   A</source>
        <translation>BOBINES   A</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Tout lire</translation>
    </message>
    <message>
        <source>Read every instrument now: currents, field, angle, who answers. Nothing is set or moved.</source>
        <translation>Lire chaque appareil maintenant&#xa0;: courants, champ, angle, qui répond. Rien n&apos;est réglé ni déplacé.</translation>
    </message>
    <message>
        <source>PLATFORM</source>
        <translation>PLATE-FORME</translation>
    </message>
    <message>
        <source>INSTRUMENTS</source>
        <translation>INSTRUMENTS</translation>
    </message>
    <message>
        <source>on</source>
        <translation>actives</translation>
    </message>
    <message>
        <source>simulated: began anew at its zero</source>
        <translation>simulé&#xa0;: recommencé à zéro</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>arrêtée</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>tourne</translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation>Aucun banc n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>L&apos;ouverture du banc est en cours …</translation>
    </message>
    <message>
        <source>all answer</source>
        <translation>tous répondent</translation>
    </message>
</context>
<context>
    <name>SigningSteps</name>
    <message>
        <source>1  Key</source>
        <translation>1  Clé</translation>
    </message>
    <message>
        <source>Name: letters, digits and . _ @ + - without blanks, as ada.smith. Passphrase: ten characters or more, no single common word, row of keys or name; four words are easy to keep; nothing brings it back.</source>
        <translation>Nom&#xa0;: lettres, chiffres et . _ @ + - sans espace, comme ada.smith. Phrase de passe&#xa0;: dix caractères ou plus, ni mot courant seul, ni rangée de touches, ni nom&#xa0;; quatre mots se retiennent bien&#xa0;; rien ne la ramène.</translation>
    </message>
    <message>
        <source>Whose key</source>
        <translation>Clé de qui</translation>
    </message>
    <message>
        <source>New passphrase</source>
        <translation>Nouvelle phrase</translation>
    </message>
    <message>
        <source>Of the new key; asked at each signature</source>
        <translation>De la nouvelle clé&#xa0;; demandée à chaque signature</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>Encore une fois</translation>
    </message>
    <message>
        <source>Typed twice: nothing can bring it back</source>
        <translation>Tapée deux fois&#xa0;: rien ne peut la ramener</translation>
    </message>
    <message>
        <source>The name that this person signs under</source>
        <translation>Le nom sous lequel cette personne signe</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle clé</translation>
    </message>
    <message>
        <source>Make a key for this name, and trust it in this lab</source>
        <translation>Créer une clé pour ce nom, à laquelle ce laboratoire se fie</translation>
    </message>
    <message>
        <source>2  Approve</source>
        <translation>2  Approuver</translation>
    </message>
    <message>
        <source>No passphrase: an approval is a name in the draft. It binds once this person has signed (3). After the first signature nobody can be added.</source>
        <translation>Pas de phrase de passe&#xa0;: une approbation est un nom dans le projet. Elle engage quand cette personne a signé (3). Après la première signature, personne ne s&apos;ajoute.</translation>
    </message>
    <message>
        <source>Who approves</source>
        <translation>Qui approuve</translation>
    </message>
    <message>
        <source>Another person than the operator, by the name that they sign under</source>
        <translation>Une autre personne que l&apos;opérateur, par le nom sous lequel elle signe</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Approuver</translation>
    </message>
    <message>
        <source>Write this name into the draft</source>
        <translation>Écrire ce nom dans le projet</translation>
    </message>
    <message>
        <source>3  Sign</source>
        <translation>3  Signer</translation>
    </message>
    <message>
        <source>These exact bytes: a signed file can no longer be changed.</source>
        <translation>Ces octets exactement&#xa0;: un fichier signé ne peut plus être changé.</translation>
    </message>
    <message>
        <source>Who signs, of those who have a key here</source>
        <translation>Qui signe, parmi ceux qui ont une clé ici</translation>
    </message>
    <message>
        <source>Who signs</source>
        <translation>Qui signe</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>Phrase de passe</translation>
    </message>
    <message>
        <source>Of this person&apos;s key; asked each time</source>
        <translation>De la clé de cette personne&#xa0;; demandée chaque fois</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signer</translation>
    </message>
    <message>
        <source>Sign the file as it is</source>
        <translation>Signer le fichier tel qu&apos;il est</translation>
    </message>
    <message>
        <source>Until when it is good</source>
        <translation>Jusqu’à quand il est valable</translation>
    </message>
    <message>
        <source>The key&apos;s name is {0}, made of “{1}”; or type another one.</source>
        <translation>Le nom de la clé est {0}, tiré de «&#xa0;{1}&#xa0;»&#xa0;; ou en taper un autre.</translation>
    </message>
    <message>
        <source>{0} has a key now.</source>
        <translation>{0} a maintenant une clé.</translation>
    </message>
    <message>
        <source>Approve it all the same</source>
        <translation>Approuver quand même</translation>
    </message>
    <message>
        <source>{0} Approve it all the same?</source>
        <translation>{0} Approuver quand même&#xa0;?</translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation>Approuvé par {0}.</translation>
    </message>
    <message>
        <source>Sign it all the same</source>
        <translation>Signer quand même</translation>
    </message>
    <message>
        <source>Choose who signs.</source>
        <translation>Choisissez qui signe.</translation>
    </message>
    <message>
        <source>Type the passphrase first.</source>
        <translation>Saisissez d’abord la phrase de passe.</translation>
    </message>
    <message>
        <source>{0} Sign it all the same?</source>
        <translation>{0} Signer quand même&#xa0;?</translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation>Signé par {0}.</translation>
    </message>
</context>
<context>
    <name>SortedTable</name>
    <message>
        <source>Click to sort by this column, again to turn the order round</source>
        <translation>Un clic trie par cette colonne, un autre inverse l&apos;ordre</translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the right</source>
        <translation>dans une table&#xa0;: dans l&apos;ordre de la colonne de droite</translation>
    </message>
    <message>
        <source>in a table: in the order of the column at the left</source>
        <translation>dans une table&#xa0;: dans l&apos;ordre de la colonne de gauche</translation>
    </message>
    <message>
        <source>in a table: its order turned round</source>
        <translation>dans une table&#xa0;: son ordre inversé</translation>
    </message>
</context>
<context>
    <name>Standing</name>
    <message>
        <source>The window broke off, and was started again. What it said last is kept in {0}.</source>
        <translation>La fenêtre s&apos;est interrompue et a été relancée. Ses derniers mots sont gardés dans {0}.</translation>
    </message>
    <message>
        <source>A run that went on is broken off by its own process: go on with it on Start.</source>
        <translation>Une mesure en cours est interrompue par son propre processus&#xa0;: la continuer à l&apos;Accueil.</translation>
    </message>
    <message>
        <source>The run went on meanwhile in its own process: here it is.</source>
        <translation>La mesure a continué entre-temps dans son propre processus&#xa0;: la voici.</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Check the cage</source>
        <translation>Vérifier la cage</translation>
    </message>
    <message>
        <source>The procedure cage-calibration, on the Run page</source>
        <translation>La procédure cage-calibration, à la page Mesure</translation>
    </message>
    <message>
        <source>Last closing check</source>
        <translation>Dernier contrôle final</translation>
    </message>
    <message>
        <source>Reference sensor</source>
        <translation>Capteur de référence</translation>
    </message>
    <message>
        <source>Cage calibration</source>
        <translation>Étalonnage de la cage</translation>
    </message>
    <message>
        <source>Last runs</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Signs and axes, the procedure axes-check: 1 minute of measuring, 3 with your own time</source>
        <translation>Signes et axes, procédure axes-check&#xa0;: 1 minute de mesure, 3 avec votre temps</translation>
    </message>
    <message>
        <source>The page where that is done</source>
        <translation>La page où cela se fait</translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation>Étalonner un DUT</translation>
    </message>
    <message>
        <source>The preflight on the Run page</source>
        <translation>Le préflight à la page Mesure</translation>
    </message>
    <message>
        <source>Simulated lab</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>A whole lab without hardware, to learn on</source>
        <translation>Un laboratoire entier sans matériel, pour apprendre</translation>
    </message>
    <message>
        <source>Open a bench …</source>
        <translation>Ouvrir un banc …</translation>
    </message>
    <message>
        <source>Looking into the store.</source>
        <translation>Lecture du dépôt.</translation>
    </message>
    <message>
        <source>A run goes on: {0}, DUT {1}. See the Run page.</source>
        <translation>Une mesure est en cours&#xa0;: {0}, DUT {1}. Voir la page Mesure.</translation>
    </message>
    <message>
        <source>Ready. {0} is to be measured on {1}.</source>
        <translation>Prêt. {0} sera mesuré sur {1}.</translation>
    </message>
    <message>
        <source>✕ Not ready: see what is said of the coils.</source>
        <translation>✕ Pas prêt&#xa0;: voir ce qui est dit des bobines.</translation>
    </message>
    <message>
        <source>✕ Not ready: {0}. See the Bench page.</source>
        <translation>✕ Pas prêt&#xa0;: {0}. Voir la page Banc.</translation>
    </message>
    <message>
        <source>The bench is being opened …</source>
        <translation>L&apos;ouverture du banc est en cours …</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>No bench is open.</source>
        <translation>Aucun banc n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>The bench file states no calibration date.</source>
        <translation>Le fichier du banc n&apos;indique aucune date d&apos;étalonnage.</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>Calibrated {0}, {1} days ago.</source>
        <translation>Étalonné le {0}, il y a {1} jours.</translation>
    </message>
    <message>
        <source>▲ due</source>
        <translation>▲ échu</translation>
    </message>
    <message>
        <source>✓ in date</source>
        <translation>✓ à jour</translation>
    </message>
    <message>
        <source>▲ not measured</source>
        <translation>▲ non mesurée</translation>
    </message>
    <message>
        <source>The file of what stands in this lab</source>
        <translation>Le fichier de ce qui se trouve dans ce laboratoire</translation>
    </message>
    <message>
        <source>▲ A run of {0} did not come to its end: go on with it below, or measure anew.</source>
        <translation>▲ Une mesure de {0} n&apos;est pas allée à son terme&#xa0;: la continuer ci-dessous, ou mesurer de nouveau.</translation>
    </message>
    <message>
        <source>Coil constants only: Check the cage measures the matrix.</source>
        <translation>Des constantes de bobines seulement&#xa0;: «&#xa0;Vérifier la cage&#xa0;» mesure la matrice.</translation>
    </message>
    <message>
        <source>The matrix is that of the approved cage calibration {0}.</source>
        <translation>La matrice est celle de l&apos;étalonnage approuvé {0}.</translation>
    </message>
    <message>
        <source>✓ approved</source>
        <translation>✓ approuvée</translation>
    </message>
    <message>
        <source>A matrix without a date: Check the cage says whether it holds.</source>
        <translation>Une matrice sans date&#xa0;: «&#xa0;Vérifier la cage&#xa0;» dit si elle tient.</translation>
    </message>
    <message>
        <source>? not checked</source>
        <translation>? non vérifiée</translation>
    </message>
    <message>
        <source>Checked {0}, {1} days ago.</source>
        <translation>Vérifiée le {0}, il y a {1} jours.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>tient</translation>
    </message>
    <message>
        <source>At its end a run comes back to a position of before, and has to read the same there.</source>
        <translation>À sa fin, une mesure revient à une position d&apos;avant et doit y lire la même chose.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucun encore</translation>
    </message>
    <message>
        <source>No finished run in the store has a closing check.</source>
        <translation>Aucune mesure finie du dépôt n&apos;a de contrôle final.</translation>
    </message>
    <message>
        <source>A run from the Run page, or a bundle imported on the History page, comes up here.</source>
        <translation>Une mesure de la page Mesure, ou un paquet importé à l&apos;Historique, apparaît ici.</translation>
    </message>
</context>
<context>
    <name>StatedFields</name>
    <message>
        <source>Last day, or empty</source>
        <translation>Dernier jour, ou vide</translation>
    </message>
    <message>
        <source>The last day on which it is good, as 2027-11-21; empty: no date is stated</source>
        <translation>Le dernier jour où il est valable, p. ex. 2027-11-21&#xa0;; vide&#xa0;: aucune date</translation>
    </message>
    <message>
        <source>Good until</source>
        <translation>Valable jusqu’au</translation>
    </message>
    <message>
        <source>The calibration of the same serial that this one takes the place of</source>
        <translation>L’étalonnage du même numéro de série que celui-ci remplace</translation>
    </message>
    <message>
        <source>Supersedes</source>
        <translation>Remplace</translation>
    </message>
    <message>
        <source>Supersedes none</source>
        <translation>Ne remplace rien</translation>
    </message>
    <message>
        <source>Supersedes {0}</source>
        <translation>Remplace {0}</translation>
    </message>
    <message>
        <source>{0} is over: the last day on which it is good is today or later</source>
        <translation>{0} est passé&#xa0;: le dernier jour de validité est aujourd’hui ou plus tard</translation>
    </message>
    <message>
        <source>“{0}” is no day; write it like 2027-11-21 or {1}</source>
        <translation>«&#xa0;{0}&#xa0;» n’est pas un jour&#xa0;; écrivez-le comme 2027-11-21 ou {1}</translation>
    </message>
</context>
<context>
    <name>StepCard</name>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>What is done in this step</source>
        <translation>Ce qui se fait à cette étape</translation>
    </message>
</context>
<context>
    <name>StepList</name>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
</context>
<context>
    <name>StudyViewModel</name>
    <message>
        <source>history of {0}</source>
        <translation>historique de {0}</translation>
    </message>
    <message>
        <source>given up</source>
        <translation>abandonné</translation>
    </message>
</context>
<context>
    <name>Table</name>
    <message>
        <source>in a table: its chosen rows to the clipboard, or all</source>
        <translation>dans une table&#xa0;: ses lignes choisies au presse-papiers, ou toutes</translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>When it is done, and when you are needed</source>
        <translation>Quand ce sera fini, et quand on a besoin de vous</translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} left</source>
        <translation>étape {0} de {1} · reste {2}</translation>
    </message>
    <message>
        <source>step {0} of {1} · {2} of simulated time left</source>
        <translation>étape {0} de {1} · reste {2} de temps simulé</translation>
    </message>
    <message>
        <source>Done at about {0}</source>
        <translation>Fini vers {0}</translation>
    </message>
    <message>
        <source>You are needed at {0}: {1}</source>
        <translation>On a besoin de vous à {0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>You are needed within a minute: {0}</source>
        <translation>On a besoin de vous d&apos;ici une minute&#xa0;: {0}</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Serial number of the device under test: type it, or scan it at any moment</source>
        <translation>Numéro de série du DUT&#xa0;: tapez-le, ou lisez-le à tout moment</translation>
    </message>
    <message>
        <source>Who works here now; stands in the record and in the calibration</source>
        <translation>Qui travaille ici&#xa0;; figure dans l&apos;enregistrement et l&apos;étalonnage</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>DUT</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>requis</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Whether hands have to be off</source>
        <translation>S’il faut tenir les mains loin</translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation>BOBINES À ZÉRO   F12</translation>
    </message>
    <message>
        <source>Take every coil to zero now (F12). Works in every state and asks nothing.</source>
        <translation>Mettre toutes les bobines à zéro (F12). Marche en tout état et ne demande rien.</translation>
    </message>
</context>
<context>
    <name>TraceProgress</name>
    <message>
        <source>tracing … {0}</source>
        <translation>recherche … {0}</translation>
    </message>
    <message>
        <source>Traced, {0}: {1}</source>
        <translation>Expliqué, {0}&#xa0;: {1}</translation>
    </message>
</context>
<context>
    <name>Trend</name>
    <message>
        <source>Calibrations over time</source>
        <translation>Étalonnages au fil du temps</translation>
    </message>
    <message>
        <source>bars: U, k=2</source>
        <translation>barres&#xa0;: U, k=2</translation>
    </message>
    <message>
        <source>Zero readings, scale factors from nominal, angles between the axes; gain: from the first calibration</source>
        <translation>Lectures à zéro, facteurs d&apos;échelle par rapport au nominal, angles entre les axes&#xa0;; gain&#xa0;: par rapport au premier étalonnage</translation>
    </message>
    <message>
        <source>No calibration of this DUT yet: its parameters and their U come up here, one dot a day.</source>
        <translation>Aucun étalonnage de ce DUT&#xa0;: ses paramètres et leur U apparaissent ici, un point par jour.</translation>
    </message>
    <message>
        <source>Calibrations of {0}</source>
        <translation>Étalonnages de {0}</translation>
    </message>
</context>
<context>
    <name>UnfinishedRuns</name>
    <message>
        <source>▲ Unfinished run</source>
        <translation>▲ Mesure inachevée</translation>
    </message>
    <message>
        <source>Turns that were finished are kept; the zero, the axes and the timing are measured again. Where none was finished it begins with the first step.</source>
        <translation>Les rotations terminées sont gardées&#xa0;; le zéro, les axes et le temps sont remesurés. Si aucune n’était terminée, cela commence par la première étape.</translation>
    </message>
    <message>
        <source>{0} more on the History page.</source>
        <translation>{0} autres à la page Historique.</translation>
    </message>
    <message>
        <source>Open a bench first.</source>
        <translation>Ouvrez d&apos;abord un banc.</translation>
    </message>
    <message>
        <source>What is missing of it; you are asked whether the mounting stands</source>
        <translation>Ce qui y manque&#xa0;; on vous demande si le montage est encore en place</translation>
    </message>
    <message>
        <source>Go on with {0}</source>
        <translation>Continuer {0}</translation>
    </message>
</context>
<context>
    <name>VerdictCard</name>
    <message>
        <source>DUT</source>
        <translation>DUT</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Ce qui a été mesuré</translation>
    </message>
    <message>
        <source>The pictures and every value with its limit</source>
        <translation>Les images et chaque valeur avec sa limite</translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>what is next for this DUT</source>
        <translation>la suite pour ce DUT</translation>
    </message>
    <message>
        <source>letters to be read from two metres, and back</source>
        <translation>lettres lisibles à deux mètres, et retour</translation>
    </message>
    <message>
        <source>{0} files were dropped together; nothing was done with them.</source>
        <translation>{0} fichiers ont été déposés ensemble&#xa0;; rien n’en a été fait.</translation>
    </message>
    <message>
        <source>Drop one at a time.</source>
        <translation>En déposer un à la fois.</translation>
    </message>
    <message>
        <source>The window has no room for larger letters: make it larger.</source>
        <translation>La fenêtre n’a pas de place pour des lettres plus grandes&#xa0;: agrandissez-la.</translation>
    </message>
    <message>
        <source>Go dark</source>
        <translation>Assombrir</translation>
    </message>
    <message>
        <source>Go light</source>
        <translation>Éclaircir</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Taire</translation>
    </message>
    <message>
        <source>Unmute</source>
        <translation>Sonner</translation>
    </message>
    <message>
        <source>Begin {0}</source>
        <translation>Commencer {0}</translation>
    </message>
    <message>
        <source>Smaller   F11</source>
        <translation>Petit   F11</translation>
    </message>
    <message>
        <source>Larger   F11</source>
        <translation>Grand   F11</translation>
    </message>
    <message>
        <source>Save a problem report</source>
        <translation>Enregistrer un rapport de problème</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Bench</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Causes</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>COILS OFF   F12</source>
        <translation>BOBINES À ZÉRO   F12</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>incomplet</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>Mounted</source>
        <translation>Monté</translation>
    </message>
    <message>
        <source>Placed</source>
        <translation>Placé</translation>
    </message>
    <message>
        <source>Taken away</source>
        <translation>Retiré</translation>
    </message>
    <message>
        <source>Leads swapped</source>
        <translation>Fils inversés</translation>
    </message>
    <message>
        <source>Leads put back</source>
        <translation>Fils remis</translation>
    </message>
    <message>
        <source>Switched</source>
        <translation>Commuté</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Éteint</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Allumé</translation>
    </message>
    <message>
        <source>Warmed</source>
        <translation>Chauffé</translation>
    </message>
    <message>
        <source>Hands off: begin</source>
        <translation>Mains loin&#xa0;: commencer</translation>
    </message>
    <message>
        <source>Redo axis {0}</source>
        <translation>Refaire l&apos;axe {0}</translation>
    </message>
    <message>
        <source>offset and first position</source>
        <translation>décalage et première position</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>répond</translation>
    </message>
    <message>
        <source>not heard yet</source>
        <translation>pas encore entendu</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>non interrogé</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation>Copier le chemin</translation>
    </message>
    <message>
        <source>✓ Path copied</source>
        <translation>✓ Chemin copié</translation>
    </message>
    <message>
        <source>The path of what was just written, to be pasted elsewhere</source>
        <translation>Le chemin de ce qui vient d’être écrit, à coller ailleurs</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Open that run on the page that computes it</source>
        <translation>Ouvrir cette mesure à la page qui la calcule</translation>
    </message>
    <message>
        <source>Show in the file manager what was just written</source>
        <translation>Montrer dans le gestionnaire ce qui vient d&apos;être écrit</translation>
    </message>
    <message>
        <source>Go to Run</source>
        <translation>Aller à Mesure</translation>
    </message>
    <message>
        <source>Record a run, or import one on the History page</source>
        <translation>Enregistrer une mesure, ou en importer une à l&apos;Historique</translation>
    </message>
    <message>
        <source>No run yet: record one on the Run page, or import a bundle on the History page.</source>
        <translation>Aucune mesure&#xa0;: enregistrez-en une à la page Mesure, ou importez un paquet à l&apos;Historique.</translation>
    </message>
    <message>
        <source>Morning check</source>
        <translation>Contrôle du matin</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Oui</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Arrêter la mesure</translation>
    </message>
    <message>
        <source>Hands off: try again</source>
        <translation>Mains loin&#xa0;: réessayer</translation>
    </message>
    <message>
        <source>Mount it again</source>
        <translation>Remonter</translation>
    </message>
    <message>
        <source>Skip this step</source>
        <translation>Sauter cette étape</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>✕ This cannot be done as asked</source>
        <translation>✕ Impossible tel que demandé</translation>
    </message>
    <message>
        <source>✕ An instrument failed</source>
        <translation>✕ Un instrument a failli</translation>
    </message>
    <message>
        <source>✕ The record is not kept</source>
        <translation>✕ L&apos;enregistrement n&apos;est pas conservé</translation>
    </message>
    <message>
        <source>✕ The check standard is out of control</source>
        <translation>✕ Étalon de contrôle hors de contrôle</translation>
    </message>
    <message>
        <source>✕ The guardian failed</source>
        <translation>✕ Le gardien est en panne</translation>
    </message>
    <message>
        <source>✕ The clock was set back</source>
        <translation>✕ L&apos;horloge a été retardée</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the platform may still turn</source>
        <translation>✕ MAINS LOIN&#xa0;: la plate-forme peut encore tourner</translation>
    </message>
    <message>
        <source>✕ A limit is not met</source>
        <translation>✕ Une limite n&apos;est pas tenue</translation>
    </message>
    <message>
        <source>■ Stopped</source>
        <translation>■ Arrêté</translation>
    </message>
    <message>
        <source>✕ This page cannot be shown</source>
        <translation>✕ Cette page ne peut être montrée</translation>
    </message>
    <message>
        <source>✕ Something in labcal broke</source>
        <translation>✕ Quelque chose s&apos;est cassé dans labcal</translation>
    </message>
    <message>
        <source>✕ The work broke off</source>
        <translation>✕ Le travail s&apos;est interrompu</translation>
    </message>
    <message>
        <source>✓ CLEAN</source>
        <translation>✓ PROPRE</translation>
    </message>
    <message>
        <source>✓ EXPLAINED</source>
        <translation>✓ EXPLIQUÉ</translation>
    </message>
    <message>
        <source>▲ PARTLY EXPLAINED</source>
        <translation>▲ EN PARTIE EXPLIQUÉ</translation>
    </message>
    <message>
        <source>? AMBIGUOUS</source>
        <translation>? AMBIGU</translation>
    </message>
    <message>
        <source>✕ UNEXPLAINED</source>
        <translation>✕ INEXPLIQUÉ</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>bruit</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>signe</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>retard</translation>
    </message>
    <message>
        <source>closure</source>
        <translation>bouclage</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>d&apos;en haut</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>de côté</translation>
    </message>
    <message>
        <source>body {0}</source>
        <translation>corps {0}</translation>
    </message>
    <message>
        <source>body {0} up</source>
        <translation>corps {0} en haut</translation>
    </message>
    <message>
        <source>mount it with body {0} up</source>
        <translation>le monter avec corps {0} en haut</translation>
    </message>
    <message>
        <source>mount it as at first</source>
        <translation>le monter comme au début</translation>
    </message>
    <message>
        <source>current {0}</source>
        <translation>courant {0}</translation>
    </message>
    <message>
        <source>temperature {0}</source>
        <translation>température {0}</translation>
    </message>
    <message>
        <source>voltage {0}</source>
        <translation>tension {0}</translation>
    </message>
    <message>
        <source>channel {0}</source>
        <translation>voie {0}</translation>
    </message>
    <message>
        <source>cage X</source>
        <translation>cage X</translation>
    </message>
    <message>
        <source>cage Y</source>
        <translation>cage Y</translation>
    </message>
    <message>
        <source>role</source>
        <translation>rôle</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>instrument</translation>
    </message>
    <message>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <source>who answered</source>
        <translation>qui a répondu</translation>
    </message>
    <message>
        <source>last reading</source>
        <translation>dernière lecture</translation>
    </message>
    <message>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <source>started</source>
        <translation>début</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>today</source>
        <translation>aujourd&apos;hui</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>no marks between thousands: 20000, not 20 000, 20,000 or 20.000</source>
        <translation>aucune marque entre milliers&#xa0;: 20000, pas 20 000, 20,000 ni 20.000</translation>
    </message>
    <message>
        <source>a point stands before decimals here: 1.5, not 1,5</source>
        <translation>ici un point précède les décimales&#xa0;: 1.5, pas 1,5</translation>
    </message>
    <message>
        <source>a blank after each comma, and a point before decimals: 20000, 50000.5</source>
        <translation>une espace après chaque virgule, et un point avant les décimales&#xa0;: 20000, 50000.5</translation>
    </message>
    <message>
        <source>DUT</source>
        <translation>DUT</translation>
    </message>
    <message>
        <source>procedure</source>
        <translation>procédure</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>opérateur</translation>
    </message>
    <message>
        <source>status</source>
        <translation>statut</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>verdict</translation>
    </message>
    <message>
        <source>site</source>
        <translation>site</translation>
    </message>
    <message>
        <source>run</source>
        <translation>mesure</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>U (k=2)</source>
        <translation>U (k=2)</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>limit ±</source>
        <translation>limite ±</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>réglage</translation>
    </message>
    <message>
        <source>mapping</source>
        <translation>correspondance</translation>
    </message>
    <message>
        <source>row 1</source>
        <translation>ligne 1</translation>
    </message>
    <message>
        <source>row 2</source>
        <translation>ligne 2</translation>
    </message>
    <message>
        <source>row 3</source>
        <translation>ligne 3</translation>
    </message>
    <message>
        <source>field  µT</source>
        <translation>champ  µT</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>signification</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>figure</source>
        <translation>grandeur</translation>
    </message>
    <message>
        <source>result</source>
        <translation>résultat</translation>
    </message>
    <message>
        <source>risk</source>
        <translation>risque</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>as left</source>
        <translation>après</translation>
    </message>
    <message>
        <source>earlier</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>later</source>
        <translation>après</translation>
    </message>
    <message>
        <source>± U (k=2) is that of the difference; beyond E_n = ±1 the DUT has changed.</source>
        <translation>± U (k=2) est celle de la différence&#xa0;; au-delà de E_n = ±1 le DUT a changé.</translation>
    </message>
    <message>
        <source>One of the two is traced, the other is not: what differs may be what tracing took out. Trace both, or none.</source>
        <translation>L&apos;un des deux a son résidu expliqué, l&apos;autre non&#xa0;: la différence peut être ce qui en a été retiré. Expliquez les deux, ou aucun.</translation>
    </message>
    <message>
        <source>They are of two DUTs. ± U (k=2) is that of the difference.</source>
        <translation>Elles sont de deux DUT. ± U (k=2) est celle de la différence.</translation>
    </message>
    <message>
        <source>One of the two is not explained: what differs may be its error, and says nothing of the DUT yet.</source>
        <translation>L&apos;une des deux n&apos;est pas expliquée&#xa0;: ce qui diffère peut être son erreur et ne dit encore rien du DUT.</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>changé</translation>
    </message>
    <message>
        <source>{0} changed</source>
        <translation>{0} changé</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>CONFORME</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NON CONFORME</translation>
    </message>
    <message>
        <source>MARGINAL</source>
        <translation>LIMITE</translation>
    </message>
    <message>
        <source>CANNOT DECIDE</source>
        <translation>INDÉCIDABLE</translation>
    </message>
    <message>
        <source>conditional pass</source>
        <translation>conforme sous réserve</translation>
    </message>
    <message>
        <source>conditional fail</source>
        <translation>non conforme sous réserve</translation>
    </message>
    <message>
        <source>In specification?</source>
        <translation>Dans la spécification&#xa0;?</translation>
    </message>
    <message>
        <source>In specification</source>
        <translation>Dans la spécification</translation>
    </message>
    <message>
        <source>In specification, conditionally</source>
        <translation>Dans la spécification, sous réserve</translation>
    </message>
    <message>
        <source>Not in specification, conditionally</source>
        <translation>Hors spécification, sous réserve</translation>
    </message>
    <message>
        <source>Not in specification</source>
        <translation>Hors spécification</translation>
    </message>
    <message>
        <source>Risk: how probably the true value is beyond its limit.</source>
        <translation>Risque&#xa0;: probabilité que la valeur vraie soit au-delà de sa limite.</translation>
    </message>
    <message>
        <source>set</source>
        <translation>réglé</translation>
    </message>
    <message>
        <source>held-out |b|  nT</source>
        <translation>mis de côté |b|  nT</translation>
    </message>
    <message>
        <source>axis error, worst  deg</source>
        <translation>erreur d&apos;axe, la pire  deg</translation>
    </message>
    <message>
        <source>look</source>
        <translation>examen</translation>
    </message>
    <message>
        <source>methods</source>
        <translation>méthodes</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>causes</translation>
    </message>
    <message>
        <source>all rows</source>
        <translation>toutes les lignes</translation>
    </message>
    <message>
        <source>declared</source>
        <translation>déclaré</translation>
    </message>
    <message>
        <source>static</source>
        <translation>mesuré au repos</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>d&apos;après les différences</translation>
    </message>
    <message>
        <source>inertial</source>
        <translation>inertielle</translation>
    </message>
    <message>
        <source>nadir</source>
        <translation>vers le nadir</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>angle  deg</source>
        <translation>angle  deg</translation>
    </message>
    <message>
        <source>field  nT</source>
        <translation>champ  nT</translation>
    </message>
    <message>
        <source>time  s</source>
        <translation>temps  s</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>known</source>
        <translation>connu</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>several, with commas</source>
        <translation>plusieurs, avec virgules</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>temps réel</translation>
    </message>
    <message>
        <source>20 times</source>
        <translation>20 fois</translation>
    </message>
    <message>
        <source>100 times</source>
        <translation>100 fois</translation>
    </message>
    <message>
        <source>at once</source>
        <translation>immédiat</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>échelle</translation>
    </message>
    <message>
        <source>non-orthogonality</source>
        <translation>non-orthogonalité</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>gain</translation>
    </message>
    <message>
        <source>nT</source>
        <translation>nT</translation>
    </message>
    <message>
        <source>ppm from the first</source>
        <translation>ppm depuis le premier</translation>
    </message>
    <message>
        <source>DUT  nT</source>
        <translation>DUT  nT</translation>
    </message>
    <message>
        <source>Plot: {0} against {1}</source>
        <translation>Graphique&#xa0;: {0} selon {1}</translation>
    </message>
    <message>
        <source>residual  nT</source>
        <translation>résidu  nT</translation>
    </message>
    <message>
        <source>held-out rms  nT</source>
        <translation>rms mis de côté  nT</translation>
    </message>
    <message>
        <source>no fields all round at one magnitude: see field-sphere</source>
        <translation>pas de champs tout autour à un même module&#xa0;: voir field-sphere</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>finie</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêtée</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>imported</source>
        <translation>importée</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Enregistrer …</translation>
    </message>
    <message>
        <source>Write this picture to a .png file, as it is shown</source>
        <translation>Écrire cette image en .png, telle qu&apos;affichée</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Every point that is drawn to the clipboard, as columns x and y of each curve</source>
        <translation>Chaque point tracé au presse-papiers, en colonnes x et y de chaque courbe</translation>
    </message>
    <message>
        <source>Needs: {0}</source>
        <translation>Besoin&#xa0;: {0}</translation>
    </message>
    <message>
        <source>About {0:g} min of measuring, and your own time beside it</source>
        <translation>Environ {0:g} min de mesure, plus votre temps</translation>
    </message>
    <message>
        <source>The plan says how long this takes</source>
        <translation>Le plan dit combien de temps cela prend</translation>
    </message>
    <message>
        <source>With a key here: {0}.</source>
        <translation>Avec une clé ici&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Whoever signed has a key elsewhere.</source>
        <translation>Qui a signé a une clé ailleurs.</translation>
    </message>
    <message>
        <source>Nobody has a key here. Make one for the person who approves.</source>
        <translation>Personne n&apos;a de clé ici. Créez-en une pour la personne qui approuve.</translation>
    </message>
    <message>
        <source>Only {0} has a key here. Make one for who approves: another person than {1}.</source>
        <translation>Seul {0} a une clé ici. Créez-en une pour qui approuve&#xa0;: une autre personne que {1}.</translation>
    </message>
    <message>
        <source>Approved by {0}.</source>
        <translation>Approuvé par {0}.</translation>
    </message>
    <message>
        <source>Signed without an approval: nobody can be added any more.</source>
        <translation>Signé sans approbation&#xa0;: personne ne s&apos;ajoute plus.</translation>
    </message>
    <message>
        <source>Another person than {0} looks at the figures below, and approves.</source>
        <translation>Une autre personne que {0} regarde les valeurs ci-dessous, et approuve.</translation>
    </message>
    <message>
        <source>First a key of another person than {0} (1).</source>
        <translation>D&apos;abord la clé d&apos;une autre personne que {0} (1).</translation>
    </message>
    <message>
        <source>Do not use it: make a new draft on the Fit page.</source>
        <translation>Ne l&apos;utilisez pas&#xa0;: refaites un projet à la page Ajuster.</translation>
    </message>
    <message>
        <source>Their key is not on this computer.</source>
        <translation>Leur clé n&apos;est pas sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Signed by {0}.</source>
        <translation>Signé par {0}.</translation>
    </message>
    <message>
        <source>First a key (1).</source>
        <translation>D&apos;abord une clé (1).</translation>
    </message>
    <message>
        <source>After the approval (2). Nobody there? Sign alone: it is valid, and PROVISIONAL.</source>
        <translation>Après l&apos;approbation (2). Personne&#xa0;? Signez seul&#xa0;: c&apos;est valide, et PROVISOIRE.</translation>
    </message>
    <message>
        <source>Once it is signed (3).</source>
        <translation>Quand il est signé (3).</translation>
    </message>
    <message>
        <source>Once {0} has signed; before that as PROVISIONAL.</source>
        <translation>Quand {0} a signé&#xa0;; avant, comme PROVISOIRE.</translation>
    </message>
    <message>
        <source>Handed out. Next: another DUT.</source>
        <translation>Remis. Ensuite&#xa0;: un autre DUT.</translation>
    </message>
    <message>
        <source>As PROVISIONAL: nobody approved it before it was signed.</source>
        <translation>Comme PROVISOIRE&#xa0;: personne ne l&apos;a approuvé avant la signature.</translation>
    </message>
    <message>
        <source>As PROVISIONAL: why is said above.</source>
        <translation>Comme PROVISOIRE&#xa0;: la raison est plus haut.</translation>
    </message>
    <message>
        <source>No key can bear “{0}”: letters, digits and . _ @ + - alone, as in ada.smith</source>
        <translation>Aucune clé ne peut porter «&#xa0;{0}&#xa0;»&#xa0;: seulement lettres, chiffres et . _ @ + -, comme ada.smith</translation>
    </message>
    <message>
        <source>{0} has a key here already, as {1}.</source>
        <translation>{0} a déjà une clé ici, comme {1}.</translation>
    </message>
    <message>
        <source>The two passphrases differ.</source>
        <translation>Les deux phrases de passe diffèrent.</translation>
    </message>
    <message>
        <source>{0} is the operator, {1}: another person approves.</source>
        <translation>{0} est l&apos;opérateur, {1}&#xa0;: une autre personne approuve.</translation>
    </message>
    <message>
        <source>the operator</source>
        <translation>l&apos;opérateur</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: the coils may be on</source>
        <translation>✕ MAINS LOIN&#xa0;: les bobines sont peut-être alimentées</translation>
    </message>
    <message>
        <source>▲ Broken off</source>
        <translation>▲ Interrompue</translation>
    </message>
    <message>
        <source>■ Stopped by COILS OFF (F12)</source>
        <translation>■ Arrêtée par BOBINES À ZÉRO (F12)</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>étalonnage</translation>
    </message>
    <message>
        <source>zero reading</source>
        <translation>lecture à zéro</translation>
    </message>
    <message>
        <source>offset k</source>
        <translation>décalage k</translation>
    </message>
    <message>
        <source>offset k x  nT</source>
        <translation>décalage k x  nT</translation>
    </message>
    <message>
        <source>offset k y  nT</source>
        <translation>décalage k y  nT</translation>
    </message>
    <message>
        <source>offset k z  nT</source>
        <translation>décalage k z  nT</translation>
    </message>
    <message>
        <source>closed loop</source>
        <translation>boucle fermée</translation>
    </message>
    <message>
        <source>stopped by COILS OFF</source>
        <translation>arrêtée par BOBINES À ZÉRO</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>interrompue</translation>
    </message>
    <message>
        <source>{0} has to sign. The operator may sign as well.</source>
        <translation>{0} doit signer. L&apos;opérateur peut signer aussi.</translation>
    </message>
    <message>
        <source>Good to use as PROVISIONAL; {0} has still to sign.</source>
        <translation>Utilisable comme PROVISOIRE&#xa0;; {0} doit encore signer.</translation>
    </message>
    <message>
        <source>no answer (plug? power?)</source>
        <translation>pas de réponse (prise&#xa0;? alimentation&#xa0;?)</translation>
    </message>
    <message>
        <source>no answer (link lost)</source>
        <translation>pas de réponse (liaison perdue)</translation>
    </message>
    <message>
        <source>heard {0}</source>
        <translation>entendu {0}</translation>
    </message>
    <message>
        <source>heard before</source>
        <translation>entendu avant</translation>
    </message>
    <message>
        <source>{0} s ago</source>
        <translation>il y a {0} s</translation>
    </message>
    <message>
        <source>{0} min ago</source>
        <translation>il y a {0} min</translation>
    </message>
    <message>
        <source>{0} h ago</source>
        <translation>il y a {0} h</translation>
    </message>
    <message>
        <source>changing</source>
        <translation>en changement</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>not read in this step</source>
        <translation>non lu dans cette étape</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>read {0} s ago</source>
        <translation>lu il y a {0} s</translation>
    </message>
    <message>
        <source>▲ Hands off: {0}</source>
        <translation>▲ Mains loin&#xa0;: {0}</translation>
    </message>
    <message>
        <source>▲ Hands off: not read yet</source>
        <translation>▲ Mains loin&#xa0;: pas encore lu</translation>
    </message>
    <message>
        <source>▲ Hands off: not read since {0}; move the mouse, and it is read again</source>
        <translation>▲ Mains loin&#xa0;: pas lu depuis {0}&#xa0;; bougez la souris et la lecture reprend</translation>
    </message>
    <message>
        <source>▲ Hands off: the coils are not being read</source>
        <translation>▲ Mains loin&#xa0;: les bobines ne sont pas lues</translation>
    </message>
    <message>
        <source>▲ Hands off: the platform is not being read</source>
        <translation>▲ Mains loin&#xa0;: la plate-forme n’est pas lue</translation>
    </message>
    <message>
        <source>✓ Hands may go in: {0}</source>
        <translation>✓ Les mains peuvent entrer&#xa0;: {0}</translation>
    </message>
    <message>
        <source>● Hands may go in: {0}</source>
        <translation>● Les mains peuvent entrer&#xa0;: {0}</translation>
    </message>
    <message>
        <source>▲ Hands off: a run of {0} was cut off; the coils are not known</source>
        <translation>▲ Mains loin&#xa0;: une mesure de {0} a été coupée&#xa0;; l&apos;état des bobines n&apos;est pas connu</translation>
    </message>
    <message>
        <source>▲ Hands off: another process drives a run of {0}; the coils may be on</source>
        <translation>▲ Mains loin&#xa0;: un autre processus conduit une mesure de {0}&#xa0;; les bobines sont peut-être alimentées</translation>
    </message>
    <message>
        <source>COILS OFF done {0}: {1}</source>
        <translation>BOBINES À ZÉRO fait à {0}&#xa0;: {1}</translation>
    </message>
    <message>
        <source>stop it at its controller, and see it stand</source>
        <translation>arrêtez-la à son contrôleur, et voyez qu&apos;elle est arrêtée</translation>
    </message>
    <message>
        <source>the platform was ordered to stop, and is not seen to stand yet</source>
        <translation>la plate-forme a reçu l’ordre de s’arrêter, et personne ne l’a encore vue arrêtée</translation>
    </message>
    <message>
        <source>press COILS OFF (F12) first: it stops the platform too, if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation>appuyez d’abord sur BOBINES À ZÉRO (F12)&#xa0;: cela arrête aussi la plate-forme, si elle est joignable. Si elle tourne encore, arrêtez-la à son contrôleur</translation>
    </message>
    <message>
        <source>COILS OFF was pressed, and stops it if it can be reached. If it keeps turning, stop it at its controller</source>
        <translation>BOBINES À ZÉRO a été pressé et l’arrête si elle est joignable. Si elle tourne encore, arrêtez-la à son contrôleur</translation>
    </message>
    <message>
        <source>platform turning</source>
        <translation>la plate-forme tourne</translation>
    </message>
    <message>
        <source>platform may turn</source>
        <translation>la plate-forme tourne peut-être</translation>
    </message>
    <message>
        <source>Nothing is left over but noise. The calibration may be signed.</source>
        <translation>Il ne reste que du bruit. L&apos;étalonnage peut être signé.</translation>
    </message>
    <message>
        <source>The error has a cause: {0}. It is in the draft, which may be signed.</source>
        <translation>L&apos;erreur a une cause&#xa0;: {0}. Elle est dans le projet, qui peut être signé.</translation>
    </message>
    <message>
        <source>A part of the error has a cause: {0}. It is in the draft; something else is left over: see 4 before you sign.</source>
        <translation>Une part de l&apos;erreur a une cause&#xa0;: {0}. Elle est dans le projet&#xa0;; il reste autre chose&#xa0;: voir 4 avant de signer.</translation>
    </message>
    <message>
        <source>This may be the cause: {0}. Another one does as well: measure what tells them apart (4), then sign.</source>
        <translation>Ceci peut être la cause&#xa0;: {0}. Une autre convient aussi&#xa0;: mesurez ce qui les distingue (4), puis signez.</translation>
    </message>
    <message>
        <source>Something is wrong that nothing known explains. Do not sign: see 4.</source>
        <translation>Quelque chose ne va pas que rien de connu n&apos;explique. Ne signez pas&#xa0;: voir 4.</translation>
    </message>
    <message>
        <source>▲ NOT ENOUGH FOR A WHOLE MAP</source>
        <translation>▲ PAS ASSEZ POUR UNE APPLICATION ENTIÈRE</translation>
    </message>
    <message>
        <source>This run does not determine the whole map: too few axes or fields were measured, so no cause was searched for. That says nothing against the DUT. What to measure stands at 4.</source>
        <translation>Cette mesure ne détermine pas toute l’application&#xa0;: trop peu d’axes ou de champs ont été mesurés, donc aucune cause n’a été cherchée. Cela ne dit rien contre le DUT. Ce qui est à mesurer est dit en 4.</translation>
    </message>
    <message>
        <source>rms of the vector, with declared errors; noise alone {0} nT rms</source>
        <translation>rms du vecteur, avec les erreurs déclarées&#xa0;; bruit seul {0} nT rms</translation>
    </message>
    <message>
        <source>before → after: held-out rms of the vector, with the errors in it that the run declares of reference and mounting; noise alone, of one such row: {0} nT, {1}; the figure on the Fit page is of |b| alone, without direction</source>
        <translation>avant → après&#xa0;: rms mis de côté du vecteur, avec les erreurs que la mesure déclare de sa référence et du montage&#xa0;; bruit seul, d’une telle ligne&#xa0;: {0} nT, {1}&#xa0;; le chiffre de la page Fit porte sur |b| seul, sans la direction</translation>
    </message>
    <message>
        <source>explains nothing beyond what is named already</source>
        <translation>n&apos;explique rien de plus que ce qui est déjà nommé</translation>
    </message>
    <message>
        <source>explains too little to be worth its parameters</source>
        <translation>explique trop peu pour ses paramètres</translation>
    </message>
    <message>
        <source>in files and commands: {0}</source>
        <translation>dans les fichiers et les commandes&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} et {1}</translation>
    </message>
    <message>
        <source>{0}, or {1}</source>
        <translation>{0}, ou {1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} ou {1}</translation>
    </message>
    <message>
        <source>{0} at {1}</source>
        <translation>{0} à {1}</translation>
    </message>
    <message>
        <source>rows that were set aside</source>
        <translation>lignes écartées</translation>
    </message>
    <message>
        <source>Calibrate a DUT</source>
        <translation>Étalonner un DUT</translation>
    </message>
    <message>
        <source>Every morning</source>
        <translation>Chaque matin</translation>
    </message>
    <message>
        <source>Test a DUT</source>
        <translation>Tester un DUT</translation>
    </message>
    <message>
        <source>The cage and its reference</source>
        <translation>La cage et sa référence</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Champs</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Fit, Loop, Certificate: Next leads there.</source>
        <translation>Ajuster, Causes, Certificat&#xa0;: Suite y mène.</translation>
    </message>
    <message>
        <source>No calibration of a DUT comes of this procedure. Next leads on.</source>
        <translation>Cette procédure ne donne pas d’étalonnage d’un DUT. Suite mène plus loin.</translation>
    </message>
    <message>
        <source>Within U of its limit: measure that part again, or Fit and see.</source>
        <translation>À moins de U de sa limite&#xa0;: remesurez cette partie, ou ajustez pour voir.</translation>
    </message>
    <message>
        <source>Look at what was measured, mend the cause, and measure again.</source>
        <translation>Regardez ce qui a été mesuré, réparez la cause, et remesurez.</translation>
    </message>
    <message>
        <source>Nothing of it had a limit: look at what was measured.</source>
        <translation>Rien n&apos;avait de limite&#xa0;: regardez ce qui a été mesuré.</translation>
    </message>
    <message>
        <source>What was measured is kept. To measure again: Close, then Begin.</source>
        <translation>Le mesuré est gardé. Pour remesurer&#xa0;: Fermer, puis Démarrer.</translation>
    </message>
    <message>
        <source>Finished turns are kept; Go on measures the zero, the axes and the timing again, then what is missing.</source>
        <translation>Les rotations terminées sont gardées&#xa0;; Continuer mesure encore le zéro, les axes et les temps, puis ce qui manque.</translation>
    </message>
    <message>
        <source>Mend what is said above, then measure again: Close, then Begin.</source>
        <translation>Réparez ce qui est dit plus haut, puis remesurez&#xa0;: Fermer, puis Démarrer.</translation>
    </message>
    <message>
        <source>PASS of the measurement: |value| + U (k=2) is within its limit ({0} of {0}).</source>
        <translation>CONFORME est la mesure&#xa0;: |valeur| + U (k=2) est dans la limite ({0} sur {0}).</translation>
    </message>
    <message>
        <source>Not measured: {0}.</source>
        <translation>Non mesuré&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>{0}, without {1}</source>
        <translation>{0}, sans {1}</translation>
    </message>
    <message>
        <source>NOT MEASURED</source>
        <translation>NON MESURÉ</translation>
    </message>
    <message>
        <source>Nothing was measured, so this says nothing of the DUT.</source>
        <translation>Rien n&apos;a été mesuré&#xa0;: cela ne dit rien du DUT.</translation>
    </message>
    <message>
        <source>It cannot be gone on with: a result of {0} is worked out from one recording without a gap.</source>
        <translation>Il ne peut pas être repris&#xa0;: un résultat de {0} se calcule d&apos;un seul enregistrement sans lacune.</translation>
    </message>
    <message>
        <source>The delay is how late the DUT reads behind the platform&apos;s angle. It comes of turns there and back about one axis without a break between; after Go on too few of those are left. To get it: sync-check, or a new preflight.</source>
        <translation>Le retard est celui de la lecture du DUT sur l&apos;angle de la plateforme. Il vient de tours aller et retour autour d&apos;un axe sans interruption&#xa0;; après Continuer, il en reste trop peu. Pour l&apos;obtenir&#xa0;: sync-check, ou un nouveau preflight.</translation>
    </message>
    <message>
        <source>How good the calibration is, Fit and Loop judge.</source>
        <translation>La qualité de l&apos;étalonnage, Ajuster et Causes la jugent.</translation>
    </message>
    <message>
        <source>Fit, and trace what is left over. Still open then? Measure longer, or with less noise.</source>
        <translation>Ajustez, puis expliquez le résidu. Toujours indécis&#xa0;? Mesurez plus longtemps, ou avec moins de bruit.</translation>
    </message>
    <message>
        <source>One axis: not enough for a calibration by itself. Measure the others too, or a preflight.</source>
        <translation>Un axe&#xa0;: seul, il ne suffit pas à un étalonnage. Mesurez aussi les autres, ou un preflight.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: finished turns are kept; the zero, the axes, the timing and the step that broke off are measured again.</source>
        <translation>Réparez ce qui est dit plus haut, puis Continuer&#xa0;: les rotations terminées sont gardées&#xa0;; le zéro, les axes, les temps et l’étape interrompue sont mesurés encore.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on.</source>
        <translation>Réparez ce qui est dit plus haut, puis Continuer.</translation>
    </message>
    <message>
        <source>No turn was finished: Go on begins with the first step again, and uses nothing of what was measured.</source>
        <translation>Aucune rotation n’est terminée&#xa0;: Continuer commence de nouveau à la première étape et n’utilise rien de ce qui a été mesuré.</translation>
    </message>
    <message>
        <source>Mend what is said above, then Go on: no turn was finished, so it begins with the first step again, and uses nothing of what was measured.</source>
        <translation>Réparez ce qui est dit plus haut, puis Continuer&#xa0;: aucune rotation n’est terminée, donc cela recommence à la première étape et n’utilise rien de ce qui a été mesuré.</translation>
    </message>
    <message>
        <source>Nothing was measured: Go on begins with the first step.</source>
        <translation>Rien n&apos;a été mesuré&#xa0;: Continuer commence par la première étape.</translation>
    </message>
    <message>
        <source>To measure again: Close, then Begin.</source>
        <translation>Pour remesurer&#xa0;: Fermer, puis Démarrer.</translation>
    </message>
    <message>
        <source>FAIL where |value| − U (k=2) is beyond the limit: {0}.</source>
        <translation>NON CONFORME si |valeur| − U (k=2) dépasse la limite&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>MARGINAL where the limit lies within ± U (k=2): {0}.</source>
        <translation>LIMITE si la limite est dans ± U (k=2)&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>CANNOT DECIDE where U (k=2) exceeds half the limit: {0}.</source>
        <translation>INDÉCIDABLE si U (k=2) dépasse la moitié de la limite&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>It did not come to its end, so it has no verdict, and gives no calibration.</source>
        <translation>Elle n&apos;est pas arrivée à sa fin&#xa0;: ni verdict, ni étalonnage.</translation>
    </message>
    <message>
        <source>DONE</source>
        <translation>FINI</translation>
    </message>
    <message>
        <source>○ draft</source>
        <translation>○ projet</translation>
    </message>
    <message>
        <source>✕ not valid</source>
        <translation>✕ non valable</translation>
    </message>
    <message>
        <source>▲ provisional</source>
        <translation>▲ provisoire</translation>
    </message>
    <message>
        <source>▲ expired</source>
        <translation>▲ expiré</translation>
    </message>
    <message>
        <source>▲ superseded</source>
        <translation>▲ remplacé</translation>
    </message>
    <message>
        <source>✓ released</source>
        <translation>✓ délivré</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>to do now</source>
        <translation>à faire</translation>
    </message>
    <message>
        <source>not any more</source>
        <translation>plus possible</translation>
    </message>
    <message>
        <source>Do not use it any more: measure anew, or take the calibration that came after it.</source>
        <translation>Ne plus l’utiliser&#xa0;: mesurer à nouveau, ou prendre l’étalonnage qui l’a suivi.</translation>
    </message>
    <message>
        <source>Good until {0}.</source>
        <translation>Valable jusqu’au {0}.</translation>
    </message>
    <message>
        <source>No last day of use is stated: it never expires by itself.</source>
        <translation>Aucun dernier jour n’est indiqué&#xa0;: il n’expire jamais de lui-même.</translation>
    </message>
    <message>
        <source>That day is stated by who approves (2), by the interval of your lab; labcal works none out here.</source>
        <translation>Ce jour est indiqué par qui approuve (2), selon l’intervalle de votre labo&#xa0;; labcal n’en calcule aucun ici.</translation>
    </message>
    <message>
        <source>So it was stated when it was approved.</source>
        <translation>Ainsi indiqué à l’approbation.</translation>
    </message>
    <message>
        <source>None was when it was approved, and none can be added any more.</source>
        <translation>Aucun ne l’était lors de l’approbation, et aucun ne peut plus être ajouté.</translation>
    </message>
    <message>
        <source>another one</source>
        <translation>une autre</translation>
    </message>
    <message>
        <source>UNEXPLAINED: what is left of held-out rows has no known cause, and U takes it for random.</source>
        <translation>INEXPLIQUÉ&#xa0;: ce qui reste dans les lignes réservées n&apos;a pas de cause connue, et U le prend pour aléatoire.</translation>
    </message>
    <message>
        <source>Its run did not measure {0}: they were held as they stand.</source>
        <translation>Sa mesure n&apos;a pas déterminé {0}&#xa0;: ils sont restés tels quels.</translation>
    </message>
    <message>
        <source>Nobody can approve it: turn about the other body axes as well.</source>
        <translation>Personne ne peut l&apos;approuver&#xa0;: tourner aussi autour des autres axes du corps.</translation>
    </message>
    <message>
        <source>Signed it stays PROVISIONAL, for its run did not measure it whole.</source>
        <translation>Signé, il reste PROVISOIRE, car sa mesure ne l&apos;a pas déterminé entièrement.</translation>
    </message>
    <message>
        <source>As {0}: why is said above.</source>
        <translation>Comme {0}&#xa0;: la raison est dite plus haut.</translation>
    </message>
    <message>
        <source>Handed out as {0}. Next: another DUT.</source>
        <translation>Remis comme {0}. Ensuite&#xa0;: un autre DUT.</translation>
    </message>
    <message>
        <source>AMBIGUOUS, the cause is not certain: {0}. It may be another: {1}.</source>
        <translation>AMBIGU, la cause n&apos;est pas sûre&#xa0;: {0}. Il peut y en avoir une autre&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>PROVISIONAL</source>
        <translation>PROVISOIRE</translation>
    </message>
    <message>
        <source>handed out</source>
        <translation>remis</translation>
    </message>
    <message>
        <source>✕ No calibration from this run by {0}</source>
        <translation>✕ Pas d&apos;étalonnage de cette mesure par {0}</translation>
    </message>
    <message>
        <source>✕ No calibration from this run</source>
        <translation>✕ Pas d&apos;étalonnage de cette mesure</translation>
    </message>
    <message>
        <source>Offset and gains did not come out of these rows, so nothing can be traced or signed of this run. The DUT may still be good.</source>
        <translation>Décalage et gains ne sont pas sortis de ces lignes&#xa0;: rien de cette mesure ne peut être expliqué ni signé. Le DUT peut être bon malgré tout.</translation>
    </message>
    <message>
        <source>Why: {0}.</source>
        <translation>Pourquoi&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Next: the other methods. Some of them need less of a run.</source>
        <translation>Ensuite&#xa0;: les autres méthodes. Certaines demandent moins d&apos;une mesure.</translation>
    </message>
    <message>
        <source>Next: measure again, with turns about x, y and z and in more than one magnitude, as preflight does it. Look first at the pictures below: a turn that stands apart from the others is the one that went wrong.</source>
        <translation>Ensuite&#xa0;: mesurer de nouveau, avec des rotations autour de x, y et z et à plus d&apos;une intensité, comme le fait preflight. Regarder d&apos;abord les figures ci-dessous&#xa0;: une rotation à l&apos;écart des autres est celle qui a mal tourné.</translation>
    </message>
    <message>
        <source>Without a result: {0}. What is said above is of {1}, and does not rest on them.</source>
        <translation>Sans résultat&#xa0;: {0}. Ce qui est dit plus haut est de {1}, et ne repose pas dessus.</translation>
    </message>
    <message>
        <source>Without a result: {0}.</source>
        <translation>Sans résultat&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>What is left over is the rms of |b| in held-out rows; its noise is what is stated of |b| in one reading. The figure on the Loop page is of the whole vector in such rows, its direction too.</source>
        <translation>Ce qui reste est le rms de |b| dans les lignes mises de côté&#xa0;; son bruit est celui indiqué de |b| d&apos;une lecture. Le chiffre de la page Loop porte sur tout le vecteur de ces lignes, direction comprise.</translation>
    </message>
    <message>
        <source>{0} nT rms of |b| are left over; no noise is stated to compare it with.</source>
        <translation>Il reste {0} nT rms de |b|&#xa0;; aucun bruit n&apos;est indiqué pour comparer.</translation>
    </message>
    <message>
        <source>No specification is stated.</source>
        <translation>Aucune spécification n&apos;est indiquée.</translation>
    </message>
    <message>
        <source>Trace the residual.</source>
        <translation>Expliquer le résidu.</translation>
    </message>
    <message>
        <source>✓ The calibration is good in size: {0} nT rms of |b| are left over, no more than its noise, {1} nT rms. The loop judges the direction.</source>
        <translation>✓ L&apos;étalonnage est bon en intensité&#xa0;: il reste {0} nT rms de |b|, pas plus que son bruit, {1} nT rms. La page Causes juge la direction.</translation>
    </message>
    <message>
        <source>▲ The map alone is not enough: {0} nT rms of |b| are left over, its noise is {1} nT rms.</source>
        <translation>▲ La transformation seule ne suffit pas&#xa0;: il reste {0} nT rms de |b|, son bruit est de {1} nT rms.</translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The Loop page says what was found.</source>
        <translation>Le résidu a été examiné&#xa0;: {0}. La page Causes dit ce qui a été trouvé.</translation>
    </message>
    <message>
        <source>The residual was traced: {0}. The loop&apos;s draft holds its cause.</source>
        <translation>Le résidu a été examiné&#xa0;: {0}. Sa cause est dans le projet fait par la page Causes.</translation>
    </message>
    <message>
        <source>▲ This run does not determine the whole map, however little is left over: {0}. It is good for a check, and for no calibration.</source>
        <translation>▲ Cette mesure ne détermine pas toute l’application, si peu qu’il reste&#xa0;: {0}. Elle vaut pour une vérification, et pour aucun étalonnage.</translation>
    </message>
    <message>
        <source>Opening the simulated lab …</source>
        <translation>Ouverture du laboratoire simulé …</translation>
    </message>
    <message>
        <source>guardian</source>
        <translation>gardien</translation>
    </message>
    <message>
        <source>only in a run</source>
        <translation>seulement pendant une mesure</translation>
    </message>
    <message>
        <source>The guardian is a program of its own beside labcal: it holds the lines of the supplies, and takes every coil to zero when a session ends, breaks off or no longer answers.</source>
        <translation>Le gardien est un programme à part, à côté de labcal&#xa0;: il tient les lignes des alimentations et ramène chaque bobine à zéro quand une session se termine, s’interrompt ou ne répond plus.</translation>
    </message>
    <message>
        <source>✕ No answer from {0}</source>
        <translation>✕ Pas de réponse de {0}</translation>
    </message>
    <message>
        <source>✕ No answer from {0} instruments</source>
        <translation>✕ Pas de réponse de {0} appareils</translation>
    </message>
    <message>
        <source>Here that is “{0}”.</source>
        <translation>Ici, c’est «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>The run did not end by itself within seconds, so its process was ended.</source>
        <translation>La mesure ne s&apos;est pas terminée d&apos;elle-même en quelques secondes&#xa0;: son processus a été arrêté.</translation>
    </message>
    <message>
        <source>Then “{0}”.</source>
        <translation>Puis «&#xa0;{0}&#xa0;».</translation>
    </message>
    <message>
        <source>Kept of this run: {0}</source>
        <translation>Conservé de cette mesure&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} → {1} nT rms of the vector, noise alone {2} nT rms</source>
        <translation>{0} → {1} nT rms du vecteur, bruit seul {2} nT rms</translation>
    </message>
    <message>
        <source>offset k {0} nT by {1}</source>
        <translation>décalage k {0} nT par {1}</translation>
    </message>
    <message>
        <source>A run goes on: the coils may be on. Hands off.</source>
        <translation>Une mesure est en cours&#xa0;: les bobines sont peut-être alimentées. Mains loin.</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Hands off</source>
        <translation>Mains loin</translation>
    </message>
    <message>
        <source>{0} s simulated</source>
        <translation>{0} s simulées</translation>
    </message>
    <message>
        <source>HANDS OFF – no answer from {0}; {1}</source>
        <translation>MAINS LOIN – pas de réponse de {0}&#xa0;; {1}</translation>
    </message>
    <message>
        <source>HANDS OFF – {0}</source>
        <translation>MAINS LOIN – {0}</translation>
    </message>
    <message>
        <source>HANDS OFF</source>
        <translation>MAINS LOIN</translation>
    </message>
    <message>
        <source>▲ Hands off</source>
        <translation>▲ Mains loin</translation>
    </message>
    <message>
        <source>the field and the platform come next</source>
        <translation>le champ et la plate-forme viennent ensuite</translation>
    </message>
    <message>
        <source>the next field or turn comes unasked</source>
        <translation>le prochain champ ou la prochaine rotation vient sans question</translation>
    </message>
    <message>
        <source>the platform turns next</source>
        <translation>la plate-forme tourne ensuite</translation>
    </message>
    <message>
        <source>COILS OFF: the run stops …</source>
        <translation>BOBINES À ZÉRO&#xa0;: la mesure s&apos;arrête …</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>arrêt en cours</translation>
    </message>
    <message>
        <source>the step is broken off</source>
        <translation>l’étape est interrompue</translation>
    </message>
    <message>
        <source>the run begins</source>
        <translation>la mesure commence</translation>
    </message>
    <message>
        <source>the run goes on</source>
        <translation>la mesure continue</translation>
    </message>
    <message>
        <source>{0}: no answer from {1}</source>
        <translation>{0}&#xa0;: pas de réponse de {1}</translation>
    </message>
    <message>
        <source>▲ One interruption: {0}. Measured again: {1}.</source>
        <translation>▲ Une interruption&#xa0;: {0}. Mesuré de nouveau&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}. Measured again: {2}.</source>
        <translation>▲ {0} interruptions&#xa0;: {1}. Mesuré de nouveau&#xa0;: {2}.</translation>
    </message>
    <message>
        <source>▲ One interruption: {0}.</source>
        <translation>▲ Une interruption&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>▲ {0} interruptions: {1}.</source>
        <translation>▲ {0} interruptions&#xa0;: {1}.</translation>
    </message>
    <message>
        <source>at {0}, for {1}</source>
        <translation>à {0}, durée&#xa0;: {1}</translation>
    </message>
    <message>
        <source>before its first step, for {0}</source>
        <translation>avant la première étape, durée&#xa0;: {0}</translation>
    </message>
    <message>
        <source>at {0}</source>
        <translation>à {0}</translation>
    </message>
    <message>
        <source>before its first step</source>
        <translation>avant la première étape</translation>
    </message>
    <message>
        <source>nobody knows how long</source>
        <translation>personne ne sait combien de temps</translation>
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
        <translation>Noté, dans l&apos;enregistrement de la mesure (l&apos;historique le montre)&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Noted: {0}</source>
        <translation>Noté&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The procedure noted {0} more, the last: {1}</source>
        <translation>La procédure en a noté {0} de plus, le dernier&#xa0;: {1}</translation>
    </message>
    <message>
        <source>Estimates on the way: {0} notes; no verdict rests on them.</source>
        <translation>Estimations en cours de route&#xa0;: {0} notes&#xa0;; aucun verdict ne repose sur ces estimations.</translation>
    </message>
    <message>
        <source>Estimates on the way: 1 note; no verdict rests on it.</source>
        <translation>Estimations en cours de route&#xa0;: 1 note&#xa0;; aucun verdict ne repose sur cette estimation.</translation>
    </message>
    <message>
        <source>▲ Open in the run itself: {0}. An approval takes that as it is.</source>
        <translation>▲ Ouvert dans la mesure même&#xa0;: {0}. Une approbation l&apos;accepte tel quel.</translation>
    </message>
    <message>
        <source>{0} not measured</source>
        <translation>{0} non mesuré</translation>
    </message>
    <message>
        <source>(not seen: {0})</source>
        <translation>(non vu&#xa0;: {0})</translation>
    </message>
    <message>
        <source>{0} COILS OFF: {1}</source>
        <translation>{0} BOBINES À ZÉRO&#xa0;: {1}</translation>
    </message>
    <message>
        <source>the reference agreed {0}</source>
        <translation>la référence concordait {0}</translation>
    </message>
    <message>
        <source>platform stands</source>
        <translation>la plate-forme est arrêtée</translation>
    </message>
    <message>
        <source>No comparison: run {0} is {1}; what it lacks would look like a change.</source>
        <translation>Pas de comparaison&#xa0;: la mesure {0} est {1}&#xa0;; ce qui lui manque semblerait un changement.</translation>
    </message>
    <message>
        <source>{0}: {1} A when last read, {2}</source>
        <translation>{0}&#xa0;: {1} A à la dernière lecture, {2}</translation>
    </message>
    <message>
        <source>{0}: see to plug, power and cable.</source>
        <translation>{0}&#xa0;: voir prise, alimentation et câble.</translation>
    </message>
    <message>
        <source>Read all asks again.</source>
        <translation>«&#xa0;Tout lire&#xa0;» interroge de nouveau.</translation>
    </message>
    <message>
        <source>they have answered at these links before: are their plugs in at both ends, and have they power?</source>
        <translation>ils ont déjà répondu sur ces liaisons&#xa0;: leurs fiches sont-elles branchées aux deux bouts, et sont-ils alimentés&#xa0;?</translation>
    </message>
    <message>
        <source>The guardian is lost. COILS OFF (F12) works without it.</source>
        <translation>Le gardien est perdu. BOBINES À ZÉRO (F12) fonctionne sans lui.</translation>
    </message>
    <message>
        <source>coil x</source>
        <translation>bobine x</translation>
    </message>
    <message>
        <source>coil y</source>
        <translation>bobine y</translation>
    </message>
    <message>
        <source>coil z</source>
        <translation>bobine z</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>contacts</translation>
    </message>
    <message>
        <source>interlock</source>
        <translation>verrouillage</translation>
    </message>
    <message>
        <source>platform</source>
        <translation>plate-forme</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>référence</translation>
    </message>
    <message>
        <source>✕ No answer from {0}.</source>
        <translation>✕ Pas de réponse de {0}.</translation>
    </message>
    <message>
        <source>Put that right first: see to plug and power. “Hands off” is not taken before it answers.</source>
        <translation>Remédiez-y d&apos;abord&#xa0;: voyez la prise et l&apos;alimentation. «&#xa0;Mains loin&#xa0;» n&apos;est pas accepté avant qu&apos;il réponde.</translation>
    </message>
    <message>
        <source>See to plug and power as well: nothing is measured before it answers.</source>
        <translation>Voyez aussi la prise et l&apos;alimentation&#xa0;: rien n&apos;est mesuré avant qu&apos;il réponde.</translation>
    </message>
    <message>
        <source>{0} (since {1})</source>
        <translation>{0} (depuis {1})</translation>
    </message>
    <message>
        <source>First press COILS OFF (F12), then switch off by hand the supply that does not answer.</source>
        <translation>Appuyez d&apos;abord sur BOBINES À ZÉRO (F12), puis coupez à la main l&apos;alimentation qui ne répond pas.</translation>
    </message>
    <message>
        <source>First stop the platform at its controller, and see it stand.</source>
        <translation>D&apos;abord, arrêtez le plateau à son contrôleur, et voyez-le à l&apos;arrêt.</translation>
    </message>
    <message>
        <source>First wait until hands may go in.</source>
        <translation>D&apos;abord, attendez que les mains puissent entrer.</translation>
    </message>
    <message>
        <source>No answer from all {0} instruments at {1}: look at their common line, not at each plug.</source>
        <translation>Pas de réponse des {0} appareils à {1}&#xa0;: voyez leur ligne commune, et non chaque prise.</translation>
    </message>
    <message>
        <source>No answer from all {0} instruments: is the rack’s power off, or the adapter or network gone?</source>
        <translation>Pas de réponse des {0} instruments&#xa0;: la baie est-elle hors tension, ou l’adaptateur ou le réseau absent&#xa0;?</translation>
    </message>
    <message>
        <source>No answer from {0} instruments, all {1} at {2} among them: look at that common line first.</source>
        <translation>Pas de réponse de {0} appareils, dont les {1} à {2}&#xa0;: voyez d&apos;abord cette ligne commune.</translation>
    </message>
    <message>
        <source>{0}: answers again</source>
        <translation>{0}&#xa0;: répond de nouveau</translation>
    </message>
    <message>
        <source>✓ The zero was checked: supplies and reference agree. A run may begin again.</source>
        <translation>✓ Le zéro a été vérifié&#xa0;: alimentations et référence s’accordent. Une mesure peut de nouveau commencer.</translation>
    </message>
    <message>
        <source>the certificate, for people</source>
        <translation>le certificat, pour les personnes</translation>
    </message>
    <message>
        <source>the calibration, for programs</source>
        <translation>l&apos;étalonnage, pour les programmes</translation>
    </message>
    <message>
        <source>a signature of it</source>
        <translation>une signature de celui-ci</translation>
    </message>
    <message>
        <source>when it was signed</source>
        <translation>quand il a été signé</translation>
    </message>
    <message>
        <source>the keys to verify it by</source>
        <translation>les clés pour le vérifier</translation>
    </message>
    <message>
        <source>this list, for the customer</source>
        <translation>cette liste, pour le client</translation>
    </message>
    <message>
        <source>{0} in the store</source>
        <translation>{0} dans le dépôt</translation>
    </message>
    <message>
        <source>{0} of {1} in the store</source>
        <translation>{0} sur {1} dans le dépôt</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Approuver</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>Signer</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Délivrer</translation>
    </message>
    <message>
        <source>Hand out</source>
        <translation>Remettre</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Make a key (1)</source>
        <translation>Créer une clé (1)</translation>
    </message>
    <message>
        <source>Approve (2)</source>
        <translation>Approuver (2)</translation>
    </message>
    <message>
        <source>Sign (3)</source>
        <translation>Signer (3)</translation>
    </message>
    <message>
        <source>Hand it out (4)</source>
        <translation>Remettre (4)</translation>
    </message>
    <message>
        <source>By the method {0}. Zero reading: what the sensor indicates in no field; the offset k of b = K m − k is under Map.</source>
        <translation>Par la méthode {0}. Lecture à zéro&#xa0;: ce que le capteur indique sans champ&#xa0;; le décalage k de b = K m − k est sous Transformation.</translation>
    </message>
    <message>
        <source>U of one component of the field: up to {0} nT (k = 2), {1} % of it from {2}.</source>
        <translation>U d&apos;une composante du champ&#xa0;: jusqu&apos;à {0} nT (k = 2), dont {1} % de {2}.</translation>
    </message>
    <message>
        <source>U of one component of the field: {0} nT (k = 2), mostly from the mounting, declared good to {1}°.</source>
        <translation>U d&apos;une composante du champ&#xa0;: {0} nT (k = 2), surtout du montage, déclaré exact à {1}°.</translation>
    </message>
    <message>
        <source>To lower it, mount more exactly and declare that (u_mounting_deg): docs/certificate.md</source>
        <translation>Pour le réduire, monter plus exactement et le déclarer (u_mounting_deg)&#xa0;: docs/certificate.md</translation>
    </message>
    <message>
        <source>What it is made of: docs/certificate.md</source>
        <translation>De quoi il est fait&#xa0;: docs/certificate.md</translation>
    </message>
    <message>
        <source>the declared mounting ({0})</source>
        <translation>le montage déclaré ({0})</translation>
    </message>
    <message>
        <source>the reference sees {0} µT along {1} more than with the coils off</source>
        <translation>la référence voit {0} µT selon {1} de plus qu&apos;avec les bobines à zéro</translation>
    </message>
    <message>
        <source>the field says: still on ({1}, {0} µT more than with the coils off, {2})</source>
        <translation>le champ dit&#xa0;: encore en marche ({1}, {0} µT de plus que les bobines coupées, {2})</translation>
    </message>
    <message>
        <source>a coil is still on by the field</source>
        <translation>une bobine est encore alimentée d’après le champ</translation>
    </message>
    <message>
        <source>✕ HANDS OFF: a coil is still on, the field says so</source>
        <translation>✕ MAINS LOIN&#xa0;: une bobine est encore alimentée, le champ le dit</translation>
    </message>
    <message>
        <source>{0}: not confirmed at zero when the window closed, {1}</source>
        <translation>{0}&#xa0;: zéro non confirmé à la fermeture de la fenêtre, {1}</translation>
    </message>
    <message>
        <source>{0}: not confirmed at a standstill when the window closed, {1}</source>
        <translation>{0}&#xa0;: arrêt non confirmé à la fermeture de la fenêtre, {1}</translation>
    </message>
    <message>
        <source>about {0} s more, said at {1}</source>
        <translation>encore {0} s environ, dit à {1}</translation>
    </message>
    <message>
        <source>about {0} s more, longer than was said before; said at {1}</source>
        <translation>encore environ {0} s, plus que ce qui avait été dit&#xa0;; dit à {1}</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Suite&#xa0;: {0}</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>ne peut être affiché</translation>
    </message>
    <message>
        <source>{0} · run of {1}</source>
        <translation>{0} · mesure du {1}</translation>
    </message>
    <message>
        <source>COILS OFF (F12), then switch off by hand: {0}</source>
        <translation>BOBINES À ZÉRO (F12), puis couper à la main&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Switch off by hand: {0}</source>
        <translation>Couper à la main&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Still to be read: {0}</source>
        <translation>Encore à lire&#xa0;: {0}</translation>
    </message>
    <message>
        <source>{0} (last read {1})</source>
        <translation>{0} (dernière lecture {1})</translation>
    </message>
    <message>
        <source>COILS OFF was pressed at {0}; nobody has confirmed it</source>
        <translation>BOBINES À ZÉRO a été actionné à {0}&#xa0;; personne ne l’a confirmé</translation>
    </message>
    <message>
        <source>zero, output open</source>
        <translation>zéro, sortie ouverte</translation>
    </message>
    <message>
        <source>zero, output not open</source>
        <translation>zéro, sortie non ouverte</translation>
    </message>
    <message>
        <source>{0}: answers again, no answer from {1} to {2}</source>
        <translation>{0}&#xa0;: répond de nouveau, pas de réponse de {1} à {2}</translation>
    </message>
    <message>
        <source>▲ Not traced: {0} nT of |b| are left over beyond the map, and nobody has looked for their cause.</source>
        <translation>▲ Résidu non expliqué&#xa0;: {0} nT de |b| restent au-delà de la transformation, et personne n&apos;en a cherché la cause.</translation>
    </message>
    <message>
        <source>To do here: {0}</source>
        <translation>À faire ici&#xa0;: {0}</translation>
    </message>
    <message>
        <source>▲ Not traced: nobody has looked for the cause of what is left over beyond the map.</source>
        <translation>▲ Résidu non expliqué&#xa0;: personne n&apos;a cherché la cause de ce qui reste au-delà de la transformation.</translation>
    </message>
    <message>
        <source>They are of two DUTs: their offsets and gains are no change of one, and stand in no table. Residuals and loci of both are drawn below.</source>
        <translation>Elles sont de deux DUT&#xa0;: leurs offsets et gains ne sont pas un changement d&apos;un seul, et ne sont dans aucun tableau. Les résidus et les lieux des deux sont tracés ci-dessous.</translation>
    </message>
    <message>
        <source>cause</source>
        <translation>cause</translation>
    </message>
    <message>
        <source>takes off  nT</source>
        <translation>ôte  nT</translation>
    </message>
    <message>
        <source>evidence</source>
        <translation>évidence</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>raison</translation>
    </message>
    <message>
        <source>in files</source>
        <translation>dans les fichiers</translation>
    </message>
    <message>
        <source>✓ named</source>
        <translation>✓ nommée</translation>
    </message>
    <message>
        <source>? rival</source>
        <translation>? rivale</translation>
    </message>
    <message>
        <source>– not named</source>
        <translation>– non nommée</translation>
    </message>
    <message>
        <source>enough</source>
        <translation>assez</translation>
    </message>
    <message>
        <source>too little</source>
        <translation>trop peu</translation>
    </message>
    <message>
        <source>does about as well as “{0}”</source>
        <translation>fait à peu près aussi bien que «&#xa0;{0}&#xa0;»</translation>
    </message>
    <message>
        <source>no evidence</source>
        <translation>aucune évidence</translation>
    </message>
    <message>
        <source>back {0}, out since {1}</source>
        <translation>de retour {0}, absent depuis {1}</translation>
    </message>
    <message>
        <source>The instruments of your lab: open its bench file, and see that each answers.</source>
        <translation>Les instruments de votre laboratoire&#xa0;: ouvrir le fichier du banc et voir que chacun répond.</translation>
    </message>
    <message>
        <source>You mount the DUT about each axis; coils and platform do the rest.</source>
        <translation>Vous montez le DUT autour de chaque axe&#xa0;; bobines et plate-forme font le reste.</translation>
    </message>
    <message>
        <source>Offset, scale and angles from that run, each with its uncertainty.</source>
        <translation>Décalage, facteur d&apos;échelle et angles de cette mesure, chacun avec son incertitude.</translation>
    </message>
    <message>
        <source>What is left over is traced to its cause, and tried on held-out data.</source>
        <translation>Ce qui reste est ramené à sa cause, et éprouvé sur des données mises de côté.</translation>
    </message>
    <message>
        <source>Another person approves, you sign, and it is handed out.</source>
        <translation>Une autre personne approuve, vous signez, et le fichier est remis.</translation>
    </message>
    <message>
        <source>Measured already, and kept: {0} (how late the reading follows the field).</source>
        <translation>Déjà mesuré, et gardé&#xa0;: {0} (le retard de la lecture sur le champ).</translation>
    </message>
    <message>
        <source>Lost: {0}, which comes of turns there and back without a break, and too few of those are left to measure. To get it: sync-check, or a new preflight.</source>
        <translation>Perdu&#xa0;: {0}, qui vient de rotations aller et retour sans interruption, et il en reste trop peu à mesurer. Pour l&apos;obtenir&#xa0;: sync-check, ou un nouveau preflight.</translation>
    </message>
    <message>
        <source>✓ done for this DUT</source>
        <translation>✓ fait pour ce DUT</translation>
    </message>
    <message>
        <source>● it goes on now</source>
        <translation>● c’est en cours</translation>
    </message>
    <message>
        <source>▲ done, and something of it is open: the page says what</source>
        <translation>▲ fait, et un point reste ouvert&#xa0;: la page dit lequel</translation>
    </message>
    <message>
        <source>✕ it failed: the page says why</source>
        <translation>✕ cela a échoué&#xa0;: la page dit pourquoi</translation>
    </message>
    <message>
        <source>○ still to be done for this DUT</source>
        <translation>○ encore à faire pour ce DUT</translation>
    </message>
    <message>
        <source>✓ every instrument answered within the last {0} s</source>
        <translation>✓ chaque instrument a répondu dans les {0} dernières s</translation>
    </message>
    <message>
        <source>● no answer within the last {0} s, for nobody asked: {1}. By themselves they are asked now and then.</source>
        <translation>● pas de réponse dans les {0} dernières s, car personne n’a demandé&#xa0;: {1}. D’eux-mêmes ils sont interrogés de temps en temps.</translation>
    </message>
    <message>
        <source>✕ no answer: {1}</source>
        <translation>✕ pas de réponse&#xa0;: {1}</translation>
    </message>
    <message>
        <source>○ no instrument answered within the last {0} s; Read all asks them</source>
        <translation>○ aucun instrument n’a répondu dans les {0} dernières s&#xa0;; Tout lire les interroge</translation>
    </message>
    <message>
        <source>✓ a run that this DUT can be calibrated by is finished</source>
        <translation>✓ une mesure qui permet d’étalonner ce DUT est terminée</translation>
    </message>
    <message>
        <source>▲ the last run that was to calibrate this DUT did not come to its end</source>
        <translation>▲ la dernière mesure qui devait étalonner ce DUT n’est pas allée à son terme</translation>
    </message>
    <message>
        <source>○ no run yet that this DUT can be calibrated by: a preflight is one, a turn about one axis is none</source>
        <translation>○ pas encore de mesure qui permette d’étalonner ce DUT&#xa0;: un preflight en est une, une rotation sur un axe n’en est pas une</translation>
    </message>
    <message>
        <source>Open a bench file</source>
        <translation>Ouvrir un fichier de banc</translation>
    </message>
    <message>
        <source>being asked</source>
        <translation>en cours d’interrogation</translation>
    </message>
    <message>
        <source>not looked at at rest</source>
        <translation>pas lu au repos</translation>
    </message>
    <message>
        <source>To look at it opens its port: that resets many a microcontroller, or switches what it sends. Read all asks it who it is.</source>
        <translation>Le regarder ouvre son port&#xa0;: cela réinitialise bien des microcontrôleurs, ou change ce qu&apos;ils envoient. Tout lire lui demande qui il est.</translation>
    </message>
    <message>
        <source>read again in the next step</source>
        <translation>relu à l’étape suivante</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>et {0} de plus</translation>
    </message>
    <message>
        <source>Being traced: {0}</source>
        <translation>Résidu en cours d’explication&#xa0;: {0}</translation>
    </message>
    <message>
        <source>Being fitted: {0}</source>
        <translation>Ajustement en cours&#xa0;: {0}</translation>
    </message>
    <message>
        <source>The bench that was open stays open: {0}.</source>
        <translation>Le banc qui était ouvert le reste&#xa0;: {0}.</translation>
    </message>
    <message>
        <source>Begun on the bench {0}.</source>
        <translation>Commencée sur le banc {0}.</translation>
    </message>
    <message>
        <source>▲ Begun on the bench {0}; {1} is open. Open {0} first: with other instruments it does not go on.</source>
        <translation>▲ Commencée sur le banc {0}&#xa0;; {1} est ouvert. Ouvrez d&apos;abord {0}&#xa0;: avec d&apos;autres appareils, elle ne continue pas.</translation>
    </message>
    <message>
        <source>{0} (simulated)</source>
        <translation>{0} (simulé)</translation>
    </message>
    <message>
        <source>{0} (served)</source>
        <translation>{0} (servi)</translation>
    </message>
    <message>
        <source>{0} (not simulated)</source>
        <translation>{0} (non simulé)</translation>
    </message>
    <message>
        <source>The buttons of the run have just changed: nothing was done. Press again.</source>
        <translation>Les boutons de la mesure viennent de changer&#xa0;: rien n&apos;a été fait. Appuyez de nouveau.</translation>
    </message>
    <message>
        <source>gain K {0} by {1}</source>
        <translation>gain K {0} par {1}</translation>
    </message>
    <message>
        <source>What a reading along {1} adds to the field along {0}.</source>
        <translation>Ce qu&apos;une lecture selon {1} ajoute au champ selon {0}.</translation>
    </message>
</context>
<context>
    <name>WorkBar</name>
    <message>
        <source>Something is being computed</source>
        <translation>Un calcul est en cours</translation>
    </message>
</context>
</TS>
