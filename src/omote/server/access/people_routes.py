"""The addresses under which pages ask who they are, and an admin lists, makes and revokes tokens."""

from __future__ import annotations

import time
from collections.abc import Awaitable, Callable, Iterable

import msgspec
from aiohttp import web

from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.access_control import AccessControl
from omote.server.access.access_guard import visitor_in
from omote.server.access.people_file import new_person
from omote.server.access.qr_code import qr_picture
from omote.server.access.show_addresses import entry_address
from omote.show.access.access_documents import AccessDocument, CodeDocument, NewPerson, PeopleDocument, PersonDocument
from omote.show.access.people_list import Person, Visitor, add_person, check_hours, remove_person, token_of
from omote.show.validation import Refusal
from omote.show.wire import encode

MESSAGEPACK = "application/msgpack"
CERTIFICATE = "application/x-x509-ca-cert"
NO_PEOPLE = "this show asks nobody for a token: only this machine reaches it. Start it with --host 0.0.0.0."
_new_person: msgspec.msgpack.Decoder[NewPerson] = msgspec.msgpack.Decoder(NewPerson)


class PeopleRoutes:
    """Answers about people. control: None where the show asks for no token; visitors: those whose links are open;
    changed: is called when the list has changed; authority: the certificate that tablets may install."""

    def __init__(
        self,
        control: Callable[[], AccessControl | None],
        visitors: Callable[[], Iterable[Visitor]],
        changed: Callable[[], None],
        authority: Callable[[], bytes | None],
    ) -> None:
        self._control = control
        self._visitors = visitors
        self._changed = changed
        self._authority = authority

    def add_routes(self, application: web.Application) -> None:
        """Adds the addresses."""
        application.router.add_get("/access", self.access)
        application.router.add_get("/people", self.people)
        application.router.add_post("/people", self.add)
        application.router.add_delete("/people/{id}", self.revoke)
        application.router.add_get("/people/{id}/code", self.code)
        application.router.add_get("/certificate", self.certificate)

    async def access(self, request: web.Request) -> web.Response:
        """Responds with who the page is."""
        visitor = visitor_in(request)
        return _respond(AccessDocument(visitor.role, visitor.name, self._control() is not None))

    async def people(self, request: web.Request) -> web.Response:
        """Responds with everybody who has a token."""
        return self._list(request, self._asked())

    async def add(self, request: web.Request) -> web.Response:
        """Makes a token, and responds with the address and the picture by which its person enters."""
        control = self._asked()
        try:
            wanted = _new_person.decode(await request.read())
            person = new_person(wanted.name, wanted.role, _wall(), check_hours(wanted.hours))
        except (msgspec.DecodeError, UnicodeDecodeError, Refusal) as error:
            raise web.HTTPBadRequest(text=f"no token can be made: {explain_error(error).rstrip('.')}.") from error
        await _keep(control.change(lambda people: add_person(people, person)))
        return _respond(_code(request, control, person))

    async def revoke(self, request: web.Request) -> web.Response:
        """Revokes a token and closes the links that came by it; responds with who is left."""
        control = self._asked()
        wanted = request.match_info["id"]
        try:
            await _keep(control.change(lambda people: remove_person(people, wanted)[0]))
        finally:
            self._changed()
        return self._list(request, control)

    async def code(self, request: web.Request) -> web.Response:
        """Responds with the address and the picture by which somebody enters."""
        control = self._asked()
        person = control.find_person(request.match_info["id"])
        if person is None:
            raise web.HTTPNotFound(text="there is no such token any more.")
        return _respond(_code(request, control, person))

    async def certificate(self, _: web.Request) -> web.Response:
        """Responds with the certificate of the authority, which a tablet installs once."""
        authority = self._authority()
        if authority is None:
            raise web.HTTPNotFound(text="this show has made no certificate: start it with --https.")
        headers = {"Content-Disposition": 'attachment; filename="omote.crt"', "Cache-Control": "no-cache"}
        return web.Response(body=authority, content_type=CERTIFICATE, headers=headers)

    def _asked(self) -> AccessControl:
        control = self._control()
        if control is None:
            raise web.HTTPNotFound(text=NO_PEOPLE)
        return control

    def _list(self, request: web.Request, control: AccessControl) -> web.Response:
        own = visitor_in(request).person
        there = [visitor.person for visitor in self._visitors()]
        rows = [
            PersonDocument(
                person.id, person.name, person.role, person.made, person.until, there.count(person.id), person.id == own
            )
            for person in control.people.people
        ]
        return _respond(PeopleDocument(rows))


async def _keep(changing: Awaitable[None]) -> None:
    try:
        await changing
    except Refusal as refusal:
        raise web.HTTPConflict(text=str(refusal)) from refusal
    except (OSError, ValueError) as error:
        raise web.HTTPServiceUnavailable(text=f"this holds until the show ends, and is not kept: {error}") from error


def _code(request: web.Request, control: AccessControl, person: Person) -> CodeDocument:
    address = entry_address(f"{request.scheme}://{request.host}", person.role, token_of(control.people, person))
    return CodeDocument(person.id, address, qr_picture(address))


def _respond(document: msgspec.Struct) -> web.Response:
    return web.Response(body=encode(document), content_type=MESSAGEPACK, headers={"Cache-Control": "no-store"})


def _wall() -> float:
    """Seconds since 1970, for people to read."""
    return time.time()  # noqa: TID251  (dates tokens; drives nothing)
