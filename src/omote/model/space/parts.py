"""Parts: eyeballs, teeth, tongue, lashes; placed on a face and moved by bindings to the skin
(docs/method.md, "Inner skin and parts")."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from omote.arrays import Indices, Values
from omote.geometry import mesh
from omote.model.space.eye_socket import radius_of
from omote.model.space.similarity import fit_similarity, fit_turn

AROUND = 8
"""Vertices of the skin around each vertex of a part in the mouth, by which that is placed."""


@dataclass(frozen=True, eq=False)
class Part:
    """A mesh of its own that follows the skin.

    points (n, 3) on the generic face, metres; triangles (f, 3); ring (m,): the skin
    vertices whose similarity transform from the generic face to another places the part there; anchors, weights (n, k):
    a part vertex moves by the weighted displacement of these skin vertices (all weights zero: rigid with the head).
    eye: "left", "right" or "" for a part that is no eyeball.
    """

    name: str
    points: Values
    triangles: Indices
    ring: Indices
    anchors: Indices
    weights: Values
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

    @property
    def follows_skin(self) -> bool:
        """Whether each of its vertices moves with the skin beneath it: lashes."""
        return bool(self.weights.any()) and not self.follows_jaw


def bind_to_head(
    name: str, points: Values, triangles: Indices, skin: Values, /, *, candidates: Indices, eye: str = ""
) -> Part:
    """Binds a part rigidly to the head (eyeballs, upper teeth).

    name: of the part; eye: the side of an eyeball, "" for another part.

    points (n, 3), triangles (f, 3), skin (V, 3) generic; candidates: skin vertices (the sheet's) that may place it.
    """
    none = np.zeros((len(points), 1))
    return Part(name, points, triangles, _ring(points, skin, candidates), none.astype(np.int32), none, eye)


def bind_to_jaw(
    name: str, points: Values, triangles: Indices, skin: Values, /, *, candidates: Indices, chin: Indices
) -> Part:
    """Binds a part rigidly to the jaw (lower teeth, tongue): it moves by the chin's mean displacement.

    name: of the part; points: (n, 3), metres; triangles: (f, 3); skin: (V, 3) generic, metres; candidates: rows of the
    skin that it may be bound to; chin: those that the jaw moves.
    """
    anchors = np.broadcast_to(chin, (len(points), len(chin))).astype(np.int32)
    weights = np.full(anchors.shape, 1.0 / len(chin))
    return Part(name, points, triangles, _ring(points, skin, candidates), anchors, weights)


def bind_to_skin(name: str, points: Values, triangles: Indices, skin: Values, /, *, candidates: Indices) -> Part:
    """Binds a part to the skin under it (lashes, hair): each vertex moves with its three nearest on the skin.

    name: of the part; points: (n, 3), metres; triangles: (f, 3); candidates: rows of the skin that it may be bound to.
    """
    distance = np.linalg.norm(points[:, None] - skin[candidates][None], axis=2)
    nearest = np.argsort(distance, axis=1, kind="stable")[:, :3]
    share = 1.0 / np.maximum(np.take_along_axis(distance, nearest, axis=1), 1e-6)
    anchors = candidates[nearest].astype(np.int32)
    return Part(
        name, points, triangles, _ring(points, skin, candidates), anchors, share / share.sum(axis=1, keepdims=True)
    )


def _ring(points: Values, skin: Values, candidates: Indices) -> Indices:
    """The sixty candidates nearest to the part."""
    distance = np.full(len(candidates), np.inf)
    for begin in range(0, len(points), 256):
        block = np.linalg.norm(skin[candidates][:, None] - points[None, begin : begin + 256], axis=2).min(axis=1)
        distance = np.minimum(distance, block)
    nearest = np.argsort(distance, kind="stable")[:60]
    return np.sort(candidates[nearest]).astype(np.int32)


def place(part: Part, generic: Values, positions: Values, /) -> Values:
    """The part's vertices (n, 3) on a face with skin positions (V, 3): an eyeball by the similarity of its ring, lashes
    with the skin beneath them, what is in the mouth as the skin around it is bent, so that it stays inside of a muzzle.

    generic: the generic skin (V, 3), metres. Source: radial basis functions with the kernel r (Duchon 1977).
    """
    if part.follows_skin:
        return part.points + np.einsum("nk,nkc->nc", part.weights, (positions - generic)[part.anchors])
    move = fit_similarity(generic[part.ring], positions[part.ring], np.ones(len(part.ring)))
    if part.eye:
        return move(part.points)
    _, near = cKDTree(generic).query(part.points, k=AROUND)
    rows = np.unique(near)
    _, first = np.unique(generic[rows], axis=0, return_index=True)
    rows = rows[first]
    return move(part.points) + _interpolate(generic[rows], positions[rows] - move(generic[rows]), part.points)


def _interpolate(where: Values, values: Values, wanted: Values) -> Values:
    """What a function that has values (k, 3) at distinct points (k, 3) is at wanted points (n, 3)."""
    one = np.ones((len(where), 1))
    system = np.block([[cdist(where, where), one], [one.T, np.zeros((1, 1))]])
    shares = np.linalg.solve(system, np.concatenate([values, np.zeros((1, 3))]))
    return np.asarray(cdist(wanted, where) @ shares[:-1] + shares[-1])


def size_ratio(part: Part, placed: Values, /) -> float:
    """How much larger the part is on a face than on the generic one (root mean square distance to its centre).

    placed: the part's vertices (n, 3) on the face, metres.
    """
    return radius_of(placed) / max(radius_of(part.points), 1e-30)


def eye_rotation(yaw: float, pitch: float, /) -> Values:
    """The rotation (3, 3) that turns a gaze straight ahead to yaw (+ = the character's left, +x) and pitch (+ = up),
    radians."""
    cy, sy, cp, sp = np.cos(yaw), np.sin(yaw), np.cos(pitch), np.sin(pitch)
    return np.array([[cy, -sy * sp, sy * cp], [0.0, cp, sp], [-sy, -cy * sp, cy * cp]])


def eye_angles(before: Values, after: Values, /) -> tuple[float, float]:
    """Yaw and pitch of the rotation about the ball's centre that carries before (n, 3) nearest to after (n, 3)."""
    centre = before.mean(axis=0)
    ahead = fit_turn(before - centre, after - centre) @ [0.0, 0.0, 1.0]
    return float(np.arctan2(ahead[0], ahead[2])), float(np.arcsin(np.clip(ahead[1], -1.0, 1.0)))
