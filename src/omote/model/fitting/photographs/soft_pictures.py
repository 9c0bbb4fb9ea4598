"""What a photograph shows of points of a face: brightness, blurred, its slope, and whether they are seen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, map_coordinates

from omote.arrays import Floats, Mask, Values
from omote.geometry.depth_map import visible
from omote.geometry.ramp import smooth_ramp
from omote.model.albedo import decode_light
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera

COARSE = 0.0008
"""Metres: pixels that are finer are put together."""
MARGIN = 0.15
"""Of a face's size, by which a picture goes beyond it."""
GRAZING = 0.4
FACING = 0.6
"""Cosines towards the camera from which on a point is seen, and from which on it is seen as well as can be."""
DARKEST = 0.004
"""Linear light below which a picture says nothing."""
LEAST_BLUR = 0.6
SLACK = 0.004
"""Metres: what lies no farther behind what the camera sees is seen."""


@dataclass(frozen=True, eq=False)
class SoftPicture:
    """The part of a photograph that shows a face: linear light (h, w), its first pixel (2,), and how many pixels each
    of its own stands for."""

    light: Floats
    first: NDArray[np.int64]
    step: int


@dataclass(frozen=True, eq=False)
class Shown:
    """Of points (s, 3): the logarithm of their brightness (s,), how it changes by metres right and up in the picture
    (s, 2), and how well each is seen (s,), 0 to 1."""

    bright: Values
    slopes: Values
    seen: Values


def cut_face(photograph: Photograph, camera: PhotographCamera, skin: Values, /) -> SoftPicture | None:
    """The part of a photograph that shows points (n, 3) of a face, no finer than it is looked at; None without.

    photograph, camera: the picture and where it was taken from; skin (n, 3): metres.
    """
    if photograph.picture is None:
        return None
    seen = camera.view(skin)
    places = camera.project(seen)
    low = places.min(axis=0)
    high = places.max(axis=0)
    size = [camera.width, camera.height]
    first, last = np.clip([low - MARGIN * (high - low), high + MARGIN * (high - low)], 0, size).astype(np.int64)
    step = max(int(COARSE * camera.focal / float(np.median(-seen[:, 2]))), 1)
    counts = np.maximum((last - first) // step, 0)
    if counts.min() < 2:
        return None
    last = first + counts * step
    light = decode_light(photograph.picture[first[1] : last[1], first[0] : last[0]]).mean(axis=2)
    blocks = light.reshape(counts[1], step, counts[0], step).mean(axis=(1, 3))
    return SoftPicture(blocks.astype(np.float32), first, step)


def look_at(picture: SoftPicture, camera: PhotographCamera, places: Values, normals: Values, blur: float, /) -> Shown:
    """What a picture, blurred by metres, shows at places (s, 3) with normals (s, 3) of a head, as if nothing hid
    them.

    picture, camera: the part of a photograph and where it was taken from; places (s, 3): metres; normals (s, 3): of
    length 1; blur: metres.
    """
    seen = camera.view(places)
    pixel = -seen[:, 2] * picture.step / camera.focal
    soft = gaussian_filter(picture.light, max(blur / float(np.median(pixel)), LEAST_BLUR))
    bright = np.log(soft + DARKEST)
    own = (camera.project(seen) - picture.first) / picture.step
    at = [own[:, 1] - 0.5, own[:, 0] - 0.5]
    level, down, right, light = (
        map_coordinates(picture_part, at, order=1, mode="nearest").astype(np.float64)
        for picture_part in (bright, *np.gradient(bright), soft)
    )
    inside = (own > 1.0).all(axis=1) & (own < np.array(picture.light.shape[::-1]) - 1.0).all(axis=1)
    clear = smooth_ramp(GRAZING, FACING, camera.facing(places, normals)) * (inside & (light > DARKEST))
    return Shown(level, np.stack([right, -down], axis=1) / pixel[:, None], clear)


def unhidden(camera: PhotographCamera, skin: Values, triangles: NDArray[np.integer], places: Values, /) -> Mask:
    """Whether nothing of a skin (V, 3) is before places (s, 3) of it.

    camera: of the photograph; skin (V, 3), places (s, 3): metres; triangles (t, 3): rows of the skin.
    """
    return visible(camera.draw(skin, triangles, camera.coarse), camera.screen(places, camera.coarse), SLACK)
