"""Answers control surfaces that ask which addresses of OSC there are (OSCQuery), at the port of the pages."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping
from typing import Any

import msgspec
from aiohttp import web

from omote.inputs.osc_feedback import AddressValues
from omote.inputs.oscquery_tree import ATTRIBUTES, HOST_INFO, Node, build_addresses, find_node, host_info, with_values
from omote.perform.snapshot import Playable
from omote.show.objects.state import State
from omote.show.osc import ROOT

Page = Callable[[web.Request], Awaitable[web.Response]]
Playing = Callable[[], tuple[State | None, Playable, tuple[str, ...], Mapping[str, int]]]
NAME = "Omote"
PEOPLE = "curl/", "wget/", "httpie/"
"""How programs begin their name with which people look what there is."""
TOLD_PERSON = (
    "Omote plays a show here: /console plays it, /stage shows it, /editor makes faces and expressions.\n"
    f"Control surfaces read its addresses of OSC (OSCQuery): /{ROOT}, /?HOST_INFO.\n"
)


class OscQuery:
    """The tree over HTTP. on_air: gives the newest state, the cast, the names of the characters and the dimensions of
    pads; port: of OSC."""

    def __init__(self, on_air: Playing, port: int) -> None:
        self._on_air = on_air
        self._port = port
        self._addresses: tuple[Playable, object, Node] | None = None

    def add_routes(self, application: web.Application, index: Page) -> None:
        """Adds the root, which stays a page for browsers, and all that is below the root of OSC.

        application: gets them; index: answers for the page at the root.
        """

        async def root(request: web.Request) -> web.Response:
            if request.query_string:
                return await self.respond(request)
            if "text/html" in request.headers.get("Accept", ""):
                return await index(request)
            return web.Response(text=TOLD_PERSON) if _is_person(request) else await self.respond(request)

        application.router.add_get("/", root)
        application.router.add_get(f"/{ROOT}", self.respond)
        application.router.add_get(f"/{ROOT}/{{path:.*}}", self.respond)

    async def respond(self, request: web.Request) -> web.Response:
        """Responds with a node and all below it, or with the one attribute that the query names (204: it has none)."""
        asked = request.query_string.upper()
        if asked == HOST_INFO:
            return _json(host_info(NAME, self._port))
        if asked and asked not in ATTRIBUTES:
            raise web.HTTPBadRequest(text=f"there is no attribute {asked[:80]}; there are {', '.join(ATTRIBUTES)}.")
        state, cast, characters, pads = self._on_air()
        macros = {} if state is None else {name: tuple(each.macros) for name, each in state.characters.items()}
        node = find_node(self._tree(cast, characters, pads, macros), request.path)
        if node is None:
            raise web.HTTPNotFound(text=f"there is no address {request.path[:80]}; /{ROOT} lists them all.")
        node = node if state is None else with_values(node, AddressValues(state))
        if not asked:
            return _json(node)
        return _json({asked: node[asked]}) if asked in node else web.Response(status=204)

    def _tree(self, cast: Playable, *names: Any) -> Node:
        """The tree without values, made once for a cast and the names of characters, pads and macros."""
        kept = self._addresses
        if kept is None or kept[0] is not cast or kept[1] != names:
            kept = self._addresses = cast, names, build_addresses(cast, *names)
        return kept[2]


def _is_person(request: web.Request) -> bool:
    """Whether somebody types at a terminal: surfaces accept anything too, but have no such name."""
    agent = request.headers.get("User-Agent", "").lower()
    accepted = request.headers.get("Accept", "*/*")
    return accepted.strip() == "*/*" and agent.startswith(PEOPLE)


def _json(document: Node | dict[str, Any]) -> web.Response:
    return web.Response(
        body=msgspec.json.encode(document), content_type="application/json", headers={"Cache-Control": "no-cache"}
    )
