"""The middleware that knows who sends each request, and lets through what their role allows."""

from __future__ import annotations

import math
from collections.abc import Callable
from http import HTTPStatus

from aiohttp import hdrs, web
from aiohttp.typedefs import Handler, Middleware

from omote.server.access.access_control import DENIALS, TOKEN, AccessControl, DeniedError
from omote.server.access.token_page import ask_for_token, leave_address
from omote.show.access.access_role import explain_missing_role, role_allows
from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.access.route_roles import OSCQUERY_ROUTES, role_for_route
from omote.show.objects.documents import READ_ROUTES

VISITOR = web.RequestKey("visitor", Visitor)
DENIED = "denied"
SURFACE = Visitor("view", "OSC")
COOKIE_SECONDS = 366 * 24 * 3600


def guard_access(
    control: Callable[[], AccessControl | None], pages: frozenset[str], surface_allowed: Callable[[str], bool]
) -> Middleware:
    """Builds the middleware. control: gives None where everybody who reaches the show may play it; pages: the addresses
    whose token leaves the address bar; surface_allowed: whether a host may play by OSC, which knows no token, and so
    may read which addresses of OSC there are."""

    @web.middleware
    async def middleware(request: web.Request, handler: Handler) -> web.StreamResponse:
        asked = control()
        if asked is None or (_asks_for_tree(request) and surface_allowed(request.remote or "")):
            request[VISITOR] = ANYBODY if asked is None else SURFACE
            return await handler(request)
        try:
            if TOKEN not in request.query and (denial := _earlier_denial(request)) is not None:
                raise denial
            visitor, presented = asked.find_visitor(request)
            _check_route(request, visitor)
        except DeniedError as denied:
            return _deny(request, denied)
        request[VISITOR] = visitor
        if presented.carrier == "query" and request.path in pages and _wants_page(request):
            return _keep_token(request, asked.cookie, presented.token)
        return await handler(request)

    return middleware


def visitor_in(request: web.Request) -> Visitor:
    """Who sends a request that was let through."""
    return request[VISITOR]


def _check_route(request: web.Request, visitor: Visitor) -> None:
    resource = request.match_info.route.resource
    route = None if resource is None else resource.canonical
    needed = READ_ROUTES.get(route or "") or role_for_route(request.method, route)
    if not role_allows(visitor.role, needed):
        raise DeniedError(HTTPStatus.FORBIDDEN, explain_missing_role(visitor.role, needed))


def _asks_for_tree(request: web.Request) -> bool:
    resource = request.match_info.route.resource
    return resource is not None and resource.canonical in OSCQUERY_ROUTES and not _wants_page(request)


def _deny(request: web.Request, denied: DeniedError) -> web.Response:
    """Says why, to people as a page that asks for a token, at an address without the one that was not taken."""
    if _wants_page(request):
        rest = request.rel_url.without_query_params(TOKEN, DENIED)
        denial = next((name for name, reason in DENIALS.items() if reason == (denied.status, denied.sentence)), None)
        if TOKEN in request.query and denial is not None:
            return leave_address(str(rest.update_query({DENIED: denial})), denied.status)
        return ask_for_token(denied.sentence, denied.status, rest.query.items())
    headers = {"WWW-Authenticate": "Bearer"} if denied.status == HTTPStatus.UNAUTHORIZED else {}
    headers |= {"Retry-After": f"{math.ceil(denied.wait)}"} if denied.wait else {}
    return web.Response(text=denied.sentence, status=denied.status, headers=headers | {"Cache-Control": "no-store"})


def _keep_token(request: web.Request, cookie: str, token: str) -> web.Response:
    response = leave_address(str(request.rel_url.without_query_params(TOKEN, DENIED)))
    response.set_cookie(cookie, token, max_age=COOKIE_SECONDS, httponly=True, samesite="Strict", secure=request.secure)
    return response


def _earlier_denial(request: web.Request) -> DeniedError | None:
    """Why the token was not taken with which a page was opened just before."""
    reason = DENIALS.get(request.query.get(DENIED, "")) if _wants_page(request) else None
    return None if reason is None else DeniedError(*reason)


def _wants_page(request: web.Request) -> bool:
    return request.method == "GET" and "text/html" in request.headers.get(hdrs.ACCEPT, "")
