"""The page that a phone opens to copy what to type into a tracker's app, and the pictures (QR codes) that open it.

No app of a tracker reads an address and a port from such a picture, so it opens a page where both are copied.
"""

from __future__ import annotations

import html
from collections.abc import Callable, Collection
from http import HTTPStatus

from aiohttp import web

from omote.server.access.access_control import AccessControl
from omote.server.access.qr_code import draw_svg
from omote.server.access.show_addresses import own_address, url
from omote.server.access.token_page import show_page
from omote.show.access.access_role import AccessRole
from omote.show.access.people_list import People, token_of
from omote.show.objects.devices import Devices, TrackerOffer

PHONE_PATH = "/connect"
CODE_PATH = "/connect/{page}.svg"
GOALS: dict[str, tuple[str, AccessRole]] = {
    "phone": (PHONE_PATH, "view"), "camera": ("/camera", "operate"), "microphone": ("/microphone", "operate"),
}  # fmt: skip
"""What a picture opens, and the role that its page needs."""
SENSORS = {"/camera": "Use this phone's camera", "/microphone": "Use this phone's microphone"}
INSECURE = (
    "Phones give camera and microphone to https pages alone: start the show with <code>--https</code>, and open its "
    "<code>/certificate</code> here once."
)
ELSEWHERE = (
    "This show's pages are open to its own machine alone. Trackers reach it all the same, by the address and the port "
    "that stand here; with <code>omote show --host 0.0.0.0</code> a phone opens this page, too."
)


class PhonePage:
    """Answers phones. describe: what is switched on; control: who may enter, None where only this machine may; pages:
    the addresses of all pages."""

    def __init__(
        self, describe: Callable[[], Devices], control: Callable[[], AccessControl | None], pages: Collection[str]
    ) -> None:
        self._describe = describe
        self._control = control
        self._pages = pages

    def add_routes(self, application: web.Application) -> None:
        """Adds the addresses."""
        application.router.add_get(PHONE_PATH, self.page)
        application.router.add_get(CODE_PATH, self.code)

    async def page(self, request: web.Request) -> web.Response:
        """Responds with what to type into each app."""
        heard = [tracker for tracker in self._describe().trackers if tracker.word]
        host = own_address() or (request.url.host or "")
        said = "".join(_section(tracker, host) for tracker in heard) or _nothing_heard()
        links = "".join(
            f'<p><a href="{path}">{words}</a></p>' for path, words in SENSORS.items() if path in self._pages
        )
        notes = (f"<small>{INSECURE}</small>" if links and not request.secure else "") + (
            f"<small>{ELSEWHERE}</small>" if self._control() is None else ""
        )
        return show_page(f"<h1>What to type into the app</h1>{said}{links}{notes}", HTTPStatus.OK)

    async def code(self, request: web.Request) -> web.Response:
        """Responds with the picture that opens a page on a phone; where no phone may open it, that says this machine's
        address."""
        goal = request.match_info["page"]
        if goal not in GOALS or (goal != "phone" and GOALS[goal][0] not in self._pages):
            raise web.HTTPNotFound(text="there is no such picture; there is phone.")
        control = self._control()
        host = own_address()
        if control is None or host is None:
            return _picture(host or "127.0.0.1")
        path, role = GOALS[goal]
        return _picture(goal_address(url(host, request.url.port or 80, request.scheme), path, role, control.people))


def goal_address(base: str, path: str, role: AccessRole, people: People) -> str:
    """The address by which a phone opens a page, with the token that all of a role share.

    base: of the show; path: of the page; people: the list that has the token.
    """
    shared = [person for person in people.people if person.name == person.role == role]
    return f"{base}{path}?token={token_of(people, shared[0])}" if shared else f"{base}{path}"


def _picture(text: str) -> web.Response:
    headers = {"Cache-Control": "no-store"}  # it may hold a token
    return web.Response(body=draw_svg(text), content_type="image/svg+xml", headers=headers)


def _section(tracker: TrackerOffer, host: str) -> str:
    """What to type into one app: its address and port each where a tap takes all of it."""
    advice = html.escape(tracker.advice[:1].upper() + tracker.advice[1:])
    fields = [("address", host)] + ([] if tracker.port is None else [("port", str(tracker.port))])
    typed = "".join(
        f'<label>{name}<input readonly inputmode="none" value="{html.escape(value)}"></label>' for name, value in fields
    )
    return f"<section><h2>{html.escape(tracker.title)}</h2><p>{advice}.</p>{typed}</section>"


def _nothing_heard() -> str:
    return (
        "<p>No tracker is switched on. Switch one on at the page <b>Devices</b> of the show, or with "
        "<code>omote show --listen livelink</code>, and open this page again.</p>"
    )
