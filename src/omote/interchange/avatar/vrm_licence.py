"""Terms of use as VRM 1.0 says them (`meta`), read from words: `cc0`, `strict`, or single terms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal, get_args

Terms = Mapping[str, str | bool]
Version = Literal["1.0", "0.x"]
VERSIONS: tuple[Version, ...] = get_args(Version)

LICENCE_URL = "https://vrm.dev/licenses/1.0/"
CC0_URL = "https://creativecommons.org/publicdomain/zero/1.0/"
TERMS: Mapping[str, tuple[str | bool, ...]] = {
    "avatarPermission": ("onlyAuthor", "onlySeparatelyLicensedPerson", "everyone"),
    "commercialUsage": ("personalNonProfit", "personalProfit", "corporation"),
    "creditNotation": ("required", "unnecessary"),
    "modification": ("prohibited", "allowModification", "allowModificationRedistribution"),
    "allowRedistribution": (False, True),
    "allowExcessivelyViolentUsage": (False, True),
    "allowExcessivelySexualUsage": (False, True),
    "allowPoliticalOrReligiousUsage": (False, True),
    "allowAntisocialOrHateUsage": (False, True),
}
"""What each term can be: from what holds where nothing is said, the strictest, to the freest."""
STRICT = "strict"
CC0 = "cc0"
ANSWERS = {"yes": True, "true": True, "no": False, "false": False}
ANSWERED: Mapping[str | bool, str] = {True: "yes", False: "no"}
HOW = "--licence strict (the author alone), cc0 (anyone, for anything), or terms, as avatarPermission=everyone"


@dataclass(frozen=True)
class Credit:
    """Who made an avatar, and what others may do with it; terms None: not said, so only what is CC0 can be written;
    version: of VRM. labels: what own faces are called, by their names; free: own faces that are CC0, made of nothing
    but the built-in cast.

    Raises ValueError where no author is named.
    """

    authors: tuple[str, ...]
    terms: Terms | None = None
    version: Version = "1.0"
    labels: Mapping[str, str] = field(default_factory=dict)
    free: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        if not self.authors or not all(name.strip() for name in self.authors):
            raise ValueError(
                "a VRM names who made it: give --author NAME, again for each further one; of an own face also who may "
                "use it, --licence strict for example"
            )

    def sentence(self, face: str) -> str:
        """Whose a written avatar is said to be, for people."""
        who = f"{self.labels.get(face, face)} is by {', '.join(self.authors)}"
        if self.terms is None:
            whence = "is made of nothing but faces that came with Omote" if face in self.free else "came with Omote"
            return f"{who}; it {whence} and is CC0, so anyone may use it for anything (--licence says otherwise)"
        said = [f"{name} {ANSWERED.get(value, value)}" for name, value in self.terms.items() if name in TERMS]
        return f"{who}, and others may use it so: {', '.join(said)}"

    def agreed(self, face: str, *, own: bool) -> Terms:
        """The terms for a face; ValueError for an own one whose terms nobody has said."""
        if self.terms is None and own and face not in self.free:
            raise ValueError(f"{face!r} is an own face and not CC0 as the built-in cast is: say who may use it, {HOW}")
        return _freest() if self.terms is None else self.terms


def parse_terms(words: Sequence[str], /) -> Terms | None:
    """Reads terms of use, several by commas; what is not named is as strict as VRM has it; None where no word is.

    ValueError for a term or a value that VRM 1.0 does not have, and for one that is given twice.
    """
    parts = [part.strip() for word in words for part in word.split(",") if part.strip()]
    if not parts:
        return None
    if len(parts) == 1 and parts[0].lower() in (STRICT, CC0):
        return _freest() if parts[0].lower() == CC0 else _strictest()
    terms = [_parse_term(part) for part in parts]
    if twice := [key for at, (key, _) in enumerate(terms) if key in dict(terms[:at])]:
        raise ValueError(f"{twice[0]} is given twice; say it once")
    return _strictest() | dict(terms)


def _parse_term(text: str) -> tuple[str, str | bool]:
    key, equals, value = (part.strip() for part in text.partition("="))
    name = next((term for term in TERMS if _plain(term) == _plain(key)), None)
    if name is None or not equals:
        raise ValueError(f"{text!r} is no term of use; give {HOW}; there are {', '.join(TERMS)}")
    if TERMS[name] == (False, True):
        if value.lower() not in ANSWERS:
            raise ValueError(f"{name} is {value!r}; expected yes or no")
        return name, ANSWERS[value.lower()]
    chosen = next((option for option in TERMS[name] if str(option).lower() == value.lower()), None)
    if chosen is None:
        raise ValueError(f"{name} is {value!r}; expected one of {', '.join(map(str, TERMS[name]))}")
    return name, chosen


def _plain(name: str) -> str:
    return name.lower().removeprefix("allow")


def _strictest() -> dict[str, str | bool]:
    return {name: values[0] for name, values in TERMS.items()}


def _freest() -> dict[str, str | bool]:
    return {name: values[-1] for name, values in TERMS.items()} | {"otherLicenseUrl": CC0_URL}
