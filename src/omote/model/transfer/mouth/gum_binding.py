"""Binds the mouth bag to the jaws where gums are, as teeth are bound (docs/method.md, "Gums")."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.geometry.proximity import nearest_triangles
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.model.space.parameter_space import InnerSkin, ParameterSpace
from omote.model.space.parts import Part
from omote.model.transfer.mouth.gum_line import GUMS, GumLine, find_gum_line

Values = NDArray[np.float64]

# Along the mesh from the sheet, metres: up to the first the bag goes with the lips, from the second on with the jaws;
# between them evenly: steeper anywhere, and walls that a raised lip pushes together would turn over.
LIPS, JAWS = 0.001, 0.028
# What holds a gum's edge by so much goes with its jaw, wherever it is.
HOLDS = 0.02


def bind_to_gums(space: ParameterSpace, /) -> ParameterSpace:
    """The space with its mouth bag bound to skull and jaw where gums are: their shares of a vertex no longer follow the
    sheet around the lips but stay, or move as the lower teeth do. Where it has no gum line it comes back as it is."""
    line = find_gum_line(space)
    if line is None:
        return space
    upper, lower = share_jaws(space, line)
    inner, jaw = space.inner, space.parts["teeth_lower"]
    rows = line.bag.rows
    down, still = (np.where(rows >= 0, share[rows], 0.0) for share in (lower, upper))
    anchors = np.broadcast_to(jaw.anchors[0], (len(rows), jaw.anchors.shape[1]))
    own = inner.weights * (1.0 - down - still)[:, None]
    return replace(
        space,
        inner=InnerSkin(
            inner.vertices,
            np.ascontiguousarray(np.concatenate([inner.anchors, anchors], axis=1), np.int32),
            np.ascontiguousarray(np.concatenate([own, down[:, None] * jaw.weights[:1]], axis=1), np.float32),
        ),
    )


def share_jaws(space: ParameterSpace, line: GumLine, /) -> tuple[Values, Values]:
    """How much each vertex of the bag goes with the upper and with the lower jaw, (m,) each; the rest is the lips'."""
    bag = line.bag
    points = np.ascontiguousarray(space.points[bag.vertices])
    away = [_distance(space.parts[name], points) for name in GUMS]
    lower = smooth_ramp(0.0, 1.0, 0.5 + (away[0] - away[1]) / np.maximum(away[0] + away[1], 1e-6))
    whole = clamp_unit((bag.distance - LIPS) / (JAWS - LIPS))
    shares = [whole * (1.0 - lower), whole * lower]
    for number, name in enumerate(GUMS):
        edge = line.places[np.flatnonzero(line.edge & (line.names == name))]
        held = np.unique(edge.indices[edge.data > HOLDS])
        shares[number][held], shares[1 - number][held] = 1.0, 0.0
    return shares[0], shares[1]


def _distance(part: Part, points: Values) -> Values:
    return nearest_triangles(np.ascontiguousarray(part.points[part.triangles]), points)[0]


def carry_bag(space: ParameterSpace, skin: Values, teeth: Values, /) -> Values:
    """A displacement of the generic skin (V, 3) with the mouth bag carried by the jaws.

    teeth: what the lower teeth do, displacements (n, 3): as an affine map (least squares) it says what happens around
    them. Shares of the upper jaw stay.
    """
    line = find_gum_line(space)
    if line is None:
        return skin
    upper, lower = (share[:, None] for share in share_jaws(space, line))
    points, bag = space.parts["teeth_lower"].points, line.bag.vertices
    ones = np.ones((len(points), 1))
    affine, *_ = np.linalg.lstsq(np.hstack([points, ones]), teeth, rcond=None)
    around = np.hstack([space.points[bag], np.ones((len(bag), 1))]) @ affine
    result = skin.copy()
    result[bag] = (1.0 - upper - lower) * skin[bag] + lower * around
    moved: Values = result[space.welded]
    return moved
