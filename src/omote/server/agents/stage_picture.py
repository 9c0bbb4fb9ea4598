"""What a stage of a running show shows, as pictures: a stage page of its own in a browser without a window."""

from __future__ import annotations

import base64
from contextlib import AsyncExitStack
from urllib.parse import urlencode

from omote.server.headless.chromium import find_chromium, open_chromium
from omote.server.headless.devtools import DevTools
from omote.server.headless.picture_renderer import OPENED, open_stage

QUALITY = "medium"
"""Level of the stage's quality: what an agent looks at is small, and a machine that plays has other work."""


class StagePicture:
    """A stage page of a show, opened with the first picture and kept open for the next ones."""

    def __init__(self, address: str, token: str, size: tuple[int, int]) -> None:
        """address: of the show, without a page; token: "" where it asks for none; size: width and height, pixels."""
        self._address = address
        self._token = token
        self._size = size
        self._open = AsyncExitStack()
        self._page: tuple[DevTools, str] | None = None

    async def take(self) -> bytes:
        """The bytes of a PNG of what is on air now.

        FileNotFoundError where there is no Chromium; BrowserError where it does not show the stage.
        """
        if self._page is None:
            self._page = await self._open_page()
        tools, session = self._page
        answer = await tools.call("Page.captureScreenshot", session=session, format="png")
        return base64.b64decode(answer["data"])

    async def close(self) -> None:
        """Ends the browser; nothing where none was started."""
        await self._open.aclose()
        self._page = None

    async def _open_page(self) -> tuple[DevTools, str]:
        tools = await self._open.enter_async_context(open_chromium(find_chromium()))
        words = {"quality": QUALITY} | ({"token": self._token} if self._token else {})
        url = f"{self._address}/stage?{urlencode(words)}"
        trusted = self._address.startswith("https:")  # the link has found out already that it is this show
        _, session = await open_stage(tools, url, self._size, OPENED, trusted=trusted)
        return tools, session
