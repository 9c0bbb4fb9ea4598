"""Decides who sends a request: by a token, its cookie, and the list of people, which may change while the show runs."""

from __future__ import annotations

import asyncio
import re
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from http import HTTPStatus
from pathlib import Path
from typing import Literal

from aiohttp import hdrs, web

from omote.server.access.people_file import change_people, read_people
from omote.show.access.people_list import ID_LENGTH, People, Person, Visitor, cookie_name, find_person, is_own, is_valid
from omote.show.access.wrong_tokens import WrongTokens

TOKEN = "token"
BEARER = "bearer "
SAFE_METHODS = ("GET", "HEAD")

Carrier = Literal["header", "query", "cookie"]


class DeniedError(Exception):
    """A request is not answered; the message says why, in a sentence. wait: the seconds after which to try again."""

    def __init__(self, status: HTTPStatus, sentence: str, wait: float = 0.0) -> None:
        super().__init__(sentence)
        self.status = status
        self.sentence = sentence
        self.wait = wait


@dataclass(frozen=True)
class Presented:
    """A token, and how it came."""

    token: str
    carrier: Carrier


NO_TOKEN = "this show is played by those who have a token: open the address that you were given."
NO_ORIGIN = "a program shows its token itself: send Authorization: Bearer, or ?token=."
DENIALS = {
    "several": (HTTPStatus.BAD_REQUEST, "this request carries several tokens: send one."),
    "wrong": (
        HTTPStatus.UNAUTHORIZED,
        "this is no token of this show: look whether it is whole, or ask whoever runs the show for a new one.",
    ),
    "revoked": (HTTPStatus.UNAUTHORIZED, "your token was revoked: ask whoever runs the show for a new one."),
    "ended": (HTTPStatus.UNAUTHORIZED, "the time of your token has ended: ask whoever runs the show for a new one."),
    "many": (
        HTTPStatus.TOO_MANY_REQUESTS,
        "too many wrong tokens came from your address: wait a minute, or send a right one, which is let in at once.",
    ),
}
"""What an address says of a token that was not taken, once the token itself has left it."""


class AccessControl:
    """Who may play a show. path: the list; wall: seconds since 1970; clock: seconds, monotonic; report: for the
    terminal."""

    def __init__(
        self,
        path: Path,
        people: People,
        *,
        wall: Callable[[], float] = time.time,  # noqa: TID251  (a token's end is a date)
        clock: Callable[[], float] = time.monotonic,
        report: Callable[[str], None] = lambda _: None,
    ) -> None:
        self.path = path
        self.people = people
        self._wall = wall
        self._clock = clock
        self._report = report
        self._wrong = WrongTokens()
        self._stamp = self._read_stamp()

    @property
    def cookie(self) -> str:
        """The name of the cookie that carries a token."""
        return cookie_name(self.people)

    def find_visitor(self, request: web.Request) -> tuple[Visitor, Presented]:
        """Who sends a request, and by which token; DeniedError where that is nobody who may."""
        host = request.remote or ""
        now = self._clock()
        presented = self._read_token(request)
        person = find_person(self.people, presented.token, self._wall())
        if person is None:
            if is_own(self.people, presented.token):  # one that was revoked is no guess
                raise DeniedError(*DENIALS["ended" if self.find_person(presented.token[:ID_LENGTH]) else "revoked"])
            wait = self._wrong.note(host, presented.token, now)
            raise DeniedError(*DENIALS["wrong"]) if wait == 0.0 else DeniedError(*DENIALS["many"], wait)
        return visitor_of(person), presented

    def holds(self, visitor: Visitor) -> bool:
        """Whether somebody who came in may stay."""
        person = self.find_person(visitor.person or "")
        return person is not None and person.role == visitor.role and is_valid(person, self._wall())

    def names(self) -> list[str]:
        """The names of those whose token is their own."""
        return [name for person in self.people.people if (name := visitor_of(person).name)]

    def find_person(self, wanted: str) -> Person | None:
        """The person of an id."""
        return next((person for person in self.people.people if person.id == wanted), None)

    def reload(self) -> None:
        """Takes up what another program has written into the list; a list that cannot be read stays as it was."""
        stamp = self._read_stamp()
        if stamp in (self._stamp, None):
            return
        self._stamp = stamp
        try:
            self.people = read_people(self.path)
        except (OSError, ValueError) as error:
            self._report(f"{error} Until then the tokens stay as they were.")

    async def change(self, change: Callable[[People], People]) -> None:
        """Changes the list, at once here and then in its file; Refusal where it cannot be, OSError with a message where
        it is not in the file."""
        self.people = change(self.people)
        await asyncio.to_thread(change_people, self.path, change)

    def _read_token(self, request: web.Request) -> Presented:
        headers = request.headers.getall(hdrs.AUTHORIZATION, [])
        asked = request.query.getall(TOKEN, [])
        cookies = read_cookies(request.headers.getall(hdrs.COOKIE, []), self.cookie)
        if max(len(headers), len(asked), len(cookies)) > 1:
            raise DeniedError(*DENIALS["several"])
        if headers:
            if not headers[0].lower().startswith(BEARER):
                raise DeniedError(HTTPStatus.UNAUTHORIZED, NO_TOKEN)
            return Presented(headers[0][len(BEARER) :].strip(), "header")
        if asked:
            return Presented(token_in_text(asked[0]), "query")
        if not cookies:
            raise DeniedError(HTTPStatus.UNAUTHORIZED, NO_TOKEN)
        if _needs_origin(request) and hdrs.ORIGIN not in request.headers:
            raise DeniedError(HTTPStatus.UNAUTHORIZED, NO_ORIGIN)
        return Presented(cookies[0], "cookie")

    def _read_stamp(self) -> tuple[int, int] | None:
        try:
            status = self.path.stat()
        except OSError:
            return None
        return status.st_mtime_ns, status.st_ino


def token_in_text(text: str) -> str:
    """The token in what a person pastes: the token alone or the whole address, with blanks and line breaks."""
    joined = "".join(text.split())
    _, separator, rest = joined.rpartition(f"{TOKEN}=")
    return re.split("[&#]", rest)[0] if separator else joined


def visitor_of(person: Person) -> Visitor:
    """What the show knows of a person; a token that carries its role's name is shared, and its bearer has no name."""
    return Visitor(person.role, "" if person.name == person.role else person.name, person.id)


def read_cookies(lines: Iterable[str], name: str) -> list[str]:
    """All values of a cookie in the headers of a request: two mean that somebody has slipped one in.

    lines: the headers; name: of the cookie.
    """
    pairs = (pair.partition("=") for line in lines for pair in line.split(";"))
    return [value.strip().strip('"') for key, _, value in pairs if key.strip() == name]


def _needs_origin(request: web.Request) -> bool:
    """Whether a browser says where such a request comes from: what a page of others could send with our cookie."""
    return request.method not in SAFE_METHODS or hdrs.UPGRADE in request.headers
