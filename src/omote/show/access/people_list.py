"""The people who may play a show, and their tokens.

No token is kept anywhere: each is a keyed hash (HMAC-SHA-256) of its person's id under the secret key of the list, so
it can be shown again, and whoever reads the names alone can make none.
"""

from __future__ import annotations

import base64
import hashlib
import hmac
from dataclasses import dataclass
from typing import Annotated

import msgspec

from omote.show.access.access_role import HIGHEST, AccessRole
from omote.show.validation import Refusal

ID_LENGTH = 8
TOKEN_LENGTH = 30
"""Characters of an id, and of a token: the id, then 132 bits of the hash."""
KEY_BYTES = 32
MOST_PEOPLE = 100
LONGEST_NAME = 24
LONGEST_HOURS = 24.0 * 366

PersonId = Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9_-]{8}$")]


class Person(msgspec.Struct, frozen=True):
    """Somebody who may play: `made` and `until` in seconds since 1970, `until` None for ever."""

    id: PersonId
    name: Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_NAME)]
    role: AccessRole
    made: float
    until: float | None = None


class People(msgspec.Struct, frozen=True):
    """The list of a show: its secret key (hexadecimal), and everybody who has a token."""

    key: Annotated[str, msgspec.Meta(pattern="^[0-9a-f]{64}$")]
    people: tuple[Person, ...] = ()


@dataclass(frozen=True)
class Visitor:
    """Who sends a request: a name for the others, a role, and the person, None where the show asks for no token."""

    role: AccessRole = HIGHEST
    name: str = ""
    person: str | None = None


ANYBODY = Visitor()
"""Who comes to a show that only this machine reaches."""


def token_of(people: People, person: Person) -> str:
    """The token of a person. people: the list that the person is on."""
    return person.id + _code(people, person.id)


def find_person(people: People, token: str, now: float) -> Person | None:
    """Whose token it is; None where it is nobody's, revoked or past its time. Takes the same time for every token.
    people: the list; now: seconds since 1970."""
    if not is_own(people, token):
        return None
    person = next((person for person in people.people if person.id == token[:ID_LENGTH]), None)
    return person if person is not None and is_valid(person, now) else None


def is_own(people: People, token: str) -> bool:
    """Whether a token was made for this list (people), for somebody who is on it or was."""
    right = _code(people, token[:ID_LENGTH]).encode()
    return hmac.compare_digest(right, token[ID_LENGTH:].encode(errors="replace"))


def is_valid(person: Person, now: float) -> bool:
    """Whether the time of a person has not ended. now: seconds since 1970."""
    return person.until is None or now < person.until


def add_person(people: People, person: Person) -> People:
    """The list with one more; Refusal where the name is taken or there is no room. people: the list; person: who is
    added."""
    if not person.name.strip() or len(person.name) > LONGEST_NAME or not person.name.isprintable():
        raise Refusal(f"{person.name[:40]!r} is no name; give 1 to {LONGEST_NAME} letters.")
    if any(other.name.casefold() == person.name.casefold() for other in people.people):
        raise Refusal(f"there is a token for {person.name!r} already: revoke it first, or give another name.")
    if len(people.people) >= MOST_PEOPLE:
        raise Refusal(f"there are {MOST_PEOPLE} tokens, the most there can be: revoke some first.")
    return msgspec.structs.replace(people, people=(*people.people, person))


def find_named(people: People, name: str) -> Person:
    """The person of a name; Refusal, with the names that there are, where nobody is called so. people: the list; name:
    in any case."""
    match = next((person for person in people.people if name.strip().casefold() == person.name.casefold()), None)
    if match is None:
        there = ", ".join(person.name for person in people.people) or "nobody"
        raise Refusal(f"there is no token for {name[:40]!r}; there are tokens for {there}.")
    return match


def remove_person(people: People, wanted: str) -> tuple[People, Person]:
    """The list without somebody, by id or name, and who that was; Refusal where nobody is called so, or it would leave
    nobody who may change the list. people: the list; wanted: an id or a name."""
    removed = next((person for person in people.people if wanted == person.id), None) or find_named(people, wanted)
    rest = tuple(person for person in people.people if person is not removed)
    if removed.role == HIGHEST and not any(person.role == HIGHEST and person.until is None for person in rest):
        raise Refusal(f"{removed.name!r} is the last who may change this list: make another admin first.")
    return msgspec.structs.replace(people, people=rest), removed


def check_hours(hours: float | None) -> float | None:
    """For how long a token is to be valid, None for ever; Refusal for a time that cannot be."""
    if hours is None or 0.0 < hours <= LONGEST_HOURS:
        return hours
    raise Refusal(f"a token for {hours:g} hours cannot be; give more than 0 and at most {LONGEST_HOURS:g}.")


def cookie_name(people: People) -> str:
    """The name of the cookie of this list: two shows at one address have two."""
    return "omote-" + hashlib.sha256(people.key.encode()).hexdigest()[:ID_LENGTH]


def _code(people: People, person: str) -> str:
    digest = hmac.digest(bytes.fromhex(people.key), person.encode(errors="replace"), "sha256")
    return base64.urlsafe_b64encode(digest).decode()[: TOKEN_LENGTH - ID_LENGTH]
