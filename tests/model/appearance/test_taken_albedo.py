"""Colours taken over from scans whose truth is known: faces of the cast, cut into other triangles and moved away."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.model.albedo import decode_light, encode_light
from omote.model.appearance.taken_albedo import FEATHER, take_albedo
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity

CAST = load_cast()
SPACE = CAST.space
SIDE = 1024
Values = NDArray[np.float64]
# Of the scan: another unit, other axes; from there to the face.
TURN = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
PLACEMENT = Similarity(0.0254, TURN, np.array([0.3, -1.2, 0.05]))


def away(points: Values) -> Values:
    """Points of a face as the scan has them."""
    moved: Values = (points - PLACEMENT.shift) @ TURN / PLACEMENT.scale
    return moved


def divided(points: Values, triangles: NDArray[np.integer]) -> tuple[Values, NDArray[np.integer]]:
    """Every triangle as three, about its middle: vertices that no face of the cast has."""
    middles = len(points) + np.arange(len(triangles))
    a, b, c = triangles.T
    parts = [np.stack([*pair, middles], axis=1) for pair in ((a, b), (b, c), (c, a))]
    return np.concatenate([points, points[triangles].mean(axis=1)]), np.concatenate(parts)


def wave(points: Values) -> NDArray[np.uint8]:
    """Colours that are different all over a head, none dark."""
    return encode_light(0.4 + 0.25 * np.sin(40.0 * points + [0.0, 1.0, 2.0]))


def scan_of(name: str, colour: Callable[[Values], NDArray[np.uint8]], keep: Callable[[Values], Values]) -> Scan:
    """A face's skin as a scan, coloured by its points, without the triangles that are not to be kept."""
    points, triangles = divided(CAST.faces[name].positions.astype(np.float64), SPACE.triangles)
    kept = triangles[keep(points[triangles].mean(axis=1)) > 0.0]
    return Scan(away(points), kept, colour(points))


def whole(middles: Values) -> Values:
    return np.ones(len(middles))


def grey(code: int = 128) -> NDArray[np.uint8]:
    return np.full((SIDE, SIDE, 3), code, np.uint8)


