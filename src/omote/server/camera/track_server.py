"""The camera page on the performer's own machine, where browsers give it a camera; the show is elsewhere."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable, Mapping
from pathlib import Path

from aiohttp import web

from omote.client.show_address import base_address, check_token
from omote.client.trust import trusted_context
from omote.inputs.performers.camera_messages import CAMERA_PATH
from omote.server.access.listening import listen
from omote.server.access.security import adding_headers, guard, silence_bad_requests
from omote.server.camera.show_relay import ShowRelay, ShowTarget
from omote.server.http.static_pages import Page, read_pages

SHOW_PORT = 8090
PAGE = "/camera"
"""What is served at the root too."""
CONSOLE = "/console"
"""The page leads there, and here it leads on to the show's own."""


def find_target(address: str, token: str | None, authority: Path | None) -> ShowTarget:
    """The show that a performer names, as `HOST`, `HOST:PORT` or the address that `omote show` prints; ValueError for
    what is no address or no token, or a certificate for a show without https, OSError for one that cannot be read.

    authority: the certificate to trust, None for what this machine trusts.
    """
    text = address.strip()
    base = base_address(text)
    if "//" not in text and ":" not in text.partition("/")[0]:
        base = f"{base}:{SHOW_PORT}"
    if authority is not None and not base.startswith("https:"):
        raise ValueError(f"--authority is for a show with https; leave it out, or give --to https:{base[5:]}")
    trusted = trusted_context(authority) if base.startswith("https:") else None
    return ShowTarget(base, check_token(token, text), trusted)


def application(target: ShowTarget, pages: Mapping[str, Page]) -> web.Application:
    """The pages' files and the link that is passed on; only this machine is answered.

    target: the show; pages: the built files.
    """
    silence_bad_requests()
    app = web.Application(middlewares=[guard(frozenset({"localhost"}))])
    app.on_response_prepare.append(adding_headers())
    app.router.add_get(CAMERA_PATH, ShowRelay(target).respond)

    async def respond(request: web.Request) -> web.Response:
        if request.path == CONSOLE:
            raise web.HTTPFound(target.address + CONSOLE)
        page = pages.get(PAGE if request.path == "/" else request.path)
        if page is None:
            raise web.HTTPNotFound(text=f"there is only {PAGE} here; the show's pages are at {target.address}.")
        return web.Response(body=page.body, content_type=page.content_type)

    app.router.add_get("/{page:.*}", respond)
    return app


def track(target: ShowTarget, port: int, announce: Callable[[str, str], None]) -> None:
    """Serves the camera page until Ctrl-C. announce: is told the page's address, and why the show cannot be reached,
    "" where it can. OSError where the port cannot be had, FileNotFoundError where the pages are not built.

    target: the show; port: of the page, 0 for any.
    """
    pages = read_pages()
    opened = listen(port)
    asyncio.run(_serve(target, pages, opened, announce))


async def _serve(
    target: ShowTarget, pages: Mapping[str, Page], opened: socket.socket, announce: Callable[[str, str], None]
) -> None:
    runner = web.AppRunner(application(target, pages), access_log=None, shutdown_timeout=1.0)
    await runner.setup()
    await web.SockSite(runner, opened).start()
    reason = ""
    try:
        await ShowRelay(target).reach()
    except ConnectionError as error:
        reason = str(error)
    try:
        announce(f"http://localhost:{opened.getsockname()[1]}{PAGE}", reason)
        await asyncio.Event().wait()
    finally:
        await runner.cleanup()
