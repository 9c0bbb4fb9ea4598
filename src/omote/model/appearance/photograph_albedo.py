"""Takes the colours of photographs over to the face that was fitted to them: each texel from where it is seen best.

Soft light is divided out: from afar, on skin that scatters it evenly, it is a polynomial of the second degree in the
normal, and skin of one colour shows it (Ramamoorthi and Hanrahan 2001). What is behind the head is left out, though one
that was fitted a little too wide lies over it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter, map_coordinates

from omote.arrays import Mask, Rows, Values
from omote.geometry.depth_map import visible
from omote.geometry.ramp import smooth_ramp
from omote.model.albedo import Light, SkinAtlas, decode_light
from omote.model.appearance.lab import to_lab
from omote.model.appearance.taken_albedo import TakenAlbedo, Texels, complete_albedo, place_texels
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.soft_light import fit_soft_light, harmonics
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace

RANGE = (0.35, 2.5)
"""Shade is divided out between these, its mean being 1: darker and lighter than that is no soft light."""
_DARKEST = 0.004
_STEP = 7  # every so many texels are enough for nine numbers
BAND = 0.015
"""Metres in from where a fitted head ends, within which what is behind it may be seen."""
OUTSIDE = 0.008
INSIDE = 0.006
BLUR = 0.001
"""Metres beyond the end where only what is behind is, and beyond the band where only the head is; of the blur."""
MARGIN = 0.02
"""Metres around the head that are looked at."""
UNLIKE = 12.0
"""L*a*b* by which both have to differ where a place is told from one of them."""
SLACK = 0.003
"""Metres that a surface may be nearer than a texel that it does not hide."""
GRAZING = 0.2
FACING = 0.7
"""Cosines towards the camera from which on a texel is seen, and from which on it is seen as well as can be."""
INNER_LIPS = np.array("78 191 80 81 82 13 312 311 310 415 308 324 318 402 317 14 87 178 88 95".split(), np.intp)
"""Points of the face mesh around the opening of the mouth, one after another."""
OPENED = 0.06
"""Of the width of the mouth: lips that are farther apart show what is between them."""
LIP_EDGE = 0.1
"""Of the opening, by which landmarks of the lips' edge may lie inside of it."""
BORDER = 12 / 1024
"""Of a side, over which a photograph fades out where its part of the skin ends."""
COARSE = 16 / 1024
"""Of a side: what is coarser is mixed over wide borders, what is finer comes from one photograph."""
SHARP = 6.0


def remove_light(light: Light, weight: Light, normals: Values, painted: Light, /) -> Light:
    """The linear light (k, k, 3) of texels divided by the shade on them, whose mean stays.

    weight (k, k): how well each is seen; normals (k, k, 3); painted (k, k, 3): linear light of usual skin, whose lips
    and shades are no light. Each colour has a light of its own.
    """
    rows, columns = np.nonzero(weight[::_STEP, ::_STEP] > 0.0)
    if len(rows) < 9 * 9:
        return light
    rows = rows * _STEP
    columns = columns * _STEP
    basis = harmonics(normals[rows, columns])
    ratio = np.maximum(light[rows, columns], _DARKEST) / np.maximum(painted[rows, columns], _DARKEST)
    result = light.copy()
    used = weight > 0.0
    everywhere = harmonics(normals[used])
    for channel in range(3):
        answer = fit_soft_light(basis, ratio[:, channel].astype(np.float64), weight[rows, columns].astype(np.float64))
        even = float((weight[rows, columns] * (basis @ answer)).sum() / weight[rows, columns].sum())
        shade = np.clip(everywhere @ answer / max(even, _DARKEST), *RANGE)
        result[used, channel] = light[used, channel] / shade
    return result


