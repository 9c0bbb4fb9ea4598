"""The cue lists of a show over HTTP, as data and as text, and what the show file keeps of them."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from functools import partial

import msgspec
from aiohttp import web

from omote.interchange.formats.cue_toml import format_cues, format_running_order, parse_cues
from omote.server.access.access_guard import visitor_in
from omote.server.http.document_routes import NO_CACHE
from omote.show.cues.cue_book import read_book
from omote.show.objects.cues import CUE_LIST_PATH
from omote.show.session import ShowSession

LONGEST_TEXT = 2**22
"""Bytes of a list as text: 2,000 cues of twelve moves have a quarter of it."""
TEXTS = {
    "toml": ("application/toml", format_cues),
    "csv": ("text/csv", format_running_order),
}
"""What a list is written as, by the value of `?as=`."""


class CueRoutes:
    """Answers for the cue lists of a session."""

    def __init__(self, session: ShowSession) -> None:
        self.session = session

    def add_routes(self, application: web.Application) -> None:
        """Adds the address of the lists."""
        application.router.add_get(CUE_LIST_PATH, self.respond)
        application.router.add_post(CUE_LIST_PATH, self.take_in)

    def load(self, documents: Callable[[str], Mapping[str, bytes]], report: Callable[[str], None]) -> None:
        """Plays what the show file keeps. documents: of a kind, by name; report: tells the operator what of it cannot
        be read."""
        book, lost = read_book(documents)
        self.session.cues.load(book)
        for sentence in lost:
            report(sentence)

    async def respond(self, request: web.Request) -> web.Response:
        """Responds with a list: JSON, or text to keep with `?as=toml` or `?as=csv`; 204 where there is none."""
        name = request.match_info["name"]
        document = self.session.cues.document(name)
        headers = {"Cache-Control": NO_CACHE}
        if document is None:
            return web.Response(status=204, headers=headers)
        form = request.query.get("as", "")
        if not form:
            return web.Response(body=msgspec.json.encode(document), content_type="application/json", headers=headers)
        if form not in TEXTS:
            raise web.HTTPBadRequest(text=f"a list of cues is written as {' or '.join(TEXTS)}, not as {form[:80]!r}.")
        kind, write = TEXTS[form]
        headers["Content-Disposition"] = f'attachment; filename="cues.{form}"'
        return web.Response(body=write(document.cues).encode(), content_type=kind, headers=headers)

    async def take_in(self, request: web.Request) -> web.Response:
        """Takes in a list as text (TOML) in the place of the one of the name, or as a new one; 400 with every line that
        is wrong."""
        try:
            text = await _text(request)
            cues = await asyncio.get_running_loop().run_in_executor(None, partial(parse_cues, text))
            self.session.cues.take_in(request.match_info["name"], cues, visitor_in(request).name or "a file")
        except ValueError as error:
            raise web.HTTPBadRequest(text=str(error)) from error
        return web.json_response({"cues": len(cues)})


async def _text(request: web.Request) -> str:
    """The text that a page sends; ValueError where it is too long, or none."""
    body = bytearray()
    async for chunk in request.content.iter_any():
        body += chunk
        if len(body) > LONGEST_TEXT:
            raise ValueError(f"the text has more than {LONGEST_TEXT} bytes, which no list of cues has.")
    try:
        return body.decode()
    except UnicodeDecodeError as error:
        raise ValueError("this is no text (UTF-8); send a list of cues as TOML.") from error
