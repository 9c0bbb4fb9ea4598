"""Parts: eyeballs, teeth, tongue, lashes; placed on a face and moved by bindings to the skin
(docs/method.md, "Inner skin and parts")."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh


@dataclass(frozen=True, eq=False)
class Part:
    """A mesh of its own that follows the skin.

    points (n, 3) on the generic face, metres; triangles (f, 3); uvs (n, 2) where it has a texture; ring (m,): the skin
    vertices whose similarity transform from the generic face to another places the part there; anchors, weights (n, k):
    a part vertex moves by the weighted displacement of these skin vertices (all weights zero: rigid with the head).
    eye: "left", "right" or "" for a part that is no eyeball.
    """

    name: str
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    ring: NDArray[np.int32]
    anchors: NDArray[np.int32]
    weights: NDArray[np.float64]
    uvs: NDArray[np.float32] | None = None
    eye: str = ""

    def __post_init__(self) -> None:
        points = mesh.validate_points(self.points, name=f"points of part {self.name!r}")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "triangles", mesh.validate_triangles(self.triangles, len(points)))
        if len(self.ring) < 3:
            raise ValueError(
                f"part {self.name!r} has a ring of {len(self.ring)} skin vertices; expected at least 3 to place it by"
            )
        if self.anchors.shape != self.weights.shape or len(self.anchors) != len(points):
            raise ValueError(
                f"part {self.name!r} has anchors {self.anchors.shape} and weights {self.weights.shape}; "
                f"expected one row each for its {len(points)} vertices"
            )
        if self.eye not in ("", "left", "right"):
            raise ValueError(f"part {self.name!r} is the {self.eye!r} eye; expected 'left', 'right' or ''")

    @property
    def follows_jaw(self) -> bool:
        """Whether all of it moves alike with some vertices of the skin: the jaw's."""
        return bool(self.weights.any() and (self.anchors == self.anchors[0]).all())


def bind_to_head(
    name: str,
    points: NDArray[np.float64],
    triangles: NDArray[np.int32],
    skin: NDArray[np.float64],
    /,
    *,
    candidates: NDArray[np.int32],
    uvs: NDArray[np.float32] | None = None,
    eye: str = "",
) -> Part:
    """Binds a part rigidly to the head (eyeballs, upper teeth).

    points (n, 3), triangles (f, 3), skin (V, 3) generic; candidates: skin vertices (the sheet's) that may place it.
    """
    none = np.zeros((len(points), 1))
    return Part(name, points, triangles, _ring(points, skin, candidates), none.astype(np.int32), none, uvs, eye)


def bind_to_jaw(
    name: str,
    points: NDArray[np.float64],
    triangles: NDArray[np.int32],
    skin: NDArray[np.float64],
    /,
    *,
    candidates: NDArray[np.int32],
    chin: NDArray[np.int32],
    uvs: NDArray[np.float32] | None = None,
) -> Part:
    """Binds a part rigidly to the jaw (lower teeth, tongue): it moves by the chin's mean displacement."""
    anchors = np.broadcast_to(chin, (len(points), len(chin))).astype(np.int32)
    weights = np.full(anchors.shape, 1.0 / len(chin))
    return Part(name, points, triangles, _ring(points, skin, candidates), anchors, weights, uvs)


def bind_to_skin(
    name: str,
    points: NDArray[np.float64],
    triangles: NDArray[np.int32],
    skin: NDArray[np.float64],
    /,
    *,
    candidates: NDArray[np.int32],
    uvs: NDArray[np.float32] | None = None,
) -> Part:
    """Binds a part to the skin under it (lashes, hair): each vertex moves with its three nearest on the skin."""
    distance = np.linalg.norm(points[:, None] - skin[candidates][None], axis=2)
    nearest = np.argsort(distance, axis=1, kind="stable")[:, :3]
    share = 1.0 / np.maximum(np.take_along_axis(distance, nearest, axis=1), 1e-6)
    anchors = candidates[nearest].astype(np.int32)
    return Part(
        name, points, triangles, _ring(points, skin, candidates), anchors, share / share.sum(axis=1, keepdims=True), uvs
    )


def _ring(points: NDArray[np.float64], skin: NDArray[np.float64], candidates: NDArray[np.int32]) -> NDArray[np.int32]:
    """The sixty candidates nearest to the part."""
    distance = np.full(len(candidates), np.inf)
    for begin in range(0, len(points), 256):
        block = np.linalg.norm(skin[candidates][:, None] - points[None, begin : begin + 256], axis=2).min(axis=1)
        distance = np.minimum(distance, block)
    nearest = np.argsort(distance, kind="stable")[:60]
    return np.sort(candidates[nearest]).astype(np.int32)


def fit_similarity(
    source: NDArray[np.float64], target: NDArray[np.float64], /
) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    """Scale, rotation (3, 3) and shift (3,) that carry source (m, 3) nearest to target (m, 3) (Umeyama 1991)."""
    here, there = source.mean(axis=0), target.mean(axis=0)
    a, b = source - here, target - there
    u, values, vt = np.linalg.svd(b.T @ a)
    sign = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    rotation = (u * sign) @ vt
    scale = float((values * sign).sum() / max((a * a).sum(), 1e-30))
    return scale, rotation, there - scale * rotation @ here


def place(part: Part, generic: NDArray[np.float64], positions: NDArray[np.float64], /) -> NDArray[np.float64]:
    """The part's vertices (n, 3) on a face with skin positions (V, 3), by the similarity of its ring."""
    scale, rotation, shift = fit_similarity(generic[part.ring], positions[part.ring])
    return scale * part.points @ rotation.T + shift


def size_ratio(part: Part, placed: NDArray[np.float64], /) -> float:
    """How much larger the part is on a face than on the generic one (root mean square distance to its centre)."""
    spread = [np.sqrt(((points - points.mean(axis=0)) ** 2).sum(axis=1).mean()) for points in (placed, part.points)]
    return float(spread[0] / max(spread[1], 1e-30))


def eye_rotation(yaw: float, pitch: float, /) -> NDArray[np.float64]:
    """The rotation (3, 3) that turns a gaze straight ahead to yaw (+ = the character's left, +x) and pitch (+ = up),
    radians."""
    cy, sy, cp, sp = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
    return np.array([[cy, -sy * sp, sy * cp], [0.0, cp, sp], [-sy, -cy * sp, cy * cp]])


def eye_angles(before: NDArray[np.float64], after: NDArray[np.float64], /) -> tuple[float, float]:
    """Yaw and pitch of the rotation about the ball's centre that carries before (n, 3) nearest to after (n, 3)."""
    centre = before.mean(axis=0)
    a, b = before - centre, after - centre
    u, _, vt = np.linalg.svd(b.T @ a)
    rotation = (u * [1.0, 1.0, np.sign(np.linalg.det(u @ vt))]) @ vt
    ahead = rotation @ [0.0, 0.0, 1.0]
    return float(np.arctan2(ahead[0], ahead[2])), float(np.arcsin(np.clip(ahead[1], -1.0, 1.0)))