def find_background(picture: Light, depth: NDArray[np.floating], at: Values, metre: float, /) -> Mask:
    """Which places of a head show what is behind it: those near its end in the picture that are more like what lies
    beside the head than like what lies farther in.

    Parameters
    ----------
    picture : ndarray, (h, w, 3)
        Linear light.
    depth : ndarray, (h, w)
        Of the fitted head; infinity beside it.
    at : ndarray, (n, 2)
        Places in the picture, pixels, right and down.
    metre : float
        Pixels that a metre takes at the head.
    """
    head = np.isfinite(depth)
    behind_head = np.zeros(len(at), np.bool_)
    if head.all() or not head.any():
        return behind_head
    left, top, right, low = _frame(head, round(MARGIN * metre))
    head = head[top:low, left:right]
    picture = picture[top:low, left:right]
    size = np.array(head.shape)
    places = np.clip((at - [left, top])[:, ::-1].astype(np.intp), 0, size - 1)
    away, nearest = distance_transform_edt(head, return_indices=True)
    far = away[places[:, 0], places[:, 1]]
    rows = np.flatnonzero((far > 0.0) & (far < BAND * metre))
    end = nearest[:, places[rows, 0], places[rows, 1]].T
    ends, outer, inner = _look_across(head, end, (places[rows] - end) / far[rows, None], metre)
    rows = rows[ends]
    soft = gaussian_filter(picture, (BLUR * metre, BLUR * metre, 0.0))
    here, behind, skin = (
        to_lab(light[where[:, 0], where[:, 1]].astype(np.float64))
        for light, where in ((picture, places[rows]), (soft, outer), (soft, inner))
    )
    to_behind, to_skin, apart = (
        np.linalg.norm(one - other, axis=1) for one, other in ((here, behind), (here, skin), (behind, skin))
    )
    behind_head[rows] = (to_behind < to_skin) & (to_behind < 0.5 * apart) & (apart > UNLIKE)
    return behind_head


def find_between_lips(landmarks: Values, at: Values, /) -> Mask:
    """Which places of a picture show what is between the lips: teeth, tongue and the dark of a mouth are no skin.

    landmarks (478, 2): of the face mesh, pixels; at (n, 2): places, pixels.
    """
    outline = landmarks[INNER_LIPS]
    tall = float(np.ptp(outline[:, 1]))
    if tall < OPENED * float(np.ptp(outline[:, 0])):  # lips that meet hide nothing
        return np.zeros(len(at), np.bool_)
    middle = outline.mean(axis=0)
    wider = middle + (outline - middle) * (1.0 + LIP_EDGE)
    inside = np.zeros(len(at), np.bool_)
    x, y = at.T
    for (left, top), (right, low) in zip(wider, np.roll(wider, -1, axis=0), strict=True):
        crossed = (top > y) != (low > y)
        if crossed.any():
            inside[crossed] ^= x[crossed] < left + (y[crossed] - top) * (right - left) / (low - top)
    return inside


def _look_across(head: Mask, end: Rows, inward: Values, metre: float) -> tuple[Rows, Rows, Rows]:
    """Which ends (n, 2) of the head have both sides in the picture, and the pixels (k, 2) beside and well inside it."""
    outer = np.rint(end - OUTSIDE * metre * inward).astype(np.intp)
    inner = np.rint(end + (BAND + INSIDE) * metre * inward).astype(np.intp)
    whole = ((np.minimum(outer, inner) >= 0) & (np.maximum(outer, inner) < head.shape)).all(axis=1)
    ends = np.flatnonzero(whole)
    ends = ends[~head[tuple(outer[ends].T)] & head[tuple(inner[ends].T)]]
    return ends, outer[ends], inner[ends]


def _frame(head: Mask, margin: int) -> tuple[int, int, int, int]:
    """The least and the first too large column and row of a head's pixels, so many pixels around it."""
    (top, low), (left, right) = (np.flatnonzero(head.any(axis=axis))[[0, -1]].tolist() for axis in (1, 0))
    return max(left - margin, 0), max(top - margin, 0), right + 1 + margin, low + 1 + margin


