"""The colours of a scan at the places of a face: where its surface is near and faces the same way."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.arrays import Values
from omote.geometry import mesh
from omote.geometry.proximity import weigh_corners
from omote.model.albedo import Light, decode_light
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity

Indices = NDArray[Any]

SAMPLES = 200_000
"""Places of the scan's surface among which the nearest is sought."""
TURN = 0.006
"""Metres that opposite normals count as half of: who faces another way is no neighbour."""
REACH = 0.03
"""Metres around the face within which the scan is looked at: a whole body is mostly not."""


@dataclass(frozen=True, eq=False)
class ScanColours:
    """A scan in the face's own place: triangles (t, 3, 3) metres, or points (t, 1, 3) of a cloud, their normals (t, 3)
    (zero for a cloud), and what colours their corners: texcoords (t, 3, 2) or rows of the scan's points (t, c)."""

    scan: Scan
    corners: Values
    normals: Values
    rows: Indices
    texcoords: Values | None
    picture: Light | None

    def light(self, faces: Indices, shares: Values, /) -> Light:
        """Linear light (n, 3) at places of triangles: faces (n,), shares (n, c) of their corners."""
        if self.texcoords is not None and self.picture is not None:
            return _sampled(self.picture, np.einsum("nc,nck->nk", shares, self.texcoords[faces]))
        assert self.scan.colours is not None  # `place_colours` refuses a scan without any
        colours: Light = np.einsum("nc,nck->nk", shares, decode_light(self.scan.colours[self.rows[faces]]))
        return colours.astype(np.float32)


def place_colours(scan: Scan, placement: Similarity, around: Values, /) -> ScanColours:
    """Places a scan's colours on a face; placement: from the scan to the face; around (n, 3): the face's points.

    ValueError where the scan has no colours, or nothing of it lies near the face.
    """
    if scan.colours is None and scan.texture is None:
        raise ValueError("this scan has no colours; expected a texture or a colour for each point")
    points = placement(scan.positions)
    rows = np.arange(len(points))[:, None] if scan.triangles is None else np.asarray(scan.triangles)
    low = around.min(axis=0) - REACH
    high = around.max(axis=0) + REACH
    middles = points[rows].mean(axis=1)
    near = np.flatnonzero(((middles > low) & (middles < high)).all(axis=1))
    if not len(near):
        raise ValueError("nothing of this scan lies near the face; expected the placement that the face was fitted by")
    corners = points[rows[near]]
    normals = np.zeros((len(near), 3)) if scan.triangles is None else mesh.unit_normals(corners)
    texcoords = None if scan.texcoords is None else scan.texcoords[near]
    picture = None if scan.texture is None else decode_light(scan.texture)
    return ScanColours(scan, corners, normals, rows[near], texcoords, picture)


def nearest_faces(
    colours: ScanColours, points: Values, normals: Values, /, *, within: float = np.inf, seed: int = 0
) -> Indices:
    """The triangle (n,) of the scan nearest to each of points (n, 3) with normals (n, 3), in six dimensions; -1 where
    none lies within so many of their metres, which is found at once.

    colours: the placed scan; points (n, 3): metres; normals (n, 3): of length 1; within: metres; seed: of the random
    samples.
    """
    corners = colours.corners
    if corners.shape[1] == 1:
        which = np.arange(len(corners))
        places = corners[:, 0]
        wanted = points
    else:
        random = np.random.default_rng(seed)
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        which = random.choice(len(corners), SAMPLES, p=area / area.sum())
        feet = np.einsum("nc,nck->nk", random.dirichlet(np.ones(3), SAMPLES), corners[which])
        places = np.concatenate([feet, TURN * colours.normals[which]], axis=1)
        wanted = np.concatenate([points, TURN * normals], axis=1)
    nearest = cKDTree(places).query(wanted, distance_upper_bound=within)[1]
    return np.append(which, -1)[nearest]


def choose_nearest(
    colours: ScanColours, points: Values, normals: Values, candidates: Indices, /
) -> tuple[Indices, Values, Values]:
    """Of candidates (n, m), triangles, the nearest to each of points (n, 3) that faces as normals (n, 3) do.

    Returns it (n,), the shares (n, c) of its corners at the nearest place, and its distance (n,), metres: infinity
    where all candidates are -1.

    colours: the placed scan; points (n, 3): metres; normals (n, 3): of length 1; candidates (n, m): rows of triangles.
    """
    if colours.corners.shape[1] == 1:
        first = candidates.max(axis=1)
        away = np.where(first < 0, np.inf, np.linalg.norm(colours.corners[first, 0] - points, axis=1))
        return np.maximum(first, 0), np.ones((len(first), 1)), away
    return _choose(colours.corners, colours.normals, points, normals, candidates)


@njit(cache=True)
def _choose(
    corners: Values, turns: Values, points: Values, normals: Values, candidates: Indices
) -> tuple[Indices, Values, Values]:
    count = len(points)
    best = np.zeros(count, np.int64)
    shares = np.zeros((count, 3))
    away = np.full(count, np.inf)
    for n in range(count):
        least = np.inf
        for m in range(candidates.shape[1]):
            t = candidates[n, m]
            if t < 0:
                continue
            u, v, w = corners[t, 1] - corners[t, 0], corners[t, 2] - corners[t, 0], points[n] - corners[t, 0]
            b, c = weigh_corners(w[0], w[1], w[2], u[0], u[1], u[2], v[0], v[1], v[2])
            gap = ((b * u + c * v - w) ** 2).sum()
            turned = TURN * TURN * (2.0 - 2.0 * (turns[t] * normals[n]).sum())
            if gap + turned < least:
                least = gap + turned
                best[n] = t
                away[n] = np.sqrt(gap)
                shares[n, 0], shares[n, 1], shares[n, 2] = 1.0 - b - c, b, c
    return best, shares, away


def _sampled(picture: Light, places: Values) -> Light:
    """Linear light of a picture (rows, columns, 3) at places (n, 2), 0 to 1 from its upper left, between its pixels."""
    size = np.array([picture.shape[1], picture.shape[0]])
    at = (places % 1.0) * size - 0.5
    low = np.floor(at).astype(np.int64)
    x, y = (at - low).astype(np.float32).T[..., None]
    (left, top) = (low % size).T
    (right, below) = ((low + 1) % size).T
    upper = picture[top, left] * (1.0 - x) + picture[top, right] * x
    lower = picture[below, left] * (1.0 - x) + picture[below, right] * x
    return upper * (1.0 - y) + lower * y
