"""Validates names and labels: a name is a permanent key of the cast, a label is shown to people and may change."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from itertools import chain, count

from omote.show.validation import Refusal

LONGEST_LABEL = 80
"""Characters."""
_LONGEST_SLUG = 60
_CONTROLS = {"\n": "a line break", "\r": "a line break", "\t": "a tab"}


def clean_label(label: str, what: str = "the label") -> str:
    """Strips a label; Refusal where it is empty, too long or not printable.

    label: as typed; what: its noun in the message.
    """
    text = label.strip()
    wanted = f"give 1 to {LONGEST_LABEL} printable characters."
    if not text:
        raise Refusal(f"{what} is empty: {wanted}")
    if len(text) > LONGEST_LABEL:
        raise Refusal(f"{what} has {len(text)} characters: {wanted}")
    if not text.isprintable():
        raise Refusal(f"{what} has {describe_unprintable(text)} in it, which nobody can see: {wanted}")
    return text


def describe_unprintable(text: str) -> str:
    """Names the first character of a text that cannot be printed, for people, as Unicode does: what was typed with it
    cannot be shown. text: has such a character."""
    character = next(character for character in text if not character.isprintable())
    name = unicodedata.name(character, "").lower() or f"U+{ord(character):04X}"
    return _CONTROLS.get(character, f"the character '{name}'")


def clean_tags(tags: Iterable[str]) -> tuple[str, ...]:
    """Strips tags and removes repeated ones; Refusal where one is empty, too long or not printable."""
    return tuple(dict.fromkeys(clean_label(tag, "a tag") for tag in tags))


def clean_text(text: str) -> str:
    """Strips a note, which may be empty; Refusal where it is not printable."""
    if not text.isprintable():
        raise Refusal(f"the note has {describe_unprintable(text)} in it: give printable characters.")
    return text.strip()


def slug(label: str, otherwise: str) -> str:
    """Converts a label to lower-case ASCII letters, digits and `_`; `otherwise` where nothing is left."""
    plain = unicodedata.normalize("NFKD", label).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "_", plain).strip("_")[:_LONGEST_SLUG].rstrip("_") or otherwise


def new_name(label: str, otherwise: str, taken: Iterable[str]) -> str:
    """Makes a name from a label, different from those taken (case-insensitive).

    label: for people; otherwise: the name where no letter of it is left; taken: names.
    """
    used = {name.casefold() for name in taken}
    stem = slug(label, otherwise)
    candidates = (stem if number == 1 else f"{stem}_{number}" for number in count(1))
    return next(name for name in candidates if name not in used)


def free_label(label: str, taken: Iterable[str]) -> str:
    """A label as it is, else with the lowest number from 2 that gives one not taken (case-insensitive)."""
    used = {other.casefold() for other in taken}
    room = LONGEST_LABEL - len(f" {len(used) + 2}")
    numbered = (f"{label[:room]} {number}" for number in count(2))
    return next(candidate for candidate in chain((label,), numbered) if candidate.casefold() not in used)


def new_label(stem: str, taken: Iterable[str]) -> str:
    """Appends to `stem` the lowest number from 1 that gives a label not taken."""
    used = {label.casefold() for label in taken}
    return next(label for label in (f"{stem} {number}" for number in count(1)) if label.casefold() not in used)
