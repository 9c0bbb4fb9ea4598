"""The collar of an exported head: the ragged rim of its neck ends in a roll of cloth, closed below."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Indices, Points
from omote.geometry import mesh
from omote.interchange.formats.glb_writer import Material, MorphTarget, Shape
from omote.interchange.formats.png import png_bytes
from omote.model.space.head_size import HEAD_METRES, find_chin
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached

COLLAR = "collar"
COLUMNS = 48
"""Places around the neck."""
PROFILE = np.array(
    [
        (-0.012, 0.002), (-0.004, 0.014), (0.002, 0.019), (0.007, 0.016), (0.010, 0.008), (0.011, -0.012),
        (0.013, -0.026), (0.011, -0.034), (0.000, -0.038), (-0.020, -0.039),
    ]
) / HEAD_METRES  # fmt: skip
"""From within the neck outwards, down and in again, heads out and up: as stages draw it, without shoulders."""
CONCENTRATION = 8.0
"""How far along the rim its radius is averaged: the concentration of a von Mises distribution."""
HIDDEN = 0.004 / HEAD_METRES
"""Heads by which what sticks out of the rim stays within the cloth."""
TOP = 0.012 / HEAD_METRES
"""Heads by which the roll is above the averaged rim, which may stick out so far."""
CLOTH = Material(COLLAR, png_bytes(np.full((4, 4, 3), (29, 29, 33), np.uint8)), roughness=0.9)


@weakly_cached
def neck_rim(space: ParameterSpace, /) -> Indices:
    """The rows of the skin's lower rim, in no order: of its boundary what lies below the chin."""
    corners = space.welded[space.triangles]
    rows = np.unique(mesh.boundary_edges(corners))
    lower: Indices = rows[space.points[rows, 1] < space.points[find_chin(space), 1]]
    return lower


def collar_shape(space: ParameterSpace, positions: NDArray[np.floating], targets: Mapping[str, MorphTarget]) -> Shape:
    """A roll of cloth around the neck of a face, which no target moves.

    space: of the head; positions (V, 3): of the face's skin, metres; targets: those of the skin, by name.
    """
    rim = positions[neck_rim(space)].astype(np.float64)
    head = HEAD_METRES * float(np.ptp(rim[:, 0]) / np.ptp(space.points[neck_rim(space), 0]))
    points = _rings(rim, PROFILE * head)
    bottom = points[-COLUMNS:].mean(axis=0, keepdims=True)
    points = np.concatenate([points, bottom])
    triangles = _triangles(len(PROFILE), COLUMNS)
    still = np.zeros((len(points), 3), np.float32)
    return Shape(
        name=COLLAR,
        points=points.astype(np.float32),
        normals=mesh.normals(points, triangles).astype(np.float32),
        uv=np.zeros((len(points), 2), np.float32),
        triangles=triangles,
        material=CLOTH,
        targets=dict.fromkeys(targets, MorphTarget(still, still)),
    )


def _rings(rim: Points, profile: Points) -> Points:
    """The points of all rings, one after the other, metres: above as the rim lies, level below. rim: of the neck;
    profile: out and up, metres."""
    flat = rim[:, [0, 2]]
    middle = (flat.min(axis=0) + flat.max(axis=0)) / 2
    across, ahead = (flat - middle).T
    angles = np.arctan2(across, ahead)
    radii = np.hypot(across, ahead)
    turn = 2.0 * np.pi * np.arange(COLUMNS) / COLUMNS
    near = np.exp(CONCENTRATION * (np.cos(turn[:, None] - angles) - 1.0))
    smooth = (near @ np.stack([radii, rim[:, 1]], axis=1)) / near.sum(axis=1, keepdims=True)
    expected = np.stack([np.interp(angles, turn, values, period=2.0 * np.pi) for values in smooth.T], axis=1)
    beyond = (np.stack([radii, rim[:, 1]], axis=1) - expected).max(axis=0)
    wider, higher = np.maximum(beyond - [HIDDEN * HEAD_METRES, TOP * HEAD_METRES], 0.0)
    height = smooth[:, 1]
    low = np.clip((profile[:, 1].max() - profile[:, 1:]) / np.ptp(profile[:, 1]), 0.0, 1.0)
    out = smooth[:, 0] + profile[:, :1] + np.where(profile[:, :1] > 0.0, wider, 0.0)
    up = (1.0 - low) * (height + higher) + low * height.min() + profile[:, 1:]
    points: Points = np.stack([middle[0] + np.sin(turn) * out, up, middle[1] + np.cos(turn) * out], axis=-1)
    return points.reshape(-1, 3)


def _triangles(rings: int, columns: int) -> NDArray[np.int32]:
    """Quads between neighbouring rings, and a fan that closes the last, facing outwards."""
    inner = (np.arange(rings - 1)[:, None] * columns + np.arange(columns)).ravel()
    beside = inner - inner % columns + (inner + 1) % columns
    below = inner + columns
    far = beside + columns
    last = (rings - 1) * columns + np.arange(columns)
    fan = np.stack([last, np.full(columns, rings * columns), np.roll(last, -1)], axis=1)
    return np.concatenate(
        [np.stack([below, beside, inner], axis=1), np.stack([below, far, beside], axis=1), fan]
    ).astype(np.int32)
