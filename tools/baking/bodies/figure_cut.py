"""Cuts the figure out of the base mesh: the head's rows first, as its skin has them, then the rest of the body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from omote.arrays import Floats as Singles
from tools.baking.heads.basemesh import BaseMesh, Floats, Ints, Quads
from tools.baking.heads.head import Head, split_quads

GROUP = "body"
SKIRT = "helper-skirt"


@dataclass(frozen=True)
class FigureCut:
    """vertices: (V + B,) rows of the base mesh, those of the head's skin first, the skirt's last;  head_rows: V;
    triangles: (t, 3) of the body, rows of `vertices`;  all_triangles: with the head's, without parts;
    uvs: (k, 2) (0, 0) the upper left corner;  uv_rows: (t, 3);  edge: rows of the head, the rim first;  rim: how many;
    skirt: (s, 3) triangles of the skirt
    """

    vertices: Ints
    head_rows: int
    triangles: Ints
    all_triangles: Ints
    uvs: Singles
    uv_rows: Ints
    edge: Ints
    rim: int
    skirt: Ints


def cut_figure(base: BaseMesh, head: Head) -> FigureCut:
    """The figure: every quad of the base mesh's body that the head's cut left is split as the head's are."""
    quads = base.groups[GROUP]
    kept = ~np.isin(quads.corners, head.skin.vertices).all(axis=1)
    corners, uv_corners = split_quads(base.points, Quads(quads.corners[kept], quads.uv_corners[kept]))
    below = np.setdiff1d(corners, head.skin.vertices)
    skirt, _ = split_quads(base.points, base.groups[SKIRT])
    vertices = np.concatenate([head.skin.vertices, below, np.unique(skirt)]).astype(np.int32)
    row_of = np.full(len(base.points), -1, np.int32)
    row_of[vertices] = np.arange(len(vertices))
    triangles = row_of[corners]
    count = len(head.skin.vertices)
    rim = np.unique(triangles[triangles < count])
    uv_rows, uv_triangles = np.unique(uv_corners, return_inverse=True)
    return FigureCut(
        vertices=vertices,
        head_rows=count,
        triangles=triangles,
        all_triangles=np.concatenate([head.skin.triangles, triangles]).astype(np.int32),
        uvs=(base.uvs[uv_rows] * [1.0, -1.0] + [0.0, 1.0]).astype(np.float32),
        uv_rows=uv_triangles.reshape(-1, 3).astype(np.int32),
        edge=np.concatenate([rim, _ring(head.skin.triangles, rim)]).astype(np.int32),
        rim=len(rim),
        skirt=row_of[skirt],
    )


def _ring(triangles: Ints, rim: Ints) -> Ints:
    """The rows of the head that share an edge with its rim."""
    touching = triangles[np.isin(triangles, rim).any(axis=1)]
    return np.setdiff1d(touching, rim).astype(np.int32)


def figure_points(cut: FigureCut, head: Head, points: Floats) -> Floats:
    """The figure's rows (V + B, 3) of a person's base mesh, metres in the head's frame; points: in the mesh's unit."""
    return head.metres(points)[cut.vertices]
