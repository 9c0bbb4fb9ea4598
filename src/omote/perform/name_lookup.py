"""Finds the name that a person means: in any case, with spaces, hyphens or underscores, by its label, or by FACS."""

from __future__ import annotations

import difflib
import unicodedata
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from omote.model.action_units import explain_action_unit, find_units
from omote.model.known_names import NEUTRAL, UNIT_NOUNS, list_near

ALL = "all"
OWN = "own"
"""Instead of a kind: every expression but neutral. The kind of those of a show file."""
NO_LABELS: Mapping[str, str] = MappingProxyType({})


def find_name(
    typed: str, names: Iterable[str], what: str, labels: Mapping[str, str] = NO_LABELS, *, where: str = " in this cast"
) -> str:
    """Returns the one of `names` that a person means: `Crooked Smile`, `crooked-smile` and `crooked_smile` are one.

    typed: what was written.

    names: those there are; labels: what people read, by name; what, where: "face", " in this cast", for messages. A
    name exactly as it is written wins, then names, then labels, then action units of FACS (of expressions and channels:
    `AU12`). ValueError with the nearest names where none is meant, and with all that are where several could be.
    """
    return find_names(typed, names, what, labels, where=where, halves=False)[0]


def find_names(
    typed: str,
    names: Iterable[str],
    what: str,
    labels: Mapping[str, str] = NO_LABELS,
    *,
    where: str = " in this cast",
    halves: bool = True,
) -> tuple[str, ...]:
    """Returns the one of `names` that a person means, as `find_name`; halves: also both halves of an action unit that
    no single one is, `AU45` is eyeBlinkLeft and eyeBlinkRight, else ValueError.

    typed: what was written; what: "face", "expression" or "channel", for messages; labels: what people read, by name;
    where: what messages add, " in this cast".
    """
    choices = list(names)
    if typed in choices:
        return (typed,)
    meant = fold(typed)
    matches = [name for name in choices if meant and fold(name) == meant]
    matches = matches or [name for name in choices if meant and fold(labels.get(name, "")) == meant]
    if len(matches) > 1:
        raise ValueError(f"the {what} {typed[:80]!r} could be {' or '.join(matches)}; write one of these names")
    units = matches or (find_units(typed, choices) if what in UNIT_NOUNS else ())
    if len(units) == 1 or (units and halves):
        return tuple(units)
    explanation = explain_action_unit(typed, choices) if what in UNIT_NOUNS else ""
    if units:
        raise ValueError(f"{explanation}; write one of them, or both as channels ({'+'.join(units)})")
    there = explanation or list_near(nearest(typed, choices, labels), choices)
    raise ValueError(f"there is no {what} {typed[:80]!r}{where}; {there}")


def find_kind(word: str, kinds: Mapping[str, str]) -> list[str]:
    """The expressions of a kind (`arkit`, `own`), or all of them but neutral (`all`); none where a word is no kind.

    kinds: of every expression, by name. ValueError where there are no own ones.
    """
    wanted = word.strip().lower()
    names = [name for name, kind in kinds.items() if wanted == kind or (wanted == ALL and name != NEUTRAL)]
    if wanted == OWN and not names:
        raise ValueError("there are no own expressions here; name a show file that holds some: --show my.omote")
    return names


def fold(text: str) -> str:
    """Folds a name or a label for comparison: letters and digits alone, lower case, without accents."""
    plain = unicodedata.normalize("NFKD", text).casefold()
    return "".join(letter for letter in plain if letter.isalnum())


def nearest(typed: str, names: Iterable[str], labels: Mapping[str, str] = NO_LABELS) -> list[str]:
    """The names, three at most, that are nearest to what was typed, by themselves or by their labels."""
    folded: dict[str, str] = {}
    for name in names:
        for text in (name, labels.get(name, "")):
            if text:
                folded.setdefault(fold(text), name)
    near = difflib.get_close_matches(fold(typed), folded, n=6, cutoff=0.4)
    return list(dict.fromkeys(folded[key] for key in near))[:3]
