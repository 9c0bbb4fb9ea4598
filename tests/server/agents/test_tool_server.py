"""An agent plays a show: a client of the protocol's own package, at a real show."""

import json
from pathlib import Path
from typing import Any

import pytest
from mcp import Client
from mcp_types import CallToolResult, TextContent

from omote.server.access.access_control import AccessControl
from omote.server.access.people_file import open_people
from omote.server.agents.command_tools import command_tools
from omote.server.agents.tool_server import open_tools, server_of
from omote.show.access.people_list import token_of
from tests.client.test_program_link import ticking
from tests.server.conftest import ShowHarness

WISHES: dict[str, Any] = {"token": None, "authority": None, "bus": "air", "size": (320, 180)}


def said(answer: CallToolResult) -> str:
    (content,) = answer.content
    assert isinstance(content, TextContent)
    return content.text


@pytest.mark.asyncio
async def test_an_agent_plays_a_scene_and_reads_what_shows(show_harness: ShowHarness) -> None:
    url = str(show_harness.client.make_url("/"))
    async with ticking(show_harness), open_tools(url, **WISHES) as tools, Client(server_of(tools)) as agent:
        listed = {tool.name for tool in (await agent.list_tools()).tools}
        assert listed == {*command_tools("admin"), "show_state", "list_names", "take_picture", "wait", "say"}
        names = json.loads(said(await agent.call_tool("list_names", {})))
        assert "broad" in names["face"]
        done = [
            await agent.call_tool("call_face", {"character": "one", "name": "broad", "seconds": 0}),
            await agent.call_tool("call_expression", {"character": "*", "name": "smile", "seconds": 0}),
            await agent.call_tool("set_head", {"character": "one", "yaw": 0.2, "pitch": 0.0, "roll": 0.0}),
            await agent.call_tool("say", {"character": "one", "text": "Good evening."}),
            await agent.call_tool("wait", {"seconds": 0.05}),
        ]
        assert [said(answer) for answer in done] == ["done"] * 5
        shown = json.loads(said(await agent.call_tool("show_state", {})))["characters"]["one"]
        assert (shown["faces"], shown["expressions"]) == ({"broad": 1.0}, {"smile": 1.0})
        assert shown["head"][0] == pytest.approx(0.2)
        assert show_harness.show.session.scene["one"].snapshot().said == 1


@pytest.mark.asyncio
async def test_an_agent_has_the_tools_of_its_token(show_harness: ShowHarness, tmp_path: Path) -> None:
    control = AccessControl(tmp_path / "a.people", people := open_people(tmp_path / "a.people"))
    show_harness.show.enable_access(control)
    url = str(show_harness.client.make_url("/"))
    wishes = {**WISHES, "token": token_of(people, people.people[0])}
    async with ticking(show_harness), open_tools(url, **wishes) as tools, Client(server_of(tools)) as agent:
        listed = {tool.name for tool in (await agent.list_tools()).tools}
        assert listed == {"show_state", "list_names", "take_picture", "wait"}
        answer = await agent.call_tool("panic", {"character": "*"})
        assert answer.is_error
        assert "list the tools" in said(answer)
        assert json.loads(said(await agent.call_tool("list_names", {})))["character"] == ["one"]
