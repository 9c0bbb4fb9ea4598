"""What an agent asks for that cannot be."""

import json
from typing import Any

import pytest

from omote.server.agents.show_tools import own_tools
from omote.server.agents.tool_server import open_tools
from tests.client.test_program_link import ticking
from tests.server.agents.test_tool_server import WISHES, said
from tests.server.conftest import ShowHarness

WRONG: dict[str, tuple[str, dict[str, Any], str]] = {
    "no face": ("call_face", {"character": "one", "name": "nobody"}, "there is no face 'nobody'"),
    "nobody": ("call_face", {"character": "ghost", "name": "broad"}, "ghost"),
    "text as time": ("call_face", {"character": "one", "name": "broad", "seconds": "long"}, "seconds"),
    "no name": ("call_face", {"character": "one"}, "needs name"),
    "no such argument": ("call_face", {"character": "one", "name": "broad", "speed": 1}, "no argument speed"),
    "no such tool": ("fly", {}, "there is no tool 'fly'"),
    "too long": ("wait", {"seconds": 1e9}, "the pause"),
    "out of range": ("set_head", {"character": "one", "yaw": 9.0, "pitch": 0.0, "roll": 0.0}, "yaw"),
}


@pytest.mark.asyncio
async def test_what_cannot_be_done_is_answered_with_a_sentence_and_changes_nothing(show_harness: ShowHarness) -> None:
    url = str(show_harness.client.make_url("/"))
    async with ticking(show_harness), open_tools(url, **WISHES) as tools:
        for tool, arguments, reason in WRONG.values():
            answer = await tools.call(tool, arguments)
            assert answer.is_error, tool
            assert reason in said(answer)
        assert json.loads(said(await tools.call("show_state", {})))["characters"]["one"]["faces"] == {"generic": 1.0}


def test_who_may_only_look_has_no_tool_that_changes_anything() -> None:
    looking = own_tools("view").values()
    assert all(tool.annotations is not None and tool.annotations.read_only_hint for tool in looking)
    assert own_tools("operate").keys() - own_tools("view").keys() == {"say"}
