"""What newcomers read is as it promises: short paragraphs, a glossary whose rooms exist, one meaning a name."""

from __future__ import annotations

import ast
import re
from collections import Counter
from pathlib import Path
from runpy import run_path

ROOT = Path(__file__).parents[1]
AT_MOST_LINES = 6
MATHEMATICS = ("geometry.py", "earth", "record", "model", "uncertainty", "quality", "fit", "loop")
NO_PROSE = ("|", "#", "<!--")
PRIVATE = {  # words that stand for others in no field: what to say instead
    "told": "reported, stated, sent, notified, distinguished",
    "untold": "not reported",
    "nought": "zero, none",
    "weighed": "scored, weighted",
    "weighing": "scoring",
    "mended": "corrected, repaired",
    "greet": "identify",
    "greets": "identifies",
    "greeted": "identified",
    "honest": "agrees with the scatter",
    "feigned": "noise-induced",
    "heaviest": "largest",
    "wary": "checked, plausible",
    "akin": "related",
    "rubbish": "incoherent",
}
ANY_PRIVATE = re.compile("|".join(PRIVATE), re.IGNORECASE)
KINDS_OF_FAULT = ("reliability.md",)  # written by the campaign, whose kinds are names
ITEM = r"\n(?=\s*(?:-|\d+\.) )"  # of a list: a paragraph of its own


def paragraphs(text: str) -> list[list[str]]:
    """Runs of prose lines, items of lists among them, without tables, headings and code."""
    plain = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    found = [part.splitlines() for part in re.split(rf"\n\s*\n|{ITEM}", plain)]
    return [prose for part in found if (prose := [line for line in part if not line.startswith(NO_PROSE)])]


def rooms(row: str) -> list[str]:
    """What stands between backticks in a row's last cell."""
    return re.findall(r"`([^`]+)`", row.strip().strip("|").split("|")[-1])


def there(room: str) -> bool:
    places = (ROOT / "labcal" / room, ROOT / room)
    return any(place.exists() or place.with_name(f"{place.name}.py").exists() for place in places)


def pages() -> dict[str, str]:
    """What people read by its name, but what the campaign writes."""
    by_itself = [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    found = [*by_itself, *sorted((ROOT / "docs").glob("*.md"))]
    return {page.name: page.read_text(encoding="utf-8") for page in found if page.name not in KINDS_OF_FAULT}


def test_no_paragraph_is_longer_than_six_lines() -> None:
    found = {
        name: [prose[0] for prose in paragraphs(text) if len(prose) > AT_MOST_LINES] for name, text in pages().items()
    }
    assert {name: long for name, long in found.items() if long} == {}
    assert len(found) > 20


def test_the_changelog_leads_to_every_page_and_to_none_that_is_gone() -> None:
    named = set(re.findall(r"\]\((docs/[^)#]+)", pages()["CHANGELOG.md"]))
    assert named == {f"docs/{path.name}" for path in (ROOT / "docs").glob("*.md")}


def private_words(text: str) -> list[str]:
    """Words of `PRIVATE` in what people read: code, links and names between backticks are not."""
    if not ANY_PRIVATE.search(text):  # most texts: the rest takes longer
        return []
    prose = re.sub(r"```.*?```|`[^`]*`|\]\([^)]*\)", " ", text, flags=re.DOTALL)
    return [word for word in re.findall(r"[a-z]+", prose.lower()) if word in PRIVATE]


def test_what_people_read_says_it_in_words_that_a_newcomer_knows() -> None:
    found = {name: words for name, text in pages().items() if (words := private_words(text))}
    assert found == {}, {word: PRIVATE[word] for words in found.values() for word in words}
    assert private_words("It is told, `told` and [told](told.md):\n```\ntold\n```\n**Told**.") == ["told"] * 3


def spoken(tree: ast.Module, *, help_too: bool) -> list[tuple[int, str]]:
    """Texts of a module by line: what it may print; where `help_too` its docstrings as well, which are its help."""
    nodes = list(ast.walk(tree))
    first = [n.body[0] for n in nodes if isinstance(n, (ast.Module, ast.ClassDef, ast.FunctionDef)) and n.body]
    docs = {id(n.value) for n in first if isinstance(n, ast.Expr)} if not help_too else set()
    texts = [n for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)]
    return [(n.lineno, n.value) for n in texts if id(n) not in docs and " " in n.value]


def test_what_labcal_says_uses_no_private_word_either() -> None:
    files = sorted(p for room in ("labcal", "drivers", "procedures") for p in (ROOT / room).rglob("*.py"))
    found = [
        f"{path.relative_to(ROOT)}:{line}: {words}"
        for path in files
        for line, text in spoken(ast.parse(path.read_text(encoding="utf-8")), help_too=path.parent.name == "cli")
        if (words := private_words(text))
    ]
    assert found == []
    assert spoken(ast.parse('"""Told."""\nsay("it was told")'), help_too=False) == [(2, "it was told")]


def test_each_term_of_the_glossary_lives_in_a_room_that_there_is() -> None:
    rows = [
        line
        for line in (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8").splitlines()
        if line.startswith("| ") and not line.startswith("| term")
    ]
    assert [row for row in rows if not rooms(row)] == []
    assert [room for row in rows for room in rooms(row) if room != "u" and not there(room)] == []
    terms = [row.split("|")[1].strip().casefold() for row in rows]
    assert len(terms) == len(set(terms)) > 40


def test_a_long_paragraph_and_a_room_that_moved_are_seen() -> None:
    assert [len(one) for one in paragraphs("# Title\n\na\nb\n\n| c |\n\nd\ne\nf\n- g\n  h\n- i\n")] == [2, 3, 2, 1]
    assert rooms("| a | b | | `loop/data`, `fit` |") == ["loop/data", "fit"]
    assert there("loop/policy")
    assert not there("loop/quick")


def public_classes(room: str) -> list[str]:
    place = ROOT / "labcal" / room
    files = [place] if place.is_file() else sorted(place.rglob("*.py"))
    trees = (ast.parse(file.read_text(encoding="utf-8")) for file in files)
    return [n.name for tree in trees for n in tree.body if isinstance(n, ast.ClassDef) and not n.name.startswith("_")]


def test_a_class_of_the_mathematics_has_a_name_of_its_own() -> None:
    names = Counter(name for room in MATHEMATICS for name in public_classes(room))
    assert [name for name, count in names.items() if count > 1] == []
    assert len(names) > 100


def test_the_page_about_the_loop_holds_judgements_and_effects_as_they_are() -> None:
    page = (ROOT / "docs" / "closed-loop.md").read_text(encoding="utf-8")
    with_tables = run_path(str(ROOT / "tools" / "loop_tables.py"))["with_tables"]
    assert with_tables(page) == page, "run tools/loop_tables.py: it writes both tables"
    for cell in ("| 12 nats |", "| `hysteresis` |"):
        assert with_tables(page.replace(cell, "| another |", 1)) == page
