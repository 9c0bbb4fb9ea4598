"""What people choose of a cast by name: expressions, hair. The names alone are needed, not the cast."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Protocol

from omote.model.known_names import NEUTRAL
from omote.perform.name_lookup import ALL, find_kind, find_names

NO_HAIR = "none"


class Titled(Protocol):
    """What an expression is called, and its kind."""

    @property
    def label(self) -> str:
        """What people read."""

    @property
    def kind(self) -> str:
        """arkit, performed, own or another."""


class NamedExpressions(Protocol):
    """A cast, or its names alone."""

    @property
    def expressions(self) -> Mapping[str, object]:
        """By name, whatever stands for them."""

    @property
    def titles(self) -> Mapping[str, Titled]:
        """What they are called, by name."""


def choose_expressions(cast: NamedExpressions, text: str, /) -> list[str]:
    """Parses a list of expressions: kinds (`arkit`, `performed`, `own`), `all`, or names, by commas; without neutral.

    ValueError for a name that is neither, and where nothing is named.

    cast: with its titles; text: as people write it.
    """
    names: dict[str, None] = {}
    kinds = {name: title.kind for name, title in cast.titles.items()}
    for word in filter(None, (word.strip() for word in text.split(","))):
        names |= dict.fromkeys(find_kind(word, kinds) or _named_expressions(cast, word))
    if not names:
        raise ValueError(f"{text!r} names no expression; give names or a kind by commas: smile,joy or arkit or neutral")
    return [name for name in names if name != NEUTRAL]


def _named_expressions(cast: NamedExpressions, word: str) -> Sequence[str]:
    labels = {name: title.label for name, title in cast.titles.items()}
    try:
        return find_names(word, cast.expressions, "expression", labels)
    except ValueError as error:
        kinds = dict.fromkeys(title.kind for title in cast.titles.values())
        raise ValueError(f"{error}; or name a kind: {', '.join(kinds)}, {ALL}") from None


def choose_hair(styles: Iterable[str], word: str, /) -> str | None:
    """The hair style that a word names, "" for none, None where no word is given; ValueError for another word.

    styles: of a cast; word: as people write it.
    """
    if word.lower() == NO_HAIR or not word:
        return "" if word else None
    listed = [*styles]
    if word not in listed:
        raise ValueError(f"there is no hair {word!r}; choose one of {', '.join(listed)}, or {NO_HAIR}")
    return word