def take_photograph_albedo(
    space: ParameterSpace, atlas: SkinAtlas, face: Face, photographs: Sequence[Photograph],
    cameras: Sequence[PhotographCamera], painted: NDArray[np.uint8], /, *,
    worn: Sequence[Values] = (), even: bool = True,
) -> TakenAlbedo:  # fmt: skip
    """Takes the colours of photographs over to the skin of the face that was fitted to them.

    Parameters
    ----------
    space : ParameterSpace
        Of the face.
    atlas : SkinAtlas
        How the skin lies on its texture.
    face : Face
        Fitted to the photographs.
    photographs : sequence of Photograph
        With pictures; those without are left out.
    cameras : sequence of PhotographCamera
        Of each.
    painted : array of uint8, (k, k, 3)
        The face's painted skin in sRGB, without brows and the like: what is filled where nothing was seen. k is 1024
        or 2048.
    worn : sequence of ndarray, (V, 3)
        The skin as it is in each photograph, metres: a mouth that is open there, or smiles, lies elsewhere than at
        rest. Without them the face is taken to be at rest in all.
    even : bool
        Whether soft light from one side is divided out, as far as skin of one colour shows it.

    Returns
    -------
    TakenAlbedo
        The picture, and what of it was seen.

    Raises
    ------
    ValueError
        Where no photograph has a picture, or none shows the face.

    References
    ----------
    Two bands after Burt and Adelson (1983), "A multiresolution spline with application to image mosaics".
    """
    skins = worn or [face.positions.astype(np.float64)] * len(photographs)
    shown = [
        (view, camera, skin)
        for view, camera, skin in zip(photographs, cameras, skins, strict=True)
        if view.picture is not None
    ]
    if not shown:
        raise ValueError("no photograph comes with its picture; expected at least one")
    side = len(painted)
    texels = place_texels(space, atlas, face, len(painted))
    lights = []
    weights = []
    for photograph, camera, skin in shown:
        at = replace(face, positions=skin)
        there = place_texels(space, atlas, at, side) if worn else texels
        light, weight = _sample(space, at, there, photograph, camera)
        lights.append(remove_light(light, weight, there.normals, decode_light(painted)) if even else light)
        weights.append(weight)
    seen = np.max(weights, axis=0) > 0.0
    if not seen.any():
        raise ValueError("no photograph shows the face; expected the cameras that it was fitted with")
    return complete_albedo(texels, _mix(lights, weights, COARSE * side), seen, painted)


def _sample(
    space: ParameterSpace, face: Face, texels: Texels, photograph: Photograph, camera: PhotographCamera
) -> tuple[Light, Light]:
    """Linear light (k, k, 3) of what a photograph shows of each texel, and how well it is seen (k, k), 0 to 1."""
    assert photograph.picture is not None
    depth = camera.draw(face.positions, space.triangles)
    rows, columns = np.nonzero(texels.used & (texels.outer > 0.0))
    at = camera.screen(texels.places[rows, columns])
    facing = camera.facing(texels.places[rows, columns], texels.normals[rows, columns])
    good = smooth_ramp(GRAZING, FACING, facing) * visible(depth, at, SLACK)
    light = np.zeros((*texels.used.shape, 3), np.float32)
    weight = np.zeros(texels.used.shape, np.float32)
    picture = decode_light(photograph.picture)
    places = [at[:, 1] - 0.5, at[:, 0] - 0.5]
    metre = camera.focal / float(np.median(at[:, 2])) if len(at) else 1.0
    good *= ~find_background(picture, depth, at[:, :2], metre)
    good *= ~find_between_lips(photograph.landmarks[:, :2], at[:, :2])
    light[rows, columns] = np.stack(
        [map_coordinates(picture[..., c], places, order=1, mode="nearest") for c in range(3)], axis=1
    )
    weight[rows, columns] = good
    inside = distance_transform_edt(weight > 0.0) / (BORDER * len(weight))
    return light, (weight * smooth_ramp(0.0, 1.0, inside)).astype(np.float32)


def _mix(lights: Sequence[Light], weights: Sequence[Light], coarse: float) -> Light:
    """Linear light (k, k, 3): coarse shades by all weights, fine ones by the best."""
    if len(lights) == 1:
        return lights[0]
    soft = [weight + np.float32(1e-6) for weight in weights]
    sharp = [weight**SHARP + np.float32(1e-12) for weight in weights]
    low = [_blurred(light, weight, coarse) for light, weight in zip(lights, weights, strict=True)]
    total = sum(soft)
    finest = sum(sharp)
    mixed: Light = np.zeros_like(lights[0])
    for light, slow, wide, narrow in zip(lights, low, soft, sharp, strict=True):
        mixed += slow * (wide / total)[..., None] + (light - slow) * (narrow / finest)[..., None]
    return np.maximum(mixed, np.float32(0.0))


def _blurred(light: Light, weight: Light, width: float) -> Light:
    """The light (k, k, 3), blurred over what is seen alone."""
    known = gaussian_filter(weight, width) + np.float32(1e-6)
    slow = [gaussian_filter(light[..., c] * weight, width) / known for c in range(3)]
    return np.stack(slow, axis=2)
