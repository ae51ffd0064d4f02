"""The window in another language, by Qt's own means: what a widget's own `tr` does not say stands here."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QLibraryInfo, QLocale, QTranslator

from labcal.files.home import home

FOLDER = Path(__file__).parent
OWN = "labcal"  # the name of our translator among the children of the application
MORNING, MORNING_CHECKS = "Morning check", ("morning-check", "axes-check")  # the first that is installed
TEXTS = (  # of tables, headings and functions: lupdate reads them here
    QT_TRANSLATE_NOOP("Words", "Start"),
    QT_TRANSLATE_NOOP("Words", "Bench"),
    QT_TRANSLATE_NOOP("Words", "Run"),
    QT_TRANSLATE_NOOP("Words", "Fit"),
    QT_TRANSLATE_NOOP("Words", "Loop"),
    QT_TRANSLATE_NOOP("Words", "Certificate"),
    QT_TRANSLATE_NOOP("Words", "History"),
    QT_TRANSLATE_NOOP("Words", "COILS OFF   F12"),
    QT_TRANSLATE_NOOP("Words", "not complete"),
    QT_TRANSLATE_NOOP("Words", "Done"),
    QT_TRANSLATE_NOOP("Words", "Mounted"),
    QT_TRANSLATE_NOOP("Words", "Placed"),
    QT_TRANSLATE_NOOP("Words", "Taken away"),
    QT_TRANSLATE_NOOP("Words", "Leads swapped"),
    QT_TRANSLATE_NOOP("Words", "Leads put back"),
    QT_TRANSLATE_NOOP("Words", "Switched"),
    QT_TRANSLATE_NOOP("Words", "Switched off"),
    QT_TRANSLATE_NOOP("Words", "Switched on"),
    QT_TRANSLATE_NOOP("Words", "Warmed"),
    QT_TRANSLATE_NOOP("Words", "Hands off: begin"),
    QT_TRANSLATE_NOOP("Words", "Redo axis {0}"),
    QT_TRANSLATE_NOOP("Words", "offset and first position"),
    QT_TRANSLATE_NOOP("Words", "answers"),
    QT_TRANSLATE_NOOP("Words", "not heard yet"),
    QT_TRANSLATE_NOOP("Words", "not asked"),
    QT_TRANSLATE_NOOP("Words", "Open the folder"),
    QT_TRANSLATE_NOOP("Words", "Copy the path"),
    QT_TRANSLATE_NOOP("Words", "✓ Path copied"),
    QT_TRANSLATE_NOOP("Words", "The path of what was just written, to be pasted elsewhere"),
    QT_TRANSLATE_NOOP("Words", "Show it"),
    QT_TRANSLATE_NOOP("Words", "Open that run on the page that computes it"),
    QT_TRANSLATE_NOOP("Words", "Show in the file manager what was just written"),
    QT_TRANSLATE_NOOP("Words", "Go to Run"),
    QT_TRANSLATE_NOOP("Words", "Record a run, or import one on the History page"),
    QT_TRANSLATE_NOOP("Words", "No run yet: record one on the Run page, or import a bundle on the History page."),
    QT_TRANSLATE_NOOP("Words", "Morning check"),
    QT_TRANSLATE_NOOP("Words", "Yes"),
    QT_TRANSLATE_NOOP("Words", "No"),
    QT_TRANSLATE_NOOP("Words", "Stop the run"),
    QT_TRANSLATE_NOOP("Words", "Hands off: try again"),
    QT_TRANSLATE_NOOP("Words", "Mount it again"),
    QT_TRANSLATE_NOOP("Words", "Skip this step"),
    QT_TRANSLATE_NOOP("Words", "Send"),
    QT_TRANSLATE_NOOP("Words", "✕ This cannot be done as asked"),
    QT_TRANSLATE_NOOP("Words", "✕ An instrument failed"),
    QT_TRANSLATE_NOOP("Words", "✕ The record is not kept"),
    QT_TRANSLATE_NOOP("Words", "✕ The check standard is out of control"),
    QT_TRANSLATE_NOOP("Words", "✕ The guardian failed"),
    QT_TRANSLATE_NOOP("Words", "✕ The clock was set back"),
    QT_TRANSLATE_NOOP("Words", "✕ HANDS OFF: the coils may be on"),
    QT_TRANSLATE_NOOP("Words", "✕ HANDS OFF: the platform may still turn"),
    QT_TRANSLATE_NOOP("Words", "✕ A limit is not met"),
    QT_TRANSLATE_NOOP("Words", "■ Stopped"),
    QT_TRANSLATE_NOOP("Words", "▲ Broken off"),
    QT_TRANSLATE_NOOP("Words", "✕ This page cannot be shown"),
    QT_TRANSLATE_NOOP("Words", "✕ Something in labcal broke"),
    QT_TRANSLATE_NOOP("Words", "✕ The work broke off"),
    QT_TRANSLATE_NOOP("Words", "■ Stopped by COILS OFF (F12)"),
    QT_TRANSLATE_NOOP("Words", "✓ CLEAN"),
    QT_TRANSLATE_NOOP("Words", "✓ EXPLAINED"),
    QT_TRANSLATE_NOOP("Words", "▲ PARTLY EXPLAINED"),
    QT_TRANSLATE_NOOP("Words", "? AMBIGUOUS"),
    QT_TRANSLATE_NOOP("Words", "✕ UNEXPLAINED"),
    QT_TRANSLATE_NOOP("Words", "coverage"),
    QT_TRANSLATE_NOOP("Words", "noise"),
    QT_TRANSLATE_NOOP("Words", "sign"),
    QT_TRANSLATE_NOOP("Words", "delay"),
    QT_TRANSLATE_NOOP("Words", "closure"),
    QT_TRANSLATE_NOOP("Words", "from above"),
    QT_TRANSLATE_NOOP("Words", "from the side"),
    QT_TRANSLATE_NOOP("Words", "body {0}"),
    QT_TRANSLATE_NOOP("Words", "body {0} up"),
    QT_TRANSLATE_NOOP("Words", "mount it with body {0} up"),
    QT_TRANSLATE_NOOP("Words", "mount it as at first"),
    QT_TRANSLATE_NOOP("Words", "current {0}"),
    QT_TRANSLATE_NOOP("Words", "temperature {0}"),
    QT_TRANSLATE_NOOP("Words", "voltage {0}"),
    QT_TRANSLATE_NOOP("Words", "channel {0}"),
    QT_TRANSLATE_NOOP("Words", "cage X"),
    QT_TRANSLATE_NOOP("Words", "cage Y"),
    QT_TRANSLATE_NOOP("Words", "role"),
    QT_TRANSLATE_NOOP("Words", "instrument"),
    QT_TRANSLATE_NOOP("Words", "link"),
    QT_TRANSLATE_NOOP("Words", "who answered"),
    QT_TRANSLATE_NOOP("Words", "last reading"),
    QT_TRANSLATE_NOOP("Words", "state"),
    QT_TRANSLATE_NOOP("Words", "started"),
    QT_TRANSLATE_NOOP("Words", "SIMULATED"),
    QT_TRANSLATE_NOOP("Words", "today"),
    QT_TRANSLATE_NOOP("Words", "yesterday"),
    QT_TRANSLATE_NOOP("Words", "no marks between thousands: 20000, not 20 000, 20,000 or 20.000"),
    QT_TRANSLATE_NOOP("Words", "a point stands before decimals here: 1.5, not 1,5"),
    QT_TRANSLATE_NOOP("Words", "a blank after each comma, and a point before decimals: 20000, 50000.5"),
    QT_TRANSLATE_NOOP("Words", "DUT"),
    QT_TRANSLATE_NOOP("Words", "procedure"),
    QT_TRANSLATE_NOOP("Words", "operator"),
    QT_TRANSLATE_NOOP("Words", "status"),
    QT_TRANSLATE_NOOP("Words", "verdict"),
    QT_TRANSLATE_NOOP("Words", "state"),
    QT_TRANSLATE_NOOP("Words", "site"),
    QT_TRANSLATE_NOOP("Words", "run"),
    QT_TRANSLATE_NOOP("Words", "measured"),
    QT_TRANSLATE_NOOP("Words", "value"),
    QT_TRANSLATE_NOOP("Words", "U (k=2)"),
    QT_TRANSLATE_NOOP("Words", "unit"),
    QT_TRANSLATE_NOOP("Words", "limit"),
    QT_TRANSLATE_NOOP("Words", "limit ±"),
    QT_TRANSLATE_NOOP("Words", "setting"),
    QT_TRANSLATE_NOOP("Words", "mapping"),
    QT_TRANSLATE_NOOP("Words", "row 1"),
    QT_TRANSLATE_NOOP("Words", "row 2"),
    QT_TRANSLATE_NOOP("Words", "row 3"),
    QT_TRANSLATE_NOOP("Words", "field  µT"),
    QT_TRANSLATE_NOOP("Words", "meaning"),
    QT_TRANSLATE_NOOP("Words", "parameter"),
    QT_TRANSLATE_NOOP("Words", "figure"),
    QT_TRANSLATE_NOOP("Words", "result"),
    QT_TRANSLATE_NOOP("Words", "calibration"),
    QT_TRANSLATE_NOOP("Words", "risk"),
    QT_TRANSLATE_NOOP("Words", "as found"),
    QT_TRANSLATE_NOOP("Words", "as left"),
    QT_TRANSLATE_NOOP("Words", "earlier"),
    QT_TRANSLATE_NOOP("Words", "later"),
    QT_TRANSLATE_NOOP("Words", "± U (k=2) is that of the difference; beyond E_n = ±1 the DUT has changed."),
    QT_TRANSLATE_NOOP(
        "Words",
        "One of the two is traced, the other is not: what differs may be what tracing took out. Trace both, or none.",
    ),
    QT_TRANSLATE_NOOP("Words", "They are of two DUTs. ± U (k=2) is that of the difference."),
    QT_TRANSLATE_NOOP(
        "Words", "One of the two is not explained: what differs may be its error, and says nothing of the DUT yet."
    ),
    QT_TRANSLATE_NOOP("Words", "changed"),
    QT_TRANSLATE_NOOP("Words", "{0} changed"),
    QT_TRANSLATE_NOOP("Words", "PASS"),
    QT_TRANSLATE_NOOP("Words", "FAIL"),
    QT_TRANSLATE_NOOP("Words", "MARGINAL"),
    QT_TRANSLATE_NOOP("Words", "CANNOT DECIDE"),
    QT_TRANSLATE_NOOP("Words", "conditional pass"),
    QT_TRANSLATE_NOOP("Words", "conditional fail"),
    QT_TRANSLATE_NOOP("Words", "In specification?"),
    QT_TRANSLATE_NOOP("Words", "In specification"),
    QT_TRANSLATE_NOOP("Words", "In specification, conditionally"),
    QT_TRANSLATE_NOOP("Words", "Not in specification, conditionally"),
    QT_TRANSLATE_NOOP("Words", "Not in specification"),
    QT_TRANSLATE_NOOP("Words", "Risk: how probably the true value is beyond its limit."),
    QT_TRANSLATE_NOOP("Words", "set"),
    QT_TRANSLATE_NOOP("Words", "held-out |b|  nT"),
    QT_TRANSLATE_NOOP("Words", "axis error, worst  deg"),
    QT_TRANSLATE_NOOP("Words", "look"),
    QT_TRANSLATE_NOOP("Words", "methods"),
    QT_TRANSLATE_NOOP("Words", "loop"),
    QT_TRANSLATE_NOOP("Words", "all rows"),
    QT_TRANSLATE_NOOP("Words", "declared"),
    QT_TRANSLATE_NOOP("Words", "static"),
    QT_TRANSLATE_NOOP("Words", "differences"),
    QT_TRANSLATE_NOOP("Words", "inertial"),
    QT_TRANSLATE_NOOP("Words", "nadir"),
    QT_TRANSLATE_NOOP("Words", "none"),
    QT_TRANSLATE_NOOP("Words", "angle  deg"),
    QT_TRANSLATE_NOOP("Words", "field  nT"),
    QT_TRANSLATE_NOOP("Words", "time  s"),
    QT_TRANSLATE_NOOP("Words", "frame"),
    QT_TRANSLATE_NOOP("Words", "known"),
    QT_TRANSLATE_NOOP("Words", "free"),
    QT_TRANSLATE_NOOP("Words", "yes"),
    QT_TRANSLATE_NOOP("Words", "no"),
    QT_TRANSLATE_NOOP("Words", "several, with commas"),
    QT_TRANSLATE_NOOP("Words", "real time"),
    QT_TRANSLATE_NOOP("Words", "20 times"),
    QT_TRANSLATE_NOOP("Words", "100 times"),
    QT_TRANSLATE_NOOP("Words", "at once"),
    QT_TRANSLATE_NOOP("Words", "zero reading"),
    QT_TRANSLATE_NOOP("Words", "offset k"),
    QT_TRANSLATE_NOOP("Words", "offset k x  nT"),
    QT_TRANSLATE_NOOP("Words", "offset k y  nT"),
    QT_TRANSLATE_NOOP("Words", "offset k z  nT"),
    QT_TRANSLATE_NOOP("Words", "closed loop"),
    QT_TRANSLATE_NOOP("Words", "scale"),
    QT_TRANSLATE_NOOP("Words", "non-orthogonality"),
    QT_TRANSLATE_NOOP("Words", "gain"),
    QT_TRANSLATE_NOOP("Words", "nT"),
    QT_TRANSLATE_NOOP("Words", "ppm from the first"),
    QT_TRANSLATE_NOOP("Words", "DUT  nT"),
    QT_TRANSLATE_NOOP("Words", "Plot: {0} against {1}"),
    QT_TRANSLATE_NOOP("Words", "residual  nT"),
    QT_TRANSLATE_NOOP("Words", "held-out rms  nT"),
    QT_TRANSLATE_NOOP("Words", "no fields all round at one magnitude: see field-sphere"),
    QT_TRANSLATE_NOOP("Words", "finished"),
    QT_TRANSLATE_NOOP("Words", "stopped"),
    QT_TRANSLATE_NOOP("Words", "stopped by COILS OFF"),
    QT_TRANSLATE_NOOP("Words", "broken off"),
    QT_TRANSLATE_NOOP("Words", "imported"),
    QT_TRANSLATE_NOOP("Words", "running"),
    QT_TRANSLATE_NOOP("Words", "Save the picture"),
    QT_TRANSLATE_NOOP("Words", "Save …"),
    QT_TRANSLATE_NOOP("Words", "Write this picture to a .png file, as it is shown"),
    QT_TRANSLATE_NOOP("Words", "Copy"),
    QT_TRANSLATE_NOOP("Words", "Every point that is drawn to the clipboard, as columns x and y of each curve"),
    QT_TRANSLATE_NOOP("Words", "Needs: {0}"),
    QT_TRANSLATE_NOOP("Words", "About {0:g} min of measuring, and your own time beside it"),
    QT_TRANSLATE_NOOP("Words", "The plan says how long this takes"),
    QT_TRANSLATE_NOOP("Words", "the operator"),
    QT_TRANSLATE_NOOP("Words", "With a key here: {0}."),
    QT_TRANSLATE_NOOP("Words", "Whoever signed has a key elsewhere."),
    QT_TRANSLATE_NOOP("Words", "Nobody has a key here. Make one for the person who approves."),
    QT_TRANSLATE_NOOP("Words", "Only {0} has a key here. Make one for who approves: another person than {1}."),
    QT_TRANSLATE_NOOP("Words", "Approved by {0}."),
    QT_TRANSLATE_NOOP("Words", "Signed without an approval: nobody can be added any more."),
    QT_TRANSLATE_NOOP("Words", "Another person than {0} looks at the figures below, and approves."),
    QT_TRANSLATE_NOOP("Words", "First a key of another person than {0} (1)."),
    QT_TRANSLATE_NOOP("Words", "Do not use it: make a new draft on the Fit page."),
    QT_TRANSLATE_NOOP("Words", "{0} has to sign. The operator may sign as well."),
    QT_TRANSLATE_NOOP("Words", "Good to use as PROVISIONAL; {0} has still to sign."),
    QT_TRANSLATE_NOOP("Words", "Their key is not on this computer."),
    QT_TRANSLATE_NOOP("Words", "Signed by {0}."),
    QT_TRANSLATE_NOOP("Words", "First a key (1)."),
    QT_TRANSLATE_NOOP("Words", "After the approval (2). Nobody there? Sign alone: it is valid, and PROVISIONAL."),
    QT_TRANSLATE_NOOP("Words", "Once it is signed (3)."),
    QT_TRANSLATE_NOOP("Words", "Once {0} has signed; before that as PROVISIONAL."),
    QT_TRANSLATE_NOOP("Words", "Handed out. Next: another DUT."),
    QT_TRANSLATE_NOOP("Words", "As PROVISIONAL: nobody approved it before it was signed."),
    QT_TRANSLATE_NOOP("Words", "As PROVISIONAL: why is said above."),
    QT_TRANSLATE_NOOP("Words", "No key can bear “{0}”: letters, digits and . _ @ + - alone, as in ada.smith"),
    QT_TRANSLATE_NOOP("Words", "{0} has a key here already, as {1}."),
    QT_TRANSLATE_NOOP("Words", "The two passphrases differ."),
    QT_TRANSLATE_NOOP("Words", "{0} is the operator, {1}: another person approves."),
)


def translated(text: str) -> str:
    """One of `WORDS` in the language of the window; what is none of them as it is."""
    return QCoreApplication.translate("Words", text)


def procedure_title(name: str) -> str:
    """A procedure as its page is headed: with the words that lead there, where they are others than its name."""
    return f"{translated(MORNING)} · {name}" if name in MORNING_CHECKS else name


def install_translator(application: QCoreApplication, locale: QLocale, folders: Iterable[Path] | None = None) -> bool:
    """Have the window speak the language of `locale`, from the first labcal_xx.qm of it; says whether there is one.

    Looked for in the `translations` of the lab's own folder, then in those that are shipped. What it spoke before is
    taken away; without such a file it speaks English.
    """
    for former in application.findChildren(QTranslator, OWN):
        application.removeTranslator(former)
        former.deleteLater()
    QLocale.setDefault(QLocale(QLocale.Language.English))
    for folder in folders or (home() / "translations", FOLDER):
        if _installed(application, locale, "labcal", folder):
            _installed(
                application, locale, "qtbase", Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
            )
            QLocale.setDefault(locale)  # days, months and decimal marks follow the words
            return True
    return False


def _installed(application: QCoreApplication, locale: QLocale, name: str, folder: Path) -> bool:
    """Whether the folder has this file of the language; what Qt's own dialogs say is in one of Qt's."""
    translator = QTranslator(application)
    translator.setObjectName(OWN)
    return translator.load(locale, name, "_", str(folder), ".qm") and application.installTranslator(translator)


def languages() -> dict[str, str]:
    """What the window can speak, by code, each called as who speaks it calls it: de is Deutsch."""
    files = sorted(path for folder in (FOLDER, home() / "translations") for path in folder.glob("labcal_*.qm"))
    codes = ["en", *(path.stem.removeprefix("labcal_") for path in files)]
    return {code: QLocale(code).nativeLanguageName().capitalize() if code != "en" else "English" for code in codes}


def spoken() -> str:
    """The code of the language that the window speaks now."""
    here = QLocale()
    return next((code for code in languages() if QLocale(code).language() == here.language()), "en")


def following(code: str) -> str:
    """The language after this one, the first after the last."""
    codes = list(languages())
    return codes[(codes.index(code) + 1) % len(codes)] if code in codes else "en"
