"""The colour of hair in photographs of a fitted head: what lies over its scalp and is neither skin nor background.

Nobody knows how bright the light was: hair is taken relative to the skin in the same photographs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import map_coordinates
from scipy.spatial import cKDTree

from omote.arrays import Floats, Mask, Rows, Values
from omote.geometry import mesh
from omote.geometry.depth_map import visible
from omote.model.albedo import decode_light, encode_light
from omote.model.appearance.lab import to_lab
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.hair import HairStyle
from omote.model.space.face import Face
from omote.model.space.head_regions import region_weights
from omote.model.space.parameter_space import ParameterSpace

LIFT = 0.004
BESIDE = 0.08
"""Metres over the scalp where hair is looked for, and where only what is behind a head is."""
HAIR_FACING = 0.1
INNER_FACING = 0.4
SKIN_FACING = 0.25
"""Cosines towards the camera from which on a place is looked at: scalp, scalp that lies well inside the head, skin."""
SLACK = 0.006
"""Metres that a surface may be nearer than a place that it does not hide."""
CHEEKS = 0.6
NOSE = 0.8
"""How much of a place belongs to these regions where its colour is the skin's."""
SPREADS = 3.0
NARROWEST = (3.0, 1.5, 1.5)
WIDEST = (8.0, 4.0, 4.0)
"""L*a*b* within so many standard deviations of the skin's median are skin; these are not smaller than the first, nor
larger than the second: half a face in the shadow is as dark as hair."""
ALIKE = 8.0
"""Colours nearer than that in L*a*b* are one."""
FEWEST = 40
PART = 0.06
APART = 0.12
BEHIND = 0.25
"""Places to look at; the part of them that is of one colour where somebody has hair, and where it is apart from what is
behind; the part of the background that has a colour of its own."""
SHADE = 0.7
"""Of the light of skin of its colour that hair shows: it lies in its own shadow (measured on the cast's strands)."""
_INNER = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4], [2, 2, 2], [1, 1, 1]]) / [[6], [6], [6], [6], [3]]


@dataclass(frozen=True)
class HairColour:
    """The colour of hair: "#rrggbb", None where it is not known; share: of the scalp that is seen, the part that shows
    it; bare: whether the scalp shows skin; doubt: a sentence on why nothing is known, "" where it is."""

    colour: str | None
    share: float = 0.0
    bare: bool = False
    doubt: str = ""


UNSEEN = HairColour(None, doubt="No photograph shows enough of the scalp; choose the colour of the hair.")
BARE = HairColour(None, bare=True, doubt="Over the scalp the photographs show skin, or hair of its colour; look at it.")
LOST = HairColour(None, doubt="The hair looks like what is behind the head; choose its colour.")


def find_scalp(space: ParameterSpace, styles: Mapping[str, HairStyle], /) -> Mask:
    """The vertices (V,) from which the strands of most styles grow.

    space: of the head; styles: of hair, by name.
    """
    grown = np.zeros(space.vertex_count, np.int64)
    for style in styles.values():
        grown[np.unique(style.anchors)] += 1
    return np.asarray(2 * grown > len(styles))


def find_hair_colour(
    space: ParameterSpace, scalp: Mask, face: Face, photographs: Sequence[Photograph],
    cameras: Sequence[PhotographCamera], skin: str, /,
) -> HairColour:  # fmt: skip
    """The colour of hair that photographs show.

    Parameters
    ----------
    space : ParameterSpace
        Of the face.
    scalp : array of bool, (V,)
        Where hair grows.
    face : Face
        Fitted to the photographs.
    photographs : sequence of Photograph
        Those without a picture are left out.
    cameras : sequence of PhotographCamera
        Of each.
    skin : str
        "#rrggbb" of the skin, beside which the hair has its colour.

    Returns
    -------
    HairColour
        The colour most often seen over the scalp beside the skin's, or why there is none.

    Raises
    ------
    ValueError
        Where there are more or fewer cameras than photographs.

    References
    ----------
    The mode of what is seen: Fukunaga and Hostetler (1975), "The estimation of the gradient of a density function",
    with one window.
    """
    shown = [pair for pair in zip(photographs, cameras, strict=True) if pair[0].picture is not None]
    points = face.positions.astype(np.float64)
    decided = _decide([_look(space, scalp, points, *pair, HAIR_FACING) for pair in shown], skin)
    if decided is LOST:  # what is behind the head may show beside a bald one
        inside = _decide([_look(space, scalp, points, *pair, INNER_FACING) for pair in shown], skin)
        return inside if inside.bare else decided
    return decided


