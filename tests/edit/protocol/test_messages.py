"""Messages of the editors' link: one tag each, a number to answer to, and limits that fit its messages."""

import hashlib
import re

import msgspec
import pytest

from omote.edit.protocol import messages as wire
from omote.edit.protocol.validation import MOST_LAYERS, MOST_POINTS, MOST_PULLS
from omote.edit.protocol.wire import decode, encode
from omote.model.recipes.recipe import Layer, Pull
from omote.model.space.head_regions import REGIONS
from omote.show.validation import Refusal
from tools.messages import editing_module

WIRE = (10, "c39d3dc2eb49518a")
"""The version of the link, and a fingerprint of what its messages hold."""


def test_the_version_rises_with_every_change_of_the_messages() -> None:
    """A page that stays open over an upgrade would misread them: raise EDITING_VERSION, then write both down here."""
    bare = re.sub(r"/\*\*.*?\*/|EDITING_VERSION = \d+", "", editing_module(), flags=re.DOTALL)
    assert (wire.EDITING_VERSION, hashlib.sha256(bare.encode()).hexdigest()[:16]) == WIRE


def test_every_message_has_a_tag_of_its_own() -> None:
    tags = [kind.__struct_config__.tag for kind in (*wire.EDITOR_MESSAGES, *wire.ANSWERS)]
    assert len(set(tags)) == len(tags)


def test_every_request_has_a_number_to_answer_to() -> None:
    numbered = [kind for kind in wire.EDITOR_MESSAGES if "request" in kind.__struct_fields__]
    assert {*wire.EDITOR_MESSAGES} - {*numbered} == {wire.Greet}


def test_the_longest_requests_fit_the_link() -> None:
    vector = (-3.141592653589793, -0.123456789, 1.23456789)
    count = [10**9] * MOST_POINTS
    drag = wire.DragPoints(2**31, 2**31, "x" * 80, count, [vector] * MOST_POINTS, [vector] * MOST_POINTS)
    layers = [Layer("#" + "0" * 32, "x" * 80, 0.1, max(REGIONS, key=len), True)] * MOST_LAYERS
    pulls = [Pull("x" * 40, 0.5)] * MOST_PULLS
    for request in (drag, wire.SetLayers(1, 1, layers), wire.SetPulls(1, 1, pulls), wire.SetNet(1, 1, count)):
        data = encode(request)
        assert len(data) <= wire.EDITING_LIMIT
        assert decode(data) == request


@pytest.mark.parametrize(
    "request_",
    [
        wire.SetNet(1, 1, [0] * (MOST_POINTS + 1)),
        wire.SetPulls(1, 1, [Pull("smiler", 0.5)] * (MOST_PULLS + 1)),
        wire.SetLayers(1, 1, [Layer("smile", "Smile")] * (MOST_LAYERS + 1)),
        wire.Describe(1, 1, "", [], 0.0),
        wire.Save(1, 1, "x" * 201),
    ],
)
def test_messages_over_a_limit_are_refused(request_: wire.FromEditor) -> None:
    with pytest.raises(Refusal, match="cannot be read"):
        decode(msgspec.msgpack.encode(request_))