def test_every_texel_that_was_seen_has_the_colour_of_its_place() -> None:
    assert CAST.atlas is not None
    face = CAST.faces["heavy"]
    taken = take_albedo(SPACE, CAST.atlas, face, scan_of("heavy", wave, whole), PLACEMENT, grey())
    places = np.stack([CAST.atlas.spread(face.positions[:, axis], SIDE) for axis in range(3)], axis=2)
    seen = taken.seen == 255
    assert seen[SIDE // 4 : 3 * SIDE // 4, SIDE // 4 : 3 * SIDE // 4].mean() > 0.8
    off = np.abs(taken.albedo.pixels[..., :3].astype(int) - wave(places).astype(int))[seen].max(axis=1)
    assert np.median(off) <= 1
    assert np.percentile(off, 99) <= 12  # within a large triangle, colours of corners are mixed


def test_a_texture_comes_back_as_it_was() -> None:
    """The scan's texture is the atlas itself, so texels find their own place in it again."""
    assert CAST.atlas is not None
    atlas = CAST.atlas
    face = CAST.faces["child"]
    rows, columns = np.indices((SIDE, SIDE)) / SIDE
    texture = encode_light(0.4 + 0.2 * np.sin(np.stack([60.0 * rows, 50.0 * columns, 40.0 * (rows + columns)], axis=2)))
    scan = Scan(
        away(face.positions.astype(np.float64)),
        np.asarray(atlas.source)[atlas.triangles],
        texture=texture,
        texcoords=np.asarray(atlas.uv, np.float64)[atlas.triangles],
    )
    taken = take_albedo(SPACE, atlas, face, scan, PLACEMENT, grey())
    off = np.abs(taken.albedo.pixels[..., :3].astype(int) - texture)[taken.seen == 255].max(axis=1)
    assert np.median(off) <= 1
    assert np.percentile(off, 99) <= 3


@pytest.mark.parametrize("skin", [(188, 188, 188), (70, 42, 28)])
def test_half_a_head_is_carried_on_in_its_hue_over_what_is_painted(skin: tuple[int, int, int]) -> None:
    """Where a scan is the painted skin in another light, so is what is filled: to the last texel, on dark skin too."""
    assert CAST.atlas is not None
    tint = np.array([0.9, 0.55, 0.4])
    scan = scan_of("round", lambda points: encode_light(np.tile(tint * 0.5, (len(points), 1))), lambda at: at[:, 0])
    painted = np.broadcast_to(np.array(skin, np.uint8), (SIDE, SIDE, 3))
    taken = take_albedo(SPACE, CAST.atlas, CAST.faces["round"], scan, PLACEMENT, painted)
    assert 0.2 < (taken.seen == 255).mean() < 0.6
    assert np.abs(taken.albedo.pixels[..., :3].astype(int) - encode_light(tint * 0.5)).max() <= 2


def test_what_is_filled_keeps_what_is_painted_fine() -> None:
    assert CAST.atlas is not None
    scan = scan_of("round", lambda points: np.full((len(points), 3), 128, np.uint8), lambda at: at[:, 0])
    stripes = grey()
    stripes[::2] = 140
    taken = take_albedo(SPACE, CAST.atlas, CAST.faces["round"], scan, PLACEMENT, stripes)
    light = decode_light(taken.albedo.pixels[..., :3]).mean(axis=2)[: SIDE // 2 * 2]
    contrast = light[::2] / light[1::2]
    filled = (taken.seen[::2] == 0) & (taken.seen[1::2] == 0)
    wanted = float(decode_light(np.array([140], np.uint8))[0] / decode_light(np.array([128], np.uint8))[0])
    assert np.median(contrast[filled]) == pytest.approx(wanted, rel=0.02)


def test_between_what_was_seen_and_what_is_filled_lies_a_feather() -> None:
    assert CAST.atlas is not None
    scan = scan_of("round", wave, lambda at: at[:, 0])
    taken = take_albedo(SPACE, CAST.atlas, CAST.faces["round"], scan, PLACEMENT, grey())
    steps = np.abs(np.diff(taken.seen.astype(int), axis=1))
    outer = (taken.albedo.pixels[:, 1:, 3] == 255) & (taken.albedo.pixels[:, :-1, 3] == 255)
    assert 0 < steps[outer].max() <= np.ceil(1.5 * 255 / (FEATHER * SIDE))  # the steepest of a smooth ramp


def test_inner_skin_stays_uncovered() -> None:
    assert CAST.atlas is not None
    taken = take_albedo(SPACE, CAST.atlas, CAST.faces["kaori"], scan_of("kaori", wave, whole), PLACEMENT, grey())
    inner = np.ones(SPACE.vertex_count)
    inner[np.unique(SPACE.skin_triangles)] = 0.0
    deep = CAST.atlas.spread(inner, SIDE) > 0.9
    assert deep.any()
    assert not taken.albedo.pixels[deep, 3].any()
    assert not taken.seen[deep].any()


def test_scans_without_colours_or_elsewhere_are_refused() -> None:
    assert CAST.atlas is not None
    face = CAST.faces["kaori"]
    plain = scan_of("kaori", wave, whole)
    with pytest.raises(ValueError, match="this scan has no colours"):
        take_albedo(SPACE, CAST.atlas, face, Scan(plain.positions, plain.triangles), PLACEMENT, grey())
    far = Similarity(PLACEMENT.scale, PLACEMENT.rotation, PLACEMENT.shift + 3.0)
    with pytest.raises(ValueError, match="nothing of this scan lies near the face"):
        take_albedo(SPACE, CAST.atlas, face, plain, far, grey())
    above = Similarity(PLACEMENT.scale, PLACEMENT.rotation, PLACEMENT.shift + np.array([0.0, 0.3, 0.0]))
    with pytest.raises(ValueError, match=r"(nothing of this scan|no skin of the face) lies"):
        take_albedo(SPACE, CAST.atlas, face, plain, above, grey())
