"""What tools/messages.py writes for the web is never stale."""

import runpy
from pathlib import Path

import pytest

from omote.edit.protocol.messages import ANSWERS, EDITOR_MESSAGES

ROOT = Path(__file__).parents[2]
TOOL = ROOT / "tools" / "messages.py"


@pytest.mark.parametrize("name", ["messages.ts", "editing_messages.ts", "constants.ts"])
def test_the_committed_mirrors_are_what_the_tool_writes(name: str) -> None:
    written = runpy.run_path(str(TOOL))["MODULES"][name]()
    mirror = (ROOT / "web" / "src" / "link" / name).read_text()
    assert mirror == written, f"web/src/link/{name} is stale: run `python tools/messages.py`"


def test_the_mirror_has_every_message_with_its_tag() -> None:
    mirror = (ROOT / "web" / "src" / "link" / "messages.ts").read_text()
    for tag in ("hello", "call_face", "call_expression", "set_gaze", "panic", "drawing", "welcome", "state", "crew"):
        assert f'type: "{tag}"' in mirror


def test_the_mirror_of_the_editors_link_has_recipes_and_every_message_with_its_tag() -> None:
    mirror = (ROOT / "web" / "src" / "link" / "editing_messages.ts").read_text()
    for tag in [message.__struct_config__.tag for message in (*EDITOR_MESSAGES, *ANSWERS)]:
        assert f'type: "{tag}"' in mirror
    assert all(f"export type {name} =" in mirror for name in ("Recipe", "FaceRecipe", "Layer", "Pull"))


def test_what_a_page_sends_leaves_out_what_has_a_default() -> None:
    tool = runpy.run_path(str(TOOL))
    by_name = {struct.__name__: struct for struct in tool["STRUCTS"]}
    lease = tool["interface"](by_name["Lease"], sent=True)
    assert "take_over?: boolean" in lease
    assert " id: string;" in lease
    assert "manager: boolean;" in tool["interface"](by_name["SeatState"])


@pytest.mark.parametrize(
    ("annotation", "written"),
    [
        (tuple[int, float], "[number, number]"),
        (tuple[int, ...], "number[]"),
        (list[tuple[float, float]], "[number, number][]"),
        (list[str | None], "(string | null)[]"),
        (dict[str, tuple[int, ...]], "Record<string, number[]>"),
    ],
)
def test_a_tuple_of_any_length_is_an_array(annotation: object, written: str) -> None:
    assert runpy.run_path(str(TOOL))["type_script"](annotation) == written


def test_a_type_the_wire_does_not_know_is_refused() -> None:
    type_script = runpy.run_path(str(TOOL))["type_script"]
    with pytest.raises(TypeError, match="no TypeScript for"):
        type_script(set[int])
