"""Targets: whatever an address of OSC takes, and nothing else."""

import pytest

from omote.inputs.bindings.target import read_target
from omote.inputs.osc_addresses import ADDRESSES


def test_every_address_is_a_target() -> None:
    for address in ADDRESSES:
        path = address.pattern.replace("{character}", "one").replace("{name}", "jawOpen").replace("{language}", "de")
        kinds = [value.kind for value in address.values[address.path.count("{") :] if value.default is None]
        numbers = [value.name for value in address.values if value.kind == "number" and value.default is None]
        axis = numbers[-1] if len(numbers) > 1 else None
        named = {
            "face",
            "expression",
            "light",
            "framing",
            "text",
            "character",
            "speech",
            "gesture",
            "cue",
            "pose",
            "body",
            "shot",
        } & set(kinds)
        arguments = ["dog"] if named and not numbers else []
        target = read_target(path, arguments, axis)
        assert target.is_level == bool({"number", "switch"} & set(kinds))
        assert target.path == path


def test_a_channel_has_the_range_of_a_fader_and_others_their_own() -> None:
    assert read_target("/omote/one/channel/jawOpen").usual_range == (0.0, 1.0)
    assert read_target("/omote/one/gaze", axis="yaw").usual_range == pytest.approx((-40.0, 40.0))


def test_a_bank_is_a_target() -> None:
    assert read_target("bank:B").bank == "B"
    assert read_target("/omote/panic").bank is None


@pytest.mark.parametrize(
    ("path", "arguments", "axis", "why"),
    [
        ("/omote/one/nose", [], None, "there is no address"),
        ("/omote/one/face", [], None, "takes name, seconds"),
        ("/omote/one/face", ["dog", 1.0, 2.0], None, "takes name, seconds"),
        ("/omote/one/face", ["dog"], "yaw", "no axis"),
        ("/omote/panic", [1.0], None, "takes nothing"),
        ("/omote/one/head", [], None, "one axis of yaw, pitch, roll"),
        ("/omote/one/head", [], "up", "one axis of yaw, pitch, roll"),
        ("/omote/one/channel/jawOpen", [1.0], None, "no arguments"),
    ],
)
def test_what_is_no_target_is_said(path: str, arguments: list[str | float], axis: str | None, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_target(path, arguments, axis)
