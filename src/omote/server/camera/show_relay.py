"""Passes the link of a camera page on to a show elsewhere, and says why where that is not possible."""

from __future__ import annotations

import asyncio
import errno
import ssl
from dataclasses import dataclass

import aiohttp
from aiohttp import WSMsgType, web

from omote.client.show_address import NO_ANSWER, explain_https_error
from omote.inputs.performers.camera_messages import CAMERA_PATH, LONGEST_MESSAGE, CameraRefused
from omote.interchange.formats.error_reasons import explain_error
from omote.server.links.links import HEARTBEAT, LinkSocket
from omote.show.access.access_documents import REVOKED_CODE
from omote.show.wire import encode

CONNECT_SECONDS = 5.0
DENIALS = {
    401: "it asks for a token, and has got none that is valid: give --token, as omote access prints it there",
    403: "this token does not allow it: ask there for one with the role operate",
    404: "it has no camera link: it is an older Omote, or another program; update it there",
    429: "too many wrong tokens came from this machine: wait a minute",
}
"""What a show means that does not let a camera in."""


@dataclass(frozen=True)
class ShowTarget:
    """A show elsewhere. address: without a path; token: "" for none; trusted: what https trusts, None for http."""

    address: str
    token: str = ""
    trusted: ssl.SSLContext | None = None


class ShowRelay:
    """Passes links on to one show."""

    def __init__(self, target: ShowTarget) -> None:
        self.target = target

    async def respond(self, request: web.Request) -> web.WebSocketResponse:
        """Hears one page until it or the show closes."""
        page = LinkSocket(heartbeat=HEARTBEAT, limit=LONGEST_MESSAGE, refusal=_refusal)
        if await page.accept(request) is None:
            return page
        async with aiohttp.ClientSession() as session:
            try:
                show = await self._connect(session)
            except ConnectionError as error:
                await page.send_bytes(_refusal(str(error)))
                await page.close(message=b"no show")
                return page
            async with show:
                await _join(page, show)
        await page.close(code=show.close_code if show.close_code == REVOKED_CODE else 1000)
        return page

    async def reach(self) -> None:
        """Connects once; ConnectionError with the reason where the show cannot be reached or refuses."""
        async with aiohttp.ClientSession() as session, await self._connect(session):
            pass

    async def _connect(self, session: aiohttp.ClientSession) -> aiohttp.ClientWebSocketResponse:
        target = self.target
        headers = {"Authorization": f"Bearer {target.token}"} if target.token else {}
        trusted = True if target.trusted is None else target.trusted
        try:
            async with asyncio.timeout(CONNECT_SECONDS):
                return await session.ws_connect(
                    target.address + CAMERA_PATH, headers=headers, ssl=trusted, heartbeat=HEARTBEAT, compress=0
                )
        except aiohttp.WSServerHandshakeError as error:
            reason = DENIALS.get(error.status, f"it answers with status {error.status}")
        except aiohttp.ClientSSLError as error:
            reason = explain_https_error(error, target.address).replace("authority=", "--authority")
        except aiohttp.ServerDisconnectedError:
            reason = NO_ANSWER if target.address.startswith("http:") else "it ends the connection"
        except TimeoutError:
            reason = f"nothing answers within {CONNECT_SECONDS:g} s: look at the address and at firewalls"
        except (aiohttp.ClientError, OSError) as error:
            reason = _explain_absence(error)
        raise ConnectionError(f"the show at {target.address} cannot be reached: {reason}")


def _explain_absence(error: aiohttp.ClientError | OSError) -> str:
    """Why no connection came about, as a clause."""
    if isinstance(error, aiohttp.ClientConnectorDNSError):
        return f"no address of {error.host[:60]} is known: type the one that the show prints"
    cause = error.os_error if isinstance(error, aiohttp.ClientConnectorError) else error
    if isinstance(cause, ConnectionRefusedError) or getattr(cause, "errno", 0) == errno.ECONNREFUSED:
        return "nothing listens there: look at the address, and start the show with --host 0.0.0.0"
    return f"{explain_error(cause)[:200]}; look at the address and at firewalls"


def _refusal(reason: str) -> bytes:
    return encode(CameraRefused(reason))


async def _join(page: web.WebSocketResponse, show: aiohttp.ClientWebSocketResponse) -> None:
    """Passes on both ways until one side closes."""

    async def pass_on() -> None:
        async for message in page:
            if message.type is WSMsgType.BINARY:
                await show.send_bytes(message.data)

    async def pass_back() -> None:
        async for message in show:
            if message.type is WSMsgType.BINARY:
                await page.send_bytes(message.data)

    ways = {asyncio.create_task(pass_on()), asyncio.create_task(pass_back())}
    _, others = await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
    for way in others:
        way.cancel()
    await asyncio.gather(*ways, return_exceptions=True)
