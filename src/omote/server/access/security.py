"""Checks the Host and Origin of requests (DNS rebinding, foreign pages) and adds the security headers."""

from __future__ import annotations

import ipaddress
import logging
import re
import socket
from collections.abc import Awaitable, Callable, Sequence
from urllib.parse import urlsplit

from aiohttp import web
from aiohttp.http_exceptions import HttpProcessingError
from aiohttp.typedefs import Handler, Middleware

POLICY = "Content-Security-Policy"
ANCESTORS = "frame-ancestors 'self'"
STAGE_PAGE = "/stage"
MOST_TOLD = 16
"""Sites of which it is told that no stage stands in their frames."""
HEADERS = {
    POLICY: "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "worker-src 'self' blob:; connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; " + ANCESTORS,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}

_ORIGIN = re.compile(r"https?://([a-z0-9.-]{1,253}|\[[0-9a-f:.]{2,45}\])(:[0-9]{1,5})?", re.IGNORECASE)
WASM_FOLDER = "/static/wasm_workers/"
"""Scripts of workers that compile WebAssembly (the camera page's face model): these alone may, no page may."""


def silence_bad_requests() -> None:
    """Drops log records of malformed HTTP requests (answered with 400), which would fill the operator's terminal."""
    logging.getLogger("aiohttp.server").addFilter(_is_no_bad_request)


def _is_no_bad_request(record: logging.LogRecord) -> bool:
    return record.exc_info is None or not isinstance(record.exc_info[1], HttpProcessingError)


def own_names() -> frozenset[str]:
    """The host names under which browsers may address this machine; numeric addresses are always allowed."""
    name = socket.gethostname().lower()
    return frozenset({"localhost", name, f"{name}.local"})


def host_allowed(host: str, names: frozenset[str]) -> bool:
    """Whether a Host header names this machine; a foreign name is a sign of DNS rebinding.

    host: the header; names: of this machine.
    """
    name = (urlsplit(f"//{host}").hostname or "").lower()
    return name in names or _is_address(name)


def origin_allowed(origin: str | None, host: str) -> bool:
    """Whether a request comes from our own pages (same origin), or has no Origin (a program, not a page).

    origin, host: the headers.
    """
    if origin is None:
        return True
    parts = urlsplit(origin)
    return parts.scheme in ("http", "https") and parts.netloc.lower() == host.lower()


def refusal(host: str, origin: str | None, names: frozenset[str]) -> str | None:
    """Why a request is rejected, in one sentence; None when it is allowed.

    host, origin: the headers; names: of this machine.
    """
    try:
        if not host_allowed(host, names):
            return f"this server is not called {host[:80]!r}: use its address in figures, or localhost."
        if not origin_allowed(origin, host):
            return f"a page of {(origin or '')[:80]!r} may not play here: open the console from this server."
    except ValueError as error:  # urlsplit on things like "[::1"
        return f"the address of this request cannot be read ({error})."
    return None


def guard(names: frozenset[str]) -> Middleware:
    """Builds the middleware that rejects requests with a foreign Host or Origin."""

    @web.middleware
    async def middleware(request: web.Request, handler: Handler) -> web.StreamResponse:
        reason = refusal(request.headers.get("Host", ""), request.headers.get("Origin"), names)
        if reason is not None:
            raise web.HTTPForbidden(text=reason)
        return await handler(request)

    return middleware


def check_embedder(origin: str) -> str:
    """The origin of pages in which a stage may stand in a frame, as browsers write it: scheme, host, port where it is
    not the usual one. ValueError for what is none, and for more than one site."""
    wanted = "give it as in https://museum.example or http://127.0.0.1:3000"
    if not _ORIGIN.fullmatch(origin):
        raise ValueError(f"{origin[:80]!r} is no origin of a page; {wanted}, without a path and without *")
    try:
        parts = urlsplit(origin)
        asked = parts.port
    except ValueError as error:
        raise ValueError(f"{origin[:80]!r} is no origin of a page ({error}); {wanted}") from error
    if asked == 0:
        raise ValueError(f"the origin {origin[:80]!r} has no port that a browser opens; {wanted}")
    usual = {"http": 80, "https": 443}[parts.scheme.lower()]
    port = "" if asked in (None, usual) else f":{asked}"
    host = parts.hostname or ""
    return f"{parts.scheme.lower()}://{f'[{host}]' if ':' in host else host}{port}"


def adding_headers(
    embedders: Sequence[str] = (), tell: Callable[[str], None] = lambda _: None
) -> Callable[[web.Request, web.StreamResponse], Awaitable[None]]:
    """Builds what adds `HEADERS` to responses (an `on_response_prepare` signal). embedders: origins of pages that may
    show a stage in a frame, as `check_embedder` gives them; no other page of the show may stand in one. tell: takes a
    sentence about a page whose browser shows no stage in its frame, once for each site."""
    framed = HEADERS[POLICY].replace(ANCESTORS, " ".join((ANCESTORS, *embedders)))
    told = set[str]()

    def tell_once(origin: str) -> None:
        if origin and origin not in (*embedders, *told) and len(told) < MOST_TOLD:
            told.add(origin)
            tell(f"a page of {origin} shows no stage in its frame: --embed {origin} allows it")

    async def add_headers(request: web.Request, response: web.StreamResponse) -> None:
        if request.path.startswith(WASM_FOLDER):
            response.headers.setdefault(POLICY, f"{HEADERS[POLICY]}; script-src 'self' 'wasm-unsafe-eval'")
        elif request.path == STAGE_PAGE:
            response.headers.setdefault(POLICY, framed)
            tell_once(_find_embedder(request))
        for name, value in HEADERS.items():
            response.headers.setdefault(name, value)

    return add_headers


def _find_embedder(request: web.Request) -> str:
    """The origin of another site's page that opens this one in a frame, as far as its browser says so; else ""."""
    fetched = request.headers.get("Sec-Fetch-Dest"), request.headers.get("Sec-Fetch-Site")
    parts = request.headers.get("Referer", "").split("/")
    if fetched[0] not in ("iframe", "frame") or fetched[1] == "same-origin" or len(parts) < 3:
        return ""
    try:
        return check_embedder("/".join(parts[:3]))
    except ValueError:
        return ""


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
