"""The built-in hair lies on every human face, and grows where expressions hardly move the skin."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.builtin import load_cast
from omote.geometry.mesh import normals
from omote.model.hair import place_strands
from omote.model.transfer.compound import compound

CAST = load_cast()
SPACE = CAST.space
BEASTS = ("alien", "cat", "dog", "noh")
HUMANS = [name for name in CAST.faces if name not in BEASTS]
UNDER = 0.0015
DEEPEST = 0.012  # metres; deeper than the first lie a few places in the creases behind ears
FEW = 0.01  # of all places
MOVED = 0.004  # metres that a root may go with any performed expression


def heights(points: NDArray[np.float64], skin: NDArray[np.float64]) -> NDArray[np.float64]:
    """Metres of points (..., 3) above the nearest point of the skin's triangles, by their smooth normals."""
    triangles = SPACE.skin_triangles
    weights = np.array([(a, b, 4 - a - b) for a in range(5) for b in range(5 - a)]) / 4
    spots = np.einsum("sc,tcd->tsd", weights, skin[triangles]).reshape(-1, 3)
    facing = np.einsum("sc,tcd->tsd", weights, normals(skin, triangles)[triangles]).reshape(-1, 3)
    _, nearest = cKDTree(spots).query(points)
    result: NDArray[np.float64] = ((points - spots[nearest]) * facing[nearest]).sum(axis=-1)
    return result


@pytest.mark.parametrize("face", HUMANS)
def test_no_hair_lies_under_the_skin_of_a_human_face(face: str) -> None:
    skin = CAST.faces[face].positions.astype(np.float64)
    placed = {style: place_strands(hair, SPACE.points, skin)[:, 2:] for style, hair in CAST.hair.items()}
    height = heights(np.concatenate([points.reshape(-1, 3) for points in placed.values()]), skin)
    ends = np.cumsum([points.size // 3 for points in placed.values()])[:-1]
    for style, own in zip(placed, np.split(height, ends), strict=True):
        assert (own < -UNDER).mean() < FEW, style
        assert own.min() > -DEEPEST, style


@pytest.mark.parametrize("style", CAST.hair)
def test_roots_lie_on_the_scalp(style: str) -> None:
    hair = CAST.hair[style]
    assert SPACE.on_sheet[hair.anchors].all()
    assert (
        np.linalg.norm(hair.points[:, 0] - SPACE.points[hair.anchors], axis=1).max() < 0.06
    )  # the scalp is coarse, a coil thick
    for name, title in CAST.titles.items():
        if title.kind == "performed":
            worn = compound(SPACE, CAST.faces["generic"], CAST.expressions[name])
            assert np.linalg.norm((worn - SPACE.points)[hair.anchors], axis=1).max() < MOVED, name


@pytest.mark.parametrize("style", CAST.hair)
def test_a_few_strands_cover_the_head_as_all_do(style: str) -> None:
    roots = CAST.hair[style].points[:, 0]
    some = roots[: len(roots) // 3]
    far, _ = cKDTree(some).query(roots)
    apart, _ = cKDTree(some).query(some, k=2)
    assert far.max() < 3.0 * np.median(apart[:, 1])  # no hole is much wider than roots are apart


def test_every_style_of_a_look_is_there() -> None:
    assert {look.hair_style for look in CAST.looks.values()} - {""} <= set(CAST.hair)
