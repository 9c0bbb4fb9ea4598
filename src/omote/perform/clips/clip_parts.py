"""The parts that a clip can give: those of the layers, and the body."""

from __future__ import annotations

from typing import Literal, get_args

from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE
from omote.perform.limits import check_known

ClipPart = Literal["brows", "eyes", "mouth", "rest", "head", "gaze", "body"]
CLIP_PARTS: tuple[ClipPart, ...] = get_args(ClipPart)
"""The parts of the layers, then the bones of a figure with where its hips and feet are."""
BODY = WHOLE + 1
"""The place of the body among shares: behind that of the whole face, which clips in show files have by its number."""
PLACES = BODY + 1
"""Of shares: one for each of `LAYER_PARTS`, that of what acts on the whole face (the mean of its regions), and the
body's."""


def check_clip_part(name: object) -> ClipPart:
    """The part of this name; ValueError where there is none."""
    return check_known(name, CLIP_PARTS, "part of a clip")


def place_of_part(part: ClipPart) -> int:
    """The place of a part among shares."""
    return BODY if part == "body" else LAYER_PARTS.index(part)
