"""What a name and a passphrase of a key may be, as they are typed: the rules of `labcal.certificate`, in words."""

from __future__ import annotations

import re
import unicodedata

from labcal.certificate.allowed_signers import check_principal
from labcal.certificate.passphrases import objection
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.record.person import perhaps_one_person


def key_name_objection(name: str) -> str:
    """Why no key can bear this name; "" where one can, or nothing is typed."""
    try:
        check_principal(name or "nobody")
    except ValueError:
        return translated("No key can bear “{0}”: letters, digits and . _ @ + - alone, as in ada.smith").format(name)
    return ""


def as_key_name(typed: str) -> str:
    """A name as a key can bear it: of "L. Holm" l.holm; "" where nothing is left of it."""
    plain = unicodedata.normalize("NFKD", typed.casefold()).encode("ascii", "ignore").decode()
    name = re.sub(r"[^a-z0-9_@+-]+", ".", plain).strip(".")
    return "" if key_name_objection(name) else name


def key_objection(name: str, passphrase: str, again: str, keys: tuple[str, ...]) -> str:
    """What is against making this key, of what has been typed so far, all of it; "" where nothing is."""
    said = [key_name_objection(name)]
    if not said[0] and (twin := next((one for one in keys if name and perhaps_one_person(name, one)), "")):
        said.append(translated("{0} has a key here already, as {1}.").format(name, twin))
    if passphrase and (why := objection(passphrase, name)) is not None:
        said.append(in_words(why))
    if again and not passphrase.startswith(again):
        said.append(translated("The two passphrases differ."))
    return "\n✕ ".join(filter(None, said))


def approver_objection(name: str, operator: str) -> str:
    """Why this person cannot approve what `operator` measured; "" where they can, or nobody is named."""
    if said := key_name_objection(name):
        return said
    if name and perhaps_one_person(name, operator):
        return translated("{0} is the operator, {1}: another person approves.").format(name, operator)
    return ""
