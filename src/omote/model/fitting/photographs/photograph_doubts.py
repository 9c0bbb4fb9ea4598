"""What photographs do not say of a face, in sentences."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from omote.model.fitting.photographs.bundle_problem import Bundle
from omote.model.fitting.photographs.photograph import Photograph

TURNED = np.radians(25.0)
"""From so far on a head shows its profile, and its other cheek no more."""
STRANGE, LARGE, DIFFERENT, FOLDS = 2.0, 0.015, 0.5, 5
SIDES = {"front": 0.0, "left": -1.0, "right": 1.0}
"""Of a photograph that was said to show a side of the head, the sign of the turn that shows it."""


def find_photograph_doubts(
    photographs: Sequence[Photograph], found: Bundle, residual: Sequence[float], spread: float, folds: int, /
) -> tuple[str, ...]:  # fmt: skip
    """Sentences on a fit, none where it is sure.

    residual: pixels of each photograph; spread: millimetres; folds: how many triangles are folded.
    """
    yaws = [camera.yaw for camera in found.cameras]
    return (*_of_views(yaws, spread), *_of_each(photographs, found, residual), *_of_shape(found, folds))


def _of_views(yaws: Sequence[float], spread: float) -> list[str]:
    """What is not seen from where the cameras were."""
    if len(yaws) == 1:
        return [
            "One photograph shows how wide and tall a face is; only shades and what people's faces have in common tell "
            f"how far nose, brow and chin stand out, about {spread:.1f} mm off. Add one from each side, or turn the "
            "head."
        ]
    doubts = []
    if max(yaws) < TURNED:
        doubts.append("No photograph shows the head from its right; that side is made up.")
    if min(yaws) > -TURNED:
        doubts.append("No photograph shows the head from its left; that side is made up.")
    if min(abs(yaw) for yaw in yaws) > TURNED:
        doubts.append("No photograph shows the head from the front; add one.")
    return doubts


def _of_each(photographs: Sequence[Photograph], found: Bundle, residual: Sequence[float]) -> list[str]:
    """What is odd about single photographs."""
    doubts = []
    for number, (photograph, camera, left) in enumerate(zip(photographs, found.cameras, residual, strict=True), 1):
        if left * float(-camera.shift[2]) / camera.focal > LARGE:
            doubts.append(f"Photograph {number} does not fit: its landmarks lie {left:.0f} pixels off; look at them.")
        said = SIDES.get(photograph.side or "")
        if said and said * camera.yaw < 0.0 and abs(camera.yaw) > TURNED:
            doubts.append(f"Photograph {number} was said to show the {photograph.side}, and shows the other side.")
        worn = max(found.units[number - 1], default=0.0)
        if worn > DIFFERENT:
            doubts.append(f"The face of photograph {number} is not at rest; that was taken out as far as it is known.")
    return doubts


def _of_shape(found: Bundle, folds: int) -> list[str]:
    """What is odd about the head."""
    doubts, strange = [], float(np.sqrt((found.weights**2).mean()))
    if strange > STRANGE:
        doubts.append("The head is unlike those of people; look whether all photographs show one person.")
    if folds > FOLDS:
        doubts.append(f"The skin stays folded at {folds} triangles; look at them, or smooth them.")
    return doubts
