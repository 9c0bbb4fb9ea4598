"""An agent at a real show: the command, a client of the protocol's package, and pictures of the stage."""

import asyncio
import base64
import json
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from mcp import ClientSession, StdioServerParameters, stdio_client
from mcp_types import ImageContent, TextContent

from omote.interchange.formats.png import read_png

PROGRAM = "from omote.cli import main; main()"
SIZE = (240, 240)


def test_an_agent_plays_a_scene_and_sees_the_face_change(show: str) -> None:
    with ThreadPoolExecutor(1) as thread:  # after a page of Playwright no asyncio.run works in this one
        thread.submit(lambda: asyncio.run(play_scene(show))).result()


async def play_scene(show: str) -> None:
    options = ["--show", show, "--width", str(SIZE[0]), "--height", str(SIZE[1])]
    command = StdioServerParameters(command=sys.executable, args=["-c", PROGRAM, "mcp", *options])
    async with stdio_client(command) as (answers, told), ClientSession(answers, told) as agent:
        await agent.initialize()

        async def picture() -> np.ndarray:
            (content,) = (await agent.call_tool("take_picture", {})).content
            assert isinstance(content, ImageContent)
            return read_png(base64.b64decode(content.data)).astype(np.int16)

        async def state() -> dict[str, float]:
            (content,) = (await agent.call_tool("show_state", {})).content
            assert isinstance(content, TextContent)
            return dict(next(iter(json.loads(content.text)["characters"].values()))["faces"])

        await agent.call_tool("call_face", {"character": "*", "name": "kaori", "seconds": 0})
        await agent.call_tool("wait", {"seconds": 1})
        kaori = await picture()
        assert kaori.shape[:2] == SIZE[::-1]
        await agent.call_tool("call_face", {"character": "*", "name": "dog", "seconds": 0})
        assert await state() == {"dog": 1.0}
        for _ in range(20):  # the stage fetches the dog first
            dog = await picture()
            if np.abs(dog - kaori).mean() > 5.0:
                break
            await agent.call_tool("wait", {"seconds": 0.5})
        assert np.abs(dog - kaori).mean() > 5.0