def _decide(parts: Sequence[tuple[Values, Values, Values]], skin: str) -> HairColour:
    """The colour that photographs show, of each what `_look` returns."""
    over, bare, behind = (np.concatenate([np.zeros((0, 3)), *(part[at] for part in parts)]) for at in range(3))
    if len(over) < FEWEST or len(bare) < FEWEST:
        return UNSEEN
    lab = to_lab(over)
    other = ~_is_skin(lab, to_lab(bare))
    if len(_most(lab[other])) < PART * len(over):
        return BARE
    other &= ~_is_behind(lab, to_lab(behind))
    chosen = np.flatnonzero(other)[_most(lab[other])]
    share = len(chosen) / len(over)
    if share < APART:
        return LOST
    beside = over[chosen].mean(axis=0) / np.maximum(np.median(bare, axis=0), 1e-4)
    light = beside * decode_light(np.frombuffer(bytes.fromhex(skin[1:]), np.uint8)) / SHADE
    colour = "".join(f"{int(code):02x}" for code in encode_light(np.minimum(light, 1.0).astype(np.float32)))
    return HairColour(f"#{colour}", share)


def _is_skin(lab: Values, skin: Values) -> Mask:
    """Which colours (n, 3) are within what skin (k, 3) is."""
    middle = np.median(skin, axis=0)
    spread = np.clip(1.48 * np.median(np.abs(skin - middle), axis=0), NARROWEST, WIDEST)
    return np.asarray((((lab - middle) / (SPREADS * spread)) ** 2).sum(axis=1) < 1.0)


def _is_behind(lab: Values, behind: Values) -> Mask:
    """Which colours (n, 3) are like what is beside the head (k, 3)."""
    if not len(behind):
        return np.zeros(len(lab), np.bool_)
    count = cKDTree(behind).query_ball_point(lab, ALIKE, return_length=True)
    return np.asarray(count > BEHIND * len(behind))


def _most(lab: Values) -> Rows:
    """The rows of the colours (n, 3) that are alike, most of all."""
    if not len(lab):
        return np.zeros(0, np.intp)
    near = ((lab[:, None] - lab) ** 2).sum(axis=2) < ALIKE**2
    return np.flatnonzero(near[near.sum(axis=1).argmax()])


def _look(
    space: ParameterSpace, scalp: Mask, skin: Values, photograph: Photograph, camera: PhotographCamera, least: float
) -> tuple[Values, Values, Values]:
    """Linear light (n, 3) of what a photograph shows over the scalp, of the face's skin, and beside the head."""
    normals = mesh.normals(skin, space.triangles)
    regions = region_weights(space)
    crown = space.triangles[scalp[space.triangles].all(axis=1)]
    places, ways = (np.einsum("sk,tkc->tsc", _INNER, values[crown]).reshape(-1, 3) for values in (skin, normals))
    face = space.on_sheet & ((regions["cheeks"] > CHEEKS) | (regions["nose"] > NOSE))
    depth = camera.draw(skin, space.triangles, camera.coarse)
    facing = camera.facing(places, ways)
    shows = visible(depth, camera.screen(places, camera.coarse), SLACK)
    shows &= facing > least
    over = places[shows] + LIFT * ways[shows]
    seen = visible(depth, camera.screen(skin, camera.coarse), SLACK) & (camera.facing(skin, normals) > SKIN_FACING)
    assert photograph.picture is not None
    light = decode_light(photograph.picture)
    beside = _beside(camera, places + BESIDE * ways, depth)
    return _colours(light, camera, over), _colours(light, camera, skin[seen & face]), _colours(light, camera, beside)


def _beside(camera: PhotographCamera, places: Values, depth: Floats) -> Values:
    """Those of places (n, 3) that lie beside the head in the picture."""
    empty = np.where(np.isinf(depth), depth, 0.0).astype(np.float32)
    return places[visible(empty, camera.screen(places, camera.coarse), 0.0)]


def _colours(light: Floats, camera: PhotographCamera, places: Values) -> Values:
    """What the picture shows at places (n, 3), those outside left out: (k, 3)."""
    at = camera.project(camera.view(places))
    at = at[((at > 0.0) & (at < [camera.width, camera.height])).all(axis=1)]
    where = [at[:, 1] - 0.5, at[:, 0] - 0.5]
    colours = [map_coordinates(light[..., c], where, order=1, mode="nearest") for c in range(3)]
    return np.stack(colours, axis=1).astype(np.float64)
