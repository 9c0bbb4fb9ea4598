"""Folds of an avatar: thin surfaces over its skin that show the folds of expressions, each as far as one presses it.

VRM has no wrinkle maps, but its expressions set colours of materials. So each part of the face has a surface of its
own, a tenth of a millimetre over the skin, that moves as the skin does and shows it as deep in folds as it gets; its
alpha is 0 at rest, and an expression brings as much of it as it presses the skin there (docs/method.md, "Folds").
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.arrays import Indices, Points, Values
from omote.geometry.strain import fans_of, vertex_strain
from omote.interchange.avatar.preset_expressions import Weights
from omote.interchange.export_face import ExportContext
from omote.interchange.formats.glb_writer import Material, MorphTarget, Shape
from omote.interchange.formats.png import png_bytes
from omote.interchange.relief_texture import Folds, paint_folds
from omote.model.cast import Look
from omote.model.folding import LIDS, RANGE

OVER = 1e-4
"""Metres that the surfaces lie over the skin."""
PARTS = (
    *("forehead", "frown", "chin", "eye_left", "eye_right"),
    *("cheek_left", "cheek_right", "mouth_left", "mouth_right"),
)
BROW = 0.029
NOSE = -0.030
MOUTH = -0.066
LIP = -0.079
MIDDLE = 0.022
"""Where parts of the generic face meet: over the brows, beside the nose's tip, at the mouth's corners, under the lip,
and beside the middle, metres."""
SEEN = 25
"""Of 255: what covers less of the skin is no fold."""
EVERY = 4
"""Of so many texels one is asked."""
LEAST = 0.02
"""What shows less is left out."""
SLACK = 0.12
GAIN = 1.7
"""What a place is pressed of the most until it folds, and how fast it goes on (fold_shaders.ts)."""


@dataclass(frozen=True, eq=False)
class Overlays:
    """The surfaces, and what tells how much of each shows: rest, poses: the skin (V, 3) at rest and in expressions by
    name, metres; triangles (t, 3): those that fold; most (V,): the strain that they bear; rows (n,), part (n,), line
    (n, 2), way (n, 2, 2): places in folds with their nearest vertex, part, depth of level and upright lines, and the
    ways across them."""

    shapes: tuple[Shape, ...]
    rest: Points
    poses: Mapping[str, Points]
    triangles: Indices
    most: Values
    rows: Indices
    part: Indices
    line: Values
    way: Values

    def shown(self, weights: Weights, /) -> dict[str, float]:
        """How much shows of each material where expressions are worn, 0 to 1; what shows nothing is left out.

        weights: of the expressions. Blinks and looks fold nothing, as on stages.
        """
        moving = {name: part for name, part in weights.items() if name not in LIDS}
        if not self.shapes or not moving:
            return {}
        worn = self.rest + sum(part * (self.poses[name] - self.rest) for name, part in moving.items())
        share = (vertex_strain(self.rest, worn, self.triangles) / self.most[:, None])[self.rows]
        level, mixed, upright = share.T[..., None]
        across = self.way
        pressed = -(
            level * across[..., 0] ** 2 + 2.0 * mixed * across[..., 0] * across[..., 1] + upright * across[..., 1] ** 2
        )
        deep = np.clip(GAIN * (pressed - SLACK), 0.0, 1.2) / 1.2 * self.line
        found = {}
        for shape in self.shapes:
            own = self.part == PARTS.index(shape.name.removeprefix(PREFIX))
            amount = float(np.sqrt((deep[own] ** 2).sum() / max((self.line[own] ** 2).sum(), 1e-12)))
            if amount >= LEAST:
                found[shape.material.name] = round(min(amount, 1.0), 3)
        return found


PREFIX = "folds_"
"""What the names of the surfaces begin with."""


def build_overlays(
    context: ExportContext, look: Look, skin: Shape, rest: Points, poses: Mapping[str, Points], /
) -> Overlays:
    """Builds the surfaces of a face; none for a cast whose skin does not fold, and for lacquer.

    context: of the cast; look: the face's; skin: its shape as it stands; rest, poses: the skin (V, 3) at rest and in
    expressions by name, metres.
    """
    cast = context.cast
    assert skin.rows is not None  # every skin has the cast's
    folding = cast.folding if cast.folding is not None and look.lacquer < 1.0 else np.zeros(len(rest), np.uint8)
    most = np.maximum(folding / 255.0 * RANGE[1], RANGE[0])
    triangles = fans_of(cast.space.triangles, folding > 0)
    folds = paint_folds(context.canvas, look)
    texels = np.argwhere(folds.picture[::EVERY, ::EVERY, 3] > SEEN) * EVERY
    _, nearest = cKDTree(skin.uv).query((texels[:, ::-1] + 0.5) / len(folds.picture), workers=1)
    rows = skin.rows[nearest]
    kept = folding[rows] > 0
    rows = rows[kept]
    down, right = texels[kept].T
    shapes = _surfaces(context.cast.space.points[skin.rows], skin, folds, nearest[kept])
    return Overlays(
        shapes, rest, poses, triangles, most, rows, _part_of(cast.space.points[rows]),
        folds.depth[:, down, right].T, folds.turn[:, down, right].transpose(1, 0, 2),
    )  # fmt: skip


def _surfaces(places: Points, skin: Shape, folds: Folds, nearest: Indices) -> tuple[Shape, ...]:
    """The surfaces around the vertices of the skin that are nearest to folds; places (n, 3): on the generic face."""
    folded = np.zeros(len(skin.points), np.bool_)
    folded[nearest] = True
    touched = skin.triangles[folded[skin.triangles].any(axis=1)]
    parts = _part_of(places[touched].mean(axis=1))
    picture = png_bytes(folds.picture)
    material = replace(skin.material, picture=picture, cut=0.0, shown=0.0)
    return tuple(
        _surface(skin, touched[parts == at], replace(material, name=f"{PREFIX}{name}"))
        for at, name in enumerate(PARTS)
        if (parts == at).any()
    )


def _surface(skin: Shape, triangles: NDArray[np.integer], material: Material) -> Shape:
    own, corners = np.unique(triangles, return_inverse=True)
    moved = {
        name: MorphTarget(target.moves[own], target.turns[own])
        for name, target in skin.targets.items()
        if target.moves[own].any()
    }
    return replace(
        skin,
        name=material.name,
        points=(skin.points + np.float32(OVER) * skin.normals)[own],
        normals=skin.normals[own],
        uv=skin.uv[own],
        rows=None,
        tangents=None,
        triangles=corners.reshape(-1, 3).astype(np.int32),
        material=material,
        targets=moved,
    )


def _part_of(places: Points) -> Indices:
    """Which of `PARTS` places (n, 3) of the generic face lie in."""
    x, y, _ = places.T
    middle = np.abs(x) < MIDDLE
    side = np.where(x > 0.0, 0, 1)
    beside = np.select(
        [y > NOSE, y > MOUTH],
        [PARTS.index("eye_left") + side, PARTS.index("cheek_left") + side],
        PARTS.index("mouth_left") + side,
    )
    within = np.select([y > NOSE, y < LIP], [PARTS.index("frown"), PARTS.index("chin")], beside)
    return np.where(y > BROW, PARTS.index("forehead"), np.where(middle, within, beside))
