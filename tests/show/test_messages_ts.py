"""The TypeScript mirror of the messages is never stale."""

import runpy
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TOOL = ROOT / "tools" / "messages.py"


def test_the_committed_mirror_is_what_the_tool_writes() -> None:
    written = runpy.run_path(str(TOOL))["module"]()
    mirror = (ROOT / "web" / "src" / "link" / "messages.ts").read_text()
    assert mirror == written, "web/src/link/messages.ts is stale: run `python tools/messages.py`"


def test_the_mirror_has_every_message_with_its_tag() -> None:
    mirror = (ROOT / "web" / "src" / "link" / "messages.ts").read_text()
    for tag in ("hello", "call_face", "call_expression", "set_gaze", "panic", "drawing", "welcome", "state", "crew"):
        assert f'type: "{tag}";' in mirror


def test_a_type_the_wire_does_not_know_is_refused() -> None:
    type_script = runpy.run_path(str(TOOL))["type_script"]
    with pytest.raises(TypeError, match="no TypeScript for"):
        type_script(set[int])
