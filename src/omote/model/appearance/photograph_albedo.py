"""Takes the colours of photographs over to the face that was fitted to them: each texel from where it is seen best."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, gaussian_filter, map_coordinates

from omote.geometry.depth_map import draw_depth, visible
from omote.geometry.ramp import smooth_ramp
from omote.model.albedo import Light, SkinAtlas, decode_light
from omote.model.appearance.photograph_background import find_background
from omote.model.appearance.removed_light import remove_light
from omote.model.appearance.taken_albedo import TakenAlbedo, Texels, complete_albedo, place_texels
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

SLACK = 0.003
"""Metres that a surface may be nearer than a texel that it does not hide."""
GRAZING, FACING = 0.2, 0.7
"""Cosines towards the camera from which on a texel is seen, and from which on it is seen as well as can be."""
BORDER = 12 / 1024
"""Of a side, over which a photograph fades out where its part of the skin ends."""
COARSE = 16 / 1024
"""Of a side: what is coarser is mixed over wide borders, what is finer comes from one photograph."""
SHARP = 6.0


def take_photograph_albedo(
    space: ParameterSpace, atlas: SkinAtlas, face: Face, photographs: Sequence[Photograph],
    cameras: Sequence[PhotographCamera], painted: NDArray[np.uint8], /, *,
    even: bool = True,
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
    shown = [(each, camera) for each, camera in zip(photographs, cameras, strict=True) if each.picture is not None]
    if not shown:
        raise ValueError("no photograph comes with its picture; expected at least one")
    side, texels = len(painted), place_texels(space, atlas, face, len(painted))
    lights, weights = [], []
    for photograph, camera in shown:
        light, weight = _sample(space, face, texels, photograph, camera)
        lights.append(remove_light(light, weight, texels.normals, decode_light(painted)) if even else light)
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
    seen = camera.view(face.positions)
    screen = np.column_stack([camera.project(seen), -seen[:, 2]])
    depth = draw_depth(screen, space.triangles.astype(np.int32), camera.width, camera.height)
    rows, columns = np.nonzero(texels.used & (texels.outer > 0.0))
    there = camera.view(texels.places[rows, columns])
    at = np.column_stack([camera.project(there), -there[:, 2]])
    turned = texels.normals[rows, columns] @ camera.rotation.T
    facing = (turned * -there).sum(axis=1) / np.linalg.norm(there, axis=1)
    good = smooth_ramp(GRAZING, FACING, facing) * visible(depth, at, SLACK)
    light, weight = np.zeros((*texels.used.shape, 3), np.float32), np.zeros(texels.used.shape, np.float32)
    picture, places = decode_light(photograph.picture), [at[:, 1] - 0.5, at[:, 0] - 0.5]
    metre = camera.focal / float(np.median(at[:, 2])) if len(at) else 1.0
    good *= ~find_background(picture, depth, at[:, :2], metre)
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
    soft, sharp = [each + np.float32(1e-6) for each in weights], [each**SHARP + np.float32(1e-12) for each in weights]
    low = [_blurred(light, weight, coarse) for light, weight in zip(lights, weights, strict=True)]
    total, finest = sum(soft), sum(sharp)
    mixed: Light = np.zeros_like(lights[0])
    for light, slow, wide, narrow in zip(lights, low, soft, sharp, strict=True):
        mixed += slow * (wide / total)[..., None] + (light - slow) * (narrow / finest)[..., None]
    return np.maximum(mixed, np.float32(0.0))


def _blurred(light: Light, weight: Light, width: float) -> Light:
    """The light (k, k, 3), blurred over what is seen alone."""
    known = gaussian_filter(weight, width) + np.float32(1e-6)
    slow = [gaussian_filter(light[..., c] * weight, width) / known for c in range(3)]
    return np.stack(slow, axis=2)
