"""The parts of clips: those of layers with their places as files have them, and the body behind."""

from __future__ import annotations

import pytest

from omote.perform.clips.clip_parts import BODY, CLIP_PARTS, PLACES, check_clip_part, place_of_part
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE


def test_layers_have_their_places_and_the_body_is_behind_the_whole_face() -> None:
    assert (*LAYER_PARTS, "body") == CLIP_PARTS
    assert [place_of_part(part) for part in CLIP_PARTS] == [*range(WHOLE), BODY]
    assert (WHOLE, BODY, PLACES) == (6, 7, 8)  # as show files have them
    with pytest.raises(ValueError, match="no part of a clip 'nose'"):
        check_clip_part("nose")
