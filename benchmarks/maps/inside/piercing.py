"""How deep lids lie in eyeballs and teeth in the skin, on any face wearing any unit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.source import Source
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import move_parts

Values = NDArray[np.float64]
Indices = NDArray[np.int32]

EYES = ("eye_left", "eye_right")
TEETH = ("teeth_upper", "teeth_lower")
# Skin farther behind a tooth than this, metres, is the throat or the nape seen through the open mouth.
BEYOND = 0.01


def balls_of(source: Source, face: Face) -> tuple[tuple[Values, float], ...]:
    """Centre (3,) and radius of both eyeballs of a face, metres: the mean distance of its vertices."""
    fitted = fit(source.space, face)
    return tuple((fitted.centres[name], fitted.ball_radius(name)) for name in EYES)


def depth_in_balls(balls: tuple[tuple[Values, float], ...], positions: Values, rest: Values, still: Values) -> Values:
    """How deep points (n, 3) lie inside the nearer eyeball, (n,) metres, zero outside, less than at rest where still.

    At rest the lids' inner rims and the corners lie inside on every face, hidden; still (n,): 1 where a point is still
    hidden, 0 where it has come out.
    """
    deep = [
        np.maximum(radius - np.linalg.norm(positions - centre, axis=1), 0.0)
        - still * np.maximum(radius - np.linalg.norm(rest - centre, axis=1), 0.0)
        for centre, radius in balls
    ]
    result: Values = np.maximum(np.max(deep, axis=0), 0.0)
    return result


def teeth_on(source: Source, face: Face, worn: Values, unit: str) -> Values:
    """The teeth's vertices (n, 3) where the skin of a face has gone to worn (V, 3)."""
    rest = source.cast.expressions[unit].parts
    parts = move_parts(source.space, fit(source.space, face), worn.astype(np.float32), rest)
    return np.concatenate([parts[name] for name in TEETH]).astype(np.float64)


def teeth_out(positions: Values, sheet: Indices, teeth: Values) -> float:
    """How deep the teeth (n, 3) pierce the skin, metres: of those in front of it the farthest from its surface.

    In front: nearer to the viewer (+z) than every sheet triangle before or close behind it. In the open mouth, where
    no skin is in the line of sight, nothing pierces.
    """
    corners = positions[sheet]
    near = (corners[..., :2].min(axis=1) <= teeth[:, :2].max(axis=0)) & (
        corners[..., :2].max(axis=1) >= teeth[:, :2].min(axis=0)
    )
    corners = corners[near.all(axis=1)]
    ahead = teeth[:, 2] - _foremost(corners, teeth)
    out = teeth[(ahead > 0) & (ahead < BEYOND)]
    return max((float(_to_segments_and_faces(corners, point).min()) for point in out), default=0.0)


def _foremost(corners: Values, points: Values) -> Values:
    """The largest z of the triangles (t, 3, 3) before or behind each point: (n,), minus infinity where none is."""
    one = corners[:, 1] - corners[:, 0]
    two = corners[:, 2] - corners[:, 0]
    away = points[:, None] - corners[None, :, 0]
    area = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]
    area = np.where(np.abs(area) < 1e-18, np.inf, area)
    u = (away[..., 0] * two[:, 1] - away[..., 1] * two[:, 0]) / area
    v = (one[:, 0] * away[..., 1] - one[:, 1] * away[..., 0]) / area
    inside = (u >= 0) & (v >= 0) & (u + v <= 1) & np.isfinite(area)
    result: Values = np.where(inside, corners[:, 0, 2] + u * one[:, 2] + v * two[:, 2], -np.inf).max(
        axis=1, initial=-np.inf
    )
    return result


def _to_segments_and_faces(corners: Values, point: Values) -> Values:
    """The distance of a point (3,) to each triangle (t, 3, 3): to its edges, and to its inside where it is over it."""
    ahead = np.roll(corners, -1, axis=1) - corners
    away = point - corners
    share = (ahead * away).sum(axis=2) / np.maximum((ahead**2).sum(axis=2), 1e-30)
    foot = away - np.minimum(np.maximum(share, 0.0), 1.0)[..., None] * ahead
    edges = np.linalg.norm(foot, axis=2).min(axis=1)
    normal = np.cross(ahead[:, 0], ahead[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30)
    over = ((np.cross(ahead, away) * normal[:, None]).sum(axis=2) >= 0).all(axis=1)
    result: Values = np.where(over, np.abs((away[:, 0] * normal).sum(axis=1)), edges)
    return result
