"""Serves a running show to an agent by the Model Context Protocol, over this process's input and output."""

from __future__ import annotations

import asyncio
import importlib.metadata
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import aiohttp
import mcp_types
import msgspec
from mcp.server.lowlevel import Server
from mcp.server.stdio import stdio_server

from omote.client.connect import connect_async
from omote.client.show_address import base_address, check_token
from omote.client.trust import trusted_context
from omote.server.agents.show_tools import ShowTools
from omote.server.agents.stage_picture import StagePicture
from omote.show.access.access_documents import AccessDocument
from omote.show.objects.link import Bus

NAME = "agent"
"""What consoles call it where it moves something."""
INSTRUCTIONS = (
    "You play the faces of a running show. Call list_names first: faces, expressions, poses and lights are called by "
    "name. Each call takes seconds and begins from whatever is showing; nothing jumps. "
    "take_picture shows what the audience sees, show_state tells it in numbers; wait lets a call come to its end. "
    "Angles are radians, + is the character's own left. panic brings all faces to rest."
)


@asynccontextmanager
async def open_tools(
    url: str, *, token: str | None, authority: Path | None, bus: Bus, size: tuple[int, int]
) -> AsyncIterator[ShowTools]:
    """The tools of a running show, which end with the block.

    url: that `omote show` prints; token: of a show that asks for one, None for that of the address; authority: a
    certificate (.pem) to trust over https; bus: what it plays, air or preview; size: of pictures, pixels.
    Errors as of `omote.connect_async`.
    """
    address = base_address(url)
    key = check_token(token, url)
    headers = {"Authorization": f"Bearer {key}"} if key else {}
    trusted = trusted_context(authority) if address.startswith("https:") else True
    show = await connect_async(url, name=NAME, token=token, authority=authority, bus=bus)
    stage = StagePicture(address, key, size)
    try:
        async with aiohttp.ClientSession(
            headers=headers, connector=aiohttp.TCPConnector(ssl=trusted), raise_for_status=True
        ) as web:
            async with web.get(f"{address}/access") as answer:
                access = msgspec.msgpack.decode(await answer.read(), type=AccessDocument)
            yield ShowTools(show, web, address, access, stage)
    finally:
        await stage.close()
        await show.close()


def server_of(tools: ShowTools) -> Server[dict[str, object]]:
    """A server of the protocol for these tools. tools: of a show."""

    async def list_tools(_context: object, _page: object) -> mcp_types.ListToolsResult:
        return mcp_types.ListToolsResult(tools=tools.tools)

    async def call_tool(_context: object, wanted: mcp_types.CallToolRequestParams) -> mcp_types.CallToolResult:
        return await tools.call(wanted.name, wanted.arguments or {})

    version = importlib.metadata.version("omote")
    return Server(
        "omote", version=version, instructions=INSTRUCTIONS, on_list_tools=list_tools, on_call_tool=call_tool
    )  # fmt: skip


def serve(url: str, *, token: str | None, authority: Path | None, bus: Bus, size: tuple[int, int]) -> None:
    """Serves a show to the agent at this process's input and output, until that ends. url, token, authority, bus, size:
    as of `open_tools`."""
    asyncio.run(_serve(url, token, authority, bus, size))


async def _serve(url: str, token: str | None, authority: Path | None, bus: Bus, size: tuple[int, int]) -> None:
    async with open_tools(url, token=token, authority=authority, bus=bus, size=size) as tools:
        server = server_of(tools)
        async with stdio_server() as (told, answers):
            await server.run(told, answers, server.create_initialization_options())
