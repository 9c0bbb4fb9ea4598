"""The tools that an agent has in a running show: its commands, and what shows, what there is, a picture, a pause."""

from __future__ import annotations

import asyncio
import base64
from collections.abc import Awaitable, Callable, Mapping
from typing import Any

import aiohttp
import mcp_types
import msgspec

from omote.client.connect import AsyncConnectedShow
from omote.perform.figures.pose_mix import IDLE_POSES
from omote.perform.limits import check_within
from omote.server.agents.command_tools import CommandTool, command_tools
from omote.server.agents.stage_picture import StagePicture
from omote.server.headless.devtools import BrowserError
from omote.show.access.access_documents import AccessDocument
from omote.show.access.access_role import AccessRole, role_allows
from omote.show.cast_documents import Manifest
from omote.show.declaration import CharacterCommand

LONGEST_WAIT = 60.0
"""Seconds."""
Content = mcp_types.TextContent | mcp_types.ImageContent
NOTHING: Mapping[str, Any] = {"type": "object", "properties": {}, "additionalProperties": False}
TEXT = {"type": "string", "minLength": 1}


class ShowTools:
    """What an agent can do in a show, limited by the role of its token."""

    def __init__(
        self,
        show: AsyncConnectedShow,
        web: aiohttp.ClientSession,
        address: str,
        access: AccessDocument,
        stage: StagePicture,
    ) -> None:
        """show: connected; web: that carries the token; address: of the show, without a page; access: who the token is;
        stage: what pictures are taken of."""
        self._show = show
        self._web = web
        self._address = address
        self._stage = stage
        self._commands = command_tools(access.role)
        self._own = own_tools(access.role)
        self._own_calls: Mapping[str, Callable[..., Awaitable[list[Content]]]] = {
            "show_state": self._state,
            "list_names": self._names,
            "take_picture": self._picture,
            "wait": self._wait,
            "say": self._say,
        }

    @property
    def tools(self) -> list[mcp_types.Tool]:
        """All that this role may use, for a client that lists them."""
        return [*self._own.values(), *map(_listed, self._commands.values())]

    async def call(self, name: str, arguments: Mapping[str, Any]) -> mcp_types.CallToolResult:
        """Uses a tool; what cannot be done is an answer too, with the show's own sentence.

        name: of the tool; arguments: as its schema has them.
        """
        if name not in self._own and name not in self._commands:
            return _failed(f"there is no tool {name!r:.80} for this token; list the tools")
        try:
            if name in self._own:
                return mcp_types.CallToolResult(content=list(await self._own_calls[name](**arguments)))
            await self._send(self._commands[name], arguments)
        except (ValueError, TypeError, OSError, aiohttp.ClientError, BrowserError) as error:
            return _failed(str(error))
        return mcp_types.CallToolResult(content=[_text("done")])

    async def _send(self, tool: CommandTool, arguments: Mapping[str, Any]) -> None:
        unknown = arguments.keys() - tool.schema["properties"].keys()
        lacking = set(tool.schema["required"]) - arguments.keys()
        if unknown or lacking:
            raise ValueError(_misfit(tool, unknown, lacking))
        if issubclass(tool.command, CharacterCommand):
            of = self._show.find_character(arguments["character"])
            rest = {name: value for name, value in arguments.items() if name != "character"}
            await self._show[of].build(tool.command, rest)
        else:
            await self._show.build(tool.command, arguments)

    async def _state(self) -> list[Content]:
        return [_text(msgspec.json.encode(self._show.state).decode())]

    async def _names(self) -> list[Content]:
        async with self._web.get(f"{self._address}/manifest") as answer:
            answer.raise_for_status()
            manifest = msgspec.msgpack.decode(await answer.read(), type=Manifest)
        return [_text(msgspec.json.encode(names_in(manifest, self._show.characters)).decode())]

    async def _picture(self) -> list[Content]:
        data = base64.b64encode(await self._stage.take()).decode()
        return [mcp_types.ImageContent(type="image", data=data, mime_type="image/png")]

    async def _wait(self, seconds: float) -> list[Content]:
        await asyncio.sleep(check_within(seconds, 0.0, LONGEST_WAIT, "the pause (seconds)"))
        return [_text("done")]

    async def _say(self, character: str, text: str, voice: str = "", language: str = "en") -> list[Content]:
        await self._show[self._show.find_character(character)].say(text, voice=voice, language=language)
        return [_text("done")]


def own_tools(role: AccessRole) -> dict[str, mcp_types.Tool]:
    """The tools that are no commands, by name. role: of the token."""
    seconds = {"type": "number", "minimum": 0.0, "maximum": LONGEST_WAIT, "description": "Seconds."}
    spoken = {
        "character": {**TEXT, "description": "Its name or its label, * for all."},
        "text": TEXT,
        "voice": {"type": "string", "description": "A voice of the show that is heard; without one lips alone move."},
        "language": {"type": "string", "description": "Of the text, as in en, de, ja."},
    }
    tools = [
        _own("show_state", "All that is on air now: characters with the weights of their faces, expressions, poses and "
             "channels, head and gaze, what is said, light, framing, cues.", NOTHING),
        _own("list_names", "What can be called: characters, faces, expressions (with labels), poses, bodies, lights.",
             NOTHING),
        _own("take_picture", "A picture of what the audience sees now.", NOTHING),
        _own("wait", "Waits, so that what was called can be seen before the next call.",
             {"type": "object", "properties": {"seconds": seconds}, "required": ["seconds"]}),
    ]  # fmt: skip
    if role_allows(role, "operate"):
        schema = {"type": "object", "properties": spoken, "required": ["character", "text"]}
        tools.append(_own("say", "Has a character speak: its lips move, and a stage plays the voice.", schema, False))
    return {tool.name: tool for tool in tools}


def names_in(manifest: Manifest, characters: tuple[str, ...]) -> dict[str, Any]:
    """What can be called, by kind. manifest: of the show's cast; characters: of its scene."""
    figures = manifest.figures
    poses = [] if figures is None else figures.poses
    return {
        "character": list(characters),
        "face": {face.name: face.label for face in manifest.faces},
        "expression": {expression.name: expression.label for expression in manifest.expressions},
        "light": [light.name for light in manifest.lights],
        "pose": {pose.name: pose.label for pose in poses if pose.name not in IDLE_POSES},
        "body": [] if figures is None else [body.name for body in figures.bodies],
    }


def _own(name: str, description: str, schema: Mapping[str, Any], reads: bool = True) -> mcp_types.Tool:
    hints = mcp_types.ToolAnnotations(read_only_hint=reads, destructive_hint=False)
    return mcp_types.Tool(name=name, description=description, input_schema=dict(schema), annotations=hints)


def _listed(tool: CommandTool) -> mcp_types.Tool:
    return mcp_types.Tool(name=tool.name, description=tool.description, input_schema=dict(tool.schema))


def _misfit(tool: CommandTool, unknown: set[str], lacking: set[str]) -> str:
    wrong = [f"no argument {', '.join(sorted(unknown))}"] if unknown else []
    missing = [f"needs {', '.join(sorted(lacking))}"] if lacking else []
    return f"{tool.name} has {' and '.join([*wrong, *missing])}; it takes {', '.join(tool.schema['properties'])}"


def _text(text: str) -> mcp_types.TextContent:
    return mcp_types.TextContent(type="text", text=text)


def _failed(reason: str) -> mcp_types.CallToolResult:
    return mcp_types.CallToolResult(content=[_text(reason)], is_error=True)
